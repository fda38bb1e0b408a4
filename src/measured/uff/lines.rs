//! The lines of a universal file and its data sets.

use crate::measured::{BYTE_ORDER_MARK, Fault, fault_at};

/// The lines of a universal file, one after the other.
#[derive(Debug)]
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Number of the line that was read last, from 1.
    number: usize,
    /// What ends a line: a carriage return where no line feed does.
    end: u8,
    /// The last column of a `-1` that is a delimiter: 6, or that of the first one.
    widest: usize,
}

/// How a data set starts.
#[derive(Debug)]
pub(super) enum Start {
    /// All of it is text; its kind.
    Text(u32),
    /// Its data are binary; its kind and its first line.
    Binary(u32, Vec<u8>),
}

impl<'a> Lines<'a> {
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

    /// Whether the line that was read last is the file's last one and has no end: the file may be cut off in it.
    pub(super) fn is_cut(&self) -> bool {
        self.at > self.bytes.len()
    }

    /// Number of the line that was read last, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// What is not read yet.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// Passes over bytes that are no text.
    pub(super) fn pass(&mut self, count: usize) {
        let passed = &self.rest()[..count.min(self.rest().len())];
        self.number += passed.split(|&byte| byte == self.end).count() - 1;
        self.at += passed.len();
    }

    /// The next line, without its end; none at the end of the file.
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

    /// The next line of a data set; none at its end, and before the line that ends it.
    pub(super) fn record(&mut self) -> Option<&'a [u8]> {
        let (at, number) = (self.at, self.number);
        let line = self.line()?;
        if is_delimiter(line, self.widest) {
            (self.at, self.number) = (at, number);
            return None;
        }
        Some(line)
    }

    /// Goes to the next data set, over what is left of the one before.
    pub(super) fn next_set(&mut self) -> Option<Start> {
        let mut inside = false;
        loop {
            let line = self.line()?;
            if is_delimiter(line, self.widest) {
                // A line that is too much is taken for a start.
                inside = true;
            } else if inside && !line.trim_ascii().is_empty() {
                return Some(start(line));
            }
        }
    }

    /// The end of a data set: the line that ends it and belongs to it.
    pub(super) fn end_set(&mut self) {
        while let Some(line) = self.line() {
            if is_delimiter(line, self.widest) {
                break;
            }
        }
    }

    /// A fault of a record: in the line that was read last.
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

/// Whether a line is `-1` up to a column.
fn is_delimiter(line: &[u8], widest: usize) -> bool {
    line.trim_ascii() == b"-1" && line.trim_ascii_end().len() <= widest
}

/// Whether the end of a data set follows, if need be behind an end of line.
pub(super) fn ends_here(rest: &[u8]) -> bool {
    let rest = rest.strip_prefix(b"\r").unwrap_or(rest);
    let rest = rest.strip_prefix(b"\n").unwrap_or(rest);
    // Without the blanks a byte more of the data would be taken for the first of them.
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
