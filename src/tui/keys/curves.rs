//! The rows of the key table for the chart.

use crossterm::event::KeyCode;

use super::{Binding, Command, Hint, bind, key, shifted, special};

/// The chart.
pub(super) const CURVES: &[Binding] = &[
    bind(
        "show",
        &[key('v')],
        Command::Show,
        Hint::Item("show"),
        "show or hide the response's curve",
    ),
    bind(
        "solo",
        &[key('V')],
        Command::Solo,
        Hint::Never,
        "show only this response; again: all of its unit",
    ),
    bind(
        "freeze",
        &[key('f')],
        Command::Freeze,
        Hint::Always("freeze"),
        "keep the curves as a dotted reference",
    ),
    bind(
        "unfreeze",
        &[key('F')],
        Command::Unfreeze,
        Hint::Never,
        "drop the reference",
    ),
    bind(
        "study",
        &[key('t')],
        Command::Study,
        Hint::Always("study"),
        "next study, or none",
    ),
    bind(
        "next-extremum",
        &[key('}')],
        Command::NextExtremum,
        Hint::Never,
        "cursor to the next peak or dip of the first curve",
    ),
    bind(
        "previous-extremum",
        &[key('{')],
        Command::PreviousExtremum,
        Hint::Never,
        "cursor to the peak or dip before",
    ),
    bind(
        "cursor-right",
        &[key(']')],
        Command::Cursor(1),
        Hint::Never,
        "cursor to the right",
    ),
    bind(
        "cursor-left",
        &[key('[')],
        Command::Cursor(-1),
        Hint::Never,
        "cursor to the left",
    ),
    bind(
        "cursor-off",
        &[special(KeyCode::Esc)],
        Command::Cancel,
        Hint::Never,
        "drop a count that was typed, end a search, or take the cursor off the chart",
    ),
    bind(
        "zoom-in",
        &[key('z')],
        Command::ZoomIn,
        Hint::Never,
        "half of the frequencies, about the cursor",
    ),
    bind(
        "zoom-out",
        &[key('Z')],
        Command::ZoomOut,
        Hint::Never,
        "twice the frequencies",
    ),
    bind(
        "zoom-whole",
        &[key('W')],
        Command::ZoomWhole,
        Hint::Never,
        "the whole sweep",
    ),
    bind(
        "pan-up",
        &[key('K'), shifted(KeyCode::Right)],
        Command::Pan(1),
        Hint::Never,
        "higher frequencies, by a quarter of those that show",
    ),
    bind(
        "pan-down",
        &[key('J'), shifted(KeyCode::Left)],
        Command::Pan(-1),
        Hint::Never,
        "lower frequencies",
    ),
    bind(
        "log-frequency",
        &[key('L')],
        Command::LogFrequency,
        Hint::Never,
        "frequency axis logarithmic or linear",
    ),
    bind(
        "decibels",
        &[key('d')],
        Command::Decibels,
        Hint::Never,
        "magnitude in powers of ten or in decibels",
    ),
];
