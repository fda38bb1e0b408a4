//! Which columns of a table make which curves.

use super::columns::{Columns, Group};
use super::dialect::Dialect;
use super::head::{Head, Role};
use crate::measured::inspect::Question;
use crate::measured::layout::{FrequencyUnit, Layout, PhaseUnit, Values};
use crate::measured::{Fault, Hint, fault_at};

/// Most columns of a table.
const MOST_COLUMNS: usize = 1000;

/// Which columns of a table make which curves.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::measured) struct Plan {
    /// The column of frequencies and its unit.
    pub(in crate::measured) frequency: (usize, FrequencyUnit),
    /// The column whose words name curves.
    pub(super) curve: Option<usize>,
    pub(in crate::measured) groups: Vec<Group>,
    pub(in crate::measured) missing: Vec<Question>,
    pub(super) notes: Vec<String>,
}

impl Plan {
    /// By the header, and by the layout where there is one.
    ///
    /// # Errors
    /// There are no columns of values, too many, or a number of them that does not fit the layout.
    pub(in crate::measured) fn new(dialect: &Dialect, hint: &Hint) -> Result<Self, Fault> {
        if dialect.width > MOST_COLUMNS {
            let message = format!(
                "has {} columns: up to {MOST_COLUMNS} would be accepted",
                dialect.width
            );
            return Err(fault_at("", 1, 1, message));
        }
        let heads: Vec<Head> = dialect.header.iter().map(|cell| Head::new(cell)).collect();
        let first = usize::from(dialect.has_curves);
        let (column, unit) = frequencies(&heads, first).unwrap_or((first, None));
        let is_free = |index: &usize| {
            *index != column
                && heads
                    .get(*index)
                    .is_none_or(|head| head.role != Role::Other)
        };
        let free: Vec<usize> = (first..dialect.width).filter(is_free).collect();
        let layout = hint.layout.as_ref();
        let told = layout.map(|layout| layout.frequency).or(unit);
        let mut plan = Self {
            frequency: (column, told.unwrap_or(FrequencyUnit::Hertz)),
            curve: dialect.has_curves.then_some(0),
            groups: Vec::new(),
            missing: Vec::new(),
            notes: Vec::new(),
        };
        if told.is_none() {
            plan.missing.push(Question::Frequency);
            plan.notes
                .push("the unit of the frequencies is not said: Hz is taken".to_owned());
        }
        let own = dialect
            .header
            .get(column)
            .is_some_and(|cell| cell == "frequency_hz");
        plan.group(&heads, &free, layout, own)?;
        plan.name(&hint.stem());
        if layout.is_none() && plan.groups.iter().any(|group| group.unit.is_none()) {
            plan.missing.push(Question::Unit);
        }
        Ok(plan)
    }

    /// Makes the groups of the free columns.
    fn group(
        &mut self,
        heads: &[Head],
        free: &[usize],
        layout: Option<&Layout>,
        own: bool,
    ) -> Result<(), Fault> {
        let (said, rest) = pairs(heads, free);
        let fits = |group: &Group| {
            layout.is_none_or(|layout| layout.values.is_like(group.columns.values()))
        };
        if said.iter().any(fits) || (own && layout.is_none() && !free.is_empty()) {
            self.groups = said;
            for index in rest {
                match heads.get(index) {
                    // An energy in a table of the program.
                    Some(head) if own && head.role == Role::Unsaid && !head.name.is_empty() => {
                        self.groups.push(magnitude(head, index));
                    }
                    _ => self.notes.push(format!(
                        "column {} left out: it is not said what it is",
                        index + 1
                    )),
                }
            }
            self.groups
                .sort_by_key(|group| group.columns.both().into_iter().min());
        } else {
            let values = layout.map_or(guess(free.len()), |layout| layout.values);
            if layout.is_none() {
                self.missing.push(Question::Values);
            }
            self.groups = in_turn(heads, free, values)?;
        }
        if let Some(layout) = layout {
            for group in self.groups.iter_mut().filter(|group| fits(group)) {
                group.columns = group.columns.in_units_of(layout.values);
                group.unit = layout.unit.clone().or(group.unit.take());
            }
        }
        Ok(())
    }

