//! The palette: an input line, and what it finds.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::text::{Line, Span};

use crate::model::{Model, grouped};
use crate::tui::app::{Entry, Found, List, Palette, Rows};
use crate::tui::panels::prompt::view::draw_input;
use crate::tui::theme::Theme;
use crate::tui::tree;
use crate::tui::view::dialog_box::{middle, open_dialog};
use crate::tui::view::text::{cut, width};

/// Columns of the widest name of a command.
const NAMES: usize = 19;
/// The largest number of results.
const MOST_LINES: usize = 16;

/// Draws the palette; returns its list with the number of visible rows, and its area.
pub(crate) fn draw(
    frame: &mut Frame<'_>,
    palette: &Palette,
    model: &Model,
    theme: Theme,
) -> (List, Rows) {
    let mut list = palette.list;
    let (count, subject) = (list.rows, palette.subject);
    let title = match count {
        0 => format!(" {subject}: none found "),
        _ => format!(" {subject}  {} of {} ", list.row + 1, grouped(count)),
    };
    let place = middle(frame.area(), MOST_LINES + 1);
    let inside = open_dialog(frame, place, &title, theme);
    let [line, rest] = Layout::vertical([Constraint::Length(1), Constraint::Fill(1)]).areas(inside);
    let mark = Rect {
        width: 2.min(line.width),
        ..line
    };
    frame.render_widget(Span::styled("> ", theme.key()), mark);
    let typed = Rect {
        x: line.x + mark.width,
        width: line.width - mark.width,
        ..line
    };
    draw_input(frame, &palette.input, typed);
    list.height = usize::from(rest.height).max(1);
    let first = list.first();
    let entries = palette.found().enumerate().skip(first);
    for (area, (row, entry)) in rest.rows().zip(entries) {
        frame.render_widget(
            entry_line(entry, model, theme, usize::from(area.width)),
            area,
        );
        if row == list.row {
            frame.buffer_mut().set_style(area, theme.selection());
        }
    }
    (list, Rows { area: rest, first })
}

/// A command with its description and keys, a chapter with its summary, or a row of the tree with its value.
fn entry_line(entry: &Entry, model: &Model, theme: Theme, columns: usize) -> Line<'static> {
    let (description, right) = match entry.found {
        Found::Command(_) | Found::Chapter(_) => (entry.help, entry.keys.clone()),
        Found::Row(node) => ("", tree::value(model, node)),
    };
    let right = cut(&right, columns / 2);
    let room = columns.saturating_sub(width(&right) + 1);
    let name = match description {
        "" => cut(&entry.name, room),
        _ => format!("{:<NAMES$}", cut(&entry.name, NAMES.min(room))),
    };
    let description = cut(description, room.saturating_sub(width(&name) + 1));
    let blank = " ".repeat((room + 1).saturating_sub(width(&name) + 1 + width(&description)));
    Line::from(vec![
        Span::styled(name, theme.key()),
        Span::styled(format!(" {description}{blank}"), theme.dim()),
        Span::raw(right),
    ])
}
