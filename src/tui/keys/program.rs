//! The rows of the key table for files and the program.

use crossterm::event::KeyCode;

use super::{Binding, Command, Hint, bind, control, key, special};

/// Files and the program.
pub(super) const FILES: &[Binding] = &[
    bind(
        "save",
        &[key('s'), control('s')],
        Command::Save,
        Hint::Always("save"),
        "save",
    ),
    bind(
        "save-as",
        &[key('S')],
        Command::SaveAs,
        Hint::Never,
        "save to another file",
    ),
    bind(
        "reload",
        &[key('R')],
        Command::Reload,
        Hint::Never,
        "read the file again; asks when something is not saved",
    ),
    bind(
        "open",
        &[key('o')],
        Command::Open,
        Hint::Never,
        "open a file",
    ),
    bind(
        "presets",
        &[key('p')],
        Command::Presets,
        Hint::Always("presets"),
        "choose a preset",
    ),
    bind(
        "palette",
        &[key(':')],
        Command::Palette,
        Hint::Always("commands"),
        "search every command and every parameter",
    ),
    bind(
        "copy-value",
        &[key('y')],
        Command::CopyValue,
        Hint::Never,
        "send the value to the terminal's clipboard (OSC 52)",
    ),
    bind(
        "copy-model",
        &[key('Y')],
        Command::CopyModel,
        Hint::Never,
        "send the model's text to the terminal's clipboard",
    ),
    bind(
        "theme",
        &[key('T')],
        Command::Theme,
        Hint::Never,
        "next theme: the terminal's colours, for a dark ground, for a light one, none",
    ),
    bind(
        "mouse",
        &[key('X')],
        Command::Mouse,
        Hint::Never,
        "take the mouse, or leave it to the terminal (to select text)",
    ),
    bind(
        "help",
        &[key('?'), special(KeyCode::F(1))],
        Command::Help,
        Hint::Always("help"),
        "this help",
    ),
    bind(
        "guide",
        &[],
        Command::Guide,
        Hint::Never,
        "read a chapter of the guide",
    ),
    bind(
        "quit",
        &[key('q')],
        Command::Quit,
        Hint::Always("quit"),
        "quit; asks when something is not saved",
    ),
];

/// Everywhere.
pub(super) const ANYWHERE: &[Binding] = &[
    bind(
        "redraw",
        &[control('l')],
        Command::Redraw,
        Hint::Never,
        "draw the screen anew",
    ),
    bind(
        "suspend",
        &[control('z')],
        Command::Suspend,
        Hint::Never,
        "stop; `fg` in the shell goes on",
    ),
    bind(
        "end",
        &[control('c')],
        Command::Quit,
        Hint::Never,
        "quit; asks when something is not saved",
    ),
];
