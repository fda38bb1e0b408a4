//! Merges a tree of values into the tables of the original.

use super::header_positions::{positions, set_position};
use super::list;
use super::new_items;
use super::node::{Entry, Node, Presence};
use toml_edit::{InlineTable, Item, RawString, Table, TableLike, Value};

/// The style of a table.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// Below a header.
    Header,
    /// As the first parts of dotted keys.
    Dotted,
    /// In braces.
    Inline,
}

/// Whether an item is equal to the node.
pub(super) fn same(item: &Item, node: &Node) -> bool {
    if let (Some(table), Some(entries)) = (item.as_table_like(), node.entries()) {
        return same_table(table, entries)
            && (!matches!(node, Node::Ordered(_)) || in_order(table, entries));
    }
    match item {
        Item::Value(value) => same_value(value, node),
        Item::ArrayOfTables(tables) => node.elements().is_some_and(|nodes| {
            let alike = |(table, node): (&Table, &Node)| {
                node.entries()
                    .is_some_and(|entries| same_table(table, entries))
            };
            tables.len() == nodes.len() && tables.iter().zip(nodes).all(alike)
        }),
        _ => false,
    }
}

/// Whether a value is equal to the node, numbers to the last bit.
pub(super) fn same_value(value: &Value, node: &Node) -> bool {
    match (value, node) {
        (Value::Float(old), Node::Number(new)) => old.value().to_bits() == new.to_bits(),
        (Value::Integer(old), Node::Number(new)) => {
            (*old.value() as f64).to_bits() == new.to_bits()
        }
        (Value::Integer(old), Node::Count(new)) => usize::try_from(*old.value()) == Ok(*new),
        (Value::Boolean(old), Node::Flag(new)) => old.value() == new,
        (Value::String(old), Node::Text(new)) => old.value() == new,
        (Value::Array(old), Node::List(new) | Node::Tables(new)) => {
            old.len() == new.len() && old.iter().zip(new).all(|(old, new)| same_value(old, new))
        }
        (Value::InlineTable(old), _) => node.entries().is_some_and(|entries| {
            same_table(old, entries)
                && (!matches!(node, Node::Ordered(_)) || in_order(old, entries))
        }),
        _ => false,
    }
}

/// Whether a table is equal to the entries; a missing key must be at its default.
pub(super) fn same_table(table: &dyn TableLike, entries: &[Entry]) -> bool {
    entries.iter().all(|entry| match table.get(&entry.key) {
        Some(item) => same(item, &entry.node),
        None => entry.presence != Presence::Always,
    }) && table.iter().all(|(key, _)| is_known(key, entries))
}

fn is_known(key: &str, entries: &[Entry]) -> bool {
    entries.iter().any(|entry| entry.key == key)
}

/// Whether the keys are in the order of the entries.
fn in_order(table: &dyn TableLike, entries: &[Entry]) -> bool {
    table
        .iter()
        .map(|(key, _)| key)
        .eq(entries.iter().map(|entry| &*entry.key))
}

/// Merges the whole model. A new table follows the one that precedes it in a new file.
pub(super) fn merge_root(root: &mut Table, entries: &[Entry]) {
    if root.is_empty() {
        for (key, item) in new_items::table(entries) {
            root.insert(&key, item);
        }
        return;
    }
    let old: Vec<bool> = entries
        .iter()
        .map(|entry| root.contains_key(&entry.key))
        .collect();
    merge_table(root, Style::Header, entries);
    let mut last = None;
    for (entry, old) in entries.iter().zip(old) {
        if let Some(item) = root.get_mut(&entry.key) {
            if !old {
                set_position(item, last);
            }
            last = last.max(positions(item).map(|(_, last)| last));
        }
    }
}

/// Merges a node into an item; returns false if it needs another kind of item.
pub(super) fn merge_item(item: &mut Item, node: &Node) -> bool {
    if same(item, node) {
        return true;
    }
    if let Some(entries) = node.entries()
        && item.is_table_like()
    {
        merge_table_like(item, entries);
        if let (Node::Ordered(_), Some(table)) = (node, item.as_table_like_mut())
            && !in_order(table, entries)
        {
            table.clear();
            for entry in entries {
                table.insert(&entry.key, Item::Value(new_items::value(&entry.node)));
            }
        }
        return true;
    }
    match (item, node.elements()) {
        (Item::ArrayOfTables(tables), Some(nodes))
            if nodes.iter().all(|node| node.entries().is_some()) =>
        {
            list::merge_tables(tables, nodes);
        }
        (Item::Value(Value::Array(array)), Some(nodes)) => list::merge_array(array, nodes),
        (Item::Value(value), _) => {
            let decor = value.decor().clone();
            *value = new_items::value(node);
            *value.decor_mut() = decor;
        }
        _ => return false,
    }
    true
}

fn merge_table_like(item: &mut Item, entries: &[Entry]) {
    match item {
        Item::Table(table) if table.is_dotted() => merge_table(table, Style::Dotted, entries),
        Item::Table(table) => merge_table(table, Style::Header, entries),
        Item::Value(Value::InlineTable(table)) => {
            let end = take_end(table);
            let was = entries
                .first()
                .is_some_and(|first| table.contains_key(&first.key));
            merge_table(table, Style::Inline, entries);
            if !was {
                put_first(table, entries);
            }
            put_end(table, end);
        }
        _ => {}
    }
}

