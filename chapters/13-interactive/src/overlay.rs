//! The path of an explained ray, drawn over the picture.

use crate::explain::{Explained, Outcome, RayKind, Visibility};
use canvas::Pixel;
use glam::{DVec2, DVec3, UVec2, Vec3};
use plotters_backend::{
    BackendColor, BackendCoord as Coord, BackendStyle, DrawingBackend, DrawingErrorKind,
    rasterizer,
};
use ray_casting::Camera;
use std::convert::Infallible;

type Drawn = Result<(), DrawingErrorKind<Infallible>>;
type Colour = (u8, u8, u8);

/// The colours of the path. Each is visible on the others, and with its dark outline on any
/// picture.
const CAMERA: Colour = (255, 255, 255);
const REFLECTED: Colour = (255, 90, 230);
const TRANSMITTED: Colour = (60, 235, 255);
const VISIBLE: Colour = (255, 235, 60);
const OCCLUDED: Colour = (235, 60, 40);
const OUTLINE: Colour = (0, 0, 0);

// ANCHOR: projection
/// The projection of the world onto the picture.
struct Projection<'a> {
    camera: &'a Camera,
    size: UVec2,
}

impl Projection<'_> {
    /// Returns a point of the world in the camera's axes, scaled so that the picture is the
    /// pyramid −z ≤ x ≤ z, −z ≤ y ≤ z.
    fn point(&self, point: Vec3) -> DVec3 {
        self.direction(point.as_dvec3() - self.camera.eye.as_dvec3())
    }

    /// Returns the point that is infinitely far away in a direction, in the same axes.
    fn direction(&self, v: DVec3) -> DVec3 {
        let camera = self.camera;
        let axes = [camera.right, camera.up, camera.forward];
        let [x, y, z] = axes.map(|axis| v.dot(axis.as_dvec3()));
        let f = f64::from(camera.focal_length);
        let [width, height] = self.size.as_dvec2().to_array();
        DVec3::new(f * (height / width) * x, f * y, z)
    }
    // ANCHOR_END: projection

    // ANCHOR: clip
    /// Returns the pixels at the ends of the part of the line between two such points that is
    /// in the picture; `None` if there is none, or if a point is in the eye or not finite.
    ///
    /// A point times any positive number projects to the same point of the picture. So all
    /// points are scaled to a length of 1 first, and those infinitely far away are no
    /// exception.
    fn clip(&self, from: DVec3, to: DVec3) -> Option<[Coord; 2]> {
        /// Keeps the line away from the eye, which has no projection.
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
            let crossing = ends[0].lerp(ends[1], a / (a - b));
            match (a >= 0.0, b >= 0.0) {
                (true, true) => {}
                (true, false) => ends[1] = crossing,
                (false, true) => ends[0] = crossing,
                (false, false) => return None,
            }
        }
        let half = self.size.as_dvec2() / 2.0;
        let position = |p: DVec3| DVec2::new(1.0 + p.x / p.z, 1.0 - p.y / p.z) * half;
        Some(ends.map(|p| position(p).as_ivec2().into()))
    }
}
// ANCHOR_END: clip

/// A colour, its opacity, and a width in pixels.
struct Stroke(Colour, f64, u32);

impl BackendStyle for Stroke {
    fn color(&self) -> BackendColor {
        let Self(rgb, alpha, _) = *self;
        BackendColor { rgb, alpha }
    }

    fn stroke_width(&self) -> u32 {
        self.2
    }
}

/// The size of a stroke, and whether its outline is in the layer below. The larger cover the
/// smaller: the ring covers dots, dots cover lines, and lines cover shadow rays.
type Layer = (u32, bool);

/// Records the colours that the rasteriser draws.
struct Recorder<'a> {
    projection: Projection<'a>,
    layer: Layer,
    /// Each with the index of its pixel, row by row from the upper left corner.
    colours: Vec<(usize, Layer, BackendColor)>,
}

