//! The commands: they parse arguments, print results to standard output and return exit codes.

mod completions;
mod csv;
mod failure;
mod frf;
mod guide;
mod man;
mod measured;
mod modes;
mod paths;
mod sensitivities;
mod signals;
mod source;
mod spread;
mod stdout;
mod tune;
mod usage;
mod validate;

use std::ffi::{OsStr, OsString};
use std::io::{IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::{Args, CommandFactory as _, Parser, Subcommand};

use self::failure::Failure;
use self::stdout::print;
use crate::escape::{escape, escape_lines, shown_path};
use crate::files::{self, Folders, read_if_there};
use crate::model::path;
use crate::presets;
use crate::solve;
use crate::tui::options::{AppearanceArguments, Environment};
use crate::tui::user::config::{self, Config};
use crate::tui::{self, Ended, Setup};

/// Designs a thin-walled beam with spring-damper-mass subsystems: exact frequency responses in the terminal.
#[derive(Debug, Parser)]
#[command(
    name = "beamtune",
    version,
    about,
    args_conflicts_with_subcommands = true
)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    designer: ModelArguments,
}

#[derive(Debug, Args)]
struct ModelArguments {
    /// A model file, a preset's name, or - for standard input.
    #[arg(default_value = "fig05a")]
    model: OsString,
    #[command(flatten)]
    sets: Sets,
    #[command(flatten)]
    look: AppearanceArguments,
}

#[derive(Debug, Args)]
struct Sets {
    /// Changes a parameter first, such as subsystems.*.mass=120 or beam.length=3.5; may be repeated.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    sets: Vec<String>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Prints the guide: the list of its chapters, or one chapter.
    Guide(guide::Arguments),
    /// Lists the presets: name and title.
    Presets,
    /// Prints a preset's model file.
    Show {
        /// The preset's name.
        preset: String,
    },
    /// Checks a model file; prints its first 50 faults, or notes on what is unusual, or nothing.
    Check {
        /// A model file, a preset's name, or - for standard input.
        model: OsString,
    },
    /// Writes frequency responses as CSV, or as a universal file (data set 58).
    Frf(frf::Arguments),
    /// Writes natural frequencies and damping ratios as CSV.
    Modes(modes::Arguments),
    /// Writes the sensitivities as CSV: exact derivatives of a level, a peak, a mode or a band.
    Sensitivities(sensitivities::Arguments),
    /// Writes the quantiles of the responses within the tolerances of [tune] as CSV.
    Spread(spread::Arguments),
    /// Optimises the variables of the model's [tune].
    Tune(tune::Arguments),
    /// Prints a summary of a file of measured curves as CSV, and writes the curves in SI.
    Measured(measured::Arguments),
    /// Compares finite elements and the paper's transfer matrices with the exact responses.
    Validate(validate::Arguments),
    /// Prints the paths of the configuration, memory, recovery files and log.
    Paths,
    /// Prints the completion script of a shell.
    Completions(completions::Arguments),
    /// Prints the manual page; `beamtune man | man -l -` shows it.
    Man,
}

/// Runs the program: 0 done, 2 bad input or usage, 1 anything else, 128 + n after signal n.
pub fn main() -> ExitCode {
    let done = match Arguments::try_parse() {
        Ok(arguments) => run(arguments),
        Err(error) => usage::answer(&error),
    };
    done.unwrap_or_else(|failure| {
        let (messages, code) = match failure {
            Failure::Input(messages) => (messages, 2),
            Failure::Other(line) => (vec![escape(&line).into_owned()], 1),
        };
        for message in messages {
            say(&format!("error: {message}"));
        }
        ExitCode::from(code)
    })
}

/// Writes a message to standard error, with hidden characters escaped.
fn say(what: &str) {
    // If standard error is closed, the message is lost.
    let _ = writeln!(std::io::stderr(), "{}", escape_lines(what));
}

/// Checks a model; notes are not faults, and go to standard error.
fn check(model: &OsStr) -> Result<(), Failure> {
    let model = source::open(model, &[])?.model;
    for note in solve::notes(&model) {
        say(&format!(
            "note: {}: {}",
            path::text(&model, note.id),
            note.message
        ));
    }
    Ok(())
}

