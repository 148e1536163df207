// ANCHOR: head
//! Sixteen rays at once: lanes in place of numbers, masks in place of `if`, and the same
//! picture to the last bit.

mod lanes;
mod surface;
pub mod views;
pub use lanes::{LANES, Lanes, Vectors};
pub use views::STAGE;

use canvas::{Pixel, count_rays};
use glam::{UVec2, Vec2, Vec3};
use plane_hit::{Object, Plane, Shape};
use ray_casting::Camera;
use reflection::Reach;
use refraction::Material;
use shadows::Scene;
use sphere_hit::{FARTHEST, Sphere};
use std::cell::Cell;
use surface::{colour, facing, lit, on_the_surface, ways_on};
// ANCHOR_END: head

// ANCHOR: packet
/// A ray in every lane that is live, and the one object whose surface they all leave.
#[derive(Clone, Copy, Debug)]
pub struct Packet<'a> {
    /// Where they start.
    pub origin: Vectors,
    /// Where they go: unit vectors, up to rounding.
    pub direction: Vectors,
    /// Where they come from, if not from the eye.
    pub from: Option<&'a Object<Material>>,
    /// A mask: which rays go into that object.
    pub inwards: Lanes,
    /// A mask: which lanes hold a ray. Nobody asks what comes of the others.
    pub live: Lanes,
}

/// Where some rays, by a mask, meet a surface.
#[derive(Clone, Copy)]
struct Hits {
    met: Lanes,
    t: Lanes,
    normal: Vectors,
}

impl Packet<'_> {
    fn at(&self, t: Lanes) -> Vectors {
        self.origin + self.direction * t
    }
}
// ANCHOR_END: packet

// ANCHOR: hit
impl Packet<'_> {
    /// Of some of the rays, those that meet a sphere.
    #[inline(always)]
    fn hit_sphere(&self, sphere: &Sphere, rays: Lanes, t_max: Lanes) -> Option<Hits> {
        let oc = self.origin - Vectors::splat(sphere.centre);
        let d_dot_d = self.direction.dot(self.direction);
        let t_closest = -self.direction.dot(oc) / d_dot_d;
        let closest = oc + self.direction * t_closest;
        let half_chord_squared = sphere.radius * sphere.radius - closest.dot(closest);
        let met = rays & half_chord_squared.simd_ge(0.0);
        // The `if` that pays: most packets miss most spheres.
        if met.none() {
            return None;
        }
        let t_half = (half_chord_squared / d_dot_d).sqrt();
        let near = t_closest - t_half;
        let is_near = near.simd_gt(0.0) & near.simd_lt(t_max);
        let t = is_near.select(near, t_closest + t_half);
        Some(self.hits_at(sphere, met, t, t_max))
    }

    /// Of some of the rays that start on a sphere, those that meet it again.
    fn other_hit(&self, sphere: &Sphere, rays: Lanes, t_max: Lanes) -> Option<Hits> {
        let oc = self.origin - Vectors::splat(sphere.centre);
        let d_dot_d = self.direction.dot(self.direction);
        let t = -2.0 * self.direction.dot(oc) / d_dot_d;
        Some(self.hits_at(sphere, rays, t, t_max))
    }

    #[inline(always)]
    fn hits_at(&self, sphere: &Sphere, rays: Lanes, t: Lanes, t_max: Lanes) -> Hits {
        let outward = (self.at(t) - Vectors::splat(sphere.centre)) / sphere.radius;
        let is_ahead = t.simd_gt(0.0) & t.simd_lt(t_max);
        Hits {
            met: rays & is_ahead & outward.have_unit(),
            t,
            normal: outward.normalize(),
        }
    }

    fn hit_plane(&self, plane: &Plane, rays: Lanes, t_max: Lanes) -> Option<Hits> {
        let normal = Vectors::splat(plane.normal);
        let to_plane = Vectors::splat(plane.point) - self.origin;
        let t = to_plane.dot(normal) / self.direction.dot(normal);
        let met = rays & t.simd_gt(0.0) & t.simd_lt(t_max);
        met.any().then_some(Hits { met, t, normal })
    }

    #[inline(always)]
    fn hit(&self, object: &Object<Material>, rays: Lanes, t_max: Lanes) -> Option<Hits> {
        let is_where_from = self.from.is_some_and(|from| std::ptr::eq(from, object));
        match &object.shape {
            Shape::Sphere(sphere) if is_where_from => {
                self.other_hit(sphere, rays & self.inwards, t_max)
            }
            Shape::Sphere(sphere) => self.hit_sphere(sphere, rays, t_max),
            Shape::Plane(plane) if !is_where_from => self.hit_plane(plane, rays, t_max),
            Shape::Plane(_) => None,
        }
    }
}
// ANCHOR_END: hit

// ANCHOR: nearest
impl Packet<'_> {
    /// The index of the object that each ray meets first, −1 for none, and where.
    fn nearest(&self, objects: &[Object<Material>]) -> (Lanes, Hits) {
        let mut nearest = Lanes::splat(-1.0);
        let mut t = Lanes::splat(FARTHEST);
        let mut normal = self.direction;
        for (index, object) in objects.iter().enumerate() {
            if let Some(hits) = self.hit(object, self.live, t) {
                nearest = hits.met.select(Lanes::splat(index as f32), nearest);
                t = hits.met.select(hits.t, t);
                normal = hits.met.select(hits.normal, normal);
            }
        }
        let met = nearest.simd_ge(0.0);
        (nearest, Hits { met, t, normal })
    }

    /// A mask: the rays that nothing is in the way of before `t_max`.
    fn free(&self, objects: &[Object<Material>], t_max: Lanes) -> Lanes {
        let mut free = self.live;
        for object in objects {
            if let Some(hits) = self.hit(object, free, t_max) {
                free &= !hits.met;
                if free.none() {
                    break;
                }
            }
        }
        free
    }
}
// ANCHOR_END: nearest

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
