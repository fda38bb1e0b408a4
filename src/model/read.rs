//! Reads the text of a model file to a model or to all of its faults.

mod list;
mod loads;
mod parts;
pub(crate) mod reader;
mod rows;
mod studies;
pub(crate) mod table;
mod tuning;
pub(crate) mod value;

use super::check::{Checked, check};
use super::fault::Fault;
use super::types::Model;
use reader::Reader;
use table::Table;
use toml::Spanned;
use toml::de::DeTable;

/// The longest quotation of invalid TOML, bytes.
const LONGEST_QUOTE: usize = 200;

/// Reads a model file of the format `beamtune/1`.
///
/// # Errors
/// All faults in the order of the text, each with line, column and path: invalid TOML; if it is valid, unknown and
/// missing keys, wrong types, numbers that are not finite, and all faults that [`check()`] finds.
pub fn read(text: &str) -> Result<Checked, Vec<Fault>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = Reader::default();
    let Some(document) = document(text, &mut reader) else {
        return Err(reader.into_faults(text));
    };
    let model = parts::model(Table::root(document.get_ref()), &[], &mut reader);
    reader.adopt(check(&model));
    if reader.is_content() {
        Ok(Checked(model))
    } else {
        Err(reader.into_faults(text))
    }
}

/// A model without some list elements, unchecked; `names` are those of the omitted subsystems. None if a part is
/// unreadable.
pub(super) fn part(content: &DeTable<'_>, names: &[&str]) -> Option<Model> {
    let mut reader = Reader::default();
    let model = parts::model(Table::root(content), names, &mut reader);
    reader.is_content().then_some(model)
}

/// The tables of a text without byte order mark; none if it is invalid TOML, whose errors become faults.
pub(crate) fn document<'a>(text: &'a str, reader: &mut Reader) -> Option<Spanned<DeTable<'a>>> {
    let (document, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        return Some(document);
    }
    for error in errors {
        let span = error.span().unwrap_or_default();
        let found = text
            .get(span.clone())
            .filter(|found| !found.is_empty() && !found.contains('\n'))
            .filter(|found| found.len() <= LONGEST_QUOTE);
        let found = found.map_or_else(String::new, |found| format!(" at `{found}`"));
        reader.fault(
            span.start,
            "",
            format!("broken TOML{found}: {}", error.message()),
        );
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_text_lacks_everything_at_its_start() {
        let faults = read("").unwrap_err();
        let paths: Vec<_> = faults.iter().map(|fault| fault.path.as_str()).collect();
        assert_eq!(paths, ["format", "title", "beam", "sweep"]);
        assert!(
            faults
                .iter()
                .all(|fault| (fault.line, fault.column) == (Some(1), Some(1)))
        );
    }

    #[test]
    fn every_syntax_error_has_its_place() {
        let faults = read("\u{feff}a = \r\n\r\nä = 1\r\nb = [1,\r\n").unwrap_err();
        assert_eq!(
            (faults[0].line, faults[0].column),
            (Some(1), Some(5)),
            "{faults:?}"
        );
        assert!(
            faults.iter().any(|fault| fault.line == Some(3)),
            "{faults:?}"
        );
        assert!(
            faults
                .iter()
                .all(|fault| fault.message.starts_with("broken TOML"))
        );
    }
}
