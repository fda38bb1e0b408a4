//! The columns of a table put together to curves: as the header says, by number, or one after the other.

use super::columns::{Columns, Group, Table};
use super::frequencies::{too_few, wrong_column};
use super::head::{Head, Role};
use super::sample::ColumnKind;
use crate::measured::layout::{Layout, Values};
use crate::measured::{Fault, fault_at};
use crate::unit::PhaseUnit;

/// A column that is a magnitude.
pub(super) fn magnitude(head: &Head, index: usize) -> Group {
    Group {
        name: head.name.clone(),
        columns: Columns::Magnitude {
            size: index,
            decibels: false,
        },
        unit: head.unit.clone(),
        minus: [false; 2],
    }
}

/// What columns that do not say it are likely to be, by the words that are there.
pub(super) fn guess(table: &Table) -> Values {
    let misfit: Vec<Head> = table
        .dialect
        .misfit
        .iter()
        .map(|word| Head::new(word))
        .collect();
    let roles = || table.heads.iter().chain(&misfit).map(|head| head.role);
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

/// The groups whose columns say what they are, and the columns that are left.
pub(super) fn said(table: &Table) -> (Vec<Group>, Vec<usize>) {
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

/// The columns of a curve that starts with complex numbers, a real part or a magnitude; degrees where a phase's unit is
/// not said.
fn columns_of(table: &Table, index: usize, left: &[usize]) -> Option<Columns> {
    if table.is_complex(index) {
        return Some(Columns::Complex {
            re: index,
            im: index,
        });
    }
    let head = table.heads.get(index)?;
    let partner = |is: fn(Role) -> bool| {
        let role = |other: usize| table.heads.get(other).filter(|one| is(one.role));
        let same = |other: &usize| role(*other).is_some_and(|one| one.name == head.name);
        // Of two neighbours one may have no name: H [dB], Phase.
        let next = |other: &usize| {
            *other == index + 1
                && role(*other).is_some_and(|one| one.name.is_empty() || head.name.is_empty())
        };
        let mut others = left
            .iter()
            .copied()
            .filter(|other| !table.is_complex(*other));
        others.clone().find(same).or_else(|| others.find(next))
    };
    let phase = || partner(|role| matches!(role, Role::Phase(_)));
    match head.role {
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
        // What has a unit and a phase is a magnitude: H [m/N], Phase.
        Role::Unsaid if head.unit.is_some() => Some(polar(table, index, false, phase()?)),
        _ => None,
    }
}

fn polar(table: &Table, size: usize, decibels: bool, phase: usize) -> Columns {
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

/// Some columns as a group, with what their headers say.
fn group(table: &Table, columns: Columns) -> Group {
    let both = columns.both();
    let heads = || both.iter().filter_map(|column| table.heads.get(*column));
    let name = heads().map(|head| &head.name).find(|name| !name.is_empty());
    let unit = heads().find_map(|head| head.unit.clone());
    let minus = |column: usize| table.heads.get(column).is_some_and(|head| head.minus);
    Group {
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

/// That real and imaginary part are in the same unit.
///
/// # Errors
/// They are not.
pub(super) fn one_unit(table: &Table, group: &Group) -> Result<(), Fault> {
    let Columns::Complex { re, im } = group.columns else {
        return Ok(());
    };
    let unit = |column: usize| table.heads.get(column).and_then(|head| head.unit.as_ref());
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

/// The columns that a person chooses by number.
pub(super) fn by_number(table: &Table, layout: &Layout) -> Result<Vec<Group>, Fault> {
    let dialect = table.dialect;
    let mut groups = Vec::new();
    for places in &layout.places.curves {
        let [first, second] = places.map(|place| place - 1);
        let in_one = first == second && layout.values == Values::Complex;
        for place in places {
            match dialect.columns.get(place - 1) {
                Some(ColumnKind::Real) => {}
                Some(ColumnKind::Complex) if in_one => {}
                Some(ColumnKind::Complex) => {
                    return Err(wrong_column(
                        *place,
                        &format!("holds complex numbers: re {place}; im {place} would be accepted"),
                    ));
                }
                Some(ColumnKind::Text) => {
                    return Err(wrong_column(
                        *place,
                        "holds no numbers: another one would be accepted",
                    ));
                }
                None => return Err(too_few(*place, dialect)),
            }
        }
        if in_one && !table.is_complex(first) {
            return Err(wrong_column(
                places[0],
                "holds no complex numbers: another column for the imaginary part would be accepted",
            ));
        }
        let mut one = group(table, Columns::of(layout.values, first, second));
        one.unit = layout.unit.clone().or(one.unit);
        one.minus[1] |= layout.minus;
        groups.push(one);
    }
    Ok(groups)
}

/// Groups of columns one after the other, whatever their words.
pub(super) fn in_turn(table: &Table, values: Values) -> Result<Vec<Group>, Fault> {
    let free = &table.free;
    let size = values.columns();
    if free.is_empty() || !free.len().is_multiple_of(size) {
        let message = format!(
            "{} columns besides the frequencies are not \"{values}\" of one curve or of several: {size} or a multiple \
             would be accepted, or the numbers of the columns, as {}",
            free.len(),
            by_example(values)
        );
        return Err(fault_at("", 1, 1, message));
    }
    let chunks = free.chunks(size);
    let groups = chunks.map(|columns| {
        let head = table.heads.get(columns[0]);
        let minus = |column: usize| table.heads.get(column).is_some_and(|head| head.minus);
        Group {
            name: head.map_or_else(String::new, |head| head.name.clone()),
            columns: Columns::of(values, columns[0], columns[size - 1]),
            unit: head.and_then(|head| head.unit.clone()),
            minus: [false, size == 2 && minus(columns[size - 1])],
        }
    });
    Ok(groups.collect())
}

/// The columns of a curve by number.
fn by_example(values: Values) -> String {
    let words = values.to_string();
    let numbered = words
        .split(' ')
        .zip(2..)
        .map(|(word, column)| format!("{word} {column}"));
    format!("hz 1; {}", numbered.collect::<Vec<_>>().join("; "))
}
