//! Records 1 to 11 of data set 58.

use super::lines::UffLines;
use super::record::HeaderRecord;
use crate::measured::Fault;

/// The header of a function.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FunctionHeader {
    /// Number of the data set in the file.
    pub(super) set: usize,
    /// ID line 1; may be empty.
    pub(super) name: String,
    /// 4 is a frequency response function.
    pub(super) function: i64,
    pub(super) response: Dof,
    pub(super) reference: Dof,
    pub(super) format: DataFormat,
    /// Number of values.
    pub(super) points: usize,
    /// First abscissa, if evenly spaced.
    pub(super) first: f64,
    /// Step of the abscissa.
    pub(super) step: f64,
    pub(super) abscissa: AxisInfo,
    pub(super) ordinate: AxisInfo,
    pub(super) denominator: AxisInfo,
    pub(super) notes: Vec<String>,
}

/// A degree of freedom: node and direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Dof {
    pub(super) node: i64,
    /// 1 to 3 translations, 4 to 6 rotations, negative opposite to the axis; 0 scalar.
    pub(super) direction: i64,
}

/// The format of the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct DataFormat {
    pub(super) complex: bool,
    pub(super) double: bool,
    /// Evenly spaced; the abscissae are then not in the data.
    pub(super) even: bool,
}

/// The quantity of an axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct AxisInfo {
    /// Specific data type.
    pub(super) kind: i64,
    /// Exponent of length in its unit, for a general type or a scalar direction.
    pub(super) length: i64,
    /// Its unit label; may be empty.
    pub(super) unit: String,
}

impl DataFormat {
    /// Numbers per value: abscissa, real part, imaginary part.
    pub(super) const fn numbers(self) -> usize {
        1 + self.complex as usize + !self.even as usize
    }

    /// Fewest bytes of `points` values in a binary data set.
    pub(super) const fn least_bytes(self, points: usize) -> usize {
        let abscissa = if self.even { 0 } else { 4 };
        let part = if self.double { 8 } else { 4 };
        points * (abscissa + part * (1 + self.complex as usize))
    }
}

impl Dof {
    const UNKNOWN: Self = Self {
        node: 0,
        direction: 0,
    };
}

impl FunctionHeader {
    /// Reads records 1 to 11.
    pub(super) fn read(lines: &mut UffLines, set: usize) -> Result<Self, Fault> {
        let mut record = HeaderRecord::new(set);
        record.next(lines)?;
        let name = record.text(0..80);
        for _ in 2..=6 {
            record.next(lines)?;
        }
        let function = record.integer(lines, 0..5)?;
        let [response, reference] = record.dofs(lines)?;
        let mut notes = Vec::new();
        if response.is_none() || reference.is_none() {
            notes.push(
                "points and directions are not in their columns: they are ignored".to_owned(),
            );
        }
        record.next(lines)?;
        let [kind, count, spacing, first, step, _] = record.fields([10, 10, 10, 13, 13, 13]);
        let format = record.format(lines, kind, spacing)?;
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
        if format.even && points > 1 && !(first.is_finite() && step.is_finite() && step != 0.0) {
            let message = format!(
                "even abscissae from {first} with a step of {step}: finite numbers and a step other than 0 would be accepted"
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
            response: response.unwrap_or(Dof::UNKNOWN),
            reference: reference.unwrap_or(Dof::UNKNOWN),
            format,
            points,
            first,
            step,
            abscissa,
            ordinate,
            denominator,
            notes,
        })
    }

    /// Response and reference, `12:+Z / 1:+Y`; empty if they are not given.
    pub(super) fn dof_names(&self) -> String {
        let name = |dof: Dof| {
            let axis = ["", "X", "Y", "Z", "RX", "RY", "RZ"];
            let axis = axis
                .get(dof.direction.unsigned_abs() as usize)
                .copied()
                .unwrap_or_default();
            let sign = match dof.direction {
                0 => "",
                1.. => ":+",
                _ => ":-",
            };
            format!("{}{sign}{axis}", dof.node)
        };
        let is_given = |dof: Dof| dof.node != 0 || dof.direction != 0;
        match (is_given(self.response), is_given(self.reference)) {
            (true, true) => format!("{} / {}", name(self.response), name(self.reference)),
            (true, false) => name(self.response),
            _ => String::new(),
        }
    }
}
