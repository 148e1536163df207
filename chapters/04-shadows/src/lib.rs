// ANCHOR: head
//! Shadows: from every hit a ray towards each light, which lights it only if no object is
//! between.

pub mod scene;
pub mod views;
pub use views::STAGE;

use glam::{Vec2, Vec3};
use plane_hit::{Object, Shape, Texture, nearest};
use ray_casting::{MAX_LENGTH, Ray, is_position};
use sphere_hit::Sphere;
use std::fmt::{Display, Formatter};
// ANCHOR_END: head

// ANCHOR: scene
/// A light source without extent; its light does not fade with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Its position.
    pub position: Vec3,
    /// Its intensity; 1 lights a white surface that faces the light to full white.
    pub intensity: f32,
}

impl PointLight {
    /// Returns a light. `None` if its position is out of range ([`is_position`]), or its
    /// intensity not between 0 and [`MAX_LENGTH`].
    #[must_use]
    pub fn new(position: Vec3, intensity: f32) -> Option<Self> {
        let is_valid = is_position(position) && (0.0..=MAX_LENGTH).contains(&intensity);
        is_valid.then_some(Self {
            position,
            intensity,
        })
    }
}

/// Objects, and the lights that shine on them.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene<M> {
    /// The objects that rays can hit, no two of them with the same surface.
    pub objects: Vec<Object<M>>,
    /// All light sources.
    pub lights: Vec<PointLight>,
    /// The radiance, linear, along a ray that hits nothing.
    pub background: Vec3,
}

/// Two objects with one and the same surface, up to rounding, which would decide at every
/// point which of the two a ray hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoincidentSurfaces(pub [&'static str; 2]);

impl Display for CoincidentSurfaces {
    fn fmt(&self, f: &mut Formatter) -> std::fmt::Result {
        let [first, second] = self.0;
        write!(
            f,
            "{first} and {second} have the same surface; move one of them"
        )
    }
}

impl std::error::Error for CoincidentSurfaces {}

impl<M> Scene<M> {
    /// Returns a scene.
    ///
    /// # Errors
    /// If two objects have the same surface.
    pub fn new(
        objects: Vec<Object<M>>,
        lights: Vec<PointLight>,
        background: Vec3,
    ) -> Result<Self, CoincidentSurfaces> {
        for (index, second) in objects.iter().enumerate() {
            let coincides = |first: &&Object<M>| is_same(&first.shape, &second.shape);
            if let Some(first) = objects[..index].iter().find(coincides) {
                return Err(CoincidentSurfaces([first.name, second.name]));
            }
        }
        Ok(Self {
            objects,
            lights,
            background,
        })
    }

    /// Returns the same scene with other materials.
    pub fn map<N>(self, material: impl Fn(M) -> N) -> Scene<N> {
        let objects = self.objects.into_iter();
        Scene {
            objects: objects.map(|object| object.map(&material)).collect(),
            lights: self.lights,
            background: self.background,
        }
    }
}
// ANCHOR_END: scene

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
fn is_same(first: &Shape, second: &Shape) -> bool {
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

// ANCHOR: shadow-ray
/// The distance from a surface, along its normal, at which a new ray starts: a
/// ten-thousandth of the radius of a ball of radius 1.
///
/// Rounding puts a computed hit above or below the surface, and from below it the surface
/// would shadow itself. A fixed distance is right for scenes about as large as ours, and for
/// no other: the chapter about shadow acne shows where it fails, and the cure.
pub const SHADOW_BIAS: f32 = 1e-4;

/// Returns the ray from a hit towards a light, and the distance to the light. `None` if the
/// light is behind the surface, which hides it: a ray from above the surface could slip past
/// its edge.
fn shadow_ray(at: &Interaction, light: &PointLight) -> Option<(Ray, f32)> {
    if !at.is_in_front(light.position) {
        return None;
    }
    let origin = at.point + SHADOW_BIAS * at.normal;
    let (direction, distance) = (light.position - origin).normalize_and_length();
    Some((Ray { origin, direction }, distance))
}

/// Returns whether the hit of a ray on a shape at `t`, nearer than a light `distance` away,
/// lies before the light. It does not if the light is on the surface and this is where the ray arrives there:
/// then rounding alone has put the hit nearer.
#[inline]
#[must_use]
pub fn is_before_light(
    shape: &Shape,
    ray: &Ray,
    t: f32,
    light: Vec3,
    distance: f32,
) -> bool {
    let is_other_side = shape.is_entered(ray, t) != shape.is_entered(ray, distance);
    is_other_side || !is_on_surface(shape, light)
}

/// Returns whether any object is between a ray's origin and a light, which is `distance` away;
/// the first one found ends the search. Counts one ray.
#[must_use]
pub fn is_occluded<M>(
    objects: &[Object<M>],
    ray: &Ray,
    light: Vec3,
    distance: f32,
) -> bool {
    canvas::count_ray();
    objects.iter().any(|Object { shape, .. }| {
        let hit = shape.distance(ray, distance);
        hit.is_some_and(|t| is_before_light(shape, ray, t, light, distance))
    })
}
// ANCHOR_END: shadow-ray

// ANCHOR: visible
/// Returns whether a light is visible from a hit.
///
/// Source: the lecture's "Now with Shadows" slide.
#[must_use]
pub fn is_visible<M>(scene: &Scene<M>, at: &Interaction, light: &PointLight) -> bool {
    shadow_ray(at, light).is_some_and(|(ray, distance)| {
        !is_occluded(&scene.objects, &ray, light.position, distance)
    })
}
// ANCHOR_END: visible

// ANCHOR: buggy
/// Returns whether a light is visible from a hit, with the lecture's bug: an object beyond
/// the light occludes it, too.
#[must_use]
pub fn is_visible_buggy<M>(
    scene: &Scene<M>,
    at: &Interaction,
    light: &PointLight,
) -> bool {
    shadow_ray(at, light).is_some_and(|(ray, _)| nearest(&scene.objects, &ray).is_none())
}
// ANCHOR_END: buggy

// ANCHOR: trace
/// A function that returns whether a light is visible from a hit.
pub type Visibility<M> = fn(&Scene<M>, &Interaction, &PointLight) -> bool;

/// Returns the flat colour of the first object that the ray hits, times the intensity of the
/// lights that are visible from there; or the background.
#[must_use]
pub fn trace(scene: &Scene<Texture>, ray: &Ray, is_visible: Visibility<Texture>) -> Vec3 {
    let Some(hit) = nearest(&scene.objects, ray) else {
        return scene.background;
    };
    let at = Interaction::new(&scene.objects, ray, hit);
    let mut intensity = 0.0;
    for light in &scene.lights {
        if is_visible(scene, &at, light) {
            intensity += light.intensity;
        }
    }
    intensity * scene.objects[at.index].material.value(at.uv())
}
// ANCHOR_END: trace
