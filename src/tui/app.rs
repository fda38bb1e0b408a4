//! The designer's state, and what every key and every answer does to it.
//!
//! [`App::update`] is pure: what is to be done outside comes back as [`Effect`]s, and what came of those goes in by
//! [`App::reply`].

mod chart;
mod curves;
mod document;
mod edit;
mod effect;
mod files;
mod fresh;
mod history;
mod modal;
mod overlay;
mod prompt;
mod request;
mod selection;
mod shape;
mod structure;
mod tables;
mod witness;

use std::sync::Arc;

use crossterm::event::KeyEvent;

pub use curves::{Curves, Member, Picture, Shown, Trace};
pub use document::Document;
pub use effect::{Effect, Guard, Reply};
pub use modal::{Completeness, Modal, ModeKind, ModeList, ModeRow, Shares};
pub use overlay::{Asked, AskedKind, List, Next, Overlay, Prompt, Purpose, ReplaceReason};
pub use selection::Selection;
pub use shape::{Shape, Shaping};
pub use tables::{Anchor, Table, Tables};
pub use witness::{Witness, WitnessCurves, WitnessPicture};

use crate::model::Model;
use crate::tui::Opened;
use crate::tui::event::Event;
use crate::tui::keys::{self, Command, Scope};

/// What the last line says in place of the hints, until the next key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Message {
    /// Something was done.
    Done(String),
    /// Something was not done, and why.
    Refused(String),
}

/// The designer.
#[derive(Debug)]
pub struct App {
    /// The model and its file.
    pub document: Document,
    /// The tree.
    pub selection: Selection,
    /// The chart.
    pub curves: Curves,
    /// The modes and the shape of one.
    pub modal: Modal,
    /// The tables of modes and peaks.
    pub tables: Tables,
    /// What the chart's cursor stays with.
    pub anchor: Anchor,
    /// The finite-element curves.
    pub witness: Witness,
    /// The box that takes the keys, if there is one.
    pub overlay: Option<Overlay>,
    /// The last line's message.
    pub message: Option<Message>,
    /// What comes after a save that was asked for by a question.
    after_save: Option<Next>,
    /// What was sent to be solved last.
    requested: Option<(Arc<Model>, Option<usize>)>,
    /// The generation whose finite-element curves were asked for last.
    witnessed: Option<u64>,
    /// The screen is too small to show anything.
    pub unseen: bool,
}

impl App {
    /// The designer with an opened model.
    pub fn new(opened: Opened) -> Self {
        let document = Document::new(opened);
        let model = document.model();
        Self {
            selection: Selection::new(model),
            curves: Curves::new(model, 0),
            document,
            modal: Modal::default(),
            tables: Tables::default(),
            anchor: Anchor::default(),
            witness: Witness::default(),
            overlay: None,
            message: None,
            after_save: None,
            requested: None,
            witnessed: None,
            unseen: false,
        }
    }

    /// What is to be done when the designer starts.
    pub fn start(&mut self) -> Vec<Effect> {
        self.request()
    }

    /// The model as it stands.
    pub fn model(&self) -> &Arc<Model> {
        self.document.model()
    }

    /// Which keys have their meaning now.
    pub fn scope(&self) -> Scope {
        match (&self.overlay, self.tables.open) {
            (Some(overlay), _) => overlay.scope(),
            (None, Some(_)) => Scope::Table,
            (None, None) => Scope::Main,
        }
    }

    /// Takes an event; what is to be done then.
    pub fn update(&mut self, event: Event) -> Vec<Effect> {
        let mut effects = match event {
            // Nobody can see what a key would do.
            Event::Key(_) | Event::Paste(_) if self.unseen => Vec::new(),
            Event::Key(key) => self.key(&key),
            Event::Paste(text) => self.paste(&text),
            Event::Resize => Vec::new(),
            Event::Answer(answer) => {
                self.take(answer);
                Vec::new()
            }
            Event::Tick => {
                self.modal.shaping = self.modal.shaping.next();
                Vec::new()
            }
            Event::Quit(signal) => return self.end(signal),
        };
        // Another curve may be the first one now.
        self.tables.peaks.set_rows(self.peaks().len());
        effects.extend(self.request());
        effects
    }

    /// Ends by a signal: there is nobody to ask, so what is not saved goes into a file of its own.
    fn end(&self, signal: i32) -> Vec<Effect> {
        let rescue = self.document.is_changed().then(|| Effect::Rescue {
            path: self.document.source().rescue_path(),
            text: self.document.text(),
        });
        let quit = Effect::Quit(Some(signal.unsigned_abs() as u8));
        rescue.into_iter().chain([quit]).collect()
    }

