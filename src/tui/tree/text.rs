//! The words of a row: its label, its value, and its full name in messages.

use std::borrow::Cow;

use super::{End, Node, motion_keys, parameter_path, tuning};
use crate::model::path::{self, Parameter, Value};
use crate::model::{
    BeamMotion, Family, Model, Place, Quantity, Restraint, Study, Supports, Sweep, Target, Unit,
    counted, field, grouped,
};
use crate::tune::words;

/// What a row is called, at its place in the tree.
pub fn label(model: &Model, node: Node) -> Cow<'_, str> {
    match node {
        Node::Title => "Title".into(),
        Node::Beam => "Beam".into(),
        Node::Material => "Material".into(),
        Node::Section => "Section".into(),
        Node::Supports => "Supports".into(),
        Node::Subsystems => "Subsystems".into(),
        Node::Forces => "Forces".into(),
        Node::Responses => "Responses".into(),
        Node::Sweep => "Sweep".into(),
        Node::Studies => "Studies".into(),
        Node::Tune => "Tune".into(),
        Node::Support(end) => end.key().into(),
        Node::Motion(_, motion) => spaced(motion.key()),
        Node::Subsystem(i) => model.subsystems[i].name.as_str().into(),
        Node::Force(i) => format!("force {}", i + 1).into(),
        Node::Response(i) => model.responses[i].name.as_str().into(),
        Node::Study(i) => model.studies[i].name.as_str().into(),
        Node::StudyLine(i, line) => study_line(&model.studies[i], line).0.into(),
        Node::TuneVariable(i) => tuning::variable_at(model, i)
            .map_or_else(String::new, tuning::variable_label)
            .into(),
        Node::TuneObjective(i) => tuning::objective_at(model, i)
            .map_or("", |objective| tuning::objective_label(&objective.aim))
            .into(),
        Node::TuneLimit(i) => tuning::limit_at(model, i)
            .map_or("", tuning::limit_label)
            .into(),
        Node::ForceAt(_) | Node::ResponseAt(_) => "at".into(),
        Node::ForceDirection(_) | Node::ResponseDirection(_) => "direction".into(),
        Node::ResponseMeasure(_) => "measure".into(),
        Node::SweepPoints => "points".into(),
        Node::SweepSpacing => "spacing".into(),
        Node::BeamNumber(_)
        | Node::MaterialNumber(_)
        | Node::SectionNumber(_)
        | Node::MotionNumber(..)
        | Node::SubsystemNumber(..)
        | Node::ForceNumber(..)
        | Node::SweepNumber(_) => spaced(number_key(node)),
    }
}

