//! The rows of a table.

use csv::ByteRecord;

use num_complex::Complex64;

use super::dialect::Dialect;
use super::records::{for_each_record, line_at};
use crate::measured::{Fault, fault_at, number, text_of};

/// A row and its position.
#[derive(Debug)]
pub(super) struct TableRow<'a> {
    /// The whole file.
    bytes: &'a [u8],
    /// An offset in the file; the row is the first non-empty row from there on.
    offset: usize,
    comma: bool,
    cells: &'a ByteRecord,
}

impl TableRow<'_> {
    /// A cell by its index; empty if the row is too short.
    pub(super) fn cell(&self, index: usize) -> &[u8] {
        self.cells.get(index).unwrap_or_default()
    }

    /// A cell as a number; NaN for an empty cell.
    pub(super) fn number(&self, index: usize) -> Result<f64, Fault> {
        let cell = self.present(index)?;
        self.real(cell)
            .ok_or_else(|| self.not_a_number(index, "1.5, -2e-7"))
    }

    /// A cell as a complex or real number; NaN for an empty cell.
    pub(super) fn complex(&self, index: usize) -> Result<Complex64, Fault> {
        let cell = self.present(index)?;
        let complex = || number::complex(cell, self.comma);
        let found = self.real(cell).map(Complex64::from).or_else(complex);
        found.ok_or_else(|| self.not_a_number(index, "1e-6-2e-7i, (1e-6-2e-7j)"))
    }

    /// Whether the frequency or all values are missing: then the row is not part of the table.
    pub(super) fn is_not_data(
        &self,
        frequency: usize,
        mut values: impl Iterator<Item = usize>,
    ) -> bool {
        let has = |index: usize| {
            let cell = self.cell(index);
            !cell.trim_ascii().is_empty()
                && (number::parse(cell, self.comma).is_some()
                    || number::complex(cell, self.comma).is_some())
        };
        !has(frequency) || !values.any(has)
    }

    /// Whether the row ends at or before a cell.
    pub(super) fn ends_by(&self, index: usize) -> bool {
        self.cells.len() <= index + 1
    }

    /// Whether the row has non-empty cells from an index on.
    pub(super) fn has_from(&self, index: usize) -> bool {
        let mut extra = self.cells.iter().skip(index);
        extra.any(|cell| !cell.trim_ascii().is_empty())
    }

    /// The first words of the row, for messages.
    pub(super) fn start(&self) -> String {
        let cells: Vec<String> = self.cells.iter().map(text_of).collect();
        let words = cells.join(" ");
        words
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
            .chars()
            .take(30)
            .collect()
    }

    /// A cell that the row must have.
    fn present(&self, index: usize) -> Result<&[u8], Fault> {
        self.cells.get(index).ok_or_else(|| {
            let (found, wanted) = (self.cells.len(), index + 1);
            self.fault(
                found.saturating_sub(1),
                format!("the row has {found} cells; {wanted} or more would be accepted"),
            )
        })
    }

    /// A cell as a real number, also from a complex number without imaginary part; NaN if it is empty.
    fn real(&self, cell: &[u8]) -> Option<f64> {
        if cell.trim_ascii().is_empty() {
            return Some(f64::NAN);
        }
        let complex = || number::complex(cell, self.comma).filter(|value| value.im == 0.0);
        number::parse(cell, self.comma).or_else(|| complex().map(|value| value.re))
    }

    fn not_a_number(&self, index: usize, accepted: &str) -> Fault {
        let text: String = text_of(self.cell(index)).chars().take(30).collect();
        let message =
            format!("{text:?} is not a number: accepted are {accepted}, or an empty cell");
        self.fault(index, message)
    }

    /// A fault at a cell.
    pub(super) fn fault(&self, index: usize, message: impl Into<String>) -> Fault {
        fault_at("", line_at(self.bytes, self.offset), index + 1, message)
    }
}

/// Calls `take` with each row of numbers until it fails.
pub(super) fn for_each_row(
    bytes: &[u8],
    dialect: &Dialect,
    mut take: impl FnMut(TableRow) -> Result<(), Fault>,
) -> Result<(), Fault> {
    for_each_record(
        bytes,
        dialect.start,
        bytes.len(),
        dialect.separator,
        |offset, cells| {
            let comma = dialect.separator.allows_decimal_comma();
            take(TableRow {
                bytes,
                offset,
                comma,
                cells,
            })
        },
    )
}
