//! Text cut to a width.

use ratatui::buffer::Buffer;
use ratatui::text::Span;

use crate::escape::{escape, escape_lines, is_hidden};

/// Shows a sign in place of every hidden character that a widget has let through: the terminal is sent none.
pub(crate) fn show_hidden(buffer: &mut Buffer) {
    for cell in &mut buffer.content {
        if !cell.symbol().is_ascii() && cell.symbol().contains(is_hidden) {
            cell.set_char(char::REPLACEMENT_CHARACTER);
        }
    }
}

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
    let mut lines = vec![String::new()];
    for word in escape_lines(text).split_whitespace() {
        let word = cut(word, columns);
        let Some(line) = lines.last_mut() else {
            break;
        };
        if line.is_empty() {
            line.push_str(&word);
        } else if width(line) + 1 + width(&word) <= columns {
            line.push(' ');
            line.push_str(&word);
        } else {
            lines.push(word);
        }
    }
    lines
}

/// A number with so many significant digits, without a power of ten where it can be read so.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    let digits = digits.max(2);
    let power = format!("{value:.*e}", digits - 1);
    let exponent = power
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    let least = (digits as i32 - 7).max(-3);
    match exponent {
        _ if value == 0.0 => "0".to_owned(),
        Some(exponent) if (least..6).contains(&exponent) => {
            let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
            format!("{value:.decimals$}")
        }
        _ => format!("{value:.*e}", (digits - 2).min(2)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_kept_and_powers_avoided() {
        assert_eq!(significant(7.413_04, 6), "7.41304");
        assert_eq!(significant(1_234.567_89, 6), "1234.57");
        assert_eq!(significant(999_999.7, 6), "1.00e6");
        assert_eq!(significant(0.0, 6), "0");
        assert_eq!(significant(0.012_345_67, 6), "1.23e-2");
        assert_eq!(significant(0.001_2, 4), "0.001200");
        assert_eq!(significant(1e-9, 3), "1.0e-9");
    }

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
    fn no_cell_keeps_a_hidden_character() {
        let mut buffer = Buffer::empty(ratatui::layout::Rect::new(0, 0, 3, 1));
        buffer[(0, 0)].set_symbol("a\u{200d}");
        buffer[(1, 0)].set_symbol("é");
        show_hidden(&mut buffer);
        assert_eq!(buffer, Buffer::with_lines(["\u{fffd}é "]));
    }

    #[test]
    fn lines_break_at_spaces() {
        assert_eq!(wrapped("a bc def ghij", 4), ["a bc", "def", "ghij"]);
        assert_eq!(wrapped("", 4), [""]);
    }
}
