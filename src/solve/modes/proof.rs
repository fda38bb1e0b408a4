//! Whether places are roots of the characteristic function: one by one, and in groups where they lie close together.
//!
//! A root that lies alone is proven by the sign that the function changes through it. Of those close together the argument
//! principle counts how many lie within a circle, and the eigenspace of that circle says where they are; the contour
//! integrals of the function over its roots, which are the sums of their powers (Delves & Lyness, Math. Comp. 21 (1967)
//! 543-560), hold what the eigenspace says against the function itself.

use num_complex::Complex64;
use rayon::prelude::*;

use super::argument_principle::Unsettled;
use super::damped::{CLOSE, OVERDAMPED, Search};
use super::eigenspace::Circle;
use super::neighbours::{Neighbours, neighbours, with_images};
use crate::solve::Cancelled;
use crate::solve::linear::Magnified;

/// What a group of places turns out to be.
enum Group {
    /// Roots, all of those within their circle; mirror images among them.
    Proven(Vec<Complex64>),
    /// Places nearer to the roots than those before.
    Nearer(Vec<Complex64>),
}

impl Search<'_> {
    /// The roots that are, as often as they are: proven ones, and new ones that may be none, or twice in the list.
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

    /// Adds those of the new places that are roots by themselves; the others come back.
    fn prove_alone(&self, proven: &mut Vec<Complex64>, new: &[Complex64]) -> Vec<Complex64> {
        let rest: Vec<Complex64> = proven.iter().chain(new).copied().collect();
        let all = with_images(&rest, self.is_hysteretic());
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

    /// Adds the roots of the groups that the doubtful places belong to; places nearer to roots come back where a group
    /// needs another look.
    fn prove_together(
        &self,
        proven: &mut Vec<Complex64>,
        mut doubtful: Vec<Complex64>,
    ) -> Result<Vec<Complex64>, Cancelled> {
        let mut nearer = Vec::new();
        // One group after the other: each sees those before it.
        while let Some(root) = doubtful.pop() {
            let first = proven.len();
            proven.push(root);
            proven.append(&mut doubtful);
            let all = with_images(proven, self.is_hysteretic());
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
            // Of mirror images one stands for both; with a loss factor there are none.
            let own = |root: &Complex64| self.is_hysteretic() || root.re >= 0.0;
            match settled {
                Group::Proven(roots) => proven.extend(roots.into_iter().filter(own)),
                Group::Nearer(places) => nearer.extend(places.into_iter().filter(own)),
            }
        }
        Ok(nearer)
    }

    /// Roots to the last digit, each if the function changes its sign through it as through a simple root.
    fn simple(&self, roots: &[Complex64]) -> Vec<Option<Complex64>> {
        const ASIDE: f64 = 1e-7;
        const CROOKED: f64 = 0.1;
        // Less than this is rounding of the function.
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
            let is_on_axis = z.re == 0.0 && !self.is_hysteretic();
            is_straight.then_some(if is_on_axis {
                Complex64::new(0.0, root.im)
            } else {
                root
            })
        };
        roots.iter().zip(values.chunks(3)).map(polished).collect()
    }

    /// What a group of the places `all` is, mirror images among them.
    fn group(&self, all: &[Complex64], group: &Neighbours) -> Result<Group, Cancelled> {
        const NONE: Group = Group::Proven(Vec::new());
        let members: Vec<Complex64> = group.members.iter().map(|&member| all[member]).collect();
        let circles = Circles::around(&members, group.gap);
        let Circles { inner, outer } = circles;
        let missing = match self.remainder_of(all).in_circle(inner.centre, outer) {
            Err(Unsettled::Cancelled(cancelled)) => return Err(cancelled),
            // What cannot be counted is no proven root: the whole count tells of it.
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

    /// A root on the imaginary axis where it is nearly there; with a loss factor none lies on it.
    fn on_axis(&self, root: Complex64) -> Complex64 {
        if !self.is_hysteretic() && root.re.abs() < OVERDAMPED * root.im {
            Complex64::new(0.0, root.im)
        } else {
            root
        }
    }
}

/// What the sums of the powers of roots may differ by, in radii of their circle.
const EXACT: f64 = 1e-8;

/// The circles round a group.
struct Circles {
    /// That of the eigenspace.
    inner: Circle,
    /// Radius of that of the count, rad/s: there is no root between them.
    outer: f64,
}

impl Circles {
    /// Around the members of a group, with `gap` from their mean to any other place, rad/s.
    fn around(members: &[Complex64], gap: f64) -> Self {
        /// Of a circle in which the function is more than rounding, in gaps.
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
