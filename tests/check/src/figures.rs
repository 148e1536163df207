//! The pictures of the book, described once more.

use crate::fault::Fault;
use crate::image::Image;
use crate::levels::{decode, levels};
use crate::tracer::{
    Level, Material, Object, Optics, Ray, Region, Scene, Shape, Texture, Tracer,
};
use glam::{Vec2, Vec3, vec3};
use std::path::PathBuf;

/// A picture of the book.
#[derive(Clone)]
pub struct Figure {
    /// Its name, `06-reflection--bouncing--knob-2`, and those of other figures of the same thing.
    pub names: Vec<String>,
    /// What it shows.
    what: What,
    camera: Camera,
    sampler: Sampler,
    /// The bug that it shows on purpose.
    pub shows: Fault,
}

#[derive(Clone)]
enum What {
    Gradient,
    HalfLight,
    Directions,
    SkyAndGround,
    FirstSphere {
        is_normal: bool,
    },
    FromAfar,
    CheckeredFloor,
    Scene(Scene),
    InsideSphere {
        bounces: u32,
    },
    Reflectance(Scene),
    Dots,
    Lamp,
    /// Known by its pixels alone.
    Stored(Image),
}

/// What has a colour of its own: an object's even or odd squares. `None` is the sky.
pub type Part = Option<(usize, bool)>;

/// An eye, and what it looks along.
#[derive(Clone, Copy)]
struct Camera {
    eye: Vec3,
    forward: Vec3,
    focal: f32,
}

#[derive(Clone, Copy)]
enum Sampler {
    Regular(u32),
    Jittered(u32),
    Adaptive(u32),
    Clamped(u32),
}

const SKY: Vec3 = vec3(0.2, 0.5, 0.8);
const GROUND: Vec3 = vec3(0.25, 0.2, 0.15);
const DARK: Vec3 = Vec3::splat(0.1);
const LIGHT: Vec3 = Vec3::splat(0.9);
const BACKDROP: Vec3 = vec3(0.05, 0.1, 0.2);
const FOCAL: f32 = 1.0 + std::f32::consts::SQRT_2;
const DEPTH: u32 = 64;

impl Camera {
    /// Returns the ray through a point of the image plane.
    fn ray(self, point: Vec2, fault: Fault) -> Ray {
        let forward = match fault {
            Fault::LooksBack => -self.forward,
            Fault::NotTilted => Vec3::Z,
            Fault::TargetAsDirection => self.eye + self.forward,
            _ => self.forward,
        }
        .normalize_or(Vec3::Z);
        let right = Vec3::Y.cross(forward).normalize_or(Vec3::X);
        let up = match fault {
            Fault::UpNotTilted => Vec3::Y,
            _ => forward.cross(right),
        };
        let half = (1.0 / self.focal).atan();
        let focal = match fault {
            Fault::FocalTimes(factor) => self.focal * factor,
            Fault::FocalInverted => 1.0 / self.focal,
            Fault::WholeAngle => 1.0 / (2.0 * half).tan(),
            Fault::DegreesAsRadians => 1.0 / half.to_degrees().tan(),
            _ => self.focal,
        };
        if fault == Fault::Parallel {
            let origin = self.eye + point.x * right + point.y * up;
            return Ray::new(origin, forward);
        }
        let direction = point.x * right + point.y * up + focal * forward;
        let direction = match fault {
            Fault::NotNormalized(_) => direction,
            _ => direction.normalize(),
        };
        Ray::new(self.eye, direction)
    }
}

/// Returns the point of the image plane at a place in the picture, in pixels from the top left.
fn image_point(at: Vec2, size: [u32; 2], fault: Fault) -> Vec2 {
    let size = Vec2::new(size[0] as f32, size[1] as f32);
    let half = size / 2.0;
    let from_middle = Vec2::new(at.x - half.x, half.y - at.y);
    match fault {
        Fault::SquarePlane => from_middle / half,
        Fault::AspectInverted => from_middle / half * Vec2::new(half.y / half.x, 1.0),
        Fault::FitsWidth => from_middle / half.x,
        Fault::SizeLessOne => {
            let at = (at - 0.5) / (size - 1.0);
            Vec2::new(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y)
                * Vec2::new(half.x / half.y, 1.0)
        }
        _ => from_middle / half.y,
    }
}

