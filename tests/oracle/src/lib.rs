//! What the chapters are measured against: a plain tracer in f64, and exact answers.
//!
//! It shares no code with the chapters, so that a bug in a chapter cannot hide in it: it has types of
//! its own, finds hits by another derivation, bends light by another, and writes the scene out once
//! more. It knows nothing of speed, and needs no offset: a ray knows the surface that it starts on.

mod border;
pub mod exact;
mod still_life;
pub use border::Border;
pub use still_life::{
    still_life, still_life_camera, still_life_with_glass, still_life_with_mirrors,
};

use glam::{DVec2, DVec3};

/// A half-line; its direction need not be a unit vector.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
    /// The thing on whose surface it starts, if on one, by its place in the scene.
    pub from: Option<usize>,
}

/// An eye with an image plane in front of it, whose half-height is 1.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// Where all rays start.
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
    /// A camera at `eye` that looks along `forward`, upright: its `right` is level.
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

    /// The ray through a point of a picture of `width` by `height` pixels: x from its left edge, y from
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

/// What a ray can meet.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// A ball.
    Sphere {
        /// Its middle.
        centre: DVec3,
        /// Its radius.
        radius: f64,
    },
    /// A plane through a point, at right angles to its normal, a unit vector.
    Plane {
        /// Any one of its points.
        point: DVec3,
        /// The direction at right angles to it.
        normal: DVec3,
    },
}

impl Shape {
    /// Where along the ray's line, in lengths of its direction, it is inside the shape: from a first to
    /// a second point. A plane has no inside, and both are one.
    ///
    /// `starts_here` says that the ray's origin is on the shape's surface, and so is one of the two.
    fn stretch(&self, ray: &Ray, starts_here: bool) -> Option<[f64; 2]> {
        match *self {
            Shape::Plane { point, normal } => {
                let height = normal.dot(point - ray.origin);
                let t = if starts_here {
                    0.0
                } else {
                    height / normal.dot(ray.direction)
                };
                t.is_finite().then_some([t, t])
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

    /// How far along the ray, in lengths of its direction, it first meets the shape ahead of its origin.
    ///
    /// `starts_here` says that the origin is on the shape's surface: that is not met a second time, but
    /// for the far side of a ball.
    #[must_use]
    pub fn meets(&self, ray: &Ray, starts_here: bool) -> Option<f64> {
        let ends = self.stretch(ray, starts_here)?;
        ends.into_iter().find(|&t| t > 0.0)
    }

    /// The point of the surface next to one that has been computed.
    fn nearest_to(&self, at: DVec3) -> DVec3 {
        match *self {
            Shape::Sphere { centre, radius } => centre + radius * self.normal(at),
            Shape::Plane { point, normal } => at - normal.dot(at - point) * normal,
        }
    }

    /// The unit vector at right angles to the surface at one of its points, out of a sphere.
    #[must_use]
    pub fn normal(&self, at: DVec3) -> DVec3 {
        match *self {
            Shape::Sphere { centre, .. } => (at - centre).normalize(),
            Shape::Plane { normal, .. } => normal,
        }
    }
}

/// A surface's colour, linear.
#[derive(Clone, Copy, Debug)]
pub enum Paint {
    /// The same everywhere.
    Plain(DVec3),
    /// Squares of side 1 by x and z: where ⌊x⌋ + ⌊z⌋ is even, and where it is odd.
    Checker(DVec3, DVec3),
}

impl Paint {
    fn at(&self, point: DVec3) -> DVec3 {
        match *self {
            Paint::Plain(colour) => colour,
            Paint::Checker(even, odd) => {
                // Of a sum of whole numbers below 2⁵³, the remainder is exact.
                if (point.x.floor() + point.z.floor()) % 2.0 == 0.0 {
                    even
                } else {
                    odd
                }
            }
        }
    }
}

/// How a surface answers to light, by Phong.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// Its colour.
    pub paint: Paint,
    /// kₐ.
    pub ambient: f64,
    /// k_d.
    pub diffuse: f64,
    /// kₛ.
    pub specular: f64,
    /// The exponent of the highlight.
    pub shininess: i32,
}

/// What becomes of the light that a surface does not scatter.
#[derive(Clone, Copy, Debug)]
pub enum Body {
    /// This share of it is mirrored, and the rest is lost.
    Opaque(f64),
    /// It goes through.
    Clear {
        /// The index of refraction within.
        inside: f64,
        /// The index of refraction around it.
        outside: f64,
        /// How much of what glass does it does.
        glass: Glass,
    },
}

/// How much a chapter knows of glass.
#[derive(Clone, Copy, Debug)]
pub enum Glass {
    /// Chapter 7: it bends the light, all of it, and mirrors what cannot go on. It stops a lamp's light.
    Bends,
    /// Chapters 8 to 10: it also mirrors its share, by Fresnel. It still stops a lamp's light.
    Mirrors,
    /// Chapter 11: it also takes up red, green and blue light at these rates, for each unit of length,
    /// and a lamp's light goes through it, straight on.
    Tints(DVec3),
}

/// A shape and what it is made of.
#[derive(Clone, Copy, Debug)]
pub struct Thing {
    /// Its shape.
    pub shape: Shape,
    /// Its surface.
    pub surface: Surface,
    /// What is behind the surface.
    pub body: Body,
}

/// A point that shines in all directions, as bright from afar as from nearby.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Where it is.
    pub position: DVec3,
    /// How bright it is.
    pub intensity: f64,
}

/// Everything there is.
#[derive(Clone, Debug)]
pub struct Scene {
    /// What a ray can meet.
    pub things: Vec<Thing>,
    /// The lamps.
    pub lamps: Vec<Lamp>,
    /// The light of a ray that meets nothing.
    pub background: DVec3,
}

/// Where a ray has met a thing.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// Which thing, by its place in the scene.
    pub thing: usize,
    /// The point.
    pub point: DVec3,
    /// The surface's unit normal there, on the side that the ray has come from.
    pub normal: DVec3,
    /// Whether the ray comes from inside the thing, or from below a plane.
    pub leaves: bool,
}

