//! The tests of the oracle: its pictures converge, and agree with POV-Ray's.

mod convergence;
mod povray;
