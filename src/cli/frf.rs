//! `beamtune frf`: frequency responses as CSV.

use std::io::{BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use clap::Args;

use super::{Failure, Sets, allow_broken_pipe, source};
use crate::model::{Family, Model, path, save_with};
use crate::solve::{ColumnKind, Frf, frequencies, sweep};

/// Frequencies solved and written at a time: bounds the memory of a long sweep.
const BLOCK: usize = 4096;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A model file, a preset's name, or - for standard input.
    model: String,
    /// Frequencies in Hz, in place of the model's sweep.
    #[arg(long, value_name = "F1,F2,..", value_delimiter = ',', value_parser = frequency)]
    at: Vec<f64>,
    /// One block of rows for each member of this study.
    #[arg(long, value_name = "NAME")]
    study: Option<String>,
    /// The file to write, in place of standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    sets: Sets,
}

fn frequency(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err("a frequency is a number of Hz above 0".into()),
    }
}

/// A model to solve, and its first cell where a study is asked for.
type Member = (Option<String>, Model);

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let model = source::open(&arguments.model, &arguments.sets.sets)?.model;
    let members = members(&model, arguments.study.as_deref())?;
    match &arguments.output {
        None => allow_broken_pipe(write_all(
            &mut BufWriter::new(std::io::stdout().lock()),
            &members,
            &arguments.at,
        )),
        Some(file) => write_file(file, &members, &arguments.at).map_err(|error| {
            Failure::Other(format!("{}: cannot be written: {error}", file.display()))
        }),
    }
}

fn members(model: &Model, study: Option<&str>) -> Result<Vec<Member>, Failure> {
    let Some(name) = study else {
        return Ok(vec![(None, model.clone())]);
    };
    let family = family(model, name)?;
    let keys = path::family_keys(family).into_iter().enumerate();
    keys.map(|(index, key)| match path::apply(model, family, index) {
        Ok(member) => Ok((Some(key), member)),
        Err(faults) => Err(Failure::faults(&format!("study {name}, {key}"), &faults)),
    })
    .collect()
}

fn family<'a>(model: &'a Model, name: &str) -> Result<&'a Family, Failure> {
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

/// Writes beside the file and renames, so that a failure leaves what was there.
fn write_file(file: &Path, members: &[Member], at: &[f64]) -> std::io::Result<()> {
    save_with(file, |file| {
        write_all(&mut BufWriter::new(file), members, at)
    })
}

fn write_all(out: &mut impl Write, members: &[Member], at: &[f64]) -> std::io::Result<()> {
    let mut header_due = true;
    let mut singular = Vec::new();
    for (index, (key, model)) in members.iter().enumerate() {
        let all = if at.is_empty() {
            frequencies(&model.sweep)
        } else {
            at.to_vec()
        };
        let mut done = 0;
        for block in all.chunks(BLOCK) {
            let Some(frf) = sweep(model, block, &AtomicBool::new(false)) else {
                continue;
            };
            if std::mem::take(&mut header_due) {
                write_header(out, key.is_some(), &frf)?;
            }
            write_rows(out, key.as_deref(), &frf)?;
            singular.extend(frf.singular());
            done += block.len();
            progress(done, all.len(), index, members.len());
        }
    }
    out.flush()?;
    warn_of(&singular);
    Ok(())
}

fn write_header(out: &mut impl Write, study: bool, frf: &Frf) -> std::io::Result<()> {
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

fn write_rows(out: &mut impl Write, key: Option<&str>, frf: &Frf) -> std::io::Result<()> {
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

/// The shortest text that reads back to the same number; `nan` where there is no finite answer.
fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else {
        "nan".into()
    }
}

/// A text as a CSV cell (RFC 4180).
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Shows how far a long sweep is, where somebody watches.
fn progress(done: usize, of: usize, member: usize, members: usize) {
    let mut out = std::io::stderr().lock();
    if of > BLOCK && out.is_terminal() {
        let end = if done == of { "\n" } else { "" };
        // Progress that cannot be shown is no reason to stop.
        let _ = write!(
            out,
            "\rcurve {} of {members}: {done} of {of} frequencies{end}",
            member + 1
        );
    }
}

fn warn_of(singular: &[f64]) {
    if let Some(first) = singular.first() {
        // The rows say it too.
        let _ = writeln!(
            std::io::stderr(),
            "warning: no finite response at {} frequencies, first at {first:?} Hz (nan in these rows): the model is \
             undamped and at a resonance, or the numbers are beyond the range of the arithmetic",
            singular.len()
        );
    }
}
