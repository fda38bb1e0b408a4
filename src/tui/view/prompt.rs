//! The box in which a value, a name or a path is typed.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Position, Rect};
use ratatui::text::Line;
use ratatui::widgets::Paragraph;
use tui_input::Input;

use super::Panels;
use super::boxes::open_box;
use super::text::{cut, wrapped};
use crate::escape::escape;
use crate::model::entry;
use crate::tui::app::{App, AskedKind, Prompt, Purpose, Question};
use crate::tui::theme::Theme;

/// The row below the selected one of the tree; the top where the tree does not show.
pub(super) fn row_below(app: &App, panels: &Panels) -> u16 {
    if panels.tree.height == 0 {
        return 0;
    }
    let (rows, offset) = app.selection.rows();
    let row = app.selection.cursor().saturating_sub(offset);
    panels.tree.y + 2 + row.min(rows.len()) as u16
}

/// Draws the box under the selected row.
pub(super) fn draw(
    frame: &mut Frame<'_>,
    prompt: &Prompt,
    complete: &str,
    theme: Theme,
    below: u16,
) {
    let area = frame.area();
    let (title, allowed) = prompt_words(&prompt.purpose, complete);
    let preview = match &prompt.purpose {
        Purpose::Ask(Question::Columns { preview, .. }) => preview.as_slice(),
        _ => &[],
    };
    let columns = 56.min(area.width.saturating_sub(2));
    let text = usize::from(columns.saturating_sub(4));
    let (mut lines, style) = match &prompt.refusal {
        Some(refusal) => (wrapped(refusal, text), theme.refusal()),
        None => (wrapped(&allowed, text), theme.dim()),
    };
    // The rows come first: the words may be more than the screen has room for.
    lines.splice(0..0, preview.iter().map(|line| cut(line, text)));
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
        Purpose::Ask(question) => question.words(complete),
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

/// The typed line, hidden characters escaped, with the terminal's cursor in it.
pub(super) fn draw_input(frame: &mut Frame<'_>, input: &Input, area: Rect) {
    let before: String = input.value().chars().take(input.cursor()).collect();
    let input =
        Input::new(escape(input.value()).into_owned()).with_cursor(escape(&before).chars().count());
    let room = usize::from(area.width.max(1) - 1);
    let scroll = input.visual_scroll(room);
    let line = Paragraph::new(input.value()).scroll((0, scroll as u16));
    frame.render_widget(line, area);
    let column = input.visual_cursor().saturating_sub(scroll) as u16;
    frame.set_cursor_position(Position::new(area.x + column, area.y));
}
