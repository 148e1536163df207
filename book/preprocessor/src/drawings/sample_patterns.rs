//! The points in a pixel at which chapter 9's samplers ask for light.

use super::{Panel, scale};
use anti_aliasing::Sampler;
use canvas::Pixel;
use glam::{UVec2, Vec2, Vec3};
use speed_and_accuracy::studies::sampling::SAMPLERS;
use std::cell::RefCell;

const N: u32 = 4;
const SIDE: f64 = 240.0;
/// One pixel of a picture of the book's size, as good as any other.
const PIXEL: Pixel = Pixel {
    x: 100,
    y: 80,
    size: UVec2::new(320, 240),
};

/// The samplers that are drawn, and what to see in their patterns.
const SHOWN: [(&str, &str); 6] = [
    ("regular", "the middle of each cell"),
    ("jittered", "anywhere in each cell"),
    (
        "adaptive",
        "four rays first (rings), and the others because those four differ: the grey part of this pixel has another colour than the rest",
    ),
    ("random", "anywhere in the pixel, in clumps and gaps"),
    (
        "R2",
        "in equal steps, which go on at the left where they leave at the right",
    ),
    (
        "Owen-Sobol",
        "one in each cell, and in each row and column of sixteenths",
    ),
];

pub fn panels() -> Vec<Panel> {
    SHOWN
        .into_iter()
        .map(|(name, what)| panel(name, what))
        .collect()
}

fn panel(name: &str, what: &str) -> Panel {
    // The points on an edge are not cut off.
    let ends = [5.0, SIDE - 5.0];
    let place = scale([0.0, 1.0], ends);
    let mut panel = Panel::new([SIDE, SIDE]);
    // Half of the pixel is light, so that the adaptive sampler has something to find.
    let edge = (name == "adaptive").then_some(0.4);
    if let Some(edge) = edge {
        panel.rectangle("solid", [[ends[0]; 2], [place(edge.into()), ends[1]]]);
    }
    for i in 0..=N {
        let along = place(f64::from(i) / f64::from(N));
        panel.line("faint", ends.map(|end| [along, end]));
        panel.line("faint", ends.map(|end| [end, along]));
    }
    panel.rectangle("ink", ends.map(|end| [end; 2]));
    let positions = positions(sampler(name), edge.unwrap_or_default());
    // What is more than n × n is the adaptive sampler's first look.
    let first = positions.len() - (N * N) as usize;
    for (i, position) in positions.iter().enumerate() {
        // The image plane's y is up, the panel's down.
        let at = [place(position.x.into()), place(1.0 - f64::from(position.y))];
        let (class, radius) = if i < first {
            ("ink", 7.0)
        } else {
            ("dot ray", 4.5)
        };
        panel.circle(class, at, radius);
    }
    let initial = name[..1].to_uppercase() + &name[1..];
    panel.caption = format!("{initial}: {what}.");
    panel.description = format!(
        "{} points in a pixel of {N} by {N} cells, {name}: {what}.",
        positions.len()
    );
    panel
}

fn sampler(name: &str) -> Sampler {
    let sampler = SAMPLERS.into_iter().find(|(known, _)| *known == name);
    sampler.expect("a sampler of the study").1
}

/// Returns the positions in a pixel, from (0, 0) at its lower left to (1, 1), that a sampler asks
/// for, in its order. Left of `edge` the pixel is light, right of it dark.
fn positions(sampler: Sampler, edge: f32) -> Vec<Vec2> {
    let asked = RefCell::new(Vec::new());
    sampler(PIXEL, N, &|point| {
        let position = (point - PIXEL.centre()) / PIXEL.footprint() + Vec2::splat(0.5);
        asked.borrow_mut().push(position);
        Vec3::splat(if position.x < edge { 1.0 } else { 0.0 })
    });
    asked.into_inner()
}

#[cfg(test)]
mod the_patterns {
    use super::*;
    use std::collections::BTreeSet;

    /// In how many of so many columns and rows of a pixel there is a point.
    fn filled(positions: &[Vec2], columns: f32, rows: f32) -> usize {
        let cells = positions.iter().map(|position| {
            let cell = *position * Vec2::new(columns, rows);
            // Rounding may put a point that is on a border on its other side.
            [cell.x + 1e-3, cell.y + 1e-3].map(|x| x as u32)
        });
        cells.collect::<BTreeSet<_>>().len()
    }

    #[test]
    fn are_as_their_captions_say() {
        for (name, _) in SHOWN {
            let positions = positions(sampler(name), 0.4);
            let expected = if name == "adaptive" { 20 } else { 16 };
            assert_eq!(positions.len(), expected, "{name}");
            let last = &positions[positions.len() - 16..];
            let is_stratified =
                ["regular", "jittered", "adaptive", "Owen-Sobol"].contains(&name);
            assert_eq!(filled(last, 4.0, 4.0) == 16, is_stratified, "{name}");
            let is_sobol = name == "Owen-Sobol";
            let lines = [filled(last, 16.0, 1.0), filled(last, 1.0, 16.0)];
            assert_eq!(lines == [16, 16], is_sobol, "{name}: {lines:?}");
        }
    }
}