    /// Names the groups that have no name after the file; the words of a column `curve` are names enough.
    fn name(&mut self, stem: &str) {
        if self.curve.is_some() && self.groups.len() == 1 {
            return;
        }
        for group in &mut self.groups {
            if group.name.is_empty() {
                stem.clone_into(&mut group.name);
            }
        }
    }
}

/// The column of frequencies from a column on, and their unit as far as it is said.
fn frequencies(heads: &[Head], first: usize) -> Option<(usize, Option<FrequencyUnit>)> {
    let mut heads = heads.iter().enumerate().skip(first);
    heads.find_map(|(index, head)| match head.role {
        Role::Frequency(unit) => Some((index, unit)),
        _ => None,
    })
}

/// A column that is a magnitude.
fn magnitude(head: &Head, index: usize) -> Group {
    Group {
        name: head.name.clone(),
        columns: Columns::Magnitude {
            size: index,
            decibels: false,
        },
        unit: head.unit.clone(),
    }
}

/// What columns without words are likely to be.
const fn guess(columns: usize) -> Values {
    if columns.is_multiple_of(2) {
        Values::Complex
    } else {
        Values::Magnitude { decibels: false }
    }
}

/// The groups whose columns say what they are, and the columns that are left.
fn pairs(heads: &[Head], free: &[usize]) -> (Vec<Group>, Vec<usize>) {
    let mut groups = Vec::new();
    let mut left: Vec<usize> = free.to_vec();
    for &index in free {
        let Some(head) = heads.get(index).filter(|_| left.contains(&index)) else {
            continue;
        };
        let Some(columns) = columns_of(heads, head, index, &left) else {
            continue;
        };
        left.retain(|column| !columns.both().contains(column));
        groups.push(Group {
            name: name(heads, columns),
            columns,
            unit: head.unit.clone(),
        });
    }
    (groups, left)
}

/// The columns of a curve that starts with a real part or a magnitude; degrees where a phase's unit is not said.
fn columns_of(heads: &[Head], head: &Head, index: usize, left: &[usize]) -> Option<Columns> {
    let partner = |is: fn(Role) -> bool| {
        let role = |other: usize| heads.get(other).filter(|one| is(one.role));
        let same = |other: &usize| role(*other).is_some_and(|one| one.name == head.name);
        // Of two neighbours one may have no name: H [dB], Phase.
        let next = |other: &usize| {
            *other == index + 1
                && role(*other).is_some_and(|one| one.name.is_empty() || head.name.is_empty())
        };
        let mut others = left.iter().copied();
        others.clone().find(same).or_else(|| others.find(next))
    };
    match head.role {
        Role::Real => {
            let im = partner(|role| role == Role::Imaginary)?;
            Some(Columns::Complex { re: index, im })
        }
        Role::Magnitude { decibels } => {
            Some(match partner(|role| matches!(role, Role::Phase(_))) {
                Some(phase) => Columns::Polar {
                    size: index,
                    decibels,
                    phase,
                    unit: match heads[phase].role {
                        Role::Phase(Some(unit)) => unit,
                        _ => PhaseUnit::Degree,
                    },
                },
                None => Columns::Magnitude {
                    size: index,
                    decibels,
                },
            })
        }
        _ => None,
    }
}

/// The name of the columns of a curve.
fn name(heads: &[Head], columns: Columns) -> String {
    let names = columns.both().map(|column| heads[column].name.clone());
    names
        .into_iter()
        .find(|name| !name.is_empty())
        .unwrap_or_default()
}

/// Groups of columns one after the other, whatever their words.
fn in_turn(heads: &[Head], free: &[usize], values: Values) -> Result<Vec<Group>, Fault> {
    let size = values.columns();
    if free.is_empty() || !free.len().is_multiple_of(size) {
        let message = format!(
            "{} columns beside the frequencies are not \"{values}\" of one curve or of several: {size} or a multiple \
             would be accepted",
            free.len()
        );
        return Err(fault_at("", 1, 1, message));
    }
    let group = |columns: &[usize]| {
        let head = heads.get(columns[0]);
        Group {
            name: head.map_or_else(String::new, |head| head.name.clone()),
            columns: Columns::of(values, columns[0], columns[size - 1]),
            unit: head.and_then(|head| head.unit.clone()),
        }
    };
    Ok(free.chunks(size).map(group).collect())
}
