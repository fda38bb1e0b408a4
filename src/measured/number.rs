//! Parses numbers as written by instruments, Fortran programs, numpy and MATLAB.

use num_complex::Complex64;

/// Longest number, bytes.
const LONGEST: usize = 64;

/// Parses a number: `1.5`, `1.5e-3`, `1.5D-03`, `1.5+100` (an exponent of three digits), with `comma` also `1,5`.
/// Surrounding blanks are ignored. `nan`, `inf` and values beyond the range are non-finite numbers.
pub(super) fn parse(text: &[u8], comma: bool) -> Option<f64> {
    let text = std::str::from_utf8(text.trim_ascii()).ok()?;
    if text.is_empty() || text.len() > LONGEST {
        return None;
    }
    if let Ok(number) = text.parse() {
        return Some(number);
    }
    let mut plain = text.replace(['D', 'd'], "e");
    if comma
        && !plain.contains('.')
        && let Some((whole, rest)) = plain.split_once(',')
    {
        // A trailing comma is a separator.
        if !rest.starts_with(|digit: char| digit.is_ascii_digit()) {
            return None;
        }
        plain = format!("{whole}.{rest}");
    }
    if let Ok(number) = plain.parse() {
        return Some(number);
    }
    let sign = plain.rfind(['+', '-']).filter(|&at| at > 0)?;
    let (mantissa, exponent) = plain.split_at(sign);
    let is_mantissa = mantissa.ends_with(|end: char| end.is_ascii_digit() || end == '.');
    if !is_mantissa {
        return None;
    }
    format!("{mantissa}e{exponent}").parse().ok()
}

/// Parses a complex number: `(1e-6-2e-7j)`, `1e-6 - 2e-7i`, `1+i*2`, `1 + 2*I`, `1 + 2im`, `2i`, `(1+-2j)`, `(1, 2)`.
/// A real number is not accepted.
pub(super) fn complex(text: &[u8], comma: bool) -> Option<Complex64> {
    let text = std::str::from_utf8(text.trim_ascii()).ok()?;
    // Fast path: most cells are not complex.
    if text.len() > 2 * LONGEST || !text.contains(['i', 'j', 'I', 'J', '(']) {
        return None;
    }
    let inside = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    if let Some((re, im)) = inside.and_then(|inside| inside.split_once([',', ';'])) {
        return Some(Complex64::new(
            parse(re.as_bytes(), comma)?,
            parse(im.as_bytes(), comma)?,
        ));
    }
    let is_significant = |letter: &char| !letter.is_whitespace() && *letter != '*';
    let plain: String = inside
        .unwrap_or(text)
        .chars()
        .filter(is_significant)
        .collect();
    // The sign before the imaginary part: not that of an exponent, and the first one of 1+-2i and 1+i*-2.
    let no_split = ['e', 'E', 'd', 'D', '+', 'i', 'j'];
    let signs = plain.char_indices().rev();
    let split = signs
        .filter(|(_, letter)| matches!(letter, '+' | '-'))
        .map(|(at, _)| at)
        .find(|at| !plain[..*at].ends_with(no_split))
        .unwrap_or(0);
    let (re, im) = plain.split_at(split);
    let re = if re.is_empty() {
        0.0
    } else {
        parse(re.as_bytes(), comma)?
    };
    Some(Complex64::new(re, imaginary(im, comma)?))
}

