//! The motion of one mode, or of some that lie close together, from forced responses beside their frequency.
//!
//! Beside a root the answer to any load is the mode, but for a share that is as small as the distance; the answers to
//! as many loads as roots lie close together span their modes. In this span the roots and modes are those of a small
//! eigenvalue problem: with answers U to loads F, `U^T K U = F^T U` and `U^T K' U` with
//! `-K' = 2 omega M - i C` give `(F^T U) y = delta (2 omega U^T M U - i U^T C U) y` for the roots `omega + delta`
//! (Rayleigh-Ritz; for the bi-orthogonality of damped modes see Foss, J. Appl. Mech. 25 (1958) 361-364).

use nalgebra::{DMatrix, DVector, Schur};
use num_complex::Complex64;

use super::motion::{Motion, combined, stretches};
use super::quadrature::{Sample, samples};
use crate::model::{
    BeamMotion, Force, MassMotion, Measure, Model, Place, Quantity, Response, Target,
};
use crate::solve::plan::Plan;
use crate::solve::recursion::Workspace;

/// Modes that lie close together.
#[derive(Debug, Clone)]
pub(super) struct Eigenspace {
    /// The roots, rad/s, by rising |omega|.
    pub(super) roots: Vec<Complex64>,
    /// The motion of each, normalised to `phi^T (2 omega M - i C) phi = 2 omega`.
    pub(super) motions: Vec<Motion>,
}

/// A model with the places where its motion is read.
#[derive(Debug, Clone)]
pub(super) struct Probe<'a> {
    model: &'a Model,
    /// Places to look at, m.
    looked_at: Vec<f64>,
    /// Places and weights of the integrals along the beam.
    pub(super) samples: Vec<Sample>,
}

impl<'a> Probe<'a> {
    /// For modes near `omega`, rad/s.
    pub(super) fn new(model: &'a Model, omega: Complex64, looked_at: Vec<f64>) -> Self {
        Self {
            model,
            looked_at,
            samples: samples(model, omega),
        }
    }

    /// The `count` modes nearest to `omega` (rad/s), which itself is no root.
    pub(super) fn eigenspace(&self, omega: Complex64, count: usize) -> Eigenspace {
        let loaded: Vec<(Motion, DVector<Complex64>)> = (0..count)
            .map(|load| self.answer(omega, load, count))
            .collect();
        let answers: Vec<&Motion> = loaded.iter().map(|(motion, _)| motion).collect();
        let form = |i: usize, j: usize| self.form(omega, answers[i], answers[j]);
        let inertia = DMatrix::from_fn(count, count, form);
        let work = DMatrix::from_fn(count, count, |i, j| loaded[j].1[i]);
        let (values, vectors) = eigen(&inertia, &work);
        let mut order: Vec<usize> = (0..count).collect();
        let root = |index: usize| omega + values[index];
        order.sort_by(|&a, &b| root(a).norm().total_cmp(&root(b).norm()));
        let mut motions: Vec<Motion> = Vec::new();
        for &index in &order {
            let mut motion = combined(&answers, &vectors[index]);
            // Modes at one frequency are any; make them orthogonal. Others are already.
            for other in &motions {
                let share = self.form(omega, other, &motion) / self.form(omega, other, other);
                motion.add(other, -share);
            }
            let norm = (self.form(omega, &motion, &motion) / (2.0 * omega)).sqrt();
            motions.push(motion.times(norm.inv()));
        }
        Eigenspace {
            roots: order.into_iter().map(root).collect(),
            motions,
        }
    }

    /// The answer to one of some loads that reach everything, and the work of every load on it.
    fn answer(&self, omega: Complex64, load: usize, count: usize) -> (Motion, DVector<Complex64>) {
        let forces = loads(self.model, load);
        let mut responses = self.responses();
        let motions = responses.len();
        responses.extend(forces.iter().map(|force| response(force.target.clone())));
        let plan = Plan::new(&Model {
            forces: forces.clone(),
            responses,
            ..self.model.clone()
        });
        let mut values = vec![Complex64::ZERO; plan.outputs.len()];
        Workspace::default().solve(&plan, omega, &mut values);
        let moved = &values[motions..];
        let work = DVector::from_fn(count, |other, _| {
            let others = loads(self.model, other);
            others
                .iter()
                .zip(moved)
                .map(|(force, moved)| force.amplitude * moved)
                .sum()
        });
        (self.motion(&values[..motions]), work)
    }

    /// What is read, in the order of [`Self::motion`].
    fn responses(&self) -> Vec<Response> {
        let mut targets = Vec::new();
        let places = self
            .looked_at
            .iter()
            .copied()
            .chain(self.samples.iter().map(|s| s.position));
        let mounts = self.model.attached().map(|subsystem| subsystem.position);
        for x in places.chain(mounts) {
            targets.extend(DISPLACEMENTS.map(|motion| Target::Beam(Place::Position(x), motion)));
        }
        for place in [Place::Left, Place::Right] {
            targets.extend(BeamMotion::ALL.map(|motion| Target::Beam(place, motion)));
        }
        for subsystem in self.model.attached() {
            let of = |motion| Target::Mass(subsystem.name.clone(), motion);
            targets.extend(MassMotion::ALL.map(of));
        }
        targets.into_iter().map(response).collect()
    }

