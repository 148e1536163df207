//! A small tracer that can make every mistake of [`Fault`].
//!
//! It calculates in f32 and by the formulas of the book, so that rounding's faults look as they do
//! there, and imports no chapter, so that a broken one cannot stop it.

use crate::fault::Fault;
use glam::{Vec2, Vec3, Vec3Swizzles};
use std::cell::Cell;

/// A half-line.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Its first point.
    pub origin: Vec3,
    /// Its direction.
    pub direction: Vec3,
    /// The index of the object on which it starts, and whether it enters this object.
    from: Option<(usize, bool)>,
}

impl Ray {
    /// Returns a ray that starts on no known surface.
    #[must_use]
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self {
            origin,
            direction,
            from: None,
        }
    }

    fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }
}

/// A ball, or a plane with an outward normal.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the field's words")]
pub enum Shape {
    Sphere { centre: Vec3, radius: f32 },
    Plane { point: Vec3, normal: Vec3 },
}

/// A colour, linear.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the field's words")]
pub enum Texture {
    Solid(Vec3),
    /// Even and odd squares.
    Checker(Vec3, Vec3),
}

/// What an object does with rays.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the field's words")]
pub enum Optics {
    Mirror(f32),
    Glass { inside: f32, outside: f32 },
}

/// A material: Phong's, and the optics.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the field's words")]
pub struct Material {
    pub colour: Texture,
    pub ambient: f32,
    pub diffuse: f32,
    pub specular: f32,
    pub shininess: u32,
    pub optics: Optics,
    pub absorption: Vec3,
}

/// An object of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Object {
    /// What the report calls it: "the red ball".
    pub name: &'static str,
    /// Its shape.
    pub shape: Shape,
    /// Its material.
    pub material: Material,
}

/// How much of the book's light there is.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum Level {
    /// Chapter 3: the colour alone.
    Flat,
    /// Chapter 4: times the visible lights.
    Shadows,
    /// Chapter 5: Phong's model.
    Shaded,
    /// Chapter 6: and mirrors.
    Mirrors,
    /// Chapter 7: and glass that refracts.
    Refracts,
    /// Chapter 8: and reflects.
    Reflects,
    /// Chapter 10: rays remember the surface on which they start.
    Remembers,
    /// Chapter 11: and glass absorbs.
    Absorbs,
}

/// Objects and lights, and how they are traced.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The objects.
    pub objects: Vec<Object>,
    /// The lights: position and intensity.
    pub lights: Vec<(Vec3, f32)>,
    /// The radiance of the sky.
    pub background: Vec3,
    /// The chapter's light.
    pub level: Level,
    /// The number of bounces.
    pub depth: u32,
    /// The distance from the surface at which a ray starts; `None` if rays remember it.
    pub bias: Option<f32>,
}

/// The throughput at or below which a ray is not followed.
const MIN_THROUGHPUT: f32 = 1.0 / 32_768.0;
const FAR: f32 = 1e18;

struct Hit {
    index: usize,
    t: f32,
    point: Vec3,
    incident: Vec3,
    outward: Vec3,
    normal: Vec3,
    enters: bool,
}

/// What is seen at a point of the picture: the object, whether a checkered one is even there, and a
/// bit for each light that reaches it. `None` is the sky.
pub type Region = Option<(usize, bool, u32)>;

/// A scene, traced with a fault.
pub struct Tracer<'a> {
    scene: &'a Scene,
    fault: Fault,
    /// How many rays may still be traced.
    left: Cell<u32>,
}

/// The most rays of a camera ray. The right pictures take no more; with some faults rays are caught
/// in the glass, and branch there without end.
const MAX_RAYS: u32 = 50_000;
const MAX_RAYS_OF_FAULT: u32 = 200;

