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
use crate::model::schema::{BeamKey, JointKey, MaterialKey, SectionKey};
use crate::model::{Group, Model, ParameterId};
use crate::solve::energy::SpanEnergy;
use crate::solve::kernel::Prepared;
use crate::solve::linear::ZERO;
use crate::solve::plan::{Event, Plan};
use crate::solve::quadrature::{Node, nodes};
use crate::solve::solution::{MassSolution, Solution, SpanWaves};
use crate::solve::waves::Amplitudes;

impl Differentiator {
    /// The derivatives of `E_V` at a frequency, rad/s.
    pub(super) fn of_energy(&self, omega: f64) -> Gradient {
        let solution = self.prepared.solution(omega.into());
        let length = self.model.beam.length;
        let stations = self
            .prepared
            .plan
            .stations
            .iter()
            .map(|station| station.position);
        let nodes = nodes(stations, &solution.waves.kappa, length);
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
        let lambda_plan = spread.loaded(&plan);
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
        let product = Product {
            setting,
            lambda: &lambda_field,
            u: &u_field,
            overlap: spans.overlap(&plan, &lambda.waves, [&lambda.spans, &u.spans]),
        };
        let mut by_parameter = product.by_parameter([&[ZERO; 6], &forces::held(&self.forces)]);
        let reader = Reader::new(lambda_plan, &lambda);
        for force in &self.forces {
            by_parameter.extend(force.by_parameter(lambda_plan, &lambda_field, &reader));
        }
        // No point of a response.
        by_parameter.resize(self.ids().len(), ZERO);
        for value in &mut by_parameter {
            *value = (2.0 * value.re).into();
        }
        for (id, share) in spread.of_weights(&self.model, &u_field) {
            if let Some(index) = self.ids().iter().position(|own| *own == id) {
                by_parameter[index] += share;
            }
        }
        Gradient {
            value: energy(&self.prepared.plan, &solution).into(),
            by_frequency: (2.0 * TAU * product.by_omega().re).into(),
            by_parameter,
        }
    }
}

/// `E_V` with the value of the frequency responses.
fn energy(plan: &Plan, solution: &Solution) -> f64 {
    let energy = SpanEnergy::vibration(plan, &solution.waves, &solution.decays);
    energy.total(plan, &solution.spans)
}

/// A solution on a plan with additional stations.
fn refined(plan: &Plan, fine: &Plan, solution: &Solution) -> Solution {
    let lengths = fine.lengths.iter();
    let decays: Vec<Amplitudes> = lengths.map(|&l| solution.waves.decay(l)).collect();
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
    }
}

fn times(amplitudes: &Amplitudes, decay: &Amplitudes) -> Amplitudes {
    std::array::from_fn(|wave| amplitudes[wave] * decay[wave])
}

/// The motion at the nodes.
struct Spread {
    nodes: Vec<NodeMotion>,
    /// rho A, kg/m.
    mass: f64,
    /// rho `I_0`, kg m.
    polar: f64,
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

impl Spread {
    /// Reads a solution of a plan whose stations include the nodes.
    fn new(plan: &Plan, solution: &Solution, nodes: &[Node]) -> Self {
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
            nodes: nodes.iter().map(at).collect(),
            mass: plan.beam.mass,
            polar: plan.beam.polar,
        }
    }

    /// The plan with the loads W conj(u) instead of its own.
    fn loaded(&self, plan: &Plan) -> Plan {
        let mut loaded = without_loads(plan);
        for node in &self.nodes {
            let [w, psi, v] = node.motion.map(|moved| node.weight * moved.conj());
            let load = [
                self.mass * w,
                self.polar * psi,
                self.mass * v,
                ZERO,
                ZERO,
                ZERO,
            ];
            loaded.stations[node.station].event = Event::Load(load);
        }
        loaded
    }

    /// The contributions of the parameters in the weights of the energy, of the length of the beam and of the positions of
    /// joints, where the motion may jump: derivatives.
    fn of_weights(&self, model: &Model, u: &Field) -> Vec<(ParameterId, f64)> {
        let (mut along, mut about) = (0.0, 0.0);
        for node in &self.nodes {
            let [w, psi, v] = node.motion.map(|moved| node.weight * moved.norm_sqr());
            along += w + v;
            about += psi;
        }
        let (material, section) = (&model.beam.material, &model.beam.section);
        let density = |motion: &[Complex64; 6]| {
            let [w, psi, v] = [0, 1, 2].map(|row: usize| motion[row].norm_sqr());
            self.mass * (w + v) + self.polar * psi
        };
        let joints = u.joints.iter().enumerate().map(|(index, joint)| {
            let [before, after] = joint.sides.each_ref().map(density);
            let position = Group::Joint(index).parameter(JointKey::Position as usize);
            (position, before - after)
        });
        let beam = [
            (
                Group::Beam.parameter(BeamKey::Length as usize),
                density(&u.edge.motion),
            ),
            (
                Group::Material.parameter(MaterialKey::Density as usize),
                section.area * along + section.polar_moment * about,
            ),
            (
                Group::Section.parameter(SectionKey::Area as usize),
                material.density * along,
            ),
            (
                Group::Section.parameter(SectionKey::PolarMoment as usize),
                material.density * about,
            ),
        ];
        beam.into_iter().chain(joints).collect()
    }
}
