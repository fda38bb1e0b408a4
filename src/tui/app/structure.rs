//! Add, duplicate, delete and enable spans, inner supports, joints, subsystems, forces and responses.

use std::sync::Arc;

use super::App;
use super::edit::faults_in_words;
use super::new_item::{
    free_name, new_branch, new_joint, new_subsystem, new_support, position_names, response_names,
    widest_gap,
};
use crate::model::edit::{self, Value};
use crate::model::schema::Kind;
use crate::model::{
    At, BeamMotion, Checked, Force, Group, Joint, Measure, Model, Place, Point, Quantity, Response,
    SupportId, Target,
};
use crate::tui::keys::{Command, CompareCommand, TuneCommand};
use crate::tui::tree::{self, Node};

impl App {
    /// Adds an element to the list of the selected row.
    pub(crate) fn add(&mut self) {
        let mut after = Model::clone(self.model());
        let (group, name) = match group(self.selection.node()) {
            Some(Group::Beam) => {
                let last = after.spans.len().saturating_sub(1);
                edit::split(&mut after, last);
                let name = format!("add span {}", after.spans.len());
                (Group::Span(last + 1), name)
            }
            Some(Group::Supports) => {
                let new = new_support(&after);
                let name = format!("add support {}", new.name);
                after.supports.inner.push(new);
                let place = after.supports.inner.len() - 1;
                (Group::Support(SupportId::Inner(place)), name)
            }
            Some(Group::Joints) => {
                let new = new_joint(&after);
                after.joints.push(new);
                let count = after.joints.len();
                (Group::Joint(count - 1), format!("add joint {count}"))
            }
            Some(Group::Subsystems) => {
                let new = new_subsystem(&after);
                let name = format!("add subsystem {}", new.name);
                after.subsystems.push(new);
                (Group::Subsystem(after.subsystems.len() - 1), name)
            }
            Some(Group::Forces) => {
                after.forces.push(Force {
                    enabled: true,
                    target: Target::Beam(Place::Left, BeamMotion::W),
                    point: Point::AXIS,
                    amplitude: 1.0,
                    phase: 0.0,
                });
                let count = after.forces.len();
                (Group::Force(count - 1), format!("add force {count}"))
            }
            Some(Group::Responses) => {
                let target = Target::Beam(Place::Right, BeamMotion::W);
                let new = Response {
                    name: free_name("right w", &response_names(&after)),
                    enabled: true,
                    quantity: Quantity::Motion(target, Measure::Displacement),
                    point: Point::AXIS,
                    over: None,
                };
                let name = format!("add response {}", new.name);
                after.responses.push(new);
                (Group::Response(after.responses.len() - 1), name)
            }
            other => return self.refuse_to_add(other),
        };
        self.restructure(name, after, group);
    }

    /// Adds a Maxwell branch to the selected spring.
    pub(crate) fn add_branch(&mut self) {
        let mut after = Model::clone(self.model());
        let place = self.selection.node().spring();
        let Some(id) = place.filter(|id| id.spring(&after).is_some()) else {
            return self.refuse(
                "select a spring to add a Maxwell branch to it: of a subsystem, or an elastic motion of a support or joint",
            );
        };
        let new = new_branch(&after, id);
        if let Some(spring) = id.spring_mut(&mut after) {
            spring.maxwell.push(new);
        }
        let group = Group::Branch(id, id.branches(&after).len() - 1);
        let name = format!("add {}", tree::subject(&after, Node::Group(group)));
        self.restructure(name, after, group);
    }

