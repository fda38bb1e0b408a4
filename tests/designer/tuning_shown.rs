//! Tuning in the designer, by keys.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use beamtune::model::checked;
use std::sync::atomic::AtomicBool;

use beamtune::model::{Aim, Combine, Limit, Model, Spacing, path};
use beamtune::solve::band::levels;
use beamtune::solve::modes::modes;
use beamtune::tui::app::{Effect, Message, Overlay, Progress, Table};
use beamtune::tui::event::Event;
use beamtune::worker::Request;

use super::driver::Driver;

/// The highest magnitude of the first response in the band of the cantilever's objective.
fn peak(model: &Model) -> f64 {
    let never = AtomicBool::new(false);
    let modes = modes(&checked(model), model.sweep.to, &never).unwrap();
    levels(&checked(model), &modes, [15.0, 60.0], &never).unwrap()[0].maximum
}

fn refusal(driver: &Driver) -> String {
    match (&driver.app.overlay, &driver.app.message) {
        (Some(Overlay::Prompt(prompt)), _) => prompt.refusal.clone().unwrap_or_default(),
        (_, Some(Message::Refused(text))) => text.clone(),
        (_, message) => panic!("{message:?}"),
    }
}

fn names_of_references(driver: &Driver) -> Vec<&str> {
    let references = driver.app.comparison.references.iter();
    references.map(|one| one.name.as_str()).collect()
}

#[test]
fn a_search_is_taken_as_one_step() {
    let mut driver = Driver::preset("cantilever");
    let before = driver.app.model().clone();
    driver.keys("1 5 0 Ctrl-g");
    let run = driver.app.tuning.run.as_ref().unwrap();
    let Progress::Found(tuned) = &run.progress else {
        panic!("{:?}", run.progress);
    };
    assert!(tuned.evaluations <= 150, "{}", tuned.evaluations);
    // The levels of the band are computed from the modes, not by the search.
    let (start, found) = (peak(&before), peak(&tuned.model));
    assert!((tuned.before[0].figure / start - 1.0).abs() < 1e-6);
    assert!((tuned.after[0].figure / found - 1.0).abs() < 1e-6);
    assert!(found < 0.5 * start, "{found} of {start}");
    let model = tuned.model.clone();
    // Meanwhile the best result is drawn next to the model.
    assert_eq!(driver.app.tables.open, Some(Table::Tuning));
    assert_eq!(names_of_references(&driver), ["best so far"]);
    assert_eq!(*driver.app.model(), before);
    let screen = driver.screen(100, 30);
    assert!(screen.contains("Tuned: "), "{screen}");
    driver.keys("Ctrl-y");
    assert_eq!(**driver.app.model(), model);
    assert!(names_of_references(&driver).is_empty());
    assert!(driver.app.tuning.run.is_none());
    driver.keys("u");
    assert_eq!(*driver.app.model(), before);
    driver.keys("U");
    assert_eq!(**driver.app.model(), model);
}

#[test]
fn a_search_that_is_dropped_leaves_nothing() {
    let mut driver = Driver::preset("cantilever");
    let before = driver.app.model().clone();
    driver.keys("4 0 Ctrl-g Ctrl-x");
    assert_eq!(*driver.app.model(), before);
    assert!(!driver.app.document.is_changed());
    assert!(names_of_references(&driver).is_empty());
    assert_eq!(driver.app.tables.open, None);
    driver.keys("Ctrl-x");
    assert_eq!(refusal(&driver), "there is no search");
}

#[test]
fn what_is_taken_leaves_other_changes_alone() {
    let mut driver = Driver::preset("cantilever");
    driver.keys("4 0 Ctrl-g");
    driver.select("beam.material.density").keys("+");
    let density = path::number(driver.app.model(), "beam.material.density").unwrap();
    driver.keys("Ctrl-y");
    let model = driver.app.model();
    assert_eq!(
        path::number(model, "beam.material.density").unwrap(),
        density
    );
    assert_ne!(
        path::number(model, "subsystems.Damper.y_left.stiffness").unwrap(),
        1.4e5
    );
}

