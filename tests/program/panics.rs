//! Injected faults: with `BEAMTUNE_FAULT` in its environment, a debug build panics at that place once the model's title
//! is `panic now`.

#![cfg(debug_assertions)]

use std::fs;

use super::harness::{Home, Program};

/// Sets the model's title, by the first row of the tree.
fn retitle(program: &mut Program, title: &str) {
    program.press("g\r");
    program.wait_for("accept");
    program.press(&format!("\u{15}{title}\r"));
}

/// A panic in the worker is reported; the designer continues, and the next edit is solved again.
#[test]
fn a_fault_of_the_worker_is_reported_and_the_designer_continues() {
    let home = Home::new();
    let mut program = Program::with(&home, &["fig08"], &[("BEAMTUNE_FAULT", "worker")]);
    program.wait_for("modes,");
    retitle(&mut program, "panic now");
    program.wait_for("not solved: ");
    // The screen is intact: nothing was written over it.
    let mut before = program.picture();
    program.settle();
    let mut after = program.picture();
    // The last line showed the edit, until the next key.
    before.pop();
    after.pop();
    assert_eq!(after, before);
    retitle(&mut program, "calm");
    program.wait("curves of the next edit", |screen| {
        screen.contains("calm") && screen.contains("solved") && !screen.contains("not solved")
    });
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
    let log = fs::read_to_string(home.state("beamtune.log")).unwrap();
    assert!(log.contains("injected fault: worker"), "{log}");
}

/// A panic while drawing ends the program: the terminal is restored, a line gives the reason, and unsaved changes are
/// in the recovery file.
#[test]
fn a_fault_in_drawing_gives_the_terminal_back_and_loses_nothing() {
    let home = Home::new();
    let mut program = Program::with(&home, &["fig08"], &[("BEAMTUNE_FAULT", "drawing")]);
    program.wait_for("modes,");
    retitle(&mut program, "panic now");
    let (code, said) = program.last_words();
    assert_eq!(code, 101);
    // Lines longer than the terminal continue in the next row.
    let said = said.replace('\n', "");
    assert_eq!(said.matches("injected fault: drawing").count(), 1, "{said}");
    assert_eq!(said.matches("unsaved changes are in").count(), 1, "{said}");
    assert!(
        !said.contains("stack backtrace") && !said.contains("RUST_BACKTRACE"),
        "{said}"
    );
    let log = fs::read_to_string(home.state("beamtune.log")).unwrap();
    assert!(log.contains("injected fault: drawing"), "{log}");
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("Unsaved changes");
    program.press("\r");
    program.wait_for("panic now");
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
    assert!(home.recovery().is_empty());
}
