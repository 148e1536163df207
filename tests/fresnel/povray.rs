//! The still life against POV-Ray's.

use ::fresnel::{STAGE, fresnel, trace};
use ::ray_casting::scene::still_life_camera;
use ::reflection::PathBudget;
use ::refraction::scene::{AIR, GLASS, still_life_with_glass};
use canvas::Picture;
use harness::povray::assert_picture;

#[test]
fn the_still_life_is_the_one_that_povray_renders() {
    assert_picture(STAGE.name, |depth| {
        let camera = still_life_camera();
        let scene = still_life_with_glass(GLASS, AIR);
        let budget = PathBudget {
            min_throughput: 0.0,
            ..PathBudget::new(depth)
        };
        Picture::new(move |pixel| {
            trace(&scene, &camera.ray(pixel.centre()), budget, fresnel)
        })
    });
}
