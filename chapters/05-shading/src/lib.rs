// ANCHOR: head
//! Let there be light: ambient, diffuse and specular, by Phong.

pub mod views;
pub use views::STAGE;

use glam::Vec3;
use plane_hit::{Pattern, nearest};
use ray_casting::{Ray, unit};
use shadows::{PointLight, Scene, light_reaches};
use sphere_hit::facing;
use std::ops::Mul;
// ANCHOR_END: head

// ANCHOR: phong
/// How a surface answers to light.
///
/// Source: Phong, "Illumination for Computer Generated Pictures" (1975).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// The colour of its ambient and diffuse light; a highlight has the light's own.
    pub colour: Pattern,
    /// kₐ: how much it glows without any lamp, in place of all the light that comes in
    /// roundabout ways.
    pub ambient: f32,
    /// k_d: how much it scatters in all directions alike.
    pub diffuse: f32,
    /// kₛ: how much it throws back about the mirror direction.
    pub specular: f32,
    /// n, at least 1: the larger, the smaller the highlight.
    pub shininess: u32,
}
// ANCHOR_END: phong

// ANCHOR: power
/// `base` to the power of `exponent`, by repeated squaring: the same bits on every
/// machine.
///
/// `T` is f32, or, in chapter 12, sixteen of them.
///
/// Source: Knuth, The Art of Computer Programming, vol. 2, 4.6.3.
#[must_use]
pub fn power<T: Copy + From<f32> + Mul<Output = T>>(base: T, exponent: u32) -> T {
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
// ANCHOR_END: power

// ANCHOR: lit
/// The light of one lamp of intensity 1 that a `surface` of some `colour` sends back
/// along −`incident`: k_d C (N·L) + kₛ (R·V)ⁿ, where R is L mirrored about N, and V is
/// −I.
///
/// `incident`, `normal` and `to_light` are unit vectors, and `normal` faces the incident
/// ray. A lamp behind the surface gives nothing, not even a highlight.
///
/// Source: the talk's "Shading" slides.
#[must_use]
pub fn lit(
    surface: &Phong,
    colour: Vec3,
    incident: Vec3,
    normal: Vec3,
    to_light: Vec3,
) -> Vec3 {
    let cos_theta_l = normal.dot(to_light);
    if !(cos_theta_l > 0.0) {
        return Vec3::ZERO;
    }
    let diffuse = surface.diffuse * cos_theta_l * colour;
    let mirrored = 2.0 * cos_theta_l * normal - to_light;
    let cos_alpha = mirrored.dot(-incident);
    if !(cos_alpha > 0.0) {
        return diffuse;
    }
    diffuse + Vec3::splat(surface.specular * power(cos_alpha, surface.shininess))
}
// ANCHOR_END: lit

// ANCHOR: shade
/// The light that a `point` of a `surface` sends back along −`incident`: its ambient
/// light, and that of every lamp in `lights` for which `reaches` holds.
///
/// `reaches` is not asked about a lamp that would give nothing: no ray is cast that could
/// not matter.
#[must_use]
pub fn shade(
    surface: &Phong,
    incident: Vec3,
    point: Vec3,
    normal: Vec3,
    lights: &[PointLight],
    reaches: impl Fn(&PointLight) -> bool,
) -> Vec3 {
    let colour = surface.colour.at(point);
    let mut sum = surface.ambient * colour;
    for light in lights {
        // At the lamp itself there is no direction to it, and no light from it.
        let Some(to_light) = unit(light.position - point) else {
            continue;
        };
        let lit = lit(surface, colour, incident, normal, to_light);
        if lit != Vec3::ZERO && reaches(light) {
            sum += light.intensity * lit;
        }
    }
    sum
}
// ANCHOR_END: shade

// ANCHOR: trace
/// What a ray brings back: the shaded light of what it meets first, or the background.
#[must_use]
pub fn trace(scene: &Scene<Phong>, ray: &Ray) -> Vec3 {
    let Some((object, hit)) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let point = ray.at(hit.t);
    let normal = facing(hit.normal, ray.direction);
    let reaches = |light: &PointLight| light_reaches(scene, point, normal, light);
    shade(
        &object.material,
        ray.direction,
        point,
        normal,
        &scene.lights,
        reaches,
    )
}
// ANCHOR_END: trace
