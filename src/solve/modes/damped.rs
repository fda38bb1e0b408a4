//! Damped modes: the complex roots of the characteristic function, continued from the undamped ones.
//!
//! All roots move together by the simultaneous iteration of Aberth (Math. Comp. 27 (1973) 339-344): Newton steps in
//! which every root pushes the others away, so that no two trackers end on one root. Where the argument principle then
//! counts another number of roots than were found, the damping is brought in by steps, and the roots without
//! oscillation are looked for on the imaginary axis, where the function is real.

use std::sync::atomic::{AtomicBool, Ordering};

use num_complex::Complex64;
use rayon::prelude::*;

use super::blocked::Blocked;
use super::characteristic::Characteristic;
use super::eigenspace::Probe;
use super::tracker::{Tracker, inverse, newton};
use super::types::{Completeness, Mode, ModeKind};
use super::winding::{Region, count};
use super::with_damping_times;
use crate::model::Model;

/// The search for the damped roots of a model.
pub(super) struct Search<'a> {
    model: &'a Model,
    characteristic: Characteristic,
    blocked: Blocked,
    /// How many modes have the frequency 0 without damping.
    rigid: usize,
    cancel: &'a AtomicBool,
}

/// Damped roots, and whether they are all.
#[derive(Debug, Clone)]
pub(super) struct Found {
    /// By rising |omega|, without the rigid-body modes; some beyond the range.
    pub(super) modes: Vec<Mode>,
    /// Of those in the range.
    pub(super) completeness: Completeness,
}

impl Found {
    /// The modes of a model without damping: the undamped roots, rad/s.
    pub(super) fn without_damping(undamped: &[f64]) -> Self {
        Self {
            modes: undamped.iter().map(|&omega| mode(omega.into())).collect(),
            completeness: Completeness::Certain,
        }
    }
}

impl<'a> Search<'a> {
    /// For a model with `rigid` modes at 0.
    pub(super) fn new(model: &'a Model, rigid: usize, cancel: &'a AtomicBool) -> Self {
        Self {
            model,
            characteristic: Characteristic::new(model),
            blocked: Blocked::new(model),
            rigid,
            cancel,
        }
    }

    /// The roots with |omega| up to `to`, rad/s, from the undamped ones (rad/s, above 0, rising; some beyond `to`, so
    /// that none is missed that damping slows). `None` where cancelled.
    pub(super) fn continue_undamped(&self, undamped: &[f64], to: f64) -> Option<Found> {
        let direct = self.settle(&self.characteristic, &self.predicted(undamped), &[])?;
        let found = self.certify(direct, to)?;
        if found.completeness == Completeness::Certain {
            return Some(found);
        }
        let starts: Vec<Complex64> = undamped.iter().map(|&omega| omega.into()).collect();
        self.certify(self.by_steps(&starts)?, to)
    }

    /// The roots from the undamped ones, as [`Self::continue_undamped`] finds them, but not counted. `None` where
    /// cancelled.
    pub(super) fn uncertified(&self, undamped: &[f64]) -> Option<Found> {
        let mut roots = self.settle(&self.characteristic, &self.predicted(undamped), &[])?;
        if roots.iter().any(Option::is_none) {
            let starts: Vec<Complex64> = undamped.iter().map(|&omega| omega.into()).collect();
            roots = self.by_steps(&starts)?;
        }
        let arrived = roots.into_iter().flatten();
        let modes = sorted(&self.parted(arrived.filter(|root| root.re >= 0.0).collect()));
        Some(Found {
            modes,
            completeness: Completeness::Doubtful,
        })
    }

    /// The roots with |omega| up to `to`, rad/s, from those of a model that differs little. `None` where cancelled.
    pub(super) fn follow(&self, before: &[Mode], to: f64) -> Option<Found> {
        let starts: Vec<Complex64> = before.iter().map(|mode| mode.omega).collect();
        self.certify(self.settle(&self.characteristic, &starts, &[])?, to)
    }

