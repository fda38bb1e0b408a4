//! The modes inside a circle in the plane of omega: roots and motions, several at once, equal ones included.
//!
//! For loads F and their responses, `H(omega) = F^T D(omega)^-1 F` has a pole at each root,
//! `-x x^T / (2 omega_k (omega - omega_k))` with `x = F^T phi` and `phi^T (2 omega M - i C) phi = 2 omega`. The contour
//! integrals of H and of `omega H` along the circle contain only the poles inside, so as many independent loads as roots
//! give a small pencil whose eigenvalues are the roots (Beyn, Linear Algebra Appl. 436 (2012) 3839-3863; Sakurai &
//! Sugiura, J. Comput. Appl. Math. 159 (2003) 119-128). The integral of the responses gives the motions.

use nalgebra::DMatrix;
use num_complex::Complex64;
use rayon::prelude::*;

use super::is_damped;
use super::loads::{combined, loads};
use super::motion::Motion;
use super::orthogonal::bi_orthogonalise;
use super::pencil::{Pair, pairs};
use crate::model::{
    BeamMotion, Force, MassMotion, Measure, Model, Place, Point, Quantity, Response, SupportId,
    Target,
};
use crate::solve::beam_matrices::Symmetric;
use crate::solve::kernel::{Prepared, Solver, waves};
use crate::solve::output::{Read, Row};
use crate::solve::plan::Plan;
use crate::solve::quadrature::{Node, nodes};
use crate::solve::waves::BeamConstants;

/// A circle in the plane of omega, rad/s, and the number of its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Circle {
    pub(super) centre: Complex64,
    pub(super) radius: f64,
    pub(super) points: usize,
}

impl Circle {
    /// Around roots (rad/s), with `gap` from their mean to any other: the integrals are right to about 1e-13.
    pub(super) fn around(roots: &[Complex64], gap: f64) -> Self {
        const LEAST: f64 = 1e-3;
        const DIGITS: f64 = 26.0;
        // Roots beyond the end of a list are unknown.
        const SEEN: f64 = 0.1;
        const ROOM: f64 = 5.0;
        let centre = roots.iter().sum::<Complex64>() / roots.len() as f64;
        let size = roots
            .iter()
            .map(|root| (root - centre).norm())
            .fold(0.0, f64::max);
        let gap = gap.min((SEEN * centre.norm()).max(ROOM * size));
        // Roots inside and outside contribute equally to the error.
        let radius = (size * gap).sqrt().max(LEAST * gap);
        let share = (size / radius).max(radius / gap);
        // Roots outside contribute to the integral with the first moment by a lower power, and there the error must be
        // small compared with the differences of the roots.
        let more = if roots.len() > 1 { 2.0 } else { 0.0 };
        let points = (more + (DIGITS / -share.ln()).ceil()).clamp(2.0, 64.0);
        Self {
            centre,
            radius,
            points: points as usize,
        }
    }

    /// Its points relative to its centre and radius (angles without the real axis, on which a pole of the responses may
    /// lie).
    fn directions(self) -> impl Iterator<Item = Complex64> {
        let points = self.points as f64;
        let angle = move |index: usize| std::f64::consts::TAU * (index as f64 + 0.5) / points;
        (0..self.points).map(move |index| Complex64::from_polar(1.0, angle(index)))
    }
}

/// A model with the positions at which its motion is read.
#[derive(Debug, Clone)]
pub(super) struct Probe<'a> {
    model: &'a Model,
    /// Positions to read the shape, m.
    pub(super) looked_at: Vec<f64>,
    /// The nodes of the integrals along the beam.
    pub(super) nodes: Vec<Node>,
    /// The motions that have inertia along the beam: slopes only with rotary inertia.
    read: &'static [BeamMotion],
}

