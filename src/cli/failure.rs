//! The failure of a command.

use crate::escape::escape;
use crate::model::{Fault, MOST_SHOWN};
use crate::solve::Cancelled;

/// The failure of a command.
#[derive(Debug)]
pub(super) enum Failure {
    /// Bad input or usage, with messages; text from outside is on one line.
    Input(Vec<String>),
    /// Anything else.
    Other(String),
}

impl Failure {
    pub(super) fn input(message: impl Into<String>) -> Self {
        Self::Input(vec![escape(&message.into()).into_owned()])
    }

    /// The faults of `source`, one per line, and the number of further ones.
    pub(super) fn faults(source: &str, faults: &[Fault]) -> Self {
        let place = |fault: &Fault| if fault.line.is_some() { ":" } else { ": " };
        let line = |fault| format!("{source}{}{fault}", place(fault));
        let more = faults.len().saturating_sub(MOST_SHOWN);
        let more = (more > 0).then(|| format!("{source}: and {more} more"));
        let lines = faults.iter().take(MOST_SHOWN).map(line).chain(more);
        Self::Input(lines.map(|line| escape(&line).into_owned()).collect())
    }
}

impl From<Cancelled> for Failure {
    fn from(cancelled: Cancelled) -> Self {
        Self::Other(cancelled.to_string())
    }
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::Other(error.to_string())
    }
}
