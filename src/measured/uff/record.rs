//! A record of data set 58 and its fields, by columns or, if a program does not keep the columns, by words.

use std::borrow::Cow;
use std::ops::Range;

use super::header::{AxisInfo, DataFormat, Dof};
use super::lines::UffLines;
use crate::measured::{Fault, number, text_of};

/// A record and its number.
pub(super) struct HeaderRecord<'a> {
    set: usize,
    number: usize,
    /// Tabs expanded.
    line: Cow<'a, [u8]>,
}

impl<'a> HeaderRecord<'a> {
    /// The position before the first record of a data set.
    pub(super) const fn new(set: usize) -> Self {
        Self {
            set,
            number: 0,
            line: Cow::Borrowed(&[]),
        }
    }

    /// Reads the next record.
    pub(super) fn next(&mut self, lines: &mut UffLines<'a>) -> Result<(), Fault> {
        self.number += 1;
        let Some(line) = lines.record() else {
            let message = format!("ends before record {}: there are twelve", self.number);
            return Err(self.fault(lines, 0, message));
        };
        self.line = without_tabs(line);
        Ok(())
    }

    pub(super) fn fault(
        &self,
        lines: &UffLines,
        column: usize,
        message: impl Into<String>,
    ) -> Fault {
        lines.fault(self.set, self.number, column + 1, message)
    }

    fn field(&self, columns: Range<usize>) -> &[u8] {
        let end = columns.end.min(self.line.len());
        self.line
            .get(columns.start..end)
            .unwrap_or_default()
            .trim_ascii()
    }

    /// A text; `NONE` is empty.
    pub(super) fn text(&self, columns: Range<usize>) -> String {
        let text = text_of(self.field(columns)).trim().to_owned();
        if text.eq_ignore_ascii_case("none") {
            String::new()
        } else {
            text
        }
    }

    /// An integer; blanks are 0.
    pub(super) fn integer(&self, lines: &UffLines, columns: Range<usize>) -> Result<i64, Fault> {
        let field = self.field(columns.clone());
        let text = std::str::from_utf8(field).ok();
        match text.map(|text| if text.is_empty() { Ok(0) } else { text.parse() }) {
            Some(Ok(number)) => Ok(number),
            _ => Err(self.not_a(lines, "whole number", &columns)),
        }
    }

    /// A number; blanks are 0.
    pub(super) fn real(&self, lines: &UffLines, columns: Range<usize>) -> Result<f64, Fault> {
        match self.field(columns.clone()) {
            [] => Ok(0.0),
            field => {
                number::parse(field, false).ok_or_else(|| self.not_a(lines, "number", &columns))
            }
        }
    }

    fn not_a(&self, lines: &UffLines, what: &str, columns: &Range<usize>) -> Fault {
        let found = text_of(self.field(columns.clone()));
        let (from, to) = (columns.start + 1, columns.end);
        let message =
            format!("{found:?} is not a {what}: one would be accepted in columns {from} to {to}");
        self.fault(lines, columns.start, message)
    }

    /// The columns of numbers with these widths; if the record has as many numbers as fields, their actual columns.
    pub(super) fn fields<const N: usize>(&self, widths: [usize; N]) -> [Range<usize>; N] {
        let words = words(&self.line);
        let is_number =
            |word: &Range<usize>| number::parse(&self.line[word.clone()], false).is_some();
        if let Ok(words) = <[_; N]>::try_from(words)
            && words.iter().all(is_number)
        {
            return words;
        }
        let mut end = 0;
        widths.map(|width| {
            end += width;
            end - width..end
        })
    }

    /// Response and reference of record 6; none if neither columns nor words give them.
    pub(super) fn dofs(&self, lines: &UffLines) -> Result<[Option<Dof>; 2], Fault> {
        // Numbers are right-aligned. A name that is too long shifts the following fields.
        let in_columns = |columns: Range<usize>| {
            let field = self
                .line
                .get(columns.start..self.line.len().min(columns.end));
            let field = field.unwrap_or_default();
            let ends = field.len() == columns.len() && !field.ends_with(b" ");
            ends || field.trim_ascii().is_empty()
        };
        let rest = self.line.get(80..).unwrap_or_default();
        let columns = [41..51, 51..55, 66..76, 76..80];
        if columns.into_iter().all(in_columns) && rest.trim_ascii().is_empty() {
            return Ok([Some(self.dof(lines, 41)?), Some(self.dof(lines, 66)?)]);
        }
        Ok(self
            .dofs_by_words()
            .map_or([None; 2], |ends| ends.map(Some)))
    }

