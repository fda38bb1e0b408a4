//! The text of a unit: a product of symbols.

use super::{Powers, symbols};
use crate::unit::plain_letter;

/// Longest text of a unit, bytes.
const LONGEST: usize = 60;

/// The SI factor and the powers of a product of symbols with `/` and brackets. A `/` applies to the next factor and to
/// those that a [`JOINT`] joins to it: m/s2/N, rad/N·m.
pub(super) fn product(text: &str) -> Option<(f64, Powers)> {
    if text.is_empty() || text.len() > LONGEST {
        return None;
    }
    let plain = plain(text);
    let mut rest = plain.as_str();
    let (mut scale, mut powers) = (1.0, [0; 4]);
    let mut signs = vec![1];
    // The sign of the next factor, and that of the last one, to which another may be joined.
    let (mut next, mut last) = (1, None);
    while let Some(letter) = rest.chars().next() {
        let outer = *signs.last()?;
        let after = &rest[letter.len_utf8()..];
        match letter {
            ' ' => rest = after,
            '/' if next == 1 => (next, last, rest) = (-1, None, after),
            JOINT => (next, last, rest) = (last?, None, after),
            '(' => {
                signs.push(outer * next);
                (next, last, rest) = (1, None, after);
            }
            ')' if signs.len() > 1 && next == 1 => {
                signs.pop();
                (last, rest) = (Some(outer * signs.last()?), after);
            }
            _ => {
                let (one, of, power, after) = symbol(rest)?;
                let power = power * outer * next;
                scale *= one.powi(power);
                for (sum, part) in powers.iter_mut().zip(of) {
                    *sum += part * power;
                }
                (next, last, rest) = (1, Some(next), after);
            }
        }
    }
    (signs.len() == 1 && next == 1).then_some((scale, powers))
}

/// Joins two factors: a dot, or a hyphen (lbf-in).
const JOINT: char = '·';

/// The text with plain letters for superscripts and brackets, with [`JOINT`] for dots and hyphens between factors, and
/// without `^` and the marks of abbreviations (g's, in.).
pub(super) fn plain(text: &str) -> String {
    let text = text.replace("**", "");
    let mut plain = String::with_capacity(text.len());
    let mut letters = text.chars().peekable();
    let mut before = ' ';
    while let Some(letter) = letters.next() {
        let next = letters.peek().copied().unwrap_or(' ');
        let joins = (before.is_alphanumeric() || before == ')') && next.is_alphabetic();
        match letter {
            '⁻' | '−' => plain.push('-'),
            '[' => plain.push('('),
            ']' => plain.push(')'),
            '.' | '-' if joins => plain.push(JOINT),
            '.' if before.is_alphabetic() => {}
            '⋅' => plain.push(JOINT),
            '*' | '\t' => plain.push(' '),
            '^' => {}
            '\'' | '’' if next.eq_ignore_ascii_case(&'s') => {}
            other => plain.push(plain_letter(other)),
        }
        before = letter;
    }
    unbracketed(&plain).to_owned()
}

/// A text without brackets around the whole.
fn unbracketed(text: &str) -> &str {
    let text = text.trim();
    let inside = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    match inside {
        Some(inside) if !inside.contains(['(', ')']) => inside.trim(),
        _ => text,
    }
}

/// The symbol at the start of a text: its SI factor, its powers, its exponent, and the rest.
fn symbol(text: &str) -> Option<(f64, Powers, i32, &str)> {
    // The number 1 has no powers: 1/kg.
    if let Some(rest) = text.strip_prefix('1') {
        return (!rest.starts_with(|next: char| next.is_alphanumeric() || next == '.'))
            .then_some((1.0, [0; 4], 1, rest));
    }
    let letters = |letter: char| letter.is_alphabetic() || letter == '°';
    let end = text.find(|letter| !letters(letter)).unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    let (one, powers) = symbols::find(name)?;
    let (sign, digits) = match rest.strip_prefix('-') {
        Some(rest) => (-1, rest),
        None => (1, rest),
    };
    match digits.chars().next().and_then(|digit| digit.to_digit(10)) {
        Some(exponent) => Some((one, powers, sign * exponent as i32, &digits[1..])),
        None if sign == 1 => Some((one, powers, 1, rest)),
        None => None,
    }
}

/// Whether a text starts with an angle over a length; a length that is joined to a factor (rad/in-lbf) is a lever arm.
pub(super) fn is_twist(text: &str) -> bool {
    let one = |text: &str| match symbol(text) {
        Some((_, powers, 1, rest)) => Some((powers, rest.chars().next())),
        _ => None,
    };
    text.split_once('/').is_some_and(|(angle, length)| {
        let length = length.trim_start().trim_start_matches('(');
        one(angle.trim()) == Some(([0, 0, 0, 1], None))
            && one(length)
                .is_some_and(|(powers, next)| powers == [1, 0, 0, 0] && next != Some(JOINT))
    })
}
