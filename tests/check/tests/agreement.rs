//! The small tracer draws the book's pictures.

use check::fault::Fault;
use check::figures::figures;
use check::image::book;
use rayon::prelude::*;

/// Every picture that is described is the book's: of one ray per pixel, to the last bit; of more, to one
/// level, as the order of the additions shows, but for half a percent of the pixels.
#[test]
fn the_small_tracer_draws_the_pictures_of_the_book() {
    let pictures = book().expect("the book's pictures");
    let figures = figures(pictures.clone());
    let lines: Vec<_> = pictures
        .par_iter()
        .filter_map(|(name, picture)| {
            let figure = figures.iter().find(|figure| figure.names.contains(name))?;
            if !figure.is_described() {
                return None;
            }
            let [w, h] = picture.size;
            // Some ten thousand pixels of each, and fewer of many rays.
            let step = (2 * figure.cost() as u32).max(w * h / 15_360) | 1;
            let all = (0..w * h).step_by(step as usize);
            let allowed = u8::from(figure.cost() > 1);
            let mut count = 0;
            let mut differ = 0;
            let mut worst = 0;
            for i in all {
                let at = [i % w, i / w];
                let [a, b] = [
                    picture.pixel(at),
                    figure.pixel(at, picture.size, Fault::None),
                ];
                count += 1;
                let by = (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
                differ += u32::from(by > allowed);
                worst = worst.max(by);
            }
            let share = f64::from(differ) / f64::from(count);
            let most = if figure.cost() == 1 { 0.0 } else { 0.005 };
            Some((name.clone(), share, worst, share <= most))
        })
        .collect();
    for (name, share, worst, _) in &lines {
        if *worst > 0 {
            println!("{name}: {share:.5} worst {worst}");
        }
    }
    println!("{} described", lines.len());
    assert!(lines.iter().all(|line| line.3));
}
