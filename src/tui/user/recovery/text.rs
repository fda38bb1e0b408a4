//! The text of a recovery file: three lines of comment, then the model's text as it is.
//!
//! ```toml
//! # beamtune recovery 1
//! # source: file "/home/ada/beam.toml"
//! # bytes: 1234
//! ```
//!
//! The source is `file "PATH"`, `file-in-hexadecimal "2F74.."` for a path that is no Unicode text, `preset "NAME"` or
//! `standard input`; what is in quotes is a basic string of TOML. The bytes are those of the model's text, by which a
//! torn file is told. A byte order mark stays the first character of the file.

use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::presets;
use crate::tui::Source;

const FIRST_LINE: &str = "# beamtune recovery 1";
const SOURCE: &str = "# source: ";
const BYTES: &str = "# bytes: ";
/// The kinds of a source.
const FILE: &str = "file ";
const FILE_BYTES: &str = "file-in-hexadecimal ";
const PRESET: &str = "preset ";
const STANDARD_INPUT: &str = "standard input";
/// The byte order mark that some editors put first.
const BOM: &str = "\u{feff}";

/// The recovery file of a model's text.
pub(super) fn write(source: &Source, model: &str) -> String {
    let (bom, body) = match model.strip_prefix(BOM) {
        Some(body) => (BOM, body),
        None => ("", model),
    };
    format!(
        "{bom}{FIRST_LINE}\n{SOURCE}{}\n{BYTES}{}\n{body}",
        write_source(source),
        model.len()
    )
}

/// Source and model text of a recovery file, byte for byte as they were. `None` where it is anything else, or torn.
pub(super) fn read(file: &str) -> Option<(Source, String)> {
    let (bom, rest) = match file.strip_prefix(BOM) {
        Some(rest) => (BOM, rest),
        None => ("", file),
    };
    let (first, rest) = rest.split_once('\n')?;
    let (source, rest) = rest.split_once('\n')?;
    let (bytes, body) = rest.split_once('\n')?;
    let source = read_source(source.strip_prefix(SOURCE)?)?;
    let bytes: usize = bytes.strip_prefix(BYTES)?.parse().ok()?;
    // A block that never reached the disk is zeros after a loss of power; TOML has none.
    let whole = bom.len() + body.len() == bytes && !body.contains('\0');
    (first == FIRST_LINE && whole).then(|| (source, format!("{bom}{body}")))
}

fn write_source(source: &Source) -> String {
    // The next program may be started in another folder.
    match source.absolute() {
        Source::File(path) => match path.to_str() {
            Some(text) => format!("{FILE}{}", quoted(text)),
            None => format!("{FILE_BYTES}\"{}\"", hexadecimal(&path)),
        },
        Source::Preset(name) => format!("{PRESET}{}", quoted(name)),
        Source::Stdin => STANDARD_INPUT.to_owned(),
    }
}

/// A preset of a name that is not known (any more) comes from nowhere, as standard input does.
fn read_source(text: &str) -> Option<Source> {
    if text == STANDARD_INPUT {
        return Some(Source::Stdin);
    }
    if let Some(path) = text.strip_prefix(FILE) {
        return absolute(PathBuf::from(unquoted(path)?));
    }
    if let Some(path) = text.strip_prefix(FILE_BYTES) {
        return absolute(PathBuf::from(from_hexadecimal(&unquoted(path)?)?));
    }
    let name = unquoted(text.strip_prefix(PRESET)?)?;
    let preset = presets::find(&name).map(|preset| Source::Preset(preset.name));
    Some(preset.unwrap_or(Source::Stdin))
}

fn absolute(path: PathBuf) -> Option<Source> {
    path.is_absolute().then_some(Source::File(path))
}

/// A basic string of TOML on one line.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            _ if character.is_control() => {
                // Writing to a string cannot fail.
                let _ = write!(quoted, "\\u{:04X}", u32::from(character));
            }
            _ => quoted.push(character),
        }
    }
    quoted.push('"');
    quoted
}

fn unquoted(text: &str) -> Option<String> {
    let basic = text.starts_with('"') && !text.starts_with("\"\"\"");
    let value: toml::Value = text.parse().ok().filter(|_| basic)?;
    value.as_str().map(str::to_owned)
}

fn hexadecimal(path: &Path) -> String {
    let bytes = path.as_os_str().as_encoded_bytes();
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02X}");
        text
    })
}

