//! Exact derivatives of the responses by every parameter, by the adjoint method.
//!
//! A response is `r = e^T u` with `D(omega, p) u = F` and D symmetric, so that `dr/dp = lambda^T (dF/dp - (dD/dp) u)`
//! with `D lambda = e`: one more solution, under a unit load at the response, gives the derivatives by all parameters.
//! `adjoint` makes these loads, `field` reads the values of a solution where parameters act, `overlap` integrates
//! products of two solutions along the beam in closed form, `product` evaluates `-lambda^T (dD/dp) u` for every
//! parameter and `forces` adds `lambda^T dF/dp`. No derivative is a difference of solutions. `unavailable` explains
//! missing ones.

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

use super::beam_state::BeamState;
use super::kernel::Prepared;
use super::linear::ZERO;
use super::output::{Read, Row, Sum};
use super::plan::Plan;
use super::solution::Solution;
use crate::model::schema::Kind;
use crate::model::{
    BeamMotion, Checked, Group, Model, ParameterId, Quantity, Restraint, SupportId, Target, edit,
};
pub use effect::{Figure, Sensitivity, effects};

use adjoint::{Adjoint, Influence, Part, factor};
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
    /// The response, as in [`sweep`](super::sweep()).
    pub value: Complex64,
    /// Its derivative by the frequency, per Hz.
    pub by_frequency: Complex64,
    /// Its derivative by each parameter, per SI unit (of a phase per degree), in the order of [`Differentiator::ids`].
    /// Real for an energy.
    ///
    /// A position at an end can only move inwards, and a beam can only grow beyond a position at its right end: those
    /// derivatives are one-sided. A warping constant of 0 can only increase, and if a torque acts between the ends or
    /// the rate of twist is fixed, the slope is infinite: the value is not finite. The rate of twist of a beam without
    /// warping stiffness has no adjoint load: its derivatives are NaN, also that by the frequency.
    pub by_parameter: Vec<Complex64>,
}

/// A model laid out once, to differentiate its responses at any frequency.
#[derive(Debug)]
pub struct Differentiator {
    model: Checked,
    /// Prepared as a whole.
    prepared: Prepared,
    parameters: Parameters,
    /// Station of each enabled subsystem, in the order of the model.
    masses: Vec<usize>,
    forces: Vec<Force>,
    /// For each enabled response.
    adjoints: Vec<Adjoint>,
}

/// The solution under the forces of the model, at one frequency.
struct Forced<'a> {
    setting: Setting<'a>,
    /// The state just left of each station.
    solution: Solution,
    spans: Spans,
    field: Field,
}

impl Differentiator {
    /// Lays out a model.
    pub fn new(model: &Checked) -> Self {
        let plan = Plan::new(model);
        let masses = plan.mass_stations(model);
        Self {
            parameters: Parameters::of(model),
            adjoints: Adjoint::all(model, &plan, &masses),
            forces: Force::all(model),
            model: model.clone(),
            masses,
            prepared: Prepared::whole(plan),
        }
    }

    /// The numbers that affect responses, in the order of [`ParameterId::all`]: of the beam, of the supports and joints, and of
    /// the subsystems, forces and responses that are enabled.
    pub fn ids(&self) -> &[ParameterId] {
        &self.parameters.ids
    }

    /// The values of the parameters, SI (phases in degrees), in the order of [`Self::ids`].
    pub fn values(&self) -> &[f64] {
        &self.parameters.values
    }

    /// The derivatives of each enabled response at a frequency, Hz: above 0, or complex in the search for a mode or a
    /// zero.
    pub fn at(&self, frequency: Complex64) -> Vec<Gradient> {
        let forced = self.forced(TAU * frequency);
        let adjoints = self.adjoints.iter();
        adjoints
            .map(|adjoint| self.gradient(&forced, adjoint))
            .collect()
    }

