//! The texts of a row: its label, its value, and its full name in messages.

use std::borrow::Cow;

use super::{Node, tuning};
use crate::model::edit::Value;
use crate::model::schema::{self, ElasticKey, Wording};
use crate::model::{
    BeamMotion, Bedding, Family, Foundation, Group, Model, Parameter, Place, Quantity, Restraint,
    Study, Supports, Sweep, Target, Unit, counted, grouped,
};
use crate::tune::words;

/// The label of a row at its place in the tree.
pub fn label(model: &Model, node: Node) -> Cow<'_, str> {
    match node {
        Node::TITLE => "Title".into(),
        Node::Group(group) => group_label(model, group),
        Node::Parameter(id) => spaced(id.key().key),
        Node::StudyLine(i, line) => study_line(&model.studies[i], line).0.into(),
    }
}

fn group_label(model: &Model, group: Group) -> Cow<'_, str> {
    match group {
        Group::Model => "Model".into(),
        Group::Beam => "Beam".into(),
        Group::Material => "Material".into(),
        Group::Section => "Section".into(),
        Group::Foundation => "Foundation".into(),
        Group::Supports => "Supports".into(),
        Group::Subsystems => "Subsystems".into(),
        Group::Forces => "Forces".into(),
        Group::Responses => "Responses".into(),
        Group::Sweep => "Sweep".into(),
        Group::Studies => "Studies".into(),
        Group::Tune => "Tune".into(),
        Group::Support(end) => end.key().into(),
        Group::Motion(_, motion) => spaced(motion.key()),
        Group::Subsystem(i) => model.subsystems[i].name.as_str().into(),
        Group::Force(i) => format!("force {}", i + 1).into(),
        Group::Response(i) => model.responses[i].name.as_str().into(),
        Group::Study(i) => model.studies[i].name.as_str().into(),
        Group::Variable(i) => tuning::variable_at(model, i)
            .map_or_else(String::new, tuning::variable_label)
            .into(),
        Group::Objective(_) | Group::Limit(_) => worded(model, group, |of| of.label).into(),
    }
}

/// `y_left.stiffness` as `y left stiffness`.
fn spaced(key: &str) -> Cow<'_, str> {
    if key.contains(['_', '.']) {
        key.replace(['_', '.'], " ").into()
    } else {
        key.into()
    }
}

