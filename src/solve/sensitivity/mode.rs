//! How a mode's frequency and damping move with the parameters.
//!
//! `d omega/dp = -phi^T (dD/dp) phi / phi^T (dD/d omega) phi` with the mode's motion phi (Lancaster, Numer. Math. 6 (1964)
//! 377-387). Beside its root the answer to any load is phi times 1 / distance and a rest that varies slowly: the
//! difference of the answers on both sides of the root is phi to the square of the distance.

use num_complex::Complex64;

use super::adjoint::without_loads;
use super::field::{Field, Setting};
use super::overlap::Spans;
use super::product::Product;
use super::{Differentiator, mass_stations};
use crate::model::Model;
use crate::solve::linear::ZERO;
use crate::solve::modes::{Mode, ModeKind, loads};
use crate::solve::plan::Plan;
use crate::solve::recursion::{Solution, Workspace};
use crate::solve::reflection::decay;
use crate::solve::waves::Waves;

/// Distance from the root, relative.
const BESIDE: f64 = 1e-9;

/// How a mode moves with each parameter, in the order of [`Differentiator::paths`].
#[derive(Debug, Clone, PartialEq)]
pub struct ModeGradient {
    /// Of [`Mode::frequency`], Hz per SI unit (of a phase: per degree).
    pub frequency: Vec<f64>,
    /// Of [`Mode::damping_ratio`], 1 per SI unit.
    pub damping_ratio: Vec<f64>,
}

impl Differentiator {
    /// The derivatives of a mode of this model.
    ///
    /// Where several modes share one root they part as a parameter moves; what is given is the derivative of their mean.
    /// A rigid-body mode stays at 0 Hz: all are 0, also for a spring of no stiffness, which would lift it with an
    /// infinite slope. The damping ratio of an overdamped mode stays 1.
    pub fn mode(&self, mode: &Mode) -> ModeGradient {
        let omega = match mode.kind {
            ModeKind::RigidBody => vec![ZERO; self.ids().len()],
            ModeKind::Oscillating | ModeKind::Overdamped => self.root(mode.omega),
        };
        let size = mode.omega.norm();
        let rate = |omega: &Complex64| match mode.kind {
            ModeKind::RigidBody => 0.0,
            ModeKind::Oscillating | ModeKind::Overdamped => (mode.omega.conj() * omega).re / size,
        };
        let damping = |omega: &Complex64| match mode.kind {
            ModeKind::RigidBody | ModeKind::Overdamped => 0.0,
            ModeKind::Oscillating => (omega.im - mode.damping_ratio() * rate(omega)) / size,
        };
        ModeGradient {
            frequency: omega
                .iter()
                .map(|w| rate(w) / std::f64::consts::TAU)
                .collect(),
            damping_ratio: omega.iter().map(damping).collect(),
        }
    }

    /// d omega/dp of a root, rad/s per SI unit: the mean over all modes that share it.
    fn root(&self, omega: Complex64) -> Vec<Complex64> {
        /// A share of an answer, squared, below which it is nothing new.
        const DEPENDENT: f64 = 1e-4;
        const MOST: usize = 12;
        let mut space: Vec<(Solution, Complex64)> = Vec::new();
        let mut sum = vec![ZERO; self.ids().len()];
        while space.len() < MOST {
            let loaded = Loaded::new(&self.model, space.len(), omega);
            let mut motion = loaded.motion();
            let all = loaded.form(&motion, &motion).1;
            for (other, norm) in &space {
                let share = loaded.form(other, &motion).1 / norm;
                add(&mut motion, other, -share);
            }
            let (product, norm) = loaded.form(&motion, &motion);
            if !space.is_empty() && norm.norm() < DEPENDENT * all.norm() {
                break;
            }
            for (sum, by) in sum.iter_mut().zip(&product) {
                *sum -= by / norm;
            }
            space.push((motion, norm));
        }
        let count = space.len() as f64;
        sum.iter().map(|sum| sum / count).collect()
    }
}

/// A model under one of some loads that reach everything, beside a root.
struct Loaded {
    model: Model,
    plan: Plan,
    bare: Plan,
    masses: Vec<usize>,
    omega: Complex64,
}

impl Loaded {
    fn new(model: &Model, load: usize, omega: Complex64) -> Self {
        let model = Model {
            forces: loads(model, load),
            responses: Vec::new(),
            ..model.clone()
        };
        let plan = Plan::new(&model);
        Self {
            masses: mass_stations(&model, &plan),
            bare: without_loads(&plan),
            model,
            plan,
            omega,
        }
    }

    /// The difference of the answers on both sides of the root, as a motion at the root.
    fn motion(&self) -> Solution {
        let answer = |side: f64| {
            Workspace::default().solution(&self.plan, self.omega * (1.0 + side * BESIDE))
        };
        let mut motion = answer(1.0);
        add(&mut motion, &answer(-1.0), -Complex64::ONE);
        motion.waves = Waves::new(&self.plan.beam, self.omega);
        let lengths = self.plan.lengths.iter();
        motion.decays = lengths.map(|&l| decay(&motion.waves, l)).collect();
        motion
    }

    /// `-phi^T (dD/dp) chi` for every parameter, and `-phi^T (dD/d omega) chi`.
    fn form(&self, phi: &Solution, chi: &Solution) -> (Vec<Complex64>, Complex64) {
        let setting = Setting {
            model: &self.model,
            plan: &self.bare,
            masses: &self.masses,
            omega: self.omega,
        };
        let [lambda, u] = [phi, chi].map(|motion| Field::new(&setting, motion));
        let spans = Spans::new(&self.bare, phi);
        let product = Product {
            setting,
            lambda: &lambda,
            u: &u,
            overlap: spans.overlap(&self.bare, &phi.waves, [&phi.spans, &chi.spans]),
        };
        let none = [ZERO; 6];
        (product.by_parameter([&none, &none]), product.by_omega())
    }
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
    let unknowns = to.unknowns.iter_mut().flatten();
    for (to, other) in unknowns.zip(other.unknowns.iter().flatten()) {
        *to += factor * other;
    }
}
