//! The numbers in the book that are not a study's. None depends on the machine.

mod anti_aliasing;
mod canvas;
mod fresnel;
mod plane_hit;
mod ray_casting;
mod reflection;
mod refraction;
mod shading;
mod shadow_acne;
mod shadows;
mod sphere_hit;
mod transparency;

#[path = "../numbers_file/mod.rs"]
mod numbers_file;

use ::canvas::{Canvas, Stage};
use glam::{UVec2, Vec3};
use numbers_file::{Numbers, percent, three_digits};

const HERO: UVec2 = UVec2::new(800, 600);
const SMALL: UVec2 = UVec2::new(320, 240);

/// A view as it comes, at some size.
fn paint(stage: &Stage, view: &str, size: UVec2) -> Canvas {
    let view = &stage.views[stage.find(view).expect("a view of the stage")];
    Canvas::paint(&(view.picture)(view.default_setting()), size)
}

/// Rows of a Markdown table.
fn table<const N: usize>(rows: impl IntoIterator<Item = [String; N]>) -> String {
    let rows = rows
        .into_iter()
        .map(|row| format!("| {} |", row.join(" | ")));
    rows.collect::<Vec<_>>().join("\n")
}

fn vector(v: &[f32]) -> String {
    let numbers: Vec<_> = v.iter().map(|x| format!("{x:.3}")).collect();
    format!("({})", numbers.join(", ").replace('-', "−"))
}

/// The view, its rays and its shadow rays, for views that cast one camera ray for each pixel of a hero.
fn ray_counts<'a>(stage: &Stage, views: impl IntoIterator<Item = &'a str>) -> String {
    table(views.into_iter().map(|view| {
        let rays = paint(stage, view, HERO).rays;
        let shadow_rays = rays - u64::from(HERO.x * HERO.y);
        [view.to_string(), rays.to_string(), shadow_rays.to_string()]
    }))
}

/// The i-th of a sequence that fills the unit cube evenly.
///
/// Source: Martin Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018).
fn evenly(i: usize) -> [f64; 3] {
    const STEPS: [f64; 3] = [
        0.819_172_513_396_164,
        0.671_043_606_703_789,
        0.549_700_477_901_97,
    ];
    STEPS.map(|step| (0.5 + step * i as f64).fract())
}
