//! Records 1 to 11 of data set 58.

use std::ops::Range;

use super::lines::Lines;
use crate::measured::{Fault, number, text_of};

/// What stands above the data of a function.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Head {
    /// Number of the data set in the file.
    pub(super) set: usize,
    /// ID line 1; empty where there is none.
    pub(super) name: String,
    /// 4 is a frequency response function.
    pub(super) function: i64,
    pub(super) response: End,
    pub(super) reference: End,
    pub(super) form: Form,
    /// Number of values.
    pub(super) points: usize,
    /// First abscissa, where they are even.
    pub(super) first: f64,
    /// Step of the abscissa.
    pub(super) step: f64,
    pub(super) abscissa: Axis,
    pub(super) ordinate: Axis,
    pub(super) denominator: Axis,
}

/// A node and a direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct End {
    pub(super) node: i64,
    /// 1 to 3 translations, 4 to 6 rotations, negative against the axis; 0 a scalar.
    pub(super) direction: i64,
}

/// How the data are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Form {
    pub(super) complex: bool,
    pub(super) double: bool,
    /// Even abscissae are not written.
    pub(super) even: bool,
}

/// What an axis is of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Axis {
    /// Specific data type.
    pub(super) kind: i64,
    /// Exponent of length in its unit, where the type is general or the direction a scalar.
    pub(super) length: i64,
    /// Its unit in words; empty where there are none.
    pub(super) unit: String,
}

impl Form {
    /// Numbers a value: abscissa, real part, imaginary part.
    pub(super) const fn numbers(self) -> usize {
        1 + self.complex as usize + !self.even as usize
    }
}

impl Head {
    /// Reads the eleven records.
    pub(super) fn read(lines: &mut Lines, set: usize) -> Result<Self, Fault> {
        let mut record = Record {
            set,
            number: 0,
            line: &[],
        };
        record.next(lines)?;
        let name = record.text(0..80);
        for _ in 2..=6 {
            record.next(lines)?;
        }
        let function = record.integer(lines, 0..5)?;
        let response = record.end(lines, 41)?;
        let reference = record.end(lines, 66)?;
        record.next(lines)?;
        let form = record.form(lines)?;
        let points = record.integer(lines, 10..20)?;
        let points = usize::try_from(points).map_err(|_| {
            record.fault(
                lines,
                10,
                format!("{points} values: 0 or more would be accepted"),
            )
        })?;
        let (first, step) = (record.real(lines, 30..43)?, record.real(lines, 43..56)?);
        if form.even && points > 1 && !(first.is_finite() && step.is_finite() && step != 0.0) {
            let message = format!(
                "even abscissae with a step of {step}: another number than 0 would be accepted"
            );
            return Err(record.fault(lines, 43, message));
        }
        let abscissa = record.axis(lines)?;
        let ordinate = record.axis(lines)?;
        let denominator = record.axis(lines)?;
        record.next(lines)?;
        Ok(Self {
            set,
            name,
            function,
            response,
            reference,
            form,
            points,
            first,
            step,
            abscissa,
            ordinate,
            denominator,
        })
    }

    /// Nodes and directions, `12:+Z / 1:+Y`; empty where they are not said.
    pub(super) fn places(&self) -> String {
        let place = |end: End| {
            let axis = ["", "X", "Y", "Z", "RX", "RY", "RZ"];
            let axis = axis
                .get(end.direction.unsigned_abs() as usize)
                .copied()
                .unwrap_or_default();
            let sign = match end.direction {
                0 => "",
                1.. => ":+",
                _ => ":-",
            };
            format!("{}{sign}{axis}", end.node)
        };
        let said = |end: End| end.node != 0 || end.direction != 0;
        match (said(self.response), said(self.reference)) {
            (true, true) => format!("{} / {}", place(self.response), place(self.reference)),
            (true, false) => place(self.response),
            _ => String::new(),
        }
    }
}

/// A record and its number.
struct Record<'a> {
    set: usize,
    number: usize,
    line: &'a [u8],
}

impl<'a> Record<'a> {
    fn next(&mut self, lines: &mut Lines<'a>) -> Result<(), Fault> {
        self.number += 1;
        match lines.record() {
            Some(line) => {
                self.line = line;
                Ok(())
            }
            None => Err(self.fault(
                lines,
                0,
                "the data set ends before this record; data set 58 has twelve",
            )),
        }
    }

    fn fault(&self, lines: &Lines, column: usize, message: impl Into<String>) -> Fault {
        lines.fault(self.set, self.number, column + 1, message)
    }

    fn field(&self, columns: Range<usize>) -> &'a [u8] {
        let end = columns.end.min(self.line.len());
        self.line
            .get(columns.start..end)
            .unwrap_or_default()
            .trim_ascii()
    }

    /// A text; `NONE` is empty.
    fn text(&self, columns: Range<usize>) -> String {
        let text = text_of(self.field(columns)).trim().to_owned();
        if text.eq_ignore_ascii_case("none") {
            String::new()
        } else {
            text
        }
    }

    /// A whole number; blanks are 0.
    fn integer(&self, lines: &Lines, columns: Range<usize>) -> Result<i64, Fault> {
        let field = self.field(columns.clone());
        let text = std::str::from_utf8(field).ok();
        match text.map(|text| if text.is_empty() { Ok(0) } else { text.parse() }) {
            Some(Ok(number)) => Ok(number),
            _ => Err(self.not_a(lines, "whole number", &columns)),
        }
    }

    /// A number; blanks are 0.
    fn real(&self, lines: &Lines, columns: Range<usize>) -> Result<f64, Fault> {
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

    fn form(&self, lines: &Lines) -> Result<Form, Fault> {
        let (complex, double) = match self.integer(lines, 0..10)? {
            2 => (false, false),
            4 => (false, true),
            5 => (true, false),
            6 => (true, true),
            other => {
                let accepted = "2 and 4 (real), 5 and 6 (complex) would be accepted";
                return Err(self.fault(
                    lines,
                    0,
                    format!("{other} is no ordinate data type: {accepted}"),
                ));
            }
        };
        let even = match self.integer(lines, 20..30)? {
            0 => false,
            1 => true,
            other => {
                let message = format!(
                    "{other} is no abscissa spacing: 0 (uneven) or 1 (even) would be accepted"
                );
                return Err(self.fault(lines, 20, message));
            }
        };
        Ok(Form {
            complex,
            double,
            even,
        })
    }

    /// The next record, which describes an axis.
    fn axis(&mut self, lines: &mut Lines<'a>) -> Result<Axis, Fault> {
        self.next(lines)?;
        Ok(Axis {
            kind: self.integer(lines, 0..10)?,
            length: self.integer(lines, 10..15)?,
            unit: self.text(47..67),
        })
    }
}
