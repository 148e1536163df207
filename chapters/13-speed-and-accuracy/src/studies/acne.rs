//! Chapter 10: how a ray leaves a surface; how often it then meets what it should not, and
//! misses what it should meet.
//!
//! The scene is one to trip over: on a planet, or on a plane, balls of radius 1, 1/20 and
//! 1/200, one that hovers 0.002 above the ground and one that nearly touches it. It is
//! scaled, and moved away from the origin of the world, so that its numbers have fewer
//! bits left. Every camera ray's shadow ray, or its mirrored ray, is compared with the
//! exact one.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Clock, Measurement, Study, each};
use canvas::Pixel;
use glam::{DVec3, UVec2, Vec3, dvec3};
use plane_hit::{Object, Plane, Shape};
use ray_casting::{Camera, Ray};
use reflection::reflect;
use shadow_acne::{
    Leave, Leaving, at_the_point, by_a_scaled_offset, from_the_eye, from_the_surface,
};
use sphere_hit::{FARTHEST, Hit, Sphere, facing};

/// Shadow rays on the planet: false hits, in percent of the points that the lamp reaches,
/// and lost shadows, in percent of those that it does not reach, over the scene's scale
/// (with the origin of the world in it) and over its distance from there (in its own
/// units, at scale 1). Both numbers count alike in "overall": their mean, over all these
/// places. The setting there is the step's length, and the times are those at scale 1.
pub const STUDY: Study = Study {
    name: "acne",
    title: "Leaving a surface: without a step, by a fixed one, by one that is scaled, and from the surface itself",
    measure,
    charts: &[
        Chart {
            title: "Acne: points in the light that are made dark",
            scene: "false hits",
            x: SCALE,
            y: Axis {
                quantity: Quantity::Wrong,
                label: "percent of the lit",
            },
            front: false,
        },
        Chart {
            title: "Lost shadows: points in the shadow that are lit",
            scene: "lost shadows",
            x: SCALE,
            y: Axis {
                quantity: Quantity::Wrong,
                label: "percent of the dark",
            },
            front: false,
        },
        Chart {
            title: "Both, at all scales and distances, against the cost",
            scene: "overall",
            x: Axis {
                quantity: Quantity::Ns,
                label: "nanoseconds for one shadow ray",
            },
            y: Axis {
                quantity: Quantity::Wrong,
                label: "wrong, in percent",
            },
            front: true,
        },
    ],
    table: include_str!("../../../../book/src/studies/acne.csv"),
};

const SCALE: Axis = Axis {
    quantity: Quantity::Setting,
    label: "scale of the scene",
};

/// How a ray leaves a surface.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    /// One of chapter 10's ways.
    Taught(Leave<()>),
    /// A fixed step off the surface, as in chapter 4, but of this length.
    Step(f32),
}

impl Way {
    fn leave<'a>(
        self,
        object: &'a Object<()>,
        point: Vec3,
        normal: Vec3,
        direction: Vec3,
    ) -> Leaving<'a, ()> {
        match self {
            Self::Taught(leave) => leave(object, point, normal, direction),
            Self::Step(length) => {
                let origin = point + length * facing(normal, -direction);
                at_the_point(object, origin, normal, direction)
            }
        }
    }
}

/// The knob's settings among what has no knob.
const METHODS: [(&str, Way); 9] = [
    ("no step", Way::Taught(at_the_point)),
    ("fixed 1e-6", Way::Step(1e-6)),
    ("fixed 1e-5", Way::Step(1e-5)),
    ("fixed 1e-4", Way::Step(1e-4)),
    ("fixed 1e-3", Way::Step(1e-3)),
    ("fixed 1e-2", Way::Step(1e-2)),
    ("fixed 1e-1", Way::Step(1e-1)),
    ("scaled", Way::Taught(by_a_scaled_offset)),
    ("from the surface", Way::Taught(from_the_surface)),
];

/// Those of them that the charts over the scale have room for.
const SHOWN: [usize; 6] = [0, 1, 3, 5, 7, 8];

