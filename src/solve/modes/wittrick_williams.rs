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
use super::station::{Cut, Fixed, Mass, Restrained, Units};
use crate::model::{Beam, BeamMotion, Model};
use crate::solve::beam_matrices::{BeamMatrices, Symmetric};

/// A model laid out for the count.
#[derive(Debug, Clone)]
pub(super) struct Counter {
    beam: Beam,
    /// By ascending x.
    supports: Vec<Restrained>,
    /// By ascending x, at most one at a position.
    cuts: Vec<Cut>,
    /// By ascending x; subsystems at one position are adjacent.
    masses: Vec<Mass>,
    /// The positions of the supports, the joints and the masses, by ascending x: the first is the left end, the last the right one.
    nodes: Vec<Node>,
    /// The lengths between the nodes, m: one less.
    spans: Vec<f64>,
    /// The span where the elimination from the left meets that from the right: the longest one, but right of every joint
    /// next to a fixed motion, which only the elimination from the left can cross.
    meeting: usize,
    /// Number of modes at frequency 0.
    rigid: usize,
    /// Number of modes that an axial compression makes grow.
    unstable: usize,
}

/// What is at one position, by the indices in the lists of the counter.
#[derive(Debug, Clone)]
struct Node {
    /// Left of everything else there.
    cut: Option<usize>,
    supports: Range<usize>,
    masses: Range<usize>,
    fixed: Fixed,
}

