//! Input and output that the designer requests, and the results.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use super::document::Base;
use crate::files::Opened;
use crate::model::{Checked, Fault, Objective};
use crate::tui::panels::measured::OpenedMeasured;
use crate::tui::user::recovery::Kept;
use crate::worker::Request;

/// An action outside the state: the state does no input or output itself.
#[derive(Debug)]
pub enum Effect {
    /// Send a request to the worker.
    Solve(Request),
    /// Save a text.
    Save {
        /// The file.
        path: PathBuf,
        /// The content.
        text: String,
        /// The condition for replacing a file.
        guard: Guard,
    },
    /// Export the screen.
    Export {
        /// The file.
        path: PathBuf,
        /// The kind of export.
        kind: Export,
        /// The condition for replacing a file.
        guard: Guard,
    },
    /// Open a model to compare with.
    OpenReference(PathBuf),
    /// Open a file of measured curves, with the description of its columns if given.
    OpenMeasured(PathBuf, Option<String>),
    /// Read the measured curve of an objective.
    CheckMatch {
        /// The model.
        model: Arc<Checked>,
        /// The objective.
        objective: Box<Objective>,
        /// The folder of the model's file.
        folder: PathBuf,
    },
    /// Write unsaved changes to the recovery file, so that a killed program does not lose them.
    Keep(Kept),
    /// There are no unsaved changes: remove the recovery file.
    Forget,
    /// Load the recovered changes with this index.
    Recover(usize),
    /// Delete the recovered changes with this index.
    Discard(usize),
    /// Check whether a file still holds this text.
    Compare {
        /// The file.
        path: PathBuf,
        /// The text when it was opened or saved.
        text: String,
    },
    /// Reload the open file.
    Reload(PathBuf),
    /// Send a text to the terminal's clipboard.
    Copy(String),
    /// Capture or release the mouse.
    Mouse(bool),
    /// Release the terminal and stop, until the shell continues the program.
    Suspend,
    /// Set up the terminal again after other programs used it.
    Resume,
    /// Open a file.
    Open(PathBuf),
    /// Complete a typed path.
    Complete(String),
    /// Redraw the whole screen.
    Redraw,
    /// End the program, with the number of a signal if one caused it.
    Quit(Option<u8>),
}

/// The condition under which a file is replaced without confirmation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Guard {
    /// The file must not exist.
    Absent,
    /// The file must hold this text, or not exist.
    Holds(String),
    /// No condition: the user confirmed.
    Anything,
    /// No condition, and attributes may be lost: the user confirmed that, too.
    Losing,
}

/// The result of an effect.
#[derive(Debug)]
pub enum Reply {
    /// The text was saved in this file.
    Saved(PathBuf, String),
    /// The file exists already; with the content to be written.
    Exists(PathBuf, Saving),
    /// Replacing the file would lose these attributes; with the content to be written.
    Loses(PathBuf, Saving, String),
    /// The file was changed since it was opened.
    ChangedOutside(PathBuf),
    /// The screen was exported to this file.
    Exported(PathBuf),
    /// A model to compare with was opened.
    Reference(Box<Opened>),
    /// The result of opening a file of measured curves.
    Measured(OpenedMeasured),
    /// Whether the measured curve of the typed objective can be matched; if not, why.
    MatchChecked(Result<(), Fault>),
    /// The file was not saved, and why.
    NotSaved(PathBuf, String),
    /// A model was opened.
    Opened(Box<Opened>),
    /// The file is not a valid model.
    Faulty(PathBuf, Vec<Fault>),
    /// The file was not read, and why.
    NotRead(PathBuf, String),
    /// The path, completed as far as unambiguous.
    Completed(String),
    /// How another program changed the file.
    Compared(ExternalChange),
    /// The open file was reloaded.
    Reloaded(Box<Opened>),
    /// Recovered changes were loaded.
    Recovered {
        /// The model, with its base text.
        opened: Box<Opened>,
        /// Where the base text is.
        base: Base,
        /// How many other recovered changes remain.
        others: usize,
    },
}

/// Unsaved changes of a program that was killed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lost {
    /// The file or preset they belong to.
    pub name: String,
    /// The age of the last change.
    pub age: Duration,
}

/// The kind of exported file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Export {
    /// The curves as numbers.
    Csv,
    /// The chart as a drawing.
    Svg,
    /// The screen as text.
    Text,
}

/// The content to be written to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Saving {
    /// The model.
    Model,
    /// The screen.
    Screen(Export),
}

impl Export {
    /// The kind for a file extension.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "csv" => Some(Self::Csv),
            "svg" => Some(Self::Svg),
            "txt" => Some(Self::Text),
            _ => None,
        }
    }
}

/// How another program changed the model's file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ExternalChange {
    /// It holds the text that was opened or saved here.
    #[default]
    Same,
    /// It holds another text.
    Changed,
    /// It was removed.
    Gone,
}
