//! Results stay attached to their rows while subsystems, forces and responses are added and deleted.

use beamtune::files::Source;
use beamtune::model::{self, Model};
use beamtune::presets;
use beamtune::tui::tree;

use crate::designer::dice::Dice;
use crate::designer::driver::Driver;

/// Keys that add, delete and change rows, and that show rows of a solved model. Repeated entries are pressed more
/// often.
const KEYS: [&str; 44] = [
    "~",
    "~",
    "~",
    "x",
    "x",
    "D",
    "D",
    "u",
    "u",
    "U",
    "a",
    "R d",
    "e",
    "n",
    "j",
    "k",
    "Tab",
    "Enter",
    "t",
    "f",
    "F",
    "M",
    ")",
    "m",
    "P",
    "O",
    "O",
    "B",
    "@ 1 0 Enter",
    "@ 3 0 Enter",
    "/ S 3 Enter",
    "/ S 2 Enter",
    "/ f o r c e Enter",
    "/ w Enter",
    "/ t i t l e Enter",
    "_",
    "\"",
    "w",
    "b",
    "v",
    "V",
    ">",
    "Esc",
    "Q",
];

/// Keys pressed with each seed.
const PRESSED: usize = 80;

/// A file with a preset of few frequencies; on disk another program has removed a subsystem, or added one.
fn driver(preset: &str, fewer: bool) -> Driver {
    let text = presets::find(preset).expect("a preset").text;
    let mut model = model::read(text).expect("a possible model").into_inner();
    model.sweep.points = 40;
    (model.sweep.from, model.sweep.to) = (1.0, 40.0);
    let text = model::write(&model, text);
    let mut other = Model::clone(&model);
    if fewer {
        other.subsystems.pop();
    } else {
        let mut more = other.subsystems[0].clone();
        "S0".clone_into(&mut more.name);
        other.subsystems.insert(0, more);
    }
    let mut driver = Driver::opened(model, text.clone(), Source::File("beam.toml".into()));
    driver.disk = Some(model::write(&other, &text));
    driver
}

/// Every row of the sensitivities that is in the tree refers to the same parameter there; its owner may have another
/// name.
fn assert_rows_stay(driver: &Driver) {
    let Some(effects) = &driver.app.sensitivities.effects else {
        return;
    };
    let own = |name: &str| name.rsplit(' ').next().map(str::to_owned);
    for row in &effects.rows {
        if let Some(node) = row.node {
            let now = tree::subject(driver.app.model(), node);
            assert_eq!(own(&now), own(&row.name), "{now}, {}", row.name);
        }
    }
}

#[test]
fn sensitivities_keep_the_names_of_the_model_they_are_of() {
    let cases = [
        ("@ 1 0 Enter ~", "/ S 3 Enter x", "S3"),
        ("@ 1 0 Enter ~", "/ S 2 Enter x", "S2"),
        ("D ~", "u", "S4"),
    ];
    for (before, change, gone) in cases {
        let mut driver = Driver::preset("fig08");
        driver.select("subsystems.S1.mass").keys(before);
        // The changed model is not solved yet.
        driver.without_answers().keys(change);
        let screen = driver.screen(120, 40);
        assert!(screen.contains("Sensitivities of"), "{screen}");
        let effects = driver.app.sensitivities.effects.as_ref().expect("effects");
        let of_gone = effects.rows.iter().filter(|row| row.name.starts_with(gone));
        // A subsystem has 14 numbers; all that are not 0 have an effect, which is listed.
        assert!(of_gone.clone().count() > 10, "{gone}");
        assert!(of_gone.into_iter().all(|row| row.node.is_none()), "{gone}");
        assert_rows_stay(&driver);
    }
}

#[test]
fn a_shape_has_its_masses_where_its_own_model_has_them() {
    let mut driver = driver("fig08", true).with_late_answers();
    driver.select("subsystems.S1.mass").keys("M )");
    // The request for the shape waits while the model loses a mass; then its answer comes.
    driver.keys("x");
    (0..3).for_each(|_| driver.answer_next());
    let shape = driver.app.modes.shape.as_ref().expect("a shape");
    assert_eq!((shape.places.len(), shape.masses[0].len()), (3, 3));
    driver.screen(80, 24);
}

fn play(seed: u64) {
    let preset = ["fig08", "fig05a"][seed as usize % 2];
    let mut dice = Dice(seed);
    let mut driver = driver(preset, seed % 4 < 2).with_late_answers();
    for _ in 0..PRESSED {
        driver.keys(dice.pick(&KEYS));
        if dice.roll(2) == 0 {
            driver.answer_next();
        }
        if dice.roll(4) == 0 {
            let (width, height) = [(80, 24), (120, 40)][dice.roll(2)];
            driver.screen(width, height);
        }
        assert_rows_stay(&driver);
    }
}

#[test]
fn late_answers_and_changed_rows_break_nothing() {
    (0..25).for_each(play);
}

#[test]
fn other_late_answers_do_not_either() {
    (25..50).for_each(play);
}
