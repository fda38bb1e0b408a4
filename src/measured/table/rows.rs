//! The rows of a table, one after the other.

use csv::{ByteRecord, ReaderBuilder};

use super::dialect::{Dialect, Separator};
use crate::measured::{Fault, fault_at, text_of};

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
        if index >= self.cells.len() {
            let (found, wanted) = (self.cells.len(), index + 1);
            return Err(self.fault(
                found.saturating_sub(1),
                format!("the row has {found} cells; {wanted} or more would be accepted"),
            ));
        }
        super::number_of(self.cell(index), self.comma).ok_or_else(|| {
            let text: String = text_of(self.cell(index)).chars().take(30).collect();
            self.fault(
                index,
                format!("{text:?} is no number: accepted is such as 1.5, -2e-7 or an empty cell"),
            )
        })
    }

    /// A fault in a cell.
    pub(super) fn fault(&self, index: usize, message: impl Into<String>) -> Fault {
        fault_at("", line_at(self.bytes, self.offset), index + 1, message)
    }
}

/// The line, from 1, of the first line from an offset on that is neither empty nor a comment.
pub(super) fn line_at(bytes: &[u8], offset: usize) -> usize {
    let before = bytes
        .iter()
        .take(offset)
        .filter(|&&byte| byte == b'\n')
        .count();
    let rest = bytes.get(offset..).unwrap_or_default();
    let nothing = |line: &[u8]| {
        line.trim_ascii_start()
            .first()
            .is_none_or(|first| is_comment(*first))
    };
    let mut lines = rest.split(|&byte| byte == b'\n');
    before + lines.position(|line| !nothing(line)).unwrap_or(0) + 1
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
        let words = line.split(u8::is_ascii_whitespace);
        for word in words.filter(|word| !word.is_empty()) {
            record.push_field(word);
        }
        take(offset, &record)?;
        offset += line.len() + 1;
    }
    Ok(())
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