    /// Response and reference after the two names, if the words are unambiguous.
    fn dofs_by_words(&self) -> Option<[Dof; 2]> {
        let words: Vec<Option<i64>> = words(&self.line)
            .into_iter()
            .map(|word| std::str::from_utf8(&self.line[word]).ok()?.parse().ok())
            .collect();
        let (numbers, rest) = words.split_at_checked(4)?;
        let (named, last) = rest.split_at_checked(rest.len().checked_sub(2)?)?;
        let end = |pair: &[Option<i64>]| match *pair {
            [Some(node), Some(direction)] if (-6..=6).contains(&direction) => {
                Some(Dof { node, direction })
            }
            _ => None,
        };
        // The first word is a name, if there are names.
        let names = usize::from(named.len() > 2);
        let mut found = named.get(names..)?.windows(2).filter_map(end);
        let response = found
            .next()
            .filter(|_| numbers.iter().all(Option::is_some))?;
        found.next().is_none().then_some([response, end(last)?])
    }

    /// The node and direction that start at a column.
    fn dof(&self, lines: &UffLines, column: usize) -> Result<Dof, Fault> {
        let node = self.integer(lines, column..column + 10)?;
        let direction = self.integer(lines, column + 10..column + 14)?;
        if (-6..=6).contains(&direction) {
            return Ok(Dof { node, direction });
        }
        Err(self.fault(
            lines,
            column + 10,
            format!("{direction} is not a direction: -6 to 6 would be accepted"),
        ))
    }

    pub(super) fn format(
        &self,
        lines: &UffLines,
        kind: Range<usize>,
        spacing: Range<usize>,
    ) -> Result<DataFormat, Fault> {
        let (complex, double) = match self.integer(lines, kind.clone())? {
            2 => (false, false),
            4 => (false, true),
            5 => (true, false),
            6 => (true, true),
            other => {
                let accepted = "2 and 4 (real), 5 and 6 (complex) would be accepted";
                return Err(self.fault(
                    lines,
                    kind.start,
                    format!("{other} is not an ordinate data type: {accepted}"),
                ));
            }
        };
        let even = match self.integer(lines, spacing.clone())? {
            0 => false,
            1 => true,
            other => {
                let message = format!(
                    "{other} is not an abscissa spacing: 0 (uneven) or 1 (even) would be accepted"
                );
                return Err(self.fault(lines, spacing.start, message));
            }
        };
        Ok(DataFormat {
            complex,
            double,
            even,
        })
    }

    /// Reads the next record, which describes an axis.
    pub(super) fn axis(&mut self, lines: &mut UffLines<'a>) -> Result<AxisInfo, Fault> {
        self.next(lines)?;
        // Two words in the first field: the record is separated by tabs instead of columns.
        let columns = match &words(&self.line)[..] {
            [kind, length, _, _, _, unit, ..] if length.start < 10 => {
                [kind.clone(), length.clone(), unit.start..self.line.len()]
            }
            _ => [0..10, 10..15, 47..67],
        };
        let [kind, length, unit] = columns;
        Ok(AxisInfo {
            kind: self.integer(lines, kind)?,
            length: self.integer(lines, length)?,
            unit: self.text(unit),
        })
    }
}

/// The positions of the words of a line.
fn words(line: &[u8]) -> Vec<Range<usize>> {
    let mut words: Vec<Range<usize>> = Vec::new();
    for (at, byte) in line.iter().enumerate() {
        match words.last_mut() {
            _ if byte.is_ascii_whitespace() => {}
            Some(word) if word.end == at => word.end = at + 1,
            _ => words.push(at..at + 1),
        }
    }
    words
}

/// Expands tabs to every eighth column.
fn without_tabs(line: &[u8]) -> Cow<'_, [u8]> {
    if !line.contains(&b'\t') {
        return Cow::Borrowed(line);
    }
    let mut plain = Vec::with_capacity(line.len() + 8);
    for &byte in line {
        if byte == b'\t' {
            plain.resize((plain.len() / 8 + 1) * 8, b' ');
        } else {
            plain.push(byte);
        }
    }
    Cow::Owned(plain)
}
