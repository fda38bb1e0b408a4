//! Parses column titles: role, name, unit and sign.

use super::vocabulary;
use crate::table::unquoted;
use crate::unit::ValueUnit;
use crate::unit::{FrequencyUnit, PhaseUnit};

/// A parsed column title.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ColumnTitle {
    pub(super) role: Role,
    /// The title without role and unit: the curve's name.
    pub(super) name: String,
    /// The unit of the values.
    pub(super) unit: Option<ValueUnit>,
    /// The text in square brackets that is not a known unit.
    pub(super) unknown: Option<String>,
    /// Whether a minus precedes the role or the title: the column has the opposite sign.
    pub(super) minus: bool,
}

/// The content of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Frequency(Option<FrequencyUnit>),
    Real,
    Imaginary,
    Magnitude {
        decibels: bool,
    },
    Phase(Option<PhaseUnit>),
    /// Not part of a response.
    Other,
    /// No known role.
    Unknown,
}

impl ColumnTitle {
    pub(super) fn new(cell: &str) -> Self {
        let (cell, minus) = without_minus(unquoted(cell.trim().trim_matches('"')).trim());
        let mut title = Self {
            role: Role::Unknown,
            name: String::new(),
            unit: None,
            unknown: None,
            minus: false,
        };
        if let Some(role) = frequency(cell) {
            title.role = role;
            let inside = bracket(cell).map(|(_, inside)| inside.to_owned());
            title.unknown = inside.filter(|_| role == Role::Frequency(None));
            return title;
        }
        let (words, note) = split_unit(cell);
        let (stated, name, inner) = role(words);
        title.role = note.applied_to(stated);
        title.minus = minus != inner;
        title.name = match (stated, title.role) {
            (Role::Phase(_), Role::Unknown) => words.to_owned(),
            _ => name,
        };
        // The unit of a phase is not a unit of values.
        if !matches!(title.role, Role::Phase(_)) {
            (title.unit, title.unknown) = (note.unit, note.unknown);
        }
        title
    }

    /// Whether the title gives a role or a unit.
    pub(super) const fn is_known(&self) -> bool {
        !matches!(self.role, Role::Unknown) || self.unit.is_some()
    }
}

/// Minus characters in titles.
const MINUS: [char; 3] = ['-', '\u{2212}', '\u{2013}'];

/// A title without a leading minus, and whether it had one: `-Im`, `minus imag`, `neg. phase`.
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

/// The text in brackets.
#[derive(Debug, Default)]
struct UnitNote {
    decibels: bool,
    phase: Option<PhaseUnit>,
    unit: Option<ValueUnit>,
    /// An unknown unit.
    unknown: Option<String>,
}

impl UnitNote {
    /// The role, changed by this unit.
    const fn applied_to(&self, stated: Role) -> Role {
        match (stated, self.phase) {
            (Role::Magnitude { decibels }, _) => Role::Magnitude {
                decibels: decibels || self.decibels,
            },
            (Role::Unknown, _) if self.decibels => Role::Magnitude { decibels: true },
            (Role::Unknown | Role::Phase(_), Some(unit)) => Role::Phase(Some(unit)),
            // An angle divided by a load is a response.
            (Role::Phase(_), None) if self.unit.is_some() => Role::Unknown,
            (other, _) => other,
        }
    }

