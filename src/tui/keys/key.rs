//! A key, with conversions from terminal events and to names.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use crate::escape::{escape, is_hidden};

/// A key with its modifiers; Shift is part of the character, if there is one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Key {
    /// The key.
    pub code: KeyCode,
    /// Control, Alt, and the Shift of special keys.
    pub modifiers: KeyModifiers,
}

/// Special keys and their names.
const NAMED: [(KeyCode, &str); 16] = [
    (KeyCode::Char(' '), "Space"),
    (KeyCode::Enter, "Enter"),
    (KeyCode::Esc, "Esc"),
    (KeyCode::Tab, "Tab"),
    (KeyCode::BackTab, "Shift-Tab"),
    (KeyCode::Backspace, "Backspace"),
    (KeyCode::Delete, "Del"),
    (KeyCode::Insert, "Ins"),
    (KeyCode::Home, "Home"),
    (KeyCode::End, "End"),
    (KeyCode::PageUp, "PgUp"),
    (KeyCode::PageDown, "PgDn"),
    (KeyCode::Up, "Up"),
    (KeyCode::Down, "Down"),
    (KeyCode::Left, "Left"),
    (KeyCode::Right, "Right"),
];

/// The prefixes of the modifiers.
const HELD: [(KeyModifiers, &str); 3] = [
    (KeyModifiers::CONTROL, "Ctrl-"),
    (KeyModifiers::ALT, "Alt-"),
    (KeyModifiers::SHIFT, "Shift-"),
];

impl Key {
    /// The key of an event.
    pub fn of(event: &KeyEvent) -> Self {
        Self {
            code: event.code,
            modifiers: event.modifiers,
        }
        .plain()
    }

    /// The event of the key.
    #[cfg(test)]
    pub fn event(self) -> KeyEvent {
        KeyEvent::new(self.code, self.modifiers)
    }

    /// The normalized key.
    fn plain(self) -> Self {
        let held = KeyModifiers::CONTROL | KeyModifiers::ALT | KeyModifiers::SHIFT;
        let mut modifiers = self.modifiers & held;
        let code = match self.code {
            // Terminals do not distinguish them.
            KeyCode::Char(c) if modifiers.contains(KeyModifiers::CONTROL) => {
                KeyCode::Char(c.to_ascii_lowercase())
            }
            KeyCode::Tab if modifiers.contains(KeyModifiers::SHIFT) => KeyCode::BackTab,
            code => code,
        };
        if matches!(code, KeyCode::Char(_) | KeyCode::BackTab) {
            modifiers.remove(KeyModifiers::SHIFT);
        }
        Self { code, modifiers }
    }

    /// Whether the key types a character: no modifier except Shift.
    pub fn is_typed(self) -> bool {
        matches!(self.code, KeyCode::Char(_)) && self.modifiers.is_empty()
    }

    /// The key with this name: `u`, `Ctrl-s`, `Alt-Enter`, `F5`, `Space`, `PgDn`. None if terminals cannot send it as a
    /// separate key (`Ctrl-m` is Enter).
    pub fn parse(text: &str) -> Option<Self> {
        let mut rest = text;
        let mut modifiers = KeyModifiers::NONE;
        while let Some((held, after)) = HELD.iter().find_map(|(held, name)| {
            let start = rest.get(..name.len())?;
            let after = &rest[name.len()..];
            (start.eq_ignore_ascii_case(name) && !after.is_empty()).then_some((*held, after))
        }) {
            modifiers |= held;
            rest = after;
        }
        let code = code_of(rest)?;
        let shifted = modifiers.contains(KeyModifiers::SHIFT);
        let control = modifiers.contains(KeyModifiers::CONTROL);
        let refused = match code {
            KeyCode::Char(' ') => shifted,
            // Shift is part of the character; with Control, few characters have a code, and some share that of another
            // key.
            KeyCode::Char(c) => {
                // With Alt, these two start an escape sequence.
                let begins = modifiers == KeyModifiers::ALT && matches!(c, '[' | 'O');
                let c = c.to_ascii_lowercase();
                let own = matches!(c, 'a'..='z' | '\\' | ']' | '^' | '_');
                shifted || begins || (control && (!own || matches!(c, 'h' | 'i' | 'j' | 'm')))
            }
            KeyCode::Enter | KeyCode::Esc | KeyCode::Backspace => control || shifted,
            KeyCode::Tab => control,
            _ => false,
        };
        (!refused).then(|| Self { code, modifiers }.plain())
    }