impl Figure {
    /// Returns its first name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.names[0]
    }

    /// Returns whether it is described, and not known by its pixels alone: it can then be drawn at
    /// any size.
    #[must_use]
    pub fn is_described(&self) -> bool {
        !matches!(self.what, What::Stored(_))
    }

    /// Returns about how many rays a pixel takes.
    #[must_use]
    pub fn cost(&self) -> usize {
        match self.sampler {
            Sampler::Regular(n) | Sampler::Jittered(n) | Sampler::Clamped(n) => {
                (n * n) as usize
            }
            Sampler::Adaptive(n) => 4 + (n * n / 4) as usize,
        }
    }

    /// Returns the levels of a pixel in the figure drawn at this size with a fault; `Fault::None`
    /// is the figure as it is in the book.
    #[must_use]
    pub fn pixel(&self, [x, y]: [u32; 2], size: [u32; 2], fault: Fault) -> [u8; 3] {
        let fault = if fault == Fault::None {
            self.shows
        } else {
            fault
        };
        let [w, h] = size;
        let [x, y] = match fault {
            Fault::FlipX => [w - 1 - x, y],
            Fault::FlipY => [x, h - 1 - y],
            Fault::HalfTurn => [w - 1 - x, h - 1 - y],
            // The picture of h by w pixels, written row by row into one of w by h.
            Fault::Transposed => [y * w / h, x * h / w],
            Fault::Shift(dx, dy) => [
                x.saturating_add_signed(dx).min(w - 1),
                y.saturating_add_signed(dy).min(h - 1),
            ],
            _ => [x, y],
        };
        levels(self.mean([x, y], size, fault), fault)
    }

    /// Returns what a pixel shows of the scene: an object, and which lights reach it.
    #[must_use]
    pub fn region(&self, [x, y]: [u32; 2], size: [u32; 2]) -> Region {
        let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
        let point = image_point(at, size, Fault::None);
        let (What::Scene(scene) | What::Reflectance(scene)) = &self.what else {
            return None;
        };
        let tracer = Tracer::new(scene, Fault::None);
        tracer.region(&self.camera.ray(point, Fault::None))
    }

    /// Returns the same figure from an eye elsewhere, which looks elsewhere.
    #[must_use]
    pub fn from_elsewhere(&self, eye: Vec3, forward: Vec3) -> Self {
        let mut figure = self.clone();
        figure.camera.eye += eye;
        figure.camera.forward += forward;
        figure
    }

    /// Returns about how far what it shows is away from the eye.
    #[must_use]
    pub fn distance_to_look(&self) -> f32 {
        self.camera.forward.length()
    }

    /// Returns the same figure with another colour of one object; the squares of a checkered one
    /// are this colour and a tenth of it. `None` if there is no such object.
    #[must_use]
    pub fn in_colour(&self, object: usize, colour: Vec3) -> Option<Self> {
        let mut figure = self.clone();
        let What::Scene(scene) = &mut figure.what else {
            return None;
        };
        let material = &mut scene.objects.get_mut(object)?.material;
        material.colour = match material.colour {
            Texture::Solid(_) => Texture::Solid(colour),
            Texture::Checker(..) => Texture::Checker(0.1 * colour, colour),
        };
        Some(figure)
    }

    /// Returns the same figure with the colours of some of its [`parts`](Self::region) multiplied:
    /// of an object's even or odd squares, or of the sky. `None` if the figure has no scene.
    #[must_use]
    pub fn with_colours(&self, ratios: &[(Part, Vec3)]) -> Option<Self> {
        let mut figure = self.clone();
        let What::Scene(scene) = &mut figure.what else {
            return None;
        };
        for &(part, ratio) in ratios {
            let Some((index, is_odd)) = part else {
                scene.background *= ratio;
                continue;
            };
            match &mut scene.objects.get_mut(index)?.material.colour {
                Texture::Solid(colour) => *colour *= ratio,
                Texture::Checker(_, odd) if is_odd => *odd *= ratio,
                Texture::Checker(even, _) => *even *= ratio,
            }
        }
        Some(figure)
    }

    /// Returns whether the figure has objects whose colours may be others.
    #[must_use]
    pub fn has_scene(&self) -> bool {
        matches!(self.what, What::Scene(_))
    }

    /// Returns whether another camera would show something else.
    #[must_use]
    pub fn has_camera(&self) -> bool {
        !matches!(
            self.what,
            What::Gradient | What::HalfLight | What::Dots | What::Lamp | What::Stored(_)
        )
    }

    /// Returns the name of an object of the scene.
    #[must_use]
    pub fn object(&self, index: usize) -> &'static str {
        match &self.what {
            What::Scene(scene) | What::Reflectance(scene) => scene.objects[index].name,
            _ => "the picture",
        }
    }

    /// Returns the mean of a pixel's samples.
    fn mean(&self, [x, y]: [u32; 2], size: [u32; 2], fault: Fault) -> Vec3 {
        let corner = Vec2::new(x as f32, y as f32);
        let light = |in_pixel: Vec2| {
            let at = match fault {
                Fault::WidePixel(width) => corner + 0.5 + width * (in_pixel - 0.5),
                Fault::PixelPoint(point) => corner + in_pixel + point - 0.5,
                _ => corner + in_pixel,
            };
            self.light(image_point(at, size, fault), [x, y], size, fault)
        };
        let n = match (self.sampler, fault) {
            (_, Fault::OneSample) => 1,
            (Sampler::Regular(n), Fault::FewerSamples) if n > 1 => n / 2,
            (
                Sampler::Regular(n)
                | Sampler::Jittered(n)
                | Sampler::Adaptive(n)
                | Sampler::Clamped(n),
                _,
            ) => n,
        };
        let jittered = |n: u32| {
            let samples = (0..n * n).map(|i| {
                let a = hash(x ^ hash(y ^ hash(i)));
                let position =
                    Vec2::new((a >> 8) as f32, (hash(a) >> 8) as f32) / (1 << 24) as f32;
                let cell = Vec2::new((i % n) as f32, (i / n) as f32);
                let in_pixel = (cell + position) / n as f32;
                // The rows of cells go up.
                light(Vec2::new(in_pixel.x, 1.0 - in_pixel.y))
            });
            samples.collect::<Vec<_>>()
        };
        let in_cell = match fault {
            Fault::Corners if n > 1 => Vec2::ZERO,
            _ => Vec2::splat(0.5),
        };
        let regular = || {
            let samples = (0..n * n).map(|i| {
                let cell = Vec2::new((i % n) as f32, (i / n) as f32);
                light((cell + in_cell) / n as f32)
            });
            samples.collect::<Vec<_>>()
        };
        let adaptive = || {
            let first = jittered(2);
            let levels: Vec<_> = first.iter().map(|&l| levels(l, Fault::None)).collect();
            let differ = (0..3).any(|c| {
                let of = levels.iter().map(|level| level[c]);
                of.clone().max() > of.min().map(|least| least.saturating_add(8))
            });
            if differ { jittered(n) } else { first }
        };
        let mut samples = match (self.sampler, fault) {
            (_, Fault::OneSample | Fault::Corners | Fault::NotJittered) => regular(),
            (Sampler::Regular(8..), Fault::AdaptiveSamples) => adaptive(),
            (Sampler::Regular(_) | Sampler::Clamped(_), _) => regular(),
            (Sampler::Jittered(_), _) => jittered(n),
            (Sampler::Adaptive(_), _) => adaptive(),
        };
        let is_clamped = matches!(self.sampler, Sampler::Clamped(_))
            && fault != Fault::UnclampedSamples;
        if is_clamped || fault == Fault::ClampedSamples {
            samples
                .iter_mut()
                .for_each(|sample| *sample = sample.min(Vec3::ONE));
        }
        let count = samples.len() as f32;
        if fault == Fault::MeanOfLevels {
            let encoded =
                |&light: &Vec3| Vec3::from(levels(light, Fault::None).map(f32::from));
            let mean = samples.iter().map(encoded).sum::<Vec3>() / count;
            return mean.map(|level| decode(f64::from(level.round()) / 255.0) as f32);
        }
        samples.iter().sum::<Vec3>() / count
    }

    /// Returns the radiance at a point of the image plane.
    fn light(&self, point: Vec2, [x, y]: [u32; 2], size: [u32; 2], fault: Fault) -> Vec3 {
        let ray = || self.camera.ray(point, fault);
        match &self.what {
            What::Stored(image) => {
                let [w, h] = image.size;
                let at = [x * w / size[0], y * h / size[1]];
                Vec3::from_array(
                    image.pixel(at).map(|l| decode(f64::from(l) / 255.0) as f32),
                )
            }
            What::Gradient => {
                let right = (x as f32 + 0.5) / size[0] as f32;
                let up = 1.0 - (y as f32 + 0.5) / size[1] as f32;
                vec3(right, up, 0.25)
            }
            What::HalfLight => Vec3::splat(match 3 * x / size[0] {
                0 => ((x + y) % 2) as f32,
                1 => 0.5,
                _ => 0.215_860_5,
            }),
            What::Directions => (ray().direction + Vec3::ONE) / 2.0,
            What::SkyAndGround => sky_and_ground(&ray()),
            What::FirstSphere { is_normal } => {
                let scene = one_sphere(vec3(-2.2, 0.8, 1.0), 0.8);
                let normal = Tracer::new(&scene, fault).normal(&ray());
                match normal {
                    Some(normal) if *is_normal => (normal + Vec3::ONE) / 2.0,
                    Some(_) => vec3(0.9, 0.15, 0.1),
                    None => sky_and_ground(&ray()),
                }
            }
            What::FromAfar => {
                let scene = one_sphere(Vec3::ZERO, 1.0);
                let normal = Tracer::new(&scene, fault).normal(&ray());
                normal.map_or(SKY, |normal| (normal + Vec3::ONE) / 2.0)
            }
            What::CheckeredFloor => {
                let ray = ray();
                let t = (-1.0 - ray.origin.y) / ray.direction.y;
                if !(t > 0.0) || fault == Fault::NoFloor {
                    return SKY;
                }
                let point = ray.origin + t * ray.direction;
                let scene = one_sphere(Vec3::ZERO, 1.0);
                let tracer = Tracer::new(&scene, fault);
                let is_odd = tracer.is_even(Vec2::new(point.x, point.z), point);
                // In space the cubes at the odd height −1 have changed places.
                if is_odd != (fault == Fault::CheckerInSpace) {
                    LIGHT
                } else {
                    DARK
                }
            }
            What::Scene(scene) => Tracer::new(scene, fault).trace(&ray()),
            What::Reflectance(scene) => {
                Tracer::new(scene, fault).reflectance_seen(&ray(), BACKDROP)
            }
            What::InsideSphere { bounces } => inside_sphere(&ray(), *bounces, fault),
            What::Dots => {
                let apart = 8.3 * (2.0 / 240.0);
                let cell = point / apart;
                let to_dot = (cell - cell.floor() - Vec2::splat(0.5)) * apart;
                Vec3::splat(f32::from(to_dot.length() < 0.25 * (2.0 / 240.0)))
            }
            What::Lamp => {
                if point.length() < 0.5 {
                    Vec3::splat(100.0)
                } else {
                    0.1 * SKY
                }
            }
        }
    }
}

