//! The derivatives of the vibration energy `E_V`.
//!
//! `E_V = int u^H W u dx` with W = (rho A, rho `I_0`, rho A) on (w, psi, v) is a real function of u, so that `dE_V = 2
//! Re int (W conj(u))^T du dx` plus the change of W itself. The load `W conj(u)` is distributed along the beam: point
//! loads at the nodes of a quadrature that is exact for u and du have the same effect, and their response lambda
//! consists of waves between the nodes like any other.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::adjoint::without_loads;
use super::field::{Field, Reader, Setting};
use super::overlap::Spans;
use super::product::Product;
use super::{Differentiator, Gradient, forces};
use crate::model::schema::{BeamKey, JointKey, MaterialKey, SectionKey, SpanKey};
use crate::model::{Beam, BeamNumber, Group, Model, ParameterId, UniformPart};
use crate::solve::beam_matrices::{Across, Symmetric};
use crate::solve::beam_state::BeamState;
use crate::solve::kernel::Prepared;
use crate::solve::linear::ZERO;
use crate::solve::plan::{Event, Plan};
use crate::solve::quadrature::{Node, nodes};
use crate::solve::solution::{MassSolution, Solution, SpanWaves};
use crate::solve::waves::{Amplitudes, BeamConstants};

impl Differentiator {
    /// The derivatives of `E_V` at a frequency, rad/s.
    pub(super) fn of_energy(&self, omega: f64) -> Gradient {
        let solution = self.prepared.solution(omega.into());
        let length = self.model.length();
        let stations = self
            .prepared
            .plan
            .stations
            .iter()
            .map(|station| station.position);
        let nodes = nodes(stations, &solution.wave_numbers(), length);
        let places = nodes.iter().map(|node| node.x);
        let plan = self.prepared.plan.with_probes(places, length);
        let u = refined(&self.prepared.plan, &plan, &solution);
        let masses = plan.mass_stations(&self.model);
        let setting = Setting {
            model: &self.model,
            plan: &plan,
            masses: &masses,
            omega: omega.into(),
        };
        let spread = Spread::new(&plan, &u, &nodes);
        let lambda_plan = spread.loaded();
        let lambda_plan = Prepared::whole(lambda_plan);
        let lambda = lambda_plan.solution(omega.into());
        let lambda_plan = &lambda_plan.plan;
        let lambda_field = Field::new(
            &Setting {
                plan: lambda_plan,
                ..setting
            },
            &lambda,
        );
        let u_field = Field::new(&setting, &u);
        let spans = Spans::new(&plan, &lambda);
        let held = BeamState {
            force: forces::held(&self.forces),
            ..BeamState::ZERO
        };
        let product = Product {
            setting,
            lambda: &lambda_field,
            u: &u_field,
            overlaps: spans.overlaps(&plan, &lambda.waves, [&lambda.spans, &u.spans]),
        };
        let mut by_parameter = product.by_parameter(self.ids(), [&BeamState::ZERO, &held]);
        let reader = Reader::new(lambda_plan, &lambda);
        for force in &self.forces {
            by_parameter.extend(force.by_parameter(lambda_plan, &lambda_field, &reader));
        }
        // No point of a response.
        by_parameter.resize(self.ids().len(), ZERO);
        for value in &mut by_parameter {
            *value = (2.0 * value.re).into();
        }
        let weights = spread.weights(&self.model, &u_field);
        for (value, id) in by_parameter.iter_mut().zip(self.ids()) {
            *value += weights.by(*id);
        }
        Gradient {
            value: self.prepared.vibration(omega.into()).into(),
            by_frequency: (2.0 * TAU * product.by_omega().re).into(),
            by_parameter,
        }
    }
}

