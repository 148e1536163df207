//! The hits of a packet on one object: shading and scattering in lanes.

use crate::{Lanes, Packet, Vec3x16};
use plane_hit::{Object, Shape, Texture};
use refraction::{Material, Optics};
use shading::{Phong, powi};
use shadows::{MIN_COS_THETA, PointLight, ROUNDING};
use sphere_hit::Sphere;

// ANCHOR: interaction
/// The hits of a packet's rays on one and the same object.
pub struct Interactions<'a> {
    pub index: usize,
    pub shape: &'a Shape,
    pub material: &'a Material,
    /// Mask of the rays that have hit it.
    pub active: Lanes,
    pub point: Vec3x16,
    pub incident: Vec3x16,
    pub outward: Vec3x16,
    pub normal: Vec3x16,
    /// Mask of the rays that enter the object.
    pub enters: Lanes,
    /// The hit points, projected onto the surface: where new rays start.
    pub origin: Vec3x16,
}

impl<'a> Interactions<'a> {
    pub fn new(
        object: &'a Object<Material>,
        index: usize,
        rays: &Packet,
        t: Lanes,
        active: Lanes,
    ) -> Self {
        let point = rays.at(t);
        let incident = rays.direction;
        let outward = match &object.shape {
            Shape::Sphere(sphere) => {
                let from_centre = point - Vec3x16::splat(sphere.centre);
                (from_centre / sphere.radius).normalize_or_y()
            }
            Shape::Plane(plane) => Vec3x16::splat(plane.normal),
        };
        let enters = rays.is_entered(&object.shape, t);
        let facing = |outward: Vec3x16| enters.select(outward, outward * -1.0);
        let mut normal = facing(outward);
        let cos_theta = -normal.dot(incident);
        let grazes = active & cos_theta.simd_lt(MIN_COS_THETA);
        if grazes.any() {
            let turned = (normal + incident * (cos_theta - MIN_COS_THETA)).normalize();
            normal = grazes.select(turned, normal);
        }
        let outward = facing(normal);
        Self {
            index,
            shape: &object.shape,
            material: &object.material,
            active,
            point,
            incident,
            outward,
            normal,
            enters,
            origin: project_to_surface(&object.shape, point, outward),
        }
    }

    /// Returns a mask of the hits that have a light in front of them.
    pub fn are_in_front(&self, light: &PointLight) -> Lanes {
        let light = &light.position;
        let (height, surface) = match self.shape {
            Shape::Plane(plane) => {
                (Lanes::splat(plane.normal.dot(light - plane.point)), 0.0)
            }
            Shape::Sphere(Sphere { centre, radius }) => {
                let height = self.outward.dot(Vec3x16::splat(light - centre));
                (height, radius * (1.0 + ROUNDING))
            }
        };
        let [above, below] = [height.simd_gt(surface), height.simd_lt(surface)];
        self.enters.select(above, below)
    }

    /// Returns the rays that leave the object, as `shadow_acne::from_surface` does.
    pub fn spawn(&self, direction: Vec3x16, active: Lanes) -> Packet {
        Packet {
            origin: self.origin,
            direction,
            origin_object: Some(self.index),
            enters: self.outward.dot(direction).simd_lt(0.0),
            active,
        }
    }
}
// ANCHOR_END: interaction

// ANCHOR: shading
/// Returns the points, moved onto the surface.
#[inline]
pub fn project_to_surface(shape: &Shape, point: Vec3x16, outward: Vec3x16) -> Vec3x16 {
    match shape {
        Shape::Sphere(sphere) => Vec3x16::splat(sphere.centre) + outward * sphere.radius,
        Shape::Plane(plane) => {
            point - outward * (point - Vec3x16::splat(plane.point)).dot(outward)
        }
    }
}

/// Returns the colours at some points of a surface.
#[inline]
pub fn colour(texture: Texture, shape: &Shape, point: Vec3x16) -> Vec3x16 {
    match texture {
        Texture::Solid(colour) => Vec3x16::splat(colour),
        Texture::Checker(even, odd) => {
            let [u, v] = match shape {
                Shape::Sphere(Sphere { centre, .. }) => {
                    [point.x - centre.x, point.z - centre.z]
                }
                Shape::Plane(plane) => {
                    let from_origin = point - Vec3x16::splat(plane.point);
                    plane.axes.map(|axis| from_origin.dot(Vec3x16::splat(axis)))
                }
            };
            let sum = u.floor() + v.floor();
            let is_even = (sum - 2.0 * (sum / 2.0).floor()).simd_eq(0.0);
            is_even.select(Vec3x16::splat(even), Vec3x16::splat(odd))
        }
    }
}

