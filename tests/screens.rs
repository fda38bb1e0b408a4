//! The designer on a screen in memory: what is drawn after some keys, symbols and styles.
#![allow(clippy::expect_used)] // The driver's functions are no tests themselves.

#[path = "screens/driver.rs"]
mod driver;
#[path = "screens/random.rs"]
mod random;

use beamtune::worker::Stage;
use driver::Driver;

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

#[test]
fn help() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("?");
    screen!("help_80x24", driver, 80 x 24);
    screen!("help_120x40", driver, 120 x 40);
}

#[test]
fn presets() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("p Down Down");
    screen!("presets_80x24", driver, 80 x 24);
    screen!("presets_120x40", driver, 120 x 40);
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
    driver.answered(|answer| {
        let columns = &mut answer.result.as_mut().expect("curves").members[0]
            .frf
            .columns;
        columns[0].values[10].re = f64::INFINITY;
        columns[3].values[500].im = f64::NAN;
    });
    let status = status(&mut driver);
    assert!(
        status.contains("no finite answer at 2 frequencies, first 2.996 Hz"),
        "{status}"
    );
}

#[test]
fn a_coarse_curve_says_so() {
    let mut driver = Driver::preset("fig05a");
    driver.answered(|answer| answer.stage = Stage::Coarse);
    let status = status(&mut driver);
    assert!(status.contains("coarse 2,000 x 12, solving"), "{status}");
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

#[test]
fn decibels_over_log_frequency() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("d L");
    screen!("decibels_80x24", driver, 80 x 24);
}

#[test]
fn small() {
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
    for keys in ["", "p", "Esc ?", "Esc Enter", "Esc + q"] {
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
    let mut driver = Driver::preset("fig05a").without_answers_at_all();
    driver.thousand_subsystems();
    driver.keys("End Home Tab Tab PgDn PgDn n N");
    let screen = driver.screen(80, 24);
    assert!(screen.contains("of 10"), "{screen}");
}
