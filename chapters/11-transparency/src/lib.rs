// ANCHOR: head
//! Coloured glass: it absorbs some of the light that passes through, and its shadow has its
//! colour. And what is where if clear bodies overlap.

pub mod scene;
pub mod views;
pub use views::STAGE;

use fresnel::{fresnel, scatter};
use glam::Vec3;
use plane_hit::{Object, Shape, nearest_by};
use reflection::PathBudget;
use refraction::{Material, Optics};
use shading::shade;
use shadow_acne::{SurfaceRay, exit_distance, from_surface};
use shadows::{Interaction, Scene};
use sphere_hit::T_MAX;
// ANCHOR_END: head

// ANCHOR: absorb
/// Returns the fraction of light that passes through a medium of some thickness: e^(−a d),
/// for red, green and blue.
///
/// `absorption` is the rate a, at least 0, per unit of length.
///
/// Source: the Beer–Lambert law (Bouguer 1729).
#[must_use]
pub fn transmittance(absorption: Vec3, distance: f32) -> Vec3 {
    (-absorption * distance).map(libm::expf)
}
// ANCHOR_END: absorb

// ANCHOR: material
/// A material whose inside may absorb light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Absorbing {
    /// Its surface and its optics.
    pub material: Material,
    /// The rate at which its inside absorbs red, green and blue light, per unit of length; at
    /// least 0.
    pub absorption: Vec3,
}
// ANCHOR_END: material

// ANCHOR: medium
/// The inside of a dielectric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Its index of refraction.
    pub eta: f32,
    /// The rate at which it absorbs red, green and blue light, per unit of length.
    pub absorption: Vec3,
}

impl Medium {
    /// Returns the fraction of light that passes through some thickness of it.
    fn transmittance(self, distance: f32) -> Vec3 {
        if self.absorption == Vec3::ZERO {
            return Vec3::ONE;
        }
        transmittance(self.absorption, distance)
    }
}

/// Returns the medium at a point: that of the last dielectric in the scene's list whose inside
/// it is in, since it displaces the others. `None` if no dielectric is there.
///
/// `contains` is given an object's index and its shape.
///
/// Source: Schmidt and Budge, "Simple Nested Dielectrics in Ray Traced Images" (2002); our
/// priority is the place in the list.
fn medium(
    objects: &[Object<Absorbing>],
    contains: impl Fn(usize, &Shape) -> bool,
) -> Option<Medium> {
    let objects = objects.iter().enumerate().rev();
    let mut media = objects.filter_map(
        |(
            index,
            Object {
                shape, material, ..
            },
        )| {
            let Optics::Dielectric {
                eta_inside: eta, ..
            } = material.material.optics
            else {
                return None;
            };
            let absorption = material.absorption;
            contains(index, shape).then_some(Medium { eta, absorption })
        },
    );
    media.next()
}

/// Returns the medium of a stretch of a ray, `distance` long, on which the ray crosses no
/// surface: that in its middle, as far from the surfaces at its ends as can be.
#[must_use]
pub fn medium_along(
    objects: &[Object<Absorbing>],
    ray: &SurfaceRay,
    distance: f32,
) -> Option<Medium> {
    let middle = ray.ray.at(0.5 * distance);
    medium(objects, |index, shape| match shape {
        // However flat the ray, its side of this plane is known.
        Shape::Plane(_) if ray.origin == Some(index) => ray.enters,
        Shape::Sphere(_) | Shape::Plane(_) => shape.contains(middle),
    })
}
// ANCHOR_END: medium

// ANCHOR: interface
/// A function that returns the optics of a surface where a ray hits it. `None` if the light
/// passes as if there were no surface.
pub type OpticsAt = fn(&[Object<Absorbing>], &Interaction) -> Option<Optics>;

/// Returns the optics of a surface by the media that are really on its two sides. `None` if
/// these have the same index of refraction, be it that a third body has displaced both.
#[must_use]
pub fn between_media(objects: &[Object<Absorbing>], at: &Interaction) -> Option<Optics> {
    let optics = objects[at.index].material.material.optics;
    let Optics::Dielectric { eta_outside, .. } = optics else {
        return Some(optics);
    };
    let eta = |is_inside: bool| {
        let contains = |index, shape: &Shape| {
            let is_crossed = index == at.index;
            if is_crossed {
                is_inside
            } else {
                shape.contains(at.point)
            }
        };
        medium(objects, contains).map_or(eta_outside, |medium| medium.eta)
    };
    let (eta_inside, eta_outside) = (eta(true), eta(false));
    (eta_inside != eta_outside).then_some(Optics::Dielectric {
        eta_inside,
        eta_outside,
    })
}

/// The bug: returns the optics of a surface as if its object were alone in the scene.
#[must_use]
pub fn as_if_alone(objects: &[Object<Absorbing>], at: &Interaction) -> Option<Optics> {
    Some(objects[at.index].material.material.optics)
}
// ANCHOR_END: interface

// ANCHOR: stretch
/// A way straight on, through one medium after the other.
struct Way<'a> {
    objects: &'a [Object<Absorbing>],
    /// The rest of the way.
    ray: SurfaceRay,
    /// The surfaces that have been crossed: the index of the object, and whether it was
    /// entered.
    crossed: Vec<(usize, bool)>,
    /// The fraction of light that the media so far transmit.
    transmitted: Vec3,
}

impl<'a> Way<'a> {
    fn new(objects: &'a [Object<Absorbing>], ray: &SurfaceRay) -> Self {
        Self {
            objects,
            ray: *ray,
            crossed: Vec::new(),
            transmitted: Vec3::ONE,
        }
    }

