//! The chapter's exercises: functions for you to write.

use crate::error_map::error_map;
use canvas::Picture;
use fresnel::fresnel;
use fresnel::views::picture_of;
use ray_casting::scene::still_life_camera;
use refraction::scene::{AIR, GLASS};

// ANCHOR: exercise-3
/// Returns the map of the errors of chapter 8's `schlick` in the still life: of its picture with
/// `schlick`, compared with the one with `fresnel`.
pub fn map_of_schlick() -> Picture {
    // Yours to write.
    let exact = || picture_of(GLASS, AIR, still_life_camera(), fresnel);
    error_map(exact(), exact())
}
// ANCHOR_END: exercise-3
