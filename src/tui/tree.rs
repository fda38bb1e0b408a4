//! The model as a tree: which rows there are, what holds them, and which parameter each of them is.
//!
//! A [`Node`] is a small value; texts are made from it only for the rows that are on the screen, so a model with
//! thousands of subsystems costs no more to draw than one with three.

mod node;
mod parameter;
mod text;
mod tuning;

pub use node::{End, Node};
pub use parameter::{differs, enabled_path, name_path, parameter_path};
pub use text::{label, of_parameter, subject, value, without_unit_of};
pub use tuning::{limit_at, objective_at, variable_at};

use std::collections::HashMap;

use crate::model::{BeamMotion, Model, Quantity, Response, Restraint, Tune, field};

/// A row on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// What it shows.
    pub node: Node,
    /// How deep it is in the tree.
    pub depth: u16,
    /// None: it holds no rows. Else whether they are shown.
    pub open: Option<bool>,
}

/// The rows that are shown, in order.
pub fn rows(model: &Model, open: impl Fn(Node) -> bool) -> Vec<Row> {
    let mut rows = Vec::new();
    for node in roots(model) {
        push(model, &open, node, 0, &mut rows);
    }
    rows
}

/// The row of every parameter by its path.
pub fn nodes_by_path(model: &Model) -> HashMap<String, Node> {
    let rows = all_rows(model).into_iter();
    rows.filter_map(|row| Some((parameter_path(model, row.node)?, row.node)))
        .collect()
}

/// All rows of the model, as if every group were open.
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

fn roots(model: &Model) -> Vec<Node> {
    let mut roots = vec![
        Node::Title,
        Node::Beam,
        Node::Supports,
        Node::Subsystems,
        Node::Forces,
        Node::Responses,
        Node::Sweep,
    ];
    if !model.studies.is_empty() {
        roots.push(Node::Studies);
    }
    if model.tune.is_some() {
        roots.push(Node::Tune);
    }
    roots
}

fn holds_rows(model: &Model, node: Node) -> bool {
    match node {
        Node::Subsystems => !model.subsystems.is_empty(),
        Node::Forces => !model.forces.is_empty(),
        Node::Responses => !model.responses.is_empty(),
        Node::Motion(end, motion) => end.support(model)[motion] != Restraint::Fixed,
        Node::Beam
        | Node::Material
        | Node::Section
        | Node::Supports
        | Node::Support(_)
        | Node::Subsystem(_)
        | Node::Force(_)
        | Node::Response(_)
        | Node::Sweep
        | Node::Studies
        | Node::Study(_)
        | Node::Tune => true,
        _ => false,
    }
}

/// The rows that a node holds, in order.
pub fn children(model: &Model, node: Node) -> Vec<Node> {
    let numbered = |count: usize, node: &dyn Fn(usize) -> Node| (0..count).map(node).collect();
    let with = |nodes: Vec<Node>, more: &[Node]| [nodes.as_slice(), more].concat();
    match node {
        Node::Beam => with(
            numbered(field::BEAM.len(), &Node::BeamNumber),
            &[Node::Material, Node::Section],
        ),
        Node::Material => numbered(field::MATERIAL.len(), &Node::MaterialNumber),
        Node::Section => numbered(field::SECTION.len(), &Node::SectionNumber),
        Node::Supports => vec![Node::Support(End::Left), Node::Support(End::Right)],
        Node::Support(end) => BeamMotion::ALL
            .map(|motion| Node::Motion(end, motion))
            .to_vec(),
        Node::Motion(end, motion) => (0..motion_keys(motion).len())
            .map(|row| Node::MotionNumber(end, motion, row))
            .collect(),
        Node::Subsystems => numbered(model.subsystems.len(), &Node::Subsystem),
        Node::Subsystem(i) => (0..field::SUBSYSTEM.len())
            .map(|row| Node::SubsystemNumber(i, row))
            .collect(),
        Node::Forces => numbered(model.forces.len(), &Node::Force),
        Node::Force(i) => {
            let numbers = (0..field::FORCE.len()).map(|row| Node::ForceNumber(i, row));
            [Node::ForceAt(i), Node::ForceDirection(i)]
                .into_iter()
                .chain(numbers)
                .collect()
        }
        Node::Responses => numbered(model.responses.len(), &Node::Response),
        Node::Response(i) => response_children(&model.responses[i], i),
        Node::Sweep => with(
            numbered(field::SWEEP.len(), &Node::SweepNumber),
            &[Node::SweepPoints, Node::SweepSpacing],
        ),
        Node::Studies => numbered(model.studies.len(), &Node::Study),
        Node::Study(i) => (0..text::study_lines(&model.studies[i]))
            .map(|row| Node::StudyLine(i, row))
            .collect(),
        Node::Tune => {
            let count = |of: fn(&Tune) -> usize| tuning::count(model, of);
            [
                numbered(count(|tune| tune.variables.len()), &Node::TuneVariable),
                numbered(count(|tune| tune.objectives.len()), &Node::TuneObjective),
                numbered(count(|tune| tune.limits.len()), &Node::TuneLimit),
            ]
            .concat()
        }
        _ => Vec::new(),
    }
}