    /// Goes on to the next surface with 0 < t < `t_max` of the objects that `is_met` holds
    /// for, or to `t_max` if there is none.
    fn go_on(
        &mut self,
        t_max: f32,
        is_met: impl Fn(&Object<Absorbing>) -> bool,
    ) -> Option<Interaction> {
        let hit = nearest_by(self.objects, t_max, |index, object, t_max| {
            let is_met = is_met(object);
            is_met.then(|| self.distance(index, &object.shape, t_max))?
        });
        let stretch = hit.map_or(t_max, |(_, t)| t);
        if let Some(medium) = medium_along(self.objects, &self.ray, stretch) {
            self.transmitted *= medium.transmittance(stretch);
        }
        Some(Interaction::new(self.objects, &self.ray.ray, hit?))
    }

    /// Returns the distance to the object's next surface.
    ///
    /// A body is convex: what has been entered is left next, and what has been left is not
    /// entered again. Where two surfaces touch, rounding would have it otherwise.
    fn distance(&self, index: usize, shape: &Shape, t_max: f32) -> Option<f32> {
        let mut crossings = self.crossed.iter().rev();
        let last = crossings.find(|crossing| crossing.0 == index);
        match (last, shape) {
            (None, _) => self.ray.distance(index, shape, t_max),
            (Some((_, true)), Shape::Sphere(sphere)) => {
                let t = self.ray.distance(index, shape, t_max)?;
                if sphere.is_entered(&self.ray.ray, t) {
                    return exit_distance(sphere, &self.ray.ray, t_max);
                }
                Some(t)
            }
            (Some(_), Shape::Sphere(_) | Shape::Plane(_)) => None,
        }
    }

    /// Crosses the surface that has been met.
    fn cross(&mut self, at: &Interaction) {
        self.crossed.push((at.index, at.enters()));
        self.ray = from_surface(at, at.incident);
    }
}
// ANCHOR_END: stretch

// ANCHOR: follow
/// Follows a ray straight on, to the first hit with a surface that reflects or refracts it.
/// Returns the fraction of light that the media on the way transmit, and the hit with its
/// optics; `None` if there is none. Counts a ray for each surface that it meets.
#[must_use]
pub fn follow(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    optics_at: OpticsAt,
) -> (Vec3, Option<(Interaction, Optics)>) {
    let mut way = Way::new(&scene.objects, ray);
    loop {
        canvas::count_ray();
        let Some(at) = way.go_on(T_MAX, |_| true) else {
            return (way.transmitted, None);
        };
        if let Some(optics) = optics_at(&scene.objects, &at) {
            return (way.transmitted, Some((at, optics)));
        }
        way.cross(&at);
    }
}
// ANCHOR_END: follow

// ANCHOR: through
/// Returns the shadow ray from a hit towards a light in front of the surface: it starts on the
/// side from which the ray has come, even if the light lies in the surface.
#[must_use]
pub fn shadow_ray(at: &Interaction, to_light: Vec3) -> SurfaceRay {
    SurfaceRay {
        enters: !at.enters(),
        ..from_surface(at, to_light)
    }
}

/// Returns the fraction of a light's red, green and blue that arrives along a shadow ray from
/// `distance` away: 0 if an opaque object occludes it, else what the media between transmit.
/// Counts one ray.
///
/// Refraction and reflection by these media are ignored, so that the shadow of a ball of glass
/// has a colour but no caustic.
#[must_use]
pub fn shadow_transmittance(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    light: Vec3,
    mut distance: f32,
) -> Vec3 {
    canvas::count_ray();
    let objects = &scene.objects;
    let is_opaque = |object: &Object<Absorbing>| {
        matches!(object.material.material.optics, Optics::Opaque { .. })
    };
    let occludes = |(index, object): (usize, &Object<Absorbing>)| {
        is_opaque(object)
            && ray
                .occlusion(index, &object.shape, light, distance)
                .is_some()
    };
    if objects.iter().enumerate().any(occludes) {
        return Vec3::ZERO;
    }
    let mut way = Way::new(objects, ray);
    while let Some(at) = way.go_on(distance, |object| !is_opaque(object)) {
        distance -= at.t;
        way.cross(&at);
    }
    way.transmitted
}
// ANCHOR_END: through

// ANCHOR: trace
/// Returns the radiance along a ray: that of the first surface that reflects or refracts it,
/// and what is seen in it and through it, less what is absorbed along the ray; or the
/// background.
#[must_use]
pub fn trace(
    scene: &Scene<Absorbing>,
    ray: &SurfaceRay,
    budget: PathBudget,
    optics_at: OpticsAt,
) -> Vec3 {
    let (path_transmittance, hit) = follow(scene, ray, optics_at);
    let Some((at, optics)) = hit else {
        return path_transmittance * scene.background;
    };
    let phong = &scene.objects[at.index].material.material.phong;
    let mut radiance = shade(phong, &at, &scene.lights, |light, to_light, distance| {
        let shadow_ray = shadow_ray(&at, to_light);
        shadow_transmittance(scene, &shadow_ray, light.position, distance)
    });
    for (weight, direction) in scatter(&optics, &at, fresnel).into_iter().flatten() {
        let coefficient = weight * path_transmittance.max_element();
        if let Some(budget) = budget.attenuated(coefficient) {
            let next = from_surface(&at, direction);
            radiance += weight * trace(scene, &next, budget, optics_at);
        }
    }
    path_transmittance * radiance
}
// ANCHOR_END: trace
