//! Exact intersections of a line with a sphere or a plane, all of f32 numbers.
//!
//! Sums, differences and products of floats are floats again, of more bits: here they are never
//! rounded, so that the sign of a discriminant is certain. A quotient or a root is rounded to 256 bits,
//! and the result to f64. All inputs must be finite; the direction need not be a unit vector.

use dashu_float::{Context, FBig, Repr, round::mode::HalfEven};
use glam::{DVec3, Vec3};
use std::cmp::Ordering;

/// A number with as many bits as it needs.
type Real = FBig<HalfEven, 2>;

/// Bits of a quotient or a root: an f64 has 53.
const BITS: usize = 256;

fn real(x: f32) -> Real {
    // A precision of 0 is none: nothing is rounded.
    Real::from_repr(Repr::try_from(x).expect("a finite f32"), Context::new(0))
}

/// Returns `x` rounded to [`BITS`] bits: division and square roots need a finite precision.
fn rounded(x: &Real) -> Real {
    x.clone().with_precision(BITS).value()
}

fn to_f64(x: &Real) -> f64 {
    x.to_f64().value()
}

type Vector = [Real; 3];

fn vector(v: Vec3) -> Vector {
    v.to_array().map(real)
}

fn difference(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn dot(a: &Vector, b: &Vector) -> Real {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The intersection of a line with a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The distance along the line, in lengths of its direction.
    pub t: f64,
    /// The sphere's outward unit normal there.
    pub normal: DVec3,
}

/// A line and a sphere, and the terms of a t² + 2 b t + c = 0.
struct Quadratic {
    oc: Vector,
    direction: Vector,
    radius: Real,
    a: Real,
    b: Real,
    c: Real,
}

impl Quadratic {
    fn new(origin: Vec3, direction: Vec3, centre: Vec3, radius: f32) -> Self {
        let oc = difference(&vector(origin), &vector(centre));
        let direction = vector(direction);
        let radius = real(radius);
        Self {
            a: dot(&direction, &direction),
            b: dot(&direction, &oc),
            c: dot(&oc, &oc) - &radius * &radius,
            oc,
            direction,
            radius,
        }
    }

    fn discriminant(&self) -> Real {
        &self.b * &self.b - &self.a * &self.c
    }

    fn hit(&self, t: &Real) -> Hit {
        let radius = rounded(&self.radius);
        let component = |i| {
            to_f64(&((rounded(&self.oc[i]) + t * rounded(&self.direction[i])) / &radius))
        };
        Hit {
            t: to_f64(t),
            normal: DVec3::from_array(std::array::from_fn(component)),
        }
    }
}

/// Returns the sign of the discriminant: `Less` for a line that misses the sphere, `Equal` for
/// a tangent.
#[must_use]
pub fn discriminant(
    origin: Vec3,
    direction: Vec3,
    centre: Vec3,
    radius: f32,
) -> Ordering {
    let discriminant = Quadratic::new(origin, direction, centre, radius).discriminant();
    discriminant.cmp(&Real::ZERO)
}

/// Returns the distance of the line from the sphere's centre, in radii: 1 for a tangent.
#[must_use]
pub fn approach(origin: Vec3, direction: Vec3, centre: Vec3, radius: f32) -> f64 {
    let Quadratic {
        oc, radius, a, b, ..
    } = Quadratic::new(origin, direction, centre, radius);
    let scaled_square = &a * dot(&oc, &oc) - &b * &b;
    let square = rounded(&scaled_square) / rounded(&(a * &radius * radius));
    to_f64(&square.sqrt())
}

/// Returns the intersections of the line, to both sides of its origin, with the sphere, in the
/// order of its direction.
///
/// `None` for a miss, or for a direction of zero.
#[must_use]
pub fn sphere(
    origin: Vec3,
    direction: Vec3,
    centre: Vec3,
    radius: f32,
) -> Option<[Hit; 2]> {
    let quadratic = Quadratic::new(origin, direction, centre, radius);
    let discriminant = quadratic.discriminant();
    if discriminant < Real::ZERO || quadratic.a == Real::ZERO {
        return None;
    }
    let [a, b, c] = [&quadratic.a, &quadratic.b, &quadratic.c].map(rounded);
    let root = rounded(&discriminant).sqrt();
    // The root of the larger magnitude has no cancellation; the other is c/a divided by it.
    let [near, far] = if b > Real::ZERO {
        let q = -b - root;
        [&q / a, c / &q]
    } else {
        let q = root - b;
        if q == Real::ZERO {
            // A tangent at its origin.
            [q.clone(), q]
        } else {
            [c / &q, &q / a]
        }
    };
    Some([near, far].map(|t| quadratic.hit(&t)))
}

/// Returns the distance along the line to the plane through `point` that is perpendicular to
/// `normal`, a vector of any length.
///
/// `None` for a line that is parallel to the plane or in it.
#[must_use]
pub fn plane(origin: Vec3, direction: Vec3, point: Vec3, normal: Vec3) -> Option<f64> {
    let normal = vector(normal);
    let d_dot_n = dot(&vector(direction), &normal);
    if d_dot_n == Real::ZERO {
        return None;
    }
    let height = dot(&difference(&vector(point), &vector(origin)), &normal);
    Some(to_f64(&(rounded(&height) / rounded(&d_dot_n))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    /// r = 13, o = (5, −20, 0), d = (0, 1, 0): 5² + 12² = 13², so t = 20 ∓ 12.
    #[test]
    fn a_pythagorean_triple_is_exact() {
        let [near, far] =
            sphere(vec3(5.0, -20.0, 0.0), Vec3::Y, Vec3::ZERO, 13.0).expect("a chord");
        assert_eq!([near.t, far.t], [8.0, 32.0]);
        assert_eq!(near.normal, DVec3::new(5.0 / 13.0, -12.0 / 13.0, 0.0));
        let [twice_as_long, _] =
            sphere(vec3(5.0, -20.0, 0.0), 2.0 * Vec3::Y, Vec3::ZERO, 13.0)
                .expect("a chord");
        assert_eq!(twice_as_long.t, 4.0);
    }

    /// One bit of the origin decides between a tangent, a chord and a miss.
    #[test]
    fn a_tangent_is_told_from_its_neighbours() {
        let from = |x| discriminant(vec3(x, 0.0, 5.0), Vec3::NEG_Z, Vec3::ZERO, 1.0);
        assert_eq!(from(1.0), Ordering::Equal);
        assert_eq!(from(1.0_f32.next_up()), Ordering::Less);
        assert_eq!(from(1.0_f32.next_down()), Ordering::Greater);
        let approach = approach(vec3(0.5, 0.0, 5.0), 3.0 * Vec3::NEG_Z, Vec3::ZERO, 1.0);
        assert_eq!(approach, 0.5);
    }

    /// From the inside, from the surface, and from the smallest numbers to the largest.
    #[test]
    fn roots_on_both_sides_are_found_at_any_scale() {
        for scale in [f32::MIN_POSITIVE, 1.0, (1u128 << 120) as f32] {
            let inside = vec3(0.5, 0.0, 0.0) * scale;
            let [near, far] =
                sphere(inside, scale * Vec3::X, Vec3::ZERO, scale).expect("a chord");
            assert_eq!([near.t, far.t], [-1.5, 0.5]);
        }
        let [near, far] = sphere(Vec3::X, Vec3::Y, Vec3::ZERO, 1.0).expect("a tangent");
        assert_eq!([near.t, far.t], [0.0, 0.0]);
        assert_eq!(sphere(Vec3::X, Vec3::ZERO, Vec3::ZERO, 1.0), None);
    }

    /// t = (x₀ − o)·n / (d·n), and `None` for a parallel line.
    #[test]
    fn a_plane_is_hit_once_or_never() {
        let from =
            |direction| plane(vec3(0.0, 3.0, 0.0), direction, Vec3::ZERO, 2.0 * Vec3::Y);
        assert_eq!(from(vec3(1.0, -1.0, 0.0)), Some(3.0));
        assert_eq!(from(Vec3::Y), Some(-3.0));
        assert_eq!(from(Vec3::X), None);
    }
}
