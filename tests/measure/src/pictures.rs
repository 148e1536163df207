//! Small pictures of the book's scenes, for measurements.

use crate::scenes::{Model, exact_camera};
use anti_aliasing::regular;
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

/// Returns the picture of a scene by n × n samples per pixel, ray by ray.
#[must_use]
pub fn scalar_picture(
    scene: Scene<Material>,
    camera: Camera,
    budget: PathBudget,
    n: u32,
) -> Picture {
    let radiance = move |point| {
        let ray = from_eye(&scene.objects, camera.ray(point));
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
