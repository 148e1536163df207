//! A plain tracer in f64.
