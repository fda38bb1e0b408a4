//! Subsystems that are too close for boxes.

use super::Picture;
use crate::model::{Subsystem, grouped};
use crate::tui::sketch::{Board, width};

/// The tick of the subsystems in one column.
pub(super) struct Tick<'a> {
    pub(super) column: i32,
    /// Their number.
    pub(super) count: usize,
    /// The one that represents all of them.
    pub(super) subsystem: &'a Subsystem,
    pub(super) selected: bool,
}

/// Ticks at their positions, and below them their names or their number.
pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>, group: &[Tick<'_>]) {
    for tick in group {
        let (subsystem, selected) = (tick.subsystem, tick.selected);
        let style = picture.style(subsystem.enabled, selected);
        let sign = match (selected, subsystem.enabled) {
            (true, _) => picture.signs.selected_tick,
            (_, on) => picture.signs.ticks[usize::from(!on)],
        };
        for row in picture.springs(tick.column) {
            let at = [tick.column, row];
            // At the ends, the springs of the supports stay.
            if selected {
                board.sign(at, sign, style);
            } else {
                board.sign_if_free(at, sign, style);
            }
        }
    }
    if picture.rows.boxes > 0 && !draw_names(picture, board, group) {
        draw_bracket(picture, board, group);
    }
}

/// Names the ticks if all names have room; returns whether they had.
fn draw_names(picture: &Picture<'_>, board: &mut Board<'_>, group: &[Tick<'_>]) -> bool {
    let row = picture.rows.below_springs();
    let mut behind = i32::MIN;
    let mut places = Vec::new();
    for tick in group {
        let subsystem = tick.subsystem;
        let columns = width(&subsystem.name);
        let left = tick.column - (columns - 1) / 2;
        let inside = left >= 0 && left + columns <= board.columns();
        if tick.count > 1 || left <= behind || !inside || !board.is_free([left, row], columns) {
            return false;
        }
        behind = left + columns;
        places.push((left, subsystem));
    }
    for (left, subsystem) in places {
        let style = picture.style(subsystem.enabled, false);
        board.word([left, row], &subsystem.name, style);
    }
    true
}

/// A bracket from the first tick to the last one, with their number.
fn draw_bracket(picture: &Picture<'_>, board: &mut Board<'_>, group: &[Tick<'_>]) {
    let row = picture.rows.below_springs();
    let [.., last] = group else {
        return;
    };
    let (left, right) = (group[0].column, last.column);
    let count: usize = group.iter().map(|tick| tick.count).sum();
    let count = grouped(count);
    let words = [format!(" {count} masses "), format!(" {count} "), count];
    let middle = left.midpoint(right);
    let style = picture.theme.dim();
    if !board.first_by([middle, row], &words, style) {
        board.first_by([middle, row + 1], &words, style);
    }
    let [_, _, from, to] = picture.signs.frame.corners;
    board.sign_if_free([left, row], from, style);
    board.sign_if_free([right, row], to, style);
    for column in left + 1..right {
        board.sign_if_free([column, row], picture.signs.frame.along, style);
    }
}
