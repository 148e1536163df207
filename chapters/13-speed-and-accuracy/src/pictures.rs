//! Small pictures of the book's scenes, to be measured.

use crate::scenes::{self, Model, exact_camera};
use anti_aliasing::regular;
use canvas::{Canvas, Picture, Pixel};
use glam::{DVec3, UVec2, Vec3};
use oracle::Limit;
use ray_casting::{Camera, Ray};
use rayon::ThreadPool;
use rayon::prelude::*;
use reflection::Reach;
use refraction::Material;
use shadow_acne::{from_the_eye, from_the_surface};
use shadows::Scene;

/// A scene, and the camera that looks at it.
pub type Sight = (Model, Camera);

/// The same without coloured glass, which packets do not have.
pub type PlainSight = (Scene<Material>, Camera);

/// The book's scene called `name`.
///
/// # Panics
/// If none is.
#[must_use]
pub fn sight(name: &str) -> Sight {
    (scenes::find(name).expect("a scene of the book").make)()
}

/// The same without coloured glass.
///
/// # Panics
/// If no scene is called so, or its glass is coloured.
#[must_use]
pub fn plain_sight(name: &str) -> PlainSight {
    match sight(name) {
        (Model::Plain(scene), camera) => (scene, camera),
        (Model::Tinted(_), _) => panic!("{name} has coloured glass"),
    }
}

/// A picture's pixels, row by row from the top.
pub fn pixels(size: UVec2) -> impl Iterator<Item = Pixel> {
    (0..size.element_product()).map(move |i| Pixel {
        x: i % size.x,
        y: i / size.x,
        size,
    })
}

/// The rays through the pixels' centres.
#[must_use]
pub fn camera_rays(camera: &Camera, size: UVec2) -> Vec<Ray> {
    let ray = |pixel: Pixel| camera.ray(pixel.centre());
    pixels(size).map(ray).collect()
}

/// What the chapters see in the pixels' centres.
#[must_use]
pub fn paint((model, camera): &Sight, size: UVec2, reach: Reach) -> Canvas {
    let (model, camera) = (model.clone(), *camera);
    let picture =
        Picture::new(move |pixel| model.trace(camera.ray(pixel.centre()), reach));
    Canvas::paint(&picture, size)
}

/// What the oracle sees there: linear light, row by row from the top.
#[must_use]
pub fn exact_light((model, camera): &Sight, size: UVec2, limit: Limit) -> Vec<DVec3> {
    let (scene, camera) = (model.exactly(), exact_camera(camera));
    let size = size.to_array();
    let centres: Vec<_> = oracle::pixel_centres(size).collect();
    let light = |&at| oracle::trace(&scene, &camera.ray(at, size), limit);
    centres.par_iter().map(light).collect()
}

/// Chapter 10's picture by n × n rays for a pixel, one at once.
#[must_use]
pub fn one_by_one((scene, camera): PlainSight, reach: Reach, n: u32) -> Picture {
    let light = move |point| {
        let leaving = from_the_eye(camera.ray(point));
        shadow_acne::trace(&scene, leaving, reach, from_the_surface)
    };
    Picture::new(move |pixel| regular(pixel, n, &light))
}

/// The same by chapter 12.
#[must_use]
pub fn by_packets((scene, camera): PlainSight, reach: Reach, n: u32) -> Picture {
    Picture::by_runs(move |first, run| {
        packets::paint(&scene, &camera, reach, n, first, run);
    })
}

/// The light of a picture, painted on this thread in runs of so many pixels, or to the
/// end of the row.
#[must_use]
pub fn frame(picture: &Picture, size: UVec2, run: usize) -> Vec<Vec3> {
    let mut light = vec![Vec3::ZERO; size.element_product() as usize];
    for (y, row) in (0..).zip(light.chunks_mut(size.x as usize)) {
        for (x, run) in (0..).step_by(run).zip(row.chunks_mut(run)) {
            picture.paint(Pixel { x, y, size }, run);
        }
    }
    light
}

/// So many threads to paint on.
///
/// # Panics
/// If the system refuses them.
#[must_use]
pub fn pool(threads: usize) -> ThreadPool {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().expect("threads")
}
