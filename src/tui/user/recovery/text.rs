//! The text of a recovery file: three lines of comment, then a model's text unchanged, then the edits since.
//!
//! ```toml
//! # beamtune recovery 1
//! # source: file "/home/ada/beam.toml"
//! # bytes: 1234
//! ```
//!
//! The source is `file "PATH"`, `file-in-hexadecimal "2F74.."` for a path that is not Unicode, `preset "NAME"` or
//! `standard input`; quoted text is a basic string of TOML. The bytes are those of the model's text; they detect a
//! truncated file. A byte order mark stays the first character of the file.
//!
//! An edit is an empty line and a comment, `# edit = {..}`, a [`delta`](crate::model::delta()) from the previous model.
//! A last edit without line end is truncated and ignored.

use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use crate::files::Source;
use crate::model::basic_string;
use crate::presets;

const FIRST_LINE: &str = "# beamtune recovery 1";
const SOURCE: &str = "# source: ";
const BYTES: &str = "# bytes: ";
/// The prefix of an edit.
const COMMENT: &str = "# ";
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

/// The text that appends an edit to a recovery file.
pub(super) fn edit(delta: &str) -> String {
    format!("\n{COMMENT}{delta}\n")
}

/// The content of a recovery file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Contents {
    /// The source of the model.
    pub source: Source,
    /// The text of the model, byte for byte.
    pub text: String,
    /// The edits since, as whole lines; they end at the first that cannot be applied.
    pub edits: Vec<String>,
}

/// Parses a recovery file. `None` for any other file, or a truncated text of the model.
pub(super) fn read(file: &[u8]) -> Option<Contents> {
    let (bom, rest) = match file.strip_prefix(BOM.as_bytes()) {
        Some(rest) => (BOM, rest),
        None => ("", file),
    };
    let (first, rest) = line(rest)?;
    let (source, rest) = line(rest)?;
    let (bytes, rest) = line(rest)?;
    let source = read_source(source.strip_prefix(SOURCE)?)?;
    let bytes: usize = bytes.strip_prefix(BYTES)?.parse().ok()?;
    let (body, edits) = rest.split_at_checked(bytes.checked_sub(bom.len())?)?;
    let body = std::str::from_utf8(body).ok()?;
    // After a loss of power, unwritten blocks are zeros; TOML has none.
    let whole = !body.contains('\0') && matches!(edits.first(), None | Some(b'\n' | b'\0'));
    (first == FIRST_LINE && whole).then(|| Contents {
        source,
        text: format!("{bom}{body}"),
        edits: read_edits(edits),
    })
}

/// The first line and the rest.
fn line(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let end = bytes.iter().position(|byte| *byte == b'\n')?;
    Some((std::str::from_utf8(&bytes[..end]).ok()?, &bytes[end + 1..]))
}

/// The whole lines, without their comment prefix.
fn read_edits(mut bytes: &[u8]) -> Vec<String> {
    let mut edits = Vec::new();
    while let Some((text, rest)) = line(bytes) {
        edits.extend(text.strip_prefix(COMMENT).map(str::to_owned));
        bytes = rest;
    }
    edits
}

fn write_source(source: &Source) -> String {
    // The next program may start in another folder.
    match source.absolute() {
        Source::File(path) => match path.to_str() {
            Some(text) => format!("{FILE}{}", basic_string(text)),
            None => format!("{FILE_BYTES}\"{}\"", hexadecimal(&path)),
        },
        Source::Preset(name) => format!("{PRESET}{}", basic_string(name)),
        Source::Stdin => STANDARD_INPUT.to_owned(),
    }
}

/// An unknown preset has no source, like standard input.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn returns(source: &Source, text: &str) {
        let file = write(source, text);
        let mut expected = Contents {
            source: source.clone(),
            text: text.to_owned(),
            edits: Vec::new(),
        };
        assert_eq!(read(file.as_bytes()), Some(expected.clone()), "{file:?}");
        expected.edits = vec!["edit = 1".to_owned(), "edit = \"é\"".to_owned()];
        let edits: String = expected.edits.iter().map(|one| edit(one)).collect();
        assert_eq!(read(format!("{file}{edits}").as_bytes()), Some(expected));
        let comments = file.trim_start_matches(BOM).lines().take(3);
        assert_eq!(
            comments.filter(|line| line.starts_with("# ")).count(),
            3,
            "{file:?}"
        );
        // Valid TOML, comments only: no source may add a line.
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
        assert_eq!(
            read(file.as_bytes()).unwrap().source,
            Source::File(expected)
        );
    }

    #[test]
    fn an_unknown_preset_comes_from_nowhere() {
        let file = "# beamtune recovery 1\n# source: preset \"fig99\"\n# bytes: 1\na";
        let found = read(file.as_bytes()).unwrap();
        assert_eq!((found.source, &*found.text), (Source::Stdin, "a"));
    }

    #[test]
    fn anything_else_is_refused() {
        let good = write(&Source::File("/a.toml".into()), "text");
        for end in (0..good.len()).filter(|end| good.is_char_boundary(*end)) {
            assert_eq!(
                read(&good.as_bytes()[..end]),
                None,
                "torn after {end} bytes"
            );
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
            assert_eq!(read(bad.as_bytes()), None, "{bad:?}");
        }
    }

    #[test]
    fn a_torn_edit_is_none() {
        let good = write(&Source::Stdin, "text") + &edit("edit = 1");
        let file = (good.clone() + &edit("edit = \"é\"")).into_bytes();
        for end in good.len()..file.len() {
            let found = read(&file[..end]).unwrap();
            assert_eq!(
                (&*found.text, found.edits),
                ("text", vec!["edit = 1".to_owned()])
            );
        }
        // The content after a loss of power.
        let zeros = [good.as_bytes(), &[0; 512]].concat();
        assert_eq!(read(&zeros).unwrap().edits, ["edit = 1"]);
        let zeros = [write(&Source::Stdin, "text").as_bytes(), &[0; 512]].concat();
        assert_eq!(read(&zeros).unwrap().edits, [""; 0]);
    }
}
