//! A tree of keys and values on one line of TOML.

use super::super::serial::{basic_string, format_number};
use super::node::{Entry, Node, Presence};
use std::fmt::Write as _;

/// Adds a table in braces; what is at its default is left out.
pub(super) fn table(entries: &[Entry], text: &mut String) {
    let written = entries
        .iter()
        .filter(|entry| entry.presence == Presence::Always);
    text.push('{');
    for (index, entry) in written.enumerate() {
        text.push_str(if index > 0 { ", " } else { "" });
        text.push_str(&key(&entry.key));
        text.push_str(" = ");
        node(&entry.node, text);
    }
    text.push('}');
}

fn node(node: &Node, text: &mut String) {
    match node {
        Node::Number(number) => text.push_str(&format_number(*number)),
        // Writing to a string cannot fail.
        Node::Count(count) => drop(write!(text, "{count}")),
        Node::Flag(flag) => drop(write!(text, "{flag}")),
        Node::Text(words) => text.push_str(&basic_string(words)),
        Node::List(nodes) | Node::Tables(nodes) => list(nodes, text),
        Node::Inline(entries) | Node::Ordered(entries) | Node::Table(entries) => {
            table(entries, text);
        }
    }
}

fn list(nodes: &[Node], text: &mut String) {
    text.push('[');
    for (index, element) in nodes.iter().enumerate() {
        text.push_str(if index > 0 { ", " } else { "" });
        node(element, text);
    }
    text.push(']');
}

/// A key, in quotes where it needs them.
fn key(key: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !key.is_empty() && key.chars().all(bare) {
        key.to_owned()
    } else {
        basic_string(key)
    }
}
