//! The chapter's pictures.

use crate::{DEFAULT_TOLERANCE, Plan};
use canvas::{Knob, Picture, Scale, Stage, View, decode, folder_name, rays_so_far};
use glam::Vec3;
use ray_casting::scene::still_life_camera;
use refraction::scene::{AIR, GLASS, still_life_with_glass};

/// The chapter's description.
pub const STAGE: Stage = Stage {
    name: folder_name(env!("CARGO_MANIFEST_DIR")),
    title: "Adaptive rendering: no more than a picture needs",
    hero: "planned",
    bugs: &[],
    views: &[
        View {
            name: "planned",
            caption: "The still life by its plan: as many rays per pixel as it needs, and no more.",
            knob: Some(tolerance(&[16.0])),
            picture: still_life,
        },
        View {
            name: "cost",
            caption: "The rays of each pixel, a shade lighter for each doubling: fewest where a pixel is uniform, most at the horizon.",
            knob: Some(tolerance(&[])),
            picture: cost,
        },
    ],
};

const fn tolerance(snapshot_settings: &'static [f32]) -> Knob {
    Knob {
        name: "tolerance",
        unit: "levels",
        min: 0.25,
        max: 16.0,
        default: DEFAULT_TOLERANCE,
        scale: Scale::Logarithmic,
        snapshot_settings,
    }
}

fn still_life(tolerance: f32) -> Picture {
    let scene = still_life_with_glass(GLASS, AIR);
    Plan::with_black_shadows(scene, tolerance).picture(still_life_camera())
}

/// Returns how many rays each pixel takes: each doubling is sixteen levels lighter.
fn cost(tolerance: f32) -> Picture {
    let picture = still_life(tolerance);
    Picture::new(move |pixel| {
        let rays_before = rays_so_far();
        let _ = picture.radiance(pixel);
        let doublings = (rays_so_far() - rays_before).ilog2();
        Vec3::splat(decode((16 * doublings).try_into().unwrap_or(u8::MAX)))
    })
}
