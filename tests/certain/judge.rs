//! A check of lists of damped modes: the argument principle on a small circle around each root, or group of roots that
//! are close together, and on the whole region, of the [`Determinant`].
//!
//! The determinant is divided by the distances to the roots of the list, so that its phase turns only for missing or
//! surplus roots.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use beamtune::model::Model;
use beamtune::solve::modes::{Completeness, Gap, ModeKind, Modes};
use num_complex::Complex64;

use super::determinant::Determinant;

/// A list to check; everything in rad/s.
struct Judge<'a> {
    determinant: Determinant<'a>,
    hysteretic: bool,
    /// Roots in the range.
    moving: Vec<Complex64>,
    /// Roots in the range, beyond it, and mirror images of both.
    all: Vec<Complex64>,
    /// Roots at 0.
    at_zero: usize,
    /// Upper end of the range.
    to: f64,
    /// Where the list is open, so that nothing is promised.
    open: Vec<[f64; 2]>,
}

/// The errors of a list: where it is certain, it must have each mode with its multiplicity. None if it is right.
pub fn fault(model: &Model, found: &Modes) -> Option<String> {
    let judge = Judge::new(model, found);
    judge.fault_near_a_root().or_else(|| judge.fault_anywhere())
}

/// How many modes a model has within `radius` of `centre`, rad/s.
pub fn counted(model: &Model, centre: Complex64, radius: f64) -> Option<i64> {
    let judge = Judge {
        determinant: Determinant::new(model),
        hysteretic: false,
        moving: Vec::new(),
        all: Vec::new(),
        at_zero: 0,
        to: 0.0,
        open: Vec::new(),
    };
    judge.missing_in_circle(centre, radius)
}

/// Whether the beam or a spring has a loss factor: then no root is the mirror image of another.
pub fn is_hysteretic(model: &Model) -> bool {
    let inner = model.supports.inner.iter().map(|inner| &inner.support);
    let ends = [&model.supports.left, &model.supports.right];
    let supports = ends.into_iter().chain(inner);
    let restraints = supports.flat_map(|support| support.restraints.clone());
    let springs = (model.subsystems.iter()).flat_map(|s| {
        [
            s.y_left.clone(),
            s.y_right.clone(),
            s.z_left.clone(),
            s.z_right.clone(),
        ]
    });
    let links = model.joints.iter().flat_map(|joint| joint.links.clone());
    let spans = model.spans.iter().filter_map(|span| span.material);
    let mut losses = std::iter::once(model.beam.material.loss_factor)
        .chain(spans.map(|material| material.loss_factor))
        .chain(restraints.map(|of| of.elastic().spring.loss_factor))
        .chain(springs.map(|of| of.loss_factor))
        .chain(links.map(|link| link.spring().loss_factor));
    losses.any(|loss| loss != 0.0)
}

impl<'a> Judge<'a> {
    fn new(model: &'a Model, found: &Modes) -> Self {
        let hysteretic = is_hysteretic(model);
        let rigid = |kind: ModeKind| kind == ModeKind::RigidBody;
        let omegas = |modes: &[beamtune::solve::modes::Mode]| -> Vec<Complex64> {
            let moving = modes.iter().filter(|mode| !rigid(mode.kind));
            moving.map(|mode| mode.omega).collect()
        };
        let moving = omegas(&found.modes);
        let mut all = moving.clone();
        all.extend(omegas(&found.beyond));
        if !hysteretic {
            let mirrored = all.iter().filter(|root| root.re != 0.0);
            let mirrored: Vec<Complex64> = mirrored.map(|root| -root.conj()).collect();
            all.extend(mirrored);
        }
        let open = match &found.completeness {
            Completeness::Certain => Vec::new(),
            Completeness::Open(gaps) => gaps.iter().map(range).collect(),
            Completeness::Uncounted | Completeness::TooMany => vec![[0.0, f64::INFINITY]],
        };
        Self {
            determinant: Determinant::new(model),
            hysteretic,
            moving,
            all,
            at_zero: 2 * found.modes.iter().filter(|mode| rigid(mode.kind)).count(),
            to: TAU * found.to,
            open,
        }
    }

