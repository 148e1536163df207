//! Maps of the errors and costs of the chapters' methods, beside the exact picture.

use crate::error_map::{cost_map, error_map};
use anti_aliasing::adaptive;
use canvas::{Knob, Picture, Pixel, Scale, Stage, View, folder_name};
use glam::Vec3;
use measure::pictures::scalar_picture;
use measure::scenes::{Model, plain_scene, scene};
use measure::subjects::finely_sampled;
use oracle::Limit;
use plane_hit::Shape;
use ray_casting::{Camera, Ray, SKY};
use reflection::{MAX_DEPTH, MIN_THROUGHPUT, PathBudget};
use shadow_acne::{from_eye, trace, untracked};
use shadows::SHADOW_BIAS;
use sphere_hit::{Sphere, T_MAX, face_forward};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Speed against accuracy",
    hero: "sampling-error",
    bugs: &[],
    views: &[
        View {
            name: "sampling-error",
            caption: "The errors of 2 × 2 jittered samples, or n × n where these differ. Black is right to 10⁻⁵ of a \
                      level; each colour is ten times as wrong as the last, the lightest by ten levels or more.",
            knob: Some(SAMPLES),
            picture: sampling_error,
        },
        View {
            name: "sampling-cost",
            caption: "The rays of those samples: black is one for a pixel, and each colour is twice as many as the last. \
                      Edges take the most, and the glass.",
            knob: Some(SAMPLES),
            picture: |n| cost_map(sampled(n)),
        },
        View {
            name: "depth-error",
            caption: "The errors of a greatest depth: plastic needs none, mirrors a little, and the glass and its \
                      images in the mirrors the most.",
            knob: Some(DEPTH),
            picture: |depth| budget_error(by_depth(depth)),
        },
        View {
            name: "depth-cost",
            caption: "The rays of that depth: in the glass each bounce multiplies them.",
            knob: Some(DEPTH),
            picture: |depth| cost_map(still_life(by_depth(depth))),
        },
        View {
            name: "cut-off-error",
            caption: "The errors of a least throughput: rays are followed as long as they matter, at the rim of the \
                      glass for longer than in its middle.",
            knob: Some(CUT_OFF),
            picture: |throughput| budget_error(by_throughput(throughput)),
        },
        View {
            name: "cut-off-cost",
            caption: "The rays of that least throughput: the rim of the glass takes more than its middle.",
            knob: Some(CUT_OFF),
            picture: |throughput| cost_map(still_life(by_throughput(throughput))),
        },
        View {
            name: "bias-error",
            caption: "The errors of a fixed shadow bias: where it is too small, the planet shadows itself, and where it \
                      is too large, shadows are lost next to the balls.",
            knob: Some(BIAS),
            picture: bias_error,
        },
        View {
            name: "sphere-error",
            caption: "The errors of a sphere's normals, as colours, by the textbook's formula: the farther away, and \
                      the nearer to the rim, the worse.",
            knob: Some(DISTANCE),
            picture: sphere_error,
        },
    ],
};

const SAMPLES: Knob = knob("n", Scale::Whole, [2.0, 32.0], 4.0, &[]);
const DEPTH: Knob = knob("depth", Scale::Whole, [0.0, 64.0], 4.0, &[]);
const CUT_OFF: Knob = knob(
    "least throughput",
    Scale::Logarithmic,
    [MIN_THROUGHPUT / 32.0, 1.0],
    MIN_THROUGHPUT,
    &[],
);
const BIAS: Knob = knob(
    "bias",
    Scale::Logarithmic,
    [1e-6, 0.1],
    SHADOW_BIAS,
    &[1e-6, 1e-2],
);
const DISTANCE: Knob = Knob {
    unit: "radii",
    ..knob("distance", Scale::Logarithmic, [1.0, 1e6], 1e3, &[10.0])
};

const fn knob(
    name: &'static str,
    scale: Scale,
    [min, max]: [f32; 2],
    default: f32,
    snapshot_settings: &'static [f32],
) -> Knob {
    Knob {
        name,
        unit: "",
        min,
        max,
        default,
        scale,
        snapshot_settings,
    }
}

