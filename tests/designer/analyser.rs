//! The chart as an analyser: its readings against the solver, closed forms and physical laws.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use beamtune::model::checked;
use std::sync::atomic::AtomicBool;

use beamtune::measured::{Hint, Layout, inspect, read};
use beamtune::model::Model;
use beamtune::solve::{Frf, sweep};
use beamtune::tui::app::{BeamView, Message, OpenedMeasured, Overlay, Reply};
use beamtune::tui::plot::Level;
use beamtune::tui::scene::{ChartView, CurveKind, Scene};
use beamtune::unit::Form;
use beamtune::unit::FrequencyUnit;
use num_complex::Complex64;

use super::driver::Driver;

/// The solver's own answer.
fn solved(model: &Model, frequencies: &[f64]) -> Frf {
    sweep(&checked(model), frequencies, &AtomicBool::new(false)).unwrap()
}

fn scene(driver: &Driver) -> Scene {
    driver.app.scene()
}

/// The solver's value of the first response of the driver's model at a frequency.
fn first_response(driver: &Driver, frequency: f64) -> Complex64 {
    solved(driver.app.model(), &[frequency]).columns[0].values[0]
}

fn assert_near(actual: f64, expected: f64, relative: f64) {
    let off = (actual - expected).abs() / expected.abs();
    assert!(off < relative, "{actual} is not {expected}: {off:e}");
}

#[test]
fn the_cursor_reads_what_is_solved_at_its_frequency() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("123.456789 Hz").keys("Enter b");
    // Expected: the solver at that frequency, which is not a point of the sweep.
    let cursor = driver.app.curves.cursor.unwrap();
    assert_eq!(cursor, 123.456_789);
    let expected = first_response(&driver, cursor);
    let at_cursor = scene(&driver).curves[0].at_cursor.clone().unwrap();
    assert_near(at_cursor[0], expected.norm(), 1e-14);
    assert_near(at_cursor[1], expected.arg().to_degrees(), 1e-12);
    // The same in the table, to the displayed digits.
    let screen = driver.keys("\"").screen(120, 40);
    assert!(screen.contains(&format!("{:.3e}", expected.norm())));
    assert!(screen.contains(&format!("{:.1}", expected.arg().to_degrees())));
}

#[test]
fn the_cursor_follows_the_model() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("100").keys("Enter");
    driver.select("subsystems.S1.mass").keys("> >");
    // Expected: the solver, for the changed model.
    let expected = first_response(&driver, 100.0);
    let at_cursor = scene(&driver).curves[0].at_cursor.clone().unwrap();
    assert_near(at_cursor[0], expected.norm(), 1e-14);
}

#[test]
fn a_frequency_is_typed_in_any_unit() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("6000 rpm").keys("Enter");
    // Closed form: 6000 rpm are 100 Hz, and 200 pi rad/s.
    assert_near(driver.app.curves.cursor.unwrap(), 100.0, 1e-15);
    driver
        .keys("@")
        .typed("628.318530717958647 rad/s")
        .keys("Enter");
    assert_near(driver.app.curves.cursor.unwrap(), 100.0, 1e-15);
    driver
        .keys("# @")
        .typed("628.318530717958647")
        .keys("Enter");
    assert_near(driver.app.curves.cursor.unwrap(), 100.0, 1e-15);
    assert_eq!(driver.app.display.unit, FrequencyUnit::RadianPerSecond);
    driver.keys("@").typed("fast").keys("Enter");
    let Some(Overlay::Prompt(prompt)) = &driver.app.overlay else {
        panic!("the box stays open");
    };
    assert!(prompt.refusal.as_ref().unwrap().contains("7200 rpm"));
}

#[test]
fn differences_to_the_second_cursor_are_those_of_the_solver() {
    let mut driver = Driver::preset("fig05a");
    driver
        .keys("@")
        .typed("50")
        .keys("Enter c @")
        .typed("80")
        .keys("Enter");
    let level = |f: f64| 20.0 * first_response(&driver, f).norm().log10();
    let expected = level(80.0) - level(50.0);
    let screen = driver.keys("\"").screen(120, 40);
    assert!(screen.contains(&format!("{expected:+.2}")), "{screen}");
    assert!(screen.contains("30 Hz from the second cursor"));
}

