//! Rays that are aimed at spheres, from near and far.

use ::ray_casting::Ray;
use ::sphere_hit::{Hit, Sphere};
use harness::{magnitude, unit_vector};
use oracle::exact::{Hit as ExactHit, approach, sphere};
use proptest::prelude::*;

/// A ray towards a sphere, or past it.
#[derive(Clone, Copy, Debug)]
pub struct Aimed {
    pub ray: Ray,
    pub sphere: Sphere,
}

impl Aimed {
    /// Returns D, the distance from the ray's origin to the centre.
    pub fn distance(&self) -> f64 {
        let [origin, centre] = [self.ray.origin, self.sphere.centre];
        origin.as_dvec3().distance(centre.as_dvec3())
    }

    /// Returns D/r.
    pub fn distance_in_radii(&self) -> f64 {
        self.distance() / f64::from(self.sphere.radius)
    }

    /// Returns b/r, exactly: the least distance of the ray's line to the centre, in radii.
    pub fn approach(&self) -> f64 {
        let Self { ray, sphere } = self;
        approach(ray.origin, ray.direction, sphere.centre, sphere.radius)
    }

    /// Returns the exact near and far hit; `None` for a miss.
    pub fn exact(&self) -> Option<[ExactHit; 2]> {
        let Self { ray, sphere: ball } = self;
        sphere(ray.origin, ray.direction, ball.centre, ball.radius)
    }

    /// Returns the hit by one of the methods.
    pub fn hit(&self, method: fn(&Sphere, &Ray, f32) -> Option<Hit>) -> Option<Hit> {
        method(&self.sphere, &self.ray, f32::MAX)
    }
}

/// Returns rays that come from D/r radii away and pass the centre at about `approach` radii.
/// The centre is up to a distance D from the origin of the world, and radii go from 10⁻³ to
/// 10⁶.
pub fn aimed(
    distance_in_radii: impl Strategy<Value = f64>,
    approach: impl Strategy<Value = f64>,
) -> impl Strategy<Value = Aimed> {
    let radius = magnitude(-3.0..6.0);
    let directions = [unit_vector(), unit_vector(), unit_vector()];
    (
        radius,
        distance_in_radii,
        approach,
        directions,
        0.0..1.0_f64,
    )
        .prop_map(
            |(radius, distance_in_radii, approach, [out, away, aside], far)| {
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