impl<'a> Probe<'a> {
    /// For modes near `omega`, rad/s.
    pub(super) fn new(model: &'a Model, omega: Complex64, looked_at: Vec<f64>) -> Self {
        let parts = model.uniform_parts();
        let beams = parts.iter().map(|part| BeamConstants::new(part, true));
        let beams: Vec<BeamConstants> = beams.collect();
        let kappa: Vec<Complex64> = beams
            .iter()
            .flat_map(|beam| waves(beam, omega).kappa)
            .collect();
        let inner = model.supports.inner.iter().map(|of| of.position);
        let joints = model.joints.iter().map(|of| of.position);
        let mut stations: Vec<f64> = model
            .attached()
            .map(|of| of.position)
            .chain(inner)
            .chain(joints)
            .chain(parts[1..].iter().map(|part| part.start))
            .collect();
        stations.sort_by(f64::total_cmp);
        Self {
            model,
            looked_at,
            nodes: nodes(stations, &kappa, model.length()),
            read: if beams
                .iter()
                .all(|beam| beam.matrices.rotary == Symmetric::ZERO)
            {
                &DISPLACEMENTS
            } else {
                &BeamMotion::ALL
            },
        }
    }

    /// The motions of the modes inside a circle that has these roots, rad/s, in their order and bi-orthogonal: `phi_i^T
    /// ((omega_i + omega_j) M - i C) phi_j = 2 omega_i` for i = j and otherwise 0. `None` if noise hides their
    /// differences.
    pub(super) fn motions(&self, circle: Circle, roots: &[Complex64]) -> Option<Vec<Motion>> {
        let moments = Moments::new(self.model, &self.responses(), circle, roots.len());
        let mut found = Vec::new();
        let mut motions = Vec::new();
        for (root, Pair { vector, .. }) in nearest(roots, moments.modes()?) {
            // The integral of the responses is -phi x^T / 2 omega_k, and the vector has x^T y = i sqrt(2 omega_k).
            let factor = Complex64::I * (2.0 * root).sqrt();
            let values = moments.answers.iter().zip(vector.iter());
            let mut motion = vec![Complex64::ZERO; moments.answers[0].len()];
            for (answer, share) in values {
                for (sum, value) in motion.iter_mut().zip(answer) {
                    *sum += factor * share * value;
                }
            }
            found.push(root);
            motions.push(self.motion(&motion));
        }
        if !is_damped(self.model) {
            motions.iter_mut().for_each(Motion::make_real);
        }
        bi_orthogonalise(self.model, &self.nodes, &found, &mut motions).then_some(motions)
    }

    /// No motion.
    pub(super) fn at_rest(&self) -> Motion {
        let answers = self.responses().len() + lefts_of_joints(self.model);
        self.motion(&vec![Complex64::ZERO; answers])
    }

    /// The positions along the beam in the order of [`Motion::beam`], m.
    pub(super) fn places(&self) -> impl Iterator<Item = f64> {
        let nodes = self.nodes.iter().map(|node| node.x);
        self.looked_at.iter().copied().chain(nodes)
    }

    /// The outputs, in the order of [`Self::motion`], which also needs the motions left of each joint.
    fn responses(&self) -> Vec<Response> {
        let mut targets = Vec::new();
        let on_axis = |target| response(target, Point::AXIS);
        for x in self.places() {
            let place = Place::Position(x);
            targets.extend((self.read.iter()).map(|&motion| on_axis(Target::Beam(place, motion))));
        }
        for subsystem in self.model.attached() {
            let place = Place::Position(subsystem.position);
            targets.extend(DISPLACEMENTS.map(|motion| on_axis(Target::Beam(place, motion))));
        }
        for support in SupportId::all(self.model) {
            let place = Place::Position(support.position(self.model));
            let point = support.support(self.model).point;
            targets.extend(BeamMotion::ALL.map(|motion| {
                let point = if motion.is_translation() {
                    point
                } else {
                    Point::AXIS
                };
                response(Target::Beam(place, motion), point)
            }));
        }
        for subsystem in self.model.attached() {
            let of = |motion| on_axis(Target::Mass(subsystem.name.clone(), motion));
            targets.extend(MassMotion::ALL.map(of));
        }
        for joint in &self.model.joints {
            let place = Place::Position(joint.position);
            targets.extend(BeamMotion::ALL.map(|motion| on_axis(Target::Beam(place, motion))));
        }
        targets
    }

