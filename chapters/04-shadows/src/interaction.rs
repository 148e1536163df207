// ANCHOR: interaction-head
//! A ray's hit on a surface: which side it is on, and which lights are in front.

use glam::{Vec2, Vec3};
use plane_hit::{Object, Shape};
use ray_casting::Ray;
use sphere_hit::Sphere;
// ANCHOR_END: interaction-head

// ANCHOR: on-surface
/// A bound of the relative error of a few rounded operations.
pub const ROUNDING: f32 = 1.5 * f32::EPSILON;

/// Returns whether a point lies on a surface, as nearly as f32 can say: by how much rounding
/// moves a point, or turns a plane, along the normal.
#[inline]
pub fn is_on_surface(shape: &Shape, point: Vec3) -> bool {
    let size = |other: Vec3| point.abs() + other.abs();
    // In f64 the height has no rounding error of its own.
    let (height, rounding) = match *shape {
        Shape::Sphere(Sphere { centre, radius }) => {
            let to_point = point.as_dvec3() - centre.as_dvec3();
            let distance = to_point.length();
            let normal = (to_point / distance).as_vec3();
            let size = normal.abs().dot(size(centre)) / 2.0 + radius;
            (distance - f64::from(radius), size)
        }
        Shape::Plane(plane) => {
            let to_point = point.as_dvec3() - plane.point.as_dvec3();
            let size = 2.0 * plane.normal.abs().dot(size(plane.point));
            (plane.normal.as_dvec3().dot(to_point), size)
        }
    };
    height.abs() <= f64::from(f32::EPSILON * rounding)
}

/// Returns whether two surfaces are the same, up to rounding.
pub(crate) fn is_same(first: &Shape, second: &Shape) -> bool {
    const CLOSE: f32 = 16.0 * f32::EPSILON;
    match (first, second) {
        (Shape::Sphere(first), Shape::Sphere(second)) => {
            let size = first.centre.abs().element_sum() + first.radius;
            (first.centre - second.centre).length() <= CLOSE * size
                && (first.radius - second.radius).abs() <= CLOSE * size
        }
        (Shape::Plane(plane), Shape::Plane(other)) => {
            plane.normal.cross(other.normal).length() <= CLOSE
                && (is_on_surface(first, other.point)
                    || is_on_surface(second, plane.point))
        }
        _ => false,
    }
}
// ANCHOR_END: on-surface

// ANCHOR: interaction
/// A ray's hit on an object, with all that shading needs.
///
/// Source: `SurfaceInteraction` in Pharr, Jakob and Humphreys, Physically Based Rendering.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interaction {
    /// The object's index in the scene.
    pub index: usize,
    /// The object's shape.
    pub shape: Shape,
    /// The distance along the ray.
    pub t: f32,
    /// The hit point.
    pub point: Vec3,
    /// The ray's direction; a unit vector.
    pub incident: Vec3,
    /// The surface's outward unit normal.
    pub outward: Vec3,
    /// The unit normal on the side from which the ray comes. Its angle to the ray is always
    /// obtuse: N·I < 0.
    pub normal: Vec3,
}

/// The least cosine of the angle of incidence: what is computed from it by a few rounded
/// operations still has its sign.
pub const MIN_COS_THETA: f32 = 8.0 * f32::EPSILON;

impl Interaction {
    /// Returns the interaction of `ray` with the object that it hits: its index, and the
    /// distance.
    #[inline]
    pub fn new<M>(objects: &[Object<M>], ray: &Ray, (index, t): (usize, f32)) -> Self {
        let shape = objects[index].shape;
        let point = ray.at(t);
        let incident = ray.direction;
        let enters = shape.is_entered(ray, t);
        let facing = |outward: Vec3| if enters { outward } else { -outward };
        let mut normal = facing(shape.normal(point));
        // Where a ray only grazes a sphere, rounding would decide on which side it is. So the
        // normal is turned, by no more than rounding can have turned it.
        let cos_theta = -normal.dot(incident);
        if cos_theta < MIN_COS_THETA {
            normal = (normal + (cos_theta - MIN_COS_THETA) * incident).normalize();
        }
        Self {
            index,
            shape,
            t,
            point,
            incident,
            outward: facing(normal),
            normal,
        }
    }

    /// Returns whether a light is in front of the surface, on the side from which the ray
    /// comes.
    ///
    /// The surface decides, and not the computed point, which rounding puts above or below it:
    /// a light in the plane of a floor is in front of no point of the floor, or of all.
    #[inline]
    pub fn is_in_front(&self, light: Vec3) -> bool {
        // How far the light is along the normal, from the plane's point or the sphere's
        // centre, and how far the surface is.
        let (height, surface) = match self.shape {
            Shape::Plane(plane) => (plane.normal.dot(light - plane.point), 0.0),
            // A light on the sphere itself is above none of its tangent planes.
            Shape::Sphere(Sphere { centre, radius }) => {
                let height = self.outward.dot(light - centre);
                (height, radius * (1.0 + ROUNDING))
            }
        };
        if self.enters() {
            height > surface
        } else {
            height < surface
        }
    }

    /// Returns whether the ray enters the object here; otherwise it leaves it.
    #[inline]
    pub fn enters(&self) -> bool {
        self.normal == self.outward
    }

    /// Returns the hit point's two coordinates on the surface.
    #[inline]
    pub fn uv(&self) -> Vec2 {
        self.shape.uv(self.point)
    }
}
// ANCHOR_END: interaction