/// Returns the light that a surface reflects from lights of intensity 1, and a mask of the
/// lanes in which there is any.
#[inline]
pub fn phong(
    surface: &Phong,
    colour: Vec3x16,
    at: &Interactions,
    to_light: Vec3x16,
) -> (Vec3x16, Lanes) {
    let cos_theta_l = from_0_to_1(at.normal.dot(to_light));
    let mut sum = colour * (surface.diffuse * cos_theta_l);
    if surface.specular > 0.0 {
        let reflected = at.normal * (2.0 * cos_theta_l) - to_light;
        let cos_alpha = from_0_to_1(-reflected.dot(at.incident));
        if (at.active & cos_alpha.simd_gt(0.0)).any() {
            sum = sum + surface.specular * powi(cos_alpha, surface.shininess);
        }
    }
    let is_black = sum.x.simd_eq(0.0) & sum.y.simd_eq(0.0) & sum.z.simd_eq(0.0);
    (sum, !is_black)
}

fn from_0_to_1(cos: Lanes) -> Lanes {
    let at_most_1 = cos.simd_gt(1.0).select(Lanes::splat(1.0), cos);
    cos.simd_gt(0.0).select(at_most_1, Lanes::splat(0.0))
}
// ANCHOR_END: shading

// ANCHOR: scatter
/// Returns the reflected and the transmitted rays, each as weights and unit directions; `None`
/// if no ray is scattered.
#[inline]
pub fn scatter(optics: &Optics, at: &Interactions) -> [Option<(Lanes, Vec3x16)>; 2] {
    let Interactions {
        incident, normal, ..
    } = *at;
    let reflected = || (incident - normal * (2.0 * normal.dot(incident))).normalize();
    match *optics {
        Optics::Opaque { reflectivity } => {
            let reflects = reflectivity > 0.0;
            [
                reflects.then(|| (Lanes::splat(reflectivity), reflected())),
                None,
            ]
        }
        Optics::Dielectric {
            eta_inside,
            eta_outside,
        } => {
            let [inside, outside] = [eta_inside, eta_outside].map(Lanes::splat);
            let eta_i = at.enters.select(outside, inside);
            let eta_t = at.enters.select(inside, outside);
            let (refracted, is_refracted) = refract(incident, normal, eta_i / eta_t);
            let reflectance = fresnel(-normal.dot(incident), eta_i, eta_t);
            let reflectance = is_refracted.select(reflectance, Lanes::splat(1.0));
            [
                Some((reflectance, reflected())),
                Some((1.0 - reflectance, refracted)),
            ]
        }
    }
}

/// Returns the refracted directions, and a mask of the lanes without total reflection.
fn refract(incident: Vec3x16, normal: Vec3x16, eta: Lanes) -> (Vec3x16, Lanes) {
    let cos_theta_i = -normal.dot(incident);
    let tangential = incident + normal * cos_theta_i;
    let sin2_theta_t = eta * eta * tangential.dot(tangential);
    let refracted = (tangential * eta - normal * (1.0 - sin2_theta_t).sqrt()).normalize();
    let is_same_index = eta.simd_eq(1.0);
    let is_refracted = is_same_index | sin2_theta_t.simd_lt(1.0);
    (is_same_index.select(incident, refracted), is_refracted)
}
// ANCHOR_END: scatter

// ANCHOR: fresnel
fn fresnel(cos_theta_i: Lanes, eta_i: Lanes, eta_t: Lanes) -> Lanes {
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i) * (1.0 + cos_theta_i);
    let cos_theta_t = (1.0 - sin2_theta_t).sqrt();
    let r_parl = (eta_t * cos_theta_i - eta_i * cos_theta_t)
        / (eta_t * cos_theta_i + eta_i * cos_theta_t);
    let r_perp = (eta_i * cos_theta_i - eta_t * cos_theta_t)
        / (eta_i * cos_theta_i + eta_t * cos_theta_t);
    let reflectance = (r_parl * r_parl + r_perp * r_perp) / 2.0;
    let reflectance = sin2_theta_t
        .simd_lt(1.0)
        .select(reflectance, Lanes::splat(1.0));
    eta_i.simd_eq(eta_t).select(Lanes::splat(0.0), reflectance)
}
// ANCHOR_END: fresnel
