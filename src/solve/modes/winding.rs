//! How many roots of the characteristic function lie in a region: the argument principle.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use num_complex::Complex64;
use rayon::prelude::*;

use super::blocked::Blocked;
use super::characteristic::Characteristic;
use super::types::{Mode, ModeKind};
use crate::solve::linear::Magnified;

/// How far below the real axis the region reaches, rad: undamped roots lie inside.
const BELOW: f64 = 0.05;

/// Points at which the function is looked at between those of the path, at most. Where it is noise, halving finds no end.
const MOST_HALVINGS: usize = 1 << 20;

/// Steps of an arc beside which no mode lies.
const FEW: usize = 16;

/// A part of the plane of omega: a half ring about 0 whose right half is walked around; its left half is the mirror
/// image. With a loss factor nothing is mirrored, and the region is the right half alone.
#[derive(Debug, Clone, Copy)]
pub(super) struct Region {
    /// rad/s.
    pub(super) inner: f64,
    /// rad/s.
    pub(super) outer: f64,
    /// Whether the model has a loss factor.
    pub(super) hysteretic: bool,
}

impl Region {
    /// Whether a root lies in it.
    fn holds(&self, omega: Complex64) -> bool {
        let ring = (self.inner..self.outer).contains(&omega.norm());
        let low = -BELOW.tan() * omega.re.abs();
        ring && omega.im > low && (omega.re > 0.0 || !self.hysteretic)
    }

    /// How many roots of the whole region the modes stand for.
    pub(super) fn weigh(&self, modes: &[Mode]) -> i64 {
        let inside = modes
            .iter()
            .filter(|mode| (self.inner..self.outer).contains(&mode.omega.norm()));
        inside
            .map(|mode| match mode.kind {
                ModeKind::Oscillating if !self.hysteretic => 2,
                ModeKind::Oscillating | ModeKind::Overdamped => 1,
                ModeKind::RigidBody => 0,
            })
            .sum()
    }
}

/// The characteristic function over the roots of the blocked masses: it turns by about pi a mode, whatever the masses.
struct Turning<'a> {
    characteristic: &'a Characteristic,
    blocked: Blocked,
    halvings: AtomicUsize,
}

impl Turning<'_> {
    /// Whether another point may be looked at.
    fn may_halve(&self) -> bool {
        self.halvings.fetch_add(1, Ordering::Relaxed) < MOST_HALVINGS
    }

    fn at(&self, omega: Complex64) -> Magnified {
        self.characteristic.at(omega).over(&self.blocked.at(omega))
    }
}

/// The roots in the region, as often as they occur, or -1 where the function is too noisy to count; `None` where cancelled. `modes` (by rising |omega|) say where the
/// function turns fast.
pub(super) fn count(
    characteristic: &Characteristic,
    blocked: &Blocked,
    region: &Region,
    modes: &[Mode],
    cancel: &AtomicBool,
) -> Option<i64> {
    // On the way itself a root would be half inside.
    let mut blocked = blocked.clone();
    blocked
        .roots
        .retain(|root| !region.hysteretic || root.re.abs() > 1e-3 * root.norm());
    let masses = blocked
        .roots
        .iter()
        .filter(|root| region.holds(**root))
        .count();
    let turning = Turning {
        characteristic,
        blocked,
        halvings: AtomicUsize::new(0),
    };
    let turn = |from: f64, to: f64, radius: f64, steps: usize| {
        arc(from, to, steps)
            .map(|angle| Complex64::from_polar(radius, angle))
            .collect::<Vec<_>>()
    };
    let mut path = turn(FRAC_PI_2, -BELOW, region.inner, FEW);
    path.extend(
        radii(region, modes)
            .into_iter()
            .map(|radius| Complex64::from_polar(radius, -BELOW)),
    );
    path.extend(turn(-BELOW, FRAC_PI_2, region.outer, FEW + 4 * modes.len()));
    if region.hysteretic {
        let mut back = radii(region, &[]);
        back.reverse();
        path.extend(back.into_iter().map(|radius| Complex64::new(0.0, radius)));
    }
    let turned = phase_along(&turning, &path, cancel)?;
    if turned.is_nan() {
        // No list has so few modes: none is taken for complete.
        return Some(-1);
    }
    let whole = if region.hysteretic { 2.0 * PI } else { PI };
    Some((turned / whole).round() as i64 + masses as i64)
}

fn arc(from: f64, to: f64, steps: usize) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |step| from + (to - from) * step as f64 / steps as f64)
}

/// Radii from the inner to the outer circle: close where modes are, else far apart.
fn radii(region: &Region, modes: &[Mode]) -> Vec<f64> {
    const NEAR: f64 = 1.03;
    const FAR: f64 = 1.3;
    let first = modes
        .iter()
        .map(|mode| mode.omega.norm())
        .find(|&r| r > region.inner);
    let near = first.map_or(region.outer, |first| 0.7 * first);
    let mut radii = Vec::new();
    let mut radius = region.inner;
    while radius < region.outer {
        radii.push(radius);
        radius *= if radius < near { FAR } else { NEAR };
    }
    let sizes: Vec<f64> = modes.iter().map(|mode| mode.omega.norm()).collect();
    radii.extend(&sizes);
    radii.extend(sizes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
    radii.push(region.outer);
    radii.retain(|radius| (region.inner..=region.outer).contains(radius));
    radii.sort_by(f64::total_cmp);
    radii.dedup();
    radii
}

/// The change of the function's phase along a path, rad; `None` where cancelled.
fn phase_along(turning: &Turning, path: &[Complex64], cancel: &AtomicBool) -> Option<f64> {
    let goes_on = || !cancel.load(Ordering::Relaxed);
    let values: Option<Vec<Magnified>> = path
        .par_iter()
        .map(|&z| goes_on().then(|| turning.at(z)))
        .collect();
    let values = values?;
    let changes = (1..path.len()).into_par_iter().map(|index| {
        let ends = [
            (path[index - 1], values[index - 1]),
            (path[index], values[index]),
        ];
        phase_between(turning, ends[0], ends[1], 0, cancel)
    });
    changes.sum()
}

/// The change between two points, halved until it is small; not a number where that finds no end.
fn phase_between(
    turning: &Turning,
    from: (Complex64, Magnified),
    to: (Complex64, Magnified),
    depth: usize,
    cancel: &AtomicBool,
) -> Option<f64> {
    const SMALL: f64 = 0.9;
    const DEEPEST: usize = 30;
    let change = (to.1.direction * from.1.direction.conj()).arg();
    // Size and phase change alike: a full turn that looks like none shows in the size.
    let larger = change.abs().max((to.1.log - from.1.log).abs());
    if larger < SMALL || depth == DEEPEST || from.0 == to.0 {
        return Some(change);
    }
    if cancel.load(Ordering::Relaxed) {
        return None;
    }
    if larger.is_nan() || !turning.may_halve() {
        return Some(f64::NAN);
    }
    let middle = 0.5 * (from.0 + to.0);
    let middle = (middle, turning.at(middle));
    let before = phase_between(turning, from, middle, depth + 1, cancel)?;
    Some(before + phase_between(turning, middle, to, depth + 1, cancel)?)
}
