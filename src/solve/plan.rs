//! A model laid out for the solver: the stations along x, in order, and the station of each response.

use std::ops::Range;

use num_complex::Complex64;

use super::attachment::Attachment;
use super::beam_state::BeamState;
use super::linear::ZERO;
use super::output::{Holds, Output, Read, Row, Sum};
use super::springs::{of_each, restraint_stiffness, rows};
use super::waves::BeamConstants;
use crate::model::{
    BeamMotion, Holder, Measure, Model, Place, Quantity, Reaction, Response, Restraint, Spring,
    SpringName, Subsystem, Support, SupportId, Target, UniformPart,
};

/// The part of a model that does not depend on the frequency.
#[derive(Debug, Clone)]
pub(super) struct Plan {
    /// The distinct beams of its parts; that of the left end first.
    pub(super) beams: Vec<BeamConstants>,
    pub(super) left: Held,
    pub(super) right: Held,
    /// The stations along the beam, by ascending x.
    pub(super) stations: Vec<Station>,
    /// The distinct kinds of spans between stations.
    pub(super) kinds: Vec<SpanKind>,
    /// Index in `kinds` of the span left of each station, and last of the span up to the right end.
    pub(super) spans: Vec<usize>,
    /// The rows that the outputs need.
    pub(super) reads: Vec<Read>,
    /// The value of each enabled response.
    pub(super) outputs: Vec<Output>,
    /// Whether some response needs the waves in every span.
    pub(super) wants_energy: bool,
}

/// A span between two stations, or up to an end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SpanKind {
    /// m.
    pub(super) length: f64,
    /// Index of its beam.
    pub(super) beam: usize,
}

/// A position of the beam that a support holds: an end, or one between them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Held {
    pub(super) support: Support,
    /// Loads along the six motions of the axis, N and N m.
    pub(super) load: [Complex64; 6],
    /// The motions of the ground, along those of its point, m and rad: springs stretch by less, and fixed motions follow.
    pub(super) ground: [Complex64; 6],
    /// Whether the beam there has no warping stiffness.
    pub(super) without_warping: bool,
}

impl Held {
    /// Without warping stiffness any restraint fixes the rate of twist.
    fn new(support: &Support, without_warping: bool) -> Self {
        let mut support = support.clone();
        let twist = &mut support[BeamMotion::PsiSlope];
        if without_warping && twist.acts() {
            *twist = Restraint::Fixed;
        }
        Self {
            support,
            load: [ZERO; 6],
            ground: [ZERO; 6],
            without_warping,
        }
    }

    /// Whether it fixes a motion, for w and v at a point with an arm, m.
    fn fixes(&self, motion: BeamMotion, arm: f64) -> bool {
        let support = &self.support;
        let own_arm = support.point.arm(motion);
        let at_point =
            own_arm.is_none_or(|own| own == arm || support[BeamMotion::Psi] == Restraint::Fixed);
        support[motion] == Restraint::Fixed && at_point
    }

    /// The motions of the axis without the rounding of those that it fixes.
    pub(super) fn held(&self, axis: &[Complex64; 6]) -> [Complex64; 6] {
        BeamMotion::ALL.map(|motion| {
            if !self.fixes(motion, 0.0) {
                return axis[motion as usize];
            }
            // With an arm the twist is fixed, too.
            let arm = self.support.point.arm(motion).unwrap_or_default();
            self.ground[motion as usize] - arm * self.ground[BeamMotion::Psi as usize]
        })
    }

    /// Its forces on the beam along the motions of its point: of springs, dampers and inertias together, or those that
    /// hold a fixed motion; from the internal forces on both sides (0 outside of the beam) and the motions of the axis.
    pub(super) fn forces(
        &self,
        omega: Complex64,
        [before, after]: [&[Complex64; 6]; 2],
        axis: &[Complex64; 6],
    ) -> [Complex64; 6] {
        let point = self.support.point;
        let (motions, loads) = (point.motions(axis), self.loads_at_point());
        let [before, after] = [before, after].map(|forces| point.forces(forces));
        BeamMotion::ALL.map(|motion| {
            let row = motion as usize;
            // Without warping stiffness no bimoment reaches a support.
            if motion == BeamMotion::PsiSlope && self.without_warping {
                return ZERO;
            }
            match restraint_stiffness(omega, &self.support[motion]) {
                None => before[row] - after[row] - loads[row],
                // A free motion may be infinite.
                Some(k) if k == ZERO => ZERO,
                Some(k) => {
                    let spring = self.support[motion]
                        .elastic()
                        .spring
                        .dynamic_stiffness(omega);
                    spring * self.ground[row] - k * motions[row]
                }
            }
        })
    }