fn sky_and_ground(ray: &Ray) -> Vec3 {
    if ray.direction.y > 0.0 { SKY } else { GROUND }
}

fn hash(mut x: u32) -> u32 {
    x = x.wrapping_add(0x9e37_79b9);
    x ^= x >> 16;
    x = x.wrapping_mul(0x21f0_aaad);
    x ^= x >> 15;
    x = x.wrapping_mul(0xd35a_2d97);
    x ^ (x >> 15)
}

fn inside_sphere(ray: &Ray, bounces: u32, fault: Fault) -> Vec3 {
    let reflect = |incident: Vec3, normal: Vec3| match fault {
        Fault::MirrorUnnormalized => incident - 2.0 * normal.dot(incident) * normal,
        Fault::MirrorWithoutTwo => (incident - normal.dot(incident) * normal).normalize(),
        _ => (incident - 2.0 * normal.dot(incident) * normal).normalize(),
    };
    let scene = one_sphere(Vec3::ZERO, 1.0);
    let tracer = Tracer::new(&scene, Fault::None);
    let Some(normal) = tracer.normal(ray) else {
        return Vec3::ZERO;
    };
    let mut direction = reflect(ray.direction, normal);
    let mut origin = normal;
    for _ in 0..bounces {
        let b = direction.dot(origin);
        let discriminant = b * b - (origin.dot(origin) - 1.0);
        let point = origin + (-b + discriminant.sqrt()) * direction;
        direction = reflect(direction, point);
        origin = point;
    }
    if !((origin.length() - 1.0).abs() < 0.1) {
        return Vec3::ZERO;
    }
    let colour = (origin + Vec3::ONE) / 2.0;
    let uv = 6.0 * Vec2::new(origin.x, origin.y);
    let tracer = Tracer::new(&scene, fault);
    if tracer.is_even(uv, origin) {
        colour
    } else {
        0.6 * colour
    }
}

