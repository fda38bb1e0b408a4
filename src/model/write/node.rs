//! The tree of keys and values of a model file.

use std::borrow::Cow;

/// A value of the file.
pub(super) enum Node {
    /// A number, always with a point or an exponent.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// True or false.
    Flag(bool),
    /// A text in quotes.
    Text(String),
    /// An array in brackets.
    List(Vec<Node>),
    /// A table in braces.
    Inline(Vec<Entry>),
    /// A table in braces whose keys keep their order.
    Ordered(Vec<Entry>),
    /// A table below a header.
    Table(Vec<Entry>),
    /// Tables below a double header each.
    Tables(Vec<Node>),
}

impl Node {
    /// The entries of a table of any kind.
    pub(super) fn entries(&self) -> Option<&[Entry]> {
        match self {
            Self::Inline(entries) | Self::Ordered(entries) | Self::Table(entries) => Some(entries),
            _ => None,
        }
    }

    /// The elements of a list of any kind.
    pub(super) fn elements(&self) -> Option<&[Self]> {
        match self {
            Self::List(nodes) | Self::Tables(nodes) => Some(nodes),
            _ => None,
        }
    }

    /// The entry that identifies a table in its list: its name or its paths.
    pub(super) fn identity(&self) -> Option<&Entry> {
        let mut entries = self.entries()?.iter();
        entries.find(|entry| matches!(&*entry.key, "name" | "path" | "paths"))
    }
}

/// A key with its value.
pub(super) struct Entry {
    pub(super) key: Cow<'static, str>,
    pub(super) node: Node,
    pub(super) presence: Presence,
}

/// Whether a key is written if the original does not have it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Presence {
    /// Always.
    Always,
    /// At its default: only in a new table, to show it.
    InNewTables,
    /// At its default: never.
    OnlyIfThere,
}
