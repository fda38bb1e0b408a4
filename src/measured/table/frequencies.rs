//! Which column of a table holds the frequencies.

use super::columns::Table;
use super::dialect::Dialect;
use super::head::Role;
use super::sample::ColumnKind;
use crate::measured::layout::Layout;
use crate::measured::{Fault, fault_at};
use crate::unit::FrequencyUnit;

/// The column of frequencies, and their unit as far as the header says it.
pub(super) fn frequencies(
    table: &Table,
    layout: Option<&Layout>,
) -> Result<(usize, Option<FrequencyUnit>), Fault> {
    let dialect = table.dialect;
    let unit = |index: usize| match table.role(index) {
        Role::Frequency(unit) => unit,
        _ => None,
    };
    if let Some(place) = layout.and_then(|layout| layout.places.frequency) {
        let index = place - 1;
        return match dialect.columns.get(index) {
            Some(ColumnKind::Real) => Ok((index, unit(index))),
            Some(_) => Err(wrong_column(
                place,
                "holds no real numbers: another one would be accepted",
            )),
            None => Err(too_few(place, dialect)),
        };
    }
    let chosen: Vec<usize> = layout.map_or_else(Vec::new, |layout| {
        layout
            .places
            .curves
            .iter()
            .flatten()
            .map(|place| place - 1)
            .collect()
    });
    let first = usize::from(dialect.has_curves);
    let is_open =
        |index: &usize| dialect.columns[*index] == ColumnKind::Real && !chosen.contains(index);
    let open: Vec<usize> = (first..dialect.width()).filter(is_open).collect();
    let named = |index: &&usize| matches!(table.role(**index), Role::Frequency(_));
    let unsaid = |index: &&usize| table.role(**index) == Role::Unsaid;
    let found = open.iter().find(named).or_else(|| open.iter().find(unsaid));
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

/// That a column chosen by number is none.
pub(super) fn too_few(place: usize, dialect: &Dialect) -> Fault {
    let width = dialect.width();
    wrong_column(
        place,
        &format!("is not there: the table has {width} columns"),
    )
}

pub(super) fn wrong_column(place: usize, why: &str) -> Fault {
    fault_at("", 1, 1, format!("column {place} {why}"))
}
