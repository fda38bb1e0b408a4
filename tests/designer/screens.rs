//! The designer on a screen in memory after some keys: symbols and styles.
#![allow(clippy::expect_used)] // The driver's functions are not tests themselves.

#[path = "screens/changed.rs"]
mod changed;
#[path = "screens/random.rs"]
mod random;

use std::sync::Arc;
use std::time::Duration;

use super::driver::Driver;
use beamtune::files::Source;
use beamtune::model::{Model, Restraint, Unit};
use beamtune::solve::euler_bernoulli_up_to;
use beamtune::solve::modes::{Completeness, Gap};
use beamtune::tui::app::{ExternalChange, Lost, Reply};
use beamtune::worker::Stage;

/// A snapshot of the screen after some keys.
macro_rules! screen {
    ($name:literal, $driver:expr, $width:literal x $height:literal) => {
        insta::assert_snapshot!($name, $driver.screen($width, $height));
    };
}

#[test]
fn start() {
    screen!("start_80x24", Driver::preset("fig05a"), 80 x 24);
    screen!("start_120x40", Driver::preset("fig05a"), 120 x 40);
}

#[test]
fn study() {
    let mut driver = Driver::preset("fig08");
    driver.keys("t");
    screen!("study_80x24", driver, 80 x 24);
    screen!("study_120x40", driver, 120 x 40);
}

#[test]
fn after_edit() {
    let edited = || {
        let mut driver = Driver::preset("fig08");
        driver
            .select("subsystems.S1.y_left.stiffness")
            .keys("f Enter")
            .typed("40 MN/m")
            .keys("Enter");
        driver
    };
    screen!("after_edit_80x24", edited(), 80 x 24);
    screen!("after_edit_120x40", edited(), 120 x 40);
}

/// A beam with its second cursor and cursor at the given frequencies.
fn read_at(preset: &str, frequencies: [&str; 2]) -> Driver {
    let mut driver = Driver::preset(preset);
    let [second, first] = frequencies;
    driver.keys("@").typed(second).keys("Enter c");
    driver.keys("@").typed(first).keys("Enter");
    driver
}

#[test]
fn views() {
    for (name, keys) in [
        ("phase", "b"),
        ("phase_unwrapped", "b '"),
        ("real_imaginary", "b b"),
        ("nyquist", "b b b"),
        ("difference", "f Tab > > > b b b b"),
        ("dynamic_stiffness", "i i i i"),
        ("rpm", "# # d"),
    ] {
        let mut driver = Driver::preset("cantilever");
        driver.keys("@").typed("18 Hz").keys("Enter").keys(keys);
        let small = format!("view_{name}_80x24");
        insta::assert_snapshot!(small, driver.screen(80, 24));
        let large = format!("view_{name}_120x40");
        insta::assert_snapshot!(large, driver.screen(120, 40));
    }
}

#[test]
fn readings() {
    let mut driver = read_at("cantilever", ["20", "25"]);
    driver.keys("f H \"");
    screen!("readings_80x24", driver, 80 x 24);
    screen!("readings_120x40", driver, 120 x 40);
    driver.keys("_");
    screen!("band_80x24", driver, 80 x 24);
    screen!("band_120x40", driver, 120 x 40);
}

#[test]
fn zoomed_in() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("100").keys("Enter 6 z");
    driver.screen(120, 40);
    driver.keys("z ! *");
    screen!("zoomed_in_80x24", driver, 80 x 24);
    screen!("zoomed_in_120x40", driver, 120 x 40);
}

#[test]
fn looks_at_the_beam() {
    for (name, keys) in [
        ("deflection", "O"),
        ("moments", "O O"),
        ("shear", "O O O"),
        ("torque", "O O O O"),
        ("bimoment", "O O O O O"),
        ("power", "O O O O O O"),
        ("structure", "B"),
        ("section", "B B"),
    ] {
        let mut driver = Driver::preset("fig05a");
        driver.select("subsystems.S2.mass");
        driver.keys("@").typed("31.5 Hz").keys("Enter").keys(keys);
        let small = format!("look_{name}_80x24");
        insta::assert_snapshot!(small, driver.screen(80, 24));
        let large = format!("look_{name}_120x40");
        insta::assert_snapshot!(large, driver.screen(120, 40));
    }
}

#[test]
fn beside_the_model() {
    let mut driver = Driver::preset("cantilever");
    driver.keys("Q");
    screen!("beside_nothing_80x24", driver, 80 x 24);
    driver.keys("Esc f Tab > > f > Q Down Enter");
    screen!("beside_80x24", driver, 80 x 24);
    screen!("beside_120x40", driver, 120 x 40);
    driver.keys("r");
    screen!("beside_name_80x24", driver, 80 x 24);
    driver.keys("Esc Ctrl-t");
    screen!("factors_80x24", driver, 80 x 24);
    driver.keys("Esc Ctrl-e");
    screen!("export_80x24", driver, 80 x 24);
}