    fn fault_near_a_root(&self) -> Option<String> {
        groups(&self.all).into_iter().find_map(|group| {
            // Of two mirror images one is enough, and roots beyond the range are not promised.
            if group[0] >= self.moving.len() {
                return None;
            }
            let (centre, radius) = self.circle(&group);
            let [from, to] = [centre.norm() - radius, centre.norm() + radius];
            if self.open.iter().any(|gap| from < gap[1] && to > gap[0]) {
                return None;
            }
            let missing = self.missing_in_circle(centre, radius);
            // With a loss factor, roots left of the imaginary axis are not listed.
            let unlisted = self.hysteretic && centre.re < radius && missing > Some(0);
            (missing != Some(0) && !unlisted).then(|| {
                let hertz = centre / TAU;
                format!("{hertz:.6} Hz: {} listed, lacks {missing:?}", group.len())
            })
        })
    }

    /// A circle around a group, well within the gap to other roots, and no larger than the accuracy of the roots
    /// requires.
    fn circle(&self, group: &[usize]) -> (Complex64, f64) {
        const EXACT: f64 = 1e-7;
        let members = || group.iter().map(|&index| self.all[index]);
        let centre = members().sum::<Complex64>() / group.len() as f64;
        let distance = |root: Complex64| (root - centre).norm();
        let size = members().map(distance).fold(0.0, f64::max);
        let others = (0..self.all.len()).filter(|index| !group.contains(index));
        let gap = others.map(|index| distance(self.all[index]) - size);
        let margin = gap
            .map(|gap| 0.3 * gap)
            .fold(EXACT * centre.norm(), f64::min);
        (centre, size + margin)
    }

    fn fault_anywhere(&self) -> Option<String> {
        /// How far below the end of the range the region may end to avoid a root there.
        const ASIDE: f64 = 1e-5;
        let sizes = || self.all.iter().map(|root| root.norm());
        let free = |radius: &f64| sizes().all(|size| (size - radius).abs() > 0.3 * ASIDE * size);
        let mut outer = (0..).map(|k| self.to * (1.0 - ASIDE * f64::from(k)));
        let outer = outer.find(free)?;
        // Above the rounding error of this number of roots at 0.
        let small = 1e-16_f64.powf(1.0 / (self.at_zero + 4) as f64);
        let inner = small * sizes().fold(0.3 * self.to, f64::min);
        let mut rings = vec![[inner, outer]];
        for gap in &self.open {
            let Some([from, to]) = rings.pop() else { break };
            rings.extend([[from, gap[0].min(to)], [gap[1].max(from), to]]);
        }
        rings
            .into_iter()
            .filter(|[from, to]| from < to)
            .find_map(|ring| {
                let missing = if self.hysteretic {
                    self.missing_in_sector(ring)
                } else {
                    self.missing_in_ring(ring)
                };
                (missing != Some(0)).then(|| {
                    let [from, to] = ring.map(|radius| radius / TAU);
                    format!("{from:.6} to {to:.6} Hz: lacks {missing:?}")
                })
            })
    }

    /// Number of missing roots within a circle.
    fn missing_in_circle(&self, centre: Complex64, radius: f64) -> Option<i64> {
        let path = |t: f64| centre + Complex64::from_polar(radius, TAU * t);
        whole(self.turns(&path, 6)?)
    }

    /// Number of missing roots between two radii; the left half of the plane mirrors the right one.
    fn missing_in_ring(&self, [inner, outer]: [f64; 2]) -> Option<i64> {
        let half = |radius: f64| {
            let path = move |t: f64| Complex64::from_polar(radius, PI * t - FRAC_PI_2);
            self.turns(&path, 8 + self.density(radius))
        };
        whole(2.0 * (half(outer)? - half(inner)?))
    }

    /// Number of missing roots between two radii, from below the real axis to just before the imaginary one, beyond
    /// which there are others.
    fn missing_in_sector(&self, [inner, outer]: [f64; 2]) -> Option<i64> {
        const BELOW: f64 = -0.2;
        let clear = |aside: &f64| {
            let mut angles = self.all.iter().map(|root| FRAC_PI_2 - root.arg());
            angles.all(|a| (a - aside).abs() > 0.2 * aside)
        };
        let aside = (0..20).map(|k| 0.05 * 1.1_f64.powi(k)).find(clear)?;
        let angle = FRAC_PI_2 - aside;
        let arc = |radius: f64, from: f64, to: f64| {
            let path = move |t: f64| Complex64::from_polar(radius, from + t * (to - from));
            self.turns(&path, 8 + self.density(radius))
        };
        let ray = |angle: f64, from: f64, to: f64| {
            let path = move |t: f64| Complex64::from_polar(from * (to / from).powf(t), angle);
            let steps = 2.0 * (to / from).ln().abs();
            self.turns(&path, 8 + steps as usize + self.density(outer))
        };
        let outward = ray(BELOW, inner, outer)? + arc(outer, BELOW, angle)?;
        whole(outward + ray(angle, outer, inner)? + arc(inner, angle, BELOW)?)
    }

