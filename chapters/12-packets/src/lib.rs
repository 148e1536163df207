// ANCHOR: head
//! Sixteen rays at once (SIMD): lanes in place of numbers, masks in place of `if`, and the
//! same picture to the last bit.

mod interactions;
mod intersect;
mod lanes;
pub use intersect::{Packet, packets_so_far};
pub use lanes::{LANES, Lanes, Vec3x16, lanes};

use canvas::Pixel;
use glam::{Vec2, Vec3};
use interactions::{Interactions, colour, phong, scatter};
use plane_hit::Object;
use ray_casting::Camera;
use reflection::PathBudget;
use refraction::Material;
use shadows::{Scene, is_on_surface};
// ANCHOR_END: head

// ANCHOR: shade
impl Interactions<'_> {
    /// Returns the ambient light, and what the surface reflects of every visible light.
    fn shade(&self, scene: &Scene<Material>) -> Vec3x16 {
        let surface = &self.material.phong;
        let colour = colour(surface.colour, self.shape, self.point);
        let mut radiance = colour * surface.ambient;
        for light in &scene.lights {
            let in_front = self.active & self.are_in_front(light);
            if in_front.none() {
                continue;
            }
            let to_light = Vec3x16::splat(light.position) - self.point;
            let direction = to_light.normalize();
            let (reflected, is_lit) = phong(surface, colour, self, direction);
            let active = in_front & is_lit & to_light.is_normalizable();
            if active.any() {
                let shadow_rays = self.spawn(direction, active);
                let distance = to_light.length();
                let visible = shadow_rays.unoccluded(&scene.objects, light, distance);
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
/// Returns a function that starts packets at the eye of a `camera`, as `shadow_acne::from_eye`
/// does: from points of the image plane, and the number of lanes that hold one, the first ones.
pub fn from_eye<'a>(
    objects: &[Object<Material>],
    camera: &'a Camera,
) -> impl Fn([Lanes; 2], usize) -> Packet + use<'a> {
    let is_here = |it: &Object<_>| is_on_surface(&it.shape, camera.eye);
    let origin_object = objects.iter().position(is_here);
    let outward = origin_object.map(|index| objects[index].shape.normal(camera.eye));
    move |[x, y], count| {
        let direction = Vec3x16::splat(camera.right) * x
            + Vec3x16::splat(camera.up) * y
            + Vec3x16::splat(camera.focal_length * camera.forward);
        let direction = direction.normalize();
        let enters = |outward| Vec3x16::splat(outward).dot(direction).simd_lt(0.0);
        Packet {
            origin: Vec3x16::splat(camera.eye),
            direction,
            origin_object,
            enters: outward.map_or(Lanes::splat(0.0), enters),
            active: lanes().simd_lt(count as f32),
        }
    }
}

/// Returns the offsets of some of a pixel's n × n samples from its centre on the image plane,
/// the same as in `anti_aliasing::regular`; `i` are their numbers.
pub fn sample_offsets(pixel: Pixel, n: u32, i: Lanes) -> [Lanes; 2] {
    let n = n as f32;
    let row = (i / n).floor();
    let offset = |cell: Lanes| pixel.footprint() * ((cell + 0.5) / n - 0.5);
    [offset(i - row * n), offset(row)]
}

/// Renders the i-th of n × n samples of every pixel of a span, [`LANES`] neighbours at once.
pub fn render_sample(
    scene: &Scene<Material>,
    camera: &Camera,
    budget: PathBudget,
    [n, i]: [u32; 2],
    first: Pixel,
    span: &mut [Vec3],
) {
    let start = from_eye(&scene.objects, camera);
    let [dx, dy] = sample_offsets(first, n, Lanes::splat(i as f32));
    let half = first.size.as_vec2() / 2.0;
    for (x, out) in (first.x..).step_by(LANES).zip(span.chunks_mut(LANES)) {
        let x = (lanes() + x as f32 + 0.5 - half.x) / half.y;
        let rays = start([x + dx, first.centre().y + dy], out.len());
        let radiance = trace(scene, &rays, budget, Lanes::splat(budget.throughput));
        out.copy_from_slice(&radiance.to_array()[..out.len()]);
    }
}

/// Renders a span of pixels with n × n samples per pixel, placed and added up as by
/// `anti_aliasing::regular`. Where they fill a packet, it holds those of one pixel.
pub fn render(
    scene: &Scene<Material>,
    camera: &Camera,
    budget: PathBudget,
    n: u32,
    first: Pixel,
    span: &mut [Vec3],
) {
    let samples = (n * n) as usize;
    if samples < LANES {
        let mut sample = vec![Vec3::ZERO; span.len()];
        span.fill(Vec3::ZERO);
        for i in 0..n * n {
            render_sample(scene, camera, budget, [n, i], first, &mut sample);
            span.iter_mut()
                .zip(&sample)
                .for_each(|(out, &it)| *out += it);
        }
        span.iter_mut().for_each(|out| *out /= samples as f32);
        return;
    }
    let start = from_eye(&scene.objects, camera);
    let packets = (0..samples).step_by(LANES);
    let offsets = packets.map(|i| sample_offsets(first, n, lanes() + i as f32));
    let offsets: Vec<_> = offsets.collect();
    for (x, out) in (first.x..).zip(span) {
        let Vec2 { x, y } = Pixel { x, ..first }.centre();
        let mut sum = Vec3::ZERO;
        for (&[dx, dy], i) in offsets.iter().zip((0..samples).step_by(LANES)) {
            let rays = start([x + dx, y + dy], samples - i);
            let seen = trace(scene, &rays, budget, Lanes::splat(budget.throughput));
            let seen = rays.active.select(seen, Vec3x16::splat(Vec3::ZERO));
            let [x, y, z] = [seen.x, seen.y, seen.z].map(Lanes::to_array);
            for lane in 0..LANES {
                sum += Vec3::new(x[lane], y[lane], z[lane]);
            }
        }
        *out = sum / samples as f32;
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