    /// The loads along the motions of its point: forces on the axis turn about it.
    pub(super) fn loads_at_point(&self) -> [Complex64; 6] {
        self.support.point.forces(&self.load)
    }
}

/// A joint: what links each motion of its two sides.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Joined {
    springs: [Option<Spring>; 6],
}

impl Joined {
    /// That of a motion: see [`Joint::springs`].
    pub(super) fn spring(&self, motion: BeamMotion) -> Option<&Spring> {
        self.springs[motion as usize].as_ref()
    }

    /// The jumps of the motions over it, right minus left: 0 where it is rigid. From the states on both sides, or from the
    /// internal forces there: for a soft spring the first, for a stiff one the second is exact.
    pub(super) fn jumps(
        &self,
        omega: Complex64,
        [before, after]: [&BeamState; 2],
    ) -> [Complex64; 6] {
        BeamMotion::ALL.map(|motion| {
            let Some(spring) = self.spring(motion) else {
                return ZERO;
            };
            let row = motion as usize;
            let (from, to) = (before.motion[row], after.motion[row]);
            let (k, force) = (spring.dynamic_stiffness(omega), after.force[row]);
            if force.norm() < k.norm() * (from.norm() + to.norm()) {
                force / k
            } else {
                to - from
            }
        })
    }
}

/// Something at a position of the beam.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Station {
    /// Distance from the left end, m.
    pub(super) position: f64,
    pub(super) event: Event,
}

/// The kind of a station.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Event {
    /// A subsystem.
    Attachment(Box<Attachment>),
    /// A support between the ends.
    Support(Box<Held>),
    /// A joint. Everything else at its position is right of it, except a first probe of the rate of twist.
    Joint(Box<Joined>),
    /// Where a uniform part ends: the index of the beam right of it. Everything else at its position is in the part with
    /// warping stiffness, left of it if both have it.
    Junction(usize),
    /// Loads along the six motions.
    Load([Complex64; 6]),
    /// A gap: jumps of the six motions, right minus left, m and rad.
    Gap([Complex64; 6]),
    /// Only a position to read a response.
    Probe,
}

impl Plan {
    /// The kind of the span up to the right end.
    pub(super) fn last_span(&self) -> usize {
        self.spans[self.stations.len()]
    }

    /// The beam of a span: that left of the station with its index.
    pub(super) fn beam(&self, span: usize) -> &BeamConstants {
        &self.beams[self.kinds[self.spans[span]].beam]
    }

    /// A response that is one more read.
    pub(super) fn output_of(&mut self, read: Read) -> Output {
        let terms = vec![(1.0, self.reads.len())];
        self.reads.push(read);
        let sum = Sum {
            terms,
            measure: Measure::Displacement,
        };
        Output::Sum(sum, None)
    }

    /// The same on a beam of another length, m, with additional probes, m from the left end.
    pub(super) fn with_probes(&self, places: impl Iterator<Item = f64>, length: f64) -> Self {
        let probe = |position| Station {
            position,
            event: Event::Probe,
        };
        let mut plan = self.clone();
        plan.stations.extend(places.map(probe));
        plan.stations
            .sort_by(|a, b| a.position.total_cmp(&b.position));
        (plan.kinds, plan.spans) = spans(&plan.stations, length);
        // The reads refer to the old station numbers.
        (plan.reads, plan.outputs) = (Vec::new(), Vec::new());
        plan
    }

    /// For each span the index of the uniform part of the model in which it lies.
    pub(super) fn parts(&self) -> Vec<usize> {
        let mut part = 0;
        let after = self.stations.iter().map(|station| {
            part += usize::from(matches!(station.event, Event::Junction(_)));
            part
        });
        std::iter::once(0).chain(after).collect()
    }

    /// The supports at a distance from the left end of a beam of a length, both m.
    pub(super) fn held_at(&self, x: f64, length: f64) -> impl Iterator<Item = &Held> {
        let first = self.stations.partition_point(|of| of.position < x);
        let last = self.stations.partition_point(|of| of.position <= x);
        held_at(
            x,
            [&self.left, &self.right],
            &self.stations[first..last],
            length,
        )
    }

