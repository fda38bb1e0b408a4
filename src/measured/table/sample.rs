//! The first rows of a table, split by one separator: start of the numbers and kinds of the columns.

use super::records::{Separator, for_each_record};
use crate::measured::{Fault, number, text_of};

/// Bytes in which the first numbers of a table are searched.
pub(super) const SAMPLE: usize = 1 << 16;

/// Most rows of a sample.
const MOST_ROWS: usize = 400;

/// The kind of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::measured) enum ColumnContent {
    /// Real numbers.
    Real,
    /// Complex numbers.
    Complex,
    /// Text.
    Text,
}

/// The kind of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CellKind {
    Empty,
    Real,
    Complex,
    Text,
}

/// A row of the sample.
struct SampleRow {
    offset: usize,
    cells: Vec<String>,
    kinds: Vec<CellKind>,
}

/// The first rows of a table, split by one separator.
pub(super) struct TableSample {
    pub(super) separator: Separator,
    rows: Vec<SampleRow>,
    /// Index of the first row of numbers.
    first: usize,
    pub(super) has_curves: bool,
    /// The kinds of the columns.
    pub(super) columns: Vec<ColumnContent>,
}

impl TableSample {
    pub(super) fn of(bytes: &[u8], body: usize, separator: Separator) -> Self {
        let rows = rows(bytes, body, separator);
        let names = rows.iter().position(|row| {
            let first = row.cells.first();
            first.is_some_and(|word| word.trim().eq_ignore_ascii_case("curve"))
        });
        let new = |has_curves| {
            let mut sample = Self {
                separator,
                first: rows.len(),
                rows: Vec::new(),
                has_curves,
                columns: columns(&rows, usize::from(has_curves)),
            };
            sample.first = sample.first_row(&rows);
            sample
        };
        // The title of a name column is directly above the numbers.
        let named = names
            .map(|names| (names, new(true)))
            .filter(|(names, sample)| sample.first == names + 1);
        let sample = named.map_or_else(|| new(false), |(_, sample)| sample);
        Self { rows, ..sample }
    }

    /// The index of the first of two adjacent rows of numbers; of the first row of numbers if there are none.
    fn first_row(&self, rows: &[SampleRow]) -> usize {
        let is_numbers = |index: &usize| rows.get(*index).is_some_and(|row| self.is_numbers(row));
        let pair = (0..rows.len()).find(|index| {
            let next = index + 1;
            is_numbers(index) && (next == rows.len() || is_numbers(&next))
        });
        let single = || (0..rows.len()).find(is_numbers);
        pair.or_else(single).unwrap_or(rows.len())
    }

    /// Whether a row has at least two numbers, and no text in number columns.
    fn is_numbers(&self, row: &SampleRow) -> bool {
        let skipped = usize::from(self.has_curves);
        let cells = row.kinds.iter().zip(&self.columns).skip(skipped);
        let mut numbers = 0;
        for (cell, column) in cells {
            match (cell, column) {
                (_, ColumnContent::Text) | (CellKind::Empty, _) => {}
                (CellKind::Text, _) => return false,
                (CellKind::Real | CellKind::Complex, _) => numbers += 1,
            }
        }
        numbers >= 2
    }

    /// How well the separator fits: rows of numbers, then few text columns, then number columns.
    pub(super) fn merit(&self) -> (usize, isize, usize) {
        let texts = self
            .columns
            .iter()
            .filter(|kind| **kind == ColumnContent::Text);
        let texts = texts.count();
        (
            self.numbers().count(),
            -(texts as isize),
            self.columns.len() - texts,
        )
    }

    /// The rows of numbers.
    fn numbers(&self) -> impl Iterator<Item = &SampleRow> {
        let rows = self.rows.iter().skip(self.first);
        rows.filter(|row| self.is_numbers(row))
    }

