//! The still life against the oracle's, which is calculated in f64.

use ::shadows::STAGE;
use harness::agreement::assert_plastic;

/// Those that differ are in the row next to the horizon, and at the edges of shadows.
/// Measured: 0.00958 %.
#[test]
fn the_still_life_with_shadows_agrees_with_the_oracle() {
    assert_plastic(&STAGE, oracle::trace_shadows, 2e-4);
}
