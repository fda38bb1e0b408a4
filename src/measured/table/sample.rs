//! The first rows of a table as one separator parts them: where its numbers start, and what its columns hold.

use super::records::{Separator, for_each_record};
use crate::measured::{Fault, number, text_of};

/// How far into a table its first numbers are looked for, bytes.
pub(super) const SAMPLE: usize = 1 << 16;

/// Rows that are looked at.
const MOST_ROWS: usize = 400;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::measured) enum ColumnKind {
    /// Real numbers.
    Real,
    /// Complex numbers.
    Complex,
    /// Something else.
    Text,
}

/// What a cell holds.
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

/// The first rows of a table as one separator parts them.
pub(super) struct Sample {
    pub(super) separator: Separator,
    rows: Vec<SampleRow>,
    /// Index of the first row of numbers.
    first: usize,
    pub(super) has_curves: bool,
    /// What the columns hold.
    pub(super) columns: Vec<ColumnKind>,
}

impl Sample {
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
        // The column of names has its word right above the numbers.
        let named = names
            .map(|names| (names, new(true)))
            .filter(|(names, sample)| sample.first == names + 1);
        let sample = named.map_or_else(|| new(false), |(_, sample)| sample);
        Self { rows, ..sample }
    }

    /// The index of the first row of numbers that another one follows; of the first at all where there is no such.
    fn first_row(&self, rows: &[SampleRow]) -> usize {
        let is_numbers = |index: &usize| rows.get(*index).is_some_and(|row| self.is_numbers(row));
        let pair = (0..rows.len()).find(|index| {
            let next = index + 1;
            is_numbers(index) && (next == rows.len() || is_numbers(&next))
        });
        let single = || (0..rows.len()).find(is_numbers);
        pair.or_else(single).unwrap_or(rows.len())
    }

    /// Whether a row has two or more numbers, and nothing else in the columns of numbers.
    fn is_numbers(&self, row: &SampleRow) -> bool {
        let skipped = usize::from(self.has_curves);
        let cells = row.kinds.iter().zip(&self.columns).skip(skipped);
        let mut numbers = 0;
        for (cell, column) in cells {
            match (cell, column) {
                (_, ColumnKind::Text) | (CellKind::Empty, _) => {}
                (CellKind::Text, _) => return false,
                (CellKind::Real | CellKind::Complex, _) => numbers += 1,
            }
        }
        numbers >= 2
    }

    /// How well the separator fits: how many rows are of numbers, how few columns of text, how many columns.
    pub(super) fn merit(&self) -> (usize, isize, usize) {
        let texts = self
            .columns
            .iter()
            .filter(|kind| **kind == ColumnKind::Text);
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

    /// The rows of numbers as they stand, without what is behind the columns.
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

    /// The number of cells that most rows of numbers have.
    pub(super) fn usual_cells(&self) -> usize {
        let mut counts = std::collections::BTreeMap::<usize, usize>::new();
        for row in self.numbers() {
            *counts.entry(row.cells.len()).or_default() += 1;
        }
        let most = counts.into_iter().max_by_key(|(_, count)| *count);
        most.map_or(0, |(cells, _)| cells)
    }

    /// What stands behind the columns in the first row of numbers.
    pub(super) fn behind_first(&self) -> &[String] {
        let cells = self.rows.get(self.first).map(|row| row.cells.as_slice());
        let cells = cells.unwrap_or_default();
        cells.get(self.columns.len()..).unwrap_or_default()
    }
}

fn rows(bytes: &[u8], body: usize, separator: Separator) -> Vec<SampleRow> {
    let mut rows = Vec::new();
    // The last row may be cut off.
    let end = match body + SAMPLE {
        end if end >= bytes.len() => bytes.len(),
        end => match bytes[body..end].iter().rposition(|&byte| byte == b'\n') {
            Some(last) => body + last,
            None => end,
        },
    };
    let comma = separator.allows_decimal_comma();
    // A failure ends the sample, and nothing else fails here.
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
        // A program that writes all its numbers as complex ones writes its frequencies so, too.
        Some(value) if value.im == 0.0 => CellKind::Real,
        Some(_) => CellKind::Complex,
        None => CellKind::Text,
    }
}

/// What the columns hold in most rows that have two numbers or more. A column that most rows do not have is none.
fn columns(rows: &[SampleRow], skipped: usize) -> Vec<ColumnKind> {
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
            () if texts > numbers => ColumnKind::Text,
            () if complex > 0 => ColumnKind::Complex,
            () => ColumnKind::Real,
        });
        if numbers + texts > 0 {
            filled = index + 1;
        }
    }
    columns.truncate(filled);
    columns
}