#[test]
fn help() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("?");
    screen!("help_80x24", driver, 80 x 24);
    screen!("help_120x40", driver, 120 x 40);
}

#[test]
fn the_guide_is_opened_from_the_palette() {
    let mut driver = Driver::preset("fig05a");
    driver.keys(":").typed("guide").keys("Enter");
    screen!("guide_80x24", driver, 80 x 24);
    driver.typed("toler").keys("Enter");
    screen!("guide_tuning_120x40", driver, 120 x 40);
    driver.keys("q");
    assert!(driver.app.overlay.is_none());
}

#[test]
fn presets() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("p Down Down");
    screen!("presets_80x24", driver, 80 x 24);
    screen!("presets_120x40", driver, 120 x 40);
}

#[test]
fn palette() {
    let mut driver = Driver::preset("fig05a");
    driver.keys(":").typed("mode");
    screen!("palette_80x24", driver, 80 x 24);
    driver.typed("s2 mass");
    screen!("palette_parameter_120x40", driver, 120 x 40);
    driver.typed("no such thing").keys("Down");
    screen!("palette_in_vain_60x18", driver, 60 x 18);
}

#[test]
fn search() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("/").typed("stiff");
    screen!("search_80x24", driver, 80 x 24);
    driver.keys("Down Down Enter");
    screen!("searched_120x40", driver, 120 x 40);
}

#[test]
fn a_count_is_shown() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("1 0");
    let screen = driver.screen(80, 24);
    let last = screen.lines().nth(23).unwrap_or_default();
    assert!(
        last.starts_with("| 10 times the next key; Esc cancels"),
        "{last}"
    );
}

#[test]
fn recovery() {
    let found = || {
        let mut driver = Driver::preset("fig05a");
        let lost = |name: &str, seconds| Lost {
            name: name.to_owned(),
            age: Duration::from_secs(seconds),
        };
        driver.app.offer(vec![
            lost("/home/ada/rig/three absorbers.toml", 125),
            lost("fig08", 200_000),
        ]);
        driver
    };
    screen!("recovery_80x24", found(), 80 x 24);
    screen!("recovery_120x40", found(), 120 x 40);
    let many = (0..40).map(|i| Lost {
        name: format!("{i}"),
        age: Duration::ZERO,
    });
    let mut driver = Driver::preset("fig05a");
    driver.app.offer(many.collect());
    driver.keys(&"Down ".repeat(39));
    let screen = driver.screen(60, 18);
    assert!(screen.contains("Unsaved changes  40 of 40"), "{screen}");
    assert!(screen.contains("discard"), "{screen}");
}

#[test]
fn zoomed() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("} } } z z z");
    screen!("zoomed_80x24", driver, 80 x 24);
    screen!("zoomed_120x40", driver, 120 x 40);
}

#[test]
fn a_file_that_another_program_changed_is_marked() {
    let mut driver = Driver::preset("fig05a");
    driver.app.reply(Reply::Compared(ExternalChange::Changed));
    assert!(status(&mut driver).contains("· changed on disk"));
    driver.select("beam.length").keys("+");
    assert!(status(&mut driver).contains("· changed, also on disk"));
    driver.app.reply(Reply::Compared(ExternalChange::Gone));
    assert!(status(&mut driver).contains("· missing on disk"));
}

#[test]
fn refused_value() {
    let mut driver = Driver::preset("fig05a");
    driver
        .select("subsystems.S2.mass")
        .keys("Enter")
        .typed("-3 kg")
        .keys("Enter");
    screen!("refused_80x24", driver, 80 x 24);
    screen!("refused_120x40", driver, 120 x 40);
}

#[test]
fn stale_curves() {
    let mut driver = Driver::preset("fig05a");
    driver.select("beam.length").without_answers().keys("+");
    screen!("stale_80x24", driver, 80 x 24);
}

/// The first line of the screen.
fn status(driver: &mut Driver) -> String {
    driver
        .screen(100, 30)
        .lines()
        .next()
        .unwrap_or_default()
        .to_owned()
}

#[test]
fn what_is_not_finite_is_said() {
    let mut driver = Driver::preset("fig05a");
    let mut first = 0.0;
    driver.answered(|answer| {
        let member = &mut answer.result.as_mut().expect("curves").members[0];
        let columns = &mut member.frf.columns;
        columns[0].values[10].re = f64::INFINITY;
        columns[3].values[500].im = f64::NAN;
        first = member.frf.frequencies[10];
    });
    let status = status(&mut driver);
    let first = Unit::HERTZ.format(first);
    let expected = format!("no finite answer at 2 frequencies, first {first}");
    assert!(status.contains(&expected), "{status}");
}

