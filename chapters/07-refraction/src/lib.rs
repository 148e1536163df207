// ANCHOR: head
//! Glass: a ray that enters it is bent, and bent back when it leaves; or it cannot leave
//! at all.

pub mod views;
pub use views::STAGE;

use glam::Vec3;
use plane_hit::nearest;
use ray_casting::Ray;
use reflection::{Reach, reflect};
use shading::{Phong, shade};
use shadows::{OFFSET, PointLight, Scene, light_reaches};
use sphere_hit::facing;
// ANCHOR_END: head

// ANCHOR: refract
/// The direction in which `incident` goes on behind a surface, by Snell's law: T = η (I +
/// cosθᵢ N) − N √(1 − η² sin²θᵢ), where η = η₁/η₂ is the index on this side over the
/// index on the far side.
///
/// `incident` and `normal` must be unit vectors, and `normal` must face the incident ray;
/// so the result is a unit vector. Returns `None` for total internal reflection: then
/// nothing goes on. Equal indices leave the ray as it is, to the last bit.
///
/// Source: the talk's "Refractions" slide.
#[must_use]
pub fn refract(incident: Vec3, normal: Vec3, eta: f32) -> Option<Vec3> {
    if eta == 1.0 {
        return Some(incident);
    }
    let cos_theta_i = -normal.dot(incident);
    // The part of the incident direction along the surface, sinθᵢ long.
    let along = incident + cos_theta_i * normal;
    let sin2_theta_t = eta * eta * along.dot(along);
    if !(sin2_theta_t < 1.0) {
        return None;
    }
    Some((eta * along - (1.0 - sin2_theta_t).sqrt() * normal).normalize())
}
// ANCHOR_END: refract

// ANCHOR: crossing
/// A ray at the border of two media: which way the surface faces, and what lies on either
/// side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The unit normal on the side that the ray comes from.
    pub normal: Vec3,
    /// The index of refraction on this side.
    pub eta_i: f32,
    /// The index of refraction on the far side.
    pub eta_t: f32,
}

impl Crossing {
    /// Decides, once, whether a ray along `incident` enters or leaves a thing whose
    /// `outward` normal is given, with an index `inside` and another `outside` it.
    #[must_use]
    pub fn new(incident: Vec3, outward: Vec3, inside: f32, outside: f32) -> Self {
        let leaves = outward.dot(incident) > 0.0;
        let (eta_i, eta_t) = if leaves {
            (inside, outside)
        } else {
            (outside, inside)
        };
        Self {
            normal: facing(outward, incident),
            eta_i,
            eta_t,
        }
    }
}
// ANCHOR_END: crossing

// ANCHOR: redirect
/// Where light goes on at a border, if it goes anywhere: through it, or, if it cannot,
/// back.
#[must_use]
pub fn redirect(
    incident: Vec3,
    outward: Vec3,
    inside: f32,
    outside: f32,
) -> Option<Vec3> {
    let crossing = Crossing::new(incident, outward, inside, outside);
    let refracted = refract(incident, crossing.normal, crossing.eta_i / crossing.eta_t);
    Some(refracted.unwrap_or_else(|| reflect(incident, crossing.normal)))
}
// ANCHOR_END: redirect

// ANCHOR: failed
/// Refraction, failed: the ratio of the indices is not inverted when the ray leaves.
#[must_use]
pub fn redirect_without_inverting(
    incident: Vec3,
    outward: Vec3,
    inside: f32,
    outside: f32,
) -> Option<Vec3> {
    let normal = facing(outward, incident);
    let refracted = refract(incident, normal, outside / inside);
    Some(refracted.unwrap_or_else(|| reflect(incident, normal)))
}

/// Refraction, failed: what cannot leave is forgotten.
#[must_use]
pub fn redirect_without_total_reflection(
    incident: Vec3,
    outward: Vec3,
    inside: f32,
    outside: f32,
) -> Option<Vec3> {
    let crossing = Crossing::new(incident, outward, inside, outside);
    refract(incident, crossing.normal, crossing.eta_i / crossing.eta_t)
}
// ANCHOR_END: failed

// ANCHOR: material
/// What becomes of light that is not scattered at the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body {
    /// A share of it is mirrored, from 0 to 1; the rest is lost.
    Opaque {
        /// kᵣ.
        reflectivity: f32,
    },
    /// It goes through. Both indices of refraction are positive.
    Clear {
        /// The index of refraction within.
        inside: f32,
        /// The index of refraction of what is around it.
        outside: f32,
    },
}

/// A surface, and what is behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// The surface's answer to the lamps.
    pub phong: Phong,
    /// What is behind it.
    pub body: Body,
}
// ANCHOR_END: material

// ANCHOR: trace
/// Where light goes on at a border, if anywhere; one of the functions above.
pub type Redirect = fn(Vec3, Vec3, f32, f32) -> Option<Vec3>;

/// What a ray brings back: the light of what it meets first, and what is seen in it or
/// through it.
#[must_use]
pub fn trace(
    scene: &Scene<Material>,
    ray: &Ray,
    reach: Reach,
    redirect: Redirect,
) -> Vec3 {
    let Some((object, hit)) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let Material { phong, body } = &object.material;
    let incident = ray.direction;
    let point = ray.at(hit.t);
    let normal = facing(hit.normal, incident);
    let reaches = |light: &PointLight| light_reaches(scene, point, normal, light);
    let light = shade(phong, incident, point, normal, &scene.lights, reaches);

    let (share, direction) = match *body {
        Body::Opaque { reflectivity } => (reflectivity, Some(reflect(incident, normal))),
        Body::Clear { inside, outside } => {
            (1.0, redirect(incident, hit.normal, inside, outside))
        }
    };
    let (Some(direction), Some(reach)) = (direction, reach.after(share)) else {
        return light;
    };
    light + share * trace(scene, &leave(point, hit.normal, direction), reach, redirect)
}

/// The ray that leaves a `point` of a surface, on the side of it that `direction` points
/// to.
#[must_use]
pub fn leave(point: Vec3, normal: Vec3, direction: Vec3) -> Ray {
    canvas::count_ray();
    Ray {
        origin: point + OFFSET * facing(normal, -direction),
        direction,
    }
}
// ANCHOR_END: trace
