//! Universal files: data set 58, functions at nodal degrees of freedom, as text and binary (58b).
//!
//! Layout: SDRC universal file format, data sets 58 and 164 (Structural Dynamics Research Laboratory, University of
//! Cincinnati). Fields are read by their columns; where other programs do not keep to them, by the blanks between them.

mod data;
mod head;
mod lines;
mod meaning;
mod record;
pub(super) mod write;

use std::collections::BTreeMap;

use num_complex::Complex64;

use super::curve::{Curve, Points};
use super::{Fault, Hint, MOST_VALUES, Question, fault_at, too_many};
use crate::model::counted;
use crate::unit::{FrequencyUnit, ValueUnit};
use data::Numbers;
use head::Head;
use lines::{Lines, Start};
use meaning::{Meaning, Units};

/// The frequency responses of a universal file, without those whose frequencies are in a unit that is not known.
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
    let note = format!("{curves_are} over frequencies in {word:?} left out: no unit that is known");
    first.notes.insert(0, note);
    Ok(curves)
}

/// The frequency responses of a universal file.
pub(super) fn look(bytes: &[u8], hint: &Hint) -> Result<Vec<Curve>, Fault> {
    let mut lines = Lines::new(bytes);
    let mut units = Units::default();
    let mut found = Found::default();
    let mut number = 0;
    while let Some(start) = lines.next_set() {
        number += 1;
        let taken = match start {
            Start::Text(164) => Units::read(&mut lines, number).map(|read| units = read),
            Start::Text(58) => found.take(&mut lines, number, None, &units, hint),
            Start::Binary(58, head) => found.take(&mut lines, number, Some(&head), &units, hint),
            Start::Text(_) | Start::Binary(..) => Ok(()),
        };
        match taken {
            Err(fault) if lines.rest().trim_ascii().is_empty() => found.cut_off(number, fault),
            taken => taken?,
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
    /// What is said of data sets that are cut off, and what is wrong with the first.
    cut_off: Vec<String>,
    fault: Option<Fault>,
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
        match numbers {
            Numbers::All(numbers) => self.add(&head, &numbers, meaning, hint),
            Numbers::CutOff(fault) => self.cut_off(number, fault),
        }
        Ok(())
    }

    /// Adds a function as a curve.
    fn add(&mut self, head: &Head, numbers: &[f64], mut meaning: Meaning, hint: &Hint) {
        meaning.answer(hint.layout.as_ref());
        let name = if head.name.is_empty() {
            hint.stem()
        } else {
            head.name.clone()
        };
        let points = points(head, numbers, &meaning);
        let kind = meaning.unit.as_ref().map(ValueUnit::kind);
        if let Some(mut curve) = points.curve(name, head.form.complex, kind) {
            curve.notes.extend(head.notes.iter().cloned());
            curve.notes.extend(meaning.notes);
            curve.unknown = meaning.unknown;
            self.curves.push(curve);
            self.places.push(head.places());
        } else {
            let why = "without a finite value above 0 Hz".to_owned();
            *self.left_out.entry(why).or_default() += 1;
        }
    }

    /// Leaves out a data set that ends early.
    fn cut_off(&mut self, number: usize, fault: Fault) {
        let why = fault.message.split(": ").next().unwrap_or_default();
        self.cut_off
            .push(format!("data set {number} left out: {why}"));
        self.fault.get_or_insert(fault);
    }

    /// The curves; those that share a name get their places.
    fn curves(mut self, sets: usize) -> Result<Vec<Curve>, Fault> {
        let notes = self.left_out.iter().map(|(why, count)| {
            let functions = if *count == 1 { "function" } else { "functions" };
            format!("{count} {functions} {why} left out")
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
        first.notes.splice(0..0, self.cut_off);
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

/// The points of a function in Hz and its unit.
fn points(head: &Head, numbers: &[f64], meaning: &Meaning) -> Points {
    let hertz = meaning.frequency.unwrap_or(FrequencyUnit::Hertz).hertz();
    let mut points = Points::default();
    for (index, numbers) in numbers.chunks_exact(head.form.numbers()).enumerate() {
        let (at, value) = numbers.split_at(usize::from(!head.form.even));
        let on_grid = head.first + index as f64 * head.step;
        let at = at.first().copied().unwrap_or(on_grid);
        let value = Complex64::new(value[0], value.get(1).copied().unwrap_or(0.0));
        points.push_in(meaning.unit.as_ref(), at * hertz, value * meaning.sign);
    }
    points
}
