//! Signals: resize, stop and continue, and all that end the program.

use std::io;
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;

use crossterm::terminal::disable_raw_mode;
use signal_hook::consts::{
    SIGALRM, SIGCONT, SIGHUP, SIGINT, SIGPROF, SIGQUIT, SIGTERM, SIGTSTP, SIGUSR1, SIGUSR2,
    SIGVTALRM, SIGWINCH, SIGXCPU, SIGXFSZ,
};
use signal_hook::iterator::Signals;

use super::restore;
use crate::files;
use crate::signals::not_ignored;
use crate::tui::event::Event;

/// Signals that the program always handles.
const HANDLED: [i32; 7] = [SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT, SIGWINCH];

/// More signals that end a process by default. Signals of internal errors (such as SIGSEGV) keep their default action:
/// the program cannot continue after them.
const TERMINATING: [i32; 7] = [
    SIGALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU, SIGXFSZ,
];

/// Time for a normal exit after a signal; a write to a blocked terminal may take longer.
const EXIT_TIMEOUT: Duration = Duration::from_secs(3);

/// Time to write the restore sequence to the terminal.
const RESTORE_TIMEOUT: Duration = Duration::from_millis(100);

/// Starts the thread that forwards signals.
///
/// # Errors
/// Signals cannot be caught.
pub(super) fn start(to: Sender<Event>) -> io::Result<()> {
    let signals = Signals::new(HANDLED)?;
    for signal in not_ignored(TERMINATING) {
        signals.add_signal(signal)?;
    }
    for signal in not_ignored(system_specific()) {
        // The C library reserves the first real-time signals and refuses them.
        let _ = signals.add_signal(signal);
    }
    thread::spawn(move || forward(signals, &to));
    Ok(())
}

/// More signals that end a process on Linux: I/O, power, coprocessor stack, real-time.
#[cfg(target_os = "linux")]
fn system_specific() -> impl Iterator<Item = i32> {
    use rustix::process::Signal;
    let named = [Signal::IO, Signal::POWER, Signal::STKFLT];
    named.into_iter().map(Signal::as_raw).chain(32..=64)
}

/// Other systems have no more signals that end a process.
#[cfg(not(target_os = "linux"))]
fn system_specific() -> impl Iterator<Item = i32> {
    std::iter::empty()
}

fn forward(mut signals: Signals, to: &Sender<Event>) {
    for signal in signals.forever() {
        let event = match signal {
            SIGTSTP => Event::Suspend,
            SIGCONT => Event::Resume,
            SIGWINCH => Event::Resize,
            other => {
                thread::spawn(move || force_exit(other, EXIT_TIMEOUT));
                Event::Quit(other)
            }
        };
        if to.send(event).is_err() {
            return;
        }
    }
}

/// Exits as by a signal if the program still runs after some time: the drawing thread is blocked by its terminal.
pub(super) fn force_exit(signal: i32, after: Duration) {
    thread::sleep(after);
    // Writing to a blocked terminal would block this thread too; resetting the modes does not write.
    thread::spawn(restore);
    thread::sleep(RESTORE_TIMEOUT);
    let _ = disable_raw_mode();
    files::remove_temporaries();
    std::process::exit(128 + signal);
}
