//! An engineer's session of sensitivities and tuning, at the two usual sizes of a terminal.

use std::fs;

use super::harness::{Home, LARGE, Program, SMALL};

fn both(play: impl Fn(&Home, Program)) {
    for size in [SMALL, LARGE] {
        let home = Home::new();
        let mut program = Program::sized(&home, &["cantilever"], size);
        program.wait_for("solved");
        play(&home, program);
    }
}

#[test]
fn a_damper_is_tuned_and_saved() {
    both(|home, mut program| {
        program.press("~");
        program.wait_for("Sensitivities of tip w");
        program.press("60\u{7}");
        program.wait_for("Tuned:");
        program.wait_for("best so far");
        program.press("\u{19}");
        program.wait_for("the tuned parameters are in the model");
        let file = home.file("tuned.toml");
        program.press("S");
        program.wait_for("Save");
        program.press(&format!("\u{15}{}\r", file.display()));
        program.wait_for("saved");
        let text = fs::read_to_string(&file).unwrap();
        let model = beamtune::model::read(&text).unwrap().into_inner();
        assert_ne!(model.subsystems[0].y_left.stiffness, 1.4e5);
        program.press("q");
        assert_eq!(program.end(), 0);
    });
}

#[test]
fn a_search_is_paused_and_dropped() {
    both(|_, mut program| {
        program.press("9000\u{7}");
        program.wait_for(" of 9,000");
        program.press("\u{7}");
        program.wait_for("paused");
        program.press("\u{7}");
        program.wait_for("the search continues");
        program.press("\u{18}");
        program.wait_for("search discarded");
        program.press("q");
        assert_eq!(program.end(), 0);
    });
}

#[test]
fn a_search_does_not_hold_up_the_end() {
    both(|_, mut program| {
        program.press("9000\u{7}");
        program.wait_for(" of 9,000");
        program.press("q");
        assert_eq!(program.end(), 0);
    });
}
