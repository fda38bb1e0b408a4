//! Numbers and strings as TOML text.

use std::fmt::Write as _;

use crate::escape::is_hidden;

/// The shortest TOML float that reads back to the same bits: `0.8`, `4e7`, `1.6625e-4`, `-0.0`.
///
/// Between 0.001 and 100,000 without an exponent; outside with an exponent unless that is longer.
pub fn format_number(value: f64) -> String {
    if value.is_nan() {
        return "nan".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "inf" } else { "-inf" }.to_owned();
    }
    let mut plain = format!("{value}");
    if !plain.contains('.') {
        plain.push_str(".0");
    }
    let size = value.abs();
    if size == 0.0 || (1e-3..1e5).contains(&size) {
        return plain;
    }
    let scientific = format!("{value:e}");
    if scientific.len() <= plain.len() {
        scientific
    } else {
        plain
    }
}

/// A TOML basic string on one line, which reads back to the same characters.
pub(crate) fn basic_string(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            // Writing to a string cannot fail.
            _ if is_hidden(letter) => {
                let code = u32::from(letter);
                let _ = match code {
                    ..=0xffff => write!(quoted, "\\u{code:04x}"),
                    _ => write!(quoted, "\\U{code:08x}"),
                };
            }
            _ => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_floats() {
        for (value, text) in [
            (4e7, "4e7"),
            (0.8, "0.8"),
            (1.6625e-4, "1.6625e-4"),
            (-0.0, "-0.0"),
            (0.0, "0.0"),
            (800.0, "800.0"),
            (-0.055, "-0.055"),
            (2.1e11, "2.1e11"),
            (1_234_567.25, "1234567.25"),
            (1e5, "1e5"),
            (f64::MAX, "1.7976931348623157e308"),
            (5e-324, "5e-324"),
        ] {
            assert_eq!(format_number(value), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
