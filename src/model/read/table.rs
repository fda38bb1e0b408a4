//! A table of the text whose keys are taken one by one.

use super::super::schema::Range;
use super::super::spelling;
use super::reader::{Reader, one_of};
use super::value::{Node, number, text, wrong_type};
use toml::de::{DeTable, DeValue};

/// A table and the keys requested so far; [`finish`](Self::finish) reports unknown and missing keys.
pub(crate) struct Table<'a> {
    /// Path, empty for the root.
    pub(super) path: String,
    /// Byte offset of the header or brace.
    pub(super) start: usize,
    content: &'a DeTable<'a>,
    known: Vec<&'a str>,
    missing: Vec<(&'a str, String)>,
}

/// A number of a range in a message.
fn expected_number(range: Range) -> String {
    match range {
        Range::Any => "a number".to_owned(),
        _ => format!("a number {}", range.words()),
    }
}

impl<'a> Table<'a> {
    /// The whole text.
    pub(crate) fn root(content: &'a DeTable<'a>) -> Self {
        Self {
            path: String::new(),
            start: 0,
            content,
            known: Vec::new(),
            missing: Vec::new(),
        }
    }

    /// A value that must be a table.
    pub(super) fn open(path: String, node: Node<'a>, reader: &mut Reader) -> Option<Self> {
        let start = node.span().start;
        reader.place(&path, start);
        if let DeValue::Table(content) = node.get_ref() {
            return Some(Self {
                path,
                start,
                content,
                known: Vec::new(),
                missing: Vec::new(),
            });
        }
        reader.fault(start, &path, wrong_type(node, "a table"));
        None
    }

    /// The path of a key.
    pub(super) fn at(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    /// Whether the text has a key.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.content.contains_key(key)
    }

    /// Accepts a key, whether it is read or not.
    pub(crate) fn accept(&mut self, key: &'a str) {
        if !self.known.contains(&key) {
            self.known.push(key);
        }
    }

    /// Path and value of a key, if the text has it.
    pub(crate) fn take(&mut self, key: &'a str, reader: &mut Reader) -> Option<(String, Node<'a>)> {
        self.accept(key);
        let node = self.content.get(key)?;
        let path = self.at(key);
        reader.place(&path, node.span().start);
        Some((path, node))
    }

    /// The same for a required key.
    pub(super) fn need(
        &mut self,
        key: &'a str,
        expected: &str,
        reader: &mut Reader,
    ) -> Option<(String, Node<'a>)> {
        let taken = self.take(key, reader);
        if taken.is_none() {
            self.missing.push((key, expected.to_owned()));
        }
        taken
    }

    /// Reports a missing number that another key requires.
    pub(super) fn miss_number(&mut self, key: &'a str, range: Range) {
        self.missing.push((key, expected_number(range)));
    }

    /// Accepts a list in place of a required key, which was read before: one of both must be there.
    pub(super) fn replaceable(&mut self, key: &'a str, list: &'a str, reader: &mut Reader) {
        let array = self.content.get(list).map(|node| node.get_ref().as_array());
        if array.is_none_or(|array| array.is_some_and(|array| array.is_empty())) {
            let expected = self.missing.iter_mut().find(|(missing, _)| *missing == key);
            if let Some((_, expected)) = expected {
                expected.extend([", or ", list, " in its place"]);
            }
        } else if let Some((path, node)) = self.take(key, reader) {
            let message = format!("cannot be combined with {list}; must be either {key} or {list}");
            reader.fault(node.span().start, &path, message);
        } else {
            self.missing.retain(|(missing, _)| *missing != key);
        }
    }

    /// An optional inner table.
    pub(crate) fn table(&mut self, key: &'a str, reader: &mut Reader) -> Option<Self> {
        let (path, node) = self.take(key, reader)?;
        Self::open(path, node, reader)
    }

    /// A required inner table.
    pub(super) fn need_table(&mut self, key: &'a str, reader: &mut Reader) -> Option<Self> {
        let (path, node) = self.need(key, "a table", reader)?;
        Self::open(path, node, reader)
    }

