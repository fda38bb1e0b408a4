//! What is found wrong while a text is read, and where.

use super::super::fault::Fault;
use super::super::spelling;
use std::collections::{HashMap, HashSet};

/// A fault at a byte offset.
struct Found {
    offset: usize,
    fault: Fault,
    /// Another offset, whose line the message is to name.
    first: Option<usize>,
}

/// The faults found so far, and where each path stands in the text.
#[derive(Default)]
pub(crate) struct Reader {
    found: Vec<Found>,
    /// Paths about which no more is to be said, nor about anything below them.
    spoken: HashSet<String>,
    /// Byte offsets.
    places: HashMap<String, usize>,
    /// What the checks call otherwise than the text: from their path to the text's.
    aliases: HashMap<String, String>,
    /// A subsystem's name could not be read, so other parts may name it in vain.
    pub(super) subsystem_lost: bool,
    /// The same of a response.
    pub(super) response_lost: bool,
}

impl Reader {
    /// Notes where a path stands.
    pub(super) fn place(&mut self, path: &str, offset: usize) {
        self.places.insert(path.to_owned(), offset);
    }

    /// Notes that what the checks call `checked` is called `path` in the text.
    pub(super) fn alias(&mut self, checked: String, path: String) {
        self.aliases.insert(checked, path);
    }

    /// A path of the checks as the text has it.
    fn in_text(&self, path: String) -> String {
        let found = ancestors(&path).find_map(|above| Some((above, self.aliases.get(above)?)));
        match found {
            Some((above, text)) => format!("{text}{}", &path[above.len()..]),
            None => path,
        }
    }

    /// Notes a fault.
    pub(crate) fn fault(&mut self, offset: usize, path: &str, message: impl Into<String>) {
        self.silence(path);
        self.found.push(Found {
            offset,
            fault: Fault::new(path, message),
            first: None,
        });
    }

    /// A name that stands at another offset already.
    pub(super) fn used_twice(&mut self, offset: usize, path: &str, name: &str, first: usize) {
        self.silence(path);
        let fault = Fault::new(path, format!("{name:?} is used twice"));
        self.found.push(Found {
            offset,
            fault,
            first: Some(first),
        });
    }

    /// Nothing more is said about the path.
    pub(super) fn silence(&mut self, path: &str) {
        self.spoken.insert(path.to_owned());
    }

    /// A word that is none of the accepted ones.
    pub(super) fn wrong_word(&mut self, offset: usize, path: &str, word: &str, words: &[&str]) {
        // Between words of a letter or two everything is near.
        let near = spelling::nearest(word, words.iter().copied())
            .filter(|_| word.chars().nth(2).is_some());
        let near = near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
        self.fault(
            offset,
            path,
            format!("is {}{near}; must be {}", quoted(word), one_of(words)),
        );
    }

    /// Whether a misspelt key still gets a hint: looking for it takes a while where a whole text is not of our kind.
    pub(super) fn may_hint(&self) -> bool {
        const MOST_HINTS: usize = 1_000;
        self.found.len() < MOST_HINTS
    }

    /// Takes over the faults of the model that was read, except what follows from faults found before.
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
        ancestors(path).any(|path| self.spoken.contains(path))
    }

    /// True where a fault may come from a name that could not be read.
    fn follows_from_lost_name(&self, path: &str) -> bool {
        let plan =
            (path.starts_with("studies.") || path.starts_with("tune.")) && last(path) != "name";
        (self.subsystem_lost && (plan || last(path) == "at")) || (self.response_lost && plan)
    }

    /// True when nothing is wrong.
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

/// A text in quotes, cut off where it is very long.
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

    /// Line and column, from 1 and in characters, of an offset not before the last one asked for.
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
    fn what_lies_below_a_fault_is_not_said_again() {
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
    fn lists_of_words_are_read_aloud() {
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
