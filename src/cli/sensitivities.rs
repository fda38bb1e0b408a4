//! `beamtune sensitivities`: which parameter matters, as CSV.

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use clap::Args;

use super::csv::{self, cell, number};
use super::{Failure, Sets, say, source};
use crate::model::{Checked, edit, path};
use crate::solve::modes::{MOST_MODES, Modes, modes};
use crate::solve::peaks::{Peak, peaks, resolved};
use crate::solve::sensitivity::{Figure, Sensitivity, effects, unavailable};
use crate::solve::{Cancelled, frequencies, sweep};

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A model file, a preset's name, or - for standard input.
    model: OsString,
    /// The response; by default the first enabled one.
    #[arg(long, value_name = "NAME")]
    response: Option<String>,
    #[command(flatten)]
    of: Of,
    /// The file to write, instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    sets: Sets,
}

/// The figure to differentiate.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
struct Of {
    /// The level at this frequency.
    #[arg(long, value_name = "HZ", value_parser = super::frequency)]
    at: Option<f64>,
    /// Height and frequency of the peak nearest to this frequency.
    #[arg(long, value_name = "HZ", value_parser = super::frequency)]
    peak: Option<f64>,
    /// Frequency and damping ratio of the mode with this number in `beamtune modes`.
    #[arg(long, value_name = "NUMBER")]
    mode: Option<usize>,
    /// The mean-square level in this band.
    #[arg(long, value_name = "F1,F2", value_parser = band)]
    band: Option<[f64; 2]>,
}

fn band(text: &str) -> Result<[f64; 2], String> {
    let ends = text
        .split_once(',')
        .ok_or("a band is two frequencies, as 20,120")?;
    let [low, high] = [super::frequency(ends.0)?, super::frequency(ends.1)?];
    if low < high {
        Ok([low, high])
    } else {
        Err("a band goes from a lower to a higher frequency".into())
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let model = source::open(&arguments.model, &arguments.sets.sets)?.model;
    let response = response(&model, arguments.response.as_deref())?;
    let figure = figure(&model, response, &arguments.of)?;
    let found = effects(&model, &figure, &AtomicBool::new(false))?;
    let found = sorted(found, &figure);
    csv::write(arguments.output.as_deref(), |out| {
        write(out, &model, &found)
    })?;
    if let Some(reason) = unavailable(&model, &figure, &found) {
        // The written cells are still correct.
        say(&format!("warning: {reason}"));
    }
    Ok(())
}

/// The index of a response among the enabled ones.
fn response(model: &Checked, name: Option<&str>) -> Result<usize, Failure> {
    let names: Vec<&str> = model
        .responses
        .iter()
        .filter(|one| one.enabled)
        .map(|one| one.name.as_str())
        .collect();
    let index = match name {
        Some(name) => names.iter().position(|one| *one == name),
        None => (!names.is_empty()).then_some(0),
    };
    index.ok_or_else(|| {
        Failure::input(match name {
            Some(name) => format!(
                "--response {name}: is no enabled response; must be one of {}",
                names.join(", ")
            ),
            None => "the model has no enabled response".to_owned(),
        })
    })
}

fn figure(model: &Checked, response: usize, of: &Of) -> Result<Figure, Failure> {
    if let Some(frequency) = of.at {
        return Ok(Figure::Level {
            response,
            frequency,
        });
    }
    if let Some(band) = of.band {
        let modes = Arc::new(modes_up_to(model, band[1].max(model.sweep.to))?);
        return Ok(Figure::Band {
            response,
            modes,
            band,
        });
    }
    let modes = Arc::new(modes_up_to(model, model.sweep.to)?);
    if let Some(number) = of.mode {
        let count = modes.modes.len();
        if !(1..=count).contains(&number) {
            return Err(Failure::input(format!(
                "--mode {number}: must be from 1 to {count}, the modes below {} Hz",
                model.sweep.to
            )));
        }
        let index = number - 1;
        return Ok(Figure::Mode { modes, index });
    }
    let near = of.peak.unwrap_or_default();
    let peak = nearest_peak(model, response, &modes, near)?.ok_or_else(|| {
        Failure::input(format!(
            "--peak {near}: the response has no peak of finite height in the sweep"
        ))
    })?;
    Ok(Figure::Peak {
        response,
        frequency: peak.frequency,
    })
}

fn modes_up_to(model: &Checked, to: f64) -> Result<Modes, Failure> {
    let found = modes(model, to, &AtomicBool::new(false))?;
    if found.are_too_many() {
        return Err(Failure::input(format!(
            "there are more than {MOST_MODES} modes below {to:?} Hz: at most {MOST_MODES} are listed"
        )));
    }
    Ok(found)
}

fn nearest_peak(
    model: &Checked,
    response: usize,
    modes: &Modes,
    near: f64,
) -> Result<Option<Peak>, Cancelled> {
    let never = AtomicBool::new(false);
    let solved = sweep(model, &frequencies(&model.sweep), &never)?;
    let frf = resolved(model, modes, solved, &never)?;
    let peaks = peaks(&frf.frequencies, &frf.columns[response], modes);
    let distance = |peak: &Peak| (peak.frequency - near).abs();
    let finite = peaks.into_iter().filter(|peak| !peak.pole);
    Ok(finite.min_by(|a, b| distance(a).total_cmp(&distance(b))))
}

/// Sorts by effect, the largest first: on the frequency of a mode, else on the level.
fn sorted(mut found: Vec<Sensitivity>, figure: &Figure) -> Vec<Sensitivity> {
    let size = |one: &Sensitivity| {
        let effect = match figure {
            Figure::Mode { .. } => one.frequency,
            Figure::Level { .. } | Figure::Peak { .. } | Figure::Band { .. } => one.level,
        };
        effect.map_or(-1.0, f64::abs)
    };
    found.sort_by(|a, b| size(b).total_cmp(&size(a)));
    found
}

/// One row per parameter: derivatives with respect to the logarithm of its magnitude.
fn write(out: &mut dyn Write, model: &Checked, found: &[Sensitivity]) -> std::io::Result<()> {
    writeln!(out, "parameter,value,level_db,frequency_hz,damping_ratio")?;
    let or_none = |value: Option<f64>| value.map_or_else(String::new, number);
    let ids: Vec<_> = found.iter().map(|one| one.id).collect();
    for (one, path) in found.iter().zip(path::texts(model, &ids)) {
        let value = edit::number(model, one.id).unwrap_or(f64::NAN);
        writeln!(
            out,
            "{},{},{},{},{}",
            cell(&path),
            number(value),
            or_none(one.level),
            or_none(one.frequency),
            or_none(one.damping_ratio)
        )?;
    }
    Ok(())
}
