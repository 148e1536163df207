//! A trial of methods that spawn rays: how often a ray that leaves a surface hits an object
//! that it should not hit, or misses one that it should.
//!
//! The scene provokes shadow acne: on a planet, or on a plane, balls of radius 1, 1/20 and
//! 1/200, one that hovers 0.002 above the ground and one that nearly touches it. It is
//! scaled, and moved away from the origin of the world, so that its numbers have fewer bits
//! left. The shadow ray or the reflected ray of every camera ray is compared with the exact
//! one.

use canvas::Pixel;
use glam::{DVec3, UVec2, Vec3, dvec3};
use plane_hit::{Object, Plane, Shape, nearest_by};
use ray_casting::{Camera, Ray};
use reflection::reflect;
use shadow_acne::{SpawnRay, SurfaceRay, untracked};
use shadows::Interaction;
use sphere_hit::{Sphere, T_MAX, face_forward};

/// A method that spawns a ray from a surface.
#[derive(Clone, Copy, Debug)]
pub enum Method {
    /// One of the chapter's functions.
    Spawn(SpawnRay),
    /// A fixed offset of this length.
    Offset(f32),
}

impl Method {
    fn spawn(self, at: &Interaction, direction: Vec3) -> SurfaceRay {
        match self {
            Self::Spawn(spawn) => spawn(at, direction),
            Self::Offset(length) => {
                let normal = face_forward(at.outward, -direction);
                let origin = at.point + length * normal;
                untracked(Ray { origin, direction })
            }
        }
    }
}

/// The ground of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ground {
    /// The plane y = 0.
    Plane,
    /// A ball of radius 1000 whose top is the origin of the scene.
    Sphere,
}

/// The ray that leaves the hit of a camera ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Secondary {
    /// Towards the light, if that is in front of the surface.
    Shadow,
    /// Reflected.
    Reflection,
}

/// A variant of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Configuration {
    /// The ground of the scene.
    pub ground: Ground,
    /// The rays that leave its surfaces.
    pub secondary: Secondary,
    /// Whether spheres are intersected in f64; points remain in f32.
    pub is_f64: bool,
    /// Its size, as a factor.
    pub scale: f64,
    /// Its distance from the origin of the world, in its own units.
    pub distance: f64,
}

/// The results of a method in a configuration, in pixels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// The exact ray hits nothing.
    pub clear: usize,
    /// Of those, the method's ray hits something.
    pub false_hits: usize,
    /// The exact ray hits something.
    pub occluded: usize,
    /// Of those, the method's ray hits nothing, or another object, but not its own.
    pub leaks: usize,
    /// The method's ray hits the surface that it leaves, which is convex, from outside.
    pub self_hits: usize,
    /// The camera ray hits another object than the exact one. Nothing else is counted for
    /// these pixels.
    pub primary_mismatches: usize,
}

impl Tally {
    fn add(&mut self, own: usize, exact: Option<usize>, ours: Option<usize>) {
        self.self_hits += usize::from(ours == Some(own));
        if exact.is_none() {
            self.clear += 1;
            self.false_hits += usize::from(ours.is_some());
        } else {
            self.occluded += 1;
            self.leaks += usize::from(ours != exact && ours != Some(own));
        }
    }

    /// Returns the false hits, in percent of the clear pixels.
    #[must_use]
    pub fn false_hits(&self) -> f64 {
        100.0 * self.false_hits as f64 / self.clear as f64
    }

    /// Returns the leaks, in percent of the occluded pixels.
    #[must_use]
    pub fn leaks(&self) -> f64 {
        100.0 * self.leaks as f64 / self.occluded as f64
    }
}

const SIZE: UVec2 = UVec2::new(240, 180);

/// A configuration's scene in f32, and the rays that leave its surfaces.
pub struct Trial {
    configuration: Configuration,
    objects: Vec<Object<()>>,
    /// The same shapes, exactly.
    exact: Vec<oracle::Shape>,
    light: Vec3,
    rays: Vec<SecondaryRay>,
    primary_mismatches: usize,
}

