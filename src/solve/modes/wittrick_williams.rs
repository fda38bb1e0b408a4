//! The number of undamped modes below a frequency, by the algorithm of Wittrick & Williams.
//!
//! `J = J_0 + s(K_D)` (Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284): `s` is the number of negative
//! eigenvalues of the dynamic stiffness over all stations, and `J_0` the number of modes with every station clamped, of
//! the spans between them and of each subsystem's mass. The stations are eliminated from left to right, so that no
//! matrix is larger than 6x6 and the cost is linear in their number. The count shares nothing with the frequency
//! responses.

use std::ops::Range;

use nalgebra::{Matrix3, Matrix6, Vector3};
use num_complex::Complex64;

use super::dynamic_stiffness::{Field, Span, symmetric};
use super::matrix_inertia::{eliminate, negatives};
use super::rigid;
use super::station::{End, Mass, Units};
use crate::model::{Beam, Model};
use crate::solve::beam_matrices::{BeamMatrices, Symmetric};

/// A model laid out for the count.
#[derive(Debug, Clone)]
pub(super) struct Counter {
    beam: Beam,
    left: End,
    right: End,
    /// By ascending x; subsystems at one position are adjacent.
    masses: Vec<Mass>,
    /// The ends and the positions of the masses, by ascending x: the indices of their `masses`.
    nodes: Vec<Range<usize>>,
    /// The lengths between the nodes, m: one less.
    spans: Vec<f64>,
    /// The longest span: where the elimination from the left meets that from the right.
    longest: usize,
    /// Number of modes at frequency 0.
    rigid: usize,
    /// Number of modes that an axial compression makes grow.
    unstable: usize,
}

impl Counter {
    /// Lays out the undamped part of a checked model.
    pub(super) fn new(model: &Model) -> Self {
        let mut beam = model.beam;
        if decays_at_once(&beam) {
            beam.section.warping_constant = 0.0;
        }
        let mut masses: Vec<Mass> = model.attached().map(Mass::new).collect();
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
            unstable: 0,
        };
        counter.rigid = rigid::count(
            [&counter.left, &counter.right],
            &counter.masses,
            &counter.beam,
        );
        if counter.beam.axial_force < 0.0 {
            let slow = counter.slow();
            counter.unstable = counter.below(slow).saturating_sub(counter.rigid);
        }
        counter
    }

    /// Number of modes at frequency 0.
    pub(super) fn rigid(&self) -> usize {
        self.rigid
    }

    /// Number of modes that an axial compression makes grow instead of oscillate.
    pub(super) fn unstable(&self) -> usize {
        self.unstable
    }

    /// An angular frequency, rad/s, at which a beam is as good as at rest.
    fn slow(&self) -> f64 {
        const SHARE: f64 = 1e-6;
        let (material, section) = (&self.beam.material, &self.beam.section);
        let stiffness = material.young_modulus * section.second_moment_y;
        let mass = material.density * section.area;
        SHARE * (stiffness / mass).sqrt() / self.beam.length.powi(2)
    }

    /// Number of modes below the angular frequency `omega` > 0, rad/s, those at 0 included, without the unstable ones.
    ///
    /// The left and the right part meet within the longest span, at an irregular fraction of it: with a clamp at an end
    /// or in the middle the modes of a part may coincide with those of the whole (a clamped and a free beam have the
    /// same), and the count would lose half its digits there.
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
        let joint = negatives(&(left + mirrored(&right)));
        march
            .count
            .saturating_add(joint)
            .saturating_sub(self.unstable)
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
        let matrices = BeamMatrices::new(&self.beam);
        let real = |of: &Symmetric<Complex64>| dimensionless(&of.map(|entry| entry.re), &units);
        // E Iy, and the square of the length over it.
        let bending = units.stiffness * units.length.powi(3);
        let square = units.length * units.length / bending;
        let quartic = square * units.length * units.length;
        let [w, v] = [matrices.shear.w, matrices.shear.v].map(|compliance| compliance.re / square);
        Field {
            bending: real(&matrices.bending) / bending,
            tension: real(&matrices.tension) * square,
            rotary: dimensionless(&matrices.rotary, &units) * (omega * omega * square),
            shear: Matrix3::from_diagonal(&Vector3::new(w, 0.0, v)),
            inertia: dimensionless(&matrices.mass, &units) * (omega * omega * quartic),
            foundation: Matrix3::from_diagonal(&Vector3::from_fn(|row, _| {
                matrices.foundation[row].re * units.motion[row].powi(2) * quartic
            })),
        }
    }
}

