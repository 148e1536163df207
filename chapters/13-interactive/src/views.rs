//! The views of the walk: the still life as each chapter renders it, from any camera.

use crate::block_of;
use crate::explain::{budget, explain};
use crate::overlay::Overlay;
use anti_aliasing::views::samples_knob;
use canvas::srgb::encode;
use canvas::{Knob, Picture, Pixel, Scale, Stage, View, decode, folder_name};
use fresnel::fresnel;
use glam::{Vec2, Vec3};
use ray_casting::Camera;
use ray_casting::scene::still_life_camera;
use reflection::MAX_DEPTH;
use reflection::scene::still_life_mirrors;
use reflection::views::depth_knob;
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use refraction::views::eta_knob;
use refraction::{Material, refract_or_reflect};
use shadows::scene::lit_still_life;
use shadows::views::still_life_by;
use shadows::{Scene, is_visible};
use sphere_hit::views::{first_sphere, red};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Interaction: a walk through the picture",
    hero: "still-life",
    bugs: &[],
    views: &{
        let [a, b, c, d, e, f, g, h, i, j, k] = VIEWS;
        [
            a.view, b.view, c.view, d.view, e.view, f.view, g.view, h.view, i.view,
            j.view, k.view,
        ]
    },
};

/// A view of the stage, from any camera.
pub struct WalkView {
    /// The view, from the still life's camera.
    pub view: View,
    /// Returns the exact picture that a camera sees, at a setting of the view's knob.
    pub picture: fn(Camera, f32) -> Picture,
    /// Of a view whose knob is n: returns the i-th of n × n samples of every pixel, from the
    /// camera, n and i. Every other view has one sample.
    sample: Option<fn(Camera, u32, u32) -> Picture>,
    /// Returns the scene in which a pixel's ray is explained, at a setting of the view's knob.
    pub scene: fn(f32) -> Scene<Material>,
}

/// A row of the table: name, caption, knob and picture of a view, and what is special to it.
macro_rules! walk_view {
    ($name:literal, $caption:literal, $knob:expr, $picture:expr $(, $field:ident = $value:expr)?) => {{
        let view = WalkView {
            view: View {
                name: $name,
                caption: $caption,
                knob: $knob,
                picture: |setting| ($picture)(still_life_camera(), setting),
            },
            picture: $picture,
            sample: None,
            scene: |_| still_life_with_glass(GLASS, AIR),
        };
        WalkView { $($field: $value,)? ..view }
    }};
}

/// All views; the key of a digit n shows the n-th.
const VIEWS: [WalkView; 11] = [
    walk_view!(
        "ray-casting",
        "Ray casting: where each ray goes.",
        None,
        |camera, _| ray_casting::views::directions(camera)
    ),
    walk_view!(
        "sphere-hit",
        "A sphere: where a ray hits it.",
        None,
        |camera, _| first_sphere(camera, red)
    ),
    walk_view!(
        "plane-hit",
        "Planes and spheres: which of many objects a ray hits first.",
        None,
        |camera, _| plane_hit::views::flat(camera)
    ),
    walk_view!(
        "shadows",
        "Shadows: which lights are visible from there.",
        None,
        |camera, _| still_life_by(camera, is_visible)
    ),
    walk_view!(
        "shading",
        "Shading: how a surface reflects their light.",
        None,
        |camera, _| shading::views::still_life_of(camera, |surface| surface)
    ),
    walk_view!(
        "reflection",
        "Reflection: what is seen in a mirror.",
        Some(depth_knob(MAX_DEPTH, &[])),
        |camera, depth| {
            let scene = lit_still_life(still_life_mirrors());
            reflection::views::picture_of(scene, camera, depth)
        }
    ),
    walk_view!(
        "refraction",
        "Refraction: what is seen through glass.",
        Some(eta_knob(&[])),
        |camera, eta| refraction::views::picture_of(eta, AIR, camera, refract_or_reflect),
        scene = |eta| still_life_with_glass(eta, AIR)
    ),
    walk_view!(
        "fresnel",
        "Fresnel: how much light the glass reflects, and how much it transmits.",
        Some(eta_knob(&[])),
        |camera, eta| fresnel::views::picture_of(eta, AIR, camera, fresnel),
        scene = |eta| still_life_with_glass(eta, AIR)
    ),
    walk_view!(
        "still-life",
        "The still life, finished: n × n rays for every pixel, and none that starts at the wrong place.",
        Some(samples_knob(4, &[])),
        still_life,
        sample = Some(still_life_sample)
    ),
    walk_view!(
        "coarse",
        "What is shown while we move: one ray for a block of pixels, whose sides are doubled until a frame is fast enough.",
        Some(Knob {
            name: "level of detail",
            unit: "",
            min: 0.0,
            max: crate::MAX_LOD as f32,
            default: 2.0,
            scale: Scale::Whole,
            snapshot_settings: &[],
        }),
        coarse
    ),
    walk_view!(
        "explained",
        "A pixel's ray, explained: where it is reflected, where it goes through glass, and which lights are visible from there.",
        None,
        explained
    ),
];

