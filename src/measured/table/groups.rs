//! Groups the columns of a table to curves: by titles, by number, or consecutively.

use super::column_title::{ColumnTitle, Role};
use super::columns::{ColumnGroup, Columns, TableColumns};
use super::frequencies::{too_few, wrong_column};
use super::sample::ColumnContent;
use crate::measured::layout::{Layout, Values};
use crate::measured::{Fault, fault_at};
use crate::unit::PhaseUnit;

/// A group of one magnitude column.
pub(super) fn magnitude(title: &ColumnTitle, index: usize) -> ColumnGroup {
    ColumnGroup {
        name: title.name.clone(),
        columns: Columns::Magnitude {
            size: index,
            decibels: false,
        },
        unit: title.unit.clone(),
        minus: [false; 2],
    }
}

/// The most likely values of columns without titles, from the available words.
pub(super) fn guess(table: &TableColumns) -> Values {
    let misfit: Vec<ColumnTitle> = table
        .dialect
        .misfit
        .iter()
        .map(|word| ColumnTitle::new(word))
        .collect();
    let roles = || table.titles.iter().chain(&misfit).map(|title| title.role);
    let decibels = roles().any(|role| role == Role::Magnitude { decibels: true });
    let phase = roles().find_map(|role| match role {
        Role::Phase(unit) => Some(unit.unwrap_or(PhaseUnit::Degree)),
        _ => None,
    });
    let (columns, has_imaginary) = (
        table.free.len(),
        roles().any(|role| role == Role::Imaginary),
    );
    match phase {
        _ if table.free.iter().any(|index| table.is_complex(*index)) => Values::Complex,
        Some(phase) if !has_imaginary => Values::MagnitudePhase { phase, decibels },
        _ if columns.is_multiple_of(2) && !decibels => Values::Complex,
        _ => Values::Magnitude { decibels },
    }
}

/// The groups of columns with known titles, and the remaining columns.
pub(super) fn titled(table: &TableColumns) -> (Vec<ColumnGroup>, Vec<usize>) {
    let mut groups = Vec::new();
    let mut left: Vec<usize> = table.free.clone();
    for &index in &table.free {
        if !left.contains(&index) {
            continue;
        }
        let Some(columns) = columns_of(table, index, &left) else {
            continue;
        };
        left.retain(|column| !columns.both().contains(column));
        groups.push(group(table, columns));
    }
    (groups, left)
}

/// The columns of a curve whose first column has complex numbers, a real part or a magnitude; a phase without a unit is
/// in degrees.
fn columns_of(table: &TableColumns, index: usize, left: &[usize]) -> Option<Columns> {
    if table.is_complex(index) {
        return Some(Columns::Complex {
            re: index,
            im: index,
        });
    }
    let title = table.titles.get(index)?;
    let partner = |is: fn(Role) -> bool| {
        let role = |other: usize| table.titles.get(other).filter(|one| is(one.role));
        let same = |other: &usize| role(*other).is_some_and(|one| one.name == title.name);
        // One of two adjacent columns may have no name: H [dB], Phase.
        let next = |other: &usize| {
            *other == index + 1
                && role(*other).is_some_and(|one| one.name.is_empty() || title.name.is_empty())
        };
        let mut others = left
            .iter()
            .copied()
            .filter(|other| !table.is_complex(*other));
        others.clone().find(same).or_else(|| others.find(next))
    };
    let phase = || partner(|role| matches!(role, Role::Phase(_)));
    match title.role {
        Role::Real => {
            let im = partner(|role| role == Role::Imaginary)?;
            Some(Columns::Complex { re: index, im })
        }
        Role::Magnitude { decibels } => Some(match phase() {
            Some(phase) => polar(table, index, decibels, phase),
            None => Columns::Magnitude {
                size: index,
                decibels,
            },
        }),
        // A column with a unit and a phase column is a magnitude: H [m/N], Phase.
        Role::Unknown if title.unit.is_some() => Some(polar(table, index, false, phase()?)),
        _ => None,
    }
}

fn polar(table: &TableColumns, size: usize, decibels: bool, phase: usize) -> Columns {
    Columns::Polar {
        size,
        decibels,
        phase,
        unit: match table.role(phase) {
            Role::Phase(Some(unit)) => unit,
            _ => PhaseUnit::Degree,
        },
    }
}

