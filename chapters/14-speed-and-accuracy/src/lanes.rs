//! Formulas written once for every kind of number, to see what they cost by themselves: in
//! full registers, without a call for each result, and as a count of operations.

use crate::study::{Clock, Job};
use crate::table::Measurement;
use glam::Vec3;
use packets::Lanes;
use std::cell::Cell;
use std::hint::black_box;
use std::ops::{Add, Div, Mul, Neg, Sub};
use wide::f64x8;

// ANCHOR: number
/// A kind of number: one or as many as fill a register, which a formula does not see.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// How many numbers it holds.
    const LANES: usize;

    /// Returns the numbers that a function has for each lane.
    fn of_each(lane: impl Fn(usize) -> f32) -> Self;

    /// Returns the square roots.
    fn sqrt(self) -> Self;
}
// ANCHOR_END: number

macro_rules! number {
    ($Number:ty, $lanes:expr, $of_each:expr) => {
        impl Number for $Number {
            const LANES: usize = $lanes;
            fn of_each(lane: impl Fn(usize) -> f32) -> Self {
                let of_each: fn([f32; $lanes]) -> Self = $of_each;
                of_each(std::array::from_fn(lane))
            }
            #[inline]
            fn sqrt(self) -> Self {
                self.sqrt()
            }
        }
    };
}
number!(f32, 1, |[number]| number);
number!(f64, 1, |[number]| number.into());
number!(Lanes, 16, Self::new);
number!(f64x8, 8, |numbers| Self::new(numbers.map(f64::from)));

/// An f32 that counts the operations.
#[derive(Clone, Copy, Debug)]
pub struct Counted(f32);

thread_local! {
    static OPERATIONS: Cell<u32> = const { Cell::new(0) };
}

fn counted(result: f32) -> Counted {
    OPERATIONS.set(OPERATIONS.get() + 1);
    Counted(result)
}

macro_rules! operator {
    ($Operator:ident, $function:ident, $sign:tt) => {
        impl $Operator for Counted {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                counted(self.0 $sign other.0)
            }
        }
    };
}
operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

/// A sign costs nothing.
impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Number for Counted {
    const LANES: usize = 1;
    fn of_each(lane: impl Fn(usize) -> f32) -> Self {
        Self(lane(0))
    }
    fn sqrt(self) -> Self {
        counted(self.0.sqrt())
    }
}

/// Three numbers of a kind.
pub type Vector<T> = [T; 3];

#[inline]
fn dot<T: Number>([a, b, c]: Vector<T>, [x, y, z]: Vector<T>) -> T {
    a * x + b * y + c * z
}

#[inline]
fn zip<T: Number>(a: Vector<T>, b: Vector<T>, f: impl Fn(T, T) -> T) -> Vector<T> {
    std::array::from_fn(|i| f(a[i], b[i]))
}

// ANCHOR: formulas
/// Returns t of the near root by the formula of `Sphere::distance_quadratic`, from a ray's
/// origin and direction, a sphere's centre and its radius; NaN if the ray misses.
#[inline]
pub fn sphere_quadratic<T: Number>([o, d, c, [r, ..]]: [Vector<T>; 4]) -> [T; 1] {
    let oc = zip(o, c, |o, c| o - c);
    let b = dot(d, oc);
    let discriminant = b * b - (dot(oc, oc) - r * r);
    [-b - discriminant.sqrt()]
}

/// Returns t of the near root by the formula of `Sphere::distance`, NaN if the ray misses.
#[inline]
pub fn sphere_stable<T: Number>([o, d, c, [r, ..]]: [Vector<T>; 4]) -> [T; 1] {
    let oc = zip(o, c, |o, c| o - c);
    let d_dot_d = dot(d, d);
    let t_closest = -dot(d, oc) / d_dot_d;
    let perpendicular = zip(oc, d, |oc, d| oc + t_closest * d);
    let half_chord_squared = r * r - dot(perpendicular, perpendicular);
    [t_closest - (half_chord_squared / d_dot_d).sqrt()]
}
// ANCHOR_END: formulas

/// Returns t by the formula of `Plane::distance`, from a ray's origin and direction and a
/// plane's point and normal.
#[inline]
pub fn plane<T: Number>([o, d, point, normal]: [Vector<T>; 4]) -> [T; 1] {
    [dot(zip(point, o, |point, o| point - o), normal) / dot(d, normal)]
}

/// Returns t by a plane's stored offset, in place of its point.
#[inline]
pub fn plane_by_offset<T: Number>(
    [o, d, [offset, ..], normal]: [Vector<T>; 4],
) -> [T; 1] {
    [(offset - dot(normal, o)) / dot(normal, d)]
}

