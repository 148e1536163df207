//! The tests of the oracle: its pictures converge, and agree with closed forms and with POV-Ray's.

mod convergence;
mod lights;
mod media;
mod povray;
mod scenes;
