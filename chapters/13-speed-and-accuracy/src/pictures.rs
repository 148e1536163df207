//! Small pictures of the book's scenes, to be measured.

use crate::scenes::{self, Model, exact_camera};
use canvas::{Canvas, Picture, Pixel};
use glam::{DVec3, UVec2};
use oracle::Limit;
use ray_casting::{Camera, Ray};
use rayon::prelude::*;
use reflection::Reach;

/// A scene, and the camera that looks at it.
pub type Sight = (Model, Camera);

/// The book's scene called `name`.
///
/// # Panics
/// If none is.
#[must_use]
pub fn sight(name: &str) -> Sight {
    (scenes::find(name).expect("a scene of the book").make)()
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
