//! `beamtune measured`: a summary of a file of measured curves, and the curves in SI as CSV.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};

use super::csv::{self, cell, number};
use super::{Failure, print};
use crate::escape::{escape, path_text};
use crate::measured::{self, Curve, Hint, Inspection, Layout, Opened};
use crate::model::Fault;
use crate::unit::Kind;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A table (CSV or similar text) or a universal file (UFF 58), or - for standard input.
    #[arg(value_hint = ValueHint::FilePath)]
    file: PathBuf,
    /// Units and columns that the file lacks or states wrongly, such as "hz; re im; m/N", "khz; dB deg; g/N" or, with
    /// column numbers, "hz 1; re 8; im 9; m/N"; with ? as the unit the values are not converted.
    #[arg(long, value_name = "FREQUENCY; VALUES; UNIT")]
    columns: Option<String>,
    /// The CSV file to write: the curves in SI, one row per frequency; a cell is empty if its curve has no value there.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Prints one row per curve, and writes the curves if a file is named.
pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let curves = read(arguments)?;
    if let Some(file) = &arguments.output {
        csv::write(Some(file), |out| write(out, &curves))?;
    }
    print(&table(&curves))
}

fn read(arguments: &Arguments) -> Result<Vec<Curve>, Failure> {
    let name = match arguments.file.to_str() {
        Some("-") => "standard input".to_owned(),
        _ => path_text(&arguments.file),
    };
    let label = escape(&name).into_owned();
    let layout = arguments.columns.as_deref().map(Layout::parse).transpose();
    let hint = Hint {
        name,
        layout: layout.map_err(|reason| Failure::input(format!("--columns {reason}")))?,
    };
    let failed = |fault: Fault| Failure::faults(&label, &[fault]);
    let bytes = load(&arguments.file).map_err(failed)?;
    match measured::open_in_si(&bytes, &hint).map_err(failed)? {
        Opened::Curves(curves) => Ok(curves),
        Opened::Asks(seen) => Err(Failure::Input(asked(&label, &seen))),
    }
}

fn load(file: &Path) -> Result<Vec<u8>, Fault> {
    if file != Path::new("-") {
        return measured::load(file);
    }
    let mut bytes = Vec::new();
    let most = measured::MOST_BYTES as u64 + 1;
    match std::io::stdin().lock().take(most).read_to_end(&mut bytes) {
        Ok(_) => Ok(bytes),
        Err(error) => Err(Fault::new("", format!("cannot be read: {error}"))),
    }
}

/// The questions that a file leaves open, with its first rows and an example of an answer, one per line.
fn asked(label: &str, seen: &Inspection) -> Vec<String> {
    let mut lines = vec![format!("{label}: {}", seen.question())];
    let known = seen
        .recognised
        .iter()
        .map(|known| format!("{label}: {known}"));
    lines.extend(known);
    lines.extend(
        seen.preview()
            .into_iter()
            .map(|row| format!("{label}: {row}")),
    );
    lines.push(format!(
        "{label}: answer with --columns, such as --columns \"{}\"{}",
        seen.proposal,
        if seen.proposal.unit.is_none() {
            " with the unit in place of ?, or ? to leave the values unchanged"
        } else {
            ""
        }
    ));
    lines
}

/// One row per curve.
fn table(curves: &[Curve]) -> String {
    let header = "curve,values,quantity,unit,points,from_hz,to_hz,notes".to_owned();
    let rows = curves.iter().map(|curve| {
        let ends = [curve.frequencies.first(), curve.frequencies.last()];
        let [from, to] = ends.map(|end| end.map_or_else(String::new, |end| number(*end)));
        let values = if curve.phase_known {
            "complex"
        } else {
            "magnitude"
        };
        let (quantity, unit) = quantity(curve.kind);
        let (name, notes) = (cell(&curve.name), cell(&curve.notes.join("; ")));
        let points = curve.frequencies.len();
        format!("{name},{values},{quantity},{unit},{points},{from},{to},{notes}")
    });
    let lines: Vec<String> = std::iter::once(header).chain(rows).collect();
    lines.join("\n") + "\n"
}

/// The quantity of the values and their SI unit; both empty if unknown.
fn quantity(kind: Option<Kind>) -> (&'static str, String) {
    let unit = kind.map_or_else(String::new, Kind::unit);
    let words = match kind {
        None => "",
        Some(Kind::Energy) => "energy",
        Some(Kind::Amplitude(dimension)) => dimension.words(),
    };
    (words, unit)
}

/// The curves in the format of `beamtune frf`: one row for each frequency of any curve.
fn write(out: &mut dyn Write, curves: &[Curve]) -> std::io::Result<()> {
    write!(out, "frequency_hz")?;
    for curve in curves {
        if curve.phase_known {
            let [re, im] = ["re", "im"].map(|part| cell(&format!("{}.{part}", curve.name)));
            write!(out, ",{re},{im}")?;
        } else {
            write!(out, ",{}", cell(&curve.name))?;
        }
    }
    writeln!(out)?;
    let mut places = vec![0; curves.len()];
    loop {
        let next = curves.iter().zip(&places);
        let next = next.filter_map(|(curve, place)| curve.frequencies.get(*place));
        let Some(frequency) = next.copied().reduce(f64::min) else {
            return Ok(());
        };
        write!(out, "{}", number(frequency))?;
        for (curve, place) in curves.iter().zip(&mut places) {
            let value = curve.values[*place..].first();
            let value = value.filter(|_| curve.frequencies[*place] == frequency);
            *place += usize::from(value.is_some());
            match (value, curve.phase_known) {
                (Some(value), true) => write!(out, ",{},{}", number(value.re), number(value.im))?,
                (Some(value), false) => write!(out, ",{}", number(value.re))?,
                (None, true) => write!(out, ",,")?,
                (None, false) => write!(out, ",")?,
            }
        }
        writeln!(out)?;
    }
}
