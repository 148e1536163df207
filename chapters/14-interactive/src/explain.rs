// ANCHOR: head
//! A pixel's ray, explained: what it met, and what came back on every way on from there.
//!
//! This is a twin of chapter 10's `trace`, of the same functions in the same order. That
//! one stays as plain as it is, and a test asserts that the two agree to the last bit.

use fresnel::{fresnel, ways_on};
use glam::{Vec2, Vec3};
use plane_hit::Object;
use ray_casting::{Camera, Ray};
use reflection::Reach;
use refraction::{Body, Material};
use shading::shade;
use shadow_acne::{Leaving, from_the_eye, from_the_surface};
use shadows::{PointLight, Scene};
use sphere_hit::{Hit, facing};
use std::cell::RefCell;
// ANCHOR_END: head

// ANCHOR: explained
/// A ray, and what came of it.
#[derive(Clone, Debug)]
pub struct Explained<'a> {
    /// The ray.
    pub ray: Ray,
    /// How it came about.
    pub way: Way,
    /// The share of its light that the ray before it passes on; the camera's ray has 1.
    pub share: f32,
    /// The share of its light in the pixel's.
    pub weight: f32,
    /// What became of it.
    pub end: End<'a>,
    /// The linear light that it brings back.
    pub light: Vec3,
}

/// How a ray comes about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// The camera cast it.
    FromTheEye,
    /// A surface mirrored it.
    Mirrored,
    /// It went through a surface, into a clear body or out of it.
    Through,
}

/// What becomes of a ray.
#[derive(Clone, Debug)]
pub enum End<'a> {
    /// It meets something.
    Met(Met<'a>),
    /// It meets nothing, and brings the background's light.
    Background,
    /// It is never cast, for its weight is not above the least.
    TooWeak,
    /// It is never cast, for no bounces are left.
    NoBouncesLeft,
}
// ANCHOR_END: explained

// ANCHOR: met
/// A ray's meeting with an object.
#[derive(Clone, Debug)]
pub struct Met<'a> {
    /// The object.
    pub object: &'a Object<Material>,
    /// How far along the ray, and the outward normal there.
    pub hit: Hit,
    /// Where.
    pub point: Vec3,
    /// F, the share that a clear body mirrors; 1 is total reflection.
    pub fresnel: Option<f32>,
    /// The surface's own light, by the lamps that reach it.
    pub own: Vec3,
    /// Every lamp of the scene, in its order.
    pub lamps: Vec<Lamp<'a>>,
    /// The rays that go on; and those that would, but for the reach.
    pub onward: Vec<Explained<'a>>,
}

/// A lamp, and whether it lights a point.
#[derive(Clone, Copy, Debug)]
pub struct Lamp<'a> {
    /// The lamp.
    pub light: &'a PointLight,
    /// How the point sees it.
    pub sight: Sight<'a>,
}

/// How a point sees a lamp.
#[derive(Clone, Copy, Debug)]
pub enum Sight<'a> {
    /// A shadow ray got there.
    Reached,
    /// An object is in the way, the first in the scene's list, and where.
    Blocked(&'a Object<Material>, Vec3),
    /// Not at all: the lamp is behind the surface, and no ray is cast.
    Behind,
    /// The surface would send nothing of its light this way, and no ray is cast.
    Useless,
}
// ANCHOR_END: met

// ANCHOR: explain
/// Explains the camera's ray through a `point` of the image plane: its light is that of
/// chapter 10's `trace` by `from_the_surface`, to the last bit.
#[must_use]
pub fn explain<'a>(
    scene: &'a Scene<Material>,
    camera: &Camera,
    point: Vec2,
    reach: Reach,
) -> Explained<'a> {
    let leaving = from_the_eye(camera.ray(point));
    follow(scene, leaving, Way::FromTheEye, 1.0, reach)
}

fn follow<'a>(
    scene: &'a Scene<Material>,
    leaving: Leaving<Material>,
    way: Way,
    share: f32,
    reach: Reach,
) -> Explained<'a> {
    let (end, light) = match leaving.nearest(&scene.objects) {
        Some((object, hit)) => {
            let (met, light) = meet(scene, &leaving.ray, object, hit, reach);
            (End::Met(met), light)
        }
        None => (End::Background, scene.background),
    };
    Explained {
        ray: leaving.ray,
        way,
        share,
        weight: reach.weight,
        end,
        light,
    }
}
// ANCHOR_END: explain

