//! Starts without a terminal.

use std::process::{Command, Output, Stdio};

use super::harness::{BEAMTUNE, Home, Program};

fn run(home: &Home, arguments: &[&str], input: Stdio) -> Output {
    Command::new(BEAMTUNE)
        .args(arguments)
        .env_clear()
        .envs(home.environment())
        .current_dir(home.work())
        .stdin(input)
        .output()
        .unwrap()
}

/// Standard output is a pipe: the designer reports what it needs, and writes nothing else.
#[test]
fn the_designer_needs_a_terminal_to_draw_on() {
    let home = Home::new();
    let output = run(&home, &["fig08"], Stdio::null());
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(
        said.starts_with("error: ") && said.contains("terminal"),
        "{said}"
    );
    assert_eq!(said.lines().count(), 1, "{said}");
    assert_eq!(home.names(), [""; 0]);
}

/// Standard input is not a terminal, but standard output is: keys come from the terminal anyway.
#[test]
fn keys_come_from_the_terminal_also_where_input_is_a_pipe() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    for script in [
        "true | \"$BEAMTUNE\" beam.toml",
        "\"$BEAMTUNE\" - < beam.toml",
    ] {
        let mut program = Program::script(&home, script);
        program.wait_for("modes,");
        program.press("q");
        assert_eq!(program.end(), 0, "{script}");
    }
}

/// A terminal that only writes lines, as in Emacs, or an unknown one: one line reports it, and nothing else is sent.
#[test]
fn the_designer_needs_a_terminal_with_a_screen() {
    let home = Home::new();
    for script in [
        "TERM=dumb exec \"$BEAMTUNE\" fig08",
        "TERM= exec \"$BEAMTUNE\" fig08",
        "unset TERM; exec \"$BEAMTUNE\" fig08 --color always",
    ] {
        let mut program = Program::script(&home, script);
        assert_eq!(program.exit(), 2, "{script}");
        assert!(program.is_plain());
        let said = String::from_utf8(program.raw.clone()).unwrap();
        assert!(
            said.starts_with("error: ") && said.contains("TERM"),
            "{said}"
        );
        assert_eq!(said.lines().count(), 1, "{said}");
        assert!(!said.contains('\u{1b}'), "{}", said.escape_debug());
    }
}
