//! Text and screens for ASCII-only terminals.

use ratatui::buffer::Buffer;
use ratatui::text::Span;

/// The text in ASCII, with the same width in columns.
pub fn text(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for letter in text.chars() {
        let columns = Span::raw(letter.encode_utf8(&mut [0; 4]) as &str).width();
        plain.extend(std::iter::repeat_n(like(letter), columns));
    }
    plain
}

/// Replaces every other symbol on a screen by a similar one in ASCII.
pub fn flatten(buffer: &mut Buffer) {
    for cell in &mut buffer.content {
        // Combining marks are omitted; a blank follows a wide character.
        if let Some(first) = cell.symbol().chars().next()
            && !cell.symbol().is_ascii()
        {
            cell.set_char(like(first));
        }
    }
}

/// A similar ASCII character; a question mark if there is none.
fn like(letter: char) -> char {
    match letter {
        _ if letter.is_ascii() => letter,
        '─' | '━' | '╌' | '╍' | '┄' | '┈' | '╴' | '╶' | '–' | '—' | '−' | '·' | '⋅' | '▁' | '▔' => {
            '-'
        }
        '│' | '┃' | '┆' | '┊' | '╎' | '║' | '▏' | '▕' => '|',
        '┌' | '┐' | '└' | '┘' | '├' | '┤' | '┬' | '┴' | '┼' | '╭' | '╮' | '╯' | '╰' => {
            '+'
        }
        '╵' | '╹' | '‘' | '’' | '′' => '\'',
        '“' | '”' | '″' => '"',
        '▾' | '▼' | '↓' => 'v',
        '▸' | '▶' | '→' | '›' => '>',
        '◂' | '◀' | '←' | '‹' => '<',
        '▴' | '▲' | '↑' => '^',
        '↕' => '%',
        '•' | '●' | '■' | '★' => '*',
        '○' | '◦' | '◯' | '°' => 'o',
        '×' => 'x',
        '…' | '≈' | '∼' => '~',
        '█' | '▓' | '▒' | '░' | '▌' | '▐' | '▀' | '▄' => '#',
        '\u{a0}' => ' ',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴' => '4',
        '⁶' => '6',
        'µ' | 'μ' => 'u',
        _ => '?',
    }
}

#[cfg(test)]
mod tests {
    use ratatui::layout::Rect;
    use ratatui::style::Style;

    use super::*;

    #[test]
    fn what_looks_alike_takes_the_place() {
        assert_eq!(text("└─ 3 m⁴ · 5 µm …"), "+- 3 m4 - 5 um ~");
        assert_eq!(text("Träger"), "Tr?ger");
        assert_eq!(text("plain ~"), "plain ~");
    }

    #[test]
    fn the_width_is_kept() {
        // A wide character, and an accent that combines with the character before it.
        assert_eq!(text("梁 e\u{301}x"), "?? ex");
        let mut buffer = Buffer::empty(Rect::new(0, 0, 6, 1));
        buffer.set_string(0, 0, "梁│e\u{301}x", Style::new());
        flatten(&mut buffer);
        assert_eq!(buffer, Buffer::with_lines(["? |ex "]));
    }
}
