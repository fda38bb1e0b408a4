//! Styles as escape sequences (ECMA-48, 8.3.117, select graphic rendition).

use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

/// The style of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct CellStyle {
    foreground: Color,
    background: Color,
    modifier: Modifier,
}

/// Modifiers with the codes that set and unset them; some share the unset code.
const MODIFIERS: [(Modifier, &str, &str); 9] = [
    (Modifier::BOLD, "1", "22"),
    (Modifier::DIM, "2", "22"),
    (Modifier::ITALIC, "3", "23"),
    (Modifier::UNDERLINED, "4", "24"),
    (Modifier::SLOW_BLINK, "5", "25"),
    (Modifier::RAPID_BLINK, "6", "25"),
    (Modifier::REVERSED, "7", "27"),
    (Modifier::HIDDEN, "8", "28"),
    (Modifier::CROSSED_OUT, "9", "29"),
];

/// Modifiers that are visible on blanks.
const ON_BLANKS: Modifier = Modifier::REVERSED
    .union(Modifier::UNDERLINED)
    .union(Modifier::SLOW_BLINK)
    .union(Modifier::RAPID_BLINK)
    .union(Modifier::CROSSED_OUT);

impl CellStyle {
    /// The style after a reset.
    pub(super) const DEFAULT: Self = Self {
        foreground: Color::Reset,
        background: Color::Reset,
        modifier: Modifier::empty(),
    };

    /// The style of a cell.
    pub(super) fn of(cell: &Cell) -> Self {
        Self {
            foreground: cell.fg,
            background: cell.bg,
            modifier: cell.modifier,
        }
    }

    /// Whether a cell shows correctly in this style: the foreground of a blank is invisible.
    pub(super) fn shows(self, cell: &Cell) -> bool {
        let modifiers = self.modifier | cell.modifier;
        let blank = cell.symbol() == " " && !modifiers.intersects(ON_BLANKS);
        self == Self::of(cell) || blank && self.background == cell.bg
    }

    /// Writes the shortest sequence that changes to the style `next`.
    pub(super) fn change_to(&mut self, next: Self, out: &mut Vec<u8>) {
        if *self == next {
            return;
        }
        let mut from_current = String::new();
        self.codes(next, &mut from_current);
        let mut from_reset = String::new();
        if next != Self::DEFAULT {
            from_reset.push('0');
            Self::DEFAULT.codes(next, &mut from_reset);
        }
        let codes = if from_reset.len() < from_current.len() {
            from_reset
        } else {
            from_current
        };
        out.extend_from_slice(b"\x1b[");
        out.extend_from_slice(codes.as_bytes());
        out.push(b'm');
        *self = next;
    }

    /// Appends the codes that change this style to `next`.
    fn codes(self, next: Self, codes: &mut String) {
        let mut push = |code: &str| {
            if !codes.is_empty() {
                codes.push(';');
            }
            codes.push_str(code);
        };
        let mut current = self.modifier;
        for (modifier, _, unset) in MODIFIERS {
            if current.contains(modifier) && !next.modifier.contains(modifier) {
                push(unset);
                let same = MODIFIERS.iter().filter(|other| other.2 == unset);
                same.for_each(|other| current.remove(other.0));
            }
        }
        for (modifier, set, _) in MODIFIERS {
            if next.modifier.contains(modifier) && !current.contains(modifier) {
                push(set);
            }
        }
        if self.foreground != next.foreground {
            push(&colour(next.foreground, 30));
        }
        if self.background != next.background {
            push(&colour(next.background, 40));
        }
    }
}

/// The code of a colour: foreground from 30, background from 40, 60 more for bright colours.
fn colour(colour: Color, from: u8) -> String {
    let number = match colour {
        Color::Reset => 9,
        Color::Black => 0,
        Color::Red => 1,
        Color::Green => 2,
        Color::Yellow => 3,
        Color::Blue => 4,
        Color::Magenta => 5,
        Color::Cyan => 6,
        Color::Gray => 7,
        Color::DarkGray => 60,
        Color::LightRed => 61,
        Color::LightGreen => 62,
        Color::LightYellow => 63,
        Color::LightBlue => 64,
        Color::LightMagenta => 65,
        Color::LightCyan => 66,
        Color::White => 67,
        Color::Indexed(index) => return format!("{};5;{index}", from + 8),
        Color::Rgb(r, g, b) => return format!("{};2;{r};{g};{b}", from + 8),
    };
    (from + number).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn style(foreground: Color, modifier: Modifier) -> CellStyle {
        CellStyle {
            foreground,
            modifier,
            ..CellStyle::DEFAULT
        }
    }

    /// The bytes that change one style to another.
    fn change(from: CellStyle, to: CellStyle) -> String {
        let (mut style, mut out) = (from, Vec::new());
        style.change_to(to, &mut out);
        assert_eq!(style, to);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn the_sixteen_colours_have_codes_of_their_own() {
        let plain = Modifier::empty();
        assert_eq!(
            change(CellStyle::DEFAULT, style(Color::Cyan, plain)),
            "\x1b[36m"
        );
        assert_eq!(
            change(CellStyle::DEFAULT, style(Color::LightRed, plain)),
            "\x1b[91m"
        );
        let fixed = style(Color::Indexed(214), plain);
        assert_eq!(change(CellStyle::DEFAULT, fixed), "\x1b[38;5;214m");
        let free = style(Color::Rgb(1, 20, 255), plain);
        assert_eq!(change(CellStyle::DEFAULT, free), "\x1b[38;2;1;20;255m");
        let background = CellStyle {
            background: Color::Blue,
            ..CellStyle::DEFAULT
        };
        assert_eq!(change(CellStyle::DEFAULT, background), "\x1b[44m");
    }

    #[test]
    fn the_shorter_sequence_is_written() {
        let red = style(Color::Red, Modifier::empty());
        let bold = style(Color::Red, Modifier::BOLD);
        assert_eq!(change(red, bold), "\x1b[1m");
        assert_eq!(change(bold, red), "\x1b[22m");
        assert_eq!(change(bold, CellStyle::DEFAULT), "\x1b[m");
        assert_eq!(change(red, red), "");
    }

    #[test]
    fn modifiers_with_a_shared_unset_code_are_set_again() {
        let both = style(Color::Red, Modifier::BOLD | Modifier::DIM);
        let dim = style(Color::Red, Modifier::DIM);
        assert_eq!(change(both, dim), "\x1b[22;2m");
        assert_eq!(change(dim, both), "\x1b[1m");
    }
}
