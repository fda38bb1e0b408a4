//! CSV cells, and where a table goes: standard output, or a file that is whole or not there.

use std::io::{BufWriter, Write};
use std::path::Path;

use super::{Failure, allow_broken_pipe};
use crate::model::save_with;

/// The shortest text that reads back to the same number; `nan` where there is no finite answer.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else {
        "nan".into()
    }
}

/// A text as a CSV cell (RFC 4180).
pub(super) fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Writes a table to a file, or to standard output where none is named. A file is written beside and renamed, so that
/// a failure leaves what was there.
pub(super) fn write(
    file: Option<&Path>,
    table: impl Fn(&mut dyn Write) -> std::io::Result<()>,
) -> Result<(), Failure> {
    let Some(file) = file else {
        let mut out = BufWriter::new(std::io::stdout().lock());
        return allow_broken_pipe(table(&mut out).and_then(|()| out.flush()));
    };
    let written = save_with(file, |file| {
        let mut out = BufWriter::new(file);
        table(&mut out)?;
        out.flush()
    });
    written
        .map_err(|error| Failure::Other(format!("{}: cannot be written: {error}", file.display())))
}
