//! Unsaved changes survive the program, however it ends.

use std::fs;
use std::path::Path;

use super::harness::{Home, Program};

/// The ways in which a program ends, with their exit codes.
const ENDS: [(&str, u32); 6] = [
    ("TERM", 143),
    ("INT", 130),
    ("HUP", 129),
    ("QUIT", 131),
    ("USR1", 138),
    ("XCPU", 152),
];

/// The length of the beam in a file, m.
fn length(path: &Path) -> f64 {
    let text = fs::read_to_string(path).unwrap();
    beamtune::model::read(&text)
        .unwrap()
        .into_inner()
        .beam
        .length
}

/// A designer with an unsaved edit: the beam is a tenth longer.
fn edited(home: &Home) -> Program {
    let mut program = Program::start(home, &["beam.toml"]);
    program.wait_for("solved");
    program.press("\t");
    program.wait_for("length of the beam");
    program.press(">");
    program.wait("the new length, solved", |screen| {
        screen.contains("3.2 -> 3.52 m") && screen.contains("changed") && screen.contains("modes")
    });
    program
}

/// The next start offers the edits; they are recovered, undone, redone and saved, and nothing is left to offer.
fn recovers(home: &Home, text: &str) {
    let mut program = Program::start(home, &["beam.toml"]);
    program.wait("the offer", |screen| {
        screen.contains("Unsaved changes") && screen.contains("beam.toml")
    });
    program.press("\r");
    program.wait("the edits", |screen| {
        screen.contains("3.52 m") && screen.contains("changed")
    });
    program.press("u");
    program.wait("the file's length", |screen| {
        screen.contains("3.2 m") && !screen.contains("3.52 m") && !screen.contains("· changed")
    });
    program.press("U");
    program.wait_for("3.52 m");
    assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
    program.press("s");
    program.wait("the save", |screen| {
        screen.contains(" saved ") && screen.contains("beam.toml")
    });
    program.press("q");
    assert_eq!(program.end(), 0);
    assert_eq!(length(&home.file("beam.toml")), 3.52);
    assert_eq!(home.recovery(), [""; 0].map(std::path::PathBuf::from));
    assert_eq!(home.names(), ["beam.toml"]);
}

#[test]
fn edits_survive_signals() {
    for (signal, code) in ENDS {
        let home = Home::new();
        let text = home.preset("fig08", "beam.toml");
        let program = edited(&home);
        program.signal(signal);
        let (ended, said) = program.last_words();
        assert_eq!(ended, code, "SIG{signal}");
        assert_eq!(
            said.matches("unsaved changes are in").count(),
            1,
            "SIG{signal}: {said}"
        );
        assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
        let kept = home.recovery();
        assert_eq!(kept.len(), 1, "SIG{signal}");
        assert_eq!(length(&kept[0]), 3.52);
        recovers(&home, text);
    }
}

/// A killed program cannot act: the changes were stored before.
#[test]
fn edits_survive_being_killed() {
    let home = Home::new();
    let text = home.preset("fig08", "beam.toml");
    let mut program = edited(&home);
    program.until("recovery file", || !home.recovery().is_empty());
    program.signal("KILL");
    program.exit();
    let kept = home.recovery();
    assert_eq!(kept.len(), 1);
    assert_eq!(length(&kept[0]), 3.52);
    recovers(&home, text);
}

/// The connection drops: nothing can be shown, but the edits are stored.
#[test]
fn edits_survive_a_line_that_drops() {
    let home = Home::new();
    let text = home.preset("fig08", "beam.toml");
    let (code, _) = edited(&home).hang_up().end();
    assert_eq!(code, 129);
    recovers(&home, text);
}

/// Changes that the user postpones are offered again; discarded ones are not.
#[test]
fn an_offer_can_wait_or_be_discarded() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let program = edited(&home);
    program.signal("TERM");
    assert_eq!(program.end(), 143);
    let mut program = Program::start(&home, &["fig06"]);
    program.wait_for("Unsaved changes");
    program.press("\u{1b}");
    program.wait("the box to go", |screen| {
        !screen.contains("A designer ended")
    });
    program.press("q");
    assert_eq!(program.end(), 0);
    assert_eq!(home.recovery().len(), 1);
    let mut program = Program::start(&home, &["fig06"]);
    program.wait_for("Unsaved changes");
    program.press("x");
    program.wait_for("discarded");
    program.press("q");
    assert_eq!(program.end(), 0);
    assert!(home.recovery().is_empty());
    let mut program = Program::start(&home, &["fig06"]);
    program.wait_for("modes,");
    assert!(!program.text().contains("Unsaved changes"));
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// Changes of a running program are not offered to another.
#[test]
fn what_a_running_program_holds_is_not_offered() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let mut program = edited(&home);
    program.until("recovery file", || !home.recovery().is_empty());
    let mut other = Program::start(&home, &["beam.toml"]);
    other.wait_for("modes,");
    assert!(
        !other.text().contains("Unsaved changes"),
        "{}",
        other.text()
    );
    other.press("q");
    assert_eq!(other.end(), 0);
    assert_eq!(home.recovery().len(), 1);
    program.press("u");
    program.until("end of the recovery file", || home.recovery().is_empty());
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// A normal exit leaves no recovery file.
#[test]
fn what_is_discarded_on_purpose_is_not_kept() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let mut program = edited(&home);
    program.until("recovery file", || !home.recovery().is_empty());
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
    assert!(home.recovery().is_empty());
}

/// Opening a file offers its own changes, and none of another file.
#[test]
fn the_changes_of_another_file_are_not_offered() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    home.preset("fig06", "other.toml");
    let program = edited(&home);
    program.signal("TERM");
    assert_eq!(program.end(), 143);
    let mut program = Program::start(&home, &["other.toml"]);
    program.wait_for("modes,");
    assert!(
        !program.text().contains("Unsaved changes"),
        "{}",
        program.text()
    );
    program.press("q");
    assert_eq!(program.end(), 0);
    assert_eq!(home.recovery().len(), 1);
    let mut program = Program::start(&home, &["beam.toml"]);
    program.wait_for("Unsaved changes");
    program.signal("TERM");
    program.end();
}
