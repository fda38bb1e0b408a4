//! Decodes a file to text: encodings and line ends.

use std::borrow::Cow;

/// Bytes of a file that are inspected for its encoding.
const SAMPLE: usize = 1 << 12;

/// Windows-1252 characters from 0x80 on, where Latin-1 has control characters.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Decodes a file to UTF-8 with line feeds and without a byte order mark.
///
/// UTF-16 is detected by its mark, or by zero bytes in ASCII text. A line that is not UTF-8 is Windows-1252. A single
/// carriage return ends a line. Line numbers do not change.
pub(in crate::measured) fn decoded(bytes: &[u8]) -> Cow<'_, [u8]> {
    let bare = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = match (utf16(bytes), std::str::from_utf8(bare)) {
        (Some(unit), _) => Cow::Owned(from_utf16(bytes, unit)),
        (None, Ok(_)) => Cow::Borrowed(bare),
        (None, Err(_)) => Cow::Owned(from_windows(bare)),
    };
    with_line_feeds(text)
}

/// The byte order of a UTF-16 file, as a conversion; none for other files.
fn utf16(bytes: &[u8]) -> Option<fn([u8; 2]) -> u16> {
    let little: fn([u8; 2]) -> u16 = u16::from_le_bytes;
    let big: fn([u8; 2]) -> u16 = u16::from_be_bytes;
    if bytes.starts_with(&[0xff, 0xfe]) {
        return Some(little);
    }
    if bytes.starts_with(&[0xfe, 0xff]) {
        return Some(big);
    }
    let sample = &bytes[..bytes.len().min(SAMPLE)];
    let pairs = sample.chunks_exact(2).filter(|pair| pair[0] != pair[1]);
    let (mut all, mut first, mut second) = (0, 0, 0);
    for pair in pairs {
        all += 1;
        first += usize::from(pair[0] == 0);
        second += usize::from(pair[1] == 0);
    }
    // Most characters of a table are ASCII.
    let most = |zeros: usize| all > 0 && zeros * 10 > all * 8;
    match (most(second), most(first)) {
        (true, false) => Some(little),
        (false, true) => Some(big),
        _ => None,
    }
}

fn from_utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Vec<u8> {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    let letters =
        char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER));
    let text: String = letters.filter(|letter| *letter != '\u{feff}').collect();
    text.into_bytes()
}

fn from_windows(bytes: &[u8]) -> Vec<u8> {
    let mut text = String::with_capacity(bytes.len());
    for line in bytes.split_inclusive(|byte| matches!(byte, b'\n' | b'\r')) {
        match std::str::from_utf8(line) {
            Ok(line) => text.push_str(line),
            Err(_) => text.extend(line.iter().map(|&byte| match byte {
                0x80..=0x9f => WINDOWS_1252[usize::from(byte - 0x80)],
                byte => char::from(byte),
            })),
        }
    }
    text.into_bytes()
}

/// Replaces single carriage returns by line feeds.
fn with_line_feeds(text: Cow<'_, [u8]>) -> Cow<'_, [u8]> {
    let is_single = |at: usize| text[at] == b'\r' && text.get(at + 1) != Some(&b'\n');
    let single: Vec<usize> = (0..text.len()).filter(|at| is_single(*at)).collect();
    if single.is_empty() {
        return text;
    }
    let mut text = text.into_owned();
    for at in single {
        text[at] = b'\n';
    }
    Cow::Owned(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encodings_become_utf_8_and_line_ends_become_line_feeds() {
        let text = "f [Hz],Phase [°]\n1,2\n";
        let utf16 =
            |unit: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(unit).collect::<Vec<u8>>();
        let (little, big) = (utf16(u16::to_le_bytes), utf16(u16::to_be_bytes));
        let marked = |mark: &[u8], rest: &[u8]| [mark, rest].concat();
        for bytes in [
            text.as_bytes().to_vec(),
            marked(b"\xef\xbb\xbf", text.as_bytes()),
            marked(b"\xff\xfe", &little),
            marked(b"\xfe\xff", &big),
            little,
            big,
            b"f [Hz],Phase [\xb0]\n1,2\n".to_vec(),
            b"f [Hz],Phase [\xb0]\r1,2\r".to_vec(),
        ] {
            assert_eq!(decoded(&bytes), text.as_bytes(), "{bytes:?}");
        }
        assert_eq!(*decoded(b"1\r\n2\r\n"), *b"1\r\n2\r\n");
        // A UTF-8 line is kept, also among lines in another encoding.
        let mixed = decoded(b"\xc2\xb5m\n\xb5m \x80\n");
        assert_eq!(*mixed, *"µm\nµm €\n".as_bytes());
        for bytes in [
            &b""[..],
            b"\0",
            b"\0\0\0\0",
            b"1",
            b"\xff\xfe",
            b"\xff\xfe1",
        ] {
            assert!(decoded(bytes).len() <= bytes.len());
        }
    }
}
