//! A short run, the same every time, of what the fuzz target `keyboard` runs without end.

use std::time::Duration;

use super::dice::Dice;

#[path = "../../fuzz/keyboard.rs"]
mod properties;

use properties::{MOST, input};

/// Pieces of terminal input, and their building blocks.
const SENT: &[&[u8]] = &[
    b"\x1b",
    b"\x1b",
    b"[",
    b"O",
    b"<",
    b"?",
    b"M",
    b"m",
    b"~",
    b"u",
    b"$",
    b";",
    b"0;5",
    b"1;5A",
    b"\x1b[200~",
    b"\x1b[201~",
    b"\x1b[<0;12;7M",
    b"\x1b[M !!",
    b"\x1b[27u",
    b"\x1b]11;rgb:0/0/0",
    b"\x1bP>|",
    b"\x1b\\",
    b"\x07",
    b"\x03",
    b"\xc3",
    b"\xe2\x82",
    b"\xac",
    b"q",
    b"jjjj",
];

/// Number of inputs from a terminal.
const INPUTS: usize = 3_000;

#[test]
fn whatever_a_terminal_sends_the_next_key_is_heard() {
    let mut dice = Dice(6);
    for turn in 0..INPUTS {
        // Mostly short; some of the maximum length.
        let most = [8, 8, 40, 400, MOST][turn % 5];
        let length = 1 + dice.roll(most);
        let mut bytes = Vec::with_capacity(length);
        while bytes.len() < length {
            match dice.roll(4) {
                0 => bytes.push(dice.roll(256) as u8),
                _ => bytes.extend_from_slice(SENT[dice.roll(SENT.len())]),
            }
        }
        let read = [1, 2, 3, 7, 16, 1024, MOST][dice.roll(7)];
        let pause = Duration::from_millis([0, 1, 10, 60, 90, 300, 900][dice.roll(7)] as u64);
        input(&bytes, read, pause);
    }
}
