//! The way of the cursor from cell to cell.

use std::io::Write as _;

/// A column and a row, from 0.
pub(super) type Place = (u16, u16);

/// Writes the shortest way to a place, from another or from one that is not known.
///
/// A line feed goes down without going back, as terminals do in raw mode; it is never written in the last row.
pub(super) fn travel(from: Option<Place>, to: Place, out: &mut Vec<u8>) {
    if from == Some(to) {
        return;
    }
    let absolute = absolute(to);
    match from.map(|from| relative(from, to)) {
        Some(relative) if relative.len() < absolute.len() => out.extend(relative),
        _ => out.extend(absolute),
    }
}

/// By row and column; a 1 need not be written.
fn absolute((x, y): Place) -> Vec<u8> {
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

/// By steps: first down or up, then to the side, or from the row's start.
fn relative((from_x, from_y): Place, (x, y): Place) -> Vec<u8> {
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

/// So many single steps, or the code for all where that is shorter.
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

    fn way(from: Option<Place>, to: Place) -> String {
        let mut out = Vec::new();
        travel(from, to, &mut out);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn the_way_is_short() {
        assert_eq!(way(Some((5, 5)), (5, 5)), "");
        assert_eq!(way(Some((5, 5)), (6, 5)), "\x1b[C");
        assert_eq!(way(Some((5, 5)), (9, 5)), "\x1b[4C");
        assert_eq!(way(Some((5, 5)), (4, 6)), "\n\x08");
        assert_eq!(way(Some((5, 5)), (0, 6)), "\n\r");
        assert_eq!(way(Some((5, 5)), (5, 4)), "\x1b[A");
        assert_eq!(way(Some((5, 5)), (100, 30)), "\x1b[31;101H");
        assert_eq!(way(Some((90, 5)), (88, 30)), "\x1b[25B\x08\x08");
        assert_eq!(way(None, (0, 0)), "\x1b[H");
        assert_eq!(way(None, (0, 9)), "\x1b[10H");
        assert_eq!(way(None, (9, 0)), "\x1b[;10H");
    }
}
