//! What the designer wants done outside, and what came of it.

use std::path::PathBuf;

use crate::model::Fault;
use crate::tui::Opened;
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
    /// Save a text that would be lost, whatever is in the file.
    Rescue {
        /// The file.
        path: PathBuf,
        /// What it shall hold.
        text: String,
    },
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
}

/// What came of an effect.
#[derive(Debug)]
pub enum Reply {
    /// The text was saved in this file.
    Saved(PathBuf, String),
    /// There is another file of this name.
    Exists(PathBuf),
    /// The file is not as it was when it was opened.
    ChangedOutside(PathBuf),
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
}
