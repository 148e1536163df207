// ANCHOR: head
//! Coloured glass: it keeps some of the light that goes through, and its shadow has its
//! colour.

pub mod views;
pub use views::STAGE;

use fresnel::{fresnel, ways_on};
use glam::Vec3;
use plane_hit::Object;
use ray_casting::{Ray, unit};
use reflection::Reach;
use refraction::{Body, Material};
use shading::lit;
use shadow_acne::{Leaving, from_the_surface};
use shadows::{PointLight, Scene};
use sphere_hit::{FARTHEST, facing};
// ANCHOR_END: head

// ANCHOR: absorb
/// What is left of light after a way of some length through a medium: e^(−a d), for red,
/// green and blue.
///
/// `absorption` is what is lost in a unit of length, as a rate, at least 0.
///
/// Source: Beer–Lambert law (Bouguer 1729).
#[must_use]
pub fn transmittance(absorption: Vec3, distance: f32) -> Vec3 {
    (-absorption * distance).map(libm::expf)
}
// ANCHOR_END: absorb

// ANCHOR: material
/// A material whose inside may have a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tinted {
    /// Its surface, and what becomes of light there.
    pub material: Material,
    /// How fast its inside takes up red, green and blue light, for each unit of length.
    pub absorption: Vec3,
}
// ANCHOR_END: material

// ANCHOR: through
/// What is left of a lamp's light on a straight way of length `distance` to it: nothing
/// behind anything opaque, and what clear things on the way let through.
///
/// Straight: what a clear thing would bend elsewhere, and what its surface would mirror,
/// is left out. So a ball of glass throws a shadow of its colour, but no bright spot in
/// it.
#[must_use]
pub fn light_through(
    scene: &Scene<Tinted>,
    ray: &Leaving<Tinted>,
    distance: f32,
) -> Vec3 {
    let blocks = |object: &Object<Tinted>| {
        matches!(object.material.material.body, Body::Opaque { .. })
            && ray.hit(object, distance).is_some()
    };
    if scene.objects.iter().any(blocks) {
        return Vec3::ZERO;
    }
    left_after(scene, ray, distance)
}

/// What all clear things leave of light on a ray's way of some `distance`.
fn left_after(scene: &Scene<Tinted>, ray: &Leaving<Tinted>, distance: f32) -> Vec3 {
    let mut light = Vec3::ONE;
    for object in &scene.objects {
        if let Body::Clear { .. } = object.material.material.body {
            let inside = way_inside(object, ray, distance);
            light *= transmittance(object.material.absorption, inside);
        }
    }
    light
}

/// How much of a ray's way of some `distance` is inside an object.
#[must_use]
pub fn way_inside<M>(object: &Object<M>, ray: &Leaving<M>, distance: f32) -> f32 {
    let Some(hit) = ray.hit(object, FARTHEST) else {
        return 0.0;
    };
    let Ray { direction, .. } = ray.ray;
    if hit.normal.dot(direction) > 0.0 {
        // It starts inside, and ends there or leaves.
        return if hit.t < distance { hit.t } else { distance };
    }
    let left = distance - hit.t;
    if !(left > 0.0) {
        return 0.0;
    }
    let entered = from_the_surface(object, ray.ray.at(hit.t), hit.normal, direction);
    entered.hit(object, left).map_or(left, |exit| exit.t)
}
// ANCHOR_END: through

// ANCHOR: trace
/// What a ray brings back: the light of what it meets first, and what is seen in it and
/// through it.
#[must_use]
pub fn trace(scene: &Scene<Tinted>, leaving: Leaving<Tinted>, reach: Reach) -> Vec3 {
    let Some((object, hit)) = leaving.nearest(&scene.objects) else {
        return scene.background;
    };
    let Material { phong, body } = &object.material.material;
    let incident = leaving.ray.direction;
    let point = leaving.ray.at(hit.t);
    let normal = facing(hit.normal, incident);
    // All that comes from here has come the ray's way, through whatever the ray has been
    // in.
    let on_the_way = left_after(scene, &leaving, hit.t);

    let colour = phong.colour.at(point);
    let mut light = phong.ambient * colour;
    for PointLight {
        position,
        intensity,
    } in &scene.lights
    {
        let to_light = *position - point;
        let Some(direction) = unit(to_light) else {
            continue;
        };
        let lit = lit(phong, colour, incident, normal, direction);
        if lit != Vec3::ZERO {
            canvas::count_ray();
            let ray = from_the_surface(object, point, hit.normal, direction);
            light += *intensity * lit * light_through(scene, &ray, to_light.length());
        }
    }

    for (share, direction) in ways_on(body, incident, hit.normal, fresnel) {
        if let Some(reach) = reach.after(share * on_the_way.max_element()) {
            canvas::count_ray();
            let leaving = from_the_surface(object, point, hit.normal, direction);
            light += share * trace(scene, leaving, reach);
        }
    }
    on_the_way * light
}
// ANCHOR_END: trace
