//! The rows of the key table.

use crossterm::event::KeyCode;

use super::boxes::{PICKER, PROMPT, READER, REPLACE, UNSAVED};
use super::modes::{MODES, TABLE};
use super::{Binding, Command, Hint, Key, Scope, Section, bind, control, key, special};

/// Every binding, in the order of help.
pub const SECTIONS: &[Section] = &[
    Section {
        title: "Move in the model",
        scope: Scope::Main,
        bindings: MOVE,
    },
    Section {
        title: "Change the model",
        scope: Scope::Main,
        bindings: CHANGE,
    },
    Section {
        title: "Curves",
        scope: Scope::Main,
        bindings: CURVES,
    },
    Section {
        title: "Modes, peaks and finite elements",
        scope: Scope::Main,
        bindings: MODES,
    },
    Section {
        title: "Files and program",
        scope: Scope::Main,
        bindings: FILES,
    },
    Section {
        title: "Everywhere",
        scope: Scope::Any,
        bindings: ANYWHERE,
    },
    Section {
        title: "In a table of modes or peaks (all other keys as without it)",
        scope: Scope::Table,
        bindings: TABLE,
    },
    Section {
        title: "While typing",
        scope: Scope::Prompt,
        bindings: PROMPT,
    },
    Section {
        title: "List of presets",
        scope: Scope::Picker,
        bindings: PICKER,
    },
    Section {
        title: "Help and lists of faults",
        scope: Scope::Reader,
        bindings: READER,
    },
    Section {
        title: "Asked about unsaved changes",
        scope: Scope::Unsaved,
        bindings: UNSAVED,
    },
    Section {
        title: "Asked before a file is replaced",
        scope: Scope::Replace,
        bindings: REPLACE,
    },
];

pub(super) const UP: &[Key] = &[special(KeyCode::Up), key('k')];
pub(super) const DOWN: &[Key] = &[special(KeyCode::Down), key('j')];
pub(super) const PAGE_UP: &[Key] = &[special(KeyCode::PageUp), control('u')];
pub(super) const PAGE_DOWN: &[Key] = &[special(KeyCode::PageDown), control('d')];
pub(super) const FIRST: &[Key] = &[special(KeyCode::Home), key('g')];
pub(super) const LAST: &[Key] = &[special(KeyCode::End), key('G')];
pub(super) const ENTER: &[Key] = &[special(KeyCode::Enter)];
pub(super) const ESCAPE: &[Key] = &[special(KeyCode::Esc)];

const MOVE: &[Binding] = &[
    bind(UP, Command::Up, Hint::Never, "row above"),
    bind(DOWN, Command::Down, Hint::Never, "row below"),
    bind(PAGE_UP, Command::PageUp, Hint::Never, "one screen up"),
    bind(PAGE_DOWN, Command::PageDown, Hint::Never, "one screen down"),
    bind(FIRST, Command::First, Hint::Never, "first row"),
    bind(LAST, Command::Last, Hint::Never, "last row"),
    bind(
        &[special(KeyCode::Right), key('l')],
        Command::Expand,
        Hint::Group("open"),
        "open the group, or go into it",
    ),
    bind(
        &[special(KeyCode::Left), key('h')],
        Command::Collapse,
        Hint::Never,
        "close the group, or go to the one that holds the row",
    ),
    bind(
        &[key('E')],
        Command::ExpandAll,
        Hint::Never,
        "open every group, but for the springs of free motions",
    ),
    bind(
        &[key('C')],
        Command::CollapseAll,
        Hint::Never,
        "close every group",
    ),
    bind(
        &[special(KeyCode::Tab)],
        Command::NextParameter,
        Hint::Group("next value"),
        "next parameter, opening the group that holds it",
    ),
    bind(
        &[special(KeyCode::BackTab)],
        Command::PreviousParameter,
        Hint::Never,
        "parameter before",
    ),
    bind(
        &[key('n')],
        Command::NextAlike,
        Hint::Never,
        "same parameter of the next subsystem, support, force or response",
    ),
    bind(
        &[key('N')],
        Command::PreviousAlike,
        Hint::Never,
        "same parameter of the one before",
    ),
];

