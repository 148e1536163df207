//! What the tests share: units of error, and where the properties take their inputs from.

use ::ray_casting::Ray;
use ::sphere_hit::{Hit, Sphere};
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::ops::Range;

/// 2⁻²³, as f64.
pub const EPS: f64 = f32::EPSILON as f64;

/// A unit in the last place of an f32 of this size.
pub fn ulp(x: f64) -> f64 {
    let x = (x as f32).abs();
    f64::from(x.next_up()) - f64::from(x)
}

pub fn ray(origin: [f32; 3], direction: [f32; 3]) -> Ray {
    Ray {
        origin: origin.into(),
        direction: direction.into(),
    }
}

/// A property's settings: the same cases on every run, and no file written when it fails.
pub fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1968),
        ..ProptestConfig::default()
    }
}

/// Every kind of number that a formula may not expect, among a few that it does.
pub fn special() -> impl Strategy<Value = f32> {
    const SPECIAL: [f32; 14] = [
        0.0,
        -0.0,
        1e-45,
        -1e-45,
        1e-38,
        1e-20,
        1.0,
        1e19,
        -1e19,
        3e38,
        -3e38,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ];
    prop_oneof![prop::sample::select(&SPECIAL[..]), -2.0_f32..2.0]
}

/// A vector of them.
pub fn special_vector() -> impl Strategy<Value = Vec3> {
    [special(), special(), special()].prop_map(Vec3::from)
}

/// A direction, whichever: a point of a square, and of which half of the sphere it is the picture.
pub fn unit() -> impl Strategy<Value = DVec3> {
    let square = (-1.0..1.0_f64, -1.0..1.0_f64, any::<bool>());
    square.prop_map(|(u, v, front)| {
        let z = (1.0 - u * u - v * v) / 2.0;
        DVec3::new(u, v, if front { z } else { -z }).normalize()
    })
}

/// A number from 10 to the power of one end of `exponents` to 10 to the power of the other, all magnitudes alike.
#[expect(
    clippy::disallowed_methods,
    reason = "where an input comes from does not matter"
)]
pub fn magnitude(exponents: Range<f64>) -> impl Strategy<Value = f64> + Clone {
    exponents.prop_map(|exponent| 10.0_f64.powf(exponent))
}

/// A ray towards a sphere, or past it.
#[derive(Clone, Copy, Debug)]
pub struct Aimed {
    pub ray: Ray,
    pub sphere: Sphere,
}

impl Aimed {
    /// D, from the ray's origin to the centre.
    pub fn distance(&self) -> f64 {
        self.ray
            .origin
            .as_dvec3()
            .distance(self.sphere.centre.as_dvec3())
    }

    /// D/r.
    pub fn distance_in_radii(&self) -> f64 {
        self.distance() / f64::from(self.sphere.radius)
    }

    /// b/r, exactly: how near the ray's line comes to the centre.
    pub fn approach(&self) -> f64 {
        let Self { ray, sphere } = self;
        oracle::exact::approach(ray.origin, ray.direction, sphere.centre, sphere.radius)
    }

    /// The exact near and far hit.
    pub fn exact(&self) -> Option<[oracle::exact::Meeting; 2]> {
        let Self { ray, sphere } = self;
        oracle::exact::sphere(ray.origin, ray.direction, sphere.centre, sphere.radius)
    }

    pub fn hit(&self, form: fn(&Sphere, &Ray, f32) -> Option<Hit>) -> Option<Hit> {
        form(&self.sphere, &self.ray, f32::MAX)
    }
}

/// Rays that come from D/r radii away and pass the centre at about `approach` radii. The centre is up
/// to a distance D from the origin of the world, and radii go from 10⁻³ to 10⁶.
pub fn aimed(
    distance_in_radii: impl Strategy<Value = f64>,
    approach: impl Strategy<Value = f64>,
) -> impl Strategy<Value = Aimed> {
    let radius = magnitude(-3.0..6.0);
    let places = (unit(), unit(), unit(), 0.0..1.0_f64);
    (radius, distance_in_radii, approach, places).prop_map(
        |(radius, distance_in_radii, approach, (out, away, aside, far))| {
            let distance = distance_in_radii * radius;
            let centre = (far * distance * away).as_vec3();
            let origin = (centre.as_dvec3() + distance * out).as_vec3();
            let to_centre = (centre - origin).as_dvec3();
            let aside = aside.reject_from(to_centre).normalize();
            let direction = (to_centre + approach * radius * aside).normalize();
            Aimed {
                ray: Ray {
                    origin,
                    direction: direction.as_vec3(),
                },
                sphere: Sphere {
                    centre,
                    radius: radius as f32,
                },
            }
        },
    )
}
