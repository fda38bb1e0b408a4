//! Tables of numbers as text, separated by commas, semicolons, tabs or blanks.

mod column_title;
mod columns;
mod dialect;
mod frequencies;
mod groups;
mod header;
mod plan;
mod records;
mod rows;
mod sample;
mod text;
mod tokens;
mod vocabulary;

use std::collections::HashMap;

use num_complex::Complex64;

use super::curve::{Curve, CurveBuilder};
use super::{Fault, Hint, MOST_VALUES, fault_at, text_of, too_many};
use crate::table::unquoted;
use crate::unit::ValueUnit;
use columns::ColumnGroup;
pub(super) use columns::Columns;
pub(super) use dialect::Dialect;
pub(super) use plan::Plan;
use rows::{TableRow, for_each_row};
pub(super) use text::decoded;

/// The curves of a table.
pub(super) fn read(bytes: &[u8], hint: &Hint) -> Result<Vec<Curve>, Fault> {
    let text = decoded(bytes);
    let dialect = Dialect::of(&text)?;
    let plan = Plan::new(&dialect, hint)?;
    if let Some(question) = plan.missing.iter().find(|missing| missing.is_needed()) {
        let message = format!("the table does not say {question}");
        return Err(fault_at("", dialect.first_line(&text), 1, message));
    }
    let mut reader = TableReader::new(&plan, dialect.width());
    for_each_row(&text, &dialect, |row| reader.take(&row))?;
    let TableReader {
        curve_points,
        end,
        rows_with_extra_cells,
        ..
    } = reader;
    let mut notes = plan.notes.clone();
    notes.extend(end.note(&text)?);
    if rows_with_extra_cells > usize::from(dialect.is_after_data) {
        let rows = if rows_with_extra_cells == 1 {
            "row"
        } else {
            "rows"
        };
        notes.push(format!(
            "extra cells after the columns in {rows_with_extra_cells} {rows} skipped"
        ));
    }
    let mut curves = curve_points.curves(&plan);
    let Some(first) = curves.first_mut() else {
        let message = "no row has a frequency above 0 and a finite value";
        return Err(fault_at("", dialect.first_line(&text), 1, message));
    };
    first.notes.extend(notes);
    Ok(curves)
}

/// Reads the rows of a table in sequence.
struct TableReader<'a> {
    plan: &'a Plan,
    width: usize,
    curve_points: CurvePoints,
    end: TableEnd,
    /// Rows with cells after the last column.
    rows_with_extra_cells: usize,
}

/// A possible end of the table, as long as no row of numbers follows.
#[derive(Default)]
enum TableEnd {
    /// The last row has numbers.
    #[default]
    None,
    /// Other lines.
    Lines {
        count: usize,
        start: String,
        fault: Fault,
    },
    /// A truncated or invalid row.
    CutRow(Fault),
}

impl TableEnd {
    /// A note on the end of the table.
    ///
    /// # Errors
    /// The last row is invalid, and the file is not truncated in it.
    fn note(self, text: &[u8]) -> Result<Option<String>, Fault> {
        match self {
            Self::None => Ok(None),
            Self::Lines { count, start, .. } => {
                let lines = if count == 1 { "line" } else { "lines" };
                Ok(Some(format!(
                    "{count} {lines} after the numbers skipped, from {start:?} on"
                )))
            }
            Self::CutRow(_) if !text.ends_with(b"\n") => Ok(Some(
                "the file is truncated in its last row, which is skipped".to_owned(),
            )),
            Self::CutRow(fault) => Err(fault),
        }
    }
}

impl<'a> TableReader<'a> {
    fn new(plan: &'a Plan, width: usize) -> Self {
        Self {
            plan,
            width,
            curve_points: CurvePoints::default(),
            end: TableEnd::None,
            rows_with_extra_cells: 0,
        }
    }

