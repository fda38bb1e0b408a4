//! The designer's state, and how events and answers change it.
//!
//! [`App::update`] is pure: input and output are requested as [`Effect`]s, and their results come back through
//! [`App::reply`].

mod commands;
mod document;
mod edit;
pub(crate) mod effect;
mod export;
mod external_changes;
mod files;
mod history;
pub(crate) mod last_request;
pub(crate) mod list;
mod mouse;
mod new_item;
mod recovery;
mod repeat;
mod request;
mod screen;
mod state;
mod structure;
mod view_state;

use std::sync::Arc;

pub use document::{Base, Document};
pub use effect::{Effect, Export, ExternalChange, Guard, Lost, Reply, Saving};
pub use list::List;
pub use screen::{Levels, Plot, Rows, Screen};
pub(crate) use state::LastChange;
pub use state::{FileState, MouseState, RecoveryState, RepeatState, RequestState, StoredViews};

pub use crate::tui::panels::band::{Band, MemberLevels, ResponseLevel};
pub use crate::tui::panels::beam_view::{BeamView, BeamViewState};
pub use crate::tui::panels::chart::{
    Curves, Detail, Display, MOTION, Member, Picture, Shown, Trace,
};
pub use crate::tui::panels::comparison::{Comparison, Reference};
pub use crate::tui::panels::dialogs::{Next, Overlay, ReplaceReason};
pub use crate::tui::panels::fem_overlay::{FemOverlay, FemPicture};
pub use crate::tui::panels::measured::{Fitted, Measured, OpenedMeasured};
pub use crate::tui::panels::modes::{Completeness, ModeKind, ModeList, ModeRow, ModesState, Shape};
pub use crate::tui::panels::palette::{Entry, Found, Palette};
pub use crate::tui::panels::prompt::{Asked, AskedKind, Prompt, Purpose, Question};
pub use crate::tui::panels::readings::{Reading, Value};
pub use crate::tui::panels::search::Search;
pub use crate::tui::panels::sensitivity::{Effects, Sensed, Sensitivities, Weighed};
pub use crate::tui::panels::tables::{Anchor, Table, Tables};
pub use crate::tui::panels::tree::Selection;
pub use crate::tui::panels::tuning::{Progress, Run, Tuning};
pub use crate::worker::Stage;

use crate::files::Opened;
use crate::model::{Checked, Model, Moves};
use crate::tui::event::Event;
use crate::tui::keys::{KeyMap, Scope};
use crate::tui::theme::Theme;

/// The message on the last line; it replaces the hints until the next key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Message {
    /// A command succeeded.
    Done(String),
    /// A command was refused, and why.
    Refused(String),
}

/// The designer.
#[derive(Debug)]
pub struct App {
    /// The key bindings.
    pub keys: KeyMap,
    /// Colours and characters.
    pub theme: Theme,
    /// The model and its file.
    pub document: Document,
    /// The tree.
    pub selection: Selection,
    /// The chart.
    pub curves: Curves,
    /// How values are shown.
    pub display: Display,
    /// The visible band, solved with a fine grid.
    pub detail: Detail,
    /// The values at the cursors.
    pub reading: Reading,
    /// References and measured curves, to compare with the model.
    pub comparison: Comparison,
    /// The levels in the marked band.
    pub band: Band,
    /// The sensitivities of the parameters.
    pub sensitivities: Sensitivities,
    /// The search for better parameters.
    pub tuning: Tuning,
    /// The view of the beam below the chart.
    pub beam_view: BeamViewState,
    /// The modes, and the shape of the selected one.
    pub modes: ModesState,
    /// The tables below the chart, and what the chart's cursor follows in them.
    pub tables: Tables,
    /// The finite-element curves.
    pub fem_overlay: FemOverlay,
    /// The dialog that takes the keys, if one is open.
    pub overlay: Option<Overlay>,
    /// The search of the tree, while typed and afterwards.
    pub search: Option<Search>,
    /// The message on the last line.
    pub message: Option<Message>,
    /// The positions of the panels on the screen, from the last drawing.
    pub screen: Screen,
    /// The model's file.
    pub files: FileState,
    /// The mouse.
    pub mouse: MouseState,
    /// Counts before commands, and the last change.
    pub repeat: RepeatState,
    /// The recovery file.
    pub recovery: RecoveryState,
    /// The stored view states and options.
    pub(crate) stored: StoredViews,
    /// What was requested of the worker.
    pub(crate) requests: RequestState,
}

