//! How many undamped modes lie below a frequency: the algorithm of Wittrick & Williams.
//!
//! `J = J_0 + s(K_D)` (Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284): `s` counts the negative
//! eigenvalues of the dynamic stiffness over all stations, and `J_0` the modes with every station clamped, of the spans
//! between them and of each subsystem's mass. The stations are eliminated from left to right, so that no matrix is
//! larger than 6x6 and the cost is linear in their number. Nothing is shared with the frequency responses.

use std::ops::Range;

use nalgebra::{Matrix3, Matrix6, SMatrix, SymmetricEigen, Vector6};

use super::inertia::{eliminate, negatives};
use super::span::{Field, Span, symmetric};
use crate::model::{Beam, BeamMotion, Elastic, Model, Restraint, Subsystem, Support};

/// A model laid out to be counted.
#[derive(Debug, Clone)]
pub(super) struct Counter {
    beam: Beam,
    left: End,
    right: End,
    /// By rising x; subsystems at one place follow each other.
    masses: Vec<Mass>,
    /// The ends and the places of the masses, by rising x: which of `masses` are there.
    nodes: Vec<Range<usize>>,
    /// The lengths between the nodes, m: one less.
    spans: Vec<f64>,
    /// The longest span: where the elimination from the left meets that from the right.
    longest: usize,
    /// How many modes have the frequency 0.
    rigid: usize,
}

/// An end: which motions it holds, and the springs and inertias on the others.
#[derive(Debug, Clone, Copy)]
struct End {
    fixed: [bool; 6],
    elastic: [Elastic; 6],
}

/// A subsystem's stiffness over (y, z, theta | w, psi, v), and its inertia.
#[derive(Debug, Clone)]
struct Mass {
    position: f64,
    stiffness: Matrix6<f64>,
    inertia: [f64; 3],
}

/// What numbers are measured by at one frequency.
#[derive(Debug, Clone, Copy)]
struct Units {
    /// m.
    length: f64,
    /// N/m.
    stiffness: f64,
    /// Size of a unit of each of the six motions, in SI.
    motion: [f64; 6],
}

impl Counter {
    /// Lays out the undamped part of a checked model.
    pub(super) fn new(model: &Model) -> Self {
        let mut beam = model.beam;
        if decays_at_once(&beam) {
            beam.section.warping_constant = 0.0;
        }
        let mut masses: Vec<Mass> = model
            .subsystems
            .iter()
            .filter(|subsystem| subsystem.enabled)
            .map(Mass::new)
            .collect();
        masses.sort_by(|a, b| a.position.total_cmp(&b.position));
        let (nodes, spans) = nodes(&masses, beam.length);
        let warps = beam.section.warping_constant > 0.0;
        let mut counter = Self {
            left: End::new(&model.supports.left, warps),
            right: End::new(&model.supports.right, warps),
            longest: longest(&spans),
            beam,
            masses,
            nodes,
            spans,
            rigid: 0,
        };
        counter.rigid = counter.count_rigid();
        counter
    }

    /// How many modes have the frequency 0.
    pub(super) fn rigid(&self) -> usize {
        self.rigid
    }

    /// How many modes lie below the angular frequency `omega` > 0, rad/s, those at 0 included.
    ///
    /// Left and right part meet within the longest span, at no simple share of it: at an end, or at a middle, the modes
    /// of the part with that point clamped may be those of the whole (a clamped and a free beam have the same), and the
    /// count would lose half its digits there.
    pub(super) fn below(&self, omega: f64) -> usize {
        const SHARE: f64 = 0.414_2;
        let mut march = March {
            counter: self,
            omega,
            units: self.units(omega),
            field: self.field(omega),
            known: None,
            count: 0,
        };
        let last = self.spans.len();
        let from_left: Vec<_> = (0..=self.longest).map(|n| (n, n)).collect();
        let from_right: Vec<_> = (self.longest..last).rev().map(|n| (n + 1, n)).collect();
        let left = march.over(&self.left, &from_left, SHARE);
        let right = march.over(&self.right, &from_right, 1.0 - SHARE);
        march.count + negatives(&(left + mirrored(&right)))
    }

    fn units(&self, omega: f64) -> Units {
        let (material, section) = (&self.beam.material, &self.beam.section);
        let bending = material.young_modulus * section.second_moment_y;
        let wave = (bending / (material.density * section.area * omega * omega)).powf(0.25);
        let length = wave.min(self.beam.length);
        let turn = (section.area / section.polar_moment).sqrt();
        Units {
            length,
            stiffness: bending / length.powi(3),
            motion: [1.0, turn, 1.0, 1.0 / length, turn / length, 1.0 / length],
        }
    }

