//! The screen before and after, also without an alternate screen (GNU screen, mosh, `alternate-screen off` of tmux).

use super::harness::{Home, Program, SMALL};
use super::pty::parser;

/// The screen that a terminal without an alternate screen shows after all output so far.
fn plain(program: &Program) -> String {
    let written = String::from_utf8_lossy(&program.raw);
    let written = written
        .replace("\u{1b}[?1049h", "")
        .replace("\u{1b}[?1049l", "");
    let mut screen = parser(SMALL.0, SMALL.1);
    screen.process(written.as_bytes());
    screen.screen().contents()
}

#[test]
fn old_text_never_shines_through() {
    let home = Home::new();
    let mut shell = Program::shell(&home);
    shell.wait_for("prompt> ");
    let fill = |shell: &mut Program, end: u32| {
        let text = "for i in $(seq 40); do printf '\\033[41m%s ' old-shell-text; done";
        shell.press(&format!("{text}; echo en''d {end}\r"));
        shell.wait_for(&format!("end {end}"));
    };
    fill(&mut shell, 1);
    shell.press("\"$BEAMTUNE\" fig08\r");
    let shows = |shell: &mut Program| {
        shell.wait_for("modes,");
        let found = plain(shell);
        assert!(found.contains("modes,"), "{found}");
        assert!(!found.contains("old-shell"), "{found}");
        assert_eq!(found.trim_end(), shell.text().trim_end());
    };
    shows(&mut shell);
    shell.press("\u{1a}");
    shell.wait_for("Stopped");
    // The shell continues below the picture.
    let found = plain(&shell);
    let (picture, below) = found.split_at(found.find("Stopped").unwrap());
    // The first rows scroll up for the shell's output.
    assert!(picture.contains("Supports"), "{found}");
    assert!(!below.contains("Supports"), "{found}");
    fill(&mut shell, 2);
    shell.press("fg; exit\r");
    shows(&mut shell);
    shell.press("q");
    shell.exit();
}
