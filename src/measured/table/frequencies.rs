//! Finds the frequency column of a table.

use super::column_title::Role;
use super::columns::TableColumns;
use super::dialect::Dialect;
use super::sample::ColumnContent;
use crate::measured::layout::Layout;
use crate::measured::{Fault, fault_at};
use crate::unit::FrequencyUnit;

/// The frequency column, and its unit if the header gives it.
pub(super) fn frequencies(
    table: &TableColumns,
    layout: Option<&Layout>,
) -> Result<(usize, Option<FrequencyUnit>), Fault> {
    let dialect = table.dialect;
    let unit = |index: usize| match table.role(index) {
        Role::Frequency(unit) => unit,
        _ => None,
    };
    if let Some(number) = layout.and_then(|layout| layout.places.frequency) {
        let index = number - 1;
        return match dialect.columns.get(index) {
            Some(ColumnContent::Real) => Ok((index, unit(index))),
            Some(_) => Err(wrong_column(
                number,
                "has no real numbers: another one would be accepted",
            )),
            None => Err(too_few(number, dialect)),
        };
    }
    let chosen: Vec<usize> = layout.map_or_else(Vec::new, |layout| {
        layout
            .places
            .curves
            .iter()
            .flatten()
            .map(|number| number - 1)
            .collect()
    });
    let first = usize::from(dialect.has_curves);
    let is_open =
        |index: &usize| dialect.columns[*index] == ColumnContent::Real && !chosen.contains(index);
    let open: Vec<usize> = (first..dialect.width()).filter(is_open).collect();
    let named = |index: &&usize| matches!(table.role(**index), Role::Frequency(_));
    let is_unknown = |index: &&usize| table.role(**index) == Role::Unknown;
    let found = open
        .iter()
        .find(named)
        .or_else(|| open.iter().find(is_unknown));
    match found {
        Some(&index) => Ok((index, unit(index))),
        None => Err(fault_at(
            "",
            1,
            1,
            "has no column of frequencies: one headed such as \"Frequency [Hz]\" would be accepted, or its number, as hz 1",
        )),
    }
}

/// The fault for a column number beyond the last column.
pub(super) fn too_few(number: usize, dialect: &Dialect) -> Fault {
    let width = dialect.width();
    wrong_column(
        number,
        &format!("is not there: the table has {width} columns"),
    )
}

pub(super) fn wrong_column(number: usize, why: &str) -> Fault {
    fault_at("", 1, 1, format!("column {number} {why}"))
}
