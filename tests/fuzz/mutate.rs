//! Randomly damaged texts: bytes, words, lines and pieces of other texts.

use crate::dice::Dice;

/// Replacements of a value.
const VALUES: &[&str] = &[
    "0",
    "-0.0",
    "1",
    "-1",
    "nan",
    "inf",
    "-inf",
    "1e400",
    "-1e-400",
    "5e-324",
    "1.7976931348623157e308",
    "1e-9",
    "0x7fffffffffffffff",
    "9223372036854775808",
    "true",
    "false",
    "\"\"",
    "\"left\"",
    "\"S1\"",
    "\"free\"",
    "\"fixed\"",
    "\"a\\u0000b\"",
    "'it''s'",
    "'''\nx'''",
    "\"\"\"\r\nx\"\"\"",
    "[]",
    "[1.0]",
    "{}",
    "{ stiffness = 1.0 }",
    "[[]]",
    "1979-05-27",
    "\"subsystems.*.mass\"",
    "[\"beam.length\"]",
    "# nothing",
];

/// Words to insert anywhere.
const PIECES: &[&str] = &[
    "\n",
    "\r\n",
    "\r",
    "\t",
    " ",
    "\u{feff}",
    "\0",
    "\u{7f}",
    "é",
    "😀",
    "\"",
    "'",
    "\"\"\"",
    "'''",
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ",",
    ".",
    "#",
    "\\",
    "_",
    "-",
    "e",
    "[beam]\n",
    "[[subsystems]]\n",
    "[[forces]]\n",
    "[sweep]\n",
    "[tune]\n",
    "kind = \"clamped\"\n",
    "enabled = false\n",
    "beam.length = 2.0\n",
    "notes = \"a\"\n",
];

/// A model file damaged in a few places; `turn` selects the seed file.
pub fn file(seeds: &[String], turn: usize, dice: &mut Dice) -> String {
    let mut text = seeds[turn % seeds.len()].clone();
    for _ in 0..=dice.roll(3) {
        text = match dice.roll(12) {
            0 => bytes(&text, dice),
            1..=4 => value(&text, dice),
            5 | 6 => lines(&text, dice),
            7 => splice(&text, &seeds[dice.roll(seeds.len())], dice),
            8 | 9 => comment(&text, dice),
            10 => text.replace('\n', "\r\n"),
            _ => insert(&text, dice.pick(PIECES), dice),
        };
    }
    text
}

/// Changes, drops or doubles a byte; invalid UTF-8 is repaired as a program would.
fn bytes(text: &str, dice: &mut Dice) -> String {
    let mut bytes = text.as_bytes().to_vec();
    if bytes.is_empty() {
        return String::new();
    }
    let at = dice.roll(bytes.len());
    match dice.roll(3) {
        0 => bytes[at] = dice.roll(256) as u8,
        1 => drop(bytes.remove(at)),
        _ => bytes.insert(at, bytes[at]),
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Puts another value after an equals sign.
fn value(text: &str, dice: &mut Dice) -> String {
    let signs: Vec<usize> = text.match_indices('=').map(|(at, _)| at + 1).collect();
    if signs.is_empty() {
        return text.to_owned();
    }
    let from = signs[dice.roll(signs.len())];
    let ends = |letter| matches!(letter, ',' | '}' | '\n' | '#');
    let to = text[from..]
        .find(ends)
        .map_or(text.len(), |length| from + length);
    let new = match text[from..to].trim().parse::<f64>() {
        Ok(old) if dice.roll(3) > 0 => format!("{:e}", old * (0.5 + dice.roll(100) as f64 / 100.0)),
        _ if dice.roll(3) == 0 => format!("{:e}", number(dice)),
        _ => dice.pick(VALUES).to_owned(),
    };
    format!("{} {new} {}", &text[..from], &text[to..])
}

/// Drops, doubles, swaps or moves lines.
fn lines(text: &str, dice: &mut Dice) -> String {
    let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
    if lines.is_empty() {
        return String::new();
    }
    let (one, other) = (dice.roll(lines.len()), dice.roll(lines.len()));
    match dice.roll(4) {
        0 => drop(lines.remove(one)),
        1 => lines.insert(other, lines[one]),
        2 => lines.swap(one, other),
        _ => drop(lines.drain(one.min(other)..one.max(other))),
    }
    lines.concat()
}

/// The beginning of one text and the end of another, or a piece of it inserted.
fn splice(text: &str, other: &str, dice: &mut Dice) -> String {
    let (cut, from) = (place(text, dice), place(other, dice));
    let rest = if dice.roll(2) == 0 { "" } else { &text[cut..] };
    format!("{}{}{rest}", &text[..cut], &other[from..])
}

/// A comment after a line.
fn comment(text: &str, dice: &mut Dice) -> String {
    let ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at).collect();
    if ends.is_empty() {
        return text.to_owned();
    }
    let at = ends[dice.roll(ends.len())];
    format!("{} # \u{20ac} = [ \"{}", &text[..at], &text[at..])
}

fn insert(text: &str, piece: &str, dice: &mut Dice) -> String {
    let at = place(text, dice);
    format!("{}{piece}{}", &text[..at], &text[at..])
}

/// Inserts between two characters.
fn place(text: &str, dice: &mut Dice) -> usize {
    let mut at = dice.roll(text.len() + 1);
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// A finite number, the ends of the range among them.
pub fn number(dice: &mut Dice) -> f64 {
    let number = match dice.roll(6) {
        0 => [0.0, -0.0, 5e-324, f64::MIN_POSITIVE, f64::MAX, -f64::MAX][dice.roll(6)],
        1 => dice.roll(100_000) as f64,
        2 => dice.roll(100_000) as f64 * 1e-7,
        _ => dice.float(),
    };
    if number.is_finite() { number } else { 1.0 }
}

/// Hasty input for a value or a path.
pub fn typed(dice: &mut Dice) -> String {
    const PARTS: &[&str] = &[
        "*",
        "/",
        "+",
        "-",
        "+=",
        "-=",
        "%",
        "x",
        "\u{d7}",
        "\u{f7}",
        "\u{2212}",
        "1",
        "0",
        "4e7",
        ".5",
        "5.",
        "1_000",
        "1e400",
        "1e-400",
        "e",
        "E+3",
        "nan",
        "inf",
        " ",
        "k",
        "M",
        "G",
        "T",
        "u",
        "\u{b5}",
        "n",
        "m",
        "mm",
        "N/m",
        "MN/m",
        "kN/mm",
        "Pa",
        "N/mm2",
        "cm4",
        "mm6",
        "kg",
        "t",
        "Hz",
        "deg",
        "\u{b0}",
        "/rad",
        "N m/rad",
        "\u{b2}",
        "true",
        "off",
        "log",
        "left",
        "S1",
        "S1 y",
        "nonsense",
        "\"",
        "'",
        "",
        "\u{fffd}",
        "subsystems",
        "supports",
        "beam",
        "length",
        "forces",
        "responses",
        "studies",
        "stiffness",
        "y_left",
        "w",
        "mass",
        "name",
        "*.",
        ".",
        ".1.",
        ".\"S1\".",
        ".*.",
        "18446744073709551616",
    ];
    (0..=dice.roll(6)).map(|_| dice.pick(PARTS)).collect()
}
