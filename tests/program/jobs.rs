//! Job control: stopped and continued, as by shells.

use super::harness::{Home, Program, picture};

/// A program that another one stops and continues repaints its screen, without a key.
#[test]
fn a_stopped_program_paints_again_when_it_goes_on() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    program.settle();
    program.signal("STOP");
    program.signal("CONT");
    program.repainted();
    assert!(!program.is_plain(), "the terminal is not raw");
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// Ctrl-Z returns to the shell, with the terminal restored; `fg` brings back the designer with its whole screen.
#[test]
fn a_shell_suspends_and_resumes_it() {
    let home = Home::new();
    let mut shell = Program::shell(&home);
    shell.wait_for("prompt> ");
    shell.press("stty -g > before; \"$BEAMTUNE\" fig08; echo left with $?\r");
    shell.wait_for("modes,");
    shell.press("\t\t");
    shell.settle();
    let before = shell.picture();
    for _ in 0..2 {
        shell.press("\u{1a}");
        shell.wait_for("Stopped");
        assert!(!shell.screen().alternate_screen() && !shell.screen().hide_cursor());
        assert!(!shell.screen().bracketed_paste());
        shell.press("stty -g > after; echo mar''ked\r");
        shell.wait_for("marked");
        let read = |name| std::fs::read_to_string(home.file(name)).unwrap();
        assert_eq!(read("after"), read("before"));
        shell.press("clear; fg\r");
        shell.wait("the designer", |screen| picture(screen) == before);
        assert!(shell.screen().alternate_screen() && shell.screen().hide_cursor());
    }
    // Raw mode again: keys are not echoed and work as before.
    shell.press("?");
    shell.wait_for("Keys");
    shell.press("qq");
    shell.wait("the shell", |screen| screen.contains("prompt> "));
    shell.press("exit\r");
    shell.exit();
}