    /// The elements of an optional array.
    pub(super) fn list(&mut self, key: &'a str, of: &str, reader: &mut Reader) -> Vec<Node<'a>> {
        let Some((path, node)) = self.take(key, reader) else {
            return Vec::new();
        };
        if let DeValue::Array(array) = node.get_ref() {
            return array.iter().collect();
        }
        let below = if path.contains('.') {
            String::new()
        } else {
            format!(", each below [[{path}]]")
        };
        let message = wrong_type(node, &format!("an array of {of}{below}"));
        reader.fault(node.span().start, &path, message);
        Vec::new()
    }

    /// A number; its default if missing; NaN without a default or if unreadable.
    pub(super) fn number(
        &mut self,
        key: &'a str,
        range: Range,
        default: Option<f64>,
        reader: &mut Reader,
    ) -> f64 {
        let expected = expected_number(range);
        let taken = match default {
            Some(default) => match self.take(key, reader) {
                Some(taken) => Some(taken),
                None => return default,
            },
            None => self.need(key, &expected, reader),
        };
        taken.map_or(f64::NAN, |(path, node)| {
            number(&path, node, &expected, reader)
        })
    }

    /// A text; its default if missing; none without a default or if it is not a text.
    pub(super) fn text(
        &mut self,
        key: &'a str,
        default: Option<&str>,
        reader: &mut Reader,
    ) -> Option<String> {
        let taken = match default {
            Some(default) if !self.has(key) => {
                self.accept(key);
                return Some(default.to_owned());
            }
            _ => self.need(key, "a text in quotes", reader),
        };
        let (path, node) = taken?;
        text(&path, node, reader)
    }

    /// A flag; none if missing or unreadable.
    pub(crate) fn flag(&mut self, key: &'a str, reader: &mut Reader) -> Option<bool> {
        let (path, node) = self.take(key, reader)?;
        let flag = node.get_ref().as_bool();
        if flag.is_none() {
            reader.fault(node.span().start, &path, wrong_type(node, "true or false"));
        }
        flag
    }

    /// The index of one of some words; its default if missing; none without a default or for another word.
    pub(crate) fn word(
        &mut self,
        key: &'a str,
        words: &[&str],
        default: Option<usize>,
        reader: &mut Reader,
    ) -> Option<usize> {
        let taken = if default.is_some() && !self.has(key) {
            self.accept(key);
            return default;
        } else {
            self.need(key, &one_of(words), reader)
        };
        let (path, node) = taken?;
        let Some(word) = node.get_ref().as_str() else {
            reader.fault(node.span().start, &path, wrong_type(node, &one_of(words)));
            return None;
        };
        let index = words.iter().position(|known| *known == word);
        if index.is_none() {
            reader.wrong_word(node.span().start, &path, word, words);
        }
        index
    }

    /// Keys and values in the order of the text, for a table with arbitrary keys.
    pub(super) fn entries(&self) -> Vec<(&'a str, Node<'a>)> {
        let mut entries: Vec<_> = self.content.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        entries
            .into_iter()
            .map(|(key, node)| (key.get_ref().as_ref(), node))
            .collect()
    }

    /// Reports unknown and missing keys. A misspelt required key is reported once.
    pub(crate) fn finish(self, reader: &mut Reader) {
        let mut misspelt = Vec::new();
        for (key, _) in self.content {
            let word = key.get_ref().as_ref();
            if self.known.contains(&word) {
                continue;
            }
            let absent = self.known.iter().copied().filter(|known| !self.has(known));
            let known = self.known.iter().copied();
            let near = if reader.may_hint() {
                spelling::nearest(word, absent).or_else(|| spelling::nearest(word, known))
            } else {
                None
            };
            let message = if let Some(near) = near {
                misspelt.push(near);
                format!("is unknown; did you mean {near}?")
            } else {
                format!("is unknown; must be one of {}", self.known.join(", "))
            };
            reader.fault(
                key.span().start,
                &self.at(&spelling::segment(word)),
                message,
            );
        }
        for (key, expected) in &self.missing {
            let path = self.at(key);
            if misspelt.contains(key) {
                reader.silence(&path);
            } else {
                reader.fault(self.start, &path, format!("is missing; must be {expected}"));
            }
        }
    }
}
