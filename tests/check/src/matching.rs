//! Which picture of the book it is meant to be, and what probably went wrong.
//!
//! Every figure is drawn once more with every fault, at some of the reader's own pixels. The fault
//! whose picture comes closest to the reader's is the likeliest. So what is compared is where and
//! how the pictures differ, at any size, and no wrong picture need be known beforehand.

use crate::fault::Fault;
use crate::figures::{Figure, Part};
use crate::image::Image;
use crate::levels::{decode, levels};
use crate::mutations::{MUTATIONS, Mutation};
use crate::report::likely;
use crate::tracer::Region;
use glam::Vec3;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// A pixel of the reader's that is compared.
#[derive(Clone, Copy)]
struct Sample {
    at: [u32; 2],
    /// How many pixels it stands for.
    weight: f32,
    yours: [u8; 3],
    book: [u8; 3],
    region: Region,
}

/// A likely cause.
#[derive(Clone, Debug)]
pub struct Cause {
    /// The row of the table; `None` is no mistake, but a picture of the reader's own.
    pub mutation: Option<&'static Mutation>,
    /// Whether the camera is elsewhere.
    pub is_elsewhere: bool,
    /// How much of the difference it explains, 1 being all of it, less a little for each further
    /// colour that must be another.
    pub explained: f32,
    /// The objects that have another colour besides.
    pub recoloured: usize,
}

/// From this difference in a channel on, a pixel is simply wrong.
const SATURATION: f32 = 48.0;

/// A reader's own colours are only estimated: differences up to this are ignored then.
const TOLERANCE: u8 = 3;

/// Returns the difference of two pixels, from 0 to 1.
fn distance(a: [u8; 3], b: [u8; 3]) -> f32 {
    distance_beyond(0, a, b)
}

/// Returns the difference of two pixels, from 0 to 1, the greater the farther they are.
fn far_distance(a: [u8; 3], b: [u8; 3]) -> f32 {
    let channels = a.into_iter().zip(b);
    channels.map(|(a, b)| f32::from(a.abs_diff(b))).sum::<f32>() / 765.0
}

fn distance_beyond(tolerance: u8, a: [u8; 3], b: [u8; 3]) -> f32 {
    let channels = a.into_iter().zip(b);
    let differences = channels.map(|(a, b)| a.abs_diff(b).saturating_sub(tolerance));
    differences
        .map(|d| (f32::from(d) / SATURATION).min(1.0))
        .sum::<f32>()
        / 3.0
}

/// The pixels that are compared, and what is in them.
pub struct Observation<'a> {
    figure: &'a Figure,
    size: [u32; 2],
    samples: Vec<Sample>,
    /// More of them, regardless of whether they differ: for what is compared region by region.
    evenly: Vec<Sample>,
}

