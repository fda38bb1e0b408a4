//! The rows of a table, one after the other.

use csv::{ByteRecord, ReaderBuilder};

use num_complex::Complex64;

use super::dialect::Dialect;
use super::sample::Separator;
use crate::measured::{Fault, fault_at, number, text_of};

/// A row and where it is.
#[derive(Debug)]
pub(super) struct Row<'a> {
    /// The whole file.
    bytes: &'a [u8],
    /// A place in the file from which on the row is the first that has something in it.
    offset: usize,
    comma: bool,
    cells: &'a ByteRecord,
}

impl Row<'_> {
    /// A cell by its index; empty where the row is too short.
    pub(super) fn cell(&self, index: usize) -> &[u8] {
        self.cells.get(index).unwrap_or_default()
    }

    /// A cell as a number; NaN where it is there and empty.
    pub(super) fn number(&self, index: usize) -> Result<f64, Fault> {
        let cell = self.there(index)?;
        self.real(cell)
            .ok_or_else(|| self.no_number(index, "1.5, -2e-7"))
    }

    /// A cell as a complex number, or as a real one; NaN where it is there and empty.
    pub(super) fn complex(&self, index: usize) -> Result<Complex64, Fault> {
        let cell = self.there(index)?;
        let complex = || number::complex(cell, self.comma);
        let found = self.real(cell).map(Complex64::from).or_else(complex);
        found.ok_or_else(|| self.no_number(index, "1e-6-2e-7i, (1e-6-2e-7j)"))
    }

    /// Whether there is no number in one column, or in none of the others: then the row is no row of the table.
    pub(super) fn is_no_row(
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

    /// Whether the row ends in or before a cell.
    pub(super) fn ends_by(&self, index: usize) -> bool {
        self.cells.len() <= index + 1
    }

    /// Whether there are words from a cell on.
    pub(super) fn has_from(&self, index: usize) -> bool {
        let mut behind = self.cells.iter().skip(index);
        behind.any(|cell| !cell.trim_ascii().is_empty())
    }

    /// The first words of the row.
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

    /// A cell, which the row must have.
    fn there(&self, index: usize) -> Result<&[u8], Fault> {
        self.cells.get(index).ok_or_else(|| {
            let (found, wanted) = (self.cells.len(), index + 1);
            self.fault(
                found.saturating_sub(1),
                format!("the row has {found} cells; {wanted} or more would be accepted"),
            )
        })
    }

    /// A cell as a real number, also where it is written as a complex one; NaN where it is empty.
    fn real(&self, cell: &[u8]) -> Option<f64> {
        if cell.trim_ascii().is_empty() {
            return Some(f64::NAN);
        }
        let complex = || number::complex(cell, self.comma).filter(|value| value.im == 0.0);
        number::parse(cell, self.comma).or_else(|| complex().map(|value| value.re))
    }

    fn no_number(&self, index: usize, accepted: &str) -> Fault {
        let text: String = text_of(self.cell(index)).chars().take(30).collect();
        let message =
            format!("{text:?} is no number: accepted is such as {accepted} or an empty cell");
        self.fault(index, message)
    }

    /// A fault in a cell.
    pub(super) fn fault(&self, index: usize, message: impl Into<String>) -> Fault {
        fault_at("", line_at(self.bytes, self.offset), index + 1, message)
    }
}

/// The line, from 1, of the first line from an offset on that is neither empty nor a comment.
pub(super) fn line_at(text: &[u8], offset: usize) -> usize {
    let before = text.iter().take(row_start(text, offset));
    before.filter(|&&byte| byte == b'\n').count() + 1
}

/// Where the first line from an offset on starts that is neither empty nor a comment; the offset where there is none.
pub(super) fn row_start(text: &[u8], offset: usize) -> usize {
    let rest = text.get(offset..).unwrap_or_default();
    let mut start = offset;
    for line in rest.split_inclusive(|&byte| byte == b'\n') {
        let first = line.trim_ascii_start().first();
        if first.is_some_and(|first| !is_comment(*first)) {
            return start;
        }
        start += line.len();
    }
    offset
}

/// Whether a line that starts so is a comment.
pub(super) const fn is_comment(first: u8) -> bool {
    matches!(first, b'#' | b'%' | b'!')
}