    /// Number of points for the waves along the beam.
    fn density(&self, radius: f64) -> usize {
        (0.25 * self.determinant.waves(radius)) as usize
    }

    /// The logarithm of the determinant over the distances to all roots of the list; its phase up to whole turns.
    fn log(&self, omega: Complex64) -> Complex64 {
        let roots: Complex64 = self.all.iter().map(|root| (omega - root).ln()).sum();
        self.determinant.at(omega).ln() - roots - self.at_zero as f64 * omega.ln()
    }

    /// How often the phase turns along a path of a parameter from 0 to 1; none if that is not certain. A step is halved
    /// where the logarithm's slope changes, which shows roots close to the path, also double ones.
    fn turns(&self, path: &dyn Fn(f64) -> Complex64, steps: usize) -> Option<f64> {
        const MOST: usize = 4000;
        let look = |t: f64| Look {
            t,
            log: self.log(path(t)),
        };
        // A short step first, so that the phase cannot make a whole turn within a step.
        let places = [0.0, 0.35].into_iter().chain((1..=steps).map(|k| k as f64));
        let mut looks: Vec<Look> = places.map(|k| look(k / steps as f64)).collect();
        while looks.len() < MOST {
            let rough = rough(&looks);
            if !rough.contains(&true) {
                let changes = looks.windows(2).map(|pair| change(pair[0], pair[1]).im);
                return Some(changes.sum::<f64>() / TAU);
            }
            let mut finer = vec![looks[0]];
            for (pair, rough) in looks.windows(2).zip(rough) {
                if rough {
                    finer.push(look(0.5 * (pair[0].t + pair[1].t)));
                }
                finer.push(pair[1]);
            }
            looks = finer;
        }
        None
    }
}

/// A point on a path and the logarithm there.
#[derive(Debug, Clone, Copy)]
struct Look {
    t: f64,
    log: Complex64,
}

/// The change of the logarithm, with the smaller change of phase.
fn change(from: Look, to: Look) -> Complex64 {
    let change = to.log - from.log;
    let turns = (change.im / TAU).round();
    change - Complex64::new(0.0, turns * TAU)
}

/// Which steps are too long.
fn rough(looks: &[Look]) -> Vec<bool> {
    const TURN: f64 = 0.8;
    const BEND: f64 = 0.5;
    let changes: Vec<(f64, Complex64)> = looks
        .windows(2)
        .map(|pair| (pair[1].t - pair[0].t, change(pair[0], pair[1])))
        .collect();
    let mut rough: Vec<bool> = changes.iter().map(|(_, by)| by.im.abs() > TURN).collect();
    for k in 1..changes.len() {
        let [(before, a), (after, b)] = [changes[k - 1], changes[k]];
        if (b / after - a / before).norm() * before.min(after) > BEND {
            rough[k - 1] |= before >= 0.5 * after;
            rough[k] |= after >= 0.5 * before;
        }
    }
    rough
}

/// The whole number of turns; none if the sum is not a whole number.
fn whole(turns: f64) -> Option<i64> {
    ((turns - turns.round()).abs() < 0.05).then(|| turns.round() as i64)
}

/// rad/s.
fn range(gap: &Gap) -> [f64; 2] {
    [TAU * gap.from, TAU * gap.to]
}

/// Groups of roots that are close together, by index; the first of each group is the lowest index.
fn groups(all: &[Complex64]) -> Vec<Vec<usize>> {
    const CLOSE: f64 = 1e-6;
    let mut left: Vec<usize> = (0..all.len()).rev().collect();
    let mut groups = Vec::new();
    while let Some(first) = left.pop() {
        let mut group = vec![first];
        let mut next = 0;
        while next < group.len() {
            let here = all[group[next]];
            let near = |index: &usize| (all[*index] - here).norm() < CLOSE * here.norm();
            group.extend(left.iter().copied().filter(near));
            left.retain(|index| !near(index));
            next += 1;
        }
        groups.push(group);
    }
    groups
}