impl<'a> Observation<'a> {
    /// Takes about `count` pixels of `yours`: of those that differ from `book` and of those that do
    /// not, each about half.
    ///
    /// `book` returns a pixel of the figure at the reader's size.
    #[must_use]
    pub fn new(
        figure: &'a Figure,
        yours: &Image,
        book: impl Fn([u32; 2]) -> [u8; 3] + Sync,
        count: usize,
    ) -> Self {
        let size = yours.size;
        let [w, h] = size;
        // More candidates than needed, as the half that differs may be small.
        let total = w as usize * h as usize;
        let step = (total / (16 * count)).max(1);
        let pixels: Vec<_> = (0..total)
            .step_by(step)
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|i| {
                // A different place in every step, so that no pattern of the picture's is met.
                let i = (i + scatter(i) % step).min(total - 1) as u32;
                let at = [i % w, i / w];
                (at, yours.pixel(at), book(at))
            })
            .collect();
        let sample = |(at, yours, book), weight| Sample {
            at,
            weight,
            yours,
            book,
            region: figure.region(at, size),
        };
        let few = if figure.cost() > 4 { 256 } else { 1536 };
        let evenly = pixels.iter().step_by((pixels.len() / few).max(1));
        let evenly = evenly.map(|&pixel| sample(pixel, 1.0)).collect();
        let (differ, equal): (Vec<_>, Vec<_>) = pixels
            .into_iter()
            .partition(|(_, yours, book)| yours != book);
        let mut samples = Vec::new();
        for part in [differ, equal] {
            let step = (part.len() / (count / 2)).max(1);
            for chunk in part.chunks(step) {
                let pixel = chunk[scatter(chunk.len()) % chunk.len()];
                samples.push(sample(pixel, chunk.len() as f32));
            }
        }
        Self {
            figure,
            size,
            samples,
            evenly,
        }
    }

    /// Returns how many of the pixels differ that causes are compared at.
    #[must_use]
    pub fn differing(&self) -> usize {
        let samples = self.samples.iter();
        samples.filter(|sample| sample.yours != sample.book).count()
    }

    /// Returns the mean difference from the book's picture, from 0 to 1.
    #[must_use]
    pub fn difference(&self) -> f32 {
        let weight: f32 = self.samples.iter().map(|sample| sample.weight).sum();
        self.total() / weight
    }

    fn total(&self) -> f32 {
        let samples = self.samples.iter();
        samples.map(|s| s.weight * distance(s.yours, s.book)).sum()
    }

    /// Returns how much of the difference remains if the figure is drawn with this fault: its
    /// pixels, and whether they change at all.
    fn drawn(&self, fault: Fault) -> Option<Vec<[u8; 3]>> {
        let mut changes = false;
        let pixels = self.samples.iter().map(|sample| {
            let pixel = self.figure.pixel(sample.at, self.size, fault);
            changes |= pixel != sample.book;
            pixel
        });
        let pixels: Vec<_> = pixels.collect();
        changes.then_some(pixels)
    }

    /// Returns the part of the difference that a drawing with a fault explains, pixel by pixel, or
    /// region by region if it has speckles; negative if the drawing is farther from the reader's
    /// than the book's is.
    fn explained(&self, fault: Fault, drawn: &[[u8; 3]], tolerance: u8) -> f32 {
        let samples = self.samples.iter().zip(drawn);
        let left: f32 = samples
            .map(|(s, &drawn)| s.weight * distance_beyond(tolerance, s.yours, drawn))
            .sum();
        let by_pixel = 1.0 - left / self.total();
        if has_speckles(fault) && by_pixel < SPECKLES {
            by_pixel.max(SPECKLES * self.explained_by_region(fault))
        } else {
            by_pixel
        }
    }

    /// Speckles are nowhere the same twice: of each region, an object in the light of some of the
    /// lights, only the mean and the spread are compared.
    fn explained_by_region(&self, fault: Fault) -> f32 {
        #[derive(Default)]
        struct Sums {
            weight: f32,
            // Yours less the book's, and the drawn less the book's: the sum, and that of the squares.
            yours: [Vec3; 2],
            drawn: [Vec3; 2],
        }
        let differing = self.evenly.iter().filter(|s| s.yours != s.book).count();
        // Speckles are many. A few pixels may be anything.
        if 100 * differing < self.evenly.len() {
            return 0.0;
        }
        let mut regions: BTreeMap<_, Sums> = BTreeMap::new();
        for sample in &self.evenly {
            let drawn = self.figure.pixel(sample.at, self.size, fault);
            let [x, y] = sample.at;
            // Where nothing is known of the scene a tile is a region.
            let tile = if self.figure.has_scene() {
                [0, 0]
            } else {
                [4 * x / self.size[0], 4 * y / self.size[1]]
            };
            let sums = regions.entry((sample.region, tile)).or_default();
            let minus = |pixel: [u8; 3]| {
                let difference = Vec3::from(pixel.map(f32::from))
                    - Vec3::from(sample.book.map(f32::from));
                difference.clamp(Vec3::splat(-SATURATION), Vec3::splat(SATURATION))
            };
            sums.weight += sample.weight;
            for (to, pixel) in [(&mut sums.yours, sample.yours), (&mut sums.drawn, drawn)]
            {
                let difference = minus(pixel);
                to[0] += sample.weight * difference;
                to[1] += sample.weight * difference.abs();
            }
        }
        let [mut left, mut all] = [0.0, 0.0];
        for sums in regions.values() {
            for i in 0..2 {
                left += (sums.yours[i] - sums.drawn[i]).abs().element_sum();
                all += sums.yours[i].abs().element_sum();
            }
        }
        1.0 - left / all.max(1e-6)
    }

    /// Returns the part of the scene whose colour, if it is the reader's own, explains most of what
    /// a drawing of a `figure` with a fault does not, and by how much that colour is multiplied.
    ///
    /// Light is linear in a colour c: it is B + c (D − B), where D is drawn with c = 1 and B with
    /// c = 0. So highlights, and what a mirror shows, do not matter.
    fn own_ratio(
        &self,
        figure: &Figure,
        fault: Fault,
        drawn: &[[u8; 3]],
    ) -> Option<(Part, Vec3)> {
        let light = |pixel: [u8; 3]| {
            Vec3::from(pixel.map(|l| decode(f64::from(l) / 255.0) as f32))
        };
        let mut parts: BTreeMap<Part, Vec<usize>> = BTreeMap::new();
        for (i, sample) in self.samples.iter().enumerate() {
            let part = sample.region.map(|(index, is_odd, _)| (index, is_odd));
            parts.entry(part).or_default().push(i);
        }
        let mut gains = Vec::new();
        for (part, indices) in parts.into_iter().filter(|(_, indices)| indices.len() >= 6)
        {
            let of = |i: usize, pixel: [u8; 3]| {
                let Sample { weight, yours, .. } = self.samples[i];
                weight * distance_beyond(TOLERANCE, yours, pixel)
            };
            let before: f32 = indices.iter().map(|&i| of(i, drawn[i])).sum();
            if before == 0.0 {
                continue;
            }
            let Some(black) = figure.with_colours(&[(part, Vec3::ZERO)]) else {
                continue;
            };
            let lights: Vec<_> = indices
                .iter()
                .map(|&i| {
                    let sample = &self.samples[i];
                    let black = black.pixel(sample.at, self.size, fault);
                    [sample.yours, drawn[i], black].map(light)
                })
                .collect();
            let ratio = |c: usize| {
                let with_colour = lights.iter().filter(|[yours, drawn, black]| {
                    drawn[c] - black[c] > 0.002 && yours[c] < 0.99
                });
                let ratios = with_colour.map(|[yours, drawn, black]| {
                    (yours[c] - black[c]) / (drawn[c] - black[c])
                });
                let mut ratios: Vec<_> = ratios.collect();
                ratios.sort_by(f32::total_cmp);
                ratios
                    .get(ratios.len() / 2)
                    .copied()
                    .unwrap_or(1.0)
                    .max(0.0)
            };
            let ratios = Vec3::new(ratio(0), ratio(1), ratio(2));
            let pairs = indices.iter().zip(&lights);
            let after: f32 = pairs
                .map(|(&i, [_, drawn, black])| {
                    of(i, levels(*black + ratios * (*drawn - *black), Fault::None))
                })
                .sum();
            if after < 0.6 * before {
                gains.push((before - after, (part, ratios)));
            }
        }
        let best = gains.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
        best.map(|(_, ratio)| ratio)
    }

    /// Returns how well a fault explains the difference with colours of the reader's own besides,
    /// and their number, at most `most`. `None` if there are none.
    fn with_own_colours(
        &self,
        fault: Fault,
        drawn: &[[u8; 3]],
        most: usize,
    ) -> Option<(f32, usize)> {
        if !self.figure.has_scene() {
            return None;
        }
        let mut figure = self.figure.clone();
        let mut drawn = drawn.to_vec();
        let mut parts = BTreeSet::new();
        // One after the other, as each is seen in the mirrors too. A part may come twice, since the
        // first estimate of its colour is one of many.
        while parts.len() < most
            && let Some((part, ratio)) = self.own_ratio(&figure, fault, &drawn)
        {
            figure = figure.with_colours(&[(part, ratio)])?;
            let pixels = self.samples.iter();
            drawn = pixels
                .map(|s| figure.pixel(s.at, self.size, fault))
                .collect();
            if !parts.insert(part) {
                break;
            }
        }
        let explained = self.explained(fault, &drawn, TOLERANCE);
        (!parts.is_empty()).then_some((explained, parts.len()))
    }

    /// Returns every so many samples, so that there are about `count`.
    fn thinned(&self, count: usize) -> Self {
        let step = (self.samples.len() / count).max(1);
        Self {
            figure: self.figure,
            size: self.size,
            samples: self.samples.iter().copied().step_by(step).collect(),
            evenly: self.evenly.iter().copied().step_by(4).collect(),
        }
    }

    /// Returns how well a fault alone explains the difference. `None` if it changes nothing.
    fn direct(&self, mutation: &'static Mutation, fault: Fault) -> Option<Cause> {
        Some(Cause {
            mutation: Some(mutation),
            is_elsewhere: false,
            explained: self.explained(fault, &self.drawn(fault)?, 0),
            recoloured: 0,
        })
    }

    /// Returns how well a fault explains the difference, alone or with one or two colours of the
    /// reader's own. `None` if it changes nothing.
    fn with_colours(&self, mutation: &'static Mutation, fault: Fault) -> Option<Cause> {
        let drawn = self.drawn(fault)?;
        let direct = self.direct(mutation, fault)?;
        // What these do to a mirror, another colour of it does as well.
        if matches!(fault, Fault::MirrorMixed | Fault::MirrorTinted) {
            return Some(direct);
        }
        let with = self.with_own_colours(fault, &drawn, 2);
        let with = with.map(|(explained, recoloured)| Cause {
            mutation: Some(mutation),
            is_elsewhere: false,
            explained: explained - COST_OF_COLOUR * recoloured as f32,
            recoloured,
        });
        with.filter(|with| with.explained > direct.explained)
            .or(Some(direct))
    }

    /// Returns the strength of a fault that explains most, starting with a given one.
    fn refined(&self, mutation: &'static Mutation, mut fault: Fault) -> Fault {
        let explained = |fault| {
            self.direct(mutation, fault)
                .map_or(0.0, |cause| cause.explained)
        };
        let mut best = explained(fault);
        for factor in [1.15, 1.07, 1.03, 1.015] {
            for factor in [factor, 1.0 / factor] {
                let Some(other) = fault.scaled(factor) else {
                    return fault;
                };
                let of_other = explained(other);
                if of_other > best {
                    (fault, best) = (other, of_other);
                }
            }
        }
        fault
    }

    /// Returns how well another camera explains it, alone or with other colours: an eye elsewhere,
    /// which looks elsewhere.
    fn own_camera(&self) -> Option<Cause> {
        if !self.figure.has_camera() {
            return None;
        }
        let few = self.thinned(if self.figure.cost() > 4 { 24 } else { 96 });
        let scale = self.figure.distance_to_look();
        // The eye, and the point that it looks at, are moved by so much.
        let seen_from = |[eye, target]: [Vec3; 2]| {
            let eye = scale * eye;
            self.figure.from_elsewhere(eye, scale * target - eye)
        };
        let left = |moved: [Vec3; 2]| {
            let figure = seen_from(moved);
            let samples = few.samples.iter();
            let left = samples.map(|s| {
                let drawn = figure.pixel(s.at, few.size, Fault::None);
                s.weight * far_distance(s.yours, drawn)
            });
            left.sum::<f32>()
        };
        let in_cube = |i: usize| {
            let coordinate = |axis: usize| {
                let from_zero_to_one = (scatter(8 * i + axis) % 1024) as f32 / 1024.0;
                2.0 * from_zero_to_one - 1.0
            };
            let [eye, target] = [0, 3]
                .map(|a| Vec3::new(coordinate(a), coordinate(a + 1), coordinate(a + 2)));
            [0.4 * eye, 0.25 * target]
        };
        let starts = (1..=120).map(in_cube).chain([[Vec3::ZERO; 2]]);
        let starts: Vec<_> = starts.collect();
        let mut starts: Vec<_> = starts.par_iter().map(|&at| (left(at), at)).collect();
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        starts.truncate(4);
        let refined = starts.into_par_iter().map(|(mut least, mut at)| {
            let mut step = 0.08;
            while step > 0.001 {
                let mut is_better = false;
                for (i, axis, sign) in (0..12).map(|i| (i / 6, i / 2 % 3, i % 2)) {
                    let mut other = at;
                    other[i][axis] += [step, -step][sign];
                    let of_other = left(other);
                    if of_other < least {
                        (least, at, is_better) = (of_other, other, true);
                    }
                }
                if !is_better {
                    step *= 0.5;
                }
            }
            (least, at)
        });
        let best = refined.min_by(|a, b| a.0.total_cmp(&b.0))?;
        // So little is half a pixel, or another arithmetic, and no other camera.
        if best.1.iter().all(|moved| moved.abs().max_element() < 0.01) {
            return None;
        }
        let figure = seen_from(best.1);
        let samples = self.samples.iter().map(|sample| Sample {
            region: figure.region(sample.at, self.size),
            ..*sample
        });
        let elsewhere = Observation {
            figure: &figure,
            size: self.size,
            samples: samples.collect(),
            evenly: Vec::new(),
        };
        let drawn = elsewhere.drawn(Fault::None)?;
        let alone = elsewhere.explained(Fault::None, &drawn, 0);
        let (explained, recoloured) = elsewhere
            .with_own_colours(Fault::None, &drawn, usize::MAX)
            .filter(|(explained, _)| *explained > alone)
            .unwrap_or((alone, 0));
        Some(Cause {
            mutation: None,
            is_elsewhere: true,
            explained,
            recoloured,
        })
    }

    /// Returns how well other colours alone explain it.
    fn own_colours(&self) -> Option<Cause> {
        let drawn: Vec<_> = self.samples.iter().map(|sample| sample.book).collect();
        let (explained, recoloured) =
            self.with_own_colours(Fault::None, &drawn, usize::MAX)?;
        Some(Cause {
            mutation: None,
            is_elsewhere: false,
            explained,
            recoloured,
        })
    }

    /// Returns the difference, from 0 to 1, that the best of all faults leaves at these pixels.
    fn least_left(&self) -> f32 {
        let faults = MUTATIONS.iter().flat_map(|row| row.faults);
        let left = [Fault::None].iter().chain(faults).map(|&fault| {
            let samples = self.samples.iter();
            let left = samples.map(|s| {
                let drawn = self.figure.pixel(s.at, self.size, fault);
                s.weight * distance(s.yours, drawn)
            });
            left.sum::<f32>()
        });
        let weight: f32 = self.samples.iter().map(|sample| sample.weight).sum();
        left.fold(f32::INFINITY, f32::min) / weight
    }

    /// Returns the difference, from 0 to 1, that the likeliest fault leaves unexplained.
    fn unexplained(&self) -> f32 {
        let guesses = self.guesses();
        let explained = guesses.first().map_or(0.0, |(cause, _)| cause.explained);
        let own = self.own_colours().map_or(0.0, |cause| cause.explained);
        let explained = explained.max(own).max(0.0);
        self.difference() * (1.0 - explained)
    }

    /// Returns the likeliest faults, the likeliest first.
    fn guesses(&self) -> Vec<(Cause, Fault)> {
        let by_pixels = |seen: &Self, faults: Vec<(&'static Mutation, Fault)>| {
            let guesses = faults
                .into_par_iter()
                .filter_map(|(row, fault)| Some((seen.direct(row, fault)?, row, fault)));
            let mut guesses: Vec<_> = guesses.collect();
            guesses.sort_by(|a, b| b.0.explained.total_cmp(&a.0.explained));
            guesses
        };
        let faults = MUTATIONS
            .iter()
            .flat_map(|row| row.faults.iter().map(move |&f| (row, f)));
        // A few pixels tell which faults are worth many.
        let likely = by_pixels(&self.thinned(32), faults.collect());
        let likely = likely
            .into_iter()
            .take(64)
            .map(|(_, row, fault)| (row, fault));
        let guesses = by_pixels(self, likely.collect()).into_iter();
        guesses.map(|(cause, _, fault)| (cause, fault)).collect()
    }

    /// Returns the causes that explain anything, the likeliest first.
    #[must_use]
    pub fn causes(&self) -> Vec<Cause> {
        if self.total() == 0.0 {
            return Vec::new();
        }
        let thinned = self.thinned(if self.figure.cost() > 4 { 48 } else { 96 });
        let mut guesses = thinned.guesses();
        let is_direct = guesses
            .first()
            .is_some_and(|(cause, _)| cause.explained > NEARLY_ALL);
        if is_direct {
            guesses.truncate(16);
        } else {
            // Besides other colours a fault still explains a part.
            let coloured = guesses.par_iter();
            let coloured = coloured.filter_map(|(cause, fault)| {
                let cause = thinned.with_colours(cause.mutation?, *fault)?;
                (cause.recoloured > 0).then_some((cause, *fault))
            });
            let mut coloured: Vec<_> = coloured.collect();
            coloured.sort_by(|a, b| b.0.explained.total_cmp(&a.0.explained));
            coloured.truncate(8);
            guesses.truncate(16);
            guesses.extend(coloured);
        }
        let causes = guesses.par_iter().filter_map(|(cause, fault)| {
            let row = cause.mutation?;
            let fault = if cause.explained > NEARLY_ALL {
                *fault
            } else {
                thinned.refined(row, *fault)
            };
            if is_direct {
                self.direct(row, fault)
            } else {
                self.with_colours(row, fault)
            }
        });
        let mut causes: Vec<Cause> = causes.collect();
        let place = |cause: &Cause| {
            let is_row =
                |row: &Mutation| cause.mutation.is_some_and(|m| m.name == row.name);
            MUTATIONS.iter().position(is_row)
        };
        // Of equals the first in the table is first.
        causes.sort_by_key(&place);
        causes.sort_by(|a, b| b.explained.total_cmp(&a.explained));
        let mut seen = Vec::new();
        causes.retain(|cause| {
            let row = place(cause);
            let is_new = !seen.contains(&row);
            seen.push(row);
            is_new && cause.explained > 0.1
        });
        if let Some(own) = self.own_colours() {
            // Colours alone, unless a mistake explains it as well without them, or what they leave.
            let best = causes.first().map_or(0.0, |cause| cause.explained);
            let direct = causes.iter().filter(|cause| cause.recoloured == 0);
            let direct = direct.map(|cause| cause.explained).fold(0.0, f32::max);
            let left = 1.0 - own.explained;
            let recoloured = causes.first().map_or(0, |cause| cause.recoloured);
            let cost = COST_OF_COLOUR * recoloured as f32;
            let best_left = 1.0 - best - cost;
            let is_all = left < 0.01 && direct < NEARLY_ALL;
            // Colours alone explain as much as the fault with colours does.
            let is_useless = direct < best && left <= best_left + 1e-3;
            if is_all || is_useless || (best < NEARLY_ALL && best_left > 0.4 * left) {
                causes.insert(0, own);
            }
        }
        let best = causes.first().map_or(0.0, |cause| cause.explained);
        if best < NEARLY_ALL
            && let Some(own) = self.own_camera()
            && own.explained > best
        {
            causes.insert(0, own);
        }
        causes
    }
}