impl Meeting {
    /// The ray that goes on from here.
    #[must_use]
    pub fn towards(&self, direction: DVec3) -> Ray {
        Ray {
            origin: self.point,
            direction,
            from: Some(self.thing),
        }
    }
}

impl Scene {
    /// From where to where along a ray it is in the thing at a place of the scene; the ray does not
    /// meet the surface on which it starts a second time, but for the far side of a ball.
    fn stretch(&self, thing: usize, ray: &Ray) -> Option<[f64; 2]> {
        let starts_here = ray.from == Some(thing);
        self.things[thing].shape.stretch(ray, starts_here)
    }

    /// How far along the ray, in lengths of its direction, it first meets a thing ahead of its origin.
    fn meets(&self, thing: usize, ray: &Ray) -> Option<f64> {
        let starts_here = ray.from == Some(thing);
        self.things[thing].shape.meets(ray, starts_here)
    }

    /// The first thing in a ray's way.
    #[must_use]
    pub fn first(&self, ray: &Ray) -> Option<Meeting> {
        let things = 0..self.things.len();
        let met = things.filter_map(|thing| Some((thing, self.meets(thing, ray)?)));
        let (thing, t) = met.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let shape = self.things[thing].shape;
        let point = shape.nearest_to(ray.origin + t * ray.direction);
        let normal = shape.normal(point);
        let leaves = normal.dot(ray.direction) > 0.0;
        Some(Meeting {
            thing,
            point,
            normal: if leaves { -normal } else { normal },
            leaves,
        })
    }

    /// What is left, of red, green and blue, of light that goes straight along a ray as far as the end
    /// of its direction, through all the tinted glass on the way.
    ///
    /// Source: Beer–Lambert: e^(−a d).
    #[expect(clippy::disallowed_methods, reason = "the oracle makes no picture")]
    fn transmittance(&self, ray: &Ray) -> DVec3 {
        let mut exponent = DVec3::ZERO;
        for (thing, Thing { body, .. }) in self.things.iter().enumerate() {
            if let Body::Clear {
                glass: Glass::Tints(absorption),
                ..
            } = body
                && let Some([from, to]) = self.stretch(thing, ray)
            {
                let inside = to.clamp(0.0, 1.0) - from.clamp(0.0, 1.0);
                exponent -= *absorption * inside * ray.direction.length();
            }
        }
        exponent.map(f64::exp)
    }

    /// How much of a lamp's red, green and blue light reaches a point.
    ///
    /// A lamp behind the surface is hidden by it.
    #[must_use]
    pub fn reaches(&self, at: &Meeting, lamp: &Lamp) -> DVec3 {
        // The way is as long as its direction: the lamp is at t = 1.
        let way = at.towards(lamp.position - at.point);
        let blocks = |thing: usize| {
            let body = self.things[thing].body;
            !matches!(
                body,
                Body::Clear {
                    glass: Glass::Tints(_),
                    ..
                }
            ) && self.meets(thing, &way).is_some_and(|t| t < 1.0)
        };
        let is_lit =
            at.normal.dot(way.direction) > 0.0 && !(0..self.things.len()).any(blocks);
        if is_lit {
            self.transmittance(&way)
        } else {
            DVec3::ZERO
        }
    }
}

/// Chapter 3: the flat colour of what a ray meets first.
#[must_use]
pub fn trace_flat(scene: &Scene, ray: &Ray) -> DVec3 {
    scene.first(ray).map_or(scene.background, |at| {
        scene.things[at.thing].surface.paint.at(at.point)
    })
}

