//! The modes at frequency 0: motions of the beam and the masses that stretch no spring.

use nalgebra::{DMatrix, SMatrix, SVector, SymmetricEigen};
use num_complex::Complex64;

use super::station::{Mass, Restrained};
use crate::model::{Beam, BeamMotion, Bedding, Elastic, Model, Spring, Subsystem};
use crate::solve::beam_matrices::BeamMatrices;

/// A motion at frequency 0.
#[derive(Debug, Clone)]
pub(super) struct RigidMotion {
    /// (w, psi, v, w', v') at the left end.
    beam: SVector<f64, 5>,
    /// (y, z, theta) of each enabled subsystem.
    pub(super) masses: Vec<[f64; 3]>,
}

/// The modes at frequency 0: motions of the rigid beam and the masses that stretch no spring.
pub(super) fn count(supports: &[Restrained], masses: &[Mass], beam: &Beam) -> usize {
    let loose: usize = masses.iter().map(|mass| mass.condensed_static().1).sum();
    loose + still(&stiffness(supports, masses, beam)).len()
}

/// The modes at frequency 0 of a model, of modal mass 1 and orthogonal.
pub(super) fn motions(model: &Model) -> Vec<RigidMotion> {
    let warps = model.beam.section.warping_constant > 0.0;
    let supports = Restrained::all(model, warps);
    let masses: Vec<Mass> = model.attached().map(Mass::new).collect();
    let of_beam = still(&stiffness(&supports, &masses, &model.beam));
    let mut motions: Vec<RigidMotion> = of_beam
        .into_iter()
        .map(|beam| RigidMotion {
            masses: masses
                .iter()
                .map(|mass| mass.following(&moved(&beam, mass.position)))
                .collect(),
            beam,
        })
        .collect();
    for (index, mass) in masses.iter().enumerate() {
        for loose in mass.loose() {
            let mut motion = RigidMotion {
                beam: SVector::zeros(),
                masses: vec![[0.0; 3]; masses.len()],
            };
            motion.masses[index] = loose;
            motions.push(motion);
        }
    }
    orthonormal(model, &supports, motions)
}

/// The number of roots at frequency 0 (two for each mode without damping) that dampers move away, to rates above
/// `least`, 1/s: slower ones are rounding.
pub(super) fn crept(model: &Model, least: f64) -> usize {
    const RESOLVED: f64 = 1e-10;
    let motions = motions(model);
    if motions.is_empty() {
        return 0;
    }
    // Dampers instead of springs.
    let in_place = |spring: Spring| Spring {
        stiffness: spring.damping,
        ..Spring::default()
    };
    let dampers: Vec<Mass> = model
        .attached()
        .map(|subsystem| {
            Mass::new(&Subsystem {
                y_left: in_place(subsystem.y_left),
                y_right: in_place(subsystem.y_right),
                z_left: in_place(subsystem.z_left),
                z_right: in_place(subsystem.z_right),
                // Its stiffness must not be added as an inertia.
                inertia: 1.0,
                ..subsystem.clone()
            })
        })
        .collect();
    let supports = Restrained::all(model, model.beam.section.warping_constant > 0.0);
    let bedding = on_foundation(&model.beam, |bedding| bedding.damping);
    // The damping of each pair, and the magnitude of its terms: a sum that cancels counts as 0.
    let term = |i: usize, j: usize| {
        let (a, b) = (&motions[i], &motions[j]);
        let of_masses = dampers.iter().enumerate().map(|(index, mass)| {
            let (a, b) = (mass.stretched(a, index), mass.stretched(b, index));
            let sum = a.dot(&(mass.stiffness * b));
            [sum, a.abs().dot(&(mass.stiffness.abs() * b.abs()))]
        });
        let of_supports = supports
            .iter()
            .flat_map(held_motions)
            .map(|(_, row, elastic)| {
                let sum = elastic.damping * row.dot(&a.beam) * row.dot(&b.beam);
                [sum, sum.abs()]
            });
        let add = |[sum, size]: [f64; 2], [more, its]: [f64; 2]| [sum + more, size + its];
        let bedded = (a.beam.transpose() * bedding * b.beam)[(0, 0)];
        of_masses
            .chain(of_supports)
            .chain([[bedded, bedded.abs()]])
            .fold([0.0; 2], add)
    };
    let count = motions.len();
    let damping = DMatrix::from_fn(count, count, |i, j| term(i, j)[0]);
    let largest = (0..count).map(|i| term(i, i)[1]).fold(0.0, f64::max);
    let values = SymmetricEigen::new(damping).eigenvalues;
    values
        .iter()
        .filter(|&&value| value > RESOLVED * largest && value > least)
        .count()
}

