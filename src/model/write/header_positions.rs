//! Positions of table headers in the file.

use toml_edit::{Item, Table};

/// The first and the last position of the headers of an item.
pub(super) fn positions(item: &Item) -> Option<(isize, isize)> {
    match item {
        Item::Table(table) => table_positions(table),
        Item::ArrayOfTables(tables) => tables.iter().filter_map(table_positions).reduce(span),
        _ => None,
    }
}

/// The same for one table and its inner tables.
pub(super) fn table_positions(table: &Table) -> Option<(isize, isize)> {
    let own = table.position().map(|position| (position, position));
    own.into_iter()
        .chain(table.iter().filter_map(|(_, item)| positions(item)))
        .reduce(span)
}

fn span(a: (isize, isize), b: (isize, isize)) -> (isize, isize) {
    (a.0.min(b.0), a.1.max(b.1))
}

/// Gives all headers of an item the same position; they keep their relative order.
pub(super) fn set_position(item: &mut Item, position: Option<isize>) {
    match item {
        Item::Table(table) => set_table_position(table, position),
        Item::ArrayOfTables(tables) => tables
            .iter_mut()
            .for_each(|table| set_table_position(table, position)),
        _ => {}
    }
}

/// The same for one table and its inner tables.
pub(super) fn set_table_position(table: &mut Table, position: Option<isize>) {
    table.set_position(position);
    table
        .iter_mut()
        .for_each(|(_, item)| set_position(item, position));
}
