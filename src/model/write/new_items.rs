//! Values and tables that the original does not have.

use super::super::toml_literal::{basic_string, format_number};
use super::node::{Entry, Node, Presence};
use crate::escape::is_hidden;
use toml_edit::{Array, InlineTable, Item, Table, Value};

/// The value of a node, with inline tables.
pub(super) fn value(node: &Node) -> Value {
    match node {
        Node::Number(number) => format_number(*number)
            .parse()
            .unwrap_or_else(|_| Value::from(*number)),
        Node::Count(count) => i64::try_from(*count).unwrap_or(i64::MAX).into(),
        Node::Flag(flag) => (*flag).into(),
        // Escapes hidden characters, so that they are visible in the file.
        Node::Text(text) if text.contains(must_be_escaped) => basic_string(text)
            .parse()
            .unwrap_or_else(|_| text.as_str().into()),
        Node::Text(text) => text.as_str().into(),
        Node::List(nodes) | Node::Tables(nodes) => {
            in_lines(nodes.iter().map(value).collect()).into()
        }
        Node::Inline(entries) | Node::Ordered(entries) | Node::Table(entries) => {
            inline_table(entries).into()
        }
    }
}

/// An array, with one line per table if there are several.
fn in_lines(values: Vec<Value>) -> Array {
    let mut array = Array::new();
    let long = values.len() > 1 && values.iter().any(Value::is_inline_table);
    for value in values {
        array.push_formatted(if long {
            value.decorated("\n    ", "")
        } else {
            value
        });
    }
    if long {
        array.set_trailing_comma(true);
        array.set_trailing("\n");
    }
    array
}

fn inline_table(entries: &[Entry]) -> InlineTable {
    let mut table = InlineTable::new();
    for entry in written(entries) {
        table.insert(entry.key.as_ref(), in_one_line(&entry.node));
    }
    table
}

/// The value of a node inside braces.
fn in_one_line(node: &Node) -> Value {
    match node {
        Node::List(nodes) | Node::Tables(nodes) => {
            nodes.iter().map(in_one_line).collect::<Array>().into()
        }
        Node::Number(_)
        | Node::Count(_)
        | Node::Flag(_)
        | Node::Text(_)
        | Node::Inline(_)
        | Node::Ordered(_)
        | Node::Table(_) => value(node),
    }
}

/// The entries that a new table shows.
fn written(entries: &[Entry]) -> impl Iterator<Item = &Entry> {
    entries
        .iter()
        .filter(|entry| entry.presence != Presence::OnlyIfThere)
}

/// The item of a node, with headers.
pub(super) fn item(node: &Node) -> Item {
    match node {
        Node::Table(entries) => Item::Table(table(entries)),
        Node::Tables(nodes) => {
            Item::ArrayOfTables(nodes.iter().filter_map(Node::entries).map(table).collect())
        }
        _ => Item::Value(value(node)),
    }
}

/// A table, with its own header if it has own keys.
pub(super) fn table(entries: &[Entry]) -> Table {
    let mut table = Table::new();
    for entry in written(entries) {
        table.insert(&entry.key, item(&entry.node));
    }
    let only_headers = table.iter().all(|(_, item)| !item.is_value());
    table.set_implicit(only_headers && !table.is_empty());
    table
}

/// The item of a node, with dotted keys.
pub(super) fn dotted(node: &Node) -> Item {
    let Node::Table(entries) = node else {
        return Item::Value(value(node));
    };
    let mut table = Table::new();
    table.set_implicit(true);
    table.set_dotted(true);
    for entry in written(entries) {
        table.insert(&entry.key, dotted(&entry.node));
    }
    Item::Table(table)
}

/// Escapes a text whose line ends would change.
///
/// Writing makes all line ends of the file equal, also those inside texts.
pub(super) fn protect_line_ends(root: &mut Table, key: &str, dos: bool) {
    let Some(Item::Value(Value::String(old))) = root.get_mut(key) else {
        return;
    };
    let raw = old
        .as_repr()
        .map(|repr| repr.as_raw().as_str().unwrap_or_default());
    let lost = match raw {
        Some(raw) => !dos && raw.contains('\n') && old.value().contains('\r'),
        None => dos && old.value().contains('\n'),
    };
    if !lost {
        return;
    }
    let text = basic_string(old.value());
    if let Ok(Value::String(mut new)) = text.parse() {
        *new.decor_mut() = old.decor().clone();
        *old = new;
    }
}

/// A hidden character other than a line end or tab.
fn must_be_escaped(letter: char) -> bool {
    is_hidden(letter) && !matches!(letter, '\n' | '\r' | '\t')
}