    fn take(&mut self, row: &TableRow) -> Result<(), Fault> {
        if let TableEnd::CutRow(fault) = &self.end {
            return Err(fault.clone());
        }
        let plan = self.plan;
        let values = || plan.groups.iter().flat_map(|group| group.columns.both());
        match values_of(row, plan) {
            Ok((frequency, values)) => {
                if let TableEnd::Lines { fault, .. } = &self.end {
                    return Err(fault.clone());
                }
                self.rows_with_extra_cells += usize::from(row.has_from(self.width));
                self.curve_points.push(row, plan, frequency, &values)
            }
            Err(fault) if row.is_not_data(plan.frequency.0, values()) => {
                match &mut self.end {
                    TableEnd::Lines { count, .. } => *count += 1,
                    _ => {
                        self.end = TableEnd::Lines {
                            count: 1,
                            start: row.start(),
                            fault,
                        }
                    }
                }
                Ok(())
            }
            Err(fault) => {
                let column = fault.column.unwrap_or(1) - 1;
                if let TableEnd::Lines { fault, .. } = &self.end {
                    return Err(fault.clone());
                }
                if !row.ends_by(column) {
                    return Err(fault);
                }
                self.end = TableEnd::CutRow(fault);
                Ok(())
            }
        }
    }
}

/// The points of each column group, for each name in the column `curve`.
#[derive(Debug, Default)]
struct CurvePoints {
    keys: Vec<String>,
    index: HashMap<Vec<u8>, usize>,
    /// One list per key, with one entry per group.
    points: Vec<Vec<CurveBuilder>>,
    taken: usize,
}

impl CurvePoints {
    /// Adds the points of a row.
    fn push(
        &mut self,
        row: &TableRow,
        plan: &Plan,
        frequency: f64,
        values: &[Complex64],
    ) -> Result<(), Fault> {
        let key = plan.curve.map_or(&b""[..], |column| row.cell(column));
        let index = self.index_of(key, plan.groups.len());
        self.taken += plan.groups.len();
        if self.taken > MOST_VALUES {
            return Err(row.fault(plan.frequency.0, too_many()));
        }
        for ((group, points), value) in plan.groups.iter().zip(&mut self.points[index]).zip(values)
        {
            points.push_in(group.unit.as_ref(), frequency, *value);
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
            .push((0..groups).map(|_| CurveBuilder::default()).collect());
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
                let kind = group.unit.as_ref().map(ValueUnit::kind);
                curves.extend(points.curve(name, group.columns.have_phase(), kind));
            }
        }
        curves
    }
}

/// The frequency of a row, Hz, and its values in file units.
fn values_of(row: &TableRow, plan: &Plan) -> Result<(f64, Vec<Complex64>), Fault> {
    let (column, unit) = plan.frequency;
    let frequency = row.number(column)? * unit.hertz();
    let values = plan.groups.iter().map(|group| value(row, group));
    Ok((frequency, values.collect::<Result<_, _>>()?))
}

/// The value of a column group in a row, in file units.
fn value(row: &TableRow, group: &ColumnGroup) -> Result<Complex64, Fault> {
    let signed = |which: usize, column| Ok(group.signed(which, row.number(column)?));
    let magnitude = |column, decibels| {
        let magnitude = signed(0, column)?;
        Ok(if decibels {
            10_f64.powf(magnitude / group.decibels_per_decade())
        } else {
            magnitude
        })
    };
    Ok(match group.columns {
        Columns::Complex { re, im } if re == im => {
            let value = row.complex(re)?;
            Complex64::new(group.signed(0, value.re), group.signed(1, value.im))
        }
        Columns::Complex { re, im } => Complex64::new(signed(0, re)?, signed(1, im)?),
        Columns::Polar {
            size,
            decibels,
            phase,
            unit,
        } => {
            let angle = signed(1, phase)? * unit.radians();
            magnitude(size, decibels)? * Complex64::cis(angle)
        }
        Columns::Magnitude { size, decibels } => magnitude(size, decibels)?.into(),
    })
}