    fn motion(&self, values: &[Complex64]) -> Motion {
        let triples = |values: &[Complex64]| -> Vec<[Complex64; 3]> {
            values
                .chunks_exact(3)
                .map(|chunk| [chunk[0], chunk[1], chunk[2]])
                .collect()
        };
        let (beam, rest) = values.split_at(3 * (self.looked_at.len() + self.samples.len()));
        let (mounts, rest) = rest.split_at(3 * self.model.attached().count());
        let (ends, masses) = rest.split_at(12);
        Motion {
            beam: triples(beam),
            ends: [
                std::array::from_fn(|row| ends[row]),
                std::array::from_fn(|row| ends[6 + row]),
            ],
            masses: triples(masses),
            mounts: triples(mounts),
        }
    }

    /// `a^T (2 omega M - i C) b`.
    fn form(&self, omega: Complex64, a: &Motion, b: &Motion) -> Complex64 {
        let mut mass = self.mass_of_beam(a, b);
        let mut damping = Complex64::ZERO;
        for (index, subsystem) in self.model.attached().enumerate() {
            let (p, q) = (&a.masses[index], &b.masses[index]);
            mass += subsystem.mass * (p[0] * q[0] + p[1] * q[1]) + subsystem.inertia * p[2] * q[2];
            let stretch = |motion: &Motion| {
                stretches(subsystem, &motion.masses[index], &motion.mounts[index])
            };
            let dampers = [
                subsystem.y_left,
                subsystem.y_right,
                subsystem.z_left,
                subsystem.z_right,
            ];
            for (spring, (s, t)) in dampers.iter().zip(stretch(a).iter().zip(stretch(b))) {
                damping += spring.damping * s * t;
            }
        }
        let supports = [&self.model.supports.left, &self.model.supports.right];
        for (support, (p, q)) in supports.iter().zip(a.ends.iter().zip(&b.ends)) {
            for motion in BeamMotion::ALL {
                let elastic = support[motion].elastic();
                let product = p[motion as usize] * q[motion as usize];
                mass += elastic.inertia * product;
                damping += elastic.damping * product;
            }
        }
        2.0 * omega * mass - Complex64::I * damping
    }

    /// `a^T M b` of the beam alone.
    fn mass_of_beam(&self, a: &Motion, b: &Motion) -> Complex64 {
        let (material, section) = (&self.model.beam.material, &self.model.beam.section);
        let polar = section.polar_moment / section.area;
        let first = self.looked_at.len();
        let motions = a.beam[first..].iter().zip(&b.beam[first..]);
        let shares = self.samples.iter().zip(motions).map(|(sample, (p, q))| {
            let coupled = section.centroid_offset * (p[0] * q[1] + p[1] * q[0]);
            let density = p[0] * q[0] + p[2] * q[2] + polar * p[1] * q[1] + coupled;
            sample.weight * material.density * section.area * density
        });
        shares.sum()
    }
}

/// Loads at some places of the beam and on every mass, in no simple ratio to each other.
pub(in crate::solve) fn loads(model: &Model, load: usize) -> Vec<Force> {
    const PLACES: [f64; 5] = [0.0, 0.217, 0.471, 0.738, 1.0];
    let section = &model.beam.section;
    let radius = (section.polar_moment / section.area).sqrt();
    let mut targets: Vec<(Target, f64)> = Vec::new();
    for share in PLACES {
        let place = Place::Position(share * model.beam.length);
        for (motion, arm) in [
            (BeamMotion::W, 1.0),
            (BeamMotion::Psi, radius),
            (BeamMotion::V, 1.0),
        ] {
            targets.push((Target::Beam(place, motion), arm));
        }
    }
    for subsystem in model.attached() {
        let turn = (subsystem.inertia / subsystem.mass).sqrt();
        for (motion, arm) in [
            (MassMotion::Y, 1.0),
            (MassMotion::Z, 1.0),
            (MassMotion::Theta, turn),
        ] {
            targets.push((Target::Mass(subsystem.name.clone(), motion), arm));
        }
    }
    let uneven = |index: usize| (12.989_8 * (index + 1) as f64 + 78.233 * (load + 1) as f64).sin();
    targets
        .into_iter()
        .enumerate()
        .map(|(index, (target, arm))| Force {
            enabled: true,
            target,
            amplitude: arm * uneven(index),
            phase: 0.0,
        })
        .collect()
}

const DISPLACEMENTS: [BeamMotion; 3] = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V];

fn response(target: Target) -> Response {
    Response {
        name: String::new(),
        enabled: true,
        quantity: Quantity::Motion(target, Measure::Displacement),
    }
}

/// Values delta and vectors y of `work y = delta inertia y`.
fn eigen(
    inertia: &DMatrix<Complex64>,
    work: &DMatrix<Complex64>,
) -> (Vec<Complex64>, Vec<DVector<Complex64>>) {
    let count = inertia.nrows();
    let Some(matrix) = inertia.clone().lu().solve(work) else {
        // Loads that reach nothing: no motion.
        return (
            vec![Complex64::ZERO; count],
            vec![DVector::zeros(count); count],
        );
    };
    let (q, t) = Schur::new(matrix).unpack();
    let values: Vec<Complex64> = t.diagonal().iter().copied().collect();
    let vectors = (0..count)
        .map(|index| &q * triangular_vector(&t, index))
        .collect();
    (values, vectors)
}

/// The eigenvector of an upper triangle for its diagonal entry `index`.
fn triangular_vector(t: &DMatrix<Complex64>, index: usize) -> DVector<Complex64> {
    let mut x = DVector::zeros(t.nrows());
    x[index] = Complex64::ONE;
    let negligible = 1e-13 * t.norm();
    for row in (0..index).rev() {
        let sum: Complex64 = (row + 1..=index).map(|k| t[(row, k)] * x[k]).sum();
        let gap = t[(row, row)] - t[(index, index)];
        x[row] = if gap.norm() <= negligible {
            Complex64::ZERO
        } else {
            -sum / gap
        };
    }
    x
}
