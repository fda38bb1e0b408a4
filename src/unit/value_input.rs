//! Parses typed text for a parameter: a number with or without unit, or a change of the old value.

use super::{Unit, plain_letter};

/// Multipliers that may follow a number instead of a unit.
const PREFIXES: &[(&str, i32)] = &[
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
    ("u", -6),
    ("n", -9),
];

/// The new value of a number that was `old`, in the unit of the model.
///
/// A value: `4e7`, `40M`, `40 MN/m`, `80 mm`. A change: `*1.1`, `/2`, `+5%`, `-5 %`, `+= 0.3`, `-= 2 mm`. A sign
/// without `%` or `=` belongs to the value: `-5` is minus five.
///
/// # Errors
/// Why the text is not a finite number, and what is accepted.
pub fn number(text: &str, old: f64, unit: &Unit) -> Result<f64, String> {
    let text = text.trim().replace('−', "-");
    if let Some(words) = decimal_comma(&text) {
        return Err(words);
    }
    let value = if let Some(rest) = text.strip_prefix(['*', '×', 'x']) {
        old * factor(rest, unit)?
    } else if let Some(rest) = text.strip_prefix(['/', '÷']) {
        let divisor = factor(rest, unit)?;
        if divisor == 0.0 {
            return Err("cannot divide by 0".to_owned());
        }
        old / divisor
    } else if let Some(rest) = text.strip_suffix('%') {
        old * percent(rest, unit)?
    } else if let Some(rest) = text.strip_prefix("+=") {
        old + quantity(rest, unit)?
    } else if let Some(rest) = text.strip_prefix("-=") {
        old - quantity(rest, unit)?
    } else {
        quantity(&text, unit)?
    };
    if value.is_finite() {
        Ok(value)
    } else {
        Err("the result is too large".to_owned())
    }
}

/// The new value of a whole number that was `old`: `2000`, `2k`, `*2`, `/3` (rounded), `+10%`.
///
/// # Errors
/// Why the text is not a whole number of 0 or more, and what is accepted.
pub fn count(text: &str, old: usize) -> Result<usize, String> {
    let mut value = number(text, old as f64, &Unit::ONE)?;
    let changes = text.trim().starts_with(['*', '×', 'x', '/', '÷']) || text.trim().ends_with('%');
    if changes {
        value = value.round();
    }
    // Above 2^53, floats do not represent every whole number.
    if value.fract() != 0.0 || !(0.0..=9.0e15).contains(&value) {
        return Err(format!(
            "{} is not a count: accepted is a whole number, 0 or more",
            text.trim()
        ));
    }
    Ok(value as usize)
}

/// The text to type instead of a number with a comma, if the text has one.
pub fn decimal_comma(text: &str) -> Option<String> {
    let (before, after) = text.split_once(',')?;
    let number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    if !number(after) {
        return None;
    }
    if after.contains(',') {
        let without = text.replace(',', "");
        return Some(format!("a number has no comma: {without}"));
    }
    let zero = if before.ends_with(|c: char| c.is_ascii_digit()) {
        ""
    } else {
        "0"
    };
    Some(format!(
        "the decimal sign is a point: {before}{zero}.{after}"
    ))
}

/// The accepted text for a number with this unit, for people.
pub fn accepted(unit: &Unit) -> String {
    if unit.symbol.is_empty() {
        return "a number (0.02, 2e-2), or a change (*1.1, /2, +5%)".to_owned();
    }
    format!(
        "a number alone (4e7, 40M) or with {}, or a change (*1.1, /2, +5%)",
        unit.accepted()
    )
}

/// The factor of `*1.1` and `/2`: a number without unit.
fn factor(text: &str, unit: &Unit) -> Result<f64, String> {
    match split(text.trim()) {
        Some((number, "")) => scaled(number, 0),
        Some((_, rest)) => Err(format!(
            "\"{rest}\" is not accepted: a factor is a number without unit"
        )),
        None => Err(no_number(text, unit)),
    }
}

/// The factor of `+5` and `-5`, from text before a percent sign.
fn percent(text: &str, unit: &Unit) -> Result<f64, String> {
    let text = text.trim();
    let (sign, digits) = if let Some(digits) = text.strip_prefix('+') {
        (1.0, digits)
    } else if let Some(digits) = text.strip_prefix('-') {
        (-1.0, digits)
    } else {
        return Err(format!(
            "{text}% needs a sign: +{text}% or -{text}% changes the value by that part"
        ));
    };
    if digits.starts_with(['+', '-']) {
        return Err(no_number(digits, unit));
    }
    Ok((100.0 + sign * factor(digits, unit)?) / 100.0)
}

