//! Universal files: data set 58, functions at nodal degrees of freedom, as text and binary (58b).
//!
//! Layout: SDRC universal file format, data sets 58 and 164 (Structural Dynamics Research Laboratory, University of
//! Cincinnati). Fields are read by their columns.

mod data;
mod head;
mod lines;
mod meaning;
pub(super) mod write;

use std::collections::BTreeMap;

use num_complex::Complex64;

use super::curve::{Curve, Points};
use super::{Fault, Hint, MOST_VALUES, ValueUnit, fault_at, too_many};
use head::Head;
use lines::{Lines, Start};
use meaning::{Meaning, Units};

/// The frequency responses of a universal file.
pub(super) fn read(bytes: &[u8], hint: &Hint) -> Result<Vec<Curve>, Fault> {
    let mut lines = Lines::new(bytes);
    let mut units = Units::default();
    let mut found = Found::default();
    let mut number = 0;
    while let Some(start) = lines.next_set() {
        number += 1;
        match start {
            Start::Text(164) => units = Units::read(&mut lines, number)?,
            Start::Text(58) => found.take(&mut lines, number, None, &units, hint)?,
            Start::Binary(58, head) => found.take(&mut lines, number, Some(&head), &units, hint)?,
            Start::Text(_) | Start::Binary(..) => {}
        }
    }
    found.curves(number)
}

/// What was found in a file.
#[derive(Debug, Default)]
struct Found {
    curves: Vec<Curve>,
    /// Points and directions of each curve, in words.
    places: Vec<String>,
    values: usize,
    /// Why functions were left out, and how many.
    left_out: BTreeMap<String, usize>,
}

impl Found {
    fn take(
        &mut self,
        lines: &mut Lines,
        number: usize,
        binary: Option<&[u8]>,
        units: &Units,
        hint: &Hint,
    ) -> Result<(), Fault> {
        let head = Head::read(lines, number)?;
        let meaning = match Meaning::of(&head, units) {
            Ok(meaning) => meaning,
            Err(why) => {
                *self.left_out.entry(why).or_default() += 1;
                return data::pass(lines, &head, binary);
            }
        };
        self.values = self.values.saturating_add(head.points);
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
            Some(start) => data::binary(lines, &head, start)?,
            None => data::text(lines, &head)?,
        };
        let asked = hint.layout.as_ref().and_then(|layout| layout.unit.as_ref());
        let unit = meaning.unit.as_ref().or(asked);
        let name = if head.name.is_empty() {
            hint.stem()
        } else {
            head.name.clone()
        };
        let points = points(&head, &numbers, &meaning, unit);
        let kind = unit.map(ValueUnit::kind);
        if let Some(mut curve) = points.curve(name, head.form.complex, kind) {
            curve.notes.extend(meaning.notes);
            self.curves.push(curve);
            self.places.push(head.places());
        } else {
            let why = "without a finite value above 0 Hz".to_owned();
            *self.left_out.entry(why).or_default() += 1;
        }
        Ok(())
    }

    /// The curves; those that share a name get their places.
    fn curves(mut self, sets: usize) -> Result<Vec<Curve>, Fault> {
        let notes = self.left_out.iter().map(|(why, count)| {
            let functions = if *count == 1 { "function" } else { "functions" };
            format!("{count} {functions} {why} left out")
        });
        let notes: Vec<String> = notes.collect();
        let Some(first) = self.curves.first_mut() else {
            let found = if notes.is_empty() {
                format!("{sets} data sets of other kinds")
            } else {
                notes.join(", ")
            };
            let message = format!(
                "holds no frequency response: accepted are functions over frequency in data set 58; found: {found}"
            );
            return Err(fault_at("", 1, 1, message));
        };
        first.notes.extend(notes);
        let mut names = BTreeMap::<String, usize>::new();
        for curve in &self.curves {
            *names.entry(curve.name.clone()).or_default() += 1;
        }
        for (curve, places) in self.curves.iter_mut().zip(self.places) {
            if names.get(&curve.name).is_some_and(|count| *count > 1) && !places.is_empty() {
                curve.name = format!("{} {places}", curve.name);
            }
        }
        Ok(self.curves)
    }
}

/// The points of a function in Hz and a unit.
fn points(head: &Head, numbers: &[f64], meaning: &Meaning, unit: Option<&ValueUnit>) -> Points {
    let mut points = Points::default();
    for (index, numbers) in numbers.chunks_exact(head.form.numbers()).enumerate() {
        let (at, value) = numbers.split_at(usize::from(!head.form.even));
        let on_grid = head.first + index as f64 * head.step;
        let at = at.first().copied().unwrap_or(on_grid);
        let value = Complex64::new(value[0], value.get(1).copied().unwrap_or(0.0));
        points.push_in(unit, at * meaning.hertz, value * meaning.sign);
    }
    points
}
