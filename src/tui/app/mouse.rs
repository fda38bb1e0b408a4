//! The mouse. Everything it does has a key, too.

use std::sync::Arc;

use crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind};
use ratatui::layout::Position;

use super::{Anchor, App, Effect, Overlay, Table};
use crate::tui::keys::{FileCommand, ModelCommand, Movement};

/// Rows that a list scrolls per notch of the wheel.
const NOTCH: isize = 3;

impl App {
    pub(crate) fn toggle_mouse(&mut self) -> Vec<Effect> {
        self.mouse.captured = !self.mouse.captured;
        self.stored.changed.mouse = Some(self.mouse.captured);
        let key = self.keys.key_of(FileCommand::Mouse);
        self.done(if self.mouse.captured {
            format!("mouse captured; with Shift it selects text, {key} releases it")
        } else {
            format!("mouse released to the terminal; {key} captures it")
        });
        vec![Effect::Mouse(self.mouse.captured)]
    }

    /// Handles a mouse event.
    pub(crate) fn mouse(&mut self, event: MouseEvent) -> Vec<Effect> {
        let place = Position::new(event.column, event.row);
        let coarse = event.modifiers.contains(KeyModifiers::CONTROL);
        match event.kind {
            MouseEventKind::Down(MouseButton::Left) => self.click(place),
            MouseEventKind::Drag(MouseButton::Left) if self.overlay.is_none() => {
                self.point(place);
                Vec::new()
            }
            MouseEventKind::ScrollUp => self.turn(place, 1, coarse),
            MouseEventKind::ScrollDown => self.turn(place, -1, coarse),
            _ => Vec::new(),
        }
    }

    fn click(&mut self, place: Position) -> Vec<Effect> {
        self.message = None;
        self.repeat.count = None;
        self.mouse.held = None;
        if self.overlay.is_some() {
            return self.click_in_box(place);
        }
        if self.is_searching() {
            self.accept_search();
        }
        if let Some(row) = self.screen.tree.at(place) {
            return self.click_in_tree(row);
        }
        let table = self.screen.table.and_then(|rows| rows.at(place));
        match (table, self.tables.open) {
            (Some(row), Some(table)) => self.click_in_table(table, row),
            _ => self.point(place),
        }
        Vec::new()
    }

    /// A click selects a row; a click on the selected row acts as Enter.
    fn click_in_tree(&mut self, row: usize) -> Vec<Effect> {
        let model = Arc::clone(self.document.model());
        let Some(node) = self.selection.rows().get(row).map(|row| row.node) else {
            return Vec::new();
        };
        let again = self.selection.node() == node;
        self.selection.select(&model, node);
        self.mouse.held = Some(node);
        if again {
            return self.repeated(ModelCommand::Edit.into(), 1);
        }
        Vec::new()
    }

    fn click_in_table(&mut self, table: Table, row: usize) {
        let list = self.tables.list_mut(table);
        if row < list.rows {
            list.row = row;
            if let Some(anchor) = Anchor::of(table) {
                self.tables.anchor = anchor;
                self.follow_anchor();
            }
        }
    }

    /// A click selects an entry of a list; a click on the selected entry accepts it.
    fn click_in_box(&mut self, place: Position) -> Vec<Effect> {
        let row = self.screen.list.and_then(|rows| rows.at(place));
        let list = self.overlay.as_mut().and_then(Overlay::choices);
        if let (Some(row), Some(list)) = (row, list)
            && row < list.rows
        {
            if list.row != row {
                list.row = row;
            } else if let Some(accept) = self.overlay.as_ref().and_then(Overlay::accept) {
                return self.command(accept);
            }
        }
        Vec::new()
    }

    /// Moves the chart's cursor to a place.
    fn point(&mut self, place: Position) {
        let plot = self.screen.plot.as_ref();
        if let Some(frequency) = plot.and_then(|plot| plot.frequency(place)) {
            self.curves.cursor = Some(frequency);
            self.tables.anchor = Anchor::Frequency;
        }
    }

    /// A notch of the wheel, up (1) or down (-1): changes the value over the details or the clicked row, zooms the
    /// chart, or scrolls lists.
    fn turn(&mut self, place: Position, up: i32, coarse: bool) -> Vec<Effect> {
        self.message = None;
        let rows = NOTCH * if up > 0 { -1 } else { 1 };
        if let Some(overlay) = &mut self.overlay {
            if let Some(list) = overlay.list() {
                list.step(rows);
            }
            return Vec::new();
        }
        if self.is_held(place) {
            let nudge = match (up > 0, coarse) {
                (true, false) => ModelCommand::NudgeUp,
                (true, true) => ModelCommand::NudgeUpCoarse,
                (false, false) => ModelCommand::NudgeDown,
                (false, true) => ModelCommand::NudgeDownCoarse,
            };
            return self.repeated(nudge.into(), 1);
        }
        self.mouse.held = None;
        let frequency = self
            .screen
            .plot
            .as_ref()
            .and_then(|plot| plot.frequency(place));
        if let Some(frequency) = frequency {
            self.zoom(if up > 0 { 0.8 } else { 1.25 }, Some(frequency));
        } else if self.screen.tree.area.contains(place) {
            self.selection.step(rows);
        } else if let (Some(table), Some(rows)) = (self.tables.open, self.screen.table)
            && rows.area.contains(place)
            && !self.is_searching()
        {
            self.move_in_table(table, if up > 0 { Movement::Up } else { Movement::Down });
        }
        Vec::new()
    }

    /// Whether the wheel changes the selected value here: over its details, or over its row after a click on it.
    /// Elsewhere in the tree it scrolls, so that a row that moves under the mouse does not change.
    fn is_held(&self, place: Position) -> bool {
        let row = self.screen.tree.at(place);
        let on_held = self.mouse.held.is_some_and(|node| {
            node == self.selection.node() && row == Some(self.selection.cursor())
        });
        on_held || self.screen.details.contains(place)
    }
}
