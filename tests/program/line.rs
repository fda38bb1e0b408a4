//! A dropped connection: the terminal is closed, and the program cannot ask.

use std::fs;
use std::time::Duration;

use super::harness::{Home, Program};

/// The goal is one second; here the machine may be busy.
const SOON: Duration = Duration::from_secs(10);

/// A program that spins until it ends uses a full second of processor time. An end below this bound shows that it does
/// not spin.
const LITTLE: f64 = 1.0;

#[test]
fn a_line_that_drops_ends_the_program() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig06"]);
    program.wait_for("solved");
    let (code, after) = program.hang_up().end();
    assert_eq!(code, 128 + 1);
    assert!(after < SOON, "ended only after {after:?}");
}

/// As under `nohup`: the signal is ignored from the start.
#[test]
fn a_line_that_drops_ends_it_also_where_hang_ups_are_ignored() {
    let home = Home::new();
    let mut program = Program::script(&home, "trap '' HUP; exec \"$BEAMTUNE\" fig06");
    program.wait_for("solved");
    let (code, after) = program.hang_up().end();
    assert_eq!(code, 128 + 1);
    assert!(after < SOON, "ended only after {after:?}");
}

/// No signal arrives, because another process leads the session; only the terminal itself shows the loss.
#[cfg(target_os = "linux")]
#[test]
fn a_line_that_drops_unheard_ends_it_without_spinning() {
    let home = Home::new();
    let script = "trap '' HUP; sh -c 'echo $$ > id; exec \"$BEAMTUNE\" fig06'; echo $? > code; times > times";
    let mut program = Program::script(&home, script);
    program.wait("all that is to be solved", |screen| {
        screen.contains("solved") && screen.contains("modes,")
    });
    let read = |name: &str| fs::read_to_string(home.file(name)).unwrap();
    let before = used(read("id").trim());
    let (_, after) = program.hang_up().end();
    assert_eq!(read("code").trim(), "129");
    assert!(after < SOON, "ended only after {after:?}");
    let used = all_used(&read("times")) - before;
    assert!(
        used < LITTLE,
        "used {used} s of a processor after the terminal had gone"
    );
}

/// Seconds of processor time that a process has used.
fn used(id: &str) -> f64 {
    let stat = fs::read_to_string(format!("/proc/{id}/stat")).unwrap();
    // The name, which may contain anything, is in parentheses; after it, the state is field 3, the times are fields 14
    // and 15.
    let (_, fields) = stat.rsplit_once(')').unwrap();
    let times = fields.split_whitespace().skip(14 - 3).take(2);
    // Ticks of a hundredth of a second.
    times
        .map(|ticks| ticks.parse::<f64>().unwrap() / 100.0)
        .sum()
}

/// Seconds of processor time that the children of a shell have used, from the second line of its `times`.
fn all_used(times: &str) -> f64 {
    let of_children = times.lines().nth(1).unwrap().split_whitespace();
    let seconds = |time: &str| {
        let (minutes, seconds) = time.trim_end_matches('s').split_once('m').unwrap();
        minutes.parse::<f64>().unwrap() * 60.0 + seconds.parse::<f64>().unwrap()
    };
    of_children.map(seconds).sum()
}

/// The resolution of the shell's clock, from which the bound above is derived.
#[test]
fn times_of_a_shell_are_read() {
    assert!((all_used("0m0.00s 0m0.00s\n0m1.25s 1m0.50s\n") - 61.75).abs() < 1e-9);
}