/// The motions that a foundation resists.
fn foundation(foundation: &Foundation) -> String {
    let names = ["w", "psi", "v"].into_iter().zip(foundation.beddings());
    let resisted = names.filter(|(_, bedding)| *bedding != Bedding::default());
    let names: Vec<&str> = resisted.map(|(name, _)| name).collect();
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

/// The name of a row in a message: `S1 y_left stiffness`.
pub fn subject(model: &Model, node: Node) -> String {
    match node {
        Node::Parameter(id) => {
            let own = id.key().key.replace('.', " ");
            match id.group {
                Group::Model => own,
                Group::Motion(end, motion) => format!("{} {} {own}", end.key(), motion.key()),
                Group::Beam
                | Group::Material
                | Group::Section
                | Group::Foundation
                | Group::Sweep => {
                    format!("{} {own}", group_label(model, id.group).to_lowercase())
                }
                group => format!("{} {own}", group_label(model, group)),
            }
        }
        Node::Group(Group::Support(end)) => format!("{} support", end.key()),
        Node::Group(Group::Motion(end, motion)) => format!("{} {}", end.key(), motion.key()),
        Node::Group(group @ (Group::Variable(_) | Group::Objective(_) | Group::Limit(_))) => {
            format!("tune {}", group_label(model, group))
        }
        _ => label(model, node).into_owned(),
    }
}

/// The value on the right of a row.
pub fn value(model: &Model, node: Node) -> String {
    match node {
        Node::Group(group) => group_value(model, group),
        Node::Parameter(id) => Parameter::of(model, id).map_or_else(
            |_| String::new(),
            |parameter| of_parameter(&parameter, &parameter.value),
        ),
        Node::StudyLine(i, line) => study_line(&model.studies[i], line).1,
    }
}

fn group_value(model: &Model, group: Group) -> String {
    match group {
        Group::Model => String::new(),
        Group::Beam => Unit::METRE.format(model.beam.length),
        Group::Material => format!(
            "E {}",
            Unit::PASCAL.format(model.beam.material.young_modulus)
        ),
        Group::Section => format!("A {}", Unit::AREA.format(model.beam.section.area)),
        Group::Foundation => foundation(&model.beam.foundation),
        Group::Supports => supports(&model.supports),
        Group::Support(end) => end.support(model).kind().to_owned(),
        Group::Motion(end, motion) => restraint(end.support(model)[motion], motion),
        Group::Subsystems => model.subsystems.len().to_string(),
        Group::Subsystem(i) => {
            let subsystem = &model.subsystems[i];
            switched(subsystem.enabled, || Unit::METRE.format(subsystem.position))
        }
        Group::Forces => model.forces.len().to_string(),
        Group::Force(i) => switched(model.forces[i].enabled, || target(&model.forces[i].target)),
        Group::Responses => model.responses.len().to_string(),
        Group::Response(i) => switched(model.responses[i].enabled, || {
            quantity(&model.responses[i].quantity)
        }),
        Group::Sweep => band(&model.sweep),
        Group::Studies => model.studies.len().to_string(),
        Group::Study(i) => counted(members(&model.studies[i]), "curve", "curves"),
        Group::Tune => model
            .tune
            .as_ref()
            .map_or_else(String::new, tuning::combination),
        Group::Variable(i) => tuning::variable_at(model, i)
            .map_or_else(String::new, |variable| words::bounds(model, variable)),
        Group::Objective(_) | Group::Limit(_) => worded(model, group, |of| of.value),
    }
}

/// The text of an objective or a limit.
fn worded(model: &Model, group: Group, wording: fn(&Wording) -> &'static str) -> String {
    let text = match group {
        Group::Objective(i) => tuning::objective_at(model, i)
            .map(|objective| words::of_objective(model, objective, wording)),
        Group::Limit(i) => {
            tuning::limit_at(model, i).map(|limit| words::of_limit(model, limit, wording))
        }
        _ => None,
    };
    text.unwrap_or_default()
}

fn supports(supports: &Supports) -> String {
    format!("{}, {}", supports.left.kind(), supports.right.kind())
}

fn band(sweep: &Sweep) -> String {
    let (from, to) = (Unit::HERTZ.format(sweep.from), Unit::HERTZ.format(sweep.to));
    format!("{}..{to}", without_unit_of(&from, &to))
}

fn quantity(quantity: &Quantity) -> String {
    match quantity {
        Quantity::Energy => "energy".to_owned(),
        Quantity::Motion(at, _) => target(at),
    }
}

fn switched(enabled: bool, text: impl FnOnce() -> String) -> String {
    if enabled { text() } else { "off".to_owned() }
}

/// A value of a parameter as text, with its unit.
pub fn of_parameter(parameter: &Parameter, value: &Value) -> String {
    match value {
        Value::Number(number) => parameter.unit.format(*number),
        Value::Count(count) => grouped(*count),
        Value::Flag(true) => "on".to_owned(),
        Value::Flag(false) => "off".to_owned(),
        Value::Choice(word) => (*word).to_owned(),
        Value::Text(text) => text.clone(),
    }
}

/// `before` without its unit, if `after` has the same unit.
pub fn without_unit_of<'a>(before: &'a str, after: &str) -> &'a str {
    match (before.split_once(' '), after.split_once(' ')) {
        (Some((number, unit)), Some((_, same))) if unit == same => number,
        _ => before,
    }
}

fn restraint(restraint: Restraint, motion: BeamMotion) -> String {
    let stiffness = &schema::elastic(motion).keys[ElasticKey::Stiffness as usize];
    match restraint {
        Restraint::Elastic(elastic) => stiffness.unit.format(elastic.stiffness),
        held => held.kind().to_owned(),
    }
}

fn target(target: &Target) -> String {
    match target {
        Target::Beam(Place::Left, motion) => format!("{} at left", motion.key()),
        Target::Beam(Place::Right, motion) => format!("{} at right", motion.key()),
        Target::Beam(Place::Position(x), motion) => {
            format!("{} at {}", motion.key(), Unit::METRE.format(*x))
        }
        Target::Mass(name, motion) => format!("{} of {name}", motion.key()),
    }
}

fn members(study: &Study) -> usize {
    match &study.family {
        Family::Vary { values, .. } => values.len(),
        Family::Cases(cases) => cases.len(),
    }
}

/// The number of lines of a study in the tree.
pub(super) fn study_lines(study: &Study) -> usize {
    match &study.family {
        Family::Vary { paths, .. } => paths.len() + 1,
        Family::Cases(cases) => cases.len(),
    }
}

/// A line of a study: its path and factors.
fn study_line(study: &Study, line: usize) -> (String, String) {
    match &study.family {
        Family::Vary {
            operation, values, ..
        } if line == 0 => {
            let values: Vec<String> = values.iter().map(f64::to_string).collect();
            (operation.key().to_owned(), values.join(" "))
        }
        Family::Vary { paths, .. } => (paths[line - 1].to_string(), String::new()),
        Family::Cases(cases) => {
            let case = &cases[line];
            let set = match case.set.len() {
                0 => "as the model".to_owned(),
                count => format!("{count} set"),
            };
            (case.name.clone(), set)
        }
    }
}
