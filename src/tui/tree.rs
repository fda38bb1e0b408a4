//! The model as a tree: its rows, their parents, and their parameters.
//!
//! A [`Node`] is a small value; only visible rows are formatted as text, so a model with thousands of subsystems is as
//! fast to draw as one with three.

mod changed;
mod node;
mod text;
mod tuning;

pub use changed::differs;
pub use node::Node;
pub use text::{label, of_parameter, subject, value, without_unit_of};
pub use tuning::{limit_at, objective_at, variable_at};

use crate::model::schema::{Key, Kind};
use crate::model::{Group, Link, Model, Restraint};

/// A row on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// The node that it shows.
    pub node: Node,
    /// The depth in the tree.
    pub depth: u16,
    /// None for a row without children; else whether the children are visible.
    pub open: Option<bool>,
}

/// The visible rows, in order.
pub fn rows(model: &Model, open: impl Fn(Node) -> bool) -> Vec<Row> {
    let mut rows = Vec::new();
    let groups = Group::Model.groups(model).into_iter().map(Node::Group);
    for node in [Node::TITLE].into_iter().chain(groups) {
        push(model, &open, node, 0, &mut rows);
    }
    rows
}

/// All rows of the model, with every group open.
pub fn all_rows(model: &Model) -> Vec<Row> {
    rows(model, |_| true)
}

fn push(model: &Model, open: &dyn Fn(Node) -> bool, node: Node, depth: u16, rows: &mut Vec<Row>) {
    let group = holds_rows(model, node);
    let shown = group && open(node);
    rows.push(Row {
        node,
        depth,
        open: group.then_some(shown),
    });
    if shown {
        for child in children(model, node) {
            push(model, open, child, depth + 1, rows);
        }
    }
}

fn holds_rows(model: &Model, node: Node) -> bool {
    let Node::Group(group) = node else {
        return false;
    };
    match group {
        Group::Joints | Group::Subsystems | Group::Forces | Group::Responses => {
            !group.groups(model).is_empty()
        }
        Group::Material(_) | Group::Section(_) | Group::Foundation(_) => group.is_there(model),
        Group::Motion(end, motion) => end.support(model)[motion] != Restraint::Fixed,
        Group::Link(joint, motion) => model.joints[joint][motion] != Link::Rigid,
        Group::Variable(_) | Group::Objective(_) | Group::Limit(_) => false,
        _ => true,
    }
}

/// The children of a node, in order: parameters that are not shown elsewhere, then tables.
pub fn children(model: &Model, node: Node) -> Vec<Node> {
    let Node::Group(group) = node else {
        return Vec::new();
    };
    let elsewhere = |key: &Key| match key.kind {
        Kind::Name | Kind::Support | Kind::Restraint | Kind::Link | Kind::Table => true,
        // That of the whole group: its own row shows it.
        Kind::Flag => key.is_on_by_default(),
        _ => false,
    };
    let keys = group.parameters();
    let keys = keys.filter(|id| !elsewhere(id.key()) && id.exists(model));
    let mut children: Vec<Node> = keys.map(Node::Parameter).collect();
    children.extend(group.groups(model).into_iter().map(Node::Group));
    if let Group::Study(i) = group {
        let lines = 0..text::study_lines(&model.studies[i]);
        children.extend(lines.map(|line| Node::StudyLine(i, line)));
    }
    children
}

/// The corresponding row of the next or previous span, subsystem, force, response, study or support.
pub fn alike(model: &Model, node: Node, forward: bool) -> Option<Node> {
    let group = node.group();
    let list = group.owner().parent().filter(|list| *list != Group::Tune)?;
    if matches!(node, Node::StudyLine(..)) {
        return None;
    }
    let place = group.place()?;
    let next = if forward {
        place + 1
    } else {
        place.checked_sub(1)?
    };
    if next < list.groups(model).len() {
        node.of_group(group.at(next))
    } else {
        None
    }
}
