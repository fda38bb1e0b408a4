//! The columns of one curve.

use crate::measured::layout::Values;
use crate::unit::PhaseUnit;
use crate::unit::{Kind, ValueUnit};

/// The columns of one curve.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::measured) struct Group {
    pub(in crate::measured) name: String,
    pub(in crate::measured) columns: Columns,
    pub(in crate::measured) unit: Option<ValueUnit>,
    /// Whether the first and the second column hold the opposite.
    pub(super) minus: [bool; 2],
}

/// Columns by their index. Real and imaginary part in one column are complex numbers in its cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::measured) enum Columns {
    Complex {
        re: usize,
        im: usize,
    },
    Polar {
        size: usize,
        decibels: bool,
        phase: usize,
        unit: PhaseUnit,
    },
    Magnitude {
        size: usize,
        decibels: bool,
    },
}

impl Columns {
    pub(super) const fn have_phase(self) -> bool {
        !matches!(self, Self::Magnitude { .. })
    }

    /// What a layout calls them.
    pub(in crate::measured) const fn values(self) -> Values {
        match self {
            Self::Complex { .. } => Values::Complex,
            Self::Polar {
                decibels,
                unit: phase,
                ..
            } => Values::MagnitudePhase { phase, decibels },
            Self::Magnitude { decibels, .. } => Values::Magnitude { decibels },
        }
    }

    /// The columns of a layout; of one, both are the same.
    pub(super) const fn of(values: Values, first: usize, second: usize) -> Self {
        match values {
            Values::Complex => Self::Complex {
                re: first,
                im: second,
            },
            Values::MagnitudePhase {
                phase: unit,
                decibels,
            } => Self::Polar {
                size: first,
                decibels,
                phase: second,
                unit,
            },
            Values::Magnitude { decibels } => Self::Magnitude {
                size: first,
                decibels,
            },
        }
    }

    /// Both columns; of one, it twice.
    pub(super) const fn both(self) -> [usize; 2] {
        match self {
            Self::Complex { re, im } => [re, im],
            Self::Polar { size, phase, .. } => [size, phase],
            Self::Magnitude { size, .. } => [size, size],
        }
    }

    /// These columns, in the units of a layout.
    pub(super) const fn in_units_of(self, values: Values) -> Self {
        match (self, values) {
            (
                Self::Polar { size, phase, .. },
                Values::MagnitudePhase {
                    phase: unit,
                    decibels,
                },
            ) => Self::Polar {
                size,
                decibels,
                phase,
                unit,
            },
            (Self::Magnitude { size, .. }, Values::Magnitude { decibels }) => {
                Self::Magnitude { size, decibels }
            }
            _ => self,
        }
    }
}

impl Group {
    /// The number in the first or second column with its sign.
    pub(super) fn signed(&self, which: usize, number: f64) -> f64 {
        if self.minus[which] { -number } else { number }
    }

    /// Decibels that are a factor of ten: 20, of an energy 10.
    pub(super) fn decibels_a_decade(&self) -> f64 {
        match self.unit.as_ref().map(ValueUnit::kind) {
            Some(Kind::Energy) => 10.0,
            _ => 20.0,
        }
    }
}
