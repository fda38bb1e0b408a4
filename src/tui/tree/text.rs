//! The texts of a row: its label, its value, and its full name in messages.

use std::borrow::Cow;

use super::{Node, tuning};
use crate::model::edit::Value;
use crate::model::schema::{self, BranchKey, ElasticKey, LinkKey, Wording};
use crate::model::{
    At, BeamMotion, Bedding, Family, Foundation, Group, Link, Model, Parameter, ParameterId, Place,
    Point, Response, Restraint, SpringId, Study, SupportId, Supports, Sweep, Target, Unit, counted,
    grouped,
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
        Group::Material(_) => "Material".into(),
        Group::Section(_) => "Section".into(),
        Group::Foundation(_) => "Foundation".into(),
        Group::Spans => "Spans".into(),
        Group::Span(i) => format!("span {}", i + 1).into(),
        Group::Supports => "Supports".into(),
        Group::Joints => "Joints".into(),
        Group::Subsystems => "Subsystems".into(),
        Group::Forces => "Forces".into(),
        Group::Responses => "Responses".into(),
        Group::Sweep => "Sweep".into(),
        Group::Studies => "Studies".into(),
        Group::Tune => "Tune".into(),
        Group::Support(id) => id.name(model).into(),
        Group::Motion(_, motion) | Group::Link(_, motion) => spaced(motion.key()),
        Group::Joint(i) => format!("joint {}", i + 1).into(),
        Group::Subsystem(i) => model.subsystems[i].name.as_str().into(),
        Group::Branch(SpringId::Subsystem(_, spring), i) => {
            format!("{} branch {}", spaced(spring.key()), i + 1).into()
        }
        Group::Branch(_, i) => format!("branch {}", i + 1).into(),
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

/// The text of a table that a span may have from the beam.
fn own_or_beams<T>(table: Option<&T>, text: impl Fn(&T) -> String) -> String {
    table.map_or_else(|| "the beam's".to_owned(), text)
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
                Group::Motion(id, motion) => format!("{} {} {own}", id.name(model), motion.key()),
                Group::Link(..) | Group::Branch(..) => {
                    format!("{} {own}", subject(model, Node::Group(id.group)))
                }
                Group::Support(id) => format!("{} {own}", support(model, id)),
                group if ParameterId::owner_of(group).is_some() => {
                    format!("{} {own}", subject(model, Node::Group(group)))
                }
                Group::Beam
                | Group::Material(_)
                | Group::Section(_)
                | Group::Foundation(_)
                | Group::Sweep => {
                    format!("{} {own}", group_label(model, id.group).to_lowercase())
                }
                group => format!("{} {own}", group_label(model, group)),
            }
        }
        Node::Group(Group::Support(id)) => support(model, id),
        Node::Group(Group::Motion(id, motion)) => format!("{} {}", id.name(model), motion.key()),
        Node::Group(Group::Link(i, motion)) => format!("joint {} {}", i + 1, motion.key()),
        Node::Group(Group::Branch(spring, i)) => {
            let owner = group_label(model, spring.owner());
            format!("{owner} {} branch {}", spring.key(), i + 1)
        }
        Node::Group(group @ (Group::Variable(_) | Group::Objective(_) | Group::Limit(_))) => {
            format!("tune {}", group_label(model, group))
        }
        Node::Group(group) => match ParameterId::owner_of(group) {
            Some(word) => format!("{} {}", group_label(model, word.group), word.key().key),
            None => group_label(model, group).into_owned(),
        },
        Node::StudyLine(..) => label(model, node).into_owned(),
    }
}

