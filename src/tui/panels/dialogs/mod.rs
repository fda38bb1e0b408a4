//! The dialogs over the designer; an open dialog takes the keys.

mod confirm;
mod help;
pub(crate) mod view;

use std::path::PathBuf;

use crate::guide::Chapter;
use crate::model::Fault;
use crate::presets;
use crate::tui::app::effect::{Lost, Saving};
use crate::tui::app::list::List;
use crate::tui::keys::{
    Command, ComparisonCommand, PaletteCommand, PickerCommand, RecoveryCommand, Scope,
};
use crate::tui::panels::palette::Palette;
use crate::tui::panels::prompt::Prompt;

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
        /// Its faults.
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
