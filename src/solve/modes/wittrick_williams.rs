//! The number of undamped modes below a frequency, by the algorithm of Wittrick & Williams.
//!
//! `J = J_0 + s(K_D)` (Wittrick & Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284): `s` is the number of negative
//! eigenvalues of the dynamic stiffness over all stations, and `J_0` the number of modes with every station clamped, of
//! the spans between them and of each subsystem's mass. The stations are eliminated from left to right, so that no
//! matrix is larger than 6x6 and the cost is linear in their number. The count shares nothing with the frequency
//! responses.
//!
//! Stations are over the motions of the axis, each uniform part between them over those of its own shear centres, where
//! fewer motions are coupled; at both ends of a part its stiffness moves by a congruence, which keeps the count. A part
//! without warping stiffness has a rate of twist that nothing else meets and that is always stable.

use std::ops::Range;

use nalgebra::{Matrix3, Matrix6, Vector3};
use num_complex::Complex64;

use super::dynamic_stiffness::{Field, Span, symmetric};
use super::matrix_inertia::{eliminate, negatives};
use super::rigid;
use super::station::{Cut, Fixed, Links, Mass, Restrained, Units};
use crate::model::{Beam, BeamMotion, Model, Point, UniformPart};
use crate::solve::beam_matrices::{BeamMatrices, Symmetric};

/// A model laid out for the count.
#[derive(Debug, Clone)]
pub(super) struct Counter {
    /// The uniform parts of the beam, from left to right.
    parts: Vec<UniformPart>,
    /// m.
    length: f64,
    means: Means,
    /// By ascending x.
    supports: Vec<Restrained>,
    /// By ascending x, at most one at a position.
    cuts: Vec<Cut>,
    /// By ascending x; subsystems at one position are adjacent.
    masses: Vec<Mass>,
    /// The positions of the supports, the joints, the masses and the ends of parts, by ascending x: the first is the left
    /// end, the last the right one.
    nodes: Vec<Node>,
    /// Between the nodes: one less.
    stretches: Vec<Stretch>,
    /// The stretch where the elimination from the left meets that from the right: the longest one, but right of every joint
    /// next to a fixed motion, which only the elimination from the left can cross.
    meeting: usize,
    /// Number of modes at frequency 0.
    rigid: usize,
    /// Number of modes that an axial compression makes grow.
    unstable: usize,
}

/// Means over the length of the beam.
#[derive(Debug, Clone, Copy)]
struct Means {
    /// E `I_y`, N m2.
    bending: f64,
    /// rho A, kg/m.
    mass: f64,
    /// `I_0 / A`, m2.
    gyration: f64,
}

/// What is at one position, by the indices in the lists of the counter.
#[derive(Debug, Clone)]
struct Node {
    /// Left of everything else there.
    cut: Option<usize>,
    supports: Range<usize>,
    masses: Range<usize>,
    fixed: Fixed,
    /// Whether the part left of it, and that right of it, has no warping stiffness and the other one does, which holds
    /// all this.
    without_warping: [bool; 2],
}

/// The beam between two nodes.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    /// m.
    length: f64,
    /// Index of its part.
    part: usize,
}

