//! The drawings of the structure and of the cross-section on the designer's screen.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use super::driver::Driver;
use beamtune::tui::options::{Environment, Options};
use beamtune::tui::theme::Theme;

const SIZES: [(u16, u16); 3] = [(60, 18), (80, 24), (120, 40)];

/// The rows of the screen, without the style section.
fn rows(driver: &mut Driver, (width, height): (u16, u16)) -> Vec<String> {
    let screen = driver.screen(width, height);
    let rows = screen.lines().take(usize::from(height));
    rows.map(str::to_owned).collect()
}

fn assert_holds(rows: &[String], words: &str) {
    let found = rows.iter().any(|row| row.contains(words));
    assert!(found, "no {words} in\n{}", rows.join("\n"));
}

#[test]
fn the_drawings_follow_each_other_and_go() {
    for size in SIZES {
        let mut driver = Driver::preset("fig05a");
        driver.select("subsystems.S2.mass");
        let without = rows(&mut driver, size);
        driver.keys("B");
        let structure = rows(&mut driver, size);
        assert_holds(&structure, "─ Structure ─");
        assert_holds(&structure, "S2 at 1.6 m, 100 kg");
        assert_holds(&structure, ">S2");
        driver.keys("B");
        let section = rows(&mut driver, size);
        assert_holds(&section, "─ Section at S2 ─");
        assert_holds(&section, "z_c 61.9 mm");
        assert_holds(&section, "+S");
        driver.keys("B");
        assert_eq!(rows(&mut driver, size), without);
    }
}

#[test]
fn the_drawings_follow_the_selection_and_the_model() {
    let mut driver = Driver::preset("fig05a");
    driver.select("subsystems.S3.position").keys("B");
    assert_holds(&rows(&mut driver, (80, 24)), "S3 at 2.4 m, 100 kg");
    driver.keys("Enter").typed("2.8").keys("Enter");
    assert_holds(&rows(&mut driver, (80, 24)), "S3 at 2.8 m, 100 kg");
    driver.select("forces.2.amplitude");
    assert_holds(&rows(&mut driver, (80, 24)), "force 2: psi at left, 1 N m");
    driver.select("supports.right.w.stiffness");
    assert_holds(&rows(&mut driver, (80, 24)), "right end: w v sprung");
    driver.select("beam.section.centroid_offset").keys("B");
    driver.keys("Enter").typed("-40 mm").keys("Enter");
    assert_holds(&rows(&mut driver, (80, 24)), "z_c -40 mm");
}

#[test]
fn the_drawings_are_ascii_where_that_is_asked_for() {
    let options = Options {
        ascii: Some(true),
        ..Options::default()
    };
    for size in SIZES {
        for (keys, holds) in [("B", "- Structure -"), ("B B", "- Section at S1 -")] {
            let mut driver = Driver::preset("fig05a");
            driver.keys(keys);
            driver.app.theme = Theme::resolve(options, &Environment::default());
            let rows = rows(&mut driver, size);
            assert!(rows.iter().all(|row| row.is_ascii()), "{rows:#?}");
            assert_holds(&rows, holds);
        }
    }
}

#[test]
fn a_thousand_subsystems_are_drawn() {
    let mut driver = Driver::thousand();
    driver.keys("B");
    for size in SIZES {
        assert_holds(&rows(&mut driver, size), "1,000 masses");
    }
    driver.select("subsystems.S700.mass");
    for size in SIZES {
        assert_holds(&rows(&mut driver, size), ">S700");
    }
}