#[test]
fn a_coarse_curve_says_so() {
    let mut driver = Driver::preset("fig05a");
    driver.answered(|answer| answer.stage = Stage::Coarse);
    let status = status(&mut driver);
    assert!(status.contains("coarse "), "{status}");
    assert!(status.contains(" x 12, solving"), "{status}");
}

#[test]
fn a_failure_says_why_and_keeps_the_curves() {
    let mut driver = Driver::preset("fig05a");
    driver.select("beam.length").without_answers().keys("+");
    driver.answered(|answer| answer.result = Err("the solver stopped".to_owned()));
    let status = status(&mut driver);
    assert!(
        status.contains("not solved: the solver stopped"),
        "{status}"
    );
    assert!(driver.app.curves.is_stale());
}

#[test]
fn questions() {
    let mut driver = Driver::preset("fig05a");
    driver.select("beam.length").keys("+ q");
    screen!("unsaved_80x24", driver, 80 x 24);
}

#[test]
fn without_colours() {
    let mut driver = Driver::preset("fig08");
    driver
        .select("responses.1.measure")
        .keys("t")
        .without_colours();
    screen!("no_color_80x24", driver, 80 x 24);
}

/// Expected: [`euler_bernoulli_up_to`] is 545 Hz for the paper's beam, within the 1 to 800 Hz of `fig14` and beyond the
/// 400 Hz of the other figures.
#[test]
fn the_limit_of_euler_and_bernoulli_is_on_the_axis() {
    let model = || Driver::preset("fig14");
    let limit = euler_bernoulli_up_to(model().app.model()).unwrap();
    assert!((limit - 545.0).abs() < 0.5, "{limit}");
    screen!("limit_80x24", model(), 80 x 24);
    screen!("limit_120x40", model(), 120 x 40);
    let mut plain = model();
    screen!("limit_no_color_80x24", plain.without_colours(), 80 x 24);
    let has_mark = |driver: &mut Driver| driver.screen(80, 24).contains('╫');
    // In rad/s, and over another panel, it is at the same frequency.
    assert!(has_mark(model().keys("#")));
    assert!(has_mark(model().keys("b")));
    // A part of the axis without it, another theory, and a sweep that ends below it have none.
    let mut zoomed = model();
    zoomed.keys("@").typed("200").keys("Enter z");
    assert!(!has_mark(&mut zoomed));
    let mut thick = model();
    thick.select("beam.theory").keys("Space");
    assert!(!has_mark(&mut thick));
    assert!(!has_mark(&mut Driver::preset("fig05a")));
}

#[test]
fn decibels_over_log_frequency() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("d L");
    screen!("decibels_80x24", driver, 80 x 24);
}

#[test]
fn modes() {
    let chosen = || {
        let mut driver = Driver::preset("fig05a");
        driver.keys("m Down Down Down");
        driver
    };
    screen!("modes_80x24", chosen(), 80 x 24);
    screen!("modes_120x40", chosen(), 120 x 40);
}

/// The modes of a preset with an incomplete or a pending list.
fn in_doubt(completeness: &Completeness) -> Driver {
    let mut driver = Driver::preset("fig05a");
    driver.keys("m Down Down Down").answered(|answer| {
        answer.stage = match completeness {
            Completeness::Uncounted => Stage::Resolved,
            _ => Stage::Counted,
        };
        let curves = answer.result.as_mut().expect("curves");
        let modal = curves.modes.as_mut().expect("modes");
        Arc::make_mut(&mut modal.modes).completeness = completeness.clone();
    });
    driver
}

#[test]
fn modes_that_are_not_counted_yet() {
    let mut driver = in_doubt(&Completeness::Uncounted);
    screen!("modes_uncounted_80x24", driver, 80 x 24);
    screen!("modes_uncounted_120x40", driver, 120 x 40);
}

#[test]
fn modes_with_open_ranges() {
    let gap = |from, to, found, counted| Gap {
        from,
        to,
        found,
        counted,
    };
    let one = vec![gap(34.5, 35.0, 2, Some(3))];
    let several = vec![
        one[0],
        gap(61.25, 70.5, 4, None),
        gap(390.0, 400.0, 1, Some(2)),
    ];
    let mut driver = in_doubt(&Completeness::Open(one));
    screen!("modes_open_80x24", driver, 80 x 24);
    let mut driver = in_doubt(&Completeness::Open(several));
    screen!("modes_open_at_several_80x24", driver, 80 x 24);
    screen!("modes_open_at_several_120x40", driver, 120 x 40);
    screen!("peaks_in_doubt_80x24", driver.keys("P"), 80 x 24);
}

