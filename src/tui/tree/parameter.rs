//! Which parameter a row is, and whether it differs from the file.

use super::{Node, motion_keys, tuning};
use crate::model::names::segment;
use crate::model::{Model, Subsystem, field, path};

/// The path of the parameter that a row shows, if it shows one.
pub fn parameter_path(model: &Model, node: Node) -> Option<String> {
    let subsystem = |i: usize| segment(&model.subsystems[i].name);
    let response = |i: usize| segment(&model.responses[i].name);
    Some(match node {
        Node::Title => "title".to_owned(),
        Node::BeamNumber(row) => format!("beam.{}", field::BEAM[row].key),
        Node::MaterialNumber(row) => format!("beam.material.{}", field::MATERIAL[row].key),
        Node::SectionNumber(row) => format!("beam.section.{}", field::SECTION[row].key),
        Node::Support(end) => format!("supports.{}.kind", end.key()),
        Node::Motion(end, motion) => format!("supports.{}.{}", end.key(), motion.key()),
        Node::MotionNumber(end, motion, row) => {
            format!(
                "supports.{}.{}.{}",
                end.key(),
                motion.key(),
                motion_keys(motion)[row]
            )
        }
        Node::SubsystemNumber(i, row) => {
            format!("subsystems.{}.{}", subsystem(i), field::SUBSYSTEM[row].key)
        }
        Node::ForceAt(i) => format!("forces.{}.at", i + 1),
        Node::ForceDirection(i) => format!("forces.{}.direction", i + 1),
        Node::ForceNumber(i, row) => format!("forces.{}.{}", i + 1, field::FORCE[row].key),
        Node::ResponseMeasure(i) => format!("responses.{}.measure", response(i)),
        Node::ResponseAt(i) => format!("responses.{}.at", response(i)),
        Node::ResponseDirection(i) => format!("responses.{}.direction", response(i)),
        Node::SweepNumber(row) => format!("sweep.{}", field::SWEEP[row].key),
        Node::SweepPoints => "sweep.points".to_owned(),
        Node::SweepSpacing => "sweep.spacing".to_owned(),
        _ => return None,
    })
}

/// The path of the switch of a subsystem, force or response.
pub fn enabled_path(model: &Model, node: Node) -> Option<String> {
    Some(match node {
        Node::Subsystem(i) => format!("subsystems.{}.enabled", segment(&model.subsystems[i].name)),
        Node::Force(i) => format!("forces.{}.enabled", i + 1),
        Node::Response(i) => format!("responses.{}.enabled", segment(&model.responses[i].name)),
        _ => return None,
    })
}

/// The path of the name of a subsystem, response or study, or of the title.
pub fn name_path(model: &Model, node: Node) -> Option<String> {
    Some(match node {
        Node::Title => "title".to_owned(),
        Node::Subsystem(i) => format!("subsystems.{}.name", segment(&model.subsystems[i].name)),
        Node::Response(i) => format!("responses.{}.name", segment(&model.responses[i].name)),
        Node::Study(i) => format!("studies.{}.name", segment(&model.studies[i].name)),
        _ => return None,
    })
}

/// Whether a row's part of the model differs from `saved`.
pub fn differs(model: &Model, saved: &Model, node: Node) -> bool {
    match node {
        Node::Title => model.title != saved.title,
        Node::Beam => model.beam != saved.beam,
        Node::Material => model.beam.material != saved.beam.material,
        Node::Section => model.beam.section != saved.beam.section,
        Node::Supports => model.supports != saved.supports,
        Node::Support(end) => end.support(model) != end.support(saved),
        Node::Motion(end, motion) => end.support(model)[motion] != end.support(saved)[motion],
        Node::Subsystems => model.subsystems != saved.subsystems,
        Node::Subsystem(i) => saved_subsystem(model, saved, i) != Some(&model.subsystems[i]),
        Node::SubsystemNumber(i, row) => saved_subsystem(model, saved, i).is_none_or(|before| {
            let get = field::SUBSYSTEM[row].get;
            get(before) != get(&model.subsystems[i])
        }),
        Node::Forces => model.forces != saved.forces,
        Node::Force(i) => saved.forces.get(i) != Some(&model.forces[i]),
        Node::Responses => model.responses != saved.responses,
        Node::Response(i) => !saved.responses.contains(&model.responses[i]),
        Node::Sweep => model.sweep != saved.sweep,
        Node::Studies => model.studies != saved.studies,
        Node::Study(i) => !saved.studies.contains(&model.studies[i]),
        Node::Tune => model.tune != saved.tune,
        Node::TuneVariable(i) => tuning::variable_at(model, i) != tuning::variable_at(saved, i),
        Node::TuneObjective(i) => tuning::objective_at(model, i) != tuning::objective_at(saved, i),
        Node::TuneLimit(i) => tuning::limit_at(model, i) != tuning::limit_at(saved, i),
        Node::StudyLine(..) => false,
        _ => parameter_differs(model, saved, node),
    }
}

fn saved_subsystem<'a>(model: &Model, saved: &'a Model, i: usize) -> Option<&'a Subsystem> {
    let subsystem = &model.subsystems[i];
    let same = |other: &&Subsystem| other.name == subsystem.name;
    // Nearly always at the same place: a search through thousands is then not needed.
    saved
        .subsystems
        .get(i)
        .filter(same)
        .or_else(|| saved.subsystems.iter().find(same))
}

fn parameter_differs(model: &Model, saved: &Model, node: Node) -> bool {
    let Some(path) = parameter_path(model, node) else {
        return false;
    };
    let now = path::parameter(model, &path).map(|parameter| parameter.value);
    let before = path::parameter(saved, &path).map(|parameter| parameter.value);
    match (now, before) {
        (Ok(now), Ok(before)) => now != before,
        (now, before) => now.is_ok() != before.is_ok(),
    }
}
