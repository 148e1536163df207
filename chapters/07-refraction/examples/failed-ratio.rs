//! What the page has the reader write as a program of their own.
// ANCHOR: main
use canvas::RgbImage;
use glam::UVec2;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, close_up, still_life_with_glass};
use refraction::{Transmission, refract_without_inverting, trace};

fn picture(transmission: Transmission, [inside, outside]: [f32; 2]) -> RgbImage {
    let camera = close_up();
    let scene = still_life_with_glass(inside, outside);
    let budget = PathBudget::new(MAX_DEPTH);
    canvas::render(UVec2::new(320, 240), |pixel| {
        trace(&scene, &camera.ray(pixel.centre()), budget, transmission)
    })
}

fn main() -> preview::ImageResult<()> {
    let picture = picture(refract_without_inverting, [GLASS, AIR]);
    preview::save_and_show(&picture, "failed-ratio")
}

#[test]
fn are_the_books_pictures() {
    use refraction::{refract_or_reflect, refract_without_total_reflection};
    let pictures: [(&str, Transmission, [f32; 2]); 4] = [
        ("failed-ratio", refract_without_inverting, [GLASS, AIR]),
        ("ball", refract_or_reflect, [GLASS, AIR]),
        (
            "failed-total",
            refract_without_total_reflection,
            [AIR, GLASS],
        ),
        ("bubble", refract_or_reflect, [AIR, GLASS]),
    ];
    for (view, transmission, indices) in pictures {
        let book = format!("../pictures/07-refraction--{view}.snap.png");
        let differing = canvas::differing(&picture(transmission, indices), &book);
        assert_eq!(differing.expect(&book), 0, "{view}");
    }
}
// ANCHOR_END: main
