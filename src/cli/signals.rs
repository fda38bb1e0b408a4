//! Signals that end a command.

use std::io;
use std::thread;

use signal_hook::consts::{
    SIGABRT, SIGALRM, SIGBUS, SIGHUP, SIGINT, SIGPROF, SIGQUIT, SIGSYS, SIGTERM, SIGTRAP, SIGUSR1,
    SIGUSR2, SIGVTALRM, SIGXCPU, SIGXFSZ,
};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

use crate::files;
use crate::signals::not_ignored;

/// Signals by which a person or the system asks a program to end.
pub(super) const ASKING: [i32; 4] = [SIGHUP, SIGINT, SIGQUIT, SIGTERM];

/// Other signals that end a program and can be caught.
const OTHERS: [i32; 11] = [
    SIGABRT, SIGALRM, SIGBUS, SIGPROF, SIGSYS, SIGTRAP, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU,
    SIGXFSZ,
];

/// Removes temporary files when a signal ends the program; the exit status is that of the signal.
///
/// # Errors
/// Signals cannot be caught.
pub(super) fn clean_up() -> io::Result<()> {
    clean_up_after(&[ASKING.as_slice(), &OTHERS].concat())
}

/// The same for [`OTHERS`] only; the caller handles [`ASKING`].
///
/// # Errors
/// Signals cannot be caught.
pub(super) fn clean_up_after_others() -> io::Result<()> {
    clean_up_after(&OTHERS)
}

fn clean_up_after(signals: &[i32]) -> io::Result<()> {
    let mut signals = Signals::new(not_ignored(signals.iter().copied()))?;
    thread::spawn(move || {
        for signal in signals.forever() {
            files::remove_temporaries();
            // This does not return if the signal ends the program.
            let _ = emulate_default_handler(signal);
        }
    });
    Ok(())
}