    /// The same for one response, by its index among the enabled ones, which must exist.
    ///
    /// For an energy, which is real, only the real part of the frequency counts.
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
            Adjoint::Sum(sum, None) => self.of_part(forced, sum),
            Adjoint::Sum(sum, Some(over)) => {
                let [sum, over] = [sum, over].map(|part| self.of_part(forced, part));
                sum.over(&over)
            }
            Adjoint::Energy => self.of_energy(forced.setting.omega.re),
        }
    }

    fn of_part(&self, forced: &Forced<'_>, part: &Part) -> Gradient {
        match part {
            Part::Sum(influence) => self.of_sum(forced, influence),
            Part::Held(response) => self.of_held(forced, *response),
        }
    }

    /// The derivatives of a motion that a support fixes: it depends only on the two points of the section, that of the
    /// response and that of the support, between which the twist has an arm.
    fn of_held(&self, forced: &Forced<'_>, index: usize) -> Gradient {
        let mut gradient = Gradient {
            value: ZERO,
            by_frequency: ZERO,
            by_parameter: vec![ZERO; self.ids().len()],
        };
        let response = &self.model.responses[index];
        let Quantity::Motion(Target::Beam(place, motion), measure) = &response.quantity else {
            return gradient;
        };
        let (key, sign) = match motion {
            BeamMotion::W => ("z", 1.0),
            BeamMotion::V => ("y", -1.0),
            BeamMotion::Psi | BeamMotion::WSlope | BeamMotion::PsiSlope | BeamMotion::VSlope => {
                return gradient;
            }
        };
        let x = place.position(self.model.length());
        let mut supports = SupportId::all(&self.model).zip(&forced.field.supports);
        let holds = |id: SupportId| {
            let support = id.support(&self.model);
            id.position(&self.model) == x
                && support[*motion] == Restraint::Fixed
                && support.point.arm(*motion) == response.point.arm(*motion)
        };
        if let Some((id, field)) = supports.find(|(id, _)| holds(*id)) {
            let [times, _] = factor(*measure, forced.setting.omega);
            let moved = sign * times * field.twist;
            for (group, by) in [
                (Group::Response(index), moved),
                (Group::Support(id), -moved),
            ] {
                let is_it = |own: &ParameterId| own.group == group && own.key().key == key;
                if let Some(parameter) = self.ids().iter().position(is_it) {
                    gradient.by_parameter[parameter] = by;
                }
            }
        }
        gradient
    }

    fn of_sum(&self, forced: &Forced<'_>, influence: &Influence) -> Gradient {
        let setting = Setting {
            plan: &influence.prepared.plan,
            ..forced.setting
        };
        let mut solution = influence.prepared.solution(setting.omega);
        let mut edge = influence.edge.clone();
        let mut lambda = Field::new(&setting, &solution);
        if let Some(spring) = &influence.spring {
            let pull = spring.pull(setting);
            solution.scale(pull);
            edge.scale(pull);
            lambda.scale(pull);
            lambda.strain(&setting, spring, pull);
        }
        let spans = [&solution.spans[..], &forced.solution.spans];
        let product = Product {
            setting,
            lambda: &lambda,
            u: &forced.field,
            overlaps: forced
                .spans
                .overlaps(&self.prepared.plan, &solution.waves, spans),
        };
        let held = BeamState {
            force: forces::held(&self.forces),
            ..BeamState::ZERO
        };
        let mut by_parameter = product.by_parameter(self.ids(), [&edge, &held]);
        let reader = Reader::new(setting.plan, &solution);
        for force in &self.forces {
            by_parameter.extend(force.by_parameter(setting.plan, &lambda, &reader));
        }
        by_parameter.extend(self.by_points(forced, influence));
        let mut by_frequency = product.by_omega();
        let is_unknown = |Read { station, row }: Read| {
            let is_rate = matches!(row, Row::Motion(BeamMotion::PsiSlope, _));
            is_rate && setting.plan.beam(station).without_warping()
        };
        if self.terms(&influence.sum).any(|(_, read)| is_unknown(read)) {
            let unknown = Complex64::new(f64::NAN, f64::NAN);
            by_parameter.fill(unknown);
            by_frequency = unknown;
        }
        let reads = influence.sum.terms.iter();
        let reads = reads.map(|(factor, read)| factor * forced.solution.reads[*read]);
        let value: Complex64 = reads.sum();
        let [times, growth] = factor(influence.sum.measure, setting.omega);
        for value in &mut by_parameter {
            *value *= times;
        }
        Gradient {
            value: times * value,
            by_frequency: TAU * (growth * value + times * by_frequency),
            by_parameter,
        }
    }

    /// The reads of a sum with their factors.
    fn terms(&self, sum: &Sum) -> impl Iterator<Item = (f64, Read)> {
        let reads = &self.prepared.plan.reads;
        let terms = sum.terms.iter();
        terms.map(|(factor, read)| (*factor, reads[*read]))
    }

    /// The change of a motion by the points of all responses, in the order of the rows: it depends on its own point only.
    fn by_points(&self, forced: &Forced<'_>, influence: &Influence) -> Vec<Complex64> {
        let reader = Reader::new(&self.prepared.plan, &forced.solution);
        let twist = self.terms(&influence.sum).map(|(factor, read)| {
            let moved = reader.end(read.station).motion;
            match read.row {
                Row::Motion(BeamMotion::W, _) => factor * moved[BeamMotion::Psi as usize],
                Row::Motion(BeamMotion::V, _) => -factor * moved[BeamMotion::Psi as usize],
                Row::Motion(..)
                | Row::Force(_)
                | Row::Reaction(..)
                | Row::Mass(_)
                | Row::Spring(..)
                | Row::OnFixed(_) => ZERO,
            }
        });
        let own: Complex64 = twist.sum();
        let all = self.model.responses.iter().enumerate();
        let with_point = all.filter(|(_, response)| response.enabled && response.has_point());
        with_point
            .map(|(index, _)| {
                if index == influence.response {
                    own
                } else {
                    ZERO
                }
            })
            .collect()
    }
}