/// Returns whether a fault's picture has speckles, which rounding puts elsewhere in every program.
fn has_speckles(fault: Fault) -> bool {
    matches!(
        fault,
        Fault::NoBias
            | Fault::Bias(_)
            | Fault::CheckerInSpace
            | Fault::TextbookSphere
            | Fault::MirrorUnnormalized
            | Fault::NotJittered
    )
}

/// What a further colour must explain to be believed.
const COST_OF_COLOUR: f32 = 0.03;
/// From here on nothing is left to explain.
const NEARLY_ALL: f32 = 0.95;
/// What an explanation of the speckles of each region, but not of each pixel, is worth.
const SPECKLES: f32 = 0.8;

fn scatter(i: usize) -> usize {
    (i.wrapping_mul(0x9e37_79b9_7f4a_7c15)) >> 40
}

/// A figure that a reader's picture may be meant to be, with the book's pixels, if the sizes agree.
#[derive(Clone, Copy)]
pub struct Reference<'a> {
    /// The figure.
    pub figure: &'a Figure,
    /// The name by which it was found; a figure may have several.
    pub name: &'a str,
    /// The book's picture of this name.
    pub book: &'a Image,
}

impl Reference<'_> {
    /// Returns whether the reader's picture has the size of the book's.
    #[must_use]
    pub fn has_size(&self, size: [u32; 2]) -> bool {
        self.book.size == size
    }

    /// Returns the right levels of a pixel in a picture of this size: the book's, or drawn anew.
    #[must_use]
    pub fn pixel(&self, at: [u32; 2], size: [u32; 2]) -> [u8; 3] {
        if self.has_size(size) {
            self.book.pixel(at)
        } else {
            self.figure.pixel(at, size, Fault::None)
        }
    }

    /// Returns what differs, at about `count` pixels.
    #[must_use]
    pub fn observe(&self, yours: &Image, count: usize) -> Observation<'_> {
        Observation::new(self.figure, yours, |at| self.pixel(at, yours.size), count)
    }
}