#[test]
fn harmonics_are_multiples_within_the_sweep() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("120").keys("Enter H");
    let to = driver.app.model().sweep.to;
    let expected: Vec<f64> = (2..=10)
        .map(|order| f64::from(order) * 120.0)
        .filter(|f| *f <= to)
        .collect();
    assert!(!expected.is_empty());
    assert_eq!(scene(&driver).marks.harmonics, expected);
    // Each value is exact.
    let screen = driver.keys("\"").screen(120, 40);
    let value = first_response(&driver, 240.0).norm();
    assert!(screen.contains(&format!("{value:.3e}")));
}

#[test]
fn peaks_and_anti_resonances_are_found_in_the_form_that_shows() {
    let mut driver = Driver::preset("cantilever");
    driver.keys("}");
    let peak = driver.app.curves.cursor.unwrap();
    let around =
        |f: f64| [0.999, 1.0, 1.001].map(|share| first_response(&driver, share * f).norm());
    let [before, at, after] = around(peak);
    assert!(at > before && at > after);
    driver.keys("\\");
    let dip = driver.app.curves.cursor.unwrap();
    let around =
        |f: f64| [0.999, 1.0, 1.001].map(|share| first_response(&driver, share * f).norm());
    let [before, at, after] = around(dip);
    assert!(dip > peak && at < before && at < after);
    // An inverse peaks where the response dips.
    driver.keys("{");
    assert_eq!(driver.app.curves.cursor, Some(peak));
    driver.keys("i i i i");
    assert_eq!(driver.app.display.form, Some(Form::DynamicStiffness));
    driver.keys("}");
    assert_near(driver.app.curves.cursor.unwrap(), dip, 1e-9);
}

#[test]
fn the_six_forms_differ_by_the_frequency_and_by_inversion() {
    let mut driver = Driver::preset("cantilever");
    let receptance = {
        let force = driver.app.model().forces[0].clone();
        let amplitude = Complex64::from_polar(force.amplitude, force.phase.to_radians());
        first_response(&driver, 20.0) / amplitude
    };
    driver.keys("@").typed("20").keys("Enter");
    let omega = std::f64::consts::TAU * 20.0;
    // Closed form: velocity is i omega times displacement, acceleration -omega^2 times.
    let expected = [
        receptance.norm(),
        omega * receptance.norm(),
        omega * omega * receptance.norm(),
        1.0 / receptance.norm(),
        1.0 / (omega * receptance.norm()),
        1.0 / (omega * omega * receptance.norm()),
    ];
    for (form, expected) in Form::ALL.into_iter().zip(expected) {
        driver.keys("i");
        assert_eq!(driver.app.display.form, Some(form));
        let at_cursor = scene(&driver).curves[0].at_cursor.clone().unwrap();
        assert_near(at_cursor[0], expected, 1e-13);
        assert!(scene(&driver).title.contains(form.name()));
    }
    driver.keys("i");
    assert_eq!(driver.app.display.form, None);
}

#[test]
fn several_forces_have_no_inverse() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("i i i");
    assert_eq!(driver.app.display.form, Some(Form::Accelerance));
    driver.keys("i");
    assert_eq!(
        driver.app.display.form, None,
        "the inverses are passed over"
    );
}

#[test]
fn zooming_in_solves_what_shows() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("100").keys("Enter z z z z z z z z");
    driver.screen(120, 40);
    driver.keys("z");
    let [low, high] = driver.app.shown_frequencies();
    let sweep = driver.app.model().sweep;
    let before = (high - low) / (sweep.to - sweep.from) * sweep.points as f64;
    assert!(before < 6.0, "the sweep has few points there: {before}");
    let scene = scene(&driver);
    let curve = &scene.curves[0];
    let columns = driver.app.screen.plot.as_ref().unwrap().frequencies.len();
    assert!(curve.frequencies.len() > 4 * columns);
    // Expected: the solver at each of them.
    let solved = solved(driver.app.model(), &curve.frequencies);
    for (value, expected) in curve.values[0].iter().zip(&solved.columns[0].values) {
        assert_near(*value, expected.norm(), 1e-14);
    }
}

