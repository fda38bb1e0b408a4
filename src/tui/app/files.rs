//! Open, save and quit.

use std::path::PathBuf;

use super::{
    App, Band, Curves, Detail, Document, Effect, ExternalChange, Guard, List, ModesState, Next,
    Overlay, Prompt, Purpose, Reading, ReplaceReason, Reply, Saving, Selection, Tables,
};
use crate::escape::{path_text, shown_path};
use crate::files::{Opened, Source};
use crate::model;
use crate::presets;
use crate::tui::keys::{ReplaceCommand, UnsavedCommand};

impl App {
    /// Continues with an action that discards the model; with unsaved changes, asks first.
    pub(crate) fn leave(&mut self, next: Next) -> Vec<Effect> {
        if !self.document.is_changed() {
            return self.go_on(next);
        }
        let beneath = match self.overlay.take() {
            // The same question is already open.
            Some(Overlay::Unsaved { beneath, .. }) => beneath,
            other => other.map(Box::new),
        };
        self.overlay = Some(Overlay::Unsaved { next, beneath });
        Vec::new()
    }

    fn go_on(&mut self, next: Next) -> Vec<Effect> {
        self.overlay = None;
        match next {
            Next::Quit => return vec![Effect::Quit(None)],
            Next::AskPath => {
                self.overlay = Some(Overlay::Prompt(Prompt::new(Purpose::Open, String::new())));
            }
            Next::Preset(row) => self.open_preset(row),
            Next::Recover(number) => return vec![Effect::Recover(number)],
            Next::Reload => return self.reload_now(),
        }
        Vec::new()
    }

    fn open_preset(&mut self, row: usize) {
        let Some(preset) = presets::ALL.get(row) else {
            return;
        };
        match Opened::preset(preset) {
            Ok(opened) => self.open(opened),
            Err(faults) => self.list_faults(PathBuf::from(preset.name), faults),
        }
    }

    /// Replaces the model by an opened one.
    fn open(&mut self, opened: Opened) {
        self.open_document(Document::new(opened));
        let name = self.document.source().name();
        self.done(format!("opened {name}"));
    }

    /// Replaces the document. Frozen references stay, for comparison.
    pub(crate) fn open_document(&mut self, document: Document) {
        self.store_view();
        self.document = document;
        let model = self.document.model();
        self.selection = Selection::new(model);
        let decibels = self.curves.decibels;
        self.curves = Curves::new(model, self.curves.generation + 1);
        self.curves.decibels = decibels;
        self.modes = ModesState::default();
        self.reading = Reading::default();
        self.detail = Detail::default();
        self.band = Band::default();
        self.beam_view.forget();
        self.sensitivities.forget();
        self.end_run();
        self.comparison.forget_sample();
        self.display.levels = None;
        self.display.decibel_references.clear();
        let open = self.tables.open;
        self.tables = Tables::default();
        self.tables.open = open;
        self.fem_overlay.forget();
        self.overlay = None;
        self.search = None;
        self.mouse.held = None;
        self.requests.expected = None;
        self.files.external_change = ExternalChange::default();
        self.recall_view();
    }

    fn list_faults(&mut self, path: PathBuf, faults: Vec<model::Fault>) {
        let list = List::new(faults.len(), 0);
        self.overlay = Some(Overlay::Faults { path, faults, list });
    }

    /// Saves to the model's file, or asks for a path.
    pub(crate) fn save(&mut self) -> Vec<Effect> {
        let Source::File(path) = self.document.source() else {
            self.ask_save_path();
            return Vec::new();
        };
        let path = path.clone();
        if !self.document.is_changed() && self.files.external_change == ExternalChange::Same {
            self.done(format!("{} is saved already", shown_path(&path)));
            return Vec::new();
        }
        let guard = self.guard(&path);
        vec![self.save_to(path, guard)]
    }

    pub(crate) fn ask_save_path(&mut self) {
        let path = match self.document.source() {
            Source::File(path) => path_text(path),
            Source::Preset(name) => format!("{name}.toml"),
            Source::Stdin => "model.toml".to_owned(),
        };
        self.overlay = Some(Overlay::Prompt(Prompt::new(Purpose::SaveAs, path)));
    }

    pub(crate) fn save_to(&self, path: PathBuf, guard: Guard) -> Effect {
        Effect::Save {
            path,
            text: self.document.text(),
            guard,
        }
    }

