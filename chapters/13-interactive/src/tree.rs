//! An explained ray as a tree of text, for the terminal.

use crate::explain::{Explained, Outcome, RayKind, SurfaceHit, Visibility};
use glam::Vec3;
use refraction::{Material, Optics};
use std::fmt::{Display, Formatter, Result};

/// The pixel's radiance, then the ray and all rays that follow from it, each below the one
/// that it comes from.
///
/// Radiance and colours are linear, distances in the scene's unit, normals outward.
impl Display for Explained<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let [r, g, b] = canvas::encode(self.radiance);
        let (radiance, rays) = (Vector(self.radiance), self.rays);
        let s = if rays == 1 { "" } else { "s" };
        write!(f, "radiance {radiance}, sRGB {r} {g} {b}, by {rays} ray{s}")?;
        write_ray(f, self, "\n", "\n")
    }
}

/// Writes a ray after `first`, and what follows from it in lines that begin with `line`.
fn write_ray(f: &mut Formatter, ray: &Explained, first: &str, line: &str) -> Result {
    let (weight, radiance) = (ray.weight, Vector(ray.radiance));
    match ray.kind {
        RayKind::Camera => write!(f, "{first}camera ray"),
        RayKind::Reflected => write!(f, "{first}reflected, weight {weight:.4}"),
        RayKind::Transmitted => write!(f, "{first}transmitted, weight {weight:.4}"),
    }?;
    write!(f, ", throughput {:.4}: ", ray.throughput)?;
    match &ray.outcome {
        Outcome::Hit(hit) => write_hit(f, hit, radiance, line),
        Outcome::Background => write!(f, "hits nothing → radiance {radiance}"),
        Outcome::NotTraced => f.write_str("not traced"),
    }
}

fn write_hit(
    f: &mut Formatter,
    hit: &SurfaceHit,
    radiance: Vector,
    line: &str,
) -> Result {
    let Material { phong, optics } = &hit.object.material;
    let leaves = !hit.at.enters();
    let verb = match (optics, hit.secondary.len()) {
        (Optics::Opaque { .. }, _) => "hits",
        // Total internal reflection.
        (Optics::Dielectric { .. }, 1) if leaves => "cannot leave",
        (Optics::Dielectric { .. }, 1) => "cannot enter",
        (Optics::Dielectric { .. }, _) if leaves => "leaves",
        (Optics::Dielectric { .. }, _) => "enters",
    };
    write!(f, "{verb} {} at t {:.3}", hit.object.name, hit.at.t)?;

    let bar = if hit.secondary.is_empty() { " " } else { "│" };
    let start = format!("{line}{bar} ");
    let [point, normal] = [hit.at.point, hit.at.outward].map(Vector);
    write!(f, "{start}point {point}, normal {normal}")?;
    let [local, colour] = [hit.local, phong.colour.value(hit.at.uv())].map(Vector);
    write!(f, "{start}radiance {radiance}, local {local}, ")?;
    write!(f, "colour {colour}")?;
    for (i, (_, visibility)) in hit.lights.iter().enumerate() {
        match i {
            0 => write!(f, "{start}lights: ")?,
            _ => f.write_str(", ")?,
        }
        match visibility {
            Visibility::Visible => f.write_str("visible")?,
            Visibility::Occluded(by, _) => write!(f, "occluded by {}", by.name)?,
            Visibility::BelowHorizon => f.write_str("below the horizon")?,
            Visibility::NoContribution => f.write_str("no contribution")?,
        }
    }
    if let [earlier @ .., last] = &hit.secondary[..] {
        for ray in earlier {
            write_ray(f, ray, &format!("{line}├ "), &format!("{line}│ "))?;
        }
        write_ray(f, last, &format!("{line}└ "), &format!("{line}  "))?;
    }
    Ok(())
}

/// Three numbers with three decimals, and without −0.
struct Vector(Vec3);

impl Display for Vector {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let round = |x| (f64::from(x) * 1e3).round() / 1e3 + 0.0;
        let [x, y, z] = self.0.to_array().map(round);
        write!(f, "({x:.3}, {y:.3}, {z:.3})")
    }
}