#[test]
fn twice_the_forces_are_six_decibels_everywhere() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("f");
    for force in 0..driver.app.model().forces.len() {
        driver.select(&format!("forces.{}.amplitude", force + 1));
        driver.keys("Enter").typed("*2").keys("Enter");
    }
    driver.keys("b b b b");
    assert_eq!(driver.app.display.view, ChartView::Difference);
    let scene = scene(&driver);
    let values = &scene.curves[0].values[0];
    assert!(values.len() > 1000);
    // Closed form: 20 lg 2 = 6.0206 dB.
    for value in values {
        assert_near(*value, 20.0 * 2.0_f64.log10(), 1e-9);
    }
}

#[test]
fn decibels_count_from_the_reference_that_is_typed() {
    let mut driver = Driver::preset("fig05a");
    driver
        .keys("@")
        .typed("100")
        .keys("Enter %")
        .typed("1e-12")
        .keys("Enter");
    assert!(driver.app.curves.decibels);
    let scene = scene(&driver);
    let expected = first_response(&driver, 100.0).norm();
    let Level::Decibel { reference, .. } = scene.panels[0].level else {
        panic!("decibels");
    };
    assert_eq!(reference, 1e-12);
    assert!(scene.panels[0].unit.starts_with("dB re 1e-12 m"));
    let level = scene.panels[0].level.value(expected);
    // Closed form: 20 lg (|H| / reference).
    assert_near(level, 20.0 * (expected / 1e-12).log10(), 1e-14);
    for refused in ["0", "-1", "nan", "many"] {
        driver.keys("%").typed(refused).keys("Enter");
        assert!(driver.app.overlay.is_some(), "{refused}");
        driver.keys("Esc");
    }
}

#[test]
fn references_are_kept_named_hidden_and_dropped() {
    let mut driver = Driver::preset("fig05a");
    driver.select("subsystems.S1.mass").keys("f > f");
    let names = |driver: &Driver| -> Vec<String> {
        let references = driver.app.comparison.references.iter();
        references.map(|one| one.name.clone()).collect()
    };
    assert_eq!(names(&driver), ["before", "before 2"]);
    driver.keys("Q r").typed("light").keys("Enter");
    assert_eq!(names(&driver), ["light", "before 2"]);
    driver.keys("Down Enter Esc");
    let shown = |driver: &Driver| {
        let curves = scene(driver).curves;
        let references = curves.iter().filter(|one| one.kind == CurveKind::Reference);
        references.map(|one| one.label.clone()).collect::<Vec<_>>()
    };
    assert_eq!(shown(&driver), ["light"]);
    driver.keys("Q x Esc");
    assert_eq!(names(&driver), ["before 2"]);
    driver.keys("F F");
    assert!(names(&driver).is_empty());
}

#[test]
fn a_study_is_made_of_the_selected_parameter_and_kept_in_the_file() {
    let mut driver = Driver::preset("fig08");
    let studies = driver.app.model().studies.len();
    driver.select("subsystems.S1.mass");
    driver.keys("Ctrl-t").typed("0.5 1 4").keys("Enter");
    assert_eq!(driver.app.curves.study, Some(studies));
    assert_eq!(driver.app.curves.picture().unwrap().members.len(), 3);
    driver.select("subsystems.S1.mass");
    driver.keys("Ctrl-t").typed("= 80 kg, 0.2 t").keys("Enter");
    assert_eq!(driver.app.curves.picture().unwrap().members.len(), 2);
    // The saved file reads back as the same model.
    let read = beamtune::model::read(&driver.app.document.text())
        .unwrap()
        .into_inner();
    assert_eq!(read, ***driver.app.model());
    assert_eq!(read.studies.len(), studies + 2);
    driver.keys("u u");
    assert_eq!(driver.app.model().studies.len(), studies);
    // Changes that give an impossible model are refused.
    driver.select("subsystems.S1.mass");
    for refused in ["", "x", "-1", "0", "= -2", "1 2 3 4 5 6 7 8 9 10 11 12 13"] {
        driver.keys("Ctrl-t").typed(refused).keys("Enter");
        assert!(driver.app.overlay.is_some(), "{refused}");
        driver.keys("Esc");
    }
    assert_eq!(driver.app.model().studies.len(), studies);
}

