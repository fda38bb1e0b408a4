//! The elements of lists.

use super::super::spelling::element_keys;
use super::reader::Reader;
use super::table::Table;
use super::value::Node;
use std::collections::HashMap;

/// The names in a list of tables; an empty text for a table without a name.
pub(super) fn names<'a>(list: &[Node<'a>]) -> Vec<&'a str> {
    list.iter()
        .map(|node| {
            node.get_ref()
                .get("name")
                .and_then(|name| name.get_ref().as_str())
                .unwrap_or("")
        })
        .collect()
}

/// The tables of a list of named tables; none for an element that is not a table.
pub(super) fn named<'a>(
    list: &[Node<'a>],
    path: &str,
    reader: &mut Reader,
) -> Vec<Option<Table<'a>>> {
    let keys = element_keys(names(list).into_iter());
    let mut first = HashMap::new();
    for (node, key) in list.iter().zip(&keys) {
        if let Some(name) = node.get_ref().get("name")
            && let Some(word) = name
                .get_ref()
                .as_str()
                .filter(|word| !word.trim().is_empty())
        {
            let here = name.span().start;
            let there = *first.entry(word).or_insert(here);
            if here != there {
                reader.used_twice(here, &format!("{path}.{key}.name"), word, there);
            }
        }
    }
    list.iter()
        .zip(keys)
        .map(|(node, key)| Table::open(format!("{path}.{key}"), node, reader))
        .collect()
}

/// The elements of an array with their paths.
pub(super) fn elements<'a>(
    key: &'static str,
    of: &str,
    table: &mut Table<'a>,
    reader: &mut Reader,
) -> Vec<(String, Node<'a>)> {
    let list = table.list(key, of, reader);
    let at = table.at(key);
    let numbered = list
        .into_iter()
        .enumerate()
        .map(|(index, node)| (format!("{at}.{}", index + 1), node));
    let elements: Vec<_> = numbered.collect();
    for (path, node) in &elements {
        reader.place(path, node.span().start);
    }
    elements
}
