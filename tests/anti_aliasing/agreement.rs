//! The still life against the oracle's, which is calculated in f64.

use ::anti_aliasing::STAGE;
use harness::SMALL;
use harness::agreement::assert_deep;
use oracle::Glass;

/// A pixel is the mean of sixteen samples, each of which may be at an edge; and of a smaller
/// picture the row next to the horizon is a larger part. Measured: 0.367 %.
#[test]
fn the_still_life_of_16_samples_per_pixel_agrees_with_the_oracle() {
    let scene = oracle::still_life_with_glass(Glass::Reflects);
    assert_deep(&STAGE, SMALL, 4, scene, 5e-3);
}
