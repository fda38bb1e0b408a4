//! A table below the chart: numbers in columns, one row selected.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

use super::text::{cut, width};
use crate::tui::app::{List, Rows};
use crate::tui::theme::Theme;
use crate::unit::FrequencyUnit;

/// Rows beside those of the list: the rule with the title, and the heading.
pub(crate) const FRAME_ROWS: u16 = 2;

/// A column: its heading, and how many cells it takes with the space before it.
pub(crate) type Column = (&'static str, usize);

/// The heading of a column of frequencies, which have the unit that is shown.
pub(crate) const FREQUENCY: &str = "frequency";

/// What a table says.
pub(crate) struct Content<'a> {
    /// In the rule.
    pub(crate) title: String,
    /// Whether the title is bad news.
    pub(crate) warns: bool,
    /// The unit of its frequencies.
    pub(crate) frequency_unit: FrequencyUnit,
    /// At the right of the rule.
    pub(crate) note: String,
    /// The columns.
    pub(crate) columns: &'a [Column],
    /// The cells of a row, right-aligned, as many as columns; or one sentence.
    pub(crate) row: &'a dyn Fn(usize) -> Vec<String>,
    /// Where there are no rows.
    pub(crate) empty: &'a str,
    /// The rows are older than the model.
    pub(crate) stale: bool,
}

/// The widest of some layouts that fits; the last one where none does.
pub(crate) fn fitting(layouts: &[&'static [Column]], columns: u16) -> &'static [Column] {
    let fits = |layout: &&&'static [Column]| {
        layout.iter().map(|column| column.1).sum::<usize>() <= usize::from(columns)
    };
    layouts
        .iter()
        .find(fits)
        .or(layouts.last())
        .copied()
        .unwrap_or_default()
}

/// Columns whose first one, of names, has the room that is left of `room`, as far as its longest name needs it.
pub(crate) fn widened(columns: &[Column], longest: usize, room: u16) -> Vec<Column> {
    let mut columns = columns.to_vec();
    let taken: usize = columns.iter().map(|column| column.1).sum();
    let left = usize::from(room).saturating_sub(taken);
    if let Some((_, name)) = columns.first_mut() {
        *name += left.min((longest + 1).saturating_sub(*name));
    }
    columns
}

/// How many cells a title may take in a table with so many columns.
pub(crate) fn title_room(columns: u16) -> usize {
    usize::from(columns).saturating_sub(4)
}

/// Draws a table and sets how many rows of its list there is room for; where they are.
pub(crate) fn draw(
    frame: &mut Frame<'_>,
    content: &Content<'_>,
    list: &mut List,
    theme: Theme,
    area: Rect,
) -> Rows {
    let columns = usize::from(area.width);
    let title = cut(&content.title, title_room(area.width));
    let mut rule = super::frame::rule(&title, theme);
    if content.warns {
        rule.spans[1].style = theme.refusal();
    }
    let note = Line::styled(format!(" {} ", content.note), theme.dim());
    let note = Some(note).filter(|_| !content.note.is_empty());
    let block =
        super::frame::panel(rule, note.unwrap_or_default(), area.width).border_style(theme.dim());
    let inside = block.inner(area);
    frame.render_widget(block, area);
    let mut lines = inside.rows();
    let Some(heading) = lines.next() else {
        return Rows::default();
    };
    list.height = usize::from(inside.height).saturating_sub(1).max(1);
    if list.rows == 0 {
        let text = cut(&format!(" {}", content.empty), columns);
        frame.render_widget(Line::styled(text, theme.dim()), heading);
        return Rows::default();
    }
    let names = content.columns.iter().map(|(name, _)| match *name {
        FREQUENCY => content.frequency_unit.symbol().to_owned(),
        name => name.to_owned(),
    });
    draw_row(frame, content, names, theme.dim(), heading);
    let style = if content.stale {
        theme.dim()
    } else {
        Style::new()
    };
    let first = list.first();
    for (line, row) in lines.zip(first..list.rows) {
        draw_row(frame, content, (content.row)(row).into_iter(), style, line);
        if row == list.row {
            frame.buffer_mut().set_style(line, theme.selection());
        }
    }
    let area = Rect {
        y: inside.y + 1,
        height: inside.height - 1,
        ..inside
    };
    Rows { area, first }
}

fn draw_row(
    frame: &mut Frame<'_>,
    content: &Content<'_>,
    cells: impl Iterator<Item = String>,
    style: Style,
    line: Rect,
) {
    let cells: Vec<String> = cells.collect();
    // A sentence takes the whole line.
    if let ([sentence], true) = (cells.as_slice(), content.columns.len() > 1) {
        let text = cut(&format!(" {sentence}"), usize::from(line.width));
        return frame.render_widget(Line::styled(text, style), line);
    }
    let cells = content.columns.iter().zip(cells);
    let spans = cells.map(|((_, columns), text)| {
        let text = cut(&text, columns.saturating_sub(1));
        let blank = " ".repeat(columns.saturating_sub(width(&text)));
        Span::styled(format!("{blank}{text}"), style)
    });
    frame.render_widget(spans.collect::<Line<'_>>(), line);
}
