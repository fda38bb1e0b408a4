//! Exchange with other programs: the clipboard, and changes of the file by others.

use std::path::Path;
use std::sync::Arc;

use super::{App, Effect, ExternalChange, Next};
use crate::files::Opened;
use crate::model::grouped;
use crate::tui::keys::{FileCommand, ModelCommand};

/// The longest text that is sent to a clipboard, bytes; terminals silently discard longer ones.
const MOST_COPIED: usize = 74_000;

impl App {
    /// Sends the selected value to the clipboard.
    pub(crate) fn copy_value(&mut self) -> Vec<Effect> {
        if let Some(value) = self.exact_value() {
            return self.copy(value.clone(), &value);
        }
        self.refuse("this row has no value to copy");
        Vec::new()
    }

    /// Sends the model's text to the clipboard.
    pub(crate) fn copy_model(&mut self) -> Vec<Effect> {
        let text = self.document.text();
        let size = text.len();
        if size > MOST_COPIED {
            let save = self.keys.key_of(FileCommand::SaveAs);
            self.refuse(format!(
                "the text has {} bytes, of which terminals take {} at most: {save} saves it to a file",
                grouped(size),
                grouped(MOST_COPIED)
            ));
            return Vec::new();
        }
        self.copy(text, "the model's text")
    }

    fn copy(&mut self, text: String, what: &str) -> Vec<Effect> {
        // Terminals do not acknowledge it.
        self.done(format!("sent to the terminal's clipboard: {what}"));
        vec![Effect::Copy(text)]
    }

    /// Checks whether the file is unchanged.
    pub(crate) fn compare(&mut self) -> Vec<Effect> {
        let compare = |path: &Path| Effect::Compare {
            path: path.to_owned(),
            text: self.document.saved_text().to_owned(),
        };
        let path = self.document.source().path();
        path.map(compare).into_iter().collect()
    }

    pub(crate) fn note_external_change(&mut self, outside: ExternalChange) {
        if outside == self.files.external_change {
            return;
        }
        self.files.external_change = outside;
        let name = self.document.source().name();
        match outside {
            ExternalChange::Same => self.done(format!("{name} has its former content again")),
            ExternalChange::Changed => {
                let key = self.keys.key_of(FileCommand::Reload);
                self.refuse(format!(
                    "{name} was changed on disk by another program: {key} reloads it"
                ));
            }
            ExternalChange::Gone => {
                self.refuse(format!(
                    "{name} no longer exists on disk; saving writes it again"
                ));
            }
        }
    }

    /// Reloads the file; with unsaved changes, asks first.
    pub(crate) fn reload(&mut self) -> Vec<Effect> {
        if self.document.source().path().is_some() {
            return self.leave(Next::Reload);
        }
        let name = self.document.source().name();
        self.refuse(format!("{name} is not a file that can be reloaded"));
        Vec::new()
    }

    pub(crate) fn reload_now(&self) -> Vec<Effect> {
        let path = self.document.source().path().map(Path::to_owned);
        path.map(Effect::Reload).into_iter().collect()
    }

    pub(crate) fn reloaded(&mut self, opened: Opened) {
        self.files.external_change = ExternalChange::Same;
        if opened.text == self.document.saved_text() {
            return self.done("the file is unchanged");
        }
        let before = Arc::clone(self.document.model());
        self.document.reload(opened.model, opened.text);
        self.follow(&before);
        let undo = self.keys.key_of(ModelCommand::Undo);
        self.done(format!("file reloaded; {undo} undoes it"));
    }
}