    /// The key's name in help and hints.
    pub fn name(self) -> String {
        let name = match self.code {
            KeyCode::F(n) => format!("F{n}"),
            code => match (NAMED.iter().find(|(known, _)| *known == code), code) {
                (Some((_, name)), _) => (*name).to_owned(),
                (None, KeyCode::Char(c)) => escape(&c.to_string()).into_owned(),
                (None, other) => format!("{other:?}"),
            },
        };
        let held = HELD
            .iter()
            .filter(|(held, _)| self.modifiers.contains(*held));
        held.map(|(_, name)| *name).chain([name.as_str()]).collect()
    }
}

fn code_of(name: &str) -> Option<KeyCode> {
    let mut letters = name.chars();
    if let (Some(letter), None) = (letters.next(), letters.next()) {
        return (!is_hidden(letter)).then_some(KeyCode::Char(letter));
    }
    let named = NAMED
        .iter()
        .find(|(_, known)| known.eq_ignore_ascii_case(name));
    if let Some((code, _)) = named {
        return Some(*code);
    }
    let number = name.strip_prefix(['F', 'f'])?.parse().ok()?;
    (1..=24).contains(&number).then_some(KeyCode::F(number))
}

/// A character.
pub(super) const fn key(c: char) -> Key {
    special(KeyCode::Char(c))
}

/// A character with Control.
pub(super) const fn control(c: char) -> Key {
    Key {
        code: KeyCode::Char(c),
        modifiers: KeyModifiers::CONTROL,
    }
}

/// A special key with Shift.
pub(super) const fn shifted(code: KeyCode) -> Key {
    Key {
        code,
        modifiers: KeyModifiers::SHIFT,
    }
}

/// A special key.
pub(super) const fn special(code: KeyCode) -> Key {
    Key {
        code,
        modifiers: KeyModifiers::NONE,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{SECTIONS, Section};
    use super::*;

    #[test]
    fn the_names_of_the_table_are_read_back() {
        let bindings = SECTIONS.iter().flat_map(Section::rows);
        for key in bindings.flat_map(|binding| binding.keys) {
            assert_eq!(Key::parse(&key.name()), Some(*key), "{}", key.name());
        }
    }

    #[test]
    fn names_are_read_as_people_write_them() {
        assert_eq!(Key::parse("ctrl-S"), Some(control('s')));
        assert_eq!(Key::parse("Ctrl-]"), Some(control(']')));
        assert_eq!(Key::parse("-"), Some(key('-')));
        assert_eq!(Key::parse("pgdn"), Some(special(KeyCode::PageDown)));
        assert_eq!(Key::parse("F12"), Some(special(KeyCode::F(12))));
        assert_eq!(Key::parse("shift-left"), Some(shifted(KeyCode::Left)));
        assert_eq!(Key::parse("ä"), Some(key('ä')));
        for nonsense in [
            "",
            "Ctrl-",
            "uu",
            "F0",
            "F25",
            "Ctrl-m",
            "Shift-a",
            "Enterr",
            "\u{1b}",
            "\u{202e}",
            "Ctrl--",
            "Ctrl-1",
            "Shift-Enter",
            "Shift-Esc",
            "Alt-[",
            "Alt-O",
        ] {
            assert_eq!(Key::parse(nonsense), None, "{nonsense:?}");
        }
    }

    #[test]
    fn shift_is_in_the_character() {
        let event = KeyEvent::new(KeyCode::Char('U'), KeyModifiers::SHIFT);
        assert_eq!(Key::of(&event), key('U'));
        let tab = KeyEvent::new(KeyCode::BackTab, KeyModifiers::SHIFT);
        assert_eq!(Key::of(&tab), special(KeyCode::BackTab));
    }
}
