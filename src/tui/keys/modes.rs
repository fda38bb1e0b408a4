//! The rows of the key table for modes, peaks and finite elements.

use super::table::{DOWN, ESCAPE, FIRST, LAST, PAGE_DOWN, PAGE_UP, UP};
use super::{Binding, Command, Hint, bind, key};

/// Beside the tree and the chart.
pub(super) const MODES: &[Binding] = &[
    bind(
        &[key('m')],
        Command::ModeTable,
        Hint::Always("modes"),
        "table of modes, or close it",
    ),
    bind(
        &[key('P')],
        Command::PeakTable,
        Hint::Table("peaks"),
        "table of the first curve's peaks, or close it",
    ),
    bind(
        &[key(')')],
        Command::NextMode,
        Hint::Never,
        "select the next mode; the cursor goes to it",
    ),
    bind(
        &[key('(')],
        Command::PreviousMode,
        Hint::Never,
        "select the mode before",
    ),
    bind(
        &[key('M')],
        Command::Shape,
        Hint::Table("shape"),
        "shape of the selected mode, or hide it",
    ),
    bind(
        &[key('A')],
        Command::Animate,
        Hint::Table("move it"),
        "let the shape move, or stand still",
    ),
    bind(
        &[key('w')],
        Command::Witness,
        Hint::Never,
        "finite-element curve beside the exact one, as points, or without",
    ),
];

/// In a table below the chart.
pub(super) const TABLE: &[Binding] = &[
    bind(UP, Command::Up, Hint::Never, "row above"),
    bind(
        DOWN,
        Command::Down,
        Hint::Always("next row"),
        "row below; the cursor goes to it",
    ),
    bind(PAGE_UP, Command::PageUp, Hint::Never, "one screen up"),
    bind(PAGE_DOWN, Command::PageDown, Hint::Never, "one screen down"),
    bind(FIRST, Command::First, Hint::Never, "first row"),
    bind(LAST, Command::Last, Hint::Never, "last row"),
    bind(
        ESCAPE,
        Command::Cancel,
        Hint::Always("close"),
        "close the table",
    ),
];
