//! The help screen, made from the key table.

use ratatui::text::{Line, Span};

use super::text::{width, wrapped};
use crate::tui::keys::SECTIONS;
use crate::tui::theme::Theme;

/// Every key and what it does, in lines of at most so many columns.
pub(super) fn lines(theme: Theme, columns: usize) -> Vec<Line<'static>> {
    let names = |keys: &[crate::tui::keys::Key]| -> String {
        keys.iter()
            .map(|key| key.name())
            .collect::<Vec<_>>()
            .join(" ")
    };
    let bindings = SECTIONS.iter().flat_map(|section| section.bindings);
    let widest = bindings
        .map(|binding| width(&names(binding.keys)))
        .max()
        .unwrap_or(0);
    let mut lines = Vec::new();
    for section in SECTIONS {
        if !lines.is_empty() {
            lines.push(Line::default());
        }
        lines.push(Line::styled(section.title, theme.accent()));
        for binding in section.bindings {
            let keys = names(binding.keys);
            let room = columns.saturating_sub(widest + 3);
            for (number, words) in wrapped(binding.help, room).into_iter().enumerate() {
                let key = if number == 0 { keys.as_str() } else { "" };
                lines.push(Line::from(vec![
                    Span::styled(format!(" {key:<widest$}  "), theme.key()),
                    Span::raw(words),
                ]));
            }
        }
    }
    lines
}
