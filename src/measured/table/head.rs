//! What the words above a column say.

use crate::measured::layout::{FrequencyUnit, PhaseUnit};
use crate::measured::unit::ValueUnit;
use crate::table::unquoted;

/// What a column's header says.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Head {
    pub(super) role: Role,
    /// What is left of the header without role and unit: the curve's name.
    pub(super) name: String,
    /// The unit of the values.
    pub(super) unit: Option<ValueUnit>,
}

/// What is in a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Frequency(Option<FrequencyUnit>),
    Real,
    Imaginary,
    Magnitude {
        decibels: bool,
    },
    Phase(Option<PhaseUnit>),
    /// Nothing that belongs to a response.
    Other,
    /// Not said.
    Unsaid,
}

impl Head {
    pub(super) fn new(cell: &str) -> Self {
        let cell = unquoted(cell.trim().trim_matches('"'));
        if let Some(role) = frequency(cell) {
            return Self {
                role,
                name: String::new(),
                unit: None,
            };
        }
        let (words, note) = match bracket(cell).map(|(words, inside)| (words, Note::new(inside))) {
            Some((words, Some(note))) => (words, note),
            // What is no unit belongs to the name: Re(H11).
            _ => (cell, Note::default()),
        };
        let (mut role, name) = role(words);
        match role {
            Role::Magnitude { decibels } => {
                role = Role::Magnitude {
                    decibels: decibels || note.decibels,
                }
            }
            Role::Unsaid if note.decibels => role = Role::Magnitude { decibels: true },
            Role::Unsaid | Role::Phase(_) if note.phase.is_some() => role = Role::Phase(note.phase),
            _ => {}
        }
        // A phase's unit is no unit of a value.
        let unit = if matches!(role, Role::Phase(_)) {
            None
        } else {
            note.unit
        };
        Self { role, name, unit }
    }
}

/// What stands in brackets.
#[derive(Debug, Default)]
struct Note {
    decibels: bool,
    phase: Option<PhaseUnit>,
    unit: Option<ValueUnit>,
}

impl Note {
    /// None where it is no unit.
    fn new(inside: &str) -> Option<Self> {
        let lower = inside.to_ascii_lowercase();
        if let Some(rest) = lower
            .strip_prefix("db")
            .filter(|rest| !rest.starts_with(char::is_alphanumeric))
        {
            let rest = inside[inside.len() - rest.len()..].trim();
            let words = ["rel.", "rel", "re", "ref.", "ref", "/"];
            let reference = words
                .into_iter()
                .find_map(|word| rest.strip_prefix(word))
                .unwrap_or(rest);
            return Some(Self {
                decibels: true,
                unit: ValueUnit::parse(reference).ok(),
                phase: None,
            });
        }
        let phase = PhaseUnit::from_word(inside);
        let unit = ValueUnit::parse(inside).ok();
        (phase.is_some() || unit.is_some()).then_some(Self {
            decibels: false,
            phase,
            unit,
        })
    }
}

/// What a header's last bracket holds, and what stands before it.
fn bracket(cell: &str) -> Option<(&str, &str)> {
    let (open, close) = match cell.chars().last()? {
        ']' => ('[', ']'),
        ')' => ('(', ')'),
        _ => return None,
    };
    let inside = cell.strip_suffix(close)?;
    // The bracket that this one closes: units have brackets in them.
    let mut depth = 1;
    for (at, letter) in inside.char_indices().rev() {
        if letter == close {
            depth += 1;
        } else if letter == open {
            depth -= 1;
        }
        if depth == 0 {
            return Some((cell[..at].trim(), inside[at + 1..].trim()));
        }
    }
    None
}

/// The role of a column of frequencies, with their unit as far as it is said; none where it is of something else.
fn frequency(cell: &str) -> Option<Role> {
    let lower = cell.to_ascii_lowercase();
    let plain = lower.replace(['[', ']', '(', ')', ',', ':', '_'], " ");
    let words: Vec<&str> = plain.split_whitespace().collect();
    let unit = |word: &str| match word {
        "hertz" => Some(FrequencyUnit::Hertz),
        "rads" | "1/s" => Some(FrequencyUnit::RadianPerSecond),
        "1/min" | "cpm" => Some(FrequencyUnit::RevolutionPerMinute),
        word => FrequencyUnit::from_word(word),
    };
    let said = match words[..] {
        [.., "rad", "s"] => Some(FrequencyUnit::RadianPerSecond),
        _ => words.iter().find_map(|word| unit(word)),
    };
    let names = [
        "f",
        "freq",
        "freq.",
        "frequency",
        "frequencies",
        "frequenz",
        "omega",
    ];
    let first = words.first()?;
    if names.contains(first) {
        let omega = (*first == "omega").then_some(FrequencyUnit::RadianPerSecond);
        return Some(Role::Frequency(said.or(omega)));
    }
    // A unit alone.
    (unit(first).is_some() && words.len() == 1 && !matches!(*first, "1/s"))
        .then_some(Role::Frequency(said))
}

