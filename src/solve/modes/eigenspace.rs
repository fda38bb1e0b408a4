//! The modes inside a circle in the plane of omega: roots and motions, several at once, equal ones included.
//!
//! Between loads F and the answers to them, `H(omega) = F^T D(omega)^-1 F` has a pole at each root,
//! `-x x^T / (2 omega_k (omega - omega_k))` with `x = F^T phi` and `phi^T (2 omega M - i C) phi = 2 omega`. The contour
//! integrals of H and of `omega H` along the circle hold the poles inside and nothing else, so that as many independent
//! loads as roots make a small pencil whose eigenvalues are the roots (Beyn, Linear Algebra Appl. 436 (2012) 3839-3863;
//! Sakurai & Sugiura, J. Comput. Appl. Math. 159 (2003) 119-128). The integral of the answers gives the motions.

use nalgebra::DMatrix;
use num_complex::Complex64;
use rayon::prelude::*;

use super::motion::Motion;
use super::pencil::{Pair, pairs};
use super::quadrature::{Sample, samples};
use crate::model::{
    BeamMotion, Force, MassMotion, Measure, Model, Place, Quantity, Response, Target,
};
use crate::solve::lanes::{Prepared, Solver};
use crate::solve::plan::Plan;

/// A circle in the plane of omega, rad/s, and how many points of it are looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Circle {
    pub(super) centre: Complex64,
    pub(super) radius: f64,
    pub(super) points: usize,
}

impl Circle {
    /// Around roots (rad/s), with `gap` from their mean to any other: the integrals are right to about 1e-13.
    pub(super) fn around(roots: &[Complex64], gap: f64) -> Self {
        const LEAST: f64 = 1e-5;
        const DIGITS: f64 = 26.0;
        let centre = roots.iter().sum::<Complex64>() / roots.len() as f64;
        let size = roots
            .iter()
            .map(|root| (root - centre).norm())
            .fold(0.0, f64::max);
        // What lies inside and what lies outside have the same share in the error.
        let radius = (size * gap).sqrt().max(LEAST * gap);
        let share = (size / radius).max(radius / gap);
        let points = (DIGITS / -share.ln()).ceil().clamp(2.0, 64.0);
        Self {
            centre,
            radius,
            points: points as usize,
        }
    }

    /// Its points (angles without the real axis, on which a pole of the answers may lie), as seen from its centre over
    /// its radius.
    fn directions(self) -> impl Iterator<Item = Complex64> {
        let points = self.points as f64;
        let angle = move |index: usize| std::f64::consts::TAU * (index as f64 + 0.5) / points;
        (0..self.points).map(move |index| Complex64::from_polar(1.0, angle(index)))
    }
}

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

    /// The `count` modes inside a circle; none where they cannot be told apart from noise.
    pub(super) fn eigenspace(&self, circle: Circle, count: usize) -> Option<Eigenspace> {
        let moments = Moments::new(self.model, &self.responses(), circle, count);
        let mut roots = Vec::new();
        let mut motions = Vec::new();
        for (root, Pair { vector, .. }) in moments.modes()? {
            // The integral of the answers is -phi x^T / 2 omega_k, and the vector has x^T y = i sqrt(2 omega_k).
            let factor = Complex64::I * (2.0 * root).sqrt();
            let values = moments.answers.iter().zip(vector.iter());
            let mut motion = vec![Complex64::ZERO; moments.answers[0].len()];
            for (answer, share) in values {
                for (sum, value) in motion.iter_mut().zip(answer) {
                    *sum += factor * share * value;
                }
            }
            roots.push(root);
            motions.push(self.motion(&motion));
        }
        Some(Eigenspace { roots, motions })
    }

    /// Nothing moves.
    pub(super) fn at_rest(&self) -> Motion {
        self.motion(&vec![Complex64::ZERO; self.responses().len()])
    }

    /// The places along the beam in the order of [`Motion::beam`], m.
    pub(super) fn places(&self) -> impl Iterator<Item = f64> {
        let sampled = self.samples.iter().map(|sample| sample.position);
        self.looked_at.iter().copied().chain(sampled)
    }

    /// What is read, in the order of [`Self::motion`].
    fn responses(&self) -> Vec<Response> {
        let mut targets = Vec::new();
        for x in self.places() {
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
        let (ends, masses) = rest.split_at(12);
        Motion {
            beam: triples(beam),
            ends: [
                std::array::from_fn(|row| ends[row]),
                std::array::from_fn(|row| ends[6 + row]),
            ],
            masses: triples(masses),
        }
    }
}

/// The `count` roots inside a circle, rad/s, by rising |omega|; none where they cannot be told apart from noise.
pub(super) fn roots_inside(model: &Model, circle: Circle, count: usize) -> Option<Vec<Complex64>> {
    let modes = Moments::new(model, &[], circle, count).modes()?;
    Some(modes.into_iter().map(|(root, _)| root).collect())
}

