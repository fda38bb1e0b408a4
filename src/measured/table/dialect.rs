//! The format of a table: separator, first row of numbers, and header.

use super::header::{Header, HeaderShape};
use super::records::{Separator, is_comment, line_at, row_start};
use super::sample::{ColumnContent, SAMPLE, TableSample};
use crate::measured::{Fault, fault_at, number, text_of};

/// The format of a table.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::measured) struct Dialect {
    pub(in crate::measured) separator: Separator,
    /// An offset after the header, at or before the first row of numbers.
    pub(super) start: usize,
    /// The titles of the columns; one per column, or none.
    pub(in crate::measured) header: Vec<String>,
    /// The words of a header that does not match the columns.
    pub(in crate::measured) misfit: Vec<String>,
    /// Whether the header follows the first row of numbers in the same line.
    pub(super) is_after_data: bool,
    /// The kind of each column.
    pub(in crate::measured) columns: Vec<ColumnContent>,
    /// Whether the first column names curves.
    pub(super) has_curves: bool,
    /// The first rows of numbers, as text.
    pub(in crate::measured) rows: Vec<Vec<String>>,
}

impl Dialect {
    /// Detects the format from the start of a UTF-8 text.
    ///
    /// # Errors
    /// There is no row of numbers.
    pub(in crate::measured) fn of(text: &[u8]) -> Result<Self, Fault> {
        let body = body(text);
        let found = Separator::ALL
            .into_iter()
            .map(|separator| TableSample::of(text, body, separator));
        // On a tie the first separator wins: tabs are also blanks.
        let best = found.rev().max_by_key(TableSample::merit);
        let best = best.and_then(|sample| Some((sample.start()?, sample)));
        let Some((start, sample)) = best else {
            return Err(fault_at(
                "",
                line_at(text, 0),
                1,
                format!(
                    "no row of two or more numbers in the first {} KiB: accepted are columns of numbers with commas, \
                     semicolons, tabs or blanks between them",
                    SAMPLE >> 10
                ),
            ));
        };
        Ok(Self::new(text, start, sample))
    }

    fn new(text: &[u8], start: usize, sample: TableSample) -> Self {
        let first = row_start(text, start);
        let above = String::from_utf8_lossy(&text[first.saturating_sub(SAMPLE)..first]);
        let below = &text[first..text.len().min(first + SAMPLE)];
        let below = String::from_utf8_lossy(below);
        let lines: Vec<&str> = below.lines().take(5).collect();
        let shape = HeaderShape {
            separator: sample.separator,
            width: sample.columns.len(),
            cells: sample.usual_cells(),
            lines: &lines,
        };
        let mut header = Header::find(above.lines().rev(), shape);
        let is_after_data = header.cells.is_empty() && header.misfit.is_empty() && {
            header = Header::after_data(sample.extra_cells(), shape);
            !header.cells.is_empty()
        };
        let visible =
            |words: Vec<String>| words.iter().map(|word| text_of(word.as_bytes())).collect();
        Self {
            separator: sample.separator,
            start,
            header: visible(header.cells),
            misfit: visible(header.misfit),
            is_after_data,
            has_curves: sample.has_curves,
            rows: sample.number_rows(),
            columns: sample.columns,
        }
    }

    /// Number of columns.
    pub(in crate::measured) fn width(&self) -> usize {
        self.columns.len()
    }

    /// The line number of the first row of numbers.
    pub(super) fn first_line(&self, text: &[u8]) -> usize {
        line_at(text, self.start)
    }

    /// The largest magnitude of a column in the first rows.
    pub(super) fn largest(&self, column: usize) -> f64 {
        let comma = self.separator.allows_decimal_comma();
        let cells = self.rows.iter().filter_map(|row| row.get(column));
        let numbers = cells.filter_map(|cell| number::parse(cell.as_bytes(), comma));
        let finite = numbers.map(f64::abs).filter(|number| number.is_finite());
        finite.fold(0.0, f64::max)
    }
}

/// The start of the first line that is neither empty nor a comment.
fn body(text: &[u8]) -> usize {
    let mut at = 0;
    for line in text.split_inclusive(|&byte| byte == b'\n') {
        match line.trim_ascii_start().first() {
            Some(first) if !is_comment(*first) => break,
            _ => at += line.len(),
        }
    }
    at
}
