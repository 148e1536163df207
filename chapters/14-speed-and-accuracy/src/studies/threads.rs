//! Threads: the gain, one ray at once and in packets.

use super::packets::{LARGE, TIME, differing, still_life};
use crate::chart::{Chart, Quantity};
use crate::study::{Choice, Clock, Study, each};
use crate::table::Measurement;
use canvas::Canvas;
use measure::pictures::{frame, pool};
use packets::LANES;

/// The still life on as many threads as the setting says, one ray at once or in packets.
///
/// Nanoseconds and work, which is rays, are those of one pixel. It is wrong if any bit
/// differs from that of one ray at once on one thread.
pub const STUDY: Study = Study {
    name: "threads",
    title: "What threads gain, one ray at once and in packets",
    measure,
    chosen: &[Choice::of("packets")],
    charts: &[Chart::new("threads", (Quantity::Setting, "threads"), TIME)
        .titled("The still life: threads help as far as there are processors")],
};

fn measure(clock: &Clock) -> Vec<Measurement> {
    let [one_by_one, packets] = still_life(1);
    let right = frame(&one_by_one, LARGE, LANES);
    let methods = [("one by one", &one_by_one), ("packets", &packets)];
    let mut rows = Vec::new();
    for threads in [1, 2, 4, 8] {
        let pool = &pool(threads);
        let render = |picture| pool.install(|| Canvas::render(picture, LARGE));
        let jobs = methods.map(|(_, picture)| each(&[()], move |()| render(picture)));
        let times = clock.min_of_rounds(right.len(), jobs);
        for ((method, picture), ns) in methods.into_iter().zip(times) {
            let canvas = render(picture);
            rows.push(Measurement {
                work: Some(canvas.rays as f64 / right.len() as f64),
                wrong: differing(&right, &canvas.radiance),
                ns,
                ..Measurement::of("threads", method, threads as f64)
            });
        }
    }
    rows
}
