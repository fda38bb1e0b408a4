//! The kernel: responses, the characteristic function and whole solutions at several complex frequencies at once.
//!
//! A number here holds the values of eight or four frequencies ([`number`], [`complex`]): each operation works on all
//! of them with one instruction if the processor has vectors of 512 or 256 bits (`vectors`; other processors:
//! `portable`), and decides for each of them as if it were alone. `dispatch` selects the instruction set at run time. A
//! whole [`solution`] uses a single lane.
//!
//! At every point the right-going amplitudes are `a = R b + s`, seen looking left (`reflection`); only decaying
//! exponentials occur, so no digits are lost for any length of beam or frequency, while a product of transfer matrices
//! loses digits like `exp(2 kappa L)` (Chen & Liu 2022, Eq. 48). `waves` and `roots` compute the waves of the
//! paper's beam, where v is on its own, `general_waves` those of any other; `ends` the
//! supports there, `action` those between them and the joints, `junction` where two parts of the beam meet, `station` the
//! subsystems, `recursion` sweeps to the right and back, `read` evaluates the responses,
//! `energy` integrates along the spans. Cost and memory are linear in the number of stations.
//!
//! `substructure` solves an edited part of the beam between cached sides. `characteristic` is the function whose zeros
//! are the natural frequencies.
//!
//! Far below the first resonance the waves are nearly the same polynomials, and their sums lose digits: there (`low`) the
//! numbers have twice the digits (`double_double`), in the same equations. So no constant may be rounded in two ways, and
//! nothing between the frequency and the response to a double.
//!
//! Savings: reflections are symmetric; the radiation of a load needs no solution of a system; a subsystem is solved for
//! its three stretches instead of six waves; unread intermediate results are not stored.

#![allow(
    clippy::inline_always,
    reason = "only what is inlined gets the instructions of its caller"
)]

mod action;
mod characteristic;
mod complex;
mod dispatch;
mod double_double;
mod elementary;
mod ends;
mod energy;
mod general_waves;
mod junction;
mod linear;
mod low;
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
pub(super) use low::low_limit;
pub(super) use number::MOST_LANES;
pub use operation_count::{Work, work};
pub(super) use recursion::Prepared;
pub(super) use solution::waves;
pub(super) use substructure::{Source, Substructure};

#[cfg(test)]
mod tests;
