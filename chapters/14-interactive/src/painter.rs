//! Paints in the background what the window asks for: coarse at once, then finer, until it
//! is exact.

use crate::views::{central, sample, samples};
use crate::{Walker, accumulating, halved, next_halvings, no_sums};
use canvas::{Canvas, Picture};
use glam::UVec2;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard};
use std::thread;
use std::time::{Duration, Instant};

// ANCHOR: wish
/// What to paint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wish {
    /// From where.
    pub walker: Walker,
    /// The view's index.
    pub view: usize,
    /// The setting of its knob.
    pub setting: f32,
    /// The size of the whole picture, in pixels.
    pub size: UVec2,
    /// Whether the next wish is only a moment away: then one coarse frame is enough.
    pub is_moving: bool,
}

/// A painted frame.
pub struct Frame {
    /// What was wished.
    pub wish: Wish,
    /// The frame, as large as [`halved`] says.
    pub canvas: Canvas,
    /// How often its sides are halved.
    pub halvings: u32,
    /// How many samples each pixel has, of how many; none while it is coarse.
    pub samples: (u32, u32),
    /// How long it took, or its last sample.
    pub took: Duration,
}

impl Frame {
    /// Whether there is nothing left to refine.
    pub fn is_exact(&self) -> bool {
        self.samples.0 == self.samples.1
    }
}
// ANCHOR_END: wish

/// The other side of a painter's thread. Dropped, it stops the painting.
pub struct Painter(Arc<Desk>);

/// Where a wish lies, and the frame that has come of it: the last ones only, so that neither side
/// waits for the other.
struct Desk {
    wish: Mutex<Option<Wish>>,
    is_new: Condvar,
    /// How many wishes there have been. What is painted for an earlier one is given up.
    wishes: AtomicU64,
    frame: Mutex<Option<Frame>>,
}

/// The number of the last wish, after which there is none.
const CLOSED: u64 = u64::MAX;

impl Painter {
    /// Starts its thread. No coarse frame should take longer than `target`.
    pub fn new(target: Duration) -> Self {
        let desk = Arc::new(Desk {
            wish: Mutex::new(None),
            is_new: Condvar::new(),
            wishes: AtomicU64::new(0),
            frame: Mutex::new(None),
        });
        let its_desk = Arc::clone(&desk);
        thread::spawn(move || its_desk.work(target));
        Self(desk)
    }

    /// Wishes for a picture. The same as the last changes nothing.
    pub fn wish(&self, wish: Wish) {
        let mut last = lock(&self.0.wish);
        if *last != Some(wish) {
            *last = Some(wish);
            self.0.wishes.fetch_add(1, Ordering::Relaxed);
            self.0.is_new.notify_one();
        }
    }

    /// The newest frame, if this has not been asked for since it was painted.
    pub fn frame(&self) -> Option<Frame> {
        lock(&self.0.frame).take()
    }
}

impl Drop for Painter {
    fn drop(&mut self) {
        // With the lock: else it could fall between the thread's look and its sleep.
        let _wish = lock(&self.0.wish);
        self.0.wishes.store(CLOSED, Ordering::Relaxed);
        self.0.is_new.notify_one();
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().expect("nobody panics with it")
}

// ANCHOR: work
impl Desk {
    fn work(self: &Arc<Self>, target: Duration) {
        let mut halvings = 0;
        let mut done = 0;
        while let Some((number, wish)) = self.next_after(done) {
            done = number;
            let (camera, size) = (wish.walker.camera(), wish.size);
            let count = samples(wish.view, wish.setting);
            let lay = |canvas, halvings, samples, took| {
                *lock(&self.frame) = Some(Frame {
                    wish,
                    canvas,
                    halvings,
                    samples: (samples, count),
                    took,
                });
            };

            // A frame at once, whatever is wished meanwhile: whoever moves wants to see it.
            let start = Instant::now();
            let coarse = central(wish.view, camera, wish.setting);
            let coarse = self.until(CLOSED, coarse);
            let canvas = Canvas::paint(&coarse, halved(size, halvings));
            let took = start.elapsed();
            let is_exact = halvings == 0 && count == 1;
            lay(canvas, halvings, u32::from(is_exact), took);
            halvings = next_halvings(halvings, took, target);
            if wish.is_moving || is_exact {
                continue;
            }

            let sums = no_sums(size);
            for i in 0..count {
                let start = Instant::now();
                let sample = sample(wish.view, camera, wish.setting, i);
                let mean = accumulating(sample, Arc::clone(&sums), i + 1);
                let canvas = Canvas::paint(&self.until(number + 1, mean), size);
                if self.wishes.load(Ordering::Relaxed) != number {
                    break;
                }
                lay(canvas, 0, i + 1, start.elapsed());
            }
        }
    }

    /// Sleeps until there is a wish that is not `done`; none when it is closed.
    fn next_after(&self, done: u64) -> Option<(u64, Wish)> {
        let wish = lock(&self.wish);
        let is_done = |_: &mut Option<Wish>| self.wishes.load(Ordering::Relaxed) == done;
        let wish = self.is_new.wait_while(wish, is_done).ok()?;
        let number = self.wishes.load(Ordering::Relaxed);
        (number != CLOSED).then_some((number, (*wish)?))
    }

    /// A picture that is given up from the wish of that number on: what is left of it is black.
    fn until(self: &Arc<Self>, number: u64, picture: Picture) -> Picture {
        let desk = Arc::clone(self);
        Picture::by_runs(move |first, run| {
            if desk.wishes.load(Ordering::Relaxed) < number {
                picture.paint(first, run);
            }
        })
    }
}
// ANCHOR_END: work
