//! How many samples a pixel takes.

use crate::{Plan, Sample};
use anti_aliasing::sobol::{image_point, sample_position};
use canvas::{Picture, Pixel, rays_so_far};
use glam::{Vec2, Vec3};
use ray_casting::Camera;

// ANCHOR: sample
/// The fewest samples of a pixel that is not uniform.
const MIN_SAMPLES: usize = 32;

/// The most samples of a pixel.
const MAX_SAMPLES: usize = 1024;

impl Plan {
    /// Returns the radiance of a pixel. `sample` samples a point of the image plane.
    ///
    /// There are eight probe samples, at the corners and in the quarters of the pixel, as in
    /// Whitted 1980. If all have the same signature and nearly the same radiance, the pixel is
    /// their mean. Otherwise the corners are dropped, and samples within are added.
    pub fn sample_pixel(&self, pixel: Pixel, sample: &dyn Fn(Vec2) -> Sample) -> Vec3 {
        let rays_before = rays_so_far();
        let corners = [Vec2::ZERO, Vec2::X, Vec2::Y, Vec2::ONE];
        let corners = corners.map(|corner| sample(image_point(pixel, corner)));
        let inside = |i| sample(image_point(pixel, sample_position(pixel, i)));
        let mut samples = [corners, [0, 1, 2, 3].map(inside)].concat();
        let rays = (rays_so_far() - rays_before) as f32 / samples.len() as f32;
        let is_same = |other: &Sample| other.signature == samples[0].signature;
        if !samples.iter().all(is_same) || !self.is_enough(&samples, rays) {
            samples.drain(..corners.len());
            while samples.len() < MIN_SAMPLES
                || samples.len() < MAX_SAMPLES && !self.is_enough(&samples, rays)
            {
                let n = samples.len() as u32;
                samples.extend((n..2 * n).map(inside));
            }
        }
        mean(&samples)
    }

    /// Returns whether further samples, of some `rays` each, would be better spent on other
    /// pixels. N stratified samples of deviation σ have an error of about σ N^(−3/4) at an
    /// edge. A picture's error is least for its rays if σ N^(−5/4) / √rays is the same in all
    /// pixels; with 16 samples of 16 rays, that is a sixteenth of the error.
    fn is_enough(&self, samples: &[Sample], rays: f32) -> bool {
        let n = samples.len() as f32;
        let mean = mean(samples);
        let deviations = samples.iter().map(|sample| sample.radiance - mean);
        let variance = deviations.map(|d| d * d).sum::<Vec3>() / n;
        let scale = n * n.sqrt().sqrt() * rays.sqrt();
        (0..3).all(|i| variance[i].sqrt() / scale <= self.tolerance_at(mean[i]) / 16.0)
    }
}

fn mean(samples: &[Sample]) -> Vec3 {
    let sum: Vec3 = samples.iter().map(|sample| sample.radiance).sum();
    sum / samples.len() as f32
}
// ANCHOR_END: sample

// ANCHOR: picture
/// The fraction of the largest radiance that pending rays are assumed to have in a picture,
/// where only the mean of many samples counts. Found by experiment, from 1/2 to 1/16.
const TYPICAL_FRACTION: f32 = 1.0 / 4.0;

impl Plan {
    /// Returns the picture of the scene, with as many samples and rays as it needs.
    pub fn picture(mut self, camera: Camera) -> Picture {
        self.max_radiance *= TYPICAL_FRACTION;
        Picture::new(move |pixel| {
            self.sample_pixel(pixel, &|point| self.trace(camera.ray(point)))
        })
    }
}
// ANCHOR_END: picture
