//! Signals that end the program, and those that do not.

use super::harness::{Home, Program};

/// Signals and their numbers: on any system, and others that Linux defines (signal(7)); 64 is the last real-time
/// signal.
const ENDING: [(&str, u32); 9] = [
    ("TERM", 15),
    ("INT", 2),
    ("HUP", 1),
    ("QUIT", 3),
    ("USR1", 10),
    ("USR2", 12),
    ("ALRM", 14),
    ("VTALRM", 26),
    ("PROF", 27),
];
const LIMITS: [(&str, u32); 6] = [
    ("XCPU", 24),
    ("XFSZ", 25),
    ("IO", 29),
    ("PWR", 30),
    ("STKFLT", 16),
    ("64", 64),
];

fn end_by(signals: &[(&str, u32)]) {
    let home = Home::new();
    for (signal, number) in signals {
        let mut program = Program::start(&home, &["fig06"]);
        program.wait_for("solved");
        program.signal(signal);
        assert_eq!(program.end(), 128 + number, "SIG{signal}");
    }
}

/// The terminal is restored after a signal, and the exit code names it.
#[test]
fn signals_give_the_terminal_back() {
    end_by(&ENDING);
}

/// The same with signals of the system itself.
#[cfg(target_os = "linux")]
#[test]
fn signals_of_the_system_give_the_terminal_back() {
    end_by(&LIMITS);
}

/// A signal that the parent process ignores is ignored.
#[cfg(target_os = "linux")]
#[test]
fn ignored_signals_stay_ignored() {
    let home = Home::new();
    let mut program = Program::script(&home, "trap '' USR1; exec \"$BEAMTUNE\" fig06");
    program.wait_for("solved");
    program.signal("USR1");
    program.settle();
    program.press("q");
    assert_eq!(program.end(), 0);
}
