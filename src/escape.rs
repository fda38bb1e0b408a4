//! Escapes text from outside (names, keys, paths, arguments, file contents) for people and terminals.
//!
//! Control characters and invisible characters are written as Rust escapes: `\u{1b}`, `\n`. Escaping is idempotent:
//! every output escapes its text, and the width of a text is that of the escaped text.
//!
//! File names are bytes. In text, a byte that is not UTF-8 is a private-use character, which is shown as `\xff` and
//! converts back to that byte.

use std::borrow::Cow;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A byte of a file name that is not UTF-8 is this character plus its value: the end of the last private use area.
const BYTES: u32 = 0x0010_ff00;

/// Whether a character controls a terminal or is invisible: controls (Unicode 16 category Cc), format characters
/// (Cf: bidirectional marks, zero-width characters, tags), separators of lines and paragraphs (Zl, Zp), and those that
/// are ignored by default (`Default_Ignorable_Code_Point`: fillers, variation selectors).
pub(crate) fn is_hidden(letter: char) -> bool {
    letter.is_control()
        || matches!(
            letter,
            '\u{ad}'
                | '\u{34f}'
                | '\u{600}'..='\u{605}'
                | '\u{61c}'
                | '\u{6dd}'
                | '\u{70f}'
                | '\u{890}'..='\u{891}'
                | '\u{8e2}'
                | '\u{115f}'..='\u{1160}'
                | '\u{17b4}'..='\u{17b5}'
                | '\u{180b}'..='\u{180f}'
                | '\u{200b}'..='\u{200f}'
                | '\u{2028}'..='\u{202e}'
                | '\u{2060}'..='\u{206f}'
                | '\u{3164}'
                | '\u{fe00}'..='\u{fe0f}'
                | '\u{feff}'
                | '\u{ffa0}'
                | '\u{fff0}'..='\u{fffb}'
                | '\u{110bd}'
                | '\u{110cd}'
                | '\u{13430}'..='\u{1343f}'
                | '\u{1bca0}'..='\u{1bca3}'
                | '\u{1d173}'..='\u{1d17a}'
                | '\u{e0000}'..='\u{e0fff}'
        )
}

/// The file name byte that a character encodes.
fn byte_of(letter: char) -> Option<u8> {
    u8::try_from(u32::from(letter).checked_sub(BYTES)?)
        .ok()
        .filter(|byte| !byte.is_ascii())
}

/// The character that encodes a file name byte.
fn letter_of(byte: u8) -> char {
    char::from_u32(BYTES + u32::from(byte)).unwrap_or(char::REPLACEMENT_CHARACTER)
}

/// A text on one line, with every hidden character escaped.
pub(crate) fn escape(text: &str) -> Cow<'_, str> {
    let plain = |letter: char| !is_hidden(letter) && byte_of(letter).is_none();
    if text.chars().all(plain) {
        return Cow::Borrowed(text);
    }
    let mut safe = String::with_capacity(text.len() + 8);
    for letter in text.chars() {
        if let Some(byte) = byte_of(letter) {
            // Writing to a string has no errors.
            let _ = write!(safe, "\\x{byte:02x}");
        } else if letter.is_control() {
            safe.extend(letter.escape_debug());
        } else if is_hidden(letter) {
            safe.extend(letter.escape_unicode());
        } else {
            safe.push(letter);
        }
    }
    Cow::Owned(safe)
}

/// The same for a text of several lines: keeps line feeds.
pub(crate) fn escape_lines(text: &str) -> String {
    let lines: Vec<Cow<str>> = text.split('\n').map(escape).collect();
    lines.join("\n")
}

/// A path for display.
pub(crate) fn shown_path(path: &Path) -> String {
    escape(&path_text(path)).into_owned()
}

