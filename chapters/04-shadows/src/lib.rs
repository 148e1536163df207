// ANCHOR: head
//! Shadows: from every hit a ray towards each light, which lights it only if no object is
//! between.

mod interaction;
pub mod scene;
pub use interaction::{Interaction, MIN_COS_THETA, ROUNDING, is_on_surface};

use glam::Vec3;
use interaction::is_same;
use plane_hit::{Object, Shape, Texture, nearest};
use ray_casting::{MAX_LENGTH, Ray, is_position};
use std::fmt::{Display, Formatter};
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

impl PointLight {
    /// Returns a light. `None` if its position is out of range ([`is_position`]), or its
    /// intensity not between 0 and [`MAX_LENGTH`].
    pub fn new(position: Vec3, intensity: f32) -> Option<Self> {
        let is_valid = is_position(position) && (0.0..=MAX_LENGTH).contains(&intensity);
        is_valid.then_some(Self {
            position,
            intensity,
        })
    }
}

/// Objects, and the lights that shine on them.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<M> {
    /// The objects that rays can hit, no two of them with the same surface.
    pub objects: Vec<Object<M>>,
    /// All light sources.
    pub lights: Vec<PointLight>,
    /// The radiance, linear, along a ray that hits nothing.
    pub background: Vec3,
}

/// Two objects with one and the same surface, up to a few roundings, which would decide at
/// every point which of the two a ray hits. Surfaces that touch, or that come nearly as close
/// in some place, are not refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoincidentSurfaces(pub [&'static str; 2]);

impl Display for CoincidentSurfaces {
    fn fmt(&self, f: &mut Formatter) -> std::fmt::Result {
        let [first, second] = self.0;
        write!(
            f,
            "{first} and {second} have the same surface; move one of them"
        )
    }
}

impl std::error::Error for CoincidentSurfaces {}

impl<M> Scene<M> {
    /// Returns a scene.
    ///
    /// # Errors
    /// If two objects have the same surface.
    pub fn new(
        objects: Vec<Object<M>>,
        lights: Vec<PointLight>,
        background: Vec3,
    ) -> Result<Self, CoincidentSurfaces> {
        for (index, second) in objects.iter().enumerate() {
            let coincides = |first: &&Object<M>| is_same(&first.shape, &second.shape);
            if let Some(first) = objects[..index].iter().find(coincides) {
                return Err(CoincidentSurfaces([first.name, second.name]));
            }
        }
        Ok(Self {
            objects,
            lights,
            background,
        })
    }

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
    if !at.is_in_front(light.position) {
        return None;
    }
    let origin = at.point + SHADOW_BIAS * at.normal;
    let (direction, distance) = (light.position - origin).normalize_and_length();
    Some((Ray { origin, direction }, distance))
}

/// Returns whether the hit of a ray on a shape at `t`, nearer than a light `distance` away,
/// lies before the light. It does not if the light is on the surface and this is where the
/// ray arrives there: then rounding alone has put the hit nearer.
#[inline]
pub fn is_before_light(
    shape: &Shape,
    ray: &Ray,
    t: f32,
    light: Vec3,
    distance: f32,
) -> bool {
    let is_other_side = shape.is_entered(ray, t) != shape.is_entered(ray, distance);
    is_other_side || !is_on_surface(shape, light)
}

/// Returns whether any object is between a ray's origin and a light, which is `distance` away;
/// the first one found ends the search. Counts one ray.
pub fn is_occluded<M>(
    objects: &[Object<M>],
    ray: &Ray,
    light: Vec3,
    distance: f32,
) -> bool {
    canvas::count_ray();
    objects.iter().any(|Object { shape, .. }| {
        let hit = shape.distance(ray, distance);
        hit.is_some_and(|t| is_before_light(shape, ray, t, light, distance))
    })
}
// ANCHOR_END: shadow-ray

// ANCHOR: visible
/// Returns whether a light is visible from a hit.
///
/// Source: the lecture's "Now with Shadows" slide.
pub fn is_visible<M>(scene: &Scene<M>, at: &Interaction, light: &PointLight) -> bool {
    shadow_ray(at, light).is_some_and(|(ray, distance)| {
        !is_occluded(&scene.objects, &ray, light.position, distance)
    })
}
// ANCHOR_END: visible

// ANCHOR: buggy
/// Returns whether a light is visible from a hit, with the lecture's bug: an object beyond
/// the light occludes it, too.
pub fn is_visible_buggy<M>(
    scene: &Scene<M>,
    at: &Interaction,
    light: &PointLight,
) -> bool {
    shadow_ray(at, light).is_some_and(|(ray, _)| nearest(&scene.objects, &ray).is_none())
}
// ANCHOR_END: buggy

// ANCHOR: trace
/// A function that returns whether a light is visible from a hit.
pub type Visibility<M> = fn(&Scene<M>, &Interaction, &PointLight) -> bool;

/// Returns the flat colour of the first object that the ray hits, times the intensity of the
/// lights that are visible from there; or the background.
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
    intensity * scene.objects[at.index].material.value(at.uv())
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
