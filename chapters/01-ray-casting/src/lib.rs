// ANCHOR: head
//! A ray for every pixel: from the eye, through the pixel, into the world.

pub mod views;
pub use views::STAGE;

use glam::{Vec2, Vec3};
// ANCHOR_END: head

// ANCHOR: ray
/// A half-line: where it starts, and where it goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes: a unit vector, up to rounding.
    pub direction: Vec3,
}

impl Ray {
    /// The point at distance `t` along the ray: o + t d.
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }
}
// ANCHOR_END: ray

// ANCHOR: camera
/// An eye, and an image plane in front of it.
///
/// `right`, `up` and `forward` are unit vectors at right angles to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where all rays start.
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

// ANCHOR: new
/// The unit vector along `vector`; `None` if it has none: it is zero or not finite, or so
/// short or so long that the square of its length is beyond f32.
#[must_use]
pub fn unit(vector: Vec3) -> Option<Vec3> {
    let has_one = vector.length_squared().is_normal();
    has_one.then(|| vector.normalize())
}

/// The least sine of the angle between a camera's `forward` and `up`.
///
/// A cross product of unit vectors is wrong by about 1e-7: below this, `right` would be
/// off by a percent.
const LEAST_SINE: f32 = 1e-5;

impl Camera {
    /// A camera at `eye` that looks along `forward`, with `up` somewhere above the middle
    /// of the picture.
    ///
    /// Neither direction need be a unit vector. Returns `None` where there is no such
    /// camera: a direction has no [`unit`] vector, `forward` is parallel to `up`, the eye
    /// is not finite, or the focal length is not a positive number.
    #[must_use]
    pub fn new(eye: Vec3, forward: Vec3, up: Vec3, focal_length: f32) -> Option<Self> {
        if !(eye.is_finite() && focal_length > 0.0 && focal_length.is_finite()) {
            return None;
        }
        let forward = unit(forward)?;
        let right = unit(up)?.cross(forward);
        if !(right.length() > LEAST_SINE) {
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
    // ANCHOR_END: new

    // ANCHOR: cast
    /// The ray from the eye through a `point` of the image plane.
    ///
    /// Source: the talk's "Ray Tracing Basics" slide.
    #[must_use]
    pub fn ray(&self, point: Vec2) -> Ray {
        canvas::count_ray();
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
/// The sky's linear light.
pub const SKY: Vec3 = Vec3::new(0.2, 0.5, 0.8);

/// The ground's linear light, until there is a floor.
pub const GROUND: Vec3 = Vec3::new(0.25, 0.2, 0.15);

/// What a ray brings back from a world with nothing in it: sky above the horizon, ground
/// below.
#[must_use]
pub fn trace(ray: &Ray) -> Vec3 {
    if ray.direction.y > 0.0 { SKY } else { GROUND }
}
// ANCHOR_END: trace