/// A support in a message: `left support`, or the name of an inner one.
fn support(model: &Model, id: SupportId) -> String {
    match id {
        SupportId::Left | SupportId::Right => format!("{} support", id.name(model)),
        SupportId::Inner(_) => id.name(model).to_owned(),
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
        Group::Beam => {
            let length = Unit::METRE.format(model.length());
            match model.spans.len() {
                0 => length,
                spans => format!("{length}, {}", counted(spans, "span", "spans")),
            }
        }
        Group::Material(part) => own_or_beams(part.material(model), |material| {
            format!("E {}", Unit::PASCAL.format(material.young_modulus))
        }),
        Group::Section(part) => own_or_beams(part.section(model), |section| {
            format!("A {}", Unit::AREA.format(section.area))
        }),
        Group::Foundation(part) => own_or_beams(part.foundation(model), foundation),
        Group::Spans => model.spans.len().to_string(),
        Group::Span(i) => Unit::METRE.format(model.spans[i].length),
        Group::Supports => supports(&model.supports),
        Group::Support(id @ (SupportId::Left | SupportId::Right)) => {
            id.support(model).kind().to_owned()
        }
        Group::Support(id @ SupportId::Inner(_)) => Unit::METRE.format(id.position(model)),
        Group::Joints => model.joints.len().to_string(),
        Group::Joint(i) => Unit::METRE.format(model.joints[i].position),
        Group::Link(i, motion) => link(&model.joints[i][motion], motion),
        Group::Motion(end, motion) => restraint(&end.support(model)[motion], motion),
        Group::Subsystems => model.subsystems.len().to_string(),
        Group::Branch(spring, i) => branch(model, spring, i),
        Group::Subsystem(i) => {
            let subsystem = &model.subsystems[i];
            switched(subsystem.enabled, || Unit::METRE.format(subsystem.position))
        }
        Group::Forces => model.forces.len().to_string(),
        Group::Force(i) => {
            let force = &model.forces[i];
            switched(force.enabled, || target(&force.target, force.point))
        }
        Group::Responses => model.responses.len().to_string(),
        Group::Response(i) => {
            switched(model.responses[i].enabled, || quantity(&model.responses[i]))
        }
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
    let ends = format!("{}, {}", supports.left.kind(), supports.right.kind());
    match supports.inner.len() {
        0 => ends,
        count => format!("{ends}, {} inner", grouped(count)),
    }
}

fn band(sweep: &Sweep) -> String {
    let (from, to) = (Unit::HERTZ.format(sweep.from), Unit::HERTZ.format(sweep.to));
    format!("{}..{to}", without_unit_of(&from, &to))
}

fn quantity(response: &Response) -> String {
    let quantity = &response.quantity;
    let what = match (quantity.target(), quantity.at(), quantity.direction()) {
        (Some(at), ..) => target(at, response.point),
        (None, Some(at), Some(direction)) => {
            let word = quantity.word().replace('_', " ");
            format!("{word} {direction} {}", place(at))
        }
        (None, ..) => quantity.word().to_owned(),
    };
    match &response.over {
        Some(over) => format!("{what} / {over}"),
        None => what,
    }
}

/// A position after a direction.
fn place(at: At<'_>) -> String {
    match at {
        At::Beam(Place::Left) => "at left".to_owned(),
        At::Beam(Place::Right) => "at right".to_owned(),
        At::Beam(Place::Position(x)) => format!("at {}", Unit::METRE.format(x)),
        At::Support(name) => format!("at {name}"),
        At::Subsystem(name) => format!("of {name}"),
        At::Ground => "at ground".to_owned(),
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

fn restraint(restraint: &Restraint, motion: BeamMotion) -> String {
    let stiffness = &schema::elastic(motion).keys[ElasticKey::Stiffness as usize];
    match restraint {
        Restraint::Elastic(elastic) => stiffness.unit.format(elastic.spring.stiffness),
        held => held.kind().to_owned(),
    }
}

fn link(link: &Link, motion: BeamMotion) -> String {
    let stiffness = &schema::link(motion).keys[LinkKey::Stiffness as usize];
    match link {
        Link::Elastic(spring) => stiffness.unit.format(spring.stiffness),
        joined => joined.kind().to_owned(),
    }
}

fn branch(model: &Model, spring: SpringId, index: usize) -> String {
    let stiffness = Group::Branch(spring, index).parameter(BranchKey::Stiffness as usize);
    value(model, Node::Parameter(stiffness))
}

/// A motion or load, its position, and the coordinate of its point of the section that matters.
fn target(target: &Target, point: Point) -> String {
    let (name, coordinate) = match target {
        Target::Beam(_, BeamMotion::W) => ("z", point.z),
        Target::Beam(_, BeamMotion::V) => ("y", point.y),
        Target::Beam(..) | Target::Mass(..) => ("", 0.0),
    };
    let offset = if coordinate == 0.0 {
        String::new()
    } else {
        format!(", {name} {}", Unit::METRE.format(coordinate))
    };
    format!("{} {}{offset}", target.direction(), place(target.at()))
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