/// A number with or without unit.
fn quantity(text: &str, unit: &Unit) -> Result<f64, String> {
    let text = text.trim();
    let (number, rest) = split(text).ok_or_else(|| no_number(text, unit))?;
    scaled(number, power(rest.trim(), unit)?)
}

/// The power of ten of the text after a number.
fn power(text: &str, unit: &Unit) -> Result<i32, String> {
    if text.is_empty() {
        return Ok(0);
    }
    // A prefix alone belongs to the number: "3u m4" is 3e-6 m4, never 3 (um)^4.
    let (first, symbol) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let prefix = PREFIXES
        .iter()
        .find(|(prefix, _)| prefix.chars().eq(first.chars().map(plain_letter)))
        .map(|(_, power)| *power);
    match (prefix, symbol) {
        (Some(power), "") => Ok(power),
        (Some(power), symbol) if unit.power_of(symbol) == Some(0) => Ok(power),
        (None, symbol) if first != "m" || symbol.is_empty() => {
            unit.power_of(text).ok_or_else(|| wrong_unit(text, unit))
        }
        _ => Err(wrong_unit(text, unit)),
    }
}

fn wrong_unit(text: &str, unit: &Unit) -> String {
    if text == "m" || text.starts_with("m ") {
        return format!(
            "a single \"m\" could be milli or a typo for M: accepted is {}",
            accepted(unit)
        );
    }
    format!(
        "\"{text}\" does not fit here: accepted is {}",
        accepted(unit)
    )
}

fn no_number(text: &str, unit: &Unit) -> String {
    let said = if text.trim().is_empty() {
        "no number".to_owned()
    } else {
        format!("\"{}\" is not a number", text.trim())
    };
    format!("{said}: accepted is {}", accepted(unit))
}

/// Splits text after its leading number; none without one.
fn split(text: &str) -> Option<(&str, &str)> {
    let bytes = text.as_bytes();
    let digits = |from: usize| {
        let run = bytes[from..]
            .iter()
            .take_while(|byte| byte.is_ascii_digit() || **byte == b'_')
            .count();
        from + run
    };
    let start = usize::from(text.starts_with(['+', '-']));
    let mut end = digits(start);
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if !bytes[start..end].iter().any(u8::is_ascii_digit) {
        return None;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        // "2e" has no exponent: the letter remains for the unit, which rejects it.
        if exponent > end + 1 + sign {
            end = exponent;
        }
    }
    Some((&text[..end], &text[end..]))
}

