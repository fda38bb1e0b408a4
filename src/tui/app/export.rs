//! Export of the screen to a file.

use std::path::{Path, PathBuf};

use super::{App, Effect, Guard};
use crate::escape::{path_of_text, path_text};

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
    fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "csv" => Some(Self::Csv),
            "svg" => Some(Self::Svg),
            "txt" => Some(Self::Text),
            _ => None,
        }
    }
}

impl App {
    /// The proposed name of an exported file.
    pub(crate) fn export_name(&self) -> String {
        let name = self.document.source().name();
        path_text(&path_of_text(&name).with_extension("svg"))
    }

    /// Exports the screen to a new file of the kind given by its extension.
    pub(crate) fn export_to(&mut self, path: PathBuf) -> Vec<Effect> {
        let Some(kind) = Export::of(&path) else {
            self.refuse_prompt("the name must end in .csv, .svg or .txt");
            return Vec::new();
        };
        if kind != Export::Text && self.curves.picture().is_none() {
            self.refuse_prompt("there are no curves yet");
            return Vec::new();
        }
        vec![Effect::Export {
            path,
            kind,
            guard: Guard::Absent,
        }]
    }
}
