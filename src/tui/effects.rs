//! Performs the effects that the state requests: solving, files, recovery.

mod files;

use std::path::{Path, PathBuf};
use std::sync::mpsc::Sender;

use super::app::{App, Base, Effect, Export, Lost, Reply};
use super::event::Event;
use super::user::recovery::{self, Found, Keeper, Kept, Left};
use super::watch::Watch;
use super::{export::provenance, view};
use crate::escape::{path_text, shown_path};
use crate::files::{Opened, Source, error_text};
use crate::model;
use crate::worker::Worker;
use files::{check_match, compare, complete, export, open, open_measured, save};

/// Performs the effects that the state requests.
#[derive(Debug)]
pub struct Performer {
    worker: Worker,
    watch: Watch,
    /// None without a folder for recovery files.
    keeper: Option<Keeper>,
    /// Unsaved changes found at the start, in the order in which they are offered.
    found: Vec<Found>,
}

/// An action for the caller.
#[derive(Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Nothing.
    Done,
    /// Redraw the whole screen.
    Redraw,
    /// Restore the terminal until the shell continues the program.
    Suspend,
    /// Set up the terminal again.
    Resume,
    /// Switch mouse reporting on or off.
    Mouse(bool),
    /// Copy a text to the terminal's clipboard.
    Copy(String),
    /// End the program, by this signal if there is one.
    Quit(Option<u8>),
}

impl Performer {
    /// A performer with a worker that answers on `events`, and with a folder for recovery files.
    pub fn new(events: &Sender<Event>, recovery: Option<PathBuf>) -> Self {
        let found = recovery.as_deref().map(recovery::found);
        let answers = events.clone();
        // An answer after the designer has ended is dropped.
        let notify = move |answer| drop(answers.send(Event::Answer(answer)));
        let troubles = events.clone();
        let report = move |sentence| drop(troubles.send(Event::Trouble(sentence)));
        Self {
            worker: Worker::start(notify),
            watch: Watch::start(events.clone()),
            keeper: recovery.map(|folder| Keeper::start(folder, report)),
            found: found.unwrap_or_default(),
        }
    }

    /// The unsaved changes found at the start: those of the opened file; without a file, all, those of this source first.
    pub fn lost(&mut self, source: &Source) -> Vec<Lost> {
        let own = source.absolute();
        self.found
            .sort_by_key(|found| found.source.absolute() != own);
        let is_offered = |found: &&Found| source.path().is_none() || found.source.absolute() == own;
        let lost = self.found.iter().filter(is_offered).map(|found| Lost {
            name: match &found.source {
                Source::File(path) => path_text(path),
                other => other.name(),
            },
            age: found.age,
        });
        lost.collect()
    }

    /// Watches the file of this source for changes by other programs.
    pub fn watch(&self, source: &Source) {
        self.watch.set(source.path());
    }

    /// Performs an effect, and the effects that follow from its result.
    pub fn perform(&mut self, effect: Effect, app: &mut App) -> Outcome {
        let reply = match effect {
            Effect::Solve(request) => {
                self.worker.request(request);
                return Outcome::Done;
            }
            Effect::Keep(kept) => return self.keep(Some(kept)),
            Effect::Forget => return self.keep(None),
            Effect::Discard(number) => return self.discard(number, app),
            Effect::Redraw => return Outcome::Redraw,
            Effect::Suspend => return Outcome::Suspend,
            Effect::Resume => return Outcome::Resume,
            Effect::Mouse(taken) => return Outcome::Mouse(taken),
            Effect::Copy(text) => return Outcome::Copy(text),
            Effect::Quit(signal) => return Outcome::Quit(signal),
            Effect::Save { path, text, guard } => save(path, text, &guard),
            Effect::Export { path, kind, guard } => {
                export(path, &exported(app, kind), kind, &guard)
            }
            Effect::OpenReference(path) => open(path, Reply::Reference),
            Effect::OpenMeasured(path, layout) => open_measured(path, layout.as_deref()),
            Effect::CheckMatch {
                model,
                objective,
                folder,
            } => check_match(&model, &objective, &folder),
            Effect::Open(path) => open(path, Reply::Opened),
            Effect::Reload(path) => open(path, Reply::Reloaded),
            Effect::Compare { path, text } => Reply::Compared(compare(&path, &text)),
            Effect::Complete(text) => Reply::Completed(complete(&text)),
            Effect::Recover(number) => self.recover(number),
        };
        let mut outcome = Outcome::Done;
        for effect in app.reply(reply) {
            let next = self.perform(effect, app);
            if next != Outcome::Done {
                outcome = next;
            }
        }
        outcome
    }

