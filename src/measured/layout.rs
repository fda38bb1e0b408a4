//! The layout of a table of numbers, as one line of text.

mod parse;

use std::fmt;

use crate::unit::{FrequencyUnit, PhaseUnit, ValueUnit};

/// The layout of the columns of a table.
///
/// Its text has three parts, separated by semicolons, `FREQUENCY; VALUES; UNIT`:
/// - FREQUENCY: `hz`, `khz`, `rad/s` or `rpm`;
/// - VALUES, the columns of one curve: `re im`, `mag deg`, `mag rad`, `dB deg`, `dB rad`, `mag` or `dB`; dB is 20 log10
///   of the value over one unit (10 log10 if the unit is that of an energy); `-im`, `-deg` and `-rad` mean that the
///   column has the opposite sign; `re im` is also one column of complex numbers;
/// - UNIT: a unit that [`ValueUnit`] reads, or `?` (or nothing) if the file contains it or it is unknown.
///
/// A number after a word selects the column, from 1; without numbers the header determines the columns, else their
/// order. Several numbers are several curves.
///
/// Examples: `hz; re im; m/s2/N`, `hz; dB deg; g/N`, `rad/s; mag; ?`, `hz 1; re 8; im 9; m/N`,
/// `hz 2; mag 3 5; deg 4 6; m/N`, `hz; re -im; m/N`.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// Unit of the frequencies.
    pub frequency: FrequencyUnit,
    /// The columns of one curve.
    pub values: Values,
    /// Whether the imaginary part or the phase has the opposite sign.
    pub minus: bool,
    /// Unit of the values; none: from the file, or unknown.
    pub unit: Option<ValueUnit>,
    /// Columns that are selected by number.
    pub places: Places,
}

/// Columns that are selected by number, from 1.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Places {
    /// The column of the frequencies; none: by the header, or the first.
    pub frequency: Option<usize>,
    /// Both columns of each curve (the same one twice for a magnitude alone or complex numbers in one column); empty:
    /// by the header, or in order.
    pub curves: Vec<[usize; 2]>,
}

/// The columns of one curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Values {
    /// Real and imaginary part.
    Complex,
    /// Magnitude and phase.
    MagnitudePhase {
        /// Unit of the phase.
        phase: PhaseUnit,
        /// Whether the magnitude is in dB.
        decibels: bool,
    },
    /// The magnitude alone.
    Magnitude {
        /// Whether it is in dB.
        decibels: bool,
    },
}

impl Values {
    /// Whether they are the same columns, whatever their units.
    pub(super) const fn is_like(self, other: Self) -> bool {
        matches!(
            (self, other),
            (Self::Complex, Self::Complex)
                | (Self::MagnitudePhase { .. }, Self::MagnitudePhase { .. })
                | (Self::Magnitude { .. }, Self::Magnitude { .. })
        )
    }

    /// The number of columns of a curve.
    pub(super) const fn columns(self) -> usize {
        match self {
            Self::Complex | Self::MagnitudePhase { .. } => 2,
            Self::Magnitude { .. } => 1,
        }
    }
}

impl fmt::Display for Values {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = |decibels| if decibels { "dB" } else { "mag" };
        match *self {
            Self::Complex => f.write_str("re im"),
            Self::MagnitudePhase { phase, decibels } => {
                write!(f, "{} {}", size(decibels), phase.key())
            }
            Self::Magnitude { decibels } => f.write_str(size(decibels)),
        }
    }
}

impl Layout {
    /// Reads a layout.
    ///
    /// # Errors
    /// The wrong part and what is accepted.
    pub fn parse(text: &str) -> Result<Self, String> {
        parse::layout(text)
    }
}

/// The text that [`Layout::parse`] reads.
impl fmt::Display for Layout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.frequency.key())?;
        if let Some(column) = self.places.frequency {
            write!(f, " {column}")?;
        }
        let curves = &self.places.curves;
        let values = self.values.to_string();
        for (index, word) in values.split(' ').enumerate() {
            let parts = if index == 0 || !curves.is_empty() {
                "; "
            } else {
                " "
            };
            let minus = if self.minus && index == 1 { "-" } else { "" };
            write!(f, "{parts}{minus}{word}")?;
            for columns in curves {
                write!(f, " {}", columns[index])?;
            }
        }
        match &self.unit {
            Some(unit) => write!(f, "; {unit}"),
            None => f.write_str("; ?"),
        }
    }
}

