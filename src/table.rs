//! Numbers and texts as CSV cells.

use crate::escape::escape;

/// The shortest text that parses to the same number; `nan` if it is not finite.
pub(crate) fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else {
        "nan".into()
    }
}

/// A text as a CSV cell (RFC 4180), hidden characters escaped.
///
/// A spreadsheet reads a cell that starts with `=`, `+`, `-` or `@` as a formula. Such a text, unless it is a number,
/// gets a leading quote mark, which marks a text in a spreadsheet and which [`unquoted`] removes.
pub(crate) fn cell(text: &str) -> String {
    let mut text = escape(text);
    if text.starts_with(FORMULA) && text.parse::<f64>().is_err() {
        text = format!("'{text}").into();
    }
    if text.contains([',', '"']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into_owned()
    }
}

/// The characters that start a formula in a spreadsheet.
const FORMULA: [char; 4] = ['=', '+', '-', '@'];

/// The text of a cell without the quote mark of [`cell`].
pub(crate) fn unquoted(text: &str) -> &str {
    match text.strip_prefix('\'') {
        Some(rest) if rest.starts_with(FORMULA) => rest,
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_neither_a_formula_nor_a_control_sequence() {
        for plain in ["P5 w.re", "1e6", "+0.3", "-5", "a=b", "'a", "x 0.5"] {
            assert_eq!(cell(plain), plain);
            assert_eq!(unquoted(plain), plain);
        }
        for (text, written) in [
            ("a, \"b\"", "\"a, \"\"b\"\"\""),
            ("=1+1", "'=1+1"),
            ("@SUM(A1,A2)", "\"'@SUM(A1,A2)\""),
            ("-x.re", "'-x.re"),
            ("\t=1", "\\t=1"),
            ("a\r\n\u{1b}", "a\\r\\n\\u{1b}"),
        ] {
            assert_eq!(cell(text), written);
        }
        assert_eq!(unquoted("'=1+1"), "=1+1");
    }
}
