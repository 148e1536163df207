//! What is said about a picture, on one screen.

use crate::figures::Figure;
use crate::image::{self, Image};
use crate::matching::{Cause, Observation, Reference, equal, guess, named};
use crate::mutations;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Where the book explains what no row of the table does: a few pixels that differ, and the rest.
pub const PLACES: [&str; 2] = [
    "mathematics.md#floating-point-in-four-sentences",
    "when-things-go-wrong.md#what-you-see-and-where-to-look",
];
/// A cause is named only if it explains at least this much of the difference.
pub const BELIEVED: f32 = 0.55;
/// Fewer pixels may differ for any reason, like another arithmetic: all of them must be explained.
const FEW: usize = 16;
const ALL: f32 = 0.99;
/// Causes whose explanations differ by less draw the same picture.
const SAME: f32 = 1e-4;
/// A cause that explains so much less than the likeliest is not named.
const MUCH_LESS: f32 = 0.25;
/// Of a picture that may also be meant, a cause must explain nearly as much as the likeliest.
const LESS: f32 = 0.05;
/// A picture is taken for one of the reader's own from here on.
const OWN: f32 = 0.8;
/// The most rays that are traced to count differing pixels.
const MAX_RAYS: usize = 4_000_000;
/// The number of pixels at which causes are compared.
const SAMPLES: usize = 800;

/// What has been found out about a picture.
pub struct Verdict {
    /// Whether it is the book's, to the last bit.
    pub is_equal: bool,
    /// The name of the book's picture.
    pub name: String,
    /// The likely causes, the likeliest first; none that explains too little.
    pub causes: Vec<Cause>,
    /// The report, for the terminal.
    pub text: String,
}

/// Judges a picture: `told` is the name of the picture that it is meant to be, if that is known.
///
/// A heat map is saved in `folder` as `label--heat.png` if the pictures differ. `None` if the book
/// has no such picture.
#[must_use]
pub fn judge(
    yours: &Image,
    told: Option<&str>,
    (figures, book): (&[Figure], &[(String, Image)]),
    (folder, label): (&Path, &str),
) -> Option<Verdict> {
    let equals = equal(yours, book);
    let references = match told.or(equals.first().copied()) {
        Some(name) => vec![named(name, figures, book)?],
        None => guess(yours, figures, book),
    };
    let reference = *references.first()?;
    let mut text = String::new();
    let verdict = |is_equal, causes, text| {
        Some(Verdict {
            is_equal,
            name: reference.name.to_string(),
            causes,
            text,
        })
    };
    if equals.contains(&reference.name) {
        let _ = writeln!(text, "equal to the book's {}", equals.join(" and "));
        if let Some(row) = mutations::of(reference.figure.shows) {
            let _ = writeln!(text, "  which shows a fault on purpose: {}", row.cause);
            let _ = writeln!(text, "     book/src/{}", row.page);
            let _ = writeln!(
                text,
                "  if it was meant to be another picture, say which: --picture NAME"
            );
        }
        return verdict(true, Vec::new(), text);
    }
    let comparison = Comparison::new(yours, reference);
    let [w, h] = reference.book.size;
    let of_size = if reference.has_size(yours.size) {
        String::new()
    } else if reference.figure.is_described() {
        format!(", which is {w}x{h}: drawn anew at your size")
    } else {
        format!(", which is {w}x{h}: scaled to your size, so edges differ")
    };
    if comparison.differ == 0 {
        let _ = writeln!(text, "equal to {}{of_size}", reference.name);
        return verdict(true, Vec::new(), text);
    }
    let how = if told.is_some() {
        "compared with"
    } else {
        "most like"
    };
    let _ = writeln!(text, "{how} {}{of_size}", reference.name);
    text += &comparison.lines();
    let _ = writeln!(text, "  {}", save_heat_map(yours, reference, folder, label));
    let (own, causes) = likely_among(yours, &references, SAMPLES);
    let share = f64::from(comparison.differ) / f64::from(comparison.count);
    if let Some(own) = own {
        let what = match (own.is_elsewhere, own.recoloured > 0) {
            (true, true) => "seen from elsewhere, in other colours",
            (true, false) => "seen from elsewhere",
            (false, _) => "in other colours",
        };
        let _ = writeln!(
            text,
            "a picture of your own: the book's scene {what}, in which I find no mistake"
        );
    } else if !causes.is_empty() {
        text += "the likely causes, the likeliest first:\n";
        let mut number = 0;
        let mut before = f32::INFINITY;
        let mut meant = reference.name;
        for (as_what, cause) in &causes {
            let Some(row) = cause.mutation else { continue };
            if as_what.name != meant {
                meant = as_what.name;
                before = f32::INFINITY;
                let _ = writeln!(text, "  or, if it is meant to be {meant}:");
            }
            // Causes that draw the same picture here have the same number.
            if before - cause.explained > SAME {
                number += 1;
            }
            before = cause.explained;
            let percent = (100.0 * cause.explained).round();
            let _ = writeln!(text, "  {number}. {}", row.cause);
            let besides = if cause.recoloured > 0 {
                ", with colours of your own"
            } else {
                ""
            };
            let _ = writeln!(
                text,
                "     explains {percent} %{besides}; see book/src/{}",
                row.page
            );
        }
    } else if !reference.has_size(yours.size) && is_scaled(yours, reference.book) {
        text += "this is the book's picture, scaled: draw it at its own size, and compare that\n";
    } else if share < 0.01 || comparison.worst <= 2 {
        text += "no cause is known for so little: often it is only another precision, or another order of\n";
        let _ = writeln!(
            text,
            "additions, which moves a few pixels at edges (book/src/{})",
            PLACES[0]
        );
    } else {
        text += "I do not know this one: it is a picture of your own, or a mistake that is not in my table\n";
        let _ = writeln!(text, "     see book/src/{}", PLACES[1]);
    }
    if told.is_none() {
        text += "if it is meant to be another picture of the book, say which: --picture NAME\n";
    }
    let causes = causes.into_iter().map(|(_, cause)| cause).collect();
    verdict(false, causes, text)
}

