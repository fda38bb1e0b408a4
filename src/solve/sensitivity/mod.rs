//! Exact derivatives of the responses by every parameter, by the adjoint.
//!
//! A response is `r = e^T u` with `D(omega, p) u = F` and D symmetric, so that `dr/dp = lambda^T (dF/dp - (dD/dp) u)` with
//! `D lambda = e`: for the price of one more solution, under a unit load in the place of the response, come the
//! derivatives by all parameters. `adjoint` lays out these loads, `field` reads what a solution does where parameters
//! act, `overlap` integrates products of two solutions along the beam in closed form, `product` puts
//! `-lambda^T (dD/dp) u` together for every parameter and `forces` adds `lambda^T dF/dp`. Nothing is a difference of
//! solutions.

mod adjoint;
mod effect;
mod energy;
mod field;
mod forces;
mod mean_square;
mod mode;
mod overlap;
mod peak;
mod product;
mod unavailable;

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::kernel::Prepared;
use super::linear::ZERO;
use super::plan::{Event, Plan};
use super::solution::Solution;
use crate::model::schema::Kind;
use crate::model::{BeamMotion, Group, Model, ParameterId, edit};
pub use effect::{Figure, Sensitivity, effects};

use adjoint::{Adjoint, Motion, Reading, factor};
use field::{Field, Reader, Setting};
use forces::Force;
pub use mean_square::MeanSquareGradient;
pub use mode::ModeGradient;
use overlap::Spans;
pub use peak::PeakGradient;
use product::Product;
pub use unavailable::unavailable;

/// The derivatives of one response at one frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// The response, as [`sweep`](super::sweep()) gives it.
    pub value: Complex64,
    /// Its derivative by the frequency, per Hz.
    pub by_frequency: Complex64,
    /// Its derivative by each parameter, per SI unit (of a phase per degree), in the order of [`Differentiator::ids`].
    /// Of an energy real.
    ///
    /// A place at an end can only move inwards, and a beam only grow beyond a place at its right end: those derivatives
    /// are one-sided. A warping constant of 0 can only rise, and where a torque acts between the ends or the
    /// rate of twist is held it does so with an infinite slope: the value is not finite. The rate of twist of a beam without warping
    /// stiffness has no adjoint load: its derivatives are NaN, also that by the frequency.
    pub by_parameter: Vec<Complex64>,
}

/// A model laid out once, to differentiate its responses at any frequency.
#[derive(Debug)]
pub struct Differentiator {
    model: Model,
    /// As a whole.
    prepared: Prepared,
    parameters: Parameters,
    /// Station of each enabled subsystem, in the order of the model.
    masses: Vec<usize>,
    forces: Vec<Force>,
    /// Of each enabled response.
    adjoints: Vec<Adjoint>,
}

/// The solution under the forces of the model, at one frequency.
struct Forced<'a> {
    setting: Setting<'a>,
    /// What the beam does just left of each station.
    solution: Solution,
    spans: Spans,
    field: Field,
}

impl Differentiator {
    /// Lays out a checked model.
    pub fn new(model: &Model) -> Self {
        let plan = Plan::new(model);
        let masses = mass_stations(model, &plan);
        Self {
            parameters: Parameters::of(model),
            adjoints: Adjoint::all(model, &plan, &masses),
            forces: Force::all(model),
            model: model.clone(),
            masses,
            prepared: Prepared::whole(plan),
        }
    }

    /// The numbers that responses depend on, in the order of [`ParameterId::all`]: of the beam, of supports that are not
    /// fixed, and of the subsystems and forces that are enabled.
    pub fn ids(&self) -> &[ParameterId] {
        &self.parameters.ids
    }

    /// The numbers themselves, SI (phases in degrees), in the order of [`Self::ids`].
    pub fn values(&self) -> &[f64] {
        &self.parameters.values
    }

    /// The derivatives of each enabled response at a frequency, Hz: above 0, or complex where a mode or a zero is sought.
    pub fn at(&self, frequency: Complex64) -> Vec<Gradient> {
        let forced = self.forced(TAU * frequency);
        let adjoints = self.adjoints.iter();
        adjoints
            .map(|adjoint| self.gradient(&forced, adjoint))
            .collect()
    }

    /// The same of one response: its index among the enabled ones, which there must be.
    ///
    /// An energy is real and takes the real part of a frequency.
    pub fn response_at(&self, response: usize, frequency: Complex64) -> Gradient {
        self.gradient(&self.forced(TAU * frequency), &self.adjoints[response])
    }

