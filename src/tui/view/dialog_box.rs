//! The frame of a dialog: its area on the screen, its border, and scrollable lines of text.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Clear, Padding, Paragraph};

use super::text::cut;
use crate::tui::app::List;
use crate::tui::theme::Theme;

/// The largest width of a dialog, in columns.
const WIDEST: u16 = 72;
/// Columns of its border and of the blanks inside it.
pub(crate) const FRAME: u16 = 4;

/// Columns of text in a centred dialog.
pub(crate) fn dialog_width(area: Rect) -> u16 {
    area.width.min(WIDEST).saturating_sub(FRAME)
}

/// Clears an area and draws a border around it; returns the area inside.
pub(crate) fn open_dialog(frame: &mut Frame<'_>, area: Rect, title: &str, theme: Theme) -> Rect {
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

/// A centred dialog with room for this number of lines.
pub(crate) fn middle(area: Rect, lines: usize) -> Rect {
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

/// Draws scrollable lines; returns their number and the number of visible rows.
pub(crate) fn draw_reader(
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
