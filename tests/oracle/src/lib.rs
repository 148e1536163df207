//! The reference for the chapters: a plain tracer in f64, and exact intersections.
//!
//! It shares no code with the chapters, so that a bug in a chapter cannot hide in it: it has types of
//! its own, finds hits by another derivation, refracts light by another, finds a ray's media by intervals,
//! and writes the scene out once more. It is not fast, and needs no offset: a ray holds the index of the
//! object that it starts on.

pub mod exact;
mod interface;
mod media;
mod still_life;
mod water;
pub use interface::Interface;
pub use still_life::{
    still_life, still_life_camera, still_life_with_glass, still_life_with_mirrors,
};
pub use water::{water, water_camera};

use glam::{DVec2, DVec3, Vec3Swizzles};

/// A half-line; its direction need not be a unit vector.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Its first point.
    pub origin: DVec3,
    /// Its direction.
    pub direction: DVec3,
    /// The index of the object on whose surface it starts, if it starts on one.
    pub from: Option<usize>,
}

/// An eye with an image plane in front of it, whose half-height is 1.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// The origin of all camera rays.
    pub eye: DVec3,
    /// The image plane's x; a unit vector, as are the next two.
    pub right: DVec3,
    /// The image plane's y.
    pub up: DVec3,
    /// From the eye to the middle of the image plane.
    pub forward: DVec3,
    /// The distance from the eye to the image plane.
    pub focal_length: f64,
}

impl Camera {
    /// Returns a camera at `eye` that looks along `forward`, upright: its `right` is level.
    #[must_use]
    pub fn upright(eye: DVec3, forward: DVec3, focal_length: f64) -> Self {
        // y up, z away, x to the right: (0,1,0) × (x,y,z) = (z,0,−x).
        let right = DVec3::new(forward.z, 0.0, -forward.x).normalize();
        let forward = forward.normalize();
        let up = forward.cross(right);
        Self {
            eye,
            right,
            up,
            forward,
            focal_length,
        }
    }

    /// Returns the ray through a point of a picture of `width` by `height` pixels: x from its left edge, y from
    /// its top, both in pixels, so that a pixel's centre is half a pixel away from its corner.
    #[must_use]
    pub fn ray(&self, at: DVec2, [width, height]: [u32; 2]) -> Ray {
        let half = DVec2::new(f64::from(width), f64::from(height)) / 2.0;
        let [x, y] = [at.x - half.x, half.y - at.y].map(|pixels| pixels / half.y);
        let direction = self.right * x + self.up * y + self.forward * self.focal_length;
        Ray {
            origin: self.eye,
            direction: direction.normalize(),
            from: None,
        }
    }
}

/// The shape of an object.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// A ball.
    Sphere {
        /// Its centre.
        centre: DVec3,
        /// Its radius.
        radius: f64,
    },
    /// A plane through a point, perpendicular to its normal, a unit vector.
    Plane {
        /// Any one of its points.
        point: DVec3,
        /// The unit vector perpendicular to it.
        normal: DVec3,
    },
}

impl Shape {
    /// Returns the interval of the ray's line inside the shape, in lengths of its direction: its first and
    /// its second end. A plane's inside is all that is behind it, so that one end is infinite, or both.
    /// `None` for a line that is never inside.
    ///
    /// `starts_here` says that the ray's origin, and with it one of the ends, is on the surface.
    fn interval(&self, ray: &Ray, starts_here: bool) -> Option<[f64; 2]> {
        match *self {
            Shape::Plane { point, normal } => {
                let depth = if starts_here {
                    0.0
                } else {
                    normal.dot(point - ray.origin)
                };
                let rate = normal.dot(ray.direction);
                let t = depth / rate;
                if !t.is_finite() {
                    // Parallel to the plane.
                    return (depth > 0.0).then_some([f64::NEG_INFINITY, f64::INFINITY]);
                }
                Some(if rate < 0.0 {
                    [t, f64::INFINITY]
                } else {
                    [f64::NEG_INFINITY, t]
                })
            }
            Shape::Sphere { centre, radius } => {
                // a t² + 2 b t + c = 0.
                let [o, d] = [ray.origin - centre, ray.direction];
                let [a, b] = [d.length_squared(), d.dot(o)];
                if starts_here {
                    // c = 0.
                    let other = -2.0 * b / a;
                    return Some([other.min(0.0), other.max(0.0)]);
                }
                // By Lagrange's identity a |o|² − (d·o)² = |o × d|², so that nothing large is
                // subtracted from something large: b² − a c = a r² − |o × d|².
                let c = (o.length() - radius) * (o.length() + radius);
                let discriminant = a * radius * radius - o.cross(d).length_squared();
                if !(discriminant >= 0.0) {
                    return None;
                }
                // The root of the larger magnitude, and the other from the product of both, c/a.
                let larger = -b - discriminant.sqrt().copysign(b);
                let [first, second] = [larger / a, c / larger];
                Some([first.min(second), first.max(second)])
            }
        }
    }