    fn motion(&self, values: &[Complex64]) -> Motion {
        let triples = |values: &[Complex64]| -> Vec<[Complex64; 3]> {
            values
                .chunks_exact(3)
                .map(|chunk| [chunk[0], chunk[1], chunk[2]])
                .collect()
        };
        let read = self.read.len();
        let (beam, rest) = values.split_at(read * (self.looked_at.len() + self.nodes.len()));
        let (stations, rest) = rest.split_at(3 * self.model.attached().count());
        let (supports, rest) = rest.split_at(6 * SupportId::all(self.model).count());
        let (masses, rest) = rest.split_at(3 * self.model.attached().count());
        let (after, before) = rest.split_at(6 * self.model.joints.len());
        let sides = after.chunks_exact(6).zip(before.chunks_exact(6));
        Motion {
            beam: beam
                .chunks_exact(read)
                .map(|chunk| std::array::from_fn(|row| chunk.get(row).copied().unwrap_or_default()))
                .collect(),
            stations: triples(stations),
            supports: supports
                .chunks_exact(6)
                .map(|chunk| std::array::from_fn(|row| chunk[row]))
                .collect(),
            joints: sides
                .map(|(after, before)| std::array::from_fn(|row| after[row] - before[row]))
                .collect(),
            masses: triples(masses),
        }
    }
}

/// The `count` roots inside a circle, rad/s, by ascending |omega|; `None` if noise hides their differences.
pub(super) fn roots_inside(model: &Model, circle: Circle, count: usize) -> Option<Vec<Complex64>> {
    let modes = Moments::new(model, &[], circle, count).modes()?;
    Some(modes.into_iter().map(|(root, _)| root).collect())
}

/// Loads that each excite one of the modes inside a circle that has these roots, rad/s, in their order; `None` if noise
/// hides their differences.
pub(super) fn isolating_loads(
    model: &Model,
    circle: Circle,
    roots: &[Complex64],
) -> Option<Vec<Vec<Force>>> {
    let moments = Moments::new(model, &[], circle, roots.len());
    let modes = nearest(roots, moments.modes()?);
    let isolating = modes.into_iter().map(|(_, pair)| {
        let size = pair
            .vector
            .iter()
            .map(|share| share.norm())
            .fold(0.0, f64::max);
        combined(&moments.loads, &(pair.vector / Complex64::from(size)))
    });
    Some(isolating.collect())
}

