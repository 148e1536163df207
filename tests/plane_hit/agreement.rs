//! The still life against the oracle's, which is calculated in f64.

use ::plane_hit::STAGE;
use harness::agreement::assert_plastic;

/// All that differ are in the row next to the horizon. Measured: 0.00729 %.
#[test]
fn the_flat_still_life_agrees_with_the_oracle() {
    assert_plastic(&STAGE, oracle::trace_flat, 1e-4);
}
