//! The book's scenes, for the planner: what chapters 3 to 11 draw.

use crate::plan::{Plan, Surface};
use anti_aliasing::views::horizon_camera;
use canvas::Picture;
use glam::Vec3;
use plane_hit::views::STILL_LIFE_COLOURS;
use plane_hit::{Object, Pattern, Shape, still_life};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ray_casting::{Camera, Ray, SKY};
use reflection::views::{facing_mirrors, still_life_mirrors};
use reflection::{Mirror, Reach};
use refraction::views::{AIR, GLASS, close_up, still_life_with_glass};
use refraction::{Body, Material};
use shading::Phong;
use shading::views::still_life_surfaces;
use shadow_acne::views::balls_on_a_planet;
use shadow_acne::{from_the_eye, from_the_surface};
use shadows::Scene;
use shadows::views::lit_still_life;
use sphere_hit::Sphere;
use transparency::Tinted;
use transparency::views::{AMBER, tinted_still_life};

/// A scene of the book and its camera.
pub struct BookScene {
    /// Lower case: `facing-mirrors`.
    pub name: &'static str,
    /// Makes it.
    pub make: fn() -> (Model, Camera),
}

/// The scene called `name`.
///
/// # Errors
/// One line that names them all, if none is called so.
pub fn find(name: &str) -> Result<&'static BookScene, String> {
    let found = SCENES.iter().find(|scene| scene.name == name);
    found.ok_or_else(|| {
        let names = SCENES.map(|scene| scene.name).join(", ");
        format!("there is no scene '{name}'; the scenes: {names}")
    })
}

/// A scene as chapters 3 to 10 see light, or as chapter 11 does.
#[derive(Clone, Debug)]
pub enum Model {
    /// Every shadow is black.
    Plain(Scene<Material>),
    /// Light gets through glass, and takes its colour.
    Tinted(Scene<Tinted>),
}

/// Every scene that chapters 3 to 11 draw, but for the bugs, and one of nested glass.
pub const SCENES: [BookScene; 15] = [
    scene("floor", || (flat(1), horizon_camera())),
    scene("flat", || (flat(6), still_life_view())),
    scene("plastic", || {
        let surfaces = still_life_surfaces().map(|phong| mirroring(phong, 0.0));
        (Model::Plain(lit_still_life(surfaces)), still_life_view())
    }),
    scene("mirror", || {
        let scene = lit_still_life(still_life_mirrors().map(opaque));
        (Model::Plain(scene), still_life_view())
    }),
    scene("still-life", || (glass(GLASS, AIR), still_life_view())),
    scene("glass", || (glass(GLASS, AIR), close_up())),
    scene("water", || (glass(1.33, AIR), close_up())),
    scene("diamond", || (glass(2.42, AIR), close_up())),
    scene("bubble", || (glass(AIR, GLASS), close_up())),
    scene("facing-mirrors", || mirrors(0.9)),
    scene("endless-mirrors", || mirrors(0.99)),
    scene("planet", || {
        let (scene, camera) = balls_on_a_planet(1.0);
        (Model::Plain(scene), camera)
    }),
    scene("amber", || {
        (Model::Tinted(tinted_still_life(AMBER)), still_life_view())
    }),
    scene("amber-ball", || {
        (Model::Tinted(tinted_still_life(AMBER)), close_up())
    }),
    scene("nested", nested),
];

const fn scene(name: &'static str, make: fn() -> (Model, Camera)) -> BookScene {
    BookScene { name, make }
}

fn still_life_view() -> Camera {
    still_life_camera(STILL_LIFE_FOCAL_LENGTH)
}

/// The first objects of chapter 3's still life, which glow in their colours by themselves.
fn flat(objects: usize) -> Model {
    let glowing = |colour| {
        let phong = Phong {
            colour,
            ambient: 1.0,
            diffuse: 0.0,
            specular: 0.0,
            shininess: 1,
        };
        mirroring(phong, 0.0)
    };
    let mut objects_of = still_life(STILL_LIFE_COLOURS.map(glowing));
    objects_of.truncate(objects);
    Model::Plain(Scene {
        objects: objects_of,
        lights: Vec::new(),
        background: SKY,
    })
}

fn glass(inside: f32, outside: f32) -> Model {
    Model::Plain(still_life_with_glass(inside, outside))
}

fn mirroring(phong: Phong, reflectivity: f32) -> Material {
    let body = Body::Opaque { reflectivity };
    Material { phong, body }
}

fn opaque(mirror: Mirror) -> Material {
    mirroring(mirror.phong, mirror.reflectivity)
}

fn mirrors(reflectivity: f32) -> (Model, Camera) {
    let (scene, camera) = facing_mirrors(reflectivity);
    let objects = scene.objects.into_iter().map(|object| Object {
        name: object.name,
        shape: object.shape,
        material: opaque(object.material),
    });
    let scene = Scene {
        objects: objects.collect(),
        lights: scene.lights,
        background: scene.background,
    };
    (Model::Plain(scene), camera)
}

