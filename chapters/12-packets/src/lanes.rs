//! Sixteen numbers that are calculated with as if they were one, and vectors of them.

// ANCHOR: lanes
use glam::Vec3;
use std::ops::{Add, Div, Mul, Sub};
use wide::Select;

/// Sixteen numbers: one register of AVX-512, two of AVX2, four of any other machine.
///
/// A comparison gives a mask: every bit of a lane where it holds, none where it does not.
pub use wide::f32x16 as Lanes;

/// How many lanes there are.
pub const LANES: usize = 16;

/// A vector in every lane; sums and products are glam's, in glam's order.
#[derive(Clone, Copy, Debug)]
pub struct Vectors {
    /// Their x.
    pub x: Lanes,
    /// Their y.
    pub y: Lanes,
    /// Their z.
    pub z: Lanes,
}
// ANCHOR_END: lanes

// ANCHOR: vectors
impl Vectors {
    /// The same vector in every lane.
    #[must_use]
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

    /// The dot products.
    #[must_use]
    #[inline]
    pub fn dot(self, other: Self) -> Lanes {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The lengths.
    #[must_use]
    #[inline]
    pub fn length(self) -> Lanes {
        self.dot(self).sqrt()
    }

    /// The unit vectors, as glam makes them: one division, and three products.
    #[must_use]
    #[inline]
    pub fn normalize(self) -> Self {
        self * (1.0 / self.length())
    }

    /// A mask: where chapter 1's `unit` finds a unit vector.
    #[must_use]
    #[inline]
    pub fn have_unit(self) -> Lanes {
        let squared = self.dot(self);
        squared.simd_ge(f32::MIN_POSITIVE) & squared.simd_lt(f32::INFINITY)
    }

    /// Puts the first lanes into their places, [`LANES`] at the most.
    pub fn write(self, places: &mut [Vec3]) {
        let [x, y, z] = [self.x, self.y, self.z].map(Lanes::to_array);
        for (lane, place) in places.iter_mut().enumerate() {
            *place = Vec3::new(x[lane], y[lane], z[lane]);
        }
    }
}
// ANCHOR_END: vectors

// ANCHOR: operators
/// A number stands for a vector of three of it.
impl<T: Into<Lanes>> From<T> for Vectors {
    #[inline]
    fn from(number: T) -> Self {
        let [x, y, z] = [number.into(); 3];
        Self { x, y, z }
    }
}

macro_rules! operator {
    ($Operator:ident, $function:ident, $sign:tt) => {
        impl<T: Into<Self>> $Operator<T> for Vectors {
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

impl Select<Vectors> for Lanes {
    #[inline]
    fn select(self, if_true: Vectors, if_false: Vectors) -> Vectors {
        if_true.zip(if_false, |a, b| self.select(a, b))
    }
}
// ANCHOR_END: operators
