//! The exercises' solutions, as the book prints them.

use ::plane_hit::{Texture, nearest};
use ::ray_casting::Ray;
use ::ray_casting::scene::still_life_camera;
use ::shadows::scene::lit_still_life;
use ::shadows::{Interaction, PointLight, Scene, is_visible};
use glam::Vec3;

// ANCHOR: exercise-1
pub fn still_life_with_headlamp(materials: [Texture; 6]) -> Scene<Texture> {
    let mut scene = lit_still_life(materials);
    let eye = still_life_camera().eye;
    scene.lights.push(PointLight {
        position: eye,
        intensity: 0.3,
    });
    scene
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn trace_coloured(scene: &Scene<Texture>, colours: &[Vec3], ray: &Ray) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let mut intensity = Vec3::ZERO;
    for (light, &colour) in scene.lights.iter().zip(colours) {
        if is_visible(scene, &at, light) {
            intensity += colour;
        }
    }
    intensity * scene.objects[at.index].material.value(at.uv())
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-4
pub fn faded(light: &PointLight, point: Vec3) -> f32 {
    light.intensity / light.position.distance_squared(point)
}
// ANCHOR_END: exercise-4
