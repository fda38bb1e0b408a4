//! A record of data set 58: its fields, by their columns, or by their words where they are not in them.

use std::borrow::Cow;
use std::ops::Range;

use super::head::{Axis, End, Form};
use super::lines::Lines;
use crate::measured::{Fault, number, text_of};

/// A record and its number.
pub(super) struct Record<'a> {
    set: usize,
    number: usize,
    /// Without tabs.
    line: Cow<'a, [u8]>,
}

impl<'a> Record<'a> {
    /// Before the first record of a data set.
    pub(super) const fn new(set: usize) -> Self {
        Self {
            set,
            number: 0,
            line: Cow::Borrowed(&[]),
        }
    }

    /// Goes to the next record.
    pub(super) fn next(&mut self, lines: &mut Lines<'a>) -> Result<(), Fault> {
        self.number += 1;
        let Some(line) = lines.record() else {
            let message = format!("ends before record {}: there are twelve", self.number);
            return Err(self.fault(lines, 0, message));
        };
        self.line = without_tabs(line);
        Ok(())
    }

    pub(super) fn fault(&self, lines: &Lines, column: usize, message: impl Into<String>) -> Fault {
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

    /// A whole number; blanks are 0.
    pub(super) fn integer(&self, lines: &Lines, columns: Range<usize>) -> Result<i64, Fault> {
        let field = self.field(columns.clone());
        let text = std::str::from_utf8(field).ok();
        match text.map(|text| if text.is_empty() { Ok(0) } else { text.parse() }) {
            Some(Ok(number)) => Ok(number),
            _ => Err(self.not_a(lines, "whole number", &columns)),
        }
    }

    /// A number; blanks are 0.
    pub(super) fn real(&self, lines: &Lines, columns: Range<usize>) -> Result<f64, Fault> {
        match self.field(columns.clone()) {
            [] => Ok(0.0),
            field => {
                number::parse(field, false).ok_or_else(|| self.not_a(lines, "number", &columns))
            }
        }
    }

    fn not_a(&self, lines: &Lines, what: &str, columns: &Range<usize>) -> Fault {
        let found = text_of(self.field(columns.clone()));
        let (from, to) = (columns.start + 1, columns.end);
        let message =
            format!("{found:?} is no {what}: one would be accepted in columns {from} to {to}");
        self.fault(lines, columns.start, message)
    }

    /// The columns of numbers that should have these widths: where as many numbers stand as there are fields, they are
    /// those, in whatever columns.
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

    /// Nodes and directions of record 6; none where they are neither in their columns nor found by their words.
    pub(super) fn ends(&self, lines: &Lines) -> Result<[Option<End>; 2], Fault> {
        // Numbers end with their columns. A name that is too long moves what follows.
        let in_place = |columns: Range<usize>| {
            let field = self
                .line
                .get(columns.start..self.line.len().min(columns.end));
            let field = field.unwrap_or_default();
            let ends = field.len() == columns.len() && !field.ends_with(b" ");
            ends || field.trim_ascii().is_empty()
        };
        let rest = self.line.get(80..).unwrap_or_default();
        let columns = [41..51, 51..55, 66..76, 76..80];
        if columns.into_iter().all(in_place) && rest.trim_ascii().is_empty() {
            return Ok([Some(self.end(lines, 41)?), Some(self.end(lines, 66)?)]);
        }
        Ok(self
            .ends_by_words()
            .map_or([None; 2], |ends| ends.map(Some)))
    }

    /// Nodes and directions behind the two names, if there is one way to read them.
    fn ends_by_words(&self) -> Option<[End; 2]> {
        let words: Vec<Option<i64>> = words(&self.line)
            .into_iter()
            .map(|word| std::str::from_utf8(&self.line[word]).ok()?.parse().ok())
            .collect();
        let (numbers, rest) = words.split_at_checked(4)?;
        let (named, last) = rest.split_at_checked(rest.len().checked_sub(2)?)?;
        let end = |pair: &[Option<i64>]| match *pair {
            [Some(node), Some(direction)] if (-6..=6).contains(&direction) => {
                Some(End { node, direction })
            }
            _ => None,
        };
        // The first word is a name, where there are names.
        let names = usize::from(named.len() > 2);
        let mut found = named.get(names..)?.windows(2).filter_map(end);
        let response = found
            .next()
            .filter(|_| numbers.iter().all(Option::is_some))?;
        found.next().is_none().then_some([response, end(last)?])
    }

    /// Node and direction from a column on.
    fn end(&self, lines: &Lines, column: usize) -> Result<End, Fault> {
        let node = self.integer(lines, column..column + 10)?;
        let direction = self.integer(lines, column + 10..column + 14)?;
        if (-6..=6).contains(&direction) {
            return Ok(End { node, direction });
        }
        Err(self.fault(
            lines,
            column + 10,
            format!("{direction} is no direction: -6 to 6 would be accepted"),
        ))
    }

    pub(super) fn form(
        &self,
        lines: &Lines,
        kind: Range<usize>,
        spacing: Range<usize>,
    ) -> Result<Form, Fault> {
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
                    format!("{other} is no ordinate data type: {accepted}"),
                ));
            }
        };
        let even = match self.integer(lines, spacing.clone())? {
            0 => false,
            1 => true,
            other => {
                let message = format!(
                    "{other} is no abscissa spacing: 0 (uneven) or 1 (even) would be accepted"
                );
                return Err(self.fault(lines, spacing.start, message));
            }
        };
        Ok(Form {
            complex,
            double,
            even,
        })
    }

    /// The next record, which describes an axis.
    pub(super) fn axis(&mut self, lines: &mut Lines<'a>) -> Result<Axis, Fault> {
        self.next(lines)?;
        // Two words in the first field: tabs part what should be in columns.
        let columns = match &words(&self.line)[..] {
            [kind, length, _, _, _, unit, ..] if length.start < 10 => {
                [kind.clone(), length.clone(), unit.start..self.line.len()]
            }
            _ => [0..10, 10..15, 47..67],
        };
        let [kind, length, unit] = columns;
        Ok(Axis {
            kind: self.integer(lines, kind)?,
            length: self.integer(lines, length)?,
            unit: self.text(unit),
        })
    }
}

/// The places of the words of a line.
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

/// A line with blanks up to every eighth column for tabs.
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
