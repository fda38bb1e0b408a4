//! The search for the best model: closed forms, figures against differences, limits, tolerances, measured curves.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "tune/absorber.rs"]
mod absorber;
#[path = "tune/matching.rs"]
mod matching;
