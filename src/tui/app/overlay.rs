//! The boxes that stand over the designer and take its keys.

use std::path::PathBuf;

use tui_input::Input;

use super::{Lost, Palette, Question, Saving};
use crate::guide::Chapter;
use crate::model::{Fault, ParameterId, Unit};
use crate::presets;
use crate::tui::keys::{
    Command, ComparisonCommand, Movement, PaletteCommand, PickerCommand, RecoveryCommand, Scope,
};

/// A box over the designer.
#[derive(Debug)]
pub enum Overlay {
    /// Something is typed.
    Prompt(Prompt),
    /// Every command and parameter is searched.
    Palette(Palette),
    /// A preset is chosen.
    Presets(List),
    /// Help is read.
    Help(List),
    /// A chapter of the guide is read.
    Guide(&'static Chapter, List),
    /// Faults of a file that was not opened are read.
    Faults {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        faults: Vec<Fault>,
        /// Which part is shown.
        list: List,
    },
    /// Asks what becomes of unsaved changes.
    Unsaved {
        /// What comes then.
        next: Next,
        /// The box that stood there before, and comes back where the question is not answered.
        beneath: Option<Box<Overlay>>,
    },
    /// Asks whether a file is replaced.
    Replace {
        /// The file.
        path: PathBuf,
        /// Why there is a question.
        reason: ReplaceReason,
        /// What is to be written.
        what: Saving,
    },
    /// What stands on the chart beside the model is listed.
    Comparison(List),
    /// Unsaved changes of programs that were killed are offered.
    Recovery {
        /// Whose they are and how old.
        lost: Vec<Lost>,
        /// The selected ones.
        list: List,
    },
}

/// Why a file is not replaced without a question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReplaceReason {
    /// Another file of this name is there.
    Exists,
    /// It is not as it was when it was opened or saved.
    ChangedOutside,
    /// It cannot keep this, which the user may not give it.
    Loses(String),
}

/// What comes after unsaved changes are dealt with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Next {
    /// The program ends.
    Quit,
    /// The path of a file is asked for.
    AskPath,
    /// A preset is opened.
    Preset(usize),
    /// Unsaved changes that were found are taken.
    Recover(usize),
    /// The file is read again.
    Reload,
}

/// A box in which a line is typed.
#[derive(Debug)]
pub struct Prompt {
    /// What is asked for.
    pub purpose: Purpose,
    /// What is typed so far.
    pub input: Input,
    /// The text is the one that the box opened with: what is typed replaces it, other keys keep it for editing.
    pub replaceable: bool,
    /// Why what was typed was refused.
    pub refusal: Option<String>,
}

impl Prompt {
    /// A prompt with some text in it.
    pub fn new(purpose: Purpose, text: String) -> Self {
        Self {
            purpose,
            replaceable: !text.is_empty(),
            input: Input::new(text),
            refusal: None,
        }
    }
}

/// What a prompt asks for.
#[derive(Debug, Clone)]
pub enum Purpose {
    /// A parameter's value.
    Value(Asked),
    /// The path of a file to open.
    Open,
    /// The path of the file to save to.
    SaveAs,
    /// Something beside the model.
    Ask(Question),
}

/// A parameter whose value is asked for.
#[derive(Debug, Clone)]
pub struct Asked {
    /// The parameter in words.
    pub subject: String,
    /// Which one it is.
    pub id: ParameterId,
    /// What it may be.
    pub range: String,
    /// How it is read.
    pub kind: AskedKind,
}

/// How a typed value is read.
#[derive(Debug, Clone)]
pub enum AskedKind {
    /// As a number with this unit, perhaps relative to the old one.
    Number(f64, Unit),
    /// As a whole number, perhaps relative to the old one.
    Count(usize),
    /// As it stands.
    Text,
}

/// A list of which one row is selected.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct List {
    /// The selected row, or the first one shown where none is selected.
    pub row: usize,
    /// How many rows there are.
    pub rows: usize,
    /// How many there is room for; known when it has been drawn.
    pub height: usize,
}

impl List {
    /// A list of so many rows.
    pub fn new(rows: usize, row: usize) -> Self {
        Self {
            row,
            rows,
            height: 1,
        }
    }

    /// The first row on the screen, so that the selected one is about in the middle.
    pub fn first(&self) -> usize {
        let last = self.rows.saturating_sub(self.height);
        self.row.saturating_sub(self.height / 2).min(last)
    }

    /// Another number of rows.
    pub fn set_rows(&mut self, rows: usize) {
        self.rows = rows;
        self.row = self.row.min(rows.saturating_sub(1));
    }

    /// Moves by a screen.
    pub fn page(&mut self, forward: bool) {
        let rows = self.height.saturating_sub(1).max(1).cast_signed();
        self.step(if forward { rows } else { -rows });
    }

    /// Moves as a key asks.
    pub fn go(&mut self, movement: Movement) {
        match movement {
            Movement::Up => self.step(-1),
            Movement::Down => self.step(1),
            Movement::PageUp => self.page(false),
            Movement::PageDown => self.page(true),
            Movement::First => self.step(isize::MIN),
            Movement::Last => self.step(isize::MAX),
        }
    }

    /// Moves by rows; stops at the ends.
    pub fn step(&mut self, rows: isize) {
        self.row = self
            .row
            .saturating_add_signed(rows)
            .min(self.rows.saturating_sub(1));
    }
}

impl Overlay {
    /// The list of presets with this one selected.
    pub fn presets(row: usize) -> Self {
        Self::Presets(List::new(presets::ALL.len(), row))
    }

    /// Which keys have their meaning in the box.
    pub fn scope(&self) -> Scope {
        match self {
            Self::Prompt(_) => Scope::Prompt,
            Self::Palette(_) => Scope::Palette,
            Self::Presets(_) => Scope::Picker,
            Self::Help(_) | Self::Guide(..) | Self::Faults { .. } => Scope::Reader,
            Self::Unsaved { .. } => Scope::Unsaved,
            Self::Replace { .. } => Scope::Replace,
            Self::Recovery { .. } => Scope::Recovery,
            Self::Comparison(_) => Scope::Comparison,
        }
    }

    /// The list that shows, of entries or of lines.
    pub(super) fn list(&mut self) -> Option<&mut List> {
        match self {
            Self::Help(list) | Self::Guide(_, list) | Self::Faults { list, .. } => Some(list),
            _ => self.choices(),
        }
    }

    /// The list of which one entry is chosen.
    pub(super) fn choices(&mut self) -> Option<&mut List> {
        match self {
            Self::Presets(list) | Self::Comparison(list) | Self::Recovery { list, .. } => {
                Some(list)
            }
            Self::Palette(palette) => Some(&mut palette.list),
            _ => None,
        }
    }

    /// The command that takes the selected entry of such a list.
    pub(super) fn accept(&self) -> Option<Command> {
        match self {
            Self::Presets(_) => Some(PickerCommand::Accept.into()),
            Self::Comparison(_) => Some(ComparisonCommand::Accept.into()),
            Self::Recovery { .. } => Some(RecoveryCommand::Accept.into()),
            Self::Palette(_) => Some(PaletteCommand::Accept.into()),
            _ => None,
        }
    }
}
