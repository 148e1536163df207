//! The exercises' solutions, as the book prints them.

use canvas::Picture;
use fresnel::views::picture_of;
use fresnel::{fresnel, schlick};
use ray_casting::scene::still_life_camera;
use refraction::scene::{AIR, GLASS};
use speed_and_accuracy::error_map::error_map;

// ANCHOR: exercise-3
pub fn map_of_schlick() -> Picture {
    let camera = still_life_camera();
    let [ours, exact] =
        [schlick, fresnel].map(|reflectance| picture_of(GLASS, AIR, camera, reflectance));
    error_map(ours, exact)
}
// ANCHOR_END: exercise-3
