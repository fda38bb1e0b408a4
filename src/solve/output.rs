//! What a response is: rows on the states of a solution, and what is made of them.

use crate::model::{BeamMotion, MassMotion, Measure};

/// A row on the state just left of a station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Row {
    /// A motion of the beam, plus its twist times an arm, m: w and v at a point of the section.
    Motion(BeamMotion, f64),
    /// A motion of the mass there.
    Mass(MassMotion),
}

/// A row at a station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Read {
    pub(super) station: usize,
    pub(super) row: Row,
}

/// A sum of reads, whose time derivative of the order of a measure is taken.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Sum {
    /// Indices of reads with their factors; none for what is always 0.
    pub(super) terms: Vec<(f64, usize)>,
    pub(super) measure: Measure,
}

/// The value of a response.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Output {
    /// A complex amplitude.
    Sum(Sum),
    /// `E_V`.
    Energy,
}
