//! What the chapters are measured against: a plain tracer in f64, and exact answers.
//!
//! It shares no code with the chapters, so that a bug in a chapter cannot hide in it: it has types of
//! its own, finds hits by another derivation, and writes the scene out once more. It knows nothing of
//! speed, and needs no offset.

pub mod exact;
mod still_life;
pub use still_life::{still_life, still_life_camera};

use glam::{DVec2, DVec3};

/// A half-line; its direction need not be a unit vector.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
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
    /// How far along the ray, in lengths of its direction, it first meets the shape ahead of its origin.
    #[must_use]
    pub fn meets(&self, ray: &Ray) -> Option<f64> {
        let ahead = |t: f64| (t > 0.0 && t.is_finite()).then_some(t);
        match *self {
            Shape::Plane { point, normal } => {
                ahead(normal.dot(point - ray.origin) / normal.dot(ray.direction))
            }
            Shape::Sphere { centre, radius } => {
                // a t² + 2 b t + c = 0. By Lagrange's identity a |o|² − (d·o)² = |o × d|², so that
                // nothing large is subtracted from something large: b² − a c = a r² − |o × d|².
                let [o, d] = [ray.origin - centre, ray.direction];
                let [a, b] = [d.length_squared(), d.dot(o)];
                let c = (o.length() - radius) * (o.length() + radius);
                let discriminant = a * radius * radius - o.cross(d).length_squared();
                if !(discriminant >= 0.0) {
                    return None;
                }
                // The root of the larger magnitude, and the other from the product of both, c/a.
                let larger = -b - discriminant.sqrt().copysign(b);
                let [first, second] = [larger / a, c / larger];
                ahead(first.min(second)).or_else(|| ahead(first.max(second)))
            }
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

/// A shape and what it is made of.
#[derive(Clone, Copy, Debug)]
pub struct Thing {
    /// Its shape.
    pub shape: Shape,
    /// Its surface.
    pub surface: Surface,
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
}

impl Scene {
    /// The first thing in a ray's way.
    #[must_use]
    pub fn first(&self, ray: &Ray) -> Option<Meeting> {
        let distances = self.things.iter().map(|thing| thing.shape.meets(ray));
        let met = distances.enumerate().filter_map(|(i, t)| Some((i, t?)));
        let (thing, t) = met.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let point = ray.origin + t * ray.direction;
        let normal = self.things[thing].shape.normal(point);
        Some(Meeting {
            thing,
            point,
            normal: -normal * normal.dot(ray.direction).signum(),
        })
    }

    /// Whether a lamp's light reaches a point.
    ///
    /// A lamp behind the surface is hidden by it. From one in front, the way does not meet the same
    /// thing again, since a ball is convex and a plane is flat: it is left out by its place in the
    /// scene, and no rounding can make a surface shadow itself.
    #[must_use]
    pub fn is_lit(&self, at: &Meeting, lamp: &Lamp) -> bool {
        let way = Ray {
            origin: at.point,
            direction: lamp.position - at.point,
        };
        // The way is as long as its direction: the lamp is at t = 1.
        let blocks = |thing: &Thing| thing.shape.meets(&way).is_some_and(|t| t < 1.0);
        let mut things = self.things.iter().enumerate();
        at.normal.dot(way.direction) > 0.0
            && !things.any(|(i, thing)| i != at.thing && blocks(thing))
    }

    fn lamps_that_light(&self, at: &Meeting) -> impl Iterator<Item = &Lamp> {
        self.lamps.iter().filter(move |lamp| self.is_lit(at, lamp))
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
        let lamps = scene.lamps_that_light(&at);
        let light: f64 = lamps.map(|lamp| lamp.intensity).sum();
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

/// kₐ C + Σ I (k_d C (N·L) + kₛ (R·L)ⁿ) over the lamps that light the point; R mirrors the unit vector `incident`.
#[expect(clippy::disallowed_methods, reason = "the oracle makes no picture")]
fn local_light(scene: &Scene, incident: DVec3, at: &Meeting) -> DVec3 {
    let surface = &scene.things[at.thing].surface;
    let colour = surface.paint.at(at.point);
    let mirrored = incident - 2.0 * incident.dot(at.normal) * at.normal;
    let mut light = surface.ambient * colour;
    for lamp in scene.lamps_that_light(at) {
        let to_lamp = (lamp.position - at.point).normalize();
        let highlight = mirrored.dot(to_lamp).max(0.0).powi(surface.shininess);
        light += lamp.intensity * surface.diffuse * at.normal.dot(to_lamp) * colour
            + lamp.intensity * surface.specular * highlight;
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
