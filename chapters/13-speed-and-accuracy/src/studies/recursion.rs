//! Chapters 6 and 8: when a ray is followed no farther.

use crate::chart::{Axis, Chart, Quantity};
use crate::pictures::{Sight, camera_rays, exact_light, paint, sight};
use crate::scenes::Model;
use crate::study::{Clock, Measurement, Study, each};
use canvas::Canvas;
use glam::{DVec3, UVec2, Vec3};
use oracle::Limit;
use ray_casting::Ray;
use reflection::{MAX_DEPTH, Reach};

/// A limit to the bounces, one to the share of the light, and both, in glass and between
/// mirrors; the setting is the depth, or k for a cut-off of 2⁻ᵏ.
///
/// Rays, shadow rays among them, and nanoseconds are those of one pixel. Errors are in
/// levels of a screen, not rounded, against the oracle; a pixel off by more than half a
/// level is wrong. Some pixels are left out, as a row of each scene says: there f32 sees
/// something else than f64, however far the rays are followed.
pub const STUDY: Study = Study {
    name: "recursion",
    title: "When to follow a ray no farther: after so many bounces, or when it brings too little",
    measure,
    charts: &[
        by_rays(
            "A ball of glass: the cut-off needs fewer rays than the depth",
            "ball",
        ),
        by_rays(
            "A ball in a bubble in a ball: by depth alone the rays multiply",
            "nested",
        ),
        by_rays(
            "Two mirrors of 0.99: one chain, in which both mean the same",
            "mirrors 0.99",
        ),
    ],
    table: include_str!("../../../../book/src/studies/recursion.csv"),
};

const fn by_rays(title: &'static str, scene: &'static str) -> Chart {
    Chart {
        title,
        scene,
        x: Axis::new(Quantity::Work, "rays for a pixel"),
        y: Axis {
            quantity: Quantity::Max,
            label: "largest error, in levels",
        },
        front: true,
    }
}

const SIZE: UVec2 = UVec2::new(64, 48);
/// Times are those of fewer pixels.
const TIMED: UVec2 = UVec2::new(20, 15);

/// To the end: between mirrors of 0.99 it comes after 1375 bounces, which need less than
/// half of a thread's usual stack of 2 MiB.
const DEEP: Reach = Reach {
    depth: 2048,
    weight: 1.0,
    least_weight: 1e-6,
};

/// In levels: a pixel that differs by more from the oracle's when both follow its rays to
/// the end is at an edge that f32 and f64 see on different sides, and is left out.
const DISAGREEMENT: f64 = 0.1;

struct Subject {
    name: &'static str,
    sight: Sight,
    /// The part of the light that is shown: what is too bright for a screen shows no error.
    exposure: f64,
    /// The most bounces that anybody would wait for if nothing else ended them.
    deepest: u32,
}

fn subjects() -> [Subject; 4] {
    let subject = |name, sight, exposure, deepest| Subject {
        name,
        sight,
        exposure,
        deepest,
    };
    [
        subject("ball", glass_alone("glass"), 1.0, MAX_DEPTH),
        subject("nested", glass_alone("nested"), 1.0, 16),
        subject("mirrors 0.9", sight("facing-mirrors"), 1.0, 1000),
        subject("mirrors 0.99", sight("endless-mirrors"), 0.1, 1000),
    ]
}

/// A scene of the book with nothing in it but its glass and its floor.
fn glass_alone(name: &str) -> Sight {
    let (mut model, camera) = sight(name);
    if let Model::Plain(scene) = &mut model {
        let is_kept = |name| ["floor", "glass"].contains(&name);
        scene.objects.retain(|object| is_kept(object.name));
    }
    (model, camera)
}

/// A method, its setting, and how far it lets a camera ray go.
type Way = (&'static str, f64, Reach);

fn ways(deepest: u32) -> Vec<Way> {
    let limit = |depth, least_weight| Reach {
        depth,
        least_weight,
        ..DEEP
    };
    let depths = (0..=6).chain([8, 10, 12, 16, 24, 32, 64, 128, 256, 512, 1000]);
    let depths = depths.filter(|&depth| depth <= deepest);
    let depths = depths.map(|depth| ("depth", f64::from(depth), limit(depth, 0.0)));
    let cut_off = |name, depth| {
        (4..=14_u32)
            .map(move |k| (name, f64::from(k), limit(depth, 1.0 / (1 << k) as f32)))
    };
    depths
        .chain(cut_off("cut-off", DEEP.depth))
        .chain(cut_off("depth 64 + cut-off", MAX_DEPTH))
        .chain([("to the end", 0.0, DEEP)])
        .collect()
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let subjects = subjects().into_iter();
    subjects
        .flat_map(|subject| compare(clock, &subject))
        .collect()
}

fn compare(clock: &Clock, subject: &Subject) -> Vec<Measurement> {
    let limit = Limit {
        bounces: DEEP.depth,
        share: f64::from(DEEP.least_weight),
    };
    let exact = exact_light(&subject.sight, SIZE, limit);
    let level = |light: DVec3| (subject.exposure * light).map(oracle::level);
    let errors = |canvas: &Canvas| -> Vec<DVec3> {
        let pairs = canvas.light.iter().zip(&exact);
        let error =
            |(light, exact): (&Vec3, &DVec3)| level(light.as_dvec3()) - level(*exact);
        pairs.map(error).map(DVec3::abs).collect()
    };
    let to_the_end = errors(&paint(&subject.sight, SIZE, DEEP));
    let is_kept = |pixel: usize| to_the_end[pixel].max_element() <= DISAGREEMENT;
    let kept: Vec<usize> = (0..exact.len()).filter(|&pixel| is_kept(pixel)).collect();

    let ways = ways(subject.deepest);
    let row = |(&(method, setting, reach), ns): (&Way, Option<f64>)| {
        let canvas = paint(&subject.sight, SIZE, reach);
        let errors = errors(&canvas);
        let errors = kept.iter().map(|&pixel| errors[pixel]);
        let wrong = errors.clone().filter(|error| error.max_element() > 0.5);
        Measurement {
            work: Some(canvas.rays as f64 / exact.len() as f64),
            wrong: Some(100.0 * wrong.count() as f64 / kept.len() as f64),
            ns,
            ..Measurement::of(subject.name, method, setting)
                .with_errors(errors.flat_map(|error| error.to_array()))
        }
    };
    let times = times(clock, subject, &ways);
    let mut rows: Vec<Measurement> = ways.iter().zip(times).map(row).collect();
    rows.push(Measurement {
        wrong: Some(100.0 - 100.0 * kept.len() as f64 / exact.len() as f64),
        ..Measurement::of(subject.name, "left out", 0.0)
    });
    rows
}

/// The nanoseconds for a pixel, each of the ways.
fn times(clock: &Clock, subject: &Subject, ways: &[Way]) -> Vec<Option<f64>> {
    let (model, camera) = &subject.sight;
    let rays = camera_rays(camera, TIMED);
    let job = |&(.., reach): &Way| each(&rays, move |&ray: &Ray| model.trace(ray, reach));
    clock.least(rays.len(), &mut ways.iter().map(job).collect::<Vec<_>>())
}
