//! The derivatives of a mode's frequency and damping by the parameters.
//!
//! `d omega/dp = -phi^T (dD/dp) phi / phi^T (dD/d omega) phi` with the mode's motion phi (Lancaster, Numer. Math. 6
//! (1964) 377-387). For modes that share one root the derivatives are the eigenvalues of the pencil of these products
//! between all of them (Friswell, J. Vib. Acoust. 118 (1996) 390-397). Near its root the response to a load that
//! excites no other mode of the group is phi times 1 / distance plus a remainder that varies slowly: the difference of
//! the responses on both sides of the root, at two distances, gives phi with an error of the fourth power of the
//! distance.

use nalgebra::DMatrix;
use num_complex::Complex64;

use super::Differentiator;
use super::adjoint::without_loads;
use super::field::{Field, Setting};
use super::overlap::Spans;
use super::product::Product;
use crate::model::{Force, Model, ParameterId};
use crate::solve::beam_state::BeamState;
use crate::solve::kernel::{Prepared, waves};
use crate::solve::linear::ZERO;
use crate::solve::modes::{Group, ModeKind, Modes, eigenvalues};
use crate::solve::plan::Plan;
use crate::solve::solution::Solution;

/// Distance from the root, as a fraction of that to the next root outside the group.
const ASIDE: f64 = 1e-3;

/// Roots closer than this (relative) count as equal.
const EQUAL: f64 = 1e-11;

/// The derivatives of a mode by each parameter, in the order of [`Differentiator::ids`].
#[derive(Debug, Clone, PartialEq)]
pub struct ModeGradient {
    /// Of [`crate::solve::modes::Mode::frequency`], Hz per SI unit (of a phase: per degree).
    pub frequency: Vec<f64>,
    /// Of [`crate::solve::modes::Mode::damping_ratio`], 1 per SI unit.
    pub damping_ratio: Vec<f64>,
}

impl Differentiator {
    /// The derivatives of the mode `index` of this model's modes, which must exist.
    ///
    /// Modes that share one root separate when a parameter changes. If its magnitude increases (away from 0), the k-th
    /// of them in the list stays the k-th by frequency: it has the k-th derivative of the frequency, by ascending
    /// value. If it decreases, they separate in the opposite order, with the same derivatives. Modes with close but
    /// different roots have their own derivatives.
    ///
    /// A rigid-body mode stays at 0 Hz: all its derivatives are 0, also for a spring without stiffness, which would
    /// raise it with an infinite slope. The damping ratio of an overdamped mode stays 1. For an erroneous entry of an
    /// open list the derivatives are meaningless, or NaN.
    pub fn mode(&self, modes: &Modes, index: usize) -> ModeGradient {
        let mode = &modes.modes[index];
        if mode.kind == ModeKind::RigidBody {
            let none = vec![0.0; self.ids().len()];
            return ModeGradient {
                frequency: none.clone(),
                damping_ratio: none,
            };
        }
        let size = mode.omega.norm();
        let rate = |shift: &Complex64| (mode.omega.conj() * shift).re / size;
        let damping = |shift: &Complex64| match mode.kind {
            ModeKind::Oscillating => (shift.im - mode.damping_ratio() * rate(shift)) / size,
            ModeKind::RigidBody | ModeKind::Overdamped => 0.0,
        };
        let shifts = self.shifts(modes, index);
        ModeGradient {
            frequency: shifts
                .iter()
                .map(|shift| rate(shift) / std::f64::consts::TAU)
                .collect(),
            damping_ratio: shifts.iter().map(damping).collect(),
        }
    }

    /// d omega/dp of a mode, rad/s per SI unit.
    fn shifts(&self, modes: &Modes, index: usize) -> Vec<Complex64> {
        let omega = modes.modes[index].omega;
        let group = Group::of(&self.model, modes, index);
        let Some(loads) = group.isolating_loads(&self.model) else {
            return vec![UNKNOWN; self.ids().len()];
        };
        let is_equal = |root: usize| (group.roots[root] - omega).norm() < EQUAL * omega.norm();
        let equal = || group.members.iter().filter(|(_, root)| is_equal(*root));
        let place = equal().position(|(of, _)| *of == index);
        let aside = ASIDE * group.gap.min(0.1 * omega.norm());
        let motions: Vec<Loaded> = equal()
            .map(|(_, root)| Loaded::new(&self.model, loads[*root].clone(), omega, aside))
            .collect();
        let forms: Vec<Vec<Form>> = (0..motions.len())
            .map(|i| {
                (0..=i)
                    .map(|j| motions[i].form(&motions[j], self.ids()))
                    .collect()
            })
            .collect();
        let matrix = |entry: &dyn Fn(&Form) -> Complex64| {
            DMatrix::from_fn(motions.len(), motions.len(), |i, j| {
                entry(&forms[i.max(j)][i.min(j)])
            })
        };
        let by_parameter = |parameter: usize| {
            // Forces are last: no mode depends on them.
            matrix(&|form| form.by_parameter.get(parameter).map_or(ZERO, |by| -by))
        };
        let parameters = 0..self.ids().len();
        let by_parameter: Vec<_> = parameters.map(by_parameter).collect();
        let Some(all) = separated(&matrix(&|form| form.by_omega), &by_parameter) else {
            return vec![UNKNOWN; self.ids().len()];
        };
        let shift = |(shifts, value): (Option<Vec<Complex64>>, &f64)| {
            let mut shifts = sorted(shifts?, omega);
            if *value < 0.0 {
                shifts.reverse();
            }
            shifts.get(place?).copied()
        };
        let all = all.into_iter().zip(self.values());
        all.map(|of| shift(of).unwrap_or(UNKNOWN)).collect()
    }
}

