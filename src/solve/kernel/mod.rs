//! The kernel: responses, the characteristic function and whole solutions at several complex frequencies at once.
//!
//! A number here is the numbers of eight or four frequencies ([`number`], [`complex`]): each line works on all of them
//! with one instruction where the processor has vectors of 512 or 256 bits (`vectors`; any other processor: `portable`),
//! and takes the same decisions for each as if it were alone. `dispatch` finds what the processor has when the program
//! runs. A whole [`solution`] is the instance with one lane.
//!
//! At every point the right-going amplitudes are carried as `a = R b + s`, seen looking left (`reflection`); only decaying
//! exponentials occur, so nothing is lost however long the beam or high the frequency, where a product of transfer
//! matrices loses digits like `exp(2 kappa L)` (Chen & Liu 2022, Eq. 48). `waves` and `roots` give the waves, `ends` the
//! supports, `station` the subsystems, `recursion` sweeps to the right and back, `read` gives what is read, `energy`
//! integrates what moved. Cost and memory are linear in the stations.
//!
//! `sides` is the cache of what lies left and right of an edited place: `carry` takes waves over it, `combinations` and
//! `quadratic` give the energy that they leave there. `characteristic` is the function whose zeros are the natural
//! frequencies.
//!
//! What saves work: reflections are symmetric; nothing is solved for what a load radiates; a subsystem is solved for its
//! three stretches instead of six waves; unread intermediate results are not stored.

#![allow(
    clippy::inline_always,
    reason = "only what is inlined gets the instructions of its caller"
)]

mod characteristic;
mod complex;
mod dispatch;
mod elementary;
mod ends;
mod energy;
mod linear;
mod number;
mod operation_count;
mod portable;
mod product;
mod read;
mod recursion;
mod reflection;
mod roots;
mod solution;
mod station;
mod substructure;
#[cfg(target_arch = "x86_64")]
mod vectors;
mod waves;

pub use dispatch::Instructions;
pub(super) use dispatch::{SideBatch, Solver};
pub(super) use number::MOST_LANES;
pub use operation_count::{Work, work};
pub(super) use recursion::Prepared;
pub(super) use solution::waves;
pub(super) use substructure::{Source, Substructure};

#[cfg(test)]
mod tests;