/// Returns in which way the picture is the reader's own, and otherwise the likely causes, the
/// likeliest first: three at most, and none if none explains enough.
#[must_use]
pub fn likely(observation: &Observation) -> (Option<Cause>, Vec<Cause>) {
    let mut causes = observation.causes();
    let own = causes
        .first()
        .filter(|first| first.mutation.is_none() && first.explained >= OWN);
    if let Some(own) = own {
        return (Some(own.clone()), Vec::new());
    }
    let best = causes.first().map_or(0.0, |first| first.explained);
    let enough = if observation.differing() < FEW {
        ALL
    } else {
        BELIEVED
    };
    let believed = enough.max(best - MUCH_LESS);
    causes.retain(|cause| cause.mutation.is_some() && cause.explained >= believed);
    causes.truncate(3);
    (None, causes)
}

/// Returns the same for a picture that is probably meant to be the first of these, but may be
/// another: what explains it as one of the others comes after what explains it as the first.
#[must_use]
pub fn likely_among<'a>(
    yours: &Image,
    references: &[Reference<'a>],
    count: usize,
) -> (Option<Cause>, Vec<(Reference<'a>, Cause)>) {
    let mut all: Vec<(_, Cause)> = Vec::new();
    for (i, reference) in references.iter().enumerate() {
        let few = if reference.figure.cost() > 4 { 4 } else { 1 };
        let (own, causes) = likely(&reference.observe(yours, count / few));
        if i == 0 && own.is_some() {
            return (own, all);
        }
        let best = all.first().map_or(0.0, |(_, first)| first.explained);
        for cause in causes
            .into_iter()
            .filter(|cause| i == 0 || cause.explained > best - LESS)
        {
            let is_new = |(_, other): &(_, Cause)| {
                let name = |cause: &Cause| cause.mutation.map(|row| row.name);
                name(other) != name(&cause)
            };
            if all.iter().all(is_new) {
                all.push((*reference, cause));
            }
        }
    }
    all.truncate(3);
    (None, all)
}

/// Returns whether the picture is the book's, scaled: nearly every pixel is between the least and
/// the most of those that it may be a mean of.
fn is_scaled(yours: &Image, book: &Image) -> bool {
    let [w, h] = yours.size;
    let [bw, bh] = book.size;
    let around = |i: u32, n: u32, of: u32| {
        let [from, to] = [i * of / n, ((i + 1) * of).div_ceil(n)];
        from.saturating_sub(1)..(to + 1).min(of)
    };
    let is_between = |i: u32| {
        let at = [i % w, i / w];
        let pixel = yours.pixel(at);
        (0..3).all(|c| {
            let levels = around(at[1], h, bh)
                .flat_map(|y| around(at[0], w, bw).map(move |x| book.pixel([x, y])[c]));
            let (least, most) = levels.fold((255, 0), |(a, b), l| (l.min(a), l.max(b)));
            (least.saturating_sub(4)..=most.saturating_add(4)).contains(&pixel[c])
        })
    };
    let pixels = (0..w * h)
        .into_par_iter()
        .step_by((w * h) as usize / 8192 + 1);
    let is_between: Vec<_> = pixels.map(is_between).collect();
    let between = is_between.iter().filter(|is| **is).count();
    between * 100 >= is_between.len() * 98
}

/// How many pixels differ, and where.
struct Comparison {
    count: u32,
    differ: u32,
    worst: u8,
    worst_at: [u32; 2],
    levels: [[u8; 3]; 2],
    /// Of each object: the pixels, and how many of them differ.
    objects: Vec<(String, u32, u32)>,
}

impl Comparison {
    fn new(yours: &Image, reference: Reference) -> Self {
        let [w, h] = yours.size;
        let rays = match reference.has_size(yours.size) {
            true => 1,
            false => reference.figure.cost(),
        } * (w * h) as usize;
        let step = rays.div_ceil(MAX_RAYS);
        let pixels = (0..w * h).into_par_iter().step_by(step).map(|i| {
            let at = [i % w, i / w];
            let [book, yours] = [reference.pixel(at, yours.size), yours.pixel(at)];
            let worst = (0..3)
                .map(|c| book[c].abs_diff(yours[c]))
                .max()
                .unwrap_or(0);
            (worst, at, [book, yours])
        });
        let pixels: Vec<_> = pixels.collect();
        let differing = pixels.iter().filter(|(worst, ..)| *worst > 0);
        // The first of the worst.
        let found = pixels.iter().rev().max_by_key(|(worst, ..)| *worst);
        let (worst, worst_at, levels) = found.copied().unwrap_or_default();
        let mut objects: BTreeMap<_, [u32; 2]> = BTreeMap::new();
        // A hundredth of the pixels tells where.
        for (worst, at, _) in pixels.iter().step_by(pixels.len() / 8192 + 1) {
            let region = reference.figure.region(*at, yours.size);
            let [all, differ] =
                objects.entry(region.map(|(index, ..)| index)).or_default();
            *all += 1;
            *differ += u32::from(*worst > 0);
        }
        let objects = objects.into_iter().map(|(index, [all, differ])| {
            let name = index.map_or("the sky", |index| reference.figure.object(index));
            (name.to_string(), all, differ)
        });
        Self {
            count: pixels.len() as u32,
            differ: differing.count() as u32,
            worst,
            worst_at,
            levels,
            objects: objects.collect(),
        }
    }

    fn lines(&self) -> String {
        let [book, yours] = self.levels.map(|[r, g, b]| format!("{r}, {g}, {b}"));
        let [x, y] = self.worst_at;
        let mut lines = format!(
            "  {} of {} pixels differ; the worst, at x = {x}, y = {y}, is {book} in the book and {yours} in yours\n",
            self.differ, self.count
        );
        if self.objects.len() > 1 {
            let mut objects = self.objects.clone();
            objects.sort_by_key(|(_, all, differ)| std::cmp::Reverse(100 * differ / all));
            let shares: Vec<_> = objects
                .iter()
                .filter(|(_, all, differ)| 100 * differ >= *all)
                .take(6)
                .map(|(name, all, differ)| format!("{name} {} %", 100 * differ / all))
                .collect();
            let _ = writeln!(lines, "  where: {}", shares.join(", "));
        }
        lines
    }
}

/// Saves the book's picture, the reader's and the differences side by side. Returns the line that
/// says so.
fn save_heat_map(
    yours: &Image,
    reference: Reference,
    folder: &Path,
    label: &str,
) -> String {
    let [w, h] = yours.size;
    let is_cheap = reference.has_size(yours.size)
        || reference.figure.cost() * (w as usize) * (h as usize) <= MAX_RAYS;
    if !is_cheap {
        return "no heat map, as drawing the picture at your size would take long"
            .to_string();
    }
    let rows: Vec<_> = (0..h)
        .into_par_iter()
        .flat_map_iter(|y| {
            let book = (0..w).map(move |x| reference.pixel([x, y], [w, h]));
            let book: Vec<_> = book.collect();
            let mine: Vec<_> = (0..w).map(|x| yours.pixel([x, y])).collect();
            let heat: Vec<_> =
                book.iter().zip(&mine).map(|(&a, &b)| heat(a, b)).collect();
            [book, mine, heat].concat()
        })
        .collect();
    let map = Image {
        size: [3 * w, h],
        levels: rows,
    };
    let path = folder.join(format!("{label}--heat.png"));
    match fs::create_dir_all(folder).and_then(|()| image::write(&path, &map)) {
        Ok(()) => format!(
            "heat map: {} (the book's | yours | what differs)",
            path.display()
        ),
        Err(error) => format!(
            "the heat map cannot be saved as {}: {error}",
            path.display()
        ),
    }
}

/// Returns black for equal pixels, and from red over yellow to white for the worse.
fn heat(a: [u8; 3], b: [u8; 3]) -> [u8; 3] {
    let worst = (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
    match u16::from(worst) {
        0 => [0; 3],
        // Even a difference of one level must be seen.
        worst => [
            (96 + 4 * worst).min(255) as u8,
            (2 * worst).min(255) as u8,
            (2 * worst).saturating_sub(255).min(255) as u8,
        ],
    }
}