// Materials and scenes.

fn phong(
    colour: Texture,
    [ambient, diffuse, specular]: [f32; 3],
    shininess: u32,
) -> Material {
    Material {
        colour,
        ambient,
        diffuse,
        specular,
        shininess,
        optics: Optics::Mirror(0.0),
        absorption: Vec3::ZERO,
    }
}

fn solid(r: f32, g: f32, b: f32) -> Texture {
    Texture::Solid(vec3(r, g, b))
}

fn grey(value: f32) -> Texture {
    Texture::Solid(Vec3::splat(value))
}

fn sphere(
    name: &'static str,
    [x, y, z]: [f32; 3],
    radius: f32,
    material: Material,
) -> Object {
    let shape = Shape::Sphere {
        centre: vec3(x, y, z),
        radius,
    };
    Object {
        name,
        shape,
        material,
    }
}

fn plane(name: &'static str, point: Vec3, normal: Vec3, material: Material) -> Object {
    let shape = Shape::Plane { point, normal };
    Object {
        name,
        shape,
        material,
    }
}

fn one_sphere(centre: Vec3, radius: f32) -> Scene {
    let material = phong(grey(1.0), [0.0; 3], 1);
    Scene {
        objects: vec![sphere("the ball", centre.to_array(), radius, material)],
        lights: vec![],
        background: SKY,
        level: Level::Flat,
        depth: 0,
        bias: None,
    }
}

