// ANCHOR: head
//! Sixteen rays at once (SIMD): lanes in place of numbers, masks in place of `if`, and the
//! same picture to the last bit.

mod interactions;
mod intersect;
mod lanes;
pub use intersect::{Packet, packets_so_far};
pub use lanes::{LANES, Lanes, Vec3x16};

use canvas::Pixel;
use glam::{UVec2, Vec2, Vec3};
use interactions::{Interactions, colour, phong, scatter};
use ray_casting::Camera;
use reflection::PathBudget;
use refraction::Material;
use shadows::Scene;
// ANCHOR_END: head

// ANCHOR: shade
impl Interactions<'_> {
    /// Returns the ambient light, and what the surface reflects of every visible light.
    fn shade(&self, scene: &Scene<Material>) -> Vec3x16 {
        let surface = &self.material.phong;
        let colour = colour(surface.colour, self.shape, self.point);
        let mut radiance = colour * surface.ambient;
        for light in &scene.lights {
            let to_light = Vec3x16::splat(light.position) - self.point;
            let direction = to_light.normalize();
            let (reflected, is_lit) = phong(surface, colour, self, direction);
            let in_front = self.are_in_front(light.position) & to_light.is_normalizable();
            let active = self.active & in_front & is_lit;
            if active.any() {
                let shadow_rays = self.spawn(direction, active);
                let distance = to_light.length();
                let visible =
                    shadow_rays.unoccluded(&scene.objects, light.position, distance);
                radiance =
                    visible.select(radiance + reflected * light.intensity, radiance);
            }
        }
        radiance
    }
    // ANCHOR_END: shade

    // ANCHOR: scatter
    /// Returns the radiance of the surface, and what is seen in it and through it.
    fn shade_and_scatter(
        &self,
        scene: &Scene<Material>,
        budget: PathBudget,
        throughput: Lanes,
    ) -> Vec3x16 {
        let mut radiance = self.shade(scene);
        if budget.depth == 0 {
            return radiance;
        }
        let rays = scatter(&self.material.optics, self);
        for (weight, direction) in rays.into_iter().flatten() {
            let throughput = throughput * weight;
            let active = self.active & throughput.simd_gt(budget.min_throughput);
            if active.any() {
                let depth = budget.depth - 1;
                let next = self.spawn(direction, active);
                let seen =
                    trace(scene, &next, PathBudget { depth, ..budget }, throughput);
                radiance = active.select(radiance + seen * weight, radiance);
            }
        }
        radiance
    }
}
// ANCHOR_END: scatter

// ANCHOR: trace
/// Returns the radiance along the active rays. Each looks for its nearest object; then the
/// objects, of which a packet hits few, are shaded one after another, each for the rays that
/// hit it.
///
/// `throughput` replaces [`PathBudget::throughput`], lane by lane.
pub fn trace(
    scene: &Scene<Material>,
    rays: &Packet,
    budget: PathBudget,
    throughput: Lanes,
) -> Vec3x16 {
    let (nearest, t) = rays.nearest(&scene.objects);
    let mut radiance = Vec3x16::splat(scene.background);
    if nearest.simd_lt(0.0).all() {
        return radiance;
    }
    for (index, object) in scene.objects.iter().enumerate() {
        let active = nearest.simd_eq(index as f32);
        if active.any() {
            let at = Interactions::new(object, index, rays, t, active);
            let seen = at.shade_and_scatter(scene, budget, throughput);
            radiance = active.select(seen, radiance);
        }
    }
    radiance
}
// ANCHOR_END: trace

// ANCHOR: render
/// Returns the camera rays through the `first` pixel and those to its right, [`LANES`] at the
/// most, at some `offset` from their centres on the image plane.
pub fn camera_rays(camera: &Camera, first: Pixel, pixels: usize, offset: Vec2) -> Packet {
    let lane = Lanes::new(std::array::from_fn(|lane| lane as f32));
    let half = first.size.as_vec2() / 2.0;
    let x = (lane + first.x as f32 + 0.5 - half.x) / half.y + offset.x;
    let y = first.centre().y + offset.y;
    let direction = Vec3x16::splat(camera.right) * x
        + Vec3x16::splat(y * camera.up)
        + Vec3x16::splat(camera.focal_length * camera.forward);
    Packet {
        origin: Vec3x16::splat(camera.eye),
        direction: direction.normalize(),
        origin_object: None,
        enters: Lanes::splat(0.0),
        active: lane.simd_lt(pixels as f32),
    }
}

/// Returns the offset of the i-th of a pixel's n × n samples from its centre, the same as in
/// `anti_aliasing::regular`.
pub fn sample_offset(pixel: Pixel, n: u32, i: u32) -> Vec2 {
    let cell = UVec2::new(i % n, i / n).as_vec2() + Vec2::splat(0.5);
    pixel.footprint() * (cell / n as f32 - Vec2::splat(0.5))
}

/// Renders a span of pixels with n × n samples per pixel, placed and added up as by
/// `anti_aliasing::regular`.
pub fn render(
    scene: &Scene<Material>,
    camera: &Camera,
    budget: PathBudget,
    n: u32,
    first: Pixel,
    span: &mut [Vec3],
) {
    for (x, out) in (first.x..).step_by(LANES).zip(span.chunks_mut(LANES)) {
        let first = Pixel { x, ..first };
        let mut sum = Vec3x16::splat(Vec3::ZERO);
        for i in 0..n * n {
            let rays = camera_rays(camera, first, out.len(), sample_offset(first, n, i));
            let rays = rays.from_eye(&scene.objects, camera.eye);
            sum = sum + trace(scene, &rays, budget, Lanes::splat(budget.throughput));
        }
        (sum / (n * n) as f32).write(out);
    }
}
// ANCHOR_END: render

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
