//! Markdown as lines of a terminal: paragraphs wrapped, tables aligned, headings and code kept.

use std::iter::Peekable;
use std::str::Lines;

use crate::wrap::{width, wrap};

/// Columns between two cells of a table.
const GAP: usize = 2;

/// The kind of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A heading, with its `#`.
    Heading,
    /// Text, a list or a table.
    Text,
    /// A line of a code block or picture, unchanged.
    Code,
}

/// A line of a chapter as a terminal shows it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// The kind.
    pub kind: Kind,
    /// Its text.
    pub text: String,
}

/// Markdown in lines of at most this number of columns; code is not wrapped.
///
/// It understands the Markdown of the guide: headings, paragraphs, lists of one level, tables, code blocks, comments,
/// and within a line code, emphasis and links.
pub fn lines(markdown: &str, columns: usize) -> Vec<Line> {
    let mut shown = Vec::new();
    let mut source = markdown.lines().peekable();
    while let Some(line) = source.next() {
        if line.starts_with("```") {
            let code = source.by_ref().take_while(|line| !line.starts_with("```"));
            shown.extend(code.map(|line| of(Kind::Code, line)));
        } else if line.starts_with("<!--") {
        } else if line.starts_with('#') {
            shown.push(of(Kind::Heading, line));
        } else if line.starts_with('|') {
            let rows = table_rows(line, &mut source);
            shown.extend(
                table(&rows, columns)
                    .iter()
                    .map(|line| of(Kind::Text, line)),
            );
        } else if line.is_empty() {
            // Comments leave several empty lines in a row.
            if shown.last().is_some_and(|last| !last.text.is_empty()) {
                shown.push(of(Kind::Text, ""));
            }
        } else {
            let text = plain(&paragraph(line, &mut source), true);
            let wrapped = wrap(&text, columns, marker(&text));
            shown.extend(wrapped.iter().map(|line| of(Kind::Text, line)));
        }
    }
    shown
}

fn of(kind: Kind, text: &str) -> Line {
    Line {
        kind,
        text: text.to_owned(),
    }
}

/// A paragraph or an item of a list in one line.
fn paragraph(first: &str, source: &mut Peekable<Lines<'_>>) -> String {
    let mut text = first.to_owned();
    let ends = |line: &str| {
        let begins_block = ["```", "<!--", "#", "|"]
            .iter()
            .any(|mark| line.starts_with(mark));
        line.is_empty() || begins_block || marker(line) > 0
    };
    while let Some(line) = source.next_if(|line| !ends(line)) {
        text.push(' ');
        text.push_str(line.trim_start());
    }
    text
}

/// Columns of the mark before an item of a list: `- ` or `1. `; 0 where the text is no item.
fn marker(text: &str) -> usize {
    let after = text.trim_start_matches(|c: char| c.is_ascii_digit());
    let digits = text.len() - after.len();
    match (digits, after) {
        (0, after) if after.starts_with("- ") => 2,
        (1.., after) if after.starts_with(". ") => digits + 2,
        _ => 0,
    }
}

/// The cells of a table without the row of dashes; an empty row before each part.
fn table_rows(first: &str, source: &mut Peekable<Lines<'_>>) -> Vec<Vec<String>> {
    let mut rows = vec![cells(first)];
    while let Some(line) = source.next_if(|line| line.starts_with('|')) {
        // A bold row begins a part of the table.
        if line.starts_with("| **") {
            rows.push(vec![String::new()]);
        }
        if !line.starts_with("| ---") {
            rows.push(cells(line));
        }
    }
    rows
}

/// The cells of a row; `\|` is a bar within a cell.
fn cells(row: &str) -> Vec<String> {
    const BAR: char = '\u{0}';
    let row = row.replace("\\|", &BAR.to_string());
    let inside = row.trim().trim_start_matches('|').trim_end_matches('|');
    let cell = |cell: &str| plain(&cell.trim().replace(BAR, "|"), false);
    inside.split('|').map(cell).collect()
}

/// A table in aligned columns, a line of dashes below its first row.
fn table(rows: &[Vec<String>], columns: usize) -> Vec<String> {
    let widths = widths(rows, columns);
    let mut lines = Vec::new();
    for (number, row) in rows.iter().enumerate() {
        let wrapped: Vec<Vec<String>> = row
            .iter()
            .zip(&widths)
            .enumerate()
            // The indent in the first column shows where a row begins.
            .map(|(index, (cell, width))| wrap(cell, *width, if index == 0 { GAP } else { 0 }))
            .collect();
        let height = wrapped.iter().map(Vec::len).max().unwrap_or(0);
        for line in 0..height {
            let cells = wrapped
                .iter()
                .map(|cell| cell.get(line).map_or("", String::as_str));
            lines.push(aligned(cells, &widths));
        }
        if number == 0 {
            let dashes: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
            lines.push(aligned(dashes.iter().map(String::as_str), &widths));
        }
    }
    lines
}

