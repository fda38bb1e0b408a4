//! Parses a layout.

use super::{Layout, Places, Values};
use crate::unit::{FrequencyUnit, PhaseUnit, ValueUnit};

/// A word for a column, whether it has a minus, and the selected column numbers.
struct Named {
    word: Word,
    minus: bool,
    places: Vec<usize>,
}

/// The content of a column of a curve.
#[derive(Clone, Copy)]
enum Word {
    Real,
    Imaginary,
    Magnitude { decibels: bool },
    Phase(PhaseUnit),
}

impl Word {
    fn of(text: &str) -> Option<Self> {
        Some(match text.to_lowercase().as_str() {
            "re" => Self::Real,
            "im" => Self::Imaginary,
            "mag" => Self::Magnitude { decibels: false },
            "db" => Self::Magnitude { decibels: true },
            word => Self::Phase(PhaseUnit::from_word(word)?),
        })
    }

    /// Whether it is the second column of a curve.
    const fn is_second(self) -> bool {
        matches!(self, Self::Imaginary | Self::Phase(_))
    }
}

/// Reads a layout.
pub(super) fn layout(text: &str) -> Result<Layout, String> {
    let wrong = || {
        "needs a frequency unit, the columns and their unit, such as hz; re im; m/s2/N, or by number hz 1; re 8; im 9; \
         m/s2/N"
            .to_owned()
    };
    let parts: Vec<&str> = text.split(';').map(str::trim).collect();
    let [frequency, columns, rest @ ..] = &parts[..] else {
        return Err(wrong());
    };
    let (frequency, column) = frequencies(frequency)?;
    let numbered = rest.iter().take_while(|part| is_numbered(part)).count();
    let (more, unit) = rest.split_at(numbered);
    let unit = match unit {
        [] | ["" | "?"] => None,
        [unit] => Some(ValueUnit::parse(unit)?),
        _ => return Err(wrong()),
    };
    let columns = std::iter::once(columns).chain(more);
    let columns: Vec<&str> = columns.copied().collect();
    let (values, minus, curves) = values(&columns.join(" "))?;
    Ok(Layout {
        frequency,
        values,
        minus,
        unit,
        places: Places {
            frequency: column,
            curves,
        },
    })
}

/// Whether a part selects columns by number, and is not a unit.
fn is_numbered(part: &str) -> bool {
    let mut words = part.split_whitespace();
    let word = words.next().and_then(|word| minus_of(word).0);
    let mut rest = words.peekable();
    word.is_some() && rest.peek().is_some_and(|next| is_number(next))
}

fn is_number(word: &str) -> bool {
    word.bytes().all(|byte| byte.is_ascii_digit())
}

/// The meaning of a word without a leading minus, and whether it has one.
fn minus_of(word: &str) -> (Option<Word>, bool) {
    match word.strip_prefix('-') {
        Some(rest) => (Word::of(rest).filter(|word| word.is_second()), true),
        None => (Word::of(word), false),
    }
}

fn frequencies(part: &str) -> Result<(FrequencyUnit, Option<usize>), String> {
    let (unit, column) = match part.rsplit_once(char::is_whitespace) {
        Some((unit, column)) if is_number(column) => (unit, Some(place(column)?)),
        _ => (part, None),
    };
    let unit = FrequencyUnit::from_word(unit).ok_or_else(|| {
        let accepted = FrequencyUnit::ACCEPTED;
        format!("{part:?} is not a unit of frequency: accepted is {accepted}, followed by the number of the column")
    })?;
    Ok((unit, column))
}

fn place(word: &str) -> Result<usize, String> {
    let place = word.parse().ok().filter(|place| *place > 0);
    place.ok_or_else(|| format!("{word:?} is not a column: columns are numbered from 1"))
}

/// The columns of a curve, whether the second one has a minus, and their numbers, if given.
fn values(text: &str) -> Result<(Values, bool, Vec<[usize; 2]>), String> {
    let wrong = || {
        format!(
            "{text:?} are not columns: accepted is re im, mag deg, mag rad, dB deg, dB rad, mag or dB, or with the numbers of \
             the columns, as re 8; im 9"
        )
    };
    let mut named: Vec<Named> = Vec::new();
    for word in text.split_whitespace() {
        match named.last_mut() {
            Some(last) if is_number(word) => last.places.push(place(word)?),
            _ => {
                let (found, minus) = minus_of(word);
                named.push(Named {
                    word: found.ok_or_else(wrong)?,
                    minus,
                    places: Vec::new(),
                });
            }
        }
    }
    // Without numbers the order determines the columns.
    if named.iter().all(|one| !one.places.is_empty()) {
        named.sort_by_key(|one| one.word.is_second());
    }
    let kinds: Vec<Word> = named.iter().map(|one| one.word).collect();
    let values = match kinds[..] {
        [Word::Real, Word::Imaginary] => Values::Complex,
        [Word::Magnitude { decibels }] => Values::Magnitude { decibels },
        [Word::Magnitude { decibels }, Word::Phase(phase)] => {
            Values::MagnitudePhase { phase, decibels }
        }
        _ => return Err(wrong()),
    };
    let (first, second) = (&named[0].places, &named[named.len() - 1].places);
    if first.is_empty() != second.is_empty() {
        return Err(wrong());
    }
    if first.len() != second.len() {
        return Err(format!(
            "{text:?} has {} columns of one kind and {} of the other: the same number would be accepted",
            first.len(),
            second.len()
        ));
    }
    let curves = first.iter().zip(second).map(|(a, b)| [*a, *b]).collect();
    Ok((values, named.iter().any(|one| one.minus), curves))
}
