//! The frame around the curves: axes, labels, units and the title.

use std::ops::Range;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::chart::{Below, Chart};
use super::glyphs::{Glyphs, put, width};
use super::layout::ChartLayout;
use super::ticks::label_span;

/// The characters of the axes.
struct AxisLines {
    vertical: char,
    horizontal: char,
    corner: char,
    /// Major ticks point to their labels, minor ticks into the plot.
    value_ticks: [char; 2],
    abscissa_ticks: [char; 2],
    /// The line, major ticks and minor ticks within the band.
    band: [char; 3],
    /// The first and the second cursor on an axis with labels.
    cursors: [char; 2],
    /// The same on an axis without labels.
    passing: [char; 2],
    /// The mark on the axis itself.
    mark: char,
    /// One, two, and more marks in a column.
    marks: [char; 3],
}

const BOX_LINES: AxisLines = AxisLines {
    vertical: '│',
    horizontal: '─',
    corner: '└',
    value_ticks: ['┤', '├'],
    abscissa_ticks: ['┬', '┴'],
    band: ['━', '┯', '┷'],
    cursors: ['▲', '△'],
    passing: ['┼', '┼'],
    mark: '╫',
    marks: ['╵', '╹', '┃'],
};

const ASCII_LINES: AxisLines = AxisLines {
    vertical: '|',
    horizontal: '-',
    corner: '+',
    value_ticks: ['+', '-'],
    abscissa_ticks: ['+', '|'],
    band: ['=', '#', '='],
    cursors: ['^', 'A'],
    passing: ['|', ':'],
    mark: '!',
    marks: ['\'', '"', '#'],
};

/// Draws all parts around the plot.
pub(super) fn draw(chart: &Chart<'_>, layout: &ChartLayout, buffer: &mut Buffer) {
    let lines = if chart.glyphs == Glyphs::Ascii {
        &ASCII_LINES
    } else {
        &BOX_LINES
    };
    draw_heading(chart, layout, buffer);
    draw_value_axis(chart, layout, lines, buffer);
    if layout.rows_below > 0 {
        draw_abscissa_axis(chart, layout, lines, buffer);
    }
    if layout.rows_below > 1 {
        draw_abscissa_labels(chart, layout, buffer);
    }
    if layout.rows_below > 2 {
        draw_marks(chart, layout, lines, buffer);
    }
}

/// Draws the row of marks: one tick per mark, a heavier one where several share a column.
fn draw_marks(chart: &Chart<'_>, layout: &ChartLayout, lines: &AxisLines, buffer: &mut Buffer) {
    let (plot, styles) = (layout.plot, &chart.styles);
    let y = plot.bottom() + 2;
    let name = Rect::new(layout.area.x, y, plot.x - layout.area.x, 1);
    if width(chart.marks.name) <= name.width {
        put(buffer, name, chart.marks.name, (chart.glyphs, styles.mark));
    }
    let mut counts = vec![0_usize; usize::from(plot.width)];
    let cells = chart.marks.values.iter().map(|x| chart.cell(plot, *x));
    cells
        .flatten()
        .for_each(|cell| counts[usize::from(cell)] += 1);
    for (x, count) in (plot.x..).zip(counts) {
        if count > 0 {
            set(buffer, x, y, lines.marks[count.min(3) - 1], styles.mark);
        }
    }
    let selected = chart.marks.selected.and_then(|i| chart.marks.values.get(i));
    if let Some(cell) = selected.and_then(|x| chart.cell(plot, *x))
        && let Some(cell) = buffer.cell_mut((plot.x + cell, y))
    {
        cell.set_style(styles.selected_mark);
    }
}

fn draw_heading(chart: &Chart<'_>, layout: &ChartLayout, buffer: &mut Buffer) {
    let Some(row) = layout.heading else {
        return;
    };
    let unit = &chart.y.unit;
    put(buffer, row, unit, (chart.glyphs, chart.styles.label));
    let after_unit = if unit.is_empty() {
        row.x
    } else {
        row.x.saturating_add(width(unit) + 2)
    };
    let x = layout.plot.x.max(after_unit).min(row.right());
    let title = Rect {
        x,
        width: row.right() - x,
        ..row
    };
    put(
        buffer,
        title,
        &chart.title,
        (chart.glyphs, chart.styles.title),
    );
}

fn draw_value_axis(
    chart: &Chart<'_>,
    layout: &ChartLayout,
    lines: &AxisLines,
    buffer: &mut Buffer,
) {
    let Some(x) = layout.value_axis else {
        return;
    };
    let plot = layout.plot;
    for y in plot.top()..plot.bottom() {
        set(buffer, x, y, lines.vertical, chart.styles.axis);
    }
    if layout.rows_below > 0 {
        set(buffer, x, plot.bottom(), lines.corner, chart.styles.axis);
    }
    for tick in &layout.ticks[1] {
        let y = plot.y + tick.cell;
        set(
            buffer,
            x,
            y,
            lines.value_ticks[usize::from(tick.label.is_none())],
            chart.styles.axis,
        );
        if let Some(label) = &tick.label {
            let start = x.saturating_sub(label.len() as u16).max(layout.area.x);
            let row = Rect::new(start, y, layout.label_columns, 1);
            put(buffer, row, label, (chart.glyphs, chart.styles.label));
        }
    }
}