fn number_key(node: Node) -> &'static str {
    match node {
        Node::BeamNumber(row) => field::BEAM[row].key,
        Node::MaterialNumber(row) => field::MATERIAL[row].key,
        Node::SectionNumber(row) => field::SECTION[row].key,
        Node::MotionNumber(_, motion, row) => motion_keys(motion)[row],
        Node::SubsystemNumber(_, row) => field::SUBSYSTEM[row].key,
        Node::ForceNumber(_, row) => field::FORCE[row].key,
        Node::SweepNumber(row) => field::SWEEP[row].key,
        _ => "",
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

/// What a row is called in a message: `S1 y_left stiffness`.
pub fn subject(model: &Model, node: Node) -> String {
    let own = match node {
        Node::Motion(_, motion) => motion.key().to_owned(),
        Node::Title => "title".to_owned(),
        _ if number_key(node).is_empty() => label(model, node).into_owned(),
        _ => number_key(node).replace('.', " "),
    };
    with_owner(model, node, own)
}

/// A name of a row with the name of what it belongs to before it.
fn with_owner(model: &Model, node: Node, own: String) -> String {
    let owner = match node {
        Node::BeamNumber(_) => "beam".to_owned(),
        Node::MaterialNumber(_) => "material".to_owned(),
        Node::SectionNumber(_) => "section".to_owned(),
        Node::Support(end) => return format!("{} support", end.key()),
        Node::Motion(end, _) => end.key().to_owned(),
        Node::MotionNumber(end, motion, _) => format!("{} {}", end.key(), motion.key()),
        Node::SubsystemNumber(i, _) => model.subsystems[i].name.clone(),
        Node::ForceAt(i) | Node::ForceDirection(i) | Node::ForceNumber(i, _) => {
            format!("force {}", i + 1)
        }
        Node::ResponseMeasure(i) | Node::ResponseAt(i) | Node::ResponseDirection(i) => {
            model.responses[i].name.clone()
        }
        Node::SweepNumber(_) | Node::SweepPoints | Node::SweepSpacing => "sweep".to_owned(),
        Node::TuneVariable(_) | Node::TuneObjective(_) | Node::TuneLimit(_) => "tune".to_owned(),
        _ => return own,
    };
    format!("{owner} {own}")
}

/// The value at the right of a row.
pub fn value(model: &Model, node: Node) -> String {
    match node {
        Node::Beam => Unit::METRE.format(model.beam.length),
        Node::Material => format!(
            "E {}",
            Unit::PASCAL.format(model.beam.material.young_modulus)
        ),
        Node::Section => format!("A {}", Unit::AREA.format(model.beam.section.area)),
        Node::Supports => supports(&model.supports),
        Node::Support(end) => end.support(model).kind().to_owned(),
        Node::Motion(end, motion) => restraint(model, end, motion),
        Node::Subsystems => model.subsystems.len().to_string(),
        Node::Subsystem(i) => {
            let subsystem = &model.subsystems[i];
            switched(subsystem.enabled, || Unit::METRE.format(subsystem.position))
        }
        Node::Forces => model.forces.len().to_string(),
        Node::Force(i) => switched(model.forces[i].enabled, || target(&model.forces[i].target)),
        Node::Responses => model.responses.len().to_string(),
        Node::Response(i) => switched(model.responses[i].enabled, || {
            quantity(&model.responses[i].quantity)
        }),
        Node::Sweep => band(&model.sweep),
        Node::Studies => model.studies.len().to_string(),
        Node::Study(i) => counted(members(&model.studies[i]), "curve", "curves"),
        Node::StudyLine(i, line) => study_line(&model.studies[i], line).1,
        Node::Tune => model
            .tune
            .as_ref()
            .map_or_else(String::new, tuning::combination),
        Node::TuneVariable(i) => tuning::variable_at(model, i)
            .map_or_else(String::new, |variable| words::bounds(model, variable)),
        Node::TuneObjective(i) => tuning::objective_at(model, i)
            .map_or_else(String::new, |one| tuning::objective_value(model, one)),
        Node::TuneLimit(i) => tuning::limit_at(model, i)
            .map_or_else(String::new, |limit| tuning::limit_value(model, limit)),
        _ => parameter_path(model, node)
            .and_then(|path| path::parameter(model, &path).ok())
            .map(|parameter| of_parameter(&parameter, &parameter.value))
            .unwrap_or_default(),
    }
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

/// A value of a parameter in words, with its unit.
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

/// `before` without its unit where `after` has the same.
pub fn without_unit_of<'a>(before: &'a str, after: &str) -> &'a str {
    match (before.split_once(' '), after.split_once(' ')) {
        (Some((number, unit)), Some((_, same))) if unit == same => number,
        _ => before,
    }
}

fn restraint(model: &Model, end: End, motion: BeamMotion) -> String {
    match end.support(model)[motion] {
        Restraint::Elastic(elastic) => field::elastic_fields(motion)[0]
            .unit
            .format(elastic.stiffness),
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

/// How many lines a study has in the tree.
pub(super) fn study_lines(study: &Study) -> usize {
    match &study.family {
        Family::Vary { paths, .. } => paths.len() + 1,
        Family::Cases(cases) => cases.len(),
    }
}

/// A line of a study: what it changes, and by what.
fn study_line(study: &Study, line: usize) -> (String, String) {
    match &study.family {
        Family::Vary {
            operation, values, ..
        } if line == 0 => {
            let values: Vec<String> = values.iter().map(f64::to_string).collect();
            (operation.key().to_owned(), values.join(" "))
        }
        Family::Vary { paths, .. } => (paths[line - 1].clone(), String::new()),
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
