//! `beamtune frf`: frequency responses as CSV or as a universal file.

mod uff;

use std::ffi::OsString;
use std::io::{IsTerminal, Write};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::{Args, ValueEnum};

use super::csv::{self, cell, number};
use super::modes::listed;
use super::{Failure, Sets, say, source};
use crate::model::{Checked, Family, counted, edit};
use crate::solve::modes::{Completeness, MOST_MODES, Modes, modes};
use crate::solve::peaks::resolved;
use crate::solve::{Cancelled, Column, ColumnKind, Frf, frequencies, sweep};

/// Frequencies solved and written at a time, which limits the memory of a long sweep.
const BLOCK: usize = 4096;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A model file, a preset's name, or - for standard input.
    model: OsString,
    /// Frequencies in Hz, instead of the model's sweep.
    #[arg(long, value_name = "F1,F2,..", value_delimiter = ',', value_parser = super::frequency)]
    at: Vec<f64>,
    /// Adds the frequencies that resolve every peak and anti-resonance in the sweep.
    #[arg(long, conflicts_with = "at")]
    resolve: bool,
    /// Writes one block of rows for each member of this study.
    #[arg(long, value_name = "NAME")]
    study: Option<String>,
    /// The format of the output: a table, or a universal file of data sets 58, in which motions are divided by the
    /// force if there is only one.
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    format: Format,
    /// The file to write, instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    sets: Sets,
}

/// The format of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    Csv,
    Uff,
}

/// The frequencies to solve.
#[derive(Debug, Clone, Copy)]
enum Points<'a> {
    /// Given frequencies, Hz.
    At(&'a [f64]),
    /// The model's sweep.
    Sweep,
    /// The model's sweep and the frequencies that its peaks and anti-resonances need.
    Resolved,
}

impl Arguments {
    fn points(&self) -> Points<'_> {
        match &self.at[..] {
            _ if self.resolve => Points::Resolved,
            [] => Points::Sweep,
            at => Points::At(at),
        }
    }
}

/// A model to solve, and its first cell in a study.
type Member = (Option<String>, Checked);

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let model = source::open(&arguments.model, &arguments.sets.sets)?.model;
    let members = members(&model, arguments.study.as_deref())?;
    let (output, points) = (arguments.output.as_deref(), arguments.points());
    match arguments.format {
        Format::Csv => csv::write(output, |out| write_all(out, &members, points)),
        Format::Uff => uff::write(output, &members, points),
    }
}

fn members(model: &Checked, study: Option<&str>) -> Result<Vec<Member>, Failure> {
    let Some(name) = study else {
        return Ok(vec![(None, model.clone())]);
    };
    let family = family(model, name)?;
    let keys = edit::family_keys(family).into_iter().enumerate();
    keys.map(|(index, key)| match edit::apply(model, family, index) {
        Ok(member) => Ok((Some(key), member)),
        Err(faults) => Err(Failure::faults(&format!("study {name}, {key}"), &faults)),
    })
    .collect()
}

fn family<'a>(model: &'a Checked, name: &str) -> Result<&'a Family, Failure> {
    match model.studies.iter().find(|study| study.name == name) {
        Some(study) => Ok(&study.family),
        None if model.studies.is_empty() => Err(Failure::input(format!(
            "--study {name}: the model has no studies"
        ))),
        None => {
            let names: Vec<&str> = model
                .studies
                .iter()
                .map(|study| study.name.as_str())
                .collect();
            Err(Failure::input(format!(
                "--study {name}: the model has {}",
                names.join(", ")
            )))
        }
    }
}

fn write_all(out: &mut dyn Write, members: &[Member], points: Points) -> std::io::Result<()> {
    let mut header_due = true;
    let mut singular = Vec::new();
    for (index, (key, model)) in members.iter().enumerate() {
        let curve = Curve::new(model, points).map_err(std::io::Error::other)?;
        let last = curve.base.len();
        for start in (0..last).step_by(BLOCK) {
            let end = last.min(start + BLOCK);
            let frf = curve.block(start..end).map_err(std::io::Error::other)?;
            if std::mem::take(&mut header_due) {
                write_header(out, key.is_some(), &frf)?;
            }
            write_rows(out, key.as_deref(), &frf)?;
            singular.extend(frf.singular());
            progress(end, last, index, members.len());
        }
    }
    warn_of(&singular, "nan in these rows");
    Ok(())
}

/// The rows of one model.
struct Curve<'a> {
    model: &'a Checked,
    /// Frequencies to solve, Hz.
    base: Vec<f64>,
    /// The model's modes, if peaks are resolved.
    modes: Option<Modes>,
}