fn response_children(response: &Response, i: usize) -> Vec<Node> {
    match response.quantity {
        Quantity::Energy => vec![Node::ResponseMeasure(i)],
        Quantity::Motion(..) => vec![
            Node::ResponseMeasure(i),
            Node::ResponseAt(i),
            Node::ResponseDirection(i),
        ],
    }
}

/// The node that holds a node.
pub fn parent(node: Node) -> Option<Node> {
    Some(match node {
        Node::BeamNumber(_) | Node::Material | Node::Section => Node::Beam,
        Node::MaterialNumber(_) => Node::Material,
        Node::SectionNumber(_) => Node::Section,
        Node::Support(_) => Node::Supports,
        Node::Motion(end, _) => Node::Support(end),
        Node::MotionNumber(end, motion, _) => Node::Motion(end, motion),
        Node::Subsystem(_) => Node::Subsystems,
        Node::SubsystemNumber(i, _) => Node::Subsystem(i),
        Node::Force(_) => Node::Forces,
        Node::ForceAt(i) | Node::ForceDirection(i) | Node::ForceNumber(i, _) => Node::Force(i),
        Node::Response(_) => Node::Responses,
        Node::ResponseMeasure(i) | Node::ResponseAt(i) | Node::ResponseDirection(i) => {
            Node::Response(i)
        }
        Node::SweepNumber(_) | Node::SweepPoints | Node::SweepSpacing => Node::Sweep,
        Node::Study(_) => Node::Studies,
        Node::StudyLine(i, _) => Node::Study(i),
        Node::TuneVariable(_) | Node::TuneObjective(_) | Node::TuneLimit(_) => Node::Tune,
        Node::Title
        | Node::Beam
        | Node::Supports
        | Node::Subsystems
        | Node::Forces
        | Node::Responses
        | Node::Sweep
        | Node::Studies
        | Node::Tune => return None,
    })
}

/// The subsystem, force, response or study that a row belongs to.
pub fn item(node: Node) -> Option<Node> {
    let mut node = node;
    loop {
        if let Node::Subsystem(_) | Node::Force(_) | Node::Response(_) | Node::Study(_) = node {
            return Some(node);
        }
        node = parent(node)?;
    }
}

/// The row with the same meaning in the neighbouring subsystem, force, response, study or support.
pub fn alike(model: &Model, node: Node, forward: bool) -> Option<Node> {
    let step = |i: usize, count: usize| {
        let next = if forward { i + 1 } else { i.checked_sub(1)? };
        (next < count).then_some(next)
    };
    let other_end = |end: End| match (end, forward) {
        (End::Left, true) => Some(End::Right),
        (End::Right, false) => Some(End::Left),
        _ => None,
    };
    let (subsystems, forces, responses) = (
        model.subsystems.len(),
        model.forces.len(),
        model.responses.len(),
    );
    Some(match node {
        Node::Support(end) => Node::Support(other_end(end)?),
        Node::Motion(end, motion) => Node::Motion(other_end(end)?, motion),
        Node::MotionNumber(end, motion, row) => Node::MotionNumber(other_end(end)?, motion, row),
        Node::Subsystem(i) => Node::Subsystem(step(i, subsystems)?),
        Node::SubsystemNumber(i, row) => Node::SubsystemNumber(step(i, subsystems)?, row),
        Node::Force(i) => Node::Force(step(i, forces)?),
        Node::ForceAt(i) => Node::ForceAt(step(i, forces)?),
        Node::ForceDirection(i) => Node::ForceDirection(step(i, forces)?),
        Node::ForceNumber(i, row) => Node::ForceNumber(step(i, forces)?, row),
        Node::Response(i) => Node::Response(step(i, responses)?),
        Node::ResponseMeasure(i) => Node::ResponseMeasure(step(i, responses)?),
        Node::ResponseAt(i) => Node::ResponseAt(step(i, responses)?),
        Node::ResponseDirection(i) => Node::ResponseDirection(step(i, responses)?),
        Node::Study(i) => Node::Study(step(i, model.studies.len())?),
        _ => return None,
    })
}

/// The keys of the numbers of an end's spring.
fn motion_keys(motion: BeamMotion) -> [&'static str; 3] {
    let table = field::elastic_fields(motion);
    [table[0].key, table[1].key, table[2].key]
}
