//! Sobol's sequence has more than its squares: it is a (0, 2)-sequence in base 2, and Owen's
//! permutations leave it one.

use ::anti_aliasing::sobol::{image_point, low_discrepancy, sample_position};
use canvas::Pixel;
use glam::{UVec2, Vec2, Vec3};
use std::cell::RefCell;

const SIZE: UVec2 = UVec2::new(5, 3);

/// Of the first 2ᵐ samples, and of each further 2ᵐ, one is in each of the 2ᵐ cells of any grid:
/// of m halvings, a of the width and the others of the height.
///
/// Source: Niederreiter, "Point Sets and Sequences with Small Discrepancy" (1987).
#[test]
fn of_two_to_the_m_samples_one_is_in_each_cell_of_every_grid() {
    for pixel in Pixel::all(SIZE) {
        for m in 0..=8 {
            for a in 0..=m {
                let grid = UVec2::new(1 << a, 1 << (m - a));
                for block in 0..4 {
                    let mut samples = vec![0; 1 << m];
                    for i in block << m..(block + 1) << m {
                        let position = sample_position(pixel, i);
                        let cell = (position * grid.as_vec2()).as_uvec2();
                        samples[(cell.y * grid.x + cell.x) as usize] += 1;
                    }
                    assert!(
                        samples.iter().all(|&samples| samples == 1),
                        "{grid}, {block}"
                    );
                }
            }
        }
    }
}

/// Two samples on different sides of the middle, in either direction, do not tell on which side
/// the first of them is: over all pixels it is on each in half of all cases, to 5 % of 4096, six
/// standard deviations.
#[test]
fn the_first_sample_of_a_pixel_is_in_any_quarter() {
    let mut quarters = [0; 4];
    for pixel in Pixel::all(UVec2::splat(64)) {
        let quarter = (2.0 * sample_position(pixel, 0)).as_uvec2();
        quarters[(2 * quarter.y + quarter.x) as usize] += 1;
    }
    for count in quarters {
        assert!((1024 - 205..=1024 + 205).contains(&count), "{quarters:?}");
    }
}

/// A pixel's samples are all within it, and their mean is that of a slope: in the middle, to an
/// eighth of a cell of 16 × 16.
#[test]
fn a_pixels_samples_are_its_own() {
    for pixel in Pixel::all(SIZE) {
        let half = Vec2::splat(pixel.footprint() / 2.0);
        let corner = image_point(pixel, Vec2::ZERO);
        assert!(corner.distance(pixel.centre() - half) <= 4.0 * f32::EPSILON);
        let points = RefCell::new(vec![]);
        let mean = low_discrepancy(pixel, 16, &|point| {
            points.borrow_mut().push(point);
            point.extend(1.0)
        });
        let points = points.into_inner();
        assert_eq!(points.len(), 256);
        for point in points {
            let within = (point - pixel.centre()).abs();
            assert!(within.cmple(half * (1.0 + 8.0 * f32::EPSILON)).all());
        }
        let off = (mean.truncate() - pixel.centre()).abs().max_element();
        assert!(off <= pixel.footprint() / 128.0, "{off}");
        assert_eq!(mean.z, 1.0);
        let white = low_discrepancy(pixel, 3, &|_| Vec3::ONE);
        assert_eq!(white, Vec3::ONE);
    }
}