    /// Returns the distance to the first hit ahead of the ray's origin, in lengths of its direction. `None`
    /// if there is none.
    ///
    /// `starts_here` says that the origin is on the surface: this is not hit again, but for the far side of
    /// a ball.
    #[must_use]
    pub fn distance(&self, ray: &Ray, starts_here: bool) -> Option<f64> {
        let ends = self.interval(ray, starts_here)?;
        ends.into_iter().find(|&t| t > 0.0 && t.is_finite())
    }

    /// Returns the point of the surface that is nearest to a computed one.
    fn nearest_to(&self, at: DVec3) -> DVec3 {
        match *self {
            Shape::Sphere { centre, radius } => centre + radius * self.normal(at),
            Shape::Plane { point, normal } => at - normal.dot(at - point) * normal,
        }
    }

    /// Returns the unit normal at a point of the surface, outward for a sphere.
    #[must_use]
    pub fn normal(&self, at: DVec3) -> DVec3 {
        match *self {
            Shape::Sphere { centre, .. } => (at - centre).normalize(),
            Shape::Plane { normal, .. } => normal,
        }
    }

    /// Returns two coordinates of a point of the surface: of a plane, along two perpendicular directions in
    /// it and from its own point; of a sphere, x and z from its centre.
    ///
    /// Those of the floor y = 0 through the world's origin are x and z.
    #[must_use]
    pub fn uv(&self, at: DVec3) -> DVec2 {
        match *self {
            Shape::Sphere { centre, .. } => (at - centre).xz(),
            Shape::Plane { point, normal } => {
                let axis = if normal.x.abs() > 0.9 {
                    DVec3::Z
                } else {
                    DVec3::X
                };
                let u = axis.reject_from_normalized(normal).normalize();
                let v = u.cross(normal);
                let v = if v.y + v.z < 0.0 { -v } else { v };
                DVec2::new(u.dot(at - point), v.dot(at - point))
            }
        }
    }

    /// Returns whether a `light` is in front of the surface at a point, where its normal, turned to the ray's
    /// side, is `normal`.
    ///
    /// A plane is asked for the light's height above itself, so that all of its points give one answer.
    fn faces(&self, light: DVec3, at: DVec3, normal: DVec3) -> bool {
        let foot = match *self {
            Shape::Sphere { .. } => at,
            Shape::Plane { point, .. } => point,
        };
        normal.dot(light - foot) > 0.0
    }
}

/// A surface's colour, linear.
#[derive(Clone, Copy, Debug)]
pub enum Texture {
    /// The same colour everywhere.
    Solid(DVec3),
    /// Squares of side 1 by the surface's own coordinates: where ⌊u⌋ + ⌊v⌋ is even, and where it is odd.
    Checker(DVec3, DVec3),
}

impl Texture {
    fn at(&self, uv: DVec2) -> DVec3 {
        match *self {
            Texture::Solid(colour) => colour,
            Texture::Checker(even, odd) => {
                // Of a sum of whole numbers below 2⁵³, the remainder is exact.
                if (uv.x.floor() + uv.y.floor()) % 2.0 == 0.0 {
                    even
                } else {
                    odd
                }
            }
        }
    }
}

/// How a surface reflects light, by Phong's model.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// Its colour.
    pub texture: Texture,
    /// kₐ.
    pub ambient: f64,
    /// k_d.
    pub diffuse: f64,
    /// kₛ.
    pub specular: f64,
    /// The exponent of the highlight.
    pub shininess: i32,
}

/// How an object reflects and transmits rays.
#[derive(Clone, Copy, Debug)]
pub enum Optics {
    /// This fraction of the light is reflected, and the rest is lost.
    Opaque(f64),
    /// Light passes through. Where several dielectrics are at one place, the last in the list of objects
    /// displaces the others.
    Dielectric {
        /// The index of refraction inside.
        eta_inside: f64,
        /// The index of refraction outside, where no other dielectric is.
        eta_outside: f64,
        /// The parts of glass's behaviour that are modelled.
        glass: Glass,
    },
}

