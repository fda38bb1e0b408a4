//! The search of the tree.

use std::sync::Arc;

use tui_input::Input;

use crate::model::{Model, Moves, counted};
use crate::tui::app::App;
use crate::tui::fuzzy::Query;
use crate::tui::keys::{ReadingCommand, SearchCommand, TreeCommand};
use crate::tui::tree::{self, Node};

/// A search of the tree.
#[derive(Debug)]
pub struct Search {
    /// What is typed.
    pub input: Input,
    /// Whether the user still types it.
    pub typing: bool,
    /// The matching rows, in the order of the tree.
    pub found: Vec<Node>,
    /// The row at the start of the search.
    origin: Node,
}

impl Search {
    /// Follows a model that has changed.
    pub(crate) fn follow(&mut self, moves: &Moves, model: &Model) {
        // A removed row is replaced by its parent.
        let mut origin = Some(self.origin);
        while let Some(node) = origin {
            if let Some(moved) = node.moved(moves) {
                self.origin = moved;
                break;
            }
            origin = node.parent();
        }
        self.refresh(model);
    }

    /// Searches a model.
    fn refresh(&mut self, model: &Model) {
        let query = Query::new(self.input.value());
        let rows = tree::all_rows(model).into_iter().map(|row| row.node);
        self.found = rows
            .filter(|node| query.is_in(&tree::subject(model, *node)))
            .collect();
    }

    /// The number of a row among the matches, from 1.
    pub fn place(&self, node: Node) -> Option<usize> {
        let place = self.found.iter().position(|found| *found == node)?;
        Some(place + 1)
    }
}

impl App {
    /// Whether the user types a search.
    pub fn is_searching(&self) -> bool {
        self.search.as_ref().is_some_and(|search| search.typing)
    }

    pub(crate) fn start_search(&mut self) {
        self.search = Some(Search {
            input: Input::default(),
            typing: true,
            found: Vec::new(),
            origin: self.selection.node(),
        });
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
        let (sought, count) = (search.input.value().to_owned(), search.found.len());
        let next = self.keys.key_of(TreeCommand::NextAlike);
        if sought.trim().is_empty() {
            self.search = None;
        } else if count == 0 {
            self.search = None;
            self.refuse(format!("no row has `{sought}` in its name"));
        } else {
            let end = self.keys.key_of(ReadingCommand::CursorOff);
            self.done(format!(
                "`{sought}`: {}; {next} goes to the next, {end} ends the search",
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
            let sought = search.input.value();
            return self.refuse(format!("no row has `{sought}` in its name"));
        }
        let here = self.selection.node();
        let next = match (search.place(here), forward) {
            (Some(place), true) => place % count,
            (Some(place), false) => (place + count - 2) % count,
            (None, _) => self.nearest_found(forward),
        };
        let node = search.found[next];
        let sought = search.input.value().to_owned();
        self.selection.select(&model, node);
        self.done(format!(
            "`{sought}`: {} of {}",
            next + 1,
            counted(count, "row", "rows")
        ));
    }

    /// The index of the match next to the selected row, which is not a match.
    fn nearest_found(&self, forward: bool) -> usize {
        let Some(search) = &self.search else {
            return 0;
        };
        let here = self.selection.node();
        let rows = tree::all_rows(self.model());
        let before = rows.iter().take_while(|row| row.node != here);
        let passed = before
            .filter(|row| search.found.contains(&row.node))
            .count();
        let count = search.found.len();
        if forward {
            passed % count
        } else {
            (passed + count - 1) % count
        }
    }
}
