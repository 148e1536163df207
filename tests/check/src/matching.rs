//! Which picture of the book it is meant to be, and what probably went wrong.
//!
//! Every figure is drawn once more with every fault, at some of the reader's own pixels. The fault
//! whose picture comes closest to the reader's is the likeliest. So what is compared is where and
//! how the pictures differ, at any size, and no wrong picture need be known beforehand.

use crate::fault::Fault;
use crate::figures::Figure;
use crate::image::Image;
use crate::levels::{decode, levels};
use crate::mutations::{MUTATIONS, Mutation};
use crate::tracer::Region;
use glam::Vec3;
use rayon::prelude::*;
use std::collections::BTreeMap;

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
    /// The row of the table; `None` is "nothing but other colours".
    pub mutation: Option<&'static Mutation>,
    /// How much of the difference it explains: 1 is all of it.
    pub explained: f32,
    /// The objects that have another colour besides.
    pub recoloured: usize,
}

/// From this difference in a channel on, a pixel is simply wrong.
const SATURATION: f32 = 48.0;

/// Returns the difference of two pixels, from 0 to 1.
fn distance(a: [u8; 3], b: [u8; 3]) -> f32 {
    let channels = a.into_iter().zip(b);
    channels
        .map(|(a, b)| (f32::from(a.abs_diff(b)) / SATURATION).min(1.0))
        .sum::<f32>()
        / 3.0
}

