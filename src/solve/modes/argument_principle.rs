//! How many roots of the characteristic function are missing from a list: the argument principle along a closed path.
//!
//! The function is divided by the distances to all roots of the list, so that the phase of the quotient makes one turn
//! for each root inside that is missing from the list, and hardly changes if none is: a few dozen points certify a
//! complete list. A path is refined where the slope of the logarithm between its points is not smooth; this also
//! detects a root close to the path, even a double one; where the function is only rounding the refinement would not
//! end, and the path is reported as unsettled.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use num_complex::Complex64;
use rayon::prelude::*;

use super::blocked::distances;
use super::characteristic::Characteristic;
use crate::solve::Cancelled;
use crate::solve::linear::Magnified;

/// Why a path has no count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unsettled {
    /// The request was cancelled.
    Cancelled(Cancelled),
    /// The function is only rounding there.
    Noise,
    /// The work limit is reached.
    Spent,
}

impl From<Cancelled> for Unsettled {
    fn from(cancelled: Cancelled) -> Self {
        Self::Cancelled(cancelled)
    }
}

/// The characteristic function divided by the distances to the known roots.
pub(super) struct Remainder<'a> {
    pub(super) characteristic: &'a Characteristic,
    /// The roots of the list with their mirror images; rad/s.
    pub(super) known: Vec<Complex64>,
    /// How many roots lie at 0.
    pub(super) at_zero: usize,
    /// The roots of blocked masses beyond the list: each has a root of the function near it.
    pub(super) masses: Vec<Complex64>,
    /// How many more points may be evaluated.
    pub(super) budget: &'a AtomicUsize,
    pub(super) cancel: &'a AtomicBool,
}

/// A point on the path as ln omega, and the logarithm of the function there (its phase up to whole turns).
#[derive(Debug, Clone, Copy)]
struct Look {
    at: Complex64,
    log: Complex64,
}

/// A part of the plane of ln omega with straight edges: ln |omega| and the angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sector {
    pub(super) radii: [f64; 2],
    pub(super) angles: [f64; 2],
}

/// The angles of the sector in which roots are counted, rad: it extends below the real axis, where there is no root,
/// and beyond the imaginary one, so that roots on the axes are inside.
pub(super) const COUNTED_ANGLES: [f64; 2] = [-0.1, FRAC_PI_2 + 0.12];