#[test]
fn a_search_is_held_up_and_ended() {
    let mut driver = Driver::preset("cantilever").without_answers_at_all();
    let solved = |effects: &[Effect], wanted: fn(&Request) -> bool| {
        let mut requests = effects.iter();
        requests.any(|effect| matches!(effect, Effect::Solve(request) if wanted(request)))
    };
    let key = |name: &str| {
        let key = beamtune::tui::keys::Key::parse(name).unwrap();
        Event::Key(key.event())
    };
    let effects = driver.app.update(key("Ctrl-g"));
    assert!(solved(&effects, |one| matches!(one, Request::Tune(_))));
    driver.app.update(key("Ctrl-g"));
    let progress =
        |driver: &Driver| format!("{:?}", driver.app.tuning.run.as_ref().unwrap().progress);
    assert_eq!(progress(&driver), "Paused");
    driver.app.update(key("Ctrl-g"));
    assert_eq!(progress(&driver), "Searching");
    driver.app.update(key("Ctrl-y"));
    assert_eq!(refusal(&driver), "the search has no result yet");
    let effects = driver.app.update(key("Ctrl-x"));
    assert!(solved(&effects, |one| matches!(one, Request::EndTuning)));
}

#[test]
fn variables_are_chosen_in_the_tree() {
    let mut driver = Driver::preset("fig05a");
    driver.keys("Ctrl-g");
    assert!(refusal(&driver).contains("no variables yet"));
    driver.select("subsystems.S1.mass").keys("$ Enter");
    let tune = driver.app.model().tune.clone().unwrap();
    let variable = &tune.variables[0];
    // A tenth and ten times the preset's 100 kg.
    assert_eq!(variable.paths, ["subsystems.S1.mass"]);
    assert_eq!((variable.min, variable.max), (10.0, 1000.0));
    assert_eq!(tune.objectives[0].aim, Aim::Peak);
    assert_eq!(tune.objectives[0].response.as_deref(), Some("P1 w"));
    assert!(driver.app.tuning.moving.has(driver.app.selection.node()));
    driver
        .select("subsystems.S2.position")
        .keys("$")
        .typed("0.5 .. 2.5 m +-2 % linear");
    driver.keys("Enter");
    let tune = driver.app.model().tune.clone().unwrap();
    assert_eq!((tune.variables[1].min, tune.variables[1].max), (0.5, 2.5));
    assert_eq!(tune.variables[1].tolerance, 2.0);
    assert_eq!(tune.variables[1].scale, Some(Spacing::Linear));
    // Again: it is fixed; without variables there is nothing to tune.
    driver.keys("$");
    assert_eq!(driver.app.model().tune.as_ref().unwrap().variables.len(), 1);
    driver.select("subsystems.S1.mass").keys("$");
    assert_eq!(driver.app.model().tune, None);
    driver.keys("u");
    assert_eq!(driver.app.model().tune.as_ref().unwrap().variables.len(), 1);
}

#[test]
fn bounds_that_make_no_model_are_refused() {
    let mut driver = Driver::preset("fig05a");
    for (text, word) in [
        ("", "type bounds"),
        ("1 .. x", "type bounds"),
        ("5 .. 1", "below max"),
        ("-5 .. 1", "impossible"),
        ("1 .. 5 +-200 %", "tolerance"),
    ] {
        driver
            .select("subsystems.S1.mass")
            .keys("$")
            .typed(text)
            .keys("Enter");
        assert!(
            refusal(&driver).contains(word),
            "{text}: {}",
            refusal(&driver)
        );
        driver.keys("Esc");
        assert_eq!(driver.app.model().tune, None);
    }
    driver.select("title").keys("$");
    assert!(refusal(&driver).contains("select a number"));
}

