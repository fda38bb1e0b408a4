//! The designer's state, and what every key and every answer does to it.
//!
//! [`App::update`] is pure: what is to be done outside comes back as [`Effect`]s, and what came of those goes in by
//! [`App::reply`].

mod band;
mod beam_view;
mod chart;
mod choose;
mod commands;
mod comparison;
mod curves;
mod detail;
mod display;
mod document;
mod edit;
mod effect;
mod export;
mod external_changes;
mod fem_overlay;
mod files;
mod history;
mod measured;
mod modes;
mod mouse;
mod new_item;
mod overlay;
mod palette;
mod prompt;
mod prompt_questions;
mod reading;
mod recovery;
mod repeat;
mod request;
mod screen;
mod search;
mod selection;
mod sensitivity;
mod shape;
mod structure;
mod tables;
mod tuning;
mod view_state;
mod zoom;

use std::sync::Arc;

pub use band::{Band, MemberLevels, ResponseLevel};
pub use beam_view::{BeamView, BeamViewState};
pub use comparison::{Comparison, Reference};
pub use curves::{Compared, Curves, Member, Picture, Shown, Trace};
pub use detail::{Detail, DetailPicture};
pub use display::{Display, MOTION};
pub use document::{Base, Document};
pub use effect::{Effect, Guard, Lost, Reply};
pub use export::{Export, Saving};
pub use external_changes::ExternalChange;
pub use fem_overlay::{FemOverlay, FemPicture};
pub use measured::{Measured, OpenedMeasured};
pub use modes::{Completeness, ModeKind, ModeList, ModeRow, ModesState};
pub use overlay::{Asked, AskedKind, List, Next, Overlay, Prompt, Purpose, ReplaceReason};
pub use palette::{Entry, Found, Palette};
pub use prompt_questions::Question;
pub use reading::{Reading, Value, nearest};
pub use screen::{Levels, Plot, Rows, Screen};
pub use search::Search;
pub use selection::Selection;
pub use sensitivity::{Effects, Sensed, Sensitivities};
pub use shape::Shape;
pub use tables::{Anchor, Table, Tables};
pub use tuning::{Progress, Run, Tuning};

pub use crate::worker::Stage;

use crate::files::Opened;
use crate::model::{Model, Moves};
use crate::tui::event::Event;
use crate::tui::keys::{KeyMap, Scope};
use crate::tui::theme::Theme;
use crate::tui::user::memory::{Memory, RememberedOptions};
use repeat::LastChange;

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
    /// Which keys do what.
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
    /// The band that shows, solved finely.
    pub detail: Detail,
    /// What is read at the cursors.
    pub reading: Reading,
    /// What stands on the chart beside the model.
    pub comparison: Comparison,
    /// The marked band.
    pub band: Band,
    /// Which parameter matters.
    pub sensitivities: Sensitivities,
    /// The search for better parameters.
    pub tuning: Tuning,
    /// What is looked at below the chart.
    pub beam_view: BeamViewState,
    /// The modes and the shape of one.
    pub modes: ModesState,
    /// The tables of modes and peaks.
    pub tables: Tables,
    /// What the chart's cursor stays with.
    pub anchor: Anchor,
    /// The finite-element curves.
    pub fem_overlay: FemOverlay,
    /// The box that takes the keys, if there is one.
    pub overlay: Option<Overlay>,
    /// The search of the tree, while it is typed and after.
    pub search: Option<Search>,
    /// The count typed before a command.
    pub count: Option<u32>,
    /// The last line's message.
    pub message: Option<Message>,
    /// What another program did to the file.
    pub external_change: ExternalChange,
    /// Whether the mouse is the designer's.
    pub mouse: bool,
    /// Where things are on the screen, as it was drawn last.
    pub screen: Screen,
    /// What is remembered of other models.
    memory: Memory,
    /// Options that were turned here.
    turned: RememberedOptions,
    /// What is not saved is kept at the end, although the program was left.
    pub keeps: bool,
    /// The change that can be done again.
    last_change: Option<LastChange>,
    /// The model that was kept for recovery last, and whether it was changed.
    kept: Option<(Arc<Model>, bool)>,
    /// The row that the mouse holds: the wheel turns its value.
    held: Option<crate::tui::tree::Node>,
    /// What comes after a save that was asked for by a question.
    after_save: Option<Next>,
    /// What was sent to be solved last.
    requested: Option<(Arc<Model>, Option<usize>)>,
    /// The parameter whose nudges are prepared for, and its value then.
    expected: Option<(crate::model::ParameterId, f64)>,
    /// The generation whose finite-element curves were asked for last.
    fem_requested: Option<u64>,
    /// The serial number given last.
    serial: u64,
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

    /// What is to be done when the designer starts.
    pub fn start(&mut self) -> Vec<Effect> {
        self.refresh_moving();
        let mut effects = self.request();
        effects.extend(self.keep());
        effects
    }

    /// The model as it stands.
    pub fn model(&self) -> &Arc<Model> {
        self.document.model()
    }

    /// Which keys have their meaning now.
    pub fn scope(&self) -> Scope {
        match (&self.overlay, self.tables.open) {
            (Some(overlay), _) => overlay.scope(),
            (None, _) if self.is_searching() => Scope::Search,
            (None, Some(_)) => Scope::Table,
            (None, None) => Scope::Main,
        }
    }

    /// Takes an event; what is to be done then.
    pub fn update(&mut self, event: Event) -> Vec<Effect> {
        let mut effects = match event {
            Event::Key(key) if self.unseen => self.key_unseen(&key),
            // Nobody can see what it would do.
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
            // There is nobody to ask: what is not saved stays kept.
            Event::Quit(signal) => return vec![Effect::Quit(Some(signal.unsigned_abs() as u8))],
        };
        effects.extend(self.settle());
        effects
    }

    /// Brings all that depends on the model up to date; what is to be done then.
    fn settle(&mut self) -> Vec<Effect> {
        self.refresh_fits();
        self.refresh_display();
        self.refresh_moving();
        // Another curve may be the first one now.
        self.tables.peaks.set_rows(self.peaks().len());
        // What is waited for comes first.
        let mut effects = self.request();
        effects.extend(self.keep());
        effects
    }

    /// Lets all that holds rows of the tree, and the chart, follow a model that has changed.
    fn follow(&mut self, before: &Model) {
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

    /// The same where no more than a number has changed: the rows have the names they had.
    fn follow_number(&mut self, before: &Model) {
        let model = Arc::clone(self.document.model());
        self.follow_rows(&Moves::new(before, &model), before, &model);
    }

    fn follow_rows(&mut self, moves: &Moves, before: &Model, model: &Model) {
        self.selection.follow(moves, model);
        self.curves.follow(before, model);
        self.keep_marks_in_sweep();
    }

    /// A number that was not given before.
    fn next_serial(&mut self) -> u64 {
        self.serial += 1;
        self.serial
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
