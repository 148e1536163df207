// ANCHOR: head
//! Shadow acne, and how a ray should leave a surface: it remembers where it comes from.

pub mod views;
pub use views::STAGE;

use fresnel::{fresnel, ways_on};
use glam::Vec3;
use plane_hit::{Object, Shape, nearest_by};
use ray_casting::{Ray, unit};
use reflection::Reach;
use refraction::Material;
use shading::shade;
use shadows::{OFFSET, PointLight, Scene};
use sphere_hit::{Hit, Sphere, facing};
// ANCHOR_END: head

// ANCHOR: leaving
/// A ray, and the object whose surface it leaves, if it is one that remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaving<'a, M> {
    /// The ray.
    pub ray: Ray,
    /// Where it comes from.
    pub from: Option<&'a Object<M>>,
    /// Whether it goes into that object.
    pub inwards: bool,
}

/// How a ray leaves an object: from a point of it with a unit outward normal, in a
/// direction.
pub type Leave<M> = for<'a> fn(&'a Object<M>, Vec3, Vec3, Vec3) -> Leaving<'a, M>;

fn forgetful<'a, M>(origin: Vec3, direction: Vec3) -> Leaving<'a, M> {
    from_the_eye(Ray { origin, direction })
}
// ANCHOR_END: leaving

// ANCHOR: offsets
/// As it comes: from the computed point. Half of those are on the wrong side of the
/// surface.
#[must_use]
pub fn at_the_point<M>(
    _: &Object<M>,
    point: Vec3,
    _: Vec3,
    direction: Vec3,
) -> Leaving<'_, M> {
    forgetful(point, direction)
}

/// A fixed step off the surface, as in chapter 4.
#[must_use]
pub fn by_a_fixed_offset<M>(
    _: &Object<M>,
    point: Vec3,
    normal: Vec3,
    direction: Vec3,
) -> Leaving<'_, M> {
    forgetful(point + OFFSET * facing(normal, -direction), direction)
}

/// A step that grows with the numbers it is added to: 4 ε max(|p|, |c|, r), from the
/// point put back onto the surface.
#[must_use]
pub fn by_a_scaled_offset<'a, M>(
    object: &'a Object<M>,
    point: Vec3,
    normal: Vec3,
    direction: Vec3,
) -> Leaving<'a, M> {
    let point = on_the_surface(&object.shape, point, normal);
    let mut largest = point.length();
    let others = match object.shape {
        Shape::Sphere(Sphere { centre, radius }) => [centre.length(), radius],
        Shape::Plane(plane) => [plane.point.length(), 0.0],
    };
    for other in others {
        if other > largest {
            largest = other;
        }
    }
    let offset = 4.0 * f32::EPSILON * largest;
    forgetful(point + offset * facing(normal, -direction), direction)
}

/// The point, put back onto the surface as well as an f32 can say.
fn on_the_surface(shape: &Shape, point: Vec3, normal: Vec3) -> Vec3 {
    match shape {
        Shape::Sphere(sphere) => sphere.centre + sphere.radius * normal,
        Shape::Plane(plane) => point - (point - plane.point).dot(normal) * normal,
    }
}
// ANCHOR_END: offsets

// ANCHOR: from-surface
/// The cure: from the surface itself, and remembering it.
#[must_use]
pub fn from_the_surface<'a, M>(
    object: &'a Object<M>,
    point: Vec3,
    normal: Vec3,
    direction: Vec3,
) -> Leaving<'a, M> {
    let origin = on_the_surface(&object.shape, point, normal);
    Leaving {
        ray: Ray { origin, direction },
        from: Some(object),
        inwards: normal.dot(direction) < 0.0,
    }
}

/// Where a ray that starts on a sphere meets it again, if that is before `t_max`: at its
/// other root.
///
/// One root is 0, for there it starts; so the quadratic has only one term left to solve
/// for.
#[must_use]
pub fn other_hit(sphere: &Sphere, ray: &Ray, t_max: f32) -> Option<Hit> {
    let direction = ray.direction;
    let t = -2.0 * direction.dot(ray.origin - sphere.centre) / direction.dot(direction);
    if !(t > 0.0 && t < t_max) {
        return None;
    }
    let normal = unit((ray.at(t) - sphere.centre) / sphere.radius)?;
    Some(Hit { t, normal })
}

impl<M> Leaving<'_, M> {
    /// Where the ray meets `object` before `t_max`. What it left, it can meet again only
    /// from within.
    #[must_use]
    pub fn hit(&self, object: &Object<M>, t_max: f32) -> Option<Hit> {
        let is_where_from = self.from.is_some_and(|from| std::ptr::eq(from, object));
        match &object.shape {
            Shape::Sphere(sphere) if is_where_from && self.inwards => {
                other_hit(sphere, &self.ray, t_max)
            }
            _ if is_where_from => None,
            shape => shape.hit(&self.ray, t_max),
        }
    }

    /// The object that the ray meets first, and where.
    #[must_use]
    pub fn nearest<'a>(&self, objects: &'a [Object<M>]) -> Option<(&'a Object<M>, Hit)> {
        nearest_by(objects, |object, t_max| self.hit(object, t_max))
    }
}
// ANCHOR_END: from-surface

// ANCHOR: trace
/// The camera's ray, which comes from no surface.
#[must_use]
pub fn from_the_eye<'a, M>(ray: Ray) -> Leaving<'a, M> {
    Leaving {
        ray,
        from: None,
        inwards: false,
    }
}

/// Chapter 8's picture, by whichever way rays `leave` a surface.
#[must_use]
pub fn trace(
    scene: &Scene<Material>,
    leaving: Leaving<Material>,
    reach: Reach,
    leave: Leave<Material>,
) -> Vec3 {
    let Some((object, hit)) = leaving.nearest(&scene.objects) else {
        return scene.background;
    };
    let Material { phong, body } = &object.material;
    let incident = leaving.ray.direction;
    let point = leaving.ray.at(hit.t);
    let normal = facing(hit.normal, incident);
    let reaches = |light: &PointLight| {
        canvas::count_ray();
        let to_light = light.position - point;
        let shadow_ray = leave(object, point, hit.normal, to_light.normalize());
        let distance = to_light.length();
        !scene
            .objects
            .iter()
            .any(|object| shadow_ray.hit(object, distance).is_some())
    };
    let mut light = shade(phong, incident, point, normal, &scene.lights, reaches);
    for (share, direction) in ways_on(body, incident, hit.normal, fresnel) {
        if let Some(reach) = reach.after(share) {
            canvas::count_ray();
            let leaving = leave(object, point, hit.normal, direction);
            light += share * trace(scene, leaving, reach, leave);
        }
    }
    light
}
// ANCHOR_END: trace
