//! The rows of the key table for the chart: which curves show, and what of them.

use crossterm::event::KeyCode;

use super::{Binding, Command, Hint, bind, key, shifted};

/// Curves, frequencies and levels.
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
        "keep the curves as a reference, dotted",
    ),
    bind(
        "unfreeze",
        &[key('F')],
        Command::Unfreeze,
        Hint::Never,
        "drop the newest reference",
    ),
    bind(
        "study",
        &[key('t')],
        Command::Study,
        Hint::Always("study"),
        "next study, or none",
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
        "the whole sweep, levels that follow the curves",
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
        "level-in",
        &[key('*')],
        Command::LevelIn,
        Hint::Never,
        "half of the levels, about the middle; they are fixed then",
    ),
    bind(
        "level-out",
        &[key('&')],
        Command::LevelOut,
        Hint::Never,
        "twice the levels",
    ),
    bind(
        "level-up",
        &[shifted(KeyCode::Up)],
        Command::LevelPan(1),
        Hint::Never,
        "higher levels, by a quarter of those that show",
    ),
    bind(
        "level-down",
        &[shifted(KeyCode::Down)],
        Command::LevelPan(-1),
        Hint::Never,
        "lower levels",
    ),
    bind(
        "level-fix",
        &[key('!')],
        Command::LevelFix,
        Hint::Never,
        "keep the levels that show, or let them follow the curves",
    ),
];
