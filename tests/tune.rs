//! The search for the best model: closed forms, figures against differences, limits, tolerances, measured curves.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "tune/absorber.rs"]
mod absorber;
#[path = "common/checked.rs"]
mod checked;
#[path = "tune/kinds.rs"]
mod kinds;
#[path = "tune/limits.rs"]
mod limits;
#[path = "tune/matching.rs"]
mod matching;
#[path = "tune/spread.rs"]
mod spread;