impl App {
    /// The designer with an opened model.
    pub fn new(opened: Opened) -> Self {
        let document = Document::new(opened);
        let model = document.model();
        Self {
            keys: KeyMap::default(),
            theme: Theme::new(true),
            selection: Selection::new(model),
            curves: Curves::new(model, 0),
            display: Display::default(),
            detail: Detail::default(),
            reading: Reading::default(),
            comparison: Comparison::default(),
            band: Band::default(),
            sensitivities: Sensitivities::default(),
            tuning: Tuning::default(),
            beam_view: BeamViewState::default(),
            modes: ModesState::default(),
            tables: Tables::default(),
            fem_overlay: FemOverlay::default(),
            overlay: None,
            search: None,
            message: None,
            screen: Screen::default(),
            files: FileState::default(),
            mouse: MouseState::default(),
            repeat: RepeatState::default(),
            recovery: RecoveryState::default(),
            stored: StoredViews::default(),
            requests: RequestState::default(),
            document,
        }
    }

    /// The effects when the designer starts.
    pub fn start(&mut self) -> Vec<Effect> {
        self.tuning.moving.refresh(self.document.model());
        let mut effects = self.request();
        effects.extend(self.keep());
        effects
    }

    /// The current model.
    pub fn model(&self) -> &Arc<Checked> {
        self.document.model()
    }

    /// The scope of the keys now.
    pub fn scope(&self) -> Scope {
        match (&self.overlay, self.tables.open) {
            (Some(overlay), _) => overlay.scope(),
            (None, _) if self.is_searching() => Scope::Search,
            (None, Some(_)) => Scope::Table,
            (None, None) => Scope::Main,
        }
    }

    /// Stores the positions of a drawing; none if the screen is too small.
    pub fn drawn(&mut self, screen: Option<Screen>) {
        let Some(screen) = screen else {
            self.screen.unseen = true;
            return;
        };
        if screen.tree.area.height > 0 {
            self.selection.set_height(screen.tree.area.height.into());
        }
        self.tables = screen.tables;
        if let (Some(list), Some(drawn)) =
            (self.overlay.as_mut().and_then(Overlay::list), screen.dialog)
        {
            *list = drawn;
        }
        self.screen = screen;
    }

    /// Handles an event; returns the effects.
    pub fn update(&mut self, event: Event) -> Vec<Effect> {
        let mut effects = match event {
            Event::Key(key) if self.screen.unseen => self.key_unseen(&key),
            // The user cannot see the result.
            Event::Paste(_) | Event::Mouse(_) if self.screen.unseen => Vec::new(),
            Event::Key(key) => self.key(&key),
            Event::Paste(text) => self.paste(&text),
            Event::Mouse(event) => self.mouse(event),
            Event::Resize => Vec::new(),
            Event::Answer(answer) => {
                self.take(answer);
                Vec::new()
            }
            Event::Tick => {
                self.beam_view.next_frame();
                Vec::new()
            }
            Event::Touched => self.compare(),
            Event::Trouble(sentence) => {
                self.refuse(sentence);
                Vec::new()
            }
            Event::Suspend => vec![Effect::Suspend],
            Event::Resume => vec![Effect::Resume],
            // We cannot prompt after a signal: unsaved changes stay in the recovery file.
            Event::Quit(signal) => return vec![Effect::Quit(Some(signal.unsigned_abs() as u8))],
        };
        effects.extend(self.settle());
        effects
    }

    /// Updates everything that depends on the model; returns the effects.
    pub(crate) fn settle(&mut self) -> Vec<Effect> {
        self.refresh_fits();
        let has_reference = self.comparison.shown().next().is_some();
        self.display.refresh(&self.curves, has_reference);
        self.tuning.moving.refresh(self.document.model());
        // The first curve may have changed.
        self.tables.peaks.set_rows(self.curves.peaks().len());
        // Urgent requests come first.
        let mut effects = self.request();
        effects.extend(self.keep());
        effects
    }

    /// Updates everything that refers to rows of the tree, and the chart, after a change of the model.
    pub(crate) fn follow(&mut self, before: &Model) {
        let model = Arc::clone(self.document.model());
        let moves = Moves::new(before, &model);
        if let Some(search) = &mut self.search {
            search.follow(&moves, &model);
        }
        if let Some(effects) = &mut self.sensitivities.effects {
            effects.follow(&moves);
        }
        self.mouse.held = self.mouse.held.and_then(|node| node.moved(&moves));
        self.requests.expected = None;
        self.follow_rows(&moves, before, &model);
    }

    /// The same after a change of numbers only: all names stay valid.
    pub(crate) fn follow_number(&mut self, before: &Model) {
        let model = Arc::clone(self.document.model());
        self.follow_rows(&Moves::new(before, &model), before, &model);
    }

    fn follow_rows(&mut self, moves: &Moves, before: &Model, model: &Model) {
        self.selection.follow(moves, model);
        self.curves.follow(before, model);
        self.keep_marks_in_sweep();
    }

    pub(crate) fn done(&mut self, text: impl Into<String>) {
        self.message = Some(Message::Done(text.into()));
    }

    pub(crate) fn refuse(&mut self, text: impl Into<String>) {
        self.message = Some(Message::Refused(text.into()));
    }
}

#[cfg(test)]
pub(crate) mod tests;
