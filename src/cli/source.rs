//! The MODEL argument: a file, a preset or standard input, with the changes of `--set`.

use std::ffi::OsStr;
use std::fs::File;
use std::path::{Path, PathBuf};

use super::Failure;
use crate::escape::shown_path;
use crate::files::{self, Opened, Source};
use crate::model::{Checked, Fault, Model, edit, path};
use crate::presets::{self, Preset};

/// The preset with a name.
pub(super) fn preset(name: &str) -> Result<&'static Preset, Failure> {
    presets::find(name).ok_or_else(|| {
        let names: Vec<&str> = presets::ALL.iter().map(|preset| preset.name).collect();
        Failure::input(format!(
            "no preset is named `{name}`; there are {}",
            names.join(", ")
        ))
    })
}

/// The name of a MODEL argument in messages.
pub(super) fn label(argument: &OsStr) -> String {
    if argument == "-" {
        "standard input".to_owned()
    } else {
        shown_path(Path::new(argument))
    }
}

/// Reads and checks a model, and changes it by each `PATH=VALUE`.
pub(super) fn open(argument: &OsStr, sets: &[String]) -> Result<Opened, Failure> {
    let label = label(argument);
    let (source, text) = text_of(argument, &label)?;
    let mut opened =
        Opened::read(text, source).map_err(|faults| Failure::faults(&label, &faults))?;
    if sets.is_empty() {
        return Ok(opened);
    }
    let mut model = opened.model.into_inner();
    for set in sets {
        change(&mut model, set)?;
    }
    opened.model = Checked::new(model).map_err(|faults| Failure::faults("--set", &faults))?;
    Ok(opened)
}

fn text_of(argument: &OsStr, label: &str) -> Result<(Source, String), Failure> {
    let unread = |error| Failure::input(format!("{label}: cannot be read: {error}"));
    if argument == "-" {
        let text = files::text_of(std::io::stdin().lock()).map_err(unread)?;
        return Ok((Source::Stdin, text));
    }
    if Path::new(argument).exists() {
        let path = PathBuf::from(argument);
        let is_file = path.is_file();
        let text = if is_file {
            files::load(&path)
        } else {
            // Wait for a named pipe, such as `<(..)`; Ctrl-C cancels.
            File::open(&path).and_then(files::text_of)
        }
        .map_err(unread)?;
        // The program cannot save to a pipe.
        let source = if is_file {
            Source::File(path)
        } else {
            Source::Stdin
        };
        return Ok((source, text));
    }
    match argument.to_str().and_then(presets::find) {
        Some(preset) => Ok((Source::Preset(preset.name), preset.text.to_owned())),
        None => Err(Failure::input(format!(
            "no file and no preset is named `{label}`; `beamtune presets` lists the presets"
        ))),
    }
}

/// Sets one `PATH=VALUE`, unchecked: the model may be possible only after several.
fn change(model: &mut Model, set: &str) -> Result<(), Failure> {
    let (pattern, text) = set.split_once('=').ok_or_else(|| {
        Failure::input(format!(
            "--set {set}: must be PATH=VALUE, such as beam.length=3.5"
        ))
    })?;
    let fail = |message: String| Failure::input(format!("--set {set}: {message}"));
    let fault = |fault: Fault| fail(fault.to_string());
    for id in path::find(model, pattern.trim()).map_err(fault)? {
        let parameter = path::described(model, id).map_err(fault)?;
        let value = parameter.read(text.trim()).map_err(&fail)?;
        edit::put(model, id, value)
            .map_err(|message| fault(Fault::new(path::text(model, id), message)))?;
    }
    Ok(())
}