    /// The rows of numbers as text, without cells after the last column.
    pub(super) fn number_rows(&self) -> Vec<Vec<String>> {
        let cut = |row: &SampleRow| {
            let cells = row.cells.iter().take(self.columns.len());
            cells.cloned().collect()
        };
        self.numbers().map(cut).collect()
    }

    /// Offset at or before the first row of numbers.
    pub(super) fn start(&self) -> Option<usize> {
        self.rows.get(self.first).map(|row| row.offset)
    }

    /// The number of cells of most rows of numbers.
    pub(super) fn usual_cells(&self) -> usize {
        let mut counts = std::collections::BTreeMap::<usize, usize>::new();
        for row in self.numbers() {
            *counts.entry(row.cells.len()).or_default() += 1;
        }
        let most = counts.into_iter().max_by_key(|(_, count)| *count);
        most.map_or(0, |(cells, _)| cells)
    }

    /// The cells after the last column in the first row of numbers.
    pub(super) fn extra_cells(&self) -> &[String] {
        let cells = self.rows.get(self.first).map(|row| row.cells.as_slice());
        let cells = cells.unwrap_or_default();
        cells.get(self.columns.len()..).unwrap_or_default()
    }
}

fn rows(bytes: &[u8], body: usize, separator: Separator) -> Vec<SampleRow> {
    let mut rows = Vec::new();
    // The last row may be truncated.
    let end = match body + SAMPLE {
        end if end >= bytes.len() => bytes.len(),
        end => match bytes[body..end].iter().rposition(|&byte| byte == b'\n') {
            Some(last) => body + last,
            None => end,
        },
    };
    let comma = separator.allows_decimal_comma();
    // The only error here is the one that ends the sample.
    let _ = for_each_record(bytes, body, end, separator, |offset, record| {
        rows.push(SampleRow {
            offset,
            cells: record.iter().map(text_of).collect(),
            kinds: record.iter().map(|cell| kind_of(cell, comma)).collect(),
        });
        if rows.len() < MOST_ROWS {
            Ok(())
        } else {
            Err(Fault::new("", ""))
        }
    });
    rows
}

fn kind_of(cell: &[u8], comma: bool) -> CellKind {
    if cell.trim_ascii().is_empty() {
        return CellKind::Empty;
    }
    if number::parse(cell, comma).is_some() {
        return CellKind::Real;
    }
    match number::complex(cell, comma) {
        // Some programs write all numbers as complex, also frequencies.
        Some(value) if value.im == 0.0 => CellKind::Real,
        Some(_) => CellKind::Complex,
        None => CellKind::Text,
    }
}

/// The kinds of the columns in most rows with at least two numbers. A column that is missing in most rows is ignored.
fn columns(rows: &[SampleRow], skipped: usize) -> Vec<ColumnContent> {
    let is_number = |kind: &CellKind| matches!(kind, CellKind::Real | CellKind::Complex);
    let two = |row: &&SampleRow| {
        row.kinds
            .iter()
            .skip(skipped)
            .filter(|kind| is_number(kind))
            .count()
            >= 2
    };
    let rows: Vec<&SampleRow> = rows.iter().filter(two).collect();
    let most = rows.iter().map(|row| row.kinds.len()).max().unwrap_or(0);
    let mut columns = Vec::new();
    let mut filled = 0;
    for index in 0..most {
        let cells = || rows.iter().filter_map(|row| row.kinds.get(index));
        let count = |kind: CellKind| cells().filter(|cell| **cell == kind).count();
        if 2 * cells().count() < rows.len() {
            break;
        }
        let (complex, texts) = (count(CellKind::Complex), count(CellKind::Text));
        let numbers = count(CellKind::Real) + complex;
        columns.push(match () {
            () if texts > numbers => ColumnContent::Text,
            () if complex > 0 => ColumnContent::Complex,
            () => ColumnContent::Real,
        });
        if numbers + texts > 0 {
            filled = index + 1;
        }
    }
    columns.truncate(filled);
    columns
}
