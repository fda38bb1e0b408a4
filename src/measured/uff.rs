//! Universal files: data set 58, functions at nodal degrees of freedom, as text and binary (58b).
//!
//! Layout: SDRC universal file format, data sets 58 and 164 (Structural Dynamics Research Laboratory, University of
//! Cincinnati). Fields are read by columns, or by blanks if a program does not keep the columns.

mod data;
mod header;
mod lines;
mod quantity;
mod record;
pub(super) mod write;

use std::collections::BTreeMap;

use num_complex::Complex64;

use super::curve::{Curve, CurveBuilder};
use super::{Fault, Hint, MOST_VALUES, Question, fault_at, too_many};
use crate::model::counted;
use crate::unit::{FrequencyUnit, ValueUnit};
use data::Numbers;
use header::FunctionHeader;
use lines::{Start, UffLines};
use quantity::{FileUnits, FunctionQuantity};

/// The frequency responses of a universal file, without those with an unknown frequency unit.
pub(super) fn read(bytes: &[u8], hint: &Hint) -> Result<Vec<Curve>, Fault> {
    let (mut curves, others): (Vec<Curve>, Vec<Curve>) = look(bytes, hint)?
        .into_iter()
        .partition(|curve| curve.unknown_word(Question::Frequency).is_none());
    let word = others
        .first()
        .and_then(|curve| curve.unknown_word(Question::Frequency));
    let Some(word) = word else {
        return Ok(curves);
    };
    let Some(first) = curves.first_mut() else {
        let message = format!("{word:?} does not say {}", Question::Frequency);
        return Err(fault_at("", 1, 1, message));
    };
    let curves_are = counted(others.len(), "curve", "curves");
    let note = format!("{curves_are} over frequencies in {word:?} skipped: unknown unit");
    first.notes.insert(0, note);
    Ok(curves)
}

/// The frequency responses of a universal file.
pub(super) fn look(bytes: &[u8], hint: &Hint) -> Result<Vec<Curve>, Fault> {
    let mut lines = UffLines::new(bytes);
    let mut units = FileUnits::default();
    let mut found = FoundCurves::default();
    let mut number = 0;
    while let Some(start) = lines.next_set() {
        number += 1;
        let taken = match start {
            Start::Text(164) => FileUnits::read(&mut lines, number).map(|read| units = read),
            Start::Text(58) => found.take(&mut lines, number, None, &units, hint),
            Start::Binary(58, header) => {
                found.take(&mut lines, number, Some(&header), &units, hint)
            }
            Start::Text(_) | Start::Binary(..) => Ok(()),
        };
        match taken {
            Err(fault) if lines.rest().trim_ascii().is_empty() => found.truncated(number, fault),
            taken => taken?,
        }
    }
    found.curves(number)
}

/// The curves and problems found in a file.
#[derive(Debug, Default)]
struct FoundCurves {
    curves: Vec<Curve>,
    /// Points and directions of each curve, as text.
    dof_names: Vec<String>,
    values: usize,
    /// Reasons for skipped functions, and their counts.
    skipped: BTreeMap<String, usize>,
    /// Notes on truncated data sets, and the fault of the first one.
    truncated: Vec<String>,
    fault: Option<Fault>,
}

impl FoundCurves {
    fn take(
        &mut self,
        lines: &mut UffLines,
        number: usize,
        binary: Option<&[u8]>,
        units: &FileUnits,
        hint: &Hint,
    ) -> Result<(), Fault> {
        let header = FunctionHeader::read(lines, number)?;
        let quantity = match FunctionQuantity::of(&header, units) {
            Ok(quantity) => quantity,
            Err(why) => {
                *self.skipped.entry(why).or_default() += 1;
                return data::skip(lines, &header, binary);
            }
        };
        self.values = self.values.saturating_add(header.points);
        if self.values > MOST_VALUES {
            let message = too_many();
            return Err(fault_at(
                &format!("data set {number}, record 7"),
                lines.number(),
                11,
                message,
            ));
        }
        let numbers = match binary {
            Some(start) => data::binary(lines, &header, start)?,
            None => data::text(lines, &header)?,
        };
        match numbers {
            Numbers::Complete(numbers) => self.add(&header, &numbers, quantity, hint),
            Numbers::Truncated(fault) => self.truncated(number, fault),
        }
        Ok(())
    }

