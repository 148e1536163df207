//! Random numbers that are the same on every machine, and stay the same with every version
//! of every crate: tables and tests are compared with earlier ones for equality.

use anti_aliasing::hash;
use glam::{DVec3, Vec3};

/// A generator of random numbers: the book's hash of a seed and a counter.
#[derive(Clone, Debug)]
pub struct Random {
    seed: u32,
    count: u32,
}

impl Random {
    /// Returns the generator of the sequence that belongs to `seed`.
    #[must_use]
    pub fn new(seed: u32) -> Self {
        let seed = hash(seed);
        Self { seed, count: 0 }
    }

    fn bits(&mut self) -> u32 {
        self.count = self.count.wrapping_add(1);
        hash(self.seed ^ hash(self.count))
    }

    /// Returns a number in [0, 1), of 24 bits.
    pub fn f32(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / (1 << 24) as f32
    }

    /// Returns a number in [0, 1), of 53 bits.
    pub fn f64(&mut self) -> f64 {
        let bits = u64::from(self.bits()) << 32 | u64::from(self.bits());
        (bits >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a number in [`from`, `to`), up to rounding.
    pub fn between(&mut self, from: f32, to: f32) -> f32 {
        from + self.f32() * (to - from)
    }

    /// Returns a number from `least` to `greatest`, both positive: all orders of magnitude
    /// between them are about equally likely.
    pub fn magnitude(&mut self, least: f32, greatest: f32) -> f32 {
        // A positive number's bits, as an integer, are nearly its logarithm.
        let [least, greatest] = [least, greatest].map(f32::to_bits);
        f32::from_bits(least + (self.f64() * f64::from(greatest - least)) as u32)
    }

    /// Returns true or false.
    pub fn bool(&mut self) -> bool {
        self.bits() >> 31 == 1
    }

    /// Returns true with a probability of `p`, from 0 to 1.
    pub fn chance(&mut self, p: f32) -> bool {
        self.f32() < p
    }

    /// Returns one of the `choices`.
    ///
    /// # Panics
    /// If there is none.
    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.index(choices.len())]
    }

    /// Returns an index below `count`, up to a bias of `count` / 2²⁴.
    pub fn index(&mut self, count: usize) -> usize {
        (self.f32() * count as f32) as usize
    }

    /// Returns a colour, each of its three numbers in [0, 1).
    pub fn colour(&mut self) -> Vec3 {
        Vec3::from_array(std::array::from_fn(|_| self.f32()))
    }

    /// Returns a unit vector; all directions are equally likely.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let cube = DVec3::from_array(std::array::from_fn(|_| 2.0 * self.f64() - 1.0));
            if (1e-3..1.0).contains(&cube.length_squared()) {
                return cube.normalize();
            }
        }
    }
}
