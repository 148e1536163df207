// ANCHOR: head
//! A floor to stand on, and the nearest of many things.

mod still_life;
pub mod views;
pub use still_life::still_life;
pub use views::STAGE;

use glam::{Vec2, Vec3};
use ray_casting::{Ray, SKY, unit};
use sphere_hit::{FARTHEST, Hit, Sphere};
// ANCHOR_END: head

// ANCHOR: plane
/// The points x with (x − `point`) · `normal` = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any one of its points.
    pub point: Vec3,
    /// The direction at right angles to it; a unit vector.
    pub normal: Vec3,
}

impl Plane {
    /// A plane; `None` if `normal`, which need not be a unit vector, has no [`unit`]
    /// vector, or if the point is not finite.
    #[must_use]
    pub fn new(point: Vec3, normal: Vec3) -> Option<Self> {
        let normal = unit(normal)?;
        point.is_finite().then_some(Self { point, normal })
    }
    // ANCHOR_END: plane

    // ANCHOR: hit
    /// The hit ahead of the ray and before `t_max`: t = (x₀ − o)·n / (d·n).
    ///
    /// Returns `None` for a ray that runs beside the plane or lies in it, and for one
    /// that meets it beyond `t_max`. The direction need not be a unit vector.
    ///
    /// Source: the talk's "Plane-Ray intersection" slides.
    #[must_use]
    pub fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let t =
            (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        // Beside the plane t is infinite, in it NaN: both are rejected here.
        if !(t > 0.0 && t < t_max) {
            return None;
        }
        Some(Hit {
            t,
            normal: self.normal,
        })
    }
}
// ANCHOR_END: hit

// ANCHOR: object
/// What a ray can hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A ball.
    Sphere(Sphere),
    /// A floor.
    Plane(Plane),
}

/// A thing in the picture, made of whatever a chapter calls a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Object<M> {
    /// What we call it.
    pub name: &'static str,
    /// Where it is.
    pub shape: Shape,
    /// What it is made of.
    pub material: M,
}

impl Shape {
    /// The first hit ahead of the ray and before `t_max`.
    #[must_use]
    pub fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        match self {
            Shape::Sphere(sphere) => sphere.hit(ray, t_max),
            Shape::Plane(plane) => plane.hit(ray, t_max),
        }
    }
}
// ANCHOR_END: object

// ANCHOR: nearest
/// The object that the ray meets first, and where; of two at the same distance, the first
/// in the list.
#[must_use]
pub fn nearest<'a, M>(
    objects: &'a [Object<M>],
    ray: &Ray,
) -> Option<(&'a Object<M>, Hit)> {
    nearest_by(objects, |object, t_max| object.shape.hit(ray, t_max))
}

/// The nearest of the objects, by whatever says where one is hit before some `t_max`.
#[must_use]
pub fn nearest_by<'a, M>(
    objects: &'a [Object<M>],
    hit: impl Fn(&'a Object<M>, f32) -> Option<Hit>,
) -> Option<(&'a Object<M>, Hit)> {
    let mut nearest = None;
    let mut t_max = FARTHEST;
    for object in objects {
        if let Some(hit) = hit(object, t_max) {
            t_max = hit.t;
            nearest = Some((object, hit));
        }
    }
    nearest
}
// ANCHOR_END: nearest

// ANCHOR: checker
/// Whether a point of a floor is on an even square of a chequerboard; `uv` are two
/// coordinates in its plane.
///
/// The parity is taken in floats: an integer cannot hold the squares near the horizon.
#[must_use]
pub fn is_even(uv: Vec2) -> bool {
    let sum = uv.x.floor() + uv.y.floor();
    sum - 2.0 * (sum / 2.0).floor() == 0.0
}

/// The same by all three coordinates of the point, which looks right and is not: on a
/// floor at a whole height, `point.y` is that height give or take a rounding, and `floor`
/// takes it for two.
#[must_use]
pub fn is_even_in_space(point: Vec3) -> bool {
    let sum = point.x.floor() + point.y.floor() + point.z.floor();
    sum - 2.0 * (sum / 2.0).floor() == 0.0
}
// ANCHOR_END: checker

// ANCHOR: pattern
/// The colour of a surface, linear, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pattern {
    /// The same everywhere.
    Plain(Vec3),
    /// Squares of side 1 in the plane y = 0, even and odd.
    Checker(Vec3, Vec3),
}

impl Pattern {
    /// The colour at a `point` of the surface.
    #[must_use]
    pub fn at(&self, point: Vec3) -> Vec3 {
        match *self {
            Pattern::Plain(colour) => colour,
            Pattern::Checker(even, odd) => {
                if is_even(Vec2::new(point.x, point.z)) {
                    even
                } else {
                    odd
                }
            }
        }
    }
}
// ANCHOR_END: pattern

// ANCHOR: trace
/// What a ray brings back: the flat colour of the nearest object, or the sky.
#[must_use]
pub fn trace(objects: &[Object<Pattern>], ray: &Ray) -> Vec3 {
    match nearest(objects, ray) {
        Some((object, hit)) => object.material.at(ray.at(hit.t)),
        None => SKY,
    }
}
// ANCHOR_END: trace