fn still_life(level: Level) -> Scene {
    let plastic = |colour, specular, n| phong(colour, [0.1, 0.8, specular], n);
    let mut mirror = plastic(grey(0.6), 0.8, 200);
    let mut green = plastic(solid(0.1, 0.7, 0.2), 0.5, 50);
    let mut glass = plastic(solid(0.55, 0.75, 0.8), 0.8, 200);
    if level >= Level::Mirrors {
        mirror = phong(grey(0.9), [0.02, 0.1, 0.8], 200);
        mirror.optics = Optics::Mirror(0.8);
        green.optics = Optics::Mirror(0.2);
    }
    if level >= Level::Refracts {
        glass = phong(grey(1.0), [0.0, 0.0, 0.8], 200);
        glass.optics = Optics::Glass {
            inside: 1.5,
            outside: 1.0,
        };
    }
    if level == Level::Absorbs {
        glass.absorption = vec3(0.1, 0.7, 2.5);
    }
    let floor = plastic(Texture::Checker(DARK, LIGHT), 0.0, 1);
    Scene {
        objects: vec![
            plane("the floor", Vec3::ZERO, Vec3::Y, floor),
            sphere(
                "the red ball",
                [-2.2, 0.8, 1.0],
                0.8,
                plastic(solid(0.9, 0.15, 0.1), 0.5, 50),
            ),
            sphere("the mirror ball", [0.2, 1.2, 2.0], 1.2, mirror),
            sphere("the green ball", [2.3, 0.7, 0.6], 0.7, green),
            sphere(
                "the blue ball",
                [-0.8, 0.4, -1.0],
                0.4,
                plastic(solid(0.15, 0.2, 0.9), 0.8, 100),
            ),
            sphere("the glass ball", [0.9, 0.6, -1.2], 0.6, glass),
        ],
        lights: vec![(vec3(-5.0, 7.0, -6.0), 0.6), (vec3(4.0, 6.0, -4.0), 0.4)],
        background: SKY,
        level,
        depth: DEPTH,
        bias: (level < Level::Remembers).then_some(1e-4),
    }
}

fn with_glass(mut scene: Scene, [inside, outside]: [f32; 2]) -> Scene {
    scene.objects[5].material.optics = Optics::Glass { inside, outside };
    scene
}

fn with_materials(mut scene: Scene, change: impl Fn(&mut Material)) -> Scene {
    scene
        .objects
        .iter_mut()
        .for_each(|object| change(&mut object.material));
    scene
}

fn with_depth(mut scene: Scene, depth: u32) -> Scene {
    scene.depth = depth;
    scene
}

fn light_between_balls() -> Scene {
    let ball = |name, height, r, g, b| {
        let material = phong(solid(r, g, b), [0.0; 3], 1);
        sphere(name, [0.0, height, 0.0], 0.5, material)
    };
    Scene {
        objects: vec![
            plane(
                "the floor",
                Vec3::ZERO,
                Vec3::Y,
                phong(grey(0.7), [0.0; 3], 1),
            ),
            ball("the lower ball", 0.5, 0.9, 0.3, 0.05),
            ball("the upper ball", 3.0, 0.1, 0.5, 0.6),
        ],
        lights: vec![(vec3(0.7, 2.0, 0.0), 1.0)],
        ..still_life(Level::Shadows)
    }
}

fn facing_mirrors(depth: u32) -> Scene {
    let plain = |colour| phong(colour, [0.1, 0.8, 0.3], 50);
    let wall = |name, x: f32| {
        let mut material = phong(grey(0.9), [0.02, 0.03, 0.0], 1);
        material.optics = Optics::Mirror(0.9);
        plane(name, x * Vec3::X, -x.signum() * Vec3::X, material)
    };
    Scene {
        objects: vec![
            plane(
                "the floor",
                Vec3::ZERO,
                Vec3::Y,
                plain(Texture::Checker(DARK, LIGHT)),
            ),
            wall("the left mirror", -3.0),
            wall("the right mirror", 3.0),
            sphere(
                "the ball",
                [0.0, 0.8, 0.3],
                0.8,
                plain(solid(0.9, 0.15, 0.1)),
            ),
        ],
        lights: vec![(vec3(0.5, 5.0, -2.0), 0.9)],
        depth,
        ..still_life(Level::Mirrors)
    }
}

fn planet(scale: f32) -> Scene {
    let plastic = |colour, reflectivity| {
        let mut material = phong(colour, [0.1, 0.8, 0.3], 50);
        material.optics = Optics::Mirror(reflectivity);
        material
    };
    let ball = |name, [x, height, z]: [f32; 3], radius: f32, material| {
        let centre = scale * vec3(x, height + radius, z);
        sphere(name, centre.to_array(), scale * radius, material)
    };
    let red = plastic(solid(0.9, 0.15, 0.1), 0.0);
    let blue = plastic(solid(0.15, 0.2, 0.9), 0.0);
    Scene {
        objects: vec![
            ball(
                "the planet",
                [0.0, -2000.0, 0.0],
                1000.0,
                plastic(grey(0.6), 0.0),
            ),
            ball("the large ball", [0.0, 0.0, 1.2], 1.0, red),
            ball(
                "the mirror ball",
                [-1.4, 0.0, 0.0],
                0.5,
                plastic(grey(0.1), 0.8),
            ),
            ball("the small ball", [0.5, 0.0, -1.4], 0.05, blue),
            ball("the tiny ball", [0.4, 0.0, -1.45], 0.005, blue),
            ball("the hovering ball", [0.7, 0.002, -1.5], 0.05, red),
        ],
        lights: vec![(scale * vec3(-3.0, 4.0, -4.0), 1.0)],
        ..still_life(Level::Remembers)
    }
}

