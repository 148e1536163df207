//! What a ray meets, and through which media it passes, by the intervals of its line in the objects.
//!
//! The last dielectric in the list of objects displaces the others: the intervals of a ray's line in all
//! dielectrics cut it into stretches, and the medium of a stretch is the last dielectric whose interval contains
//! its middle. Between two stretches of one index of refraction there is no interface, whatever
//! surface is there. An opaque object displaces all dielectrics.

use crate::{Glass, Interaction, Object, Optics, PointLight, Ray, Scene};
use glam::DVec3;

/// The part of a ray between neighbouring surfaces of dielectrics.
struct Stretch {
    /// Its ends, in lengths of the ray's direction: the first stretch starts at 0, and the last never ends.
    ends: [f64; 2],
    /// The index of the dielectric that it is in, if it is in one.
    medium: Option<usize>,
}

impl Ray {
    /// Returns the distance from `t` within which another surface is taken to be at the same place, in
    /// lengths of its direction: a billionth of the way from the world's origin to there, by the ray's own.
    ///
    /// A surface is put about 10⁻¹⁶ of that away from where it is by rounding, and more the more it is grazed:
    /// a light on a surface is not hidden by this surface, nor is anything between objects in touch, down
    /// to some 10⁻⁶ from a grazing ray.
    fn rounding(&self, t: f64) -> f64 {
        // At the world's origin itself, a thousandth of a unit.
        let origin = self.origin.length().max(1e-3);
        1e-9 * (origin / self.direction.length() + t.abs())
    }
}

impl Scene {
    /// Returns the interval of a ray's line inside the object with this index.
    fn interval(&self, object: usize, ray: &Ray) -> Option<[f64; 2]> {
        let starts_here = ray.from == Some(object);
        self.objects[object].shape.interval(ray, starts_here)
    }

    /// Returns the distance to the ray's first hit on the object with this index, and whether it leaves the
    /// object there.
    fn first_hit(&self, object: usize, ray: &Ray) -> Option<(f64, bool)> {
        let [enters, leaves] = self.interval(object, ray)?;
        let ahead = |&(t, _): &(f64, bool)| t > ray.rounding(0.0) && t.is_finite();
        [(enters, false), (leaves, true)].into_iter().find(ahead)
    }

