// ANCHOR: head
//! Coloured glass: it absorbs some of the light that passes through, and its shadow has its
//! colour. And what is where if clear bodies overlap.

pub mod scene;
pub mod views;
pub use views::STAGE;

use fresnel::{fresnel, scatter};
use glam::Vec3;
use plane_hit::{Object, nearest_by};
use reflection::PathBudget;
use refraction::{Material, Optics};
use shading::shade;
use shadow_acne::{SurfaceRay, from_surface};
use shadows::{Interaction, Scene};
use sphere_hit::T_MAX;
// ANCHOR_END: head

// ANCHOR: absorb
/// Returns the fraction of light that passes through a medium of some thickness: e^(−a d),
/// for red, green and blue.
///
/// `absorption` is the rate a, at least 0, per unit of length.
///
/// Source: the Beer–Lambert law (Bouguer 1729).
#[must_use]
pub fn transmittance(absorption: Vec3, distance: f32) -> Vec3 {
    (-absorption * distance).map(libm::expf)
}
// ANCHOR_END: absorb

// ANCHOR: material
/// A material whose inside may absorb light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Absorbing {
    /// Its surface and its optics.
    pub material: Material,
    /// The rate at which its inside absorbs red, green and blue light, per unit of length; at
    /// least 0.
    pub absorption: Vec3,
}
// ANCHOR_END: material

// ANCHOR: medium
/// The inside of a dielectric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Its index of refraction.
    pub eta: f32,
    /// The rate at which it absorbs red, green and blue light, per unit of length.
    pub absorption: Vec3,
}

impl Medium {
    /// Returns the fraction of light that passes through some thickness of it.
    fn transmittance(self, distance: f32) -> Vec3 {
        if self.absorption == Vec3::ZERO {
            return Vec3::ONE;
        }
        transmittance(self.absorption, distance)
    }
}

/// Returns the medium at the origin of a ray, or just beyond the surface on which it starts:
/// that of the last dielectric in the scene's list that contains the point, since it displaces
/// the others. `None` if no dielectric does.
///
/// Source: Schmidt and Budge, "Simple Nested Dielectrics in Ray Traced Images" (2002); our
/// priority is the place in the list.
#[must_use]
pub fn medium(objects: &[Object<Absorbing>], ray: &SurfaceRay) -> Option<Medium> {
    let objects = objects.iter().enumerate().rev();
    let mut media = objects.filter_map(|(index, object)| {
        let Absorbing {
            material,
            absorption,
        } = object.material;
        let Optics::Dielectric {
            eta_inside: eta, ..
        } = material.optics
        else {
            return None;
        };
        let contains = if ray.origin == Some(index) {
            ray.enters
        } else {
            object.shape.contains(ray.ray.origin)
        };
        contains.then_some(Medium { eta, absorption })
    });
    media.next()
}
// ANCHOR_END: medium

// ANCHOR: interface
/// A function that returns the optics of a surface where a ray hits it. `None` if the light
/// passes as if there were no surface.
pub type OpticsAt = fn(&[Object<Absorbing>], &Interaction) -> Option<Optics>;

/// Returns the optics of a surface by the media that are really on its two sides. `None` if
/// these have the same index of refraction, be it that a third body has displaced both.
#[must_use]
pub fn between_media(objects: &[Object<Absorbing>], at: &Interaction) -> Option<Optics> {
    let optics = objects[at.index].material.material.optics;
    let Optics::Dielectric { eta_outside, .. } = optics else {
        return Some(optics);
    };
    let eta = |side| {
        medium(objects, &from_surface(at, side)).map_or(eta_outside, |medium| medium.eta)
    };
    let (eta_inside, eta_outside) = (eta(-at.outward), eta(at.outward));
    (eta_inside != eta_outside).then_some(Optics::Dielectric {
        eta_inside,
        eta_outside,
    })
}

/// The bug: returns the optics of a surface as if its object were alone in the scene.
#[must_use]
pub fn as_if_alone(objects: &[Object<Absorbing>], at: &Interaction) -> Option<Optics> {
    Some(objects[at.index].material.material.optics)
}
// ANCHOR_END: interface