/// The number of a text from [`split`], times a power of ten; rounded once, so that no digit is lost.
fn scaled(number: &str, power: i32) -> Result<f64, String> {
    let number = number.replace('_', "");
    let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((&number, "0"));
    // An exponent that overflows an integer is beyond every float.
    let beyond = if exponent.starts_with('-') {
        i64::MIN / 2
    } else {
        i64::MAX / 2
    };
    let exponent = exponent
        .parse()
        .unwrap_or(beyond)
        .saturating_add(i64::from(power));
    let value: f64 = format!("{mantissa}e{exponent}")
        .parse()
        .map_err(|_| format!("\"{number}\" is not a number"))?;
    if value.is_infinite() {
        return Err(format!("{number} is too large: accepted is up to 1.8e308"));
    }
    if value == 0.0 && mantissa.contains(|letter| matches!(letter, '1'..='9')) {
        return Err(format!("{number} is too small to be distinguished from 0"));
    }
    Ok(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_comma_is_answered_by_the_number_that_was_meant() {
        for (typed, meant) in [
            ("3,5", "3.5"),
            ("-0,02", "-0.02"),
            ("3,5 MN/m", "3.5 MN/m"),
            ("*1,1", "*1.1"),
            ("+2,5%", "+2.5%"),
            (",5", "0.5"),
            ("1,5e3", "1.5e3"),
        ] {
            let words = number(typed, 2.0, &Unit::STIFFNESS).unwrap_err();
            assert_eq!(words, format!("the decimal sign is a point: {meant}"));
        }
        let words = number("1,234,567", 2.0, &Unit::STIFFNESS).unwrap_err();
        assert_eq!(words, "a number has no comma: 1234567");
        assert_eq!(decimal_comma("left, right"), None);
        assert_eq!(decimal_comma("3.5"), None);
    }
    use proptest::prelude::*;

    #[test]
    fn values_are_read_with_and_without_unit() {
        let cases: &[(&str, Unit, f64)] = &[
            ("4e7", Unit::STIFFNESS, 4e7),
            ("4E+7", Unit::STIFFNESS, 4e7),
            ("40M", Unit::STIFFNESS, 4e7),
            ("40 M", Unit::STIFFNESS, 4e7),
            ("40M N/m", Unit::STIFFNESS, 4e7),
            ("40 MN/m", Unit::STIFFNESS, 4e7),
            (" 40MN / m ", Unit::STIFFNESS, 4e7),
            ("40 kN/mm", Unit::STIFFNESS, 4e7),
            ("2.1e11", Unit::PASCAL, 2.1e11),
            ("210 GPa", Unit::PASCAL, 2.1e11),
            ("80 mm", Unit::METRE, 0.08),
            ("80mm", Unit::METRE, 0.08),
            ("40m", Unit::METRE, 40.0),
            ("40 m", Unit::METRE, 40.0),
            ("40 mm", Unit::METRE, 0.04),
            ("40 µm", Unit::METRE, 4e-5),
            ("40 μm", Unit::METRE, 4e-5),
            ("40um", Unit::METRE, 4e-5),
            ("40u", Unit::METRE, 4e-5),
            ("40µ", Unit::METRE, 4e-5),
            ("116 cm2", Unit::AREA, 0.0116),
            ("116 cm²", Unit::AREA, 0.0116),
            ("166.25u m4", Unit::METRE_4, 1.6625e-4),
            ("16625 cm4", Unit::METRE_4, 1.6625e-4),
            ("0.3t", Unit::KILOGRAM, 300.0),
            ("-55 mm", Unit::METRE, -0.055),
            ("−55 mm", Unit::METRE, -0.055),
            ("+5", Unit::METRE, 5.0),
            ("-5", Unit::METRE, -5.0),
            (".5", Unit::ONE, 0.5),
            ("5.", Unit::ONE, 5.0),
            ("1_000", Unit::KILOGRAM, 1000.0),
            ("0e999999999999999999999", Unit::ONE, 0.0),
            ("1.5 MN m/rad", Unit::ROTATIONAL_STIFFNESS, 1.5e6),
            ("1.5 MNm", Unit::ROTATIONAL_STIFFNESS, 1.5e6),
            ("90 °", Unit::DEGREE, 90.0),
        ];
        for (text, unit, expected) in cases {
            assert_eq!(number(text, 7.0, unit), Ok(*expected), "{text}");
        }
    }

    #[test]
    fn changes_act_on_the_old_value() {
        let cases: &[(&str, f64, f64)] = &[
            ("*1.1", 10.0, 11.0),
            ("× 2", 10.0, 20.0),
            ("x0.5", 10.0, 5.0),
            ("*-1", 0.3, -0.3),
            ("/2", 10.0, 5.0),
            ("/ 4", 10.0, 2.5),
            ("+5%", 100.0, 105.0),
            ("-5%", 100.0, 95.0),
            ("-5 %", 100.0, 95.0),
            ("+ 5 %", 100.0, 105.0),
            ("−5%", 100.0, 95.0),
            ("-100%", 100.0, 0.0),
            ("+5%", -2.0, -2.1),
            ("+= 300 mm", 1.6, 1.6 + 0.3),
            ("-=0.3", 1.6, 1.6 - 0.3),
        ];
        for (text, old, expected) in cases {
            assert_eq!(number(text, *old, &Unit::METRE), Ok(*expected), "{text}");
        }
    }

    #[test]
    fn what_gives_no_number_is_refused() {
        let texts = [
            "",
            " ",
            "nan",
            "NaN",
            "inf",
            "-inf",
            "infinity",
            "1e400",
            "-1e400",
            "1e-400",
            "1e99999999999999999999",
            "1e-99999999999999999999",
            "1e9223372036854775807G",
            "*1e300",
            "/0",
            "/-0",
            "/0.0",
            "*",
            "/",
            "+",
            "-",
            "%",
            "+%",
            "5%",
            "+-5%",
            "*nan",
            "*2 N/m",
            "/2k",
            "1,5",
            "1.2.3",
            "2 000",
            "2e",
            "e5",
            "_",
            ".",
            "-.",
            "0x10",
            "--5",
            "1e5e5",
            "40 K",
            "40 kg",
            "40 N",
            "40 m",
            "40m N/m",
            "40m",
            "40 MPa",
            "40 k kN/m",
            "abc",
            "* *2",
            "5 +5%",
            "=5",
        ];
        for text in texts {
            assert!(
                number(text, 1e10, &Unit::STIFFNESS).is_err(),
                "{text:?} was taken"
            );
        }
        for text in ["3m m2", "3 m m2", "40m m"] {
            assert!(
                number(text, 1.0, &Unit::AREA).is_err() && number(text, 1.0, &Unit::METRE).is_err(),
                "{text}"
            );
        }
        assert!(number("166u m4", 1.0, &Unit::METRE).is_err());
        assert!(number("5 %", 1.0, &Unit::ONE).is_err());
    }

    #[test]
    fn a_refusal_says_what_is_accepted() {
        let wrong = number("40 kg", 0.0, &Unit::STIFFNESS).unwrap_err();
        assert!(
            wrong.contains("\"kg\"") && wrong.contains("MN/m"),
            "{wrong}"
        );
        assert!(
            number("40m", 0.0, &Unit::STIFFNESS)
                .unwrap_err()
                .contains("milli")
        );
        assert!(
            number("1,5", 0.0, &Unit::METRE)
                .unwrap_err()
                .contains("point")
        );
        assert!(number("5%", 1.0, &Unit::METRE).unwrap_err().contains("+5%"));
        assert!(
            number("/0", 1.0, &Unit::METRE)
                .unwrap_err()
                .contains("divide by 0")
        );
        assert!(number("abc", 1.0, &Unit::ONE).unwrap_err().contains("0.02"));
        assert!(
            !number("abc", 1.0, &Unit::ONE)
                .unwrap_err()
                .contains("with ,")
        );
    }

    #[test]
    fn counts_are_whole() {
        assert_eq!(count("2000", 1), Ok(2000));
        assert_eq!(count("2k", 1), Ok(2000));
        assert_eq!(count("*2", 2000), Ok(4000));
        assert_eq!(count("/3", 2000), Ok(667));
        assert_eq!(count("+10%", 2000), Ok(2200));
        assert_eq!(count("+= 5", 2000), Ok(2005));
        for text in ["2000.5", "-1", "1e30", "nan", "", "5 m", "*-1"] {
            assert!(count(text, 2000).is_err(), "{text:?} was taken");
        }
    }

    proptest! {
        #[test]
        fn exact_text_reads_back_to_the_bit(bits: u64, unit in prop::sample::select(Unit::ALL)) {
            let old = f64::from_bits(bits);
            prop_assume!(old.is_finite());
            let text = unit.format_exact(old);
            let read = number(&text, 1.0, &unit);
            prop_assert_eq!(read.clone().map(f64::to_bits), Ok(old.to_bits()), "{} -> {:?}", text, read);
        }

        #[test]
        fn ordinary_values_read_back_to_the_bit(old in -1e12..1e12_f64, scale in -20..3_i32, unit in prop::sample::select(Unit::ALL)) {
            let old = old * 10_f64.powi(scale);
            let text = unit.format_exact(old);
            prop_assert_eq!(number(&text, 1.0, &unit).map(f64::to_bits), Ok(old.to_bits()), "{}", text);
            prop_assert!(number(&unit.format(old), 1.0, &unit).is_ok());
        }

        #[test]
        fn any_text_gives_a_finite_number_or_a_reason(text in "\\PC*", old in -1e300..1e300_f64) {
            for unit in Unit::ALL {
                match number(&text, old, unit) {
                    Ok(value) => prop_assert!(value.is_finite()),
                    Err(reason) => prop_assert!(!reason.is_empty()),
                }
            }
        }

        #[test]
        fn text_like_numbers_never_panics(text in "[-+*/x%=.0-9eE_ kMGumµn/²N]{0,12}", old in -1e300..1e300_f64) {
            for unit in Unit::ALL {
                if let Ok(value) = number(&text, old, unit) {
                    prop_assert!(value.is_finite());
                }
            }
            let _ = count(&text, 10);
        }
    }
}
