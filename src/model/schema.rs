//! The schema of the model file: one row per key, with its symbol, unit, meaning, kind and range.
//!
//! Reading, writing, checking, parameter paths and the designer's tree use these rows, so each key is described once.
//! A number that is added here is read, written, checked, described and shown.

use crate::unit::Unit;

/// The fewest frequencies of a sweep.
pub const FEWEST_POINTS: usize = 2;
/// The most frequencies of a sweep.
pub const MOST_POINTS: usize = 1_000_000;

/// A key of a table of the model file.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// The key in its table of the file; a dot separates the key of an inner table (`y_left.stiffness`).
    pub key: &'static str,
    /// The symbol in the literature; empty if it has none.
    pub symbol: &'static str,
    /// Unit of a number.
    pub unit: Unit,
    /// Its meaning, for people.
    pub meaning: &'static str,
    /// The kind of its value.
    pub kind: Kind,
    /// The range of a number.
    pub range: Range,
    /// The default of a number; none if the file must give it. 0 of a flag that is false by default.
    pub default: Option<f64>,
    /// Whether it is a stiffness or damping, which is searched on a logarithmic scale.
    pub is_spring: bool,
    /// The words of a choice; the first is the default.
    pub words: &'static [&'static str],
    /// The same words for people, if those of the file are not clear.
    pub spoken: &'static [&'static str],
}

impl Key {
    /// Whether a flag is true where the file does not set it.
    pub fn is_on_by_default(&self) -> bool {
        self.default != Some(0.0)
    }
}

/// The kind of a key's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// A whole number.
    Count,
    /// True or false.
    Flag,
    /// One of some words.
    Word,
    /// One line of text.
    Line,
    /// Any text; the default is empty.
    Text,
    /// A name that is unique in its list.
    Name,
    /// The position of a force or response.
    Place,
    /// The motion of a force or response.
    Direction,
    /// What is measured of a response.
    Measure,
    /// The name of the response that divides another one; optional.
    Over,
    /// One word for all motions of a support.
    Support,
    /// The restraint of one motion of a support.
    Restraint,
    /// What joins one motion of both sides of a joint.
    Link,
    /// Whether a span has a table of the beam or its own.
    Table,
    /// The paths of the parameters of a variable.
    Paths,
    /// The scale of a variable's search; optional.
    Scale,
    /// The name of a response.
    Response,
    /// A text that is not blank.
    Filled,
    /// The same, optional.
    Optional,
}

/// The range of a finite number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// Any finite number.
    Any,
    /// 0 or more.
    NonNegative,
    /// More than 0.
    Positive,
}

impl Range {
    /// Whether a value is in the range. Accepts NaN, because the reader has already reported it.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Any => true,
            Self::NonNegative => value >= 0.0 || value.is_nan(),
            Self::Positive => value > 0.0 || value.is_nan(),
        }
    }

    /// The range in words: "any number", ">= 0", "> 0".
    pub const fn words(self) -> &'static str {
        match self {
            Self::Any => "any number",
            Self::NonNegative => ">= 0",
            Self::Positive => "> 0",
        }
    }
}

/// Functions that get and set the value of a key in its struct, unchecked.
#[derive(Debug)]
pub enum Access<T> {
    /// A number.
    Number(fn(&T) -> f64, fn(&mut T, f64)),
    /// An optional number.
    OptionalNumber(fn(&T) -> Option<f64>, fn(&mut T, Option<f64>)),
    /// A whole number.
    Count(fn(&T) -> usize, fn(&mut T, usize)),
    /// A flag.
    Flag(fn(&T) -> bool, fn(&mut T, bool)),
    /// The index of a word.
    Word(fn(&T) -> usize, fn(&mut T, usize)),
    /// A text.
    Text(fn(&T) -> &String, fn(&mut T) -> &mut String),
    /// An optional text.
    Optional(fn(&T) -> Option<&String>, fn(&mut T, Option<String>)),
    /// With its own rules.
    Own,
}

/// A kind of table, selected by one word, with its own keys.
#[derive(Debug)]
pub struct Choice<T: 'static> {
    /// The key that selects it.
    pub key: &'static str,
    /// The word that selects it; empty if the key accepts any text.
    pub word: &'static str,
    /// Makes the value before its keys are read.
    pub blank: fn() -> T,
    /// The kind of response that it requires.
    pub response: Asked,
    /// Its keys.
    pub rows: Rows<T>,
    /// Its wording for people.
    pub wording: Wording,
}

/// The kind of response that an aim or a limit requires.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// None.
    Nothing,
    /// A motion or an energy.
    Any,
    /// A motion.
    Motion,
    /// A displacement.
    Displacement,
}

