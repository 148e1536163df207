//! The exercises' solutions, as the book prints them.

use ::plane_hit::nearest;
use ::ray_casting::Ray;
use ::reflection::scene::still_life_mirrors;
use ::reflection::{Mirror, PathBudget, reflect};
use ::shading::shade;
use ::shadows::{Interaction, SHADOW_BIAS, Scene, is_visible};
use glam::Vec3;

// ANCHOR: exercise-1
pub fn still_life_on_a_mirror() -> [Mirror; 6] {
    let mut mirrors = still_life_mirrors();
    mirrors[0].reflectivity = 0.3;
    mirrors
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn trace_tinted(
    scene: &Scene<Mirror>,
    tints: &[Vec3],
    ray: &Ray,
    budget: PathBudget,
) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let surface = &scene.objects[at.index].material.phong;
    let radiance = shade(surface, &at, &scene.lights, |light, _, _| {
        Vec3::splat(f32::from(is_visible(scene, &at, light)))
    });
    let tint = tints[at.index];
    let Some(budget) = budget.attenuated(tint.max_element()) else {
        return radiance;
    };
    let reflected = Ray {
        origin: at.point + SHADOW_BIAS * at.normal,
        direction: reflect(at.incident, at.normal),
    };
    radiance + tint * trace_tinted(scene, tints, &reflected, budget)
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
pub fn differing_pixels(first: &[[u8; 3]], second: &[[u8; 3]]) -> Vec<usize> {
    let pixels = 0..first.len();
    pixels.filter(|&i| first[i] != second[i]).collect()
}
// ANCHOR_END: exercise-3