/// The parts of glass's behaviour that are modelled.
#[derive(Clone, Copy, Debug)]
pub enum Glass {
    /// It refracts all of the light, and reflects only what cannot be refracted. Its shadow is black.
    Refracts,
    /// It also reflects, by Fresnel's equations. Its shadow is still black.
    Reflects,
    /// It also absorbs red, green and blue light at these rates per unit of length, and a light shines
    /// through it, straight on.
    Absorbs(DVec3),
}

/// A shape, and its material.
#[derive(Clone, Copy, Debug)]
pub struct Object {
    /// Its shape.
    pub shape: Shape,
    /// Its surface.
    pub surface: Surface,
    /// How the object reflects and transmits rays.
    pub optics: Optics,
}

impl Object {
    /// Returns its colour at a point of its surface.
    fn colour(&self, at: DVec3) -> DVec3 {
        self.surface.texture.at(self.shape.uv(at))
    }
}

/// A point that shines in all directions; its light does not fade with distance.
#[derive(Clone, Copy, Debug)]
pub struct PointLight {
    /// Its position.
    pub position: DVec3,
    /// Its intensity.
    pub intensity: f64,
}

/// Objects, lights and a background.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The objects that rays can hit.
    pub objects: Vec<Object>,
    /// The lights.
    pub lights: Vec<PointLight>,
    /// The radiance along a ray that hits nothing.
    pub background: DVec3,
}

/// A ray's hit on an object.
#[derive(Clone, Copy, Debug)]
pub struct Interaction {
    /// The object's index in the scene.
    pub object: usize,
    /// The distance along the ray, in lengths of its direction.
    pub t: f64,
    /// The point.
    pub point: DVec3,
    /// The surface's unit normal there, on the side that the ray has come from.
    pub normal: DVec3,
    /// Whether the ray comes from inside the object, or from below a plane.
    pub leaves: bool,
    /// The indices of refraction on the ray's side and beyond; both 1 at an opaque object.
    pub indices: [f64; 2],
}

impl Interaction {
    /// Returns the ray that leaves the hit in a direction.
    #[must_use]
    pub fn spawn(&self, direction: DVec3) -> Ray {
        Ray {
            origin: self.point,
            direction,
            from: Some(self.object),
        }
    }
}

/// Returns the flat colour of the first object that a ray hits.
#[must_use]
pub fn trace_flat(scene: &Scene, ray: &Ray) -> DVec3 {
    scene.intersect(ray).map_or(scene.background, |at| {
        scene.objects[at.object].colour(at.point)
    })
}

/// Returns the flat colour, times the light that arrives from the visible lights.
#[must_use]
pub fn trace_shadows(scene: &Scene, ray: &Ray) -> DVec3 {
    scene.intersect(ray).map_or(scene.background, |at| {
        let lights = scene.lights.iter();
        let light: DVec3 = lights
            .map(|light| light.intensity * scene.visibility(&at, light))
            .sum();
        light * scene.objects[at.object].colour(at.point)
    })
}

/// Returns the radiance along a ray of ambient, diffuse and specular light.
#[must_use]
pub fn trace_shaded(scene: &Scene, ray: &Ray) -> DVec3 {
    scene
        .intersect(ray)
        .map_or(scene.background, |at| shade(scene, ray.direction, &at))
}

/// The limit to the recursion.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// The greatest number of bounces.
    pub bounces: u32,
    /// Rays with a throughput at or below this are not traced.
    pub min_throughput: f64,
}

/// Returns the radiance along a ray, with what is seen in mirrors and through glass.
#[must_use]
pub fn trace(scene: &Scene, ray: &Ray, limit: Limit) -> DVec3 {
    radiance(scene, ray, limit, 1.0)
}