/// Returns the reference for a picture of the book, by its name. `None` if there is no such picture.
#[must_use]
pub fn named<'a>(
    name: &str,
    figures: &'a [Figure],
    book: &'a [(String, Image)],
) -> Option<Reference<'a>> {
    let (name, image) = book.iter().find(|(other, _)| other == name)?;
    let figure = figures.iter().find(|figure| figure.names.contains(name))?;
    Some(Reference {
        figure,
        name,
        book: image,
    })
}

/// Returns the pictures of the book that are equal to the reader's.
#[must_use]
pub fn equal<'a>(yours: &Image, book: &'a [(String, Image)]) -> Vec<&'a str> {
    let equal = book.iter().filter(|(_, image)| image == yours);
    equal.map(|(name, _)| &name[..]).collect()
}

/// Returns the pictures of the book that the reader's may be meant to be, the likeliest first, three
/// at most: those from which it differs least, but for what one of the faults explains.
#[must_use]
pub fn guess<'a>(
    yours: &Image,
    figures: &'a [Figure],
    book: &'a [(String, Image)],
) -> Vec<Reference<'a>> {
    // Nobody means a bug: the picture is the right one, and the bug is its cause.
    let references = figures
        .iter()
        .filter(|figure| figure.cost() <= 64 && figure.shows == Fault::None);
    let references = references.filter_map(|figure| named(figure.name(), figures, book));
    let references: Vec<_> = references.collect();
    let nearest = |references: &[Reference<'a>],
                   most: usize,
                   left: &(dyn Fn(&Reference) -> f32 + Sync)| {
        let mut left: Vec<_> = references.par_iter().map(|r| (left(r), *r)).collect();
        // Of equals the first in the book.
        left.sort_by(|a, b| a.0.total_cmp(&b.0));
        left.truncate(most);
        let (_, references): (Vec<_>, Vec<_>) = left.into_iter().unzip();
        references
    };
    let is_slow = |reference: &Reference| reference.figure.cost() > 4;
    let near = nearest(&references, 24, &|reference| {
        let count = if is_slow(reference) { 8 } else { 32 };
        reference.observe(yours, count).least_left()
    });
    let near = nearest(&near, 8, &|reference| {
        let count = if is_slow(reference) { 48 } else { 128 };
        reference.observe(yours, count).unexplained()
    });
    // Of these all causes are weighed, as the answer will name them.
    nearest(&near, 3, &|reference| {
        let seen = reference.observe(yours, 128);
        let (own, causes) = likely(&seen);
        // Another camera and other colours come near to much: each costs what a colour besides a
        // fault does.
        let own = own.map_or(0.0, |own| {
            let changes = own.recoloured + usize::from(own.is_elsewhere);
            own.explained - COST_OF_COLOUR * changes as f32
        });
        let explained = causes.first().map_or(own, |cause| cause.explained);
        seen.difference() * (1.0 - explained)
    })
}