fn run(arguments: Arguments) -> Result<ExitCode, Failure> {
    match arguments.command {
        None => return design(&arguments.designer),
        Some(Command::Guide(arguments)) => guide::run(&arguments)?,
        Some(Command::Presets) => print(&list_presets())?,
        Some(Command::Show { preset }) => print(source::preset(&preset)?.text)?,
        Some(Command::Check { model }) => check(&model)?,
        Some(Command::Frf(arguments)) => frf::run(&arguments)?,
        Some(Command::Modes(arguments)) => modes::run(&arguments)?,
        Some(Command::Sensitivities(arguments)) => sensitivities::run(&arguments)?,
        Some(Command::Spread(arguments)) => spread::run(&arguments)?,
        Some(Command::Measured(arguments)) => measured::run(&arguments)?,
        Some(Command::Validate(arguments)) => return validate::run(&arguments),
        Some(Command::Paths) => paths::run()?,
        Some(Command::Completions(arguments)) => {
            completions::run(&arguments, completion_commands())?;
        }
        Some(Command::Man) => man::run(Arguments::command())?,
        Some(Command::Tune(arguments)) => return tune::run(&arguments),
    }
    Ok(ExitCode::SUCCESS)
}

fn design(arguments: &ModelArguments) -> Result<ExitCode, Failure> {
    if let Some(failure) = usage::misspelt(&arguments.model) {
        return Err(failure);
    }
    let opened = source::open(&arguments.model, &arguments.sets.sets)?;
    if !std::io::stdout().is_terminal() {
        return Err(Failure::input(
            "the designer needs a terminal on standard output; `beamtune frf` writes to files and pipes",
        ));
    }
    if !Environment::of_process().has_screen() {
        return Err(Failure::input(
            "this terminal cannot show the designer, because TERM is dumb or not set; it needs a full-screen terminal, such as \
             TERM=xterm-256color; `beamtune frf` writes to files and pipes",
        ));
    }
    let folders = Folders::of_user();
    let setup = Setup {
        options: arguments.look.options(),
        config: configuration(folders.as_ref().ok())?,
        // Without a home folder the designer runs, but stores nothing for the user.
        folders: folders.ok(),
    };
    let code = match tui::run(opened, &setup)? {
        Ended::Left => 0,
        Ended::Signal(signal) => 128_u8.saturating_add(signal),
        Ended::Fault => 101,
    };
    Ok(ExitCode::from(code))
}

/// The commands, from which completions are generated.
fn completion_commands() -> completions::Commands {
    let bare = clap::Command::new("beamtune").version(env!("CARGO_PKG_VERSION"));
    let options = AppearanceArguments::augment_args(Sets::augment_args(bare));
    completions::Commands {
        whole: Arguments::command(),
        without_model: Command::augment_subcommands(options),
    }
}

/// The user's configuration, if there is one.
fn configuration(folders: Option<&Folders>) -> Result<Config, Failure> {
    let Some(path) = folders.map(Folders::config_file) else {
        return Ok(Config::default());
    };
    let name = shown_path(&path);
    match read_if_there(&path) {
        Ok(Some(text)) => config::read(&text).map_err(|faults| Failure::faults(&name, &faults)),
        Ok(None) => Ok(Config::default()),
        Err(error) => Err(Failure::input(format!("{name}: cannot be read: {error}"))),
    }
}

fn list_presets() -> String {
    let width = presets::ALL
        .iter()
        .map(|preset| preset.name.len())
        .max()
        .unwrap_or(0);
    let line =
        |preset: &presets::Preset| format!("{}  {}\n", padded(preset.name, width), preset.title());
    presets::ALL.iter().map(line).collect::<Vec<_>>().concat()
}

/// A frequency argument, Hz.
fn frequency(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(value),
        _ => Err("a frequency is a number of Hz above 0".into()),
    }
}

/// Pads a text with spaces to a width in characters. `format!` fails above a width of 65,535, which text from outside
/// may exceed.
fn padded(text: &str, width: usize) -> String {
    let blanks = width.saturating_sub(text.chars().count());
    format!("{text}{}", " ".repeat(blanks))
}

/// Warns of attributes that a file will lose when it is replaced.
///
/// # Errors
/// It cannot be replaced.
fn warn_of_loss(file: &Path) -> std::io::Result<()> {
    if let Some(lost) = files::may_save(file)? {
        let name = shown_path(file);
        say(&format!(
            "warning: {name} loses {lost}, which the user may not set"
        ));
    }
    Ok(())
}