#[test]
fn levels_are_fixed_zoomed_and_let_go() {
    let mut driver = Driver::preset("fig05a");
    driver.screen(120, 40);
    let whole = driver.app.screen.levels.unwrap();
    assert!(whole.log);
    driver.keys("*");
    let [low, high] = driver.app.display.levels.unwrap();
    // Half of the decades.
    let decades = |[low, high]: [f64; 2]| (high / low).log10();
    assert_near(decades([low, high]), 0.5 * decades(whole.bounds), 1e-12);
    driver.keys("Shift-Up");
    let moved = driver.app.display.levels.unwrap();
    assert_near(decades([low, moved[0]]), 0.25 * decades([low, high]), 1e-9);
    driver.screen(120, 40);
    assert_eq!(driver.app.screen.levels.unwrap().bounds, moved);
    driver.keys("!");
    assert_eq!(driver.app.display.levels, None);
    driver.keys("& z W");
    assert_eq!(driver.app.display.levels, None);
    assert_eq!(driver.app.curves.window, None);
}

#[test]
fn what_the_beam_does_follows_the_cursor() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("100").keys("Enter O");
    assert_eq!(driver.app.beam_view.shown, Some(BeamView::Deflection));
    let operating = driver.app.beam_view.operating().unwrap();
    assert_eq!(operating.frequency, 100.0);
    // Expected: the response that the solver gives for w at the right end.
    let model = driver.app.model().clone();
    let right = model
        .responses
        .iter()
        .position(|one| one.name == "P5 w")
        .unwrap();
    let expected = solved(&model, &[100.0]).columns[right].values[0];
    let shown = *operating.motion[0].last().unwrap();
    assert!((shown - expected).norm() < 1e-10 * expected.norm());
    driver.keys("]");
    let cursor = driver.app.curves.cursor.unwrap();
    assert_eq!(driver.app.beam_view.operating().unwrap().frequency, cursor);
    assert!(!driver.app.operating_is_stale());
    driver.keys("O O O O O O");
    assert_eq!(driver.app.beam_view.shown, None);
}

/// A measured curve of the first response of the cantilever, in a unit, loaded.
fn with_measured(unit: &str, values: impl Fn(f64, Complex64) -> Complex64) -> Driver {
    let mut driver = Driver::preset("cantilever");
    let frequencies: Vec<f64> = (0..300).map(|i| 5.0 + 0.5 * f64::from(i)).collect();
    let exact = solved(driver.app.model(), &frequencies);
    let amplitude = driver.app.model().forces[0].amplitude;
    let rows = frequencies.iter().zip(&exact.columns[0].values);
    let rows: Vec<String> = rows
        .map(|(f, h)| {
            let value = values(*f, *h / amplitude);
            format!("{f},{},{}\n", value.re, value.im)
        })
        .collect();
    load(
        &mut driver,
        &format!("f [Hz],H re [{unit}],H im [{unit}]\n{}", rows.concat()),
    );
    driver
}

/// Loads a table.
fn load(driver: &mut Driver, text: &str) {
    let hint = Hint {
        name: "table.csv".to_owned(),
        layout: None,
    };
    let curves = read(text.as_bytes(), &hint).unwrap();
    let reply = Reply::Measured(OpenedMeasured::Curves(curves));
    let effects = driver.app.reply(reply);
    driver.perform(effects);
}

