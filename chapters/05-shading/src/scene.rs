// ANCHOR: surfaces
//! The surfaces of the still life.

use crate::Phong;
use plane_hit::scene::STILL_LIFE_COLOURS;

/// Returns the still life's surfaces: floor, red, mirror, green, blue, glass. Until they have
/// their own chapters, the mirror and the glass are of plastic.
pub fn still_life_surfaces() -> [Phong; 6] {
    let [floor, red, mirror, green, blue, glass] = STILL_LIFE_COLOURS;
    let phong = |colour, specular, shininess| Phong {
        colour,
        ambient: 0.1,
        diffuse: 0.8,
        specular,
        shininess,
    };
    [
        phong(floor, 0.0, 1),
        phong(red, 0.5, 50),
        phong(mirror, 0.8, 200),
        phong(green, 0.5, 50),
        phong(blue, 0.8, 100),
        phong(glass, 0.8, 200),
    ]
}
// ANCHOR_END: surfaces
