// ANCHOR: head
//! A floor, and the nearest of many objects.

mod object;
pub mod scene;
pub use object::{Object, Shape, nearest, nearest_by};

use glam::{Vec2, Vec3};
use ray_casting::{Ray, SKY, checked_normalize, is_position};
// ANCHOR_END: head

// ANCHOR: plane
/// The points x with (x − `point`) · `normal` = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point of the plane, and the origin of its two coordinates.
    pub point: Vec3,
    /// The unit vector perpendicular to the plane.
    pub normal: Vec3,
    /// The axes of its coordinates: unit vectors in the plane, perpendicular to each other.
    pub axes: [Vec3; 2],
}

impl Plane {
    /// Returns a plane; `normal` need not be a unit vector. `None` if it cannot be
    /// normalised ([`checked_normalize`]), or if the point is out of range ([`is_position`]).
    ///
    /// The first axis is as close to x as the plane allows, or to z if the normal is close to
    /// x; the second points upwards, or away from the viewer in a floor. So the axes of a
    /// horizontal plane are x and z, and those of a plane and of its other side are the same.
    pub fn new(point: Vec3, normal: Vec3) -> Option<Self> {
        let normal = checked_normalize(normal)?;
        let along = if normal.x.abs() < 0.9 {
            Vec3::X
        } else {
            Vec3::Z
        };
        let first = (along - along.dot(normal) * normal).normalize();
        let second = first.cross(normal);
        let is_downwards = match second.y + second.z {
            0.0 => second.y < 0.0,
            sum => sum < 0.0,
        };
        let axes = [first, if is_downwards { -second } else { second }];
        is_position(point).then_some(Self {
            point,
            normal,
            axes,
        })
    }

    /// Returns the two coordinates of a `point` of the plane.
    #[inline]
    pub fn uv(&self, point: Vec3) -> Vec2 {
        let from_origin = point - self.point;
        let [u, v] = self.axes.map(|axis| from_origin.dot(axis));
        Vec2::new(u, v)
    }
}
// ANCHOR_END: plane

// ANCHOR: distance
impl Plane {
    /// Returns the distance to the hit, t = (x₀ − o)·n / (d·n), if 0 < t < `t_max`. `None`
    /// otherwise, and for a ray that is parallel to the plane or lies in it.
    ///
    /// The direction need not be a unit vector; the distance is in units of its length.
    ///
    /// Source: the lecture's "Plane-Ray intersection" slides.
    #[inline]
    pub fn distance(&self, ray: &Ray, t_max: f32) -> Option<f32> {
        let t =
            (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        // Parallel to the plane t is infinite, in the plane NaN: both are rejected here.
        (t > 0.0 && t < t_max).then_some(t)
    }
}
// ANCHOR_END: distance

// ANCHOR: checker
/// Returns whether a point of a floor lies in an even square of a checkerboard; `uv` are its
/// two coordinates in the floor's plane.
///
/// The parity is calculated in floats: no integer holds the numbers of the squares near the
/// horizon.
#[inline]
pub fn is_even(uv: Vec2) -> bool {
    let sum = uv.x.floor() + uv.y.floor();
    sum - 2.0 * (sum / 2.0).floor() == 0.0
}

/// Returns whether a point lies in an even cube of a three-dimensional checkerboard. Used for
/// a floor, this is a bug: at a whole height, rounding puts `point.y` above or below it, and
/// `floor` gives two different numbers.
pub fn is_even_in_space(point: Vec3) -> bool {
    let sum = point.x.floor() + point.y.floor() + point.z.floor();
    sum - 2.0 * (sum / 2.0).floor() == 0.0
}
// ANCHOR_END: checker

// ANCHOR: texture
/// The colour of a surface, linear, each component from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texture {
    /// The same colour everywhere.
    Solid(Vec3),
    /// Squares of side 1: even and odd.
    Checker(Vec3, Vec3),
}

impl Texture {
    /// Returns the colour at a point of the surface, given by its two coordinates there
    /// ([`Shape::uv`]).
    #[inline]
    pub fn value(&self, uv: Vec2) -> Vec3 {
        match *self {
            Self::Checker(_, odd) if !is_even(uv) => odd,
            Self::Solid(colour) | Self::Checker(colour, _) => colour,
        }
    }
}
// ANCHOR_END: texture

// ANCHOR: trace
/// Returns the flat colour of the first object that the ray hits, or the sky's.
pub fn trace(objects: &[Object<Texture>], ray: &Ray) -> Vec3 {
    match nearest(objects, ray) {
        Some((index, t)) => {
            let Object {
                shape, material, ..
            } = &objects[index];
            material.value(shape.uv(ray.at(t)))
        }
        None => SKY,
    }
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