#[test]
fn a_measured_curve_fits_in_every_form_whatever_was_measured() {
    // The reading of an accelerometer in g per newton: -omega^2 H / 9.80665.
    let mut driver = with_measured("g/N", |f, h| {
        let omega = std::f64::consts::TAU * f;
        -omega * omega * h / 9.806_65
    });
    for form in [None].into_iter().chain(Form::ALL.map(Some)) {
        assert_eq!(driver.app.display.form, form);
        // Expected: it is the model's own response, so FRAC is 1 and the differences are 0.
        let fit = &driver.app.comparison.fits[0].fit;
        assert_near(fit.frac, 1.0, 1e-12);
        assert!(fit.mean_decibels.abs() < 1e-10, "{form:?}");
        let curves = scene(&driver).curves;
        let [model, measured] = [CurveKind::Model, CurveKind::Measured]
            .map(|kind| curves.iter().find(|one| one.kind == kind).unwrap());
        let place = model.frequencies.iter().position(|f| *f == 50.0);
        if let Some(place) = place {
            let other = measured
                .frequencies
                .iter()
                .position(|f| *f == 50.0)
                .unwrap();
            assert_near(measured.values[0][other], model.values[0][place], 1e-12);
        }
        driver.keys("i");
    }
}

/// The dialog names the file and shows its first rows; the status line lists what was ignored.
#[test]
fn columns_are_requested_with_a_preview_and_notes_are_shown() {
    let text = "Pt Force at Tip\n1 10 2e-6 OK\n2 20 3e-6 OK\nsaved today\n";
    let mut hint = Hint {
        name: "table.txt".to_owned(),
        layout: None,
    };
    let seen = inspect(text.as_bytes(), &hint).unwrap();
    let mut driver = Driver::preset("cantilever");
    let asks = OpenedMeasured::Asks("table.txt".into(), Box::new(seen));
    let effects = driver.app.reply(Reply::Measured(asks));
    driver.perform(effects);
    for (width, height) in [(80, 24), (120, 40)] {
        let screen = driver.screen(width, height);
        for part in [
            "1: Pt | 2: Force",
            "1 | 10 | 2e-6",
            "It does not say in which unit",
        ] {
            assert!(screen.contains(part), "{part}: {screen}");
        }
    }
    hint.layout = Some(Layout::parse("hz 2; mag 3; m/N").unwrap());
    let curves = read(text.as_bytes(), &hint).unwrap();
    let effects = driver
        .app
        .reply(Reply::Measured(OpenedMeasured::Curves(curves)));
    driver.perform(effects);
    assert_eq!(
        driver.app.message,
        Some(Message::Done(
            "1 measured curve; column 4 skipped: it has no numbers; 1 line after the numbers skipped, from \"saved \
             today\" on"
                .to_owned()
        ))
    );
}

#[test]
fn a_fit_follows_the_model_and_a_file_that_is_loaded_again() {
    let mut driver = with_measured("m/N", |_, h| 2.0 * h);
    // Closed form: twice the response is 6.0206 dB, with the same shape.
    assert_near(driver.app.comparison.fits[0].fit.frac, 1.0, 1e-12);
    assert_near(
        driver.app.comparison.fits[0].fit.mean_decibels,
        -20.0 * 2.0_f64.log10(),
        1e-9,
    );
    driver.select("beam.length").keys(">");
    assert!(driver.app.comparison.fits[0].fit.frac < 0.99);
    driver.keys("u Q x Esc");
    assert!(driver.app.comparison.fits.is_empty());
    load(
        &mut driver,
        "f [Hz],re [m/N],im [m/N]\n10,1,0\n20,2,0\n30,1,1\n",
    );
    assert_eq!(driver.app.comparison.fits[0].fit.points, 3);
    // Another file with the same name has other frequencies.
    driver.keys("Q x Esc");
    load(
        &mut driver,
        "f [Hz],re [m/N],im [m/N]\n11,1,0\n21,2,0\n31,1,1\n41,1,1\n",
    );
    assert_eq!(driver.app.comparison.fits[0].fit.points, 4);
}

#[test]
fn fixed_levels_are_those_of_one_axis() {
    let mut driver = Driver::preset("fig05a");
    driver.screen(80, 24);
    driver.keys("!");
    assert!(driver.app.display.levels.is_some());
    driver.keys("d");
    assert_eq!(
        driver.app.display.levels, None,
        "decibels have other levels"
    );
    driver.screen(80, 24);
    driver.keys("! i i");
    assert_eq!(driver.app.display.levels, None, "and so have velocities");
}

