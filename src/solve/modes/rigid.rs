//! The modes at frequency 0: motions of the beam and the masses that stretch no spring.

use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen};
use num_complex::Complex64;

use super::station::{Cut, Mass, Restrained};
use crate::model::{BeamMotion, Bedding, Elastic, Model, Spring, Subsystem, UniformPart};
use crate::solve::beam_matrices::BeamMatrices;

/// The coordinates of a beam whose parts between its joints are rigid: (w, psi, v, w', v') at the left end, then the jump of
/// each motion that a joint releases. A rigid part has no rate of twist.
#[derive(Debug, Clone)]
struct Coordinates {
    /// The uniform parts of the beam.
    parts: Vec<UniformPart>,
    jumps: Vec<Jump>,
}

/// The jump of a motion over a joint, right minus left.
#[derive(Debug, Clone)]
struct Jump {
    position: f64,
    motion: BeamMotion,
    spring: Spring,
}

/// A motion at frequency 0.
#[derive(Debug, Clone)]
pub(super) struct RigidMotion {
    coordinates: Coordinates,
    /// The values of the coordinates.
    beam: DVector<f64>,
    /// (y, z, theta) of each enabled subsystem.
    pub(super) masses: Vec<[f64; 3]>,
}

/// The modes at frequency 0: motions of the rigid beam and the masses that stretch no spring.
pub(super) fn count(
    supports: &[Restrained],
    cuts: &[Cut],
    masses: &[Mass],
    parts: Vec<UniformPart>,
) -> usize {
    let coordinates = Coordinates::new(cuts, parts);
    let loose: usize = masses.iter().map(|mass| mass.condensed_static().1).sum();
    loose + still(&coordinates.stiffness(supports, masses)).len()
}

