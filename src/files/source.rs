//! Where a model came from.

use std::path::PathBuf;

use crate::escape::path_text;
use crate::model::Model;

/// Where a model came from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Source {
    /// A file, to which it is saved.
    File(PathBuf),
    /// An embedded preset.
    Preset(&'static str),
    /// Standard input.
    Stdin,
}

impl Source {
    /// The name on the status line: a file's name without its folder, or a preset's.
    pub fn name(&self) -> String {
        match self {
            Self::File(path) => path_text(
                path.file_name()
                    .map_or(path.as_path(), std::path::Path::new),
            ),
            Self::Preset(name) => (*name).to_owned(),
            Self::Stdin => "standard input".to_owned(),
        }
    }

    /// The same, found from any folder.
    #[must_use]
    pub fn absolute(&self) -> Self {
        match self {
            Self::File(path) => {
                Self::File(std::path::absolute(path).unwrap_or_else(|_| path.clone()))
            }
            other => other.clone(),
        }
    }
}

/// A model that was opened.
#[derive(Debug, Clone)]
pub struct Opened {
    /// The model; it may differ from the text by values set on the command line.
    pub model: Model,
    /// The text it was read from.
    pub text: String,
    /// Where that came from.
    pub source: Source,
}