/// Calls `take` with each row of numbers until it fails.
pub(super) fn for_each_row(
    bytes: &[u8],
    dialect: &Dialect,
    mut take: impl FnMut(Row) -> Result<(), Fault>,
) -> Result<(), Fault> {
    for_each_record(
        bytes,
        dialect.start,
        bytes.len(),
        dialect.separator,
        |offset, cells| {
            let comma = dialect.separator.allows_decimal_comma();
            take(Row {
                bytes,
                offset,
                comma,
                cells,
            })
        },
    )
}

/// Calls `take` with each row of a part of a file that is neither empty nor a comment, until it fails.
pub(super) fn for_each_record(
    bytes: &[u8],
    from: usize,
    to: usize,
    separator: Separator,
    mut take: impl FnMut(usize, &ByteRecord) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let part = bytes.get(from..to).unwrap_or_default();
    let take = |offset: usize, record: &ByteRecord| {
        let mut letters = record
            .iter()
            .flatten()
            .skip_while(|byte| byte.is_ascii_whitespace());
        match letters.next() {
            Some(first) if !is_comment(*first) => take(from + offset, record),
            _ => Ok(()),
        }
    };
    match separator {
        Separator::Byte(byte) => parted(part, byte, take),
        Separator::Blanks => blank_parted(part, take),
    }
}

/// Calls `take` with each row and a place at or before it.
fn parted(
    part: &[u8],
    separator: u8,
    mut take: impl FnMut(usize, &ByteRecord) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let mut reader = ReaderBuilder::new()
        .delimiter(separator)
        .comment(first_comment(part))
        .has_headers(false)
        .flexible(true)
        .from_reader(part);
    let mut record = ByteRecord::new();
    // Reading from memory does not fail.
    while reader.read_byte_record(&mut record).unwrap_or(false) {
        let offset = record.position().map_or(0, |place| place.byte() as usize);
        take(offset, &record)?;
    }
    Ok(())
}

/// Calls `take` with each line and its place.
fn blank_parted(
    part: &[u8],
    mut take: impl FnMut(usize, &ByteRecord) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let mut record = ByteRecord::new();
    let mut offset = 0;
    for line in part.split(|byte| matches!(byte, b'\n' | b'\r')) {
        record.clear();
        for cell in blank_cells(line) {
            record.push_field(cell);
        }
        take(offset, &record)?;
        offset += line.len() + 1;
    }
    Ok(())
}

/// The cells of a line with blanks between them. What belongs to a complex number stays in one: `1e-6 - 2e-7i`,
/// `1e-6 -2e-7i`, `(1e-6, -2e-7)`.
fn blank_cells(line: &[u8]) -> Vec<&[u8]> {
    // Where the cells start and end.
    let mut cells: Vec<(usize, usize)> = Vec::new();
    let mut at = 0;
    for word in line.split(u8::is_ascii_whitespace) {
        let (from, to) = (at, at + word.len());
        at = to + 1;
        if word.is_empty() {
            continue;
        }
        match cells.last_mut() {
            Some(last) if goes_on(&line[last.0..last.1], word) => last.1 = to,
            _ => cells.push((from, to)),
        }
    }
    // Some programs put names of rows into quotes.
    let bare = |cell: &[u8]| cell.len() > 2 && cell.starts_with(b"\"") && cell.ends_with(b"\"");
    let cells = cells.into_iter().map(|(from, to)| match &line[from..to] {
        cell if bare(cell) => &cell[1..cell.len() - 1],
        cell => cell,
    });
    cells.collect()
}

/// Whether a word goes on with the complex number in a cell.
fn goes_on(cell: &[u8], word: &[u8]) -> bool {
    let is_sign = |word: &[u8]| matches!(word, b"+" | b"-");
    let ends_in_sign = cell.ends_with(b" +") || cell.ends_with(b" -");
    let is_open = cell.starts_with(b"(") && !cell.contains(&b')');
    let is_imaginary = || {
        word.starts_with(b"+") | word.starts_with(b"-")
            && number::parse(cell, true).is_some()
            && number::complex(word, true).is_some()
    };
    is_open
        || ends_in_sign
        || (is_sign(word) && number::parse(cell, true).is_some())
        || is_imaginary()
}

/// The sign by which the first comment of a text starts. A quote in a comment must not swallow the lines behind it.
fn first_comment(part: &[u8]) -> Option<u8> {
    const SAMPLE: usize = 1 << 16;
    let sample = &part[..part.len().min(SAMPLE)];
    let firsts = sample
        .split(|&byte| byte == b'\n')
        .filter_map(|line| line.first().copied());
    firsts.into_iter().find(|first| is_comment(*first))
}