/// A ray that is about to leave the hit of a camera ray.
pub struct SecondaryRay {
    at: Interaction,
    direction: Vec3,
    /// The distance up to which its hits matter.
    t_max: f32,
    /// The index of the object that the exact ray hits first.
    exact: Option<usize>,
}

impl Configuration {
    /// Returns the scene of this configuration, with a secondary ray for each pixel that has
    /// one.
    ///
    /// # Panics
    /// If the scale is not positive, or if f32 cannot represent the scene.
    #[must_use]
    pub fn trial(self) -> Trial {
        let away = dvec3(0.64, 0.48, -0.6);
        let at = |p: DVec3| (self.scale * (p + self.distance * away)).as_vec3();
        let ball =
            |centre, radius: f64| Shape::sphere(at(centre), (self.scale * radius) as f32);
        let pole = dvec3(0.0, -1000.0, 0.0);
        let ground = match self.ground {
            Ground::Plane => Shape::plane(at(DVec3::ZERO), Vec3::Y),
            Ground::Sphere => ball(pole, 1000.0),
        };
        // A ball above (x, z), with a gap of `air` between it and the ground.
        let resting = |x, z, radius, air| {
            let height = radius + air;
            let centre = match self.ground {
                Ground::Plane => dvec3(x, height, z),
                Ground::Sphere => {
                    pole + (1000.0 + height) * dvec3(x, 1000.0, z).normalize()
                }
            };
            ball(centre, radius)
        };
        let shapes = [
            ground,
            resting(0.0, 1.2, 1.0, 0.0),
            resting(0.5, -1.4, 0.05, 0.0),
            resting(0.4, -1.45, 0.005, 0.0),
            resting(0.7, -1.5, 0.05, 0.002),
            resting(0.25, -1.3, 0.05, 0.0001),
        ];
        let object = |shape| Object {
            name: "",
            shape,
            material: (),
        };
        let eye = dvec3(0.4, 0.9, -3.6);
        let towards = (dvec3(0.3, 0.0, -1.0) - eye).as_vec3();
        let camera = Camera::new(at(eye), towards, Vec3::Y, 2.0).expect("a camera");
        let mut trial = Trial {
            configuration: self,
            objects: shapes.map(object).into(),
            exact: shapes.map(exactly).into(),
            light: at(dvec3(-3.0, 4.0, -4.0)),
            rays: Vec::new(),
            primary_mismatches: 0,
        };
        for pixel in Pixel::all(SIZE) {
            trial.add(camera.ray(pixel.centre()));
        }
        trial
    }
}

/// Returns a shape in the oracle's types, its f32 numbers unchanged.
#[must_use]
pub fn exactly(shape: Shape) -> oracle::Shape {
    match shape {
        Shape::Sphere(Sphere { centre, radius }) => oracle::Shape::Sphere {
            centre: centre.as_dvec3(),
            radius: radius.into(),
        },
        Shape::Plane(Plane { point, normal, .. }) => oracle::Shape::Plane {
            point: point.as_dvec3(),
            normal: normal.as_dvec3(),
        },
    }
}

impl Trial {
    /// Returns the secondary rays.
    #[must_use]
    pub fn rays(&self) -> &[SecondaryRay] {
        &self.rays
    }

    /// Returns the results of a method.
    #[must_use]
    pub fn tally(&self, method: Method) -> Tally {
        let mut tally = Tally {
            primary_mismatches: self.primary_mismatches,
            ..Tally::default()
        };
        for secondary in &self.rays {
            let ray = self.spawn(method, secondary);
            let nearest =
                nearest_by(&self.objects, secondary.t_max, |index, object, t_max| {
                    self.distance(&ray, index, &object.shape, t_max)
                });
            let ours = nearest.map(|(index, _)| index);
            tally.add(secondary.at.index, secondary.exact, ours);
        }
        tally
    }

