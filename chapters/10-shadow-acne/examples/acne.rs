//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use reflection::{MAX_DEPTH, PathBudget};
use shadow_acne::scene::balls_on_a_planet;
use shadow_acne::{SpawnRay, from_eye, trace, without_offset};

fn picture(spawn: SpawnRay) -> RgbImage {
    let (scene, camera) = balls_on_a_planet(1.0);
    let budget = PathBudget::new(MAX_DEPTH);
    let start = from_eye(&scene.objects, camera.eye);
    canvas::render(UVec2::new(320, 240), |pixel| {
        let ray = start(camera.ray(pixel.centre()));
        trace(&scene, &ray, budget, spawn)
    })
}

fn main() -> preview::ImageResult<()> {
    preview::save_and_show(&picture(without_offset), "acne")
}

#[test]
fn all_methods_draw_the_books_pictures() {
    let methods: [(&str, SpawnRay); 4] = [
        ("acne", without_offset),
        ("fixed", shadow_acne::with_fixed_offset),
        ("scaled", shadow_acne::with_scaled_offset),
        ("from-surface", shadow_acne::from_surface),
    ];
    for (view, spawn) in methods {
        let book = format!("../pictures/10-shadow-acne--{view}.snap.png");
        let differing = canvas::differing(&picture(spawn), &book);
        assert_eq!(differing.expect(&book), 0, "{view}");
    }
}
// ANCHOR_END: main