    /// Adds a function as a curve.
    fn add(
        &mut self,
        header: &FunctionHeader,
        numbers: &[f64],
        mut quantity: FunctionQuantity,
        hint: &Hint,
    ) {
        quantity.complete(hint.layout.as_ref());
        let name = if header.name.is_empty() {
            hint.stem()
        } else {
            header.name.clone()
        };
        let points = points(header, numbers, &quantity);
        let kind = quantity.unit.as_ref().map(ValueUnit::kind);
        if let Some(mut curve) = points.curve(name, header.format.complex, kind) {
            curve.notes.extend(header.notes.iter().cloned());
            curve.notes.extend(quantity.notes);
            curve.unknown = quantity.unknown;
            self.curves.push(curve);
            self.dof_names.push(header.dof_names());
        } else {
            let why = "without a finite value above 0 Hz".to_owned();
            *self.skipped.entry(why).or_default() += 1;
        }
    }

    /// Skips a truncated data set.
    fn truncated(&mut self, number: usize, fault: Fault) {
        let why = fault.message.split(": ").next().unwrap_or_default();
        self.truncated
            .push(format!("data set {number} skipped: {why}"));
        self.fault.get_or_insert(fault);
    }

    /// The curves; curves with the same name get their points and directions appended.
    fn curves(mut self, sets: usize) -> Result<Vec<Curve>, Fault> {
        let notes = self.skipped.iter().map(|(why, count)| {
            let functions = if *count == 1 { "function" } else { "functions" };
            format!("{count} {functions} {why} skipped")
        });
        let notes: Vec<String> = notes.collect();
        if let (true, Some(fault)) = (self.curves.is_empty(), self.fault) {
            return Err(fault);
        }
        let Some(first) = self.curves.first_mut() else {
            let found = if notes.is_empty() {
                counted(sets, "data set of another kind", "data sets of other kinds")
            } else {
                notes.join(", ")
            };
            let message = format!(
                "holds no frequency response: accepted are functions over frequency in data set 58; found: {found}"
            );
            return Err(fault_at("", 1, 1, message));
        };
        first.notes.extend(notes);
        first.notes.splice(0..0, self.truncated);
        let mut names = BTreeMap::<String, usize>::new();
        for curve in &self.curves {
            *names.entry(curve.name.clone()).or_default() += 1;
        }
        for (curve, dof_names) in self.curves.iter_mut().zip(self.dof_names) {
            if names.get(&curve.name).is_some_and(|count| *count > 1) && !dof_names.is_empty() {
                curve.name = format!("{} {dof_names}", curve.name);
            }
        }
        Ok(self.curves)
    }
}

/// The points of a function, in Hz and in its unit.
fn points(header: &FunctionHeader, numbers: &[f64], quantity: &FunctionQuantity) -> CurveBuilder {
    let hertz = quantity.frequency.unwrap_or(FrequencyUnit::Hertz).hertz();
    let mut points = CurveBuilder::default();
    for (index, numbers) in numbers.chunks_exact(header.format.numbers()).enumerate() {
        let (at, value) = numbers.split_at(usize::from(!header.format.even));
        let on_grid = header.first + index as f64 * header.step;
        let at = at.first().copied().unwrap_or(on_grid);
        let value = Complex64::new(value[0], value.get(1).copied().unwrap_or(0.0));
        points.push_in(quantity.unit.as_ref(), at * hertz, value * quantity.sign);
    }
    points
}