    /// None if the text is not a unit.
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

/// Splits a title into its words and its unit.
fn split_unit(cell: &str) -> (&str, UnitNote) {
    let unknown = |inside: &str| UnitNote {
        unknown: Some(inside.to_owned()),
        ..UnitNote::default()
    };
    let (words, note) = match bracket(cell) {
        Some((words, inside)) => match UnitNote::new(inside) {
            Some(note) => (words, note),
            None if cell.ends_with(']') || inside.contains('/') => (words, unknown(inside)),
            // Text in brackets that is not a unit belongs to the name: Re(H11).
            None => (cell, UnitNote::default()),
        },
        None => unit_after_words(cell).unwrap_or((cell, UnitNote::default())),
    };
    // Remove what joined the unit to the words.
    let words = words.trim_end_matches([' ', '/', ',', ':']);
    (words.strip_suffix(" in").unwrap_or(words), note)
}

/// The text before and in the last bracket of a title.
fn bracket(cell: &str) -> Option<(&str, &str)> {
    let (open, close) = match cell.chars().last()? {
        ']' => ('[', ']'),
        ')' => ('(', ')'),
        _ => return None,
    };
    let inside = cell.strip_suffix(close)?;
    // Find the matching bracket: units may contain brackets.
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

/// Splits a title with a unit without brackets: `Betrag in um/N`, `Phase / deg`, `Real, m/N`.
fn unit_after_words(cell: &str) -> Option<(&str, UnitNote)> {
    [" in ", " / ", ", "].into_iter().find_map(|between| {
        let (words, unit) = cell.rsplit_once(between)?;
        Some((words.trim(), UnitNote::new(unit.trim())?))
    })
}

/// The role of a frequency column, with its unit if given; none for other columns.
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
    // Only a unit.
    if let [word] = all[..]
        && word != "1/s"
        && let Some(unit) = unit(word)
    {
        return Some(Role::Frequency(Some(unit)));
    }
    let (words, stated) = match &all[..] {
        [words @ .., "rad", "s"] => (words.to_vec(), Some(FrequencyUnit::RadianPerSecond)),
        words => {
            let stated = words.iter().find_map(|word| unit(word));
            let named = words
                .iter()
                .filter(|word| unit(word).is_none() && **word != "in");
            (named.copied().collect(), stated)
        }
    };
    let name: Vec<&str> = match bracket(cell) {
        // Unknown text in brackets is not part of the name.
        Some((before, _)) => before
            .split(|letter: char| letter.is_whitespace() || "_.,:".contains(letter))
            .filter(|word| !word.is_empty())
            .collect(),
        None => words,
    };
    let angular = vocabulary::frequency(&name)?;
    let angular = angular.then_some(FrequencyUnit::RadianPerSecond);
    Some(Role::Frequency(stated.or(angular)))
}

/// The role from the last or first word of a title, the remaining name, and whether a minus precedes the role.
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
    let plain = |index: &usize| !vocabulary::is_part(&text[words[*index].clone()]);
    let own: Vec<usize> = (0..words.len()).filter(plain).collect();
    // Brackets contain a name, Re(H), or only a role, H (re).
    let bracketed = |word: &std::ops::Range<usize>| {
        text[..word.start].ends_with('(') && &text[word.end..] == ")"
    };
    let ends_in_word = |word: &std::ops::Range<usize>| word.end == text.len() || bracketed(word);
    let last = own
        .last()
        .filter(|_| words.last().is_some_and(ends_in_word));
    for index in last.into_iter().chain(own.first()) {
        let range = words[*index].clone();
        let Some(role) = vocabulary::role(&text[range.clone()]) else {
            continue;
        };
        let (mut from, mut to) = (range.start, range.end);
        let is_part = |index: Option<usize>| {
            let range = words.get(index?)?;
            vocabulary::is_part(&text[range.clone()]).then_some(range)
        };
        if let Some(part) = is_part(index.checked_sub(1)) {
            from = part.start;
        }
        if let Some(part) = is_part(index.checked_add(1)) {
            to = part.end;
        }
        if bracketed(&range) {
            (from, to) = (from - 1, to + 1);
        }
        let before = &text[..from];
        // H -imag has a minus; H-imag and H - imag have a dash.
        let minus = before.strip_suffix(MINUS).is_some_and(|rest| {
            rest.is_empty()
                || rest.ends_with(|letter: char| letter.is_whitespace() || "(./_".contains(letter))
        });
        return (role, trimmed(&format!("{before}{}", &text[to..])), minus);
    }
    (Role::Unknown, text.to_owned(), false)
}

/// The positions of the words of a text.
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

/// A name without the characters that joined it to a role.
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

    fn title(cell: &str) -> (Role, String, Option<String>) {
        let title = ColumnTitle::new(cell);
        (
            title.role,
            title.name,
            title.unit.map(|unit| unit.to_string()),
        )
    }

    #[test]
    fn frequencies_and_their_units_are_parsed() {
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
            assert_eq!(title(cell).0, Role::Frequency(unit), "{cell}");
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
            assert!(!matches!(title(cell).0, Role::Frequency(_)), "{cell}");
        }
    }

    #[test]
    fn roles_names_and_units_are_parsed() {
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
            ("Angle [rad/N]", Role::Unknown, "Angle", Some("rad/N")),
            ("Real (furlong/N)", Role::Real, "", None),
            ("Gain [dB]", magnitude(true), "Gain", None),
            ("Coherence", Role::Other, "", None),
            ("E_V", Role::Unknown, "E_V", None),
            ("H11", Role::Unknown, "H11", None),
            ("", Role::Unknown, "", None),
        ] {
            let unit = unit.map(str::to_owned);
            assert_eq!(title(cell), (role, name.to_owned(), unit), "{cell}");
        }
    }

    #[test]
    fn a_minus_and_an_unknown_unit_are_parsed() {
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
            assert_eq!(ColumnTitle::new(cell).minus, minus, "{cell}");
        }
        let unknown = |cell: &str| ColumnTitle::new(cell).unknown;
        assert_eq!(unknown("Re [furlong/N]").as_deref(), Some("furlong/N"));
        assert_eq!(unknown("Frequency [MHz]").as_deref(), Some("MHz"));
        assert_eq!(unknown("Re [m/N]"), None);
        assert_eq!(unknown("Re(H11)"), None);
    }
}