    /// What each support of a model holds, in the order of [`SupportId::all`].
    pub(super) fn held(&self, model: &Model) -> impl Iterator<Item = &Held> {
        let inner = self.held_between(model).map(|(_, held)| held);
        [&self.left, &self.right].into_iter().chain(inner)
    }

    /// Each support of a model between the ends, in its order, with its station.
    pub(super) fn held_between(&self, model: &Model) -> impl Iterator<Item = (usize, &Held)> {
        let positions = model.supports.inner.iter().map(|of| of.position);
        let stations = self.stations_of(positions, |event| matches!(event, Event::Support(_)));
        let stations = stations.into_iter();
        stations.filter_map(|station| match &self.stations[station].event {
            Event::Support(held) => Some((station, &**held)),
            Event::Attachment(_)
            | Event::Joint(_)
            | Event::Junction(_)
            | Event::Load(_)
            | Event::Gap(_)
            | Event::Probe => None,
        })
    }

    /// The station of each enabled subsystem, in the order of the model.
    pub(super) fn mass_stations(&self, model: &Model) -> Vec<usize> {
        let positions = model.attached().map(|of| of.position);
        self.stations_of(positions, |event| matches!(event, Event::Attachment(_)))
    }

    /// Each joint of a model, in its order, with its station.
    pub(super) fn joined(&self, model: &Model) -> impl Iterator<Item = (usize, &Joined)> {
        let positions = model.joints.iter().map(|of| of.position);
        let stations = self.stations_of(positions, |event| matches!(event, Event::Joint(_)));
        let stations = stations.into_iter();
        stations.filter_map(|station| match &self.stations[station].event {
            Event::Joint(joined) => Some((station, &**joined)),
            Event::Attachment(_)
            | Event::Support(_)
            | Event::Junction(_)
            | Event::Load(_)
            | Event::Gap(_)
            | Event::Probe => None,
        })
    }

    /// The span in which to read a motion at a distance from the left end, m, and the station at its right end: right of a
    /// joint and of a part without warping stiffness that ends there, left of everything else.
    pub(super) fn span_at(&self, x: f64) -> usize {
        let first = self.stations.partition_point(|of| of.position < x);
        let here = self.stations[first..].iter();
        let here = here.take_while(|of| of.position == x).enumerate();
        let is_before = |index: usize, event: &Event| match event {
            Event::Joint(_) => true,
            Event::Junction(_) => self.beam(first + index).without_warping(),
            Event::Attachment(_)
            | Event::Support(_)
            | Event::Load(_)
            | Event::Gap(_)
            | Event::Probe => false,
        };
        let before = here.filter(|(index, of)| is_before(*index, &of.event));
        first + before.last().map_or(0, |(index, _)| index + 1)
    }

    /// The stations of a kind, in the order of their `positions` in the model.
    fn stations_of(
        &self,
        positions: impl Iterator<Item = f64>,
        is_it: impl Fn(&Event) -> bool,
    ) -> Vec<usize> {
        // Stations are in order of ascending position, those at one position in the order of the model.
        let positions: Vec<f64> = positions.collect();
        let mut order: Vec<usize> = (0..positions.len()).collect();
        order.sort_by(|&a, &b| positions[a].total_cmp(&positions[b]));
        let stations = self.stations.iter().enumerate();
        let found = stations.filter(|(_, of)| is_it(&of.event));
        let mut all = vec![0; positions.len()];
        for (index, (station, _)) in order.into_iter().zip(found) {
            all[index] = station;
        }
        all
    }

    /// Lays out a checked model.
    pub(super) fn new(model: &Model) -> Self {
        let mut layout = Layout::new(model);
        layout.place_first_probes();
        layout.place_junctions(|part| !part.warps());
        layout.place_joints();
        layout.place_supports();
        layout.place_subsystems();
        layout.place_loads();
        layout.place_probes();
        layout.place_junctions(UniformPart::warps);
        layout.finish()
    }
}

