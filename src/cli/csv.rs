//! Writes a table to standard output, or atomically to a file.

use std::io::{BufWriter, Write};
use std::path::Path;

use super::{Failure, signals, stdout, warn_of_loss};
use crate::escape::shown_path;
use crate::files::save_with;
pub(super) use crate::table::{cell, number};

/// Writes a table to a file, or to standard output if none is named. A temporary file is written and renamed, so that
/// an error preserves the existing file.
pub(super) fn write(
    file: Option<&Path>,
    table: impl Fn(&mut dyn Write) -> std::io::Result<()>,
) -> Result<(), Failure> {
    let Some(file) = file else {
        return stdout::write(table);
    };
    signals::clean_up()?;
    let written = warn_of_loss(file).and_then(|()| {
        save_with(file, |file| {
            let mut out = BufWriter::new(file);
            table(&mut out)?;
            out.flush()
        })
    });
    written.map_err(|error| unwritten(file, &error))
}

/// The failure to write a file.
pub(super) fn unwritten(file: &Path, error: &std::io::Error) -> Failure {
    Failure::Other(format!("{}: cannot be written: {error}", shown_path(file)))
}
