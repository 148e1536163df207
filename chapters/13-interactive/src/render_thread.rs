//! A thread that renders what the window requests: a coarse frame at once, then finer ones,
//! until the picture is exact.

use crate::views::WalkView;
use crate::{Accumulator, CameraPose, block_of, next_lod, size_at_lod};
use canvas::{Canvas, Picture, Pixel};
use glam::UVec2;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

// ANCHOR: request
/// A request to render a view.
#[derive(Clone, Copy, PartialEq)]
pub struct RenderRequest {
    /// The camera's pose.
    pub pose: CameraPose,
    /// The view.
    pub view: &'static WalkView,
    /// The setting of the view's knob.
    pub setting: f32,
    /// The size of the whole picture, in pixels.
    pub size: UVec2,
    /// Whether the camera is moving: then the next request follows at once, and one coarse
    /// frame is enough.
    pub is_moving: bool,
}

/// A rendered frame.
pub struct Frame {
    /// The request.
    pub request: RenderRequest,
    /// The frame, of the size that [`size_at_lod`] returns.
    pub canvas: Canvas,
    /// Its level of detail.
    pub lod: u32,
    /// The number of samples per pixel so far; 0 while it is coarse.
    pub samples: u32,
    /// The number of samples per pixel of the exact picture.
    pub total_samples: u32,
    /// The time taken by the frame, or by its last sample.
    pub took: Duration,
}

impl Frame {
    /// Returns whether all samples have been taken.
    pub fn is_exact(&self) -> bool {
        self.samples == self.total_samples
    }

    /// Returns the sRGB levels of the whole picture, in blocks if the frame is coarse.
    pub fn levels(&self) -> Vec<[u8; 3]> {
        let level = |pixel| {
            let Pixel { x, y, size } = block_of(pixel, self.lod);
            self.canvas.levels[y as usize * size.x as usize + x as usize]
        };
        Pixel::all(self.request.size).map(level).collect()
    }
}
// ANCHOR_END: request

// ANCHOR: thread
/// Handle to the render thread. Dropping it stops the rendering.
pub struct RenderThread {
    requests: Sender<(u64, RenderRequest)>,
    latest: Option<RenderRequest>,
    shared: Arc<Shared>,
}

/// The state that the window and the render thread share.
#[derive(Default)]
struct Shared {
    /// The number of requests so far. Samples for an earlier one are abandoned.
    generation: AtomicU64,
    /// The latest frame, until the window takes it.
    frame: Mutex<Option<Frame>>,
}

impl RenderThread {
    /// Starts the thread. It chooses a level of detail at which a coarse frame takes no longer
    /// than `target`, if there is one.
    pub fn new(target: Duration) -> Self {
        let (sender, requests) = channel();
        let shared = Arc::<Shared>::default();
        let clone = Arc::clone(&shared);
        thread::spawn(move || clone.render_loop(&requests, target));
        Self {
            requests: sender,
            latest: None,
            shared,
        }
    }

    /// Replaces the latest request. One that equals it changes nothing.
    pub fn request(&mut self, request: RenderRequest) {
        if self.latest != Some(request) {
            self.latest = Some(request);
            let before = self.shared.generation.fetch_add(1, Ordering::Relaxed);
            // An error means that the thread is gone: then there are no more frames.
            let _ = self.requests.send((before + 1, request));
        }
    }

    /// Takes the latest frame; `None` if none was rendered since the last call.
    pub fn take_frame(&self) -> Option<Frame> {
        self.shared.frame().take()
    }
}

impl Drop for RenderThread {
    fn drop(&mut self) {
        self.shared.generation.fetch_add(1, Ordering::Relaxed);
    }
}
// ANCHOR_END: thread

// ANCHOR: render-loop
impl Shared {
    /// Renders until the handle is dropped, and with it the sender of the requests.
    fn render_loop(
        self: Arc<Self>,
        requests: &Receiver<(u64, RenderRequest)>,
        target: Duration,
    ) {
        let mut lod = 0;
        while let Ok(next) = requests.recv() {
            let (generation, request) = requests.try_iter().last().unwrap_or(next);
            let (view, setting, size) = (request.view, request.setting, request.size);
            let camera = request.pose.camera();
            let total_samples = view.samples(setting);
            let publish = |canvas, lod, samples, took| {
                *self.frame() = Some(Frame {
                    request,
                    canvas,
                    lod,
                    samples,
                    total_samples,
                    took,
                });
            };

            // This frame is finished even if there is a newer request: while requests follow
            // each other, no other frame is shown.
            let start = Instant::now();
            let coarse = view.preview(camera, setting);
            let canvas = Canvas::render(&coarse, size_at_lod(size, lod));
            let took = start.elapsed();
            let is_exact = lod == 0 && total_samples == 1;
            publish(canvas, lod, u32::from(is_exact), took);
            lod = next_lod(lod, took, target);
            if request.is_moving || is_exact {
                continue;
            }

            let mut accumulator = Accumulator::new(size);
            for i in 0..total_samples {
                let start = Instant::now();
                let sample = view.sample(camera, setting, i);
                let sample = Arc::clone(&self).while_latest(generation, sample);
                let mut canvas = Canvas::render(&sample, size);
                if !self.is_latest(generation) {
                    break;
                }
                accumulator.add(&mut canvas);
                publish(canvas, 0, i + 1, start.elapsed());
            }
        }
    }

    fn is_latest(&self, generation: u64) -> bool {
        self.generation.load(Ordering::Relaxed) == generation
    }

    /// Returns `picture`, abandoned when there is a newer request: its remaining spans are
    /// black.
    fn while_latest(self: Arc<Self>, generation: u64, picture: Picture) -> Picture {
        Picture::from_spans(move |first, span| {
            if self.is_latest(generation) {
                picture.render_span(first, span);
            }
        })
    }

    /// Locks the frame, which is whole even after a panic: it is only ever replaced.
    fn frame(&self) -> MutexGuard<'_, Option<Frame>> {
        self.frame.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
// ANCHOR_END: render-loop
