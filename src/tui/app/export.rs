//! What is on the screen, to be written to a file.

use std::path::{Path, PathBuf};

use super::{App, Effect, Guard};
use crate::escape::{path_of_text, path_text};

/// A kind of file that is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Export {
    /// The curves as numbers.
    Csv,
    /// The chart as a drawing.
    Svg,
    /// The screen as text.
    Text,
}

/// What is written to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Saving {
    /// The model.
    Model,
    /// What is on the screen.
    Screen(Export),
}

impl Export {
    /// The kind by the ending of a file's name.
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
    /// The name that is proposed for what is on the screen.
    pub(super) fn export_name(&self) -> String {
        let name = self.document.source().name();
        path_text(&path_of_text(&name).with_extension("svg"))
    }

    /// Writes what is on the screen to a new file of the kind that its ending says.
    pub(super) fn export_to(&mut self, path: PathBuf) -> Vec<Effect> {
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
