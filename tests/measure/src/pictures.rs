//! Small pictures of the book's scenes, for measurements.

use crate::scenes::{Model, exact_camera};
use anti_aliasing::sobol::sample_position;
use anti_aliasing::{hash, regular};
use canvas::{Canvas, Picture, Pixel};
use glam::{DVec3, UVec2, Vec3};
use oracle::Limit;
use ray_casting::{Camera, Ray};
use rayon::ThreadPool;
use rayon::prelude::*;
use reflection::PathBudget;
use refraction::Material;
use shadow_acne::{from_eye, from_surface};
use shadows::Scene;

/// Returns the rays through the pixels' centres.
#[must_use]
pub fn camera_rays(camera: &Camera, size: UVec2) -> Vec<Ray> {
    let ray = |pixel: Pixel| camera.ray(pixel.centre());
    Pixel::all(size).map(ray).collect()
}

/// Returns the canvas of a scene with one sample per pixel, by the chapters' own tracers.
#[must_use]
pub fn render(model: &Model, camera: Camera, size: UVec2, budget: PathBudget) -> Canvas {
    let model = model.clone();
    let picture =
        Picture::new(move |pixel| model.trace(camera.ray(pixel.centre()), budget));
    Canvas::render(&picture, size)
}

/// Returns the oracle's radiance for the same samples, row by row from the top.
#[must_use]
pub fn exact_radiance(
    model: &Model,
    camera: &Camera,
    size: UVec2,
    limit: Limit,
) -> Vec<DVec3> {
    let (scene, camera) = (model.exactly(), exact_camera(camera));
    let size = size.to_array();
    let centres: Vec<_> = oracle::pixel_centres(size).collect();
    let radiance = |&at| oracle::trace(&scene, &camera.ray(at, size), limit);
    centres.par_iter().map(radiance).collect()
}

/// Returns two means of a pixel by the oracle, each at points of its own: of 1,024 samples if
/// these hardly differ, of 4,096 if two means of so many differ by no more than a tenth of a
/// level, and otherwise of 16,384.
#[must_use]
pub fn exact_means(
    scene: &oracle::Scene,
    camera: &oracle::Camera,
    pixel: Pixel,
    limit: Limit,
) -> [DVec3; 2] {
    let corner = UVec2::new(pixel.x, pixel.y).as_dvec2();
    let radiance = |seed: u32, i| {
        // Sobol's sequence, scrambled as that of another pixel.
        let x = hash(pixel.x ^ seed);
        let position = sample_position(Pixel { x, ..pixel }, i);
        let at = corner + position.as_dvec2();
        oracle::trace(scene, &camera.ray(at, pixel.size.to_array()), limit)
    };
    let mut samples = [Vec::new(), Vec::new()];
    for count in [1024, 4096, 16384] {
        for (samples, seed) in samples.iter_mut().zip([1, 2]) {
            let so_far = samples.len() as u32;
            samples.extend((so_far..count).map(|i| radiance(seed, i)));
        }
        let means = means(&samples);
        let [a, b] = means.map(|mean| mean.map(oracle::level));
        let is_enough = match count {
            1024 => samples.iter().all(|samples| range(samples) <= 4.0),
            _ => (a - b).abs().max_element() <= 0.1,
        };
        if is_enough {
            return means;
        }
    }
    means(&samples)
}

fn means(samples: &[Vec<DVec3>; 2]) -> [DVec3; 2] {
    let mean =
        |samples: &Vec<DVec3>| samples.iter().sum::<DVec3>() / samples.len() as f64;
    samples.each_ref().map(mean)
}

/// Returns how far the levels of samples are apart.
fn range(samples: &[DVec3]) -> f64 {
    let levels = samples.iter().map(|sample| sample.map(oracle::level));
    let (least, most) = levels.fold(
        (DVec3::INFINITY, DVec3::NEG_INFINITY),
        |(least, most), levels| (least.min(levels), most.max(levels)),
    );
    (most - least).max_element()
}

/// Returns the picture of a scene by n × n samples per pixel, ray by ray.
#[must_use]
pub fn scalar_picture(
    scene: Scene<Material>,
    camera: Camera,
    budget: PathBudget,
    n: u32,
) -> Picture {
    let start = from_eye(&scene.objects, camera.eye);
    let radiance = move |point| {
        let ray = start(camera.ray(point));
        shadow_acne::trace(&scene, &ray, budget, from_surface)
    };
    Picture::new(move |pixel| regular(pixel, n, &radiance))
}

/// Returns the picture of a scene by n × n samples per pixel, traced in packets.
#[must_use]
pub fn packet_picture(
    scene: Scene<Material>,
    camera: Camera,
    budget: PathBudget,
    n: u32,
) -> Picture {
    Picture::from_spans(move |first, span| {
        packets::render(&scene, &camera, budget, n, first, span);
    })
}

/// Returns the radiance of a picture, rendered on this thread in spans of a given number of
/// pixels, or to the end of the row.
#[must_use]
pub fn frame(picture: &Picture, size: UVec2, span: usize) -> Vec<Vec3> {
    let mut radiance = vec![Vec3::ZERO; size.element_product() as usize];
    for (y, row) in (0..).zip(radiance.chunks_mut(size.x as usize)) {
        for (x, span) in (0..).step_by(span).zip(row.chunks_mut(span)) {
            picture.render_span(Pixel { x, y, size }, span);
        }
    }
    radiance
}

/// Returns a pool of this number of threads.
///
/// # Panics
/// If the system refuses to create them.
#[must_use]
pub fn pool(threads: usize) -> ThreadPool {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().expect("threads")
}