    fn field(&self, omega: f64) -> Field {
        let units = self.units(omega);
        let (material, section) = (&self.beam.material, &self.beam.section);
        let inertia =
            omega * omega * material.density * section.area * units.length / units.stiffness;
        let radius_square = section.polar_moment / section.area;
        Field {
            bending_v: section.second_moment_z / section.second_moment_y,
            warping: section.warping_constant / (section.second_moment_y * radius_square),
            torsion: material.shear_modulus * section.torsion_constant
                / (units.stiffness * units.length * radius_square),
            mass: inertia,
            polar: inertia,
            coupling: inertia * section.centroid_offset / radius_square.sqrt(),
        }
    }

    /// The modes at frequency 0: motions of the rigid beam and the masses that stretch no spring.
    fn count_rigid(&self) -> usize {
        // Of w, psi, v at the left end and the two slopes; a rigid beam has no rate of twist.
        let mut rigid = SMatrix::<f64, 5, 5>::zeros();
        let mut free = 0;
        for (end, x) in [(&self.left, 0.0), (&self.right, self.beam.length)] {
            for (row, motion) in rigid_motions(x).iter().enumerate() {
                let stiffness = if end.fixed[row] {
                    self.held_stiffness()
                } else {
                    end.elastic[row].stiffness
                };
                rigid += stiffness * motion * motion.transpose();
            }
        }
        for mass in &self.masses {
            let (condensed, loose) = mass.condensed_static();
            let motions = rigid_motions(mass.position);
            for row in 0..3 {
                for column in 0..3 {
                    rigid += condensed[(row, column)] * motions[row] * motions[column].transpose();
                }
            }
            free += loose;
        }
        free + 5 - rank(&rigid)
    }

    /// A stiffness as large as any of the model: what is fixed is certainly no mode at frequency 0.
    fn held_stiffness(&self) -> f64 {
        let ends = [&self.left, &self.right];
        let springs = ends
            .iter()
            .flat_map(|end| end.elastic.iter().map(|elastic| elastic.stiffness));
        let masses = self.masses.iter().map(|mass| mass.stiffness.amax());
        springs.chain(masses).fold(1.0, f64::max)
    }
}

/// Whether the warping of an end dies out within so little of the beam that no digit of a count shows it.
fn decays_at_once(beam: &Beam) -> bool {
    const NEGLIGIBLE: f64 = 1e-12;
    let (material, section) = (&beam.material, &beam.section);
    material.young_modulus * section.warping_constant
        < NEGLIGIBLE * material.shear_modulus * section.torsion_constant * beam.length.powi(2)
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

/// The rank of a positive semidefinite matrix, each motion in its own unit.
fn rank<const N: usize>(stiffness: &SMatrix<f64, N, N>) -> usize
where
    nalgebra::Const<N>: nalgebra::DimSub<nalgebra::U1>,
    nalgebra::DefaultAllocator: nalgebra::allocator::Allocator<nalgebra::Const<N>>
        + nalgebra::allocator::Allocator<nalgebra::DimDiff<nalgebra::Const<N>, nalgebra::U1>>,
{
    const RESOLVED: f64 = 1e-11;
    let scale = |index: usize| {
        let diagonal = stiffness[(index, index)];
        if diagonal > 0.0 {
            diagonal.sqrt().recip()
        } else {
            0.0
        }
    };
    let scaled = SMatrix::<f64, N, N>::from_fn(|i, j| stiffness[(i, j)] * scale(i) * scale(j));
    SymmetricEigen::new(scaled)
        .eigenvalues
        .iter()
        .filter(|&&x| x > RESOLVED)
        .count()
}

/// The masses at each place, ends included, and the lengths between the places.
fn nodes(masses: &[Mass], length: f64) -> (Vec<Range<usize>>, Vec<f64>) {
    let mut nodes = Vec::new();
    let mut spans = Vec::new();
    let (mut first, mut x) = (0, 0.0);
    for (index, mass) in masses.iter().enumerate() {
        if mass.position > x {
            nodes.push(first..index);
            spans.push(mass.position - x);
            (first, x) = (index, mass.position);
        }
    }
    nodes.push(first..masses.len());
    if x < length {
        nodes.push(masses.len()..masses.len());
        spans.push(length - x);
    }
    (nodes, spans)
}

/// The index of the longest span.
fn longest(spans: &[f64]) -> usize {
    let by_length = |&a: &usize, &b: &usize| spans[a].total_cmp(&spans[b]);
    (0..spans.len()).max_by(by_length).unwrap_or(0)
}

/// The elimination of stations at one frequency.
struct March<'a> {
    counter: &'a Counter,
    omega: f64,
    units: Units,
    field: Field,
    /// The last span and its length, for the next of that length.
    known: Option<(f64, Span)>,
    /// Negative pivots, and modes of clamped spans and blocked masses, so far.
    count: usize,
}