    /// Where the roots go to first order in the damping: one Newton step at a small share of it, scaled up.
    fn predicted(&self, undamped: &[f64]) -> Vec<Complex64> {
        const SHARE: f64 = 1e-3;
        const FARTHEST: f64 = 0.5;
        let weak = Characteristic::new(&with_damping_times(self.model, SHARE));
        undamped
            .par_iter()
            .map(|&omega| {
                let shift = -newton(&weak, omega.into()) / SHARE;
                let size = shift.norm() / omega;
                let limited = if size > FARTHEST {
                    FARTHEST / size
                } else {
                    1.0
                };
                if size.is_finite() {
                    omega + shift * limited
                } else {
                    Complex64::from(omega)
                }
            })
            .collect()
    }

    /// Scales the damping up in steps and follows the roots.
    fn by_steps(&self, starts: &[Complex64]) -> Option<Vec<Option<Complex64>>> {
        const STEPS: u32 = 12;
        let mut roots = starts.to_vec();
        for step in 1..STEPS {
            let share = (f64::from(step) / f64::from(STEPS)).powi(2);
            let weaker = Characteristic::new(&with_damping_times(self.model, share));
            let settled = self.settle(&weaker, &roots, &[])?;
            for (root, settled) in roots.iter_mut().zip(settled) {
                *root = settled.unwrap_or(*root);
            }
        }
        self.settle(&self.characteristic, &roots, &[])
    }

    /// Moves all starts to roots other than the known ones; those that do not arrive are `None`.
    fn settle(
        &self,
        characteristic: &Characteristic,
        starts: &[Complex64],
        known: &[Complex64],
    ) -> Option<Vec<Option<Complex64>>> {
        const MOST_STEPS: usize = 100;
        let mut trackers: Vec<Tracker> = starts.iter().map(|&z| Tracker::new(z)).collect();
        // Roots that no tracker seeks: about where their masses would be on a blocked beam.
        let sought = starts
            .iter()
            .chain(known)
            .map(|z| z.norm())
            .fold(0.0, f64::max);
        let masses = self.blocked.roots.iter().copied();
        let beyond: Vec<Complex64> = masses.filter(|root| root.norm() > sought).collect();
        for _ in 0..MOST_STEPS {
            if self.cancel.load(Ordering::Relaxed) {
                return None;
            }
            let moving = trackers.iter().map(|tracker| tracker.z);
            let now: Vec<Complex64> = moving.chain(known.iter().copied()).collect();
            trackers
                .par_iter_mut()
                .enumerate()
                .for_each(|(index, tracker)| {
                    if !tracker.arrived {
                        let push = self.push(&now, index, &beyond);
                        tracker.step(characteristic, push, !self.is_hysteretic());
                    }
                });
            if trackers.iter().all(|tracker| tracker.arrived) {
                break;
            }
        }
        Some(
            trackers
                .into_iter()
                .map(|tracker| tracker.arrived.then_some(tracker.z))
                .collect(),
        )
    }

    /// Whether the model has a loss factor: no root is then the mirror image of another.
    fn is_hysteretic(&self) -> bool {
        self.model.beam.material.loss_factor != 0.0
    }

    /// The sum of 1 / (z - other) over all other known roots: trackers, their mirror images, those at 0, and far ones.
    fn push(&self, all: &[Complex64], index: usize, beyond: &[Complex64]) -> Complex64 {
        let z = all[index];
        let others = all.iter().enumerate().filter(|&(other, _)| other != index);
        let mut push: Complex64 = others.map(|(_, other)| inverse(z - other)).sum();
        // A root on the imaginary axis is its own image; with a loss factor there are none.
        let images = all
            .iter()
            .filter(|other| other.re != 0.0 && !self.is_hysteretic());
        push += images
            .map(|other| inverse(z + other.conj()))
            .sum::<Complex64>();
        push += beyond
            .iter()
            .map(|other| inverse(z - other))
            .sum::<Complex64>();
        push + 2.0 * self.rigid as f64 * inverse(z)
    }