impl Counter {
    /// Lays out the undamped part of a checked model.
    pub(super) fn new(model: &Model) -> Self {
        let mut beam = model.beam;
        if decays_at_once(&beam) {
            beam.section.warping_constant = 0.0;
        }
        let mut supports = Restrained::all(model, beam.section.warping_constant > 0.0);
        supports.sort_by(|a, b| a.position.total_cmp(&b.position));
        let mut cuts = Cut::all(model, beam.section.warping_constant > 0.0);
        cuts.sort_by(|a, b| a.position.total_cmp(&b.position));
        let mut masses: Vec<Mass> = model.attached().map(Mass::new).collect();
        for mass in &mut masses {
            mass.position = near_support(mass.position, &supports, &cuts, beam.length);
        }
        masses.sort_by(|a, b| a.position.total_cmp(&b.position));
        let (nodes, spans) = nodes(&supports, &cuts, &masses);
        let mut counter = Self {
            supports,
            cuts,
            meeting: meeting(&nodes, &spans),
            beam,
            masses,
            nodes,
            spans,
            rigid: 0,
            unstable: 0,
        };
        counter.rigid = rigid::count(
            &counter.supports,
            &counter.cuts,
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
    /// The left and the right part meet within a long span, at an irregular fraction of it: with a clamp at an end
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
        let from_left: Vec<_> = (0..=self.meeting).map(|n| (n, n)).collect();
        let from_right: Vec<_> = (self.meeting..last).rev().map(|n| (n + 1, n)).collect();
        let left = march.over(&from_left, SHARE, true);
        let right = march.over(&from_right, 1.0 - SHARE, false);
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

/// The position of a support that fixes a motion, if a position is as good as there and no joint is between them: the
/// stiffness of the span between them would be so large that rounding hides everything else. Both m.
fn near_support(position: f64, supports: &[Restrained], cuts: &[Cut], length: f64) -> f64 {
    const NEAR: f64 = 2e-7;
    let is_near = |support: &&Restrained| {
        let fixes = BeamMotion::ALL
            .into_iter()
            .any(|motion| support.is_fixed(motion));
        // A joint is left of everything else at its position.
        let (low, high) = (
            support.position.min(position),
            support.position.max(position),
        );
        let is_between = |cut: &Cut| low < cut.position && cut.position <= high;
        fixes && high - low < NEAR * length && !cuts.iter().any(is_between)
    };
    let near = supports.iter().find(is_near);
    near.map_or(position, |support| support.position)
}

/// The positions of supports, joints and masses, and the lengths between them.
fn nodes(supports: &[Restrained], cuts: &[Cut], masses: &[Mass]) -> (Vec<Node>, Vec<f64>) {
    let of_supports = supports.iter().map(|support| support.position);
    let mut positions: Vec<f64> = of_supports
        .chain(cuts.iter().map(|cut| cut.position))
        .chain(masses.iter().map(|mass| mass.position))
        .collect();
    positions.sort_by(f64::total_cmp);
    positions.dedup();
    let spans = positions.windows(2).map(|ends| ends[1] - ends[0]).collect();
    let node = |x: &f64| {
        let held = supports.partition_point(|of| of.position < *x)
            ..supports.partition_point(|of| of.position <= *x);
        Node {
            cut: cuts.iter().position(|cut| cut.position == *x),
            fixed: Fixed::by(&supports[held.clone()]),
            supports: held,
            masses: masses.partition_point(|of| of.position < *x)
                ..masses.partition_point(|of| of.position <= *x),
        }
    };
    (positions.iter().map(node).collect(), spans)
}

/// The index of the span where both eliminations meet.
fn meeting(nodes: &[Node], spans: &[f64]) -> usize {
    let is_one_way = |node: &Node| node.cut.is_some() && node.fixed.motions != [false; 6];
    let first = nodes.iter().rposition(is_one_way).unwrap_or(0);
    let by_length = |&a: &usize, &b: &usize| spans[a].total_cmp(&spans[b]);
    (first..spans.len()).max_by(by_length).unwrap_or(0)
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
    /// From the left or the right end over nodes, each with the span behind it, and a fraction of the last span; returns
    /// the dynamic stiffness of this part, in a frame that points away from the end.
    fn over(&mut self, path: &[(usize, usize)], share: f64, is_left: bool) -> Matrix6<f64> {
        let mut stiffness = Matrix6::zeros();
        let last = path.len() - 1;
        for (step, &(node, span)) in path.iter().enumerate() {
            let node = &self.counter.nodes[node];
            if is_left {
                self.join(node, &mut stiffness);
            }
            self.attach(node, &mut stiffness);
            if !is_left {
                self.join(node, &mut stiffness);
            }
            let part = if step == last { share } else { 1.0 };
            self.cross(part * self.counter.spans[span], &mut stiffness, node.fixed);
        }
        stiffness
    }

    /// Moves the stiffness over the joint of a node, if it has one.
    fn join(&mut self, node: &Node, stiffness: &mut Matrix6<f64>) {
        if let Some(cut) = node.cut {
            let (beyond, own) = self.counter.cuts[cut].beyond(stiffness, &self.units);
            *stiffness = beyond;
            self.count = self.count.saturating_add(own);
        }
    }

    /// Adds the springs and the masses of a node.
    fn attach(&mut self, node: &Node, stiffness: &mut Matrix6<f64>) {
        for support in &self.counter.supports[node.supports.clone()] {
            *stiffness += support.stiffness(self.omega, &self.units);
        }
        for mass in &self.counter.masses[node.masses.clone()] {
            let (condensed, own) = mass.condensed(self.omega, &self.units);
            let mut corner = stiffness.fixed_view_mut::<3, 3>(0, 0);
            corner += condensed;
            self.count = self.count.saturating_add(own);
        }
    }

    /// Moves the stiffness over a span.
    fn cross(&mut self, length: f64, stiffness: &mut Matrix6<f64>, mut fixed: Fixed) {
        let pieces = self.field.pieces(length / self.units.length);
        let length = length / pieces as f64;
        let span = match self.known.take() {
            Some((known, span)) if known == length => span,
            _ => self.field.span(length / self.units.length),
        };
        for _ in 0..pieces {
            let count = if let Some(axis) = fixed.axis_of_point(&self.units) {
                *stiffness = axis.transpose() * *stiffness * axis;
                cross(&span.at_point(&axis), stiffness, fixed.motions)
            } else {
                cross(&span, stiffness, fixed.motions)
            };
            self.count = self.count.saturating_add(count);
            fixed = Fixed::NONE;
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
