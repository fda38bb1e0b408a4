//! The sensitivities that the designer shows, against differences of the solver.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use beamtune::model::checked;
use std::sync::atomic::AtomicBool;

use beamtune::model::{Model, edit, path};
use beamtune::solve::band::levels;
use beamtune::solve::modes::modes;
use beamtune::solve::peaks::{peaks, resolved};
use beamtune::solve::sensitivity::{Differentiator, Sensitivity};
use beamtune::solve::{frequencies, sweep};
use beamtune::tui::app::{Effects, Message, Sensed, Table};
use beamtune::tui::tree;

use super::driver::Driver;

/// The derivative of `figure` by the logarithm of a parameter: central differences of fourth order, with a relative
/// error of about 1e-9 at this step.
fn difference(model: &Model, path: &str, figure: impl Fn(&Model) -> f64) -> f64 {
    const STEP: f64 = 2e-4;
    let value = path::number(model, path).unwrap();
    let at = |steps: f64| {
        let mut model = model.clone();
        let changed = edit::Value::Number(value * (steps * STEP).exp());
        edit::set_unchecked(&mut model, path, changed).unwrap();
        figure(&model)
    };
    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * STEP)
}

/// The level of the first response, dB.
fn level(model: &Model, frequency: f64) -> f64 {
    let frf = sweep(&checked(model), &[frequency], &AtomicBool::new(false)).unwrap();
    20.0 * frf.columns[0].values[0].norm().log10()
}

fn effects(driver: &Driver) -> &Effects {
    driver.app.sensitivities.effects.as_ref().unwrap()
}

fn of<'a>(driver: &'a Driver, path: &str) -> &'a Sensitivity {
    let id = path::one(driver.app.model(), path).unwrap();
    &effects(driver)
        .rows
        .iter()
        .find(|row| row.effect.id == id)
        .unwrap()
        .effect
}

fn assert_near(actual: f64, expected: f64, tolerance: f64) {
    assert!(
        (actual - expected).abs() < tolerance,
        "{actual} is not {expected}"
    );
}

/// Parameters of every part of the model.
const SOME: [&str; 6] = [
    "beam.length",
    "beam.material.young_modulus",
    "beam.section.centroid_offset",
    "supports.left.w.stiffness",
    "subsystems.S2.position",
    "subsystems.S3.z_right.damping",
];

#[test]
fn bars_at_the_cursor_are_derivatives_of_the_level() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("63").keys("Enter ~");
    let model = driver.app.model().clone();
    let effects = effects(&driver);
    assert_eq!((effects.sensed, effects.at), (Sensed::Cursor, [63.0; 2]));
    for path in SOME {
        let expected = difference(&model, path, |model| level(model, 63.0));
        assert_near(of(&driver, path).level.unwrap(), expected, 1e-6);
    }
    // By size, the largest first; each parameter of the model that is not 0 has its row.
    let sizes: Vec<f64> = effects
        .rows
        .iter()
        .map(|row| row.effect.level.unwrap().abs())
        .collect();
    assert!(sizes.is_sorted_by(|a, b| a >= b));
    let differentiator = Differentiator::new(&model);
    let numbers = differentiator.values().iter();
    assert_eq!(sizes.len(), numbers.filter(|value| **value != 0.0).count());
}

#[test]
fn a_peak_has_the_derivatives_of_its_height_and_frequency() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("} } } ~");
    let model = driver.app.model().clone();
    let effects = effects(&driver);
    assert_eq!(effects.sensed, Sensed::Peak);
    // The peak that the table of peaks would list, by its index.
    let row = driver.app.tables.peaks.row;
    let peak = |model: &Model| {
        let never = AtomicBool::new(false);
        let modes = modes(&checked(model), model.sweep.to, &never).unwrap();
        let solved = sweep(&checked(model), &frequencies(&model.sweep), &never).unwrap();
        let frf = resolved(&checked(model), &modes, solved, &never).unwrap();
        peaks(&frf.frequencies, &frf.columns[0], &modes)[row]
    };
    for path in SOME {
        // A step moves the peak by many of its widths: the differences are accurate to 1e-4 relative, and no better
        // than the 1e-5 dB accuracy of a height in the table, divided by the step.
        let height = difference(&model, path, |model| 20.0 * peak(model).height.log10());
        let tolerance = 1e-4 * height.abs() + 5e-2;
        assert_near(of(&driver, path).level.unwrap(), height, tolerance);
        let shift = difference(&model, path, |model| peak(model).frequency);
        assert_near(of(&driver, path).frequency.unwrap(), shift, 1e-3);
    }
}

