//! Characters that a terminal obeys or that are invisible, by the Unicode character database (16.0), apart from the
//! program's own table.

/// One of each kind that is not a control: bidirectional marks, zero-width characters, separators, fillers, tags.
pub const HIDDEN: &[char] = &[
    '\u{ad}',
    '\u{34f}',
    '\u{61c}',
    '\u{180e}',
    '\u{200b}',
    '\u{200c}',
    '\u{200d}',
    '\u{200e}',
    '\u{200f}',
    '\u{2028}',
    '\u{2029}',
    '\u{202a}',
    '\u{202b}',
    '\u{202c}',
    '\u{202d}',
    '\u{202e}',
    '\u{2060}',
    '\u{2061}',
    '\u{2062}',
    '\u{2063}',
    '\u{2064}',
    '\u{2066}',
    '\u{2067}',
    '\u{2068}',
    '\u{2069}',
    '\u{206a}',
    '\u{206f}',
    '\u{3164}',
    '\u{fe0f}',
    '\u{feff}',
    '\u{fff9}',
    '\u{fffb}',
    '\u{e0001}',
    '\u{e0020}',
    '\u{e0041}',
    '\u{e007f}',
    '\u{e0100}',
];

/// Every control: C0, DEL and C1.
pub fn controls() -> Vec<char> {
    (0..=0x1f)
        .chain(0x7f..=0x9f)
        .filter_map(char::from_u32)
        .collect()
}

/// Output as text; line feeds are its only controls.
pub fn assert_safe(what: &str, output: &[u8]) {
    let text = std::str::from_utf8(output).unwrap_or_else(|error| panic!("{what}: {error}"));
    let found = text
        .chars()
        .find(|c| *c != '\n' && (c.is_control() || HIDDEN.contains(c)));
    assert_eq!(found, None, "{what}: {text:?}");
}

/// A text inside of a basic string of TOML.
pub fn in_toml(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            ' '..='~' if !matches!(c, '"' | '\\') => c.to_string(),
            _ => format!("\\U{:08x}", u32::from(c)),
        })
        .collect()
}