/// Columns as a group, with name, unit and sign of their titles.
fn group(table: &TableColumns, columns: Columns) -> ColumnGroup {
    let both = columns.both();
    let titles = || both.iter().filter_map(|column| table.titles.get(*column));
    let name = titles()
        .map(|title| &title.name)
        .find(|name| !name.is_empty());
    let unit = titles().find_map(|title| title.unit.clone());
    let minus = |column: usize| table.titles.get(column).is_some_and(|title| title.minus);
    ColumnGroup {
        name: name.cloned().unwrap_or_default(),
        columns,
        unit,
        minus: match columns {
            Columns::Magnitude {
                decibels: false, ..
            } => [false; 2],
            Columns::Complex { .. } | Columns::Polar { .. } | Columns::Magnitude { .. } => {
                both.map(minus)
            }
        },
    }
}

/// Checks that real and imaginary part have the same unit.
///
/// # Errors
/// The units differ.
pub(super) fn one_unit(table: &TableColumns, group: &ColumnGroup) -> Result<(), Fault> {
    let Columns::Complex { re, im } = group.columns else {
        return Ok(());
    };
    let unit = |column: usize| {
        table
            .titles
            .get(column)
            .and_then(|title| title.unit.as_ref())
    };
    match (unit(re), unit(im)) {
        (Some(a), Some(b)) if (a.kind(), a.ratio()) != (b.kind(), b.ratio()) => {
            let message = format!(
                "{} is in {a} and {} in {b}: the same unit would be accepted",
                table.title(re),
                table.title(im)
            );
            Err(fault_at("", 1, 1, message))
        }
        _ => Ok(()),
    }
}

/// The groups that the user gives by column number.
pub(super) fn by_number(table: &TableColumns, layout: &Layout) -> Result<Vec<ColumnGroup>, Fault> {
    let dialect = table.dialect;
    let mut groups = Vec::new();
    for numbers in &layout.places.curves {
        let [first, second] = numbers.map(|number| number - 1);
        let in_one = first == second && layout.values == Values::Complex;
        for number in numbers {
            match dialect.columns.get(number - 1) {
                Some(ColumnContent::Real) => {}
                Some(ColumnContent::Complex) if in_one => {}
                Some(ColumnContent::Complex) => {
                    return Err(wrong_column(
                        *number,
                        &format!("has complex numbers: re {number}; im {number} would be accepted"),
                    ));
                }
                Some(ColumnContent::Text) => {
                    return Err(wrong_column(
                        *number,
                        "has no numbers: another one would be accepted",
                    ));
                }
                None => return Err(too_few(*number, dialect)),
            }
        }
        if in_one && !table.is_complex(first) {
            return Err(wrong_column(
                numbers[0],
                "has no complex numbers: another column for the imaginary part would be accepted",
            ));
        }
        let mut one = group(table, Columns::of(layout.values, first, second));
        one.unit = layout.unit.clone().or(one.unit);
        one.minus[1] |= layout.minus;
        groups.push(one);
    }
    Ok(groups)
}

/// Consecutive columns as groups, without regard to their titles.
pub(super) fn consecutive(table: &TableColumns, values: Values) -> Result<Vec<ColumnGroup>, Fault> {
    let free = &table.free;
    let size = values.columns();
    if free.is_empty() || !free.len().is_multiple_of(size) {
        let message = format!(
            "{} columns next to the frequencies are not \"{values}\" of one or more curves: {size} or a multiple \
             would be accepted, or the numbers of the columns, as {}",
            free.len(),
            by_example(values)
        );
        return Err(fault_at("", 1, 1, message));
    }
    let chunks = free.chunks(size);
    let groups = chunks.map(|columns| {
        let title = table.titles.get(columns[0]);
        let minus = |column: usize| table.titles.get(column).is_some_and(|title| title.minus);
        ColumnGroup {
            name: title.map_or_else(String::new, |title| title.name.clone()),
            columns: Columns::of(values, columns[0], columns[size - 1]),
            unit: title.and_then(|title| title.unit.clone()),
            minus: [false, size == 2 && minus(columns[size - 1])],
        }
    });
    Ok(groups.collect())
}

/// An example of columns by number, for messages.
fn by_example(values: Values) -> String {
    let words = values.to_string();
    let numbered = words
        .split(' ')
        .zip(2..)
        .map(|(word, column)| format!("{word} {column}"));
    format!("hz 1; {}", numbered.collect::<Vec<_>>().join("; "))
}
