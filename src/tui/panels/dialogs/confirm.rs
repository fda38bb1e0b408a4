//! The confirmation dialogs: unsaved changes, replacing a file, and recovered changes.

use std::path::Path;
use std::time::Duration;

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout};
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;

use crate::escape::shown_path;
use crate::tui::app::{List, Lost, Next, ReplaceReason, Rows};
use crate::tui::theme::Theme;
use crate::tui::view::dialog_box::{dialog_width, middle, open_dialog};
use crate::tui::view::text::{cut, width, wrapped};

/// The keys that answer, with their meanings.
type Answers<'a> = Vec<(String, &'a str)>;

/// Asks what to do with the changes to `source`.
pub(crate) fn draw_unsaved(
    frame: &mut Frame<'_>,
    next: Next,
    source: &str,
    answers: Answers<'_>,
    theme: Theme,
) {
    draw(
        frame,
        " Not saved ",
        &unsaved_words(next, source),
        answers,
        theme,
    );
}

/// Asks whether to replace a file.
pub(crate) fn draw_replace(
    frame: &mut Frame<'_>,
    reason: &ReplaceReason,
    path: &Path,
    answers: Answers<'_>,
    theme: Theme,
) {
    draw(
        frame,
        " Replace? ",
        &replace_words(reason, path),
        answers,
        theme,
    );
}

fn unsaved_words(next: Next, source: &str) -> String {
    let before = match next {
        Next::Quit => "quitting",
        Next::AskPath => "opening a file",
        Next::Preset(_) => "opening the preset",
        Next::Reload => "reloading the file",
        Next::Recover(_) => "recovering unsaved changes",
    };
    format!("The changes to {source} are not saved. Save them before {before}?")
}

fn replace_words(reason: &ReplaceReason, path: &Path) -> String {
    let path = shown_path(path);
    match reason {
        ReplaceReason::Exists => format!("{path} already exists. Replace it?"),
        ReplaceReason::ChangedOutside => {
            format!("{path} was changed by another program after it was opened here. Replace it?")
        }
        ReplaceReason::Loses(lost) => {
            format!("{path} would lose {lost}, which you may not set. Replace it?")
        }
    }
}

/// Draws the unsaved changes of programs that were killed, one per line, and the keys that answer. Returns the list and
/// its area.
pub(crate) fn draw_recovery(
    frame: &mut Frame<'_>,
    lost: &[Lost],
    mut list: List,
    answers: Answers<'_>,
    theme: Theme,
) -> (List, Rows) {
    const WORDS: &str = "A designer ended without saving. These changes can be recovered:";
    let words = wrapped(WORDS, usize::from(dialog_width(frame.area())));
    let place = middle(frame.area(), words.len() + lost.len() + 3);
    let title = format!(" Unsaved changes  {} of {} ", list.row + 1, lost.len());
    let inside = open_dialog(frame, place, &title, theme);
    let [head, rows, foot] = Layout::vertical([
        Constraint::Length(words.len() as u16 + 1),
        Constraint::Fill(1),
        Constraint::Length(2),
    ])
    .areas(inside);
    frame.render_widget(
        Paragraph::new(words.into_iter().map(Line::from).collect::<Vec<_>>()),
        head,
    );
    list.height = usize::from(rows.height).max(1);
    let first = list.first();
    for (line, (row, one)) in rows.rows().zip(lost.iter().enumerate().skip(first)) {
        let age = ago(one.age);
        let room = usize::from(line.width).saturating_sub(width(&age) + 1);
        let name = cut(&one.name, room);
        let blank = " ".repeat(room.saturating_sub(width(&name)));
        frame.render_widget(Line::raw(format!("{name}{blank} {age}")), line);
        if row == list.row {
            frame.buffer_mut().set_style(line, theme.selection());
        }
    }
    let answers = Paragraph::new(vec![Line::default(), answer_line(answers, theme)]);
    frame.render_widget(answers, foot);
    (list, Rows { area: rows, first })
}

/// How long ago something was, rounded as in speech.
fn ago(age: Duration) -> String {
    const UNITS: [(u64, &str); 4] = [
        (86_400, "day"),
        (3_600, "hour"),
        (60, "minute"),
        (1, "second"),
    ];
    let seconds = age.as_secs().max(1);
    let unit = UNITS.into_iter().find(|(length, _)| seconds >= *length);
    let (length, name) = unit.unwrap_or((1, "second"));
    match seconds / length {
        1 => format!("1 {name} ago"),
        count => format!("{count} {name}s ago"),
    }
}

/// A question with the keys that answer it.
fn draw(frame: &mut Frame<'_>, title: &str, text: &str, answers: Answers<'_>, theme: Theme) {
    let area = frame.area();
    let columns = usize::from(dialog_width(area));
    let mut lines: Vec<Line<'_>> = wrapped(text, columns).into_iter().map(Line::from).collect();
    lines.push(Line::default());
    lines.push(answer_line(answers, theme));
    let inside = open_dialog(frame, middle(area, lines.len()), title, theme);
    frame.render_widget(Paragraph::new(lines), inside);
}

/// The keys that answer, with their meanings.
fn answer_line(answers: Answers<'_>, theme: Theme) -> Line<'static> {
    let answers = answers.into_iter().flat_map(|(key, words)| {
        [
            Span::styled(key, theme.key()),
            Span::raw(format!(" {words}   ")),
        ]
    });
    answers.collect()
}