/// A plan under construction: stations in order of creation, before they are sorted by x.
struct Layout<'a> {
    model: &'a Model,
    parts: Vec<UniformPart>,
    /// The distinct beams, and that of each part.
    beams: Vec<BeamConstants>,
    beam_of_part: Vec<usize>,
    left: Held,
    right: Held,
    stations: Vec<Station>,
    /// The probes before everything else at their positions: the first stations.
    first_probes: usize,
    /// The supports among the stations.
    supports: Range<usize>,
    /// Station of each subsystem, by name.
    masses: std::collections::HashMap<&'a str, usize>,
    reads: Vec<Read>,
    outputs: Vec<Output>,
}

impl<'a> Layout<'a> {
    fn new(model: &'a Model) -> Self {
        let parts = model.uniform_parts();
        // A point off the axis couples v with twist.
        let mut supports = SupportId::all(model);
        let all_coupled = supports.any(|id| id.support(model).point.y != 0.0)
            || parts.iter().any(UniformPart::couples_all);
        let mut beams: Vec<BeamConstants> = Vec::new();
        let beam_of_part = parts.iter().map(|part| {
            let beam = BeamConstants::new(part, all_coupled);
            let known = beams.iter().position(|known| *known == beam);
            known.unwrap_or_else(|| {
                beams.push(beam);
                beams.len() - 1
            })
        });
        let beam_of_part = beam_of_part.collect();
        let ends = [&parts[0], &parts[parts.len() - 1]];
        let [left, right] = ends.map(|part| !part.warps());
        Self {
            model,
            left: Held::new(&model.supports.left, left),
            right: Held::new(&model.supports.right, right),
            beams,
            beam_of_part,
            parts,
            stations: Vec::new(),
            first_probes: 0,
            supports: 0..0,
            masses: std::collections::HashMap::new(),
            reads: Vec::new(),
            outputs: Vec::new(),
        }
    }

    /// The positions where a response is read before everything that acts there.
    fn place_first_probes(&mut self) {
        let first = self
            .model
            .computed()
            .filter_map(|of| self.is_read_first(of));
        let mut positions: Vec<f64> = first.collect();
        positions.sort_by(f64::total_cmp);
        positions.dedup();
        let probes = positions.into_iter().map(|position| Station {
            position,
            event: Event::Probe,
        });
        self.stations.extend(probes);
        self.first_probes = self.stations.len();
    }

    /// The position of a response that is also, or only, read before everything that acts there: without warping stiffness a rate
    /// of twist, except at the left end; a reaction at the left end; an internal force at the right end.
    fn is_read_first(&self, response: &Response) -> Option<f64> {
        match response.quantity {
            Quantity::Motion(Target::Beam(place, BeamMotion::PsiSlope), _) => {
                let x = self.x(place);
                let without_warping = !UniformPart::at(&self.parts, x).warps();
                (x != 0.0 && without_warping && self.acts_at(x)).then_some(x)
            }
            Quantity::Reaction(Reaction::Support(Holder::Left, _) | Reaction::Ground(_)) => {
                Some(0.0)
            }
            Quantity::InternalForce(place, _) => {
                let length = self.model.length();
                (self.x(place) == length).then_some(length)
            }
            Quantity::Motion(..)
            | Quantity::Reaction(_)
            | Quantity::Spring(..)
            | Quantity::Energy => None,
        }
    }

    /// Where those parts end that are so.
    fn place_junctions(&mut self, is_so: impl Fn(&UniformPart) -> bool) {
        for (part, right) in self.parts.iter().zip(&self.beam_of_part[1..]) {
            if is_so(part) {
                self.stations.push(Station {
                    position: part.end,
                    event: Event::Junction(*right),
                });
            }
        }
    }

    /// Whether a joint, a support, a subsystem, a force or the end of a part is at a distance from the left end, m.
    fn acts_at(&self, x: f64) -> bool {
        let mut forces = self.model.forces.iter().filter(|force| force.enabled);
        let mut inner = self.model.supports.inner.iter();
        self.model.attached().any(|of| of.position == x)
            || inner.any(|of| of.position == x)
            || self.model.joints.iter().any(|of| of.position == x)
            || self.parts[1..].iter().any(|part| part.start == x)
            || forces
                .any(|force| matches!(force.target, Target::Beam(place, _) if self.x(place) == x))
    }

