//! Splits a header line into words and combines them to column titles.

use csv::ReaderBuilder;

use super::records::Separator;

/// A word of a line and its position, in letters from the left.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Token {
    pub(super) text: String,
    pub(super) from: usize,
    pub(super) to: usize,
}

/// Splits a line by a separator; with blanks, a unit belongs to the word before it.
pub(super) fn split(line: &str, separator: Separator) -> Vec<String> {
    let Separator::Byte(byte) = separator else {
        return joined(tokens(line))
            .into_iter()
            .map(|token| token.text)
            .collect();
    };
    let mut reader = ReaderBuilder::new()
        .delimiter(byte)
        .has_headers(false)
        .flexible(true)
        .from_reader(line.as_bytes());
    let mut record = csv::StringRecord::new();
    // Reading a text from memory does not fail.
    if !reader.read_record(&mut record).unwrap_or(false) {
        return Vec::new();
    }
    record
        .iter()
        .map(|cell| cell.trim().trim_matches('"').trim().to_owned())
        .collect()
}

/// Splits a line into words at blanks.
pub(super) fn tokens(line: &str) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::new();
    let mut is_inside = false;
    for (at, letter) in line.chars().enumerate() {
        if letter.is_whitespace() {
            is_inside = false;
            continue;
        }
        match tokens.last_mut().filter(|_| is_inside) {
            Some(token) => {
                token.text.push(letter);
                token.to = at + 1;
            }
            None => tokens.push(Token {
                text: letter.to_string(),
                from: at,
                to: at + 1,
            }),
        }
        is_inside = true;
    }
    tokens
}

/// Joins words with following text in brackets, after `in` or a slash, or inside an open bracket or quote.
pub(super) fn joined(tokens: Vec<Token>) -> Vec<Token> {
    let mut joined: Vec<Token> = Vec::new();
    for token in tokens {
        match joined.last_mut() {
            Some(last)
                if token.text.starts_with(['[', '('])
                    || matches!(token.text.as_str(), "in" | "/")
                    || is_open(&last.text) =>
            {
                append(last, &token);
            }
            _ => joined.push(token),
        }
    }
    joined
}

/// Joins words with following bare units, which get brackets.
pub(super) fn with_units(tokens: Vec<Token>, is_unit: fn(&str) -> bool) -> Vec<Token> {
    let mut all: Vec<Token> = Vec::new();
    for token in tokens {
        match all.last_mut() {
            Some(last) if is_unit(&token.text) && !last.text.ends_with([')', ']']) => {
                let text = format!("[{}]", token.text.trim_matches(['(', ')', '[', ']']));
                append(last, &Token { text, ..token });
            }
            _ => all.push(token),
        }
    }
    all
}

/// Groups words, one group per known word. An unknown word belongs to the next known word, or to the previous one if the
/// line does not end with a known word.
pub(super) fn grouped(tokens: &[Token], is_known: &[bool]) -> Vec<String> {
    let to_next = is_known.last().is_some_and(|known| *known);
    let mut groups: Vec<String> = Vec::new();
    let mut has_known = false;
    for (token, known) in tokens.iter().zip(is_known) {
        let is_new = match groups.last() {
            None => true,
            Some(_) if to_next => has_known,
            Some(_) => *known && has_known,
        };
        if is_new {
            groups.push(String::new());
            has_known = false;
        }
        has_known |= known;
        if let Some(group) = groups.last_mut() {
            if !group.is_empty() {
                group.push(' ');
            }
            group.push_str(&token.text);
        }
    }
    groups
}

/// The words above each column of some lines of numbers; none if a column has no words.
pub(super) fn placed(words: &[Token], lines: &[&str], width: usize) -> Option<Vec<Vec<String>>> {
    let rows = lines.iter().map(|line| tokens(line));
    let rows: Vec<Vec<Token>> = rows.filter(|row| row.len() == width).collect();
    let ends = (0..width).map(|column| {
        let from = rows.iter().map(|row| row[column].from).min()?;
        let to = rows.iter().map(|row| row[column].to).max()?;
        Some((from, to))
    });
    let ends: Vec<(usize, usize)> = ends.collect::<Option<_>>()?;
    // Aligned columns do not overlap.
    if ends.windows(2).any(|pair| pair[0].1 >= pair[1].0) {
        return None;
    }
    let mut groups = vec![Vec::new(); width];
    for word in words {
        let distance = |(from, to): &(usize, usize)| (from + to).abs_diff(word.from + word.to);
        let nearest = (0..width).min_by_key(|column| distance(&ends[*column]))?;
        groups[nearest].push(word.text.clone());
    }
    groups
        .iter()
        .all(|group| !group.is_empty())
        .then_some(groups)
}

fn append(last: &mut Token, token: &Token) {
    last.text.push(' ');
    last.text.push_str(&token.text);
    last.to = token.to;
}

/// Whether a bracket or quote is open at the end of a text, or a unit must follow.
fn is_open(text: &str) -> bool {
    let count = |letter: char| text.matches(letter).count();
    text.ends_with(" in")
        || text.ends_with(" /")
        || count('(') > count(')')
        || count('[') > count(']')
        || count('"') % 2 == 1
}
