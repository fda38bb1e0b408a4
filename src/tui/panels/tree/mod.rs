//! The open groups, the selected row, and the visible part of the tree.

pub(crate) mod details;
mod summary;
pub(crate) mod view;

use std::collections::HashSet;

use crate::model::{Group, Model, Moves, Restraint};
use crate::tui::tree::{self, Node, Row};

/// The tree's state. Its rows are those of the last refreshed model.
#[derive(Debug)]
pub struct Selection {
    open: HashSet<Node>,
    rows: Vec<Row>,
    cursor: usize,
    offset: usize,
    height: usize,
}

impl Selection {
    /// A tree with its first level and the first subsystem open.
    pub fn new(model: &Model) -> Self {
        let mut open = HashSet::from([
            Node::Group(Group::Beam),
            Node::Group(Group::Subsystems),
            Node::Group(Group::Responses),
        ]);
        if model.subsystems.len() <= 1 {
            open.extend([
                Node::Group(Group::Supports),
                Node::Group(Group::Subsystem(0)),
            ]);
        }
        let mut selection = Self {
            open,
            rows: Vec::new(),
            cursor: 1,
            offset: 0,
            height: usize::MAX,
        };
        selection.refresh(model);
        selection
    }

    /// The selected row's node.
    pub fn node(&self) -> Node {
        self.rows
            .get(self.cursor)
            .map_or(Node::TITLE, |row| row.node)
    }

    /// All rows.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The first visible row for a height: scrolls only as far as needed to show the selected row.
    pub fn first_shown(&self, height: usize) -> usize {
        let height = height.max(1);
        let last = self.rows.len().saturating_sub(height);
        let lowest = (self.cursor + 1).saturating_sub(height);
        self.offset.max(lowest).min(self.cursor).min(last)
    }

    /// The index of the selected row.
    pub fn cursor(&self) -> usize {
        self.cursor
    }

    /// The open groups, in the order of the tree.
    pub(crate) fn open(&self) -> impl Iterator<Item = Node> {
        let open = self.rows.iter().filter(|row| row.open == Some(true));
        open.map(|row| row.node)
    }

    /// Opens exactly these groups, and selects a row if it exists.
    pub(crate) fn restore(&mut self, model: &Model, open: HashSet<Node>, selected: Option<Node>) {
        self.open = open;
        self.refresh(model);
        if let Some(node) = selected {
            self.select(model, node);
        }
    }

    /// The selected row and the number of rows, to detect a change.
    pub(crate) fn state(&self) -> (usize, usize) {
        (self.cursor, self.rows.len())
    }

    /// Rebuilds the rows after a change of the model or of the open groups; the selection stays on its node, or moves
    /// to its parent.
    pub fn refresh(&mut self, model: &Model) {
        let node = self.rows.get(self.cursor).map(|row| row.node);
        self.rows = tree::rows(model, |node| self.open.contains(&node));
        let mut shown = node;
        while let Some(node) = shown {
            if let Some(found) = self.rows.iter().position(|row| row.node == node) {
                self.cursor = found;
                break;
            }
            shown = node.parent();
        }
        self.cursor = self.cursor.min(self.rows.len().saturating_sub(1));
        self.scroll();
    }

    /// Follows subsystems, forces, responses and studies to their new indices after some were added or removed.
    pub(crate) fn follow(&mut self, moved: &Moves, after: &Model) {
        self.open = self
            .open
            .iter()
            .filter_map(|node| node.moved(moved))
            .collect();
        for row in &mut self.rows {
            if let Some(node) = row.node.moved(moved) {
                row.node = node;
            }
        }
        self.refresh(after);
    }

    /// Sets the visible height.
    pub fn set_height(&mut self, height: usize) {
        self.height = height.max(1);
        self.scroll();
    }

    /// Moves by rows; stops at the ends.
    pub fn step(&mut self, rows: isize) {
        self.go(self.cursor.saturating_add_signed(rows));
    }

    /// Moves by screens.
    pub fn page(&mut self, forward: bool) {
        let rows = self.height.saturating_sub(1).max(1).cast_signed();
        self.step(if forward { rows } else { -rows });
    }

    /// Goes to the first row.
    pub fn first(&mut self) {
        self.go(0);
    }

    /// Goes to the last row.
    pub fn last(&mut self) {
        self.go(usize::MAX);
    }

    /// Opens the selected group, or goes to its first row if already open.
    pub fn expand(&mut self, model: &Model) {
        match self.rows.get(self.cursor).and_then(|row| row.open) {
            Some(true) => self.step(1),
            Some(false) => self.toggle(model),
            None => {}
        }
    }

    /// Opens every group, except the springs of free motions, which are all 0.
    pub fn expand_all(&mut self, model: &Model) {
        let groups = tree::all_rows(model)
            .into_iter()
            .filter(|row| row.open.is_some())
            .map(|row| row.node);
        let holds_zeros = |node: &Node| match node {
            Node::Group(Group::Motion(end, motion)) => {
                end.support(model)[*motion] == Restraint::Free
            }
            _ => false,
        };
        self.open = groups.filter(|node| !holds_zeros(node)).collect();
        self.refresh(model);
    }

    /// Closes every group.
    pub fn collapse_all(&mut self, model: &Model) {
        self.open.clear();
        self.refresh(model);
    }

    /// Closes the selected group, or goes to the group that holds the row.
    pub fn collapse(&mut self, model: &Model) {
        if self.rows.get(self.cursor).and_then(|row| row.open) == Some(true) {
            self.toggle(model);
        } else if let Some(parent) = self.node().parent() {
            self.select(model, parent);
        }
    }

    /// Opens or closes the selected group.
    pub fn toggle(&mut self, model: &Model) {
        let node = self.node();
        if !self.open.remove(&node) {
            self.open.insert(node);
        }
        self.refresh(model);
    }

    /// Selects a node, and opens its parents.
    pub fn select(&mut self, model: &Model, node: Node) {
        let mut holder = node.parent();
        while let Some(parent) = holder {
            self.open.insert(parent);
            holder = parent.parent();
        }
        self.rows = tree::rows(model, |node| self.open.contains(&node));
        if let Some(found) = self.rows.iter().position(|row| row.node == node) {
            self.cursor = found;
        }
        self.go(self.cursor);
    }

    /// Selects a following or preceding parameter of the model, visible or not.
    pub fn next_parameter(&mut self, model: &Model, forward: bool, times: usize) {
        let all = tree::all_rows(model);
        let here = self.node();
        let Some(at) = all.iter().position(|row| row.node == here) else {
            return;
        };
        let parameter = |row: &&Row| row.open.is_none() && row.node.parameter().is_some();
        let found = if forward {
            all[at + 1..].iter().filter(parameter).take(times).last()
        } else {
            all[..at].iter().rev().filter(parameter).take(times).last()
        };
        if let Some(row) = found {
            self.select(model, row.node);
        }
    }

    fn go(&mut self, row: usize) {
        self.cursor = row.min(self.rows.len().saturating_sub(1));
        self.scroll();
    }

    fn scroll(&mut self) {
        self.offset = self.first_shown(self.height);
    }
}