fn draw_abscissa_axis(
    chart: &Chart<'_>,
    layout: &ChartLayout,
    lines: &AxisLines,
    buffer: &mut Buffer,
) {
    let (plot, styles) = (layout.plot, &chart.styles);
    let signs = match chart.below {
        Below::All => lines.cursors,
        Below::Axis => lines.passing,
    };
    let cursors = [chart.cursor, chart.second].map(|value| chart.cell(plot, value?));
    let band = chart.band.map(|band| band_cells(chart, layout, band));
    let mark = chart
        .axis_mark
        .and_then(|mark| chart.cell(plot, mark.value));
    for column in 0..plot.width {
        let tick = layout.ticks[0].iter().find(|tick| tick.cell == column);
        // 0: no tick, 1: major, 2: minor.
        let kind = tick.map_or(0, |tick| 1 + usize::from(tick.label.is_none()));
        let cursor = cursors.iter().position(|cell| *cell == Some(column));
        let (glyph, style) = match cursor {
            Some(cursor) => (signs[cursor], styles.cursor),
            None if mark == Some(column) => (lines.mark, styles.mark),
            None if band.as_ref().is_some_and(|band| band.contains(&column)) => {
                (lines.band[kind], styles.band)
            }
            None if kind == 0 => (lines.horizontal, styles.axis),
            None => (lines.abscissa_ticks[kind - 1], styles.axis),
        };
        set(buffer, plot.x + column, plot.bottom(), glyph, style);
    }
}

/// The columns of the part of the band on the axis.
fn band_cells(chart: &Chart<'_>, layout: &ChartLayout, [low, high]: [f64; 2]) -> Range<u16> {
    let [from, to] = chart.x.bounds();
    if high < from || low > to {
        return 0..0;
    }
    let cell = |value: f64| chart.cell(layout.plot, value.clamp(from, to)).unwrap_or(0);
    cell(low)..cell(high) + 1
}

fn draw_abscissa_labels(chart: &Chart<'_>, layout: &ChartLayout, buffer: &mut Buffer) {
    let y = layout.plot.bottom() + 1;
    let mut labels = placed_labels(layout);
    let unit = width(&chart.x.unit);
    if unit > 0 && unit < layout.area.width {
        let x = unit_column(layout.area, unit, &mut labels);
        put(
            buffer,
            Rect::new(x, y, unit, 1),
            &chart.x.unit,
            (chart.glyphs, chart.styles.label),
        );
    }
    for (x, label) in &labels {
        let row = Rect::new(*x, y, label.len() as u16, 1);
        put(buffer, row, label, (chart.glyphs, chart.styles.label));
    }
    if let Some((x, label)) = mark_label(chart, layout, buffer) {
        let row = Rect::new(x, y, width(label), 1);
        put(buffer, row, label, (chart.glyphs, chart.styles.axis));
    }
}

/// The label of the mark on the axis and its column: the longest one that fits into the row of labels below the mark,
/// as near to its middle as the others allow, and touches none of them.
fn mark_label(
    chart: &Chart<'_>,
    layout: &ChartLayout,
    buffer: &Buffer,
) -> Option<(u16, &'static str)> {
    let mark = chart.axis_mark?;
    let column = layout.plot.x + chart.cell(layout.plot, mark.value)?;
    let (left, right) = (layout.area.left(), layout.area.right());
    let is_free = |x: u16| buffer[(x, layout.plot.bottom() + 1)].symbol() == " ";
    mark.labels.iter().find_map(|label| {
        let columns = width(label);
        let fits = |start: &u16| {
            let around = start.saturating_sub(1).max(left)..(start + columns + 1).min(right);
            *start >= left && start + columns <= right && around.into_iter().all(is_free)
        };
        let starts = (column + 1).saturating_sub(columns)..=column;
        let middle = column.saturating_sub((columns - 1) / 2);
        let start = starts
            .filter(fits)
            .min_by_key(|start| start.abs_diff(middle))?;
        Some((start, *label))
    })
}

/// The labels below the plot and their columns, without those that would touch an earlier one.
fn placed_labels(layout: &ChartLayout) -> Vec<(u16, &str)> {
    let (left, right) = (
        i32::from(layout.area.left()),
        i32::from(layout.area.right()),
    );
    let mut free = left;
    let mut labels = Vec::new();
    for tick in &layout.ticks[0] {
        let Some(label) = tick.label.as_deref() else {
            continue;
        };
        let (offset, columns) = label_span(label, tick.cell);
        let columns = i32::from(columns);
        // At the ends a label may shift as long as it stays below its tick.
        let start = (i32::from(layout.plot.x) + offset)
            .min(right - columns)
            .max(left);
        let column = i32::from(layout.plot.x + tick.cell);
        let below = (start..start + columns).contains(&column) && start + columns <= right;
        if below && start >= free {
            labels.push((start as u16, label));
            free = start + columns + 1;
        }
    }
    labels
}

/// The column of the unit: after the last label, before it (as in DIN 461), or instead of it.
fn unit_column(area: Rect, unit: u16, labels: &mut Vec<(u16, &str)>) -> u16 {
    let end = |(x, label): &(u16, &str)| x + label.len() as u16;
    let at_end = area.right() - unit;
    let [.., before, last] = labels.as_slice() else {
        labels.retain(|label| end(label) < at_end);
        return at_end;
    };
    if end(last) < at_end {
        return at_end;
    }
    if end(before) + 1 + unit < last.0 {
        return end(before).midpoint(last.0 - unit);
    }
    labels.retain(|label| end(label) < at_end);
    at_end
}

fn set(buffer: &mut Buffer, x: u16, y: u16, glyph: char, style: Style) {
    if let Some(cell) = buffer.cell_mut((x, y)) {
        cell.set_char(glyph).set_style(style);
    }
}
