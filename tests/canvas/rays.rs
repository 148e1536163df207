//! Rays are counted where they are traced, and a picture's are the sum of its rows'.

use ::canvas::{
    Canvas, Picture, Pixel, Row, count_ray, count_rays, rays_so_far, rays_traced,
    spawn_render,
};
use glam::{UVec2, Vec3};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::channel;
use std::sync::{Arc, RwLock};

const SIZE: UVec2 = UVec2::new(17, 9);

#[test]
fn a_ray_counts_once_and_several_count_as_many() {
    let before = rays_so_far();
    count_ray();
    assert_eq!(rays_so_far() - before, 1);
    count_rays(5);
    count_rays(0);
    count_ray();
    assert_eq!(rays_so_far() - before, 7);
}

/// Returns a picture whose every pixel has a light and a number of rays of its own.
fn picture() -> Picture {
    Picture::new(|pixel| {
        count_rays(pixel.x * pixel.y);
        Vec3::new(pixel.x as f32, pixel.y as f32, 100.0) / 256.0
    })
}

/// x y over all pixels: 136 · 36 of them, on any number of threads, at once or row by row.
#[test]
fn a_picture_has_the_rays_of_all_its_pixels() {
    let all_at_once = Canvas::render(&picture(), SIZE);
    assert_eq!(all_at_once.rays, 136 * 36);
    let mut by_rows = Canvas::black(SIZE);
    assert_eq!(by_rows.rays, 0);
    for row in spawn_render(picture(), SIZE) {
        assert_eq!(row.rays, 136 * u64::from(row.y));
        by_rows.write_row(&row);
    }
    assert_eq!(by_rows.rays, 136 * 36);
    assert_eq!(by_rows.radiance, all_at_once.radiance);
    assert_eq!(by_rows.levels, all_at_once.levels);
}

/// On whichever threads they were traced. Other tests count as well: there is no upper bound.
#[test]
fn all_threads_rays_are_traced_rays() {
    let before = rays_traced();
    Canvas::render(&picture(), SIZE);
    count_ray();
    assert!(rays_traced() - before > 136 * 36);
}

/// One by one, in spans of any length, or as the canvas has it.
#[test]
fn a_pixel_has_the_same_light_alone_and_in_a_span() {
    let (picture, canvas) = (picture(), Canvas::render(&picture(), SIZE));
    for (pixel, radiance) in Pixel::all(SIZE).zip(&canvas.radiance) {
        assert_eq!(picture.radiance(pixel), *radiance);
        let mut span = vec![Vec3::NAN; (SIZE.x - pixel.x) as usize];
        picture.render_span(pixel, &mut span);
        let start = (pixel.y * SIZE.x + pixel.x) as usize;
        assert_eq!(span, canvas.radiance[start..start + span.len()]);
    }
}

#[test]
fn a_black_canvas_is_black_all_over() {
    let canvas = Canvas::black(SIZE);
    assert_eq!(canvas.size, SIZE);
    assert_eq!(canvas.radiance, [Vec3::ZERO; 17 * 9]);
    assert_eq!(canvas.levels, [[0; 3]; 17 * 9]);
}

/// A row that is rendered while the receiver goes is the last one of its thread.
#[test]
fn nothing_is_rendered_for_a_receiver_that_is_gone() {
    const ROWS: u32 = 10_000;
    let rendered = Arc::new(AtomicU32::new(0));
    let is_received = Arc::new(RwLock::new(()));
    let (done, is_done) = channel::<()>();
    let picture = {
        let (rendered, is_received) = (rendered.clone(), is_received.clone());
        Picture::new(move |_| {
            // When the picture is dropped, so is its end of the channel.
            let _ = &done;
            rendered.fetch_add(1, Ordering::Relaxed);
            drop(is_received.read());
            Vec3::ZERO
        })
    };
    let receiving = is_received.write().expect("no thread panics");
    drop(spawn_render(picture, UVec2::new(1, ROWS)));
    drop(receiving);
    assert!(is_done.recv().is_err());
    // Each thread may find out by its own row; some of the rows were never begun.
    let threads = rayon::current_num_threads() as u32;
    let rendered = rendered.load(Ordering::Relaxed);
    assert!(
        rendered <= 2 * threads,
        "{rendered} rows on {threads} threads"
    );
}

/// A row that does not fit into the canvas.
#[test]
fn a_row_of_another_picture_is_refused() {
    for (y, width) in [(0, 16), (0, 18), (9, 17)] {
        let row = Row {
            y,
            radiance: vec![Vec3::ONE; width],
            levels: vec![[255; 3]; width],
            rays: 0,
        };
        let written = std::panic::catch_unwind(|| Canvas::black(SIZE).write_row(&row));
        assert!(written.is_err(), "row {y}, {width} pixels wide");
    }
}
