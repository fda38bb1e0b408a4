//! The boxes over the designer: prompts, lists and questions.

use std::path::Path;
use std::time::Duration;

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Position, Rect};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Clear, Padding, Paragraph};
use tui_input::Input;

use super::text::{cut, width, wrapped};
use super::{Panels, help, palette};
use crate::model::{Fault, entry};
use crate::presets;
use crate::tui::app::{
    App, AskedKind, List, Lost, Next, Overlay, Prompt, Purpose, ReplaceReason, Rows,
};
use crate::tui::keys::{Command, RowKind, Scope};
use crate::tui::theme::Theme;

/// Columns of a box at most.
const WIDEST: u16 = 72;

pub(super) fn draw(frame: &mut Frame<'_>, app: &mut App, theme: Theme, panels: &Panels) {
    let area = frame.area();
    let source = app.document.source().name();
    let (rows, offset) = app.selection.rows();
    let row = app
        .selection
        .cursor()
        .saturating_sub(offset)
        .min(rows.len());
    // Where the tree does not show there is no row to stand under.
    let below = if panels.tree.height > 0 {
        panels.tree.y + 2 + row as u16
    } else {
        0
    };
    let complete = app.keys.key_of_in(Scope::Prompt, Command::Complete);
    app.screen.list = None;
    match &mut app.overlay {
        None => {}
        Some(Overlay::Prompt(prompt)) => draw_prompt(frame, prompt, &complete, theme, below),
        Some(Overlay::Palette(palette)) => {
            let model = app.document.model();
            app.screen.list = Some(palette::draw(frame, palette, model, theme));
        }
        Some(Overlay::Presets(list)) => app.screen.list = Some(draw_presets(frame, list, theme)),
        Some(Overlay::Recovery { lost, list }) => {
            let answers = app.keys.hints(Scope::Recovery, RowKind::Group);
            app.screen.list = Some(draw_recovery(frame, lost, list, answers, theme));
        }
        Some(Overlay::Help(list)) => {
            let lines = help::lines(&app.keys, theme, usize::from(boxed_width(area)));
            draw_reader(frame, " Keys ", lines, list, theme);
        }
        Some(Overlay::Faults { path, faults, list }) => {
            let title = format!(" {}: not opened ", path.display());
            let lines = fault_lines(faults, theme, usize::from(boxed_width(area)));
            draw_reader(frame, &title, lines, list, theme);
        }
        Some(Overlay::Unsaved { next, .. }) => {
            let text = unsaved_words(*next, &source);
            draw_question(
                frame,
                " Not saved ",
                &text,
                app.keys.hints(Scope::Unsaved, RowKind::Group),
                theme,
            );
        }
        Some(Overlay::Replace { path, reason }) => {
            let text = replace_words(*reason, path);
            draw_question(
                frame,
                " Replace? ",
                &text,
                app.keys.hints(Scope::Replace, RowKind::Group),
                theme,
            );
        }
    }
}

fn unsaved_words(next: Next, source: &str) -> String {
    let before = match next {
        Next::Quit => "quitting",
        Next::AskPath => "opening a file",
        Next::Preset(_) => "opening the preset",
        Next::Reload => "reading the file again",
        Next::Recover(_) => "taking the unsaved changes that were found",
    };
    format!("The changes to {source} are not saved. Save them before {before}?")
}

fn replace_words(reason: ReplaceReason, path: &Path) -> String {
    let path = path.display();
    match reason {
        ReplaceReason::Exists => format!("{path} is there already. Replace it?"),
        ReplaceReason::ChangedOutside => {
            format!("{path} was changed by another program after it was opened here. Replace it?")
        }
    }
}

/// Columns of text in a centred box.
fn boxed_width(area: Rect) -> u16 {
    area.width.min(WIDEST).saturating_sub(4)
}

