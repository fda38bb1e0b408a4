//! Number of arithmetic operations of a sweep: the kernel runs with numbers that count.

use std::cell::Cell;

use super::complex::Complex;
use super::dispatch::Instructions;
use super::number::{MOST_LANES, Real};
use super::portable::{Array, Notes};
use super::recursion::{Prepared, Room};
use crate::model::{Checked, Model};
use crate::solve::plan::Plan;

thread_local! {
    static MULTIPLY_ADDS: Cell<u64> = const { Cell::new(0) };
    static DIVISIONS: Cell<u64> = const { Cell::new(0) };
}

/// Operations on real numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Work {
    /// Fused multiply-adds, multiplications and additions: each takes as long as a fused multiply-add. Comparisons,
    /// changes of sign and absolute values do not count.
    pub multiply_adds: f64,
    /// Divisions and square roots.
    pub divisions: f64,
}

/// The counter of this thread.
#[derive(Debug, Clone, Copy)]
struct Counter;

impl Notes for Counter {
    #[inline(always)]
    fn operation() {
        MULTIPLY_ADDS.set(MULTIPLY_ADDS.get() + 1);
    }

    #[inline(always)]
    fn division() {
        DIVISIONS.set(DIVISIONS.get() + 1);
    }
}

/// The operations per frequency of a sweep of a checked model, on average over some frequencies (Hz, > 0), with an
/// instruction set: with more frequencies in a group, some of them wait for others.
///
/// Work that does not depend on the frequency does not count.
pub fn work(model: &Checked, frequencies: &[f64], instructions: Instructions) -> Work {
    match instructions {
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx512 => counted::<8>(model, frequencies),
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx2 => counted::<4>(model, frequencies),
        Instructions::Portable => counted::<4>(model, frequencies),
    }
}

fn counted<const LANES: usize>(model: &Model, frequencies: &[f64]) -> Work {
    let prepared = Prepared::new(Plan::new(model));
    let mut room: Room<Array<Counter, LANES>> = Room::default();
    let mut out = vec![Complex::ZERO; prepared.plan.outputs.len()];
    MULTIPLY_ADDS.set(0);
    DIVISIONS.set(0);
    let groups = frequencies.chunks_exact(LANES);
    let count = groups.len() as f64;
    for group in groups {
        // An operation on a group counts once for each of its frequencies.
        let mut omega = [0.0; MOST_LANES];
        for lane in 0..LANES {
            omega[lane] = std::f64::consts::TAU * group[lane];
        }
        let omega = Complex::from_real(Real::new(&omega));
        room.solve(&prepared, omega, &mut out);
    }
    Work {
        multiply_adds: MULTIPLY_ADDS.get() as f64 / count,
        divisions: DIVISIONS.get() as f64 / count,
    }
}
