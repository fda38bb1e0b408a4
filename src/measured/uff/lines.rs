//! The lines and data sets of a universal file.

use crate::measured::{BYTE_ORDER_MARK, Fault, fault_at};

/// A line reader for universal files.
#[derive(Debug)]
pub(super) struct UffLines<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Number of the last line read, from 1.
    number: usize,
    /// The line end: a line feed, or a carriage return in a file without line feeds.
    end: u8,
    /// The last possible column of a delimiter `-1`: 6, or that of the first delimiter.
    widest: usize,
}

/// The start of a data set.
#[derive(Debug)]
pub(super) enum Start {
    /// A text data set and its type number.
    Text(u32),
    /// A binary data set, its type number and its first line.
    Binary(u32, Vec<u8>),
}

impl<'a> UffLines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        let is_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let ends = bytes.iter().skip_while(|byte| !is_end(byte));
        let mut ends = ends.take_while(|byte| is_end(byte)).peekable();
        let old = ends.peek().is_some() && ends.all(|&byte| byte == b'\r');
        let mut lines = Self {
            bytes,
            at: 0,
            number: 0,
            end: if old { b'\r' } else { b'\n' },
            widest: usize::MAX,
        };
        let first = std::iter::from_fn(|| lines.line()).find(|line| !line.trim_ascii().is_empty());
        let first = first.filter(|line| is_delimiter(line, usize::MAX));
        let widest = first.map_or(0, |line| line.trim_ascii_end().len());
        Self {
            at: 0,
            number: 0,
            widest: widest.max(6),
            ..lines
        }
    }

    /// Whether the last line read has no line end: the file may be truncated.
    pub(super) fn is_truncated(&self) -> bool {
        self.at > self.bytes.len()
    }

    /// Number of the last line read, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// The unread bytes.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// Skips binary bytes.
    pub(super) fn skip(&mut self, count: usize) {
        let skipped = &self.rest()[..count.min(self.rest().len())];
        self.number += skipped.split(|&byte| byte == self.end).count() - 1;
        self.at += skipped.len();
    }

    /// The next line, without its line end; none at the end of the file.
    fn line(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest();
        if rest.is_empty() {
            return None;
        }
        let end = rest
            .iter()
            .position(|&byte| byte == self.end)
            .unwrap_or(rest.len());
        self.at += end + 1;
        self.number += 1;
        let mut line = &rest[..end];
        while let Some(shorter) = line.strip_suffix(b"\r") {
            line = shorter;
        }
        Some(line)
    }

    /// The next line of a data set; none at its end. Does not consume the delimiter.
    pub(super) fn record(&mut self) -> Option<&'a [u8]> {
        let (at, number) = (self.at, self.number);
        let line = self.line()?;
        if is_delimiter(line, self.widest) {
            (self.at, self.number) = (at, number);
            return None;
        }
        Some(line)
    }

    /// Skips to the next data set.
    pub(super) fn next_set(&mut self) -> Option<Start> {
        let mut inside = false;
        loop {
            let line = self.line()?;
            if is_delimiter(line, self.widest) {
                // An extra delimiter counts as a start.
                inside = true;
            } else if inside && !line.trim_ascii().is_empty() {
                return Some(start(line));
            }
        }
    }

    /// Skips to the end of a data set, with its delimiter.
    pub(super) fn end_set(&mut self) {
        while let Some(line) = self.line() {
            if is_delimiter(line, self.widest) {
                break;
            }
        }
    }

    /// A fault of a record, in the last line read.
    pub(super) fn fault(
        &self,
        set: usize,
        record: usize,
        column: usize,
        message: impl Into<String>,
    ) -> Fault {
        fault_at(
            &format!("data set {set}, record {record}"),
            self.number.max(1),
            column,
            message,
        )
    }
}

/// Whether a line is `-1` that ends at or before a column.
fn is_delimiter(line: &[u8], widest: usize) -> bool {
    line.trim_ascii() == b"-1" && line.trim_ascii_end().len() <= widest
}

/// Whether the end of a data set follows, possibly after a line end.
pub(super) fn starts_with_end(rest: &[u8]) -> bool {
    let rest = rest.strip_prefix(b"\r").unwrap_or(rest);
    let rest = rest.strip_prefix(b"\n").unwrap_or(rest);
    // The blanks are required: a last data byte could otherwise count as one of them.
    rest.is_empty() || rest.starts_with(b"    -1")
}

fn start(line: &[u8]) -> Start {
    let word = line.trim_ascii_start();
    let digits = word.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let kind = std::str::from_utf8(&word[..digits])
        .ok()
        .and_then(|digits| digits.parse().ok());
    let kind = kind.unwrap_or(0);
    match word.get(digits) {
        Some(b'b' | b'B') => Start::Binary(kind, line.to_vec()),
        _ => Start::Text(kind),
    }
}
