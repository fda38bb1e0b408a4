//! Inspects a file of measured curves, and finds the questions to ask before reading it.

use super::layout::{Places, Question};
use super::table::{Columns, Dialect, Plan, decoded};
use super::{Curve, Fault, Format, Hint, Layout, Values, read, uff};
use crate::model::counted;
use crate::unit::FrequencyUnit;

/// Rows of numbers in a preview.
const PREVIEW_ROWS: usize = 3;

/// Columns in a preview.
const PREVIEW_COLUMNS: usize = 16;

/// The content of a file, and the questions to ask.
#[derive(Debug, Clone, PartialEq)]
pub struct Inspection {
    /// The kind of file.
    pub format: Format,
    /// The header of a table, or `column 1` and so on; empty for a universal file.
    pub columns: Vec<String>,
    /// The first five rows of numbers, unconverted.
    pub first_rows: Vec<Vec<String>>,
    /// Names of the curves, according to the first rows.
    pub curves: Vec<String>,
    /// The recognised properties, one sentence each.
    pub recognised: Vec<String>,
    /// The missing information; empty if there is nothing to ask.
    pub missing: Vec<Question>,
    /// The recognised layout, completed with the likeliest values, as the default of a prompt.
    pub proposal: Layout,
    /// Whether the table has the header that the program writes, `frequency_hz`: then its numbers are in SI.
    pub is_own: bool,
}

/// An opened file.
#[derive(Debug, Clone, PartialEq)]
pub enum Opened {
    /// Its curves.
    Curves(Vec<Curve>),
    /// Its questions come first.
    Asks(Box<Inspection>),
}

impl Inspection {
    /// The missing information as a sentence.
    pub fn question(&self) -> String {
        let missing: Vec<String> = self.missing.iter().map(ToString::to_string).collect();
        format!("It does not say {}", missing.join("; nor "))
    }

    /// The columns of a table and its first rows, one line each.
    pub fn preview(&self) -> Vec<String> {
        let numbered = |(index, name): (usize, &String)| {
            let number = format!("column {}", index + 1);
            if *name == number {
                (index + 1).to_string()
            } else {
                format!("{}: {name}", index + 1)
            }
        };
        let names: Vec<String> = self.columns.iter().enumerate().map(numbered).collect();
        let rows = self.first_rows.iter().take(PREVIEW_ROWS);
        let lines = std::iter::once(&names).chain(rows);
        let lines = lines.filter(|cells| !cells.is_empty());
        lines.map(|cells| preview_line(cells)).collect()
    }
}

fn preview_line(cells: &[String]) -> String {
    let shown = cells.iter().take(PREVIEW_COLUMNS).map(|cell| cell.trim());
    let shown: Vec<&str> = shown.collect();
    let more = if cells.len() > PREVIEW_COLUMNS {
        " | ..."
    } else {
        ""
    };
    format!("{}{more}", shown.join(" | "))
}

/// Reads a file, or returns the questions to ask first. A layout in the hint answers them.
///
/// # Errors
/// As [`read()`].
pub fn open(bytes: &[u8], hint: &Hint) -> Result<Opened, Fault> {
    if hint.layout.is_none() {
        let inspection = inspect(bytes, hint)?;
        if !inspection.missing.is_empty() {
            return Ok(Opened::Asks(Box::new(inspection)));
        }
    }
    read(bytes, hint).map(Opened::Curves)
}

/// As [`open()`], but a table that the program wrote needs no answer for its units: its numbers are in SI.
///
/// # Errors
/// As [`read()`].
pub fn open_in_si(bytes: &[u8], hint: &Hint) -> Result<Opened, Fault> {
    match open(bytes, hint)? {
        Opened::Asks(seen) if seen.is_own && seen.missing == [Question::Unit] => {
            read(bytes, hint).map(Opened::Curves)
        }
        opened => Ok(opened),
    }
}

/// Inspects a file without reading all of a table; a layout in the hint answers questions.
///
/// # Errors
/// As [`read()`](super::read()), except for missing information.
pub fn inspect(bytes: &[u8], hint: &Hint) -> Result<Inspection, Fault> {
    super::of_possible_size(bytes)?;
    match Format::of(bytes, &hint.name) {
        Format::Csv => table(bytes, hint),
        Format::Uff => universal(bytes, hint),
    }
}

