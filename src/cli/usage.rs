//! Answers arguments that clap does not accept: help, the version, or a usage error.

use std::ffi::OsStr;
use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;

use clap::{CommandFactory as _, Parser as _};

use super::{Arguments, Failure, stdout};
use crate::escape::{escape_lines, shown_path};
use crate::model::spelling::nearest;
use crate::presets;

/// Answers arguments that clap does not accept.
pub(super) fn answer(error: &clap::Error) -> Result<ExitCode, Failure> {
    if let Some(failure) = std::env::args_os().nth(1).and_then(|word| misspelt(&word)) {
        return Err(failure);
    }
    // Parse again with escaped arguments, for the same message without terminal control sequences.
    let escaped = std::env::args_os().map(|argument| shown_path(Path::new(&argument)));
    match Arguments::try_parse_from(escaped) {
        Err(shown) if shown.use_stderr() => {
            // If standard error is closed, the message is lost.
            let _ = shown.print();
            Ok(ExitCode::from(2))
        }
        Err(help) => {
            stdout::must_be_open()?;
            stdout::accept(help.print().and_then(|()| std::io::stdout().flush()))?;
            Ok(ExitCode::SUCCESS)
        }
        // Invalid UTF-8 becomes valid by escaping.
        Ok(_) => {
            let text = escape_lines(error.to_string().trim_end());
            let _ = writeln!(std::io::stderr(), "{text}");
            Ok(ExitCode::from(2))
        }
    }
}

/// The failure of a first word that is neither a file nor a preset, and near the name of a command.
pub(super) fn misspelt(word: &OsStr) -> Option<Failure> {
    let text = word.to_str().filter(|text| !text.starts_with('-'))?;
    if Path::new(word).exists() || presets::find(text).is_some() {
        return None;
    }
    let arguments = Arguments::command();
    let commands = arguments.get_subcommands().map(clap::Command::get_name);
    let near = nearest(text, commands).filter(|near| *near != text)?;
    Some(Failure::input(format!(
        "no command, file or preset is named `{text}`; did you mean `beamtune {near}`?"
    )))
}
