//! Export of the screen to a file.

use std::path::PathBuf;

use super::{App, Effect, Export, Guard};
use crate::escape::{path_of_text, path_text};

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
