//! Damped modes: the complex roots of the characteristic function, from the undamped ones or those of a similar model.
//!
//! All roots move together by the simultaneous iteration of Aberth (Math. Comp. 27 (1973) 339-344): Newton steps in
//! which every root repels the others. Then each root is proven (see [`proof`](super::proof)). The argument principle
//! counts the missing ones (see [`argument_principle`](super::argument_principle)); the search tries the roots of the
//! blocked masses for them, and then [`regions`](super::regions).

use std::sync::atomic::{AtomicBool, AtomicUsize};

use num_complex::Complex64;
use rayon::prelude::*;

use super::aberth::Tracker;
use super::argument_principle::{Remainder, Unsettled};
use super::blocked::Blocked;
use super::characteristic::{Characteristic, inverse};
use super::eigenspace::{Circle, roots_inside};
use super::neighbours::{neighbours, with_images};
use super::regions::Regions;
use super::types::{Completeness, Mode, ModeKind};
use super::{is_hysteretic, rigid, with_damping_times};
use crate::model::Model;
use crate::solve::Cancelled;

/// The search for the damped roots of a model.
pub(super) struct Search<'a> {
    model: &'a Model,
    /// Whether the model has a loss factor: then no root is the mirror image of another.
    pub(super) is_hysteretic: bool,
    pub(super) characteristic: Characteristic,
    blocked: Blocked,
    /// How many roots lie at 0.
    at_zero: usize,
    /// Larger than the radius of every circle of a count, rad/s.
    reach: f64,
    /// How many more points the counts may evaluate.
    budget: AtomicUsize,
    cancel: &'a AtomicBool,
}

/// Damped roots, and whether the list is complete.
#[derive(Debug, Clone)]
pub(super) struct Found {
    /// By ascending |omega|, without the rigid-body modes; some are beyond the range.
    pub(super) modes: Vec<Mode>,
    /// The completeness within the range.
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
    /// For a checked model, the number of its rigid-body modes, and its roots with |omega| up to `to`, rad/s.
    pub(super) fn new(
        model: &'a Model,
        rigid_modes: usize,
        to: f64,
        cancel: &'a AtomicBool,
    ) -> Self {
        /// The limit of stations that a count may pass: some seconds of work.
        const BUDGET: usize = 40_000_000;
        let stations = 10 + model.attached().count();
        let zeros = 2 * rigid_modes;
        Self {
            model,
            is_hysteretic: is_hysteretic(model),
            characteristic: Characteristic::new(model),
            blocked: Blocked::new(model),
            reach: FARTHEST * to,
            at_zero: zeros
                - if zeros > 0 {
                    rigid::crept(model, STILL * to)
                } else {
                    0
                },
            budget: AtomicUsize::new(BUDGET / stations),
            cancel,
        }
    }

    /// The roots with |omega| up to `to`, rad/s, from the undamped ones (rad/s, above 0, ascending; some beyond `to`,
    /// because damping may slow them into the range).
    pub(super) fn continue_undamped(&self, undamped: &[f64], to: f64) -> Result<Found, Cancelled> {
        self.completed(&self.predicted(undamped), to)
    }

    /// The roots from the undamped ones, by [`Self::continue_undamped`], and from `overdamped`, rad/s; without a count.
    pub(super) fn uncertified(
        &self,
        undamped: &[f64],
        overdamped: &[Mode],
    ) -> Result<Found, Cancelled> {
        let mut starts = self.predicted(undamped);
        starts.extend(overdamped.iter().map(|mode| mode.omega));
        self.uncounted(&starts)
    }

    /// The roots near those of a similar model, without a count.
    pub(super) fn follow(&self, before: &[Mode]) -> Result<Found, Cancelled> {
        self.uncounted(&omegas(before))
    }

    /// The roots with |omega| up to `to`, rad/s, from known ones: each of them is proven again, and they are counted.
    pub(super) fn certify(&self, known: &[Mode], to: f64) -> Result<Found, Cancelled> {
        self.completed(&omegas(known), to)
    }

    /// The roots to which starting values converge.
    fn uncounted(&self, starts: &[Complex64]) -> Result<Found, Cancelled> {
        let arrived = self.settled(starts, &[])?;
        Ok(Found {
            modes: listed(&self.proven(Vec::new(), &arrived)?),
            completeness: Completeness::Uncounted,
        })
    }

