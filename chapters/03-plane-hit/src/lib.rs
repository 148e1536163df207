// ANCHOR: head
//! A floor, and the nearest of many objects.

pub mod scene;

use glam::{Vec2, Vec3, Vec3Swizzles};
use ray_casting::{Ray, SKY, checked_normalize, is_position};
use sphere_hit::{Sphere, T_MAX};
// ANCHOR_END: head

// ANCHOR: plane
/// The points x with (x − `point`) · `normal` = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point of the plane, and the origin of its two coordinates.
    pub point: Vec3,
    /// The unit vector perpendicular to the plane.
    pub normal: Vec3,
    /// The axes of its coordinates: unit vectors in the plane, perpendicular to each other.
    pub axes: [Vec3; 2],
}

impl Plane {
    /// Returns a plane; `normal` need not be a unit vector. `None` if it cannot be
    /// normalised ([`checked_normalize`]), or if the point is out of range ([`is_position`]).
    ///
    /// The first axis is as close to x as the plane allows, or to z if the normal is close to
    /// x; the second points upwards, or away from the viewer in a floor. So the axes of a
    /// horizontal plane are x and z, and those of a plane and of its other side are the same.
    pub fn new(point: Vec3, normal: Vec3) -> Option<Self> {
        let normal = checked_normalize(normal)?;
        let along = if normal.x.abs() < 0.9 {
            Vec3::X
        } else {
            Vec3::Z
        };
        let first = (along - along.dot(normal) * normal).normalize();
        let second = first.cross(normal);
        let is_downwards = match second.y + second.z {
            0.0 => second.y < 0.0,
            sum => sum < 0.0,
        };
        let axes = [first, if is_downwards { -second } else { second }];
        is_position(point).then_some(Self {
            point,
            normal,
            axes,
        })
    }

    /// Returns the two coordinates of a `point` of the plane.
    #[inline]
    pub fn uv(&self, point: Vec3) -> Vec2 {
        let from_origin = point - self.point;
        let [u, v] = self.axes.map(|axis| from_origin.dot(axis));
        Vec2::new(u, v)
    }
}
// ANCHOR_END: plane

// ANCHOR: distance
impl Plane {
    /// Returns the distance to the hit, t = (x₀ − o)·n / (d·n), if 0 < t < `t_max`. `None`
    /// otherwise, and for a ray that is parallel to the plane or lies in it.
    ///
    /// The direction need not be a unit vector; the distance is in units of its length.
    ///
    /// Source: the lecture's "Plane-Ray intersection" slides.
    #[inline]
    pub fn distance(&self, ray: &Ray, t_max: f32) -> Option<f32> {
        let t =
            (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        // Parallel to the plane t is infinite, in the plane NaN: both are rejected here.
        (t > 0.0 && t < t_max).then_some(t)
    }
}
// ANCHOR_END: distance

// ANCHOR: object
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

// ANCHOR: checker
/// Returns whether a point of a floor lies in an even square of a checkerboard; `uv` are its
/// two coordinates in the floor's plane.
///
/// The parity is calculated in floats: no integer holds the numbers of the squares near the
/// horizon.
#[inline]
pub fn is_even(uv: Vec2) -> bool {
    let sum = uv.x.floor() + uv.y.floor();
    sum - 2.0 * (sum / 2.0).floor() == 0.0
}

/// Returns whether a point lies in an even cube of a three-dimensional checkerboard. Used for
/// a floor, this is a bug: at a whole height, rounding puts `point.y` above or below it, and
/// `floor` gives two different numbers.
pub fn is_even_in_space(point: Vec3) -> bool {
    let sum = point.x.floor() + point.y.floor() + point.z.floor();
    sum - 2.0 * (sum / 2.0).floor() == 0.0
}
// ANCHOR_END: checker

// ANCHOR: texture
/// The colour of a surface, linear, each component from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texture {
    /// The same colour everywhere.
    Solid(Vec3),
    /// Squares of side 1: even and odd.
    Checker(Vec3, Vec3),
}

impl Texture {
    /// Returns the colour at a point of the surface, given by its two coordinates there
    /// ([`Shape::uv`]).
    #[inline]
    pub fn value(&self, uv: Vec2) -> Vec3 {
        match *self {
            Self::Checker(_, odd) if !is_even(uv) => odd,
            Self::Solid(colour) | Self::Checker(colour, _) => colour,
        }
    }
}
// ANCHOR_END: texture

// ANCHOR: trace
/// Returns the flat colour of the first object that the ray hits, or the sky's.
pub fn trace(objects: &[Object<Texture>], ray: &Ray) -> Vec3 {
    match nearest(objects, ray) {
        Some((index, t)) => {
            let Object {
                shape, material, ..
            } = &objects[index];
            material.value(shape.uv(ray.at(t)))
        }
        None => SKY,
    }
}
// ANCHOR_END: trace

// ANCHOR: ours
// The exercises; and the pictures of this page, for the window, the command line and the tests
// of this project.
pub mod exercises;
pub mod views;
pub use views::STAGE;
// ANCHOR_END: ours
