//! The render thread: coarse at once, exact in the end, and what is no longer wanted is
//! abandoned.

use glam::UVec2;
use interactive::views::WalkView;
use interactive::{CameraPose, Frame, RenderRequest, RenderThread, STAGE, size_at_lod};
use std::thread;
use std::time::Duration;

const SIZE: UVec2 = UVec2::new(64, 48);

fn request(n: f32, size: UVec2, is_moving: bool) -> RenderRequest {
    RenderRequest {
        pose: CameraPose::START,
        view: WalkView::named(STAGE.hero).expect("a view"),
        setting: n,
        size,
        is_moving,
    }
}

/// Waits for the next frame, for a minute at most.
fn next_frame(thread: &RenderThread) -> Frame {
    for _ in 0..60_000 {
        if let Some(frame) = thread.take_frame() {
            return frame;
        }
        thread::sleep(Duration::from_millis(1));
    }
    panic!("no frame");
}

#[test]
fn a_picture_at_rest_becomes_exact() {
    let mut thread = RenderThread::new(Duration::from_secs(60));
    thread.request(request(2.0, SIZE, false));
    let mut samples = 0;
    let last = loop {
        let frame = next_frame(&thread);
        assert!(frame.samples >= samples && frame.total_samples == 4);
        samples = frame.samples;
        if frame.is_exact() {
            break frame;
        }
    };
    let view = last.request.view;
    let picture = (view.picture)(CameraPose::START.camera(), 2.0);
    let expected = canvas::Canvas::render(&picture, SIZE);
    assert_eq!(last.levels(), expected.levels);
    assert_eq!(last.canvas.radiance, expected.radiance);
}

#[test]
fn a_moving_picture_gets_coarser_until_it_is_fast_enough() {
    // No frame is as fast as this.
    let mut thread = RenderThread::new(Duration::ZERO);
    for lod in 0..=interactive::MAX_LOD {
        let mut request = request(4.0, SIZE, true);
        request.pose = request.pose.zoomed(1.0 + lod as f32);
        thread.request(request);
        let frame = next_frame(&thread);
        assert_eq!((frame.lod, frame.samples), (lod, 0));
        assert_eq!(frame.canvas.size, size_at_lod(SIZE, lod));
        assert_eq!(frame.levels().len(), SIZE.element_product() as usize);
        assert!(frame.request == request);
    }
}

/// All samples of the first would take minutes. Of a request that is no longer wanted, one
/// frame may be waiting, and one may be on its way.
#[test]
fn a_new_request_abandons_the_old_one() {
    let mut thread = RenderThread::new(Duration::from_secs(60));
    thread.request(request(20.0, UVec2::new(1600, 1200), false));
    while next_frame(&thread).samples == 0 {}
    thread.request(request(1.0, SIZE, false));
    let mut old = 0;
    let frame = loop {
        let frame = next_frame(&thread);
        if frame.request.size == SIZE {
            break frame;
        }
        old += 1;
        assert!(old <= 2, "sample {} of the old request", frame.samples);
    };
    assert!(frame.is_exact());
}

#[test]
fn the_same_request_is_rendered_once() {
    let mut thread = RenderThread::new(Duration::from_secs(60));
    thread.request(request(1.0, SIZE, false));
    assert!(next_frame(&thread).is_exact());
    thread.request(request(1.0, SIZE, false));
    thread::sleep(Duration::from_millis(100));
    assert!(thread.take_frame().is_none());
}
