//! The legend: the line sample, marker and label of each curve.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::symbols::Marker;

use super::chart::{Chart, Legend};
use super::curve::{Curve, LineStyle};
use super::glyphs::{Glyphs, put, width};
use crate::escape::escape;

/// Columns of a line sample and the space after it.
const SAMPLE: u16 = 4;
/// Columns, and characters, of the marker of another curve in an entry and the space after it.
const SHARED: usize = 2;
/// Columns between the entries of a one-line legend.
const GAP: u16 = 2;
/// Fewest columns of a shortened label; without room for them there is no legend.
const SHORTEST: u16 = 3;
/// Fewest rows of the plot below a one-line legend.
const SHORTEST_PLOT: u16 = 3;
/// Largest part of the plot that a legend inside it may cover, in percent.
const MOST_COVERED: u32 = 40;

/// The position of the legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LegendPosition {
    Nowhere,
    Inside(Rect),
    Line(Rect),
}

struct LegendEntry {
    sample: String,
    /// The markers of curves that share the entry, each with a space after it, then the name.
    label: String,
    style: Style,
    /// The styles of those markers.
    shared: Vec<Style>,
}

fn entries(chart: &Chart<'_>) -> Vec<LegendEntry> {
    let mut entries: Vec<LegendEntry> = Vec::new();
    for (index, curve) in chart.curves.iter().enumerate() {
        if !curve.label.is_empty() {
            entries.push(entry(chart, index, curve));
        } else if let Some(entry) = entries.last_mut()
            && curve.shares_entry
            && let Some(marker) = chart.marker(index)
        {
            let skipped = SHARED * entry.shared.len();
            let at = entry
                .label
                .char_indices()
                .nth(skipped)
                .map_or(0, |(at, _)| at);
            entry.label.insert_str(at, &format!("{marker} "));
            entry.shared.push(curve.dimmed_style());
        }
    }
    entries
}

fn entry(chart: &Chart<'_>, index: usize, curve: &Curve<'_>) -> LegendEntry {
    let body = match (chart.grid_of(index), curve.line) {
        (_, LineStyle::Points { .. }) => ' ',
        (Marker::Custom(body), _) => body,
        (_, LineStyle::Solid) => '─',
        (_, LineStyle::Dashed) => '╌',
        (_, LineStyle::Dotted) => '┈',
    };
    let marker = chart.marker(index).unwrap_or(body);
    LegendEntry {
        sample: [body, marker, body].iter().collect(),
        label: curve.label.clone(),
        style: curve.dimmed_style(),
        shared: Vec::new(),
    }
}

/// Finds the position of the legend: inside `plot`, or in the top row of `around`, the plot with its axis.
pub(super) fn position(chart: &Chart<'_>, plot: Rect, around: Rect) -> LegendPosition {
    let entries = entries(chart);
    if entries.is_empty() || chart.legend == Legend::Hidden {
        return LegendPosition::Nowhere;
    }
    let widest = entries
        .iter()
        .map(|entry| width(&entry.label))
        .max()
        .unwrap_or(0);
    // One blank column separates the curves from the samples.
    let columns = (1 + SAMPLE + widest).min(plot.width / 2);
    let rows = entries.len() as u16;
    let covered = u32::from(columns) * u32::from(rows) * 100;
    let fits = columns > SAMPLE + widest.min(SHORTEST)
        && rows <= plot.height
        && covered <= plot.area() * MOST_COVERED;
    if fits && chart.legend == Legend::Inside {
        return LegendPosition::Inside(Rect {
            x: plot.right() - columns,
            width: columns,
            height: rows,
            ..plot
        });
    }
    if around.height > SHORTEST_PLOT
        && longest_label(&entries, around.width) >= widest.min(SHORTEST)
    {
        return LegendPosition::Line(Rect {
            height: 1,
            ..around
        });
    }
    LegendPosition::Nowhere
}

/// Draws the legend at its position.
pub(super) fn draw(chart: &Chart<'_>, position: LegendPosition, buffer: &mut Buffer) {
    let entries = entries(chart);
    match position {
        LegendPosition::Nowhere => {}
        LegendPosition::Inside(area) => {
            for (entry, row) in entries.iter().zip(area.rows()) {
                let row = Rect {
                    x: row.x + 1,
                    width: row.width - 1,
                    ..row
                };
                draw_entry(chart, entry, row, buffer);
            }
        }
        LegendPosition::Line(row) => draw_line(chart, &entries, row, buffer),
    }
}

fn draw_line(chart: &Chart<'_>, entries: &[LegendEntry], row: Rect, buffer: &mut Buffer) {
    let share = longest_label(entries, row.width);
    let mut x = row.x;
    for entry in entries {
        let columns = (SAMPLE + width(&entry.label).min(share)).min(row.right().saturating_sub(x));
        draw_entry(
            chart,
            entry,
            Rect {
                x,
                width: columns,
                ..row
            },
            buffer,
        );
        x = x.saturating_add(columns + GAP);
    }
}

/// The label length, in columns, up to which all entries fit into one line.
fn longest_label(entries: &[LegendEntry], columns: u16) -> u16 {
    let total = |longest: u16| -> u32 {
        let widths = entries
            .iter()
            .map(|entry| SAMPLE + GAP + width(&entry.label).min(longest));
        widths.map(u32::from).sum::<u32>()
    };
    let room = u32::from(columns + GAP);
    (0..=columns)
        .rev()
        .find(|longest| total(*longest) <= room)
        .unwrap_or(0)
}

fn draw_entry(chart: &Chart<'_>, entry: &LegendEntry, row: Rect, buffer: &mut Buffer) {
    let sample = Rect {
        width: row.width.min(SAMPLE - 1),
        ..row
    };
    put(buffer, sample, &entry.sample, (chart.glyphs, entry.style));
    let used = row.width.min(SAMPLE);
    let label = Rect {
        x: row.x + used,
        width: row.width - used,
        ..row
    };
    put(
        buffer,
        label,
        &entry.label_in(label.width, chart.glyphs),
        (chart.glyphs, chart.styles.legend),
    );
    for (style, column) in entry.shared.iter().zip(label.columns().step_by(SHARED)) {
        buffer.set_style(column, *style);
    }
}

impl LegendEntry {
    /// The label, shortened to `columns`.
    fn label_in(&self, columns: u16, glyphs: Glyphs) -> String {
        if width(&self.label) <= columns {
            return self.label.clone();
        }
        let mut short = String::new();
        for letter in escape(&self.label).chars() {
            short.push(letter);
            if width(&short) >= columns {
                short.pop();
                break;
            }
        }
        short.push(if glyphs == Glyphs::Ascii { '~' } else { '…' });
        short
    }
}
