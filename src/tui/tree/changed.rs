//! Whether a row differs from the file.

use super::{Node, tuning};
use crate::model::edit;
use crate::model::{Group, Model, ParameterId, SupportId};

/// Whether the row's part of the model differs from `saved`.
pub fn differs(model: &Model, saved: &Model, node: Node) -> bool {
    match node {
        Node::Group(group) => group_differs(model, saved, group),
        Node::Parameter(id) => parameter_differs(model, saved, id),
        Node::StudyLine(..) => false,
    }
}

fn group_differs(model: &Model, saved: &Model, group: Group) -> bool {
    match group {
        Group::Model => model != saved,
        Group::Beam => model.beam != saved.beam || model.spans != saved.spans,
        Group::Material(part) => part.material(model) != part.material(saved),
        Group::Section(part) => part.section(model) != part.section(saved),
        Group::Foundation(part) => part.foundation(model) != part.foundation(saved),
        Group::Spans => model.spans != saved.spans,
        Group::Span(i) => saved.spans.get(i) != Some(&model.spans[i]),
        Group::Supports => model.supports != saved.supports,
        Group::Support(id) => counterpart(model, saved, group).is_none_or(|other| {
            let has_moved = match id {
                SupportId::Left | SupportId::Right => false,
                SupportId::Inner(_) => id.position(model) != other.position(saved),
            };
            has_moved || id.support(model) != other.support(saved)
        }),
        Group::Motion(id, motion) => counterpart(model, saved, group)
            .is_none_or(|other| id.support(model)[motion] != other.support(saved)[motion]),
        Group::Joints => model.joints != saved.joints,
        Group::Joint(i) => saved.joints.get(i) != Some(&model.joints[i]),
        Group::Link(i, motion) => {
            saved.joints.get(i).map(|joint| &joint[motion]) != Some(&model.joints[i][motion])
        }
        Group::Subsystems => model.subsystems != saved.subsystems,
        Group::Subsystem(i) => group
            .counterpart(model, saved)
            .and_then(Group::place)
            .is_none_or(|place| saved.subsystems[place] != model.subsystems[i]),
        Group::Branch(spring, i) => {
            let now = spring.branches(model).get(i);
            now != match group.counterpart(model, saved) {
                Some(Group::Branch(spring, i)) => spring.branches(saved).get(i),
                _ => None,
            }
        }
        Group::Forces => model.forces != saved.forces,
        Group::Force(i) => saved.forces.get(i) != Some(&model.forces[i]),
        Group::Responses => model.responses != saved.responses,
        Group::Response(i) => !saved.responses.contains(&model.responses[i]),
        Group::Sweep => model.sweep != saved.sweep,
        Group::Studies => model.studies != saved.studies,
        Group::Study(i) => !saved.studies.contains(&model.studies[i]),
        Group::Tune => model.tune != saved.tune,
        Group::Variable(i) => tuning::variable_at(model, i) != tuning::variable_at(saved, i),
        Group::Objective(i) => tuning::objective_at(model, i) != tuning::objective_at(saved, i),
        Group::Limit(i) => tuning::limit_at(model, i) != tuning::limit_at(saved, i),
    }
}

/// The support of the same name in another model.
fn counterpart(model: &Model, other: &Model, group: Group) -> Option<SupportId> {
    match group.counterpart(model, other)? {
        Group::Support(id) | Group::Motion(id, _) => Some(id),
        _ => None,
    }
}

fn parameter_differs(model: &Model, saved: &Model, id: ParameterId) -> bool {
    let now = edit::get(model, id).ok();
    let before = id
        .counterpart(model, saved)
        .and_then(|id| edit::get(saved, id).ok());
    now != before
}
