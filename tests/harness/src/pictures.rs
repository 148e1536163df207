//! Pictures of a chapter's views, and the rays that they take.

use crate::{bits, table, with_separators};
use canvas::{Canvas, Picture, Stage};
use glam::{UVec2, Vec3};

/// The size of a page's large picture.
pub const HERO: UVec2 = UVec2::new(800, 600);
/// The size of its other pictures.
pub const SMALL: UVec2 = UVec2::new(320, 240);

/// Returns the canvas of a view at its default setting.
#[must_use]
pub fn render(stage: &Stage, view: &str, size: UVec2) -> Canvas {
    let view = stage.view(view).expect("a view of the stage");
    Canvas::render(&(view.picture)(view.default_setting()), size)
}

/// Returns the canvas of a view at some setting of its knob.
#[must_use]
pub fn render_at(stage: &Stage, view: &str, setting: f32, size: UVec2) -> Canvas {
    let view = stage.view(view).expect("a view of the stage");
    Canvas::render(&(view.picture)(setting), size)
}

/// Returns the greatest difference of two pictures in any channel, in levels that are not
/// rounded.
#[must_use]
pub fn largest_difference(a: &Canvas, b: &Canvas) -> f64 {
    let levels =
        |radiance: &Vec3| radiance.to_array().map(|x| oracle::level(f64::from(x)));
    let pairs = a.radiance.iter().zip(&b.radiance);
    let differences = pairs.flat_map(|(a, b)| {
        let [a, b] = [a, b].map(levels);
        (0..3).map(move |i| (a[i] - b[i]).abs())
    });
    differences.fold(0.0, f64::max)
}

/// Returns `chapter` and the chapter's number in the book.
#[must_use]
pub fn chapter(stage: &Stage) -> String {
    let number: u32 = stage.name[..2]
        .parse()
        .expect("a name begins with a number");
    format!("chapter {number}")
}

/// Returns rows of a view, its rays and its shadow rays, for views of which each pixel takes
/// one camera ray and some shadow rays.
pub fn ray_counts<'a>(stage: &Stage, views: impl IntoIterator<Item = &'a str>) -> String {
    table(views.into_iter().map(|view| {
        let rays = render(stage, view, HERO).rays;
        let shadow_rays = rays - u64::from(HERO.x * HERO.y);
        let [rays, shadow_rays] = [rays, shadow_rays].map(with_separators);
        [view.to_string(), rays, shadow_rays]
    }))
}

/// Compares renderings of a chapter's first view on 1, 2 and 7 threads.
///
/// # Panics
/// If the bits differ, or the number of rays.
pub fn check_threads(stage: &Stage) {
    let view = stage.hero();
    let picture = (view.picture)(view.default_setting());
    let [one, two, seven] = [1, 2, 7].map(|threads| render_on(threads, &picture));
    assert_eq!(one, two);
    assert_eq!(one, seven);
}

/// Returns the bits of a picture rendered on this number of threads, and its rays.
fn render_on(threads: usize, picture: &Picture) -> (Vec<[u32; 3]>, u64) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.expect("a few threads");
    let canvas = pool.install(|| Canvas::render(picture, UVec2::new(160, 120)));
    (canvas.radiance.iter().map(bits).collect(), canvas.rays)
}

/// Returns how many of `values`, of pixels one after the other, differ by more than 0.05 from
/// both their neighbours, and to the same side: a highlight has no more than a few of them.
pub fn speckles(values: &[f32]) -> usize {
    let is_speckle = |three: &&[f32]| {
        let [left, right] = [three[1] - three[0], three[1] - three[2]];
        left * right > 0.0 && left.abs() > 0.05 && right.abs() > 0.05
    };
    values.windows(3).filter(is_speckle).count()
}
