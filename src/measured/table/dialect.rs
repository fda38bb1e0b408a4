//! How a table is written: what parts its cells, where its numbers start, and what stands above them.

use super::rows::{for_each_record, is_comment, line_at};
use crate::measured::layout::{FrequencyUnit, PhaseUnit};
use crate::measured::unit::ValueUnit;
use crate::measured::{Fault, fault_at, text_of};

/// How far into a table its first numbers are looked for, bytes.
const SAMPLE: usize = 1 << 16;

/// Rows that are looked at.
const MOST_ROWS: usize = 400;

/// What parts the cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::measured) enum Separator {
    /// A comma, a semicolon or a tab.
    Byte(u8),
    /// Blanks, any number of them.
    Blanks,
}

/// How a table is written.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::measured) struct Dialect {
    pub(in crate::measured) separator: Separator,
    /// Offset at or before the first row of numbers, and behind the header.
    pub(super) start: usize,
    /// The words above the columns; as many as columns, or none.
    pub(in crate::measured) header: Vec<String>,
    /// Number of columns.
    pub(in crate::measured) width: usize,
    /// Whether the first column names curves.
    pub(super) has_curves: bool,
    /// The first rows of numbers, as they stand.
    pub(in crate::measured) first_rows: Vec<Vec<String>>,
}

/// A row of the sample.
type Cells = Vec<String>;

impl Separator {
    const ALL: [Self; 4] = [
        Self::Byte(b'\t'),
        Self::Byte(b';'),
        Self::Byte(b','),
        Self::Blanks,
    ];

    /// Whether a comma may part the decimals.
    pub(super) fn allows_decimal_comma(self) -> bool {
        self != Self::Byte(b',')
    }

    /// Its name.
    pub(in crate::measured) const fn name(self) -> &'static str {
        match self {
            Self::Byte(b'\t') => "tabs",
            Self::Byte(b';') => "semicolons",
            Self::Byte(_) => "commas",
            Self::Blanks => "blanks",
        }
    }
}

impl Dialect {
    /// Finds it in the first part of a table.
    ///
    /// # Errors
    /// No row of numbers is there.
    pub(in crate::measured) fn of(bytes: &[u8]) -> Result<Self, Fault> {
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            let message = "is text in UTF-16: text in UTF-8 or ASCII would be accepted";
            return Err(fault_at("", 1, 1, message));
        }
        let body = body(bytes);
        let found = Separator::ALL
            .into_iter()
            .map(|separator| Sample::of(bytes, body, separator));
        // Of equals the first: tabs are blanks, too.
        let best = found.rev().max_by_key(Sample::conforming);
        let Some(sample) = best.filter(|sample| sample.conforming() > 0) else {
            return Err(fault_at(
                "",
                line_at(bytes, 0),
                1,
                format!(
                    "no row of two or more numbers in the first {} KiB: accepted are columns of numbers with commas, \
                     semicolons, tabs or blanks between them",
                    SAMPLE >> 10
                ),
            ));
        };
        Ok(sample.dialect(last_comment(bytes, body)))
    }

    /// The line of the first row of numbers.
    pub(super) fn first_line(&self, bytes: &[u8]) -> usize {
        line_at(bytes, self.start)
    }
}

/// The first rows of a table as one separator parts them.
struct Sample {
    separator: Separator,
    rows: Vec<(usize, Cells)>,
    /// Index of the first row of numbers.
    first: usize,
    has_curves: bool,
}

impl Sample {
    fn of(bytes: &[u8], body: usize, separator: Separator) -> Self {
        let mut rows = Vec::new();
        // The last row may be cut off.
        let end = match body + SAMPLE {
            end if end >= bytes.len() => bytes.len(),
            end => match bytes[body..end].iter().rposition(|&byte| byte == b'\n') {
                Some(last) => body + last,
                None => end,
            },
        };
        // A failure ends the sample, and nothing else fails here.
        let _ = for_each_record(bytes, body, end, separator, |offset, record| {
            rows.push((offset, record.iter().map(text_of).collect()));
            if rows.len() < MOST_ROWS {
                Ok(())
            } else {
                Err(Fault::new("", ""))
            }
        });
        let mut sample = Self {
            separator,
            first: rows.len(),
            rows,
            has_curves: false,
        };
        for index in 0..sample.rows.len() {
            let header = index.checked_sub(1).map(|above| &sample.rows[above].1);
            let above = header.and_then(|cells| cells.first());
            sample.has_curves = above.is_some_and(|word| word.trim().eq_ignore_ascii_case("curve"));
            let next = index + 1;
            if sample.is_numbers(index) && (next == sample.rows.len() || sample.is_numbers(next)) {
                sample.first = index;
                break;
            }
        }
        sample
    }

