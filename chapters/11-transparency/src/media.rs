// ANCHOR: media-head
//! What is where: the media along a ray, and those on the two sides of a surface.

use crate::{Absorbing, transmittance};
use glam::Vec3;
use plane_hit::{Object, Shape, nearest_by};
use refraction::Optics;
use shadow_acne::{SurfaceRay, exit_distance, from_surface};
use shadows::Interaction;
// ANCHOR_END: media-head

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
    #[inline]
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
#[inline]
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
#[inline]
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
/// these have the same index of refraction, or if a third body has displaced both.
#[inline]
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
pub fn as_if_alone(objects: &[Object<Absorbing>], at: &Interaction) -> Option<Optics> {
    Some(objects[at.index].material.material.optics)
}
// ANCHOR_END: interface

// ANCHOR: stretch
/// A way straight on, through one medium after the other.
pub(crate) struct Way<'a> {
    objects: &'a [Object<Absorbing>],
    /// The rest of the way.
    ray: SurfaceRay,
    /// The surfaces that have been crossed: the index of the object, and whether it was
    /// entered.
    crossed: Vec<(usize, bool)>,
    /// The fraction of light that the media so far transmit.
    pub(crate) transmitted: Vec3,
}

impl<'a> Way<'a> {
    #[inline]
    pub(crate) fn new(objects: &'a [Object<Absorbing>], ray: &SurfaceRay) -> Self {
        Self {
            objects,
            ray: *ray,
            crossed: Vec::new(),
            transmitted: Vec3::ONE,
        }
    }

    /// Goes on to the next surface with 0 < t < `t_max` of the objects that `is_met` holds
    /// for, or to `t_max` if there is none.
    #[inline]
    pub(crate) fn go_on(
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
    #[inline(always)]
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
    #[inline]
    pub(crate) fn cross(&mut self, at: &Interaction) {
        self.crossed.push((at.index, at.enters()));
        self.ray = from_surface(at, at.incident);
    }
}
// ANCHOR_END: stretch
