//! Lanes of sixteen numbers, and vectors of them.

// ANCHOR: lanes
use glam::Vec3;
use std::ops::{Add, Div, Mul, Sub};
use wide::Select;

/// Sixteen numbers: one register of AVX-512, two of AVX2, four of any other machine.
///
/// A comparison returns a mask: in each lane all bits are set if it holds, and none if not.
pub use wide::f32x16 as Lanes;

/// The number of lanes.
pub const LANES: usize = 16;

/// Returns the lanes' numbers, from 0.
#[inline]
pub fn lanes() -> Lanes {
    Lanes::new(std::array::from_fn(|lane| lane as f32))
}

/// A vector in every lane; sums and products have the order of glam's.
#[derive(Clone, Copy, Debug)]
pub struct Vec3x16 {
    /// Their x.
    pub x: Lanes,
    /// Their y.
    pub y: Lanes,
    /// Their z.
    pub z: Lanes,
}
// ANCHOR_END: lanes

// ANCHOR: vectors
impl Vec3x16 {
    /// Returns the same vector in every lane.
    #[inline]
    pub fn splat(vector: Vec3) -> Self {
        Self {
            x: Lanes::splat(vector.x),
            y: Lanes::splat(vector.y),
            z: Lanes::splat(vector.z),
        }
    }

    #[inline]
    fn zip(self, other: Self, f: impl Fn(Lanes, Lanes) -> Lanes) -> Self {
        Self {
            x: f(self.x, other.x),
            y: f(self.y, other.y),
            z: f(self.z, other.z),
        }
    }

    /// Returns the dot products.
    #[inline]
    pub fn dot(self, other: Self) -> Lanes {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Returns the lengths.
    #[inline]
    pub fn length(self) -> Lanes {
        self.dot(self).sqrt()
    }

    /// Returns the unit vectors, calculated as glam does: one division and three products.
    #[inline]
    pub fn normalize(self) -> Self {
        self * (1.0 / self.length())
    }

    /// Returns the unit vectors, or Y where there is none, as `Sphere::normal` does.
    #[inline]
    pub fn normalize_or_y(self) -> Self {
        let is_normalizable = self.is_normalizable();
        is_normalizable.select(self.normalize(), Self::splat(Vec3::Y))
    }

    /// Returns a mask of the vectors that `ray_casting::checked_normalize` accepts.
    #[inline]
    pub fn is_normalizable(self) -> Lanes {
        let squared = self.dot(self);
        squared.simd_ge(f32::MIN_POSITIVE) & squared.simd_lt(f32::INFINITY)
    }

    /// Returns the vectors, lane by lane.
    #[inline]
    pub fn to_array(self) -> [Vec3; LANES] {
        let [x, y, z] = [self.x, self.y, self.z].map(Lanes::to_array);
        std::array::from_fn(|lane| Vec3::new(x[lane], y[lane], z[lane]))
    }
}
// ANCHOR_END: vectors

// ANCHOR: operators
/// Converts a number to the vector whose three components are that number.
impl<T: Into<Lanes>> From<T> for Vec3x16 {
    #[inline]
    fn from(number: T) -> Self {
        let [x, y, z] = [number.into(); 3];
        Self { x, y, z }
    }
}

macro_rules! operator {
    ($Operator:ident, $function:ident, $sign:tt) => {
        impl<T: Into<Self>> $Operator<T> for Vec3x16 {
            type Output = Self;
            #[inline]
            fn $function(self, other: T) -> Self {
                self.zip(other.into(), |a, b| a $sign b)
            }
        }
    };
}
operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl Select<Vec3x16> for Lanes {
    #[inline]
    fn select(self, if_true: Vec3x16, if_false: Vec3x16) -> Vec3x16 {
        if_true.zip(if_false, |a, b| self.select(a, b))
    }
}
// ANCHOR_END: operators
