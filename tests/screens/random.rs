//! Whoever presses keys at random breaks nothing.

use beamtune::model;
use beamtune::tui::keys::SECTIONS;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::driver::Driver;

/// A small generator of numbers (Knuth's MMIX constants): the same sequence everywhere.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % sides
    }
}

/// What is typed into boxes.
const TYPED: [&str; 12] = [
    "4e7",
    "*1.1",
    "/2",
    "+5%",
    "-1",
    "0",
    "1.6",
    "left",
    "S1",
    "new name",
    "S.1 \"x\"",
    "nonsense",
];

fn play(seed: u64, preset: &str) {
    let mut dice = Dice(seed);
    let mut driver = Driver::preset(preset).without_answers_at_all();
    let bindings: Vec<_> = SECTIONS
        .iter()
        .flat_map(|section| section.bindings)
        .collect();
    let mut log = Vec::new();
    for _ in 0..400 {
        if dice.roll(6) == 0 {
            let text = TYPED[dice.roll(TYPED.len())];
            log.push(format!("type {text}"));
            driver.typed(text).press(KeyEvent::from(KeyCode::Enter));
        } else {
            let keys = bindings[dice.roll(bindings.len())].keys;
            let key = keys[dice.roll(keys.len())];
            log.push(key.name());
            let modifiers = if key.control {
                KeyModifiers::CONTROL
            } else {
                KeyModifiers::NONE
            };
            driver.press(KeyEvent::new(key.code, modifiers));
        }
        let faults = model::check(driver.app.model());
        assert!(faults.is_empty(), "seed {seed}: {faults:?} after {log:?}");
        if dice.roll(20) == 0 {
            let (width, height) = [(80, 24), (60, 18), (120, 40), (1, 1)][dice.roll(4)];
            driver.screen(width, height);
        }
    }
    // Keys wait while the screen is too small.
    driver.screen(80, 24);
    while driver.app.overlay.is_some() {
        driver.press(KeyEvent::from(KeyCode::Esc));
    }
    while driver.app.document.undo().is_some() {
        let faults = model::check(driver.app.model());
        assert!(
            faults.is_empty(),
            "seed {seed}: {faults:?} in undo after {log:?}"
        );
    }
    assert!(
        !driver.app.document.is_changed(),
        "seed {seed} after {log:?}"
    );
    assert_eq!(
        driver.app.document.text(),
        driver.app.document.saved_text(),
        "seed {seed}"
    );
    while driver.app.document.redo().is_some() {}
    assert!(model::check(driver.app.model()).is_empty(), "seed {seed}");
}

#[test]
fn random_keys_leave_a_possible_model_and_a_way_back() {
    for seed in 0..40 {
        play(
            seed,
            ["fig05a", "fig08", "fig13", "fig06", "fig07a", "fig16"][seed as usize % 6],
        );
    }
}