    /// Before everything that acts at their positions.
    fn place_joints(&mut self) {
        let joints = self.model.joints.iter().map(|joint| Station {
            position: joint.position,
            event: Event::Joint(Box::new(Joined {
                springs: joint
                    .springs(!UniformPart::transmit_bimoment(&self.parts, joint.position)),
            })),
        });
        let joints: Vec<Station> = joints.collect();
        self.stations.extend(joints);
    }

    /// Before the subsystems, which lie on what they hold.
    fn place_supports(&mut self) {
        let first = self.stations.len();
        let supports = self.model.supports.inner.iter().map(|inner| {
            let without_warping = !UniformPart::at(&self.parts, inner.position).warps();
            Station {
                position: inner.position,
                event: Event::Support(Box::new(Held::new(&inner.support, without_warping))),
            }
        });
        let supports: Vec<Station> = supports.collect();
        self.stations.extend(supports);
        self.supports = first..self.stations.len();
    }

    fn place_subsystems(&mut self) {
        for subsystem in self.model.attached() {
            self.masses.insert(&subsystem.name, self.stations.len());
            let mut attachment = Attachment::new(subsystem);
            attachment.held =
                DISPLACEMENTS.map(|motion| self.is_held(subsystem.position, motion, 0.0));
            self.stations.push(Station {
                position: subsystem.position,
                event: Event::Attachment(Box::new(attachment)),
            });
        }
    }

    /// Whether a support fixes a motion at a distance from the left end, m, for w and v at a point with an arm, m.
    fn is_held(&self, x: f64, motion: BeamMotion, arm: f64) -> bool {
        let mut here = held_at(
            x,
            [&self.left, &self.right],
            &self.stations[self.supports.clone()],
            self.model.length(),
        );
        here.any(|held| held.fixes(motion, arm))
    }

    /// A load at a support is part of its equations, where a fixed motion takes it exactly.
    fn place_loads(&mut self) {
        for force in self.model.forces.iter().filter(|f| f.enabled) {
            let value = Complex64::from_polar(force.amplitude, force.phase.to_radians());
            match &force.target {
                Target::Mass(name, motion) => {
                    if let Some(&station) = self.masses.get(name.as_str())
                        && let Event::Attachment(attachment) = &mut self.stations[station].event
                    {
                        attachment.load[*motion as usize] += value;
                    }
                }
                Target::Beam(place, motion) => {
                    let mut load = [ZERO; 6];
                    load[*motion as usize] = value;
                    if let Some(arm) = force.point.arm(*motion) {
                        load[BeamMotion::Psi as usize] += arm * value;
                    }
                    self.load_beam(self.x(*place), load);
                }
            }
        }
    }

    fn load_beam(&mut self, x: f64, load: [Complex64; 6]) {
        let is_here = |station: &&mut Station| station.position == x;
        let held = if x == 0.0 {
            &mut self.left
        } else if x == self.model.length() {
            &mut self.right
        } else if let Some(Station {
            event: Event::Support(held),
            ..
        }) = self.stations[self.supports.clone()]
            .iter_mut()
            .find(is_here)
        {
            held
        } else {
            self.stations.push(Station {
                position: x,
                event: Event::Load(load),
            });
            return;
        };
        for (sum, load) in held.load.iter_mut().zip(load) {
            *sum += load;
        }
    }

    fn place_probes(&mut self) {
        for response in self.model.responses.iter().filter(|r| r.enabled) {
            let output = match self.sum(response) {
                Some(sum) => {
                    let divisor = response.divisor(self.model);
                    Output::Sum(sum, divisor.and_then(|divisor| self.sum(divisor)))
                }
                None => Output::Energy,
            };
            self.outputs.push(output);
        }
    }

