//! The text of a path and its parts.

use std::borrow::Borrow;
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

use crate::model::spelling;

/// The path or pattern of a study or a variable. Its text is parsed once; clones share the result.
#[derive(Debug, Clone)]
pub struct Pattern(Arc<Parsed>);

#[derive(Debug)]
struct Parsed {
    text: String,
    parts: Result<Vec<Part>, String>,
}

impl Pattern {
    /// Its parts, or an error in its text.
    pub(in crate::model) fn parts(&self) -> Result<&[Part], &str> {
        self.0.parts.as_deref().map_err(String::as_str)
    }
}

impl<T: Into<String>> From<T> for Pattern {
    fn from(text: T) -> Self {
        let text = text.into();
        let parts = split(&text);
        Self(Arc::new(Parsed { text, parts }))
    }
}

impl Deref for Pattern {
    type Target = str;
    fn deref(&self) -> &str {
        &self.0.text
    }
}

impl Borrow<str> for Pattern {
    fn borrow(&self) -> &str {
        self
    }
}

impl PartialEq for Pattern {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl PartialEq<&str> for Pattern {
    fn eq(&self, other: &&str) -> bool {
        **self == **other
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self)
    }
}

#[cfg(test)]
thread_local! {
    /// The number of texts that this thread has parsed.
    pub(crate) static PARSED: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

/// A part of a path, between two dots.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::model) enum Part {
    /// `*`: any word.
    Any,
    /// A key, a name or a number.
    Word(String),
    /// A name in quotes, never a number.
    Quoted(String),
}

impl Part {
    /// The word without quotes; `*` for any.
    pub(in crate::model) fn word(&self) -> &str {
        match self {
            Self::Any => "*",
            Self::Word(word) | Self::Quoted(word) => word,
        }
    }

    /// Whether it matches a key.
    pub(in crate::model) fn means(&self, key: &str) -> bool {
        *self == Self::Any || self.word() == key
    }
}

/// Splits a path at its dots, outside of quotes.
///
/// # Errors
/// The error in the text.
fn split(path: &str) -> Result<Vec<Part>, String> {
    #[cfg(test)]
    PARSED.set(PARSED.get() + 1);
    let mut parts = Vec::new();
    let mut rest = path;
    loop {
        rest = rest.trim_start();
        let (part, after) = match rest.chars().next() {
            Some(quote @ ('"' | '\'')) => quoted(&rest[1..], quote)?,
            _ => plain(rest)?,
        };
        parts.push(part);
        match after.trim_start().strip_prefix('.') {
            Some(next) => rest = next,
            None if after.trim().is_empty() => return Ok(parts),
            None => {
                return Err(format!(
                    "`{after}` stands behind a quote; must be a dot or the end"
                ));
            }
        }
    }
}

fn plain(text: &str) -> Result<(Part, &str), String> {
    let end = text.find('.').unwrap_or(text.len());
    match text[..end].trim() {
        "" => Err("has an empty part; must be keys with a dot between them".to_owned()),
        "*" => Ok((Part::Any, &text[end..])),
        word => Ok((Part::Word(word.to_owned()), &text[end..])),
    }
}

/// A part up to its closing quote. As in TOML, a backslash escapes in double quotes only.
fn quoted(text: &str, quote: char) -> Result<(Part, &str), String> {
    let mut name = String::new();
    let mut letters = text.char_indices();
    while let Some((at, letter)) = letters.next() {
        match letter {
            '\\' if quote == '"' => name.extend(letters.next().map(|(_, escaped)| escaped)),
            letter if letter == quote => return Ok((Part::Quoted(name), &text[at + 1..])),
            letter => name.push(letter),
        }
    }
    Err(format!(
        "has a quote without its end; must be closed by {quote}"
    ))
}

/// The text of parts, with quotes where needed.
pub(in crate::model) fn join(parts: &[Part]) -> String {
    let texts = parts.iter().map(|part| match part {
        Part::Any => "*".to_owned(),
        Part::Word(word) => word.clone(),
        Part::Quoted(name) => spelling::segment(name),
    });
    texts.collect::<Vec<_>>().join(".")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn word(text: &str) -> Part {
        Part::Word(text.to_owned())
    }

    #[test]
    fn dots_split_outside_of_quotes() {
        assert_eq!(
            split("beam.length").unwrap(),
            [word("beam"), word("length")]
        );
        assert_eq!(
            split(" a . * . b c ").unwrap(),
            [word("a"), Part::Any, word("b c")]
        );
        let name = Part::Quoted("a.b".to_owned());
        assert_eq!(
            split(r#"s."a.b".m"#).unwrap(),
            [word("s"), name.clone(), word("m")]
        );
        assert_eq!(split("s.'a.b'.m").unwrap(), [word("s"), name, word("m")]);
        assert_eq!(split(r#""*""#).unwrap(), [Part::Quoted("*".to_owned())]);
        assert_eq!(
            split(r#""5\" \\""#).unwrap(),
            [Part::Quoted(r#"5" \"#.to_owned())]
        );
        assert_eq!(split(r"'a\'").unwrap(), [Part::Quoted(r"a\".to_owned())]);
    }

    #[test]
    fn broken_text_is_refused() {
        for text in [
            "", ".", "a.", ".a", "a..b", "\"a", "'a", "\"a\"b", "a.\"b\\",
        ] {
            assert!(split(text).is_err(), "{text:?} was taken");
        }
    }

    proptest! {
        #[test]
        fn every_name_survives_as_a_part(name in "\\PC*") {
            let path = format!("subsystems.{}.mass", spelling::segment(&name));
            let parts = split(&path).unwrap();
            prop_assert_eq!(parts.len(), 3);
            prop_assert_eq!(parts[1].word(), name.as_str());
            prop_assert_ne!(&parts[1], &Part::Any);
            let again = split(&join(&parts)).unwrap();
            prop_assert_eq!(again[1].word(), name.as_str());
        }

        #[test]
        fn any_text_splits_or_is_refused(text in "\\PC*") {
            let _ = split(&text);
        }
    }
}