/// A solution on a plan with additional stations.
fn refined(plan: &Plan, fine: &Plan, solution: &Solution) -> Solution {
    let kinds = fine.kinds.iter();
    let decays = kinds.map(|kind| solution.waves[kind.beam].decay(kind.length));
    let decays: Vec<Amplitudes> = decays.collect();
    let mut spans: Vec<SpanWaves> = Vec::new();
    let mut masses = Vec::new();
    let mut first = 0;
    for (span, waves) in solution.spans.iter().enumerate() {
        // The fine spans up to the station at the end of this one.
        let end = plan
            .stations
            .get(span)
            .map_or(f64::INFINITY, |of| of.position);
        let probes = &fine.stations[first..];
        let within = probes.iter().take_while(|of| of.position < end).count();
        masses.extend(vec![MassSolution::default(); within]);
        masses.extend(solution.masses.get(span));
        let last = first + within;
        let pieces = &fine.spans[first..=last];
        let mut piece_waves = vec![waves.clone(); pieces.len()];
        for index in 1..pieces.len() {
            let decay = &decays[pieces[index - 1]];
            piece_waves[index].a = times(&piece_waves[index - 1].a, decay);
            let (left, right) = (pieces.len() - 1 - index, pieces.len() - index);
            piece_waves[left].b = times(&piece_waves[right].b, &decays[pieces[right]]);
        }
        spans.extend(piece_waves);
        first = last + 1;
    }
    Solution {
        waves: solution.waves.clone(),
        decays,
        spans,
        masses,
        reads: Vec::new(),
    }
}

fn times(amplitudes: &Amplitudes, decay: &Amplitudes) -> Amplitudes {
    std::array::from_fn(|wave| amplitudes[wave] * decay[wave])
}

/// The motion at the nodes.
struct Spread<'a> {
    plan: &'a Plan,
    nodes: Vec<NodeMotion>,
}

/// The motion at a node.
struct NodeMotion {
    /// The node's station.
    station: usize,
    /// m.
    weight: f64,
    /// w, psi, v.
    motion: [Complex64; 3],
}

impl<'a> Spread<'a> {
    /// Reads a solution of a plan whose stations include the nodes.
    fn new(plan: &'a Plan, solution: &Solution, nodes: &[Node]) -> Self {
        let reader = Reader::new(plan, solution);
        let at = |node: &Node| {
            let station = plan.span_at(node.x);
            let [w, psi, v, ..] = reader.end(station).motion;
            NodeMotion {
                station,
                weight: node.weight,
                motion: [w, psi, v],
            }
        };
        Self {
            plan,
            nodes: nodes.iter().map(at).collect(),
        }
    }

    /// The plan with the loads W conj(u) instead of its own.
    fn loaded(&self) -> Plan {
        let mut loaded = without_loads(self.plan);
        for node in &self.nodes {
            let moved = node.motion.map(|moved| node.weight * moved.conj());
            let [w, psi, v] = self.plan.beam(node.station).vibration().times(moved);
            loaded.stations[node.station].event = Event::Load([w, psi, v, ZERO, ZERO, ZERO]);
        }
        loaded
    }

    fn weights(&self, model: &'a Model, u: &'a Field) -> Weights<'a> {
        let parts = self.plan.parts();
        let uniform = model.uniform_parts();
        let mut squares = vec![Symmetric::<f64>::ZERO; uniform.len()];
        for node in &self.nodes {
            let square = &mut squares[parts[node.station]];
            *square = square.plus(node.weight, &Symmetric::square(node.motion));
        }
        let forms = uniform
            .iter()
            .map(|part| BeamConstants::new(part, true).vibration());
        Weights {
            model,
            u,
            joints: (self.plan.joined(model))
                .map(|(station, _)| parts[station])
                .collect(),
            forms: forms.collect(),
            parts: uniform,
            squares,
        }
    }
}

/// The derivatives of the energy by what changes its form W, or where it holds, but not the motion.
struct Weights<'a> {
    model: &'a Model,
    u: &'a Field,
    parts: Vec<UniformPart>,
    /// W of each part.
    forms: Vec<Symmetric<f64>>,
    /// The integral over each part of what W adds up.
    squares: Vec<Symmetric<f64>>,
    /// The part of each joint.
    joints: Vec<usize>,
}

