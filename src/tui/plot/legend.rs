//! The legend: which line, marker and label belong together.

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
/// Columns of the marker of another curve in an entry and the space after it; as many characters.
const SHARED: usize = 2;
/// Columns between the entries of a one-line legend.
const GAP: u16 = 2;
/// Columns a label is at least shortened to; a legend without room for that is left out.
const SHORTEST: u16 = 3;
/// Rows the plot keeps beneath a one-line legend.
const SHORTEST_PLOT: u16 = 3;
/// Most of the plot a legend inside it may cover, in percent.
const MOST_COVERED: u32 = 40;

/// The place found for a legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    Nowhere,
    Inside(Rect),
    Line(Rect),
}

struct Entry {
    sample: String,
    /// The markers of curves that share the entry, each with a space behind it, and the name.
    label: String,
    style: Style,
    /// The styles of those markers.
    shared: Vec<Style>,
}

fn entries(chart: &Chart<'_>) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for (index, curve) in chart.curves.iter().enumerate() {
        if !curve.label.is_empty() {
            entries.push(entry(chart, index, curve));
        } else if let Some(entry) = entries.last_mut()
            && curve.shares_entry
            && let Some(marker) = chart.marker(index)
        {
            let at = SHARED * entry.shared.len();
            let at = entry.label.char_indices().nth(at).map_or(0, |(at, _)| at);
            entry.label.insert_str(at, &format!("{marker} "));
            entry.shared.push(curve.ink());
        }
    }
    entries
}

fn entry(chart: &Chart<'_>, index: usize, curve: &Curve<'_>) -> Entry {
    let body = match (chart.grid_of(index), curve.line) {
        (_, LineStyle::Points { .. }) => ' ',
        (Marker::Custom(body), _) => body,
        (_, LineStyle::Solid) => '─',
        (_, LineStyle::Dashed) => '╌',
        (_, LineStyle::Dotted) => '┈',
    };
    let marker = chart.marker(index).unwrap_or(body);
    Entry {
        sample: [body, marker, body].iter().collect(),
        label: curve.label.clone(),
        style: curve.ink(),
        shared: Vec::new(),
    }
}

/// Finds a place for the legend: inside `plot`, or in the top row of `around`, the plot with its axis.
pub(super) fn place(chart: &Chart<'_>, plot: Rect, around: Rect) -> Place {
    let entries = entries(chart);
    if entries.is_empty() || chart.legend == Legend::Hidden {
        return Place::Nowhere;
    }
    let widest = entries
        .iter()
        .map(|entry| width(&entry.label))
        .max()
        .unwrap_or(0);
    // One blank column keeps the curves off the samples.
    let columns = (1 + SAMPLE + widest).min(plot.width / 2);
    let rows = entries.len() as u16;
    let covered = u32::from(columns) * u32::from(rows) * 100;
    let fits = columns > SAMPLE + widest.min(SHORTEST)
        && rows <= plot.height
        && covered <= plot.area() * MOST_COVERED;
    if fits && chart.legend == Legend::Inside {
        return Place::Inside(Rect {
            x: plot.right() - columns,
            width: columns,
            height: rows,
            ..plot
        });
    }
    if around.height > SHORTEST_PLOT
        && longest_label(&entries, around.width) >= widest.min(SHORTEST)
    {
        return Place::Line(Rect {
            height: 1,
            ..around
        });
    }
    Place::Nowhere
}

/// Draws the legend into its place.
pub(super) fn draw(chart: &Chart<'_>, place: Place, buffer: &mut Buffer) {
    let entries = entries(chart);
    match place {
        Place::Nowhere => {}
        Place::Inside(area) => {
            for (entry, row) in entries.iter().zip(area.rows()) {
                let row = Rect {
                    x: row.x + 1,
                    width: row.width - 1,
                    ..row
                };
                draw_entry(chart, entry, row, buffer);
            }
        }
        Place::Line(row) => draw_line(chart, &entries, row, buffer),
    }
}

fn draw_line(chart: &Chart<'_>, entries: &[Entry], row: Rect, buffer: &mut Buffer) {
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

/// The longest label all entries can have and still fit into one line, in columns.
fn longest_label(entries: &[Entry], columns: u16) -> u16 {
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

fn draw_entry(chart: &Chart<'_>, entry: &Entry, row: Rect, buffer: &mut Buffer) {
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

impl Entry {
    /// The label, shortened to so many columns.
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