    /// Says which keys add elements here, or where this one works.
    fn refuse_to_add(&mut self, group: Option<Group>) {
        let [study, variable, objective] = [
            CompareCommand::MakeStudy.into(),
            TuneCommand::TuneVariable.into(),
            TuneCommand::TuneObjective.into(),
        ]
        .map(|command: Command| self.keys.key_of(command));
        self.refuse(match group {
            Some(Group::Studies) => {
                format!("{study} on a number of the model adds a study of it; others are added in the file")
            }
            Some(Group::Tune) => {
                format!("{variable} on a number makes it a variable, {objective} adds an objective")
            }
            _ => "spans of the beam, supports, joints, subsystems, forces and responses can be added: select one of them, or their group"
                .to_owned(),
        });
    }

    /// Adds a copy of the selected inner support, joint, subsystem, Maxwell branch, force or response after it; a span is
    /// divided in half.
    pub(crate) fn duplicate(&mut self) {
        let mut after = Model::clone(self.model());
        let (group, name) = match self.selection.node().element() {
            Some(branch @ Group::Branch(id, i)) => {
                if let Some(spring) = id.spring_mut(&mut after) {
                    spring.maxwell.insert(i + 1, spring.maxwell[i]);
                }
                let subject = tree::subject(&after, Node::Group(branch));
                (Group::Branch(id, i + 1), format!("duplicate {subject}"))
            }
            Some(Group::Support(SupportId::Inner(i))) => {
                let mut copy = after.supports.inner[i].clone();
                copy.name = free_name(&copy.name, &position_names(&after));
                // Two supports cannot fix one motion at the same place.
                copy.position = widest_gap(&after);
                let name = format!(
                    "duplicate {} as {}",
                    after.supports.inner[i].name, copy.name
                );
                after.supports.inner.insert(i + 1, copy);
                (Group::Support(SupportId::Inner(i + 1)), name)
            }
            Some(Group::Span(i)) => {
                edit::split(&mut after, i);
                (Group::Span(i + 1), format!("duplicate span {}", i + 1))
            }
            Some(Group::Joint(i)) => {
                // Two joints cannot be at the same place.
                let position = widest_gap(&after);
                let copy = Joint {
                    position,
                    ..after.joints[i].clone()
                };
                after.joints.insert(i + 1, copy);
                (Group::Joint(i + 1), format!("duplicate joint {}", i + 1))
            }
            Some(Group::Subsystem(i)) => {
                let mut copy = after.subsystems[i].clone();
                copy.name = free_name(&copy.name, &position_names(&after));
                let name = format!("duplicate {} as {}", after.subsystems[i].name, copy.name);
                after.subsystems.insert(i + 1, copy);
                (Group::Subsystem(i + 1), name)
            }
            Some(Group::Force(i)) => {
                after.forces.insert(i + 1, after.forces[i].clone());
                (Group::Force(i + 1), format!("duplicate force {}", i + 1))
            }
            Some(Group::Response(i)) => {
                let mut copy = after.responses[i].clone();
                copy.name = free_name(&copy.name, &response_names(&after));
                let name = format!("duplicate {} as {}", after.responses[i].name, copy.name);
                after.responses.insert(i + 1, copy);
                (Group::Response(i + 1), name)
            }
            _ => {
                return self.refuse(
                    "select a span, inner support, joint, subsystem, force or response to duplicate it",
                );
            }
        };
        self.restructure(name, after, group);
    }

    /// Deletes the selected span, inner support, joint, subsystem, Maxwell branch, force, response or study, unless another
    /// element needs it.
    pub(crate) fn delete(&mut self) {
        match self.selection.node().group() {
            Group::Variable(index) => return self.drop_variable(index),
            Group::Objective(index) => return self.drop_objective(index),
            Group::Limit(index) => return self.drop_limit(index),
            _ => {}
        }
        let mut after = Model::clone(self.model());
        let Some(item) = self.selection.node().element() else {
            return self.refuse(
                "select a span, inner support, joint, subsystem, force, response or study to delete it",
            );
        };
        let Some(list) = item.parent() else {
            return;
        };
        let place = list.groups(&after).iter().position(|of| *of == item);
        if let (Group::Span(_), [last]) = (item, &after.spans[..])
            && last.offset != Point::AXIS
        {
            return self
                .refuse("the last span lies off the axis of the beam: its offset must be 0");
        }
        edit::remove(&mut after, item);
        let subject = tree::subject(self.model(), Node::Group(item));
        if let Some(user) = user_of(self.model(), &after, item) {
            return self.refuse(format!("{subject} is needed by {user}"));
        }
        let rest = list.groups(&after);
        let next = place.and_then(|place| rest.get(place)).or(rest.last());
        // The spans have no row without a span.
        let without = if list == Group::Spans {
            Group::Beam
        } else {
            list
        };
        let next = next.copied().unwrap_or(without);
        self.restructure(format!("delete {subject}"), after, next);
    }