#[test]
fn a_mode_has_the_derivatives_of_its_frequency_and_damping() {
    let mut driver = Driver::preset("fig05a");
    driver.keys(") ) ) ) ~ ~");
    let model = driver.app.model().clone();
    while driver.app.sensitivities.sensed != Some(Sensed::Mode) {
        driver.keys("~");
    }
    let index = driver.app.tables.modes.row;
    let to = model.sweep.to;
    let mode = |model: &Model| {
        modes(&checked(model), to, &AtomicBool::new(false))
            .unwrap()
            .modes[index]
    };
    for path in [
        "beam.material.young_modulus",
        "subsystems.S2.mass",
        "supports.left.w.damping",
    ] {
        let frequency = difference(&model, path, |model| mode(model).frequency());
        assert_near(of(&driver, path).frequency.unwrap(), frequency, 1e-6);
        let damping = difference(&model, path, |model| mode(model).damping_ratio());
        assert_near(of(&driver, path).damping_ratio.unwrap(), damping, 1e-8);
    }
}

#[test]
fn a_band_has_the_derivatives_of_its_mean_square() {
    let mut driver = Driver::preset("fig05a");
    driver
        .keys("@")
        .typed("40")
        .keys("Enter c @")
        .typed("50")
        .keys("Enter _");
    while driver.app.sensitivities.sensed != Some(Sensed::Band) {
        driver.keys("~");
    }
    let model = driver.app.model().clone();
    let mean = |model: &Model| {
        let never = AtomicBool::new(false);
        let modes = modes(&checked(model), model.sweep.to, &never).unwrap();
        let levels = levels(&checked(model), &modes, [40.0, 50.0], &never).unwrap();
        10.0 * levels[0].mean_square.log10()
    };
    for path in SOME {
        // The quadrature is accurate to 1e-8, so its differences are accurate to 1e-8 / 2e-4.
        let expected = difference(&model, path, mean);
        assert_near(of(&driver, path).level.unwrap(), expected, 1e-3);
    }
}

#[test]
fn the_tree_carries_bars_and_the_table_leads_to_the_parameter() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("63").keys("Enter E ~");
    assert_eq!(driver.app.tables.open, Some(Table::Sensitivities));
    let screen = driver.screen(120, 40);
    assert!(
        screen.contains("Sensitivities of P1 w at 63 Hz"),
        "{screen}"
    );
    driver.keys("Home");
    let largest = effects(&driver).rows[0].node.unwrap();
    assert_eq!(driver.app.selection.node(), largest);
    let name = tree::subject(driver.app.model(), largest);
    assert!(driver.screen(120, 40).contains(&name));
    // A nudge in the table changes that parameter; the row stays with it.
    let before = driver.app.model().clone();
    driver.keys("+");
    assert_ne!(*driver.app.model(), before);
    let row = driver.app.tables.sensitivities.row;
    assert_eq!(effects(&driver).rows[row].node, Some(largest));
}

#[test]
fn what_a_nudge_does_is_what_the_bar_said() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("@").typed("63").keys("Enter ~");
    driver.select("subsystems.S2.mass");
    let said = of(&driver, "subsystems.S2.mass").level.unwrap();
    let before = level(driver.app.model(), 63.0);
    // 0.1 % more, so the second order is about a thousandth.
    driver.keys(".");
    let after = level(driver.app.model(), 63.0);
    assert_near(
        after - before,
        said * 1.001_f64.ln(),
        5e-3 * (said * 1e-3).abs(),
    );
}

#[test]
fn without_a_figure_there_is_a_word() {
    let mut driver = Driver::preset("fig05a");
    driver.app.curves.visible.clear();
    driver.app.modes = beamtune::tui::app::ModesState::default();
    driver.keys("~");
    let Some(Message::Refused(text)) = &driver.app.message else {
        panic!("{:?}", driver.app.message);
    };
    assert!(text.contains("sensitivities are of the cursor"), "{text}");
}

#[test]
fn a_key_that_comes_before_the_first_peaks_means_the_one_that_will_be_there() {
    let mut driver = Driver::begun("cantilever");
    driver.keys("~");
    assert_eq!(driver.app.tables.open, Some(Table::Sensitivities));
    assert!(driver.app.sensitivities.effects.is_none());
    driver.answered(|_| ());
    assert_eq!(effects(&driver).sensed, Sensed::Peak);
    let (_, trace) = driver.app.curves.first_resolved().unwrap();
    assert_eq!(effects(&driver).at, [trace.peaks[0].frequency; 2]);
}

#[test]
fn sensitivities_of_a_peak_that_never_comes_say_so() {
    let mut driver = Driver::begun("cantilever");
    driver.keys("~");
    driver.answered(|answer| {
        let curves = answer.result.as_mut().unwrap();
        for member in &mut curves.members {
            member.peaks.iter_mut().for_each(Vec::clear);
        }
    });
    assert!(driver.app.lacks_figure());
    let screen = driver.screen(80, 24);
    assert!(screen.contains("there is no such"), "{screen}");
}
