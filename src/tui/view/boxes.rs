//! The boxes over the designer: prompts, lists and questions.

use std::path::Path;

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Position, Rect};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Clear, Padding, Paragraph};

use super::text::{cut, width, wrapped};
use super::{Panels, help};
use crate::model::{Fault, entry};
use crate::presets;
use crate::tui::app::{App, AskedKind, List, Next, Overlay, Prompt, Purpose, ReplaceReason};
use crate::tui::keys::{self, RowKind, Scope};
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
    let below = panels.tree.y + 2 + row as u16;
    match &mut app.overlay {
        None => {}
        Some(Overlay::Prompt(prompt)) => draw_prompt(frame, prompt, theme, below),
        Some(Overlay::Presets(list)) => draw_presets(frame, list, theme),
        Some(Overlay::Help(list)) => {
            let lines = help::lines(theme, usize::from(boxed_width(area)));
            draw_reader(frame, " Keys ", lines, list, theme);
        }
        Some(Overlay::Faults { path, faults, list }) => {
            let title = format!(" {}: not opened ", path.display());
            let lines = fault_lines(faults, theme, usize::from(boxed_width(area)));
            draw_reader(frame, &title, lines, list, theme);
        }
        Some(Overlay::Unsaved(next)) => {
            let text = unsaved_words(*next, &source);
            draw_question(frame, " Not saved ", &text, Scope::Unsaved, theme);
        }
        Some(Overlay::Replace { path, reason }) => {
            let text = replace_words(*reason, path);
            draw_question(frame, " Replace? ", &text, Scope::Replace, theme);
        }
    }
}

fn unsaved_words(next: Next, source: &str) -> String {
    let before = match next {
        Next::Quit => "quitting",
        Next::AskPath => "opening a file",
        Next::Preset(_) => "opening the preset",
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
fn open_box(frame: &mut Frame<'_>, area: Rect, title: &str, theme: Theme) -> Rect {
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
fn middle(area: Rect, lines: usize) -> Rect {
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

fn draw_prompt(frame: &mut Frame<'_>, prompt: &Prompt, theme: Theme, below: u16) {
    let area = frame.area();
    let (title, allowed) = prompt_words(&prompt.purpose);
    let columns = 56.min(area.width.saturating_sub(2));
    let text = usize::from(columns.saturating_sub(4));
    let (lines, style) = match &prompt.refusal {
        Some(refusal) => (wrapped(refusal, text), theme.refusal()),
        None => (wrapped(&allowed, text), theme.dim()),
    };
    let height = lines.len() as u16 + 3;
    // Under the selected row, or above it where there is no room.
    let y = if below + height < area.height {
        below
    } else {
        below.saturating_sub(height + 1)
    };
    let place = Rect::new(
        2.min(area.width - columns),
        y,
        columns,
        height.min(area.height),
    );
    let inside = open_box(frame, place, &title, theme);
    let [line, rest] = Layout::vertical([Constraint::Length(1), Constraint::Fill(1)]).areas(inside);
    draw_input(frame, prompt, line);
    let lines: Vec<Line<'_>> = lines
        .into_iter()
        .map(|line| Line::styled(line, style))
        .collect();
    frame.render_widget(Paragraph::new(lines), rest);
}

/// The title of a prompt, and what may be typed.
fn prompt_words(purpose: &Purpose) -> (String, String) {
    let path = || "path; Tab completes it".to_owned();
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
fn draw_input(frame: &mut Frame<'_>, prompt: &Prompt, area: Rect) {
    let room = usize::from(area.width.max(1) - 1);
    let scroll = prompt.input.visual_scroll(room);
    let line = Paragraph::new(prompt.input.value()).scroll((0, scroll as u16));
    frame.render_widget(line, area);
    let column = prompt.input.visual_cursor().saturating_sub(scroll) as u16;
    frame.set_cursor_position(Position::new(area.x + column, area.y));
}

fn draw_presets(frame: &mut Frame<'_>, list: &mut List, theme: Theme) {
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
fn draw_question(frame: &mut Frame<'_>, title: &str, text: &str, scope: Scope, theme: Theme) {
    let area = frame.area();
    let columns = usize::from(boxed_width(area));
    let mut lines: Vec<Line<'_>> = wrapped(text, columns).into_iter().map(Line::from).collect();
    let answers = keys::hints(scope, RowKind::Group)
        .into_iter()
        .flat_map(|(key, words)| {
            [
                Span::styled(key, theme.key()),
                Span::raw(format!(" {words}   ")),
            ]
        });
    lines.push(Line::default());
    lines.push(answers.collect());
    let inside = open_box(frame, middle(area, lines.len()), title, theme);
    frame.render_widget(Paragraph::new(lines), inside);
}
