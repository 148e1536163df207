//! The intersections of a packet's rays with spheres and planes.

use crate::{Lanes, Vec3x16};
use canvas::count_rays;
use plane_hit::{Object, Plane, Shape};
use shadows::{PointLight, is_on_surface};
use sphere_hit::{Sphere, T_MAX};
use std::cell::Cell;

// ANCHOR: packet
/// A ray in every active lane, and the one object on whose surface all of them start.
#[derive(Clone, Copy, Debug)]
pub struct Packet {
    /// Their origins.
    pub origin: Vec3x16,
    /// Their directions: unit vectors, up to rounding.
    pub direction: Vec3x16,
    /// The index of the object on whose surface they start, if there is one.
    pub origin_object: Option<usize>,
    /// Mask of the rays that enter that object.
    pub enters: Lanes,
    /// Mask of the lanes that hold a ray; results in the others are ignored.
    pub active: Lanes,
}

/// Hits: a mask of the rays that have one, and their distances.
type Hits = Option<(Lanes, Lanes)>;

impl Packet {
    /// Returns the points at distances `t` along the rays.
    #[inline]
    pub fn at(&self, t: Lanes) -> Vec3x16 {
        self.origin + self.direction * t
    }
    // ANCHOR_END: packet

    // ANCHOR: distance
    /// Returns the hits of some of the rays on a sphere; `None` if there is none.
    #[inline(always)]
    fn sphere_distance(&self, sphere: &Sphere, rays: Lanes, t_max: Lanes) -> Hits {
        let oc = self.origin - Vec3x16::splat(sphere.centre);
        let b = self.direction.dot(oc);
        // The textbook's discriminant, with a margin a hundred times the rounding error: a
        // sure miss costs no division.
        let outside = 0.99999 * oc.dot(oc) - sphere.radius * sphere.radius;
        if (rays & (b * b).simd_ge(outside)).none() {
            return None;
        }
        let d_dot_d = self.direction.dot(self.direction);
        let t_closest = -b / d_dot_d;
        let perpendicular = oc + self.direction * t_closest;
        let half_chord_squared =
            sphere.radius * sphere.radius - perpendicular.dot(perpendicular);
        let mask = rays & half_chord_squared.simd_ge(0.0);
        // This branch pays: most packets miss most spheres.
        if mask.none() {
            return None;
        }
        let t_half = (half_chord_squared / d_dot_d).sqrt();
        let near = t_closest - t_half;
        let is_near = near.simd_gt(0.0) & near.simd_lt(t_max);
        let t = is_near.select(near, t_closest + t_half);
        within(mask, t, t_max)
    }

    /// Returns the hits of some of the rays that start on a sphere and enter it.
    #[inline(always)]
    fn exit_distance(&self, sphere: &Sphere, rays: Lanes, t_max: Lanes) -> Hits {
        let oc = self.origin - Vec3x16::splat(sphere.centre);
        let d_dot_d = self.direction.dot(self.direction);
        within(rays, -2.0 * self.direction.dot(oc) / d_dot_d, t_max)
    }

    #[inline(always)]
    fn plane_distance(&self, plane: &Plane, rays: Lanes, t_max: Lanes) -> Hits {
        let normal = Vec3x16::splat(plane.normal);
        let to_plane = Vec3x16::splat(plane.point) - self.origin;
        within(
            rays,
            to_plane.dot(normal) / self.direction.dot(normal),
            t_max,
        )
    }

    /// Returns a mask of the hits at distances `t` where the rays enter the shape.
    #[inline(always)]
    pub(crate) fn is_entered(&self, shape: &Shape, t: Lanes) -> Lanes {
        let direction = self.direction;
        match shape {
            Shape::Sphere(sphere) => {
                let oc = self.origin - Vec3x16::splat(sphere.centre);
                t.simd_le(-direction.dot(oc) / direction.dot(direction))
            }
            Shape::Plane(plane) => {
                Vec3x16::splat(plane.normal).dot(direction).simd_lt(0.0)
            }
        }
    }

    #[inline(always)]
    fn distance(&self, index: usize, shape: &Shape, rays: Lanes, t_max: Lanes) -> Hits {
        let starts_here = self.origin_object == Some(index);
        match shape {
            Shape::Sphere(sphere) if starts_here => {
                self.exit_distance(sphere, rays & self.enters, t_max)
            }
            Shape::Sphere(sphere) => self.sphere_distance(sphere, rays, t_max),
            Shape::Plane(plane) if !starts_here => {
                self.plane_distance(plane, rays, t_max)
            }
            Shape::Plane(_) => None,
        }
    }
    // ANCHOR_END: distance

    // ANCHOR: nearest
    /// Returns the index of the object that each ray hits first, −1 for none, and the
    /// distance. Counts the rays.
    // Not `always`: unoptimised, 64 bounces would no longer fit onto a thread's stack.
    #[inline]
    pub fn nearest<M>(&self, objects: &[Object<M>]) -> (Lanes, Lanes) {
        count(self.active);
        let mut nearest = Lanes::splat(-1.0);
        let mut nearest_t = Lanes::splat(T_MAX);
        for (index, object) in objects.iter().enumerate() {
            if let Some((mask, t)) =
                self.distance(index, &object.shape, self.active, nearest_t)
            {
                nearest = mask.select(Lanes::splat(index as f32), nearest);
                nearest_t = mask.select(t, nearest_t);
            }
        }
        (nearest, nearest_t)
    }

    /// Returns a mask of the rays that hit nothing before a light, some distances away. Counts
    /// the rays.
    #[inline]
    pub fn unoccluded<M>(
        &self,
        objects: &[Object<M>],
        light: &PointLight,
        distance: Lanes,
    ) -> Lanes {
        count(self.active);
        let mut unoccluded = self.active;
        for (index, Object { shape, .. }) in objects.iter().enumerate() {
            if let Some((mut mask, t)) = self.distance(index, shape, unoccluded, distance)
            {
                if is_on_surface(shape, light.position) {
                    mask &= self.is_entered(shape, t) ^ self.is_entered(shape, distance);
                }
                unoccluded &= !mask;
                if unoccluded.none() {
                    break;
                }
            }
        }
        unoccluded
    }
}

/// Returns the hits with 0 < t < `t_max`.
#[inline(always)]
fn within(mask: Lanes, t: Lanes, t_max: Lanes) -> Hits {
    let mask = mask & t.simd_gt(0.0) & t.simd_lt(t_max);
    mask.any().then_some((mask, t))
}
// ANCHOR_END: nearest

// ANCHOR: count
thread_local! {
    static PACKETS: Cell<u64> = const { Cell::new(0) };
}

/// Returns the number of packets that this thread has traced so far; each could hold
/// [`LANES`](crate::LANES) rays.
pub fn packets_so_far() -> u64 {
    PACKETS.get()
}

/// Counts a packet, and its rays.
#[inline]
fn count(active: Lanes) {
    PACKETS.set(PACKETS.get() + 1);
    count_rays(active.to_bitmask().count_ones());
}
// ANCHOR_END: count
