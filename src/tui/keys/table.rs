//! The sections of the key table, and keys that several of them share.

use crossterm::event::KeyCode;

use super::boxes::{PALETTE, PICKER, PROMPT, READER, RECOVERY, REPLACE, SEARCH, UNSAVED};
use super::compare::{BESIDE, COMPARE, LOOK};
use super::curves::CURVES;
use super::model::{CHANGE, MOVE};
use super::modes::{MODES, TABLE};
use super::program::{ANYWHERE, FILES};
use super::reading::READING;
use super::tuning::TUNING;
use super::{Key, Scope, Section, control, key, special};

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
        title: "Read the curves",
        scope: Scope::Main,
        bindings: READING,
    },
    Section {
        title: "Compare",
        scope: Scope::Main,
        bindings: COMPARE,
    },
    Section {
        title: "Look at the beam",
        scope: Scope::Main,
        bindings: LOOK,
    },
    Section {
        title: "Modes, peaks and finite elements",
        scope: Scope::Main,
        bindings: MODES,
    },
    Section {
        title: "Tune",
        scope: Scope::Main,
        bindings: TUNING,
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
        title: "In a table below the chart (all other keys as without it)",
        scope: Scope::Table,
        bindings: TABLE,
    },
    Section {
        title: "While typing",
        scope: Scope::Prompt,
        bindings: PROMPT,
    },
    Section {
        title: "In the palette",
        scope: Scope::Palette,
        bindings: PALETTE,
    },
    Section {
        title: "While searching the tree",
        scope: Scope::Search,
        bindings: SEARCH,
    },
    Section {
        title: "List of presets",
        scope: Scope::Picker,
        bindings: PICKER,
    },
    Section {
        title: "References and measured curves",
        scope: Scope::Beside,
        bindings: BESIDE,
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
    Section {
        title: "Unsaved changes that were found",
        scope: Scope::Recovery,
        bindings: RECOVERY,
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