/// Contour integrals of the answers to some loads.
struct Moments {
    circle: Circle,
    /// Of H and of H times the place on the circle, as its centre sees it.
    forms: [DMatrix<Complex64>; 2],
    /// Of the responses, by load.
    answers: Vec<Vec<Complex64>>,
}

impl Moments {
    fn new(model: &Model, responses: &[Response], circle: Circle, count: usize) -> Self {
        let loads: Vec<Vec<Force>> = (0..count).map(|load| loads(model, load)).collect();
        let integrals: Vec<[Vec<Complex64>; 2]> = loads
            .par_iter()
            .map_init(Solver::default, |solver, forces| {
                integrals(model, responses, forces, circle, solver)
            })
            .collect();
        let form = |power: usize| {
            DMatrix::from_fn(count, count, |other, load| {
                let moved = &integrals[load][power][responses.len()..];
                let works = loads[other].iter().zip(moved);
                works.map(|(force, moved)| force.amplitude * moved).sum()
            })
        };
        Self {
            circle,
            forms: [form(0), form(1)],
            answers: integrals
                .iter()
                .map(|by_power| by_power[0][..responses.len()].to_vec())
                .collect(),
        }
    }

    /// Each root with its vector, by rising |omega|.
    fn modes(&self) -> Option<Vec<(Complex64, Pair)>> {
        let [first, second] = &self.forms;
        let finite = first.iter().chain(second).all(|value| value.is_finite());
        let pairs = if finite {
            pairs(first, second)?
        } else {
            return None;
        };
        let root = |value: Complex64| self.circle.centre + self.circle.radius * value;
        let mut modes: Vec<_> = pairs
            .into_iter()
            .map(|pair| (root(pair.value), pair))
            .collect();
        modes.sort_by(|(a, _), (b, _)| a.norm().total_cmp(&b.norm()));
        Some(modes)
    }
}

/// Integrals along the circle, over 2 pi i, of the responses and of what the loads' places do, times 1 and times the
/// place on the circle.
fn integrals(
    model: &Model,
    responses: &[Response],
    forces: &[Force],
    circle: Circle,
    solver: &mut Solver,
) -> [Vec<Complex64>; 2] {
    let own = forces.iter().map(|force| response(force.target.clone()));
    let prepared = Prepared::new(Plan::new(&Model {
        forces: forces.to_vec(),
        responses: responses.iter().cloned().chain(own).collect(),
        ..model.clone()
    }));
    let directions: Vec<Complex64> = circle.directions().collect();
    let omegas: Vec<Complex64> = directions
        .iter()
        .map(|direction| circle.centre + circle.radius * direction)
        .collect();
    let mut values = vec![vec![Complex64::ZERO; omegas.len()]; prepared.plan.outputs.len()];
    let mut columns: Vec<&mut [Complex64]> = values.iter_mut().map(Vec::as_mut_slice).collect();
    solver.solve(&prepared, &omegas, &mut columns);
    let integral = |power: i32| {
        let sum = |values: &Vec<Complex64>| -> Complex64 {
            let terms = directions.iter().zip(values);
            terms.map(|(to, value)| to.powi(1 + power) * value).sum()
        };
        let weight = circle.radius / circle.points as f64;
        values.iter().map(|values| weight * sum(values)).collect()
    };
    [integral(0), integral(1)]
}

/// Loads at some places of the beam and on every mass; those of different numbers `load` are independent.
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
        let arm = if turn > 0.0 {
            turn
        } else {
            // It may creep without inertia.
            subsystem.arm_left.abs() + subsystem.arm_right.abs()
        };
        for (motion, arm) in [
            (MassMotion::Y, 1.0),
            (MassMotion::Z, 1.0),
            (MassMotion::Theta, arm),
        ] {
            targets.push((Target::Mass(subsystem.name.clone(), motion), arm));
        }
    }
    targets
        .into_iter()
        .enumerate()
        .map(|(index, (target, arm))| Force {
            enabled: true,
            target,
            amplitude: arm * uneven(index, load),
            phase: 0.0,
        })
        .collect()
}

/// A number between -1 and 1 for each pair of numbers, without any pattern.
///
/// Sines or other smooth functions would not do: sin(a index + b load) has rank 2.
/// Source of the mixing: Steele, Lea & Flood, OOPSLA 2014, 453-472 (`SplitMix64`).
fn uneven(index: usize, load: usize) -> f64 {
    let mut bits = (index as u64 + 1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add((load as u64 + 1).wrapping_mul(0xd1b5_4a32_d192_ed03));
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^= bits >> 31;
    (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

const DISPLACEMENTS: [BeamMotion; 3] = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V];

fn response(target: Target) -> Response {
    Response {
        name: String::new(),
        enabled: true,
        quantity: Quantity::Motion(target, Measure::Displacement),
    }
}
