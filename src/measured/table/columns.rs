//! The columns of a table and of a curve.

use super::column_title::{ColumnTitle, Role};
use super::dialect::Dialect;
use super::sample::ColumnContent;
use crate::measured::layout::Values;
use crate::unit::{Kind, PhaseUnit, ValueUnit};

/// The columns of one curve.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::measured) struct ColumnGroup {
    pub(in crate::measured) name: String,
    pub(in crate::measured) columns: Columns,
    pub(in crate::measured) unit: Option<ValueUnit>,
    /// Whether the first and the second column have the opposite sign.
    pub(super) minus: [bool; 2],
}

/// Columns by index. Equal indices of real and imaginary part: one column of complex numbers.
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

    /// The corresponding values of a layout.
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

    /// Columns for the values of a layout; one column is given twice.
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

    /// Both columns; a single column twice.
    pub(super) const fn both(self) -> [usize; 2] {
        match self {
            Self::Complex { re, im } => [re, im],
            Self::Polar { size, phase, .. } => [size, phase],
            Self::Magnitude { size, .. } => [size, size],
        }
    }

    /// These columns with the units of a layout.
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

impl ColumnGroup {
    /// The number of the first or second column with the sign applied.
    pub(super) fn signed(&self, which: usize, number: f64) -> f64 {
        if self.minus[which] { -number } else { number }
    }

    /// Decibels per factor of ten: 20, for an energy 10.
    pub(super) fn decibels_per_decade(&self) -> f64 {
        match self.unit.as_ref().map(ValueUnit::kind) {
            Some(Kind::Energy) => 10.0,
            _ => 20.0,
        }
    }
}

/// All columns with their titles.
pub(super) struct TableColumns<'a> {
    pub(super) dialect: &'a Dialect,
    pub(super) titles: Vec<ColumnTitle>,
    /// The value columns, without the frequencies.
    pub(super) free: Vec<usize>,
}

impl TableColumns<'_> {
    /// The number of a column and its original title.
    pub(super) fn title(&self, index: usize) -> String {
        match self.dialect.header.get(index).map(|word| word.trim()) {
            Some(word) if !word.is_empty() => format!("column {} ({word})", index + 1),
            _ => format!("column {}", index + 1),
        }
    }

    pub(super) fn is_complex(&self, index: usize) -> bool {
        self.dialect.columns.get(index) == Some(&ColumnContent::Complex)
    }

    pub(super) fn role(&self, index: usize) -> Role {
        self.titles
            .get(index)
            .map_or(Role::Unknown, |title| title.role)
    }

    /// The number columns, except the frequencies, that may be values.
    pub(super) fn value_columns(&self, frequency: usize) -> Vec<usize> {
        let dialect = self.dialect;
        let is_free = |index: &usize| {
            *index != frequency
                && dialect.columns[*index] != ColumnContent::Text
                && self.role(*index) != Role::Other
        };
        let first = usize::from(dialect.has_curves);
        (first..dialect.width()).filter(is_free).collect()
    }
}