impl Counter {
    /// Lays out the undamped part of a checked model.
    pub(super) fn new(model: &Model) -> Self {
        let length = model.length();
        let mut parts = model.uniform_parts();
        for part in &mut parts {
            if part.offset == Point::AXIS && decays_at_once(&part.beam, length) {
                part.beam.section.warping_constant = 0.0;
            }
        }
        move_ends(&mut parts, model, length);
        let mut supports = Restrained::all(model, &parts);
        supports.sort_by(|a, b| a.position.total_cmp(&b.position));
        let mut cuts = Cut::all(model, &parts);
        cuts.sort_by(|a, b| a.position.total_cmp(&b.position));
        let mut masses: Vec<Mass> = model.attached().map(Mass::new).collect();
        for mass in &mut masses {
            mass.position = near_support(mass.position, &supports, &cuts, length);
        }
        masses.sort_by(|a, b| a.position.total_cmp(&b.position));
        let (nodes, stretches) = nodes(&supports, &cuts, &masses, &parts);
        let mut counter = Self {
            meeting: meeting(&nodes, &stretches),
            rigid: rigid::count(&supports, &cuts, &masses, parts.clone()),
            means: Means::of(&parts, length),
            length,
            parts,
            supports,
            cuts,
            masses,
            nodes,
            stretches,
            unstable: 0,
        };
        if (counter.parts.iter()).any(|part| part.beam.axial_force < 0.0) {
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
        SHARE * (self.means.bending / self.means.mass).sqrt() / self.length.powi(2)
    }

    /// Number of modes below the angular frequency `omega` > 0, rad/s, those at 0 included, without the unstable ones.
    ///
    /// The left and the right part meet within a long span, at an irregular fraction of it: with a clamp at an end
    /// or in the middle the modes of a part may coincide with those of the whole (a clamped and a free beam have the
    /// same), and the count would lose half its digits there.
    pub(super) fn below(&self, omega: f64) -> usize {
        const SHARE: f64 = 0.414_2;
        let units = self.units(omega);
        let beams = self.parts.iter().map(|part| Part::new(part, omega, &units));
        let mut march = March {
            counter: self,
            omega,
            parts: beams.collect(),
            units,
            known: None,
            count: 0,
        };
        let last = self.stretches.len();
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
        let Means {
            bending,
            mass,
            gyration,
        } = self.means;
        let wave = (bending / (mass * omega * omega)).powf(0.25);
        let length = wave.min(self.length);
        let turn = gyration.sqrt().recip();
        Units {
            length,
            stiffness: bending / length.powi(3),
            motion: [1.0, turn, 1.0, 1.0 / length, turn / length, 1.0 / length],
        }
    }
}

impl Means {
    fn of(parts: &[UniformPart], length: f64) -> Self {
        let mean = |of: fn(&Beam) -> f64| {
            let sum: f64 = (parts.iter())
                .map(|part| of(&part.beam) * (part.end - part.start))
                .sum();
            sum / length
        };
        Self {
            bending: mean(|of| of.material.young_modulus * of.section.second_moment_y),
            mass: mean(|of| of.material.density * of.section.area),
            gyration: mean(|of| of.section.polar_moment / of.section.area),
        }
    }
}

/// A uniform part of the beam at one frequency.
#[derive(Debug)]
struct Part {
    field: Field,
    /// Its own motions from those of the axis, dimensionless; none if they are the same.
    own: Option<Matrix6<f64>>,
}

impl Part {
    fn new(part: &UniformPart, omega: f64, units: &Units) -> Self {
        let matrices = BeamMatrices::new(&part.beam);
        let real = |of: &Symmetric<Complex64>| dimensionless(&of.map(|entry| entry.re), units);
        // E Iy, and the square of the length over it.
        let bending = units.stiffness * units.length.powi(3);
        let square = units.length * units.length / bending;
        let quartic = square * units.length * units.length;
        let [w, v] = [matrices.shear.w, matrices.shear.v].map(|compliance| compliance.re / square);
        // It is on the axis.
        let Point { y, z } = part.offset;
        let foundation = Symmetric::diagonal(matrices.foundation).moved(Point { y: -y, z: -z });
        let field = Field {
            bending: real(&matrices.bending) / bending,
            tension: real(&matrices.tension) * square,
            rotary: dimensionless(&matrices.rotary, units) * (omega * omega * square),
            shear: Matrix3::from_diagonal(&Vector3::new(w, 0.0, v)),
            inertia: dimensionless(&matrices.mass, units) * (omega * omega * quartic),
            foundation: real(&foundation) * quartic,
        };
        Self {
            field,
            own: units.of_line(part.offset),
        }
    }
}

/// A matrix over (w, psi, v) with twist in its unit.
fn dimensionless(of: &Symmetric<f64>, units: &Units) -> Matrix3<f64> {
    let rows = of.rows();
    Matrix3::from_fn(|i, j| rows[i][j] * units.motion[i] * units.motion[j])
}

/// Whether the warping of an end decays within so little of a length, m, that it does not affect the count.
fn decays_at_once(beam: &Beam, length: f64) -> bool {
    const NEGLIGIBLE: f64 = 1e-12;
    let (material, section) = (&beam.material, &beam.section);
    material.young_modulus * section.warping_constant
        < NEGLIGIBLE * material.shear_modulus * section.torsion_constant * length.powi(2)
}

/// Moves the ends of parts to the supports that are as good as there.
fn move_ends(parts: &mut [UniformPart], model: &Model, length: f64) {
    let (supports, cuts) = (Restrained::all(model, parts), Cut::all(model, parts));
    for right in 1..parts.len() {
        let end = near_support(parts[right].start, &supports, &cuts, length);
        parts[right - 1].end = end;
        parts[right].start = end;
    }
}

/// The position of a support that fixes a motion, if a position is as good as there and no joint is between them: the
/// stiffness of the beam between them would be so large that rounding hides everything else. All in m.
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

/// The positions of supports, joints, masses and ends of parts, and the beam between them.
fn nodes(
    supports: &[Restrained],
    cuts: &[Cut],
    masses: &[Mass],
    parts: &[UniformPart],
) -> (Vec<Node>, Vec<Stretch>) {
    let of_supports = supports.iter().map(|support| support.position);
    let mut positions: Vec<f64> = of_supports
        .chain(cuts.iter().map(|cut| cut.position))
        .chain(masses.iter().map(|mass| mass.position))
        .chain(parts[1..].iter().map(|part| part.start))
        .collect();
    positions.sort_by(f64::total_cmp);
    positions.dedup();
    let inner = &parts[..parts.len() - 1];
    let stretch = |ends: &[f64]| Stretch {
        length: ends[1] - ends[0],
        part: inner.partition_point(|part| part.end <= ends[0]),
    };
    let stretches = positions.windows(2).map(stretch).collect();
    let node = |x: &f64| {
        let held = supports.partition_point(|of| of.position < *x)
            ..supports.partition_point(|of| of.position <= *x);
        let sides = [
            inner.partition_point(|part| part.end < *x),
            inner.partition_point(|part| part.end <= *x),
        ];
        let warps = UniformPart::at(parts, *x).warps();
        Node {
            cut: cuts.iter().position(|cut| cut.position == *x),
            fixed: Fixed::by(&supports[held.clone()]),
            supports: held,
            masses: masses.partition_point(|of| of.position < *x)
                ..masses.partition_point(|of| of.position <= *x),
            without_warping: sides.map(|side| warps && !parts[side].warps()),
        }
    };
    (positions.iter().map(node).collect(), stretches)
}

/// The index of the stretch where both eliminations meet.
fn meeting(nodes: &[Node], stretches: &[Stretch]) -> usize {
    let is_one_way = |node: &Node| node.cut.is_some() && node.fixed.motions != [false; 6];
    let first = nodes.iter().rposition(is_one_way).unwrap_or(0);
    let by_length = |&a: &usize, &b: &usize| stretches[a].length.total_cmp(&stretches[b].length);
    (first..stretches.len()).max_by(by_length).unwrap_or(0)
}

/// The elimination of stations at one frequency.
struct March<'a> {
    counter: &'a Counter,
    omega: f64,
    units: Units,
    parts: Vec<Part>,
    /// The last span, with its length and its part, for the next of that kind.
    known: Option<(f64, Field, Span)>,
    /// Number of negative pivots, and of modes of clamped spans and blocked masses, so far.
    count: usize,
}

