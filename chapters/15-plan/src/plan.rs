//! A plan for a scene: its tolerance, and the largest radiance along any ray.

use canvas::{decode, encode};
use glam::{Vec2, Vec3};
use plane_hit::Texture;
use refraction::{Material, Optics};
use shading::Phong;
use shadow_acne::SurfaceRay;
use shadows::{PointLight, Scene};
use transparency::{Absorbing, shadow_transmittance};

// ANCHOR: plan
/// Decides how far rays are followed in a scene, and how many samples a pixel takes.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The scene.
    pub scene: Scene<Absorbing>,
    /// The target for the RMS error of the pixels, in levels; positive.
    pub tolerance: f32,
    /// The largest radiance, of the strongest colour, along any ray: a bound if all objects
    /// are opaque, and an estimate if there is glass.
    pub max_radiance: f32,
    /// Returns the fraction of a light's red, green and blue that arrives along a shadow ray
    /// from the light's position, some distance away.
    pub visibility: fn(&Scene<Absorbing>, &SurfaceRay, Vec3, f32) -> Vec3,
}

/// Default tolerance: half an 8-bit sRGB level.
pub const DEFAULT_TOLERANCE: f32 = 0.5;
// ANCHOR_END: plan

impl Plan {
    // ANCHOR: new
    /// Returns the plan for a scene and a tolerance in levels.
    pub fn new(scene: Scene<Absorbing>, tolerance: f32) -> Self {
        let mut emitters = vec![(scene.background.max_element(), 0.0)];
        let mut highlight = 0.0;
        for object in &scene.objects {
            let Material { phong, optics } = &object.material.material;
            let radiance = own_radiance(phong, &scene.lights);
            match *optics {
                Optics::Opaque { reflectivity } => {
                    emitters.push((radiance, reflectivity))
                }
                Optics::Dielectric { .. } => {
                    if radiance > highlight {
                        highlight = radiance;
                    }
                }
            }
        }
        Self {
            scene,
            tolerance,
            max_radiance: highlight + max_radiance(&emitters),
            visibility: shadow_transmittance,
        }
    }

    /// Returns the plan for a scene in which nothing absorbs light, and even glass casts a
    /// black shadow.
    pub fn with_black_shadows(scene: Scene<Material>, tolerance: f32) -> Self {
        let absorption = Vec3::ZERO;
        let scene = scene.map(|material| Absorbing {
            material,
            absorption,
        });
        Self {
            visibility: |scene, ray, light, distance| {
                Vec3::splat(f32::from(!ray.is_occluded(&scene.objects, light, distance)))
            },
            ..Self::new(scene, tolerance)
        }
    }
    // ANCHOR_END: new

    // ANCHOR: tolerance
    /// Returns the tolerance as linear light, at some radiance of a channel: the distance of
    /// its level's light from that of the level below, times the tolerance in levels.
    pub(crate) fn tolerance_at(&self, radiance: f32) -> f32 {
        // Level 0 has no level below it; its own width is level 1's.
        let level = encode(Vec3::splat(radiance))[0].max(1);
        self.tolerance * (decode(level) - decode(level - 1))
    }
    // ANCHOR_END: tolerance
}

// ANCHOR: max-radiance
/// Returns the largest radiance that a surface has by the lights alone, of its strongest
/// colour.
fn own_radiance(surface: &Phong, lights: &[PointLight]) -> f32 {
    let [even, odd] = match surface.colour {
        Texture::Solid(colour) => [colour; 2],
        Texture::Checker(even, odd) => [even, odd],
    };
    let colour = Vec2::new(even.max_element(), odd.max_element()).max_element();
    let intensity: f32 = lights.iter().map(|light| light.intensity).sum();
    surface.ambient * colour + intensity * (surface.diffuse * colour + surface.specular)
}

/// Returns the largest radiance along any ray, from the radiance that each emitter has of its
/// own, and its reflectivity. No emitter reflects itself.
///
/// The brightest path alternates between two of them in the end:
/// E₁ + ρ₁ (E₂ + ρ₂ (E₁ + …)) = (E₁ + ρ₁ E₂) / (1 − ρ₁ ρ₂).
fn max_radiance(emitters: &[(f32, f32)]) -> f32 {
    let mut largest = 0.0;
    for (i, &(e1, rho1)) in emitters.iter().enumerate() {
        for (j, &(e2, rho2)) in emitters.iter().enumerate() {
            let series = (e1 + rho1 * e2) / (1.0 - rho1 * rho2);
            let radiance = if i == j { e1 } else { series };
            if radiance > largest {
                largest = radiance;
            }
        }
    }
    largest
}
// ANCHOR_END: max-radiance
