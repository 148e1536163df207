//! What the page has the reader write as a program of their own.
// ANCHOR: main
use anti_aliasing::{Sampler, jittered};
use canvas::RgbImage;
use fresnel::{fresnel, trace};
use glam::{UVec2, Vec2};
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};

fn picture(sampler: Sampler) -> RgbImage {
    let camera = still_life_camera();
    let scene = still_life_with_glass(GLASS, AIR);
    let budget = PathBudget::new(MAX_DEPTH);
    let radiance = |point: Vec2| trace(&scene, &camera.ray(point), budget, fresnel);
    canvas::render(UVec2::new(320, 240), |pixel| sampler(pixel, 4, &radiance))
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(jittered), "jittered")
}

#[test]
fn is_the_books_picture() {
    let book = "../pictures/09-anti-aliasing--jittered.snap.png";
    let picture = picture(jittered);
    assert_eq!(canvas::differing(&picture, book).expect(book), 0);
}

#[test]
fn the_adaptive_one_is_the_books_picture() {
    let book = "../pictures/09-anti-aliasing--adaptive.snap.png";
    let picture = picture(anti_aliasing::adaptive);
    assert_eq!(canvas::differing(&picture, book).expect(book), 0);
}
// ANCHOR_END: main