/// The still life's ball of glass with a bubble in it, and a ball of glass in that.
#[must_use]
pub fn nested() -> (Model, Camera) {
    let mut scene = still_life_with_glass(GLASS, AIR);
    let glass = scene.objects[5].clone();
    let Shape::Sphere(Sphere { centre, radius }) = glass.shape else {
        unreachable!("the still life's glass is a ball");
    };
    let within = |part: f32, inside, outside| {
        let sphere = Sphere::new(centre, part * radius).expect("a sphere");
        let body = Body::Clear { inside, outside };
        Object {
            shape: Shape::Sphere(sphere),
            material: Material {
                body,
                ..glass.material
            },
            ..glass.clone()
        }
    };
    scene.objects.push(within(0.8, AIR, GLASS));
    scene.objects.push(within(0.4, GLASS, AIR));
    (Model::Plain(scene), close_up())
}

impl Model {
    /// What its picture needs, to be wrong by no more than a `wish`, in levels.
    #[must_use]
    pub fn plan(&self, camera: &Camera, wish: f32) -> Plan {
        match self {
            Self::Plain(scene) => Plan::new(scene, camera, wish),
            Self::Tinted(scene) => Plan::new(scene, camera, wish),
        }
    }

    /// Its picture by a plan, with one sample for each pixel, in its centre.
    #[must_use]
    pub fn at_centres(self, plan: Plan, camera: Camera) -> Picture {
        match self {
            Self::Plain(scene) => plan.at_centres(scene, camera),
            Self::Tinted(scene) => plan.at_centres(scene, camera),
        }
    }

    /// Its picture by a plan.
    #[must_use]
    pub fn planned(self, plan: Plan, camera: Camera) -> Picture {
        match self {
            Self::Plain(scene) => plan.picture(scene, camera),
            Self::Tinted(scene) => plan.picture(scene, camera),
        }
    }

    /// What a ray brings back by the chapters' own tracers.
    #[must_use]
    pub fn trace(&self, ray: Ray, reach: Reach) -> Vec3 {
        match self {
            Self::Plain(scene) => {
                shadow_acne::trace(scene, from_the_eye(ray), reach, from_the_surface)
            }
            Self::Tinted(scene) => transparency::trace(scene, from_the_eye(ray), reach),
        }
    }

    /// The same scene, as the f64 oracle has it.
    #[must_use]
    pub fn exactly(&self) -> oracle::Scene {
        match self {
            Self::Plain(scene) => exactly(scene),
            Self::Tinted(scene) => exactly(scene),
        }
    }
}

/// A scene as the oracle has it, in the very numbers that its f32s are.
fn exactly<M: Surface>(scene: &Scene<M>) -> oracle::Scene {
    let things = scene.objects.iter().map(|object| {
        let Material { phong, body } = object.material.material();
        oracle::Thing {
            shape: match object.shape {
                Shape::Sphere(Sphere { centre, radius }) => oracle::Shape::Sphere {
                    centre: centre.as_dvec3(),
                    radius: radius.into(),
                },
                Shape::Plane(plane) => oracle::Shape::Plane {
                    point: plane.point.as_dvec3(),
                    normal: plane.normal.as_dvec3(),
                },
            },
            surface: oracle::Surface {
                paint: match phong.colour {
                    Pattern::Plain(colour) => oracle::Paint::Plain(colour.as_dvec3()),
                    Pattern::Checker(even, odd) => {
                        oracle::Paint::Checker(even.as_dvec3(), odd.as_dvec3())
                    }
                },
                ambient: phong.ambient.into(),
                diffuse: phong.diffuse.into(),
                specular: phong.specular.into(),
                shininess: phong.shininess as i32,
            },
            body: match *body {
                Body::Opaque { reflectivity } => {
                    oracle::Body::Opaque(reflectivity.into())
                }
                Body::Clear { inside, outside } => oracle::Body::Clear {
                    inside: inside.into(),
                    outside: outside.into(),
                    glass: match object.material.absorption() {
                        None => oracle::Glass::Mirrors,
                        Some(absorption) => oracle::Glass::Tints(absorption.as_dvec3()),
                    },
                },
            },
        }
    });
    let lamps = scene.lights.iter().map(|light| oracle::Lamp {
        position: light.position.as_dvec3(),
        intensity: light.intensity.into(),
    });
    oracle::Scene {
        things: things.collect(),
        lamps: lamps.collect(),
        background: scene.background.as_dvec3(),
    }
}

/// A camera as the oracle has it.
#[must_use]
pub fn exact_camera(camera: &Camera) -> oracle::Camera {
    oracle::Camera {
        eye: camera.eye.as_dvec3(),
        right: camera.right.as_dvec3(),
        up: camera.up.as_dvec3(),
        forward: camera.forward.as_dvec3(),
        focal_length: camera.focal_length.into(),
    }
}
