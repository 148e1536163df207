// ANCHOR: ray
//! A ray for every pixel: from the eye, through the pixel, into the world.
//!
//! Coordinates are left-handed: x to the right, y up, z away from the viewer.

pub mod scene;

use glam::{Vec2, Vec3};

/// A half-line: the points o + t d with t ≥ 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// o, its first point.
    pub origin: Vec3,
    /// d, a unit vector, up to rounding.
    pub direction: Vec3,
}

impl Ray {
    /// Returns the point at distance `t` along the ray: o + t d.
    #[inline]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }
}
// ANCHOR_END: ray

// ANCHOR: camera
/// A pinhole camera: an eye, and an image plane in front of it.
///
/// `right`, `up` and `forward` are orthonormal; [`Camera::new`] makes them so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The origin of all camera rays.
    pub eye: Vec3,
    /// The direction of the image plane's x.
    pub right: Vec3,
    /// The direction of the image plane's y.
    pub up: Vec3,
    /// The direction from the eye to the middle of the image plane.
    pub forward: Vec3,
    /// The distance from the eye to the image plane, whose half-height is 1.
    pub focal_length: f32,
}
// ANCHOR_END: camera

// ANCHOR: range
/// The largest coordinate, radius and focal length. The smallest radius and focal length is
/// the inverse: from 1e-15 to 1e15 no square, nor a sum of a few, leaves f32's range.
pub const MAX_LENGTH: f32 = 1e15;

/// Returns whether a number is between 1 / [`MAX_LENGTH`] and [`MAX_LENGTH`]; NaN is not.
#[inline]
pub fn is_length(number: f32) -> bool {
    (1.0 / MAX_LENGTH..=MAX_LENGTH).contains(&number)
}

/// Returns whether all coordinates of a point are between −[`MAX_LENGTH`] and
/// [`MAX_LENGTH`]; NaN is not.
#[inline]
pub fn is_position(point: Vec3) -> bool {
    point.abs().cmple(Vec3::splat(MAX_LENGTH)).all()
}
// ANCHOR_END: range

// ANCHOR: new
/// Returns the unit vector along `vector`. `None` if it is zero or not finite, or if the
/// square of its length underflows or overflows f32 (a length below 1.1e-19 or above
/// 1.8e19).
#[inline]
pub fn checked_normalize(vector: Vec3) -> Option<Vec3> {
    let is_normalizable = vector.length_squared().is_normal();
    is_normalizable.then(|| vector.normalize())
}

/// The least sine of the angle between a camera's `forward` and `up`.
///
/// A cross product of unit vectors is wrong by about 1e-7: below this, `right` would be
/// off by a percent.
const MIN_SIN_UP_ANGLE: f32 = 1e-5;

impl Camera {
    /// Returns a camera at `eye` that looks along `forward`, turned so that `up` points
    /// upwards in the picture.
    ///
    /// Neither direction need be a unit vector. `None` if a direction cannot be normalised
    /// ([`checked_normalize`]), if `forward` is parallel to `up`, or if the eye or the focal
    /// length is out of range ([`is_position`], [`is_length`]).
    pub fn new(eye: Vec3, forward: Vec3, up: Vec3, focal_length: f32) -> Option<Self> {
        if !(is_position(eye) && is_length(focal_length)) {
            return None;
        }
        let forward = checked_normalize(forward)?;
        let right = checked_normalize(up)?.cross(forward);
        if !(right.length() > MIN_SIN_UP_ANGLE) {
            return None;
        }
        let right = right.normalize();
        let up = forward.cross(right);
        Some(Self {
            eye,
            right,
            up,
            forward,
            focal_length,
        })
    }
}
// ANCHOR_END: new

// ANCHOR: cast
impl Camera {
    /// Returns the ray from the eye through a `point` of the image plane.
    ///
    /// Source: the lecture's "Ray Tracing Basics" slide.
    #[inline]
    pub fn ray(&self, point: Vec2) -> Ray {
        let direction =
            point.x * self.right + point.y * self.up + self.focal_length * self.forward;
        Ray {
            origin: self.eye,
            direction: direction.normalize(),
        }
    }
}
// ANCHOR_END: cast

// ANCHOR: trace
/// The sky's radiance, linear.
pub const SKY: Vec3 = Vec3::new(0.2, 0.5, 0.8);

/// The ground's radiance, linear, until there is a floor.
pub const GROUND: Vec3 = Vec3::new(0.25, 0.2, 0.15);

/// Returns the radiance along a ray in an empty world: sky above the horizon, ground below.
pub fn trace(ray: &Ray) -> Vec3 {
    canvas::count_ray();
    if ray.direction.y > 0.0 { SKY } else { GROUND }
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
