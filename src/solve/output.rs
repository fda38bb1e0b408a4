//! What a response is: rows on the states of a solution, and what is made of them.

use crate::model::{BeamMotion, MassMotion, Measure, SpringMeasure, SpringName};

/// A row on the state just left of a station.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Row {
    /// A motion of the beam, plus its twist times an arm, m: w and v at a point of the section.
    Motion(BeamMotion, f64),
    /// An internal force of the beam, conjugate to a motion.
    Force(BeamMotion),
    /// What the beam puts on the ground by a support, along a motion of the point that it holds.
    Reaction(Holds, BeamMotion),
    /// A motion of the mass there.
    Mass(MassMotion),
    /// What a spring of the subsystem there carries, or its stretch, the beam's end less the mass's.
    Spring(SpringName, SpringMeasure),
    /// What a spring carries along a motion that a support at its place fixes, as a part of the reaction there: between them
    /// is no beam, and the sweep leaves it out.
    OnFixed(SpringName),
}

/// Which support a reaction is of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Holds {
    /// That of the left end, read just inside of it.
    Left,
    /// That of the right end, read just inside of it.
    Right,
    /// That of the station.
    Station,
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
    /// A complex amplitude, and what divides it.
    Sum(Sum, Option<Sum>),
    /// `E_V`.
    Energy,
}