fn table(bytes: &[u8], hint: &Hint) -> Result<Inspection, Fault> {
    let dialect = Dialect::of(&decoded(bytes))?;
    let plan = Plan::new(&dialect, hint)?;
    let name = |index: usize| name(&dialect, index);
    let layout = hint.layout.as_ref();
    Ok(Inspection {
        format: Format::Csv,
        columns: (0..dialect.width()).map(name).collect(),
        first_rows: dialect.rows.iter().take(5).cloned().collect(),
        curves: plan.groups.iter().map(|group| group.name.clone()).collect(),
        recognised: recognised(&dialect, &plan),
        proposal: Layout {
            frequency: plan.frequency.1,
            values: plan
                .groups
                .first()
                .map_or(Values::Complex, |group| group.columns.values()),
            minus: layout.is_some_and(|layout| layout.minus),
            unit: plan.groups.iter().find_map(|group| group.unit.clone()),
            places: layout.map_or_else(Places::default, |layout| layout.places.clone()),
        },
        missing: plan.missing,
        is_own: plan.is_own,
    })
}

/// The header of a column, or its number.
fn name(dialect: &Dialect, index: usize) -> String {
    let word = dialect.header.get(index);
    let word = word.filter(|word| !word.trim().is_empty());
    word.cloned()
        .unwrap_or_else(|| format!("column {}", index + 1))
}

/// The recognised properties of a table, one sentence each.
fn recognised(dialect: &Dialect, plan: &Plan) -> Vec<String> {
    let name = |index: usize| name(dialect, index);
    let (column, unit) = plan.frequency;
    let mut recognised = vec![format!(
        "{} columns with {} between them",
        dialect.width(),
        dialect.separator.name()
    )];
    recognised.extend(plan.doubts.iter().cloned());
    if !plan.missing.contains(&Question::Frequency) {
        recognised.push(format!("frequencies in {}: {}", name(column), unit.key()));
    }
    if plan.missing.contains(&Question::Values) {
        return recognised;
    }
    for group in &plan.groups {
        let columns = match group.columns {
            Columns::Complex { re, im } if re == im => name(re),
            Columns::Complex { re, im } => format!("{} and {}", name(re), name(im)),
            Columns::Polar { size, phase, .. } => format!("{} and {}", name(size), name(phase)),
            Columns::Magnitude { size, .. } => name(size),
        };
        let unit = group.unit.as_ref();
        let unit = unit.map_or_else(String::new, |unit| format!(", {unit}"));
        recognised.push(format!("{} in {columns}{unit}", group.columns.values()));
    }
    recognised
}

fn universal(bytes: &[u8], hint: &Hint) -> Result<Inspection, Fault> {
    let mut curves = uff::look(bytes, hint)?;
    super::curve::distinguish(&mut curves);
    let recognised = curves.iter().map(|curve| {
        let words = curve.unknown.iter();
        let words: Vec<String> = words
            .map(|(_, word)| format!("{word:?} is not a known unit"))
            .collect();
        let unit = match curve.kind {
            _ if !words.is_empty() => words.join(", "),
            Some(kind) => kind.unit(),
            None => "unit not given".to_owned(),
        };
        let phase = if curve.phase_known {
            ""
        } else {
            ", without phase"
        };
        format!(
            "{}: {}, {unit}{phase}",
            curve.name,
            counted(curve.frequencies.len(), "point", "points")
        )
    });
    let mut missing = Vec::new();
    let asks = |curve: &Curve| curve.unknown_word(Question::Frequency).is_some();
    if curves.iter().any(asks) {
        missing.push(Question::Frequency);
    }
    if curves.iter().any(|curve| curve.kind.is_none()) {
        missing.push(Question::Unit);
    }
    Ok(Inspection {
        format: Format::Uff,
        columns: Vec::new(),
        first_rows: Vec::new(),
        recognised: recognised.collect(),
        missing,
        proposal: Layout {
            frequency: FrequencyUnit::Hertz,
            values: if curves.iter().any(|curve| curve.phase_known) {
                Values::Complex
            } else {
                Values::Magnitude { decibels: false }
            },
            minus: false,
            unit: None,
            places: Places::default(),
        },
        is_own: false,
        curves: curves.into_iter().map(|curve| curve.name).collect(),
    })
}