    fn key(&mut self, key: &KeyEvent) -> Vec<Effect> {
        let command = keys::command(self.scope(), key);
        self.message = None;
        match command {
            Some(command) => self.command(command),
            None => self.type_key(key),
        }
    }

    /// Does what a key asks for; what is to be done outside then.
    pub fn command(&mut self, command: Command) -> Vec<Effect> {
        match command {
            Command::Redraw => return vec![Effect::Redraw],
            Command::Quit => return self.leave(Next::Quit),
            _ => {}
        }
        match self.scope() {
            Scope::Table if self.table_command(command) => Vec::new(),
            Scope::Main | Scope::Any | Scope::Table => self.main_command(command),
            Scope::Prompt => self.prompt_command(command),
            Scope::Picker | Scope::Reader => self.list_command(command),
            Scope::Unsaved | Scope::Replace => self.answer_question(command),
        }
    }

    fn main_command(&mut self, command: Command) -> Vec<Effect> {
        match command {
            Command::Save => return self.save(),
            Command::SaveAs => self.ask_save_path(),
            Command::Open => return self.leave(Next::AskPath),
            Command::Presets => self.overlay = Some(Overlay::presets(self.preset_row())),
            Command::Help => self.overlay = Some(Overlay::Help(List::default())),
            _ if self.move_selection(command)
                || self.change_chart(command)
                || self.change_modes(command) => {}
            _ => self.change_model(command),
        }
        Vec::new()
    }

    /// Moves in the tree; false where the command is another one.
    fn move_selection(&mut self, command: Command) -> bool {
        let model = Arc::clone(self.document.model());
        let selection = &mut self.selection;
        match command {
            Command::Up => selection.step(-1),
            Command::Down => selection.step(1),
            Command::PageUp => selection.page(false),
            Command::PageDown => selection.page(true),
            Command::First => selection.first(),
            Command::Last => selection.last(),
            Command::Collapse => selection.collapse(&model),
            Command::Expand => selection.expand(&model),
            Command::ExpandAll => selection.expand_all(&model),
            Command::CollapseAll => selection.collapse_all(&model),
            Command::NextParameter => selection.next_parameter(&model, true),
            Command::PreviousParameter => selection.next_parameter(&model, false),
            Command::NextAlike => self.go_alike(true),
            Command::PreviousAlike => self.go_alike(false),
            _ => return false,
        }
        true
    }

    /// Changes the model, or takes a change back.
    fn change_model(&mut self, command: Command) {
        match command {
            Command::Undo => self.travel(true),
            Command::Redo => self.travel(false),
            Command::Edit => self.edit(),
            Command::Cycle => self.cycle_or_toggle(),
            Command::Nudge(thousandths) => self.nudge(thousandths),
            Command::Revert => self.revert(),
            Command::Add => self.add(),
            Command::Duplicate => self.duplicate(),
            Command::Rename => self.ask_name(),
            Command::Delete => self.delete(),
            Command::Enable => self.switch(),
            _ => {}
        }
    }

    /// Goes to the same row of the neighbouring subsystem, force, response or support.
    fn go_alike(&mut self, forward: bool) {
        let model = Arc::clone(self.document.model());
        match crate::tui::tree::alike(&model, self.selection.node(), forward) {
            Some(node) => self.selection.select(&model, node),
            None if forward => self.refuse("there is no further one like this"),
            None => self.refuse("there is none like this before"),
        }
    }

    /// Undoes or redoes a step.
    fn travel(&mut self, back: bool) {
        let before = Arc::clone(self.document.model());
        let step = if back {
            self.document.undo()
        } else {
            self.document.redo()
        };
        match (step, back) {
            (Some(name), true) => self.done(format!("undo: {name}")),
            (Some(name), false) => self.done(format!("redo: {name}")),
            (None, true) => self.refuse("nothing to undo"),
            (None, false) => self.refuse("nothing to redo"),
        }
        self.follow(&before);
    }

    /// Lets the tree and the chart follow a model that has changed.
    fn follow(&mut self, before: &Model) {
        let model = Arc::clone(self.document.model());
        self.selection.follow(before, &model);
        self.curves.follow(before, &model);
    }

    fn done(&mut self, text: impl Into<String>) {
        self.message = Some(Message::Done(text.into()));
    }

    fn refuse(&mut self, text: impl Into<String>) {
        self.message = Some(Message::Refused(text.into()));
    }
}

#[cfg(test)]
mod tests;