/// A matrix over (w, psi, v) with twist in its unit.
fn dimensionless(of: &Symmetric<f64>, units: &Units) -> Matrix3<f64> {
    let rows = of.rows();
    Matrix3::from_fn(|i, j| rows[i][j] * units.motion[i] * units.motion[j])
}

/// Whether the warping of an end decays within so little of the beam that it does not affect the count.
fn decays_at_once(beam: &Beam) -> bool {
    const NEGLIGIBLE: f64 = 1e-12;
    let (material, section) = (&beam.material, &beam.section);
    material.young_modulus * section.warping_constant
        < NEGLIGIBLE * material.shear_modulus * section.torsion_constant * beam.length.powi(2)
}

/// The masses at each position, ends included, and the lengths between the positions.
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
    /// Number of negative pivots, and of modes of clamped spans and blocked masses, so far.
    count: usize,
}

impl March<'_> {
    /// From an end over nodes, each with the span behind it, and a fraction of the last span; returns the dynamic
    /// stiffness of this part, in a frame that points away from the end.
    fn over(&mut self, end: &End, path: &[(usize, usize)], share: f64) -> Matrix6<f64> {
        let mut stiffness = end.stiffness(self.omega, &self.units);
        let mut fixed = end.fixed();
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
            self.count = self.count.saturating_add(own);
        }
    }

    /// Moves the stiffness over a span.
    fn cross(&mut self, length: f64, stiffness: &mut Matrix6<f64>, mut fixed: [bool; 6]) {
        let pieces = self.field.pieces(length / self.units.length);
        let length = length / pieces as f64;
        let span = match self.known.take() {
            Some((known, span)) if known == length => span,
            _ => self.field.span(length / self.units.length),
        };
        for _ in 0..pieces {
            self.count = self.count.saturating_add(cross(&span, stiffness, fixed));
            fixed = [false; 6];
        }
        self.known = Some((length, span));
    }
}

/// A stiffness in the opposite frame: slopes change their sign.
fn mirrored(stiffness: &Matrix6<f64>) -> Matrix6<f64> {
    let sign = |row: usize| if row < 3 { 1.0 } else { -1.0 };
    Matrix6::from_fn(|i, j| sign(i) * sign(j) * stiffness[(i, j)])
}

/// Moves the stiffness over a span; returns the count of the eliminated end and of the clamped span.
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
        // Only the span of its columns matters, so any regular scale is possible.
        let moved_on = transfer.a * moved + transfer.b * force;
        Some((transfer.c * moved + transfer.d * force) * moved_on.try_inverse()?)
    });
    *stiffness = symmetric(
        by_transfer.unwrap_or_else(|| ends.right - ends.across.transpose() * eliminated.solution),
    );
    ends.clamped.saturating_add(eliminated.negatives)
}

/// Removes fixed motions from a stiffness: no coupling, and a positive pivot that does not count.
fn hold(stiffness: &mut Matrix6<f64>, fixed: [bool; 6]) {
    for row in (0..6).filter(|&row| fixed[row]) {
        stiffness.row_mut(row).fill(0.0);
        stiffness.column_mut(row).fill(0.0);
        stiffness[(row, row)] = 1.0;
    }
}