/// Chapter 4: the same, times the light of the lamps that reach it.
#[must_use]
pub fn trace_shadows(scene: &Scene, ray: &Ray) -> DVec3 {
    scene.first(ray).map_or(scene.background, |at| {
        let lamps = scene.lamps.iter();
        let light: DVec3 = lamps
            .map(|lamp| lamp.intensity * scene.reaches(&at, lamp))
            .sum();
        light * scene.things[at.thing].surface.paint.at(at.point)
    })
}

/// Chapter 5: ambient, diffuse and specular light.
#[must_use]
pub fn trace_shaded(scene: &Scene, ray: &Ray) -> DVec3 {
    scene.first(ray).map_or(scene.background, |at| {
        local_light(scene, ray.direction, &at)
    })
}

/// How far rays are followed.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// The most bounces.
    pub bounces: u32,
    /// A ray that brings no more than this share of the picture's light is not followed.
    pub share: f64,
}

/// Chapters 6 to 11: what is seen in mirrors and through glass as well, from things to things.
#[must_use]
pub fn trace(scene: &Scene, ray: &Ray, limit: Limit) -> DVec3 {
    follow(scene, ray, limit, 1.0)
}

/// What a ray brings back that brings this `share` of the picture's light.
fn follow(scene: &Scene, ray: &Ray, limit: Limit, share: f64) -> DVec3 {
    let Some(at) = scene.first(ray) else {
        return scene.background;
    };
    // Whatever comes from there comes the way that the ray has gone.
    let left = scene.transmittance(&Ray {
        direction: at.point - ray.origin,
        ..*ray
    });
    let go_on = |part: f64, direction: DVec3| {
        let share = share * part * left.max_element();
        if limit.bounces == 0 || !(share > limit.share) {
            return DVec3::ZERO;
        }
        let limit = Limit {
            bounces: limit.bounces - 1,
            ..limit
        };
        part * follow(scene, &at.towards(direction), limit, share)
    };
    let incident = ray.direction.normalize();
    let seen = match scene.things[at.thing].body {
        Body::Opaque(mirrored) => go_on(
            mirrored,
            Border::new(incident, at.normal, [1.0, 1.0]).mirrored,
        ),
        Body::Clear {
            inside,
            outside,
            glass,
        } => {
            let indices = if at.leaves {
                [inside, outside]
            } else {
                [outside, inside]
            };
            let border = Border::new(incident, at.normal, indices);
            match (border.refracted, glass) {
                (None, _) => go_on(1.0, border.mirrored),
                (Some(refracted), Glass::Bends) => go_on(1.0, refracted),
                (Some(refracted), Glass::Mirrors | Glass::Tints(_)) => {
                    go_on(border.reflectance, border.mirrored)
                        + go_on(1.0 - border.reflectance, refracted)
                }
            }
        }
    };
    left * (local_light(scene, incident, &at) + seen)
}

/// kₐ C + Σ I (k_d C (N·L) + kₛ (R·L)ⁿ) over the lamps that light the point; R mirrors the unit vector
/// `incident`.
#[expect(clippy::disallowed_methods, reason = "the oracle makes no picture")]
fn local_light(scene: &Scene, incident: DVec3, at: &Meeting) -> DVec3 {
    let surface = &scene.things[at.thing].surface;
    let colour = surface.paint.at(at.point);
    let mirrored = incident - 2.0 * incident.dot(at.normal) * at.normal;
    let mut light = surface.ambient * colour;
    for lamp in &scene.lamps {
        let to_lamp = (lamp.position - at.point).normalize();
        let highlight = mirrored.dot(to_lamp).max(0.0).powi(surface.shininess);
        let diffuse = surface.diffuse * at.normal.dot(to_lamp) * colour;
        light += lamp.intensity
            * scene.reaches(at, lamp)
            * (diffuse + surface.specular * highlight);
    }
    light
}

/// The pixels' centres in a picture of `width` by `height`, row by row from the top.
pub fn pixel_centres([width, height]: [u32; 2]) -> impl Iterator<Item = DVec2> {
    let row = move |y| (0..width).map(move |x| DVec2::new(f64::from(x), f64::from(y)));
    (0..height).flat_map(row).map(|corner| corner + 0.5)
}