    /// Whether a row is of two or more numbers and nothing else.
    fn is_numbers(&self, index: usize) -> bool {
        let cells = self.rows[index].1.iter().skip(usize::from(self.has_curves));
        let comma = self.separator.allows_decimal_comma();
        let mut numbers = 0;
        for cell in cells {
            match super::number_of(cell.as_bytes(), comma) {
                Some(_) => numbers += usize::from(!cell.trim().is_empty()),
                None => return false,
            }
        }
        numbers >= 2
    }

    /// How many rows are of numbers.
    fn conforming(&self) -> usize {
        (self.first..self.rows.len())
            .filter(|&index| self.is_numbers(index))
            .count()
    }

    fn dialect(self, comment: Option<String>) -> Dialect {
        let width = |cells: &Cells| {
            cells
                .iter()
                .rposition(|cell| !cell.trim().is_empty())
                .map_or(0, |last| last + 1)
        };
        let numbers: Vec<&Cells> = (self.first..self.rows.len())
            .filter(|&index| self.is_numbers(index))
            .map(|index| &self.rows[index].1)
            .collect();
        let columns = numbers.iter().map(|cells| width(cells)).max().unwrap_or(0);
        let above: Vec<&Cells> = self.rows[..self.first]
            .iter()
            .map(|(_, cells)| cells)
            .collect();
        let comment = comment.map(|line| split(&line, self.separator));
        let header = header(&above, columns).or(comment.filter(|cells| cells.len() == columns));
        Dialect {
            separator: self.separator,
            start: self.rows[self.first].0,
            header: header.unwrap_or_default(),
            width: columns,
            has_curves: self.has_curves,
            first_rows: numbers
                .iter()
                .take(5)
                .map(|cells| (*cells).clone())
                .collect(),
        }
    }
}

/// The header of some columns in the last rows above them: of words, and of units below them where there are such.
fn header(above: &[&Cells], columns: usize) -> Option<Vec<String>> {
    let fits = |cells: &&&Cells| {
        cells.len() >= columns && cells.iter().filter(|cell| !cell.is_empty()).count() >= 2
    };
    let cut = |cells: &Cells| cells[..columns].to_vec();
    let (last, before) = above.split_last()?;
    let words = before.last().filter(fits);
    if let Some(words) = words.filter(|_| fits(&last) && last.iter().all(|cell| is_unit(cell))) {
        let with_unit = |(word, unit): (&String, &String)| match bare(unit) {
            "" | "-" => word.clone(),
            unit => format!("{word} [{unit}]"),
        };
        return Some(
            words
                .iter()
                .zip(last.iter())
                .take(columns)
                .map(with_unit)
                .collect(),
        );
    }
    Some(*last).filter(|last| fits(&last)).map(cut)
}

/// Whether a cell is a unit and nothing else.
fn is_unit(cell: &str) -> bool {
    let word = bare(cell);
    matches!(word.to_ascii_lowercase().as_str(), "" | "-" | "db")
        || FrequencyUnit::from_word(word).is_some()
        || PhaseUnit::from_word(word).is_some()
        || ValueUnit::parse(word).is_ok()
}

/// A word without brackets around it.
fn bare(word: &str) -> &str {
    let word = word.trim();
    let inside = |open, close| word.strip_prefix(open)?.strip_suffix(close);
    inside('[', ']').or(inside('(', ')')).unwrap_or(word).trim()
}

/// The words of a comment that stands above columns.
fn split(line: &str, separator: Separator) -> Vec<String> {
    match separator {
        Separator::Byte(byte) => line
            .split(char::from(byte))
            .map(|cell| cell.trim().to_owned())
            .collect(),
        Separator::Blanks => {
            let mut cells: Vec<String> = Vec::new();
            for word in line.split_whitespace() {
                match cells.last_mut() {
                    // A unit belongs to the word before it.
                    Some(cell) if word.starts_with(['[', '(']) => *cell = format!("{cell} {word}"),
                    Some(cell) if cell.contains('[') && !cell.contains(']') => {
                        *cell = format!("{cell} {word}");
                    }
                    _ => cells.push(word.to_owned()),
                }
            }
            cells
        }
    }
}

/// Where the first line starts that is neither empty nor a comment, behind a byte order mark.
fn body(bytes: &[u8]) -> usize {
    let mut at = if bytes.starts_with(b"\xef\xbb\xbf") {
        3
    } else {
        0
    };
    for line in bytes[at..].split_inclusive(|&byte| byte == b'\n') {
        match line.trim_ascii_start().first() {
            Some(first) if !is_comment(*first) => break,
            _ => at += line.len(),
        }
    }
    at
}

/// The last comment above the body, without the signs that make it one.
fn last_comment(bytes: &[u8], body: usize) -> Option<String> {
    let mut lines = bytes[..body].rsplit(|&byte| byte == b'\n');
    let line = lines.find(|line| !line.trim_ascii().is_empty())?;
    let line = text_of(line);
    Some(
        line.trim_start_matches(['\u{feff}', ' ', '#', '%', '!'])
            .trim()
            .to_owned(),
    )
}
