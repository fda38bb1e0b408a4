//! Texts in a number of columns on a terminal: their width, cut off, or wrapped into lines.

use ratatui::text::Span;

use crate::escape::{escape, escape_lines};

/// Columns that a text takes as [`cut`] shows it.
pub(crate) fn width(text: &str) -> usize {
    Span::raw(escape(text)).width()
}

/// A text as it is shown: hidden characters escaped, in at most this many columns; what is cut off leaves an ellipsis.
pub(crate) fn cut(text: &str, columns: usize) -> String {
    let text = escape(text);
    if width(&text) <= columns {
        return text.into_owned();
    }
    let mut kept = String::new();
    let mut taken = 0;
    for c in text.chars() {
        let next = width(c.encode_utf8(&mut [0; 4]));
        if taken + next + 1 > columns {
            break;
        }
        taken += next;
        kept.push(c);
    }
    if columns > 0 {
        kept.push('…');
    }
    kept
}

/// A text in lines of at most this many columns, broken at spaces; hidden characters are escaped.
pub(crate) fn wrapped(text: &str, columns: usize) -> Vec<String> {
    let text = escape_lines(text);
    let words = text.split_whitespace().map(|word| cut(word, columns));
    wrap(&words.collect::<Vec<_>>().join(" "), columns, 0)
}

/// A text in lines of at most this many columns, or as wide as a longer word; all but the first begin with an indent.
pub(crate) fn wrap(text: &str, columns: usize, indent: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    let mut is_fresh = true;
    for word in text.split_whitespace() {
        if !is_fresh && width(&line) + 1 + width(word) > columns {
            lines.push(std::mem::replace(&mut line, " ".repeat(indent)));
            is_fresh = true;
        }
        if !is_fresh {
            line.push(' ');
        }
        line.push_str(word);
        is_fresh = false;
    }
    lines.push(line);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cut_text_says_so() {
        assert_eq!(cut("stiffness", 9), "stiffness");
        assert_eq!(cut("stiffness", 6), "stiff…");
        assert_eq!(cut("stiffness", 1), "…");
        assert_eq!(cut("stiffness", 0), "");
    }

    #[test]
    fn what_is_measured_is_what_is_shown() {
        assert_eq!(width("a\u{202e}b"), 10);
        assert_eq!(cut("a\u{202e}b", 10), r"a\u{202e}b");
        assert_eq!(cut("a\u{202e}b", 9), r"a\u{202e…");
        assert_eq!(wrapped("a\u{1b}[2J b\nc", 12), [r"a\u{1b}[2J b", "c"]);
    }

    #[test]
    fn lines_break_at_spaces() {
        assert_eq!(wrapped("a bc def ghij", 4), ["a bc", "def", "ghij"]);
        assert_eq!(wrapped("", 4), [""]);
    }
}
