//! The search of the tree.

mod commands;

use tui_input::Input;

use crate::model::{Model, Moves};
use crate::tui::fuzzy::Query;
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

    /// A search that starts at a row.
    pub(crate) fn new(origin: Node) -> Self {
        Self {
            input: Input::default(),
            typing: true,
            found: Vec::new(),
            origin,
        }
    }

    /// The index of the match next to a row that is not a match.
    fn nearest(&self, model: &Model, here: Node, forward: bool) -> usize {
        let rows = tree::all_rows(model);
        let before = rows.iter().take_while(|row| row.node != here);
        let passed = before.filter(|row| self.found.contains(&row.node)).count();
        let count = self.found.len();
        if forward {
            passed % count
        } else {
            (passed + count - 1) % count
        }
    }
}

#[cfg(test)]
mod tests;
