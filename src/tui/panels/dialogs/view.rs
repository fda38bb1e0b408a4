//! The dialogs over the designer: which one is open, and lists to read or to choose from.

use ratatui::Frame;
use ratatui::text::{Line, Span};

use super::{confirm, help};
use crate::escape::shown_path;
use crate::model::{Fault, MOST_SHOWN};
use crate::presets;
use crate::tui::app::{App, List, Overlay, Rows};
use crate::tui::keys::{PromptCommand, RowKind, Scope};
use crate::tui::panels::{comparison, palette, prompt};
use crate::tui::theme::Theme;
use crate::tui::view::dialog_box::{FRAME, dialog_width, draw_reader, middle, open_dialog};
use crate::tui::view::layout::Panels;
use crate::tui::view::text::{cut, width, wrapped};

/// Columns of the widest picture of the guide.
const PICTURE: usize = 80;

/// Draws the open dialog; returns its list, and the rows of it that can be clicked.
pub(crate) fn draw(
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
            let below = prompt::view::row_below(app, panels);
            prompt::view::draw(frame, prompt, &complete, theme, below);
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
        Overlay::Comparison(list) => comparison::view::draw(frame, app, *list, theme),
        Overlay::Palette(palette) => {
            palette::view::draw(frame, palette, app.document.model(), theme)
        }
        Overlay::Presets(list) => draw_presets(frame, *list, theme),
        Overlay::Recovery { lost, list } => {
            confirm::draw_recovery(frame, lost, *list, answers(Scope::Recovery), theme)
        }
    };
    (Some(list), Some(rows))
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