const SCALES: [f64; 10] = [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6];
const DISTANCES: [f64; 6] = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5];

fn measure(clock: &Clock) -> Vec<Measurement> {
    let scaled = SCALES.map(|scale| ("", scale, on_the_planet(scale, 0.0)));
    let away =
        DISTANCES.map(|distance| (", far away", distance, on_the_planet(1.0, distance)));
    let places = scaled.into_iter().chain(away);
    let tallies: Vec<(&str, f64, [Tally; 9])> = places
        .map(|(place, setting, trial)| {
            (place, setting, METHODS.map(|(_, way)| trial.tally(way)))
        })
        .collect();
    let mut rows = Vec::new();
    for (place, setting, tallies) in &tallies {
        for method in SHOWN {
            let row = |scene, wrong| Measurement {
                wrong: Some(wrong),
                ..Measurement::of(format!("{scene}{place}"), METHODS[method].0, *setting)
            };
            rows.push(row("false hits", tallies[method].false_hits()));
            rows.push(row("lost shadows", tallies[method].leaks()));
        }
    }

    let trial = on_the_planet(1.0, 0.0);
    let mut jobs: Vec<_> = METHODS
        .iter()
        .map(|&(_, way)| {
            let trial = &trial;
            each(&trial.departures, move |departure| {
                trial.is_blocked(way, departure)
            })
        })
        .collect();
    let times = clock.least(trial.departures.len(), &mut jobs);
    for (method, ((name, way), ns)) in METHODS.into_iter().zip(times).enumerate() {
        let of_both = tallies.iter().map(|(.., tallies)| {
            (tallies[method].false_hits() + tallies[method].leaks()) / 2.0
        });
        let (name, setting) = match way {
            Way::Taught(_) => (name, 0.0),
            Way::Step(length) => ("fixed", length.into()),
        };
        rows.push(Measurement {
            wrong: Some(of_both.sum::<f64>() / tallies.len() as f64),
            ns,
            ..Measurement::of("overall", name, setting)
        });
    }
    rows
}

fn on_the_planet(scale: f64, distance: f64) -> Trial {
    let configuration = Configuration {
        ground: Ground::Sphere,
        secondary: Secondary::Shadow,
        is_f64: false,
        scale,
        distance,
    };
    configuration.trial()
}

/// What the scene stands on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ground {
    /// y = 0.
    Plane,
    /// A ball of radius 1000 whose top is the origin of the scene.
    Sphere,
}

/// The ray that leaves where a camera ray has met something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Secondary {
    /// Towards the lamp, if that is in front of the surface.
    Shadow,
    /// Mirrored.
    Reflection,
}

/// How a ray meets an object.
type Meets = fn(&Leaving<()>, &Object<()>, f32) -> Option<Hit>;

/// As chapter 10 does.
fn in_f32(leaving: &Leaving<()>, object: &Object<()>, t_max: f32) -> Option<Hit> {
    leaving.hit(object, t_max)
}

/// The same, but for spheres that the ray does not come from, which it meets in f64.
fn in_f64(leaving: &Leaving<()>, object: &Object<()>, t_max: f32) -> Option<Hit> {
    let is_where_from = leaving.from.is_some_and(|from| std::ptr::eq(from, object));
    match &object.shape {
        Shape::Sphere(sphere) if !is_where_from => sphere.hit_in_f64(&leaving.ray, t_max),
        _ => leaving.hit(object, t_max),
    }
}

/// The scene's variants.
#[derive(Clone, Copy, Debug)]
pub struct Configuration {
    /// What it stands on.
    pub ground: Ground,
    /// Which rays leave its surfaces.
    pub secondary: Secondary,
    /// Whether spheres are met in f64, points remaining in f32.
    pub is_f64: bool,
    /// How large it is.
    pub scale: f64,
    /// How many of its own units it is away from the origin of the world.
    pub distance: f64,
}