    fn keep(&mut self, kept: Option<Kept>) -> Outcome {
        if let Some(keeper) = &self.keeper {
            match kept {
                Some(kept) => keeper.keep(kept),
                None => keeper.clear(),
            }
        }
        Outcome::Done
    }

    /// Recovers the changes with this number: a model, and the text of the file or preset that they belong to.
    fn recover(&mut self, number: usize) -> Reply {
        let found = self.found.remove(number);
        let model = match found.model() {
            Ok(model) => model,
            Err(faults) => return Reply::Faulty(found.path.clone(), faults),
        };
        let base = found.source.text().filter(|text| model::read(text).is_ok());
        let kind = match base {
            None => Base::Missing,
            Some(_) if is_newer(&found.source, &found.path) => Base::Newer,
            Some(_) => Base::Own,
        };
        let opened = Opened {
            text: base.unwrap_or_else(|| model::write(&model, &found.text)),
            model,
            source: found.source.clone(),
        };
        if let Some(keeper) = &self.keeper {
            keeper.adopt(found);
        }
        Reply::Recovered {
            opened: Box::new(opened),
            base: kind,
            others: self.found.len(),
        }
    }

    fn discard(&mut self, number: usize, app: &mut App) -> Outcome {
        let found = self.found.remove(number);
        let place = shown_path(&found.path);
        if let Err(error) = found.discard() {
            app.update(Event::Trouble(format!(
                "{place} cannot be removed: {}",
                error_text(&error)
            )));
        }
        Outcome::Done
    }

    /// Ends: stores unsaved changes, if any, for recovery. Returns a sentence on where they are, or why they are lost.
    pub fn finish(self, unsaved: Option<Kept>) -> Option<String> {
        let nothing = unsaved.is_none();
        let left = match (self.keeper, unsaved) {
            (Some(keeper), unsaved) => keeper.finish(unsaved),
            (None, Some(unsaved)) => recovery::leave_elsewhere(&unsaved),
            (None, None) => return None,
        };
        match left {
            Ok(Left::Nothing) => None,
            Ok(Left::Offered(path)) => Some(format!(
                "unsaved changes are in {}; the next start offers them",
                shown_path(&path)
            )),
            Ok(Left::Elsewhere(path)) => Some(format!(
                "unsaved changes are in {}, which is a model file",
                shown_path(&path)
            )),
            Err(error) if nothing => Some(format!(
                "the recovery file cannot be removed: {}",
                error_text(&error)
            )),
            Err(error) => Some(format!("unsaved changes are lost: {}", error_text(&error))),
        }
    }
}

/// The text of an export.
fn exported(app: &mut App, kind: Export) -> String {
    match kind {
        // Without the dialog that asked for the file.
        Export::Text => {
            let asked = app.overlay.take();
            let text = view::text(app);
            app.overlay = asked;
            text
        }
        Export::Csv => super::export::csv(&app.scene(), &provenance(app)),
        Export::Svg => super::export::svg(&app.scene(), &provenance(app)),
    }
}

/// Whether the file of a model is newer than its recovery file.
fn is_newer(source: &Source, kept: &Path) -> bool {
    let written = |path: &Path| std::fs::metadata(path).ok()?.modified().ok();
    let (file, kept) = (source.path().and_then(written), written(kept));
    file.zip(kept).is_some_and(|(file, kept)| file > kept)
}
