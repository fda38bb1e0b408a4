//! Colours, characters and keys as configured.

use vt100::Color;

use super::harness::{Home, Program};

/// The designer once everything is solved.
fn shown(home: &Home, arguments: &[&str], variables: &[(&str, &str)]) -> Program {
    let mut program = Program::with(home, arguments, variables);
    program.wait_for("modes,");
    program.settle();
    program
}

fn leave(mut program: Program) {
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// Every colour on the screen, of text and background.
fn colours(program: &Program) -> Vec<Color> {
    let screen = program.screen();
    let (rows, columns) = screen.size();
    let cells = (0..rows.get()).flat_map(|row| (0..columns.get()).map(move |column| (row, column)));
    cells
        .filter_map(|(row, column)| screen.cell(row, column))
        .flat_map(|cell| [cell.fgcolor(), cell.bgcolor()])
        .filter(|colour| *colour != Color::Default)
        .collect()
}

/// Whether some cell is emphasised without a colour.
fn is_marked(program: &Program) -> bool {
    let screen = program.screen();
    let (rows, columns) = screen.size();
    let selected = |row| {
        let cells = (0..columns.get()).filter_map(|column| screen.cell(row, column));
        cells.filter(|cell| cell.inverse()).count() > 5
    };
    (0..rows.get()).any(selected)
}

#[test]
fn without_colours_the_selection_still_shows() {
    for (arguments, variables) in [
        (&["fig08"][..], &[("NO_COLOR", "1")][..]),
        (&["fig08", "--color", "never"], &[]),
    ] {
        let home = Home::new();
        let program = shown(&home, arguments, variables);
        assert_eq!(colours(&program), [], "{arguments:?}");
        assert!(is_marked(&program), "{arguments:?}");
        leave(program);
    }
}

/// The default is the terminal's sixteen colours, also if it claims more, because its background is unknown.
#[test]
fn colours_are_as_many_as_asked_for() {
    let sixteen = |colour: &Color| matches!(colour, Color::Idx(0..16));
    let fixed = |colour: &Color| matches!(colour, Color::Idx(16..));
    let free = |colour: &Color| matches!(colour, Color::Rgb(..));
    let kinds = |arguments: &[&str], variables: &[(&str, &str)]| {
        let home = Home::new();
        let program = shown(&home, arguments, variables);
        let colours = colours(&program);
        assert!(is_marked(&program), "{arguments:?}");
        leave(program);
        let any = |kind: fn(&Color) -> bool| colours.iter().any(kind);
        [any(sixteen), any(fixed), any(free)]
    };
    let truecolor = [("COLORTERM", "truecolor")];
    assert_eq!(kinds(&["fig08"], &[]), [true, false, false]);
    assert_eq!(kinds(&["fig08"], &truecolor), [true, false, false]);
    assert_eq!(
        kinds(&["fig08", "--color", "16"], &truecolor),
        [true, false, false]
    );
    let [_, fixed, free] = kinds(&["fig08", "--color", "256", "--theme", "dark"], &[]);
    assert_eq!((fixed, free), (true, false));
    let [_, _, free] = kinds(&["fig08", "--color", "truecolor", "--theme", "light"], &[]);
    assert!(free);
    let [_, _, free] = kinds(&["fig08", "--theme", "light"], &truecolor);
    assert!(free);
    // The command line takes precedence over the variable.
    assert_eq!(
        kinds(&["fig08", "--color", "always"], &[("NO_COLOR", "1")]),
        [true, false, false]
    );
}

/// If the terminal may not support more, no byte beyond ASCII is sent.
#[test]
fn a_plain_terminal_gets_plain_characters() {
    for (arguments, variables) in [
        (&["fig08", "--ascii"][..], &[][..]),
        (&["fig08"], &[("LANG", "C")]),
        (&["fig08"], &[("LANG", "")]),
        (&["fig08"], &[("LC_ALL", "POSIX")]),
        (&["fig08"], &[("TERM", "linux")]),
    ] {
        let home = Home::new();
        let mut program = shown(&home, arguments, variables);
        for keys in [
            "?",
            "q",
            "p",
            "q",
            "\t",
            "\r",
            "\u{1b}[27u",
            "+",
            "u",
            "m",
            "M",
            ":",
            "\u{1b}[27u",
        ] {
            program.press(keys);
            program.settle();
        }
        let strange = program.raw.iter().position(|byte| !byte.is_ascii());
        assert_eq!(strange, None, "{arguments:?} {variables:?}");
        leave(program);
    }
    let home = Home::new();
    let program = shown(
        &home,
        &["fig08"],
        &[("LC_ALL", "de_DE.utf8"), ("LANG", "C")],
    );
    assert!(!program.raw.is_ascii());
    leave(program);
}

#[test]
fn keys_are_those_of_the_configuration() {
    let home = Home::new();
    home.configure("[keys.model]\nquit = [\"F10\"]\nhelp = [\"Alt-h\"]\n");
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    program.press("q?");
    program.settle();
    assert!(!program.text().contains("Everywhere"), "{}", program.text());
    program.press("\u{1b}h");
    program.wait_for("Alt-h");
    program.press("\u{1b}[27u");
    // F10.
    program.press("\u{1b}[21~");
    assert_eq!(program.end(), 0);
}

#[test]
fn a_key_for_two_commands_is_refused_with_both_names() {
    let home = Home::new();
    home.configure("[keys.model]\nundo = [\"s\"]\n");
    let program = Program::start(&home, &["fig08"]);
    let (code, said) = program.last_words();
    assert_eq!(code, 2);
    let said = said.replace('\n', "");
    assert!(
        said.contains("error: ") && said.contains("config.toml:2:"),
        "{said}"
    );
    assert!(said.contains("undo") && said.contains("save"), "{said}");
}
