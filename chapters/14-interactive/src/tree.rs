// ANCHOR: head
//! An explained ray in words: a tree, for the terminal.

use crate::explain::{End, Explained, Met, Sight, Way};
use glam::Vec3;
use std::fmt::{Display, Formatter, Result};
// ANCHOR_END: head

// ANCHOR: ray
/// The pixel's light, then the ray and all rays after it, each below the one it comes
/// from.
///
/// Light and colours are linear, distances in the scene's unit, normals outward.
impl Display for Explained<'_> {
    fn fmt(&self, f: &mut Formatter) -> Result {
        let light = Vector(self.light);
        let [r, g, b] = canvas::encode(self.light);
        let rays = self.rays();
        let s = if rays == 1 { "" } else { "s" };
        writeln!(f, "light {light}, sRGB {r} {g} {b}, by {rays} ray{s}")?;
        write_ray(f, self, "", "")
    }
}

/// Writes a ray's lines: the first and the rest have indents of their own.
fn write_ray(f: &mut Formatter, ray: &Explained, first: &str, rest: &str) -> Result {
    let Explained { share, weight, .. } = ray;
    match ray.way {
        Way::FromTheEye => write!(f, "{first}eye ray, "),
        Way::Mirrored => write!(f, "{first}mirrored, share {share:.4}, "),
        Way::Through => write!(f, "{first}through, share {share:.4}, "),
    }?;
    write!(f, "weight {weight:.4}: ")?;
    let light = Vector(ray.light);
    match &ray.end {
        End::Met(met) => {
            let verb = match (met.fresnel, met.hit.normal.dot(ray.ray.direction) > 0.0) {
                (None, _) => "meets",
                (Some(_), false) => "enters",
                (Some(_), true) => "leaves",
            };
            let (name, t) = (met.object.name, met.hit.t);
            writeln!(f, "{verb} {name} at t {t:.3}")?;
            write_met(f, met, light, rest)
        }
        End::Background => writeln!(f, "meets nothing → light {light}"),
        End::TooWeak => writeln!(f, "too weak, not cast"),
        End::NoBouncesLeft => writeln!(f, "no bounces left, not cast"),
    }
}
// ANCHOR_END: ray

// ANCHOR: met
fn write_met(f: &mut Formatter, met: &Met, light: Vector, indent: &str) -> Result {
    let branch = if met.onward.is_empty() {
        "   "
    } else {
        "│  "
    };
    let [point, normal] = [met.point, met.hit.normal].map(Vector);
    write!(f, "{indent}{branch}point {point}, normal {normal}")?;
    if let Some(share) = met.fresnel {
        let total = if share == 1.0 {
            ", total reflection"
        } else {
            ""
        };
        write!(f, ", F {share:.4}{total}")?;
    }
    let colour = met.object.material.phong.colour.at(met.point);
    let [colour, own] = [colour, met.own].map(Vector);
    write!(
        f,
        "\n{indent}{branch}light {light}, own {own}, colour {colour}"
    )?;
    for (i, lamp) in met.lamps.iter().enumerate() {
        if i == 0 {
            write!(f, "\n{indent}{branch}lamps: ")?;
        } else {
            f.write_str(", ")?;
        }
        match lamp.sight {
            Sight::Reached => f.write_str("reached"),
            Sight::Blocked(by, _) => write!(f, "blocked by {}", by.name),
            Sight::Behind => f.write_str("behind it"),
            Sight::Useless => f.write_str("adds nothing"),
        }?;
    }
    writeln!(f)?;
    if let [earlier @ .., last] = &met.onward[..] {
        for onward in earlier {
            write_ray(f, onward, &format!("{indent}├─ "), &format!("{indent}│  "))?;
        }
        write_ray(f, last, &format!("{indent}└─ "), &format!("{indent}   "))?;
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
// ANCHOR_END: met
