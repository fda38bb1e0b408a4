//! `beamtune tune`: optimises the variables of `[tune]`.

mod example;
mod interruption;
mod progress;
mod report;

use std::ffi::OsString;
use std::io::{IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use self::interruption::{Interruption, Target};
use self::progress::Progress;
use super::csv::unwritten;
use super::{Failure, Sets, print, source, stdout, warn_of_loss};
use crate::escape::shown_path;
use crate::files::{self, Opened};
use crate::model::{self, Model};
use crate::tune::{self, Options, Problem, Stop, Tuned};

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A model file, a preset's name, or - for standard input.
    model: OsString,
    /// The model file to write: the model with the best parameters, and a summary in its notes.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Seed of the random numbers; the same seed gives the same result.
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// The most models to evaluate; the default depends on the number of variables.
    #[arg(long, value_name = "EVALS", value_parser = clap::value_parser!(u64).range(1..))]
    budget: Option<u64>,
    #[command(flatten)]
    sets: Sets,
}

/// Searches, writes the tuned model and prints the improvements. A signal ends the search, and the program once the
/// best so far is written; the exit code is then 128 plus the number of the signal.
pub(super) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let opened = source::open(&arguments.model, &arguments.sets.sets)?;
    let label = &source::label(&arguments.model);
    if opened.model.tune.is_none() {
        let lines = example::wanted(label, &opened.model);
        return Err(Failure::Input(vec![lines]));
    }
    // Check the output before the search, so that no result is lost.
    stdout::must_be_open()?;
    let output = arguments.output.as_deref();
    if let Some(file) = output {
        warn_of_loss(file).map_err(|error| unwritten(file, &error))?;
    }
    let problem = Problem::new(&opened.model, opened.source.folder())
        .map_err(|faults| Failure::faults(label, &faults))?;
    for path in problem.outside() {
        warn(&format!(
            "{path} is outside its bounds; the search starts at the nearer one"
        ));
    }
    let interruption = Interruption::listen(Target {
        opened: opened.clone(),
        output: arguments.output.clone(),
        seed: arguments.seed,
    })?;
    let tuned = search(&problem, arguments, &interruption)?;
    interruption.write(|| output.map_or(Ok(()), |file| save(file, &written(&opened, &tuned)?)))?;
    warn_of(&tuned, output);
    let printed = print(&report::table(&opened.model, &tuned));
    match interruption.signal() {
        // The terminal may be closed, which may be the reason for the signal.
        Some(signal) => Ok(ExitCode::from(128_u8.saturating_add(signal))),
        None => printed.map(|()| ExitCode::SUCCESS),
    }
}

fn search(
    problem: &Problem,
    arguments: &Arguments,
    interruption: &Interruption,
) -> Result<Tuned, Failure> {
    let options = Options {
        seed: arguments.seed,
        budget: arguments.budget.map(|budget| budget as usize),
    };
    let mut progress = Progress::start();
    let found = tune::run(problem, &options, &interruption.cancel, &mut |status| {
        interruption.note(status);
        progress.show(status);
    });
    progress.clear();
    found.map_err(Failure::Other)
}

/// The text of the tuned model, with a summary in its notes.
fn written(opened: &Opened, tuned: &Tuned) -> Result<String, Failure> {
    let model = notes_added(&tuned.model, &report::notes(&opened.model, tuned));
    let faults = model::check(&model);
    match faults.first() {
        None => Ok(model::write(&model, &opened.text)),
        Some(fault) => Err(Failure::Other(format!(
            "the tuned model is invalid: {fault}"
        ))),
    }
}

/// The model with a paragraph added to its notes.
fn notes_added(model: &Model, paragraph: &str) -> Model {
    let mut notes = model.notes.trim_end().to_owned();
    if !notes.is_empty() {
        notes.push_str("\n\n");
    }
    notes.push_str(paragraph);
    Model {
        notes,
        ..model.clone()
    }
}

/// Writes the tuned model; waits for a pipe or a device.
fn save(file: &Path, text: &str) -> Result<(), Failure> {
    files::save_with(file, |out| out.write_all(text.as_bytes()))
        .map_err(|error| unwritten(file, &error))
}

/// Warnings that should not be overlooked; the table contains them too.
fn warn_of(tuned: &Tuned, output: Option<&Path>) {
    if tuned.stop == Stop::Cancelled {
        let written = match output {
            Some(file) => format!(", and is in {}", shown_path(file)),
            None => String::new(),
        };
        say(&format!("stopped: the best so far is the result{written}"));
    }
    if tuned.limits.iter().any(|limit| !limit.holds) {
        warn("no model within all limits was found");
    }
    if tuned.after.iter().any(|one| one.overlooked.is_some()) {
        warn(
            "there is a higher peak than the search evaluated; another --seed may find a better model",
        );
    }
}

fn warn(what: &str) {
    say(&format!("warning: {what}"));
}

/// Writes a message to standard error over the progress line; ignores errors.
fn say(what: &str) {
    if std::io::stderr().is_terminal() {
        let _ = write!(std::io::stderr(), "\r\x1b[K");
    }
    super::say(what);
}