/// Parses an imaginary number: `-2e-7i`, `+j2`, `+-2j`, `2im`.
fn imaginary(text: &str, comma: bool) -> Option<f64> {
    let (sign, size) = match text.strip_prefix('-') {
        Some(size) => (-1.0, size),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let number = |text: &str| {
        // Of two signs the first must be a plus.
        let twice = text.starts_with('+') || (sign < 0.0 && text.starts_with('-'));
        let starts = text
            .starts_with(|letter: char| letter == '-' || letter == '.' || letter.is_ascii_digit());
        let is_word = matches!(text, "nan" | "inf" | "NaN" | "Inf");
        (!twice && (starts || is_word))
            .then(|| parse(text.as_bytes(), comma))
            .flatten()
    };
    let units = ["im", "i", "j", "I", "J"];
    let after = units.iter().find_map(|unit| size.strip_suffix(unit));
    let before = || units[1..].iter().find_map(|unit| size.strip_prefix(unit));
    let size = after
        .and_then(number)
        .or_else(|| before().and_then(number))?;
    Some(sign * size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_notations_of_numbers_are_parsed() {
        for (text, number) in [
            ("1.5", 1.5),
            (" -1.5E-3 ", -1.5e-3),
            ("1.50000D+02", 150.0),
            ("1.00000+100", 1e100),
            ("-2.5-101", -2.5e-101),
            ("1.", 1.0),
            (".5", 0.5),
            ("1e999", f64::INFINITY),
        ] {
            assert_eq!(parse(text.as_bytes(), false), Some(number), "{text}");
        }
        for (text, number) in [("1,5e3", 1500.0), ("2D-3", 2e-3), ("1.5+2", 150.0)] {
            assert_eq!(parse(text.as_bytes(), true), Some(number), "{text}");
        }
        assert!(parse(b"NaN", false).unwrap().is_nan());
    }

    #[test]
    fn invalid_numbers_are_none() {
        for text in [
            "", " ", "1 2", "1,5", "*****", "e", "1e", "+", "1.0e+5+5", "1+", "0x10", "1_0",
        ] {
            assert_eq!(parse(text.as_bytes(), false), None, "{text}");
        }
        for text in ["1,", "1,,5", "1.2,5", "1,2,3", ","] {
            assert_eq!(parse(text.as_bytes(), true), None, "{text}");
        }
        assert_eq!(parse(&[b'1'; 65], false), None);
        assert_eq!(parse(b"\xff", false), None);
    }

    /// Expected: the values that numpy, pandas, MATLAB, Maple and C++ print in these notations.
    #[test]
    fn all_notations_of_complex_numbers_are_parsed() {
        for (text, re, im) in [
            ("(6.93e-06-1.2e-07j)", 6.93e-6, -1.2e-7),
            ("6.93e-06-1.2e-07i", 6.93e-6, -1.2e-7),
            ("-1.5 + 2.5i", -1.5, 2.5),
            ("1.5D-3 - 2.5D+2i", 1.5e-3, -250.0),
            ("1+i*2", 1.0, 2.0),
            ("1-j2e-3", 1.0, -2e-3),
            ("1 + 2*I", 1.0, 2.0),
            ("-2e-7j", 0.0, -2e-7),
            ("2i", 0.0, 2.0),
            ("(6.93e-06+-1.2e-07j)", 6.93e-6, -1.2e-7),
            ("1+j*-2", 1.0, -2.0),
            ("1.5 - 2.5im", 1.5, -2.5),
            ("(1.5,-2)", 1.5, -2.0),
            ("( 1.5 , -2 )", 1.5, -2.0),
            ("(0+0j)", 0.0, 0.0),
        ] {
            let expected = Some(Complex64::new(re, im));
            assert_eq!(complex(text.as_bytes(), false), expected, "{text}");
        }
        let comma = complex(b"1,5-2,5e-3i", true);
        assert_eq!(comma, Some(Complex64::new(1.5, -2.5e-3)));
        assert!(complex(b"(nan+nanj)", false).is_some_and(Complex64::is_nan));
        assert!(complex(b"(nan-infj)", false).is_some_and(|found| found.im < 0.0));
        for text in [
            "", "i", "1.5", "1e-5", "(1.5)", "1+2", "1+2k", "x+2i", "1+xi", "()", "(,)", "1--2i",
            "inf", "1+2i+3i", "pi", "Hi",
        ] {
            assert_eq!(complex(text.as_bytes(), false), None, "{text}");
        }
        assert_eq!(complex(&[b'1'; 200], false), None);
        assert_eq!(complex(b"\xff", false), None);
    }
}
