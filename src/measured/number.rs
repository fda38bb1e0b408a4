//! Numbers as instruments and Fortran programs write them.

/// Longest text of a number, bytes.
const LONGEST: usize = 64;

/// A number: `1.5`, `1.5e-3`, `1.5D-03`, `1.5+100` (an exponent of three digits), with `comma` also `1,5`. Blanks around
/// it do not matter; `nan` and `inf` are numbers that are not finite, and so is what is beyond the range.
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
        // A comma that ends a cell parts cells.
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
    let ends_well = mantissa.ends_with(|end: char| end.is_ascii_digit() || end == '.');
    if !ends_well {
        return None;
    }
    format!("{mantissa}e{exponent}").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_all_spellings_are_read() {
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
    fn what_is_no_number_is_none() {
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
}
