// ANCHOR: head
//! Sixteen rays at once: lanes in place of numbers, masks in place of `if`, and the same
//! picture to the last bit.

mod hits;
mod lanes;
mod surface;
pub mod views;
pub use hits::Packet;
pub use lanes::{LANES, Lanes, Vectors};
pub use views::STAGE;

use canvas::{Pixel, count_rays};
use glam::{UVec2, Vec2, Vec3};
use plane_hit::Object;
use ray_casting::Camera;
use reflection::Reach;
use refraction::Material;
use shadows::Scene;
use std::cell::Cell;
use surface::{colour, facing, lit, on_the_surface, ways_on};
// ANCHOR_END: head

// ANCHOR: count
thread_local! {
    static PACKETS: Cell<u64> = const { Cell::new(0) };
}

/// How many packets this thread has cast so far; of each, [`LANES`] rays could be live.
#[must_use]
pub fn packets_so_far() -> u64 {
    PACKETS.get()
}

/// Counts a packet, and its rays.
fn count(live: Lanes) {
    PACKETS.set(PACKETS.get() + 1);
    count_rays(live.to_bitmask().count_ones());
}
// ANCHOR_END: count

// ANCHOR: met
/// Where rays of a packet have met one and the same object.
struct Met<'a> {
    object: &'a Object<Material>,
    /// A mask: which rays have.
    live: Lanes,
    incident: Vectors,
    point: Vectors,
    /// The point, put back onto the surface.
    origin: Vectors,
    normal: Vectors,
}

impl<'a> Met<'a> {
    /// The rays that leave the object, as chapter 10's `from_the_surface` has them.
    fn leave(&self, direction: Vectors, live: Lanes) -> Packet<'a> {
        count(live);
        Packet {
            origin: self.origin,
            direction,
            from: Some(self.object),
            inwards: self.normal.dot(direction).simd_lt(0.0),
            live,
        }
    }
    // ANCHOR_END: met

    // ANCHOR: shade
    /// The ambient light, and that of every lamp that reaches the points.
    fn shade(&self, scene: &Scene<Material>) -> Vectors {
        let phong = &self.object.material.phong;
        let colour = colour(phong.colour, self.point);
        let facing = facing(self.normal, self.incident);
        let mut light = colour * phong.ambient;
        for lamp in &scene.lights {
            let to_light = Vectors::splat(lamp.position) - self.point;
            let direction = to_light.normalize();
            let (lit, is_lit) = lit(phong, colour, self.incident, facing, direction);
            let live = self.live & to_light.have_unit() & is_lit;
            if live.any() {
                let shadow_rays = self.leave(direction, live);
                let free = shadow_rays.free(&scene.objects, to_light.length());
                light = free.select(light + lit * lamp.intensity, light);
            }
        }
        light
    }
    // ANCHOR_END: shade

    // ANCHOR: answer
    /// What the rays bring back: the shaded light, and what comes on the two ways on.
    fn answer(&self, scene: &Scene<Material>, reach: Reach, weight: Lanes) -> Vectors {
        let mut light = self.shade(scene);
        let body = &self.object.material.body;
        for (share, direction) in ways_on(body, self.incident, self.normal) {
            let weight = weight * share;
            let live = self.live & weight.simd_gt(reach.least_weight);
            if reach.depth > 0 && live.any() {
                let depth = reach.depth - 1;
                let onward = self.leave(direction, live);
                let seen = trace(scene, &onward, Reach { depth, ..reach }, weight);
                light = live.select(light + seen * share, light);
            }
        }
        light
    }
}
// ANCHOR_END: answer

// ANCHOR: trace
/// What the live rays bring back: each looks for what it meets first, and then each
/// object that any of them has met, few in a packet, answers them all.
///
/// `weight` is each ray's share of its pixel's light, in place of [`Reach::weight`].
#[must_use]
pub fn trace(
    scene: &Scene<Material>,
    rays: &Packet,
    reach: Reach,
    weight: Lanes,
) -> Vectors {
    let (nearest, t, normal) = rays.nearest(&scene.objects);
    let mut light = Vectors::splat(scene.background);
    if nearest.simd_lt(0.0).all() {
        return light;
    }
    let point = rays.at(t);
    for (index, object) in scene.objects.iter().enumerate() {
        let live = nearest.simd_eq(index as f32);
        if live.any() {
            let met = Met {
                object,
                live,
                incident: rays.direction,
                point,
                origin: on_the_surface(&object.shape, point, normal),
                normal,
            };
            light = live.select(met.answer(scene, reach, weight), light);
        }
    }
    light
}
// ANCHOR_END: trace

// ANCHOR: paint
/// The camera's rays through some pixels, the `first` and those to the right of it,
/// [`LANES`] at the most, `from_centre` away from their centres.
#[must_use]
pub fn rays(
    camera: &Camera,
    first: Pixel,
    pixels: usize,
    from_centre: Vec2,
) -> Packet<'static> {
    let lane = Lanes::new(std::array::from_fn(|lane| lane as f32));
    let live = lane.simd_lt(pixels as f32);
    count(live);
    let half = first.size.as_vec2() / 2.0;
    let x = (lane + first.x as f32 + 0.5 - half.x) / half.y + from_centre.x;
    let y = first.centre().y + from_centre.y;
    let direction = Vectors::splat(camera.right) * x
        + Vectors::splat(y * camera.up)
        + Vectors::splat(camera.focal_length * camera.forward);
    Packet {
        origin: Vectors::splat(camera.eye),
        direction: direction.normalize(),
        from: None,
        inwards: Lanes::splat(0.0),
        live,
    }
}

/// How far the i-th of a pixel's n × n samples is from its centre; where chapter 9's
/// `regular` has it.
#[must_use]
pub fn from_centre(pixel: Pixel, n: u32, i: u32) -> Vec2 {
    let cell = UVec2::new(i % n, i / n).as_vec2() + Vec2::splat(0.5);
    pixel.footprint() * (cell / n as f32 - Vec2::splat(0.5))
}

/// Paints a run of pixels by n × n rays each, as chapter 9's `regular` places them
/// and adds them up.
pub fn paint(
    scene: &Scene<Material>,
    camera: &Camera,
    reach: Reach,
    n: u32,
    first: Pixel,
    run: &mut [Vec3],
) {
    for (x, places) in (first.x..).step_by(LANES).zip(run.chunks_mut(LANES)) {
        let first = Pixel { x, ..first };
        let mut sum = Vectors::splat(Vec3::ZERO);
        for i in 0..n * n {
            let rays = rays(camera, first, places.len(), from_centre(first, n, i));
            sum = sum + trace(scene, &rays, reach, Lanes::splat(reach.weight));
        }
        (sum / (n * n) as f32).write(places);
    }
}
// ANCHOR_END: paint
