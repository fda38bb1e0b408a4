//! Finding names by parts of them.

/// A word that is a whole word of the name.
const WHOLE: i32 = 100;
/// A word with which a word of the name begins.
const START: i32 = 70;
/// A word somewhere in the name.
const WITHIN: i32 = 40;
/// A word whose letters are in the name in their order.
const SCATTERED: i32 = 20;
/// What a word counts for, against a letter that the name has too many.
const LETTERS: i32 = 256;

/// Words that are sought.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Query {
    words: Vec<String>,
}

impl Query {
    /// The words of a text; case does not count.
    pub fn new(text: &str) -> Self {
        Self {
            words: words(&text.to_lowercase()).map(str::to_owned).collect(),
        }
    }

    /// How well a name answers, more is better: each word must be in it, at least letter by letter. Of names that
    /// answer alike, the shortest says the least else. Without words every name answers alike.
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

    /// How well a description answers, less than any name: each word must stand in it as it is.
    pub fn score_with_description(&self, description: &str) -> Option<i32> {
        self.is_in(description).then_some(0)
    }

    /// Whether each word, of at least one, stands in a text as it is.
    pub fn is_in(&self, text: &str) -> bool {
        let text = text.to_lowercase();
        !self.words.is_empty() && self.words.iter().all(|word| text.contains(word))
    }
}

/// The words of a text; what parts keys and names parts words too.
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

    /// The names that answer, the best first.
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
