//! `beamtune modes`: natural frequencies, damping ratios and mode shapes as CSV.

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
use num_complex::Complex64;

use super::csv::{self, cell, number};
use super::{Failure, Sets, say, source};
use crate::model::{Checked, counted};
use crate::solve::modes::{
    Completeness, Gap, MOST_MODES, Modes, Shape, buckling_factor, modes, shapes,
};

/// The number of points of a shape along the beam.
const PLACES: usize = 101;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A model file, a preset's name, or - for standard input.
    model: OsString,
    /// Highest frequency, Hz; without it, the end of the model's sweep.
    #[arg(long, value_name = "HZ", value_parser = super::frequency)]
    to: Option<f64>,
    /// Writes the mode shapes to this file.
    #[arg(long, value_name = "FILE")]
    shapes: Option<PathBuf>,
    /// The file to write, instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    sets: Sets,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let model = source::open(&arguments.model, &arguments.sets.sets)?.model;
    let to = arguments.to.unwrap_or(model.sweep.to);
    let never = AtomicBool::new(false);
    let found = modes(&model, to, &never)?;
    if found.are_too_many() {
        return Err(Failure::input(format!(
            "there are more than {MOST_MODES} modes below {to:?} Hz: at most {MOST_MODES} are listed; a lower --to gives fewer"
        )));
    }
    csv::write(arguments.output.as_deref(), |out| write_modes(out, &found))?;
    if let Some(file) = &arguments.shapes {
        let shapes = shapes(&model, &found, PLACES, &never)?;
        csv::write(Some(file), |out| write_shapes(out, &model, &shapes))?;
    }
    // On standard error, so that standard output contains only the table.
    say(&statement(&found));
    if let Some(buckling) = buckling(&model, &found) {
        say(&buckling);
    }
    Ok(())
}

/// How far an axial force is from buckling, if there is one.
fn buckling(model: &Checked, found: &Modes) -> Option<String> {
    let parts = model.uniform_parts();
    let force = parts[0].beam.axial_force;
    if parts.iter().all(|part| part.beam.axial_force == 0.0) {
        return None;
    }
    let Some(factor) = buckling_factor(model) else {
        return Some("the beam buckles under no axial force".to_owned());
    };
    let load = if parts.iter().all(|part| part.beam.axial_force == force) {
        format!(", {:.6e} N", factor * force)
    } else {
        String::new()
    };
    let unstable = counted(found.unstable, "mode", "modes");
    Some(if found.unstable > 0 {
        format!(
            "warning: the beam has buckled: {unstable} unstable and not listed; it buckles at {factor:.6} times its axial force{load}"
        )
    } else {
        format!("it buckles at {factor:.6} times its axial force{load}")
    })
}

/// Which part of the list is certain, and which is not.
fn statement(found: &Modes) -> String {
    let (count, to) = (found.modes.len(), found.to);
    let modes = counted(count, "mode", "modes");
    let undamped = match found.undamped {
        undamped if undamped == count => String::new(),
        undamped => format!(" ({undamped} without damping)"),
    };
    match &found.completeness {
        Completeness::Certain => format!("{count} of {modes} below {to} Hz{undamped}"),
        Completeness::TooMany => {
            format!("more than {MOST_MODES} modes below {to} Hz: none is listed")
        }
        Completeness::Open(gaps) => format!(
            "warning: {modes} found below {to} Hz{undamped}, and the list may not be complete {}; all others are certain",
            listed(gaps)
        ),
        Completeness::Uncounted => {
            format!(
                "warning: {modes} found below {to} Hz{undamped}, not counted: some may be missing"
            )
        }
    }
}

/// The uncertain ranges of a list of modes as a sentence.
pub(super) fn listed(gaps: &[Gap]) -> String {
    let gaps: Vec<String> = gaps.iter().map(Gap::to_string).collect();
    gaps.join("; ")
}

fn write_modes(out: &mut dyn Write, found: &Modes) -> std::io::Result<()> {
    writeln!(out, "mode,frequency_hz,damping_ratio")?;
    for (index, mode) in found.modes.iter().enumerate() {
        let (frequency, damping) = (number(mode.frequency()), number(mode.damping_ratio()));
        writeln!(out, "{},{frequency},{damping}", index + 1)?;
    }
    Ok(())
}

/// A row for each motion of each point and of each mass.
fn write_shapes(out: &mut dyn Write, model: &Checked, shapes: &[Shape]) -> std::io::Result<()> {
    writeln!(out, "mode,at,position_m,direction,re,im")?;
    for (index, shape) in shapes.iter().enumerate() {
        let mut row = |at: &str, x: f64, direction: &str, value: Complex64| {
            let (re, im) = (number(value.re), number(value.im));
            writeln!(
                out,
                "{},{at},{},{direction},{re},{im}",
                index + 1,
                number(x)
            )
        };
        for (place, &x) in shape.positions.iter().enumerate() {
            row("beam", x, "w", shape.w[place])?;
            row("beam", x, "psi", shape.psi[place])?;
            row("beam", x, "v", shape.v[place])?;
        }
        for (subsystem, motion) in model.attached().zip(&shape.masses) {
            let name = cell(&subsystem.name);
            for (direction, value) in ["y", "z", "theta"].into_iter().zip(motion) {
                row(&name, subsystem.position, direction, *value)?;
            }
        }
    }
    Ok(())
}