#[test]
fn peaks() {
    let chosen = || {
        let mut driver = Driver::preset("fig05a");
        driver.keys("P Down Down");
        driver
    };
    screen!("peaks_80x24", chosen(), 80 x 24);
    screen!("peaks_120x40", chosen(), 120 x 40);
    screen!("peaks_in_decibels_80x24", chosen().keys("d"), 80 x 24);
    let mut study = Driver::preset("fig08");
    study.keys("t P");
    screen!("peaks_of_a_study_80x24", study, 80 x 24);
}

#[test]
fn shapes() {
    let shown = || {
        let mut driver = Driver::preset("fig05a");
        driver.keys(") ) ) ) ) ) M");
        driver
    };
    screen!("shape_80x24", shown(), 80 x 24);
    screen!("shape_120x40", shown().keys("m"), 120 x 40);
}

#[test]
fn a_shape_moves_and_stands_still_again() {
    let mut driver = Driver::preset("fig05a");
    driver.keys(") ) ) M");
    let still = driver.screen(80, 24);
    driver.keys("A");
    let mut frames = vec![driver.screen(80, 24)];
    for _ in 0..24 {
        frames.push(driver.tick().screen(80, 24));
    }
    assert_ne!(frames[0], frames[6]);
    // After a period it is back at the start.
    assert_eq!(frames[0], frames[24]);
    driver.keys("A");
    assert_eq!(driver.screen(80, 24), still);
    assert!(!driver.app.moves());
}

/// A model without any damping.
fn undamped(name: &str) -> Driver {
    let mut model = Model::clone(Driver::preset(name).app.model());
    model.beam.material.loss_factor = 0.0;
    for end in [&mut model.supports.left, &mut model.supports.right] {
        for restraint in &mut end.restraints {
            if let Restraint::Elastic(elastic) = restraint {
                elastic.spring.damping = 0.0;
            }
        }
    }
    Driver::opened(model, String::new(), Source::Stdin)
}

#[test]
fn poles_are_drawn_and_called_so() {
    let mut driver = undamped("fig06");
    driver.keys("P");
    screen!("poles_80x24", driver, 80 x 24);
}

#[test]
fn finite_elements_are_drawn_over_the_curve() {
    let mut driver = Driver::preset("fig06");
    driver.keys("w m");
    screen!("finite_elements_80x24", driver, 80 x 24);
}

#[test]
fn a_mode_that_was_won_is_said() {
    let mut driver = Driver::preset("fig06");
    let before = driver.app.modes.list.as_ref().map(|list| list.rows.len());
    driver.select("beam.length");
    // A longer beam has more modes below 400 Hz.
    while driver.app.modes.list.as_ref().map(|list| list.rows.len()) == before {
        driver.keys("+");
    }
    let status = status(&mut driver);
    assert!(status.contains(" modes, one more than before"), "{status}");
}

#[test]
fn small() {
    screen!("small_modes_60x18", Driver::preset("fig08").keys("m End Up"), 60 x 18);
    screen!("small_shape_60x18", Driver::preset("fig08").keys("M ) ) )"), 60 x 18);

    screen!("small_60x18", Driver::preset("fig08"), 60 x 18);
    screen!("too_small_59x17", Driver::preset("fig08"), 59 x 17);
}

#[test]
fn keys_wait_while_the_screen_is_too_small() {
    let mut driver = Driver::preset("fig08");
    driver.screen(40, 10);
    driver.keys("D x D > +");
    assert!(!driver.app.document.is_changed());
    driver.screen(80, 24);
    driver.keys("j >");
    assert!(driver.app.document.is_changed());
}

#[test]
fn any_size_is_drawn() {
    let mut driver = Driver::preset("fig05a");
    for keys in ["", "M m", "P", "Esc p", "Esc ?", "Esc Enter", "Esc + q"] {
        driver.keys(keys);
        for (width, height) in [
            (1, 1),
            (2, 1),
            (1, 30),
            (60, 18),
            (61, 19),
            (75, 24),
            (76, 19),
            (300, 18),
            (200, 90),
        ] {
            driver.screen(width, height);
        }
    }
}

#[test]
fn a_thousand_subsystems_are_drawn() {
    let mut driver = Driver::thousand();
    driver.keys("End Home Tab Tab PgDn PgDn n N");
    let screen = driver.screen(80, 24);
    assert!(screen.contains("of 10"), "{screen}");
}
