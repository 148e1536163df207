//! Explains a pixel's ray: what it hits, and the radiance along every ray that follows from
//! it.
//!
//! [`explain`] does what [`shadow_acne::trace`] does, by the same functions in the same order,
//! and takes notes. That one stays as plain as it is, and a test asserts that the two agree to
//! the last bit.

use canvas::Pixel;
use fresnel::{fresnel, scatter};
use glam::{Vec2, Vec3};
use plane_hit::Object;
use ray_casting::{Camera, Ray};
use reflection::{MAX_DEPTH, PathBudget};
use refraction::Material;
use shading::shade;
use shadow_acne::{SurfaceRay, from_eye, from_surface};
use shadows::{Interaction, PointLight, Scene};

// ANCHOR: explained
/// A ray, its outcome, and the radiance along it.
#[derive(Clone, Debug)]
pub struct Explained<'a> {
    /// The ray.
    pub ray: Ray,
    /// Its kind.
    pub kind: RayKind,
    /// The fraction of its radiance that the ray before it receives; the camera's ray has 1.
    pub weight: f32,
    /// The fraction of its radiance that the pixel receives.
    pub throughput: f32,
    /// Its outcome.
    pub outcome: Outcome<'a>,
    /// The radiance along it, linear.
    pub radiance: Vec3,
    /// The number of rays that were traced for it: itself, its shadow rays, and those of all
    /// rays that follow from it.
    pub rays: u64,
}

/// The kind of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RayKind {
    /// The camera casts it.
    Camera,
    /// A surface reflects it.
    Reflected,
    /// It is refracted, into a dielectric or out of it.
    Transmitted,
}

/// The outcome of a ray.
#[derive(Clone, Debug)]
pub enum Outcome<'a> {
    /// It hits an object.
    Hit(SurfaceHit<'a>),
    /// It hits nothing: its radiance is the background's.
    Background,
    /// It is not traced: the budget has no bounces left, or its throughput is too low.
    NotTraced,
}

/// A ray's hit on an object.
#[derive(Clone, Debug)]
pub struct SurfaceHit<'a> {
    /// The object.
    pub object: &'a Object<Material>,
    /// The hit.
    pub at: Interaction,
    /// The radiance by shading alone: ambient light, and that of the visible lights.
    pub local: Vec3,
    /// Every light of the scene, in order, and its visibility from the point.
    pub lights: Vec<(&'a PointLight, Visibility<'a>)>,
    /// The reflected and the transmitted ray, if there are such rays, traced or not.
    pub secondary: Vec<Explained<'a>>,
}

/// The visibility of a light from a point.
#[derive(Clone, Copy, Debug)]
pub enum Visibility<'a> {
    /// No object is between the two.
    Visible,
    /// This object is between the two, where the shadow ray hits it: the first such object in
    /// the scene's list.
    Occluded(&'a Object<Material>, Vec3),
    /// The light is behind the surface; no shadow ray is traced.
    BelowHorizon,
    /// The surface would reflect none of its light along the ray. No shadow ray is traced.
    NoContribution,
}
// ANCHOR_END: explained

/// Returns the budget of the finished picture's rays.
pub fn budget() -> PathBudget {
    PathBudget::new(MAX_DEPTH)
}

/// Returns the ray of `camera` through a `point` of the image plane, explained. Its radiance
/// is that of [`shadow_acne::trace`] with [`from_surface`], bit for bit.
pub fn explain<'a>(
    scene: &'a Scene<Material>,
    camera: &Camera,
    point: Vec2,
    budget: PathBudget,
) -> Explained<'a> {
    let ray = from_eye(&scene.objects, camera.eye)(camera.ray(point));
    let throughput = budget.throughput;
    trace(scene, &ray, RayKind::Camera, 1.0, throughput, Some(budget))
}

/// Returns the ray through the centre of a pixel in words, as the finished picture has it.
pub fn explanation(scene: &Scene<Material>, camera: &Camera, pixel: Pixel) -> String {
    let explained = explain(scene, camera, pixel.centre(), budget());
    let Pixel { x, y, size } = pixel;
    let [width, height] = size.to_array();
    format!("pixel {x},{y} of {width}x{height}, the ray through its centre\n{explained}")
}

// ANCHOR: trace
fn trace<'a>(
    scene: &'a Scene<Material>,
    ray: &SurfaceRay,
    kind: RayKind,
    weight: f32,
    throughput: f32,
    budget: Option<PathBudget>,
) -> Explained<'a> {
    let mut explained = Explained {
        ray: ray.ray,
        kind,
        weight,
        throughput,
        outcome: Outcome::NotTraced,
        radiance: Vec3::ZERO,
        rays: 0,
    };
    let Some(budget) = budget else {
        return explained;
    };
    explained.rays = 1;
    let Some(at) = ray.intersect(&scene.objects) else {
        explained.outcome = Outcome::Background;
        explained.radiance = scene.background;
        return explained;
    };
    let object = &scene.objects[at.index];
    let Material { phong, optics } = &object.material;

    // The visibility of a light towards which shading traces no ray.
    let untraced = |light: &'a PointLight| {
        let visibility = if at.is_in_front(light.position) {
            Visibility::NoContribution
        } else {
            Visibility::BelowHorizon
        };
        (light, visibility)
    };
    let mut lights: Vec<_> = scene.lights.iter().map(untraced).collect();
    let local = shade(phong, &at, &scene.lights, |light, to_light, distance| {
        let shadow_ray = from_surface(&at, to_light);
        let seen = visibility(scene, &shadow_ray, light.position, distance);
        explained.rays += 1;
        for (_, visibility) in lights.iter_mut().filter(|(other, _)| *other == light) {
            *visibility = seen;
        }
        Vec3::splat(f32::from(matches!(seen, Visibility::Visible)))
    });
    explained.radiance = local;

    let mut secondary = Vec::new();
    let kinds = [RayKind::Reflected, RayKind::Transmitted].into_iter();
    for (kind, scattered) in kinds.zip(scatter(optics, &at, fresnel)) {
        let Some((weight, direction)) = scattered else {
            continue;
        };
        let ray = from_surface(&at, direction);
        let throughput = budget.throughput * weight;
        let budget = budget.attenuated(weight);
        let next = trace(scene, &ray, kind, weight, throughput, budget);
        explained.radiance += weight * next.radiance;
        explained.rays += next.rays;
        secondary.push(next);
    }
    explained.outcome = Outcome::Hit(SurfaceHit {
        object,
        at,
        local,
        lights,
        secondary,
    });
    explained
}
// ANCHOR_END: trace

/// Returns the visibility of the light that a shadow ray points to, `distance` away.
fn visibility<'a>(
    scene: &'a Scene<Material>,
    shadow_ray: &SurfaceRay,
    light: Vec3,
    distance: f32,
) -> Visibility<'a> {
    let mut objects = scene.objects.iter().enumerate();
    let occluder = objects.find_map(|(index, object)| {
        let t = shadow_ray.occlusion(index, &object.shape, light, distance)?;
        Some(Visibility::Occluded(object, shadow_ray.ray.at(t)))
    });
    occluder.unwrap_or(Visibility::Visible)
}