    /// Returns whether a method's ray is occluded; the first occluder ends the search.
    #[must_use]
    pub fn is_occluded(&self, method: Method, secondary: &SecondaryRay) -> bool {
        let ray = self.spawn(method, secondary);
        let mut objects = self.objects.iter().enumerate();
        objects.any(|(index, object)| {
            let distance = self.distance(&ray, index, &object.shape, secondary.t_max);
            distance.is_some()
        })
    }

    fn spawn(&self, method: Method, secondary: &SecondaryRay) -> SurfaceRay {
        let SecondaryRay { at, direction, .. } = secondary;
        method.spawn(at, *direction)
    }

    fn distance(
        &self,
        ray: &SurfaceRay,
        index: usize,
        shape: &Shape,
        t_max: f32,
    ) -> Option<f32> {
        match shape {
            Shape::Sphere(sphere)
                if self.configuration.is_f64 && ray.origin != Some(index) =>
            {
                Some(sphere.hit_in_f64(&ray.ray, t_max)?.t)
            }
            Shape::Sphere(_) | Shape::Plane(_) => ray.distance(index, shape, t_max),
        }
    }

    /// Adds the secondary ray of a camera ray, if it has one.
    fn add(&mut self, ray: Ray) {
        let exact_ray = oracle::Ray {
            origin: ray.origin.as_dvec3(),
            direction: ray.direction.as_dvec3(),
            from: None,
        };
        let exact = self.first(&exact_ray, f64::INFINITY);
        let camera_ray = untracked(ray);
        let ours = nearest_by(&self.objects, T_MAX, |index, object, t_max| {
            self.distance(&camera_ray, index, &object.shape, t_max)
        });
        match (exact, ours) {
            (None, None) => {}
            (Some((own, t)), Some(hit)) if own == hit.0 => {
                let exact_point = exact_ray.origin + t * exact_ray.direction;
                let mut at = Interaction::new(&self.objects, &ray, hit);
                if let (Shape::Sphere(sphere), true) =
                    (self.objects[own].shape, self.configuration.is_f64)
                {
                    let in_f64 = sphere.hit_in_f64(&ray, T_MAX);
                    at.outward = in_f64.map_or(at.outward, |hit| hit.normal);
                    at.normal = face_forward(at.outward, at.incident);
                }
                let secondary = self.secondary(at, exact_point);
                self.rays.extend(secondary);
            }
            _ => self.primary_mismatches += 1,
        }
    }

    /// Returns the ray that leaves a hit. `None` if none does.
    fn secondary(&self, at: Interaction, exact_point: DVec3) -> Option<SecondaryRay> {
        let exact_normal = self.exact[at.index].normal(exact_point);
        // The exact direction need not be a unit vector: a shadow ray's ends at t = 1.
        let (direction, t_max, exact_direction, exact_t_max) = match self
            .configuration
            .secondary
        {
            Secondary::Shadow => {
                let to_light = self.light - at.point;
                let exactly = self.light.as_dvec3() - exact_point;
                if !(at.normal.dot(to_light) > 0.0 && exact_normal.dot(exactly) > 0.0) {
                    return None;
                }
                (to_light.normalize(), to_light.length(), exactly, 1.0)
            }
            Secondary::Reflection => {
                let incident = at.incident.as_dvec3();
                let exactly = incident - 2.0 * incident.dot(exact_normal) * exact_normal;
                let direction = reflect(at.incident, at.normal);
                (direction, T_MAX, exactly, f64::INFINITY)
            }
        };
        let exact_ray = oracle::Ray {
            origin: exact_point,
            direction: exact_direction,
            from: Some(at.index),
        };
        let exact = self.first(&exact_ray, exact_t_max);
        Some(SecondaryRay {
            at,
            direction,
            t_max,
            exact: exact.map(|(index, _)| index),
        })
    }

    /// Returns the index of the first object that the exact ray hits before `t_max`, and
    /// the distance.
    fn first(&self, ray: &oracle::Ray, t_max: f64) -> Option<(usize, f64)> {
        let shapes = self.exact.iter().enumerate();
        shapes
            .filter_map(|(i, shape)| Some((i, shape.distance(ray, ray.from == Some(i))?)))
            .filter(|&(_, t)| t < t_max)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }
}
