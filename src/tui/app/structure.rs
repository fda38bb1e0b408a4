//! Adding, duplicating, deleting and switching subsystems, forces and responses.

use std::sync::Arc;

use super::App;
use super::edit::faults_in_words;
use super::fresh::{free_name, new_subsystem, response_names, subsystem_names};
use crate::model::names::segment;
use crate::model::path::Value;
use crate::model::{
    self, BeamMotion, Force, Measure, Model, Place, Quantity, Response, Target, path,
};
use crate::tui::keys::Command;
use crate::tui::tree::{self, Node};

impl App {
    /// Adds one of what the selected row belongs to.
    pub(super) fn add(&mut self) {
        let mut after = Model::clone(self.model());
        let (node, name) = match group(self.selection.node()) {
            Node::Subsystems => {
                let new = new_subsystem(&after);
                let name = format!("add subsystem {}", new.name);
                after.subsystems.push(new);
                (Node::Subsystem(after.subsystems.len() - 1), name)
            }
            Node::Forces => {
                after.forces.push(Force {
                    enabled: true,
                    target: Target::Beam(Place::Left, BeamMotion::W),
                    amplitude: 1.0,
                    phase: 0.0,
                });
                let count = after.forces.len();
                (Node::Force(count - 1), format!("add force {count}"))
            }
            Node::Responses => {
                let target = Target::Beam(Place::Right, BeamMotion::W);
                let new = Response {
                    name: free_name("right w", &response_names(&after)),
                    enabled: true,
                    quantity: Quantity::Motion(target, Measure::Displacement),
                };
                let name = format!("add response {}", new.name);
                after.responses.push(new);
                (Node::Response(after.responses.len() - 1), name)
            }
            other => return self.refuse_to_add(other),
        };
        self.restructure(name, after, node);
    }

    /// Says what is added here by other keys, or where this one adds something.
    fn refuse_to_add(&mut self, group: Node) {
        let [study, variable, objective] = [
            Command::MakeStudy,
            Command::TuneVariable,
            Command::TuneObjective,
        ]
        .map(|command| self.keys.key_of(command));
        self.refuse(match group {
            Node::Studies => {
                format!("{study} on a number of the model adds a study of it; others are added in the file")
            }
            Node::Tune => {
                format!("{variable} on a number lets a search move it, {objective} adds what is sought")
            }
            _ => "subsystems, forces and responses can be added: select one of them, or their group"
                .to_owned(),
        });
    }

    /// Adds a copy of the selected subsystem, force or response after it.
    pub(super) fn duplicate(&mut self) {
        let mut after = Model::clone(self.model());
        let (node, name) = match tree::item(self.selection.node()) {
            Some(Node::Subsystem(i)) => {
                let mut copy = after.subsystems[i].clone();
                copy.name = free_name(&copy.name, &subsystem_names(&after));
                let name = format!("duplicate {} as {}", after.subsystems[i].name, copy.name);
                after.subsystems.insert(i + 1, copy);
                (Node::Subsystem(i + 1), name)
            }
            Some(Node::Force(i)) => {
                after.forces.insert(i + 1, after.forces[i].clone());
                (Node::Force(i + 1), format!("duplicate force {}", i + 1))
            }
            Some(Node::Response(i)) => {
                let mut copy = after.responses[i].clone();
                copy.name = free_name(&copy.name, &response_names(&after));
                let name = format!("duplicate {} as {}", after.responses[i].name, copy.name);
                after.responses.insert(i + 1, copy);
                (Node::Response(i + 1), name)
            }
            _ => return self.refuse("select a subsystem, force or response to duplicate it"),
        };
        self.restructure(name, after, node);
    }

    /// Deletes the selected subsystem, force, response or study, unless something needs it.
    pub(super) fn delete(&mut self) {
        match self.selection.node() {
            Node::TuneVariable(index) => return self.drop_variable(index),
            Node::TuneObjective(index) => return self.drop_objective(index),
            Node::TuneLimit(index) => return self.drop_limit(index),
            _ => {}
        }
        let mut after = Model::clone(self.model());
        let Some(node) = tree::item(self.selection.node()) else {
            return self.refuse("select a subsystem, force, response or study to delete it");
        };
        let (list, i) = match node {
            Node::Subsystem(i) => {
                after.subsystems.remove(i);
                (Node::Subsystems, i)
            }
            Node::Force(i) => {
                after.forces.remove(i);
                (Node::Forces, i)
            }
            Node::Response(i) => {
                after.responses.remove(i);
                (Node::Responses, i)
            }
            Node::Study(i) => {
                after.studies.remove(i);
                (Node::Studies, i)
            }
            _ => return,
        };
        let subject = tree::subject(self.model(), node);
        if let Some(user) = user_of(self.model(), node) {
            return self.refuse(format!("{subject} is needed by {user}"));
        }
        let rest = tree::children(&after, list);
        let next = rest.get(i).or(rest.last()).copied().unwrap_or(list);
        self.restructure(format!("delete {subject}"), after, next);
    }