fn by_depth(depth: f32) -> PathBudget {
    PathBudget {
        min_throughput: 0.0,
        ..PathBudget::new(depth as u32)
    }
}

fn by_throughput(min_throughput: f32) -> PathBudget {
    PathBudget {
        min_throughput,
        ..PathBudget::new(MAX_DEPTH)
    }
}

/// Returns the still life with one sample per pixel.
fn still_life(budget: PathBudget) -> Picture {
    let (scene, camera) = plain_scene("still-life");
    scalar_picture(scene, camera, budget, 1)
}

fn budget_error(budget: PathBudget) -> Picture {
    let (model, camera) = scene("still-life");
    error_map(still_life(budget), exact_picture(&model, camera))
}

/// Returns the still life by 2 × 2 samples, or n × n where these differ.
fn sampled(n: f32) -> Picture {
    let (model, camera) = scene("still-life");
    let budget = PathBudget::new(MAX_DEPTH);
    Picture::new(move |pixel| {
        let radiance = |point| model.trace(camera.ray(point), budget);
        adaptive(pixel, n as u32, &radiance)
    })
}

fn sampling_error(n: f32) -> Picture {
    let (scene, camera) = plain_scene("still-life");
    let budget = PathBudget::new(MAX_DEPTH);
    error_map(sampled(n), finely_sampled(scene, camera, budget))
}

fn bias_error(bias: f32) -> Picture {
    let (scene, camera) = plain_scene("planet");
    let exact = exact_picture(&Model::Plain(scene.clone()), camera);
    let budget = PathBudget::new(MAX_DEPTH);
    let ours = move |pixel: Pixel| {
        let ray = from_eye(&scene.objects, camera.eye)(camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, |at, direction| {
            let origin = at.point + bias * face_forward(at.outward, -direction);
            untracked(Ray { origin, direction })
        })
    };
    error_map(Picture::new(ours), exact)
}

/// Returns the errors of a unit sphere's normals as colours, by the textbook's formula.
fn sphere_error(distance: f32) -> Picture {
    let sphere = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    let exact = trial::exactly(Shape::Sphere(sphere));
    let to_centre = 1.0 + distance;
    // The sphere's outline is a circle of radius 0.8 on the image plane.
    let focal_length = 0.8 * (to_centre * to_centre - 1.0).sqrt();
    let eye = to_centre * Vec3::NEG_Z;
    let camera = Camera::new(eye, Vec3::Z, Vec3::Y, focal_length).expect("a camera");
    let ours = move |pixel: Pixel| {
        canvas::count_ray();
        let ray = camera.ray(pixel.centre());
        let t = sphere.distance_quadratic(&ray, T_MAX);
        t.map_or(SKY, |t| (sphere.normal(ray.at(t)) + 1.0) / 2.0)
    };
    let exact = move |pixel: Pixel| {
        let ray = exact_ray(camera.ray(pixel.centre()));
        let normal = |t: f64| exact.normal(ray.origin + t * ray.direction).as_vec3();
        let t = exact.distance(&ray, false);
        t.map_or(SKY, |t| (normal(t) + 1.0) / 2.0)
    };
    error_map(Picture::new(ours), Picture::new(exact))
}

/// Returns the oracle's picture in f64, which follows the same camera rays to the end.
fn exact_picture(model: &Model, camera: Camera) -> Picture {
    let scene = model.exactly();
    let limit = Limit {
        bounces: 1000,
        min_throughput: 1e-6,
    };
    Picture::new(move |pixel| {
        let ray = exact_ray(camera.ray(pixel.centre()));
        oracle::trace(&scene, &ray, limit).as_vec3()
    })
}

fn exact_ray(ray: Ray) -> oracle::Ray {
    oracle::Ray {
        origin: ray.origin.as_dvec3(),
        direction: ray.direction.as_dvec3(),
        from: None,
    }
}