    /// Returns the stretches of a ray, in its order.
    fn stretches(&self, ray: &Ray) -> Vec<Stretch> {
        let objects = self.objects.iter().enumerate();
        let dielectrics = objects
            .filter(|(_, object)| matches!(object.optics, Optics::Dielectric { .. }));
        let intervals: Vec<(usize, [f64; 2])> = dielectrics
            .filter_map(|(object, _)| Some((object, self.interval(object, ray)?)))
            .collect();
        let ends = intervals.iter().flat_map(|(_, ends)| *ends);
        let ahead = ends.filter(|&t| t > 0.0 && t.is_finite());
        let mut ends: Vec<f64> = [0.0, f64::INFINITY].into_iter().chain(ahead).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|second, first| *second - *first <= ray.rounding(*first));
        let stretch = |ends: &[f64]| {
            let [first, second] = [ends[0], ends[1]];
            let middle = first.midpoint(second);
            let contains =
                |&&(_, [from, to]): &&(usize, [f64; 2])| from <= middle && middle <= to;
            Stretch {
                ends: [first, second],
                medium: intervals.iter().rfind(contains).map(|&(object, _)| object),
            }
        };
        ends.windows(2).map(stretch).collect()
    }

    /// Returns the indices of refraction of two media in touch. Where no dielectric is, it is the other's
    /// index outside.
    fn indices(&self, media: [Option<usize>; 2]) -> [f64; 2] {
        let optics = |medium: Option<usize>| Some(self.objects[medium?].optics);
        let outside = match optics(media[0]).xor(optics(media[1])) {
            Some(Optics::Dielectric { eta_outside, .. }) => eta_outside,
            _ => 1.0,
        };
        media.map(|medium| match optics(medium) {
            Some(Optics::Dielectric { eta_inside, .. }) => eta_inside,
            _ => outside,
        })
    }

    /// Returns the ray's first hit on an opaque object or on an interface. `None` if it hits nothing.
    #[must_use]
    pub fn intersect(&self, ray: &Ray) -> Option<Interaction> {
        let objects = self.objects.iter().enumerate();
        let opaque = objects
            .filter(|(_, object)| matches!(object.optics, Optics::Opaque(_)))
            .filter_map(|(object, _)| Some((object, self.first_hit(object, ray)?)))
            .min_by(|(_, a), (_, b)| a.0.total_cmp(&b.0))
            .map(|(object, (t, leaves))| (t, object, leaves, [1.0, 1.0]));
        let interface = self.stretches(ray).windows(2).find_map(|pair| {
            let media = [pair[0].medium, pair[1].medium];
            let indices = self.indices(media);
            // The surface is that of the later object: it displaces the earlier one.
            let object = media[0].max(media[1])?;
            let leaves = media[0] == Some(object);
            (indices[0] != indices[1]).then_some((
                pair[1].ends[0],
                object,
                leaves,
                indices,
            ))
        });
        let nearest = match (opaque, interface) {
            (Some(opaque), Some(interface))
                if opaque.0 > interface.0 + ray.rounding(interface.0) =>
            {
                interface
            }
            (opaque, interface) => opaque.or(interface)?,
        };
        let (t, object, leaves, indices) = nearest;
        let shape = self.objects[object].shape;
        let point = shape.nearest_to(ray.origin + t * ray.direction);
        let normal = shape.normal(point);
        Some(Interaction {
            object,
            t,
            point,
            normal: if leaves { -normal } else { normal },
            leaves,
            indices,
        })
    }

    /// Returns the transmittance, for red, green and blue, of the media along a ray, from t = 0 to `until`.
    ///
    /// Source: Beer–Lambert: e^(−a d).
    #[expect(clippy::disallowed_methods, reason = "the oracle makes no picture")]
    pub(crate) fn transmittance(&self, ray: &Ray, until: f64) -> DVec3 {
        let stretches = self.stretches(ray).into_iter();
        let transmittance = |Stretch { ends, medium }: Stretch| {
            let inside =
                (ends[1].min(until) - ends[0].min(until)) * ray.direction.length();
            let optics = medium.map(|object| self.objects[object].optics);
            let Some(Optics::Dielectric {
                glass: Glass::Absorbs(absorption),
                ..
            }) = optics
            else {
                return DVec3::ONE;
            };
            // Over an endless way, too, what absorbs nothing transmits all.
            absorption.map(|a| if a > 0.0 { (-a * inside).exp() } else { 1.0 })
        };
        stretches.map(transmittance).product()
    }

    /// Returns the fraction of a light's red, green and blue that arrives at a hit.
    ///
    /// A light behind the surface is hidden by it. A light on a surface is not hidden by this surface.
    #[must_use]
    pub fn visibility(&self, at: &Interaction, light: &PointLight) -> DVec3 {
        // The light is at t = 1.
        let shadow_ray = at.spawn(light.position - at.point);
        let casts_black_shadow = |object: &Object| match object.optics {
            Optics::Opaque(_) => true,
            Optics::Dielectric { glass, .. } => !matches!(glass, Glass::Absorbs(_)),
        };
        let occludes = |(index, object): (usize, &Object)| {
            let hit = self.first_hit(index, &shadow_ray);
            casts_black_shadow(object)
                && hit.is_some_and(|(t, _)| t < 1.0 - shadow_ray.rounding(1.0))
        };
        let shape = self.objects[at.object].shape;
        let is_lit = shape.faces(light.position, at.point, at.normal)
            && !self.objects.iter().enumerate().any(occludes);
        if is_lit {
            self.transmittance(&shadow_ray, 1.0)
        } else {
            DVec3::ZERO
        }
    }
}