/// Assigns to each root the nearest of the remaining modes.
fn nearest(roots: &[Complex64], mut modes: Vec<(Complex64, Pair)>) -> Vec<(Complex64, Pair)> {
    let mut ordered = Vec::new();
    for root in roots {
        let distance = |index: &usize| (modes[*index].0 - root).norm();
        let nearest = (0..modes.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        if let Some(nearest) = nearest {
            ordered.push(modes.remove(nearest));
        }
    }
    ordered
}

/// Contour integrals of the responses to some loads.
struct Moments {
    circle: Circle,
    /// All at the same positions.
    loads: Vec<Vec<Force>>,
    /// Of H and of H times the point on the circle, relative to its centre.
    forms: [DMatrix<Complex64>; 2],
    /// Of the responses, by load.
    answers: Vec<Vec<Complex64>>,
}

impl Moments {
    /// For as many loads as modes, which are independent in the modes: this does not magnify rounding.
    fn new(model: &Model, responses: &[Response], circle: Circle, count: usize) -> Self {
        const FEW: usize = 4;
        let loads = (0..count).map(|load| loads(model, load)).collect();
        if count == 1 {
            return Self::of(model, responses, circle, loads);
        }
        // A few points are enough to check their independence.
        let few = Circle {
            points: circle.points.min(FEW),
            ..circle
        };
        let tried = Self::of(model, &[], few, loads);
        let loads = tried.independent().unwrap_or(tried.loads);
        Self::of(model, responses, circle, loads)
    }

    fn of(model: &Model, responses: &[Response], circle: Circle, loads: Vec<Vec<Force>>) -> Self {
        let integrals: Vec<[Vec<Complex64>; 2]> = loads
            .par_iter()
            .map_init(Solver::default, |solver, forces| {
                integrals(model, responses, forces, circle, solver)
            })
            .collect();
        // The imaginary parts are rounding, but would mix equal modes.
        let is_real = !is_damped(model);
        let count = loads.len();
        let answers = responses.len() + lefts_of_joints(model);
        let form = |power: usize| {
            DMatrix::from_fn(count, count, |other, load| {
                let moved = &integrals[load][power][answers..];
                let works = loads[other].iter().zip(moved);
                let work: Complex64 = works.map(|(force, moved)| force.amplitude * moved).sum();
                if is_real { work.re.into() } else { work }
            })
        };
        Self {
            circle,
            forms: [form(0), form(1)],
            answers: integrals
                .iter()
                .map(|by_power| by_power[0][..answers].to_vec())
                .collect(),
            loads,
        }
    }

    /// Combinations of the loads that are independent in the modes; `None` if the loads already are, or if noise hides
    /// the differences of the modes.
    fn independent(&self) -> Option<Vec<Vec<Force>>> {
        const INDEPENDENT: f64 = 0.03;
        const NOISE: f64 = 1e-11;
        let form = &self.forms[0];
        if !form.iter().all(|value| value.is_finite()) {
            return None;
        }
        // Real combinations, so that the motions of a model without damping stay real.
        let count = form.ncols();
        let parts = DMatrix::from_fn(2 * count, count, |row, column| {
            if row < count {
                form[(row, column)].re
            } else {
                form[(row - count, column)].im
            }
        });
        let svd = parts.try_svd(false, true, f64::EPSILON, 0)?;
        let directions = svd.v_t?;
        let (least, largest) = (svd.singular_values.min(), svd.singular_values.max());
        if least > INDEPENDENT * largest || least <= NOISE * largest {
            return None;
        }
        let directions = directions.row_iter().zip(&svd.singular_values);
        let weights = directions.map(|(row, value)| {
            let weight = (value / largest).sqrt().recip();
            row.transpose().map(|share| Complex64::from(weight * share))
        });
        Some(
            weights
                .map(|shares| combined(&self.loads, &shares))
                .collect(),
        )
    }

    /// Each root with its vector, by ascending |omega|.
    fn modes(&self) -> Option<Vec<(Complex64, Pair)>> {
        // Relative to a root.
        const ROUNDING: f64 = 1e-13;
        let [first, second] = &self.forms;
        let finite = first.iter().chain(second).all(|value| value.is_finite());
        let pairs = if finite {
            let noise = ROUNDING * self.circle.centre.norm() / self.circle.radius;
            pairs(first, second, noise)?
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

/// The number of motions left of joints.
fn lefts_of_joints(model: &Model) -> usize {
    BeamMotion::ALL.len() * model.joints.len()
}

/// The motions just left of each joint, where no response is read.
fn left_of_joints(plan: &Plan, model: &Model) -> Vec<Read> {
    let reads = |(station, _)| {
        BeamMotion::ALL.map(|motion| Read {
            station,
            row: Row::Motion(motion, 0.0),
        })
    };
    plan.joined(model).flat_map(reads).collect()
}

/// Integrals along the circle, over 2 pi i, of the responses, of the motions left of the joints and of the motions at the
/// loads, times 1 and times the point on the circle.
fn integrals(
    model: &Model,
    responses: &[Response],
    forces: &[Force],
    circle: Circle,
    solver: &mut Solver,
) -> [Vec<Complex64>; 2] {
    let own = forces
        .iter()
        .map(|force| response(force.target.clone(), force.point));
    let mut plan = Plan::new(&Model {
        forces: forces.to_vec(),
        responses: responses.iter().cloned().chain(own).collect(),
        ..model.clone()
    });
    let lefts = left_of_joints(&plan, model).into_iter();
    let lefts: Vec<_> = lefts.map(|read| plan.output_of(read)).collect();
    plan.outputs.splice(responses.len()..responses.len(), lefts);
    let prepared = Prepared::new(plan);
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

const DISPLACEMENTS: [BeamMotion; 3] = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V];

fn response(target: Target, point: Point) -> Response {
    Response {
        name: String::new(),
        enabled: true,
        quantity: Quantity::Motion(target, Measure::Displacement),
        point,
        over: None,
    }
}