/// Information that a file lacks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Question {
    /// The unit of its frequencies; the default is Hz.
    Frequency,
    /// The meaning of its columns; without an answer the file is rejected.
    Values,
    /// The unit of its phases; the default is degrees.
    Phase,
    /// The quantity and unit of its values; without an answer they are not converted.
    Unit,
}

impl Question {
    /// Whether there are no curves without an answer.
    pub const fn is_needed(self) -> bool {
        matches!(self, Self::Values)
    }
}

/// The missing information, and what is accepted.
impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Frequency => {
                let accepted = FrequencyUnit::ACCEPTED;
                return write!(f, "in which unit its frequencies are: {accepted}");
            }
            Self::Values => {
                "what its columns are: re im, mag deg, mag rad, dB deg, dB rad, mag or dB would be accepted, or with the \
                 numbers of the columns, as hz 1; re 8; im 9"
            }
            Self::Phase => "in which unit its phases are: deg or rad",
            Self::Unit => "what its values are: a unit such as m/N, mm/s/N, g/N, m/s2 or rad/(N m)",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layout_is_one_line_that_reads_back() {
        for text in [
            "hz; re im; m/s2/N",
            "khz; mag deg; mm/s",
            "rad/s; mag rad; rad/(N m)",
            "rpm; dB deg; g/N",
            "hz; dB rad; 1e-6 m/N",
            "hz; mag; kg m2",
            "hz; dB; ?",
            "hz; re -im; m/N",
            "hz; dB -rad; ?",
            "hz 1; re 8; im 9; m/N",
            "khz 2; mag 3 5; -deg 4 6; mm/s",
            "hz 2; re im; ?",
            "hz; dB 7; g",
            "hz; mag; deg",
            "hz 2; re 3; im 3; m/N",
        ] {
            let layout = Layout::parse(text).unwrap();
            assert_eq!(layout.to_string(), text);
            assert_eq!(Layout::parse(&layout.to_string()), Ok(layout));
        }
        assert_eq!(
            Layout::parse(" HZ ;RE  Im").unwrap().to_string(),
            "hz; re im; ?"
        );
        for (text, same) in [
            ("Hz; db DEG;", "hz; dB deg; ?"),
            ("hz 1; im 9; re 8; m/N", "hz 1; re 8; im 9; m/N"),
            ("hz 1; re 8 im 9; m/N", "hz 1; re 8; im 9; m/N"),
            ("hz 1; mag 2; Grad 3", "hz 1; mag 2; deg 3; ?"),
        ] {
            assert_eq!(Layout::parse(text).unwrap().to_string(), same);
        }
    }

    #[test]
    fn a_wrong_part_is_named_with_what_is_accepted() {
        for (text, part, accepted) in [
            ("", "", "hz; re im; m/s2/N"),
            ("hz", "", "hz; re im; m/s2/N"),
            ("hz; re im; m; 4", "", "hz; re im; m/s2/N"),
            ("mhz; re im", "\"mhz\"", "rad/s"),
            ("hz; im re", "\"im re\"", "mag deg"),
            ("hz; re deg", "\"re deg\"", "mag deg"),
            ("hz; re im; furlong", "\"furlong\"", "m/s2/N"),
            ("hz; -re im", "\"-re im\"", "re im"),
            ("hz; re 2 im", "\"re 2 im\"", "re 8; im 9"),
            ("hz; re 2 4; im 3; m", "\"re 2 4 im 3\"", "the same number"),
            ("hz 0; re im", "\"0\"", "from 1"),
            ("hz; re 0; im 1", "\"0\"", "from 1"),
            ("hz; re 99999999999999999999; im 1", "", "from 1"),
            ("hz 1 2; re im", "\"hz 1 2\"", "rad/s"),
        ] {
            let message = Layout::parse(text).unwrap_err();
            assert!(
                message.contains(part) && message.contains(accepted),
                "{text}: {message}"
            );
        }
    }
}
