//! The palette: a fuzzy search of all commands and parameters.

pub(crate) mod view;

use std::cmp::Reverse;
use std::sync::Arc;

use tui_input::Input;

use crate::guide::{CHAPTERS, Chapter};
use crate::tui::app::{App, Effect, List, Overlay};
use crate::tui::fuzzy;
use crate::tui::keys::{AnywhereCommand, Command, FileCommand, PaletteCommand, Scope};
use crate::tui::tree::{self, Node};

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

impl App {
    pub(crate) fn open_palette(&mut self) {
        let commands = self.keys.of(Scope::Main).chain(self.keys.of(Scope::Any));
        let mut entries: Vec<Entry> = commands
            .filter(|row| row.binding.command != FileCommand::Palette.into())
            .map(|row| Entry {
                found: Found::Command(row.binding.command),
                name: row.binding.name.replace('-', " "),
                help: row.binding.help,
                keys: row.names(),
            })
            .collect();
        let model = Arc::clone(self.document.model());
        entries.extend(tree::all_rows(&model).into_iter().map(|row| Entry {
            found: Found::Row(row.node),
            name: tree::subject(&model, row.node),
            help: "",
            keys: String::new(),
        }));
        let palette = Palette::new("Commands and parameters", entries);
        self.overlay = Some(Overlay::Palette(palette));
    }

    /// The palette of the chapters of the guide.
    pub(crate) fn open_chapters(&mut self) {
        let entry = |chapter: &'static Chapter| Entry {
            found: Found::Chapter(chapter),
            name: chapter.name.to_owned(),
            help: chapter.summary(),
            keys: String::new(),
        };
        let entries = CHAPTERS.iter().map(entry).collect();
        self.overlay = Some(Overlay::Palette(Palette::new(
            "Chapters of the guide",
            entries,
        )));
    }

    pub(crate) fn palette_command(&mut self, command: PaletteCommand) -> Vec<Effect> {
        let Some(Overlay::Palette(palette)) = &self.overlay else {
            return Vec::new();
        };
        let chosen = palette.found().nth(palette.list.row).map(|one| one.found);
        match (command, chosen) {
            (PaletteCommand::Cancel, _) => self.overlay = None,
            (PaletteCommand::Accept, None) => {}
            (PaletteCommand::Accept, Some(Found::Command(command))) => {
                self.overlay = None;
                return self.command(command);
            }
            (PaletteCommand::Accept, Some(Found::Row(node))) => {
                self.overlay = None;
                self.go_to(node);
            }
            (PaletteCommand::Accept, Some(Found::Chapter(chapter))) => {
                self.overlay = Some(Overlay::Guide(chapter, List::default()));
            }
        }
        Vec::new()
    }

    /// Selects a row, and opens a prompt for its value if it is typed.
    fn go_to(&mut self, node: Node) {
        let model = Arc::clone(self.document.model());
        self.selection.select(&model, node);
        if self.asked().is_some() {
            self.edit();
        }
    }
}
