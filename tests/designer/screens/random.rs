//! Random keys break nothing.

use std::sync::Arc;

use beamtune::model::{self, Checked};
use beamtune::tui::event::Event;
use beamtune::tui::keys::{Key, SECTIONS, Section};
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

use crate::designer::dice::Dice;
use crate::designer::driver::Driver;

/// Keys pressed with each seed.
const KEYS: usize = 10_000;

/// Texts typed into dialogs.
const TYPED: [&str; 15] = [
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
    "s2 mass",
    "undo",
    "",
];

/// Sizes of the screen; the last one is too small, and keys wait.
const SIZES: [(u16, u16); 4] = [(80, 24), (60, 18), (120, 40), (1, 1)];

/// A user who presses keys without looking.
struct Player {
    dice: Dice,
    driver: Driver,
    /// Keys of every scope.
    keys: Vec<Key>,
    /// The last model that was checked.
    checked: Arc<Checked>,
    /// The last input.
    log: Vec<String>,
}

impl Player {
    fn new(seed: u64) -> Self {
        let preset = ["fig05a", "fig08", "fig13", "fig06", "fig07a", "fig16"][seed as usize % 6];
        let driver = Driver::preset(preset).without_answers_at_all();
        let bindings = SECTIONS.iter().flat_map(Section::rows);
        Self {
            dice: Dice(seed),
            checked: driver.app.model().clone(),
            driver,
            keys: bindings.flat_map(|binding| binding.keys).copied().collect(),
            log: vec![format!("seed {seed}, {preset}")],
        }
    }

    /// A key of the table, a text, a digit of a count, or the mouse.
    fn act(&mut self) {
        match self.dice.roll(12) {
            0 | 1 => {
                let text = TYPED[self.dice.roll(TYPED.len())];
                self.log.push(format!("type {text}"));
                self.driver
                    .typed(text)
                    .press(KeyEvent::from(KeyCode::Enter));
            }
            2 => {
                let digit = char::from(b'0' + self.dice.roll(10) as u8);
                self.log.push(digit.to_string());
                self.driver.press(KeyEvent::from(KeyCode::Char(digit)));
            }
            3 => {
                let event = self.mouse();
                self.log.push(format!("{event:?}"));
                self.driver.happen(Event::Mouse(event));
            }
            _ => {
                let key = self.keys[self.dice.roll(self.keys.len())];
                // Undo does not lead from another model back to this one.
                if key.code == KeyCode::Char('p') && self.dice.roll(20) > 0 {
                    return;
                }
                self.log.push(key.name());
                self.driver.press(key.event());
            }
        }
    }

    fn mouse(&mut self) -> MouseEvent {
        use MouseButton::{Left, Right};
        use MouseEventKind::{Down, Drag, ScrollDown, ScrollUp, Up};
        let kinds = [
            Down(Left),
            Down(Left),
            Down(Right),
            Drag(Left),
            Up(Left),
            ScrollUp,
            ScrollDown,
        ];
        MouseEvent {
            kind: kinds[self.dice.roll(kinds.len())],
            column: self.dice.roll(130) as u16,
            row: self.dice.roll(45) as u16,
            modifiers: KeyModifiers::NONE,
        }
    }

    /// The model is valid.
    fn check(&mut self) {
        let model = self.driver.app.model();
        if !Arc::ptr_eq(model, &self.checked) {
            let faults = model::check(model);
            assert!(faults.is_empty(), "{faults:?} after {}", self.said());
            self.checked = model.clone();
        }
    }

    /// Reports the seed and the last input.
    fn said(&self) -> String {
        let last = self.log.len().saturating_sub(40).max(1);
        format!("{}: .. {:?}", self.log[0], &self.log[last..])
    }
}

fn play(seed: u64) {
    let mut player = Player::new(seed);
    for _ in 0..KEYS {
        player.act();
        player.check();
        if player.dice.roll(50) == 0 {
            let (width, height) = SIZES[player.dice.roll(SIZES.len())];
            player.driver.screen(width, height);
        }
    }
    // Keys wait while the screen is too small.
    player.driver.screen(80, 24);
    while player.driver.app.overlay.is_some() {
        player.driver.press(KeyEvent::from(KeyCode::Esc));
    }
    while player.driver.app.document.undo().is_some() {
        player.check();
    }
    let document = &player.driver.app.document;
    assert!(!document.is_changed(), "{}", player.said());
    assert_eq!(document.text(), document.saved_text(), "{}", player.said());
    while player.driver.app.document.redo().is_some() {}
    player.check();
}

#[test]
fn random_keys_leave_a_possible_model_and_a_way_back() {
    (0..10).for_each(play);
}

#[test]
fn other_random_keys_do_too() {
    (10..20).for_each(play);
}
