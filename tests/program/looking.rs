//! Drawings of the structure and of the cross-section.

use super::harness::{Home, Program};

#[test]
fn the_drawings_come_and_go() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig05a"]);
    program.wait_for("modes,");
    program.press("B");
    program.wait_for("─ Structure ─");
    program.wait_for("3.2 m, 3 subsystems");
    program.press("B");
    program.wait_for("─ Section at S1 ─");
    program.wait_for("z_c 61.9 mm");
    program.resize((120, 40));
    program.wait_for("mounts y ±130 mm, z -55 mm");
    program.press("B");
    program.wait("no drawing", |screen| !screen.contains("Section at"));
    program.press("q");
    assert_eq!(program.end(), 0);
}