    /// Keeps what arrived, and adds roots without oscillation where some are missing in the range.
    fn certify(&self, roots: Vec<Option<Complex64>>, to: f64) -> Option<Found> {
        let arrived = roots.into_iter().flatten();
        let mut roots = self.parted(arrived.filter(|root| root.re >= 0.0).collect());
        let slowest = roots.iter().map(|root| root.norm()).fold(to, f64::min);
        let mut modes = sorted(&roots);
        let region = Region {
            inner: 1e-4 * slowest,
            outer: boundary(&modes, to),
            hysteretic: self.is_hysteretic(),
        };
        let counted = count(
            &self.characteristic,
            &self.blocked,
            &region,
            &modes,
            self.cancel,
        )?;
        if counted != region.weigh(&modes) {
            roots.retain(|&root| mode(root).kind == ModeKind::Oscillating);
            // A tracker may run out of the region: try again from other places.
            for start in [(0.5, 0.05), (0.2, 0.3), (0.8, 1.0)] {
                let missing = counted - region.weigh(&sorted(&roots));
                roots.extend(self.overdamped(missing, start, &roots, &region)?);
            }
            modes = sorted(&self.parted(roots));
        }
        let completeness = if counted == region.weigh(&modes) {
            Completeness::Certain
        } else {
            Completeness::Doubtful
        };
        Some(Found {
            modes,
            completeness,
        })
    }

    /// Roots without oscillation: on the imaginary axis the function is real, and trackers that start there stay. With
    /// a loss factor such roots lie beside it.
    fn overdamped(
        &self,
        missing: i64,
        (offset, aside): (f64, f64),
        known: &[Complex64],
        region: &Region,
    ) -> Option<Vec<Complex64>> {
        let ratio = region.outer / region.inner;
        let starts: Vec<Complex64> = (0..missing.max(0))
            .map(|index| {
                let share = (index as f64 + offset) / missing as f64;
                let aside = if region.hysteretic { aside } else { 0.0 };
                Complex64::new(aside, 1.0) * region.inner * ratio.powf(share)
            })
            .collect();
        let arrived = self.settle(&self.characteristic, &starts, known)?;
        let inside = |root: &Complex64| {
            root.re >= 0.0 && (region.inner..region.outer).contains(&root.norm())
        };
        Some(arrived.into_iter().flatten().filter(inside).collect())
    }

    /// Roots so close together that the function between them is rounding: told apart in the space of their motions.
    fn parted(&self, mut roots: Vec<Complex64>) -> Vec<Complex64> {
        const CLOSE: f64 = 1e-5;
        const BESIDE: f64 = 1e-9;
        roots.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        let close = |a: &Complex64, b: &Complex64| (a - b).norm() < CLOSE * a.norm();
        let groups: Vec<&[Complex64]> = roots.chunk_by(close).collect();
        let refined = groups.into_par_iter().flat_map_iter(|group| {
            if group.len() == 1 {
                return group.to_vec();
            }
            let mean = group.iter().sum::<Complex64>() / group.len() as f64;
            let near = mean * (1.0 + BESIDE);
            let probe = Probe::new(self.model, near, Vec::new());
            let space = probe.eigenspace(near, group.len());
            let near_enough = |root: &Complex64| (root - mean).norm() < 10.0 * CLOSE * mean.norm();
            if space.roots.iter().all(near_enough) {
                space.roots
            } else {
                group.to_vec()
            }
        });
        refined.collect()
    }
}

/// The modes of roots, by rising |omega|.
fn sorted(roots: &[Complex64]) -> Vec<Mode> {
    let mut modes: Vec<Mode> = roots.iter().map(|&root| mode(root)).collect();
    modes.sort_by(|a, b| a.omega.norm().total_cmp(&b.omega.norm()));
    modes
}

/// The mode of a root.
fn mode(omega: Complex64) -> Mode {
    const OVERDAMPED: f64 = 1e-7;
    // A root that no damper reaches lies on the real axis but for rounding.
    const UNDAMPED: f64 = 1e-13;
    if omega.re < OVERDAMPED * omega.im {
        return Mode {
            omega: Complex64::new(0.0, omega.im),
            kind: ModeKind::Overdamped,
        };
    }
    let decay = if omega.im < UNDAMPED * omega.re {
        0.0
    } else {
        omega.im
    };
    Mode {
        omega: Complex64::new(omega.re, decay),
        kind: ModeKind::Oscillating,
    }
}

/// A radius near `to` that keeps away from the modes.
fn boundary(modes: &[Mode], to: f64) -> f64 {
    let inside = modes.iter().rev().find(|mode| mode.omega.norm() <= to);
    let outside = modes.iter().find(|mode| mode.omega.norm() > to);
    let below = inside.map_or(0.9 * to, |mode| mode.omega.norm().max(0.9 * to));
    let above = outside.map_or(1.1 * to, |mode| mode.omega.norm().min(1.1 * to));
    (below * above).sqrt()
}
