//! Prompts for one line: what they ask for.

mod commands;
mod questions;
pub(crate) mod view;

use std::path::PathBuf;
use std::sync::Arc;

use tui_input::Input;

use crate::measured::Curve;
use crate::model::edit::Value;
use crate::model::path::Pattern;
use crate::model::{ParameterId, Unit, value_input};
use crate::tui::panels::measured::choose;
use crate::unit::FrequencyUnit;

/// A prompt for one line.
#[derive(Debug)]
pub struct Prompt {
    /// Its purpose.
    pub purpose: Purpose,
    /// The typed text.
    pub input: Input,
    /// Whether the text is the initial one: typing replaces it, other keys start editing it.
    pub replaceable: bool,
    /// Why the text was refused.
    pub refusal: Option<String>,
}

impl Prompt {
    /// A prompt with an initial text.
    pub fn new(purpose: Purpose, text: String) -> Self {
        Self {
            purpose,
            replaceable: !text.is_empty(),
            input: Input::new(text),
            refusal: None,
        }
    }
}

/// What a prompt is for.
#[derive(Debug, Clone)]
pub enum Purpose {
    /// A parameter's value.
    Value(Asked),
    /// The path of a file to open.
    Open,
    /// The path of the file to save to.
    SaveAs,
    /// Another question.
    Ask(Question),
}

/// A parameter with a prompt for its value.
#[derive(Debug, Clone)]
pub struct Asked {
    /// The parameter as text.
    pub subject: String,
    /// The parameter.
    pub id: ParameterId,
    /// The allowed values.
    pub range: String,
    /// How the input is parsed.
    pub kind: AskedKind,
}

/// How a typed value is parsed.
#[derive(Debug, Clone)]
pub enum AskedKind {
    /// A number with this unit, or a change relative to the old value.
    Number(f64, Unit),
    /// A whole number, or a change relative to the old value.
    Count(usize),
    /// A text.
    Text,
}

impl AskedKind {
    /// A typed value.
    ///
    /// # Errors
    /// Why the text is no such value, in one line.
    pub(crate) fn read(&self, text: &str) -> Result<Value, String> {
        match self {
            Self::Number(old, unit) => value_input::number(text, *old, unit).map(Value::Number),
            Self::Text => Ok(Value::Text(text.to_owned())),
            Self::Count(old) => value_input::count(text, *old).map(Value::Count),
        }
    }
}

/// What a prompt asks for, other than values of parameters and paths of models.
#[derive(Debug, Clone, PartialEq)]
pub enum Question {
    /// The frequency of the cursor.
    Frequency(FrequencyUnit),
    /// The 0 dB reference in a unit.
    DecibelReference(String),
    /// Factors or values of a parameter.
    Factors {
        /// The parameter as text.
        subject: String,
        /// The parameter.
        id: ParameterId,
        /// The unit of its values.
        unit: Unit,
    },
    /// Another name for the reference or measured curve with this name.
    Name(String),
    /// The file of a model to compare with.
    ReferenceFile,
    /// The file of a measured curve.
    MeasuredFile,
    /// The description of the columns of a measured file.
    Columns {
        /// The file.
        path: PathBuf,
        /// What the file lacks and what it holds, as text.
        seen: String,
        /// Its columns and first rows.
        preview: Vec<String>,
    },
    /// Which curves to show from a file with more than the limit.
    Curves(Arc<Vec<Curve>>),
    /// The file for an export of the screen.
    Export,
    /// The bounds of a variable.
    Bounds {
        /// The parameter as text.
        subject: String,
        /// The paths that change together.
        paths: Vec<Pattern>,
        /// The unit of the bounds.
        unit: Unit,
        /// The variable to change; none for a new one.
        index: Option<usize>,
    },
    /// The objective of a search.
    Objective {
        /// The response and the band as text.
        subject: String,
        /// The response.
        response: String,
        /// Hz.
        band: [f64; 2],
    },
}

impl Question {
    /// The title of the dialog, and the accepted input.
    pub fn words(&self, complete: &str) -> (String, String) {
        let (title, allowed) = match self {
            Self::Frequency(unit) => (
                "Cursor to",
                format!(
                    "{}; or a number with {}",
                    unit.symbol(),
                    FrequencyUnit::SHOWN_WORDS
                ),
            ),
            Self::DecibelReference(unit) => (
                "0 dB is",
                format!(
                    "a number above 0, in {unit}; or with a unit of its kind, as 1 um/N for m/N"
                ),
            ),
            Self::Factors { subject, unit, .. } => {
                let symbol = if unit.symbol.is_empty() {
                    "a number"
                } else {
                    unit.symbol
                };
                return (
                    format!(" Study of {subject} "),
                    format!(
                        "factors, as 0.5 1 2; or = and values, as = 1e6 2e6 ({symbol}); or + and increments"
                    ),
                );
            }
            Self::Bounds { subject, unit, .. } => {
                let symbol = if unit.symbol.is_empty() {
                    String::new()
                } else {
                    format!(" {}", unit.symbol)
                };
                return (
                    format!(" Bounds of {subject} "),
                    format!(
                        "LOW .. HIGH{symbol}; then optionally +-5 % (tolerance), log or linear"
                    ),
                );
            }
            Self::Objective { subject, .. } => {
                return (
                    format!(" Tune {subject} "),
                    "peak, mean square, energy, width LEVEL, anti-resonance HZ, match FILE (columns hz; re im; m/N); + adds; limit mass KG".to_owned(),
                );
            }
            Self::Name(_) => ("Name", "any text".to_owned()),
            Self::ReferenceFile => (
                "Load a model as reference",
                format!("path; {complete} completes it"),
            ),
            Self::MeasuredFile => (
                "Load a measured curve",
                format!("CSV or universal file (UFF 58); {complete} completes the path"),
            ),
            Self::Columns { seen, .. } => ("Describe the columns", seen.clone()),
            Self::Curves(curves) => {
                let title = format!(" Which of {} curves ", curves.len());
                return (title, choose::allowed(curves));
            }
            Self::Export => (
                "Export the screen",
                format!("path ending in .csv, .svg or .txt; {complete} completes it"),
            ),
        };
        (format!(" {title} "), allowed)
    }

    /// Whether the input is a path.
    pub(crate) fn is_path(&self) -> bool {
        matches!(
            self,
            Self::ReferenceFile | Self::MeasuredFile | Self::Export
        )
    }
}
