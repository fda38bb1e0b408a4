//! An engineer's session: start, edit, view, save, quit.

use super::harness::{Home, Program, picture};

/// Start, find and change a parameter, see the new curve, save, quit, read the file back.
#[test]
fn a_parameter_is_tuned_and_saved() {
    let home = Home::new();
    let text = home.preset("fig08", "tuned.toml");
    let mut program = Program::start(&home, &["tuned.toml"]);
    program.wait_for("solved");
    select(&mut program, "S1 y_left stiffness");
    program.press("\r");
    program.wait_for("3.33333");
    // Ctrl-U empties the line.
    program.press("\u{15}5 MN/m\r");
    program.wait("the new value, solved", |screen| {
        screen.contains("5 MN/m") && screen.contains("solved")
    });
    program.press("s");
    program.wait_for("saved");
    program.press("q");
    assert_eq!(program.end(), 0);
    let saved = std::fs::read_to_string(home.file("tuned.toml")).unwrap();
    let model = beamtune::model::read(&saved).unwrap().into_inner();
    assert_eq!(model.subsystems[0].y_left.stiffness, 5e6);
    let mut original = beamtune::model::read(text).unwrap().into_inner();
    original.subsystems[0].y_left.stiffness = 5e6;
    assert_eq!(model, original);
    let comments = |text: &str| text.matches('#').count();
    assert_eq!(comments(&saved), comments(text));
}

/// The title of the panel with the details of the selected row.
fn details(screen: &str) -> Option<&str> {
    let titles = screen.lines().filter_map(|line| line.strip_prefix("─ "));
    titles
        .filter_map(|title| title.split_once(" ─"))
        .map(|(title, _)| title)
        .find(|title| *title != "Model")
}

/// Steps through the parameters until the details are those of `name`.
fn select(program: &mut Program, name: &str) {
    for _ in 0..200 {
        let before = program.text();
        if before.contains(&format!("{name} ─")) {
            return;
        }
        program.press("\t");
        // A change of the screen alone is not enough: new curves may arrive at any time.
        program.wait("the next parameter", |screen| {
            details(screen).is_some() && details(screen) != details(&before)
        });
    }
    panic!("{name} not found; the screen is\n{}", program.text());
}

/// A changed model is not discarded without a confirmation.
#[test]
fn quitting_asks_when_something_is_unsaved() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig08", "--set", "subsystems.S1.mass=200"]);
    program.wait_for("solved");
    program.press("q");
    program.wait_for("discard");
    program.press("\u{1b}");
    program.wait("the question to go", |screen| !screen.contains("discard"));
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
}

/// A shape is animated, and the same key stops it.
#[test]
fn a_shape_moves_while_it_shall() {
    let home = Home::new();
    let mut program = Program::start(&home, &["fig06"]);
    program.press("m");
    program.wait_for("Modes: 16 of 16");
    program.press("jM");
    // The axis is drawn last.
    program.wait("a shape", |screen| {
        screen.contains("psi  ") && screen.contains("2.5    3 m")
    });
    let still = program.picture();
    program.press("A");
    program.wait("a frame", |screen| picture(screen) != still);
    let frame = program.picture();
    program.wait("the next frame", |screen| picture(screen) != frame);
    // It stops where it is; when shown again, it is at its largest.
    program.press("A");
    program.press("MM");
    program.wait("the shape at its widest", |screen| picture(screen) == still);
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// A beam around the whole earth has too many modes below 400 Hz to wait for. The user can still quit the program while
/// it counts them.
#[test]
fn a_beam_with_too_many_modes_says_so_and_shows_its_curves() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let mut program = Program::start(&home, &["beam.toml", "--set", "beam.length=4e7"]);
    program.wait_for("too many modes");
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
}

#[test]
fn an_endless_model_does_not_block_the_user() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let mut program = Program::start(&home, &["beam.toml", "--set", "beam.length=1500"]);
    program.wait_for("computing modes");
    program.press("\t");
    program.wait_for("length of the beam");
    // Every answer is superseded by the next edit.
    for _ in 0..20 {
        program.press("+");
        program.settle();
    }
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
}
