//! What surfaces do with light, in lanes: chapters 2 to 10.

use crate::{Lanes, Vectors};
use plane_hit::{Pattern, Shape};
use refraction::Body;
use shading::{Phong, power};

// ANCHOR: shading
/// The normals on the side that rays along `incident` come from.
pub fn facing(normal: Vectors, incident: Vectors) -> Vectors {
    let is_behind = normal.dot(incident).simd_gt(0.0);
    is_behind.select(normal * -1.0, normal)
}

/// The points, put back onto the surface.
pub fn on_the_surface(shape: &Shape, point: Vectors, outward: Vectors) -> Vectors {
    match shape {
        Shape::Sphere(sphere) => Vectors::splat(sphere.centre) + outward * sphere.radius,
        Shape::Plane(plane) => {
            point - outward * (point - Vectors::splat(plane.point)).dot(outward)
        }
    }
}

/// The colours at some points.
pub fn colour(pattern: Pattern, point: Vectors) -> Vectors {
    match pattern {
        Pattern::Plain(colour) => Vectors::splat(colour),
        Pattern::Checker(even, odd) => {
            let sum = point.x.floor() + point.z.floor();
            let is_even = (sum - 2.0 * (sum / 2.0).floor()).simd_eq(0.0);
            is_even.select(Vectors::splat(even), Vectors::splat(odd))
        }
    }
}

/// The light of lamps of intensity 1, and a mask: where there is any.
pub fn lit(
    surface: &Phong,
    colour: Vectors,
    incident: Vectors,
    normal: Vectors,
    to_light: Vectors,
) -> (Vectors, Lanes) {
    let cos_theta_l = normal.dot(to_light);
    let diffuse = colour * (surface.diffuse * cos_theta_l);
    let mirrored = normal * (2.0 * cos_theta_l) - to_light;
    let cos_alpha = -mirrored.dot(incident);
    let specular = surface.specular * power(cos_alpha, surface.shininess);
    let lit = cos_alpha.simd_gt(0.0).select(diffuse + specular, diffuse);
    let is_black = lit.x.simd_eq(0.0) & lit.y.simd_eq(0.0) & lit.z.simd_eq(0.0);
    (lit, cos_theta_l.simd_gt(0.0) & !is_black)
}
// ANCHOR_END: shading

// ANCHOR: ways
/// The two ways on which light may go on, each with the share that takes it.
#[inline]
pub fn ways_on(
    body: &Body,
    incident: Vectors,
    outward: Vectors,
) -> [(Lanes, Vectors); 2] {
    let along_normal = outward * (2.0 * outward.dot(incident));
    let mirrored = (incident - along_normal).normalize();
    match *body {
        Body::Opaque { reflectivity } => {
            let [share, none] = [reflectivity, 0.0].map(Lanes::splat);
            [(share, mirrored), (none, incident)]
        }
        Body::Clear { inside, outside } => {
            let [inside, outside] = [inside, outside].map(Lanes::splat);
            let leaves = outward.dot(incident).simd_gt(0.0);
            let eta_i = leaves.select(inside, outside);
            let eta_t = leaves.select(outside, inside);
            let normal = facing(outward, incident);
            let (refracted, goes_on) = refract(incident, normal, eta_i / eta_t);
            let share = fresnel(-normal.dot(incident), eta_i, eta_t);
            let share = goes_on.select(share, Lanes::splat(1.0));
            [(share, mirrored), (1.0 - share, refracted)]
        }
    }
}

/// Where rays go on behind a surface, and a mask: which of them do.
fn refract(incident: Vectors, normal: Vectors, eta: Lanes) -> (Vectors, Lanes) {
    let cos_theta_i = -normal.dot(incident);
    let along = incident + normal * cos_theta_i;
    let sin2_theta_t = eta * eta * along.dot(along);
    let refracted = (along * eta - normal * (1.0 - sin2_theta_t).sqrt()).normalize();
    let is_straight = eta.simd_eq(1.0);
    let goes_on = is_straight | sin2_theta_t.simd_lt(1.0);
    (is_straight.select(incident, refracted), goes_on)
}
// ANCHOR_END: ways

// ANCHOR: fresnel
fn fresnel(cos_theta_i: Lanes, eta_i: Lanes, eta_t: Lanes) -> Lanes {
    let eta = eta_i / eta_t;
    let sin2_theta_t = eta * eta * (1.0 - cos_theta_i) * (1.0 + cos_theta_i);
    let cos_theta_t = (1.0 - sin2_theta_t).sqrt();
    let r_parl = (eta_t * cos_theta_i - eta_i * cos_theta_t)
        / (eta_t * cos_theta_i + eta_i * cos_theta_t);
    let r_perp = (eta_i * cos_theta_i - eta_t * cos_theta_t)
        / (eta_i * cos_theta_i + eta_t * cos_theta_t);
    let share = (r_parl * r_parl + r_perp * r_perp) / 2.0;
    let share = sin2_theta_t.simd_lt(1.0).select(share, Lanes::splat(1.0));
    eta_i.simd_eq(eta_t).select(Lanes::splat(0.0), share)
}
// ANCHOR_END: fresnel
