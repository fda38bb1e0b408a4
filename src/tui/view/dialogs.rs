//! The boxes over the designer: which one is drawn, and lists that are read or chosen from.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Clear, Padding, Paragraph};

use super::text::{cut, width, wrapped};
use super::{Panels, comparison, confirm, help, palette, prompt};
use crate::escape::shown_path;
use crate::model::{Fault, MOST_SHOWN};
use crate::presets;
use crate::tui::app::{App, List, Overlay, Rows};
use crate::tui::keys::{PromptCommand, RowKind, Scope};
use crate::tui::theme::Theme;

/// Columns of a box at most.
const WIDEST: u16 = 72;
/// Columns of its border and of the blanks beside it.
const FRAME: u16 = 4;
/// Columns of the widest picture of the guide.
const PICTURE: usize = 80;

/// Draws the open dialog; its list, and the rows of it that can be clicked.
pub(super) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    theme: Theme,
    panels: &Panels,
) -> (Option<List>, Option<Rows>) {
    let Some(overlay) = &app.overlay else {
        return (None, None);
    };
    let columns = usize::from(dialog_width(frame.area()));
    let answers = |scope| app.keys.hints(scope, RowKind::Group);
    let (list, rows) = match overlay {
        Overlay::Prompt(prompt) => {
            let complete = app.keys.key_of(PromptCommand::Complete);
            let below = prompt::row_below(app, panels);
            prompt::draw(frame, prompt, &complete, theme, below);
            return (None, None);
        }
        Overlay::Unsaved { next, .. } => {
            let source = app.document.source().name();
            confirm::draw_unsaved(frame, *next, &source, answers(Scope::Unsaved), theme);
            return (None, None);
        }
        Overlay::Replace { path, reason, .. } => {
            confirm::draw_replace(frame, reason, path, answers(Scope::Replace), theme);
            return (None, None);
        }
        Overlay::Help(list) => {
            let lines = help::lines(&app.keys, theme, columns);
            return (
                Some(draw_reader(frame, " Keys ", lines, *list, theme)),
                None,
            );
        }
        Overlay::Guide(chapter, list) => {
            let columns = frame.area().width.saturating_sub(FRAME);
            let lines = help::chapter(chapter, theme, usize::from(columns).min(PICTURE));
            let title = format!(" Guide: {} ", chapter.name);
            return (Some(draw_reader(frame, &title, lines, *list, theme)), None);
        }
        Overlay::Faults { path, faults, list } => {
            let title = format!(" {}: not opened ", shown_path(path));
            let lines = fault_lines(faults, theme, columns);
            return (Some(draw_reader(frame, &title, lines, *list, theme)), None);
        }
        Overlay::Comparison(list) => comparison::draw(frame, app, *list, theme),
        Overlay::Palette(palette) => palette::draw(frame, palette, app.document.model(), theme),
        Overlay::Presets(list) => draw_presets(frame, *list, theme),
        Overlay::Recovery { lost, list } => {
            confirm::draw_recovery(frame, lost, *list, answers(Scope::Recovery), theme)
        }
    };
    (Some(list), Some(rows))
}

/// Columns of text in a centred box.
pub(super) fn dialog_width(area: Rect) -> u16 {
    area.width.min(WIDEST).saturating_sub(FRAME)
}

/// Clears a place and draws a border around it; what is inside.
pub(super) fn open_dialog(frame: &mut Frame<'_>, area: Rect, title: &str, theme: Theme) -> Rect {
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
    middle_of_width(area, lines, WIDEST)
}

fn middle_of_width(area: Rect, lines: usize, widest: u16) -> Rect {
    let height = (lines as u16)
        .saturating_add(2)
        .min(area.height.saturating_sub(2));
    let width = area.width.min(widest);
    Rect::new(
        (area.width - width) / 2,
        (area.height - height) / 2,
        width,
        height,
    )
}

fn draw_presets(frame: &mut Frame<'_>, mut list: List, theme: Theme) -> (List, Rows) {
    let place = middle(frame.area(), presets::ALL.len());
    let title = format!(" Presets  {} of {} ", list.row + 1, list.rows);
    let inside = open_dialog(frame, place, &title, theme);
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
    let area = inside;
    (list, Rows { area, first })
}

/// Draws lines that are read and scrolled; how many of them there are and there is room for.
fn draw_reader(
    frame: &mut Frame<'_>,
    title: &str,
    lines: Vec<Line<'_>>,
    mut list: List,
    theme: Theme,
) -> List {
    let widest = lines.iter().map(Line::width).max().unwrap_or(0) as u16;
    let place = middle_of_width(frame.area(), lines.len(), WIDEST.max(widest + FRAME));
    list.height = usize::from(place.height.saturating_sub(2)).max(1);
    list.rows = lines.len().saturating_sub(list.height) + 1;
    list.row = list.row.min(list.rows - 1);
    let more = lines.len() > list.height;
    let inside = open_dialog(frame, place, title, theme);
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
    list
}

fn fault_lines(faults: &[Fault], theme: Theme, columns: usize) -> Vec<Line<'static>> {
    let mut lines = Vec::new();
    let more = faults.len().saturating_sub(MOST_SHOWN);
    let more = (more > 0).then(|| format!("and {more} more"));
    let sentences = faults.iter().take(MOST_SHOWN).map(Fault::to_string);
    for sentence in sentences.chain(more) {
        for (number, text) in wrapped(&sentence, columns.saturating_sub(2))
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
