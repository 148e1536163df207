//! The exercises' solutions, as the book prints them.

use ::shading::scene::still_life_surfaces;
use ::shading::{Phong, powi};
use ::shadows::Interaction;
use glam::Vec3;

// ANCHOR: exercise-1
pub fn five_shininesses() -> [Phong; 6] {
    let mut surfaces = still_life_surfaces();
    for (ball, shininess) in surfaces[1..].iter_mut().zip([5, 20, 80, 320, 1280]) {
        ball.shininess = shininess;
    }
    surfaces
}
// ANCHOR_END: exercise-1

// ANCHOR: exercise-2
pub fn blinn_phong(
    surface: &Phong,
    colour: Vec3,
    at: &Interaction,
    to_light: Vec3,
) -> Vec3 {
    let from_0_to_1 = |cos: f32| match cos {
        1.0.. => 1.0,
        0.0.. => cos,
        _ => 0.0,
    };
    let cos_theta_l = from_0_to_1(at.normal.dot(to_light));
    let diffuse = surface.diffuse * cos_theta_l * colour;
    let half = (to_light - at.incident).normalize();
    let cos_half = from_0_to_1(at.normal.dot(half));
    diffuse + Vec3::splat(surface.specular * powi(cos_half, surface.shininess))
}
// ANCHOR_END: exercise-2

// ANCHOR: exercise-3
pub fn ambient_from_around(sky: Vec3, ground: Vec3, normal: Vec3) -> Vec3 {
    ground.lerp(sky, (1.0 + normal.y) / 2.0)
}
// ANCHOR_END: exercise-3
