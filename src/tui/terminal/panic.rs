//! What a panic does: it gives the terminal back before it is reported, in one line; the rest goes to the log.

use std::backtrace::Backtrace;
use std::io::{self, Write as _};
use std::panic::PanicHookInfo;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::thread::{self, ThreadId};

use super::give_back;
use crate::escape::{escape, shown_path};
use crate::tui::user::log;

/// The thread whose panic ends the program.
static OWNER: OnceLock<ThreadId> = OnceLock::new();

/// The log file that takes the report of a panic.
static SINK: OnceLock<PathBuf> = OnceLock::new();

/// Panics of any thread are reported in this log file from now on; the first file that is told remains.
pub fn set_panic_sink(log_file: Option<PathBuf>) {
    if let Some(file) = log_file {
        SINK.get_or_init(|| file);
    }
}

/// A panic of this thread gives the terminal back before it is reported. One of another thread comes as an
/// answer's error and must not write over the screen.
pub(super) fn install_hook() {
    if OWNER.set(thread::current().id()).is_ok() {
        std::panic::set_hook(Box::new(report));
    }
}

fn report(panic: &PanicHookInfo<'_>) {
    let fault = fault(panic);
    let sink = SINK.get();
    if OWNER.get() == Some(&thread::current().id()) {
        give_back();
        // Standard error may be gone with the terminal.
        let _ = writeln!(io::stderr(), "{}", line(&fault, sink.map(PathBuf::as_path)));
    }
    if let Some(file) = sink {
        let way = Backtrace::force_capture();
        log::append(file, &format!("{fault}\n{way}"));
    }
}

/// What went wrong and where, in one line.
fn fault(panic: &PanicHookInfo<'_>) -> String {
    let payload = panic.payload();
    let message = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("without a message");
    let message = message.split_whitespace().collect::<Vec<_>>().join(" ");
    let place = panic.location().map_or_else(
        || "an unknown place".to_owned(),
        |at| format!("{}:{}", at.file(), at.line()),
    );
    format!("a fault of its own at {place}: {message}")
}

fn line(fault: &str, log_file: Option<&Path>) -> String {
    let fault = escape(fault);
    match log_file {
        Some(file) => format!("beamtune: {fault}; report in {}", shown_path(file)),
        None => format!("beamtune: {fault}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_is_one_line() {
        let fault = "a fault of its own at src/x.rs:1: why";
        assert_eq!(line(fault, None), format!("beamtune: {fault}"));
        assert_eq!(
            line(fault, Some(Path::new("/a/b.log"))),
            format!("beamtune: {fault}; report in /a/b.log")
        );
    }
}