const CHANGE: &[Binding] = &[
    bind(
        ENTER,
        Command::Edit,
        Hint::Value("edit"),
        "type a value (4e7, 40M, 40 MN/m, *1.1, /2, +5%), next choice, or open and close",
    ),
    bind(
        &[key('+'), key('=')],
        Command::Nudge(10),
        Hint::Number("1 % more"),
        "1 % more",
    ),
    bind(
        &[key('-')],
        Command::Nudge(-10),
        Hint::Number("less"),
        "1 % less",
    ),
    bind(
        &[key('>')],
        Command::Nudge(100),
        Hint::Number("10 % more"),
        "10 % more",
    ),
    bind(
        &[key('<')],
        Command::Nudge(-100),
        Hint::Number("less"),
        "10 % less",
    ),
    bind(&[key('.')], Command::Nudge(1), Hint::Never, "0.1 % more"),
    bind(&[key(',')], Command::Nudge(-1), Hint::Never, "0.1 % less"),
    bind(
        &[key(' ')],
        Command::Cycle,
        Hint::Choice("next choice"),
        "next choice (support, spacing, measure, direction, place), or open and close",
    ),
    bind(
        &[special(KeyCode::Backspace)],
        Command::Revert,
        Hint::Never,
        "put the file's value back",
    ),
    bind(
        &[key('a')],
        Command::Add,
        Hint::List("add"),
        "add a subsystem, force or response",
    ),
    bind(
        &[key('D')],
        Command::Duplicate,
        Hint::Item("duplicate"),
        "duplicate the subsystem, force or response",
    ),
    bind(
        &[key('r')],
        Command::Rename,
        Hint::Item("rename"),
        "rename the subsystem, response or study",
    ),
    bind(
        &[key('e')],
        Command::Enable,
        Hint::Item("on/off"),
        "enable or disable the subsystem, force or response",
    ),
    bind(
        &[key('x'), special(KeyCode::Delete)],
        Command::Delete,
        Hint::Item("delete"),
        "delete the subsystem, force, response or study",
    ),
    bind(&[key('u')], Command::Undo, Hint::Always("undo"), "undo"),
    bind(
        &[key('U'), control('r')],
        Command::Redo,
        Hint::Never,
        "redo",
    ),
];

const CURVES: &[Binding] = &[
    bind(
        &[key('v')],
        Command::Show,
        Hint::Item("show"),
        "show or hide the response's curve",
    ),
    bind(
        &[key('V')],
        Command::Solo,
        Hint::Never,
        "show only this response; again: all of its unit",
    ),
    bind(
        &[key('f')],
        Command::Freeze,
        Hint::Always("freeze"),
        "keep the curves as a dotted reference",
    ),
    bind(
        &[key('F')],
        Command::Unfreeze,
        Hint::Never,
        "drop the reference",
    ),
    bind(
        &[key('t')],
        Command::Study,
        Hint::Always("study"),
        "next study, or none",
    ),
    bind(
        &[key('}')],
        Command::NextExtremum,
        Hint::Never,
        "cursor to the next peak or dip of the first curve",
    ),
    bind(
        &[key('{')],
        Command::PreviousExtremum,
        Hint::Never,
        "cursor to the peak or dip before",
    ),
    bind(
        &[key(']')],
        Command::Cursor(1),
        Hint::Never,
        "cursor to the right",
    ),
    bind(
        &[key('[')],
        Command::Cursor(-1),
        Hint::Never,
        "cursor to the left",
    ),
    bind(
        &[special(KeyCode::Esc)],
        Command::Cancel,
        Hint::Never,
        "take the cursor off the chart",
    ),
    bind(
        &[key('L')],
        Command::LogFrequency,
        Hint::Never,
        "frequency axis logarithmic or linear",
    ),
    bind(
        &[key('d')],
        Command::Decibels,
        Hint::Never,
        "magnitude in powers of ten or in decibels",
    ),
];

const FILES: &[Binding] = &[
    bind(
        &[key('s'), control('s')],
        Command::Save,
        Hint::Always("save"),
        "save",
    ),
    bind(
        &[key('S')],
        Command::SaveAs,
        Hint::Never,
        "save to another file",
    ),
    bind(&[key('o')], Command::Open, Hint::Never, "open a file"),
    bind(
        &[key('p')],
        Command::Presets,
        Hint::Always("presets"),
        "choose a preset",
    ),
    bind(
        &[key('?'), special(KeyCode::F(1))],
        Command::Help,
        Hint::Always("help"),
        "this help",
    ),
    bind(
        &[key('q')],
        Command::Quit,
        Hint::Always("quit"),
        "quit; asks when something is not saved",
    ),
];

const ANYWHERE: &[Binding] = &[
    bind(
        &[control('l')],
        Command::Redraw,
        Hint::Never,
        "draw the screen anew",
    ),
    bind(&[control('c')], Command::Quit, Hint::Never, "quit"),
];
