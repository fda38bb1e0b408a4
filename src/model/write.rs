//! Writes a model to the text of its file and preserves comments and formatting.

mod array_layout;
mod header_positions;
mod list;
mod merge;
mod new_items;
mod node;
mod tree;
mod tuning;

use super::toml_literal::{basic_string, format_number};
use super::types::Model;
use merge::{merge_root, same_table};
use node::{Entry, Node, Presence};
use std::fmt::Write as _;
use toml_edit::{DocumentMut, Table};

/// The byte order mark that some editors put first.
const BOM: char = '\u{feff}';

/// The text of a model, with the fewest differences from the original.
///
/// Comments, order, spacing, line ends and the spelling of every unchanged value are preserved; an unchanged model
/// returns the original byte for byte. Keys at their default are not added. If the original is empty or not TOML, the
/// text is new. Numbers read back to the same bits.
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
        new_items::protect_line_ends(document.as_table_mut(), key, dos);
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

/// A model as an inline table on one line, without values at their default.
pub(super) fn one_line(model: &Model) -> String {
    let mut text = String::new();
    one_line_table(&tree::model(model, &Table::new()), &mut text);
    text
}

/// Adds an inline table without values at their default.
fn one_line_table(entries: &[Entry], text: &mut String) {
    let written = entries
        .iter()
        .filter(|entry| entry.presence == Presence::Always);
    text.push('{');
    for (index, entry) in written.enumerate() {
        text.push_str(if index > 0 { ", " } else { "" });
        text.push_str(&quoted_key(&entry.key));
        text.push_str(" = ");
        one_line_node(&entry.node, text);
    }
    text.push('}');
}

fn one_line_node(node: &Node, text: &mut String) {
    match node {
        Node::Number(number) => text.push_str(&format_number(*number)),
        // Writing to a string cannot fail.
        Node::Count(count) => drop(write!(text, "{count}")),
        Node::Flag(flag) => drop(write!(text, "{flag}")),
        Node::Text(words) => text.push_str(&basic_string(words)),
        Node::List(nodes) | Node::Tables(nodes) => one_line_list(nodes, text),
        Node::Inline(entries) | Node::Ordered(entries) | Node::Table(entries) => {
            one_line_table(entries, text);
        }
    }
}

fn one_line_list(nodes: &[Node], text: &mut String) {
    text.push('[');
    for (index, element) in nodes.iter().enumerate() {
        text.push_str(if index > 0 { ", " } else { "" });
        one_line_node(element, text);
    }
    text.push(']');
}

/// A key, in quotes if needed.
fn quoted_key(key: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !key.is_empty() && key.chars().all(bare) {
        key.to_owned()
    } else {
        basic_string(key)
    }
}
