//! Faults of a model or its text.

use std::fmt;

use crate::escape::escape;

/// The most faults that are shown; the number of the others follows.
pub(crate) const MOST_SHOWN: usize = 50;

/// An error in a model or its text, and what is accepted instead.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Path of the parameter or table, such as `beam.section.area`; empty if the text is not TOML.
    pub path: String,
    /// The error and what is accepted, in words.
    pub message: String,
    /// Line in the text, from 1; none without a text.
    pub line: Option<usize>,
    /// Column in characters, from 1.
    pub column: Option<usize>,
}

impl Fault {
    /// A fault without a position in a text.
    pub fn new(path: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            message: message.into(),
            line: None,
            column: None,
        }
    }
}

/// `LINE:COL: PATH: MESSAGE` on one line, without the parts that are unknown; hidden characters are escaped.
impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let (Some(line), Some(column)) = (self.line, self.column) {
            write!(f, "{line}:{column}: ")?;
        }
        if !self.path.is_empty() {
            write!(f, "{}: ", escape(&self.path))?;
        }
        f.write_str(&escape(&self.message))
    }
}

impl std::error::Error for Fault {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_parts_are_left_out() {
        let mut fault = Fault::new("beam.length", "is -1; must be > 0");
        assert_eq!(fault.to_string(), "beam.length: is -1; must be > 0");
        (fault.line, fault.column) = (Some(3), Some(10));
        assert_eq!(fault.to_string(), "3:10: beam.length: is -1; must be > 0");
        fault.path.clear();
        assert_eq!(fault.to_string(), "3:10: is -1; must be > 0");
        let fault = Fault::new("a\u{1b}[2J", "is `\u{202e}`\nerror: all is well");
        assert_eq!(
            fault.to_string(),
            r"a\u{1b}[2J: is `\u{202e}`\nerror: all is well"
        );
    }
}