impl RigidMotion {
    /// (w, psi, v) at x.
    pub(super) fn at(&self, x: f64) -> [f64; 3] {
        let [w, psi, v, ..] = rigid_motions(x).map(|row| row.dot(&self.beam));
        [w, psi, v]
    }

    /// The six motions of the beam at x.
    pub(super) fn all_at(&self, x: f64) -> [f64; 6] {
        rigid_motions(x).map(|row| row.dot(&self.beam))
    }

    fn add(&mut self, other: &Self, factor: f64) {
        self.beam += factor * other.beam;
        let own = self.masses.iter_mut().flatten();
        for (own, other) in own.zip(other.masses.iter().flatten()) {
            *own += factor * other;
        }
    }
}

/// Makes motions mass-orthogonal, each of modal mass 1; twice, to remove rounding errors.
fn orthonormal(
    model: &Model,
    supports: &[Restrained],
    motions: Vec<RigidMotion>,
) -> Vec<RigidMotion> {
    let mut done: Vec<RigidMotion> = Vec::new();
    for mut motion in motions {
        for _ in 0..2 {
            for other in &done {
                let share = mass(model, supports, other, &motion);
                motion.add(other, -share);
            }
            let norm = mass(model, supports, &motion, &motion).sqrt();
            let copy = motion.clone();
            motion.add(&copy, norm.recip() - 1.0);
        }
        done.push(motion);
    }
    done
}

/// `a^T M b`, closed form along the beam.
fn mass(model: &Model, supports: &[Restrained], a: &RigidMotion, b: &RigidMotion) -> f64 {
    let length = model.beam.length;
    let matrices = BeamMatrices::new(&model.beam);
    let density = |x: f64| {
        let [a, b] = [a, b].map(|motion| motion.all_at(x).map(Complex64::from));
        matrices.inertia(&a, &b).re
    };
    // Simpson's rule is exact for the product of two straight lines.
    let mean = (density(0.0) + 4.0 * density(0.5 * length) + density(length)) / 6.0;
    let mut sum = length * mean;
    for (_, row, elastic) in supports.iter().flat_map(held_motions) {
        sum += elastic.inertia * row.dot(&a.beam) * row.dot(&b.beam);
    }
    for (subsystem, (p, q)) in model.attached().zip(a.masses.iter().zip(&b.masses)) {
        sum += subsystem.mass * (p[0] * q[0] + p[1] * q[1]) + subsystem.inertia * p[2] * q[2];
    }
    sum
}

/// (w, psi, v) at x.
fn moved(beam: &SVector<f64, 5>, x: f64) -> [f64; 3] {
    let [w, psi, v, ..] = rigid_motions(x).map(|row| row.dot(beam));
    [w, psi, v]
}

