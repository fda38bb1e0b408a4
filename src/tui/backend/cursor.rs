//! Cursor movements from cell to cell.

use std::io::Write as _;

/// A column and a row, from 0.
pub(super) type CellPosition = (u16, u16);

/// Writes the shortest sequence that moves the cursor to `to`, from a known or an unknown position.
///
/// In raw mode a line feed moves down and keeps the column; it is never written in the last row.
pub(super) fn move_cursor(from: Option<CellPosition>, to: CellPosition, out: &mut Vec<u8>) {
    if from == Some(to) {
        return;
    }
    let absolute = absolute(to);
    match from.map(|from| relative(from, to)) {
        Some(relative) if relative.len() < absolute.len() => out.extend(relative),
        _ => out.extend(absolute),
    }
}

/// An absolute movement; a parameter of 1 is omitted.
fn absolute((x, y): CellPosition) -> Vec<u8> {
    let mut out = Vec::with_capacity(10);
    // Writing into memory does not fail.
    let _ = match (x, y) {
        (0, 0) => write!(out, "\x1b[H"),
        (0, _) => write!(out, "\x1b[{}H", y + 1),
        (_, 0) => write!(out, "\x1b[;{}H", x + 1),
        _ => write!(out, "\x1b[{};{}H", y + 1, x + 1),
    };
    out
}

/// A relative movement: first vertical, then horizontal, or from the start of the row.
fn relative((from_x, from_y): CellPosition, (x, y): CellPosition) -> Vec<u8> {
    let mut out = Vec::with_capacity(10);
    if y > from_y {
        step(y - from_y, b'\n', b'B', &mut out);
    } else if y < from_y {
        code(from_y - y, b'A', &mut out);
    }
    if x == 0 && from_x > 0 {
        out.push(b'\r');
    } else if x > from_x {
        code(x - from_x, b'C', &mut out);
    } else if x < from_x {
        step(from_x - x, b'\x08', b'D', &mut out);
    }
    out
}

/// `count` single steps, or one code for all if that is shorter.
fn step(count: u16, single: u8, all: u8, out: &mut Vec<u8>) {
    if count <= 3 {
        out.extend(std::iter::repeat_n(single, usize::from(count)));
    } else {
        code(count, all, out);
    }
}

fn code(count: u16, letter: u8, out: &mut Vec<u8>) {
    let _ = match count {
        1 => write!(out, "\x1b["),
        _ => write!(out, "\x1b[{count}"),
    };
    out.push(letter);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moves(from: Option<CellPosition>, to: CellPosition) -> String {
        let mut out = Vec::new();
        move_cursor(from, to, &mut out);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn movements_are_short() {
        assert_eq!(moves(Some((5, 5)), (5, 5)), "");
        assert_eq!(moves(Some((5, 5)), (6, 5)), "\x1b[C");
        assert_eq!(moves(Some((5, 5)), (9, 5)), "\x1b[4C");
        assert_eq!(moves(Some((5, 5)), (4, 6)), "\n\x08");
        assert_eq!(moves(Some((5, 5)), (0, 6)), "\n\r");
        assert_eq!(moves(Some((5, 5)), (5, 4)), "\x1b[A");
        assert_eq!(moves(Some((5, 5)), (100, 30)), "\x1b[31;101H");
        assert_eq!(moves(Some((90, 5)), (88, 30)), "\x1b[25B\x08\x08");
        assert_eq!(moves(None, (0, 0)), "\x1b[H");
        assert_eq!(moves(None, (0, 9)), "\x1b[10H");
        assert_eq!(moves(None, (9, 0)), "\x1b[;10H");
    }
}