impl March<'_> {
    /// From the left or the right end over nodes, each with the stretch behind it, and a fraction of the last stretch;
    /// returns the dynamic stiffness of all this, in a frame that points away from the end.
    fn over(&mut self, path: &[(usize, usize)], share: f64, is_left: bool) -> Matrix6<f64> {
        let mut stiffness = Matrix6::zeros();
        let last = path.len() - 1;
        for (step, &(node, stretch)) in path.iter().enumerate() {
            let node = &self.counter.nodes[node];
            let [left, right] = node.without_warping;
            let [before, beyond] = if is_left {
                [left, right]
            } else {
                [right, left]
            };
            if before {
                without_bimoment(&mut stiffness);
            }
            if is_left {
                self.join(node, &mut stiffness);
            }
            self.attach(node, &mut stiffness);
            if !is_left {
                self.join(node, &mut stiffness);
            }
            let mut fixed = node.fixed;
            if beyond {
                self.end_warping(&mut fixed, &mut stiffness);
            }
            let part = if step == last { share } else { 1.0 };
            let Stretch { length, part: of } = self.counter.stretches[stretch];
            self.cross((part * length, of), &mut stiffness, fixed);
        }
        stiffness
    }

    /// Moves the stiffness over the joint of a node, if it has one.
    fn join(&mut self, node: &Node, stiffness: &mut Matrix6<f64>) {
        if let Some(cut) = node.cut {
            self.release(self.counter.cuts[cut].links(&self.units), stiffness);
        }
    }

    fn release(&mut self, links: Links, stiffness: &mut Matrix6<f64>) {
        let (beyond, own) = links.beyond(stiffness);
        *stiffness = beyond;
        self.count = self.count.saturating_add(own);
    }

    /// Into a part without warping stiffness: the rate of twist before it is free, unless it is fixed.
    fn end_warping(&mut self, fixed: &mut Fixed, stiffness: &mut Matrix6<f64>) {
        let rate = &mut fixed.motions[BeamMotion::PsiSlope as usize];
        if std::mem::take(rate) {
            without_bimoment(stiffness);
        } else {
            self.release(Links::without_bimoment(), stiffness);
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

    /// Moves the stiffness over a length, m, of a part.
    fn cross(&mut self, (length, part): (f64, usize), stiffness: &mut Matrix6<f64>, fixed: Fixed) {
        let Part { field, own } = &self.parts[part];
        let pieces = field.pieces(length / self.units.length);
        let length = length / pieces as f64;
        let span = match self.known.take() {
            Some((known, of, span)) if known == length && of == *field => span,
            _ => field.span(length / self.units.length),
        };
        let axis = fixed.axis_of_point(&self.units);
        if let Some(axis) = &axis {
            *stiffness = axis.transpose() * *stiffness * axis;
        }
        let first = match (own, axis) {
            (Some(own), Some(axis)) => Some(own * axis),
            (own, axis) => own.or(axis),
        };
        let count = match first {
            Some(first) => cross(&span.starting_with(&first), stiffness, fixed.motions),
            None => cross(&span, stiffness, fixed.motions),
        };
        self.count = self.count.saturating_add(count);
        for _ in 1..pieces {
            let count = cross(&span, stiffness, Fixed::NONE.motions);
            self.count = self.count.saturating_add(count);
        }
        if let Some(own) = own {
            *stiffness = symmetric(own.transpose() * *stiffness * own);
        }
        self.known = Some((length, *field, span));
    }
}

/// A part without warping stiffness ends: its rate of twist is no motion of what is beyond.
fn without_bimoment(stiffness: &mut Matrix6<f64>) {
    stiffness.row_mut(BeamMotion::PsiSlope as usize).fill(0.0);
    stiffness
        .column_mut(BeamMotion::PsiSlope as usize)
        .fill(0.0);
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
