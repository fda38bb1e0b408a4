//! Signals that end a command.

use std::fs;
use std::io;
use std::thread;

use signal_hook::consts::{
    SIGABRT, SIGALRM, SIGBUS, SIGHUP, SIGINT, SIGPROF, SIGQUIT, SIGSYS, SIGTERM, SIGTRAP, SIGUSR1,
    SIGUSR2, SIGVTALRM, SIGXCPU, SIGXFSZ,
};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

use crate::model;

/// Those by which a person or the system asks a program to end.
pub(super) const ASKING: [i32; 4] = [SIGHUP, SIGINT, SIGQUIT, SIGTERM];

/// Those that end a program otherwise, and can be caught.
const OTHERS: [i32; 11] = [
    SIGABRT, SIGALRM, SIGBUS, SIGPROF, SIGSYS, SIGTRAP, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU,
    SIGXFSZ,
];

/// Removes temporary files when a signal ends the program, which it does as it would otherwise.
///
/// # Errors
/// Signals cannot be caught.
pub(super) fn clean_up() -> io::Result<()> {
    clean_up_after(&[ASKING.as_slice(), &OTHERS].concat())
}

/// The same at the signals that do not ask: the caller has the others.
///
/// # Errors
/// Signals cannot be caught.
pub(super) fn clean_up_after_others() -> io::Result<()> {
    clean_up_after(&OTHERS)
}

fn clean_up_after(signals: &[i32]) -> io::Result<()> {
    let mut signals = Signals::new(not_ignored(signals))?;
    thread::spawn(move || {
        for signal in signals.forever() {
            model::remove_temporaries();
            // It does not return from a signal that ends the program.
            let _ = emulate_default_handler(signal);
        }
    });
    Ok(())
}

/// Those of some signals that are to be heard: what the program was started to ignore, as by `nohup`, is ignored.
pub(super) fn not_ignored(signals: &[i32]) -> Vec<i32> {
    let status = fs::read_to_string("/proc/self/status");
    // Where the system does not say, none is ignored.
    let ignored = status.ok().as_deref().and_then(ignored).unwrap_or(0);
    let heard = signals.iter().copied();
    heard
        .filter(|signal| (ignored >> (signal - 1)) & 1 == 0)
        .collect()
}

/// A bit for each signal that is ignored, the lowest for signal 1 (Linux, proc(5), /proc/PID/status).
fn ignored(status: &str) -> Option<u64> {
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))?;
    u64::from_str_radix(line.trim(), 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `nohup cat /proc/self/status` says `SigIgn: 0000000000000001`; SIGHUP is signal 1.
    #[test]
    fn what_is_ignored_is_read_by_its_bit() {
        let status =
            "Name:\tcat\nSigBlk:\t0000000000000000\nSigIgn:\t0000000000001001\nSigCgt:\t0\n";
        assert_eq!(ignored(status), Some(0x1001));
        assert_eq!(ignored("Name:\tcat\n"), None);
        assert_eq!(SIGHUP, 1);
    }
}