    /// Handles the answer about unsaved changes.
    pub(crate) fn answer_unsaved(&mut self, answer: UnsavedCommand) -> Vec<Effect> {
        let asked = |overlay: &mut Overlay| matches!(overlay, Overlay::Unsaved { .. });
        let Some(Overlay::Unsaved { next, beneath }) = self.overlay.take_if(asked) else {
            return Vec::new();
        };
        match answer {
            UnsavedCommand::Save => {
                self.files.after_save = Some(next);
                self.save()
            }
            UnsavedCommand::Discard => self.go_on(next),
            UnsavedCommand::Cancel => {
                if beneath.is_none() {
                    self.files.after_save = None;
                }
                self.overlay = beneath.map(|beneath| *beneath);
                Vec::new()
            }
        }
    }

    /// Handles the answer about replacing a file.
    pub(crate) fn answer_replace(&mut self, answer: ReplaceCommand) -> Vec<Effect> {
        let asked = |overlay: &mut Overlay| matches!(overlay, Overlay::Replace { .. });
        let Some(Overlay::Replace { path, what, reason }) = self.overlay.take_if(asked) else {
            return Vec::new();
        };
        match answer {
            ReplaceCommand::Replace => {
                let guard = match reason {
                    ReplaceReason::Exists | ReplaceReason::ChangedOutside => Guard::Anything,
                    ReplaceReason::Loses(_) => Guard::Losing,
                };
                vec![match what {
                    Saving::Model => self.save_to(path, guard),
                    Saving::Screen(kind) => Effect::Export { path, kind, guard },
                }]
            }
            ReplaceCommand::Cancel => {
                self.files.after_save = None;
                self.refuse(match what {
                    Saving::Model => "not saved",
                    Saving::Screen(_) => "not written",
                });
                Vec::new()
            }
        }
    }

    /// Handles the result of an effect; returns further effects.
    pub fn reply(&mut self, reply: Reply) -> Vec<Effect> {
        let mut effects = match reply {
            Reply::Saved(path, text) => self.saved(path, text),
            Reply::Exists(path, what) => self.ask_replace(path, ReplaceReason::Exists, what),
            Reply::Loses(path, what, lost) => {
                self.ask_replace(path, ReplaceReason::Loses(lost), what)
            }
            Reply::ChangedOutside(path) => {
                self.ask_replace(path, ReplaceReason::ChangedOutside, Saving::Model)
            }
            Reply::Exported(path) => {
                self.overlay = None;
                self.done(format!("written to {}", shown_path(&path)));
                Vec::new()
            }
            Reply::Reference(opened) => {
                self.take_reference(*opened);
                Vec::new()
            }
            Reply::Measured(opened) => self.measured_opened(opened),
            Reply::MatchChecked(checked) => {
                self.match_checked(checked);
                Vec::new()
            }
            Reply::NotSaved(path, reason) => {
                self.files.after_save = None;
                self.refuse_prompt(format!("{} is not saved: {reason}", shown_path(&path)));
                Vec::new()
            }
            Reply::Opened(opened) => {
                self.open(*opened);
                Vec::new()
            }
            Reply::Faulty(path, faults) => {
                self.list_faults(path, faults);
                Vec::new()
            }
            Reply::NotRead(path, reason) => {
                self.refuse_prompt(format!("{} cannot be read: {reason}", shown_path(&path)));
                Vec::new()
            }
            Reply::Completed(text) => {
                self.complete(text);
                Vec::new()
            }
            Reply::Compared(outside) => {
                self.note_external_change(outside);
                Vec::new()
            }
            Reply::Reloaded(opened) => {
                self.reloaded(*opened);
                Vec::new()
            }
            Reply::Recovered {
                opened,
                base,
                others,
            } => {
                self.recovered(*opened, base, others);
                Vec::new()
            }
        };
        effects.extend(self.settle());
        effects
    }

    fn saved(&mut self, path: PathBuf, text: String) -> Vec<Effect> {
        self.overlay = None;
        self.done(format!("saved {}", shown_path(&path)));
        self.document.mark_saved(path, text);
        self.files.external_change = ExternalChange::Same;
        match self.files.after_save.take() {
            Some(next) => self.go_on(next),
            None => Vec::new(),
        }
    }

    fn ask_replace(&mut self, path: PathBuf, reason: ReplaceReason, what: Saving) -> Vec<Effect> {
        self.overlay = Some(Overlay::Replace { path, reason, what });
        Vec::new()
    }
}