/// The wording of an aim or a limit. A key in braces is replaced by its value, `{response}` and `{band}` by those of
/// the objective; a part in brackets is omitted if a value in it is empty.
#[derive(Debug)]
pub struct Wording {
    /// The label of its row of the tree.
    pub label: &'static str,
    /// The value of that row.
    pub value: &'static str,
    /// The full description.
    pub whole: &'static str,
    /// The name of its figure in a report; empty for a limit.
    pub figure: &'static str,
}

impl<T> Choice<T> {
    /// The choice among `all` that a value belongs to.
    pub fn of<'a>(all: &'a [Self], value: &T) -> Option<&'a Self> {
        let kind = std::mem::discriminant(value);
        all.iter()
            .find(|one| std::mem::discriminant(&(one.blank)()) == kind)
    }

    /// Whether a key belongs to it.
    pub fn has(&self, key: &str) -> bool {
        let of_response = key == "response" && self.response != Asked::Nothing;
        of_response || self.rows.keys.iter().any(|own| own.key == key)
    }
}

/// The keys of a table of the file, with the access to them.
#[derive(Debug)]
pub struct Rows<T: 'static> {
    /// The keys, in the order of the file.
    pub keys: &'static [Key],
    /// The access to each of them.
    pub access: &'static [Access<T>],
}

impl<T> Rows<T> {
    /// Every key with its access.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Key, &'static Access<T>)> + use<T> {
        self.keys.iter().zip(self.access)
    }

    /// The keys of numbers, with their values.
    pub fn numbers(&self, of: &T) -> impl Iterator<Item = (&'static Key, f64)> {
        self.iter().filter_map(move |(key, access)| match access {
            Access::Number(get, _) => Some((key, get(of))),
            Access::OptionalNumber(get, _) => Some((key, get(of)?)),
            _ => None,
        })
    }
}

/// A key with no special properties.
const BLANK: Key = Key {
    key: "",
    symbol: "",
    unit: Unit::ONE,
    meaning: "",
    kind: Kind::Text,
    range: Range::Any,
    default: None,
    is_spring: false,
    words: &[],
    spoken: &[],
};

/// The description of a row of `rows!`.
macro_rules! key {
    (number $key:literal, $symbol:literal, $unit:ident, $range:ident $(or $default:literal)?, $meaning:literal, $($place:ident).+) => {
        Key { key: $key, symbol: $symbol, unit: Unit::$unit, meaning: $meaning, kind: Kind::Number, range: Range::$range, default: [$(Some($default),)? None][0], ..BLANK }
    };
    (spring $key:literal, $symbol:literal, $unit:ident, $meaning:literal, $($place:ident).+) => {
        Key { is_spring: true, ..key!(number $key, $symbol, $unit, NonNegative or 0.0, $meaning, $($place).+) }
    };
    (required_spring $key:literal, $symbol:literal, $unit:ident, $meaning:literal, $place:ident) => {
        Key { is_spring: true, ..key!(number $key, $symbol, $unit, NonNegative, $meaning, $place) }
    };
    (optional_number $key:literal, $symbol:literal, $unit:ident, $range:ident, $meaning:literal, $place:ident) => {
        key!(number $key, $symbol, $unit, $range, $meaning, $place)
    };
    (number_of $key:literal, $unit:ident, $range:ident, $meaning:literal, $of:path, $field:ident) => {
        Key { key: $key, unit: Unit::$unit, meaning: $meaning, kind: Kind::Number, range: Range::$range, ..BLANK }
    };
    (word_of $key:literal, $words:ident, $meaning:literal, $of:path, $field:ident) => {
        Key { spoken: $words::SPOKEN, ..key!(word $key, $words, $meaning, $field) }
    };
    (text_of $key:literal, $kind:ident, $meaning:literal, $of:path, $field:ident) => {
        Key { key: $key, meaning: $meaning, kind: Kind::$kind, ..BLANK }
    };
    (word $key:literal, $words:ident, $meaning:literal, $place:ident) => {
        Key { key: $key, meaning: $meaning, kind: Kind::Word, words: $words::WORDS, ..BLANK }
    };
    (switch $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Key { default: Some(0.0), ..key!(flag $key, $kind, $meaning, $place) }
    };
    ($access:ident $key:literal, $kind:ident, $meaning:expr $(, $place:ident)?) => {
        Key { key: $key, meaning: $meaning, kind: Kind::$kind, ..BLANK }
    };
}

