//! Proof of roots of the characteristic function: one by one, and in groups if they are close together.
//!
//! A separate root is proven by the sign change of the function. For close ones the argument principle counts the roots
//! within a circle, and the eigenspace of that circle locates them; the contour integrals of the function, which are
//! the sums of the powers of its roots (Delves & Lyness, Math. Comp. 21 (1967) 543-560), verify the result of the
//! eigenspace.

use num_complex::Complex64;
use rayon::prelude::*;

use super::argument_principle::Unsettled;
use super::damped::{CLOSE, OVERDAMPED, Search};
use super::eigenspace::Circle;
use super::neighbours::{Neighbours, neighbours, with_images};
use crate::solve::Cancelled;
use crate::solve::linear::Magnified;

/// The result for a group of candidate points.
enum Group {
    /// All roots within the circle, including mirror images.
    Proven(Vec<Complex64>),
    /// Points nearer to the roots than those before.
    Nearer(Vec<Complex64>),
}

impl Search<'_> {
    /// The roots with their multiplicity: proven ones, and new candidates, which may be no roots or duplicates.
    pub(super) fn proven(
        &self,
        mut proven: Vec<Complex64>,
        new: &[Complex64],
    ) -> Result<Vec<Complex64>, Cancelled> {
        const MOST_ROUNDS: usize = 5;
        let mut doubtful = new.to_vec();
        for _ in 0..MOST_ROUNDS {
            if doubtful.is_empty() {
                break;
            }
            let together = self.prove_alone(&mut proven, &doubtful);
            let nearer = self.prove_together(&mut proven, together)?;
            doubtful = self.settled(&nearer, &proven)?;
        }
        proven.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        Ok(proven)
    }

    /// Adds the new candidates that are separate roots; returns the others.
    fn prove_alone(&self, proven: &mut Vec<Complex64>, new: &[Complex64]) -> Vec<Complex64> {
        let rest: Vec<Complex64> = proven.iter().chain(new).copied().collect();
        let all = with_images(&rest, self.is_hysteretic);
        let is_alone: Vec<bool> = (proven.len()..rest.len())
            .into_par_iter()
            .with_min_len(64)
            .map(|index| neighbours(&all, index, CLOSE).members.len() == 1)
            .collect();
        let pick = |wanted: bool| -> Vec<Complex64> {
            let picked = new.iter().zip(&is_alone).filter(|new| *new.1 == wanted);
            picked.map(|(&root, _)| root).collect()
        };
        let (alone, mut doubtful) = (pick(true), pick(false));
        for (root, simple) in alone.iter().zip(self.simple(&alone)) {
            match simple {
                Some(root) => proven.push(root),
                None => doubtful.push(*root),
            }
        }
        doubtful
    }

    /// Adds the roots of the groups of the doubtful candidates; returns points nearer to roots if a group needs another
    /// pass.
    fn prove_together(
        &self,
        proven: &mut Vec<Complex64>,
        mut doubtful: Vec<Complex64>,
    ) -> Result<Vec<Complex64>, Cancelled> {
        let mut nearer = Vec::new();
        // One group after the other: each uses the results of those before it.
        while let Some(root) = doubtful.pop() {
            let first = proven.len();
            proven.push(root);
            proven.append(&mut doubtful);
            let all = with_images(proven, self.is_hysteretic);
            let group = neighbours(&all, first, CLOSE);
            let settled = self.group(&all, &group)?;
            doubtful = proven.split_off(first);
            for &member in group.members.iter().rev() {
                if member < first {
                    proven.swap_remove(member);
                } else if member - first < doubtful.len() {
                    doubtful.swap_remove(member - first);
                }
            }
            // Of two mirror images one is enough; with a loss factor there are none.
            let own = |root: &Complex64| self.is_hysteretic || root.re >= 0.0;
            match settled {
                Group::Proven(roots) => proven.extend(roots.into_iter().filter(own)),
                Group::Nearer(places) => nearer.extend(places.into_iter().filter(own)),
            }
        }
        Ok(nearer)
    }

    /// Refines roots to the last digit, each if the function changes its sign through it as through a simple root.
    fn simple(&self, roots: &[Complex64]) -> Vec<Option<Complex64>> {
        const ASIDE: f64 = 1e-7;
        const CROOKED: f64 = 0.1;
        // Smaller values are rounding of the function.
        const ROUNDING: f64 = 1e-12;
        let beside = |z: &Complex64| [z - ASIDE * z, *z, z + ASIDE * z];
        let places: Vec<Complex64> = roots.iter().flat_map(beside).collect();
        let values = self.characteristic.at(&places);
        let polished = |(z, values): (&Complex64, &[Magnified])| {
            let [before, here] = [&values[0], &values[1]].map(|value| {
                if value.log == f64::NEG_INFINITY {
                    Complex64::ZERO
                } else {
                    value.ratio(&values[2])
                }
            });
            let is_straight = (1.0 + before).norm() < CROOKED && here.norm() < CROOKED;
            let step = ASIDE * z * here / (0.5 * (1.0 - before));
            let root = if step.norm() > ROUNDING * z.norm() {
                z - step
            } else {
                *z
            };
            let is_on_axis = z.re == 0.0 && !self.is_hysteretic;
            is_straight.then_some(if is_on_axis {
                Complex64::new(0.0, root.im)
            } else {
                root
            })
        };
        roots.iter().zip(values.chunks(3)).map(polished).collect()
    }

    /// The result for a group of the points `all`, including mirror images.
    fn group(&self, all: &[Complex64], group: &Neighbours) -> Result<Group, Cancelled> {
        const NONE: Group = Group::Proven(Vec::new());
        let members: Vec<Complex64> = group.members.iter().map(|&member| all[member]).collect();
        let circles = Circles::around(&members, group.gap);
        let Circles { inner, outer } = circles;
        let missing = match self.remainder_of(all).in_circle(inner.centre, outer) {
            Err(Unsettled::Cancelled(cancelled)) => return Err(cancelled),
            // If the count fails, no root is proven; the total count detects it.
            Err(Unsettled::Noise | Unsettled::Spent) => return Ok(NONE),
            Ok(missing) => missing,
        };
        let count = usize::try_from(members.len() as i64 + missing).unwrap_or(0);
        if count == 0 {
            return Ok(NONE);
        }
        let found = self.inside(inner, count);
        let farthest = found.iter().map(|root| (root - inner.centre).norm());
        if found.is_empty() || farthest.fold(0.0, f64::max) > outer {
            return Ok(NONE);
        }
        let found: Vec<Complex64> = found.into_iter().map(|root| self.on_axis(root)).collect();
        let others = (0..all.len()).filter(|index| !group.members.contains(index));
        let known = others.map(|index| all[index]).chain(found.iter().copied());
        let known: Vec<Complex64> = known.collect();
        let sums = self
            .remainder_of(&known)
            .power_sums(inner.centre, outer, count);
        Ok(match sums {
            Err(Unsettled::Cancelled(cancelled)) => return Err(cancelled),
            Ok(sums) if sums.iter().all(|sum| sum.norm() < EXACT) => Group::Proven(found),
            Ok(_) | Err(Unsettled::Noise | Unsettled::Spent) => Group::Nearer(found),
        })
    }

    /// Moves a root that is almost on the imaginary axis onto it; with a loss factor no root is on it.
    fn on_axis(&self, root: Complex64) -> Complex64 {
        if !self.is_hysteretic && root.re.abs() < OVERDAMPED * root.im {
            Complex64::new(0.0, root.im)
        } else {
            root
        }
    }
}

/// Accepted difference between the sums of the powers of roots, in radii of their circle.
const EXACT: f64 = 1e-8;

/// The circles around a group.
struct Circles {
    /// The circle of the eigenspace.
    inner: Circle,
    /// Radius of the circle of the count, rad/s: there is no root between them.
    outer: f64,
}

impl Circles {
    /// Around the members of a group, with `gap` from their mean to any other point, rad/s.
    fn around(members: &[Complex64], gap: f64) -> Self {
        /// The smallest circle in which the function is more than rounding, in gaps.
        const LEAST: f64 = 0.03;
        const DIGITS: f64 = 26.0;
        let mut inner = Circle::around(members, gap);
        inner.radius = inner.radius.max(LEAST * gap);
        let outer = (inner.radius * gap).sqrt();
        let size = |member: &Complex64| (member - inner.centre).norm();
        let size = members.iter().map(size).fold(0.0, f64::max);
        let share = (size / inner.radius).max(inner.radius / outer);
        inner.points = (DIGITS / -share.ln()).ceil().clamp(12.0, 64.0) as usize;
        Self { inner, outer }
    }
}
