//! Which columns of a table make which curves.

use super::columns::{Columns, Group, Table};
use super::dialect::Dialect;
use super::frequencies::frequencies;
use super::groups::{by_number, guess, in_turn, magnitude, one_unit, said};
use super::head::{Head, Role};
use super::sample::ColumnKind;
use crate::measured::layout::{Layout, Question, Values};
use crate::measured::{Fault, Hint, fault_at};
use crate::unit::FrequencyUnit;

/// Most columns of a table.
const MOST_COLUMNS: usize = 1000;

/// A phase beyond this is in degrees: in rad it would be nearly ten turns.
const SURELY_DEGREES: f64 = 60.0;

/// Which columns of a table make which curves.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::measured) struct Plan {
    /// The column of frequencies and its unit.
    pub(in crate::measured) frequency: (usize, FrequencyUnit),
    /// The column whose words name curves.
    pub(super) curve: Option<usize>,
    pub(in crate::measured) groups: Vec<Group>,
    pub(in crate::measured) missing: Vec<Question>,
    /// What was left out or taken for granted.
    pub(super) notes: Vec<String>,
    /// What is in the header and not understood, a sentence each.
    pub(in crate::measured) doubts: Vec<String>,
    /// Whether the header is the one that the program writes.
    pub(in crate::measured) is_own: bool,
}

impl Plan {
    /// By the header, and by the layout where there is one.
    ///
    /// # Errors
    /// There are no columns of values, too many, or a number of them that does not fit the layout.
    pub(in crate::measured) fn new(dialect: &Dialect, hint: &Hint) -> Result<Self, Fault> {
        of_possible_width(dialect)?;
        let layout = hint.layout.as_ref();
        let mut table = Table {
            dialect,
            heads: dialect.header.iter().map(|cell| Head::new(cell)).collect(),
            free: Vec::new(),
        };
        let (column, unit) = frequencies(&table, layout)?;
        table.free = table.besides(column);
        let told = layout.map(|layout| layout.frequency).or(unit);
        let mut plan = Self {
            frequency: (column, told.unwrap_or(FrequencyUnit::Hertz)),
            curve: dialect.has_curves.then_some(0),
            groups: Vec::new(),
            missing: Vec::new(),
            notes: Vec::new(),
            doubts: doubts(&table),
            is_own: dialect
                .header
                .get(column)
                .is_some_and(|cell| cell == "frequency_hz"),
        };
        if told.is_none() {
            plan.missing.push(Question::Frequency);
            plan.notes
                .push("the unit of the frequencies is not said: Hz is taken".to_owned());
        }
        plan.group(&table, layout)?;
        plan.note_texts(&table);
        plan.note_minus(&table);
        plan.name(&hint.stem());
        if layout.is_none() {
            plan.ask_of_phases(&table);
            if plan.groups.iter().any(|group| group.unit.is_none()) {
                plan.missing.push(Question::Unit);
            }
        }
        Ok(plan)
    }

    /// Makes the groups of the free columns.
    fn group(&mut self, table: &Table, layout: Option<&Layout>) -> Result<(), Fault> {
        if let Some(layout) = layout.filter(|layout| !layout.places.curves.is_empty()) {
            self.groups = by_number(table, layout)?;
            return Ok(());
        }
        let (mut said, rest) = said(table);
        if layout.is_some_and(|layout| matches!(layout.values, Values::Magnitude { .. })) {
            self.leave_out_phases(&mut said);
        }
        let fits = |group: &Group| {
            layout.is_none_or(|layout| layout.values.is_like(group.columns.values()))
        };
        let own = self.is_own && layout.is_none() && !table.free.is_empty();
        if said.iter().any(fits) || own {
            self.take_said(table, said, fits);
            self.leave_out(table, rest);
            self.groups
                .sort_by_key(|group| group.columns.both().into_iter().min());
        } else {
            let values = layout.map_or_else(|| guess(table), |layout| layout.values);
            if layout.is_none() {
                self.missing.push(Question::Values);
            }
            self.groups = in_turn(table, values)?;
        }
        if let Some(layout) = layout {
            for group in self.groups.iter_mut().filter(|group| fits(group)) {
                group.columns = group.columns.in_units_of(layout.values);
                group.unit = layout.unit.clone().or(group.unit.take());
                group.minus[1] |= layout.minus;
            }
        }
        self.ask_of_order(table, layout);
        if layout.is_none_or(|layout| layout.unit.is_none()) {
            return self
                .groups
                .iter()
                .try_for_each(|group| one_unit(table, group));
        }
        Ok(())
    }