    /// Enables or disables the selected subsystem, force or response.
    pub(super) fn switch(&mut self) {
        let model = Arc::clone(self.document.model());
        let item = tree::item(self.selection.node());
        let path = item.and_then(|node| Some((node, tree::enabled_path(&model, node)?)));
        let Some((node, path)) = path else {
            return self.refuse("select a subsystem, force or response to enable or disable it");
        };
        let on = path::parameter(&model, &path)
            .is_ok_and(|parameter| parameter.value == Value::Flag(true));
        let subject = tree::subject(&model, node);
        if let Err(faults) = self.set(&subject, &path, Value::Flag(!on), false) {
            self.refuse(faults_in_words(&faults, &path, &subject));
        }
    }

    /// Takes a model with another structure, if it is possible, and selects a row of it.
    fn restructure(&mut self, name: String, after: Model, node: Node) {
        let faults = model::check(&after);
        if !faults.is_empty() {
            return self.refuse(format!(
                "cannot {name}: {}",
                faults_in_words(&faults, "", "")
            ));
        }
        let before = Arc::clone(self.document.model());
        self.document.replace(name.clone(), after);
        self.follow(&before);
        let model = Arc::clone(self.document.model());
        self.selection.select(&model, node);
        self.done(name);
    }
}

/// The list to which a row belongs.
fn group(node: Node) -> Node {
    let mut node = node;
    while let Some(parent) = tree::parent(node) {
        node = parent;
    }
    node
}

/// Who needs a subsystem or response, in words.
fn user_of(model: &Model, node: Node) -> Option<String> {
    match node {
        Node::Subsystem(i) => {
            let name = &model.subsystems[i].name;
            let on = |target: &Target| matches!(target, Target::Mass(mass, _) if mass == name);
            let force = model.forces.iter().position(|force| on(&force.target));
            let response = model.responses.iter().find(
                |response| matches!(&response.quantity, Quantity::Motion(target, _) if on(target)),
            );
            force
                .map(|i| format!("force {}, which acts on it", i + 1))
                .or_else(|| {
                    response
                        .map(|response| format!("response {}, which is taken on it", response.name))
                })
                .or_else(|| {
                    path_user(
                        model,
                        &ways_to(Some(segment(name)), i, model.subsystems.len()),
                        "subsystems",
                    )
                })
        }
        Node::Force(i) => path_user(model, &ways_to(None, i, model.forces.len()), "forces"),
        Node::Response(i) => {
            let name = &model.responses[i].name;
            let tuned = model.tune.as_ref().is_some_and(|tune| {
                tune.objectives
                    .iter()
                    .any(|one| one.aim.response() == Some(name))
            });
            tuned.then(|| "the objective of [tune]".to_owned())
        }
        _ => None,
    }
}

/// How a path may lead to an item of a list, or to one that moves when it is deleted: by its name, by numbers, and by
/// a star if it is the last one.
fn ways_to(name: Option<String>, item: usize, length: usize) -> Vec<String> {
    let numbers = (item + 1..=length).map(|number| number.to_string());
    numbers
        .chain(name)
        .chain((length == 1).then(|| "*".to_owned()))
        .collect()
}

/// The study or variable with a path into this item of a list.
fn path_user(model: &Model, names: &[String], list: &str) -> Option<String> {
    let into = |path: &str| {
        names.iter().any(|name| {
            let rest = path
                .strip_prefix(list)
                .and_then(|rest| rest.strip_prefix('.'));
            rest.and_then(|rest| rest.strip_prefix(name.as_str()))
                .is_some_and(|rest| rest.starts_with('.'))
        })
    };
    let study = model.studies.iter().find(|study| match &study.family {
        model::Family::Vary { paths, .. } => paths.iter().any(|path| into(path)),
        model::Family::Cases(cases) => cases
            .iter()
            .flat_map(|case| &case.set)
            .any(|(path, _)| into(path)),
    });
    let tuned = model.tune.as_ref().is_some_and(|tune| {
        tune.variables
            .iter()
            .flat_map(|variable| &variable.paths)
            .any(|path| into(path))
    });
    study
        .map(|study| format!("study {}", study.name))
        .or_else(|| tuned.then(|| "a variable of [tune]".to_owned()))
}
