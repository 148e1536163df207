// ANCHOR: head
//! Shadow acne, and how a ray should leave a surface: it remembers its origin.

pub mod scene;

use fresnel::{fresnel, scatter};
use glam::Vec3;
use plane_hit::{Object, Shape, nearest_by};
use ray_casting::Ray;
use reflection::PathBudget;
use refraction::Material;
use shading::shade;
use shadows::{Interaction, SHADOW_BIAS, Scene, is_before_light, is_on_surface};
use sphere_hit::{Sphere, T_MAX, face_forward};
// ANCHOR_END: head

// ANCHOR: surface-ray
/// A ray, and the object on whose surface it starts, if that is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceRay {
    /// The ray.
    pub ray: Ray,
    /// The index of the object on whose surface the ray starts.
    pub origin: Option<usize>,
    /// Whether the ray enters that object.
    pub enters: bool,
}

/// A function that spawns a ray: from the hit and a unit direction to the ray.
pub type SpawnRay = fn(&Interaction, Vec3) -> SurfaceRay;

/// Returns a ray whose origin is not known to be on a surface.
#[inline]
pub fn untracked(ray: Ray) -> SurfaceRay {
    SurfaceRay {
        ray,
        origin: None,
        enters: false,
    }
}
// ANCHOR_END: surface-ray

// ANCHOR: offsets
/// Spawns a ray at a fixed distance from the surface, [`SHADOW_BIAS`].
pub fn with_fixed_offset(at: &Interaction, direction: Vec3) -> SurfaceRay {
    let normal = face_forward(at.outward, -direction);
    untracked(Ray {
        origin: at.point + SHADOW_BIAS * normal,
        direction,
    })
}

/// Spawns a ray at a distance from the surface that grows with the numbers of the scene:
/// 4 ε max(|p|, |c|, r) from the projected point, since each of its coordinates is rounded to
/// within ε/2 of these numbers, a few times over.
///
/// Source: the idea is that of Wächter and Binder, Ray Tracing Gems (2019), ch. 6.
pub fn with_scaled_offset(at: &Interaction, direction: Vec3) -> SurfaceRay {
    let point = project_to_surface(at);
    let mut largest = point.length();
    let others = match at.shape {
        Shape::Sphere(Sphere { centre, radius }) => [centre.length(), radius],
        Shape::Plane(plane) => [plane.point.length(), 0.0],
    };
    for other in others {
        if other > largest {
            largest = other;
        }
    }
    let offset = 4.0 * f32::EPSILON * largest;
    let normal = face_forward(at.outward, -direction);
    untracked(Ray {
        origin: point + offset * normal,
        direction,
    })
}

/// Returns the hit point, moved onto the surface as exactly as f32 can express.
#[inline]
fn project_to_surface(at: &Interaction) -> Vec3 {
    match at.shape {
        Shape::Sphere(sphere) => sphere.centre + sphere.radius * at.outward,
        Shape::Plane(plane) => {
            at.point - (at.point - plane.point).dot(at.outward) * at.outward
        }
    }
}
// ANCHOR_END: offsets

// ANCHOR: from-surface
/// Spawns a ray that starts on the surface, and remembers the object: the fix.
#[inline]
pub fn from_surface(at: &Interaction, direction: Vec3) -> SurfaceRay {
    let origin = project_to_surface(at);
    SurfaceRay {
        ray: Ray { origin, direction },
        origin: Some(at.index),
        enters: at.outward.dot(direction) < 0.0,
    }
}

/// Returns a function that starts rays at the eye of a camera. If the eye lies on the surface
/// of an object, they start on it, and do not hit it where they start. Of several such objects
/// it knows the first alone.
pub fn from_eye<M>(
    objects: &[Object<M>],
    eye: Vec3,
) -> impl Fn(Ray) -> SurfaceRay + use<M> {
    let origin = objects.iter().position(|it| is_on_surface(&it.shape, eye));
    let outward = origin.map(|index| objects[index].shape.normal(eye));
    move |ray| SurfaceRay {
        ray,
        origin,
        enters: outward.is_some_and(|outward| outward.dot(ray.direction) < 0.0),
    }
}

