//! How often the cause is named first, and among the first three.

use check::fault::Fault;
use check::figures::{Figure, figures};
use check::image::{Image, book};
use check::matching::Observation;
use check::mutations::MUTATIONS;
use rayon::prelude::*;

fn drawn(figure: &Figure, size: [u32; 2], fault: Fault) -> Image {
    let [w, h] = size;
    let pixels = (0..w * h).into_par_iter();
    let levels = pixels.map(|i| figure.pixel([i % w, i / w], size, fault));
    Image {
        size,
        levels: levels.collect(),
    }
}

#[test]
fn explore() {
    let figures = figures(book().expect("pictures"));
    let names: &[&str] = &["02-sphere-hit--normals", "03-plane-hit--flat", "04-shadows--hard", "04-shadows--beyond", "05-shading--combined", "06-reflection--bouncing", "06-reflection--facing-mirrors--knob-5", "07-refraction--ball","07-refraction--bubble", "08-fresnel--still-life", "08-fresnel--reflectance", "09-anti-aliasing--grid--knob-2", "10-shadow-acne--from-surface", "11-transparency--ball", "11-transparency--displaced", "12-packets--still-life--knob-4"];
    let size = [120, 90];
    let (mut first, mut third, mut all) = (0, 0, 0);
    for mutation in MUTATIONS {
        let mut seen = 0;
        for name in names.iter().copied() {
            let figure = figures.iter().find(|f| f.names.iter().any(|n| n == name)).expect(name);
            let fault = mutation.faults[0];
            let right = drawn(figure, size, Fault::None);
            let wrong = drawn(figure, size, fault);
            let differ = right.levels.iter().zip(&wrong.levels).filter(|(a, b)| (0..3).any(|c| a[c].abs_diff(b[c]) > 3)).count();
            if (differ as f64) < 0.003 * 120.0 * 90.0 {
                continue;
            }
            seen += 1;
            let observation = Observation::new(figure, &wrong, |at| right.pixel(at), 400);
            let causes = observation.causes();
            let rank = causes.iter().position(|c| c.mutation.is_some_and(|m| m.name == mutation.name));
            all += 1;
            if rank == Some(0) { first += 1; }
            if rank.is_some_and(|r| r < 3) { third += 1; }
            if rank != Some(0) {
                let top: Vec<_> = causes.iter().take(4).map(|c| format!("{} {:.3}", c.mutation.map_or("colours", |m| m.name), c.explained)).collect();
                println!("{:22} {name:30} {rank:?} {}", mutation.name, top.join(", "));
            }
        }
        if seen < 2 { println!("ONLY {seen}: {}", mutation.name); }
    }
    println!("{first} {third} of {all}");
}
