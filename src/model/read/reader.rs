//! The faults found while a text is read, and their positions.

use super::super::fault::Fault;
use super::super::spelling;
use std::collections::{HashMap, HashSet};

/// A fault at a byte offset.
struct Found {
    offset: usize,
    fault: Fault,
    /// Another offset, whose line the message names.
    first: Option<usize>,
}

/// The faults found so far, and the position of each path in the text.
#[derive(Default)]
pub(crate) struct Reader {
    found: Vec<Found>,
    /// Paths whose further faults are suppressed, also below them.
    silenced: HashSet<String>,
    /// Byte offsets.
    places: HashMap<String, usize>,
    /// Paths of the checks that differ from those of the text, with the latter.
    aliases: HashMap<String, String>,
    /// A subsystem's name is unreadable, so references to it cannot be checked.
    pub(super) subsystem_lost: bool,
    /// The same for a response.
    pub(super) response_lost: bool,
}

impl Reader {
    /// Records the position of a path.
    pub(super) fn place(&mut self, path: &str, offset: usize) {
        self.places.insert(path.to_owned(), offset);
    }

    /// Records that the path `checked` of the checks is `path` in the text.
    pub(super) fn alias(&mut self, checked: String, path: String) {
        self.aliases.insert(checked, path);
    }

    /// Converts a path of the checks to that of the text.
    fn in_text(&self, path: String) -> String {
        let found = ancestors(&path).find_map(|above| Some((above, self.aliases.get(above)?)));
        match found {
            Some((above, text)) => format!("{text}{}", &path[above.len()..]),
            None => path,
        }
    }

    /// Records a fault.
    pub(crate) fn fault(&mut self, offset: usize, path: &str, message: impl Into<String>) {
        self.silence(path);
        self.found.push(Found {
            offset,
            fault: Fault::new(path, message),
            first: None,
        });
    }

    /// Records a name that is already used at another offset.
    pub(super) fn used_twice(&mut self, offset: usize, path: &str, name: &str, first: usize) {
        self.silence(path);
        let fault = Fault::new(path, format!("{name:?} is used twice"));
        self.found.push(Found {
            offset,
            fault,
            first: Some(first),
        });
    }

    /// Suppresses further faults of the path.
    pub(super) fn silence(&mut self, path: &str) {
        self.silenced.insert(path.to_owned());
    }

    /// Records a word that is not accepted.
    pub(super) fn wrong_word(&mut self, offset: usize, path: &str, word: &str, words: &[&str]) {
        // Words of one or two letters are all near each other.
        let near = spelling::nearest(word, words.iter().copied())
            .filter(|_| word.chars().nth(2).is_some());
        let near = near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
        self.fault(
            offset,
            path,
            format!("is {}{near}; must be {}", quoted(word), one_of(words)),
        );
    }

    /// Whether a misspelt key still gets a suggestion: the search is slow if the whole text has unknown keys.
    pub(super) fn may_hint(&self) -> bool {
        const MOST_HINTS: usize = 1_000;
        self.found.len() < MOST_HINTS
    }

    /// Adds the faults of the checks, except those that result from earlier faults.
    pub(super) fn adopt(&mut self, faults: Vec<Fault>) {
        for mut fault in faults {
            fault.path = self.in_text(fault.path);
            if !self.is_known(&fault.path) && !self.follows_from_lost_name(&fault.path) {
                let offset = ancestors(&fault.path)
                    .find_map(|path| self.places.get(path))
                    .copied()
                    .unwrap_or(0);
                self.found.push(Found {
                    offset,
                    fault,
                    first: None,
                });
            }
        }
    }

    fn is_known(&self, path: &str) -> bool {
        ancestors(path).any(|path| self.silenced.contains(path))
    }

    /// Whether a fault may result from an unreadable name.
    fn follows_from_lost_name(&self, path: &str) -> bool {
        let plan =
            (path.starts_with("studies.") || path.starts_with("tune.")) && last(path) != "name";
        (self.subsystem_lost && (plan || last(path) == "at")) || (self.response_lost && plan)
    }

    /// Whether there are no faults.
    pub(crate) fn is_content(&self) -> bool {
        self.found.is_empty()
    }

