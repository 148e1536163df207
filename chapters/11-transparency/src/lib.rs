// ANCHOR: head
//! Coloured glass: it absorbs some of the light that passes through, and its shadow has its
//! colour.

pub mod scene;
pub mod views;
pub use views::STAGE;

use fresnel::{fresnel, scatter};
use glam::Vec3;
use plane_hit::Object;
use ray_casting::Ray;
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

// ANCHOR: through
/// Returns the fraction of a light's red, green and blue that arrives along a shadow ray from
/// `distance` away: 0 if an opaque object occludes it, else what the dielectrics between
/// transmit. Counts one ray.
///
/// Refraction and reflection by these dielectrics are ignored, so that the shadow of a ball of
/// glass has a colour but no caustic.
#[must_use]
pub fn shadow_transmittance(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    distance: f32,
) -> Vec3 {
    canvas::count_ray();
    let occludes = |(index, object): (usize, &Object<Absorbing>)| {
        matches!(object.material.material.optics, Optics::Opaque { .. })
            && ray.distance(index, &object.shape, distance).is_some()
    };
    if scene.objects.iter().enumerate().any(occludes) {
        return Vec3::ZERO;
    }
    transmittance_along(scene, ray, distance)
}

/// Returns the fraction of light that all dielectrics transmit along a ray, from its origin to
/// `distance`.
fn transmittance_along(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    distance: f32,
) -> Vec3 {
    let mut transmitted = Vec3::ONE;
    for (index, object) in scene.objects.iter().enumerate() {
        if let Optics::Dielectric { .. } = object.material.material.optics {
            let inside = path_length_inside(&scene.objects, index, ray, distance);
            transmitted *= transmittance(object.material.absorption, inside);
        }
    }
    transmitted
}

/// Returns the length of the part of a ray, from its origin to `distance`, that lies inside
/// the sphere with this index.
///
/// Of a plane, whose inside is what lies behind it, only the part of a ray that comes from in
/// front is found: a ray that starts behind the plane gives 0.
#[must_use]
pub fn path_length_inside<M>(
    objects: &[Object<M>],
    index: usize,
    ray: &SurfaceRay,
    distance: f32,
) -> f32 {
    let shape = &objects[index].shape;
    let Some(t) = ray.distance(index, shape, T_MAX) else {
        return 0.0;
    };
    let Ray { direction, .. } = ray.ray;
    let at = Interaction::new(objects, &ray.ray, (index, t));
    if at.outward.dot(direction) > 0.0 {
        // It starts inside, and ends there or leaves.
        return if t < distance { t } else { distance };
    }
    let rest = distance - t;
    if !(rest > 0.0) {
        return 0.0;
    }
    let entered = from_surface(shape, &at, direction);
    entered.distance(index, shape, rest).unwrap_or(rest)
}
// ANCHOR_END: through

// ANCHOR: trace
/// Returns the radiance along a ray: that of the surface that it hits first, and what is seen
/// in it and through it, less what is absorbed along the ray; or the background.
#[must_use]
pub fn trace(scene: &Scene<Absorbing>, ray: &SurfaceRay, budget: PathBudget) -> Vec3 {
    let Some(at) = ray.intersect(&scene.objects) else {
        return scene.background;
    };
    let Object {
        shape, material, ..
    } = &scene.objects[at.index];
    let Material { phong, optics } = &material.material;
    // All light from here has come along the ray, through the medium that the ray is in.
    let path_transmittance = transmittance_along(scene, ray, at.t);
    let mut radiance = shade(phong, &at, &scene.lights, |_, to_light, distance| {
        shadow_transmittance(scene, &from_surface(shape, &at, to_light), distance)
    });
    for (weight, direction) in scatter(optics, &at, fresnel).into_iter().flatten() {
        let coefficient = weight * path_transmittance.max_element();
        if let Some(budget) = budget.attenuated(coefficient) {
            let next = from_surface(shape, &at, direction);
            radiance += weight * trace(scene, &next, budget);
        }
    }
    path_transmittance * radiance
}
// ANCHOR_END: trace
