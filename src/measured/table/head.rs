//! What the words above a column say.

use super::words;
use crate::table::unquoted;
use crate::unit::ValueUnit;
use crate::unit::{FrequencyUnit, PhaseUnit};

/// What a column's header says.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Head {
    pub(super) role: Role,
    /// What is left of the header without role and unit: the curve's name.
    pub(super) name: String,
    /// The unit of the values.
    pub(super) unit: Option<ValueUnit>,
    /// What stands in square brackets, where it is no known unit.
    pub(super) unknown: Option<String>,
    /// Whether a minus stands in front of the role or the whole: the column holds the opposite.
    pub(super) minus: bool,
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
        let (cell, minus) = without_minus(unquoted(cell.trim().trim_matches('"')).trim());
        let mut head = Self {
            role: Role::Unsaid,
            name: String::new(),
            unit: None,
            unknown: None,
            minus: false,
        };
        if let Some(role) = frequency(cell) {
            head.role = role;
            let inside = bracket(cell).map(|(_, inside)| inside.to_owned());
            head.unknown = inside.filter(|_| role == Role::Frequency(None));
            return head;
        }
        let (words, note) = noted(cell);
        let (said, name, inner) = role(words);
        head.role = note.applied_to(said);
        head.minus = minus != inner;
        head.name = match (said, head.role) {
            (Role::Phase(_), Role::Unsaid) => words.to_owned(),
            _ => name,
        };
        // A phase's unit is no unit of a value.
        if !matches!(head.role, Role::Phase(_)) {
            (head.unit, head.unknown) = (note.unit, note.unknown);
        }
        head
    }

    /// Whether it says anything of what is in the column.
    pub(super) const fn is_known(&self) -> bool {
        !matches!(self.role, Role::Unsaid) || self.unit.is_some()
    }
}

/// What a minus is in headers.
const MINUS: [char; 3] = ['-', '\u{2212}', '\u{2013}'];

/// A header without the minus in front of it, and whether there is one: `-Im`, `minus imag`, `neg. phase`.
fn without_minus(cell: &str) -> (&str, bool) {
    if let Some(rest) = cell.strip_prefix(MINUS) {
        let rest = rest.trim_start();
        return if rest.starts_with(char::is_alphabetic) {
            (rest, true)
        } else {
            (cell, false)
        };
    }
    let words = ["minus", "neg.", "neg", "negative", "moins"];
    let (word, rest) = cell.split_once(char::is_whitespace).unwrap_or((cell, ""));
    if words.contains(&word.to_lowercase().as_str()) && !rest.trim().is_empty() {
        (rest.trim(), true)
    } else {
        (cell, false)
    }
}

/// What stands in brackets.
#[derive(Debug, Default)]
struct Note {
    decibels: bool,
    phase: Option<PhaseUnit>,
    unit: Option<ValueUnit>,
    /// What should be a unit and is none that is known.
    unknown: Option<String>,
}

impl Note {
    /// What a role is in this unit.
    const fn applied_to(&self, said: Role) -> Role {
        match (said, self.phase) {
            (Role::Magnitude { decibels }, _) => Role::Magnitude {
                decibels: decibels || self.decibels,
            },
            (Role::Unsaid, _) if self.decibels => Role::Magnitude { decibels: true },
            (Role::Unsaid | Role::Phase(_), Some(unit)) => Role::Phase(Some(unit)),
            // An angle over a load is a response.
            (Role::Phase(_), None) if self.unit.is_some() => Role::Unsaid,
            (other, _) => other,
        }
    }

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
                ..Self::default()
            });
        }
        let phase = PhaseUnit::from_word(inside);
        let unit = ValueUnit::parse(inside).ok();
        (phase.is_some() || unit.is_some()).then_some(Self {
            phase,
            unit,
            ..Self::default()
        })
    }
}

