//! The tests of `check`.


mod rates;
