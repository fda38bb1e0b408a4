//! Fuzzy search of names.

/// The score of a query word that equals a word of the name.
const WHOLE: i32 = 100;
/// The score of a query word that is a prefix of a word of the name.
const START: i32 = 70;
/// The score of a query word anywhere in the name.
const WITHIN: i32 = 40;
/// The score of a query word whose letters are in the name in order.
const SCATTERED: i32 = 20;
/// The weight of a query word relative to one extra letter of the name.
const LETTERS: i32 = 256;

/// The words of a query.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Query {
    words: Vec<String>,
}

impl Query {
    /// Splits a query into words; case is ignored.
    pub fn new(text: &str) -> Self {
        Self {
            words: words(&text.to_lowercase()).map(str::to_owned).collect(),
        }
    }

    /// The score of a name, higher is better: each word must match, at least letter by letter. At equal matches the
    /// shorter name wins. An empty query matches every name equally.
    pub fn score(&self, name: &str) -> Option<i32> {
        if self.words.is_empty() {
            return Some(0);
        }
        let name = name.to_lowercase();
        let scores = self.words.iter().map(|word| score(word, &name));
        let sum: i32 = scores.sum::<Option<i32>>()?;
        let letters = name.chars().count().min(LETTERS as usize - 1) as i32;
        Some(sum * LETTERS - letters)
    }

    /// The score of a match in a description, lower than any match in a name: each word must be in it literally.
    pub fn score_with_description(&self, description: &str) -> Option<i32> {
        self.is_in(description).then_some(0)
    }

    /// Whether a non-empty query has each word literally in a text.
    pub fn is_in(&self, text: &str) -> bool {
        let text = text.to_lowercase();
        !self.words.is_empty() && self.words.iter().all(|word| text.contains(word))
    }
}

/// The words of a text; separators of keys and names separate words, too.
fn words(text: &str) -> impl Iterator<Item = &str> + Clone {
    text.split(|c: char| c.is_whitespace() || matches!(c, '_' | '.' | '-'))
        .filter(|word| !word.is_empty())
}

fn score(word: &str, name: &str) -> Option<i32> {
    let mut parts = words(name);
    if parts.clone().any(|part| part == word) {
        return Some(WHOLE);
    }
    if parts.any(|part| part.starts_with(word)) {
        return Some(START);
    }
    if name.contains(word) {
        return Some(WITHIN);
    }
    let mut letters = name.chars();
    word.chars()
        .all(|wanted| letters.any(|letter| letter == wanted))
        .then_some(SCATTERED)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The matching names, best first.
    fn found<'a>(query: &str, names: &[&'a str]) -> Vec<&'a str> {
        let query = Query::new(query);
        let mut scores: Vec<_> = names
            .iter()
            .filter_map(|name| Some((query.score(name)?, *name)))
            .collect();
        scores.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
        scores.into_iter().map(|(_, name)| name).collect()
    }

    #[test]
    fn whole_words_come_first_then_starts_then_parts_then_letters() {
        let names = [
            "S12 mass",
            "S2 mount_y",
            "S2 mass",
            "mass of s2x",
            "sum 2 mass",
        ];
        assert_eq!(
            found("s2 mass", &names),
            ["S2 mass", "mass of s2x", "S12 mass", "sum 2 mass"]
        );
        assert_eq!(found("mas s2", &names)[0], "S2 mass");
        assert!(found("s2 mass x9", &names).is_empty());
    }

    #[test]
    fn keys_of_the_model_file_are_found_by_their_parts() {
        assert_eq!(
            found("left stiff", &["S1 y_left damping", "S1 y_left stiffness"]),
            ["S1 y_left stiffness"]
        );
        assert_eq!(found("y_left", &["S1 y_left damping"]).len(), 1);
    }

    #[test]
    fn nothing_typed_finds_all_and_a_description_only_by_what_stands_in_it() {
        assert_eq!(found(" ", &["b", "a"]), ["b", "a"]);
        assert_eq!(
            Query::new("file again").score_with_description("read the file again"),
            Some(0)
        );
        assert_eq!(
            Query::new("fl").score_with_description("read the file again"),
            None
        );
        assert!(!Query::new("").is_in("anything"));
    }
}