/// The role in a header's last or first word, and the name that is left.
fn role(words: &str) -> (Role, String) {
    let parts = |letter: char| !(letter.is_alphanumeric() || letter == '°');
    let trim = |name: &str| {
        let name =
            name.trim_matches(|letter: char| letter.is_whitespace() || "._-:,/|".contains(letter));
        let bare = name
            .strip_prefix('(')
            .and_then(|name| name.strip_suffix(')'));
        bare.unwrap_or(name).trim().to_owned()
    };
    let whole = words.trim();
    let lower = whole.to_ascii_lowercase();
    for (part, role) in [
        ("real part", Role::Real),
        ("imaginary part", Role::Imaginary),
        ("imag part", Role::Imaginary),
    ] {
        if let Some(at) = lower.find(part) {
            return (
                role,
                trim(&format!("{} {}", &whole[..at], &whole[at + part.len()..])),
            );
        }
    }
    let last = whole.rfind(parts).map_or(0, |at| {
        at + whole[at..].chars().next().map_or(1, char::len_utf8)
    });
    if let Some(role) = word(&whole[last..]) {
        return (role, trim(&whole[..last]));
    }
    let first = whole.find(parts).unwrap_or(whole.len());
    if let Some(role) = word(&whole[..first]) {
        return (role, trim(&whole[first..]));
    }
    (Role::Unsaid, whole.to_owned())
}

fn word(word: &str) -> Option<Role> {
    Some(match word.to_ascii_lowercase().as_str() {
        "re" | "real" => Role::Real,
        "im" | "imag" | "imaginary" => Role::Imaginary,
        "mag" | "magnitude" | "abs" | "amplitude" | "amp" | "modulus" => {
            Role::Magnitude { decibels: false }
        }
        "db" => Role::Magnitude { decibels: true },
        "phase" | "arg" | "angle" => Role::Phase(None),
        "deg" => Role::Phase(Some(PhaseUnit::Degree)),
        "rad" => Role::Phase(Some(PhaseUnit::Radian)),
        "coherence" | "coh" | "time" | "index" => Role::Other,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(cell: &str) -> (Role, String, Option<String>) {
        let head = Head::new(cell);
        (head.role, head.name, head.unit.map(|unit| unit.to_string()))
    }

    #[test]
    fn frequencies_and_their_units_are_known() {
        use FrequencyUnit::{Hertz, Kilohertz, RadianPerSecond, RevolutionPerMinute};
        for (cell, unit) in [
            ("frequency_hz", Some(Hertz)),
            ("Frequency [Hz]", Some(Hertz)),
            ("FREQ(kHz)", Some(Kilohertz)),
            ("f", None),
            ("Frequency", None),
            ("omega [rad/s]", Some(RadianPerSecond)),
            ("freq_rad_s", Some(RadianPerSecond)),
            ("omega", Some(RadianPerSecond)),
            ("Hz", Some(Hertz)),
            ("rpm", Some(RevolutionPerMinute)),
            ("\"Frequency, Hz\"", Some(Hertz)),
        ] {
            assert_eq!(head(cell).0, Role::Frequency(unit), "{cell}");
        }
        for cell in ["F1 re", "force", "fundamental", "first", "x"] {
            assert!(!matches!(head(cell).0, Role::Frequency(_)), "{cell}");
        }
    }

    #[test]
    fn roles_names_and_units_are_known() {
        let magnitude = |decibels| Role::Magnitude { decibels };
        let degrees = Role::Phase(Some(PhaseUnit::Degree));
        for (cell, role, name, unit) in [
            ("P1 w.re", Role::Real, "P1 w", None),
            ("P1 w.im", Role::Imaginary, "P1 w", None),
            ("w at 1.2 (m).re", Role::Real, "w at 1.2 (m)", None),
            ("Re(H11)", Role::Real, "H11", None),
            ("Im(H11) [m/s2/N]", Role::Imaginary, "H11", Some("m/s2/N")),
            ("H11 Real", Role::Real, "H11", None),
            ("Real part (m/(N s2))", Role::Real, "", Some("m/(N s2)")),
            ("Magnitude (g/N)", magnitude(false), "", Some("g/N")),
            ("abs H [dB re 1 m/N]", magnitude(true), "H", Some("1 m/N")),
            ("H [dB]", magnitude(true), "H", None),
            ("dB", magnitude(true), "", None),
            ("Phase [deg]", degrees, "", None),
            ("H (°)", degrees, "H", None),
            (
                "phase (rad)",
                Role::Phase(Some(PhaseUnit::Radian)),
                "",
                None,
            ),
            ("phase", Role::Phase(None), "", None),
            ("Coherence", Role::Other, "", None),
            ("E_V", Role::Unsaid, "E_V", None),
            ("H11", Role::Unsaid, "H11", None),
            ("", Role::Unsaid, "", None),
        ] {
            let unit = unit.map(str::to_owned);
            assert_eq!(head(cell), (role, name.to_owned(), unit), "{cell}");
        }
    }
}
