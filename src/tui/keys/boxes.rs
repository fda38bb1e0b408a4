//! The rows of the key table for the boxes over the designer.

use crossterm::event::KeyCode;

use super::table::{DOWN, ENTER, ESCAPE, FIRST, LAST, PAGE_DOWN, PAGE_UP, UP};
use super::{Binding, Command, Hint, bind, control, key, special};

/// While something is typed.
pub(super) const PROMPT: &[Binding] = &[
    bind(
        ENTER,
        Command::Accept,
        Hint::Always("take it"),
        "take what is typed",
    ),
    bind(
        ESCAPE,
        Command::Cancel,
        Hint::Always("leave as it was"),
        "close the box, changing nothing",
    ),
    bind(
        &[special(KeyCode::Tab)],
        Command::Complete,
        Hint::Never,
        "complete a file's path",
    ),
];

/// In the list of presets.
pub(super) const PICKER: &[Binding] = &[
    bind(UP, Command::Up, Hint::Never, "preset above"),
    bind(DOWN, Command::Down, Hint::Never, "preset below"),
    bind(PAGE_UP, Command::PageUp, Hint::Never, "one screen up"),
    bind(PAGE_DOWN, Command::PageDown, Hint::Never, "one screen down"),
    bind(FIRST, Command::First, Hint::Never, "first preset"),
    bind(LAST, Command::Last, Hint::Never, "last preset"),
    bind(
        ENTER,
        Command::Accept,
        Hint::Always("open"),
        "open the preset",
    ),
    bind(
        &[special(KeyCode::Esc), key('q'), key('p')],
        Command::Cancel,
        Hint::Always("close"),
        "close the list",
    ),
];

/// In help and lists of faults.
pub(super) const READER: &[Binding] = &[
    bind(UP, Command::Up, Hint::Never, "one line up"),
    bind(DOWN, Command::Down, Hint::Always("scroll"), "one line down"),
    bind(PAGE_UP, Command::PageUp, Hint::Never, "one screen up"),
    bind(
        &[special(KeyCode::PageDown), control('d'), key(' ')],
        Command::PageDown,
        Hint::Always("page"),
        "one screen down",
    ),
    bind(FIRST, Command::First, Hint::Never, "the top"),
    bind(LAST, Command::Last, Hint::Never, "the end"),
    bind(
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
        &[key('s'), key('y')],
        Command::Save,
        Hint::Always("save first"),
        "save, then go on",
    ),
    bind(
        &[key('d'), key('n')],
        Command::Discard,
        Hint::Always("discard the changes"),
        "go on without saving",
    ),
    bind(
        ESCAPE,
        Command::Cancel,
        Hint::Always("stay"),
        "stay, as if nothing had been asked",
    ),
];

/// When asked before a file is replaced.
pub(super) const REPLACE: &[Binding] = &[
    bind(
        &[key('y')],
        Command::Replace,
        Hint::Always("replace it"),
        "replace the file",
    ),
    bind(
        &[special(KeyCode::Esc), key('n')],
        Command::Cancel,
        Hint::Always("keep it"),
        "keep the file; nothing is saved",
    ),
];
