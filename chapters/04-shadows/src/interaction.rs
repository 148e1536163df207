// ANCHOR: interaction-head
//! A ray's hit on a surface: which side it is on, and which lights are in front.

use glam::{Vec2, Vec3};
use plane_hit::{Object, Shape};
use ray_casting::Ray;
use sphere_hit::Sphere;
// ANCHOR_END: interaction-head

// ANCHOR: on-surface
/// A bound of the relative error of a few rounded operations.
pub const ROUNDING: f32 = 2.0 * f32::EPSILON;

/// Returns the sum of a point's coordinates, without their signs.
fn size(point: Vec3) -> f32 {
    point.abs().element_sum()
}

/// Returns whether a point lies on a surface, up to rounding.
#[inline]
#[must_use]
pub fn is_on_surface(shape: &Shape, point: Vec3) -> bool {
    match shape {
        Shape::Sphere(Sphere { centre, radius }) => {
            let difference = (point - centre).length() - radius;
            difference.abs() <= ROUNDING * (size(point) + size(*centre) + radius)
        }
        Shape::Plane(plane) => {
            let height = plane.normal.dot(point - plane.point);
            height.abs() <= ROUNDING * (size(point) + size(plane.point))
        }
    }
}

/// Returns whether two surfaces are the same, up to rounding.
pub(crate) fn is_same(first: &Shape, second: &Shape) -> bool {
    match (first, second) {
        (Shape::Sphere(first), Shape::Sphere(second)) => {
            let tolerance = ROUNDING * (size(first.centre) + first.radius);
            (first.centre - second.centre).length() <= tolerance
                && (first.radius - second.radius).abs() <= tolerance
        }
        (Shape::Plane(plane), Shape::Plane(second)) => {
            plane.normal.cross(second.normal).length() <= ROUNDING
                && is_on_surface(first, second.point)
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
    #[must_use]
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
    #[must_use]
    pub fn is_in_front(&self, light: Vec3) -> bool {
        // Its height above the plane through the origin, or the centre; and the surface's.
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
    #[must_use]
    pub fn enters(&self) -> bool {
        self.normal == self.outward
    }

    /// Returns the hit point's two coordinates on the surface.
    #[inline]
    #[must_use]
    pub fn uv(&self) -> Vec2 {
        self.shape.uv(self.point)
    }
}
// ANCHOR_END: interaction
