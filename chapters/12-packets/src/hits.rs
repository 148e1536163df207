//! Where the rays of a packet meet things: chapters 2, 3 and 10.

use crate::{Lanes, Vectors};
use plane_hit::{Object, Plane, Shape};
use refraction::Material;
use sphere_hit::{FARTHEST, Sphere};

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
pub struct Hits {
    pub met: Lanes,
    pub t: Lanes,
    pub normal: Vectors,
}

impl Packet<'_> {
    /// The points at distances `t` along them.
    pub fn at(&self, t: Lanes) -> Vectors {
        self.origin + self.direction * t
    }
    // ANCHOR_END: packet

    // ANCHOR: hit
    /// Of some of the rays, those that meet a sphere.
    #[inline(always)]
    fn hit_sphere(&self, sphere: &Sphere, rays: Lanes, t_max: Lanes) -> Option<Hits> {
        let oc = self.origin - Vectors::splat(sphere.centre);
        let b = self.direction.dot(oc);
        // The slide's discriminant, with more room than rounding needs: a sure miss costs no division.
        let outside = 0.99999 * oc.dot(oc) - sphere.radius * sphere.radius;
        if (rays & (b * b).simd_ge(outside)).none() {
            return None;
        }
        let d_dot_d = self.direction.dot(self.direction);
        let t_closest = -b / d_dot_d;
        let closest = oc + self.direction * t_closest;
        let half_chord_squared = sphere.radius * sphere.radius - closest.dot(closest);
        let met = rays & half_chord_squared.simd_ge(0.0);
        // An `if` that pays: most packets miss most spheres.
        if met.none() {
            return None;
        }
        let t_half = (half_chord_squared / d_dot_d).sqrt();
        let near = t_closest - t_half;
        let is_near = near.simd_gt(0.0) & near.simd_lt(t_max);
        let t = is_near.select(near, t_closest + t_half);
        self.hits_at(sphere, met, t, t_max)
    }

    /// Of some of the rays that start on a sphere, those that meet it again.
    #[inline(always)]
    fn other_hit(&self, sphere: &Sphere, rays: Lanes, t_max: Lanes) -> Option<Hits> {
        let oc = self.origin - Vectors::splat(sphere.centre);
        let d_dot_d = self.direction.dot(self.direction);
        let t = -2.0 * self.direction.dot(oc) / d_dot_d;
        self.hits_at(sphere, rays, t, t_max)
    }

    #[inline(always)]
    fn hits_at(
        &self,
        sphere: &Sphere,
        rays: Lanes,
        t: Lanes,
        t_max: Lanes,
    ) -> Option<Hits> {
        let met = rays & t.simd_gt(0.0) & t.simd_lt(t_max);
        if met.none() {
            return None;
        }
        let outward = (self.at(t) - Vectors::splat(sphere.centre)) / sphere.radius;
        Some(Hits {
            met: met & outward.have_unit(),
            t,
            normal: outward.normalize(),
        })
    }

    #[inline(always)]
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
    // ANCHOR_END: hit

    // ANCHOR: nearest
    /// The index of the object that each ray meets first, −1 for none; how far away that
    /// is, and the normal there.
    // Not `always`: unoptimised, 64 bounces would no longer fit onto a thread's stack.
    #[inline]
    pub fn nearest(&self, objects: &[Object<Material>]) -> (Lanes, Lanes, Vectors) {
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
        (nearest, t, normal)
    }

    /// A mask: the rays that nothing is in the way of before `t_max`.
    #[inline]
    pub fn free(&self, objects: &[Object<Material>], t_max: Lanes) -> Lanes {
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