/// The level of linear light on a screen, 0 to 255, not rounded: 255 times its sRGB encoding.
///
/// Source: IEC 61966-2-1.
#[must_use]
#[expect(
    clippy::disallowed_methods,
    reason = "the definition, which the canvas's whole powers are measured against"
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

    fn ball(centre: DVec3, radius: f64, ambient: f64, body: Body) -> Thing {
        Thing {
            shape: Shape::Sphere { centre, radius },
            surface: glow(ambient),
            body,
        }
    }

    fn glow(ambient: f64) -> Surface {
        Surface {
            paint: Paint::Plain(DVec3::ONE),
            ambient,
            diffuse: 0.0,
            specular: 0.0,
            shininess: 1,
        }
    }

    fn scene(things: Vec<Thing>) -> Scene {
        Scene {
            things,
            lamps: vec![],
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

    /// D22: two parallel mirrors that glow by 0.1 and pass on 0.9: Σ 0.1 · 0.9ᵏ = 1 − 0.9ᴰ⁺¹, to the
    /// last bits at depth 5 as at 1000, upright and tilted.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the closed form")]
    fn two_facing_mirrors_add_up_to_the_closed_form() {
        for normal in [DVec3::X, dvec3(1.0, 2.0, -3.0).normalize()] {
            let wall = |side: f64| Thing {
                shape: Shape::Plane {
                    point: side * normal,
                    normal: -side * normal,
                },
                surface: glow(0.1),
                body: Body::Opaque(0.9),
            };
            let scene = scene(vec![wall(1.0), wall(-1.0)]);
            let ray = ray(DVec3::ZERO, (normal + dvec3(0.1, 0.0, 0.2)).normalize());
            for bounces in [0, 1, 5, 10, 50, 100, 200, 1000] {
                let light = trace(
                    &scene,
                    &ray,
                    Limit {
                        bounces,
                        share: 0.0,
                    },
                );
                let exact = 1.0 - 0.9_f64.powi(bounces as i32 + 1);
                assert!((light.x - exact).abs() <= 1e-14, "{bounces}: {light}");
            }
        }
    }

    /// D20: inside a mirror sphere at 45°, four bounces make a square. After 1000 of them the fault of
    /// each direction, some 10⁻¹⁶, has been multiplied by the bounces that follow: 1000² · 10⁻¹⁶.
    #[test]
    fn an_orbit_inside_a_mirror_sphere_closes() {
        let scene = scene(vec![ball(DVec3::ZERO, 1.0, 0.0, Body::Opaque(1.0))]);
        let mut ray = Ray {
            from: Some(0),
            ..ray(DVec3::X, dvec3(-1.0, 1.0, 0.0).normalize())
        };
        let corners = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y];
        for bounces in 1..=1000 {
            let at = scene.first(&ray).expect("the sphere is all around");
            assert!(at.leaves);
            assert!(
                at.point.distance(corners[bounces % 4]) <= 1e-10,
                "{bounces}"
            );
            let border = Border::new(ray.direction, at.normal, [1.0, 1.0]);
            ray = at.towards(border.mirrored);
        }
    }

    /// A tinted ball straight on: each bounce between its two ends passes 0.04 on, and leaves e^(−2 a).
    /// With T = 0.96, R = 0.04 and A = e^(−2 a), the sky behind comes through with T² A / (1 − R² A²), and
    /// the sky in front with R + T² R A² / (1 − R² A²): without absorption all of it.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the closed form")]
    fn a_tinted_ball_passes_on_and_mirrors_a_geometric_series() {
        let absorption = dvec3(0.0, 0.3, 2.0);
        let body = Body::Clear {
            inside: 1.5,
            outside: 1.0,
            glass: Glass::Tints(absorption),
        };
        let mut scene = scene(vec![ball(DVec3::ZERO, 1.0, 0.0, body)]);
        scene.background = DVec3::ONE;
        let limit = Limit {
            bounces: 200,
            share: 0.0,
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

    /// A lamp through a tinted ball of radius 1, and from inside it: e^(−a) for each unit of length.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the closed form")]
    fn a_lamp_shines_through_tinted_glass() {
        let body = Body::Clear {
            inside: 1.5,
            outside: 1.0,
            glass: Glass::Tints(DVec3::ONE),
        };
        let floor = Thing {
            shape: Shape::Plane {
                point: DVec3::ZERO,
                normal: DVec3::Y,
            },
            ..ball(DVec3::ZERO, 1.0, 0.0, Body::Opaque(0.0))
        };
        let scene = scene(vec![floor, ball(dvec3(0.0, 2.0, 0.0), 1.0, 0.0, body)]);
        let at = scene.first(&ray(dvec3(1.0, 1.0, 0.0), dvec3(-1.0, -1.0, 0.0)));
        let at = at.expect("the floor");
        assert_eq!((at.thing, at.point, at.leaves), (0, DVec3::ZERO, false));
        for (height, inside) in [(9.0, 2.0_f64), (2.5, 1.5), (0.5, 0.0)] {
            let lamp = Lamp {
                position: dvec3(0.0, height, 0.0),
                intensity: 1.0,
            };
            let left = scene.reaches(&at, &lamp);
            assert!((left.x - (-inside).exp()).abs() <= 1e-15, "{height}");
        }
    }
}