impl Gradient {
    /// That of the ratio to another response.
    fn over(mut self, divisor: &Self) -> Self {
        let ratio = self.value / divisor.value;
        let quotient = |by: Complex64, of: Complex64| (by - ratio * of) / divisor.value;
        for (by, of) in self.by_parameter.iter_mut().zip(&divisor.by_parameter) {
            *by = quotient(*by, *of);
        }
        Self {
            value: ratio,
            by_frequency: quotient(self.by_frequency, divisor.by_frequency),
            ..self
        }
    }
}

/// Parameters with their values.
#[derive(Debug, Default)]
struct Parameters {
    ids: Vec<ParameterId>,
    /// SI.
    values: Vec<f64>,
}

impl Parameters {
    /// The numbers of the beam, of the supports and joints, and of the subsystems, forces and responses that are enabled.
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
        Group::Beam
        | Group::Material(_)
        | Group::Section(_)
        | Group::Foundation(_)
        | Group::Span(_)
        | Group::Support(_)
        | Group::Motion(..)
        | Group::Joint(_)
        | Group::Link(..) => true,
        Group::Subsystem(index) => model.subsystems[index].enabled,
        Group::Branch(spring, _) => acts(model, spring.owner()),
        Group::Force(index) => model.forces[index].enabled,
        Group::Response(index) => model.responses[index].enabled,
        Group::Model
        | Group::Spans
        | Group::Supports
        | Group::Joints
        | Group::Subsystems
        | Group::Forces
        | Group::Responses
        | Group::Sweep
        | Group::Studies
        | Group::Study(_)
        | Group::Tune
        | Group::Variable(_)
        | Group::Objective(_)
        | Group::Limit(_) => false,
    }
}