/// Clears a place and draws a border around it; what is inside.
pub(super) fn open_box(frame: &mut Frame<'_>, area: Rect, title: &str, theme: Theme) -> Rect {
    let block = Block::bordered()
        .border_style(theme.accent())
        .title(Span::styled(
            cut(title, usize::from(area.width.saturating_sub(2))),
            theme.accent(),
        ))
        .padding(Padding::horizontal(1));
    let inside = block.inner(area);
    frame.render_widget(Clear, area);
    frame.render_widget(block, area);
    inside
}

/// A box in the middle for so many lines of text.
pub(super) fn middle(area: Rect, lines: usize) -> Rect {
    let height = (lines as u16)
        .saturating_add(2)
        .min(area.height.saturating_sub(2));
    let width = area.width.min(WIDEST);
    Rect::new(
        (area.width - width) / 2,
        (area.height - height) / 2,
        width,
        height,
    )
}

fn draw_prompt(frame: &mut Frame<'_>, prompt: &Prompt, complete: &str, theme: Theme, below: u16) {
    let area = frame.area();
    let (title, allowed) = prompt_words(&prompt.purpose, complete);
    let columns = 56.min(area.width.saturating_sub(2));
    let text = usize::from(columns.saturating_sub(4));
    let (lines, style) = match &prompt.refusal {
        Some(refusal) => (wrapped(refusal, text), theme.refusal()),
        None => (wrapped(&allowed, text), theme.dim()),
    };
    let height = lines.len() as u16 + 3;
    // Under the selected row, or above it where there is no room; on the screen in any case.
    let y = if below + height < area.height {
        below
    } else {
        below.saturating_sub(height + 1)
    };
    let y = y.min(area.height.saturating_sub(height));
    let place = Rect::new(
        2.min(area.width - columns),
        y,
        columns,
        height.min(area.height),
    );
    let inside = open_box(frame, place, &title, theme);
    let [line, rest] = Layout::vertical([Constraint::Length(1), Constraint::Fill(1)]).areas(inside);
    draw_input(frame, &prompt.input, line);
    let lines: Vec<Line<'_>> = lines
        .into_iter()
        .map(|line| Line::styled(line, style))
        .collect();
    frame.render_widget(Paragraph::new(lines), rest);
}

/// The title of a prompt, and what may be typed.
fn prompt_words(purpose: &Purpose, complete: &str) -> (String, String) {
    let path = || format!("path; {complete} completes it");
    match purpose {
        Purpose::Open => (" Open a file ".to_owned(), path()),
        Purpose::SaveAs => (" Save as ".to_owned(), path()),
        Purpose::Value(asked) => {
            let allowed = match &asked.kind {
                AskedKind::Number(_, unit) => format!("{}: {}", asked.range, entry::accepted(unit)),
                AskedKind::Count(_) => format!("{}; or a change (*2, /2, +5%)", asked.range),
                AskedKind::Text => asked.range.clone(),
            };
            (format!(" {} ", asked.subject), allowed)
        }
    }
}

/// The typed line with the terminal's cursor in it.
pub(super) fn draw_input(frame: &mut Frame<'_>, input: &Input, area: Rect) {
    let room = usize::from(area.width.max(1) - 1);
    let scroll = input.visual_scroll(room);
    let line = Paragraph::new(input.value()).scroll((0, scroll as u16));
    frame.render_widget(line, area);
    let column = input.visual_cursor().saturating_sub(scroll) as u16;
    frame.set_cursor_position(Position::new(area.x + column, area.y));
}

fn draw_presets(frame: &mut Frame<'_>, list: &mut List, theme: Theme) -> Rows {
    let place = middle(frame.area(), presets::ALL.len());
    let title = format!(" Presets  {} of {} ", list.row + 1, list.rows);
    let inside = open_box(frame, place, &title, theme);
    list.height = usize::from(inside.height);
    let names = presets::ALL
        .iter()
        .map(|preset| width(preset.name))
        .max()
        .unwrap_or(0);
    let first = (list.row + 1).saturating_sub(list.height);
    for (line, (row, preset)) in inside
        .rows()
        .zip(presets::ALL.iter().enumerate().skip(first))
    {
        let title = cut(
            &preset.title(),
            usize::from(line.width).saturating_sub(names + 2),
        );
        let text = Line::from(vec![
            Span::styled(format!("{:<names$}  ", preset.name), theme.key()),
            Span::raw(title),
        ]);
        frame.render_widget(text, line);
        if row == list.row {
            frame.buffer_mut().set_style(line, theme.selection());
        }
    }
    Rows {
        area: inside,
        first,
    }
}

