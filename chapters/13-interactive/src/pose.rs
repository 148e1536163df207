//! The pose of the walk's camera, and how it moves.

use glam::{Vec2, Vec3};
use ray_casting::Camera;
use ray_casting::scene::STILL_LIFE_FOCAL_LENGTH;
use std::fmt;
use std::str::FromStr;

// ANCHOR: pose
/// A camera that can be moved: its eye, its direction and its focal length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraPose {
    eye: Vec3,
    forward: Vec3,
    focal_length: f32,
}

/// The greatest coordinate of an eye, in each direction.
pub const WORLD: f32 = 1000.0;

/// The shortest and the longest focal length.
pub const FOCAL_LENGTHS: [f32; 2] = [0.25, 16.0];

/// The greatest sine of the angle between the direction and the horizon.
const MAX_PITCH_SIN: f32 = 0.99;

impl CameraPose {
    /// The pose of the still life's camera in the book.
    pub const START: Self = Self {
        eye: Vec3::new(0.0, 2.0, -7.0),
        forward: Vec3::new(0.0, -1.1, 7.0),
        focal_length: STILL_LIFE_FOCAL_LENGTH,
    };

    /// Returns the pose of a camera at `eye` that looks along `forward`, which need not be a
    /// unit vector.
    ///
    /// # Errors
    /// If a coordinate of the eye is beyond [`WORLD`], the focal length is not one of
    /// [`FOCAL_LENGTHS`], the direction is zero or too steep, or a number is not finite.
    pub fn new(eye: Vec3, forward: Vec3, focal_length: f32) -> Result<Self, PoseError> {
        let [shortest, longest] = FOCAL_LENGTHS;
        if !eye.abs().cmple(Vec3::splat(WORLD)).all() {
            return Err(PoseError::Eye);
        }
        if !(shortest..=longest).contains(&focal_length) {
            return Err(PoseError::FocalLength);
        }
        match Camera::new(eye, forward, Vec3::Y, focal_length) {
            Some(camera) if camera.forward.y.abs() <= MAX_PITCH_SIN => Ok(Self {
                eye,
                forward,
                focal_length,
            }),
            _ => Err(PoseError::Direction),
        }
    }

    /// Returns the camera in this pose, its horizon level.
    pub fn camera(&self) -> Camera {
        Camera::new(self.eye, self.forward, Vec3::Y, self.focal_length)
            .expect("`new` has made this camera before")
    }

    /// Returns the pose after `steps` to the right, up and ahead, where ahead is level. A step
    /// that would lead beyond [`WORLD`] is not taken.
    pub fn moved(self, steps: Vec3) -> Self {
        let right = self.camera().right;
        let ahead = right.cross(Vec3::Y);
        // One by one: a step ahead that is not taken does not prevent one to the side.
        let steps = [steps.x * right, steps.y * Vec3::Y, steps.z * ahead];
        steps.into_iter().fold(self, |pose, step| {
            Self::new(pose.eye + step, self.forward, self.focal_length).unwrap_or(pose)
        })
    }

    /// Returns the pose turned so that what was seen at a `point` of the image plane is seen
    /// in its middle; turned only to the side, if the direction would be too steep.
    pub fn turned(self, point: Vec2) -> Self {
        let towards = |point| {
            let forward = self.camera().ray(point).direction;
            Self::new(self.eye, forward, self.focal_length)
        };
        let aside = Vec2::new(point.x, 0.0);
        towards(point).or_else(|_| towards(aside)).unwrap_or(self)
    }

    /// Returns the pose with a focal length larger by `factor`, or the same pose if there is
    /// no such focal length.
    pub fn zoomed(self, factor: f32) -> Self {
        let focal_length = factor * self.focal_length;
        Self::new(self.eye, self.forward, focal_length).unwrap_or(self)
    }
}
// ANCHOR_END: pose

// ANCHOR: text
/// Seven numbers with commas between them: eye, direction, focal length. Parsed, they give
/// the same pose, bit for bit.
impl fmt::Display for CameraPose {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [eye, forward] = [self.eye, self.forward].map(|v| v.to_array());
        for number in eye.iter().chain(&forward) {
            write!(f, "{number},")?;
        }
        write!(f, "{}", self.focal_length)
    }
}

impl FromStr for CameraPose {
    type Err = PoseError;

    fn from_str(text: &str) -> Result<Self, PoseError> {
        let numbers = text.split(',').map(|number| number.trim().parse());
        let numbers: Result<Vec<f32>, _> = numbers.collect();
        let Ok(&[x, y, z, right, up, ahead, focal_length]) = numbers.as_deref() else {
            return Err(PoseError::Syntax);
        };
        let forward = Vec3::new(right, up, ahead);
        Self::new(Vec3::new(x, y, z), forward, focal_length)
    }
}

/// The reason why there is no such pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PoseError {
    /// The text is not seven numbers with commas between them.
    Syntax,
    /// The eye is too far away.
    Eye,
    /// The direction is zero, or too close to straight up or down.
    Direction,
    /// The focal length is too short or too long.
    FocalLength,
}

impl fmt::Display for PoseError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [shortest, longest] = FOCAL_LENGTHS;
        match self {
            Self::Syntax => write!(f, "these are not seven numbers"),
            Self::Eye => write!(f, "a coordinate of the eye is not within ±{WORLD}"),
            Self::Direction => {
                write!(
                    f,
                    "the direction is zero, or closer than 8° to straight up or down"
                )
            }
            Self::FocalLength => {
                write!(f, "the focal length is not from {shortest} to {longest}")
            }
        }?;
        write!(
            f,
            "; write seven numbers, like {}: eye, direction, focal length",
            CameraPose::START
        )
    }
}

impl std::error::Error for PoseError {}
// ANCHOR_END: text
