//! The whole solution of a plan at one frequency, in ordinary numbers.

use num_complex::Complex64;

use super::beam_state::BeamState;
use super::plan::Plan;
use super::waves::{Amplitudes, Waves};

/// The waves in a span: the right-going ones at its left end, and the left-going ones at its right end.
#[derive(Debug, Clone)]
pub(super) struct SpanWaves {
    pub(super) a: Amplitudes,
    pub(super) b: Amplitudes,
}

/// The state of a subsystem.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct MassSolution {
    /// The forces of its channels, N: the y springs, the sum and the difference of the z springs.
    pub(super) forces: [Complex64; 3],
    /// y, z, theta of the mass, m and rad.
    pub(super) motion: [Complex64; 3],
}

/// The complete solution.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    /// The waves of each beam of the plan.
    pub(super) waves: Vec<Waves>,
    /// exp(-kappa l) of each kind of span.
    pub(super) decays: Vec<Amplitudes>,
    /// The waves of the span left of each station, and last of the span up to the right end.
    pub(super) spans: Vec<SpanWaves>,
    /// The state of the subsystem at each station; zero for stations without one.
    pub(super) masses: Vec<MassSolution>,
    /// The value of each read of the plan.
    pub(super) reads: Vec<Complex64>,
}

/// The complete solution as states.
#[derive(Debug)]
pub(super) struct States {
    /// Motions and internal forces just inside the left and the right end of the span left of each station, and last of the
    /// span up to the right end.
    pub(super) ends: Vec<[BeamState; 2]>,
    /// The state of the subsystem at each station; zero for stations without one.
    pub(super) masses: Vec<MassSolution>,
    /// What the loss factor of the material dissipates in a radian, twice, N m.
    pub(super) dissipation: f64,
    /// What the foundation dissipates in a radian along w, psi and v, twice, N m.
    pub(super) on_foundation: [f64; 3],
}

impl Solution {
    /// The wave numbers of all beams, 1/m.
    pub(super) fn wave_numbers(&self) -> Vec<Complex64> {
        self.waves.iter().flat_map(|waves| waves.kappa).collect()
    }

    /// Multiplies the state by a factor; the reads stay.
    pub(super) fn scale(&mut self, by: Complex64) {
        let waves = self
            .spans
            .iter_mut()
            .flat_map(|span| span.a.iter_mut().chain(&mut span.b));
        let masses = self.masses.iter_mut();
        let masses = masses.flat_map(|of| of.forces.iter_mut().chain(&mut of.motion));
        for value in waves.chain(masses) {
            *value *= by;
        }
    }

    /// The waves of the beam of a span: that left of the station with its index.
    pub(super) fn waves_of(&self, plan: &Plan, span: usize) -> &Waves {
        &self.waves[plan.kinds[plan.spans[span]].beam]
    }
}
