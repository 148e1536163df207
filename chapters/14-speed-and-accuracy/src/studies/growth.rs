//! The growth of the cost with pixels, samples, lights, bounces and spheres.

use super::recursion::trace_times;
use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Choice, Clock, Study, each};
use crate::table::Measurement;
use anti_aliasing::regular;
use canvas::{Canvas, Picture};
use glam::UVec2;
use measure::Random;
use measure::bvh::{Bvh, anywhere, cloud, packets, rays};
use measure::pictures::{frame, render};
use measure::scenes::{plain_scene, scene};
use packets::LANES;
use plane_hit::nearest;
use ray_casting::Ray;
use reflection::{MAX_DEPTH, MIN_THROUGHPUT, PathBudget};
use shadow_acne::{from_eye, from_surface, trace};

/// The cost of more pixels, samples, lights, bounces and spheres.
///
/// In a "picture" the setting is how many times as many there are as in [`FEW`] pixels
/// with a sample each and two lights, and work and nanoseconds are those of the whole
/// picture. Of "depth", they are rays and nanoseconds of one pixel; of "spheres", the
/// nanoseconds of one ray.
pub const STUDY: Study = Study {
    name: "growth",
    title: "What more pixels, samples, lights, bounces and spheres cost",
    measure: |clock| [spheres(clock), depths(clock), pictures(clock)].concat(),
    chosen: &[
        Choice::of("all, camera"),
        Choice::of("all, random"),
        Choice::of("still life, cut off"),
        Choice::of("nested, cut off"),
    ],
    charts: &[
        Chart::new("spheres", (Quantity::Setting, "spheres"), RAY_TIME).titled(
            "Spheres, all tried or by a tree of boxes: for a handful it is not worth it",
        ),
        Chart::new("depth", (Quantity::Setting, "depth"), RAYS).titled(
            "Bounces: glass in glass multiplies the rays, until the cut-off ends them",
        ),
        Chart::new("picture", (Quantity::Setting, "times as many"), TIME).titled(
            "The still life: as many times the pixels or samples, as many times the time",
        ),
    ],
};

/// The size of the smallest picture, in pixels.
pub const FEW: UVec2 = UVec2::new(20, 15);

const RAY_TIME: Axis = (Quantity::Ns, "nanoseconds per ray");
const RAYS: Axis = (Quantity::Work, "rays per pixel");
const TIME: Axis = (Quantity::Ns, "nanoseconds per picture");

fn spheres(clock: &Clock) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for (name, rays) in rays() {
        for count in [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 4000] {
            let objects = cloud(count);
            let bvh = Bvh::new(&objects);
            // Few rays for many spheres: a short job is not interrupted.
            let few = rays.as_chunks::<LANES>().0.iter();
            let few = few.step_by(objects.len().div_ceil(64)).flatten();
            let few: Vec<Ray> = few.copied().collect();
            let packets = packets(&few);
            let mut methods = vec![
                ("all", few.len(), each(&few, |ray| nearest(&objects, ray))),
                ("tree", rays.len(), each(&rays, |ray| bvh.nearest(ray))),
            ];
            // Random rays have no neighbours to make a packet with.
            if name == "camera" {
                let job = each(&packets, |packet| packet.nearest(&objects));
                methods.push(("in lanes", few.len(), job));
            }
            let (names, jobs): (Vec<_>, Vec<_>) = methods
                .into_iter()
                .map(|(name, rays, job)| ((name, rays), job))
                .unzip();
            let times = clock.min_of_rounds(1, jobs);
            for ((method, count_of_rays), ns) in names.into_iter().zip(times) {
                rows.push(Measurement {
                    ns: ns.map(|ns| ns / count_of_rays as f64),
                    ..Measurement::of(
                        "spheres",
                        format!("{method}, {name}"),
                        count.into(),
                    )
                });
            }
        }
    }
    rows
}

fn depths(clock: &Clock) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for (method, name, min_throughput, deepest) in [
        ("still life", "still-life", 0.0, 64),
        ("still life, cut off", "still-life", MIN_THROUGHPUT, 64),
        ("nested glass", "nested", 0.0, 12),
        ("nested, cut off", "nested", MIN_THROUGHPUT, 64),
    ] {
        let (model, camera) = scene(name);
        let depths = [0, 1, 2, 4, 6, 8, 10, 12, 16, 32, 64].into_iter();
        let depths = depths.filter(|&depth| depth <= deepest);
        let budget = |depth| PathBudget {
            min_throughput,
            ..PathBudget::new(depth)
        };
        let budgets: Vec<PathBudget> = depths.map(budget).collect();
        let times = trace_times(clock, &model, &camera, budgets.iter().copied());
        for (budget, ns) in budgets.into_iter().zip(times) {
            let size = UVec2::new(40, 30);
            let rays = render(&model, camera, size, budget).rays as f64;
            rows.push(Measurement {
                work: Some(rays / f64::from(size.element_product())),
                ns,
                ..Measurement::of("depth", method, budget.depth.into())
            });
        }
    }
    rows
}

/// Returns the still life by n × n samples, and as many `lights` about each of its own.
fn lit(n: u32, lights: u32) -> Picture {
    let (mut scene, camera) = plain_scene("still-life");
    let mut random = Random::new(13);
    scene.lights = scene.lights.repeat(lights as usize);
    for light in &mut scene.lights {
        light.position += anywhere(&mut random);
        light.intensity /= lights as f32;
    }
    let budget = PathBudget::new(MAX_DEPTH);
    let start = from_eye(&scene.objects, camera.eye);
    Picture::new(move |pixel| {
        regular(pixel, n, &|point| {
            trace(&scene, &start(camera.ray(point)), budget, from_surface)
        })
    })
}

fn pictures(clock: &Clock) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for n in [1, 2, 4, 8] {
        let methods = [
            ("pixels", FEW * n, lit(1, 1)),
            ("samples", FEW, lit(n, 1)),
            ("lights", FEW, lit(1, n * n)),
        ];
        let jobs = methods.each_ref().map(|(_, size, picture)| {
            each(&[()], move |()| frame(picture, *size, LANES))
        });
        let times = clock.min_of_rounds(1, jobs);
        for ((method, size, picture), ns) in methods.iter().zip(times) {
            rows.push(Measurement {
                work: Some(Canvas::render(picture, *size).rays as f64),
                ns,
                ..Measurement::of("picture", *method, f64::from(n * n))
            });
        }
    }
    rows
}
