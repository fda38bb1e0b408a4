//! The dialog to type a value, a name or a path.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Position, Rect};
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;
use tui_input::Input;

use crate::escape::escape;
use crate::model::value_input;
use crate::tui::app::{App, AskedKind, Prompt, Purpose, Question};
use crate::tui::theme::Theme;
use crate::tui::view::dialog_box::open_dialog;
use crate::tui::view::frame::block_inside;
use crate::tui::view::layout::Panels;
use crate::tui::view::text::{cut, width, wrapped};

/// Columns of a dialog with a short text.
const COLUMNS: u16 = 56;

/// Rows for the typed text; of more, those around the cursor are visible.
const MOST_ROWS: usize = 5;

/// The row below the selected one of the tree; the top row if the tree is hidden.
pub(crate) fn row_below(app: &App, panels: &Panels) -> u16 {
    if panels.tree.height == 0 {
        return 0;
    }
    let height = block_inside(panels.tree).height;
    let first = app.selection.first_shown(height.into());
    let row = app.selection.cursor().saturating_sub(first);
    panels.tree.y + 2 + row.min(app.selection.rows().len()) as u16
}

/// Draws the dialog below the selected row.
pub(crate) fn draw(
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
    let most = area.width.saturating_sub(2);
    // A long text widens the dialog, then wraps.
    let wanted = width(prompt.input.value()).min(usize::from(most)) as u16 + 5;
    let columns = wanted.max(COLUMNS).min(most);
    let text = usize::from(columns.saturating_sub(4));
    let typed = Typed::new(&prompt.input, text);
    let typed_rows = typed.rows.len().min(MOST_ROWS) as u16;
    let (mut lines, style) = match &prompt.refusal {
        Some(refusal) => (wrapped(refusal, text), theme.refusal()),
        None => (wrapped(&allowed, text), theme.dim()),
    };
    // The typed rows come first: the help may be longer than the screen.
    lines.splice(0..0, preview.iter().map(|line| cut(line, text)));
    let height = lines.len() as u16 + 2 + typed_rows;
    // Below the selected row, or above it if there is no room; always on the screen.
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
    let inside = open_dialog(frame, place, &title, theme);
    let parts = [Constraint::Length(typed_rows), Constraint::Fill(1)];
    let [above, rest] = Layout::vertical(parts).areas(inside);
    let replaced = prompt.replaceable.then(|| theme.selection());
    typed.draw(frame, above, replaced.unwrap_or_default());
    let lines: Vec<Line<'_>> = lines
        .into_iter()
        .map(|line| Line::styled(line, style))
        .collect();
    frame.render_widget(Paragraph::new(lines), rest);
}

/// The title of a prompt, and what can be typed.
fn prompt_words(purpose: &Purpose, complete: &str) -> (String, String) {
    let path = || format!("path; {complete} completes it");
    match purpose {
        Purpose::Ask(question) => question.words(complete),
        Purpose::Open => (" Open a file ".to_owned(), path()),
        Purpose::SaveAs => (" Save as ".to_owned(), path()),
        Purpose::Value(asked) => {
            let allowed = match &asked.kind {
                AskedKind::Number(_, unit) => {
                    format!("{}: {}", asked.range, value_input::accepted(unit))
                }
                AskedKind::Count(_) => format!("{}; or a change (*2, /2, +5%)", asked.range),
                AskedKind::Text => asked.range.clone(),
            };
            (format!(" {} ", asked.subject), allowed)
        }
    }
}

/// The typed text in rows, hidden characters escaped.
struct Typed {
    rows: Vec<String>,
    /// The column and the row of the cursor.
    cursor: [usize; 2],
}

impl Typed {
    fn new(input: &Input, columns: usize) -> Self {
        let rows = rows(&escape(input.value()), columns);
        let before: String = input.value().chars().take(input.cursor()).collect();
        let before = self::rows(&escape(&before), columns);
        let row = before.len() - 1;
        let column = before.last().map_or(0, |row| width(row));
        let mut typed = Self {
            rows,
            cursor: [column, row],
        };
        if column == columns.max(1) {
            typed.cursor = [0, row + 1];
        }
        if typed.cursor[1] == typed.rows.len() {
            typed.rows.push(String::new());
        }
        typed
    }

    /// The visible rows, with that of the cursor among them.
    fn draw(&self, frame: &mut Frame<'_>, area: Rect, style: Style) {
        let [column, row] = self.cursor;
        let first = (row + 1).saturating_sub(usize::from(area.height));
        for (text, line) in self.rows.iter().skip(first).zip(area.rows()) {
            frame.render_widget(Span::styled(text.as_str(), style), line);
        }
        let place = [column, row - first].map(|place| place as u16);
        frame.set_cursor_position(Position::new(area.x + place[0], area.y + place[1]));
    }
}

/// A text in rows of a width in columns, broken where a row ends; at least one row.
fn rows(text: &str, columns: usize) -> Vec<String> {
    let mut rows = vec![String::new()];
    let mut taken = 0;
    for c in text.chars() {
        let next = width(c.encode_utf8(&mut [0; 4]));
        if taken + next > columns && taken > 0 {
            rows.push(String::new());
            taken = 0;
        }
        taken += next;
        if let Some(row) = rows.last_mut() {
            row.push(c);
        }
    }
    rows
}

/// The typed line, hidden characters escaped, with the terminal's cursor in it.
pub(crate) fn draw_input(frame: &mut Frame<'_>, input: &Input, area: Rect) {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_text_goes_on_below_with_the_cursor_where_it_is_typed() {
        let typed = |text: &str, cursor| {
            let input = Input::new(text.to_owned()).with_cursor(cursor);
            let typed = Typed::new(&input, 4);
            (typed.rows, typed.cursor)
        };
        let rows = |rows: &[&str]| rows.iter().map(|row| (*row).to_owned()).collect::<Vec<_>>();
        assert_eq!(typed("", 0), (rows(&[""]), [0, 0]));
        assert_eq!(typed("abc", 3), (rows(&["abc"]), [3, 0]));
        assert_eq!(typed("abcd", 4), (rows(&["abcd", ""]), [0, 1]));
        assert_eq!(typed("abcdef", 6), (rows(&["abcd", "ef"]), [2, 1]));
        assert_eq!(typed("abcdef", 4), (rows(&["abcd", "ef"]), [0, 1]));
        // Two columns per character.
        assert_eq!(
            typed("abc\u{4e2d}", 4),
            (rows(&["abc", "\u{4e2d}"]), [2, 1])
        );
    }
}
