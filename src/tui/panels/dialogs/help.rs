//! Text to read: every key, from the key table, and the chapters of the guide.

use ratatui::text::{Line, Span};

use crate::guide::{self, Chapter, Kind};
use crate::tui::keys::{FileCommand, KeyMap};
use crate::tui::theme::Theme;
use crate::tui::view::text::{width, wrapped};

/// Every key and its effect, in lines of at most this number of columns.
pub(crate) fn lines(keys: &KeyMap, theme: Theme, columns: usize) -> Vec<Line<'static>> {
    let widest = keys
        .rows()
        .map(|row| width(&row.names()))
        .max()
        .unwrap_or(0);
    let room = columns.saturating_sub(widest + 3);
    let guide = format!(
        "The guide explains more: `{}` lists its chapters.",
        keys.key_of(FileCommand::Guide)
    );
    let guide = wrapped(&guide, columns).into_iter().map(Line::raw);
    let mut lines: Vec<Line<'_>> = guide.chain([Line::default()]).collect();
    let mut heading = "";
    for row in keys.rows() {
        if row.section.title != heading {
            if !heading.is_empty() {
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

/// A chapter of the guide in lines of at most this number of columns; a picture may be wider.
pub(crate) fn chapter(chapter: &Chapter, theme: Theme, columns: usize) -> Vec<Line<'static>> {
    let styled = |line: guide::Line| match line.kind {
        Kind::Heading => {
            let title = line.text.trim_start_matches(['#', ' ']).to_owned();
            Line::styled(title, theme.accent())
        }
        Kind::Text | Kind::Code => Line::raw(line.text),
    };
    let lines = guide::lines(chapter.markdown, columns);
    lines.into_iter().map(styled).collect()
}