/// The pixels that are compared, and what is in them.
pub struct Observation<'a> {
    figure: &'a Figure,
    size: [u32; 2],
    samples: Vec<Sample>,
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
        let (differ, equal): (Vec<_>, Vec<_>) = pixels
            .into_iter()
            .partition(|(_, yours, book)| yours != book);
        let mut samples = Vec::new();
        for part in [differ, equal] {
            let step = (part.len() / (count / 2)).max(1);
            for chunk in part.chunks(step) {
                let (at, yours, book) = chunk[scatter(chunk.len()) % chunk.len()];
                samples.push(Sample {
                    at,
                    weight: chunk.len() as f32,
                    yours,
                    book,
                    region: figure.region(at, size),
                });
            }
        }
        Self {
            figure,
            size,
            samples,
        }
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

    /// Returns the part of the difference that a drawing explains, pixel by pixel and region by
    /// region; negative if the drawing is farther from the reader's than the book's is.
    fn explained(&self, drawn: &[[u8; 3]]) -> f32 {
        let samples = self.samples.iter().zip(drawn);
        let left: f32 = samples
            .map(|(sample, &drawn)| sample.weight * distance(sample.yours, drawn))
            .sum();
        let by_pixel = 1.0 - left / self.total();
        by_pixel.max(0.9 * self.explained_by_region(drawn))
    }

    /// Speckles are nowhere the same twice: of each region, an object in the light of some of the
    /// lights, only the mean and the spread are compared.
    fn explained_by_region(&self, drawn: &[[u8; 3]]) -> f32 {
        #[derive(Default)]
        struct Sums {
            weight: f32,
            // Yours less the book's, and the drawn less the book's: the sum, and that of the squares.
            yours: [Vec3; 2],
            drawn: [Vec3; 2],
        }
        let mut regions: BTreeMap<_, Sums> = BTreeMap::new();
        for (sample, &drawn) in self.samples.iter().zip(drawn) {
            let [x, y] = sample.at;
            // Where nothing is known of the scene, and to tell near from far, a tile is a region.
            let tile = [4 * x / self.size[0], 4 * y / self.size[1]];
            let sums = regions.entry((sample.region, tile)).or_default();
            let minus = |pixel: [u8; 3]| {
                let difference = Vec3::from(pixel.map(f32::from)) - Vec3::from(sample.book.map(f32::from));
                difference.clamp(Vec3::splat(-SATURATION), Vec3::splat(SATURATION))
            };
            sums.weight += sample.weight;
            for (to, pixel) in [(&mut sums.yours, sample.yours), (&mut sums.drawn, drawn)] {
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

    /// Gives the objects of a drawing the reader's colours, where that explains an object almost
    /// whole; at most `most` of them. Returns their number.
    fn recolour(&self, drawn: &mut [[u8; 3]], most: usize) -> usize {
        let light = |pixel: [u8; 3]| {
            Vec3::from(pixel.map(|level| decode(f64::from(level) / 255.0) as f32))
        };
        let mut objects: BTreeMap<_, Vec<usize>> = BTreeMap::new();
        for (i, sample) in self.samples.iter().enumerate() {
            let object = sample.region.map(|(index, is_odd, _)| (index, is_odd));
            objects.entry(object).or_default().push(i);
        }
        let mut gains = Vec::new();
        for indices in objects.values().filter(|indices| indices.len() >= 12) {
            let ratio = |channel: usize| {
                let mut ratios: Vec<_> = indices
                    .iter()
                    .map(|&i| [light(self.samples[i].yours)[channel], light(drawn[i])[channel]])
                    .filter(|[_, drawn]| *drawn > 0.002)
                    .map(|[yours, drawn]| yours / drawn)
                    .collect();
                ratios.sort_by(f32::total_cmp);
                ratios.get(ratios.len() / 2).copied().unwrap_or(1.0)
            };
            let ratios = Vec3::new(ratio(0), ratio(1), ratio(2));
            let recoloured: Vec<_> = indices
                .iter()
                .map(|&i| levels(ratios * light(drawn[i]), Fault::None))
                .collect();
            let cost = |pixels: &mut dyn Iterator<Item = (usize, [u8; 3])>| {
                pixels
                    .map(|(i, pixel)| self.samples[i].weight * distance(self.samples[i].yours, pixel))
                    .sum::<f32>()
            };
            let before = cost(&mut indices.iter().map(|&i| (i, drawn[i])));
            let after = cost(&mut indices.iter().copied().zip(recoloured.iter().copied()));
            if after < 0.25 * before {
                gains.push((before - after, indices, recoloured));
            }
        }
        gains.sort_by(|a, b| b.0.total_cmp(&a.0));
        gains.truncate(most);
        for (_, indices, recoloured) in &gains {
            for (&i, &pixel) in indices.iter().zip(recoloured) {
                drawn[i] = pixel;
            }
        }
        gains.len()
    }

    /// Returns every so many samples, so that there are about `count`.
    fn thinned(&self, count: usize) -> Self {
        let step = (self.samples.len() / count).max(1);
        Self {
            figure: self.figure,
            size: self.size,
            samples: self.samples.iter().copied().step_by(step).collect(),
        }
    }

    /// Returns how well a fault explains the difference. `None` if it changes nothing.
    fn cause(&self, mutation: &'static Mutation, fault: Fault) -> Option<Cause> {
        let mut drawn = self.drawn(fault)?;
        let explained = self.explained(&drawn);
        let recoloured = self.recolour(&mut drawn, 2);
        let also = self.explained(&drawn) - COST_OF_COLOUR * recoloured as f32;
        let (explained, recoloured) = if also > explained {
            (also, recoloured)
        } else {
            (explained, 0)
        };
        Some(Cause {
            mutation: Some(mutation),
            explained,
            recoloured,
        })
    }

    /// Returns how well other colours alone explain it.
    fn own_colours(&self) -> Cause {
        let mut drawn: Vec<_> = self.samples.iter().map(|sample| sample.book).collect();
        let recoloured = self.recolour(&mut drawn, usize::MAX);
        Cause {
            mutation: None,
            explained: self.explained(&drawn) - COST_OF_COLOUR * recoloured as f32,
            recoloured,
        }
    }

    /// Returns the difference, from 0 to 1, that the likeliest fault leaves unexplained.
    fn unexplained(&self) -> f32 {
        let guesses = self.guesses();
        let explained = guesses.first().map_or(0.0, |(cause, _)| cause.explained);
        let explained = explained.max(self.own_colours().explained).max(0.0);
        self.difference() * (1.0 - explained)
    }

    /// Returns every fault that changes the picture, the likeliest first.
    fn guesses(&self) -> Vec<(Cause, Fault)> {
        let faults = MUTATIONS.iter().flat_map(|row| row.faults.iter().map(move |&f| (row, f)));
        let faults: Vec<_> = faults.collect();
        let guesses = faults
            .par_iter()
            .filter_map(|&(row, fault)| Some((self.cause(row, fault)?, fault)));
        let mut guesses: Vec<_> = guesses.collect();
        guesses.sort_by(|a, b| b.0.explained.total_cmp(&a.0.explained));
        guesses
    }

    /// Returns the causes that explain anything, the likeliest first.
    #[must_use]
    pub fn causes(&self) -> Vec<Cause> {
        if self.total() == 0.0 {
            return Vec::new();
        }
        // A few pixels tell which faults are worth many.
        let mut guesses = self.thinned(96).guesses();
        guesses.truncate(20);
        let mut causes: Vec<Cause> = guesses
            .par_iter()
            .filter_map(|(cause, fault)| self.cause(cause.mutation?, *fault))
            .collect();
        causes.push(self.own_colours());
        let place = |cause: &Cause| {
            let is_row = |row: &Mutation| cause.mutation.is_some_and(|m| m.name == row.name);
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
        causes
    }
}

/// What a further colour must explain to be believed.
const COST_OF_COLOUR: f32 = 0.04;

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

/// Returns the picture of the book that the reader's is most likely meant to be: the one from which
/// it differs least, but for what one of the faults explains.
#[must_use]
pub fn guess<'a>(
    yours: &Image,
    figures: &'a [Figure],
    book: &'a [(String, Image)],
) -> Option<Reference<'a>> {
    // What changes nearly every pixel is tried at once.
    let everywhere = [
        Fault::None,
        Fault::FlipX,
        Fault::FlipY,
        Fault::HalfTurn,
        Fault::Linear,
        Fault::Gamma(2.2),
        Fault::EncodedTwice,
        Fault::Channels([2, 1, 0]),
        Fault::Channels([0, 2, 1]),
        Fault::Channels([1, 0, 2]),
        Fault::Negative,
        Fault::FocalTimes(0.5),
        Fault::FocalTimes(2.0),
        Fault::SquarePlane,
        Fault::FitsWidth,
    ];
    let references = figures.iter().filter(|figure| figure.cost() <= 64);
    let references: Vec<_> = references
        .filter_map(|figure| named(figure.name(), figures, book))
        .collect();
    let mut near: Vec<_> = references
        .par_iter()
        .map(|reference| {
            let seen = reference.observe(yours, if reference.figure.cost() > 4 { 32 } else { 128 });
            let left = everywhere.iter().map(|&fault| {
                let samples = seen.samples.iter();
                let left: f32 = samples
                    .map(|s| {
                        let drawn = reference.figure.pixel(s.at, seen.size, fault);
                        s.weight * distance(s.yours, drawn)
                    })
                    .sum();
                left
            });
            let weight: f32 = seen.samples.iter().map(|sample| sample.weight).sum();
            (left.fold(f32::INFINITY, f32::min) / weight, *reference)
        })
        .collect();
    near.sort_by(|a, b| a.0.total_cmp(&b.0));
    near.truncate(8);
    let left = near.par_iter().map(|(_, reference)| {
        let seen = reference.observe(yours, if reference.figure.cost() > 4 { 48 } else { 128 });
        (seen.unexplained(), *reference)
    });
    let left: Vec<_> = left.collect();
    // Of equals the nearest.
    let best = left.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, reference)| reference)
}