fn pool() -> Scene {
    let surface = |colour, diffuse: f32, specular| {
        phong(colour, [0.1 * diffuse, diffuse, specular], 200)
    };
    let clear = |inside, absorption| {
        let mut material = surface(grey(1.0), 0.0, 0.8);
        material.optics = Optics::Glass {
            inside,
            outside: 1.0,
        };
        material.absorption = absorption;
        material
    };
    let tiles = Texture::Checker(vec3(0.5, 0.6, 0.7), LIGHT);
    let amber = vec3(0.1, 0.7, 2.5);
    let water = clear(1.33, vec3(0.5, 0.1, 0.15));
    Scene {
        objects: vec![
            plane("the ground", Vec3::NEG_Y, Vec3::Y, surface(tiles, 0.8, 0.0)),
            sphere(
                "the red ball",
                [-1.7, -0.5, 1.2],
                0.5,
                surface(solid(0.9, 0.15, 0.1), 0.8, 0.0),
            ),
            plane("the water", Vec3::ZERO, Vec3::Y, water),
            sphere("the ice", [-0.5, 0.0, -0.4], 0.6, clear(1.31, Vec3::ZERO)),
            sphere("the glass ball", [0.9, -0.3, 0.0], 0.7, clear(1.5, amber)),
            sphere("the bubble", [0.9, -0.3, 0.0], 0.35, clear(1.0, Vec3::ZERO)),
        ],
        lights: vec![(vec3(-4.0, 6.0, -3.0), 0.6), (vec3(3.0, 5.0, -2.0), 0.4)],
        ..still_life(Level::Absorbs)
    }
}

