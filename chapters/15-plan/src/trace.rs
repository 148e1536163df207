//! Best-first tracing: the ray that may contribute most is next.

use crate::Plan;
use anti_aliasing::hash;
use fresnel::{fresnel, scatter};
use glam::Vec3;
use plane_hit::Texture;
use ray_casting::Ray;
use shading::shade;
use shadow_acne::{SurfaceRay, from_eye, from_surface};
use shadows::PointLight;
use transparency::{between_media, follow, shadow_ray};

// ANCHOR: sample
/// A sample of a pixel: the result of a camera ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// The radiance along the ray.
    pub radiance: Vec3,
    /// A hash of what the radiance comes from: the objects that are hit, the squares of a
    /// floor, and the lights that are visible from there.
    pub signature: u32,
}

/// A ray that is still to be traced.
struct PendingRay {
    ray: SurfaceRay,
    /// The fraction of its red, green and blue that reaches the pixel.
    throughput: Vec3,
}
// ANCHOR_END: sample

// ANCHOR: trace
/// Hits with a throughput at or below this do not enter a sample's signature.
const IDENTITY_THRESHOLD: f32 = 1.0 / 16.0;

/// The most rays of a sample, shadow rays aside: perfect mirrors reflect light for ever.
const MAX_RAYS: u32 = 1 << 10;

impl Plan {
    /// Returns the radiance along a ray, and its signature. Reflected and refracted rays are
    /// traced best-first, until all that are pending can contribute no
    /// more than the tolerance.
    ///
    /// Source: after Hall and Greenberg, "A Testbed for Realistic Image Synthesis" (1983).
    pub fn trace(&self, ray: Ray) -> Sample {
        let scene = &self.scene;
        let mut ray = from_eye(&scene.objects, ray.origin)(ray);
        let mut throughput = Vec3::ONE;
        let (mut sample, mut pending) = (Sample::default(), Vec::new());
        for _ in 0..MAX_RAYS {
            let (transmitted, hit) = follow(scene, &ray, between_media);
            throughput *= transmitted;
            if let Some((at, optics)) = hit {
                let phong = &scene.objects[at.index].material.material.phong;
                let spawn = |direction| from_surface(&at, direction);
                let mut identity = at.index as u32;
                if let Texture::Checker(..) = phong.colour {
                    identity ^= hash_vector(at.uv().floor().extend(0.0));
                }
                let visibility = |light: &PointLight, to_light, distance| {
                    let shadow_ray = shadow_ray(&at, to_light);
                    let visible =
                        (self.visibility)(scene, &shadow_ray, light.position, distance);
                    if visible != Vec3::ZERO {
                        identity ^= hash_vector(light.position);
                    }
                    visible
                };
                let radiance = shade(phong, &at, &scene.lights, visibility);
                sample.radiance += throughput * radiance;
                if throughput.max_element() > IDENTITY_THRESHOLD {
                    sample.signature = hash(sample.signature ^ identity);
                }
                let scattered = scatter(&optics, &at, fresnel);
                for (weight, direction) in scattered.into_iter().flatten() {
                    let (ray, throughput) = (spawn(direction), weight * throughput);
                    pending.push(PendingRay { ray, throughput });
                }
            } else {
                sample.radiance += throughput * scene.background;
            }
            let Some(next) = self.take_largest(&mut pending, sample.radiance) else {
                break;
            };
            PendingRay { ray, throughput } = next;
        }
        sample
    }

    /// Takes the first of the rays with the largest throughput. `None` if all together can
    /// contribute no more than the tolerance at the radiance that was found.
    fn take_largest(
        &self,
        rays: &mut Vec<PendingRay>,
        found: Vec3,
    ) -> Option<PendingRay> {
        let throughputs = rays.iter().map(|ray| ray.throughput.max_element());
        let bound = self.max_radiance * throughputs.clone().sum::<f32>();
        // The darkest channel has the smallest tolerance.
        if !(bound > self.tolerance_at(found.min_element())) {
            return None;
        }
        let from_last = throughputs.enumerate().rev();
        let (largest, _) = from_last.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        Some(rays.swap_remove(largest))
    }
}

fn hash_vector(vector: Vec3) -> u32 {
    let numbers = vector.to_array().into_iter();
    numbers.fold(0, |hashed, number| hash(hashed ^ number.to_bits()))
}
// ANCHOR_END: trace