/// A path as text that [`path_of_text`] converts back to the same path, for any bytes.
pub(crate) fn path_text(path: &Path) -> String {
    let mut text = String::new();
    for chunk in path.as_os_str().as_encoded_bytes().utf8_chunks() {
        for letter in chunk.valid().chars() {
            match byte_of(letter) {
                None => text.push(letter),
                // A character that would convert back to a byte is itself encoded byte by byte.
                Some(_) => text.extend(letter.to_string().bytes().map(letter_of)),
            }
        }
        text.extend(chunk.invalid().iter().copied().map(letter_of));
    }
    text
}

/// The path of a typed text or of a text from [`path_text`].
pub(crate) fn path_of_text(text: &str) -> PathBuf {
    use std::os::unix::ffi::OsStringExt as _;
    let mut bytes = Vec::with_capacity(text.len());
    for letter in text.chars() {
        match byte_of(letter) {
            Some(byte) => bytes.push(byte),
            None => bytes.extend(letter.encode_utf8(&mut [0; 4]).bytes()),
        }
    }
    std::ffi::OsString::from_vec(bytes).into()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn hidden_characters_are_written_as_values_are() {
        for plain in [
            "",
            "S1 w",
            "Träger 梁",
            "e\u{301}",
            r"C:\beam",
            "a\"b",
            "\u{10fe80}",
        ] {
            assert!(matches!(escape(plain), Cow::Borrowed(same) if same == plain));
        }
        for (text, shown) in [
            ("\u{1b}]0;x\u{7}", r"\u{1b}]0;x\u{7}"),
            ("a\nb\tc\rd\0", r"a\nb\tc\rd\0"),
            ("\u{7f}\u{9b}", r"\u{7f}\u{9b}"),
            ("a\u{202e}b\u{2066}", r"a\u{202e}b\u{2066}"),
            ("\u{200d}\u{feff}\u{ad}", r"\u{200d}\u{feff}\u{ad}"),
            ("\u{e0041}\u{fe0f}", r"\u{e0041}\u{fe0f}"),
        ] {
            assert_eq!(escape(text), shown);
        }
        assert_eq!(escape_lines("a\u{7}\nb"), "a\\u{7}\nb");
    }

    /// `Debug` of the standard library escapes controls, format characters and separators by its own Unicode tables.
    #[test]
    fn characters_that_debug_escapes_are_escaped_and_letters_are_not() {
        for letter in '\0'..=char::MAX {
            let quoted = format!("{letter:?}") != format!("'{letter}'");
            // Hidden, but letters or marks for `Debug`: the Hangul fillers.
            let filler = matches!(letter, '\u{115f}'..='\u{1160}' | '\u{3164}' | '\u{ffa0}');
            if is_hidden(letter) {
                assert!(quoted || filler, "{:x}", u32::from(letter));
            }
            if letter.is_alphanumeric() {
                assert!(!is_hidden(letter) || filler, "{letter}");
            }
        }
    }

    #[test]
    fn a_path_of_any_bytes_is_text_and_back() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt as _;
        let path = |bytes: &'static [u8]| Path::new(OsStr::from_bytes(bytes));
        assert_eq!(shown_path(path(b"a/m\xff\xc3.toml")), r"a/m\xff\xc3.toml");
        assert_eq!(shown_path(path(b"a\x1b[2J")), r"a\u{1b}[2J");
        assert_eq!(path_text(path("Träger.toml".as_bytes())), "Träger.toml");
        for bytes in [
            &b"m\xff.toml"[..],
            b"\xed\xa0\x80",
            "\u{10ffff}\u{10ff80}".as_bytes(),
            b"\xf4\x8f\xbe",
        ] {
            assert_eq!(path_of_text(&path_text(path(bytes))), path(bytes));
        }
    }

    proptest! {
        #[test]
        fn escaping_is_safe_and_idempotent(text in any::<String>()) {
            let safe = escape(&text).into_owned();
            prop_assert!(!safe.contains(is_hidden));
            prop_assert_eq!(&escape(&safe), &safe);
            prop_assert_eq!(path_of_text(&path_text(Path::new(&text))), Path::new(&text));
        }
    }
}
