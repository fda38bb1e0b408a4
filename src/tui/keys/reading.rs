//! The rows of the key table for reading values off the chart.

use crossterm::event::KeyCode;

use super::{Binding, Command, Hint, bind, key, special};

/// Views, units and cursors.
pub(super) const READING: &[Binding] = &[
    bind(
        "next-view",
        &[key('b')],
        Command::NextView,
        Hint::Never,
        "next view: magnitude, with phase, real and imaginary, Nyquist, difference to the reference",
    ),
    bind(
        "next-form",
        &[key('i')],
        Command::NextForm,
        Hint::Never,
        "next form: as asked for, receptance, mobility, accelerance, their inverses, motion under the force as it is",
    ),
    bind(
        "previous-form",
        &[key('I')],
        Command::PreviousForm,
        Hint::Never,
        "form before",
    ),
    bind(
        "decibels",
        &[key('d')],
        Command::Decibels,
        Hint::Never,
        "magnitude in powers of ten or in decibels",
    ),
    bind(
        "decibel-reference",
        &[key('%')],
        Command::DecibelReference,
        Hint::Never,
        "type the value of 0 dB",
    ),
    bind(
        "frequency-unit",
        &[key('#')],
        Command::FrequencyUnit,
        Hint::Never,
        "frequencies in Hz, rad/s or rpm",
    ),
    bind(
        "unwrap",
        &[key('\'')],
        Command::Unwrap,
        Hint::Never,
        "phase runs on, or stays within half a turn",
    ),
    bind(
        "cursor-right",
        &[key(']')],
        Command::Cursor(1),
        Hint::Never,
        "cursor a column to the right",
    ),
    bind(
        "cursor-left",
        &[key('[')],
        Command::Cursor(-1),
        Hint::Never,
        "cursor a column to the left",
    ),
    bind(
        "cursor-off",
        &[special(KeyCode::Esc)],
        Command::Cancel,
        Hint::Never,
        "drop a count that was typed, end a search, or take the cursor off the chart",
    ),
    bind(
        "next-peak",
        &[key('}')],
        Command::NextPeak,
        Hint::Never,
        "cursor to the next peak of the first curve",
    ),
    bind(
        "previous-peak",
        &[key('{')],
        Command::PreviousPeak,
        Hint::Never,
        "cursor to the peak before",
    ),
    bind(
        "next-dip",
        &[key('\\')],
        Command::NextDip,
        Hint::Never,
        "cursor to the next anti-resonance of the first curve",
    ),
    bind(
        "previous-dip",
        &[key('|')],
        Command::PreviousDip,
        Hint::Never,
        "cursor to the anti-resonance before",
    ),
    bind(
        "go-to",
        &[key('@')],
        Command::GoTo,
        Hint::Never,
        "cursor to a frequency that is typed",
    ),
    bind(
        "readings",
        &[key('"')],
        Command::Readings,
        Hint::Never,
        "table of what every curve is at the cursors, or close it",
    ),
    bind(
        "second-cursor",
        &[key('c')],
        Command::SecondCursor,
        Hint::Never,
        "second cursor here, from which differences are counted; again: without",
    ),
    bind(
        "harmonics",
        &[key('H')],
        Command::Harmonics,
        Hint::Never,
        "mark the harmonics of the cursor, or not",
    ),
    bind(
        "band",
        &[key('_')],
        Command::Band,
        Hint::Never,
        "mark the band between the cursors, or that shows, and tell its levels; again: without",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::FrequencyUnit;

    #[test]
    fn the_help_names_the_units_that_the_key_goes_through() {
        let row = READING
            .iter()
            .find(|row| row.command == Command::FrequencyUnit)
            .unwrap();
        assert!(row.help.ends_with(FrequencyUnit::SHOWN_WORDS));
    }
}
