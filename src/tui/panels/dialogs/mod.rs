//! The dialogs over the designer; an open dialog takes the keys.

mod confirm;
mod help;
pub(crate) mod view;

use std::path::PathBuf;

use tui_input::Input;

use crate::guide::Chapter;
use crate::model::{Fault, ParameterId, Unit};
use crate::presets;
use crate::tui::app::{Lost, Palette, Question, Saving};
use crate::tui::keys::{
    Command, ComparisonCommand, Movement, PaletteCommand, PickerCommand, RecoveryCommand, Scope,
};

/// An open dialog.
#[derive(Debug)]
pub enum Overlay {
    /// A prompt.
    Prompt(Prompt),
    /// The palette: a search of all commands and parameters.
    Palette(Palette),
    /// The list of presets.
    Presets(List),
    /// Help.
    Help(List),
    /// A chapter of the guide.
    Guide(&'static Chapter, List),
    /// The faults of a file that was not opened.
    Faults {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        faults: Vec<Fault>,
        /// The scroll position.
        list: List,
    },
    /// The confirmation about unsaved changes.
    Unsaved {
        /// The action that follows.
        next: Next,
        /// The dialog that was open before; cancelling restores it.
        beneath: Option<Box<Overlay>>,
    },
    /// The confirmation before a file is replaced.
    Replace {
        /// The file.
        path: PathBuf,
        /// Why a confirmation is needed.
        reason: ReplaceReason,
        /// The content to be written.
        what: Saving,
    },
    /// The list of references and measured curves.
    Comparison(List),
    /// The list of unsaved changes of programs that were killed.
    Recovery {
        /// Their models and ages.
        lost: Vec<Lost>,
        /// The selection.
        list: List,
    },
}

/// Why replacing a file needs confirmation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ReplaceReason {
    /// The file exists already.
    Exists,
    /// The file changed since it was opened or saved.
    ChangedOutside,
    /// The file would lose these attributes, which the user may not set.
    Loses(String),
}

/// The action that follows the confirmation about unsaved changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Next {
    /// Quit.
    Quit,
    /// Prompt for a file to open.
    AskPath,
    /// Open a preset.
    Preset(usize),
    /// Load recovered changes.
    Recover(usize),
    /// Reload the file.
    Reload,
}

/// A prompt for one line.
#[derive(Debug)]
pub struct Prompt {
    /// What it is for.
    pub purpose: Purpose,
    /// The typed text.
    pub input: Input,
    /// Whether the text is the initial one: typing replaces it, other keys start editing it.
    pub replaceable: bool,
    /// Why the text was refused.
    pub refusal: Option<String>,
}

impl Prompt {
    /// A prompt with an initial text.
    pub fn new(purpose: Purpose, text: String) -> Self {
        Self {
            purpose,
            replaceable: !text.is_empty(),
            input: Input::new(text),
            refusal: None,
        }
    }
}

/// What a prompt is for.
#[derive(Debug, Clone)]
pub enum Purpose {
    /// A parameter's value.
    Value(Asked),
    /// The path of a file to open.
    Open,
    /// The path of the file to save to.
    SaveAs,
    /// Another question.
    Ask(Question),
}

/// A parameter with a prompt for its value.
#[derive(Debug, Clone)]
pub struct Asked {
    /// The parameter as text.
    pub subject: String,
    /// The parameter.
    pub id: ParameterId,
    /// The allowed values.
    pub range: String,
    /// How the input is parsed.
    pub kind: AskedKind,
}

/// How a typed value is parsed.
#[derive(Debug, Clone)]
pub enum AskedKind {
    /// A number with this unit, or a change relative to the old value.
    Number(f64, Unit),
    /// A whole number, or a change relative to the old value.
    Count(usize),
    /// A text.
    Text,
}

/// A list with one selected row.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct List {
    /// The selected row, or the first visible one where none is selected.
    pub row: usize,
    /// How many rows there are.
    pub rows: usize,
    /// The number of visible rows; known after the first drawing.
    pub height: usize,
}

impl List {
    /// A list with this many rows.
    pub fn new(rows: usize, row: usize) -> Self {
        Self {
            row,
            rows,
            height: 1,
        }
    }

    /// The first visible row; keeps the selected one near the middle.
    pub fn first(&self) -> usize {
        let last = self.rows.saturating_sub(self.height);
        self.row.saturating_sub(self.height / 2).min(last)
    }

    /// Sets the number of rows.
    pub fn set_rows(&mut self, rows: usize) {
        self.rows = rows;
        self.row = self.row.min(rows.saturating_sub(1));
    }

    /// Moves by a screen.
    pub fn page(&mut self, forward: bool) {
        let rows = self.height.saturating_sub(1).max(1).cast_signed();
        self.step(if forward { rows } else { -rows });
    }

    /// Moves the selection.
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

    /// The scope of the dialog's keys.
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

    /// The visible list, of entries or of lines.
    pub(crate) fn list(&mut self) -> Option<&mut List> {
        match self {
            Self::Help(list) | Self::Guide(_, list) | Self::Faults { list, .. } => Some(list),
            _ => self.choices(),
        }
    }

    /// The list with a selectable entry.
    pub(crate) fn choices(&mut self) -> Option<&mut List> {
        match self {
            Self::Presets(list) | Self::Comparison(list) | Self::Recovery { list, .. } => {
                Some(list)
            }
            Self::Palette(palette) => Some(&mut palette.list),
            _ => None,
        }
    }

    /// The command that accepts the selected entry of such a list.
    pub(crate) fn accept(&self) -> Option<Command> {
        match self {
            Self::Presets(_) => Some(PickerCommand::Accept.into()),
            Self::Comparison(_) => Some(ComparisonCommand::Accept.into()),
            Self::Recovery { .. } => Some(RecoveryCommand::Accept.into()),
            Self::Palette(_) => Some(PaletteCommand::Accept.into()),
            _ => None,
        }
    }
}
