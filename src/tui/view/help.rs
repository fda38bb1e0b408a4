//! The help screen, made from the key table.

use ratatui::text::{Line, Span};

use super::text::{width, wrapped};
use crate::tui::keys::KeyMap;
use crate::tui::theme::Theme;

/// Every key and what it does, in lines of at most so many columns.
pub(super) fn lines(keys: &KeyMap, theme: Theme, columns: usize) -> Vec<Line<'static>> {
    let widest = keys
        .rows()
        .map(|row| width(&row.names()))
        .max()
        .unwrap_or(0);
    let room = columns.saturating_sub(widest + 3);
    let mut lines = Vec::new();
    let mut heading = "";
    for row in keys.rows() {
        if row.section.title != heading {
            if !lines.is_empty() {
                lines.push(Line::default());
            }
            heading = row.section.title;
            lines.push(Line::styled(heading, theme.accent()));
        }
        let names = row.names();
        for (number, words) in wrapped(row.binding.help, room).into_iter().enumerate() {
            let key = if number == 0 { names.as_str() } else { "" };
            let blank = " ".repeat(widest.saturating_sub(width(key)));
            lines.push(Line::from(vec![
                Span::styled(format!(" {key}{blank}  "), theme.key()),
                Span::raw(words),
            ]));
        }
    }
    lines
}
