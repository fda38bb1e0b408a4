//! Splits a text into rows by one separator, without empty lines and comments.

use csv::{ByteRecord, ReaderBuilder};

use crate::measured::{Fault, number};

/// The separator of cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::measured) enum Separator {
    /// A comma, a semicolon or a tab.
    Byte(u8),
    /// One or more blanks.
    Blanks,
}

impl Separator {
    pub(super) const ALL: [Self; 4] = [
        Self::Byte(b'\t'),
        Self::Byte(b';'),
        Self::Byte(b','),
        Self::Blanks,
    ];

    /// Whether numbers may have a decimal comma.
    pub(super) fn allows_decimal_comma(self) -> bool {
        self != Self::Byte(b',')
    }

    /// The plural name, for messages.
    pub(in crate::measured) const fn name(self) -> &'static str {
        match self {
            Self::Byte(b'\t') => "tabs",
            Self::Byte(b';') => "semicolons",
            Self::Byte(_) => "commas",
            Self::Blanks => "blanks",
        }
    }
}

/// The line number, from 1, of the first line from an offset on that is neither empty nor a comment.
pub(super) fn line_at(text: &[u8], offset: usize) -> usize {
    let before = text.iter().take(row_start(text, offset));
    before.filter(|&&byte| byte == b'\n').count() + 1
}

/// The start of the first line from an offset on that is neither empty nor a comment; the offset if there is none.
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

/// Whether a line with this first byte is a comment.
pub(super) const fn is_comment(first: u8) -> bool {
    matches!(first, b'#' | b'%' | b'!')
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
        Separator::Byte(byte) => for_each_delimited(part, byte, take),
        Separator::Blanks => for_each_blank_separated(part, take),
    }
}

/// Calls `take` with each row and an offset at or before it.
fn for_each_delimited(
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

/// Calls `take` with each line and its offset.
fn for_each_blank_separated(
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

/// Splits a line at blanks. A complex number stays in one cell: `1e-6 - 2e-7i`, `1e-6 -2e-7i`, `(1e-6, -2e-7)`.
fn blank_cells(line: &[u8]) -> Vec<&[u8]> {
    // Start and end of each cell.
    let mut cells: Vec<(usize, usize)> = Vec::new();
    let mut at = 0;
    for word in line.split(u8::is_ascii_whitespace) {
        let (from, to) = (at, at + word.len());
        at = to + 1;
        if word.is_empty() {
            continue;
        }
        match cells.last_mut() {
            Some(last) if continues_number(&line[last.0..last.1], word) => last.1 = to,
            _ => cells.push((from, to)),
        }
    }
    // Some programs quote row names.
    let is_quoted =
        |cell: &[u8]| cell.len() > 2 && cell.starts_with(b"\"") && cell.ends_with(b"\"");
    let cells = cells.into_iter().map(|(from, to)| match &line[from..to] {
        cell if is_quoted(cell) => &cell[1..cell.len() - 1],
        cell => cell,
    });
    cells.collect()
}

/// Whether a word continues the complex number in a cell.
fn continues_number(cell: &[u8], word: &[u8]) -> bool {
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

/// The character that starts the first comment of a text. A quote in a comment must not include the following lines.
fn first_comment(part: &[u8]) -> Option<u8> {
    const SAMPLE: usize = 1 << 16;
    let sample = &part[..part.len().min(SAMPLE)];
    let firsts = sample
        .split(|&byte| byte == b'\n')
        .filter_map(|line| line.first().copied());
    firsts.into_iter().find(|first| is_comment(*first))
}