impl Recorder<'_> {
    /// Draws a ray, its shadow rays, up to the light or to what occludes it, and all rays that
    /// follow from it.
    fn draw_ray(&mut self, ray: &Explained) -> Drawn {
        let direction = ray.ray.direction.as_dvec3();
        let (end, hit) = match &ray.outcome {
            Outcome::Hit(hit) => (self.projection.point(hit.at.point), Some(hit)),
            Outcome::Background => (self.projection.direction(direction), None),
            Outcome::NotTraced => return Ok(()),
        };
        // The fourth root: a thousandth of the light still has an opacity of a sixth.
        let alpha = f64::from(ray.throughput).sqrt().sqrt();
        let colour = match ray.kind {
            RayKind::Camera => CAMERA,
            RayKind::Reflected => REFLECTED,
            RayKind::Transmitted => TRANSMITTED,
        };
        let origin = self.projection.point(ray.ray.origin);
        self.draw_segment(origin, end, Stroke(colour, alpha, 2))?;
        if ray.kind == RayKind::Camera {
            self.draw_ring(end, 8, Stroke(CAMERA, alpha, 2))?;
        }
        let Some(hit) = hit else { return Ok(()) };
        // A ring of radius 0 is a dot.
        self.draw_ring(end, 0, Stroke(CAMERA, alpha, 4))?;
        for &(light, visibility) in &hit.lights {
            let (to, colour) = match visibility {
                Visibility::Visible => (light.position, VISIBLE),
                Visibility::Occluded(_, point) => (point, OCCLUDED),
                Visibility::BelowHorizon | Visibility::NoContribution => continue,
            };
            self.draw_segment(end, self.projection.point(to), Stroke(colour, alpha, 1))?;
        }
        hit.secondary.iter().try_for_each(|ray| self.draw_ray(ray))
    }

    fn draw_segment(&mut self, from: DVec3, to: DVec3, stroke: Stroke) -> Drawn {
        let ends = self.projection.clip(from, to);
        let Some(ends) = ends else { return Ok(()) };
        let Stroke(_, alpha, width) = stroke;
        // The outline of a thin or faint line is fainter still.
        let outline = alpha * alpha * f64::from(width * width) / 4.0;
        self.layer = (width, false);
        self.draw_path(ends, &Stroke(OUTLINE, outline, width + 2))?;
        self.layer = (width, true);
        self.draw_path(ends, &stroke)
    }

    fn draw_ring(&mut self, centre: DVec3, radius: u32, stroke: Stroke) -> Drawn {
        let centre = self.projection.clip(centre, centre);
        let Some([centre, _]) = centre else {
            return Ok(());
        };
        let Stroke(_, alpha, width) = stroke;
        self.layer = (radius + width, false);
        self.draw_circle(centre, radius, &Stroke(OUTLINE, alpha, 2 * width), false)?;
        self.draw_circle(centre, radius, &stroke, false)
    }
}

impl DrawingBackend for Recorder<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.projection.size.into()
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): Coord, colour: BackendColor) -> Drawn {
        let [width, height] = self.projection.size.as_ivec2().to_array();
        if (0..width).contains(&x) && (0..height).contains(&y) {
            let index = y as usize * width as usize + x as usize;
            self.colours.push((index, self.layer, colour));
        }
        Ok(())
    }

    /// As in the bitmaps of `plotters`, a row or a translucent column that is drawn backwards
    /// lacks its ends: the rasteriser draws a polygon's empty spans backwards.
    fn draw_line<S: BackendStyle>(&mut self, from: Coord, to: Coord, style: &S) -> Drawn {
        let colour = style.color();
        if from.1 != to.1 && (from.0 != to.0 || colour.alpha >= 1.0) {
            return rasterizer::draw_line(self, from, to, style);
        }
        let [mut xs, ys] =
            [(from.0, to.0 + 1), (from.1, to.1 + 1)].map(|(a, b)| a.min(b)..a.max(b));
        xs.try_for_each(|x| ys.clone().try_for_each(|y| self.draw_pixel((x, y), colour)))
    }
}

/// The path of an explained ray, to be drawn over a picture.
pub struct Overlay(Vec<(usize, Layer, BackendColor)>);

impl Overlay {
    /// Returns the path as `camera` sees it in a picture of `size` pixels.
    ///
    /// Hidden parts are drawn, too. A ray of low throughput is faint, and the first ray ends
    /// in a ring. Seen by its own camera, that ray is a point; seen by another, it is a line.
    pub fn new(explained: &Explained, camera: &Camera, size: UVec2) -> Self {
        let mut recorder = Recorder {
            projection: Projection { camera, size },
            layer: (0, false),
            colours: Vec::new(),
        };
        let drawn = recorder.draw_ray(explained);
        drawn.expect("recording does not fail");
        // Stable: within a layer, the later cover the earlier.
        let mut colours = recorder.colours;
        colours.sort_by_key(|&(index, layer, _)| (index, layer));
        Self(colours)
    }

    /// Draws the path over the sRGB levels of a picture of `size` pixels.
    pub fn draw(&self, size: UVec2, levels: &mut [[u8; 3]]) {
        self.draw_span(Pixel { x: 0, y: 0, size }, levels);
    }

    /// Draws the path over the levels of the `first` pixel and of those after it.
    pub fn draw_span(&self, first: Pixel, levels: &mut [[u8; 3]]) {
        let start = first.y as usize * first.size.x as usize + first.x as usize;
        let before = self.0.partition_point(|&(index, ..)| index < start);
        for &(index, _, BackendColor { rgb, alpha }) in &self.0[before..] {
            let Some(levels) = levels.get_mut(index - start) else {
                return;
            };
            // In 256ths; 255 of them count as opaque.
            let alpha = match (256.0 * alpha) as u8 {
                255 => 256,
                alpha => i32::from(alpha),
            };
            for (level, colour) in levels.iter_mut().zip(<[u8; 3]>::from(rgb)) {
                let [below, above] = [*level, colour].map(i32::from);
                *level = (below + (above - below) * alpha / 256) as u8;
            }
        }
    }
}
