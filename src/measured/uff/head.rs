//! Records 1 to 11 of data set 58.

use super::lines::Lines;
use super::record::Record;
use crate::measured::Fault;

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
    pub(super) notes: Vec<String>,
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

    /// Bytes that this many values have at least in a binary data set.
    pub(super) const fn least_bytes(self, points: usize) -> usize {
        let abscissa = if self.even { 0 } else { 4 };
        let part = if self.double { 8 } else { 4 };
        points * (abscissa + part * (1 + self.complex as usize))
    }
}

impl End {
    const UNSAID: Self = Self {
        node: 0,
        direction: 0,
    };
}

impl Head {
    /// Reads the eleven records.
    pub(super) fn read(lines: &mut Lines, set: usize) -> Result<Self, Fault> {
        let mut record = Record::new(set);
        record.next(lines)?;
        let name = record.text(0..80);
        for _ in 2..=6 {
            record.next(lines)?;
        }
        let function = record.integer(lines, 0..5)?;
        let [response, reference] = record.ends(lines)?;
        let mut notes = Vec::new();
        if response.is_none() || reference.is_none() {
            notes.push("points and directions are not in their columns: none are taken".to_owned());
        }
        record.next(lines)?;
        let [kind, count, spacing, first, step, _] = record.fields([10, 10, 10, 13, 13, 13]);
        let form = record.form(lines, kind, spacing)?;
        let points = record.integer(lines, count.clone())?;
        let points = usize::try_from(points).map_err(|_| {
            record.fault(
                lines,
                count.start,
                format!("{points} values: 0 or more would be accepted"),
            )
        })?;
        let column = step.start;
        let (first, step) = (record.real(lines, first)?, record.real(lines, step)?);
        if form.even && points > 1 && !(first.is_finite() && step.is_finite() && step != 0.0) {
            let message = format!(
                "even abscissae from {first} with a step of {step}: finite numbers and another step than 0 would be accepted"
            );
            return Err(record.fault(lines, column, message));
        }
        let abscissa = record.axis(lines)?;
        let ordinate = record.axis(lines)?;
        let denominator = record.axis(lines)?;
        record.next(lines)?;
        Ok(Self {
            set,
            name,
            function,
            response: response.unwrap_or(End::UNSAID),
            reference: reference.unwrap_or(End::UNSAID),
            form,
            points,
            first,
            step,
            abscissa,
            ordinate,
            denominator,
            notes,
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
