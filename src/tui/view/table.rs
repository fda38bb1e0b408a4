//! A table below the chart: columns of a list of rows, one row selected.

use std::borrow::Cow;

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

use super::text::{cut, width};
use crate::tui::app::{App, List, Rows};

/// Rows in addition to those of the list: the rule with the title, and the heading.
pub(crate) const FRAME_ROWS: u16 = 2;

/// A column of a table with rows of type `R`.
pub(crate) struct Column<R> {
    kind: Kind,
    /// For each layout, from the widest on: the heading and the cells it takes with the space before it. [`NONE`] or
    /// nothing if the layout does not have the column.
    headings: &'static [(&'static str, usize)],
    /// The text of a row.
    cell: fn(&App, &R) -> String,
}

/// The heading of a column that a layout does not have.
pub(crate) const NONE: (&str, usize) = ("", 0);

/// How a column is shown.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    /// Right-aligned.
    Plain,
    /// The same; the heading is the displayed unit.
    Frequency,
    /// The same, at least as wide as the longest text.
    Whole,
    /// Left-aligned; wider for the longest text if the table leaves room.
    Name,
}

pub(crate) const fn column<R>(
    kind: Kind,
    headings: &'static [(&'static str, usize)],
    cell: fn(&App, &R) -> String,
) -> Column<R> {
    Column {
        kind,
        headings,
        cell,
    }
}

/// What a table shows.
pub(crate) struct Content<'a, R> {
    /// In the rule.
    pub(crate) title: String,
    /// Whether the title is a warning.
    pub(crate) warns: bool,
    /// At the right of the rule.
    pub(crate) note: String,
    /// The columns.
    pub(crate) columns: &'a [Column<R>],
    /// The rows.
    pub(crate) rows: &'a [R],
    /// Sentences below them, one per line.
    pub(crate) sentences: Vec<String>,
    /// Shown if there are no rows.
    pub(crate) empty: Cow<'a, str>,
    /// The rows are older than the model.
    pub(crate) stale: bool,
}

/// A column of the layout that is shown.
struct Placed<'a, R> {
    column: &'a Column<R>,
    heading: &'static str,
    width: usize,
}

impl<R> Content<'_, R> {
    /// The first layout that fits in this number of cells, or the last.
    fn layout<'a>(&'a self, app: &'a App, room: usize) -> Vec<Placed<'a, R>> {
        let layouts = self.columns.iter().map(|column| column.headings.len());
        let mut placed = Vec::new();
        for layout in 0..layouts.max().unwrap_or(0) {
            let columns = self.columns.iter();
            placed = columns
                .filter_map(|column| self.placed(app, column, layout))
                .collect();
            if taken(&placed) <= room {
                break;
            }
        }
        let left = room.saturating_sub(taken(&placed));
        for one in &mut placed {
            if one.column.kind == Kind::Name {
                one.width += left.min(self.longest(app, one.column).saturating_sub(one.width));
            }
        }
        placed
    }

    fn placed<'a>(
        &self,
        app: &'a App,
        column: &'a Column<R>,
        layout: usize,
    ) -> Option<Placed<'a, R>> {
        let (mut heading, mut width) = *column
            .headings
            .get(layout)
            .filter(|(_, width)| *width > 0)?;
        match column.kind {
            Kind::Plain | Kind::Name => {}
            Kind::Frequency => heading = app.display.unit.symbol(),
            Kind::Whole => width = width.max(self.longest(app, column)),
        }
        Some(Placed {
            column,
            heading,
            width,
        })
    }

    /// The width that the longest text of a column needs.
    fn longest(&self, app: &App, column: &Column<R>) -> usize {
        let texts = self.rows.iter().map(|row| (column.cell)(app, row));
        texts.map(|text| width(&text) + 1).max().unwrap_or(0)
    }
}

fn taken<R>(placed: &[Placed<'_, R>]) -> usize {
    placed.iter().map(|one| one.width).sum()
}

/// How many cells a title may take in a table of this width.
pub(crate) fn title_room(columns: u16) -> usize {
    usize::from(columns).saturating_sub(4)
}

/// Draws a table and sets the visible height of its list; returns the positions of the rows.
pub(crate) fn draw<R>(
    frame: &mut Frame<'_>,
    app: &App,
    content: &Content<'_, R>,
    list: &mut List,
    area: Rect,
) -> Rows {
    let dim = app.theme.dim();
    let inside = draw_rule(frame, app, content, area);
    let mut lines = inside.rows();
    let Some(heading) = lines.next() else {
        return Rows::default();
    };
    list.height = usize::from(inside.height).saturating_sub(1).max(1);
    if list.rows == 0 {
        let text = cut(&format!(" {}", content.empty), area.width.into());
        frame.render_widget(Line::styled(text, dim), heading);
        return Rows::default();
    }
    let layout = content.layout(app, area.width.into());
    let headings = layout
        .iter()
        .map(|one| aligned(one.heading, one.width, Kind::Plain));
    frame.render_widget(Span::styled(headings.collect::<String>(), dim), heading);
    let style = if content.stale { dim } else { Style::new() };
    let first = list.first();
    for (line, index) in lines.zip(first..list.rows) {
        if let Some(row) = content.rows.get(index) {
            let text = |one: &Placed<'_, R>| (one.column.cell)(app, row);
            let cells = layout
                .iter()
                .map(|one| aligned(&text(one), one.width, one.column.kind));
            frame.render_widget(Span::styled(cells.collect::<String>(), style), line);
        } else if let Some(sentence) = content.sentences.get(index - content.rows.len()) {
            let text = cut(&format!(" {sentence}"), line.width.into());
            frame.render_widget(Line::styled(text, style), line);
        }
        if index == list.row {
            frame.buffer_mut().set_style(line, app.theme.selection());
        }
    }
    let area = Rect {
        y: inside.y + 1,
        height: inside.height - 1,
        ..inside
    };
    Rows { area, first }
}

/// Draws the rule with title and note; returns the area below it.
fn draw_rule<R>(frame: &mut Frame<'_>, app: &App, content: &Content<'_, R>, area: Rect) -> Rect {
    let theme = app.theme;
    let title = cut(&content.title, title_room(area.width));
    let mut rule = super::frame::rule(&title, theme);
    if content.warns {
        rule.spans[1].style = theme.refusal();
    }
    let note = match content.note.as_str() {
        "" => Line::default(),
        note => Line::styled(format!(" {note} "), theme.dim()),
    };
    let block = super::frame::panel(rule, note, area.width).border_style(theme.dim());
    let inside = block.inner(area);
    frame.render_widget(block, area);
    inside
}

/// A text in this number of cells, at least one of them blank before it.
fn aligned(text: &str, columns: usize, kind: Kind) -> String {
    let text = cut(text, columns.saturating_sub(1));
    let blank = " ".repeat(columns.saturating_sub(width(&text) + 1));
    match kind {
        Kind::Name => format!(" {text}{blank}"),
        Kind::Plain | Kind::Frequency | Kind::Whole => format!("{blank} {text}"),
    }
}
