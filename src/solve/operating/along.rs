//! Motions and internal forces along the beam: at both ends of each span, in which probes divide it.

use num_complex::Complex64;

use crate::model::Model;
use crate::solve::beam_state::BeamState;
use crate::solve::kernel::Prepared;
use crate::solve::plan::{Event, Plan};
use crate::solve::solution::States;

/// A model with its solution at one frequency.
pub(super) struct Along<'a> {
    pub(super) model: &'a Model,
    pub(super) plan: &'a Plan,
    /// rad/s.
    pub(super) omega: f64,
    pub(super) states: States,
}

/// An end of a span: where two spans meet there is one for each side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    /// m from the left end.
    pub(super) position: f64,
    span: usize,
    /// The left end of the span, otherwise the right one.
    is_start: bool,
}

/// The plan of a model without responses, with probes between its stations at equally spaced positions, `points` with those
/// of the ends.
pub(super) fn probed(model: &Model, points: usize) -> Plan {
    /// A position closer than this to a station, relative to the length, counts as the station.
    const NEAR: f64 = 1e-9;
    let (plan, length) = (Plan::new(model), model.length());
    let steps = points.max(2) - 1;
    let grid = (1..steps).map(|step| length * step as f64 / steps as f64);
    let between = grid.filter(|&x| {
        let mut stations = plan.stations.iter();
        !stations.any(|station| (station.position - x).abs() <= NEAR * length)
    });
    plan.with_probes(between, length)
}

impl<'a> Along<'a> {
    /// Solves a model with its [probed] plan, prepared as a [whole](Prepared::whole), at an angular frequency, rad/s.
    pub(super) fn new(model: &'a Model, prepared: &'a Prepared, omega: f64) -> Self {
        Self {
            model,
            plan: &prepared.plan,
            omega,
            states: prepared.states(omega.into()),
        }
    }

    /// Each probe, and both sides of each position with another station.
    pub(super) fn places(&self) -> Vec<Spot> {
        let last = self.plan.stations.len();
        let mut places = Vec::new();
        for span in 0..=last {
            let [start, end] = [self.start(span), self.end(span)];
            let is_probed = |left: usize| matches!(self.plan.stations[left].event, Event::Probe);
            // Spans of the length 0 are between stations at one position, or at the outer side of an end.
            match (start.position < end.position, span == 0 || span == last) {
                (true, _) => {
                    places.extend((!span.checked_sub(1).is_some_and(is_probed)).then_some(start));
                    places.push(end);
                }
                (false, true) => places.push(end),
                (false, false) => {}
            }
        }
        places
    }

    /// The first side of the position of a station or an end, m, but right of a joint there.
    pub(super) fn spot(&self, position: f64) -> Spot {
        let span = self.plan.span_at(position);
        let end = self.end(span);
        if end.position == position {
            end
        } else {
            self.start(span)
        }
    }

    /// The outer sides of the left and of the right end.
    pub(super) fn ends(&self) -> [Spot; 2] {
        [self.start(0), self.end(self.plan.stations.len())]
    }

    /// The states just before and just after a station.
    pub(super) fn sides(&self, station: usize) -> [BeamState; 2] {
        [self.end(station), self.start(station + 1)].map(|spot| self.at(spot))
    }

    /// The motions and internal forces at the end of a span.
    pub(super) fn at(&self, spot: Spot) -> BeamState {
        let [start, end] = &self.states.ends[spot.span];
        let mut local = if spot.is_start { start } else { end }.clone();
        self.hold(spot, &mut local.motion);
        local
    }

    /// A fixed motion is exactly zero; left of a joint no support at its position fixes any.
    fn hold(&self, spot: Spot, motion: &mut [Complex64; 6]) {
        let later = self.plan.stations.iter().skip(spot.span);
        let mut here = later.take_while(|of| of.position == spot.position);
        if here.any(|of| matches!(of.event, Event::Joint(_))) {
            return;
        }
        for held in self.plan.held_at(spot.position, self.model.length()) {
            *motion = held.held(motion);
        }
    }

    fn start(&self, span: usize) -> Spot {
        let station = span.checked_sub(1).map(|left| &self.plan.stations[left]);
        Spot {
            position: station.map_or(0.0, |station| station.position),
            span,
            is_start: true,
        }
    }

    fn end(&self, span: usize) -> Spot {
        let station = self.plan.stations.get(span);
        Spot {
            position: station.map_or(self.model.length(), |station| station.position),
            span,
            is_start: false,
        }
    }
}