/// How a way to leave did in a configuration, in pixels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Where the exact ray meets nothing.
    pub clear: usize,
    /// Of those, where ours meets something.
    pub false_hits: usize,
    /// Where the exact ray meets something.
    pub blocked: usize,
    /// Of those, where ours meets nothing, or another thing, but not what it leaves.
    pub leaks: usize,
    /// Where ours meets the surface that it leaves, which is convex, from its outside.
    pub self_hits: usize,
    /// Where the camera ray meets another thing than the exact one: how the next ray
    /// leaves does not matter there, and nothing else is counted.
    pub strays: usize,
}

impl Tally {
    fn note(&mut self, own: usize, exact: Option<usize>, ours: Option<usize>) {
        self.self_hits += usize::from(ours == Some(own));
        if exact.is_none() {
            self.clear += 1;
            self.false_hits += usize::from(ours.is_some());
        } else {
            self.blocked += 1;
            self.leaks += usize::from(ours != exact && ours != Some(own));
        }
    }

    /// In percent of the clear pixels.
    #[must_use]
    pub fn false_hits(&self) -> f64 {
        100.0 * self.false_hits as f64 / self.clear as f64
    }

    /// In percent of the blocked pixels.
    #[must_use]
    pub fn leaks(&self) -> f64 {
        100.0 * self.leaks as f64 / self.blocked as f64
    }
}

const SIZE: UVec2 = UVec2::new(240, 180);

/// A configuration's scene in f32, and the rays that leave its surfaces.
pub struct Trial {
    objects: Vec<Object<()>>,
    /// The same, exactly.
    exact: Vec<oracle::Shape>,
    lamp: Vec3,
    secondary: Secondary,
    meets: Meets,
    departures: Vec<Departure>,
    strays: usize,
}

/// A ray about to leave what a camera ray has met.
struct Departure {
    /// What that is, by its place in the list.
    own: usize,
    point: Vec3,
    /// Outward.
    normal: Vec3,
    direction: Vec3,
    /// How far the ray matters.
    t_max: f32,
    /// What the exact ray meets first.
    exact: Option<usize>,
}

impl Configuration {
    /// The scene of this configuration, with a departure for each pixel that has one.
    ///
    /// # Panics
    /// If the scale is not positive, or either number so large or small that f32 has no
    /// such scene.
    #[must_use]
    pub fn trial(&self) -> Trial {
        let away = dvec3(0.64, 0.48, -0.6);
        let at = |p: DVec3| (self.scale * (p + self.distance * away)).as_vec3();
        let ball = |centre: DVec3, radius: f64| {
            let radius = (self.scale * radius) as f32;
            Shape::Sphere(Sphere::new(at(centre), radius).expect("a sphere"))
        };
        let pole = dvec3(0.0, -1000.0, 0.0);
        let ground = match self.ground {
            Ground::Plane => {
                Shape::Plane(Plane::new(at(DVec3::ZERO), Vec3::Y).expect("a plane"))
            }
            Ground::Sphere => ball(pole, 1000.0),
        };
        // A ball above (x, z), with some air between it and the ground.
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
            objects: shapes.map(object).into(),
            exact: shapes.map(in_the_oracle).into(),
            lamp: at(dvec3(-3.0, 4.0, -4.0)),
            secondary: self.secondary,
            meets: if self.is_f64 { in_f64 } else { in_f32 },
            departures: Vec::new(),
            strays: 0,
        };
        for (y, x) in (0..SIZE.y).flat_map(|y| (0..SIZE.x).map(move |x| (y, x))) {
            let pixel = Pixel { x, y, size: SIZE };
            trial.look(camera.ray(pixel.centre()));
        }
        trial
    }
}

fn in_the_oracle(shape: Shape) -> oracle::Shape {
    match shape {
        Shape::Sphere(Sphere { centre, radius }) => oracle::Shape::Sphere {
            centre: centre.as_dvec3(),
            radius: radius.into(),
        },
        Shape::Plane(Plane { point, normal }) => oracle::Shape::Plane {
            point: point.as_dvec3(),
            normal: normal.as_dvec3(),
        },
    }
}