/// Returns the distance at which a ray that starts on a sphere leaves it, if 0 < t < `t_max`;
/// `None` otherwise.
///
/// One root of the quadratic is 0, where the ray starts, so only a linear term is left for
/// the other.
#[inline]
pub fn exit_distance(sphere: &Sphere, ray: &Ray, t_max: f32) -> Option<f32> {
    let direction = ray.direction;
    let t = -2.0 * direction.dot(ray.origin - sphere.centre) / direction.dot(direction);
    (t > 0.0 && t < t_max).then_some(t)
}

impl SurfaceRay {
    /// Returns the distance to the first hit with 0 < t < `t_max` on the object with this
    /// index. `None` if there is none. The object on which the ray starts can be hit again
    /// only from inside.
    #[inline(always)]
    pub fn distance(&self, index: usize, shape: &Shape, t_max: f32) -> Option<f32> {
        if self.origin != Some(index) {
            return shape.distance(&self.ray, t_max);
        }
        match shape {
            Shape::Sphere(sphere) if self.enters => {
                exit_distance(sphere, &self.ray, t_max)
            }
            // Both are convex.
            Shape::Sphere(_) | Shape::Plane(_) => None,
        }
    }

    /// Returns the interaction with the first object that the ray hits. `None` if it hits
    /// nothing. Counts one ray.
    #[inline]
    pub fn intersect<M>(&self, objects: &[Object<M>]) -> Option<Interaction> {
        canvas::count_ray();
        let hit = nearest_by(objects, T_MAX, |index, object, t_max| {
            self.distance(index, &object.shape, t_max)
        })?;
        Some(Interaction::new(objects, &self.ray, hit))
    }

    /// Returns the distance at which an object is hit between the ray's origin and a light
    /// that is `distance` away. `None` if it is not.
    #[inline]
    pub fn occlusion(
        &self,
        index: usize,
        shape: &Shape,
        light: Vec3,
        distance: f32,
    ) -> Option<f32> {
        let hit = self.distance(index, shape, distance);
        hit.filter(|&t| is_before_light(shape, &self.ray, t, light, distance))
    }

    /// Returns whether any object is between the ray's origin and a light that is `distance`
    /// away. Counts one ray.
    #[inline]
    pub fn is_occluded<M>(
        &self,
        objects: &[Object<M>],
        light: Vec3,
        distance: f32,
    ) -> bool {
        canvas::count_ray();
        let occlusion = |(index, object): (usize, &Object<M>)| {
            self.occlusion(index, &object.shape, light, distance)
        };
        objects
            .iter()
            .enumerate()
            .any(|object| occlusion(object).is_some())
    }
}
// ANCHOR_END: from-surface

// ANCHOR: without-offset
/// Spawns a ray at the computed point, which rounding puts on either side of the surface:
/// the bug.
pub fn without_offset(at: &Interaction, direction: Vec3) -> SurfaceRay {
    untracked(Ray {
        origin: at.point,
        direction,
    })
}
// ANCHOR_END: without-offset

// ANCHOR: trace
/// Returns the radiance along a ray, as `fresnel::trace` does, but with `spawn` to choose
/// where shadow rays, reflected and refracted rays start.
pub fn trace(
    scene: &Scene<Material>,
    ray: &SurfaceRay,
    budget: PathBudget,
    spawn: impl Fn(&Interaction, Vec3) -> SurfaceRay + Copy,
) -> Vec3 {
    let Some(at) = ray.intersect(&scene.objects) else {
        return scene.background;
    };
    let Material { phong, optics } = &scene.objects[at.index].material;
    let mut radiance = shade(phong, &at, &scene.lights, |light, to_light, distance| {
        let shadow_ray = spawn(&at, to_light);
        let is_occluded =
            shadow_ray.is_occluded(&scene.objects, light.position, distance);
        Vec3::splat(f32::from(!is_occluded))
    });
    for (weight, direction) in scatter(optics, &at, fresnel).into_iter().flatten() {
        if let Some(budget) = budget.attenuated(weight) {
            let next = spawn(&at, direction);
            radiance += weight * trace(scene, &next, budget, spawn);
        }
    }
    radiance
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