impl Weights<'_> {
    /// By a parameter: of the forms, of the lengths of the parts and of the positions of joints, where the motion may jump; 0
    /// for any other.
    fn by(&self, id: ParameterId) -> f64 {
        let none = Symmetric::<f64>::ZERO;
        if let Group::Joint(index) = id.group
            && id.row == JointKey::Position as usize
        {
            let [before, after] = &self.u.joints[index].sides;
            let part = self.joints[index];
            return self.density(part, before) - self.density(part, after);
        }
        let Some(number) = id.of_beam() else {
            return 0.0;
        };
        let of = number.parts(self.model);
        match number {
            BeamNumber::Beam(BeamKey::Length) => self.by_length(0),
            BeamNumber::Span(index, SpanKey::Length) => self.by_length(index),
            BeamNumber::Span(index, SpanKey::OffsetY) => self.by_offset(index, Across::Y),
            BeamNumber::Span(index, SpanKey::OffsetZ) => self.by_offset(index, Across::Z),
            BeamNumber::Material(_, MaterialKey::Density) => {
                self.by_form(of, |Beam { section, .. }| Symmetric {
                    w: section.area,
                    psi: section.polar_moment,
                    v: section.area,
                    ..none
                })
            }
            BeamNumber::Section(_, SectionKey::Area) => self.by_form(of, |beam| Symmetric {
                w: beam.material.density,
                v: beam.material.density,
                ..none
            }),
            BeamNumber::Section(_, SectionKey::PolarMoment) => self.by_form(of, |beam| Symmetric {
                psi: beam.material.density,
                ..none
            }),
            BeamNumber::Beam(BeamKey::Theory | BeamKey::WarpingInertia | BeamKey::AxialForce)
            | BeamNumber::Span(
                _,
                SpanKey::AxialForce | SpanKey::Material | SpanKey::Section | SpanKey::Foundation,
            )
            | BeamNumber::Material(
                _,
                MaterialKey::YoungModulus | MaterialKey::ShearModulus | MaterialKey::LossFactor,
            )
            | BeamNumber::Section(
                _,
                SectionKey::SecondMomentY
                | SectionKey::SecondMomentZ
                | SectionKey::TorsionConstant
                | SectionKey::WarpingConstant
                | SectionKey::CentroidOffset
                | SectionKey::ProductMoment
                | SectionKey::CentroidOffsetY
                | SectionKey::ShearAreaY
                | SectionKey::ShearAreaZ,
            )
            | BeamNumber::Foundation(..) => 0.0,
        }
    }

    fn by_form(
        &self,
        of: impl Iterator<Item = usize>,
        derivative: impl Fn(&Beam) -> Symmetric<f64>,
    ) -> f64 {
        let by = of.map(|index| {
            let UniformPart { beam, offset, .. } = &self.parts[index];
            derivative(beam).moved(*offset).paired(&self.squares[index])
        });
        by.sum()
    }

    fn by_offset(&self, part: usize, along: Across) -> f64 {
        let form = &self.forms[part];
        form.by_offset(along).paired(&self.squares[part])
    }

    /// With one more metre of a part: the right end and the ends of the parts from there on move.
    fn by_length(&self, part: usize) -> f64 {
        let last = self.parts.len() - 1;
        let mut sum = self.density(last, &self.u.edge.motion);
        for index in part..last {
            let [before, after] = &self.u.junctions[index];
            sum += self.density(index, &before.motion) - self.density(index + 1, &after.motion);
        }
        sum
    }

    /// The energy per length of a part with a motion.
    fn density(&self, part: usize, [w, psi, v, ..]: &[Complex64; 6]) -> f64 {
        self.forms[part].paired(&Symmetric::square([*w, *psi, *v]))
    }
}
