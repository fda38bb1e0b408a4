//! The whole solution of a plan at one frequency, as plain numbers.

use num_complex::Complex64;

use super::waves::{Amplitudes, Waves};

/// The waves in a span: what leaves its left end to the right, and its right end to the left.
#[derive(Debug, Clone)]
pub(super) struct SpanWaves {
    pub(super) a: Amplitudes,
    pub(super) b: Amplitudes,
}

/// What a subsystem does.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct MassSolution {
    /// The forces of its channels, N: of the y springs, the sum and the difference of the z springs.
    pub(super) forces: [Complex64; 3],
    /// y, z, theta of the mass, m and rad.
    pub(super) motion: [Complex64; 3],
}

/// Everything that moves.
#[derive(Debug, Clone)]
pub(super) struct Solution {
    pub(super) waves: Waves,
    /// exp(-kappa l) of each distinct span.
    pub(super) decays: Vec<Amplitudes>,
    /// Of the span left of each station, and last of the span up to the right end.
    pub(super) spans: Vec<SpanWaves>,
    /// What each station does that is an attachment; zero of the others.
    pub(super) masses: Vec<MassSolution>,
}