/// Merges entries into a table: removes extra keys, changes different values, adds missing keys.
pub(super) fn merge_table(table: &mut dyn TableLike, style: Style, entries: &[Entry]) {
    let unknown: Vec<String> = table
        .iter()
        .map(|(key, _)| key.to_owned())
        .filter(|key| !is_known(key, entries))
        .collect();
    let mut comments = String::new();
    for key in unknown {
        comments.push_str(&remove(table, &key));
    }
    for entry in entries {
        if let Some(item) = table.get_mut(&entry.key) {
            if !merge_item(item, &entry.node) {
                let comments = remove(table, &entry.key);
                insert(table, style, entry, &comments);
            }
        } else if entry.presence == Presence::Always {
            insert(table, style, entry, &comments);
            comments.clear();
        }
    }
}

/// Removes a key and returns its comments, one per line.
fn remove(table: &mut dyn TableLike, key: &str) -> String {
    let mut comments = String::new();
    if let Some((key, item)) = table.get_key_value(key) {
        gather(key.leaf_decor().prefix(), &mut comments);
        gather_item(item, &mut comments);
    }
    table.remove(key);
    comments
}

fn gather_item(item: &Item, comments: &mut String) {
    if let Item::Table(table) = item {
        gather(table.decor().prefix(), comments);
        gather(table.decor().suffix(), comments);
        for (key, item) in table {
            gather(
                table.key(key).and_then(|key| key.leaf_decor().prefix()),
                comments,
            );
            gather_item(item, comments);
        }
    } else if let Item::Value(value) = item {
        gather(value.decor().suffix(), comments);
    }
}

fn gather(decor: Option<&RawString>, comments: &mut String) {
    let lines = decor
        .and_then(RawString::as_str)
        .unwrap_or_default()
        .lines()
        .map(str::trim);
    for line in lines.filter(|line| line.starts_with('#')) {
        comments.push_str(line);
        comments.push('\n');
    }
}

/// Adds a key at the end, after some comments and with the indentation of the previous key.
fn insert(table: &mut dyn TableLike, style: Style, entry: &Entry, comments: &str) {
    let item = match style {
        Style::Header => new_items::item(&entry.node),
        Style::Dotted => new_items::dotted(&entry.node),
        Style::Inline => Item::Value(new_items::value(&entry.node)),
    };
    let indent = table
        .get_values()
        .last()
        .and_then(|(keys, _)| keys.last().copied().cloned())
        .map(|key| {
            let prefix = key
                .leaf_decor()
                .prefix()
                .and_then(RawString::as_str)
                .unwrap_or_default();
            prefix.rsplit('\n').next().unwrap_or_default().to_owned()
        });
    let is_value = item.is_value();
    table.insert(&entry.key, item);
    if style == Style::Inline {
        return;
    }
    let indent = indent.filter(|_| is_value).unwrap_or_default();
    let prefix: String = comments
        .lines()
        .flat_map(|line| [indent.as_str(), line, "\n"])
        .chain([indent.as_str()])
        .collect();
    if prefix.is_empty() {
        return;
    }
    // The comments of the key of a list would stand above each of its headers.
    if let Some(Item::ArrayOfTables(tables)) = table.get_mut(&entry.key) {
        if let Some(first) = tables.get_mut(0) {
            first.decor_mut().set_prefix(format!("\n{prefix}"));
        }
    } else if let Some(mut key) = table.key_mut(&entry.key) {
        key.leaf_decor_mut().set_prefix(prefix);
    }
}

/// Inserts a new first key, which selects the kind of a table, before the others.
fn put_first(table: &mut InlineTable, entries: &[Entry]) {
    if let [
        Entry {
            key,
            node: Node::Text(_),
            ..
        },
        ..,
    ] = entries
    {
        table.sort_values_by(|a, _, b, _| (a != &**key).cmp(&(b != &**key)));
    }
}

/// Removes the space before the closing brace from the last value, so that a key can follow it.
fn take_end(table: &mut InlineTable) -> Option<String> {
    let value = last_value(table)?;
    let end = value.decor().suffix()?.as_str()?.to_owned();
    if end.trim().is_empty() {
        value.decor_mut().set_suffix("");
        Some(end)
    } else {
        None
    }
}

fn put_end(table: &mut InlineTable, end: Option<String>) {
    if let (Some(end), Some(value)) = (end, last_value(table))
        && !value
            .decor()
            .suffix()
            .and_then(RawString::as_str)
            .unwrap_or_default()
            .contains('#')
    {
        value.decor_mut().set_suffix(end);
    }
}

/// The last value in the text.
fn last_value(table: &mut InlineTable) -> Option<&mut Value> {
    let (_, value) = table.iter_mut().last()?;
    if value.as_inline_table().is_some_and(InlineTable::is_dotted) {
        return value.as_inline_table_mut().and_then(last_value);
    }
    Some(value)
}
