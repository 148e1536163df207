//! The hits of a packet on one object: shading and scattering in lanes.

use crate::{Lanes, Packet, Vec3x16};
use plane_hit::{Object, Shape, Texture};
use refraction::{Material, Optics};
use shading::{Phong, powi};

// ANCHOR: interaction
/// The hits of a packet's rays on one and the same object.
pub struct Interactions<'a> {
    pub index: usize,
    pub material: &'a Material,
    /// Mask of the rays that have hit it.
    pub active: Lanes,
    pub point: Vec3x16,
    pub incident: Vec3x16,
    pub outward: Vec3x16,
    pub normal: Vec3x16,
    /// The hit points, projected onto the surface: where new rays start.
    pub origin: Vec3x16,
}

impl<'a> Interactions<'a> {
    pub fn new(
        object: &'a Object<Material>,
        index: usize,
        rays: &Packet,
        point: Vec3x16,
        active: Lanes,
    ) -> Self {
        let outward = match &object.shape {
            Shape::Sphere(sphere) => {
                let from_centre = point - Vec3x16::splat(sphere.centre);
                (from_centre / sphere.radius).normalize_or_y()
            }
            Shape::Plane(plane) => Vec3x16::splat(plane.normal),
        };
        Self {
            index,
            material: &object.material,
            active,
            point,
            incident: rays.direction,
            outward,
            normal: face_forward(outward, rays.direction),
            origin: project_to_surface(&object.shape, point, outward),
        }
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
/// Returns the normals on the side from which rays along `incident` come.
#[inline]
pub fn face_forward(normal: Vec3x16, incident: Vec3x16) -> Vec3x16 {
    let is_behind = normal.dot(incident).simd_gt(0.0);
    is_behind.select(normal * -1.0, normal)
}

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

/// Returns the colours at some points.
#[inline]
pub fn colour(texture: Texture, point: Vec3x16) -> Vec3x16 {
    match texture {
        Texture::Solid(colour) => Vec3x16::splat(colour),
        Texture::Checker(even, odd) => {
            let sum = point.x.floor() + point.z.floor();
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
    let cos_theta_l = at.normal.dot(to_light);
    let diffuse = colour * (surface.diffuse * cos_theta_l);
    let reflected = at.normal * (2.0 * cos_theta_l) - to_light;
    let cos_alpha = -reflected.dot(at.incident);
    let specular = surface.specular * powi(cos_alpha, surface.shininess);
    let sum = cos_alpha.simd_gt(0.0).select(diffuse + specular, diffuse);
    let is_black = sum.x.simd_eq(0.0) & sum.y.simd_eq(0.0) & sum.z.simd_eq(0.0);
    (sum, cos_theta_l.simd_gt(0.0) & !is_black)
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
            let leaves = at.outward.dot(incident).simd_gt(0.0);
            let eta_i = leaves.select(inside, outside);
            let eta_t = leaves.select(outside, inside);
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