/// Returns the radiance along a ray with this `throughput`.
fn radiance(scene: &Scene, ray: &Ray, limit: Limit, throughput: f64) -> DVec3 {
    let Some(at) = scene.intersect(ray) else {
        return scene.transmittance(ray, f64::INFINITY) * scene.background;
    };
    // All light from there has come along the ray.
    let transmitted = scene.transmittance(ray, at.t);
    let trace_next = |weight: f64, direction: DVec3| {
        let throughput = throughput * weight * transmitted.max_element();
        if limit.bounces == 0 || !(throughput > limit.min_throughput) {
            return DVec3::ZERO;
        }
        let limit = Limit {
            bounces: limit.bounces - 1,
            ..limit
        };
        weight * radiance(scene, &at.spawn(direction), limit, throughput)
    };
    let incident = ray.direction.normalize();
    let seen = match scene.objects[at.object].optics {
        Optics::Opaque(reflected) => trace_next(
            reflected,
            Interface::new(incident, at.normal, at.indices).reflected,
        ),
        Optics::Dielectric { glass, .. } => {
            let interface = Interface::new(incident, at.normal, at.indices);
            match (interface.refracted, glass) {
                (None, _) => trace_next(1.0, interface.reflected),
                (Some(refracted), Glass::Refracts) => trace_next(1.0, refracted),
                (Some(refracted), Glass::Reflects | Glass::Absorbs(_)) => {
                    trace_next(interface.reflectance, interface.reflected)
                        + trace_next(1.0 - interface.reflectance, refracted)
                }
            }
        }
    };
    transmitted * (shade(scene, incident, &at) + seen)
}

/// Returns kₐ C + Σ I (k_d C (N·L) + kₛ (R·L)ⁿ) over the visible lights; R is the unit vector `incident`,
/// reflected.
#[expect(clippy::disallowed_methods, reason = "the oracle makes no picture")]
fn shade(scene: &Scene, incident: DVec3, at: &Interaction) -> DVec3 {
    let object = &scene.objects[at.object];
    let (surface, colour) = (&object.surface, object.colour(at.point));
    let reflected = incident - 2.0 * incident.dot(at.normal) * at.normal;
    let mut radiance = surface.ambient * colour;
    for light in &scene.lights {
        let to_light = (light.position - at.point).normalize();
        let highlight = reflected.dot(to_light).max(0.0).powi(surface.shininess);
        let diffuse = surface.diffuse * at.normal.dot(to_light) * colour;
        radiance += light.intensity
            * scene.visibility(at, light)
            * (diffuse + surface.specular * highlight);
    }
    radiance
}

/// Returns the pixels' centres in a picture of `width` by `height`, row by row from the top.
pub fn pixel_centres([width, height]: [u32; 2]) -> impl Iterator<Item = DVec2> {
    let row = move |y| (0..width).map(move |x| DVec2::new(f64::from(x), f64::from(y)));
    (0..height).flat_map(row).map(|corner| corner + 0.5)
}

