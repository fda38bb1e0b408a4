//! `beamtune validate`: compares the exact solution with two independent methods.

use std::ffi::OsString;
use std::io::{IsTerminal, Write};
use std::process::ExitCode;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use clap::Args;

use super::{Failure, Sets, frequency, print, source};
use crate::model::Checked;
use crate::solve::compare::{Difference, differences};
use crate::solve::fem::{self, FiniteElements};
use crate::solve::transfer_matrix::{self, NotApplicable};
use crate::solve::{self, Frf};

mod report;

/// The largest accepted number of elements; four times as many are solved.
const MOST_ELEMENTS: u64 = 10_000;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A model file, a preset's name, or - for standard input.
    model: OsString,
    /// Finite elements along the beam; by default as many as the highest frequency needs.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MOST_ELEMENTS))]
    elements: Option<u64>,
    /// Frequencies in Hz, instead of the model's sweep.
    #[arg(long, value_name = "F1,F2,..", value_delimiter = ',', value_parser = frequency)]
    at: Vec<f64>,
    /// The largest accepted relative difference.
    #[arg(long, value_name = "T", default_value = "1e-2", value_parser = tolerance)]
    tolerance: f64,
    #[command(flatten)]
    sets: Sets,
}

fn tolerance(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err("a tolerance is a number above 0".into()),
    }
}

/// The result of one method: its differences by response and frequency, and its time.
struct Witness {
    differences: Vec<Vec<Option<Difference>>>,
    time: Duration,
}

/// The data of the report.
struct Findings {
    exact: Frf,
    exact_time: Duration,
    /// Finite elements, each with its number: N, 2 N and 4 N.
    meshes: Vec<(usize, Witness)>,
    chain: Result<Witness, NotApplicable>,
}

/// Prints the report; returns 0 if the finite elements agree with the exact solution, else 1.
pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let model = source::open(&arguments.model, &arguments.sets.sets)?.model;
    let mut frequencies = arguments.at.clone();
    if frequencies.is_empty() {
        frequencies = solve::frequencies(&model.sweep);
    }
    // The mesh depends on the highest solved frequency.
    let highest = frequencies.iter().copied().fold(0.0, f64::max);
    let model = model.derived(|model| model.sweep.to = highest);
    if !model.responses.iter().any(|response| response.enabled) {
        return Err(Failure::input(format!(
            "{}: has no enabled response to compare",
            source::label(&arguments.model)
        )));
    }
    let elements = match arguments.elements {
        Some(count) => count as usize,
        None => fem::default_elements(&model),
    };
    let findings = find(&model, elements, &frequencies)?;
    print(&report::text(&model, &findings, arguments))?;
    let worst = largest(&findings.meshes[0].1.differences, |d| d.relative);
    match worst {
        Some((worst, _)) if worst <= arguments.tolerance => Ok(ExitCode::SUCCESS),
        Some(_) => Ok(ExitCode::FAILURE),
        None => Err(Failure::Other(format!(
            "{}: the exact response is finite at none of the frequencies",
            source::label(&arguments.model)
        ))),
    }
}

/// Solves by all methods.
fn find(model: &Checked, elements: usize, frequencies: &[f64]) -> Result<Findings, Failure> {
    // Only a signal cancels a command.
    let never = AtomicBool::new(false);
    progress("exact solution");
    let start = Instant::now();
    let exact = solve::sweep(model, frequencies, &never)?;
    let exact_time = start.elapsed();
    let witness = |start: Instant, frf: &Frf| Witness {
        time: start.elapsed(),
        differences: differences(model, &exact, frf),
    };
    progress("transfer matrices");
    let start = Instant::now();
    let chain = match transfer_matrix::sweep(model, frequencies, &never) {
        Ok(frf) => Ok(witness(start, &frf?)),
        Err(reason) => Err(reason),
    };
    let mut mesh = FiniteElements::new(model, elements);
    let mut meshes = Vec::new();
    for _ in 0..3 {
        progress(&format!("{} finite elements", mesh.elements()));
        let start = Instant::now();
        let frf = mesh.sweep(frequencies, &never)?;
        meshes.push((mesh.elements(), witness(start, &frf)));
        mesh = mesh.halved();
    }
    progress("");
    Ok(Findings {
        exact,
        exact_time,
        meshes,
        chain,
    })
}

/// Shows the current step, if standard error is a terminal.
fn progress(what: &str) {
    let mut out = std::io::stderr().lock();
    if out.is_terminal() {
        // Ignore errors of the progress display.
        let _ = write!(out, "\r\x1b[K{what}");
    }
}

/// The largest of a figure of the differences, with the row of its frequency.
fn largest<'a>(
    differences: impl IntoIterator<Item = &'a Vec<Option<Difference>>>,
    figure: impl Fn(&Difference) -> f64,
) -> Option<(f64, usize)> {
    let found = differences.into_iter().flat_map(|column| {
        let rows = column.iter().enumerate();
        rows.filter_map(|(row, difference)| difference.as_ref().map(|d| (row, d)))
    });
    found
        .map(|(row, difference)| (figure(difference), row))
        .max_by(|a, b| a.0.total_cmp(&b.0))
}
