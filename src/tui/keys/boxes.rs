//! The rows of the key table for the boxes over the designer.

use crossterm::event::KeyCode;

use super::table::{DOWN, ENTER, ESCAPE, FIRST, LAST, PAGE_DOWN, PAGE_UP, UP};
use super::{Binding, Command, Hint, Key, bind, control, key, special};

/// While something is typed.
pub(super) const PROMPT: &[Binding] = &[
    bind(
        "accept",
        ENTER,
        Command::Accept,
        Hint::Always("take it"),
        "take what is typed",
    ),
    bind(
        "cancel",
        ESCAPE,
        Command::Cancel,
        Hint::Always("leave as it was"),
        "close the box, changing nothing",
    ),
    bind(
        "complete",
        &[special(KeyCode::Tab)],
        Command::Complete,
        Hint::Never,
        "complete a file's path",
    ),
];

/// In the palette.
pub(super) const PALETTE: &[Binding] = &[
    bind("up", LINE_UP, Command::Up, Hint::Never, "entry above"),
    bind(
        "down",
        LINE_DOWN,
        Command::Down,
        Hint::Always("next"),
        "entry below",
    ),
    bind(
        "page-up",
        &[special(KeyCode::PageUp)],
        Command::PageUp,
        Hint::Never,
        "one screen up",
    ),
    bind(
        "page-down",
        &[special(KeyCode::PageDown)],
        Command::PageDown,
        Hint::Never,
        "one screen down",
    ),
    bind(
        "accept",
        ENTER,
        Command::Accept,
        Hint::Always("do or edit it"),
        "do the command, or go to the parameter and edit it",
    ),
    bind(
        "cancel",
        ESCAPE,
        Command::Cancel,
        Hint::Always("close"),
        "close the palette",
    ),
];

/// While the tree is searched.
pub(super) const SEARCH: &[Binding] = &[
    bind("up", LINE_UP, Command::Up, Hint::Never, "found row above"),
    bind(
        "down",
        LINE_DOWN,
        Command::Down,
        Hint::Always("next"),
        "found row below",
    ),
    bind(
        "accept",
        ENTER,
        Command::Accept,
        Hint::Always("stay there"),
        "stay on the row",
    ),
    bind(
        "cancel",
        ESCAPE,
        Command::Cancel,
        Hint::Always("go back"),
        "go back to the row where the search began",
    ),
];

/// Up and down where characters are typed.
const LINE_UP: &[Key] = &[
    special(KeyCode::Up),
    control('p'),
    special(KeyCode::BackTab),
];
const LINE_DOWN: &[Key] = &[special(KeyCode::Down), control('n'), special(KeyCode::Tab)];

/// In the list of presets.
pub(super) const PICKER: &[Binding] = &[
    bind("up", UP, Command::Up, Hint::Never, "preset above"),
    bind("down", DOWN, Command::Down, Hint::Never, "preset below"),
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
    bind("first", FIRST, Command::First, Hint::Never, "first preset"),
    bind("last", LAST, Command::Last, Hint::Never, "last preset"),
    bind(
        "accept",
        ENTER,
        Command::Accept,
        Hint::Always("open"),
        "open the preset",
    ),
    bind(
        "cancel",
        &[special(KeyCode::Esc), key('q'), key('p')],
        Command::Cancel,
        Hint::Always("close"),
        "close the list",
    ),
];

/// In help and lists of faults.
pub(super) const READER: &[Binding] = &[
    bind("up", UP, Command::Up, Hint::Never, "one line up"),
    bind(
        "down",
        DOWN,
        Command::Down,
        Hint::Always("scroll"),
        "one line down",
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
        &[special(KeyCode::PageDown), control('d'), key(' ')],
        Command::PageDown,
        Hint::Always("page"),
        "one screen down",
    ),
    bind("first", FIRST, Command::First, Hint::Never, "the top"),
    bind("last", LAST, Command::Last, Hint::Never, "the end"),
    bind(
        "cancel",
        &[
            special(KeyCode::Esc),
            key('q'),
            key('?'),
            special(KeyCode::Enter),
        ],
        Command::Cancel,
        Hint::Always("close"),
        "close",
    ),
];

/// When asked about unsaved changes.
pub(super) const UNSAVED: &[Binding] = &[
    bind(
        "save",
        &[key('s'), key('y')],
        Command::Save,
        Hint::Always("save first"),
        "save, then go on",
    ),
    bind(
        "discard",
        &[key('d'), key('n')],
        Command::Discard,
        Hint::Always("discard the changes"),
        "go on without saving",
    ),
    bind(
        "cancel",
        ESCAPE,
        Command::Cancel,
        Hint::Always("stay"),
        "stay, as if nothing had been asked",
    ),
];

/// When asked before a file is replaced.
pub(super) const REPLACE: &[Binding] = &[
    bind(
        "replace",
        &[key('y')],
        Command::Replace,
        Hint::Always("replace it"),
        "replace the file",
    ),
    bind(
        "cancel",
        &[special(KeyCode::Esc), key('n')],
        Command::Cancel,
        Hint::Always("keep it"),
        "keep the file; nothing is saved",
    ),
];

/// In the list of unsaved changes that were found.
pub(super) const RECOVERY: &[Binding] = &[
    bind("up", UP, Command::Up, Hint::Never, "changes above"),
    bind("down", DOWN, Command::Down, Hint::Never, "changes below"),
    bind(
        "accept",
        ENTER,
        Command::Accept,
        Hint::Always("take them"),
        "take the changes: the model is as it was when they were lost",
    ),
    bind(
        "discard",
        &[key('x'), key('d'), special(KeyCode::Delete)],
        Command::Discard,
        Hint::Always("discard"),
        "discard the changes for good",
    ),
    bind(
        "cancel",
        &[special(KeyCode::Esc), key('q')],
        Command::Cancel,
        Hint::Always("later"),
        "leave them for the next start",
    ),
];
