//! The rows of the key table for modes, peaks and finite elements.

use super::table::{DOWN, ESCAPE, FIRST, LAST, PAGE_DOWN, PAGE_UP, UP};
use super::{Binding, Command, Hint, bind, key};

/// Beside the tree and the chart.
pub(super) const MODES: &[Binding] = &[
    bind(
        "mode-table",
        &[key('m')],
        Command::ModeTable,
        Hint::Always("modes"),
        "table of modes, or close it",
    ),
    bind(
        "peak-table",
        &[key('P')],
        Command::PeakTable,
        Hint::Table("peaks"),
        "table of the first curve's peaks, or close it",
    ),
    bind(
        "next-mode",
        &[key(')')],
        Command::NextMode,
        Hint::Never,
        "select the next mode; the cursor goes to it",
    ),
    bind(
        "previous-mode",
        &[key('(')],
        Command::PreviousMode,
        Hint::Never,
        "select the mode before",
    ),
    bind(
        "shape",
        &[key('M')],
        Command::Shape,
        Hint::Table("shape"),
        "shape of the selected mode, or hide it",
    ),
    bind(
        "animate",
        &[key('A')],
        Command::Animate,
        Hint::Table("move it"),
        "let the shape move, or stand still",
    ),
    bind(
        "finite-elements",
        &[key('w')],
        Command::Witness,
        Hint::Never,
        "finite-element curve beside the exact one, as points, or without",
    ),
];

/// In a table below the chart.
pub(super) const TABLE: &[Binding] = &[
    bind("up", UP, Command::Up, Hint::Never, "row above"),
    bind(
        "down",
        DOWN,
        Command::Down,
        Hint::Always("next row"),
        "row below; the cursor goes to it",
    ),
    bind(
        "page-up",
        PAGE_UP,
        Command::PageUp,
        Hint::Never,
        "one screen up",
    ),
    bind(
        "page-down",
        PAGE_DOWN,
        Command::PageDown,
        Hint::Never,
        "one screen down",
    ),
    bind("first", FIRST, Command::First, Hint::Never, "first row"),
    bind("last", LAST, Command::Last, Hint::Never, "last row"),
    bind(
        "close",
        ESCAPE,
        Command::Cancel,
        Hint::Always("close"),
        "close the table",
    ),
];