#[test]
fn a_difference_ends_with_its_reference() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("f b b b b");
    assert_eq!(driver.app.display.view, ChartView::Difference);
    driver.keys("F");
    assert_eq!(driver.app.display.view, ChartView::Magnitude);
}

#[test]
fn a_study_that_is_made_has_its_row_at_once() {
    let mut driver = Driver::preset("fig08");
    let rows = driver.app.selection.rows().len();
    driver.keys("End l");
    let open = driver.app.selection.rows().len();
    assert!(open > rows, "the studies are open");
    driver.select("subsystems.S1.mass");
    let before = driver.app.selection.rows().len();
    driver.keys("Ctrl-t").typed("0.5 2").keys("Enter");
    assert_eq!(driver.app.selection.rows().len(), before + 1);
}

#[test]
fn another_model_is_looked_at_afresh() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("300").keys("Enter c O _");
    assert!(driver.app.beam_view.operating().is_some());
    driver.without_answers().keys("p End Enter");
    assert!(driver.app.beam_view.operating().is_none());
    assert!(driver.app.curves.band.is_none() && driver.app.band.levels.is_none());
    assert!(driver.app.reading.second.is_none());
}

#[test]
fn the_sweep_keeps_what_is_marked_on_its_axis() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("300").keys("Enter c");
    driver
        .select("sweep.to")
        .keys("Enter")
        .typed("200")
        .keys("Enter");
    assert_eq!(driver.app.curves.cursor, None);
    assert_eq!(driver.app.reading.second, None);
}

#[test]
fn a_measured_motion_stands_with_the_motion_under_the_one_force() {
    // Accelerations of the tip under the preset's 100 N, as recorded by an accelerometer without a force sensor.
    let amplitude = 100.0;
    let mut driver = with_measured("m/s2", |f, h| {
        let omega = std::f64::consts::TAU * f;
        -omega * omega * h * amplitude
    });
    assert!(driver.app.comparison.fits.is_empty());
    driver.keys("Q");
    let screen = driver.screen(120, 40);
    assert!(
        screen.contains("does not match the visible curves"),
        "{screen}"
    );
    driver.keys("Esc I");
    assert!(driver.app.display.motion && driver.app.display.form.is_none());
    let fit = &driver.app.comparison.fits[0].fit;
    // Expected: it is the model's own motion.
    assert_near(fit.frac, 1.0, 1e-12);
    assert!(fit.mean_decibels.abs() < 1e-10, "{}", fit.mean_decibels);
    driver.keys("Q");
    let screen = driver.screen(120, 40);
    assert!(screen.contains("FRAC 1.0000"), "{screen}");
    // Closed form: the motion is a hundred times the receptance, 40 dB.
    driver.keys("Esc @").typed("20").keys("Enter");
    let read = |driver: &Driver| {
        let (_, trace) = driver.app.curves.first_trace().unwrap();
        driver.app.value_at(0, trace, 20.0).unwrap().shown.norm()
    };
    let motion = read(&driver);
    assert_eq!(driver.app.display.shown_units(&driver.app.curves), ["m"]);
    driver.keys("i");
    assert_near(motion, 100.0 * read(&driver), 1e-12);
    assert_eq!(driver.app.display.shown_units(&driver.app.curves), ["m/N"]);
    // If several forces act there is no ratio, and so this form does not exist.
    let mut several = Driver::preset("fig05a");
    several.keys("I");
    assert!(!several.app.display.motion);
}

