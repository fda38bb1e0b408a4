//! Where a force can act or a response can be read, in words.

use super::quantity::Quantity;
use super::spelling::{nearest, segment};
use super::types::{At, Model, Place};
use crate::unit::{Unit, value_input};

/// The most names that a message lists.
const MOST_LISTED: usize = 6;

/// The accepted positions of a force or response.
pub(super) struct Places<'a> {
    /// The words of positions that every model has.
    words: &'static [&'static str],
    /// Whether a distance from the left end is accepted.
    any: bool,
    /// The accepted names, and what they are of.
    names: Vec<&'a str>,
    named: Option<Named>,
}

/// What has a name.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Named {
    Subsystem,
    Support,
}

impl Named {
    const fn words(self) -> &'static str {
        match self {
            Self::Subsystem => "a subsystem",
            Self::Support => "an inner support",
        }
    }
}

impl<'a> Places<'a> {
    /// Those of a force, or of a motion as a response.
    pub(super) fn of_motion(model: &'a Model) -> Self {
        Self::new(&["left", "right"], true, Some(Named::Subsystem), model)
    }

    /// Those of a quantity.
    pub(super) fn of(quantity: &Quantity, model: &'a Model) -> Self {
        match quantity {
            Quantity::Motion(..) => Self::of_motion(model),
            Quantity::Reaction(_) => {
                let words = &["left", "right", "ground"];
                Self::new(words, false, Some(Named::Support), model)
            }
            Quantity::InternalForce(..) => Self::new(&["left", "right"], true, None, model),
            Quantity::Spring(..) => Self::new(&[], false, Some(Named::Subsystem), model),
            Quantity::Energy => Self::new(&[], false, None, model),
        }
    }

    fn new(
        words: &'static [&'static str],
        any: bool,
        named: Option<Named>,
        model: &'a Model,
    ) -> Self {
        let names = match named {
            Some(Named::Subsystem) => model.subsystems.iter().map(|of| of.name.as_str()).collect(),
            Some(Named::Support) => {
                let inner = model.supports.inner.iter();
                inner.map(|of| of.name.as_str()).collect()
            }
            None => Vec::new(),
        };
        Self {
            words,
            any,
            names,
            named,
        }
    }

    /// The position of a typed text; a change of a distance such as `*1.1` starts from `now`.
    ///
    /// # Errors
    /// The text is no position that is accepted here; the message says what is.
    pub(super) fn read<'b>(&'b self, text: &'b str, now: At<'_>) -> Result<At<'b>, String> {
        let text = text.trim();
        let named = |name: &'b str| {
            let of = self.named.filter(|_| self.names.contains(&name))?;
            Some(match of {
                Named::Subsystem => At::Subsystem(name),
                Named::Support => At::Support(name),
            })
        };
        if self.words.contains(&text) {
            return Ok(match text {
                "left" => At::Beam(Place::Left),
                "right" => At::Beam(Place::Right),
                _ => At::Ground,
            });
        }
        if let Some(at) = unquoted(text).and_then(named) {
            return Ok(at);
        }
        let now = match now {
            At::Beam(Place::Position(position)) => position,
            _ => f64::NAN,
        };
        let number = value_input::number(text, now, &Unit::METRE);
        match number {
            Ok(position) if self.any => Ok(At::Beam(Place::Position(position))),
            _ => named(text).ok_or_else(|| {
                let near = self.near(text);
                format!("is {text:?}{near}; must be {}", self.listed())
            }),
        }
    }

    /// Why a name is no position here, and what is; with a similar name if `hint`.
    pub(super) fn refusal(&self, name: &str, hint: bool) -> String {
        let near = if hint { self.near(name) } else { String::new() };
        let none = if self.names.is_empty() && self.named.is_some() {
            " (there is none)"
        } else {
            ""
        };
        let what = self.named.map_or("a place", Named::words);
        let quoted = self.words.iter().map(|word| format!("{word:?}"));
        let accepted = in_words(quoted.collect(), self.any, self.of_name());
        format!("{name:?} is not {what}{near}; must be {accepted}{none}")
    }

    /// The accepted positions except distances and disabled subsystems, as texts that [`Self::read`] reads.
    pub(super) fn texts(&self, model: &Model) -> Vec<String> {
        let is_off = |name: &&&str| {
            let mut disabled = model.subsystems.iter().filter(|one| !one.enabled);
            disabled.any(|one| one.name == ***name)
        };
        let names = self.names.iter().filter(|name| !is_off(name));
        let words = self.words.iter().map(|word| (*word).to_owned());
        words
            .chain(names.map(|name| text(At::Support(name))))
            .collect()
    }

    /// The accepted positions for people, with the names if they are few.
    pub(super) fn listed(&self) -> String {
        let words = self.words.iter().map(|word| (*word).to_owned()).collect();
        let names = match self.names.len() {
            0 => None,
            1..=MOST_LISTED => {
                let names: Vec<String> = self.names.iter().map(|name| segment(name)).collect();
                Some(names.join(", "))
            }
            _ => self.of_name(),
        };
        in_words(words, self.any, names)
    }

    fn of_name(&self) -> Option<String> {
        self.named.map(|named| format!("{}'s name", named.words()))
    }

    /// A similar position, in parentheses.
    fn near(&self, text: &str) -> String {
        let known = self.words.iter().chain(&self.names).copied();
        nearest(text, known).map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"))
    }
}

/// Words, a distance and names as a list with "or" before the last one.
fn in_words(mut words: Vec<String>, any: bool, names: Option<String>) -> String {
    words.extend(any.then(|| "a position in m".to_owned()));
    words.extend(names);
    match words.pop() {
        Some(last) if words.is_empty() => last,
        Some(last) => format!("{} or {last}", words.join(", ")),
        None => String::new(),
    }
}

/// A position as text that [`Places::read`] reads back: `left`, `right`, `ground`, `1.6 m`, or a name, in quotes if it could be
/// read as one of the others.
pub(super) fn text(at: At<'_>) -> String {
    match at {
        At::Beam(Place::Left) => "left".to_owned(),
        At::Beam(Place::Right) => "right".to_owned(),
        At::Ground => "ground".to_owned(),
        At::Beam(Place::Position(position)) => Unit::METRE.format_exact(position),
        At::Subsystem(name) | At::Support(name) if is_plain(name) => name.to_owned(),
        At::Subsystem(name) | At::Support(name) => format!("'{name}'"),
    }
}

/// Whether [`Places::read`] reads a name without quotes as a name.
fn is_plain(name: &str) -> bool {
    let place = matches!(name, "" | "left" | "right" | "ground")
        || value_input::number(name, 0.0, &Unit::METRE).is_ok();
    !place && name.trim() == name && unquoted(name).is_none()
}

/// The text inside quotes; none without quotes.
fn unquoted(text: &str) -> Option<&str> {
    let quoted = |quote| {
        text.strip_prefix(quote)
            .and_then(|rest: &str| rest.strip_suffix(quote))
    };
    quoted('\'').or_else(|| quoted('"'))
}