impl Trial {
    /// How a way to leave does here.
    #[must_use]
    pub fn tally(&self, way: Way) -> Tally {
        let mut tally = Tally {
            strays: self.strays,
            ..Tally::default()
        };
        for departure in &self.departures {
            let leaving = self.leaving(way, departure);
            let ours = self.nearest(&leaving, departure.t_max).map(|(i, _)| i);
            tally.note(departure.own, departure.exact, ours);
        }
        tally
    }

    fn leaving(&self, way: Way, departure: &Departure) -> Leaving<'_, ()> {
        let &Departure {
            own,
            point,
            normal,
            direction,
            ..
        } = departure;
        way.leave(&self.objects[own], point, normal, direction)
    }

    /// As chapter 10 asks for a shadow: the first blocker ends the search.
    fn is_blocked(&self, way: Way, departure: &Departure) -> bool {
        let leaving = self.leaving(way, departure);
        let mut objects = self.objects.iter();
        objects.any(|object| (self.meets)(&leaving, object, departure.t_max).is_some())
    }

    /// Notes what becomes of a camera ray.
    fn look(&mut self, ray: Ray) {
        let to_eye = oracle::Ray {
            origin: ray.origin.as_dvec3(),
            direction: ray.direction.as_dvec3(),
            from: None,
        };
        let exact = self.first(&to_eye, f64::INFINITY);
        match (exact, self.nearest(&from_the_eye(ray), FARTHEST)) {
            (None, None) => {}
            (Some((own, t)), Some((ours, hit))) if own == ours => {
                let exact_point = to_eye.origin + t * to_eye.direction;
                let departure = self.departure(own, &ray, hit, exact_point);
                self.departures.extend(departure);
            }
            _ => self.strays += 1,
        }
    }

    /// The ray that leaves the object at a place in the list, where a camera ray has hit
    /// it; `None` if none does.
    fn departure(
        &self,
        own: usize,
        ray: &Ray,
        hit: Hit,
        exact_point: DVec3,
    ) -> Option<Departure> {
        let exact_normal = self.exact[own].normal(exact_point);
        let point = ray.at(hit.t);
        let normal = facing(hit.normal, ray.direction);
        // The direction, how far it matters, and the same exactly, where a way is as long
        // as its direction.
        let (direction, t_max, way, way_end) = match self.secondary {
            Secondary::Shadow => {
                let to_lamp = self.lamp - point;
                let way = self.lamp.as_dvec3() - exact_point;
                if !(normal.dot(to_lamp) > 0.0 && exact_normal.dot(way) > 0.0) {
                    return None;
                }
                (to_lamp.normalize(), to_lamp.length(), way, 1.0)
            }
            Secondary::Reflection => {
                let incident = ray.direction.as_dvec3();
                let way = incident - 2.0 * incident.dot(exact_normal) * exact_normal;
                (reflect(ray.direction, normal), FARTHEST, way, f64::INFINITY)
            }
        };
        let exact = oracle::Ray {
            origin: exact_point,
            direction: way,
            from: Some(own),
        };
        Some(Departure {
            own,
            point,
            normal: hit.normal,
            direction,
            t_max,
            exact: self.first(&exact, way_end).map(|(i, _)| i),
        })
    }

    /// The first object before `t_max`, exactly: by its place in the list, and where.
    fn first(&self, ray: &oracle::Ray, t_max: f64) -> Option<(usize, f64)> {
        let shapes = self.exact.iter().enumerate();
        shapes
            .filter_map(|(i, shape)| Some((i, shape.meets(ray, ray.from == Some(i))?)))
            .filter(|&(_, t)| t < t_max)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The first object before `t_max`, by its place in the list.
    fn nearest(&self, leaving: &Leaving<()>, mut t_max: f32) -> Option<(usize, Hit)> {
        let mut nearest = None;
        for (i, object) in self.objects.iter().enumerate() {
            if let Some(hit) = (self.meets)(leaving, object, t_max) {
                t_max = hit.t;
                nearest = Some((i, hit));
            }
        }
        nearest
    }
}
