//! The panic hook: restores the terminal, reports the panic in one line, and writes the backtrace to the log.

use std::backtrace::Backtrace;
use std::io::{self, Write as _};
use std::panic::PanicHookInfo;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::thread::{self, ThreadId};

use super::restore;
use crate::escape::{escape, shown_path};
use crate::tui::user::log;

/// The user-interface thread; its panic ends the program.
static UI_THREAD: OnceLock<ThreadId> = OnceLock::new();

/// The log file for panic reports.
static LOG_FILE: OnceLock<PathBuf> = OnceLock::new();

/// Sets the log file for panic reports of all threads; later calls have no effect.
pub fn set_panic_sink(log_file: Option<PathBuf>) {
    if let Some(file) = log_file {
        LOG_FILE.get_or_init(|| file);
    }
}

/// Installs the hook. A panic of this thread restores the terminal before the report. A panic of another thread becomes
/// the error of its answer and must not write to the screen.
pub(super) fn install_hook() {
    if UI_THREAD.set(thread::current().id()).is_ok() {
        std::panic::set_hook(Box::new(report));
    }
}

fn report(panic: &PanicHookInfo<'_>) {
    let description = describe(panic);
    let log_file = LOG_FILE.get();
    if UI_THREAD.get() == Some(&thread::current().id()) {
        restore();
        // Standard error may be lost with the terminal.
        let _ = writeln!(
            io::stderr(),
            "{}",
            line(&description, log_file.map(PathBuf::as_path))
        );
    }
    if let Some(file) = log_file {
        let backtrace = Backtrace::force_capture();
        log::append(file, &format!("{description}\n{backtrace}"));
    }
}

/// Message and location of a panic, in one line.
fn describe(panic: &PanicHookInfo<'_>) -> String {
    let payload = panic.payload();
    let message = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("without a message");
    let message = message.split_whitespace().collect::<Vec<_>>().join(" ");
    let location = panic.location().map_or_else(
        || "an unknown location".to_owned(),
        |at| format!("{}:{}", at.file(), at.line()),
    );
    format!("internal error at {location}: {message}")
}

fn line(description: &str, log_file: Option<&Path>) -> String {
    let description = escape(description);
    match log_file {
        Some(file) => format!("beamtune: {description}; report in {}", shown_path(file)),
        None => format!("beamtune: {description}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_is_one_line() {
        let description = "internal error at src/x.rs:1: why";
        assert_eq!(line(description, None), format!("beamtune: {description}"));
        assert_eq!(
            line(description, Some(Path::new("/a/b.log"))),
            format!("beamtune: {description}; report in /a/b.log")
        );
    }
}
