// ANCHOR: head
//! The path of an explained ray, drawn over the picture.

use crate::explain::{End, Explained, Sight, Way};
use glam::{DVec3, UVec2, Vec3};
use plotters::element::PathElement;
use plotters::prelude::*;
use ray_casting::Camera;
// ANCHOR_END: head

// ANCHOR: colours
/// Each is visible on the others, and with its dark outline on any picture.
const MIRRORED: RGBColor = RGBColor(255, 90, 230);
const THROUGH: RGBColor = RGBColor(60, 235, 255);
const REACHED: RGBColor = RGBColor(255, 235, 60);
const BLOCKED: RGBColor = RGBColor(235, 60, 40);
// ANCHOR_END: colours

// ANCHOR: projection
/// A place of the picture, in pixels from its upper left corner.
type Place = (i32, i32);

/// From the world to the picture.
struct Projection<'a> {
    camera: &'a Camera,
    size: UVec2,
}

impl Projection<'_> {
    /// A point of the world in the camera's axes, where the picture is the pyramid
    /// −z ≤ x ≤ z, −z ≤ y ≤ z.
    fn point(&self, point: Vec3) -> DVec3 {
        self.direction(point.as_dvec3() - self.camera.eye.as_dvec3())
    }

    /// The same for the point that is infinitely far away in a direction.
    fn direction(&self, v: DVec3) -> DVec3 {
        let camera = self.camera;
        let axes = [camera.right, camera.up, camera.forward];
        let [x, y, z] = axes.map(|axis| v.dot(axis.as_dvec3()));
        let f = f64::from(camera.focal_length);
        let shape = f64::from(self.size.y) / f64::from(self.size.x);
        DVec3::new(f * shape * x, f * y, z)
    }

    /// Where a ray ends, if it was cast: infinitely far away, if it meets nothing.
    fn end(&self, ray: &Explained) -> Option<DVec3> {
        match &ray.end {
            End::Met(met) => Some(self.point(met.point)),
            End::Background => Some(self.direction(ray.ray.direction.as_dvec3())),
            End::TooWeak | End::NoBouncesLeft => None,
        }
    }
    // ANCHOR_END: projection

    // ANCHOR: clip
    /// The part of the line between two such points that is in the picture; `None` if
    /// there is none, or a point is nowhere: in the eye, or not finite.
    ///
    /// A point times any positive number is in the same place of the picture. So all are
    /// brought to a length of 1 first, and infinitely far is not far.
    fn clip(&self, from: DVec3, to: DVec3) -> Option<[Place; 2]> {
        /// Keeps the line from the eye, where it has no place.
        const NEAREST: f64 = 1e-6;
        let sides: [fn(DVec3) -> f64; 5] = [
            |p| p.z - NEAREST,
            |p| p.z - p.x,
            |p| p.z + p.x,
            |p| p.z - p.y,
            |p| p.z + p.y,
        ];
        let mut ends = [from.try_normalize()?, to.try_normalize()?];
        for side in sides {
            let [a, b] = ends.map(side);
            let border = ends[0].lerp(ends[1], a / (a - b));
            match (a >= 0.0, b >= 0.0) {
                (true, true) => {}
                (true, false) => ends[1] = border,
                (false, true) => ends[0] = border,
                (false, false) => return None,
            }
        }
        let half = self.size.as_dvec2() / 2.0;
        let place = |p: DVec3| {
            let x = (1.0 + p.x / p.z) * half.x - 0.5;
            let y = (1.0 - p.y / p.z) * half.y - 0.5;
            (x.round() as i32, y.round() as i32)
        };
        Some(ends.map(place))
    }
}
// ANCHOR_END: clip

// ANCHOR: path
/// What to draw, and how visibly, from 0 to 1.
#[derive(Default)]
struct Path {
    shadow_rays: Vec<([Place; 2], RGBAColor)>,
    rays: Vec<([Place; 2], RGBAColor)>,
    points: Vec<(Place, f64)>,
}

impl Path {
    fn add(&mut self, ray: &Explained, projection: &Projection) {
        let Some(end) = projection.end(ray) else {
            return;
        };
        // A thousandth of the light is not nothing: it shows by a sixth.
        let visible = f64::from(ray.weight).sqrt().sqrt();
        let segment = |from, to, colour: RGBColor| {
            let line = projection.clip(from, to)?;
            Some((line, colour.mix(visible)))
        };
        let from = projection.point(ray.ray.origin);
        match ray.way {
            // Seen from the eye that cast it, it is a point, and has no line.
            Way::FromTheEye => self.rays.extend(segment(from, end, WHITE)),
            Way::Mirrored => self.rays.extend(segment(from, end, MIRRORED)),
            Way::Through => self.rays.extend(segment(from, end, THROUGH)),
        }
        let End::Met(met) = &ray.end else { return };
        if let Some([place, _]) = projection.clip(end, end) {
            self.points.push((place, visible));
        }
        for lamp in &met.lamps {
            let shadow_ray = match lamp.sight {
                Sight::Reached => {
                    segment(end, projection.point(lamp.light.position), REACHED)
                }
                Sight::Blocked(_, at) => segment(end, projection.point(at), BLOCKED),
                Sight::Behind | Sight::Useless => None,
            };
            self.shadow_rays.extend(shadow_ray);
        }
        for onward in &met.onward {
            self.add(onward, projection);
        }
    }
}
// ANCHOR_END: path

// ANCHOR: draw
/// Draws the path of a ray over a picture of `size` pixels: mirrored rays, rays through
/// clear bodies, and shadow rays, up to the lamp or to what is in the way.
///
/// Draws what is hidden, too. A weak ray is faint; what the eye saw has a ring around it. The `camera`
/// need not be the one that cast the ray: from elsewhere, the eye's own ray is a line, too.
///
/// # Panics
/// If there are fewer levels than pixels.
pub fn draw(explained: &Explained, camera: &Camera, size: UVec2, levels: &mut [[u8; 3]]) {
    let projection = Projection { camera, size };
    let mut path = Path::default();
    path.add(explained, &projection);

    let area = BitMapBackend::with_buffer(levels.as_flattened_mut(), size.into())
        .into_drawing_area();
    let lines = |lines: &[([Place; 2], RGBAColor)], width, dark: f64| {
        for &(ends, RGBAColor(.., visible)) in lines {
            let outline = BLACK.mix(dark * visible * visible);
            let outline = PathElement::new(ends, outline.stroke_width(width + 2));
            drawn(area.draw(&outline));
        }
        for &(ends, colour) in lines {
            drawn(area.draw(&PathElement::new(ends, colour.stroke_width(width))));
        }
    };
    lines(&path.shadow_rays, 1, 0.25);
    lines(&path.rays, 2, 1.0);
    for &(place, visible) in &path.points {
        for (colour, radius) in [(BLACK, 4), (WHITE, 2)] {
            drawn(area.draw(&Circle::new(place, radius, colour.mix(visible).filled())));
        }
    }
    let end = projection.end(explained);
    if let Some([place, _]) = end.and_then(|end| projection.clip(end, end)) {
        for (colour, width) in [(BLACK, 4), (WHITE, 2)] {
            drawn(area.draw(&Circle::new(place, 8, colour.stroke_width(width))));
        }
    }
}

fn drawn<T, E: std::fmt::Debug>(drawn: Result<T, E>) {
    drawn.expect("memory takes everything");
}
// ANCHOR_END: draw
