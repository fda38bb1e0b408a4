//! Signals that end the program.

use super::harness::{Home, Program};

/// The signals and their numbers.
const ENDING: [(&str, u32); 3] = [("TERM", 15), ("INT", 2), ("HUP", 1)];

/// The terminal is given back after a signal, and the exit code says which.
#[test]
fn signals_give_the_terminal_back() {
    for (signal, number) in ENDING {
        let home = Home::new();
        let mut program = Program::start(&home, &["fig06"]);
        program.wait_for("solved");
        program.signal(signal);
        assert_eq!(program.end(), 128 + number, "SIG{signal}");
    }
}