impl Remainder<'_> {
    /// The number of roots missing from the list in the disc up to `radius` (rad/s), counted in the right half of the
    /// plane and on the imaginary axis; negative if the list has too many. Without a loss factor the left half is the
    /// mirror image.
    pub(super) fn in_disc(&self, radius: f64, hysteretic: bool) -> Result<i64, Unsettled> {
        if !hysteretic {
            let right = Complex64::new(radius.ln(), -FRAC_PI_2);
            // There is no root below the real axis, so half of the circle is enough.
            let turned = self.turned(&[right, right + Complex64::I * PI])?;
            return whole(turned / PI);
        }
        let nearest = self.known.iter().map(|root| root.norm());
        let inner = (0.2 * nearest.fold(radius, f64::min)).max(self.characteristic.slowest());
        let inner = inner.min(0.5 * radius).ln();
        let outer = radius.ln();
        // Passes 0 on its left, where there is also no root below the axis.
        let path = [
            Complex64::new(outer, COUNTED_ANGLES[0]),
            Complex64::new(outer, COUNTED_ANGLES[1]),
            Complex64::new(inner, COUNTED_ANGLES[1]),
            Complex64::new(inner, TAU + COUNTED_ANGLES[0]),
            Complex64::new(outer, TAU + COUNTED_ANGLES[0]),
        ];
        whole(self.turned(&path)? / TAU)
    }

    /// The number of roots missing from the list in a sector.
    pub(super) fn in_sector(&self, sector: &Sector) -> Result<i64, Unsettled> {
        let [[low, high], [from, to]] = [sector.radii, sector.angles];
        let corners = [
            (low, from),
            (high, from),
            (high, to),
            (low, to),
            (low, from),
        ];
        let path = corners.map(|(radius, angle)| Complex64::new(radius, angle));
        whole(self.turned(&path)? / TAU)
    }

    /// The number of roots missing from the list within `radius` of `centre`, rad/s; the circle is a polygon.
    pub(super) fn in_circle(&self, centre: Complex64, radius: f64) -> Result<i64, Unsettled> {
        const CORNERS: usize = 16;
        let corner = |index: usize| {
            let angle = TAU * index as f64 / CORNERS as f64;
            (centre + Complex64::from_polar(radius, angle)).ln()
        };
        let path: Vec<Complex64> = (0..=CORNERS).map(corner).collect();
        whole(self.turned(&path)? / TAU)
    }

    /// The amount by which the sums of the powers 1 to `count` of the list's roots within `radius` of `centre` (rad/s;
    /// powers of the distance over the radius) differ from the exact ones, if none is missing there: -p times the mean
    /// of `z^p ln f`.
    pub(super) fn power_sums(
        &self,
        centre: Complex64,
        radius: f64,
        count: usize,
    ) -> Result<Vec<Complex64>, Unsettled> {
        const POINTS: usize = 64;
        let directions: Vec<Complex64> = (0..POINTS)
            .map(|index| Complex64::cis(TAU * (index as f64 + 0.5) / POINTS as f64))
            .collect();
        let places: Vec<Complex64> = directions
            .iter()
            .map(|direction| (centre + radius * direction).ln())
            .collect();
        let looks = self.look(&places)?;
        let mut log = Complex64::ZERO;
        let mut logs = vec![log];
        for pair in looks.windows(2) {
            log += step(pair[0], pair[1]);
            logs.push(log);
        }
        let sum = |power: usize| {
            let terms = directions.iter().zip(&logs);
            let sum: Complex64 = terms.map(|(z, log)| z.powi(power as i32) * log).sum();
            -(power as f64) * sum / POINTS as f64
        };
        Ok((1..=count).map(sum).collect())
    }

    /// The change of the phase along a path of straight lines in ln omega, rad.
    fn turned(&self, corners: &[Complex64]) -> Result<f64, Unsettled> {
        /// Between two points, from the growth of the waves, rad: small enough that a full turn cannot be missed.
        const TURN: f64 = 1.2;
        const LONGEST: f64 = 0.2;
        const MOST_ROUNDS: usize = 24;
        let mut path = vec![corners[0]];
        for pair in corners.windows(2) {
            let length = (pair[1] - pair[0]).norm();
            let direction = (pair[1] - pair[0]) / length;
            let mut gone = 0.0;
            while gone < length {
                let here = pair[0] + direction * gone;
                let fastest = (here.re + LONGEST * direction.re.max(0.0)).exp();
                gone += (TURN / self.characteristic.turning(fastest)).min(LONGEST);
                path.push(if gone < length {
                    pair[0] + direction * gone
                } else {
                    pair[1]
                });
            }
        }
        let most = 24 * path.len() + 400;
        let mut looks = self.look(&path)?;
        for _ in 0..MOST_ROUNDS {
            let rough = rough(&looks);
            let missing: Vec<Complex64> = (0..rough.len())
                .filter(|&index| rough[index])
                .map(|index| 0.5 * (looks[index].at + looks[index + 1].at))
                .collect();
            if missing.is_empty() {
                return Ok(looks.windows(2).map(|pair| step(pair[0], pair[1]).im).sum());
            }
            if looks.len() + missing.len() > most {
                return Err(Unsettled::Noise);
            }
            let mut new = self.look(&missing)?.into_iter();
            let mut finer = vec![looks[0]];
            for (index, &look) in looks.iter().enumerate().skip(1) {
                if rough[index - 1] {
                    finer.extend(new.next());
                }
                finer.push(look);
            }
            looks = finer;
        }
        Err(Unsettled::Noise)
    }

    fn look(&self, places: &[Complex64]) -> Result<Vec<Look>, Unsettled> {
        /// Points between two checks for cancellation.
        const AT_ONCE: usize = 512;
        let spent = |left: usize| left.checked_sub(places.len());
        if self
            .budget
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, spent)
            .is_err()
        {
            return Err(Unsettled::Spent);
        }
        let mut looks = Vec::with_capacity(places.len());
        for places in places.chunks(AT_ONCE) {
            looks.extend(self.logs(places));
            Cancelled::check(self.cancel)?;
        }
        if looks.iter().any(|look| !look.log.is_finite()) {
            return Err(Unsettled::Noise);
        }
        Ok(looks)
    }

    /// The logarithm of the function at each omega = e^at.
    fn logs(&self, places: &[Complex64]) -> Vec<Look> {
        let omegas: Vec<Complex64> = places.iter().map(|at| at.exp()).collect();
        let values = self.characteristic.at(&omegas);
        let look = |((&at, &omega), value): ((&Complex64, &Complex64), &Magnified)| {
            let value = value
                .over(&distances(&self.known, omega))
                .over(&distances(&self.masses, omega));
            let at_zero = self.at_zero as f64 * at;
            Look {
                at,
                log: Complex64::new(value.log, value.direction.arg()) - at_zero,
            }
        };
        let places = places.par_iter().zip(&omegas).zip(&values);
        places.with_min_len(64).map(look).collect()
    }
}

/// The nearest integer to a number of turns; `Noise` if it is not close to one.
fn whole(turns: f64) -> Result<i64, Unsettled> {
    const RESOLVED: f64 = 0.05;
    let count = turns.round();
    if (turns - count).abs() < RESOLVED {
        Ok(count as i64)
    } else {
        Err(Unsettled::Noise)
    }
}

/// The change of the logarithm, with its phase in (-pi, pi].
fn step(from: Look, to: Look) -> Complex64 {
    let change = to.log - from.log;
    let turns = (change.im / TAU).round();
    change - Complex64::new(0.0, turns * TAU)
}

/// The intervals between points that are too long. The slope along the path is that of an analytic function: it is also
/// smooth at a corner.
fn rough(looks: &[Look]) -> Vec<bool> {
    const TURN: f64 = 1.0;
    const BEND: f64 = 0.4;
    let steps: Vec<Complex64> = looks
        .windows(2)
        .map(|pair| step(pair[0], pair[1]))
        .collect();
    let lengths: Vec<Complex64> = looks
        .windows(2)
        .map(|pair| pair[1].at - pair[0].at)
        .collect();
    let mut rough: Vec<bool> = steps.iter().map(|step| step.im.abs() > TURN).collect();
    for index in 1..steps.len() {
        let bend = steps[index] / lengths[index] - steps[index - 1] / lengths[index - 1];
        let (before, after) = (lengths[index - 1].norm(), lengths[index].norm());
        if bend.norm() * before.min(after) > BEND {
            // The longer interval can miss more.
            rough[index] |= after >= 0.5 * before;
            rough[index - 1] |= before >= 0.5 * after;
        }
    }
    rough
}