/// The eigenvalues of `second y = t first y` for each `second`; NaN if the computation fails.
fn separated(
    first: &DMatrix<Complex64>,
    seconds: &[DMatrix<Complex64>],
) -> Option<Vec<Option<Vec<Complex64>>>> {
    if first.len() > 1 {
        return eigenvalues(first, seconds);
    }
    // Also if it is infinite.
    let alone = |second: &DMatrix<Complex64>| Some(vec![second[(0, 0)] / first[(0, 0)]]);
    Some(seconds.iter().map(alone).collect())
}

/// Orders derivatives of roots at `omega` by that of the frequency, then by that of the decay.
fn sorted(mut shifts: Vec<Complex64>, omega: Complex64) -> Vec<Complex64> {
    const ROUNDING: f64 = 1e-9;
    let largest = shifts.iter().map(|shift| shift.norm()).fold(0.0, f64::max);
    let steps = |rate: f64| (rate / (ROUNDING * largest)).round();
    let rate = |shift: &Complex64| steps((omega.conj() * shift).re / omega.norm());
    shifts.sort_by(|a, b| {
        let by_frequency = rate(a).total_cmp(&rate(b));
        by_frequency.then(a.im.total_cmp(&b.im))
    });
    shifts
}

/// NaN: an unknown derivative.
const UNKNOWN: Complex64 = Complex64::new(f64::NAN, f64::NAN);

/// Products of two motions.
struct Form {
    /// `-phi^T (dD/dp) chi` for every parameter.
    by_parameter: Vec<Complex64>,
    /// `-phi^T (dD/d omega) chi`.
    by_omega: Complex64,
}

/// A mode's motion from a load that excites no other mode near it.
struct Loaded {
    model: Model,
    bare: Plan,
    masses: Vec<usize>,
    omega: Complex64,
    motion: Solution,
}

impl Loaded {
    /// For a model at a root under some forces; `aside` is the distance of the nearer responses from it, rad/s.
    fn new(model: &Model, forces: Vec<Force>, omega: Complex64, aside: f64) -> Self {
        let model = Model {
            forces,
            responses: Vec::new(),
            ..model.clone()
        };
        let plan = Plan::new(&model);
        Self {
            masses: plan.mass_stations(&model),
            bare: without_loads(&plan),
            motion: motion(&Prepared::whole(plan), omega, aside / omega.norm()),
            model,
            omega,
        }
    }

    /// The products of this motion and another one at the same root.
    fn form(&self, other: &Self, ids: &[ParameterId]) -> Form {
        let setting = Setting {
            model: &self.model,
            plan: &self.bare,
            masses: &self.masses,
            omega: self.omega,
        };
        let [phi, chi] = [self, other].map(|one| &one.motion);
        let [lambda, u] = [phi, chi].map(|motion| Field::new(&setting, motion));
        let spans = Spans::new(&self.bare, phi);
        let product = Product {
            setting,
            lambda: &lambda,
            u: &u,
            overlaps: spans.overlaps(&self.bare, &phi.waves, [&phi.spans, &chi.spans]),
        };
        Form {
            by_parameter: product.by_parameter(ids, [&BeamState::ZERO; 2]),
            by_omega: product.by_omega(),
        }
    }
}

/// The residue of the responses at a root as a motion there, times a number; `aside` is a relative distance.
///
/// The points are on the ray through the root, along which no wave changes its direction. With
/// `u = phi / distance + r0 + r1 distance + ...` the weights cancel all terms except phi and those of the fourth order.
fn motion(prepared: &Prepared, omega: Complex64, aside: f64) -> Solution {
    let plan = &prepared.plan;
    let answer = |side: f64| prepared.solution(omega * (1.0 + side * aside));
    let mut motion = answer(1.0);
    for (side, weight) in [(-1.0, -1.0), (2.0, -0.5), (-2.0, 0.5)] {
        add(&mut motion, &answer(side), weight.into());
    }
    motion.waves = plan.beams.iter().map(|beam| waves(beam, omega)).collect();
    let kinds = plan.kinds.iter();
    let decays = kinds.map(|kind| motion.waves[kind.beam].decay(kind.length));
    motion.decays = decays.collect();
    motion
}

/// Adds a solution of the same plan times a factor.
fn add(to: &mut Solution, other: &Solution, factor: Complex64) {
    let spans = to.spans.iter_mut().zip(&other.spans);
    for (to, other) in spans {
        let waves = to.a.iter_mut().chain(&mut to.b);
        for (to, other) in waves.zip(other.a.iter().chain(&other.b)) {
            *to += factor * other;
        }
    }
    for (to, other) in to.masses.iter_mut().zip(&other.masses) {
        for index in 0..3 {
            to.forces[index] += factor * other.forces[index];
            to.motion[index] += factor * other.motion[index];
        }
    }
}
