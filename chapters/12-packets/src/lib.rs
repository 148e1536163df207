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
use hits::Hits;
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

// ANCHOR: answer
/// What the rays bring back that have met one and the same object.
fn answer(
    scene: &Scene<Material>,
    object: &Object<Material>,
    rays: &Packet,
    hits: Hits,
    reach: Reach,
    weight: Lanes,
) -> Vectors {
    let Material { phong, body } = &object.material;
    let Hits { met, t, normal } = hits;
    let incident = rays.direction;
    let point = rays.at(t);
    let origin = on_the_surface(&object.shape, point, normal);
    let leave = |direction: Vectors, live: Lanes| {
        count(live);
        let inwards = normal.dot(direction).simd_lt(0.0);
        let from = Some(object);
        Packet {
            origin,
            direction,
            from,
            inwards,
            live,
        }
    };

    let colour = colour(phong.colour, point);
    let facing = facing(normal, incident);
    let mut light = colour * Lanes::splat(phong.ambient);
    for lamp in &scene.lights {
        let to_light = Vectors::splat(lamp.position) - point;
        let direction = to_light.normalize();
        let (lit, is_lit) = lit(phong, colour, incident, facing, direction);
        let live = met & to_light.have_unit() & is_lit;
        if live.any() {
            let shadow_rays = leave(direction, live);
            let free = shadow_rays.free(&scene.objects, to_light.length());
            light = free.select(light + lit * Lanes::splat(lamp.intensity), light);
        }
    }
    let Some(depth) = reach.depth.checked_sub(1) else {
        return light;
    };
    let reach = Reach { depth, ..reach };
    for (share, direction) in ways_on(body, incident, normal) {
        let weight = weight * share;
        let live = met & weight.simd_gt(reach.least_weight);
        if live.any() {
            let seen = trace(scene, &leave(direction, live), reach, weight);
            light = live.select(light + seen * share, light);
        }
    }
    light
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
    let (nearest, hits) = rays.nearest(&scene.objects);
    let mut light = Vectors::splat(scene.background);
    if hits.met.none() {
        return light;
    }
    for (index, object) in scene.objects.iter().enumerate() {
        let met = nearest.simd_eq(index as f32);
        if met.any() {
            let seen = answer(scene, object, rays, Hits { met, ..hits }, reach, weight);
            light = met.select(seen, light);
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