impl March<'_> {
    /// From an end over nodes, each with the span behind it, and a share of the last span; returns the dynamic
    /// stiffness of all that was passed, in a frame that points away from the end.
    fn over(&mut self, end: &End, path: &[(usize, usize)], share: f64) -> Matrix6<f64> {
        let mut stiffness = end.stiffness(self.omega, &self.units);
        let mut fixed = end.fixed;
        let last = path.len() - 1;
        for (step, &(node, span)) in path.iter().enumerate() {
            self.attach(node, &mut stiffness);
            let part = if step == last { share } else { 1.0 };
            self.cross(part * self.counter.spans[span], &mut stiffness, fixed);
            fixed = [false; 6];
        }
        stiffness
    }

    /// Adds the masses of a node.
    fn attach(&mut self, node: usize, stiffness: &mut Matrix6<f64>) {
        for mass in &self.counter.masses[self.counter.nodes[node].clone()] {
            let (condensed, own) = mass.condensed(self.omega, &self.units);
            let mut corner = stiffness.fixed_view_mut::<3, 3>(0, 0);
            corner += condensed;
            self.count += own;
        }
    }

    /// Carries the stiffness over a span.
    fn cross(&mut self, length: f64, stiffness: &mut Matrix6<f64>, mut fixed: [bool; 6]) {
        let pieces = self.field.pieces(length / self.units.length);
        let length = length / pieces as f64;
        let span = match self.known.take() {
            Some((known, span)) if known == length => span,
            _ => self.field.span(length / self.units.length),
        };
        for _ in 0..pieces {
            self.count += cross(&span, stiffness, fixed);
            fixed = [false; 6];
        }
        self.known = Some((length, span));
    }
}

/// A stiffness in the frame that points the other way: slopes change their sign.
fn mirrored(stiffness: &Matrix6<f64>) -> Matrix6<f64> {
    let sign = |row: usize| if row < 3 { 1.0 } else { -1.0 };
    Matrix6::from_fn(|i, j| sign(i) * sign(j) * stiffness[(i, j)])
}

/// Carries the stiffness over a span; returns the count of what was eliminated and of the clamped span.
fn cross(span: &Span, stiffness: &mut Matrix6<f64>, fixed: [bool; 6]) -> usize {
    let ends = &span.ends;
    let mut node = ends.left + *stiffness;
    hold(&mut node, fixed);
    let mut across = ends.across;
    let mut moved = Matrix6::identity();
    let mut force = *stiffness;
    for row in (0..6).filter(|&row| fixed[row]) {
        across.row_mut(row).fill(0.0);
        moved[(row, row)] = 0.0;
        force.row_mut(row).fill(0.0);
        force.column_mut(row).fill(0.0);
        force[(row, row)] = 1.0;
    }
    let eliminated = eliminate(&node, &across);
    let by_transfer = span.transfer.as_ref().and_then(|transfer| {
        // Only its columns' span counts, so that any regular scale will do.
        let moved_on = transfer.a * moved + transfer.b * force;
        Some((transfer.c * moved + transfer.d * force) * moved_on.try_inverse()?)
    });
    *stiffness = symmetric(
        by_transfer.unwrap_or_else(|| ends.right - ends.across.transpose() * eliminated.solution),
    );
    ends.clamped + eliminated.negatives
}

/// Takes fixed motions out of a stiffness: no coupling, and a positive pivot that counts nothing.
fn hold(stiffness: &mut Matrix6<f64>, fixed: [bool; 6]) {
    for row in (0..6).filter(|&row| fixed[row]) {
        stiffness.row_mut(row).fill(0.0);
        stiffness.column_mut(row).fill(0.0);
        stiffness[(row, row)] = 1.0;
    }
}