impl<'a> Curve<'a> {
    fn new(model: &'a Checked, points: Points) -> Result<Self, Cancelled> {
        let never = AtomicBool::new(false);
        let (base, modes) = match points {
            Points::At(at) => (at.to_vec(), None),
            Points::Sweep => (frequencies(&model.sweep), None),
            Points::Resolved => {
                let modes = modes(model, model.sweep.to, &never)?;
                warn_of_doubt(&modes);
                let listed = (!modes.are_too_many()).then_some(modes);
                (frequencies(&model.sweep), listed)
            }
        };
        Ok(Self { model, base, modes })
    }

    /// The rows from the first frequency of a part of the base to the start of the next part.
    fn block(&self, part: Range<usize>) -> Result<Frf, Cancelled> {
        let never = AtomicBool::new(false);
        let Some(modes) = &self.modes else {
            return sweep(self.model, &self.base[part], &never);
        };
        // One more frequency on each side, to resolve a peak next to a bound.
        let wider = part.start.saturating_sub(1)..self.base.len().min(part.end + 1);
        let solved = sweep(self.model, &self.base[wider], &never)?;
        let frf = resolved(self.model, modes, solved, &never)?;
        let row_of = |bound: f64| frf.frequencies.partition_point(|&f| f < bound);
        let first = row_of(self.base[part.start]);
        let end = match self.base.get(part.end) {
            Some(&next) => row_of(next),
            None => frf.frequencies.len(),
        };
        Ok(rows(&frf, first..end))
    }
}

/// Some rows of a response.
fn rows(frf: &Frf, part: Range<usize>) -> Frf {
    let columns = frf.columns.iter().map(|column| Column {
        name: column.name.clone(),
        values: column.values[part.clone()].to_vec(),
        ..*column
    });
    Frf {
        columns: columns.collect(),
        frequencies: frf.frequencies[part].to_vec(),
    }
}

fn write_header(out: &mut dyn Write, study: bool, frf: &Frf) -> std::io::Result<()> {
    let mut cells = Vec::new();
    if study {
        cells.push("curve".to_owned());
    }
    cells.push("frequency_hz".to_owned());
    for column in &frf.columns {
        match column.kind {
            ColumnKind::Complex => {
                cells.push(cell(&format!("{}.re", column.name)));
                cells.push(cell(&format!("{}.im", column.name)));
            }
            ColumnKind::Energy => cells.push(cell(&column.name)),
        }
    }
    writeln!(out, "{}", cells.join(","))
}

fn write_rows(out: &mut dyn Write, key: Option<&str>, frf: &Frf) -> std::io::Result<()> {
    let key = key.map(cell);
    for (row, frequency) in frf.frequencies.iter().enumerate() {
        if let Some(key) = &key {
            write!(out, "{key},")?;
        }
        write!(out, "{frequency:?}")?;
        for column in &frf.columns {
            let value = column.values[row];
            write!(out, ",{}", number(value.re))?;
            if column.kind == ColumnKind::Complex {
                write!(out, ",{}", number(value.im))?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Shows the progress of a long sweep, if standard error is a terminal.
fn progress(done: usize, of: usize, member: usize, members: usize) {
    let mut out = std::io::stderr().lock();
    if of > BLOCK && out.is_terminal() {
        let end = if done == of { "\n" } else { "" };
        // Ignore errors of the progress display.
        let _ = write!(
            out,
            "\rcurve {} of {members}: {done} of {of} frequencies{end}",
            member + 1
        );
    }
}

fn warn_of_doubt(modes: &Modes) {
    let doubt = match &modes.completeness {
        Completeness::Certain => return,
        Completeness::TooMany => return warn_of_too_many(modes.to),
        Completeness::Open(gaps) => format!("not certain {}", listed(gaps)),
        Completeness::Uncounted => "not counted".to_owned(),
    };
    // The written rows are still correct.
    say(&format!(
        "warning: a peak may be missing: the modes are {doubt}"
    ));
}

fn warn_of_too_many(to: f64) {
    // The written rows are still correct.
    say(&format!(
        "warning: there are more than {MOST_MODES} modes below {to:?} Hz: no rows are added for their peaks"
    ));
}

/// Warns of frequencies without a finite response, and says what the output has there.
fn warn_of(singular: &[f64], there: &str) {
    if let Some(first) = singular.first() {
        // The rows also contain this information.
        say(&format!(
            "warning: no finite response at {}, first at {first:?} Hz ({there}): the model is \
             undamped and at a resonance, or the numbers are beyond the range of the arithmetic",
            counted(singular.len(), "frequency", "frequencies")
        ));
    }
}