impl Tracer<'_> {
    /// Returns a tracer of one camera ray in a `scene`, with what is wrong.
    #[must_use]
    pub fn new(scene: &Scene, fault: Fault) -> Tracer<'_> {
        let left = match fault {
            Fault::None | Fault::Alone => MAX_RAYS,
            _ => MAX_RAYS_OF_FAULT,
        };
        Tracer {
            scene,
            fault,
            left: Cell::new(left),
        }
    }

    /// Returns the radiance along a camera ray.
    #[must_use]
    pub fn trace(&self, ray: &Ray) -> Vec3 {
        let depth = match self.fault {
            Fault::DepthOne => self.scene.depth.min(1),
            Fault::DepthLess => self.scene.depth.saturating_sub(1),
            _ => self.scene.depth,
        };
        self.radiance(ray, depth, 1.0, false)
    }

    /// Returns what a camera ray sees first.
    #[must_use]
    pub fn region(&self, ray: &Ray) -> Region {
        let hit = self.nearest(ray)?;
        let lights = self.scene.lights.iter().enumerate();
        let mut lit = 0;
        for (i, &(light, _)) in lights {
            let is_lit = self.is_in_front(&hit, light)
                && self.visibility(&hit, light) != Vec3::ZERO;
            lit |= u32::from(is_lit) << i;
        }
        let object = &self.scene.objects[hit.index];
        let is_odd = matches!(object.material.colour, Texture::Checker(_, odd) if self.colour(&hit) == odd);
        Some((hit.index, is_odd, lit))
    }

    fn is(&self, fault: Fault) -> bool {
        self.fault == fault
    }

    // Hits.

    fn radius(&self, radius: f32) -> f32 {
        match self.fault {
            Fault::RadiusTimes(factor) => radius * factor,
            _ => radius,
        }
    }

    /// Returns the distance to a sphere.
    fn sphere(&self, ray: &Ray, centre: Vec3, radius: f32, t_max: f32) -> Option<f32> {
        let radius = self.radius(radius);
        let oc = ray.origin - centre;
        let roots = if matches!(
            self.fault,
            Fault::TextbookSphere | Fault::NotNormalized(true)
        ) {
            let b = ray.direction.dot(oc);
            let discriminant = b * b - (oc.dot(oc) - radius * radius);
            if !(discriminant >= 0.0) {
                return None;
            }
            let root = discriminant.sqrt();
            [-b - root, -b + root]
        } else {
            let d_dot_d = ray.direction.dot(ray.direction);
            let t_closest = -ray.direction.dot(oc) / d_dot_d;
            let perpendicular = oc + t_closest * ray.direction;
            let radius_squared = match self.fault {
                Fault::RadiusUnsquared => radius,
                _ => radius * radius,
            };
            let squared = radius_squared - perpendicular.dot(perpendicular);
            if !(squared >= 0.0) {
                return None;
            }
            let t_half = (squared / d_dot_d).sqrt();
            [t_closest - t_half, t_closest + t_half]
        };
        let [near, far] = roots;
        let roots = match self.fault {
            Fault::FarRoot => [far, near],
            Fault::FarWallOnly => [far, far],
            Fault::HalfRoot => [near * 0.5, far * 0.5],
            _ => [near, far],
        };
        roots.into_iter().find(|&t| t > 0.0 && t < t_max)
    }

    fn distance(&self, ray: &Ray, index: usize, t_max: f32) -> Option<f32> {
        let shape = self.scene.objects[index].shape;
        if let Some((from, enters)) = ray.from
            && from == index
        {
            let Shape::Sphere { centre, .. } = shape else {
                return None;
            };
            let d = ray.direction;
            let t = -2.0 * d.dot(ray.origin - centre) / d.dot(d);
            return (enters && t > 0.0 && t < t_max).then_some(t);
        }
        match shape {
            Shape::Sphere { centre, radius } => self.sphere(ray, centre, radius, t_max),
            Shape::Plane { point, normal } => {
                if self.is(Fault::NoFloor) {
                    return None;
                }
                let along = ray.direction.dot(normal);
                if self.is(Fault::OneSidedPlane) && along >= 0.0 {
                    return None;
                }
                let t = (point - ray.origin).dot(normal) / along;
                (t > 0.0 && t < t_max).then_some(t)
            }
        }
    }

    fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest: Option<(usize, f32)> = None;
        for index in 0..self.scene.objects.len() {
            let t_max = match (nearest, self.fault) {
                (Some(_), Fault::LastInList | Fault::Farthest) | (None, _) => FAR,
                (Some((_, t)), _) => t,
            };
            if let Some(t) = self.distance(ray, index, t_max) {
                if self.is(Fault::FirstInList) && nearest.is_some() {
                    continue;
                }
                if self.is(Fault::Farthest) && nearest.is_some_and(|(_, old)| old > t) {
                    continue;
                }
                nearest = Some((index, t));
            }
        }
        nearest.map(|(index, t)| self.hit(ray, index, t))
    }

    fn hit(&self, ray: &Ray, index: usize, t: f32) -> Hit {
        let point = ray.at(t);
        let incident = ray.direction;
        let (outward, enters) = match self.scene.objects[index].shape {
            Shape::Sphere { centre, radius } => {
                let oc = ray.origin - centre;
                let d = ray.direction;
                let outward = match self.fault {
                    Fault::NormalNotNormalized => point - centre,
                    Fault::NormalFromOrigin => point.normalize_or(Vec3::Y),
                    _ => ((point - centre) / radius).normalize_or(Vec3::Y),
                };
                (outward, t <= -d.dot(oc) / d.dot(d))
            }
            Shape::Plane { normal, .. } => (normal, normal.dot(incident) < 0.0),
        };
        let outward = if self.is(Fault::NormalInward) {
            -outward
        } else {
            outward
        };
        let enters = enters || self.is(Fault::GlassNormalUnturned);
        Hit {
            index,
            t,
            point,
            incident,
            outward,
            normal: if enters { outward } else { -outward },
            enters,
        }
    }

    fn is_clear(&self, index: usize) -> bool {
        self.scene.level >= Level::Refracts
            && !self.is(Fault::GlassOpaque)
            && matches!(
                self.scene.objects[index].material.optics,
                Optics::Glass { .. }
            )
    }

    /// Returns the hit point on the surface, as nearly as can be.
    fn projected(&self, hit: &Hit) -> Vec3 {
        match self.scene.objects[hit.index].shape {
            Shape::Sphere { centre, radius } => {
                centre + self.radius(radius) * hit.outward
            }
            Shape::Plane { point, .. } => {
                hit.point - (hit.point - point).dot(hit.outward) * hit.outward
            }
        }
    }

    /// Returns the ray that leaves a hit.
    fn spawn(&self, hit: &Hit, direction: Vec3) -> Ray {
        let side = if hit.outward.dot(direction) < 0.0 {
            -hit.outward
        } else {
            hit.outward
        };
        let bias = match self.fault {
            Fault::NoBias => Some(0.0),
            Fault::Bias(bias) => Some(bias),
            Fault::BiasInward => Some(-1e-3),
            Fault::FarRoot | Fault::NormalNotNormalized | Fault::NormalFromOrigin => {
                Some(self.scene.bias.unwrap_or(1e-4))
            }
            _ => self.scene.bias,
        };
        match bias {
            Some(bias) => Ray::new(hit.point + bias * side, direction),
            None => Ray {
                origin: self.projected(hit),
                direction,
                from: Some((hit.index, hit.outward.dot(direction) < 0.0)),
            },
        }
    }

    // Colours.

    fn colour(&self, hit: &Hit) -> Vec3 {
        let decoded = |colour: Vec3| {
            if self.is(Fault::ColoursDecoded) {
                colour.map(|c| crate::levels::decode(f64::from(c)) as f32)
            } else {
                colour
            }
        };
        let object = &self.scene.objects[hit.index];
        match object.material.colour {
            Texture::Solid(colour) => decoded(colour),
            Texture::Checker(even, odd) => {
                let (from_origin, uv) = match object.shape {
                    Shape::Sphere { centre, .. } => {
                        (hit.point - centre, (hit.point - centre).xz())
                    }
                    Shape::Plane { point, normal } => {
                        let p = hit.point - point;
                        // Our planes' normals are along an axis.
                        let uv = if normal.x.abs() > 0.9 {
                            Vec2::new(p.z, p.y)
                        } else if normal.z.abs() > 0.9 {
                            p.xy()
                        } else {
                            p.xz()
                        };
                        (p, uv)
                    }
                };
                decoded(if self.is_even(uv, from_origin) {
                    even
                } else {
                    odd
                })
            }
        }
    }

    /// Returns whether a point of a checkered surface is in an even square.
    #[must_use]
    pub fn is_even(&self, uv: Vec2, in_space: Vec3) -> bool {
        let parity = |sum: f32| sum - 2.0 * (sum / 2.0).floor() == 0.0;
        let [u, v] = uv.floor().to_array();
        match self.fault {
            Fault::CheckerParity => !parity(u + v),
            Fault::CheckerInSpace => parity(u + v + in_space.y.floor()),
            Fault::CheckerTowardsZero => parity(uv.x.trunc() + uv.y.trunc()),
            Fault::CheckerTimes(factor) => {
                let [u, v] = (factor * uv).floor().to_array();
                parity(u + v)
            }
            Fault::CheckerStripes => parity(u),
            Fault::CheckerMultiplied => parity(u * v),
            _ => parity(u + v),
        }
    }

    // Lights.

    fn lights(&self) -> impl Iterator<Item = (Vec3, f32)> + '_ {
        let lights = &self.scene.lights;
        let count = lights.len();
        lights
            .iter()
            .enumerate()
            .filter(move |(i, _)| self.fault != Fault::LightMissing(*i))
            .map(move |(i, &(position, intensity))| match self.fault {
                Fault::LightsSwapped => (position, lights[count - 1 - i].1),
                Fault::LightsFull => (position, 1.0),
                Fault::LightsAveraged => (position, intensity / count as f32),
                Fault::LightMirroredZ => {
                    (position * Vec3::new(1.0, 1.0, -1.0), intensity)
                }
                Fault::LightsDirectional => (1e5 * position, intensity),
                _ => (position, intensity),
            })
    }

    fn is_in_front(&self, hit: &Hit, light: Vec3) -> bool {
        let (height, surface) = match self.scene.objects[hit.index].shape {
            Shape::Plane { point, normal } => (normal.dot(light - point), 0.0),
            Shape::Sphere { centre, radius } => {
                (hit.outward.dot(light - centre), self.radius(radius))
            }
        };
        if hit.enters {
            height > surface
        } else {
            height < surface
        }
    }

    /// Returns the fraction of a light that arrives at a hit.
    fn visibility(&self, hit: &Hit, light: Vec3) -> Vec3 {
        if self.is(Fault::NoShadows) {
            return Vec3::ONE;
        }
        let to_light = light - hit.point;
        let (mut ray, mut distance) = if self.scene.level < Level::Remembers {
            let bias = match self.fault {
                Fault::NoBias => 0.0,
                Fault::Bias(bias) => bias,
                Fault::BiasInward => -1e-3,
                _ => self.scene.bias.unwrap_or(0.0),
            };
            let origin = hit.point + bias * hit.normal;
            let (direction, distance) = (light - origin).normalize_and_length();
            (Ray::new(origin, direction), distance)
        } else {
            let ray = self.spawn(hit, to_light.normalize());
            (ray, to_light.length())
        };
        match self.fault {
            Fault::ShadowUnnormalized => ray.direction *= distance,
            Fault::BeyondLight => distance = FAR,
            Fault::ShadowFromEye => ray.direction = -ray.direction,
            _ => {}
        }
        let mut visible = Vec3::ONE;
        for (index, object) in self.scene.objects.iter().enumerate() {
            let is_clear = self.is_clear(index);
            if is_clear && self.is(Fault::GlassNoShadow) {
                continue;
            }
            let lets_through = is_clear
                && self.scene.level == Level::Absorbs
                && !self.is(Fault::GlassShadowBlack);
            if lets_through {
                if self.scene.lights.len() > 1 && !self.is_pool() {
                    visible *= self.transmitted_by(object, &ray, index, distance);
                }
            } else if self.distance(&ray, index, distance).is_some() {
                return Vec3::ZERO;
            }
        }
        if self.is_pool() && self.scene.level == Level::Absorbs {
            visible *= self.through_media(&ray, distance);
        }
        visible
    }

    fn reflected_light(
        &self,
        material: &Material,
        colour: Vec3,
        hit: &Hit,
        l: Vec3,
    ) -> [Vec3; 2] {
        let n = hit.normal;
        let clamped = |cos: f32| {
            if matches!(self.fault, Fault::NotNormalized(_)) {
                cos.max(0.0)
            } else {
                cos.clamp(0.0, 1.0)
            }
        };
        let raw = n.dot(l);
        let cos_l = match self.fault {
            Fault::DiffuseBothSides => raw.abs(),
            Fault::LightUnnormalized | Fault::NormalNotNormalized => raw.max(0.0),
            _ => clamped(raw),
        };
        let diffuse = match self.fault {
            Fault::NoDiffuse => 0.0,
            Fault::DiffuseFlat => 1.0,
            Fault::DiffuseHalf => 0.5 * raw + 0.5,
            _ => cos_l,
        };
        let diffuse = material.diffuse * diffuse * colour;
        let view = match self.fault {
            Fault::ViewSign => hit.incident,
            _ => -hit.incident,
        };
        let mut shininess = material.shininess;
        let cos = match self.fault {
            Fault::HalfVector => n.dot((l + view).normalize_or(n)),
            Fault::ReflectedSign => (l - 2.0 * cos_l * n).dot(view),
            _ => (2.0 * cos_l * n - l).dot(view),
        };
        if let Fault::ShininessTimes(factor) = self.fault {
            shininess = ((shininess as f32 * factor) as u32).max(1);
        }
        let cos = match self.fault {
            Fault::CosineUnclamped => cos,
            Fault::LightUnnormalized => cos.max(0.0),
            _ => clamped(cos),
        };
        let power = powi(cos, shininess);
        let mut specular = material.specular * power * Vec3::ONE;
        match self.fault {
            Fault::NoSpecular => specular = Vec3::ZERO,
            Fault::SpecularColoured => specular *= colour,
            Fault::SpecularTimesCosine => specular *= cos_l,
            _ => {}
        }
        [diffuse, specular]
    }

    fn shade(&self, hit: &Hit) -> Vec3 {
        let mut material = self.scene.objects[hit.index].material;
        if self.is(Fault::StrongSurfaces) && material.specular > 0.0 {
            material.specular = 5.0;
        }
        let colour = self.colour(hit);
        let ambient = match self.fault {
            Fault::NoAmbient => Vec3::ZERO,
            Fault::AmbientWhite => Vec3::splat(material.ambient),
            _ => material.ambient * colour,
        };
        let mut radiance = ambient;
        let mut is_lit = false;
        for (position, intensity) in self.lights() {
            if self.is(Fault::AmbientPerLight) {
                radiance += ambient;
            }
            let leaks = matches!(
                self.fault,
                Fault::DiffuseBothSides | Fault::CosineUnclamped | Fault::DiffuseHalf
            );
            if !leaks && !self.is_in_front(hit, position) {
                continue;
            }
            let to_light = position - hit.point;
            let mut l = to_light.normalize_or(hit.normal);
            if self.is(Fault::LightUnnormalized) {
                l = to_light;
            }
            let intensity = match self.fault {
                Fault::Falloff(1) => intensity * 5.0 / to_light.length(),
                Fault::Falloff(2) => intensity / to_light.length_squared(),
                Fault::Falloff(_) => intensity * 50.0 / to_light.length_squared(),
                _ => intensity,
            };
            let [diffuse, specular] = self.reflected_light(&material, colour, hit, l);
            let mut visible = Vec3::ONE;
            if diffuse + specular != Vec3::ZERO {
                visible = self.visibility(hit, position);
                is_lit |= visible != Vec3::ZERO;
            }
            radiance += if self.is(Fault::SpecularUnshadowed) {
                intensity * (diffuse * visible + specular)
            } else {
                intensity * (diffuse + specular) * visible
            };
        }
        if self.is(Fault::AmbientShadowed) && !is_lit {
            return Vec3::ZERO;
        }
        if self.is(Fault::AmbientPerLight) {
            radiance -= ambient;
        }
        radiance
    }

    // Paths.

    fn radiance(
        &self,
        ray: &Ray,
        depth: u32,
        throughput: f32,
        is_secondary: bool,
    ) -> Vec3 {
        let scene = self.scene;
        if self.is_pool() {
            return self.pool_radiance(ray, depth, throughput);
        }
        let Some(hit) = self.nearest(ray) else {
            if is_secondary && self.is(Fault::MirrorBlackSky) {
                return Vec3::ZERO;
            }
            return scene.background;
        };
        match scene.level {
            Level::Flat => return self.colour(&hit),
            Level::Shadows => {
                let colour = self.colour(&hit);
                let mut intensity = 0.0;
                for (position, light) in self.lights() {
                    let visible = self.is(Fault::NoShadows)
                        || (self.is_in_front(&hit, position)
                            && self.visibility(&hit, position) != Vec3::ZERO);
                    if self.is(Fault::AnyShadowIsAll) && !visible {
                        intensity = 0.0;
                        break;
                    }
                    intensity += f32::from(visible) * light;
                }
                return intensity * colour;
            }
            Level::Shaded => return self.shade(&hit),
            _ => {}
        }
        let transmitted = self.transmitted(&hit);
        let shaded = if is_secondary && self.is(Fault::MirrorUnlit) {
            self.colour(&hit)
        } else {
            self.shade(&hit)
        };
        let (seen, keeps) =
            self.scattered(&hit, depth, throughput * transmitted.max_element());
        transmitted * (keeps * shaded + seen)
    }

    /// Returns what the glass transmits on the way to a hit.
    fn transmitted(&self, hit: &Hit) -> Vec3 {
        if self.scene.level != Level::Absorbs {
            return Vec3::ONE;
        }
        if self.is(Fault::AbsorbsOutside) {
            let is_outside = hit.enters || !self.is_clear(hit.index);
            let glass = self
                .scene
                .objects
                .iter()
                .find(|o| o.material.absorption != Vec3::ZERO);
            let absorption = glass.map_or(Vec3::ZERO, |glass| glass.material.absorption);
            return if is_outside {
                exp(absorption, hit.t)
            } else {
                Vec3::ONE
            };
        }
        if hit.enters || !self.is_clear(hit.index) {
            return Vec3::ONE;
        }
        self.absorbed(self.scene.objects[hit.index].material.absorption, hit.t)
    }

    fn absorbed(&self, absorption: Vec3, distance: f32) -> Vec3 {
        match self.fault {
            Fault::AbsorbsNot => Vec3::ONE,
            Fault::AbsorbsAtSurface => exp(absorption, 0.5),
            Fault::AbsorbsTwice => exp(absorption, 2.0 * distance),
            Fault::AbsorbsBaseTen => exp(absorption, std::f32::consts::LN_10 * distance),
            Fault::AbsorbsLinearly => (Vec3::ONE - absorption * distance).max(Vec3::ZERO),
            _ => exp(absorption, distance),
        }
    }

    /// Returns what one body transmits of a light.
    fn transmitted_by(
        &self,
        object: &Object,
        ray: &Ray,
        index: usize,
        distance: f32,
    ) -> Vec3 {
        let Shape::Sphere { centre, radius } = object.shape else {
            return Vec3::ONE;
        };
        if object.material.absorption == Vec3::ZERO || self.is(Fault::AbsorbsOutside) {
            return Vec3::ONE;
        }
        let inside = if ray.from.is_some_and(|(from, _)| from == index) {
            self.distance(ray, index, distance)
        } else {
            let right = Tracer::new(self.scene, Fault::None);
            right.sphere(ray, centre, radius, distance).map(|near| {
                let oc = ray.origin - centre;
                let closest = -ray.direction.dot(oc);
                if near < closest {
                    (2.0 * closest - near).min(distance) - near
                } else {
                    near
                }
            })
        };
        inside.map_or(Vec3::ONE, |inside| {
            self.absorbed(object.material.absorption, inside)
        })
    }

    fn next(
        &self,
        hit: &Hit,
        weight: f32,
        direction: Vec3,
        depth: u32,
        throughput: f32,
    ) -> Vec3 {
        let throughput = throughput * weight;
        let min_throughput = match self.fault {
            Fault::None | Fault::Alone => MIN_THROUGHPUT,
            // A quarter of a level in the dark.
            _ => 4.0 * MIN_THROUGHPUT,
        };
        if depth == 0 || !(throughput > min_throughput) || self.left.get() == 0 {
            return Vec3::ZERO;
        }
        self.left.set(self.left.get() - 1);
        let mut ray = self.spawn(hit, direction);
        if self.is(Fault::GlassBiasWrong) && self.is_clear(hit.index) {
            ray = Ray::new(hit.point + 1e-3 * hit.normal, direction);
        }
        if self.is(Fault::GlassDepth) && self.is_clear(hit.index) {
            return weight * self.radiance(&ray, 0, throughput, true);
        }
        weight * self.radiance(&ray, depth - 1, throughput, true)
    }

    /// Returns what is seen in and through a surface, and the fraction of its own light.
    fn scattered(&self, hit: &Hit, depth: u32, throughput: f32) -> (Vec3, f32) {
        let object = &self.scene.objects[hit.index];
        let reflected = self.reflect(hit);
        match object.material.optics {
            Optics::Mirror(k) => {
                let k = match self.fault {
                    Fault::NoMirror => 0.0,
                    Fault::MirrorFull if k > 0.0 => 1.0,
                    Fault::MirrorSquared => k * k,
                    _ => k,
                };
                if k == 0.0 {
                    return (Vec3::ZERO, 1.0);
                }
                let mut seen = self.next(hit, k, reflected, depth, throughput);
                if self.is(Fault::MirrorTinted) {
                    seen *= self.colour(hit);
                }
                let keeps = match self.fault {
                    Fault::MirrorMixed => 1.0 - k,
                    Fault::MirrorOnly => 0.0,
                    _ => 1.0,
                };
                (seen, keeps)
            }
            Optics::Glass { inside, outside } => {
                if !self.is_clear(hit.index) {
                    return (Vec3::ZERO, 1.0);
                }
                let seen = self.through(hit, [inside, outside], depth, throughput);
                (seen, 1.0)
            }
        }
    }

    fn through(
        &self,
        hit: &Hit,
        [inside, outside]: [f32; 2],
        depth: u32,
        throughput: f32,
    ) -> Vec3 {
        let inside = match self.fault {
            Fault::IndexOther(index) if inside > outside => index,
            _ => inside,
        };
        let (eta_i, eta_t) = if hit.enters {
            (outside, inside)
        } else {
            (inside, outside)
        };
        let eta = match self.fault {
            Fault::RatioInverted => eta_t / eta_i,
            Fault::RatioSame => outside / inside,
            Fault::Unbent => 1.0,
            _ => eta_i / eta_t,
        };
        let reflected = self.reflect(hit);
        let tint = if self.is(Fault::GlassTinted) && self.scene.level != Level::Absorbs {
            0.8
        } else {
            1.0
        };
        let next = |weight: f32, direction| {
            self.next(hit, weight * tint, direction, depth, throughput)
        };
        let Some(refracted) = refract(hit.incident, hit.normal, eta) else {
            return match self.fault {
                Fault::TotalBlack => Vec3::ZERO,
                Fault::TotalStraight => next(1.0, hit.incident),
                _ => next(1.0, reflected),
            };
        };
        let refracted = if self.is(Fault::RefractSign) {
            let along = refracted.dot(hit.normal) * hit.normal;
            2.0 * along - refracted
        } else {
            refracted
        };
        if self.scene.level == Level::Refracts {
            return next(1.0, refracted);
        }
        let cos_i = -hit.normal.dot(hit.incident);
        let r = self.reflectance(cos_i, eta_i, eta_t);
        let (r, t) = match self.fault {
            Fault::NoReflection => (0.0, 1.0),
            Fault::OnlyReflection => (r, 0.0),
            Fault::FresnelSwapped => (1.0 - r, r),
            Fault::TransmitsAll => (r, 1.0),
            _ => (r, 1.0 - r),
        };
        next(r, reflected) + next(t, refracted)
    }

    /// Returns the reflectance of an interface.
    #[must_use]
    pub fn reflectance(&self, cos_i: f32, eta_i: f32, eta_t: f32) -> f32 {
        if eta_i == eta_t && !self.is(Fault::EqualIndicesSparkle) {
            return 0.0;
        }
        let r0 = ((eta_i - eta_t) / (eta_i + eta_t)).powi(2);
        let schlick = |cos: f32| r0 + (1.0 - r0) * powi(1.0 - cos, 5);
        if let Fault::ConstantReflectance(constant) = self.fault {
            return constant;
        }
        if self.is(Fault::SchlickWrongCosine) {
            return schlick(cos_i);
        }
        let eta = eta_i / eta_t;
        let sin2_t = eta * eta * (1.0 - cos_i) * (1.0 + cos_i);
        if !(sin2_t < 1.0) {
            return 1.0;
        }
        let cos_t = (1.0 - sin2_t).sqrt();
        if self.is(Fault::Schlick) {
            return schlick(cos_i.min(cos_t));
        }
        let parallel = (eta_t * cos_i - eta_i * cos_t) / (eta_t * cos_i + eta_i * cos_t);
        let perpendicular =
            (eta_i * cos_i - eta_t * cos_t) / (eta_i * cos_i + eta_t * cos_t);
        let [p, s] = [parallel * parallel, perpendicular * perpendicular];
        match self.fault {
            Fault::OnePolarization(true) => p,
            Fault::OnePolarization(false) => s,
            Fault::FresnelAverage => {
                (0.5 * (parallel.abs() + perpendicular.abs())).min(1.0)
            }
            _ => (p + s) / 2.0,
        }
    }

    fn reflect(&self, hit: &Hit) -> Vec3 {
        let (i, n) = (hit.incident, hit.normal);
        match self.fault {
            Fault::MirrorWithoutTwo => (i - n.dot(i) * n).normalize_or(n),
            Fault::MirrorSign => (i + 2.0 * n.dot(i) * n).normalize_or(n),
            Fault::MirrorFromLight => -(i - 2.0 * n.dot(i) * n).normalize_or(n),
            Fault::MirrorUnnormalized => i - 2.0 * n.dot(i) * n,
            _ => (i - 2.0 * n.dot(i) * n).normalize(),
        }
    }

    // Chapter 11's pool, where bodies are in one another.

    fn is_pool(&self) -> bool {
        self.scene.level == Level::Absorbs && self.scene.objects[0].name == "the ground"
    }

    /// Returns the index of refraction and the absorption at a point; `known` says of one object
    /// whether its inside is meant.
    fn medium(&self, point: Vec3, known: Option<(usize, bool)>) -> (f32, Vec3) {
        let objects = self.scene.objects.iter().enumerate().rev();
        for (index, object) in objects {
            let Optics::Glass { inside, .. } = object.material.optics else {
                continue;
            };
            let is_in = match (known, object.shape) {
                (Some((other, is_in)), _) if other == index => is_in,
                (_, Shape::Sphere { centre, radius }) => {
                    point.distance_squared(centre) < radius * radius
                }
                (
                    _,
                    Shape::Plane {
                        point: origin,
                        normal,
                    },
                ) => {
                    !self.is(Fault::PlaneWithoutInside)
                        && (point - origin).dot(normal) < 0.0
                }
            };
            if is_in {
                return (inside, object.material.absorption);
            }
        }
        (1.0, Vec3::ZERO)
    }

    /// Returns what the media along a stretch without opaque bodies transmit.
    fn through_media(&self, ray: &Ray, distance: f32) -> Vec3 {
        let mut ray = *ray;
        let mut left = distance;
        let mut transmitted = Vec3::ONE;
        for _ in 0..16 {
            let nearest = (0..self.scene.objects.len())
                .filter(|&index| self.is_clear(index))
                .filter_map(|index| Some((index, self.distance(&ray, index, left)?)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            let stretch = nearest.map_or(left, |(_, t)| t);
            let (_, absorption) = self.medium(ray.at(0.5 * stretch), None);
            transmitted *= self.absorbed(absorption, stretch);
            let Some((index, t)) = nearest else { break };
            let hit = self.hit(&ray, index, t);
            ray = Ray {
                origin: self.projected(&hit),
                direction: hit.incident,
                from: Some((index, hit.outward.dot(hit.incident) < 0.0)),
            };
            left -= t;
        }
        transmitted
    }

    fn pool_radiance(&self, ray: &Ray, depth: u32, throughput: f32) -> Vec3 {
        let mut ray = *ray;
        let mut transmitted = Vec3::ONE;
        for _ in 0..16 {
            let hit = self.nearest(&ray);
            let stretch = hit.as_ref().map_or(FAR, |hit| hit.t);
            let known = ray.from.filter(|&(i, _)| {
                matches!(self.scene.objects[i].shape, Shape::Plane { .. })
            });
            let (_, absorption) = self.medium(ray.at(0.5 * stretch), known);
            if absorption != Vec3::ZERO {
                transmitted *= self.absorbed(absorption, stretch);
            }
            let Some(hit) = hit else {
                return transmitted * self.scene.background;
            };
            let optics = self.scene.objects[hit.index].material.optics;
            let clear = match optics {
                Optics::Glass { inside, outside } if self.is_clear(hit.index) => {
                    Some((inside, outside))
                }
                _ => None,
            };
            let Some((mut inside, mut outside)) = clear else {
                let (seen, keeps) =
                    self.scattered(&hit, depth, throughput * transmitted.max_element());
                return transmitted * (keeps * self.shade(&hit) + seen);
            };
            if !self.is(Fault::Alone) {
                inside = self.medium(hit.point, Some((hit.index, true))).0;
                outside = self.medium(hit.point, Some((hit.index, false))).0;
                if inside == outside {
                    ray = self.spawn(&hit, hit.incident);
                    continue;
                }
            }
            let throughput = throughput * transmitted.max_element();
            let seen = self.through(&hit, [inside, outside], depth, throughput);
            return transmitted * (self.shade(&hit) + seen);
        }
        Vec3::ZERO
    }
}

fn exp(absorption: Vec3, distance: f32) -> Vec3 {
    (-absorption * distance).map(f32::exp)
}

/// Returns a power by repeated squaring.
fn powi(base: f32, exponent: u32) -> f32 {
    let (mut result, mut square, mut bits) = (1.0, base, exponent);
    while bits > 0 {
        if bits & 1 == 1 {
            result *= square;
        }
        square *= square;
        bits >>= 1;
    }
    result
}

/// Returns the refracted direction; `None` for total internal reflection.
fn refract(incident: Vec3, normal: Vec3, eta: f32) -> Option<Vec3> {
    if eta == 1.0 {
        return Some(incident);
    }
    let cos_i = -normal.dot(incident);
    let tangential = incident + cos_i * normal;
    let sin2_t = eta * eta * tangential.dot(tangential);
    if !(sin2_t < 1.0) {
        return None;
    }
    let cos_t = (1.0 - sin2_t).sqrt();
    Some((eta * tangential - cos_t * normal).normalize())
}

// Pictures that are not of light.
impl Tracer<'_> {
    /// Returns the outward normal where a ray hits; `None` if it hits nothing.
    #[must_use]
    pub fn normal(&self, ray: &Ray) -> Option<Vec3> {
        Some(self.nearest(ray)?.outward)
    }

    /// Returns the reflectance where a ray hits glass, as grey, or else `backdrop`.
    #[must_use]
    pub fn reflectance_seen(&self, ray: &Ray, backdrop: Vec3) -> Vec3 {
        let Some(hit) = self.nearest(ray) else {
            return backdrop;
        };
        let Optics::Glass { inside, outside } =
            self.scene.objects[hit.index].material.optics
        else {
            return backdrop;
        };
        let (eta_i, eta_t) = match (hit.enters, self.fault) {
            (true, Fault::RatioInverted) | (false, _) => (inside, outside),
            (true, _) => (outside, inside),
        };
        let cos = -hit.normal.dot(hit.incident);
        Vec3::splat(self.reflectance(cos, eta_i, eta_t))
    }
}
