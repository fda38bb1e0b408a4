//! The solver of sweeps: the recursion of [`super::recursion`] at several frequencies at once.
//!
//! A number here is the numbers of eight or four frequencies side by side ([`number`], [`complex`]): each line of the
//! kernel works on all of them with one instruction where the processor has vectors of 512 or 256 bits (`vectors`; any
//! other processor: `portable`), and takes the same decisions for each as if it were alone. `waves`, `ends`, `station`,
//! `reflection` and `recursion` have the names of their plain counterparts in [`super`], which solve one complex
//! frequency and are what these are held against. `roots` finds the coupled waves, `dispatch` looks what the processor can
//! do when the program runs.
//!
//! `sides` keeps what lies beside an edited place: `carry` takes waves over it, `combinations` and `quadratic` say what
//! energy they leave there.
//!
//! `characteristic` is the function whose zeros are the natural frequencies.
//!
//! What makes it less work than the plain one, apart from the vectors: reflections are symmetric; nothing is solved for
//! what a load radiates; a subsystem is solved for its three stretches instead of six waves; unread intermediate results
//! are not stored.

#![allow(
    clippy::inline_always,
    reason = "only what is inlined gets the instructions of its caller"
)]

mod carry;
mod characteristic;
mod combinations;
mod complex;
mod count;
mod dispatch;
mod elementary;
mod ends;
mod energy;
mod linear;
mod number;
mod portable;
mod quadratic;
mod read;
mod recursion;
mod reflection;
mod roots;
mod sides;
mod station;
#[cfg(target_arch = "x86_64")]
mod vectors;
mod waves;

pub use count::{Work, work};
pub use dispatch::Instructions;
pub(super) use dispatch::{KeptSides, Solver};
pub(super) use number::MOST_LANES;
pub(super) use recursion::Prepared;
pub(super) use sides::{Between, Source};

#[cfg(test)]
mod tests;
