// ANCHOR: head
//! Coloured glass: it absorbs some of the light that passes through, and its shadow has its
//! colour. And what is where if clear bodies overlap.

mod media;
pub mod scene;
pub use media::{Medium, OpticsAt, as_if_alone, between_media, medium_along};

use fresnel::{fresnel, scatter};
use glam::Vec3;
use media::Way;
use plane_hit::Object;
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
#[inline]
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

// ANCHOR: follow
/// Follows a ray straight on, to the first hit with a surface that reflects or refracts it.
/// Returns the fraction of light that the media on the way transmit, and the hit with its
/// optics; `None` if there is none. Counts a ray for each surface that it crosses, and one
/// more for the rest of the way, even if that meets nothing.
#[inline]
pub fn follow(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    optics_at: OpticsAt,
) -> (Vec3, Option<(Interaction, Optics)>) {
    let mut way = Way::new(&scene.objects, ray);
    loop {
        canvas::count_ray();
        let Some(at) = way.go_on(T_MAX, |_| true) else {
            return (way.transmitted, None);
        };
        if let Some(optics) = optics_at(&scene.objects, &at) {
            return (way.transmitted, Some((at, optics)));
        }
        way.cross(&at);
    }
}
// ANCHOR_END: follow

// ANCHOR: through
/// Returns the shadow ray from a hit towards a light in front of the surface: it starts on the
/// side from which the ray has come, even if the light lies in the surface.
#[inline]
pub fn shadow_ray(at: &Interaction, to_light: Vec3) -> SurfaceRay {
    SurfaceRay {
        enters: !at.enters(),
        ..from_surface(at, to_light)
    }
}

/// Returns the fraction of a light's red, green and blue that arrives along a shadow ray from
/// `distance` away: 0 if an opaque object occludes it, else what the media between transmit.
/// Counts one ray.
///
/// Refraction and reflection by these media are ignored, so that the shadow of a ball of glass
/// has a colour but no caustic.
#[inline]
pub fn shadow_transmittance(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    light: Vec3,
    mut distance: f32,
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
    let mut way = Way::new(objects, ray);
    while let Some(at) = way.go_on(distance, |object| !is_opaque(object)) {
        distance -= at.t;
        way.cross(&at);
    }
    way.transmitted
}
// ANCHOR_END: through

// ANCHOR: trace
/// Returns the radiance along a ray: that of the first surface that reflects or refracts it,
/// and what is seen in it and through it, less what is absorbed along the ray; or the
/// background.
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
        let shadow_ray = shadow_ray(&at, to_light);
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

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