    /// The faults in the order of the text, with lines and columns.
    pub(crate) fn into_faults(mut self, text: &str) -> Vec<Fault> {
        let mut offsets: Vec<_> = self
            .found
            .iter()
            .flat_map(|found| [Some(found.offset), found.first])
            .flatten()
            .collect();
        offsets.sort_unstable();
        let mut cursor = Cursor::new(text);
        let places: HashMap<_, _> = offsets
            .into_iter()
            .map(|offset| (offset, cursor.advance(offset)))
            .collect();
        self.found.sort_by_key(|found| found.offset);
        let mut faults = Vec::new();
        for Found {
            offset,
            mut fault,
            first,
        } in self.found
        {
            if let Some((line, column)) = places.get(&offset) {
                (fault.line, fault.column) = (Some(*line), Some(*column));
            }
            if let Some((line, _)) = first.and_then(|first| places.get(&first)) {
                fault.message = format!("{}, first in line {line}; must be unique", fault.message);
            }
            faults.push(fault);
        }
        faults.dedup();
        faults
    }
}

/// The path itself, then each one above it.
fn ancestors(path: &str) -> impl Iterator<Item = &str> {
    std::iter::successors(Some(path), |path| path.rfind('.').map(|dot| &path[..dot]))
}

/// The last segment.
fn last(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

/// A text in quotes, truncated if very long.
pub(crate) fn quoted(text: &str) -> String {
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{:?}...", &text[..end]),
        None => format!("{text:?}"),
    }
}

/// `"a"`, `"a" or "b"`, `"a", "b" or "c"`.
pub(super) fn one_of(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("{word:?}")).collect();
    match quoted.as_slice() {
        [] => String::new(),
        [only] => only.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

/// Converts rising byte offsets to lines and columns in a single pass over the text.
struct Cursor<'a> {
    rest: &'a str,
    offset: usize,
    line: usize,
    column: usize,
}

impl<'a> Cursor<'a> {
    /// At the start of the text.
    fn new(text: &'a str) -> Self {
        Self {
            rest: text,
            offset: 0,
            line: 1,
            column: 1,
        }
    }

    /// Line and column, from 1 and in characters, of an offset that is not before the previous one.
    fn advance(&mut self, offset: usize) -> (usize, usize) {
        let mut length = offset.saturating_sub(self.offset).min(self.rest.len());
        while !self.rest.is_char_boundary(length) {
            length -= 1;
        }
        let (passed, rest) = self.rest.split_at(length);
        match passed.rfind('\n') {
            Some(newline) => {
                self.line += passed.matches('\n').count();
                self.column = 1 + passed[newline + 1..].chars().count();
            }
            None => self.column += passed.chars().count(),
        }
        self.rest = rest;
        self.offset += length;
        (self.line, self.column)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_below_a_fault_are_suppressed() {
        let mut reader = Reader::default();
        reader.place("beam", 4);
        reader.fault(7, "beam.section", "is missing");
        reader.adopt(vec![
            Fault::new("beam.section.area", "is nan"),
            Fault::new("beam.length", "is nan"),
        ]);
        let faults = reader.into_faults("ab\ncdefghi");
        assert_eq!(
            faults.iter().map(ToString::to_string).collect::<Vec<_>>(),
            ["2:2: beam.length: is nan", "2:5: beam.section: is missing"]
        );
    }

    #[test]
    fn lists_of_words_are_joined_with_or() {
        assert_eq!(one_of(&["a"]), "\"a\"");
        assert_eq!(one_of(&["a", "b", "c"]), "\"a\", \"b\" or \"c\"");
    }

    #[test]
    fn columns_count_characters() {
        let mut cursor = Cursor::new("aé\nöb\n\nc");
        assert_eq!(cursor.advance(0), (1, 1));
        assert_eq!(cursor.advance(3), (1, 3));
        assert_eq!(cursor.advance(6), (2, 2));
        assert_eq!(cursor.advance(6), (2, 2));
        assert_eq!(cursor.advance(99), (4, 2));
    }

    #[test]
    fn an_offset_inside_a_character_is_that_character() {
        assert_eq!(Cursor::new("éb").advance(1), (1, 1));
    }
}
