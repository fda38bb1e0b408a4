//! Tables of numbers as text: comma-, semicolon-, tab- or blank-separated.

mod columns;
mod dialect;
mod head;
mod plan;
mod rows;

use std::collections::HashMap;

use num_complex::Complex64;

use super::curve::{Curve, Points};
use super::{Fault, Hint, MOST_VALUES, fault_at, number, text_of, too_many};
use crate::table::unquoted;
pub(super) use columns::Columns;
use columns::Group;
pub(super) use dialect::Dialect;
pub(super) use plan::Plan;
use rows::{Row, for_each_row};

/// The curves of a table.
pub(super) fn read(bytes: &[u8], hint: &Hint) -> Result<Vec<Curve>, Fault> {
    let dialect = Dialect::of(bytes)?;
    let plan = Plan::new(&dialect, hint)?;
    if let Some(question) = plan.missing.iter().find(|missing| missing.is_needed()) {
        let message = format!("the table does not say {question}");
        return Err(fault_at("", dialect.first_line(bytes), 1, message));
    }
    let mut tables = Tables::default();
    for_each_row(bytes, &dialect, |row| tables.take(&row, &plan))?;
    let mut curves = tables.curves(&plan);
    let Some(first) = curves.first_mut() else {
        let message = "no row has a frequency above 0 and a finite value";
        return Err(fault_at("", dialect.first_line(bytes), 1, message));
    };
    first.notes.extend(plan.notes);
    Ok(curves)
}

/// The points of each group of columns, for each word in the column `curve`.
#[derive(Debug, Default)]
struct Tables {
    keys: Vec<String>,
    index: HashMap<Vec<u8>, usize>,
    /// A list a key, an entry a group.
    points: Vec<Vec<Points>>,
    taken: usize,
}

impl Tables {
    fn take(&mut self, row: &Row, plan: &Plan) -> Result<(), Fault> {
        let (column, unit) = plan.frequency;
        let frequency = row.number(column)? * unit.hertz();
        let key = plan.curve.map_or(&b""[..], |column| row.cell(column));
        let index = self.index_of(key, plan.groups.len());
        self.taken += plan.groups.len();
        if self.taken > MOST_VALUES {
            return Err(row.fault(column, too_many()));
        }
        for (group, points) in plan.groups.iter().zip(&mut self.points[index]) {
            points.push_in(group.unit.as_ref(), frequency, value(row, group)?);
        }
        Ok(())
    }

    fn index_of(&mut self, key: &[u8], groups: usize) -> usize {
        if let Some(&index) = self.index.get(key) {
            return index;
        }
        let index = self.keys.len();
        self.index.insert(key.to_vec(), index);
        self.keys.push(unquoted(text_of(key).trim()).to_owned());
        self.points
            .push((0..groups).map(|_| Points::default()).collect());
        index
    }

    fn curves(self, plan: &Plan) -> Vec<Curve> {
        let mut curves = Vec::new();
        for (key, points) in self.keys.into_iter().zip(self.points) {
            for (group, points) in plan.groups.iter().zip(points) {
                let name = match (group.name.as_str(), key.as_str()) {
                    (name, "") => name.to_owned(),
                    ("", key) => key.to_owned(),
                    (name, key) => format!("{name}, {key}"),
                };
                let kind = group.unit.as_ref().map(super::ValueUnit::kind);
                curves.extend(points.curve(name, group.columns.have_phase(), kind));
            }
        }
        curves
    }
}

/// The value of a group of columns in a row, in the file's unit.
fn value(row: &Row, group: &Group) -> Result<Complex64, Fault> {
    let magnitude = |column, decibels| {
        let magnitude = row.number(column)?;
        Ok(if decibels {
            10_f64.powf(magnitude / group.decibels_a_decade())
        } else {
            magnitude
        })
    };
    Ok(match group.columns {
        Columns::Complex { re, im } => Complex64::new(row.number(re)?, row.number(im)?),
        Columns::Polar {
            size,
            decibels,
            phase,
            unit,
        } => {
            let angle = row.number(phase)? * unit.radians();
            magnitude(size, decibels)? * Complex64::cis(angle)
        }
        Columns::Magnitude { size, decibels } => magnitude(size, decibels)?.into(),
    })
}

/// A cell as a number; NaN where it is empty.
fn number_of(cell: &[u8], comma: bool) -> Option<f64> {
    if cell.trim_ascii().is_empty() {
        return Some(f64::NAN);
    }
    number::parse(cell, comma)
}
