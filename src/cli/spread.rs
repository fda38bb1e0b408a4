//! `beamtune spread`: the band of the responses under tolerances, as CSV.

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use super::csv::{self, cell, number};
use super::{Failure, Sets, source};
use crate::solve::frequencies;
use crate::tune::{Spread, spread};

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A model file, a preset's name, or - for standard input.
    model: OsString,
    /// Frequencies in Hz, instead of the model's sweep.
    #[arg(long, value_name = "F1,F2,..", value_delimiter = ',', value_parser = super::frequency)]
    at: Vec<f64>,
    /// The number of random models within the tolerances of the variables in [tune].
    #[arg(long, value_name = "MODELS", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    samples: u32,
    /// Seed of the random numbers.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The file to write, instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    sets: Sets,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let opened = source::open(&arguments.model, &arguments.sets.sets)?;
    let model = opened.model;
    let tune = model
        .tune
        .as_ref()
        .filter(|tune| tune.variables.iter().any(|one| one.tolerance > 0.0))
        .ok_or_else(|| {
            Failure::input(
                "no variable of [tune] has a tolerance; must have one, as tolerance = 5.0 (percent)",
            )
        })?;
    let at = match arguments.at.as_slice() {
        [] => frequencies(&model.sweep),
        at => at.to_vec(),
    };
    let (samples, seed) = (arguments.samples as usize, arguments.seed);
    let found = spread(&model, tune, (samples, seed), &at, &AtomicBool::new(false))
        .map_err(|fault| Failure::faults(&source::label(&arguments.model), &[fault]))??;
    csv::write(arguments.output.as_deref(), |out| write(out, &at, &found))
}

/// One row per frequency: the 5, 50 and 95 % quantiles of the magnitude of each response.
fn write(out: &mut dyn Write, frequencies: &[f64], found: &[Spread]) -> std::io::Result<()> {
    write!(out, "frequency_hz")?;
    for one in found {
        for quantile in ["p5", "p50", "p95"] {
            write!(out, ",{}", cell(&format!("{}.{quantile}", one.name)))?;
        }
    }
    writeln!(out)?;
    for (row, frequency) in frequencies.iter().enumerate() {
        write!(out, "{}", number(*frequency))?;
        for one in found {
            let [low, median, high] =
                [&one.low, &one.median, &one.high].map(|all| number(all[row]));
            write!(out, ",{low},{median},{high}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}
