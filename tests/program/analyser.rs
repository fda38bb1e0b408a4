//! An engineer's session of reading and comparing curves, at the two usual sizes of a terminal.

use std::fs;

use super::harness::{ESCAPE, Home, LARGE, Program, SMALL};

/// Both sizes at which everything must work.
fn both(play: impl Fn(&Home, &mut dyn FnMut(&[&str]) -> Program)) {
    for size in [SMALL, LARGE] {
        let home = Home::new();
        play(&home, &mut |arguments| {
            let mut program = Program::sized(&home, arguments, size);
            program.wait_for("solved");
            program
        });
    }
}

fn leave(mut program: Program) {
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// Replaces the text of a dialog by a line, and accepts it.
fn type_line(program: &mut Program, line: &str) {
    program.press(&format!("\u{15}{line}\r"));
}

#[test]
fn every_view_and_form_shows() {
    both(|_, start| {
        let mut program = start(&["cantilever"]);
        program.press("b");
        program.wait_for("phase, deg");
        program.press("'");
        program.wait_for("phase unwrapped");
        program.press("b");
        program.wait_for("Im, 0-peak");
        program.press("b");
        program.wait_for("Nyquist");
        program.press("fb");
        program.wait_for("level against the reference");
        program.press("b");
        program.wait_for("|H|");
        for form in [
            "receptance",
            "mobility",
            "accelerance",
            "dynamic stiffness",
            "impedance",
            "apparent mass",
            "motion under the force",
        ] {
            program.press("i");
            program.wait_for(&format!("tip w, {form}"));
        }
        program.press("i#");
        program.wait_for("rad/s");
        program.press("#");
        program.wait_for("rpm");
        program.press("%");
        program.wait_for("0 dB is");
        type_line(&mut program, "1e-9");
        program.wait_for("dB re 1e-9 m/N");
        leave(program);
    });
}

#[test]
fn cursors_are_read_in_a_table() {
    both(|_, start| {
        let mut program = start(&["cantilever"]);
        program.press("@");
        program.wait_for("Cursor to");
        type_line(&mut program, "20 Hz");
        program.press("c\"");
        program.wait_for("0 Hz from the second cursor");
        program.press("@");
        program.wait_for("Cursor to");
        type_line(&mut program, "30 Hz");
        program.wait_for("10 Hz from the second cursor");
        program.press("H");
        program.wait_for("2 x f");
        program.press("_");
        program.wait_for("Band 20");
        // The maximum in the band is shown.
        program.wait("the levels", |screen| {
            screen.contains("max") && screen.contains("tip w")
        });
        program.press("_}");
        program.press("\\|{)(");
        leave(program);
    });
}

#[test]
fn zoom_solves_again_and_goes_back() {
    both(|_, start| {
        let mut program = start(&["cantilever"]);
        program.press("@");
        program.wait_for("Cursor to");
        type_line(&mut program, "20 Hz");
        // The axis spans a few hertz about the cursor, and then the whole sweep again.
        program.wait_for("modes");
        program.press("5z");
        program.wait_for("20.5");
        program.press("*!");
        program.wait_for("levels follow the curves");
        program.press("!");
        program.wait_for("levels fixed");
        program.press("W");
        program.wait_for("200 ");
        leave(program);
    });
}

#[test]
fn the_beam_is_looked_at() {
    both(|_, start| {
        let mut program = start(&["cantilever"]);
        program.press("O");
        program.wait_for("Deflection at");
        program.press("A");
        program.press("A`");
        program.wait_for("animation stepped by");
        for panel in [
            "Bending moments",
            "Shear forces",
            "Torque",
            "Bimoment",
            "Power",
        ] {
            program.press("O");
            program.wait_for(panel);
        }
        program.press("O");
        program.press("B");
        program.wait_for("Structure");
        program.press("B");
        program.wait_for("Section");
        program.press("B");
        leave(program);
    });
}

#[test]
fn references_are_listed_and_loaded() {
    both(|home, start| {
        home.preset("cantilever", "other.toml");
        let mut program = start(&["cantilever"]);
        program.press("fQ");
        program.wait_for("References and measured curves");
        program.wait_for("before");
        program.press("a");
        program.wait_for("Load a model");
        type_line(&mut program, "other.toml");
        program.wait_for("other.toml is a reference now");
        program.press("Qr");
        program.wait_for("Name");
        type_line(&mut program, "first");
        program.wait_for("first");
        program.press(&format!("x{ESCAPE}"));
        program.wait_for("other.toml");
        program.press("F");
        program.wait_for("reference other.toml removed");
        leave(program);
    });
}

#[test]
fn a_measurement_is_compared_with_the_model() {
    both(|home, start| {
        // The program wrote the file itself: it must match.
        let model = beamtune::model::read(beamtune::presets::find("cantilever").unwrap().text);
        let model = model.unwrap();
        let frequencies: Vec<f64> = (1..=200).map(f64::from).map(|f| f + 2.0).collect();
        let never = std::sync::atomic::AtomicBool::new(false);
        let frf = beamtune::solve::sweep(&model, &frequencies, &never).unwrap();
        let rows = frequencies.iter().zip(&frf.columns[0].values);
        let rows: Vec<String> = rows
            .map(|(f, h)| format!("{f},{},{}\n", h.re, h.im))
            .collect();
        let rows = rows.concat();
        fs::write(home.file("measured.csv"), format!("f [Hz],re,im\n{rows}")).unwrap();
        let mut program = start(&["cantilever"]);
        // Ctrl-o.
        program.press("\u{f}");
        program.wait_for("Load a measured curve");
        type_line(&mut program, "none.csv");
        program.wait_for("none.csv");
        type_line(&mut program, "measured.csv");
        program.wait_for("Describe the columns");
        // The unit of the visible curves is proposed.
        program.wait_for("hz; re im; m/N");
        program.press("\r");
        program.wait_for("1 measured curve");
        program.press("Q");
        program.wait_for("FRAC 1.0000");
        program.press(ESCAPE);
        leave(program);
    });
}

#[test]
fn a_parameter_is_swept_on_the_spot_and_the_study_saved() {
    both(|home, start| {
        home.preset("cantilever", "beam.toml");
        let mut program = start(&["beam.toml"]);
        program.press("/damper mass");
        program.wait_for("of ");
        program.press("\r\u{14}");
        program.wait_for("Study of");
        type_line(&mut program, "0.5 1 2");
        program.wait_for("study:");
        program.press("s");
        program.wait_for("saved beam.toml");
        let text = fs::read_to_string(home.file("beam.toml")).unwrap();
        assert!(text.contains("multiply = [0.5, 1.0, 2.0]"), "{text}");
        leave(program);
    });
}

#[test]
fn what_is_on_the_screen_is_written_to_files() {
    both(|home, start| {
        let mut program = start(&["cantilever"]);
        let mut write = |name: &str, answer: &str| {
            // Ctrl-e.
            program.press("\u{5}");
            program.wait_for("Export the screen");
            type_line(&mut program, name);
            program.wait_for(answer);
            name.to_owned()
        };
        write("curves.csv", "written to curves.csv");
        write("chart.svg", "written to chart.svg");
        write("screen.txt", "written to screen.txt");
        write("curves.pdf", "must end in .csv, .svg or .txt");
        program.press(ESCAPE);
        // An existing file is replaced only after a confirmation.
        program.press("\u{5}");
        program.wait_for("Export the screen");
        type_line(&mut program, "screen.txt");
        program.wait_for("replace");
        program.press("y");
        program.wait_for("written to screen.txt");
        let csv = fs::read_to_string(home.file("curves.csv")).unwrap();
        assert!(csv.starts_with("# beamtune "), "{csv}");
        assert!(csv.contains("sha256"));
        let svg = fs::read_to_string(home.file("chart.svg")).unwrap();
        assert!(svg.contains("<svg") && svg.trim_end().ends_with("</svg>"));
        let text = fs::read_to_string(home.file("screen.txt")).unwrap();
        assert!(text.contains("tip w") && !text.contains("Export the screen"));
        leave(program);
    });
}
