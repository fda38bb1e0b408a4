//! The designer's state, and how events and answers change it.
//!
//! [`App::update`] is pure: input and output are requested as [`Effect`]s, and their results come back through
//! [`App::reply`].

mod commands;
mod document;
pub(crate) mod edit;
mod effect;
mod export;
mod external_changes;
mod files;
mod history;
mod mouse;
mod new_item;
mod recovery;
pub(crate) mod repeat;
pub(crate) mod request;
mod screen;
mod structure;
mod view_state;

use std::sync::Arc;

pub use document::{Base, Document};
pub use effect::{Effect, Guard, Lost, Reply};
pub use export::{Export, Saving};
pub use external_changes::ExternalChange;
pub use screen::{Levels, Plot, Rows, Screen};

pub use crate::tui::panels::band::{Band, MemberLevels, ResponseLevel};
pub use crate::tui::panels::beam_view::{BeamView, BeamViewState};
pub use crate::tui::panels::chart::{
    Compared, Curves, Detail, DetailPicture, Display, MOTION, Member, Picture, Shown, Trace,
};
pub use crate::tui::panels::comparison::{Comparison, Reference};
pub use crate::tui::panels::dialogs::{
    Asked, AskedKind, List, Next, Overlay, Prompt, Purpose, ReplaceReason,
};
pub use crate::tui::panels::fem_overlay::{FemOverlay, FemPicture};
pub use crate::tui::panels::measured::{Measured, OpenedMeasured};
pub use crate::tui::panels::modes::{Completeness, ModeKind, ModeList, ModeRow, ModesState, Shape};
pub use crate::tui::panels::palette::{Entry, Found, Palette};
pub use crate::tui::panels::prompt::Question;
pub use crate::tui::panels::readings::{Reading, Value, nearest};
pub use crate::tui::panels::search::Search;
pub use crate::tui::panels::sensitivity::{Effects, Sensed, Sensitivities};
pub use crate::tui::panels::tables::{Anchor, Table, Tables};
pub use crate::tui::panels::tree::Selection;
pub use crate::tui::panels::tuning::{Progress, Run, Tuning};
pub use crate::worker::Stage;

use crate::files::Opened;
use crate::model::{Checked, Model, Moves};
use crate::tui::event::Event;
use crate::tui::keys::{KeyMap, Scope};
use crate::tui::theme::Theme;
use crate::tui::user::memory::{Memory, RememberedOptions};
use repeat::LastChange;

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
    /// The marked band.
    pub band: Band,
    /// The sensitivities of the parameters.
    pub sensitivities: Sensitivities,
    /// The search for better parameters.
    pub tuning: Tuning,
    /// The view of the beam below the chart.
    pub beam_view: BeamViewState,
    /// The modes, and the shape of the selected one.
    pub modes: ModesState,
    /// The tables below the chart.
    pub tables: Tables,
    /// What the chart's cursor follows.
    pub anchor: Anchor,
    /// The finite-element curves.
    pub fem_overlay: FemOverlay,
    /// The dialog that takes the keys, if one is open.
    pub overlay: Option<Overlay>,
    /// The search of the tree, while typed and afterwards.
    pub search: Option<Search>,
    /// The count typed before a command.
    pub count: Option<u32>,
    /// The message on the last line.
    pub message: Option<Message>,
    /// How another program changed the file.
    pub external_change: ExternalChange,
    /// Whether the designer captures the mouse.
    pub mouse: bool,
    /// The positions of the panels on the screen, from the last drawing.
    pub screen: Screen,
    /// The view states of other models.
    pub(crate) memory: Memory,
    /// Options that the user changed in this session.
    pub(crate) turned: RememberedOptions,
    /// Whether unsaved changes stay in the recovery file when the program ends.
    pub keeps: bool,
    /// The last change, for the repeat command.
    pub(crate) last_change: Option<LastChange>,
    /// The model that was last written to the recovery file, and whether it had unsaved changes.
    pub(crate) kept: Option<(Arc<Checked>, bool)>,
    /// The row that was clicked: the wheel changes its value.
    pub(crate) held: Option<crate::tui::tree::Node>,
    /// What follows a save that was started from a confirmation dialog.
    pub(crate) after_save: Option<Next>,
    /// The last request for curves.
    pub(crate) requested: Option<(Arc<Checked>, Option<usize>)>,
    /// The parameter whose next nudges are prepared, and its value at that time.
    pub(crate) expected: Option<(crate::model::ParameterId, f64)>,
    /// The generation of the last request for finite-element curves.
    pub(crate) fem_requested: Option<u64>,
    /// The last serial number.
    pub(crate) serial: u64,
    /// The screen is too small to show anything.
    pub unseen: bool,
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
            anchor: Anchor::default(),
            fem_overlay: FemOverlay::default(),
            overlay: None,
            search: None,
            count: None,
            message: None,
            external_change: ExternalChange::default(),
            mouse: false,
            screen: Screen::default(),
            memory: Memory::default(),
            turned: RememberedOptions::default(),
            keeps: false,
            last_change: None,
            kept: None,
            held: None,
            after_save: None,
            requested: None,
            expected: None,
            fem_requested: None,
            serial: 0,
            unseen: false,
            document,
        }
    }

    /// The effects when the designer starts.
    pub fn start(&mut self) -> Vec<Effect> {
        self.refresh_moving();
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

    /// Handles an event; returns the effects.
    pub fn update(&mut self, event: Event) -> Vec<Effect> {
        let mut effects = match event {
            Event::Key(key) if self.unseen => self.key_unseen(&key),
            // The user cannot see the result.
            Event::Paste(_) | Event::Mouse(_) if self.unseen => Vec::new(),
            Event::Key(key) => self.key(&key),
            Event::Paste(text) => self.paste(&text),
            Event::Mouse(event) => self.mouse(event),
            Event::Resize => Vec::new(),
            Event::Answer(answer) => {
                self.take(answer);
                Vec::new()
            }
            Event::Tick => {
                self.next_frame();
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
        self.refresh_display();
        self.refresh_moving();
        // The first curve may have changed.
        self.tables.peaks.set_rows(self.peaks().len());
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
        self.held = self.held.and_then(|node| node.moved(&moves));
        self.expected = None;
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

    /// A new serial number.
    pub(crate) fn next_serial(&mut self) -> u64 {
        self.serial += 1;
        self.serial
    }

    pub(crate) fn done(&mut self, text: impl Into<String>) {
        self.message = Some(Message::Done(text.into()));
    }

    pub(crate) fn refuse(&mut self, text: impl Into<String>) {
        self.message = Some(Message::Refused(text.into()));
    }
}

#[cfg(test)]
mod tests;