// ANCHOR: follow
/// Follows a ray straight on, to the first hit with a surface that reflects or refracts it.
/// Returns the fraction of light that the media on the way transmit, and the hit with its
/// optics; `None` if there is none. Counts a ray for each surface that it meets.
#[must_use]
pub fn follow(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    optics_at: OpticsAt,
) -> (Vec3, Option<(Interaction, Optics)>) {
    let objects = &scene.objects;
    let (mut ray, mut transmitted) = (*ray, Vec3::ONE);
    // A line crosses each surface twice at the most.
    for _ in 0..=2 * objects.len() {
        let hit = ray.intersect(objects);
        if let Some(medium) = medium(objects, &ray) {
            transmitted *= medium.transmittance(hit.map_or(T_MAX, |at| at.t));
        }
        let Some(at) = hit else {
            break;
        };
        if let Some(optics) = optics_at(objects, &at) {
            return (transmitted, Some((at, optics)));
        }
        ray = from_surface(&at, at.incident);
    }
    (transmitted, None)
}
// ANCHOR_END: follow

// ANCHOR: through
/// Returns the fraction of a light's red, green and blue that arrives along a shadow ray from
/// `distance` away: 0 if an opaque object occludes it, else what the media between transmit.
/// Counts one ray.
///
/// Refraction and reflection by these media are ignored, so that the shadow of a ball of glass
/// has a colour but no caustic.
#[must_use]
pub fn shadow_transmittance(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    light: Vec3,
    distance: f32,
) -> Vec3 {
    canvas::count_ray();
    let objects = &scene.objects;
    let is_opaque = |object: &Object<Absorbing>| {
        matches!(object.material.material.optics, Optics::Opaque { .. })
    };
    let occludes = |(index, object): (usize, &Object<Absorbing>)| {
        is_opaque(object)
            && ray
                .occlusion(index, &object.shape, light, distance)
                .is_some()
    };
    if objects.iter().enumerate().any(occludes) {
        return Vec3::ZERO;
    }
    let (mut ray, mut distance, mut transmitted) = (*ray, distance, Vec3::ONE);
    for _ in 0..=2 * objects.len() {
        let hit = nearest_by(objects, distance, |index, object, t_max| {
            let is_hit = !is_opaque(object);
            is_hit.then(|| ray.distance(index, &object.shape, t_max))?
        });
        if let Some(medium) = medium(objects, &ray) {
            transmitted *= medium.transmittance(hit.map_or(distance, |(_, t)| t));
        }
        let Some(hit) = hit else {
            break;
        };
        let at = Interaction::new(objects, &ray.ray, hit);
        ray = from_surface(&at, at.incident);
        distance -= at.t;
    }
    transmitted
}
// ANCHOR_END: through

// ANCHOR: trace
/// Returns the radiance along a ray: that of the first surface that reflects or refracts it,
/// and what is seen in it and through it, less what is absorbed along the ray; or the
/// background.
#[must_use]
pub fn trace(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    budget: PathBudget,
    optics_at: OpticsAt,
) -> Vec3 {
    let (path_transmittance, hit) = follow(scene, ray, optics_at);
    let Some((at, optics)) = hit else {
        return path_transmittance * scene.background;
    };
    let phong = &scene.objects[at.index].material.material.phong;
    let mut radiance = shade(phong, &at, &scene.lights, |light, to_light, distance| {
        let shadow_ray = from_surface(&at, to_light);
        shadow_transmittance(scene, &shadow_ray, light.position, distance)
    });
    for (weight, direction) in scatter(&optics, &at, fresnel).into_iter().flatten() {
        let coefficient = weight * path_transmittance.max_element();
        if let Some(budget) = budget.attenuated(coefficient) {
            let next = from_surface(&at, direction);
            radiance += weight * trace(scene, &next, budget, optics_at);
        }
    }
    path_transmittance * radiance
}
// ANCHOR_END: trace
