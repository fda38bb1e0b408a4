//! From a model to the text of its file, keeping all that a person wrote there.

mod fresh;
mod layout;
mod list;
mod merge;
mod node;
mod one_line;
mod position;
mod tree;
mod tuning;

use super::types::Model;
use merge::{merge_root, same_table};
use toml_edit::{DocumentMut, Table};

/// The byte order mark that some editors put first.
const BOM: char = '\u{feff}';

/// The text of a model, as little different from the original as can be.
///
/// Comments, order, spacing, line ends and the spelling of every value that did not change stay as they are; an
/// unchanged model gives the original byte for byte. Keys at their default are not added. Where the original is empty
/// or no TOML, the file is written anew. Numbers read back to the same bits.
pub fn write(model: &Model, original: &str) -> String {
    let body = original.strip_prefix(BOM).unwrap_or(original);
    let lines = body.matches('\n').count();
    let dos = lines > 0 && body.matches("\r\n").count() == lines;
    let mut document: DocumentMut = body.parse().unwrap_or_default();
    let tree = tree::model(model, document.as_table());
    if same_table(document.as_table(), &tree) {
        return original.to_owned();
    }
    merge_root(document.as_table_mut(), &tree);
    for key in ["title", "notes"] {
        fresh::protect_line_ends(document.as_table_mut(), key, dos);
    }
    let mut text = if body.len() < original.len() {
        String::from(BOM)
    } else {
        String::new()
    };
    text.push_str(&document.to_string());
    if dos {
        text.replace("\r\n", "\n").replace('\n', "\r\n")
    } else {
        text
    }
}

/// A model as a table in braces on one line, without what is at its default.
pub(super) fn one_line(model: &Model) -> String {
    let mut text = String::new();
    one_line::table(&tree::model(model, &Table::new()), &mut text);
    text
}