    /// The roots to first order in the damping: one Newton step at a small fraction of it, scaled up; for roots that
    /// are close together the eigenspace at that fraction.
    fn predicted(&self, undamped: &[f64]) -> Vec<Complex64> {
        const SHARE: f64 = 1e-3;
        const FARTHEST: f64 = 0.5;
        let model = with_damping_times(self.model, SHARE);
        let weak = Characteristic::new(&model);
        let all: Vec<Complex64> = undamped.iter().map(|&omega| omega.into()).collect();
        let groups: Vec<&[f64]> = undamped.chunk_by(|a, b| b - a < CLOSE * a).collect();
        let steps = weak.newton_steps(&all);
        let shifts = |group: &&[f64]| -> Vec<Complex64> {
            let first = undamped.partition_point(|omega| *omega < group[0]);
            if group.len() == 1 {
                return vec![-steps[first] / SHARE];
            }
            let gap = neighbours(&all, first, CLOSE).gap;
            let starts: Vec<Complex64> = group.iter().map(|&omega| omega.into()).collect();
            let found = roots_inside(&model, Circle::around(&starts, gap), group.len());
            let shifted = found.unwrap_or_else(|| starts.clone());
            shifted
                .iter()
                .zip(group.iter())
                .map(|(root, omega)| (root - omega) / SHARE)
                .collect()
        };
        let shifts: Vec<Complex64> = groups.par_iter().flat_map_iter(shifts).collect();
        let moved = undamped.iter().zip(shifts).map(|(&omega, shift)| {
            let limited = (FARTHEST * omega / shift.norm()).min(1.0);
            if limited.is_finite() {
                omega + shift * limited
            } else {
                Complex64::from(omega)
            }
        });
        moved.collect()
    }

    /// The roots to which starting values converge, and those that the counts still miss.
    fn completed(&self, starts: &[Complex64], to: f64) -> Result<Found, Cancelled> {
        let arrived = self.settled(starts, &[])?;
        let mut roots = self.proven(Vec::new(), &arrived)?;
        let mut outer = boundary(&roots, to);
        let mut counted = self.missing(&roots, outer)?;
        if counted != Some(0) {
            let masses = self.blocked.roots.iter().copied();
            let inside =
                masses.filter(|root| root.re >= 0.0 && root.norm() < outer && root.im > 0.0);
            let arrived = self.settled(&inside.collect::<Vec<_>>(), &roots)?;
            roots = self.proven(roots, &arrived)?;
            outer = boundary(&roots, to);
            counted = self.missing(&roots, outer)?;
        }
        let mut completeness = Completeness::Certain;
        if counted != Some(0) {
            let open;
            (roots, open) = Regions::new(self, outer).completed(roots)?;
            if !open.is_empty() {
                completeness = Completeness::Open(open);
            }
        }
        Ok(Found {
            modes: listed(&roots),
            completeness,
        })
    }

    /// The number of roots missing from the list in the disc up to `outer`, rad/s; `None` if the count fails.
    pub(super) fn missing(
        &self,
        roots: &[Complex64],
        outer: f64,
    ) -> Result<Option<i64>, Cancelled> {
        match self.remainder(roots).in_disc(outer, self.is_hysteretic) {
            Ok(counted) => Ok(Some(counted)),
            Err(Unsettled::Noise | Unsettled::Spent) => Ok(None),
            Err(Unsettled::Cancelled(cancelled)) => Err(cancelled),
        }
    }

