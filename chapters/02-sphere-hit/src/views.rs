//! The chapter's pictures.

use crate::scene::camera_at;
use crate::{Sphere, T_MAX};
use canvas::{Knob, Picture, Scale, Stage, View, folder_name};
use glam::{Vec2, Vec3};
use ray_casting::scene::still_life_camera;
use ray_casting::{Camera, Ray, SKY};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Spheres: where a ray hits one",
    hero: "flat",
    bugs: &["far-textbook"],
    views: &[
        View {
            name: "flat",
            caption: "The still life's first sphere: red where the ray hits it, the empty world where it does not.",
            knob: None,
            picture: |_| first_sphere(still_life_camera(), red),
        },
        View {
            name: "normals",
            caption: "The same sphere's normals as colours: red to the right, green up, blue away from you.",
            knob: None,
            picture: |_| first_sphere(still_life_camera(), normal_as_colour),
        },
        View {
            name: "miss",
            caption: "Discriminant below 0: the ray passes the sphere by.",
            knob: None,
            picture: |_| cross_section(0.75),
        },
        View {
            name: "tangent",
            caption: "Discriminant 0: the ray touches the sphere in one point.",
            knob: None,
            picture: |_| cross_section(PAPER_SPHERE.radius),
        },
        View {
            name: "two-hits",
            caption: "Discriminant above 0: the ray enters the sphere, and would leave it.",
            knob: None,
            picture: |_| cross_section(0.25),
        },
        View {
            name: "far-textbook",
            caption: "A sphere from afar, by the textbook's formula: the farther away, the worse.",
            knob: Some(DISTANCE),
            picture: |distance| from_afar(distance, Sphere::distance_quadratic),
        },
        View {
            name: "far-stable",
            caption: "The same sphere from the same distance, by the stable formula: to the eye, as round as ever.",
            knob: Some(DISTANCE),
            picture: |distance| from_afar(distance, Sphere::distance),
        },
    ],
};

const DISTANCE: Knob = Knob {
    name: "distance",
    unit: "radii",
    min: 1.0,
    max: 1e6,
    default: 1000.0,
    scale: Scale::Logarithmic,
    snapshot_settings: &[10.0, 100.0, 1e4, 1e6],
};

fn normal_as_colour(normal: Vec3) -> Vec3 {
    (normal + Vec3::ONE) / 2.0
}

/// Returns the first sphere's flat colour; the normal is ignored.
pub fn red(_: Vec3) -> Vec3 {
    Vec3::new(0.9, 0.15, 0.1)
}

/// Returns the picture of the still life's first sphere in an empty world; its colour may
/// depend on the normal.
pub fn first_sphere(camera: Camera, colour: fn(Vec3) -> Vec3) -> Picture {
    let sphere = Sphere::new(Vec3::new(-2.2, 0.8, 1.0), 0.8).expect("a sphere");
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        match sphere.distance(&ray, T_MAX) {
            Some(t) => {
                canvas::count_ray();
                colour(sphere.normal(ray.at(t)))
            }
            None => ray_casting::trace(&ray),
        }
    })
}

/// Returns the picture of a sphere of radius 1 whose surface is `distance` away.
fn from_afar(distance: f32, intersect: fn(&Sphere, &Ray, f32) -> Option<f32>) -> Picture {
    let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    let camera = camera_at(distance);
    Picture::new(move |pixel| {
        let ray = camera.ray(pixel.centre());
        canvas::count_ray();
        match intersect(&sphere, &ray, T_MAX) {
            Some(t) => normal_as_colour(sphere.normal(ray.at(t))),
            None => SKY,
        }
    })
}

const PAPER_SPHERE: Sphere = Sphere {
    centre: Vec3::new(0.1, 0.0, 0.0),
    radius: 0.5,
};

/// Returns the drawing of a ray at some `height` above the centre of a sphere, both cut
/// through the middle.
fn cross_section(height: f32) -> Picture {
    let start = Vec2::new(-1.1, height);
    let end = Vec2::new(1.3, height);
    // The far hit is the first one of the ray that comes from the other side.
    let there = ray_on_paper(start, Vec2::X);
    let back = ray_on_paper(end, Vec2::NEG_X);
    let hits = [there, back].map(|ray| Some(ray.at(PAPER_SPHERE.distance(&ray, T_MAX)?)));
    let hits = hits.into_iter().flatten().map(Vec3::truncate).collect();
    drawing(start, end, hits, |point| {
        point.distance(PAPER_SPHERE.centre.truncate()) - PAPER_SPHERE.radius
    })
}

/// Returns a ray in the plane of a drawing, z = 0.
pub fn ray_on_paper(origin: Vec2, direction: Vec2) -> Ray {
    Ray {
        origin: origin.extend(0.0),
        direction: direction.extend(0.0),
    }
}

/// Returns the drawing of a ray from `start` to `end`, its `hits`, and a solid shape.
///
/// `solid` returns the distance of a point from the shape's edge, negative inside.
pub fn drawing(
    start: Vec2,
    end: Vec2,
    hits: Vec<Vec2>,
    solid: impl Fn(Vec2) -> f32 + Send + Sync + 'static,
) -> Picture {
    const PAPER: Vec3 = Vec3::new(0.9, 0.88, 0.82);
    const SOLID: Vec3 = Vec3::new(0.25, 0.45, 0.6);
    const RAY: Vec3 = Vec3::new(0.75, 0.25, 0.02);
    const HIT: Vec3 = Vec3::new(0.02, 0.02, 0.02);
    Picture::new(move |pixel| {
        let point = pixel.centre();
        let ink = |under: Vec3, ink: Vec3, distance: f32| {
            under.lerp(ink, coverage(distance, pixel.footprint()))
        };
        let mut light = ink(PAPER, SOLID, solid(point));
        light = ink(light, RAY, segment_distance(point, start, end) - 0.012);
        light = ink(light, RAY, point.distance(start) - 0.03);
        for &hit in &hits {
            light = ink(light, HIT, point.distance(hit) - 0.04);
        }
        light
    })
}

/// Returns the fraction of a pixel, 0 to 1, that is covered by a shape whose edge is at a
/// `distance`, negative inside.
fn coverage(distance: f32, footprint: f32) -> f32 {
    let covered = 0.5 - distance / footprint;
    if covered > 1.0 {
        1.0
    } else if covered > 0.0 {
        covered
    } else {
        0.0
    }
}

fn segment_distance(point: Vec2, start: Vec2, end: Vec2) -> f32 {
    let along = end - start;
    let t = (point - start).dot(along) / along.dot(along);
    let t = if t > 1.0 {
        1.0
    } else if t > 0.0 {
        t
    } else {
        0.0
    };
    point.distance(start + t * along)
}
