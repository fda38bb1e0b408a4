//! Starts, types and ends the search of the tree, and goes to what is found.

use std::sync::Arc;

use tui_input::Input;

use crate::model::counted;
use crate::tui::app::App;
use crate::tui::keys::{ReadingCommand, SearchCommand, TreeCommand};
use crate::tui::tree;

impl App {
    /// Whether the user types a search.
    pub fn is_searching(&self) -> bool {
        self.search.as_ref().is_some_and(|search| search.typing)
    }

    /// Changes the search text; selects the first match from the start row on.
    pub(crate) fn type_search(&mut self, change: impl FnOnce(&mut Input)) {
        let model = Arc::clone(self.document.model());
        let Some(search) = &mut self.search else {
            return;
        };
        let before = search.input.value().to_owned();
        change(&mut search.input);
        if search.input.value() == before {
            return;
        }
        search.refresh(&model);
        let origin = search.origin;
        let rows = tree::all_rows(&model);
        let mut from_origin = rows.iter().skip_while(|row| row.node != origin);
        let next = from_origin.find(|row| search.found.contains(&row.node));
        let found = next.map(|row| row.node).or(search.found.first().copied());
        self.selection.select(&model, found.unwrap_or(origin));
    }

    pub(crate) fn search_command(&mut self, command: SearchCommand) {
        match command {
            SearchCommand::Accept => self.accept_search(),
            SearchCommand::Cancel => {
                let model = Arc::clone(self.document.model());
                if let Some(search) = self.search.take() {
                    self.selection.select(&model, search.origin);
                }
            }
        }
    }

    pub(crate) fn accept_search(&mut self) {
        let Some(search) = &mut self.search else {
            return;
        };
        search.typing = false;
        let (query, count) = (search.input.value().to_owned(), search.found.len());
        let next = self.keys.key_of(TreeCommand::NextAlike);
        if query.trim().is_empty() {
            self.search = None;
        } else if count == 0 {
            self.search = None;
            self.refuse(format!("no row has `{query}` in its name"));
        } else {
            let end = self.keys.key_of(ReadingCommand::CursorOff);
            self.done(format!(
                "`{query}`: {}; {next} goes to the next, {end} ends the search",
                counted(count, "row", "rows")
            ));
        }
    }

    /// Goes to the next or previous match, cyclically.
    pub(crate) fn seek_found(&mut self, forward: bool) {
        let model = Arc::clone(self.document.model());
        let Some(search) = &self.search else {
            return;
        };
        let count = search.found.len();
        if count == 0 {
            let query = search.input.value();
            return self.refuse(format!("no row has `{query}` in its name"));
        }
        let here = self.selection.node();
        let next = match (search.place(here), forward) {
            (Some(place), true) => place % count,
            (Some(place), false) => (place + count - 2) % count,
            (None, _) => search.nearest(&model, here, forward),
        };
        let node = search.found[next];
        let query = search.input.value().to_owned();
        self.selection.select(&model, node);
        self.done(format!(
            "`{query}`: {} of {}",
            next + 1,
            counted(count, "row", "rows")
        ));
    }
}