#[test]
fn a_match_is_read_where_it_is_typed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run 7.txt");
    std::fs::write(&path, "1 20 1e-6 -1e-7\n2 30 2e-6 -2e-7\n").unwrap();
    let path = path.display();
    let mut driver = Driver::preset("cantilever");
    let before = driver.app.model().tune.clone();
    driver.keys("^");
    for (answer, word) in [
        ("", "an answer would be accepted, as columns = \"hz;"),
        ("", "1 | 20 | 1e-6 | -1e-7"),
        (" columns hz; re im; m/N", "hz 1; re 2; im 3"),
        (" columns hz 2; re 3; im 7; m/N", "the table has 4 columns"),
        (" columns hz 2; re 3; im 4; furlong", "m/s2/N"),
        (
            " columns hz 2; re 3; im 4; rad/(N m)",
            "does not match the response",
        ),
    ] {
        driver.typed(&format!("match {path}{answer}")).keys("Enter");
        assert!(
            refusal(&driver).contains(word),
            "{answer}: {}",
            refusal(&driver)
        );
        assert_eq!(driver.app.model().tune, before);
    }
    driver.typed("match none.csv").keys("Enter");
    assert!(
        refusal(&driver).contains("none.csv: cannot be read"),
        "{}",
        refusal(&driver)
    );
    driver
        .typed(&format!("+ match {path} columns hz 2; re 3; im 4; m/N x 2"))
        .keys("Enter");
    assert!(driver.app.overlay.is_none(), "{}", refusal(&driver));
    let tune = driver.app.model().tune.clone().unwrap();
    let last = tune.objectives.last().unwrap();
    assert_eq!((tune.objectives.len(), last.weight), (2, 2.0));
    assert!(
        matches!(&last.aim, Aim::Match { columns: Some(columns), .. } if columns == "hz 2; re 3; im 4; m/N"),
        "{last:?}"
    );
}

#[test]
fn the_objective_is_a_figure_of_the_marked_band() {
    let mut driver = Driver::preset("cantilever");
    driver
        .keys("@")
        .typed("20")
        .keys("Enter c @")
        .typed("40")
        .keys("Enter _ ^");
    driver.typed("mean square").keys("Enter");
    let tune = |driver: &Driver| driver.app.model().tune.clone().unwrap();
    let objective = tune(&driver).objectives[0].clone();
    assert_eq!((objective.from, objective.to), (20.0, 40.0));
    assert_eq!(objective.aim, Aim::MeanSquare);
    assert_eq!(objective.response.as_deref(), Some("tip w"));
    driver
        .keys("^")
        .typed("+ energy x 2")
        .keys("Enter ^")
        .typed("worst")
        .keys("Enter");
    assert_eq!(tune(&driver).objectives.len(), 2);
    assert_eq!(tune(&driver).objectives[1].weight, 2.0);
    assert_eq!(tune(&driver).combine, Combine::Worst);
    driver.keys("^").typed("limit mass 5 kg").keys("Enter");
    assert_eq!(tune(&driver).limits, [Limit::AddedMass { at_most: 5.0 }]);
    driver.keys("^").typed("anti-resonance 90").keys("Enter");
    assert!(refusal(&driver).contains("90"), "{}", refusal(&driver));
    driver.typed("nonsense").keys("Enter");
    assert!(refusal(&driver).contains("peak, mean square"));
    driver.keys("Esc ^").typed("no limits").keys("Enter");
    assert!(tune(&driver).limits.is_empty());
}

#[test]
fn tolerances_make_a_band_around_the_curve() {
    let mut driver = Driver::preset("cantilever");
    driver.keys("Ctrl-k");
    assert!(refusal(&driver).contains("no variable of [tune] has a tolerance"));
    driver
        .select("subsystems.Damper.mass")
        .keys("$")
        .typed("1 .. 10 kg +-10 %")
        .keys("Enter Ctrl-k");
    let scene = driver.app.scene();
    let labels: Vec<&str> = scene
        .curves
        .iter()
        .map(|curve| curve.label.as_str())
        .collect();
    assert_eq!(labels, ["5, 50, 95 %", "", "", "tip w"]);
    // Quantiles are ordered at every frequency, and separate where the damper has an effect.
    let [low, median, high] = [0, 1, 2].map(|index| &scene.curves[index].values[0]);
    for index in 0..low.len() {
        assert!(low[index] <= median[index] && median[index] <= high[index]);
    }
    let spread = low.iter().zip(high).map(|(low, high)| high / low);
    assert!(spread.fold(0.0, f64::max) > 1.2);
    driver.keys("Ctrl-k");
    assert_eq!(driver.app.scene().curves.len(), 1);
}