/// The stiffness over (w, psi, v, w', v') of a rigid beam at its left end, while its masses follow.
///
/// An axial force resists a slope, or turns the beam further; both are no motion at frequency 0.
fn stiffness(supports: &[Restrained], masses: &[Mass], beam: &Beam) -> SMatrix<f64, 5, 5> {
    // A rigid beam has no rate of twist.
    let mut rigid = SMatrix::<f64, 5, 5>::zeros();
    for slope in [3, 4] {
        rigid[(slope, slope)] = beam.axial_force.abs() * beam.length;
    }
    rigid += on_foundation(beam, |bedding| bedding.stiffness);
    let held = held_stiffness(supports, masses);
    for restrained in supports {
        for (motion, row, elastic) in held_motions(restrained) {
            let stiffness = if restrained.is_fixed(motion) {
                held
            } else {
                elastic.stiffness
            };
            rigid += stiffness * row * row.transpose();
        }
    }
    for mass in masses {
        let (condensed, _) = mass.condensed_static();
        let motions = rigid_motions(mass.position);
        for row in 0..3 {
            for column in 0..3 {
                rigid += condensed[(row, column)] * motions[row] * motions[column].transpose();
            }
        }
    }
    rigid
}

/// The springs, or the dampers, of the foundation under a rigid beam.
fn on_foundation(beam: &Beam, of: fn(&Bedding) -> f64) -> SMatrix<f64, 5, 5> {
    let mut sum = SMatrix::zeros();
    // Simpson's rule is exact for the product of two straight lines.
    for (x, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
        let rows = rigid_motions(x * beam.length);
        for (row, bedding) in rows.iter().zip(beam.foundation.beddings()) {
            sum += of(&bedding) * weight * beam.length / 6.0 * row * row.transpose();
        }
    }
    sum
}

/// A stiffness as large as any of the model: it makes sure that a fixed motion is not a mode at frequency 0.
fn held_stiffness(supports: &[Restrained], masses: &[Mass]) -> f64 {
    let rows = supports.iter().flat_map(Restrained::rows);
    let springs = rows.map(|(_, _, elastic)| elastic.stiffness);
    let masses = masses.iter().map(|mass| mass.stiffness.amax());
    springs.chain(masses).fold(1.0, f64::max)
}

/// The motions of the point that a support holds, each with its spring and inertia, as functions of (w, psi, v, w', v') of
/// a rigid beam at its left end.
fn held_motions(
    restrained: &Restrained,
) -> impl Iterator<Item = (BeamMotion, SVector<f64, 5>, Elastic)> {
    let rows = rigid_motions(restrained.position);
    restrained.rows().map(move |(motion, row, elastic)| {
        let shares = rows.iter().zip(&row);
        (
            motion,
            shares.map(|(motion, share)| motion * *share).sum(),
            elastic,
        )
    })
}

/// w, psi, v and their slopes at x, as functions of (w, psi, v, w', v') of a rigid beam at its left end.
fn rigid_motions(x: f64) -> [SMatrix<f64, 5, 1>; 6] {
    [
        [1.0, 0.0, 0.0, x, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, x],
        [0.0, 0.0, 0.0, 1.0, 0.0],
        [0.0; 5],
        [0.0, 0.0, 0.0, 0.0, 1.0],
    ]
    .map(SMatrix::<f64, 5, 1>::from)
}

/// The null space of a positive semidefinite stiffness, each motion in its own unit.
fn still(stiffness: &SMatrix<f64, 5, 5>) -> Vec<SVector<f64, 5>> {
    const RESOLVED: f64 = 1e-11;
    let scale = SVector::<f64, 5>::from_fn(|index, _| {
        let diagonal = stiffness[(index, index)];
        if diagonal > 0.0 {
            diagonal.sqrt().recip()
        } else {
            1.0
        }
    });
    let scaled = SMatrix::<f64, 5, 5>::from_fn(|i, j| stiffness[(i, j)] * scale[i] * scale[j]);
    let eigen = SymmetricEigen::new(scaled);
    let pairs = eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter());
    pairs
        .filter(|(value, _)| **value <= RESOLVED)
        .map(|(_, vector)| vector.component_mul(&scale))
        .collect()
}
