//! Models whose names and titles contain characters that would control a terminal.

use beamtune::presets;

use super::dice::Dice;
use super::hidden::{HIDDEN, in_toml};

/// Letters with hidden characters between them; without controls if used as a name.
pub fn hostile(dice: &mut Dice, controls: &[char]) -> String {
    let mut text = String::from("x");
    for _ in 0..6 {
        let all = HIDDEN.len() + controls.len();
        let index = dice.roll(all);
        text.push(*HIDDEN.iter().chain(controls).nth(index).unwrap());
        text.push(char::from(b'a' + dice.roll(26) as u8));
    }
    text
}

/// The cantilever with other names, controls in its title, and tolerances.
pub fn hostile_model(name: &str, title: &str) -> String {
    let text = presets::find("cantilever").unwrap().text;
    text.replace("Damper", &in_toml(name))
        .replace("tip ", &in_toml(&format!("=tip{name}")))
        .replace("tip,", "end,")
        .replace(
            "title = \"Cantilever",
            &format!("title = \"{}", in_toml(title)),
        )
        .replace("points = 2000", "points = 12")
        .replace("max = 2000.0 }", "max = 2000.0, tolerance = 5.0 }")
}