    /// The rows of a response; none for an energy.
    fn sum(&mut self, response: &Response) -> Option<Sum> {
        let mut measure = Measure::Displacement;
        let terms = match &response.quantity {
            Quantity::Motion(Target::Beam(place, motion), of) => {
                measure = *of;
                let arm = response.point.arm(*motion).unwrap_or_default();
                self.motion_of_beam(self.x(*place), *motion, arm)
            }
            Quantity::Motion(Target::Mass(name, motion), of) => {
                measure = *of;
                self.of_mass(name, Row::Mass(*motion))
            }
            Quantity::Reaction(Reaction::Support(holder, motion)) => {
                let id = SupportId::all(self.model).find(|id| id.name(self.model) == holder.name());
                id.map_or_else(Vec::new, |id| self.reaction(id, *motion))
            }
            Quantity::Reaction(Reaction::Ground(across)) => {
                let all = SupportId::all(self.model);
                all.flat_map(|id| self.reaction(id, (*across).into()))
                    .collect()
            }
            Quantity::InternalForce(place, motion) => {
                let x = self.x(*place);
                let station = if x == self.model.length() {
                    self.first_probe(x)
                } else {
                    Some(self.probe(x))
                };
                let terms = station.map(|station| self.term(1.0, station, Row::Force(*motion)));
                terms.into_iter().collect()
            }
            Quantity::Spring(name, spring, of) => {
                if let Some(station) = self.masses.get(name.as_str()) {
                    // Where the load of its derivatives acts.
                    self.probe(self.stations[*station].position);
                }
                self.of_mass(name, Row::Spring(*spring, *of))
            }
            Quantity::Energy => return None,
        };
        Some(Sum { terms, measure })
    }

    /// One more read, as a term of a sum.
    fn term(&mut self, factor: f64, station: usize, row: Row) -> (f64, usize) {
        self.reads.push(Read { station, row });
        (factor, self.reads.len() - 1)
    }

    /// A row at a subsystem; a checked model has no response on a disabled one.
    fn of_mass(&mut self, name: &str, row: Row) -> Vec<(f64, usize)> {
        let station = self.masses.get(name).copied();
        let term = station.map(|station| self.term(1.0, station, row));
        term.into_iter().collect()
    }

    /// The reaction of a support, with what subsystems at its place put on a motion that it fixes.
    fn reaction(&mut self, id: SupportId, motion: BeamMotion) -> Vec<(f64, usize)> {
        let x = id.position(self.model);
        let (holds, station) = match id {
            SupportId::Left => (Holds::Left, self.first_probe(x)),
            SupportId::Right => (Holds::Right, Some(self.probe(x))),
            SupportId::Inner(index) => (Holds::Station, Some(self.supports.start + index)),
        };
        let held = match (id, station.map(|station| &self.stations[station].event)) {
            (SupportId::Left, _) => &self.left,
            (SupportId::Right, _) => &self.right,
            (SupportId::Inner(_), Some(Event::Support(held))) => held,
            (SupportId::Inner(_), _) => return Vec::new(),
        };
        // Without warping stiffness no bimoment reaches a support.
        if motion == BeamMotion::PsiSlope && held.without_warping {
            return Vec::new();
        }
        let own = station.map(|station| (1.0, station, Row::Reaction(holds, motion)));
        let here = self.model.attached().filter(|of| of.position == x);
        let passed = here.flat_map(|subsystem| {
            let station = self.masses[&*subsystem.name];
            let springs = passed_on(held, motion, subsystem);
            springs.map(move |(factor, spring)| (factor, station, Row::OnFixed(spring)))
        });
        let all: Vec<_> = own.into_iter().chain(passed).collect();
        let terms = all.into_iter();
        terms
            .map(|(factor, station, row)| self.term(factor, station, row))
            .collect()
    }

    /// The rate of twist jumps at a torque without warping stiffness, at a load, a subsystem, a support or a joint between the
    /// ends. There it is the mean of both sides, just before and just after everything at that position: the limit for a
    /// warping constant that goes to 0, because warping makes the same boundary layer on both sides of the torque. At an
    /// end it is the value just inside the end.
    fn motion_of_beam(&mut self, x: f64, motion: BeamMotion, arm: f64) -> Vec<(f64, usize)> {
        if self.is_held(x, motion, arm) {
            return Vec::new();
        }
        let row = Row::Motion(motion, arm);
        let without_warping = !UniformPart::at(&self.parts, x).warps();
        let is_rate = motion == BeamMotion::PsiSlope && without_warping && x != 0.0;
        let first = self.first_probe(x).filter(|_| is_rate);
        match first {
            Some(first) if x == self.model.length() => vec![self.term(1.0, first, row)],
            Some(first) => {
                let last = self.probe(x);
                vec![self.term(0.5, first, row), self.term(0.5, last, row)]
            }
            None => {
                let station = self.probe(x);
                vec![self.term(1.0, station, row)]
            }
        }
    }

    /// The station of the probe before everything at a position.
    fn first_probe(&self, position: f64) -> Option<usize> {
        let mut firsts = self.stations[..self.first_probes].iter();
        firsts.position(|of| of.position == position)
    }