/// The modes at frequency 0 of a model, of modal mass 1 and orthogonal.
pub(super) fn motions(model: &Model) -> Vec<RigidMotion> {
    let parts = model.uniform_parts();
    let supports = Restrained::all(model, &parts);
    let masses: Vec<Mass> = model.attached().map(Mass::new).collect();
    let coordinates = Coordinates::new(&Cut::all(model, &parts), parts);
    let of_beam = still(&coordinates.stiffness(&supports, &masses));
    let count = coordinates.count();
    let mut motions: Vec<RigidMotion> = of_beam
        .into_iter()
        .map(|beam| {
            let mut motion = RigidMotion {
                coordinates: coordinates.clone(),
                beam,
                masses: Vec::new(),
            };
            let following = masses
                .iter()
                .map(|of| of.following(&motion.at(of.position)));
            motion.masses = following.collect();
            motion
        })
        .collect();
    for (index, mass) in masses.iter().enumerate() {
        for loose in mass.loose() {
            let mut motion = RigidMotion {
                coordinates: coordinates.clone(),
                beam: DVector::zeros(count),
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
    // Dampers instead of springs; close to frequency 0 a Maxwell branch is one.
    let of = |spring: &Spring| spring.damping_between([Complex64::ZERO; 2]).re;
    let in_place = |spring| Spring {
        stiffness: of(spring),
        ..Spring::default()
    };
    let dampers: Vec<Mass> = model
        .attached()
        .map(|subsystem| {
            Mass::new(&Subsystem {
                y_left: in_place(&subsystem.y_left),
                y_right: in_place(&subsystem.y_right),
                z_left: in_place(&subsystem.z_left),
                z_right: in_place(&subsystem.z_right),
                // Its stiffness must not be added as an inertia.
                inertia: 1.0,
                ..subsystem.clone()
            })
        })
        .collect();
    let coordinates = &motions[0].coordinates;
    let supports = Restrained::all(model, &coordinates.parts);
    let bedding = coordinates.on_foundation(|bedding| bedding.damping);
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
            .flat_map(|of| coordinates.held_motions(of))
            .map(|(_, row, elastic)| {
                let sum = of(&elastic.spring) * row.dot(&a.beam) * row.dot(&b.beam);
                [sum, sum.abs()]
            });
        let add = |[sum, size]: [f64; 2], [more, its]: [f64; 2]| [sum + more, size + its];
        let of_joints = a.jumps().zip(b.jumps()).map(|((jump, one), (_, other))| {
            let sum = of(&jump.spring) * one * other;
            [sum, sum.abs()]
        });
        let bedded = a.beam.dot(&(&bedding * &b.beam));
        of_masses
            .chain(of_supports)
            .chain(of_joints)
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
        let [w, psi, v, ..] = self.all_at(x);
        [w, psi, v]
    }

    /// The six motions of the beam at x, right of a joint there.
    pub(super) fn all_at(&self, x: f64) -> [f64; 6] {
        self.coordinates.rows(x).map(|row| row.dot(&self.beam))
    }

    /// The jumps of the six motions over a joint at a position, right minus left.
    pub(super) fn jumps_at(&self, x: f64) -> [f64; 6] {
        let mut all = [0.0; 6];
        for (jump, by) in self.jumps().filter(|(jump, _)| jump.position == x) {
            all[jump.motion as usize] = by;
        }
        all
    }

    /// Every jump with its value.
    fn jumps(&self) -> impl Iterator<Item = (&Jump, f64)> {
        let values = self.beam.iter().skip(AT_LEFT_END).copied();
        self.coordinates.jumps.iter().zip(values)
    }

    fn add(&mut self, other: &Self, factor: f64) {
        self.beam += factor * &other.beam;
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
    let coordinates = &a.coordinates;
    let mut sum = 0.0;
    for part in &coordinates.parts {
        let matrices = BeamMatrices::of_part(part);
        for (weight, rows) in coordinates.nodes(part) {
            let [a, b] = [a, b].map(|of| rows.each_ref().map(|row| row.dot(&of.beam).into()));
            sum += weight * matrices.inertia(&a, &b).re;
        }
    }
    let held = supports.iter().flat_map(|of| coordinates.held_motions(of));
    for (_, row, elastic) in held {
        sum += elastic.inertia * row.dot(&a.beam) * row.dot(&b.beam);
    }
    for (subsystem, (p, q)) in model.attached().zip(a.masses.iter().zip(&b.masses)) {
        sum += subsystem.mass * (p[0] * q[0] + p[1] * q[1]) + subsystem.inertia * p[2] * q[2];
    }
    sum
}

/// The coordinates at the left end.
const AT_LEFT_END: usize = 5;

impl Coordinates {
    fn new(cuts: &[Cut], parts: Vec<UniformPart>) -> Self {
        let jumps = cuts.iter().flat_map(|cut| {
            let position = cut.position;
            cut.released().map(move |(motion, spring)| Jump {
                position,
                motion,
                spring: spring.clone(),
            })
        });
        Self {
            parts,
            jumps: jumps
                .filter(|jump| jump.motion != BeamMotion::PsiSlope)
                .collect(),
        }
    }

    /// Their number.
    fn count(&self) -> usize {
        AT_LEFT_END + self.jumps.len()
    }

    /// The six motions at x, right of a joint there, as functions of the coordinates.
    fn rows(&self, x: f64) -> [DVector<f64>; 6] {
        self.rows_after(x, x)
    }

    /// The same right of what is at `from`, m.
    fn rows_after(&self, from: f64, x: f64) -> [DVector<f64>; 6] {
        let mut rows: [DVector<f64>; 6] = std::array::from_fn(|_| DVector::zeros(self.count()));
        let at_left_end = [
            (0.0, BeamMotion::W),
            (0.0, BeamMotion::Psi),
            (0.0, BeamMotion::V),
            (0.0, BeamMotion::WSlope),
            (0.0, BeamMotion::VSlope),
        ];
        let jumps = self.jumps.iter().map(|jump| (jump.position, jump.motion));
        for (index, (start, motion)) in at_left_end.into_iter().chain(jumps).enumerate() {
            if start > from {
                continue;
            }
            rows[motion as usize][index] = 1.0;
            match motion {
                BeamMotion::WSlope => rows[BeamMotion::W as usize][index] = x - start,
                BeamMotion::VSlope => rows[BeamMotion::V as usize][index] = x - start,
                BeamMotion::W | BeamMotion::Psi | BeamMotion::V | BeamMotion::PsiSlope => {}
            }
        }
        rows
    }

    /// Nodes of an integral along a part of the beam, which is exact for the product of two motions: their weights, m, and
    /// the six motions there (Simpson's rule for the product of two straight lines).
    fn nodes(&self, part: &UniformPart) -> impl Iterator<Item = (f64, [DVector<f64>; 6])> {
        let [start, end] = [part.start, part.end];
        let cuts = self.jumps.iter().map(|jump| jump.position);
        let cuts = cuts.filter(|cut| (start..end).contains(cut));
        let mut ends: Vec<f64> = cuts.chain([start, end]).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let pieces: Vec<[f64; 2]> = ends.windows(2).map(|piece| [piece[0], piece[1]]).collect();
        pieces.into_iter().flat_map(|[from, to]| {
            [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)].map(|(share, weight)| {
                let x = from + share * (to - from);
                ((to - from) * weight / 6.0, self.rows_after(from, x))
            })
        })
    }

    /// The stiffness over the coordinates, while the masses follow.
    ///
    /// An axial force resists a slope, or turns the beam further; both are no motion at frequency 0.
    fn stiffness(&self, supports: &[Restrained], masses: &[Mass]) -> DMatrix<f64> {
        let mut rigid = self.on_foundation(|bedding| bedding.stiffness);
        for part in &self.parts {
            for (weight, rows) in self.nodes(part) {
                for slope in [BeamMotion::WSlope, BeamMotion::VSlope] {
                    let row = &rows[slope as usize];
                    add_square(&mut rigid, part.beam.axial_force.abs() * weight, row);
                }
            }
        }
        for (index, jump) in self.jumps.iter().enumerate() {
            let at = AT_LEFT_END + index;
            rigid[(at, at)] += jump.spring.stiffness;
        }
        let held = self.held_stiffness(supports, masses);
        for restrained in supports {
            for (motion, row, elastic) in self.held_motions(restrained) {
                let stiffness = if restrained.is_fixed(motion) {
                    held
                } else {
                    elastic.spring.stiffness
                };
                add_square(&mut rigid, stiffness, &row);
            }
        }
        for mass in masses {
            let (condensed, _) = mass.condensed_static();
            if condensed == Matrix3::zeros() {
                continue;
            }
            let motions = self.rows(mass.position);
            for row in 0..3 {
                for column in 0..3 {
                    rigid += condensed[(row, column)] * &motions[row] * motions[column].transpose();
                }
            }
        }
        rigid
    }

    /// The springs, or the dampers, of the foundation.
    fn on_foundation(&self, of: fn(&Bedding) -> f64) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(self.count(), self.count());
        for part in &self.parts {
            for (weight, rows) in self.nodes(part) {
                for (row, bedding) in rows.iter().zip(part.beam.foundation.beddings()) {
                    add_square(&mut sum, of(&bedding) * weight, row);
                }
            }
        }
        sum
    }

    /// A stiffness as large as any of the model: it makes sure that a fixed motion is not a mode at frequency 0.
    fn held_stiffness(&self, supports: &[Restrained], masses: &[Mass]) -> f64 {
        let rows = supports.iter().flat_map(Restrained::rows);
        let springs = rows.map(|(_, _, elastic)| elastic.spring.stiffness);
        let joints = self.jumps.iter().map(|jump| jump.spring.stiffness);
        let masses = masses.iter().map(|mass| mass.stiffness.amax());
        springs.chain(joints).chain(masses).fold(1.0, f64::max)
    }

    /// The motions of the point that a support holds, each with its spring and inertia, as functions of the coordinates.
    fn held_motions<'a>(
        &self,
        restrained: &'a Restrained,
    ) -> impl Iterator<Item = (BeamMotion, DVector<f64>, &'a Elastic)> + use<'a> {
        let rows = self.rows(restrained.position);
        restrained.rows().map(move |(motion, row, elastic)| {
            let shares = rows.iter().zip(&row);
            (
                motion,
                shares.map(|(motion, share)| motion * *share).sum(),
                elastic,
            )
        })
    }
}

/// Adds `factor a a^T`.
fn add_square(sum: &mut DMatrix<f64>, factor: f64, a: &DVector<f64>) {
    if factor != 0.0 {
        sum.ger(factor, a, a, 1.0);
    }
}

/// The null space of a positive semidefinite stiffness, each motion in its own unit.
fn still(stiffness: &DMatrix<f64>) -> Vec<DVector<f64>> {
    const RESOLVED: f64 = 1e-11;
    let count = stiffness.nrows();
    let scale = DVector::<f64>::from_fn(count, |index, _| {
        let diagonal = stiffness[(index, index)];
        if diagonal > 0.0 {
            diagonal.sqrt().recip()
        } else {
            1.0
        }
    });
    let scaled =
        DMatrix::<f64>::from_fn(count, count, |i, j| stiffness[(i, j)] * scale[i] * scale[j]);
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