/// The words of a header and what stands behind them of their unit.
fn noted(cell: &str) -> (&str, Note) {
    let unknown = |inside: &str| Note {
        unknown: Some(inside.to_owned()),
        ..Note::default()
    };
    let (words, note) = match bracket(cell) {
        Some((words, inside)) => match Note::new(inside) {
            Some(note) => (words, note),
            None if cell.ends_with(']') || inside.contains('/') => (words, unknown(inside)),
            // What is no unit belongs to the name: Re(H11).
            None => (cell, Note::default()),
        },
        None => behind(cell).unwrap_or((cell, Note::default())),
    };
    // What joined the unit to the words.
    let words = words.trim_end_matches([' ', '/', ',', ':']);
    (words.strip_suffix(" in").unwrap_or(words), note)
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

/// The words and the unit behind them without brackets: `Betrag in um/N`, `Phase / deg`, `Real, m/N`.
fn behind(cell: &str) -> Option<(&str, Note)> {
    [" in ", " / ", ", "].into_iter().find_map(|between| {
        let (words, unit) = cell.rsplit_once(between)?;
        Some((words.trim(), Note::new(unit.trim())?))
    })
}

/// The role of a column of frequencies, with their unit as far as it is said; none where it is of something else.
fn frequency(cell: &str) -> Option<Role> {
    let lower = cell.to_lowercase();
    let plain = lower
        .replace(['[', ']', '(', ')', ',', ':', '_', '.'], " ")
        .replace(" / ", " ");
    let all: Vec<&str> = plain.split_whitespace().collect();
    let unit = |word: &str| match word {
        "rads" | "1/s" => Some(FrequencyUnit::RadianPerSecond),
        word => FrequencyUnit::from_word(word),
    };
    // A unit alone.
    if let [word] = all[..]
        && word != "1/s"
        && let Some(unit) = unit(word)
    {
        return Some(Role::Frequency(Some(unit)));
    }
    let (words, said) = match &all[..] {
        [words @ .., "rad", "s"] => (words.to_vec(), Some(FrequencyUnit::RadianPerSecond)),
        words => {
            let said = words.iter().find_map(|word| unit(word));
            let named = words
                .iter()
                .filter(|word| unit(word).is_none() && **word != "in");
            (named.copied().collect(), said)
        }
    };
    let name: Vec<&str> = match bracket(cell) {
        // What stands in brackets and is not known is no word of the name.
        Some((before, _)) => before
            .split(|letter: char| letter.is_whitespace() || "_.,:".contains(letter))
            .filter(|word| !word.is_empty())
            .collect(),
        None => words,
    };
    let angular = words::frequency(&name)?;
    let angular = angular.then_some(FrequencyUnit::RadianPerSecond);
    Some(Role::Frequency(said.or(angular)))
}

/// The role in a header's last or first word, the name that is left, and whether a minus stands in front of the role.
fn role(text: &str) -> (Role, String, bool) {
    let text = text.trim();
    let bars = text
        .strip_prefix('|')
        .and_then(|rest| rest.strip_suffix('|'));
    if let Some(inside) = bars.filter(|inside| !inside.is_empty()) {
        return (Role::Magnitude { decibels: false }, trimmed(inside), false);
    }
    if let Some(rest) = text.strip_prefix('∠') {
        return (Role::Phase(None), trimmed(rest), false);
    }
    let words = words_of(text);
    let plain = |index: &usize| !words::is_part(&text[words[*index].clone()]);
    let own: Vec<usize> = (0..words.len()).filter(plain).collect();
    // In brackets is a name, Re(H), but where there is nothing but a role, H (re).
    let bracketed = |word: &std::ops::Range<usize>| {
        text[..word.start].ends_with('(') && &text[word.end..] == ")"
    };
    let ends_in_word = |word: &std::ops::Range<usize>| word.end == text.len() || bracketed(word);
    let last = own
        .last()
        .filter(|_| words.last().is_some_and(ends_in_word));
    for index in last.into_iter().chain(own.first()) {
        let place = words[*index].clone();
        let Some(role) = words::role(&text[place.clone()]) else {
            continue;
        };
        let (mut from, mut to) = (place.start, place.end);
        let is_part = |index: Option<usize>| {
            let place = words.get(index?)?;
            words::is_part(&text[place.clone()]).then_some(place)
        };
        if let Some(part) = is_part(index.checked_sub(1)) {
            from = part.start;
        }
        if let Some(part) = is_part(index.checked_add(1)) {
            to = part.end;
        }
        if bracketed(&place) {
            (from, to) = (from - 1, to + 1);
        }
        let before = &text[..from];
        // H -imag has a minus, H-imag and H - imag have a dash.
        let minus = before.strip_suffix(MINUS).is_some_and(|rest| {
            rest.is_empty()
                || rest.ends_with(|letter: char| letter.is_whitespace() || "(./_".contains(letter))
        });
        return (role, trimmed(&format!("{before}{}", &text[to..])), minus);
    }
    (Role::Unsaid, text.to_owned(), false)
}

/// Where the words of a text are.
fn words_of(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut words: Vec<std::ops::Range<usize>> = Vec::new();
    for (at, letter) in text.char_indices() {
        if !(letter.is_alphanumeric() || letter == '°' || matches!(letter, '\u{300}'..='\u{36f}'))
        {
            continue;
        }
        let end = at + letter.len_utf8();
        match words.last_mut() {
            Some(word) if word.end == at => word.end = end,
            _ => words.push(at..end),
        }
    }
    words
}

/// A name without what joined it to a role.
fn trimmed(name: &str) -> String {
    let joins = |letter: char| {
        letter.is_whitespace() || "._-:,/|".contains(letter) || MINUS.contains(&letter)
    };
    let name = name.trim_matches(joins);
    let name = ["of ", "von ", "de "]
        .into_iter()
        .find_map(|word| name.strip_prefix(word))
        .unwrap_or(name);
    let inside = |open: char, close: char| name.strip_prefix(open)?.strip_suffix(close);
    let bare = inside('(', ')').or(inside('{', '}'));
    bare.unwrap_or(name).trim().to_owned()
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
            ("Excitation frequency", None),
            ("Fréquence (Hz)", Some(Hertz)),
            ("Frequenz in kHz", Some(Kilohertz)),
            ("f / Hz", Some(Hertz)),
            ("Kreisfrequenz", Some(RadianPerSecond)),
            ("angular frequency [Hz]", Some(Hertz)),
            ("Frequency [MHz]", None),
        ] {
            assert_eq!(head(cell).0, Role::Frequency(unit), "{cell}");
        }
        for cell in [
            "F1 re",
            "force",
            "fundamental",
            "first",
            "x",
            "f.re",
            "Frequency response",
            "Frequenzgang",
        ] {
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
            (
                "Phi(x)[rad]",
                Role::Phase(Some(PhaseUnit::Radian)),
                "x",
                None,
            ),
            ("Abs(x)[m]", magnitude(false), "x", Some("m")),
            ("|Z|", magnitude(false), "Z", None),
            ("∠Z (°)", degrees, "Z", None),
            ("Betrag in um/N", magnitude(false), "", Some("um/N")),
            ("Partie re\u{301}elle (m/N)", Role::Real, "", Some("m/N")),
            ("Imaginärteil", Role::Imaginary, "", None),
            ("tip (re) [m/N]", Role::Real, "tip", Some("m/N")),
            ("Angle [rad/N]", Role::Unsaid, "Angle", Some("rad/N")),
            ("Real (furlong/N)", Role::Real, "", None),
            ("Gain [dB]", magnitude(true), "Gain", None),
            ("Coherence", Role::Other, "", None),
            ("E_V", Role::Unsaid, "E_V", None),
            ("H11", Role::Unsaid, "H11", None),
            ("", Role::Unsaid, "", None),
        ] {
            let unit = unit.map(str::to_owned);
            assert_eq!(head(cell), (role, name.to_owned(), unit), "{cell}");
        }
    }

    #[test]
    fn a_minus_and_an_unknown_unit_are_seen() {
        for (cell, minus) in [
            ("-Im", true),
            ("-Im(H) [m/N]", true),
            ("H -imaginary (m/N)", true),
            ("- Phase [deg]", true),
            ("neg. imag", true),
            ("H-Im", false),
            ("H - Im", false),
            ("Im", false),
            ("-", false),
            ("minus", false),
        ] {
            assert_eq!(Head::new(cell).minus, minus, "{cell}");
        }
        let unknown = |cell: &str| Head::new(cell).unknown;
        assert_eq!(unknown("Re [furlong/N]").as_deref(), Some("furlong/N"));
        assert_eq!(unknown("Frequency [MHz]").as_deref(), Some("MHz"));
        assert_eq!(unknown("Re [m/N]"), None);
        assert_eq!(unknown("Re(H11)"), None);
    }
}