/// Returns the level of linear light on a screen, 0 to 255, not rounded: 255 times its sRGB encoding.
///
/// Source: IEC 61966-2-1.
#[must_use]
#[expect(
    clippy::disallowed_methods,
    reason = "the definition, which the canvas's levels are measured against"
)]
pub fn level(light: f64) -> f64 {
    let light = light.clamp(0.0, 1.0);
    let encoded = if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    };
    255.0 * encoded
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    fn ball(centre: DVec3, radius: f64, ambient: f64, optics: Optics) -> Object {
        Object {
            shape: Shape::Sphere { centre, radius },
            surface: glow(ambient),
            optics,
        }
    }

    fn glow(ambient: f64) -> Surface {
        Surface {
            texture: Texture::Solid(DVec3::ONE),
            ambient,
            diffuse: 0.0,
            specular: 0.0,
            shininess: 1,
        }
    }

    fn scene(objects: Vec<Object>) -> Scene {
        Scene {
            objects,
            lights: vec![],
            background: DVec3::ZERO,
        }
    }

    fn ray(origin: DVec3, direction: DVec3) -> Ray {
        Ray {
            origin,
            direction,
            from: None,
        }
    }

    /// Two parallel mirrors that glow by 0.1 and pass on 0.9: Σ 0.1 · 0.9ᵏ = 1 − 0.9ᴰ⁺¹, to the
    /// last bits at depth 5 as at 1000, upright and tilted.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the closed form")]
    fn two_facing_mirrors_add_up_to_the_closed_form() {
        for normal in [DVec3::X, dvec3(1.0, 2.0, -3.0).normalize()] {
            let wall = |side: f64| Object {
                shape: Shape::Plane {
                    point: side * normal,
                    normal: -side * normal,
                },
                surface: glow(0.1),
                optics: Optics::Opaque(0.9),
            };
            let scene = scene(vec![wall(1.0), wall(-1.0)]);
            let ray = ray(DVec3::ZERO, (normal + dvec3(0.1, 0.0, 0.2)).normalize());
            for bounces in [0, 1, 5, 10, 50, 100, 200, 1000] {
                let light = trace(
                    &scene,
                    &ray,
                    Limit {
                        bounces,
                        min_throughput: 0.0,
                    },
                );
                let exact = 1.0 - 0.9_f64.powi(bounces as i32 + 1);
                assert!((light.x - exact).abs() <= 1e-14, "{bounces}: {light}");
            }
        }
    }

    /// Inside a mirror sphere at 45°, four bounces make a square. After 1000 of them the fault of
    /// each direction, some 10⁻¹⁶, has been multiplied by the bounces that follow: 1000² · 10⁻¹⁶.
    #[test]
    fn an_orbit_inside_a_mirror_sphere_closes() {
        let scene = scene(vec![ball(DVec3::ZERO, 1.0, 0.0, Optics::Opaque(1.0))]);
        let mut ray = Ray {
            from: Some(0),
            ..ray(DVec3::X, dvec3(-1.0, 1.0, 0.0).normalize())
        };
        let corners = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y];
        for bounces in 1..=1000 {
            let at = scene.intersect(&ray).expect("the sphere is all around");
            assert!(at.leaves);
            assert!(
                at.point.distance(corners[bounces % 4]) <= 1e-10,
                "{bounces}"
            );
            let interface = Interface::new(ray.direction, at.normal, [1.0, 1.0]);
            ray = at.spawn(interface.reflected);
        }
    }

    /// An absorbing ball at normal incidence: each bounce between its two ends passes 0.04 on, and leaves e^(−2 a).
    /// With T = 0.96, R = 0.04 and A = e^(−2 a), the sky behind comes through with T² A / (1 − R² A²), and
    /// the sky in front with R + T² R A² / (1 − R² A²): without absorption all of it.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the closed form")]
    fn an_absorbing_ball_transmits_and_reflects_a_geometric_series() {
        let absorption = dvec3(0.0, 0.3, 2.0);
        let optics = Optics::Dielectric {
            eta_inside: 1.5,
            eta_outside: 1.0,
            glass: Glass::Absorbs(absorption),
        };
        let mut scene = scene(vec![ball(DVec3::ZERO, 1.0, 0.0, optics)]);
        scene.background = DVec3::ONE;
        let limit = Limit {
            bounces: 200,
            min_throughput: 0.0,
        };
        let light = trace(&scene, &ray(dvec3(0.0, 0.0, 5.0), DVec3::NEG_Z), limit);
        let exact = absorption.map(|a| {
            let [r, t, left] = [0.04, 0.96, (-2.0 * a).exp()];
            let through = t * t * left / (1.0 - r * r * left * left);
            through + r + r * left * through
        });
        assert!(light.distance(exact) <= 1e-14, "{light} for {exact}");
        assert!((light.x - 1.0).abs() <= 1e-14);
    }

    /// A light through an absorbing ball of radius 1, and from inside it: e^(−a) for each unit of length.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the closed form")]
    fn a_light_shines_through_absorbing_glass() {
        let optics = Optics::Dielectric {
            eta_inside: 1.5,
            eta_outside: 1.0,
            glass: Glass::Absorbs(DVec3::ONE),
        };
        let floor = Object {
            shape: Shape::Plane {
                point: DVec3::ZERO,
                normal: DVec3::Y,
            },
            ..ball(DVec3::ZERO, 1.0, 0.0, Optics::Opaque(0.0))
        };
        let scene = scene(vec![floor, ball(dvec3(0.0, 2.0, 0.0), 1.0, 0.0, optics)]);
        let at = scene.intersect(&ray(dvec3(1.0, 1.0, 0.0), dvec3(-1.0, -1.0, 0.0)));
        let at = at.expect("the floor");
        assert_eq!((at.object, at.point, at.leaves), (0, DVec3::ZERO, false));
        for (height, inside) in [(9.0, 2.0_f64), (2.5, 1.5), (0.5, 0.0)] {
            let light = PointLight {
                position: dvec3(0.0, height, 0.0),
                intensity: 1.0,
            };
            let left = scene.visibility(&at, &light);
            assert!((left.x - (-inside).exp()).abs() <= 1e-15, "{height}");
        }
    }
}
