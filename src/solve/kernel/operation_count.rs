//! How much arithmetic a sweep takes: the kernel run with numbers that count.

use std::cell::Cell;

use super::complex::Complex;
use super::dispatch::Instructions;
use super::number::{MOST_LANES, Real};
use super::portable::{Array, Notes};
use super::recursion::{Prepared, Room};
use super::waves::Waves;
use crate::model::Model;
use crate::solve::plan::Plan;

thread_local! {
    static MULTIPLY_ADDS: Cell<u64> = const { Cell::new(0) };
    static DIVISIONS: Cell<u64> = const { Cell::new(0) };
}

/// Operations on real numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Work {
    /// Multiplications that add, multiplications and additions: each takes a processor as long as a multiplication that
    /// adds. Comparisons, changes of sign and absolute values are not counted.
    pub multiply_adds: f64,
    /// Divisions and square roots.
    pub divisions: f64,
}

/// The thread that computes.
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

/// The operations that a sweep of a checked model takes at a frequency, on average over some (Hz, > 0), with some
/// instructions: where more frequencies are solved at once, some of them wait for others.
///
/// What does not depend on the frequency is not counted.
pub fn work(model: &Model, frequencies: &[f64], instructions: Instructions) -> Work {
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
    let mut waves = Waves::NONE;
    let mut out = vec![Complex::ZERO; prepared.plan.outputs.len()];
    MULTIPLY_ADDS.set(0);
    DIVISIONS.set(0);
    let groups = frequencies.chunks_exact(LANES);
    let count = groups.len() as f64;
    for group in groups {
        // An operation of a group is one of each of its frequencies.
        let mut omega = [0.0; MOST_LANES];
        for lane in 0..LANES {
            omega[lane] = std::f64::consts::TAU * group[lane];
        }
        waves.set(&prepared.constants, Complex::from_real(Real::new(&omega)));
        room.solve(&prepared, &waves, &mut out);
    }
    Work {
        multiply_adds: MULTIPLY_ADDS.get() as f64 / count,
        divisions: DIVISIONS.get() as f64 / count,
    }
}
