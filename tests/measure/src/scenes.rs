//! The book's scenes, by name.

use anti_aliasing::scene::horizon_camera;
use glam::Vec3;
use plane_hit::scene::{STILL_LIFE_COLOURS, still_life};
use plane_hit::{Object, Shape, Texture};
use ray_casting::scene::still_life_camera;
use ray_casting::{Camera, Ray, SKY};
use reflection::PathBudget;
use reflection::scene::{facing_mirrors, still_life_mirrors};
use refraction::scene::{AIR, GLASS, close_up, opaque, still_life_with_glass};
use refraction::{Material, Optics};
use shading::Phong;
use shading::scene::still_life_surfaces;
use shadow_acne::scene::balls_on_a_planet;
use shadow_acne::{from_eye, from_surface};
use shadows::Scene;
use shadows::scene::lit_still_life;
use sphere_hit::Sphere;
use transparency::Absorbing;
use transparency::scene::{AMBER, absorbing_still_life};
use trial::exactly as exact_shape;

/// A scene of the book and its camera.
pub struct BookScene {
    /// Lower case: `facing-mirrors`.
    pub name: &'static str,
    /// Returns the scene and its camera.
    pub make: fn() -> (Model, Camera),
}

/// Returns the scene called `name`, and its camera.
///
/// # Panics
/// If there is no such scene.
#[must_use]
pub fn scene(name: &str) -> (Model, Camera) {
    let found = SCENES.iter().find(|scene| scene.name == name);
    (found.expect("a scene of the book").make)()
}

/// Returns the scene called `name`, and its camera, if its glass absorbs nothing.
///
/// # Panics
/// If there is no such scene, or its glass absorbs light.
#[must_use]
pub fn plain_scene(name: &str) -> (Scene<Material>, Camera) {
    match scene(name) {
        (Model::Plain(scene), camera) => (scene, camera),
        (Model::Absorbing(_), _) => panic!("{name} has glass that absorbs light"),
    }
}

/// A scene whose shadows are black, or one whose glass absorbs light.
#[derive(Clone, Debug)]
pub enum Model {
    /// Every shadow is black, even that of glass.
    Plain(Scene<Material>),
    /// Glass transmits a light's rays, and absorbs some of them.
    Absorbing(Scene<Absorbing>),
}

/// Every scene of the book but those of bugs, and one of nested glass.
pub const SCENES: [BookScene; 15] = [
    book("floor", || (flat(1), horizon_camera())),
    book("flat", || (flat(6), still_life_camera())),
    book("plastic", || {
        let surfaces = still_life_surfaces().map(|phong| mirroring(phong, 0.0));
        (Model::Plain(lit_still_life(surfaces)), still_life_camera())
    }),
    book("mirror", || {
        let scene = lit_still_life(still_life_mirrors().map(opaque));
        (Model::Plain(scene), still_life_camera())
    }),
    book("still-life", || (glass(GLASS, AIR), still_life_camera())),
    book("glass", || (glass(GLASS, AIR), close_up())),
    book("water", || (glass(1.33, AIR), close_up())),
    book("diamond", || (glass(2.42, AIR), close_up())),
    book("bubble", || (glass(AIR, GLASS), close_up())),
    book("facing-mirrors", || mirrors(0.9)),
    book("endless-mirrors", || mirrors(0.99)),
    book("planet", || {
        let (scene, camera) = balls_on_a_planet(1.0);
        (Model::Plain(scene), camera)
    }),
    book("amber", || {
        (
            Model::Absorbing(absorbing_still_life(AMBER)),
            still_life_camera(),
        )
    }),
    book("amber-ball", || {
        (Model::Absorbing(absorbing_still_life(AMBER)), close_up())
    }),
    book("nested", nested),
];

const fn book(name: &'static str, make: fn() -> (Model, Camera)) -> BookScene {
    BookScene { name, make }
}