/// Returns the refracted direction by the textbook's formula, from the incident direction,
/// the normal and η; NaN under total internal reflection.
#[inline]
pub fn refract_by_textbook<T: Number>([i, n, [eta, ..]]: [Vector<T>; 3]) -> Vector<T> {
    let one = T::of_each(|_| 1.0);
    let cos_theta_i = -dot(n, i);
    let cos_theta_t = (one - eta * eta * (one - cos_theta_i * cos_theta_i)).sqrt();
    zip(i, n, |i, n| eta * (i + cos_theta_i * n) - cos_theta_t * n)
}

/// Returns the refracted direction by the formula of `refract`, but for its last step, which
/// normalises it.
#[inline]
pub fn refract_tangential<T: Number>([i, n, [eta, ..]]: [Vector<T>; 3]) -> Vector<T> {
    let cos_theta_i = -dot(n, i);
    let tangential = zip(i, n, |i, n| i + cos_theta_i * n);
    let sin2_theta_t = eta * eta * dot(tangential, tangential);
    let cos_theta_t = (T::of_each(|_| 1.0) - sin2_theta_t).sqrt();
    zip(tangential, n, |tangential, n| {
        eta * tangential - cos_theta_t * n
    })
}

/// Returns the refracted direction by the formula of `refract`.
#[inline]
pub fn refract<T: Number>(case: [Vector<T>; 3]) -> Vector<T> {
    let direction = refract_tangential(case);
    let reciprocal = T::of_each(|_| 1.0) / dot(direction, direction).sqrt();
    direction.map(|component| component * reciprocal)
}

/// Returns the results of a formula for one number of each kind `T`.
pub fn results<T: Number, const K: usize, const M: usize>(
    cases: &[[Vec3; K]],
    formula: impl Fn([Vector<T>; K]) -> [T; M],
) -> Vec<[T; M]> {
    registers(cases).into_iter().map(formula).collect()
}

/// Returns the inputs of a formula, as many in each as there are lanes.
fn registers<T: Number, const K: usize>(cases: &[[Vec3; K]]) -> Vec<[Vector<T>; K]> {
    let registers = cases.chunks_exact(T::LANES).map(|cases| {
        std::array::from_fn(|k| {
            std::array::from_fn(|axis| T::of_each(|lane| cases[lane][k][axis]))
        })
    });
    registers.collect()
}

// ANCHOR: batch
/// The results of a batch: with the inputs they stay in the fastest cache.
const BATCH: usize = 128;

const ROUNDS: usize = 100;

/// A formula to be timed in full registers.
pub struct InLanes {
    job: Job<'static>,
    lanes: usize,
    operations: u32,
}

impl InLanes {
    /// Returns a formula for the first [`BATCH`] of the cases, in registers of `T`; it is given
    /// a second time for numbers that count the operations.
    pub fn of<T: Number + 'static, const K: usize, const M: usize>(
        cases: &[[Vec3; K]],
        formula: impl Fn([Vector<T>; K]) -> [T; M] + 'static,
        counting: impl Fn([Vector<Counted>; K]) -> [Counted; M],
    ) -> Self {
        let inputs = registers(&cases[..BATCH]);
        let mut results = vec![[T::of_each(|_| 0.0); M]; inputs.len()];
        let job = move || {
            // So many that starting the clock is nothing beside them.
            for _ in 0..ROUNDS {
                for (result, input) in results.iter_mut().zip(black_box(&inputs)) {
                    *result = formula(*input);
                }
                black_box(&mut results);
            }
        };
        Self {
            job: Box::new(job),
            lanes: T::LANES,
            operations: operations(counting),
        }
    }
}

/// Returns the rows of the scene "lanes": the errors of each method's row, and beside them
/// what its formula costs, as operations and as nanoseconds for one result. The setting is
/// the number of lanes.
pub fn costs(
    clock: &Clock,
    errors: &[Measurement],
    formulas: Vec<InLanes>,
) -> Vec<Measurement> {
    let mut costs = Vec::new();
    let mut jobs = Vec::new();
    for formula in formulas {
        costs.push((formula.lanes, formula.operations));
        jobs.push(formula.job);
    }
    let times = clock.min_of_rounds(BATCH * ROUNDS, jobs);
    let rows = errors.iter().zip(costs).zip(times);
    rows.map(|((errors, (lanes, operations)), ns)| Measurement {
        scene: "lanes".to_string(),
        setting: lanes as f64,
        work: Some(operations.into()),
        ns,
        ..errors.clone()
    })
    .collect()
}
// ANCHOR_END: batch

/// Returns the number of operations of a formula: sums, products, divisions and roots.
fn operations<const K: usize, const M: usize>(
    formula: impl Fn([Vector<Counted>; K]) -> [Counted; M],
) -> u32 {
    let case = [[Counted(1.0); 3]; K];
    OPERATIONS.set(0);
    let _ = formula(case);
    OPERATIONS.get()
}