    /// Takes the groups that fit what a person says, and those that say themselves in which unit they are.
    fn take_said(&mut self, table: &Table, said: Vec<Group>, fits: impl Fn(&Group) -> bool) {
        for group in said {
            if fits(&group) || group.unit.is_some() || self.is_own {
                self.groups.push(group);
            } else {
                let [first, second] = group.columns.both();
                let columns = if first == second {
                    table.title(first)
                } else {
                    format!("{} and {}", table.title(first), table.title(second))
                };
                self.notes.push(format!(
                    "{columns} left out: {}, which is not what was asked for",
                    group.columns.values()
                ));
            }
        }
    }

    /// Keeps the magnitudes alone where only these are asked for.
    fn leave_out_phases(&mut self, groups: &mut [Group]) {
        for group in groups {
            if let Columns::Polar {
                size,
                decibels,
                phase,
                ..
            } = group.columns
            {
                group.columns = Columns::Magnitude { size, decibels };
                self.notes.push(format!(
                    "column {} left out: only magnitudes were asked for",
                    phase + 1
                ));
            }
        }
    }

    fn leave_out(&mut self, table: &Table, rest: Vec<usize>) {
        for index in rest {
            match table.heads.get(index) {
                // An energy in a table of the program.
                Some(head) if self.is_own && head.role == Role::Unsaid && !head.name.is_empty() => {
                    self.groups.push(magnitude(head, index));
                }
                _ => self.notes.push(format!(
                    "column {} left out: it is not said what it is",
                    index + 1
                )),
            }
        }
    }

    /// Asks which of several columns holds the frequencies of complex numbers.
    fn ask_of_order(&mut self, table: &Table, layout: Option<&Layout>) {
        let is_said = matches!(table.role(self.frequency.0), Role::Frequency(_));
        let is_used = |index: usize| {
            let mut groups = self.groups.iter();
            groups.any(|group| group.columns.both().contains(&index))
        };
        let spare = table.free.iter().any(|index| !is_used(*index));
        let is_open = layout.is_none() && !is_said && spare;
        if is_open && !self.missing.contains(&Question::Values) {
            self.missing.push(Question::Values);
        }
    }

    /// Says which columns are no numbers.
    fn note_texts(&mut self, table: &Table) {
        let kinds = table.dialect.columns.iter().enumerate();
        for (index, _) in kinds.filter(|(_, kind)| **kind == ColumnKind::Text) {
            if self.curve != Some(index) {
                self.notes.push(format!(
                    "column {} left out: it holds no numbers",
                    index + 1
                ));
            }
        }
    }

    /// Says where a minus of the header is undone.
    fn note_minus(&mut self, table: &Table) {
        let columns = self.groups.iter().flat_map(|group| {
            let both = group.columns.both().into_iter().zip(group.minus);
            both.filter(|(_, minus)| *minus).map(|(column, _)| column)
        });
        let notes = columns
            .map(|column| format!("{} is taken with the opposite sign", table.title(column)));
        self.notes.extend(notes.collect::<Vec<_>>());
    }

    /// Asks for the unit of phases where neither the header nor their size says it.
    fn ask_of_phases(&mut self, table: &Table) {
        let open = self.groups.iter().any(|group| match group.columns {
            Columns::Polar { phase, .. } => {
                table.role(phase) == Role::Phase(None)
                    && table.dialect.largest(phase) < SURELY_DEGREES
            }
            Columns::Complex { .. } | Columns::Magnitude { .. } => false,
        });
        if open && !self.missing.contains(&Question::Values) {
            self.missing.push(Question::Phase);
            self.notes
                .push("the unit of the phases is not said: degrees are taken".to_owned());
        }
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

fn of_possible_width(dialect: &Dialect) -> Result<(), Fault> {
    let width = dialect.width();
    if width > MOST_COLUMNS {
        let message = format!("has {width} columns: up to {MOST_COLUMNS} would be accepted");
        return Err(fault_at("", 1, 1, message));
    }
    Ok(())
}

/// What is in the header and not understood.
fn doubts(table: &Table) -> Vec<String> {
    let dialect = table.dialect;
    let mut doubts = Vec::new();
    if !dialect.misfit.is_empty() {
        doubts.push(format!(
            "its header has {} words for {} columns ({})",
            dialect.misfit.len(),
            dialect.width(),
            dialect.misfit.join(" | ")
        ));
    }
    let mut unknown: Vec<&String> = Vec::new();
    for unit in table.heads.iter().filter_map(|head| head.unknown.as_ref()) {
        if !unknown.contains(&unit) {
            unknown.push(unit);
            doubts.push(format!("its unit {unit:?} is not known"));
        }
    }
    doubts
}
