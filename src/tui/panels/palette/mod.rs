//! The palette: a fuzzy search of all commands and parameters.

mod commands;
pub(crate) mod view;

use std::cmp::Reverse;

use tui_input::Input;

use crate::guide::Chapter;
use crate::tui::app::list::List;
use crate::tui::fuzzy;
use crate::tui::keys::{AnywhereCommand, Command, FileCommand};
use crate::tui::tree::Node;

/// Common names of commands in other programs, and the command here.
const HABITS: [(&str, Command); 7] = [
    ("w", Command::File(FileCommand::Save)),
    ("write", Command::File(FileCommand::Save)),
    ("q", Command::File(FileCommand::Quit)),
    ("q", Command::Anywhere(AnywhereCommand::End)),
    ("exit", Command::File(FileCommand::Quit)),
    ("exit", Command::Anywhere(AnywhereCommand::End)),
    ("e", Command::File(FileCommand::Open)),
];

/// The target of an entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Found {
    /// Runs a command.
    Command(Command),
    /// Selects a row of the tree, and edits its value if it is typed.
    Row(Node),
    /// Opens a chapter of the guide.
    Chapter(&'static Chapter),
}

/// A line of the palette.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The target.
    pub found: Found,
    /// The name of the command or chapter, or the full name of the row.
    pub name: String,
    /// The description of a command or chapter; empty for a row.
    pub help: &'static str,
    /// The command's keys; empty for others.
    pub keys: String,
}

/// The palette's state.
#[derive(Debug)]
pub struct Palette {
    /// The kind of entries, for the heading.
    pub subject: &'static str,
    /// The typed text.
    pub input: Input,
    /// The list of matches.
    pub list: List,
    entries: Vec<Entry>,
    /// Indices of matching entries, best first.
    ranked: Vec<usize>,
}

impl Palette {
    /// A palette of these entries.
    fn new(subject: &'static str, entries: Vec<Entry>) -> Self {
        let mut palette = Self {
            subject,
            input: Input::default(),
            list: List::default(),
            entries,
            ranked: Vec::new(),
        };
        palette.rank();
        palette
    }

    /// The matches, best first.
    pub fn found(&self) -> impl Iterator<Item = &Entry> {
        self.ranked.iter().map(|index| &self.entries[*index])
    }

    /// Changes the typed text and searches again.
    pub(crate) fn type_into(&mut self, change: impl FnOnce(&mut Input)) {
        let before = self.input.value().to_owned();
        change(&mut self.input);
        if self.input.value() != before {
            self.rank();
        }
    }

    fn rank(&mut self) {
        let query = fuzzy::Query::new(self.input.value());
        let typed = self.input.value().trim();
        let is_meant = |found: Found| {
            let mut habits = HABITS.iter().filter(|(habit, _)| *habit == typed);
            habits.any(|(_, command)| found == Found::Command(*command))
        };
        let scored = self
            .entries
            .iter()
            .enumerate()
            .filter_map(|(index, entry)| {
                let is_meant = is_meant(entry.found);
                let score = query
                    .score(&entry.name)
                    .max(query.score_with_description(entry.help));
                // Equal scores keep the order of the table and the tree.
                let rank = (!is_meant, Reverse(score), index);
                (is_meant || score.is_some()).then_some(rank)
            });
        let mut scored: Vec<_> = scored.collect();
        scored.sort_unstable();
        self.ranked = scored.into_iter().map(|(.., index)| index).collect();
        self.list.rows = self.ranked.len();
        self.list.row = 0;
    }
}