    /// Enables or disables the selected subsystem, force or response.
    pub(crate) fn switch(&mut self) {
        let model = Arc::clone(self.document.model());
        let item = self.selection.node().item();
        let switch = item.and_then(|item| item.parameter_of(Kind::Flag));
        let Some(id) = switch else {
            return self.refuse("select a subsystem, force or response to enable or disable it");
        };
        let on = edit::get(&model, id) == Ok(Value::Flag(true));
        let subject = tree::subject(&model, Node::Group(id.group));
        if let Err(faults) = self.set(&subject, id, Value::Flag(!on), false) {
            self.refuse(self.in_words(&faults, id, &subject));
        }
    }

    /// Applies a model with another structure, if it is valid, and selects a row of it.
    fn restructure(&mut self, name: String, after: Model, group: Group) {
        let after = match Checked::new(after) {
            Ok(after) => after,
            Err(faults) => {
                let words = faults_in_words(&faults, "", "");
                return self.refuse(format!("cannot {name}: {words}"));
            }
        };
        let before = Arc::clone(self.document.model());
        self.document.replace(name.clone(), after);
        self.follow(&before);
        let model = Arc::clone(self.document.model());
        self.selection.select(&model, Node::Group(group));
        self.done(name);
    }
}

/// The first-level table or list of a row; none for the title.
fn group(node: Node) -> Option<Group> {
    let holders = std::iter::successors(Some(node.group()), |group| group.parent());
    holders.into_iter().filter(|of| *of != Group::Model).last()
}

/// Names the elements that need an element missing in `after`.
fn user_of(model: &Model, after: &Model, element: Group) -> Option<String> {
    let own = match element {
        Group::Subsystem(i) => user_of_place(model, At::Subsystem(&model.subsystems[i].name)),
        Group::Support(SupportId::Inner(i)) => {
            user_of_place(model, At::Support(&model.supports.inner[i].name))
        }
        Group::Response(i) => {
            let name = Some(&model.responses[i].name);
            let mut responses = model.responses.iter();
            if let Some(user) = responses.find(|one| one.over.as_ref() == name) {
                return Some(format!("response {}, which is divided by it", user.name));
            }
            let tune = model.tune.as_ref()?;
            let mut objectives = tune.objectives.iter();
            return objectives
                .any(|one| one.response.as_ref() == name)
                .then(|| "the objective of [tune]".to_owned());
        }
        _ => None,
    };
    own.or_else(|| match edit::misled(model, after, element)? {
        Group::Study(i) => Some(format!("study {}", model.studies[i].name)),
        _ => Some("a variable of [tune]".to_owned()),
    })
}

/// Names the force or response at a subsystem or support.
fn user_of_place(model: &Model, at: At<'_>) -> Option<String> {
    let on = |group| edit::at_of(model, group) == Some(at);
    let force = Group::Forces.groups(model).into_iter().position(on);
    let mut responses = Group::Responses.groups(model).into_iter();
    let response = responses.position(on);
    force
        .map(|i| format!("force {}, which acts on it", i + 1))
        .or_else(|| {
            let name = &model.responses[response?].name;
            Some(format!("response {name}, which refers to it"))
        })
}
