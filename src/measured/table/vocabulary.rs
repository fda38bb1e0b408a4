//! The words of headers in English, German, French, Italian and Spanish.

use super::column_title::Role;
use crate::unit::PhaseUnit;

/// Words that name a frequency column if they are the last word, without accents.
const FREQUENCIES: &[&str] = &[
    "freq",
    "frequency",
    "frequencies",
    "frequenz",
    "frequenzen",
    "frequence",
    "frequences",
    "frequenza",
    "frecuencia",
];

/// Words for an angular frequency, rad/s.
const ANGULAR: &[&str] = &["omega", "ω", "kreisfrequenz", "pulsation"];

/// Words that change the meaning of a frequency: frequency response.
const NOT_FREQUENCIES: &[&str] = &["response", "responses", "function", "reponse", "resp", "rf"];

/// A word in lower case without accents.
pub(super) fn folded(word: &str) -> String {
    let plain = |letter: char| match letter {
        'à' | 'á' | 'â' | 'ä' => 'a',
        'è' | 'é' | 'ê' | 'ë' => 'e',
        'ì' | 'í' | 'î' | 'ï' => 'i',
        'ò' | 'ó' | 'ô' | 'ö' => 'o',
        'ù' | 'ú' | 'û' | 'ü' => 'u',
        'ç' => 'c',
        other => other,
    };
    // An accent may be a separate character.
    let is_accent = |letter: &char| matches!(letter, '\u{300}'..='\u{36f}');
    let lower = word.to_lowercase();
    lower
        .chars()
        .filter(|letter| !is_accent(letter))
        .map(plain)
        .collect()
}

/// The role that a word gives a column.
pub(super) fn role(word: &str) -> Option<Role> {
    Some(match folded(word).as_str() {
        "re" | "real" | "realteil" | "reell" | "reel" | "reelle" | "reale" => Role::Real,
        "im" | "imag" | "imaginary" | "imaginarteil" | "imaginaerteil" | "imaginar"
        | "imaginaer" | "imaginaire" | "imaginaria" | "immaginaria" | "imaginario"
        | "immaginario" => Role::Imaginary,
        "mag" | "magn" | "magnitude" | "abs" | "amplitude" | "ampl" | "amp" | "modulus"
        | "module" | "betrag" | "absolutbetrag" | "ampiezza" | "amplitud" | "modulo" => {
            Role::Magnitude { decibels: false }
        }
        "db" => Role::Magnitude { decibels: true },
        "phase" | "arg" | "argument" | "angle" | "phi" | "φ" | "ϕ" | "phasenwinkel" | "winkel"
        | "fase" => Role::Phase(None),
        "deg" | "grad" => Role::Phase(Some(PhaseUnit::Degree)),
        "rad" => Role::Phase(Some(PhaseUnit::Radian)),
        "coherence" | "coh" | "koharenz" | "kohaerenz" | "time" | "zeit" | "temps" | "index"
        | "pt" | "nr" => Role::Other,
        _ => return None,
    })
}

/// Whether a word belongs to the previous or next word: real part, partie réelle.
pub(super) fn is_part(word: &str) -> bool {
    matches!(folded(word).as_str(), "part" | "partie" | "parte")
}

/// Whether words name an angular frequency; none if they do not name a frequency.
pub(super) fn frequency(words: &[&str]) -> Option<bool> {
    let words: Vec<String> = words.iter().map(|word| folded(word)).collect();
    let (first, last) = (words.first()?.as_str(), words.last()?.as_str());
    let named = |word: &str| {
        FREQUENCIES.contains(&word) || word.ends_with("frequenz") || word.ends_with("frequency")
    };
    let angular = words.iter().any(|word| {
        let word = word.as_str();
        word == "angular" || word == "circular" || ANGULAR.contains(&word)
    });
    let single = words.len() == 1 && (first == "f" || ANGULAR.contains(&first));
    let other = |word: &String| NOT_FREQUENCIES.contains(&word.as_str()) || role(word).is_some();
    let found = single || named(last) || (named(first) && !words.iter().any(other));
    found.then_some(angular)
}