/// Only where a path is bytes can one that is no text be made from them again.
#[cfg(unix)]
fn from_hexadecimal(text: &str) -> Option<OsString> {
    use std::os::unix::ffi::OsStringExt as _;
    let digit = |byte: u8| char::from(byte).to_digit(16);
    let byte = |pair: &[u8]| match *pair {
        [high, low] => Some((digit(high)? * 16 + digit(low)?) as u8),
        _ => None,
    };
    let bytes: Option<Vec<u8>> = text.as_bytes().chunks(2).map(byte).collect();
    bytes.map(OsString::from_vec)
}

#[cfg(not(unix))]
fn from_hexadecimal(_text: &str) -> Option<OsString> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn returns(source: &Source, text: &str) {
        let file = write(source, text);
        assert_eq!(
            read(&file),
            Some((source.clone(), text.to_owned())),
            "{file:?}"
        );
        let comments = file.trim_start_matches(BOM).lines().take(3);
        assert_eq!(
            comments.filter(|line| line.starts_with("# ")).count(),
            3,
            "{file:?}"
        );
        // Comments alone are TOML: no source may break out of its line.
        let header = write(source, "");
        assert!(
            header.parse::<toml::Table>().unwrap().is_empty(),
            "{header:?}"
        );
    }

    #[test]
    fn a_recovery_file_is_a_model_file_under_three_comments() {
        let text = "format = \"beamtune/1\"\n";
        let file = write(&Source::File("/home/ada/beam.toml".into()), text);
        assert_eq!(
            file,
            "# beamtune recovery 1\n# source: file \"/home/ada/beam.toml\"\n# bytes: 22\nformat = \"beamtune/1\"\n"
        );
        for preset in presets::ALL {
            let file = write(&Source::Preset(preset.name), preset.text);
            assert!(crate::model::read(&file).is_ok(), "{}", preset.name);
        }
    }

    #[test]
    fn every_text_comes_back_byte_for_byte() {
        for text in [
            "",
            "\n",
            "a",
            "\r\na = 1\r\n",
            "\u{feff}a = 1\n",
            "\u{feff}",
            "# beamtune recovery 1\n",
            "a = \"é\"\n\n\n",
        ] {
            returns(&Source::Stdin, text);
        }
    }

    #[test]
    fn a_byte_order_mark_stays_first() {
        let preset = presets::find("fig06").unwrap().text;
        let file = write(&Source::Stdin, &format!("{BOM}{preset}"));
        assert!(crate::model::read(&file).is_ok());
    }

    #[test]
    fn every_source_comes_back() {
        for path in [
            "/a b.toml",
            "/\"quoted\" and 'quoted'.toml",
            "/back\\slash\\n",
            "/line\nbreak\r\ttab",
            "/\u{7f}\u{0}\u{85}\u{2028}é梁",
            "/\"\"\"",
            "/# comment",
        ] {
            returns(&Source::File(path.into()), "text");
        }
        returns(&Source::Preset("fig06"), "text");
        returns(&Source::Stdin, "text");
    }

    #[cfg(unix)]
    #[test]
    fn a_path_that_is_no_text_comes_back() {
        use std::os::unix::ffi::OsStringExt as _;
        let path = OsString::from_vec(b"/caf\xe9\n\".toml".to_vec());
        returns(&Source::File(path.into()), "text");
    }

    #[test]
    fn a_relative_path_is_made_absolute() {
        let file = write(&Source::File("beam.toml".into()), "");
        let expected = std::env::current_dir().unwrap().join("beam.toml");
        assert_eq!(read(&file), Some((Source::File(expected), String::new())));
    }

    #[test]
    fn an_unknown_preset_comes_from_nowhere() {
        let file = "# beamtune recovery 1\n# source: preset \"fig99\"\n# bytes: 1\na";
        assert_eq!(read(file), Some((Source::Stdin, "a".to_owned())));
    }

    #[test]
    fn anything_else_is_refused() {
        let good = write(&Source::File("/a.toml".into()), "text");
        for end in (0..good.len()).filter(|end| good.is_char_boundary(*end)) {
            assert_eq!(read(&good[..end]), None, "torn after {end} bytes");
        }
        for bad in [
            good.replace("recovery 1", "recovery 2"),
            good.replace("bytes: 4", "bytes: 5"),
            good.replace("bytes: 4", "bytes: four"),
            good.replace("/a.toml", "a.toml"),
            good.replace("\"/a.toml\"", "'/a.toml'"),
            good.replace("\"/a.toml\"", "\"\"\"/a.toml\"\"\""),
            good.replace("\"/a.toml\"", "3"),
            good.replace("file", "folder"),
            good.replace('\n', "\r\n"),
            good.replace("text", "te\0t"),
            format!("{good} "),
            format!(" {good}"),
        ] {
            assert_eq!(read(&bad), None, "{bad:?}");
        }
    }
}
