//! What chapter 6 shows, and the still life with its mirrors.

use crate::{MAX_DEPTH, Mirror, Reach, bounce_inside, reflect, reflect_by_slide, trace};
use canvas::{Knob, Picture, Scale, Stage, View};
use glam::{Vec2, Vec3};
use plane_hit::{Object, Pattern, Plane, Shape, is_even};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use ray_casting::{Camera, SKY};
use shading::Phong;
use shading::views::still_life_surfaces;
use shadows::views::lit_still_life;
use shadows::{PointLight, Scene};
use sphere_hit::{FARTHEST, Sphere};

/// Chapter 6.
pub const STAGE: Stage = Stage {
    name: "06-reflection",
    title: "Mirrors, and what is seen in them",
    views: &[
        View {
            name: "bouncing",
            caption: "The still life with its mirror, and a green ball that shines a little: rays bounce until \
                      they bring nothing more.",
            knob: Some(depth(MAX_DEPTH, &[0.0, 2.0])),
            picture: |depth| {
                let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
                picture_of(lit_still_life(still_life_mirrors()), camera, depth)
            },
        },
        View {
            name: "one-bounce",
            caption: "One bounce and no more: the mirror shows a green ball that mirrors nothing.",
            knob: None,
            picture: |_| {
                let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
                picture_of(lit_still_life(still_life_mirrors()), camera, 1.0)
            },
        },
        View {
            name: "facing-mirrors",
            caption: "Two mirrors that face each other, each passing on nine tenths of the light.",
            knob: Some(depth(MAX_DEPTH, &[5.0, 20.0])),
            picture: |depth| {
                let (scene, camera) = facing_mirrors(0.9);
                picture_of(scene, camera, depth)
            },
        },
        View {
            name: "inside-slide",
            caption: "Inside a mirror sphere with a chequered skin, after some bounces by the slides' formulas. \
                      Black: lost.",
            knob: Some(BOUNCES),
            picture: |bounces| inside_a_sphere(bounces, reflect_by_slide),
        },
        View {
            name: "inside-stable",
            caption: "The same bounces, each direction made a unit vector again.",
            knob: Some(BOUNCES),
            picture: |bounces| inside_a_sphere(bounces, reflect),
        },
    ],
};

/// The knob of how many bounces a ray is followed for.
#[must_use]
pub const fn depth(default: u32, pinned: &'static [f32]) -> Knob {
    Knob {
        name: "depth",
        unit: "bounces",
        min: 0.0,
        max: MAX_DEPTH as f32,
        default: default as f32,
        scale: Scale::Whole,
        pinned,
    }
}

const BOUNCES: Knob = Knob {
    name: "bounces",
    unit: "",
    min: 0.0,
    max: 16.0,
    default: 6.0,
    scale: Scale::Whole,
    pinned: &[3.0, 5.0, 10.0],
};

/// A scene with mirrors, each ray followed for `depth` bounces.
#[must_use]
pub fn picture_of(scene: Scene<Mirror>, camera: Camera, depth: f32) -> Picture {
    let reach = Reach::new(depth as u32);
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre()), reach))
}

/// The still life's surfaces with the mirror and the green ball's gloss; the glass still waits.
#[must_use]
pub fn still_life_mirrors() -> [Mirror; 6] {
    let [floor, red, _, green, blue, glass] = still_life_surfaces();
    let mirror = Phong {
        colour: Pattern::Plain(Vec3::splat(0.9)),
        ambient: 0.02,
        diffuse: 0.1,
        specular: 0.8,
        shininess: 200,
    };
    let with = |phong, reflectivity| Mirror {
        phong,
        reflectivity,
    };
    [
        with(floor, 0.0),
        with(red, 0.0),
        with(mirror, 0.8),
        with(green, 0.2),
        with(blue, 0.0),
        with(glass, 0.0),
    ]
}

/// A ball between two mirror walls of some reflectivity, and a camera between them.
#[must_use]
pub fn facing_mirrors(reflectivity: f32) -> (Scene<Mirror>, Camera) {
    let plain = |colour| Phong {
        colour,
        ambient: 0.1,
        diffuse: 0.8,
        specular: 0.3,
        shininess: 50,
    };
    let wall = Phong {
        colour: Pattern::Plain(Vec3::splat(0.9)),
        ambient: 0.02,
        diffuse: 0.03,
        specular: 0.0,
        shininess: 1,
    };
    let object = |name, shape, phong, reflectivity| Object {
        name,
        shape,
        material: Mirror {
            phong,
            reflectivity,
        },
    };
    let plane = |point, normal| Shape::Plane(Plane::new(point, normal).expect("a plane"));
    let ball = Sphere::new(Vec3::new(0.0, 0.8, 0.3), 0.8).expect("a sphere");
    let floor = Pattern::Checker(Vec3::splat(0.1), Vec3::splat(0.9));
    let red = Pattern::Plain(Vec3::new(0.9, 0.15, 0.1));
    let scene = Scene {
        objects: vec![
            object("floor", plane(Vec3::ZERO, Vec3::Y), plain(floor), 0.0),
            object(
                "left",
                plane(3.0 * Vec3::NEG_X, Vec3::X),
                wall,
                reflectivity,
            ),
            object(
                "right",
                plane(3.0 * Vec3::X, Vec3::NEG_X),
                wall,
                reflectivity,
            ),
            object("ball", Shape::Sphere(ball), plain(red), 0.0),
        ],
        lights: vec![PointLight {
            position: Vec3::new(0.5, 5.0, -2.0),
            intensity: 0.9,
        }],
        background: SKY,
    };
    let eye = Vec3::new(2.7, 1.9, -1.6);
    let towards = Vec3::new(-3.0, 0.9, 0.7) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, 1.5).expect("a camera");
    (scene, camera)
}

/// What is seen from inside a mirror sphere whose skin is chequered, after a number of bounces.
fn inside_a_sphere(bounces: f32, reflect: fn(Vec3, Vec3) -> Vec3) -> Picture {
    let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    let eye = Vec3::new(0.0, 0.0, -0.6);
    let camera = Camera::new(eye, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
    Picture::new(move |pixel| {
        let mut ray = camera.ray(pixel.centre());
        let Some(hit) = sphere.hit(&ray, FARTHEST) else {
            return Vec3::ZERO;
        };
        // The first wall, then one more for every bounce.
        ray.direction = reflect(ray.direction, hit.normal);
        ray.origin = hit.normal;
        for _ in 0..bounces as u32 {
            ray = bounce_inside(&sphere, &ray, reflect);
        }
        let end = ray.origin;
        if !((end.length() - 1.0).abs() < LOST) {
            return Vec3::ZERO;
        }
        let colour = (end + Vec3::ONE) / 2.0;
        if is_even(6.0 * Vec2::new(end.x, end.y)) {
            colour
        } else {
            0.6 * colour
        }
    })
}

/// A point this far from the sphere of radius 1 that it should be on is lost.
const LOST: f32 = 0.1;
