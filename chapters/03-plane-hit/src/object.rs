// ANCHOR: object
//! Spheres and planes of any material, and the nearest of many.

use crate::Plane;
use glam::{Vec2, Vec3, Vec3Swizzles};
use ray_casting::Ray;
use sphere_hit::{Sphere, T_MAX};

/// The shape of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A ball.
    Sphere(Sphere),
    /// A floor or a wall.
    Plane(Plane),
}

/// An object of the scene. `M` is the chapter's type of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Object<M> {
    /// Its name.
    pub name: &'static str,
    /// Its shape and position.
    pub shape: Shape,
    /// Its material.
    pub material: M,
}

impl Shape {
    /// Returns a sphere.
    ///
    /// # Panics
    /// If [`Sphere::new`] returns `None`.
    pub fn sphere(centre: Vec3, radius: f32) -> Self {
        Self::Sphere(Sphere::new(centre, radius).expect("a valid sphere"))
    }

    /// Returns a plane.
    ///
    /// # Panics
    /// If [`Plane::new`] returns `None`.
    pub fn plane(point: Vec3, normal: Vec3) -> Self {
        Self::Plane(Plane::new(point, normal).expect("a valid plane"))
    }

    /// Returns the distance to the first hit with 0 < t < `t_max`. `None` if there is none.
    #[inline]
    pub fn distance(&self, ray: &Ray, t_max: f32) -> Option<f32> {
        match self {
            Self::Sphere(sphere) => sphere.distance(ray, t_max),
            Self::Plane(plane) => plane.distance(ray, t_max),
        }
    }

    /// Returns whether a hit at distance `t`, as found by [`Shape::distance`], is one where the
    /// ray enters the shape; a plane's inside is the side from which its normal points away.
    #[inline]
    pub fn is_entered(&self, ray: &Ray, t: f32) -> bool {
        match self {
            Self::Sphere(sphere) => sphere.is_entered(ray, t),
            Self::Plane(plane) => plane.normal.dot(ray.direction) < 0.0,
        }
    }

    /// Returns whether a point lies inside: in the ball, or behind the plane.
    #[inline]
    pub fn contains(&self, point: Vec3) -> bool {
        match self {
            Self::Sphere(Sphere { centre, radius }) => {
                point.distance_squared(*centre) < radius * radius
            }
            Self::Plane(plane) => (point - plane.point).dot(plane.normal) < 0.0,
        }
    }

    /// Returns the outward unit normal at a `point` of the surface.
    #[inline]
    pub fn normal(&self, point: Vec3) -> Vec3 {
        match self {
            Self::Sphere(sphere) => sphere.normal(point),
            Self::Plane(plane) => plane.normal,
        }
    }

    /// Returns two coordinates of a `point` of the surface, by which a pattern on it is drawn:
    /// the plane's own ones, or x and z from the sphere's centre.
    #[inline]
    pub fn uv(&self, point: Vec3) -> Vec2 {
        match self {
            Self::Sphere(sphere) => (point - sphere.centre).xz(),
            Self::Plane(plane) => plane.uv(point),
        }
    }
}

impl<M> Object<M> {
    /// Returns the same object with another material.
    pub fn map<N>(self, material: impl FnOnce(M) -> N) -> Object<N> {
        Object {
            name: self.name,
            shape: self.shape,
            material: material(self.material),
        }
    }
}
// ANCHOR_END: object

// ANCHOR: nearest
/// Returns the index of the object that the ray hits first, and the distance to the hit.
/// `None` if it hits nothing. Counts one ray.
///
/// Of several objects at the same distance, the first in the list is returned.
#[inline]
pub fn nearest<M>(objects: &[Object<M>], ray: &Ray) -> Option<(usize, f32)> {
    canvas::count_ray();
    nearest_by(objects, T_MAX, |_, object, t_max| {
        object.shape.distance(ray, t_max)
    })
}

/// Returns the nearest hit with 0 < t < `t_max`, as [`nearest`] does, of objects that
/// `distance` intersects: a function from an object's index, the object and the distance of
/// the nearest hit so far to that of the object's first hit before it. Counts no ray.
#[inline]
pub fn nearest_by<M>(
    objects: &[Object<M>],
    mut t_max: f32,
    distance: impl Fn(usize, &Object<M>, f32) -> Option<f32>,
) -> Option<(usize, f32)> {
    let mut nearest = None;
    for (index, object) in objects.iter().enumerate() {
        if let Some(t) = distance(index, object, t_max) {
            t_max = t;
            nearest = Some((index, t));
        }
    }
    nearest
}
// ANCHOR_END: nearest
