//! The tree of keys and values that a model is written as.

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
    /// A table in braces, in which the order of the keys means something.
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

    /// What tells a table from others like it: its name, or the parameters it is about.
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

/// Whether a key is written where the file does not have it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Presence {
    /// It is.
    Always,
    /// At its default: only with its whole table, for people to see.
    InNewTables,
    /// At its default: never.
    OnlyIfThere,
}