/// Returns the first objects of the still life in flat colours: all light is ambient.
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
    let optics = Optics::Opaque { reflectivity };
    Material { phong, optics }
}

fn mirrors(reflectivity: f32) -> (Model, Camera) {
    let (scene, camera) = facing_mirrors(reflectivity);
    (Model::Plain(scene.map(opaque)), camera)
}

/// Returns the still life with a bubble in its ball of glass, and a ball of glass in that.
fn nested() -> (Model, Camera) {
    let mut scene = still_life_with_glass(GLASS, AIR);
    let glass = scene.objects[5].clone();
    let Shape::Sphere(Sphere { centre, radius }) = glass.shape else {
        unreachable!("the still life's glass is a ball");
    };
    let within = |part: f32, eta_inside, eta_outside| Object {
        name: glass.name,
        shape: Shape::sphere(centre, part * radius),
        material: Material {
            optics: Optics::Dielectric {
                eta_inside,
                eta_outside,
            },
            ..glass.material
        },
    };
    scene.objects.push(within(0.8, AIR, GLASS));
    scene.objects.push(within(0.4, GLASS, AIR));
    (Model::Plain(scene), close_up())
}

impl Model {
    /// Returns the radiance along a ray, by the chapters' own tracers.
    #[must_use]
    pub fn trace(&self, ray: Ray, budget: PathBudget) -> Vec3 {
        match self {
            Self::Plain(scene) => {
                let ray = from_eye(&scene.objects, ray.origin)(ray);
                shadow_acne::trace(scene, &ray, budget, from_surface)
            }
            Self::Absorbing(scene) => {
                let ray = from_eye(&scene.objects, ray.origin)(ray);
                transparency::trace(scene, &ray, budget, transparency::between_media)
            }
        }
    }

    /// Returns the scene in the oracle's types.
    #[must_use]
    pub fn exactly(&self) -> oracle::Scene {
        match self {
            Self::Plain(scene) => {
                exactly(scene, |material| (*material, oracle::Glass::Reflects))
            }
            Self::Absorbing(scene) => exactly(scene, |absorbing| {
                let absorption = absorbing.absorption.as_dvec3();
                (absorbing.material, oracle::Glass::Absorbs(absorption))
            }),
        }
    }
}

/// Returns a scene in the oracle's types, its f32 numbers unchanged.
fn exactly<M>(
    scene: &Scene<M>,
    material: impl Fn(&M) -> (Material, oracle::Glass),
) -> oracle::Scene {
    let objects = scene.objects.iter().map(|object| {
        let (Material { phong, optics }, glass) = material(&object.material);
        oracle::Object {
            shape: exact_shape(object.shape),
            surface: oracle::Surface {
                texture: match phong.colour {
                    Texture::Solid(colour) => oracle::Texture::Solid(colour.as_dvec3()),
                    Texture::Checker(even, odd) => {
                        oracle::Texture::Checker(even.as_dvec3(), odd.as_dvec3())
                    }
                },
                ambient: phong.ambient.into(),
                diffuse: phong.diffuse.into(),
                specular: phong.specular.into(),
                shininess: phong.shininess as i32,
            },
            optics: match optics {
                Optics::Opaque { reflectivity } => {
                    oracle::Optics::Opaque(reflectivity.into())
                }
                Optics::Dielectric {
                    eta_inside,
                    eta_outside,
                } => oracle::Optics::Dielectric {
                    eta_inside: eta_inside.into(),
                    eta_outside: eta_outside.into(),
                    glass,
                },
            },
        }
    });
    let lights = scene.lights.iter().map(|light| oracle::PointLight {
        position: light.position.as_dvec3(),
        intensity: light.intensity.into(),
    });
    oracle::Scene {
        objects: objects.collect(),
        lights: lights.collect(),
        background: scene.background.as_dvec3(),
    }
}

/// Returns a camera in the oracle's types.
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
