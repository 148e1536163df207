//! What costs more when there is more of it.

mod spheres;

use crate::chart::{Axis, Chart, Quantity};
use crate::pictures::{Sight, camera_rays, paint, pixels, sight};
use crate::scenes::Model;
use crate::study::{Clock, Job, Measurement, Study, each};
use anti_aliasing::regular;
use canvas::{Canvas, Picture, Pixel};
use glam::{UVec2, Vec3};
use ray_casting::Ray;
use reflection::{LEAST_WEIGHT, MAX_DEPTH, Reach};
use std::sync::Arc;

/// The cost of more pixels, samples, lamps, bounces and spheres.
///
/// In a "picture" the setting is how many times as many there are as in 20 by 15 pixels
/// with a sample each and two lamps, and work and nanoseconds are those of the whole
/// picture. Of "depth", they are rays and nanoseconds of one pixel; of "spheres", tests of
/// spheres and boxes for one ray, and its nanoseconds, and wrong is a hit that is not brute
/// force's.
pub const STUDY: Study = Study {
    name: "growth",
    title: "What more pixels, samples, lamps, bounces and spheres cost",
    measure,
    charts: &[
        by_setting(
            "spheres",
            "spheres",
            (Quantity::Ns, "nanoseconds for a ray"),
            "Spheres, all tried or by a tree of boxes: for a handful it is not worth it",
        ),
        by_setting(
            "depth",
            "depth",
            (Quantity::Work, "rays for a pixel"),
            "Bounces: glass in glass multiplies the rays, until the cut-off ends them",
        ),
        by_setting(
            "picture",
            "times as many",
            (Quantity::Ns, "nanoseconds for the picture"),
            "The still life: as many times the pixels or samples, as many times the time",
        ),
    ],
    table: include_str!("../../../../book/src/studies/growth.csv"),
};

const fn by_setting(
    scene: &'static str,
    setting: &'static str,
    (quantity, label): (Quantity, &'static str),
    title: &'static str,
) -> Chart {
    Chart {
        title,
        scene,
        x: Axis::new(Quantity::Setting, setting),
        y: Axis::new(quantity, label),
        front: false,
    }
}

const SIZE: UVec2 = UVec2::new(40, 30);
/// Of what is timed, for short jobs.
const FEW: UVec2 = UVec2::new(20, 15);

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut rows = spheres::measure(clock);
    rows.extend(depths(clock));
    rows.extend(pictures(clock));
    rows
}

type Light = Arc<dyn Fn(Pixel) -> Vec3 + Send + Sync>;

/// The still life by n × n samples, and so many lamps about each of its own.
fn lit(n: u32, lamps: u32) -> Light {
    let (mut model, camera) = sight("still-life");
    let mut random = fastrand::Rng::with_seed(13);
    if let Model::Plain(scene) = &mut model {
        scene.lights = scene.lights.repeat(lamps as usize);
        for light in &mut scene.lights {
            light.position += spheres::anywhere(&mut random);
            light.intensity /= lamps as f32;
        }
    }
    let reach = Reach::new(MAX_DEPTH);
    let light = move |point| model.trace(camera.ray(point), reach);
    Arc::new(move |pixel| regular(pixel, n, &light))
}

fn pictures(clock: &Clock) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for n in [1, 2, 4, 8] {
        let methods = [
            ("pixels", FEW * n, lit(1, 1)),
            ("samples", FEW, lit(n, 1)),
            ("lamps", FEW, lit(1, n * n)),
        ];
        let job = |(_, size, light): &(_, UVec2, Light)| -> Job {
            let (light, pixels) = (light.clone(), pixels(*size).collect::<Vec<_>>());
            Box::new(move || each(&pixels, |&pixel| light(pixel))())
        };
        let times = clock.least(1, &mut methods.each_ref().map(job));
        for ((method, size, light), ns) in methods.into_iter().zip(times) {
            let canvas = Canvas::paint(&Picture::new(move |pixel| light(pixel)), size);
            rows.push(Measurement {
                work: Some(canvas.rays as f64),
                ns,
                ..Measurement::of("picture", method, f64::from(n * n))
            });
        }
    }
    rows
}

fn depths(clock: &Clock) -> Vec<Measurement> {
    let sights = ["still-life", "nested"].map(|name| {
        let sight = sight(name);
        let rays = camera_rays(&sight.1, FEW);
        (sight, rays)
    });
    let [still_life, nested] = &sights;
    let sweeps = [
        ("still life", still_life, 0.0, 64),
        ("still life, cut off", still_life, LEAST_WEIGHT, 64),
        ("nested glass", nested, 0.0, 12),
        ("nested, cut off", nested, LEAST_WEIGHT, 64),
    ];
    let cases = sweeps
        .into_iter()
        .flat_map(|(method, seen, least_weight, deepest)| {
            let depths = [0, 1, 2, 4, 6, 8, 10, 12, 16, 32, 64].into_iter();
            depths
                .filter(move |&depth| depth <= deepest)
                .map(move |depth| {
                    let reach = Reach::new(depth);
                    (
                        method,
                        seen,
                        Reach {
                            least_weight,
                            ..reach
                        },
                    )
                })
        });
    let cases: Vec<_> = cases.collect();
    let mut jobs = Vec::new();
    for &(_, (sight, rays), reach) in &cases {
        jobs.push(each(rays, move |&ray: &Ray| sight.0.trace(ray, reach)));
    }
    let times = clock.least(still_life.1.len(), &mut jobs);
    let row = |(&(method, (sight, _), reach), ns): (&(_, &(Sight, _), Reach), _)| {
        let canvas = paint(sight, SIZE, reach);
        Measurement {
            work: Some(canvas.rays as f64 / canvas.light.len() as f64),
            ns,
            ..Measurement::of("depth", method, f64::from(reach.depth))
        }
    };
    cases.iter().zip(times).map(row).collect()
}
