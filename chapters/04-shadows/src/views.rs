//! The chapter's pictures.

use crate::scene::lit_still_life;
use crate::{PointLight, Scene, Visibility, is_visible, is_visible_buggy, trace};
use canvas::{Picture, Stage, View, folder_name};
use glam::Vec3;
use plane_hit::scene::STILL_LIFE_COLOURS;
use plane_hit::{Object, Shape, Texture};
use ray_casting::scene::still_life_camera;
use ray_casting::{Camera, SKY};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "What the light does not reach",
    hero: "hard",
    bugs: &["beyond-buggy"],
    views: &[
        View {
            name: "hard",
            caption: "The still life with the shadows of its two lights: darker where one is hidden, black where both are.",
            knob: None,
            picture: |_| still_life_by(still_life_camera(), is_visible),
        },
        View {
            name: "none",
            caption: "Without shadows: every light reaches everything, and the spheres seem to float.",
            knob: None,
            picture: |_| still_life_by(still_life_camera(), |_, _, _| true),
        },
        View {
            name: "beyond-buggy",
            caption: "The bug: the light hangs between the balls, and the upper ball, beyond it, darkens the floor.",
            knob: None,
            picture: |_| light_between_balls(is_visible_buggy),
        },
        View {
            name: "beyond",
            caption: "The cure: only an object in front of the light can occlude it. The lower ball has a shadow, the upper one has none.",
            knob: None,
            picture: |_| light_between_balls(is_visible),
        },
    ],
};

fn picture_of(
    scene: Scene<Texture>,
    camera: Camera,
    is_visible: Visibility<Texture>,
) -> Picture {
    Picture::new(move |pixel| trace(&scene, &camera.ray(pixel.centre()), is_visible))
}

/// Returns the picture of the still life with the shadows that `is_visible` finds.
pub fn still_life_by(camera: Camera, is_visible: Visibility<Texture>) -> Picture {
    picture_of(lit_still_life(STILL_LIFE_COLOURS), camera, is_visible)
}

/// Returns the picture of a ball on the floor, another high above it, and a light between
/// the two.
fn light_between_balls(is_visible: Visibility<Texture>) -> Picture {
    let ball = |name, height, colour| Object {
        name,
        shape: Shape::sphere(Vec3::new(0.0, height, 0.0), 0.5),
        material: Texture::Solid(colour),
    };
    let floor = Object {
        name: "floor",
        shape: Shape::plane(Vec3::ZERO, Vec3::Y),
        material: Texture::Solid(Vec3::splat(0.7)),
    };
    let objects = vec![
        floor,
        ball("lower", 0.5, Vec3::new(0.9, 0.3, 0.05)),
        ball("upper", 3.0, Vec3::new(0.1, 0.5, 0.6)),
    ];
    let light = PointLight::new(Vec3::new(0.7, 2.0, 0.0), 1.0).expect("a valid light");
    let scene = Scene::new(objects, vec![light], SKY).expect("three surfaces");
    let eye = Vec3::new(0.0, 2.5, -8.0);
    let towards = Vec3::new(0.3, 1.5, 0.0) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, 3.0).expect("a camera");
    picture_of(scene, camera, is_visible)
}
