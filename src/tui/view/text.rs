//! Text as the views show it.

use ratatui::buffer::Buffer;

use crate::escape::is_hidden;
pub(crate) use crate::wrap::{cut, width, wrapped};

/// Replaces every hidden character that a widget lets through by a sign, so that none reaches the terminal.
pub(crate) fn show_hidden(buffer: &mut Buffer) {
    for cell in &mut buffer.content {
        if !cell.symbol().is_ascii() && cell.symbol().contains(is_hidden) {
            cell.set_char(char::REPLACEMENT_CHARACTER);
        }
    }
}

/// A number with this many significant digits, without a power of ten if it is readable so.
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
    fn no_cell_keeps_a_hidden_character() {
        let mut buffer = Buffer::empty(ratatui::layout::Rect::new(0, 0, 3, 1));
        buffer[(0, 0)].set_symbol("a\u{200d}");
        buffer[(1, 0)].set_symbol("é");
        show_hidden(&mut buffer);
        assert_eq!(buffer, Buffer::with_lines(["\u{fffd}é "]));
    }
}
