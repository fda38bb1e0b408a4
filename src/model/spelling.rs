//! Names in paths, and the nearest known word to a misspelt one.

use std::collections::HashMap;

/// The longest name, characters.
pub(super) const LONGEST_NAME: usize = 200;

/// A name as one part of a parameter path, in double quotes if needed.
///
/// Quotes are needed for a name with a dot, star, quote or backslash, with a space at an end, of digits alone (which
/// are a number in a list), and for the empty name.
pub(crate) fn segment(name: &str) -> String {
    let special = name.contains(['.', '*', '"', '\'', '\\']) || name.trim() != name;
    if special || name.chars().all(|letter| letter.is_ascii_digit()) {
        format!("\"{}\"", name.replace('\\', "\\\\").replace('"', "\\\""))
    } else {
        name.to_owned()
    }
}

/// The key of each named element in a path: its name, or its number from 1 if the name is empty, not unique, too long
/// or not one line.
pub(super) fn element_keys<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut seen = HashMap::new();
    names
        .enumerate()
        .map(|(index, name)| key(name, index, *seen.entry(name).or_insert(index) == index))
        .collect()
}

/// The key of one element.
pub(super) fn element_key<'a>(names: impl Iterator<Item = &'a str>, index: usize) -> String {
    let names: Vec<&str> = names.take(index + 1).collect();
    let name = names.last().copied().unwrap_or_default();
    let is_first = names.iter().position(|other| *other == name) == Some(index);
    key(name, index, is_first)
}

fn key(name: &str, index: usize, is_first: bool) -> String {
    let fits = !name.trim().is_empty() && !name.contains(char::is_control);
    if is_first && fits && !is_too_long(name) {
        segment(name)
    } else {
        (index + 1).to_string()
    }
}

/// Whether a name is longer than [`LONGEST_NAME`].
pub(super) fn is_too_long(name: &str) -> bool {
    name.chars().nth(LONGEST_NAME).is_some()
}

/// The known word nearest to `word`, if it is near enough to suggest.
///
/// The distance is the number of edits (insert, delete, replace or swap letters; case is ignored): at most one per
/// three letters. The first of equally near words wins.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = letters(word);
    let mut best: Option<(usize, &str)> = None;
    for name in known {
        let candidate = letters(name);
        let allowed = (word.len().max(candidate.len()) / 3).max(1);
        let limit = best.map_or(allowed, |(edits, _)| allowed.min(edits.saturating_sub(1)));
        // The lengths alone often show that it is too far.
        if word.len().abs_diff(candidate.len()) > limit {
            continue;
        }
        let edits = distance(&word, &candidate);
        if edits <= limit && best.is_none_or(|(least, _)| edits < least) {
            best = Some((edits, name));
        }
    }
    best.map(|(_, name)| name)
}

fn letters(word: &str) -> Vec<char> {
    word.to_lowercase().chars().collect()
}

/// Edit distance in which a swap of neighbours is one edit (optimal string alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let other = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = other.min(above[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_quoted_where_it_must_be() {
        for plain in ["S1", "P5 w", "left", "é", "S_1-a", "1a"] {
            assert_eq!(segment(plain), plain);
        }
        for (name, quoted) in [
            ("a.b", r#""a.b""#),
            ("*", r#""*""#),
            ("12", r#""12""#),
            ("", r#""""#),
            (" a", r#"" a""#),
            ("5\" arm", r#""5\" arm""#),
            (r"a\b", r#""a\\b""#),
        ] {
            assert_eq!(segment(name), quoted);
        }
    }

    #[test]
    fn a_slip_finds_its_word() {
        let known = ["density", "young_modulus", "shear_modulus", "loss_factor"];
        assert_eq!(nearest("densty", known), Some("density"));
        assert_eq!(nearest("Young_Modulus", known), Some("young_modulus"));
        assert_eq!(nearest("youngs_modulus", known), Some("young_modulus"));
        assert_eq!(nearest("mass", known), None);
        assert_eq!(nearest("", known), None);
    }

    #[test]
    fn a_swap_is_one_edit() {
        assert_eq!(nearest("form", ["to", "from"]), Some("from"));
        assert_eq!(distance(&letters("ab"), &letters("ba")), 1);
        assert_eq!(distance(&letters("kitten"), &letters("sitting")), 3);
    }

    #[test]
    fn the_nearest_wins_and_then_the_first() {
        assert_eq!(nearest("S2", ["S11", "S1", "S3"]), Some("S1"));
        assert_eq!(nearest("S3", ["S1", "S3"]), Some("S3"));
    }
}
