//! Assigns the columns of a table to curves.

use super::column_title::{ColumnTitle, Role};
use super::columns::{ColumnGroup, Columns, TableColumns};
use super::dialect::Dialect;
use super::frequencies::frequencies;
use super::groups::{by_number, consecutive, guess, magnitude, one_unit, titled};
use super::sample::ColumnContent;
use crate::measured::layout::{Layout, Question, Values};
use crate::measured::{Fault, Hint, fault_at};
use crate::unit::FrequencyUnit;

/// Most columns of a table.
const MOST_COLUMNS: usize = 1000;

/// A larger phase is in degrees: in rad it would be almost ten turns.
const SURELY_DEGREES: f64 = 60.0;

/// The assignment of the columns of a table to curves.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::measured) struct Plan {
    /// The frequency column and its unit.
    pub(in crate::measured) frequency: (usize, FrequencyUnit),
    /// The column of curve names.
    pub(super) curve: Option<usize>,
    pub(in crate::measured) groups: Vec<ColumnGroup>,
    pub(in crate::measured) missing: Vec<Question>,
    /// Skipped columns and assumptions, one sentence each.
    pub(super) notes: Vec<String>,
    /// The parts of the header that are not understood, one sentence each.
    pub(in crate::measured) doubts: Vec<String>,
    /// Whether this program wrote the header.
    pub(in crate::measured) is_own: bool,
}

impl Plan {
    /// Assigns columns by the header and, if given, by the layout.
    ///
    /// # Errors
    /// There are no value columns, too many, or their number does not match the layout.
    pub(in crate::measured) fn new(dialect: &Dialect, hint: &Hint) -> Result<Self, Fault> {
        of_possible_width(dialect)?;
        let layout = hint.layout.as_ref();
        let mut table = TableColumns {
            dialect,
            titles: dialect
                .header
                .iter()
                .map(|cell| ColumnTitle::new(cell))
                .collect(),
            free: Vec::new(),
        };
        let (column, unit) = frequencies(&table, layout)?;
        table.free = table.value_columns(column);
        let frequency_unit = layout.map(|layout| layout.frequency).or(unit);
        let mut plan = Self {
            frequency: (column, frequency_unit.unwrap_or(FrequencyUnit::Hertz)),
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
        if frequency_unit.is_none() {
            plan.missing.push(Question::Frequency);
            plan.notes
                .push("the frequency unit is not given: Hz assumed".to_owned());
        }
        plan.group(&table, layout)?;
        plan.note_texts(&table);
        plan.note_minus(&table);
        plan.name(&hint.stem());
        if layout.is_none() {
            plan.ask_phase_unit(&table);
            if plan.groups.iter().any(|group| group.unit.is_none()) {
                plan.missing.push(Question::Unit);
            }
        }
        Ok(plan)
    }

    /// Groups the value columns.
    fn group(&mut self, table: &TableColumns, layout: Option<&Layout>) -> Result<(), Fault> {
        if let Some(layout) = layout.filter(|layout| !layout.places.curves.is_empty()) {
            self.groups = by_number(table, layout)?;
            return Ok(());
        }
        let (mut groups, rest) = titled(table);
        if layout.is_some_and(|layout| matches!(layout.values, Values::Magnitude { .. })) {
            self.leave_out_phases(&mut groups);
        }
        let fits = |group: &ColumnGroup| {
            layout.is_none_or(|layout| layout.values.is_like(group.columns.values()))
        };
        let is_own_table = self.is_own && layout.is_none() && !table.free.is_empty();
        if groups.iter().any(fits) || is_own_table {
            self.take_titled(table, groups, fits);
            self.leave_out(table, rest);
            self.groups
                .sort_by_key(|group| group.columns.both().into_iter().min());
        } else {
            let values = layout.map_or_else(|| guess(table), |layout| layout.values);
            if layout.is_none() {
                self.missing.push(Question::Values);
            }
            self.groups = consecutive(table, values)?;
        }
        if let Some(layout) = layout {
            for group in self.groups.iter_mut().filter(|group| fits(group)) {
                group.columns = group.columns.in_units_of(layout.values);
                group.unit = layout.unit.clone().or(group.unit.take());
                group.minus[1] |= layout.minus;
            }
        }
        self.ask_columns(table, layout);
        if layout.is_none_or(|layout| layout.unit.is_none()) {
            return self
                .groups
                .iter()
                .try_for_each(|group| one_unit(table, group));
        }
        Ok(())
    }

    /// Takes the groups that match the user's description, and those with a unit.
    fn take_titled(
        &mut self,
        table: &TableColumns,
        groups: Vec<ColumnGroup>,
        fits: impl Fn(&ColumnGroup) -> bool,
    ) {
        for group in groups {
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
                    "{columns} skipped: {}, which was not requested",
                    group.columns.values()
                ));
            }
        }
    }

    /// Keeps only the magnitudes.
    fn leave_out_phases(&mut self, groups: &mut [ColumnGroup]) {
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
                    "column {} skipped: only magnitudes were requested",
                    phase + 1
                ));
            }
        }
    }

    fn leave_out(&mut self, table: &TableColumns, rest: Vec<usize>) {
        for index in rest {
            match table.titles.get(index) {
                // An energy in a table of this program.
                Some(title)
                    if self.is_own && title.role == Role::Unknown && !title.name.is_empty() =>
                {
                    self.groups.push(magnitude(title, index));
                }
                _ => self.notes.push(format!(
                    "column {} skipped: its quantity is not given",
                    index + 1
                )),
            }
        }
    }

    /// Asks for the values if the frequency column has no title and value columns are unused.
    fn ask_columns(&mut self, table: &TableColumns, layout: Option<&Layout>) {
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

    /// Adds a note for each text column.
    fn note_texts(&mut self, table: &TableColumns) {
        let kinds = table.dialect.columns.iter().enumerate();
        for (index, _) in kinds.filter(|(_, kind)| **kind == ColumnContent::Text) {
            if self.curve != Some(index) {
                self.notes
                    .push(format!("column {} skipped: it has no numbers", index + 1));
            }
        }
    }

    /// Adds a note for each column with an inverted sign.
    fn note_minus(&mut self, table: &TableColumns) {
        let columns = self.groups.iter().flat_map(|group| {
            let both = group.columns.both().into_iter().zip(group.minus);
            both.filter(|(_, minus)| *minus).map(|(column, _)| column)
        });
        let notes = columns
            .map(|column| format!("{} is taken with the opposite sign", table.title(column)));
        self.notes.extend(notes.collect::<Vec<_>>());
    }

    /// Asks for the unit of phases if neither the header nor their size gives it.
    fn ask_phase_unit(&mut self, table: &TableColumns) {
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
                .push("the phase unit is not given: degrees assumed".to_owned());
        }
    }

    /// Names unnamed groups after the file, unless a column `curve` names the only group.
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

/// The parts of the header that are not understood.
fn doubts(table: &TableColumns) -> Vec<String> {
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
    for unit in table
        .titles
        .iter()
        .filter_map(|title| title.unknown.as_ref())
    {
        if !unknown.contains(&unit) {
            unknown.push(unit);
            doubts.push(format!("its unit {unit:?} is unknown"));
        }
    }
    doubts
}
