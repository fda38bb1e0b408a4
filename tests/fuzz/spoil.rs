//! Randomly damaged files of bytes: numbers, lines, pieces of other files, cut ends.

use crate::dice::Dice;

/// Replacements of a number.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "4",
    "6",
    "18",
    "58",
    "164",
    "nan",
    "inf",
    "1e400",
    "-1e-400",
    "5e-324",
    "1.7976931348623157e308",
    "1.0+100",
    "1.5D-3",
    "1,5",
    "x",
    "",
    "99999999999999999999",
    "0x10",
    "1_0",
];

/// Words to insert anywhere.
const PIECES: &[&[u8]] = &[
    b"\n",
    b"\r\n",
    b"\r",
    b"\t",
    b" ",
    b",",
    b";",
    b"\"",
    b"#",
    b"%",
    b"!",
    b"\xef\xbb\xbf",
    b"\xff\xfe",
    b"\0",
    b"    -1\n",
    b"    58\n",
    b"    58b     1     2          11          56\n",
    b"NONE\n",
    b"[g/N]",
    b"[dB]",
    b".re",
    b".im",
    b"curve,",
    b"Frequency [Hz],",
    b"(rad)",
    b"kg m2",
    b"\n\n# \"\n",
    b" - 2i",
    b"(1+2j)",
    b"-Im",
    b"\nend\n",
    b" OK\n",
];

/// A file damaged in a few places; `turn` selects the seed file.
pub fn file(seeds: &[Vec<u8>], turn: usize, dice: &mut Dice) -> Vec<u8> {
    let mut bytes = seeds[turn % seeds.len()].clone();
    for _ in 0..=dice.roll(3) {
        let at = dice.roll(bytes.len() + 1);
        match dice.roll(10) {
            0 => bytes.truncate(at),
            1 if at < bytes.len() => bytes[at] = dice.roll(256) as u8,
            2 if at < bytes.len() => drop(bytes.remove(at)),
            3 => drop(bytes.splice(at..at, dice.pick(PIECES).iter().copied())),
            4 | 5 => lines(&mut bytes, dice),
            6 => {
                let other = &seeds[dice.roll(seeds.len())];
                let from = dice.roll(other.len() + 1);
                bytes.truncate(at);
                bytes.extend_from_slice(&other[from..]);
            }
            _ => number(&mut bytes, at, dice),
        }
    }
    bytes
}

/// Drops, doubles or swaps lines.
fn lines(bytes: &mut Vec<u8>, dice: &mut Dice) {
    let mut lines: Vec<Vec<u8>> = bytes
        .split_inclusive(|&byte| byte == b'\n')
        .map(<[u8]>::to_vec)
        .collect();
    if lines.is_empty() {
        return;
    }
    let (one, other) = (dice.roll(lines.len()), dice.roll(lines.len()));
    match dice.roll(3) {
        0 => drop(lines.remove(one)),
        1 => lines.insert(other, lines[one].clone()),
        _ => lines.swap(one, other),
    }
    *bytes = lines.concat();
}

/// Replaces the next number by another; half the time in the same number of columns.
fn number(bytes: &mut Vec<u8>, at: usize, dice: &mut Dice) {
    let part = |byte: &u8| byte.is_ascii_digit() || b"+-.eEdD".contains(byte);
    let Some(start) = bytes[at..].iter().position(part).map(|start| at + start) else {
        return;
    };
    let end = bytes[start..]
        .iter()
        .position(|byte| !part(byte))
        .map_or(bytes.len(), |length| start + length);
    let mut new = dice.pick(NUMBERS).as_bytes().to_vec();
    if dice.roll(2) == 0 {
        new.resize(end - start, b' ');
    }
    bytes.splice(start..end, new);
}
