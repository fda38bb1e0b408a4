//! Motions and internal forces anywhere on the beam, from the waves of the span.

use num_complex::Complex64;

use crate::model::Model;
use crate::solve::beam_state::BeamState;
use crate::solve::kernel::Prepared;
use crate::solve::plan::{Event, Plan};
use crate::solve::solution::Solution;
use crate::solve::waves::Amplitudes;

/// A model with its solution at one frequency.
pub(super) struct Along<'a> {
    pub(super) model: &'a Model,
    pub(super) plan: &'a Plan,
    /// rad/s.
    pub(super) omega: f64,
    pub(super) solution: Solution,
}

/// A position and its span: where two spans meet there is one for each side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    /// m from the left end.
    pub(super) position: f64,
    span: usize,
}

impl<'a> Along<'a> {
    /// Solves a model without responses, prepared as a [whole](Prepared::whole), at an angular frequency, rad/s.
    pub(super) fn new(model: &'a Model, prepared: &'a Prepared, omega: f64) -> Self {
        Self {
            model,
            plan: &prepared.plan,
            omega,
            solution: prepared.solution(omega.into()),
        }
    }

    /// `points` equally spaced positions, and both sides of each position between two spans.
    pub(super) fn places(&self, points: usize) -> Vec<Spot> {
        /// A position closer than this to a joint, relative to the length, counts as the joint.
        const NEAR: f64 = 1e-9;
        let length = self.model.length();
        let near = NEAR * length;
        let steps = points.max(2) - 1;
        let grid: Vec<f64> = (1..steps)
            .map(|step| length * step as f64 / steps as f64)
            .collect();
        let last = self.plan.stations.len();
        let mut places = Vec::new();
        for span in 0..=last {
            let (from, to) = (self.start_of(span), self.end_of(span));
            let spot = |position| Spot { position, span };
            // Spans of the length 0 are between stations at one position, or at the outer side of an end.
            let inside = grid.iter().filter(|&&x| from + near < x && x < to - near);
            match (from < to, span == 0 || span == last) {
                (true, _) => {
                    places.push(spot(from));
                    places.extend(inside.map(|&x| spot(x)));
                    places.push(spot(to));
                }
                (false, true) => places.push(spot(to)),
                (false, false) => {}
            }
        }
        places
    }

    /// The first side of the position at a distance from the left end, m, but right of a joint there.
    pub(super) fn spot(&self, position: f64) -> Spot {
        Spot {
            position,
            span: self.plan.span_at(position),
        }
    }

    /// The outer sides of the left and of the right end.
    pub(super) fn ends(&self) -> [Spot; 2] {
        let last = self.plan.stations.len();
        [(0.0, 0), (self.model.length(), last)].map(|(position, span)| Spot { position, span })
    }

    /// The states just before and just after a station.
    pub(super) fn sides(&self, station: usize) -> [BeamState; 2] {
        let position = self.plan.stations[station].position;
        [station, station + 1].map(|span| self.at(Spot { position, span }))
    }

    /// The motions and internal forces at a position: `Q (a + b)`, `S (b - a)`, `P (a - b)` and `M (a + b)` of the
    /// waves there.
    pub(super) fn at(&self, spot: Spot) -> BeamState {
        let (a, b) = self.waves_at(spot);
        let mut local = BeamState::new(self.solution.waves_of(self.plan, spot.span), &a, &b);
        self.hold(spot, &mut local.motion);
        local
    }

    fn waves_at(&self, spot: Spot) -> (Amplitudes, Amplitudes) {
        let waves = self.solution.waves_of(self.plan, spot.span);
        let from_left = waves.decay(spot.position - self.start_of(spot.span));
        let from_right = waves.decay(self.end_of(spot.span) - spot.position);
        let span = &self.solution.spans[spot.span];
        (
            std::array::from_fn(|wave| span.a[wave] * from_left[wave]),
            std::array::from_fn(|wave| span.b[wave] * from_right[wave]),
        )
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

    fn start_of(&self, span: usize) -> f64 {
        let station = span.checked_sub(1).map(|left| &self.plan.stations[left]);
        station.map_or(0.0, |station| station.position)
    }

    fn end_of(&self, span: usize) -> f64 {
        let station = self.plan.stations.get(span);
        station.map_or(self.model.length(), |station| station.position)
    }
}
