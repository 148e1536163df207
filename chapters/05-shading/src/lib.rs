// ANCHOR: head
//! Let there be light: ambient, diffuse and specular reflection, by Phong's model.

pub mod scene;

use glam::Vec3;
use plane_hit::{Texture, nearest};
use ray_casting::{Ray, checked_normalize};
use shadows::{Interaction, PointLight, Scene, is_visible};
use std::ops::Mul;
// ANCHOR_END: head

// ANCHOR: phong
/// How a surface reflects light.
///
/// Source: Phong, "Illumination for Computer Generated Pictures" (1975).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// The colour of its ambient and diffuse light; a highlight has the light's own.
    pub colour: Texture,
    /// kₐ, the fraction of its colour that it always reflects, in place of all indirect
    /// light.
    pub ambient: f32,
    /// k_d, the fraction that it reflects in all directions alike.
    pub diffuse: f32,
    /// kₛ, the fraction that it reflects around the mirror direction.
    pub specular: f32,
    /// n, the exponent, at least 1: the larger, the smaller the highlight.
    pub shininess: u32,
}
// ANCHOR_END: phong

// ANCHOR: powi
/// Returns `base` to the power of `exponent`, by repeated squaring: with multiplications
/// alone, which IEEE 754 rounds alike on every machine.
///
/// `T` is f32, or sixteen of them.
///
/// Source: Knuth, The Art of Computer Programming, vol. 2, 4.6.3.
#[inline]
pub fn powi<T: Copy + From<f32> + Mul<Output = T>>(base: T, exponent: u32) -> T {
    let mut result = T::from(1.0);
    let mut square = base;
    let mut bits = exponent;
    while bits > 0 {
        if bits & 1 == 1 {
            result = result * square;
        }
        square = square * square;
        bits >>= 1;
    }
    result
}
// ANCHOR_END: powi

// ANCHOR: reflect-light
/// Returns the light that a `surface` of some `colour` reflects towards the viewer from one
/// light of intensity 1 in the direction `to_light`: k_d C (N·L) + k_s (R·V)ⁿ, where R is L
/// reflected about N, and V is −I.
///
/// `to_light` is a unit vector towards a light in front of the surface
/// ([`Interaction::is_in_front`]). The result is never more than k_d C + k_s.
///
/// Source: Phong 1975; the lecture's "Shading" slides.
#[inline]
pub fn phong(surface: &Phong, colour: Vec3, at: &Interaction, to_light: Vec3) -> Vec3 {
    let cos_theta_l = from_0_to_1(at.normal.dot(to_light));
    let diffuse = surface.diffuse * cos_theta_l * colour;
    let reflected = 2.0 * cos_theta_l * at.normal - to_light;
    let cos_alpha = from_0_to_1(reflected.dot(-at.incident));
    diffuse + Vec3::splat(surface.specular * powi(cos_alpha, surface.shininess))
}

/// Returns a cosine, 0 if it is negative, and 1 if rounding has made it larger: its power
/// would have no limit.
#[inline]
fn from_0_to_1(cos: f32) -> f32 {
    if cos > 1.0 {
        1.0
    } else if cos > 0.0 {
        cos
    } else {
        0.0
    }
}
// ANCHOR_END: reflect-light

// ANCHOR: shade
/// Returns the radiance that a `surface` sends back along the ray that hit it: its ambient
/// light, and what it reflects of every light.
///
/// `visibility` is given a light, the unit vector towards it and its distance, and returns
/// the fraction of its light that arrives, for red, green and blue: 1 if it is visible, 0 if
/// it is occluded. It is not called for a light behind the surface, nor for one of which the
/// surface would reflect nothing, so that no ray is traced that could not matter.
#[inline]
pub fn shade<'a>(
    surface: &Phong,
    at: &Interaction,
    lights: &'a [PointLight],
    mut visibility: impl FnMut(&'a PointLight, Vec3, f32) -> Vec3,
) -> Vec3 {
    let colour = surface.colour.value(at.uv());
    let mut radiance = surface.ambient * colour;
    for light in lights.iter().filter(|light| at.is_in_front(light.position)) {
        let to_light = light.position - at.point;
        // At the light itself there is no direction to it, and no light from it.
        let Some(direction) = checked_normalize(to_light) else {
            continue;
        };
        let reflected = phong(surface, colour, at, direction);
        if reflected != Vec3::ZERO {
            let visible = visibility(light, direction, to_light.length());
            radiance += light.intensity * reflected * visible;
        }
    }
    radiance
}
// ANCHOR_END: shade

// ANCHOR: trace
/// Returns the radiance along a ray: that of the surface that it hits first, or the
/// background.
pub fn trace(scene: &Scene<Phong>, ray: &Ray) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let surface = &scene.objects[at.index].material;
    shade(surface, &at, &scene.lights, |light, _, _| {
        Vec3::splat(f32::from(is_visible(scene, &at, light)))
    })
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
