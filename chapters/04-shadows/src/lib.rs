// ANCHOR: head
//! Shadows: from every hit a ray towards the light, and darkness if something is in its
//! way.

pub mod views;
pub use views::STAGE;

use glam::Vec3;
use plane_hit::{Object, Pattern, nearest};
use ray_casting::Ray;
use sphere_hit::{FARTHEST, facing};
// ANCHOR_END: head

// ANCHOR: scene
/// A lamp too small to see; its light does not fade with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it hangs.
    pub position: Vec3,
    /// How strong it is; 1 lights a white surface that faces it to full white.
    pub intensity: f32,
}

/// What there is to see, and by which light.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<M> {
    /// Everything a ray can hit.
    pub objects: Vec<Object<M>>,
    /// Every lamp.
    pub lights: Vec<PointLight>,
    /// The linear light of a ray that hits nothing.
    pub background: Vec3,
}
// ANCHOR_END: scene

// ANCHOR: shadow-ray
/// How far from a surface, along its normal, a shadow ray starts: a ten-thousandth of a
/// ball of radius 1.
///
/// A computed hit lies a little above or below the surface, and from below the surface
/// would shadow itself. A fixed distance is right for scenes about as large as ours, and
/// for no other: chapter 10 shows where it fails, and the cure.
pub const OFFSET: f32 = 1e-4;

/// The ray from a `point` on a surface towards a light, and the distance to go; `None`
/// for a light behind the surface, which hides it: from above the surface, a ray could
/// slip past its edge.
fn shadow_ray(point: Vec3, normal: Vec3, light: &PointLight) -> Option<(Ray, f32)> {
    let origin = point + OFFSET * normal;
    let to_light = light.position - origin;
    if !(normal.dot(to_light) > 0.0) {
        return None;
    }
    canvas::count_ray();
    let direction = to_light.normalize();
    Some((Ray { origin, direction }, to_light.length()))
}

/// Whether anything is in the ray's way before `t_max`; the first blocker ends the
/// search.
fn is_blocked<M>(scene: &Scene<M>, ray: &Ray, t_max: f32) -> bool {
    let mut objects = scene.objects.iter();
    objects.any(|object| object.shape.hit(ray, t_max).is_some())
}
// ANCHOR_END: shadow-ray

// ANCHOR: reaches
/// Whether the light reaches a `point`, on the side of the surface that `normal`, a unit
/// vector, points to.
///
/// Source: the talk's "Now with Shadows" slide.
#[must_use]
pub fn light_reaches<M>(
    scene: &Scene<M>,
    point: Vec3,
    normal: Vec3,
    light: &PointLight,
) -> bool {
    shadow_ray(point, normal, light)
        .is_some_and(|(ray, distance)| !is_blocked(scene, &ray, distance))
}
// ANCHOR_END: reaches

// ANCHOR: buggy
/// The talk's buggy shadow: whatever lies in the light's direction blocks it, even from
/// beyond.
#[must_use]
pub fn light_reaches_buggy<M>(
    scene: &Scene<M>,
    point: Vec3,
    normal: Vec3,
    light: &PointLight,
) -> bool {
    shadow_ray(point, normal, light)
        .is_some_and(|(ray, _)| !is_blocked(scene, &ray, FARTHEST))
}
// ANCHOR_END: buggy

// ANCHOR: trace
/// What decides whether a light reaches a point with a normal.
pub type Reaches<M> = fn(&Scene<M>, Vec3, Vec3, &PointLight) -> bool;

/// What a ray brings back: the flat colour of what it meets first, times the light that
/// reaches it.
#[must_use]
pub fn trace(scene: &Scene<Pattern>, ray: &Ray, reaches: Reaches<Pattern>) -> Vec3 {
    let Some((object, hit)) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let point = ray.at(hit.t);
    let normal = facing(hit.normal, ray.direction);
    let mut intensity = 0.0;
    for light in &scene.lights {
        if reaches(scene, point, normal, light) {
            intensity += light.intensity;
        }
    }
    intensity * object.material.at(point)
}
// ANCHOR_END: trace
