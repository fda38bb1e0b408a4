//! Few bytes: unchanged cells are not sent again over a slow connection.

use beamtune::model::Unit;

use super::harness::{Home, LARGE, Program};

/// Whether everything is solved and no more output is pending.
fn complete(screen: &str) -> bool {
    screen.contains("modes, solved") && !screen.contains("computing")
}

/// Nudges without delay, which are counted.
const NUDGES: usize = 20;

/// A nudge redraws what changes: less than a third of the screen.
#[test]
fn a_nudge_costs_less_than_a_third_of_a_painting() {
    let home = Home::new();
    let mut program = Program::sized(&home, &["fig05a"], LARGE);
    program.wait("everything", complete);
    program.press("\t");
    program.wait_for("length of the beam");
    let painting = program.settle().len();
    let mut length = 3.2;
    let mut nudges = Vec::new();
    for _ in 0..NUDGES {
        let before = program.pending();
        program.press(".");
        // The value as a nudge stores it, with six digits.
        length = format!("{:.5e}", length * 1.001).parse().unwrap();
        let shown = Unit::METRE.format(length);
        program.wait("the nudge, solved", |screen| {
            screen.contains(&shown) && complete(screen)
        });
        nudges.push(program.raw.len() - before);
    }
    nudges.sort_unstable();
    // On a busy machine some answers come late, and a picture is drawn without them.
    let nudge = nudges[NUDGES / 4];
    assert!(
        nudge < painting / 3,
        "{nudges:?} bytes a nudge, {painting} a painting"
    );
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
}

/// Once everything is shown, no more bytes are written, however long the program waits.
#[test]
fn an_idle_program_writes_nothing() {
    let home = Home::new();
    let mut program = Program::sized(&home, &["fig05a"], LARGE);
    program.wait("everything", complete);
    program.settle();
    let before = program.raw.len();
    // Time passes: another program solves the same beam, several times.
    for _ in 0..3 {
        let mut other = Program::start(&home, &["fig05a"]);
        other.wait("everything", |screen| screen.contains("modes,"));
        other.press("q");
        assert_eq!(other.end(), 0);
    }
    assert_eq!(
        program.pending(),
        before,
        "bytes were written by an idle program"
    );
    // The program was still alive.
    program.settle();
    program.press("q");
    assert_eq!(program.end(), 0);
}