impl WalkView {
    /// All views, in the order of the stage.
    pub const ALL: &[Self] = &VIEWS;

    /// Returns the view called `name`, or `None` if there is no such view.
    pub fn named(name: &str) -> Option<&'static Self> {
        Self::ALL.iter().find(|walk| walk.view.name == name)
    }

    /// Returns the number of samples per pixel at a setting of the knob.
    pub fn samples(&self, setting: f32) -> u32 {
        self.sample.map_or(1, |_| setting as u32 * setting as u32)
    }

    /// Returns the picture of the i-th sample of every pixel.
    pub fn sample(&self, camera: Camera, setting: f32, i: u32) -> Picture {
        match self.sample {
            Some(sample) => sample(camera, setting as u32, i),
            None => (self.picture)(camera, setting),
        }
    }

    /// Returns the picture of one sample in the centre of every pixel.
    pub fn preview(&self, camera: Camera, setting: f32) -> Picture {
        match self.sample {
            Some(sample) => sample(camera, 1, 0),
            None => (self.picture)(camera, setting),
        }
    }
}

/// Views are equal if their names are.
impl PartialEq for WalkView {
    fn eq(&self, other: &Self) -> bool {
        self.view.name == other.view.name
    }
}

/// Returns the finished still life, with n × n samples of every pixel.
fn still_life(camera: Camera, n: f32) -> Picture {
    let scene = still_life_with_glass(GLASS, AIR);
    Picture::from_spans(move |first, span| {
        packets::render(&scene, &camera, budget(), n as u32, first, span);
    })
}

/// Returns the picture of the i-th of these samples of every pixel.
fn still_life_sample(camera: Camera, n: u32, i: u32) -> Picture {
    let scene = still_life_with_glass(GLASS, AIR);
    Picture::from_spans(move |first, span| {
        packets::render_sample(&scene, &camera, budget(), [n, i], first, span);
    })
}

fn coarse(camera: Camera, lod: f32) -> Picture {
    let sample = still_life_sample(camera, 1, 0);
    Picture::new(move |pixel| sample.radiance(block_of(pixel, lod as u32)))
}

/// Returns the still life with the path of one pixel's ray, which hits the glass.
fn explained(camera: Camera, _: f32) -> Picture {
    let scene = still_life_with_glass(GLASS, AIR);
    Picture::from_spans(move |first, span| {
        packets::render(&scene, &camera, budget(), 1, first, span);
        let mut levels: Vec<_> = span.iter().map(|radiance| encode(*radiance)).collect();
        let size = first.size;
        let [x, y] = (size.as_vec2() * Vec2::new(0.6, 0.64))
            .as_uvec2()
            .to_array();
        let explained = explain(&scene, &camera, Pixel { x, y, size }.centre(), budget());
        Overlay::new(&explained, &camera, size).draw_span(first, &mut levels);
        for (out, level) in span.iter_mut().zip(levels) {
            *out = Vec3::from_array(level.map(decode));
        }
    })
}
