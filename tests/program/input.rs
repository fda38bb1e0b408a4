//! Extreme input: many sizes and very long pastes.

use super::dice::Dice;
use super::harness::{ESCAPE, Home, Program, SMALL, picture};

/// A megabyte.
const LARGE_PASTE: usize = 1_000_000;

/// The selected row: the first line of the tree with reversed letters.
fn selected(program: &Program) -> String {
    let screen = program.screen();
    let (rows, columns) = screen.size();
    let reversed = |row| {
        let cells = (0..columns.get()).filter_map(|column| screen.cell(row, column));
        let inverse = cells.filter(|cell| cell.inverse());
        inverse
            .map(|cell| cell.contents().to_owned())
            .collect::<String>()
    };
    (0..rows.get())
        .map(reversed)
        .find(|text| !text.is_empty())
        .unwrap_or_default()
}

/// Five hundred sizes in a row from 1x1 to 300x100: each is drawn, and the selection stays.
#[test]
fn five_hundred_sizes_in_a_row_keep_the_selection() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig05a"]);
    program.wait_for("modes,");
    program.press("\t\t\t");
    program.settle();
    let before = selected(&program);
    assert!(
        !before.trim().is_empty(),
        "nothing is selected in\n{}",
        program.text()
    );
    let picture = program.picture();
    let mut dice = Dice(5);
    for turn in 0..500_u16 {
        // Often the extremes; never the same size twice, which would not be a change.
        let size = match turn % 10 {
            0 => (1, 1),
            1 => (300, 100),
            2 => (59, 17),
            3 => (60, 18),
            _ => (2 + dice.roll(297) as u16, 2 + dice.roll(97) as u16),
        };
        program.resize(size);
        // Some are superseded by the next, as when a window is resized by its corner.
        if turn % 4 < 2 {
            program.painted();
        }
    }
    program.resize(SMALL);
    program.painted();
    program.settle();
    assert_eq!(selected(&program), before);
    assert_eq!(program.picture(), picture);
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// A megabyte in one piece without a prompt: it does not act as commands, and changes nothing.
#[test]
fn a_large_paste_outside_of_a_box_does_nothing() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    program.settle();
    let before = program.picture();
    // As keys, these would add, delete and quit.
    let text = "aDx+q\n".repeat(LARGE_PASTE / 6);
    program.press(&format!("\u{1b}[200~{text}\u{1b}[201~"));
    program.settle();
    assert_eq!(program.picture(), before);
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// A megabyte in one piece into a prompt: it is refused as invalid, and the dialog can be closed.
#[test]
fn a_large_paste_into_a_box_is_taken_or_refused_at_once() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    program.press("\t");
    program.settle();
    let before = program.picture();
    program.press("\r");
    program.wait("the box", |screen| picture(screen) != before);
    let text = "9".repeat(LARGE_PASTE);
    program.press(&format!("\u{1b}[200~{text}\u{1b}[201~"));
    program.settle();
    program.press("\r");
    program.settle();
    program.press(ESCAPE);
    program.settle();
    assert!(!program.text().contains("changed"), "{}", program.text());
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// A megabyte from a terminal without bracketed paste: it arrives as keys, here into the open dialog.
#[test]
fn a_large_paste_as_keys_is_taken_too() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    program.press("\t\r");
    program.send(&b"7".repeat(LARGE_PASTE));
    program.settle();
    program.press(ESCAPE);
    program.settle();
    // And without a dialog: up and down the tree.
    program.send(&b"jk".repeat(LARGE_PASTE / 2));
    program.settle();
    assert!(!program.text().contains("changed"), "{}", program.text());
    program.press("q");
    assert_eq!(program.end(), 0);
}
