//! Signals: another size, stopping and going on, and all that end the program.

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

use super::give_back;
use crate::files;
use crate::signals::not_ignored;
use crate::tui::event::Event;

/// Those that the program always catches.
const OWN: [i32; 7] = [SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT, SIGWINCH];

/// Others that end a process which does not catch them. Those of its own faults (such as SIGSEGV) remain as they are:
/// there is no going on after them.
const ENDING: [i32; 7] = [
    SIGALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU, SIGXFSZ,
];

/// How long the program has to end after a signal; its terminal may be one that takes no more and is waited for.
const PATIENCE: Duration = Duration::from_secs(3);

/// How long the terminal has to take its last bytes.
const LAST: Duration = Duration::from_millis(100);

/// Starts the thread that forwards signals.
///
/// # Errors
/// Where signals cannot be caught.
pub(super) fn start(to: Sender<Event>) -> io::Result<()> {
    let signals = Signals::new(OWN)?;
    for signal in not_ignored(ENDING) {
        signals.add_signal(signal)?;
    }
    for signal in not_ignored(of_system()) {
        // The C library keeps the first real-time signals to itself, and refuses them.
        let _ = signals.add_signal(signal);
    }
    thread::spawn(move || forward(signals, &to));
    Ok(())
}

/// More signals that end a process on this system: input and output, power, the coprocessor's stack, real time.
#[cfg(target_os = "linux")]
fn of_system() -> impl Iterator<Item = i32> {
    use rustix::process::Signal;
    let named = [Signal::IO, Signal::POWER, Signal::STKFLT];
    named.into_iter().map(Signal::as_raw).chain(32..=64)
}

/// Other systems have no more that end a process.
#[cfg(not(target_os = "linux"))]
fn of_system() -> impl Iterator<Item = i32> {
    std::iter::empty()
}

fn forward(mut signals: Signals, to: &Sender<Event>) {
    for signal in signals.forever() {
        let event = match signal {
            SIGTSTP => Event::Suspend,
            SIGCONT => Event::Resume,
            SIGWINCH => Event::Resize,
            other => {
                thread::spawn(move || insist(other, PATIENCE));
                Event::Quit(other)
            }
        };
        if to.send(event).is_err() {
            return;
        }
    }
}

/// Ends the program as by a signal if it is still there after some time: the drawing thread hangs on its terminal.
pub(super) fn insist(signal: i32, after: Duration) {
    thread::sleep(after);
    // A terminal that takes no more would hold up this thread too; the modes are the system's.
    thread::spawn(give_back);
    thread::sleep(LAST);
    let _ = disable_raw_mode();
    files::remove_temporaries();
    std::process::exit(128 + signal);
}