/// The access of a row of `rows!`.
macro_rules! access {
    (number $key:literal, $symbol:literal, $unit:ident, $range:ident $(or $default:literal)?, $meaning:literal, $($place:ident).+) => {
        Access::Number(|of| of.$($place).+, |of, value| of.$($place).+ = value)
    };
    (spring $key:literal, $symbol:literal, $unit:ident, $meaning:literal, $($place:ident).+) => {
        access!(number $key, $symbol, $unit, NonNegative or 0.0, $meaning, $($place).+)
    };
    (required_spring $key:literal, $symbol:literal, $unit:ident, $meaning:literal, $place:ident) => {
        access!(number $key, $symbol, $unit, NonNegative, $meaning, $place)
    };
    (optional_number $key:literal, $symbol:literal, $unit:ident, $range:ident, $meaning:literal, $place:ident) => {
        Access::OptionalNumber(|of| of.$place, |of, value| of.$place = value)
    };
    (number_of $key:literal, $unit:ident, $range:ident, $meaning:literal, $of:path, $field:ident) => {
        Access::Number(
            |of| if let $of { $field, .. } = of { *$field } else { f64::NAN },
            |of, value| if let $of { $field, .. } = of { *$field = value },
        )
    };
    (word_of $key:literal, $words:ident, $meaning:literal, $of:path, $field:ident) => {
        Access::Word(
            |of| if let $of { $field, .. } = of { *$field as usize } else { 0 },
            |of, index| if let $of { $field, .. } = of { *$field = $words::ALL[index] },
        )
    };
    (text_of $key:literal, Optional, $meaning:literal, $of:path, $field:ident) => {
        Access::Optional(
            |of| if let $of { $field, .. } = of { $field.as_ref() } else { None },
            |of, text| if let $of { $field, .. } = of { *$field = text },
        )
    };
    (text_of $key:literal, $kind:ident, $meaning:literal, $of:path, $field:ident) => {
        Access::Optional(
            |of| if let $of { $field, .. } = of { Some($field) } else { None },
            |of, text| if let $of { $field, .. } = of { *$field = text.unwrap_or_default() },
        )
    };
    (word $key:literal, $words:ident, $meaning:literal, $place:ident) => {
        Access::Word(|of| of.$place as usize, |of, index| of.$place = $words::ALL[index])
    };
    (count $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Access::Count(|of| of.$place, |of, count| of.$place = count)
    };
    (flag $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Access::Flag(|of| of.$place, |of, flag| of.$place = flag)
    };
    (switch $key:literal, $kind:ident, $meaning:literal, $place:ident) => { access!(flag $key, $kind, $meaning, $place) };
    (text $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Access::Text(|of| &of.$place, |of| &mut of.$place)
    };
    (optional_text $key:literal, $kind:ident, $meaning:literal, $place:ident) => {
        Access::Optional(|of| of.$place.as_ref(), |of, text| of.$place = text)
    };
    (own $key:literal, $kind:ident, $meaning:expr) => { Access::Own };
}

/// `TABLE of Struct { kind(key, ..), .. }`; with `as Enum` the rows have names: `Name = kind(key, ..)`.
///
/// - `number(key, symbol, unit, range [or default], meaning, place in the struct)`
/// - `optional_number(key, symbol, unit, range, meaning, place)`: without a default of its own
/// - `spring(key, symbol, unit, meaning, place in the struct)`: a stiffness or damping, 0 or more, 0 by default;
///   `required_spring`: without a default
/// - `word(key, type of the words, meaning, place)`
/// - `number_of(key, unit, range, ..)`, `word_of(key, words, ..)`, `text_of(key, kind, ..)`: meaning, variant, field of
///   an enum
/// - `count`, `flag` (true by default), `switch` (a flag, false by default), `text` or `optional_text(key, kind, meaning, place)`,
///   `own(key, kind, meaning)`
macro_rules! rows {
    ($(#[$doc:meta])* $name:ident of $of:ty { $($kind:ident($($row:tt)*),)* }) => {
        $(#[$doc])*
        #[allow(missing_docs)]
        pub const $name: Rows<$of> = Rows { keys: &[$(key!($kind $($row)*)),*], access: &[$(access!($kind $($row)*)),*] };
    };
    ($(#[$doc:meta])* $name:ident of $of:ty as $names:ident { $($row_name:ident = $kind:ident($($row:tt)*),)* }) => {
        rows! { $(#[$doc])* $name of $of { $($kind($($row)*),)* } }
        #[doc = concat!("The names of the rows of [`", stringify!($name), "`].")]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[allow(missing_docs)]
        pub enum $names { $($row_name),* }
        impl $names {
            /// All of them, in the order of the rows.
            pub const ALL: [Self; $name.keys.len()] = [$(Self::$row_name),*];
        }
    };
}

mod tables;
mod tuning;

pub use tables::*;
pub use tuning::*;
