//! How much arithmetic a sweep takes: the kernel run with numbers that count.

use std::cell::Cell;

use super::complex::Complex;
use super::number::{Arithmetic, Part, Real, WIDTH};
use super::recursion::{Prepared, Room};
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

/// Two roundings, counted.
#[derive(Debug, Clone, Copy)]
struct Counted;

impl Arithmetic for Counted {
    #[inline(always)]
    fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }

    #[inline(never)]
    fn outlined<P: Part>(part: P) -> P::Output {
        part.run()
    }

    #[inline(always)]
    fn note() {
        MULTIPLY_ADDS.set(MULTIPLY_ADDS.get() + 1);
    }

    #[inline(always)]
    fn note_division() {
        DIVISIONS.set(DIVISIONS.get() + 1);
    }
}

/// The operations that a sweep of a checked model takes at a frequency, on average over some (Hz, > 0).
///
/// What does not depend on the frequency is not counted.
pub fn work(model: &Model, frequencies: &[f64]) -> Work {
    let prepared = Prepared::new(Plan::new(model));
    let mut room: Room<Counted> = Room::default();
    let mut out = vec![Complex::ZERO; prepared.plan.outputs.len()];
    MULTIPLY_ADDS.set(0);
    DIVISIONS.set(0);
    let groups = frequencies.chunks_exact(WIDTH);
    let count = groups.len() as f64;
    for group in groups {
        // An operation of a group is one of each of its frequencies.
        let omega = std::array::from_fn(|lane| std::f64::consts::TAU * group[lane]);
        room.solve(&prepared, Real::new(omega), &mut out);
    }
    Work {
        multiply_adds: MULTIPLY_ADDS.get() as f64 / count,
        divisions: DIVISIONS.get() as f64 / count,
    }
}
