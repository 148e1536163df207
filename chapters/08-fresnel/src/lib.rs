// ANCHOR: head
//! Fresnel: how much of the light is mirrored at a border, and how much goes through.

pub mod views;
pub use views::STAGE;

use glam::Vec3;
use plane_hit::nearest;
use ray_casting::Ray;
use reflection::{Reach, reflect};
use refraction::{Body, Crossing, Material, leave, refract};
use shading::{power, shade};
use shadows::{PointLight, Scene, light_reaches};
use sphere_hit::facing;
// ANCHOR_END: head

// ANCHOR: fresnel
/// The share of unpolarised light that is mirrored at the border of two media, from 0 to
/// 1; the rest goes through.
///
/// `cos_theta_i` is the cosine of the angle of incidence, from 0 to 1; `eta_i` and
/// `eta_t` are the indices on this side and on the far side. Total internal reflection
/// gives 1, equal indices 0.
///
/// Source: the talk's "Fresnel" slide.
#[must_use]
pub fn fresnel(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> f32 {
    // Without this, an invisible ball would sparkle: 0/0 at grazing angles.
    if eta_i == eta_t {
        return 0.0;
    }
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i) * (1.0 + cos_theta_i);
    if !(sin2_theta_t < 1.0) {
        return 1.0;
    }
    let cos_theta_t = (1.0 - sin2_theta_t).sqrt();
    let r_parl = (eta_t * cos_theta_i - eta_i * cos_theta_t)
        / (eta_t * cos_theta_i + eta_i * cos_theta_t);
    let r_perp = (eta_i * cos_theta_i - eta_t * cos_theta_t)
        / (eta_i * cos_theta_i + eta_t * cos_theta_t);
    (r_parl * r_parl + r_perp * r_perp) / 2.0
}
// ANCHOR_END: fresnel

// ANCHOR: schlick
/// Schlick's approximation, with the classic mistake: it takes the cosine on the side
/// that the light comes from, where the approximation is one in the larger of the two
/// angles.
///
/// On entering a denser medium that is the same, and for glass it is off by a few
/// hundredths at most. On leaving it knows nothing of total reflection.
///
/// Source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering" (1994).
#[must_use]
pub fn schlick(cos_theta_i: f32, eta_i: f32, eta_t: f32) -> f32 {
    let r = (eta_i - eta_t) / (eta_i + eta_t);
    let r0 = r * r;
    r0 + (1.0 - r0) * power(1.0 - cos_theta_i, 5)
}
// ANCHOR_END: schlick

// ANCHOR: ways
/// How much is mirrored; one of the functions above.
pub type Reflectance = fn(f32, f32, f32) -> f32;

/// The two ways on which light may go on at a surface, each with the share that takes it:
/// mirrored, and through. A way that there is not has a share of 0.
///
/// `incident` and the `outward` normal are unit vectors, and so are the directions.
#[must_use]
pub fn ways_on(
    body: &Body,
    incident: Vec3,
    outward: Vec3,
    reflectance: Reflectance,
) -> [(f32, Vec3); 2] {
    let mirrored = reflect(incident, outward);
    match *body {
        Body::Opaque { reflectivity } => [(reflectivity, mirrored), (0.0, incident)],
        Body::Clear { inside, outside } => {
            let Crossing {
                normal,
                eta_i,
                eta_t,
            } = Crossing::new(incident, outward, inside, outside);
            match refract(incident, normal, eta_i / eta_t) {
                Some(refracted) => {
                    let share = reflectance(-normal.dot(incident), eta_i, eta_t);
                    [(share, mirrored), (1.0 - share, refracted)]
                }
                // Total internal reflection.
                None => [(1.0, mirrored), (0.0, incident)],
            }
        }
    }
}
// ANCHOR_END: ways

// ANCHOR: trace
/// What a ray brings back: the light of what it meets first, and what is seen in it and
/// through it.
#[must_use]
pub fn trace(
    scene: &Scene<Material>,
    ray: &Ray,
    reach: Reach,
    reflectance: Reflectance,
) -> Vec3 {
    let Some((object, hit)) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let Material { phong, body } = &object.material;
    let incident = ray.direction;
    let point = ray.at(hit.t);
    let normal = facing(hit.normal, incident);
    let reaches = |light: &PointLight| light_reaches(scene, point, normal, light);
    let mut light = shade(phong, incident, point, normal, &scene.lights, reaches);
    for (share, direction) in ways_on(body, incident, hit.normal, reflectance) {
        if let Some(reach) = reach.after(share) {
            let onward = leave(point, hit.normal, direction);
            light += share * trace(scene, &onward, reach, reflectance);
        }
    }
    light
}
// ANCHOR_END: trace
