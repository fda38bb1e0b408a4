//! Numbers and texts as cells of a CSV table.

use crate::escape::escape;

/// The shortest text that reads back to the same number; `nan` where there is no finite answer.
pub(crate) fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else {
        "nan".into()
    }
}

/// A text as a CSV cell (RFC 4180), hidden characters escaped.
///
/// A spreadsheet takes what begins with `=`, `+`, `-` or `@` for a formula: a text that does, and is no number, gets a
/// quote mark before it, which a spreadsheet takes as the sign of a text and [`unquoted`] takes away.
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

/// What a spreadsheet begins a formula with.
const FORMULA: [char; 4] = ['=', '+', '-', '@'];

/// A text that was read from a cell, without the quote mark that [`cell`] gave it.
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
    fn a_text_is_no_formula_nor_a_command() {
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
