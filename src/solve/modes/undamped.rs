//! The undamped natural frequencies: none missed by the count, each polished on the characteristic function.

use std::sync::atomic::{AtomicBool, Ordering};

use num_complex::Complex64;
use rayon::prelude::*;

use super::bracket::bracketed;
use super::characteristic::Characteristic;
use super::count::Counter;
use super::eigenspace::{Circle, roots_inside};
use super::neighbours::neighbours;
use super::{MOST_MODES, without_damping};
use crate::model::Model;

/// Relative width to which the count alone brings a root.
const NARROW: f64 = 4e-14;

/// Roots closer than this (relative) are told apart by the count alone: between them the characteristic function is
/// smaller than its rounding.
const CLOSE: f64 = 1e-5;

/// How near the count must agree with a polished root (relative); where waves of very different lengths meet it has
/// fewer digits than the characteristic function.
const CONFIRMED: [f64; 3] = [1e-10, 1e-9, 1e-8];

/// The search for the undamped roots of a model.
pub(super) struct Search<'a> {
    pub(super) counter: Counter,
    /// Without damping.
    model: Model,
    characteristic: Characteristic,
    cancel: &'a AtomicBool,
}

/// A frequency with its count.
#[derive(Debug, Clone, Copy)]
struct Counted {
    omega: f64,
    below: usize,
}

impl<'a> Search<'a> {
    /// For a checked model; its dampers and loss factor are left out.
    pub(super) fn new(model: &Model, cancel: &'a AtomicBool) -> Self {
        let model = without_damping(model);
        Self {
            counter: Counter::new(&model),
            characteristic: Characteristic::new(&model),
            model,
            cancel,
        }
    }

    /// All roots from 0 to `to` (rad/s), rising, as often as they occur; rigid-body modes are 0. `None` where cancelled,
    /// or where they are more than [`MOST_MODES`].
    pub(super) fn up_to(&self, to: f64) -> Option<Vec<f64>> {
        let rigid = self.counter.rigid();
        let high = self.counted(to);
        if high.below > MOST_MODES {
            return None;
        }
        let low = self.floor(high, rigid);
        let mut roots = vec![0.0; low.below];
        let moving = self.between(low, high)?;
        roots.extend(self.separated(&moving));
        Some(roots)
    }

    /// Roots too close together for the functions, to the last digits from the space of their motions.
    fn separated(&self, roots: &[f64]) -> Vec<f64> {
        let all: Vec<Complex64> = roots.iter().map(|&omega| omega.into()).collect();
        let groups: Vec<&[f64]> = roots.chunk_by(|a, b| b - a < CLOSE * a).collect();
        let separated = groups.into_par_iter().flat_map_iter(|group| {
            if group.len() == 1 {
                return group.to_vec();
            }
            let first = roots.partition_point(|root| *root < group[0]);
            let close = neighbours(&all, first, CLOSE);
            let members: Vec<Complex64> = close.members.iter().map(|&member| all[member]).collect();
            let circle = Circle::around(&members, close.gap);
            let Some(found) = roots_inside(&self.model, circle, members.len()) else {
                return group.to_vec();
            };
            // The group may have been found with others beside it.
            let offset = close
                .members
                .iter()
                .position(|&member| member == first)
                .unwrap_or(0);
            let own = found.get(offset..offset + group.len()).unwrap_or_default();
            let near =
                |(found, counted): (&Complex64, &f64)| (found.re - counted).abs() < CLOSE * counted;
            if own.len() == group.len() && own.iter().zip(group).all(near) {
                own.iter().map(|root| root.re).collect()
            } else {
                group.to_vec()
            }
        });
        separated.collect()
    }

    fn counted(&self, omega: f64) -> Counted {
        Counted {
            omega,
            below: self.counter.below(omega),
        }
    }

    /// A frequency with no mode below it but those at 0. What is slower than any beam moves counts as 0.
    fn floor(&self, high: Counted, rigid: usize) -> Counted {
        const SLOWEST: f64 = 1e-10;
        let mut low = high;
        while low.below > rigid && low.omega > SLOWEST * high.omega {
            low = self.counted(low.omega / 8.0);
        }
        low
    }

    /// The roots above `low` up to `high`.
    fn between(&self, low: Counted, high: Counted) -> Option<Vec<f64>> {
        if self.cancel.load(Ordering::Relaxed) {
            return None;
        }
        let roots = high.below.saturating_sub(low.below);
        if roots == 0 {
            return Some(Vec::new());
        }
        let width = high.omega / low.omega - 1.0;
        if width < NARROW {
            return Some(vec![0.5 * (low.omega + high.omega); roots]);
        }
        if roots == 1
            && width > CLOSE
            && let Some(root) = self.polished(low, high)
        {
            return Some(vec![root]);
        }
        let middle = self.counted((low.omega * high.omega).sqrt());
        let (left, right) =
            rayon::join(|| self.between(low, middle), || self.between(middle, high));
        let mut roots = left?;
        roots.extend(right?);
        Some(roots)
    }

    /// The one root between two frequencies, where the count confirms it.
    fn polished(&self, low: Counted, high: Counted) -> Option<f64> {
        let start = self.characteristic.at(low.omega.into());
        let value = |omega: f64| {
            self.characteristic
                .at(Complex64::from(omega))
                .ratio(&start)
                .re
        };
        let root = bracketed(low.omega, high.omega, value)?;
        // Where a neighbour may be close beyond the bracket, a sign may have been rounding.
        if root > low.omega * (1.0 + CLOSE) && root < high.omega * (1.0 - CLOSE) {
            return Some(root);
        }
        let beside = |share: f64| self.counter.below(root * (1.0 + share));
        CONFIRMED
            .iter()
            .any(|&share| beside(-share) == low.below && beside(share) == high.below)
            .then_some(root)
    }
}