    /// The characteristic function divided by the distances to the roots and their mirror images.
    pub(super) fn remainder(&self, roots: &[Complex64]) -> Remainder<'_> {
        self.remainder_of(&with_images(roots, self.is_hysteretic))
    }

    /// The characteristic function divided by the distances to some points.
    pub(super) fn remainder_of(&self, roots: &[Complex64]) -> Remainder<'_> {
        Remainder {
            characteristic: &self.characteristic,
            known: roots.to_vec(),
            at_zero: self.at_zero,
            masses: self.masses_beyond(roots.iter()),
            budget: &self.budget,
            cancel: self.cancel,
        }
    }

    /// The roots of the blocked masses outside the circles of the counts and outside some roots.
    fn masses_beyond<'b>(&self, roots: impl Iterator<Item = &'b Complex64>) -> Vec<Complex64> {
        let farthest = roots.map(|root| root.norm()).fold(self.reach, f64::max);
        let masses = self.blocked.roots.iter().copied();
        masses.filter(|root| root.norm() > farthest).collect()
    }

    /// Roots inside a circle that contains `count` of them; approximate if others are close outside, none if noise
    /// hides them.
    pub(super) fn inside(&self, circle: Circle, count: usize) -> Vec<Complex64> {
        roots_inside(self.model, circle, count).unwrap_or_default()
    }

    /// Moves all starting values to roots other than the known ones. Those that do not converge are left out, except
    /// starting values that are close together: these move as one to where their number can be proven.
    pub(super) fn settled(
        &self,
        starts: &[Complex64],
        known: &[Complex64],
    ) -> Result<Vec<Complex64>, Cancelled> {
        const MOST_STEPS: usize = 40;
        const TOGETHER: f64 = 1e-6;
        let mut trackers: Vec<Tracker> = Vec::new();
        for &start in starts {
            let near =
                |tracker: &&mut Tracker| (tracker.z - start).norm() < TOGETHER * start.norm();
            match trackers.iter_mut().rev().find(near) {
                Some(tracker) => tracker.count += 1,
                None => trackers.push(Tracker::new(start, 1, self.is_hysteretic)),
            }
        }
        let fixed: Vec<(Complex64, f64)> = known.iter().map(|&z| (z, 1.0)).collect();
        // Without the roots beyond, possibly thousands, steps would have the wrong size.
        let beyond = self.masses_beyond(starts.iter().chain(known));
        for _ in 0..MOST_STEPS {
            Cancelled::check(self.cancel)?;
            let moving = trackers
                .iter()
                .map(|tracker| (tracker.z, tracker.count as f64));
            let all: Vec<(Complex64, f64)> = moving.chain(fixed.iter().copied()).collect();
            let moving: Vec<usize> = (0..trackers.len())
                .filter(|&index| !trackers[index].arrived)
                .collect();
            let places: Vec<Complex64> = moving.iter().map(|&index| trackers[index].z).collect();
            let steps = self.characteristic.newton_steps(&places);
            let pushes: Vec<Complex64> = moving
                .par_iter()
                .with_min_len(64)
                .map(|&index| self.push(&all, index) + pull(&beyond, all[index].0))
                .collect();
            for ((index, step), push) in moving.into_iter().zip(steps).zip(pushes) {
                trackers[index].step(step, push);
            }
            if trackers.iter().all(|tracker| tracker.arrived) {
                break;
            }
        }
        let arrived = trackers
            .into_iter()
            .filter(|tracker| tracker.arrived || tracker.count > 1);
        Ok(arrived
            .flat_map(|tracker| vec![tracker.z; tracker.count])
            .collect())
    }

    /// The sum of 1 / (z - other) over all other roots with their multiplicity, mirror images, and those at 0.
    fn push(&self, all: &[(Complex64, f64)], index: usize) -> Complex64 {
        let (z, _) = all[index];
        let mut push = self.at_zero as f64 * inverse(z);
        for (other, &(root, count)) in all.iter().enumerate() {
            if other != index {
                push += count * inverse(z - root);
            }
            if root.re != 0.0 && !self.is_hysteretic {
                push += count * inverse(z + root.conj());
            }
        }
        push
    }
}

/// A rate this small compared with the range counts as 0.
const STILL: f64 = 1e-14;

/// Roots closer than this (relative) are proven together.
pub(super) const CLOSE: f64 = 1e-5;

/// The largest extent of the counts beyond the range.
const FARTHEST: f64 = 1.08;

/// A root this close to the imaginary axis (relative) is on it.
pub(super) const OVERDAMPED: f64 = 1e-7;

/// Rounding of a root on the axis, relative.
const ON_AXIS: f64 = 1e-10;

/// The sum of 1 / (z - root) over some roots.
fn pull(roots: &[Complex64], z: Complex64) -> Complex64 {
    roots.iter().map(|root| inverse(z - root)).sum()
}

fn omegas(modes: &[Mode]) -> Vec<Complex64> {
    modes.iter().map(|mode| mode.omega).collect()
}

/// The modes of the roots in the right half of the plane, by ascending |omega|.
fn listed(roots: &[Complex64]) -> Vec<Mode> {
    let right = roots
        .iter()
        .filter(|root| root.re >= -ON_AXIS * root.norm());
    let mut modes: Vec<Mode> = right.map(|&root| mode(root)).collect();
    modes.sort_by(|a, b| a.omega.norm().total_cmp(&b.omega.norm()));
    modes
}

/// The mode of a root.
fn mode(omega: Complex64) -> Mode {
    // A root that no damper affects is on the real axis up to rounding.
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

/// A radius just beyond `to` in the widest gap between roots.
fn boundary(roots: &[Complex64], to: f64) -> f64 {
    const NEAREST: f64 = 1.005;
    let (low, high) = (NEAREST * to, FARTHEST * to);
    let mut sizes: Vec<f64> = roots.iter().map(|root| root.norm()).collect();
    sizes.retain(|size| (to..high).contains(size));
    sizes.extend([low, high]);
    sizes.sort_by(f64::total_cmp);
    let gaps = sizes
        .windows(2)
        .filter(|pair| pair[0] >= low || pair[1] > low);
    let gaps = gaps.map(|pair| (pair[0].max(low), pair[1]));
    let widest = gaps.max_by(|a, b| (a.1 / a.0).total_cmp(&(b.1 / b.0)));
    widest.map_or(low, |(from, to)| (from * to).sqrt())
}
