//! What chapter 13 shows: the studies' charts.

use crate::chart;
use crate::plan::{Plan, WISH};
use crate::studies::{
    acne, bounces, fresnel, growth, highlight, packets, plan, plane, recursion,
    refraction, sampling, sphere,
};
use crate::study::{Study, Table};
use ::refraction::views::{AIR, GLASS, still_life_with_glass};
use canvas::{Knob, Picture, Pixel, Scale, Stage, View, decode, rays_so_far};
use glam::{UVec2, Vec2, Vec3};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};

/// Chapter 13.
pub const STAGE: Stage = Stage {
    name: "13-speed-and-accuracy",
    title: "Speed against accuracy",
    views: &[
        View {
            name: "planned",
            caption: "The still life by its plan: as many rays as each pixel needs, and no more.",
            knob: Some(wish(&[16.0])),
            picture: still_life_planned,
        },
        View {
            name: "cost",
            caption: "What that takes, a shade lighter for each doubling of a pixel's rays: 8 to 24 where all of it is alike, \
                      thousands where the floor's squares crowd at the horizon.",
            knob: Some(wish(&[])),
            picture: |wish| cost_of(still_life_planned(wish)),
        },
        chart_view(&sphere::STUDY, |_| charts(&sphere::STUDY)),
        chart_view(&plane::STUDY, |_| charts(&plane::STUDY)),
        chart_view(&bounces::STUDY, |_| charts(&bounces::STUDY)),
        chart_view(&refraction::STUDY, |_| charts(&refraction::STUDY)),
        chart_view(&fresnel::STUDY, |_| charts(&fresnel::STUDY)),
        chart_view(&highlight::STUDY, |_| charts(&highlight::STUDY)),
        chart_view(&recursion::STUDY, |_| charts(&recursion::STUDY)),
        chart_view(&sampling::STUDY, |_| charts(&sampling::STUDY)),
        chart_view(&acne::STUDY, |_| charts(&acne::STUDY)),
        chart_view(&growth::STUDY, |_| charts(&growth::STUDY)),
        chart_view(&packets::STUDY, |_| charts(&packets::STUDY)),
        chart_view(&plan::STUDY, |_| charts(&plan::STUDY)),
    ],
};

const fn wish(pinned: &'static [f32]) -> Knob {
    Knob {
        name: "wish",
        unit: "levels",
        min: 0.25,
        max: 16.0,
        default: WISH,
        scale: Scale::Logarithmic,
        pinned,
    }
}

fn still_life_planned(wish: f32) -> Picture {
    let scene = still_life_with_glass(GLASS, AIR);
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    Plan::new(&scene, &camera, wish).picture(scene, camera)
}

/// How many rays each pixel of a picture takes: one of sixteen shades of grey more for
/// each doubling.
fn cost_of(picture: Picture) -> Picture {
    Picture::new(move |pixel| {
        let before = rays_so_far();
        let _ = picture.light(pixel);
        let doublings = (rays_so_far() - before).checked_ilog2().unwrap_or(0);
        Vec3::splat(decode((16 * doublings).try_into().unwrap_or(u8::MAX)))
    })
}

const fn chart_view(study: &'static Study, picture: fn(f32) -> Picture) -> View {
    View {
        name: study.name,
        caption: study.title,
        knob: None,
        picture,
    }
}

/// The charts of a study, as the book has them: as large as fits, in the middle.
fn charts(study: &Study) -> Picture {
    // A table that is not there yet is an empty one.
    let table = Table::from_csv(study.table).unwrap_or_default();
    let (width, height, levels) = chart::pixels(study.charts, &table);
    let chart = UVec2::new(width, height);
    let light: Vec<Vec3> = levels
        .chunks_exact(3)
        .map(|rgb| Vec3::new(decode(rgb[0]), decode(rgb[1]), decode(rgb[2])))
        .collect();
    Picture::new(move |pixel| mean_over(pixel, chart, &light))
}

/// The mean of what a pixel covers of a picture of `size` that is shown as large as fits;
/// white beside it.
fn mean_over(pixel: Pixel, size: UVec2, light: &[Vec3]) -> Vec3 {
    let per_pixel = (size.as_vec2() / pixel.size.as_vec2()).max_element();
    let from_middle =
        Vec2::new(pixel.x as f32, pixel.y as f32) - pixel.size.as_vec2() / 2.0;
    let corner = from_middle * per_pixel + size.as_vec2() / 2.0;
    // One at least, even where a pixel is smaller than one of the picture's.
    let first = corner.floor().as_ivec2();
    let last = (corner + Vec2::splat(per_pixel)).ceil().as_ivec2();
    let (mut sum, mut count) = (Vec3::ZERO, 0.0);
    for y in first.y..last.y {
        for x in first.x..last.x {
            let is_in =
                (0..size.x as i32).contains(&x) && (0..size.y as i32).contains(&y);
            sum += if is_in {
                light[(y * size.x as i32 + x) as usize]
            } else {
                Vec3::ONE
            };
            count += 1.0;
        }
    }
    sum / count
}
