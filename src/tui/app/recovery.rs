//! The recovery file: unsaved changes survive the program.

use std::sync::Arc;

use super::{App, Base, Document, Effect, List, Lost, Next, Overlay};
use crate::files::Opened;
use crate::model::counted;
use crate::tui::keys::{FileCommand, ModelCommand, RecoveryCommand};

impl App {
    /// Writes unsaved changes to the recovery file, if they differ from the last ones.
    pub(crate) fn keep(&mut self) -> Vec<Effect> {
        let changed = self.document.is_changed();
        let model = self.document.model();
        let same = |(kept, was): &(Arc<_>, bool)| Arc::ptr_eq(kept, model) && *was == changed;
        if self.recovery.written.as_ref().is_some_and(same) {
            return Vec::new();
        }
        let first = self.recovery.written.is_none();
        self.recovery.written = Some((Arc::clone(model), changed));
        match self.document.unsaved() {
            Some(kept) => vec![Effect::Keep(kept)],
            None if first => Vec::new(),
            None => vec![Effect::Forget],
        }
    }

    /// Offers recovered changes.
    pub fn offer(&mut self, lost: Vec<Lost>) {
        if !lost.is_empty() {
            let list = List::new(lost.len(), 0);
            self.overlay = Some(Overlay::Recovery { lost, list });
        }
    }

    pub(crate) fn recovery_command(&mut self, command: RecoveryCommand) -> Vec<Effect> {
        let Some(Overlay::Recovery { lost, list }) = &mut self.overlay else {
            return Vec::new();
        };
        let number = list.row;
        match command {
            RecoveryCommand::Accept => self.leave(Next::Recover(number)),
            RecoveryCommand::Discard => {
                let name = lost.remove(number).name;
                list.set_rows(lost.len());
                if lost.is_empty() {
                    self.overlay = None;
                }
                self.done(format!("unsaved changes to {name} discarded"));
                vec![Effect::Discard(number)]
            }
            RecoveryCommand::Cancel => {
                self.overlay = None;
                self.done(
                    "unsaved changes stay in the recovery file; the next start offers them again",
                );
                Vec::new()
            }
        }
    }

    pub(crate) fn recovered(&mut self, opened: Opened, base: Base, others: usize) {
        self.open_document(Document::recovered(opened, base));
        let (save, undo) = (
            self.keys.key_of(FileCommand::Save),
            self.keys.key_of(ModelCommand::Undo),
        );
        let mut words = vec![format!("unsaved changes recovered: {save} saves them")];
        if base != Base::Missing {
            words.push(format!("{undo} undoes them"));
        }
        if others > 0 {
            words.insert(
                0,
                counted(others, "more recovery file", "more recovery files"),
            );
        }
        if base == Base::Newer {
            words.insert(0, "the file was changed later".to_owned());
        }
        self.done(words.join(", "));
    }
}
