//! What the designer wants done outside, and what came of it.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use super::{Base, Export, ExternalChange, OpenedMeasured, Saving};
use crate::files::Opened;
use crate::model::{Fault, Model, Objective};
use crate::tui::user::recovery::Kept;
use crate::worker::Request;

/// Something to be done outside of the state: input and output are not done by it.
#[derive(Debug)]
pub enum Effect {
    /// Ask the worker.
    Solve(Request),
    /// Save a text.
    Save {
        /// The file.
        path: PathBuf,
        /// What it shall hold.
        text: String,
        /// What must be there before.
        guard: Guard,
    },
    /// Write what is on the screen.
    Export {
        /// The file.
        path: PathBuf,
        /// What of it.
        kind: Export,
        /// What must be there before.
        guard: Guard,
    },
    /// Open a model to compare with.
    OpenReference(PathBuf),
    /// Open a file of measured curves; its columns are what this says, where it is said.
    OpenMeasured(PathBuf, Option<String>),
    /// Read the measured curve that an objective asks for.
    CheckMatch {
        /// The model.
        model: Arc<Model>,
        /// The objective.
        objective: Box<Objective>,
        /// The folder of the model's file.
        folder: PathBuf,
    },
    /// Keep changes that are not saved, so that a killed program does not lose them.
    Keep(Kept),
    /// Nothing is unsaved any more.
    Forget,
    /// Take the unsaved changes with this number of those that were found.
    Recover(usize),
    /// Remove them for good.
    Discard(usize),
    /// See whether a file still holds this text.
    Compare {
        /// The file.
        path: PathBuf,
        /// What it held when it was opened or saved.
        text: String,
    },
    /// Read a file that is open again.
    Reload(PathBuf),
    /// Send a text to the terminal's clipboard.
    Copy(String),
    /// Take the mouse, or leave it to the terminal.
    Mouse(bool),
    /// Give the terminal back and stop, until the shell goes on with the program.
    Suspend,
    /// Take the terminal again after others had it.
    Resume,
    /// Open a file.
    Open(PathBuf),
    /// Complete a path that is being typed.
    Complete(String),
    /// Draw the whole screen anew.
    Redraw,
    /// End the program, by this signal if there is one.
    Quit(Option<u8>),
}

/// What a file must be for it to be replaced without a question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Guard {
    /// It must not be there.
    Absent,
    /// It must still hold this text, or not be there.
    Holds(String),
    /// It may be anything: the question was answered.
    Anything,
    /// It may also lose what cannot be kept: that question was answered, too.
    Losing,
}

/// What came of an effect.
#[derive(Debug)]
pub enum Reply {
    /// The text was saved in this file.
    Saved(PathBuf, String),
    /// There is another file of this name; what was to be written to it.
    Exists(PathBuf, Saving),
    /// The file cannot keep this if it is replaced; what was to be written to it.
    Loses(PathBuf, Saving, String),
    /// The file is not as it was when it was opened.
    ChangedOutside(PathBuf),
    /// What is on the screen was written to this file.
    Exported(PathBuf),
    /// A model to compare with was opened.
    Reference(Box<Opened>),
    /// What came of opening a file of measured curves.
    Measured(OpenedMeasured),
    /// Whether the measured curve of the typed objective can be matched, else why not.
    MatchChecked(Result<(), Fault>),
    /// The file was not saved, and why.
    NotSaved(PathBuf, String),
    /// A model was opened.
    Opened(Box<Opened>),
    /// The file is not a model.
    Faulty(PathBuf, Vec<Fault>),
    /// The file was not read, and why.
    NotRead(PathBuf, String),
    /// The path as far as it is unambiguous.
    Completed(String),
    /// What another program did to the file.
    Compared(ExternalChange),
    /// A file that is open was read again.
    Reloaded(Box<Opened>),
    /// Unsaved changes that were found were taken.
    Recovered {
        /// The model, beside the text it belongs to.
        opened: Box<Opened>,
        /// Where that text is.
        base: Base,
        /// How many others there are.
        others: usize,
    },
}

/// Unsaved changes that were found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lost {
    /// The file or preset they belong to.
    pub name: String,
    /// How long ago the last of them was made.
    pub age: Duration,
}