    fn forced(&self, omega: Complex64) -> Forced<'_> {
        let setting = Setting {
            model: &self.model,
            plan: &self.prepared.plan,
            masses: &self.masses,
            omega,
        };
        let solution = self.prepared.solution(omega);
        Forced {
            spans: Spans::new(&self.prepared.plan, &solution),
            field: Field::new(&setting, &solution),
            setting,
            solution,
        }
    }

    fn gradient(&self, forced: &Forced<'_>, adjoint: &Adjoint) -> Gradient {
        match adjoint {
            Adjoint::Motion(motion) => self.of_motion(forced, motion),
            Adjoint::Held => self.nothing(),
            Adjoint::Energy => self.of_energy(forced.setting.omega.re),
        }
    }

    /// Of a motion that does not depend on anything.
    fn nothing(&self) -> Gradient {
        Gradient {
            value: ZERO,
            by_frequency: ZERO,
            by_parameter: vec![ZERO; self.ids().len()],
        }
    }

    fn of_motion(&self, forced: &Forced<'_>, motion: &Motion) -> Gradient {
        let setting = Setting {
            plan: &motion.prepared.plan,
            ..forced.setting
        };
        let solution = motion.prepared.solution(setting.omega);
        let lambda = Field::new(&setting, &solution);
        let spans = [&solution.spans[..], &forced.solution.spans];
        let product = Product {
            setting,
            lambda: &lambda,
            u: &forced.field,
            overlap: forced
                .spans
                .overlap(&self.prepared.plan, &solution.waves, spans),
        };
        let mut by_parameter = product.by_parameter([&motion.held, &forces::held(&self.forces)]);
        let reader = Reader::new(setting.plan, &solution);
        for force in &self.forces {
            by_parameter.extend(force.by_parameter(setting.plan, &lambda, &reader));
        }
        let [times, growth] = factor(motion.measure, setting.omega);
        let mut by_frequency = product.by_omega();
        let is_unknown = self.prepared.plan.beam.without_warping()
            && matches!(
                motion.reading,
                Reading::Beam(_, BeamMotion::PsiSlope) | Reading::MeanTwistRate(_)
            );
        if is_unknown {
            let unknown = Complex64::new(f64::NAN, f64::NAN);
            by_parameter.fill(unknown);
            by_frequency = unknown;
        }
        for value in &mut by_parameter {
            *value *= times;
        }
        let moved = self.read(forced, motion.reading);
        Gradient {
            value: times * moved,
            by_frequency: TAU * (growth * moved + times * by_frequency),
            by_parameter,
        }
    }

    /// A motion under the forces of the model.
    fn read(&self, forced: &Forced<'_>, reading: Reading) -> Complex64 {
        let reader = Reader::new(&self.prepared.plan, &forced.solution);
        let rate = |station: usize| reader.end(station).motion[BeamMotion::PsiSlope as usize];
        match reading {
            Reading::Mass(index, motion) => forced.field.masses[index].motion[motion],
            Reading::Beam(station, motion) => reader.end(station).motion[motion as usize],
            Reading::MeanTwistRate([before, after]) => 0.5 * (rate(before) + rate(after)),
        }
    }
}

/// The station of each enabled subsystem, in the order of the model.
fn mass_stations(model: &Model, plan: &Plan) -> Vec<usize> {
    // Stations lie by rising place, those at one place in the order of the model.
    let positions: Vec<f64> = model.attached().map(|of| of.position).collect();
    let mut order: Vec<usize> = (0..positions.len()).collect();
    order.sort_by(|&a, &b| positions[a].total_cmp(&positions[b]));
    let stations = plan.stations.iter().enumerate();
    let attached = stations.filter(|(_, of)| matches!(of.event, Event::Attachment(_)));
    let mut masses = vec![0; positions.len()];
    for (subsystem, (station, _)) in order.into_iter().zip(attached) {
        masses[subsystem] = station;
    }
    masses
}

/// Numbers with the parameters that they are of.
#[derive(Debug, Default)]
struct Parameters {
    ids: Vec<ParameterId>,
    /// SI.
    values: Vec<f64>,
}

impl Parameters {
    /// Those of the beam, of supports that are not fixed, and of the subsystems and forces that are enabled.
    fn of(model: &Model) -> Self {
        let ids = ParameterId::all(model).into_iter();
        let numbers = ids
            .filter(|id| id.key().kind == Kind::Number && acts(model, id.group))
            .filter_map(|id| Some((id, edit::number(model, id).ok()?)));
        let (ids, values) = numbers.unzip();
        Self { ids, values }
    }
}

/// Whether responses depend on the numbers of a table.
fn acts(model: &Model, group: Group) -> bool {
    match group {
        Group::Beam | Group::Material | Group::Section | Group::Motion(..) => true,
        Group::Subsystem(index) => model.subsystems[index].enabled,
        Group::Force(index) => model.forces[index].enabled,
        _ => false,
    }
}
