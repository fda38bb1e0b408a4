//! Styles as the terminal is told them (ECMA-48, 8.3.117, select graphic rendition).

use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

/// The style of letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Look {
    letters: Color,
    ground: Color,
    modifier: Modifier,
}

/// Modifiers with the codes that set and unset them; a code that unsets two of them is with both.
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

/// Modifiers that show on blanks.
const ON_BLANKS: Modifier = Modifier::REVERSED
    .union(Modifier::UNDERLINED)
    .union(Modifier::SLOW_BLINK)
    .union(Modifier::RAPID_BLINK)
    .union(Modifier::CROSSED_OUT);

impl Look {
    /// That of a terminal that was told nothing.
    pub(super) const PLAIN: Self = Self {
        letters: Color::Reset,
        ground: Color::Reset,
        modifier: Modifier::empty(),
    };

    /// That of a cell.
    pub(super) fn of(cell: &Cell) -> Self {
        Self {
            letters: cell.fg,
            ground: cell.bg,
            modifier: cell.modifier,
        }
    }

    /// Whether a cell written in this look is as it should be: a blank shows nothing of its letters' colour.
    pub(super) fn suits(self, cell: &Cell) -> bool {
        let modifiers = self.modifier | cell.modifier;
        let blank = cell.symbol() == " " && !modifiers.intersects(ON_BLANKS);
        self == Self::of(cell) || blank && self.ground == cell.bg
    }

    /// Tells the terminal to go on in the look `next`, in as few bytes as that takes.
    pub(super) fn turn(&mut self, next: Self, out: &mut Vec<u8>) {
        if *self == next {
            return;
        }
        let mut changed = String::new();
        self.change(next, &mut changed);
        let mut anew = String::new();
        if next != Self::PLAIN {
            anew.push('0');
            Self::PLAIN.change(next, &mut anew);
        }
        let codes = if anew.len() < changed.len() {
            anew
        } else {
            changed
        };
        out.extend_from_slice(b"\x1b[");
        out.extend_from_slice(codes.as_bytes());
        out.push(b'm');
        *self = next;
    }

    /// The codes from this look to another.
    fn change(self, next: Self, codes: &mut String) {
        let mut push = |code: &str| {
            if !codes.is_empty() {
                codes.push(';');
            }
            codes.push_str(code);
        };
        let mut kept = self.modifier;
        for (modifier, _, unset) in MODIFIERS {
            if kept.contains(modifier) && !next.modifier.contains(modifier) {
                push(unset);
                let same = MODIFIERS.iter().filter(|other| other.2 == unset);
                same.for_each(|other| kept.remove(other.0));
            }
        }
        for (modifier, set, _) in MODIFIERS {
            if next.modifier.contains(modifier) && !kept.contains(modifier) {
                push(set);
            }
        }
        if self.letters != next.letters {
            push(&colour(next.letters, 30));
        }
        if self.ground != next.ground {
            push(&colour(next.ground, 40));
        }
    }
}

/// The code of a colour: of letters from 30 on, of the ground from 40 on; 60 more for the bright ones.
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

    fn look(letters: Color, modifier: Modifier) -> Look {
        Look {
            letters,
            modifier,
            ..Look::PLAIN
        }
    }

    /// What is written from one look to another.
    fn turn(from: Look, to: Look) -> String {
        let (mut look, mut out) = (from, Vec::new());
        look.turn(to, &mut out);
        assert_eq!(look, to);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn the_sixteen_colours_have_codes_of_their_own() {
        let plain = Modifier::empty();
        assert_eq!(turn(Look::PLAIN, look(Color::Cyan, plain)), "\x1b[36m");
        assert_eq!(turn(Look::PLAIN, look(Color::LightRed, plain)), "\x1b[91m");
        let fixed = look(Color::Indexed(214), plain);
        assert_eq!(turn(Look::PLAIN, fixed), "\x1b[38;5;214m");
        let free = look(Color::Rgb(1, 20, 255), plain);
        assert_eq!(turn(Look::PLAIN, free), "\x1b[38;2;1;20;255m");
        let ground = Look {
            ground: Color::Blue,
            ..Look::PLAIN
        };
        assert_eq!(turn(Look::PLAIN, ground), "\x1b[44m");
    }

    #[test]
    fn the_shorter_way_is_taken() {
        let red = look(Color::Red, Modifier::empty());
        let bold = look(Color::Red, Modifier::BOLD);
        assert_eq!(turn(red, bold), "\x1b[1m");
        assert_eq!(turn(bold, red), "\x1b[22m");
        assert_eq!(turn(bold, Look::PLAIN), "\x1b[m");
        assert_eq!(turn(red, red), "");
    }

    #[test]
    fn what_is_unset_together_is_set_again() {
        let both = look(Color::Red, Modifier::BOLD | Modifier::DIM);
        let dim = look(Color::Red, Modifier::DIM);
        assert_eq!(turn(both, dim), "\x1b[22;2m");
        assert_eq!(turn(dim, both), "\x1b[1m");
    }
}