#[test]
fn of_a_file_with_many_curves_any_can_be_chosen() {
    let columns: Vec<String> = (1..=40)
        .map(|i| format!(",P{i} re [m/N],P{i} im [m/N]"))
        .collect();
    let row = |f: i32| format!("{f}{}\n", ",1e-6,0".repeat(40));
    let text = format!("f [Hz]{}\n{}{}", columns.concat(), row(10), row(20));
    let mut driver = Driver::preset("cantilever");
    load(&mut driver, &text);
    let screen = driver.screen(80, 24);
    assert!(screen.contains("Which of 40 curves"), "{screen}");
    assert!(screen.contains("40 P40"), "{screen}");
    assert!(driver.app.comparison.measured.is_empty());
    let names = |driver: &Driver| -> Vec<String> {
        let measured = driver.app.comparison.measured.iter();
        measured.map(|one| one.name.clone()).collect()
    };
    // An answer that selects nothing or too much keeps the dialog open and explains why.
    for (wrong, word) in [("50", "50"), ("1-13", "room for 12"), ("P", "40 curves")] {
        driver.typed(wrong).keys("Enter");
        let screen = driver.screen(80, 24);
        assert!(
            screen.contains(word) && screen.contains("Which of"),
            "{screen}"
        );
    }
    driver.typed("13, P40").keys("Enter");
    assert_eq!(names(&driver), ["P13", "P40"]);
    assert!(driver.app.overlay.is_none());
    // Again, for more: it proposes as many as fit.
    load(&mut driver, &text);
    driver.keys("Enter");
    assert_eq!(names(&driver).len(), 12);
    // Every one can be selected.
    for number in 13..=40 {
        let mut driver = Driver::preset("cantilever");
        driver.without_answers();
        load(&mut driver, &text);
        driver.typed(&number.to_string()).keys("Enter");
        assert_eq!(names(&driver), [format!("P{number}")]);
    }
}

#[test]
fn in_the_difference_view_the_difference_is_read() {
    let mut driver = Driver::preset("cantilever");
    let before = first_response(&driver, 31.5);
    driver
        .keys("f")
        .select("subsystems.Damper.mass")
        .keys("> @");
    driver.typed("31.5").keys("Enter");
    while driver.app.display.view != ChartView::Difference {
        driver.keys("b");
    }
    // Closed form: 20 log10 of the ratio of the solver's values for both models.
    let expected = 20.0 * (first_response(&driver, 31.5).norm() / before.norm()).log10();
    assert!(expected.abs() > 0.05, "{expected}");
    let expected_text = format!("31.5 Hz  {expected:+.2} dB");
    let screen = driver.screen(80, 24);
    assert!(
        screen.contains(&expected_text),
        "no {expected_text} in {screen}"
    );
    driver.keys("\"");
    let screen = driver.screen(120, 40);
    assert!(screen.contains("against before"), "{screen}");
    assert!(screen.contains(&format!(" {expected:+.2}")), "{screen}");
    // From another cursor, the difference of the differences is shown.
    driver.keys("c @").typed("20").keys("Enter");
    let here = driver
        .app
        .difference_at(0, driver.app.curves.first_trace().unwrap().1, 20.0);
    let expected_text = format!("{:+.2}", here.unwrap().decibels - expected);
    let screen = driver.screen(120, 40);
    assert!(
        screen.contains(&expected_text),
        "no {expected_text} in {screen}"
    );
}

#[test]
fn two_cursors_keep_the_frequency_and_the_value_on_a_small_screen() {
    let mut driver = Driver::preset("cantilever");
    driver
        .keys("@")
        .typed("20")
        .keys("Enter c @")
        .typed("25.25")
        .keys("Enter");
    let value = first_response(&driver, 25.25).norm() / driver.app.model().forces[0].amplitude;
    let expected_text = format!("25.25 Hz  {value:.3e} m/N");
    for size in [(80, 24), (120, 40)] {
        let screen = driver.screen(size.0, size.1);
        assert!(
            screen.contains(&expected_text),
            "no {expected_text} in {screen}"
        );
        assert!(screen.lines().nth(1).unwrap().contains(" dB"), "{screen}");
    }
}

#[test]
fn names_of_sensitivities_are_whole_where_there_is_room() {
    let mut driver = Driver::preset("fig08");
    driver.select("subsystems.S1.mass").keys("r");
    driver
        .typed("a machine with quite a long name")
        .keys("Enter @")
        .typed("10")
        .keys("Enter ~");
    // The name is padded with blanks in its column; the title of the details is in a rule.
    let name = "a machine with quite a long name mass  ";
    let screen = driver.screen(160, 40);
    assert!(screen.contains(name), "no {name} in {screen}");
}