/// Unsaved changes of programs that were killed, a line each, and the keys that answer.
fn draw_recovery(
    frame: &mut Frame<'_>,
    lost: &[Lost],
    list: &mut List,
    answers: Vec<(String, &str)>,
    theme: Theme,
) -> Rows {
    const WORDS: &str = "A designer ended without saving. Its changes were kept:";
    let words = wrapped(WORDS, usize::from(boxed_width(frame.area())));
    let place = middle(frame.area(), words.len() + lost.len() + 3);
    let title = format!(" Unsaved changes  {} of {} ", list.row + 1, lost.len());
    let inside = open_box(frame, place, &title, theme);
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
        frame.render_widget(Line::raw(format!("{name:<room$} {age}")), line);
        if row == list.row {
            frame.buffer_mut().set_style(line, theme.selection());
        }
    }
    let answers = Paragraph::new(vec![Line::default(), answer_line(answers, theme)]);
    frame.render_widget(answers, foot);
    Rows { area: rows, first }
}

/// How long ago something was, as precisely as one would say it.
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

/// Lines that are read and scrolled.
fn draw_reader(
    frame: &mut Frame<'_>,
    title: &str,
    lines: Vec<Line<'_>>,
    list: &mut List,
    theme: Theme,
) {
    let place = middle(frame.area(), lines.len());
    list.height = usize::from(place.height.saturating_sub(2)).max(1);
    list.rows = lines.len().saturating_sub(list.height) + 1;
    list.row = list.row.min(list.rows - 1);
    let more = lines.len() > list.height;
    let inside = open_box(frame, place, title, theme);
    if more {
        let last = (list.row + list.height).min(lines.len());
        let text = format!(" {} to {last} of {} ", list.row + 1, lines.len());
        let bottom = Rect::new(
            place.x + 2,
            place.bottom() - 1,
            place.width.saturating_sub(4),
            1,
        );
        frame.render_widget(Line::styled(text, theme.dim()).right_aligned(), bottom);
    }
    frame.render_widget(Paragraph::new(lines).scroll((list.row as u16, 0)), inside);
}

fn fault_lines(faults: &[Fault], theme: Theme, columns: usize) -> Vec<Line<'static>> {
    let mut lines = Vec::new();
    for fault in faults {
        for (number, text) in wrapped(&fault.to_string(), columns.saturating_sub(2))
            .into_iter()
            .enumerate()
        {
            let bullet = if number == 0 { "- " } else { "  " };
            lines.push(Line::from(vec![
                Span::styled(bullet, theme.refusal()),
                Span::raw(text),
            ]));
        }
    }
    lines
}

/// A question with the keys that answer it.
fn draw_question(
    frame: &mut Frame<'_>,
    title: &str,
    text: &str,
    answers: Vec<(String, &str)>,
    theme: Theme,
) {
    let area = frame.area();
    let columns = usize::from(boxed_width(area));
    let mut lines: Vec<Line<'_>> = wrapped(text, columns).into_iter().map(Line::from).collect();
    lines.push(Line::default());
    lines.push(answer_line(answers, theme));
    let inside = open_box(frame, middle(area, lines.len()), title, theme);
    frame.render_widget(Paragraph::new(lines), inside);
}

/// The keys that answer, with what they mean.
fn answer_line(answers: Vec<(String, &str)>, theme: Theme) -> Line<'static> {
    let answers = answers.into_iter().flat_map(|(key, words)| {
        [
            Span::styled(key, theme.key()),
            Span::raw(format!(" {words}   ")),
        ]
    });
    answers.collect()
}
