//! Opens the palette, and runs what is chosen.

use std::sync::Arc;

use super::{Entry, Found, Palette};
use crate::guide::{CHAPTERS, Chapter};
use crate::tui::app::{App, Effect, List, Overlay};
use crate::tui::keys::{FileCommand, PaletteCommand, Scope};
use crate::tui::tree::{self, Node};

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
