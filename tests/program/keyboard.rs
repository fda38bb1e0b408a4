//! Incomplete key sequences: unfinished ones, sequences typed key by key, and sequences in pieces.

use std::time::Duration;

use super::harness::{ESCAPE, Home, Program};

/// Beginnings of sequences that never end.
const UNFINISHED: [&[u8]; 9] = [
    b"\x1b[<",
    b"\x1b[<0;5",
    b"\x1b[200~abc",
    b"\x1b[?",
    b"\x1bO",
    b"\x1b\x1b",
    b"\x1b[M",
    b"\x1b]11;",
    b"\xe2\x82",
];

/// The designer on a model that differs from its file, so that it asks before it quits.
fn changed(home: &Home) -> Program {
    let mut program = Program::start(home, &["fig08", "--set", "subsystems.S1.mass=200"]);
    program.wait_for("modes,");
    program
}

/// Closes the confirmation.
fn stay(program: &mut Program) {
    program.press(ESCAPE);
    program.wait("the question to go", |screen| !screen.contains("discard"));
}

fn leave(mut program: Program) {
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
}

/// Ctrl-C works inside of each, in the same read and in the next one.
#[test]
fn control_c_answers_inside_of_an_unfinished_sequence() {
    let home = Home::new();
    let mut program = changed(&home);
    for bytes in UNFINISHED {
        program.send(&[bytes, b"\x03"].concat());
        program.wait_for("discard");
        stay(&mut program);
        program.send(bytes);
        program.press("\u{3}");
        program.wait_for("discard");
        stay(&mut program);
    }
    leave(program);
}

/// And so does every other key once the sequence is not continued.
#[test]
fn keys_answer_after_an_unfinished_sequence() {
    let home = Home::new();
    let mut program = changed(&home);
    for bytes in UNFINISHED {
        program.send(bytes);
        program.press_until("q", "discard");
        stay(&mut program);
    }
    leave(program);
}

/// Esc, `[` and `<` lower the selected number by 10 %, whether a person types them or tmux sends them together.
#[test]
fn keys_that_could_begin_a_sequence_do_what_they_do() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    program.press("\t");
    program.settle();
    for pause in [0, 100, 200, 300] {
        program.press_slowly(b"\x1b[<", Duration::from_millis(pause));
        program.wait_for("\u{b7} changed");
        program.press("u");
        program.wait("the change to go", |screen| {
            !screen.contains("\u{b7} changed")
        });
    }
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// A function key that arrives byte by byte over a slow connection is that key.
#[test]
fn a_key_that_comes_in_pieces_is_one() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    // A busy machine may lengthen one pause, but not all of them.
    let helps = |_| {
        program.press_slowly(b"\x1bOP", Duration::from_millis(10));
        program.settle();
        program.text().contains("Keys")
    };
    assert!((0..10).any(helps), "no help in\n{}", program.text());
    program.press("qq");
    assert_eq!(program.end(), 0);
}