    /// The station of a probe after everything at a position.
    fn probe(&mut self, position: f64) -> usize {
        let is_it = |of: &Station| of.position == position && matches!(of.event, Event::Probe);
        let rest = &self.stations[self.first_probes..];
        if let Some(known) = rest.iter().position(is_it) {
            return self.first_probes + known;
        }
        self.stations.push(Station {
            position,
            event: Event::Probe,
        });
        self.stations.len() - 1
    }

    fn x(&self, place: Place) -> f64 {
        place.position(self.model.length())
    }

    /// Sorts the stations by x and renumbers those of the reads.
    fn finish(mut self) -> Plan {
        let mut order: Vec<usize> = (0..self.stations.len()).collect();
        order.sort_by(|&a, &b| {
            self.stations[a]
                .position
                .total_cmp(&self.stations[b].position)
        });
        let mut rank = vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            rank[old] = new;
        }
        for read in &mut self.reads {
            read.station = rank[read.station];
        }
        let mut stations = self.stations;
        stations.sort_by(|a, b| a.position.total_cmp(&b.position));
        let (kinds, spans) = spans(&stations, self.model.length());
        Plan {
            beams: self.beams,
            left: self.left,
            right: self.right,
            wants_energy: self.outputs.contains(&Output::Energy),
            stations,
            kinds,
            spans,
            reads: self.reads,
            outputs: self.outputs,
        }
    }
}

/// The springs of a subsystem that act on motions which a support at its place fixes, with the share of each that the support
/// takes along one of its motions.
fn passed_on(
    held: &Held,
    motion: BeamMotion,
    subsystem: &Subsystem,
) -> impl Iterator<Item = (f64, SpringName)> {
    let shares = rows(subsystem).map(|stretch| {
        // The forces on the beam's axis where it does not move.
        let mut forces = [ZERO; 6];
        for (own, share) in DISPLACEMENTS.into_iter().zip(stretch.beam) {
            if held.fixes(own, 0.0) {
                forces[own as usize] = share.into();
            }
        }
        held.support.point.forces(&forces)[motion as usize].re
    });
    let is_fixed = held.support[motion] == Restraint::Fixed;
    let shares = of_each(shares).into_iter().zip(SpringName::ALL);
    shares.filter(move |(share, _)| is_fixed && *share != 0.0)
}

/// The displacements of the axis, in the order of the rows of springs.
const DISPLACEMENTS: [BeamMotion; 3] = [BeamMotion::W, BeamMotion::Psi, BeamMotion::V];

/// The supports at a distance from the left end of a beam of a length, both m, by its ends and some stations.
fn held_at<'a>(
    x: f64,
    [left, right]: [&'a Held; 2],
    stations: &'a [Station],
    length: f64,
) -> impl Iterator<Item = &'a Held> {
    let ends = [(left, x == 0.0), (right, x == length)];
    let inner = stations
        .iter()
        .filter_map(move |station| match &station.event {
            Event::Support(held) if station.position == x => Some(&**held),
            Event::Support(_)
            | Event::Joint(_)
            | Event::Junction(_)
            | Event::Attachment(_)
            | Event::Load(_)
            | Event::Gap(_)
            | Event::Probe => None,
        });
    let ends = ends.into_iter().filter(|(_, is_here)| *is_here);
    ends.map(|(end, _)| end).chain(inner)
}

/// The distinct kinds of spans, and the kind of the span left of each station and of the right end.
fn spans(stations: &[Station], length: f64) -> (Vec<SpanKind>, Vec<usize>) {
    let mut kinds = Vec::new();
    let mut known = std::collections::HashMap::new();
    let (mut previous, mut beam) = (0.0, 0);
    let mut kind = |x: f64, beam: usize| {
        let length: f64 = x - previous;
        previous = x;
        *known.entry((length.to_bits(), beam)).or_insert_with(|| {
            kinds.push(SpanKind { length, beam });
            kinds.len() - 1
        })
    };
    let mut spans: Vec<usize> = Vec::new();
    for station in stations {
        spans.push(kind(station.position, beam));
        if let Event::Junction(next) = station.event {
            beam = next;
        }
    }
    spans.push(kind(length, beam));
    (kinds, spans)
}