/// The widths of a table's columns: as wide as their cells, the widest narrowed until all fit. No column gets narrower
/// than its longest word.
fn widths(rows: &[Vec<String>], columns: usize) -> Vec<usize> {
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let of_column = |measure: fn(&str) -> usize| -> Vec<usize> {
        let widest = |column: usize| {
            rows.iter()
                .filter_map(|row| row.get(column))
                .map(|cell| measure(cell))
                .max()
        };
        (0..count)
            .map(|column| widest(column).unwrap_or(0))
            .collect()
    };
    let least = of_column(|cell| {
        let words = cell.split(' ').map(width);
        words.max().unwrap_or(0)
    });
    let mut widths = of_column(width);
    while widths.iter().sum::<usize>() + GAP * count.saturating_sub(1) > columns {
        let wide = (0..count).filter(|&column| widths[column] > least[column]);
        let Some(widest) = wide.max_by_key(|&column| widths[column]) else {
            break;
        };
        widths[widest] -= 1;
    }
    widths
}

fn aligned<'a>(cells: impl Iterator<Item = &'a str>, widths: &[usize]) -> String {
    let padded = cells.zip(widths).map(|(cell, width)| {
        let blank = " ".repeat((width + GAP).saturating_sub(crate::wrap::width(cell)));
        format!("{cell}{blank}")
    });
    padded.collect::<String>().trim_end().to_owned()
}

/// A line without its marks: emphasis and links; code keeps its backticks if requested.
fn plain(text: &str, with_quotes: bool) -> String {
    let mut shown = String::new();
    let mut rest = text;
    while let Some(place) = rest.find(['`', '*', '[']) {
        let (before, marked) = rest.split_at(place);
        shown.push_str(before);
        let (inside, after) = match &marked[..1] {
            "`" => code(marked, with_quotes),
            "[" => link(marked),
            _ => (String::new(), &marked[1..]),
        };
        shown.push_str(&inside);
        rest = after;
    }
    shown + rest
}

/// The code at the start of a text, in any number of backticks, and what follows.
fn code(text: &str, with_quotes: bool) -> (String, &str) {
    let after = text.trim_start_matches('`');
    let quotes = &text[..text.len() - after.len()];
    match after.split_once(quotes) {
        Some((inside, rest)) if with_quotes => (format!("`{}`", inside.trim()), rest),
        Some((inside, rest)) => (inside.trim().to_owned(), rest),
        None => (quotes.to_owned(), after),
    }
}

/// The link at the start of a text as its words with the address in brackets, and what follows.
fn link(text: &str) -> (String, &str) {
    let parts = text[1..].split_once("](").and_then(|(words, rest)| {
        let (address, rest) = rest.split_once(')')?;
        Some((format!("{words} ({address})"), rest))
    });
    parts.unwrap_or(("[".to_owned(), &text[1..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(markdown: &str, columns: usize) -> Vec<String> {
        lines(markdown, columns)
            .into_iter()
            .map(|line| line.text)
            .collect()
    }

    #[test]
    fn paragraphs_are_wrapped_and_lists_hang() {
        let markdown = "# Title\n\nsome *few*\nwords here\n\n- one two\n  three\n10. four `a b`\n";
        let expected = [
            "# Title",
            "",
            "some few",
            "words here",
            "",
            "- one two",
            "  three",
            "10. four",
            "    `a b`",
        ];
        assert_eq!(shown(markdown, 10), expected);
    }

    #[test]
    fn a_table_is_aligned_and_its_widest_column_narrowed() {
        let markdown = "| key | what |\n| --- | --- |\n| `a` `\\|` | one two three |\n| **b** | |\n| `` ` `` | |\n";
        let expected = [
            "key  what",
            "---  -------",
            "a |  one two",
            "     three",
            "",
            "b",
            "`",
        ];
        assert_eq!(shown(markdown, 12), expected);
    }

    #[test]
    fn code_is_unchanged_and_comments_are_left_out() {
        let markdown = "a\n\n<!-- picture -->\n\n```text\n  *b*  |\n\n```\n";
        assert_eq!(shown(markdown, 5), ["a", "", "  *b*  |", ""]);
        assert_eq!(lines(markdown, 5)[2].kind, Kind::Code);
    }

    #[test]
    fn a_link_shows_its_address_and_a_bracket_stays() {
        assert_eq!(shown("[a b](http://c), [d]", 80), ["a b (http://c), [d]"]);
    }
}