/// Returns every figure of the book, with the `stored` ones that are not described.
///
/// A stored picture is given by its name and its pixels.
#[must_use]
pub fn figures(stored: Vec<(String, Image)>) -> Vec<Figure> {
    let still = Camera {
        eye: vec3(0.0, 2.0, -7.0),
        forward: vec3(0.0, -1.1, 7.0),
        focal: FOCAL,
    };
    let focused = |focal| Camera { focal, ..still };
    let look = |eye: Vec3, at: Vec3, focal| Camera {
        eye,
        forward: at - eye,
        focal,
    };
    let close = look(vec3(0.7, 1.2, -4.2), vec3(0.9, 0.6, -1.2), 3.4);
    let horizon = Camera {
        forward: vec3(0.0, -0.6, 7.0),
        focal: 5.0,
        ..still
    };
    let mut figures = Vec::new();
    let mut add_shown = |names: &str, what, camera, sampler, shows| {
        figures.push(Figure {
            names: names.split(' ').map(str::to_string).collect(),
            what,
            camera,
            sampler,
            shows,
        });
    };
    let one = Sampler::Regular(1);
    let mut add =
        |names: &str, what, camera| add_shown(names, what, camera, one, Fault::None);
    add("00-canvas--gradient", What::Gradient, still);
    add("00-canvas--half-light", What::HalfLight, still);
    add(
        "01-ray-casting--directions 13-interactive--ray-casting",
        What::Directions,
        still,
    );
    add(
        "01-ray-casting--directions--knob-0_5",
        What::Directions,
        focused(0.5),
    );
    add("01-ray-casting--sky-and-ground", What::SkyAndGround, still);
    add(
        "01-ray-casting--sky-and-ground--knob-0_5",
        What::SkyAndGround,
        focused(0.5),
    );
    add(
        "02-sphere-hit--flat 13-interactive--sphere-hit",
        What::FirstSphere { is_normal: false },
        still,
    );
    add(
        "02-sphere-hit--normals",
        What::FirstSphere { is_normal: true },
        still,
    );
    let scene = |level| What::Scene(still_life(level));
    add(
        "03-plane-hit--flat 13-interactive--plane-hit",
        scene(Level::Flat),
        still,
    );
    add(
        "03-plane-hit--checker-in-plane",
        What::CheckeredFloor,
        still,
    );
    add(
        "04-shadows--hard 13-interactive--shadows",
        scene(Level::Shadows),
        still,
    );
    let between = look(vec3(0.0, 2.5, -8.0), vec3(0.3, 1.5, 0.0), 3.0);
    add(
        "04-shadows--beyond",
        What::Scene(light_between_balls()),
        between,
    );
    add(
        "05-shading--combined 13-interactive--shading",
        scene(Level::Shaded),
        still,
    );
    let changed = |change: fn(&mut Material)| {
        What::Scene(with_materials(still_life(Level::Shaded), change))
    };
    add(
        "05-shading--ambient",
        changed(|m| (m.diffuse, m.specular) = (0.0, 0.0)),
        still,
    );
    add(
        "05-shading--diffuse",
        changed(|m| (m.ambient, m.specular) = (0.0, 0.0)),
        still,
    );
    for (name, n) in [
        ("", 50),
        ("--knob-1", 1),
        ("--knob-10", 10),
        ("--knob-200", 200),
    ] {
        let scene = with_materials(still_life(Level::Shaded), |m| {
            (m.ambient, m.diffuse, m.shininess) = (0.0, 0.0, n);
        });
        add(
            &format!("05-shading--specular{name}"),
            What::Scene(scene),
            still,
        );
    }
    add(
        "06-reflection--bouncing 13-interactive--reflection",
        scene(Level::Mirrors),
        still,
    );
    for (name, depth) in [
        ("bouncing--knob-0", 0),
        ("one-bounce", 1),
        ("bouncing--knob-2", 2),
    ] {
        let scene = with_depth(still_life(Level::Mirrors), depth);
        add(&format!("06-reflection--{name}"), What::Scene(scene), still);
    }
    let between_mirrors = look(vec3(2.7, 1.9, -1.6), vec3(-3.0, 0.9, 0.7), 1.5);
    for (name, depth) in [("", 64), ("--knob-5", 5), ("--knob-20", 20)] {
        let what = What::Scene(facing_mirrors(depth));
        add(
            &format!("06-reflection--facing-mirrors{name}"),
            what,
            between_mirrors,
        );
    }
    let glass = |level, indices| What::Scene(with_glass(still_life(level), indices));
    add(
        "07-refraction--glass 13-interactive--refraction",
        scene(Level::Refracts),
        still,
    );
    for (name, index) in [
        ("", 1.5),
        ("--knob-1", 1.0),
        ("--knob-1_33", 1.33),
        ("--knob-2_42", 2.42),
    ] {
        let what = glass(Level::Refracts, [index, 1.0]);
        add(&format!("07-refraction--ball{name}"), what, close);
    }
    add(
        "07-refraction--bubble",
        glass(Level::Refracts, [1.0, 1.5]),
        close,
    );
    add(
        "08-fresnel--still-life 13-interactive--fresnel",
        scene(Level::Reflects),
        still,
    );
    add(
        "10-shadow-acne--still-life 12-packets--still-life",
        scene(Level::Remembers),
        still,
    );
    for (name, index) in [("--knob-1", 1.0), ("--knob-2_42", 2.42)] {
        let what = glass(Level::Reflects, [index, 1.0]);
        add(&format!("08-fresnel--still-life{name}"), what, still);
    }
    let reflectance =
        |indices| What::Reflectance(with_glass(still_life(Level::Reflects), indices));
    for (name, index) in [("", 1.5), ("--knob-1_33", 1.33), ("--knob-2_42", 2.42)] {
        let what = reflectance([index, 1.0]);
        add(&format!("08-fresnel--reflectance{name}"), what, close);
    }
    add("08-fresnel--leaving", reflectance([1.0, 1.5]), close);
    for (name, scale) in [
        ("", 1.0),
        ("--knob-0_001", 1e-3),
        ("--knob-1000", 1e3),
        ("--knob-1000000", 1e6),
    ] {
        let planet = planet(scale);
        let mut camera = look(vec3(0.4, 0.9, -3.6), vec3(-0.1, 0.35, 0.0), 2.0);
        camera.eye *= scale;
        add(
            &format!("10-shadow-acne--from-surface{name}"),
            What::Scene(planet),
            camera,
        );
    }
    for (name, times) in [("", 1.0), ("--knob-0", 0.0), ("--knob-4", 4.0)] {
        let amber = || {
            What::Scene(with_materials(still_life(Level::Absorbs), |m| {
                m.absorption *= times
            }))
        };
        add(
            &format!("11-transparency--still-life{name}"),
            amber(),
            still,
        );
        add(&format!("11-transparency--ball{name}"), amber(), close);
    }
    let above_pool = look(vec3(0.1, 1.7, -4.0), vec3(0.05, -0.15, 0.0), 3.4);
    add(
        "11-transparency--displaced",
        What::Scene(pool()),
        above_pool,
    );

    for n in [4, 1, 2, 10, 20] {
        let name = match n {
            4 => "09-anti-aliasing--grid".to_string(),
            n => format!("09-anti-aliasing--grid--knob-{n}"),
        };
        add_shown(
            &name,
            scene(Level::Reflects),
            still,
            Sampler::Regular(n),
            Fault::None,
        );
    }
    add_shown(
        "12-packets--still-life--knob-4 13-interactive--still-life",
        scene(Level::Remembers),
        still,
        Sampler::Regular(4),
        Fault::None,
    );
    let floor = || {
        let mut scene = still_life(Level::Flat);
        scene.objects.truncate(1);
        What::Scene(scene)
    };
    let mut sampled = |name: &str, what, camera, sampler| {
        add_shown(
            &format!("09-anti-aliasing--{name}"),
            what,
            camera,
            sampler,
            Fault::None,
        );
    };
    sampled(
        "jittered",
        scene(Level::Reflects),
        still,
        Sampler::Jittered(4),
    );
    sampled(
        "adaptive",
        scene(Level::Reflects),
        still,
        Sampler::Adaptive(4),
    );
    sampled("horizon-grid", floor(), horizon, Sampler::Regular(4));
    sampled("horizon-jittered", floor(), horizon, Sampler::Jittered(4));
    sampled("light", floor(), horizon, Sampler::Regular(8));
    sampled("dots-grid", What::Dots, still, Sampler::Regular(8));
    sampled("dots-adaptive", What::Dots, still, Sampler::Adaptive(8));
    sampled("lamp-grid", What::Lamp, still, Sampler::Regular(8));
    sampled("lamp-clamped", What::Lamp, still, Sampler::Clamped(8));

    // The book's bugs, on purpose.
    for (name, what, shows) in [
        ("00-canvas--gloomy", What::Gradient, Fault::Linear),
        (
            "01-ray-casting--upside-down",
            What::SkyAndGround,
            Fault::FlipY,
        ),
        (
            "05-shading--too-much-light",
            scene(Level::Shaded),
            Fault::StrongSurfaces,
        ),
    ] {
        add_shown(name, what, still, one, shows);
    }
    let afar = |distance: f32| {
        let to_centre = 1.0 + distance;
        Camera {
            eye: vec3(0.0, 0.0, -to_centre),
            forward: Vec3::Z,
            focal: 0.8 * (to_centre * to_centre - 1.0).sqrt(),
        }
    };
    for (name, distance) in [
        ("", 1e3),
        ("--knob-10", 10.0),
        ("--knob-100", 100.0),
        ("--knob-10000", 1e4),
        ("--knob-1000000", 1e6),
    ] {
        for (view, shows) in
            [("stable", Fault::None), ("textbook", Fault::TextbookSphere)]
        {
            let name = format!("02-sphere-hit--far-{view}{name}");
            add_shown(&name, What::FromAfar, afar(distance), one, shows);
        }
    }
    add_shown(
        "03-plane-hit--checker-in-space",
        What::CheckeredFloor,
        still,
        one,
        Fault::CheckerInSpace,
    );
    add_shown(
        "04-shadows--none",
        scene(Level::Shadows),
        still,
        one,
        Fault::NoShadows,
    );
    add_shown(
        "04-shadows--beyond-buggy",
        What::Scene(light_between_balls()),
        between,
        one,
        Fault::BeyondLight,
    );
    let inside = Camera {
        eye: vec3(0.0, 0.0, -0.6),
        forward: Vec3::Z,
        focal: 1.0,
    };
    for (name, bounces) in [("", 6), ("--knob-3", 3), ("--knob-5", 5), ("--knob-10", 10)]
    {
        for (view, shows) in [
            ("stable", Fault::None),
            ("textbook", Fault::MirrorUnnormalized),
        ] {
            let name = format!("06-reflection--inside-{view}{name}");
            add_shown(&name, What::InsideSphere { bounces }, inside, one, shows);
        }
    }
    add_shown(
        "07-refraction--failed-ratio",
        glass(Level::Refracts, [1.5, 1.0]),
        close,
        one,
        Fault::RatioSame,
    );
    add_shown(
        "07-refraction--failed-total",
        glass(Level::Refracts, [1.0, 1.5]),
        close,
        one,
        Fault::TotalBlack,
    );
    add_shown(
        "08-fresnel--leaving-schlick",
        reflectance([1.0, 1.5]),
        close,
        one,
        Fault::SchlickWrongCosine,
    );
    add_shown(
        "09-anti-aliasing--levels",
        floor(),
        horizon,
        Sampler::Regular(8),
        Fault::MeanOfLevels,
    );
    for (name, scale) in [
        ("", 1.0),
        ("--knob-0_001", 1e-3),
        ("--knob-1000", 1e3),
        ("--knob-1000000", 1e6),
    ] {
        let mut camera = look(vec3(0.4, 0.9, -3.6), vec3(-0.1, 0.35, 0.0), 2.0);
        camera.eye *= scale;
        for (view, shows) in [("acne", Fault::NoBias), ("fixed", Fault::Bias(1e-4))] {
            let name = format!("10-shadow-acne--{view}{name}");
            add_shown(&name, What::Scene(planet(scale)), camera, one, shows);
        }
    }
    add_shown(
        "11-transparency--alone",
        What::Scene(pool()),
        above_pool,
        one,
        Fault::Alone,
    );
    for (name, image) in stored {
        if !figures.iter().any(|figure| figure.names.contains(&name)) {
            figures.push(Figure {
                names: vec![name],
                what: What::Stored(image),
                camera: still,
                sampler: one,
                shows: Fault::None,
            });
        }
    }
    figures
}

/// Returns the folder of the book's pictures.
#[must_use]
pub fn folder() -> PathBuf {
    PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../book/src/pictures"
    ))
}
