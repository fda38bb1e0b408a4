//! The rows of the key table for comparing, and for looking at the beam.

use crossterm::event::KeyCode;

use super::table::{DOWN, ENTER, FIRST, LAST, PAGE_DOWN, PAGE_UP, UP};
use super::{Binding, Command, Hint, bind, control, key, special};

/// What stands beside the model, and what goes out.
pub(super) const COMPARE: &[Binding] = &[
    bind(
        "beside",
        &[key('Q')],
        Command::Beside,
        Hint::Never,
        "references and measured curves: show, name, drop, load",
    ),
    bind(
        "add-measured",
        &[control('o')],
        Command::AddMeasured,
        Hint::Never,
        "open a measured curve: CSV or universal file (UFF 58)",
    ),
    bind(
        "make-study",
        &[control('t')],
        Command::MakeStudy,
        Hint::Never,
        "sweep the selected parameter: a study of it with factors or values that are typed",
    ),
    bind(
        "export",
        &[control('e')],
        Command::Export,
        Hint::Never,
        "write what is on the screen: .csv, .svg or .txt",
    ),
];

/// What the beam does and is.
pub(super) const LOOK: &[Binding] = &[
    bind(
        "operating",
        &[key('O')],
        Command::Operating,
        Hint::Never,
        "operating deflection at the cursor, then internal forces, then power; again: nothing",
    ),
    bind(
        "phase-step",
        &[key('`')],
        Command::PhaseStep,
        Hint::Never,
        "a step further in the period of what moves",
    ),
    bind(
        "structure",
        &[key('B')],
        Command::Structure,
        Hint::Never,
        "drawing of the beam, then of its cross-section; again: nothing",
    ),
];

/// In the list of what stands beside the model.
pub(super) const BESIDE: &[Binding] = &[
    bind("up", UP, Command::Up, Hint::Never, "entry above"),
    bind("down", DOWN, Command::Down, Hint::Never, "entry below"),
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
    bind("first", FIRST, Command::First, Hint::Never, "first entry"),
    bind("last", LAST, Command::Last, Hint::Never, "last entry"),
    bind(
        "accept",
        ENTER,
        Command::Accept,
        Hint::Always("show or hide"),
        "show it, or hide it",
    ),
    bind(
        "add-reference",
        &[key('a')],
        Command::AddReference,
        Hint::Always("load a model"),
        "load a model as a reference",
    ),
    bind(
        "add-measured",
        &[key('m')],
        Command::AddMeasured,
        Hint::Always("load a measured curve"),
        "load a measured curve",
    ),
    bind(
        "rename",
        &[key('r')],
        Command::Rename,
        Hint::Always("rename"),
        "give it another name",
    ),
    bind(
        "delete",
        &[key('x'), special(KeyCode::Delete)],
        Command::Delete,
        Hint::Always("drop"),
        "drop it",
    ),
    bind(
        "cancel",
        &[special(KeyCode::Esc), key('q'), key('Q')],
        Command::Cancel,
        Hint::Always("close"),
        "close the list",
    ),
];
