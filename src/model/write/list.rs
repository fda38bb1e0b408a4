//! Merges lists: matches old and new elements, and positions them.

use super::array_layout::ArrayLayout;
use super::header_positions::{set_table_position, table_positions};
use super::merge::{Style, merge_item, merge_table, same, same_table, same_value};
use super::new_items;
use super::node::{Entry, Node};
use std::collections::HashSet;
use toml_edit::{Array, ArrayOfTables, Item, RawString, Table, TableLike, Value};

/// The matching old element of each new one: first by name (or content, without names), then the remaining ones in
/// order.
fn align(count: usize, nodes: &[Node], alike: impl Fn(usize, &Node) -> bool) -> Vec<Option<usize>> {
    let mut free = vec![true; count];
    let mut from = vec![None; nodes.len()];
    for (new, node) in nodes.iter().enumerate().take(count) {
        if alike(new, node) {
            free[new] = false;
            from[new] = Some(new);
        }
    }
    for (new, node) in nodes.iter().enumerate() {
        if from[new].is_none()
            && let Some(old) = (0..count).find(|old| free[*old] && alike(*old, node))
        {
            free[old] = false;
            from[new] = Some(old);
        }
    }
    let mut left_over = (0..count).filter(|old| free[*old]);
    for from in from.iter_mut().filter(|from| from.is_none()) {
        *from = left_over.next();
    }
    from
}

fn stays(from: &[Option<usize>], count: usize) -> bool {
    from.len() == count && from.iter().enumerate().all(|(new, old)| *old == Some(new))
}

/// Whether a table has this identity.
fn is_it(table: &dyn TableLike, identity: &Entry) -> bool {
    table
        .get(&identity.key)
        .is_some_and(|item| same(item, &identity.node))
}

/// Merges an array of tables. Comments move with their element; a comment above the first element with an empty line
/// between stays first.
pub(super) fn merge_tables(tables: &mut ArrayOfTables, nodes: &[Node]) {
    let mut old: Vec<Table> = std::mem::take(tables).into_iter().collect();
    let from = align(old.len(), nodes, |index, node| match node.identity() {
        Some(identity) => is_it(&old[index], identity),
        None => node
            .entries()
            .is_some_and(|entries| same_table(&old[index], entries)),
    });
    let heading = if stays(&from, old.len()) {
        String::new()
    } else {
        take_heading(&mut old, &from)
    };
    let reordered = !from.iter().flatten().is_sorted();
    let mut place = first_place(&old, &from, reordered);
    for (node, from) in nodes.iter().zip(&from) {
        let entries = node.entries().unwrap_or_default();
        let mut table = from.map_or_else(
            || new_items::table(entries),
            |index| std::mem::take(&mut old[index]),
        );
        let last = table_positions(&table).map(|(_, last)| last);
        if from.is_some() {
            merge_table(&mut table, Style::Header, entries);
        }
        if reordered || from.is_none() {
            set_table_position(&mut table, place);
        } else {
            place = last.or(place);
        }
        if tables.is_empty() {
            prepend(&mut table, &heading);
        }
        tables.push(table);
    }
}

/// The position of the first header of a list; headers of the same position are written in the order of the list.
fn first_place(old: &[Table], from: &[Option<usize>], reordered: bool) -> Option<isize> {
    let first = |index: usize| table_positions(&old[index]).map(|(first, _)| first);
    if reordered {
        (0..old.len()).filter_map(first).min()
    } else {
        from.iter().flatten().find_map(|index| first(*index))
    }
}

/// Moves the headings of removed elements to the next remaining ones, and returns the heading of the first element if
/// it will not be the first.
fn take_heading(old: &mut [Table], from: &[Option<usize>]) -> String {
    let kept: HashSet<usize> = from.iter().flatten().copied().collect();
    let mut carried = String::new();
    for (index, table) in old.iter_mut().enumerate().skip(1) {
        if kept.contains(&index) {
            prepend(table, &std::mem::take(&mut carried));
        } else {
            carried.push_str(&cut_heading(table));
        }
    }
    match (old.first_mut(), from.first()) {
        (Some(first), Some(new)) if *new != Some(0) => cut_heading(first),
        _ => String::new(),
    }
}

/// Removes and returns the comments above a header with an empty line between.
fn cut_heading(table: &mut Table) -> String {
    let prefix = table
        .decor()
        .prefix()
        .and_then(RawString::as_str)
        .unwrap_or_default();
    let Some((heading, own)) = prefix
        .rsplit_once("\n\n")
        .filter(|(heading, _)| heading.contains('#'))
    else {
        return String::new();
    };
    let (heading, own) = (format!("{heading}\n\n"), format!("\n{own}"));
    table.decor_mut().set_prefix(own);
    heading
}

fn prepend(table: &mut Table, heading: &str) {
    if !heading.is_empty() {
        let own = table
            .decor()
            .prefix()
            .and_then(RawString::as_str)
            .unwrap_or_default();
        let prefix = format!("{heading}{}", own.trim_start_matches('\n'));
        table.decor_mut().set_prefix(prefix);
    }
}

/// Merges an array in brackets.
pub(super) fn merge_array(array: &mut Array, nodes: &[Node]) {
    let mut old: Vec<Value> = array.iter().cloned().collect();
    let from = align(old.len(), nodes, |index, node| match node.identity() {
        Some(identity) => old[index]
            .as_inline_table()
            .is_some_and(|table| is_it(table, identity)),
        None => same_value(&old[index], node),
    });
    let moved = !stays(&from, old.len());
    let layout = moved.then(|| ArrayLayout::take(array, &mut old));
    let merge = |(node, from): (&Node, &Option<usize>)| match from {
        Some(index) => merge_value(old[*index].clone(), node),
        None => new_items::value(node),
    };
    let mut values: Vec<Value> = nodes.iter().zip(&from).map(merge).collect();
    if let Some(layout) = layout {
        layout.apply(array, &mut values, &from);
    }
    array.clear();
    for value in values {
        array.push_formatted(value);
    }
}

fn merge_value(old: Value, node: &Node) -> Value {
    let mut item = Item::Value(old);
    if merge_item(&mut item, node)
        && let Item::Value(value) = item
    {
        value
    } else {
        new_items::value(node)
    }
}
