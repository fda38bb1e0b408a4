//! State of the designer that no panel shows.

use std::sync::Arc;

use super::effect::ExternalChange;
use crate::model::{Checked, ParameterId};
use crate::tui::keys::Command;
use crate::tui::panels::dialogs::Next;
use crate::tui::tree::Node;
use crate::tui::user::memory::{Memory, RememberedOptions};

/// The model's file.
#[derive(Debug, Default)]
pub struct FileState {
    /// How another program changed it.
    pub external_change: ExternalChange,
    /// What follows a save that was started from a confirmation dialog.
    pub(crate) after_save: Option<Next>,
}

/// The mouse.
#[derive(Debug, Default)]
pub struct MouseState {
    /// Whether the designer captures it.
    pub captured: bool,
    /// The row that was clicked: the wheel changes its value.
    pub(crate) held: Option<Node>,
}

/// Counts before commands, and the last change.
#[derive(Debug, Default)]
pub struct RepeatState {
    /// The count typed before a command.
    pub count: Option<u32>,
    /// The last change, for the repeat command.
    pub(crate) last_change: Option<LastChange>,
}

/// A change that can be repeated on another row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum LastChange {
    /// A command with its count.
    Command(Command, u32),
    /// A typed value.
    Typed(String),
}

/// The recovery file.
#[derive(Debug, Default)]
pub struct RecoveryState {
    /// Whether unsaved changes stay in it when the program ends.
    pub stays: bool,
    /// The model that was last written to it, and whether that model had unsaved changes.
    pub(crate) written: Option<(Arc<Checked>, bool)>,
}

/// The stored view states and options.
#[derive(Debug, Default)]
pub struct StoredViews {
    /// The view states of other models.
    pub(crate) memory: Memory,
    /// Options that the user changed in this session.
    pub(crate) changed: RememberedOptions,
}

/// What was requested of the worker for the whole model; features store their own requests.
#[derive(Debug, Default)]
pub struct RequestState {
    /// The model and the study of the last request for curves.
    pub(crate) curves: Option<(Arc<Checked>, Option<usize>)>,
    /// The parameter whose next nudges are prepared, and its value at that time.
    pub(crate) expected: Option<(ParameterId, f64)>,
    /// The generation of the last request for finite-element curves.
    pub(crate) fem: Option<u64>,
    /// The last serial number.
    serial: u64,
}

impl RequestState {
    /// A new serial number.
    pub(crate) fn next_serial(&mut self) -> u64 {
        self.serial += 1;
        self.serial
    }
}
