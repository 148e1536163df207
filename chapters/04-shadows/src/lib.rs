// ANCHOR: head
//! Shadows: from every hit a ray towards each light, which lights it only if no object is
//! between.

pub mod scene;
pub mod views;
pub use views::STAGE;

use glam::Vec3;
use plane_hit::{Object, Texture, nearest};
use ray_casting::Ray;
use sphere_hit::{T_MAX, face_forward};
// ANCHOR_END: head

// ANCHOR: scene
/// A light source without extent; its light does not fade with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Its position.
    pub position: Vec3,
    /// Its intensity; 1 lights a white surface that faces the light to full white.
    pub intensity: f32,
}

/// Objects, and the lights that shine on them.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<M> {
    /// The objects that rays can hit.
    pub objects: Vec<Object<M>>,
    /// All light sources.
    pub lights: Vec<PointLight>,
    /// The radiance, linear, along a ray that hits nothing.
    pub background: Vec3,
}

impl<M> Scene<M> {
    /// Returns the same scene with other materials.
    pub fn map<N>(self, material: impl Fn(M) -> N) -> Scene<N> {
        let objects = self.objects.into_iter();
        Scene {
            objects: objects.map(|object| object.map(&material)).collect(),
            lights: self.lights,
            background: self.background,
        }
    }
}
// ANCHOR_END: scene

// ANCHOR: interaction
/// A ray's hit on an object, with all that shading needs.
///
/// Source: `SurfaceInteraction` in Pharr, Jakob and Humphreys, Physically Based Rendering.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interaction {
    /// The object's index in the scene.
    pub index: usize,
    /// The distance along the ray.
    pub t: f32,
    /// The hit point.
    pub point: Vec3,
    /// The ray's direction; a unit vector.
    pub incident: Vec3,
    /// The surface's outward unit normal.
    pub outward: Vec3,
    /// The unit normal on the side from which the ray comes.
    pub normal: Vec3,
}

impl Interaction {
    /// Returns the interaction of `ray` with the object that it hits: its index, and the
    /// distance.
    #[inline]
    #[must_use]
    pub fn new<M>(objects: &[Object<M>], ray: &Ray, (index, t): (usize, f32)) -> Self {
        let point = ray.at(t);
        let outward = objects[index].shape.normal(point);
        Self {
            index,
            t,
            point,
            incident: ray.direction,
            outward,
            normal: face_forward(outward, ray.direction),
        }
    }
}
// ANCHOR_END: interaction

// ANCHOR: shadow-ray
/// The distance from a surface, along its normal, at which a new ray starts: a
/// ten-thousandth of the radius of a ball of radius 1.
///
/// Rounding puts a computed hit above or below the surface, and from below it the surface
/// would shadow itself. A fixed distance is right for scenes about as large as ours, and for
/// no other: the chapter about shadow acne shows where it fails, and the cure.
pub const SHADOW_BIAS: f32 = 1e-4;

/// Returns the ray from a hit towards a light, and the distance to the light. `None` if the
/// light is behind the surface, which hides it: a ray from above the surface could slip past
/// its edge.
fn shadow_ray(at: &Interaction, light: &PointLight) -> Option<(Ray, f32)> {
    let origin = at.point + SHADOW_BIAS * at.normal;
    let to_light = light.position - origin;
    if !(at.normal.dot(to_light) > 0.0) {
        return None;
    }
    let (direction, distance) = to_light.normalize_and_length();
    Some((Ray { origin, direction }, distance))
}

/// Returns whether any object is hit with 0 < t < `t_max`; the first one found ends the
/// search. Counts one ray.
#[inline]
#[must_use]
pub fn is_occluded<M>(objects: &[Object<M>], ray: &Ray, t_max: f32) -> bool {
    canvas::count_ray();
    let mut objects = objects.iter();
    objects.any(|object| object.shape.distance(ray, t_max).is_some())
}
// ANCHOR_END: shadow-ray

// ANCHOR: visible
/// Returns whether a light is visible from a hit.
///
/// Source: the lecture's "Now with Shadows" slide.
#[must_use]
pub fn is_visible<M>(scene: &Scene<M>, at: &Interaction, light: &PointLight) -> bool {
    shadow_ray(at, light)
        .is_some_and(|(ray, distance)| !is_occluded(&scene.objects, &ray, distance))
}
// ANCHOR_END: visible

// ANCHOR: buggy
/// Returns whether a light is visible from a hit, with the lecture's bug: an object beyond
/// the light occludes it, too.
#[must_use]
pub fn is_visible_buggy<M>(
    scene: &Scene<M>,
    at: &Interaction,
    light: &PointLight,
) -> bool {
    shadow_ray(at, light)
        .is_some_and(|(ray, _)| !is_occluded(&scene.objects, &ray, T_MAX))
}
// ANCHOR_END: buggy

// ANCHOR: trace
/// A function that returns whether a light is visible from a hit.
pub type Visibility<M> = fn(&Scene<M>, &Interaction, &PointLight) -> bool;

/// Returns the flat colour of the first object that the ray hits, times the intensity of the
/// lights that are visible from there; or the background.
#[must_use]
pub fn trace(scene: &Scene<Texture>, ray: &Ray, is_visible: Visibility<Texture>) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let mut intensity = 0.0;
    for light in &scene.lights {
        if is_visible(scene, &at, light) {
            intensity += light.intensity;
        }
    }
    intensity * scene.objects[at.index].material.value(at.point)
}
// ANCHOR_END: trace