// ANCHOR: meet
/// What there is at a hit, and the light that goes back along the ray from there.
fn meet<'a>(
    scene: &'a Scene<Material>,
    ray: &Ray,
    object: &'a Object<Material>,
    hit: Hit,
    reach: Reach,
) -> (Met<'a>, Vec3) {
    let Material { phong, body } = &object.material;
    let incident = ray.direction;
    let point = ray.at(hit.t);
    let normal = facing(hit.normal, incident);

    // What is known of a lamp until `shade` asks about it.
    let unseen = |light: &'a PointLight| {
        let is_behind = normal.dot(light.position - point) < 0.0;
        let sight = if is_behind {
            Sight::Behind
        } else {
            Sight::Useless
        };
        Lamp { light, sight }
    };
    let lamps: RefCell<Vec<_>> = RefCell::new(scene.lights.iter().map(unseen).collect());
    let reaches = |light: &PointLight| {
        let sight = look(scene, object, point, hit.normal, light);
        let is_it = |lamp: &&mut Lamp| std::ptr::eq(lamp.light, light);
        if let Some(lamp) = lamps.borrow_mut().iter_mut().find(is_it) {
            lamp.sight = sight;
        }
        matches!(sight, Sight::Reached)
    };
    let own = shade(phong, incident, point, normal, &scene.lights, reaches);

    let mut light = own;
    let mut onward = Vec::new();
    let ways = ways_on(body, incident, hit.normal, fresnel);
    for (way, (share, direction)) in [Way::Mirrored, Way::Through].into_iter().zip(ways) {
        let leaving = from_the_surface(object, point, hit.normal, direction);
        if let Some(reach) = reach.after(share) {
            let explained = follow(scene, leaving, way, share, reach);
            light += share * explained.light;
            onward.push(explained);
        } else if share > 0.0 {
            onward.push(never_cast(leaving.ray, way, share, reach));
        }
    }
    let met = Met {
        object,
        hit,
        point,
        fresnel: matches!(body, Body::Clear { .. }).then_some(ways[0].0),
        own,
        lamps: lamps.into_inner(),
        onward,
    };
    (met, light)
}
// ANCHOR_END: meet

// ANCHOR: look
/// How a point of an object sees a lamp: chapter 10's question, and who is in the way.
fn look<'a>(
    scene: &'a Scene<Material>,
    object: &Object<Material>,
    point: Vec3,
    normal: Vec3,
    light: &PointLight,
) -> Sight<'a> {
    let to_light = light.position - point;
    let shadow_ray = from_the_surface(object, point, normal, to_light.normalize());
    let distance = to_light.length();
    let blocks = |object: &'a _| Some((object, shadow_ray.hit(object, distance)?));
    match scene.objects.iter().find_map(blocks) {
        Some((object, hit)) => Sight::Blocked(object, shadow_ray.ray.at(hit.t)),
        None => Sight::Reached,
    }
}

/// A ray that the reach, before it, is too short for.
fn never_cast<'a>(ray: Ray, way: Way, share: f32, reach: Reach) -> Explained<'a> {
    let end = if reach.depth == 0 {
        End::NoBouncesLeft
    } else {
        End::TooWeak
    };
    Explained {
        ray,
        way,
        share,
        weight: reach.weight * share,
        end,
        light: Vec3::ZERO,
    }
}

impl Explained<'_> {
    /// How many rays were cast for it: itself, its shadow rays, and those of all rays
    /// after it.
    #[must_use]
    pub fn rays(&self) -> usize {
        match &self.end {
            End::Met(met) => {
                let is_cast = |lamp: &&Lamp| {
                    matches!(lamp.sight, Sight::Reached | Sight::Blocked(..))
                };
                let shadow_rays = met.lamps.iter().filter(is_cast).count();
                1 + shadow_rays + met.onward.iter().map(Self::rays).sum::<usize>()
            }
            End::Background => 1,
            End::TooWeak | End::NoBouncesLeft => 0,
        }
    }
}
// ANCHOR_END: look