impl End {
    /// Where a section does not warp, the rate of twist is no degree of freedom: it is held at no cost.
    fn new(support: &Support, warps: bool) -> Self {
        let mut end = Self {
            fixed: [false; 6],
            elastic: [Elastic::default(); 6],
        };
        for motion in BeamMotion::ALL {
            match support[motion] {
                _ if motion == BeamMotion::PsiSlope && !warps => {
                    end.fixed[motion as usize] = true;
                }
                Restraint::Free => {}
                Restraint::Fixed => end.fixed[motion as usize] = true,
                Restraint::Elastic(elastic) => end.elastic[motion as usize] = elastic,
            }
        }
        end
    }

    fn stiffness(&self, omega: f64, units: &Units) -> Matrix6<f64> {
        Matrix6::from_diagonal(&Vector6::from_fn(|row, _| {
            let elastic = self.elastic[row];
            (elastic.stiffness - omega * omega * elastic.inertia) * units.motion[row].powi(2)
                / units.stiffness
        }))
    }
}

impl Mass {
    /// Chen & Liu 2022, Appendix A, without damping.
    fn new(subsystem: &Subsystem) -> Self {
        let y = subsystem.y_left.stiffness + subsystem.y_right.stiffness;
        let (left, right) = (subsystem.z_left.stiffness, subsystem.z_right.stiffness);
        // Each spring's stretch as a row over (y, z, theta | w, psi, v).
        let stretches = [
            (y, [1.0, 0.0, 0.0, -1.0, -subsystem.mount_z, 0.0]),
            (
                left,
                [0.0, 1.0, -subsystem.arm_left, 0.0, subsystem.mount_y, -1.0],
            ),
            (
                right,
                [0.0, 1.0, subsystem.arm_right, 0.0, -subsystem.mount_y, -1.0],
            ),
        ];
        let mut stiffness = Matrix6::zeros();
        for (spring, row) in stretches {
            let row = Vector6::from(row);
            stiffness += spring * row * row.transpose();
        }
        let mut inertia = [subsystem.mass, subsystem.mass, subsystem.inertia];
        if subsystem.inertia == 0.0 && stiffness[(2, 2)] == 0.0 {
            // Nothing turns it and nothing resists: no degree of freedom.
            stiffness[(2, 2)] = 1.0;
            inertia[2] = 0.0;
        }
        Self {
            position: subsystem.position,
            stiffness,
            inertia,
        }
    }

    /// The stiffness over (w, psi, v) with the mass eliminated, without dimension, and the count of the blocked mass.
    fn condensed(&self, omega: f64, units: &Units) -> (Matrix3<f64>, usize) {
        let scale = |index: usize| match index {
            0 | 1 => 1.0,
            2 => units.motion[1],
            beam => units.motion[beam - 3],
        };
        let full = Matrix6::from_fn(|i, j| {
            let inertia = if i == j && i < 3 {
                omega * omega * self.inertia[i]
            } else {
                0.0
            };
            (self.stiffness[(i, j)] - inertia) * scale(i) * scale(j) / units.stiffness
        });
        let across = full.fixed_view::<3, 3>(0, 3).into_owned();
        let own = eliminate(&full.fixed_view::<3, 3>(0, 0).into_owned(), &across);
        let condensed = full.fixed_view::<3, 3>(3, 3) - across.transpose() * own.solution;
        (condensed, own.negatives)
    }

    /// The static stiffness over (w, psi, v) with the mass following, and how many of its motions meet no spring.
    fn condensed_static(&self) -> (Matrix3<f64>, usize) {
        const RESOLVED: f64 = 1e-12;
        let own = self.stiffness.fixed_view::<3, 3>(0, 0).into_owned();
        let across = self.stiffness.fixed_view::<3, 3>(0, 3);
        let direct = self.stiffness.fixed_view::<3, 3>(3, 3);
        let eigen = SymmetricEigen::new(own);
        let least = RESOLVED * eigen.eigenvalues.amax();
        let mut condensed = direct.into_owned();
        let mut loose = 0;
        for (value, vector) in eigen
            .eigenvalues
            .iter()
            .zip(eigen.eigenvectors.column_iter())
        {
            if *value > least {
                let pulled = across.transpose() * vector;
                condensed -= pulled * pulled.transpose() / *value;
            } else {
                loose += 1;
            }
        }
        // A mass that can follow leaves nothing but rounding.
        let scale = direct.amax();
        (
            condensed.map(|x| if x.abs() < RESOLVED * scale { 0.0 } else { x }),
            loose,
        )
    }
}
