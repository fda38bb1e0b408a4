//! Identifiers of the groups and parameters of a model: small values without text.

use super::schema::{self, Key, Kind};
use super::types::{BeamMotion, Model, Quantity, Restraint, Support};

/// An end of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum End {
    /// x = 0.
    Left,
    /// x = L.
    Right,
}

impl End {
    /// Both, from the left.
    pub const ALL: [Self; 2] = [Self::Left, Self::Right];

    /// The word of the model file.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }

    /// The support of this end.
    pub const fn support(self, model: &Model) -> &Support {
        match self {
            Self::Left => &model.supports.left,
            Self::Right => &model.supports.right,
        }
    }

    /// The support of this end, mutable.
    pub const fn support_mut(self, model: &mut Model) -> &mut Support {
        match self {
            Self::Left => &mut model.supports.left,
            Self::Right => &mut model.supports.right,
        }
    }
}

/// A group of a model: a table or a list of tables. Elements of lists count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Group {
    /// The whole model, with the keys above all tables.
    Model,
    /// The beam.
    Beam,
    /// The beam's material.
    Material,
    /// The beam's section.
    Section,
    /// The foundation.
    Foundation,
    /// Both supports.
    Supports,
    /// One end's support.
    Support(End),
    /// The spring of one motion of an end.
    Motion(End, BeamMotion),
    /// All subsystems.
    Subsystems,
    /// One subsystem.
    Subsystem(usize),
    /// All forces.
    Forces,
    /// One force.
    Force(usize),
    /// All responses.
    Responses,
    /// One response.
    Response(usize),
    /// The frequencies.
    Sweep,
    /// All studies.
    Studies,
    /// One study.
    Study(usize),
    /// The tuning.
    Tune,
    /// One of its variables.
    Variable(usize),
    /// One of its objectives.
    Objective(usize),
    /// One of its limits.
    Limit(usize),
}

impl Group {
    /// The keys of parameters, in the order of the file.
    pub const fn keys(self) -> &'static [Key] {
        match self {
            Self::Model => schema::MODEL.keys,
            Self::Beam => schema::BEAM.keys,
            Self::Material => schema::MATERIAL.keys,
            Self::Section => schema::SECTION.keys,
            Self::Foundation => schema::FOUNDATION.keys,
            Self::Support(_) => schema::SUPPORT.keys,
            Self::Motion(_, motion) => schema::elastic(motion).keys,
            Self::Subsystem(_) => schema::SUBSYSTEM.keys,
            Self::Force(_) => schema::FORCE.keys,
            Self::Response(_) => schema::RESPONSE.keys,
            Self::Sweep => schema::SWEEP.keys,
            Self::Study(_) => schema::STUDY.keys,
            Self::Supports
            | Self::Subsystems
            | Self::Forces
            | Self::Responses
            | Self::Studies
            | Self::Tune
            | Self::Variable(_)
            | Self::Objective(_)
            | Self::Limit(_) => &[],
        }
    }

    /// Its parent group.
    pub const fn parent(self) -> Option<Self> {
        Some(match self {
            Self::Model => return None,
            Self::Material | Self::Section | Self::Foundation => Self::Beam,
            Self::Support(_) => Self::Supports,
            Self::Motion(end, _) => Self::Support(end),
            Self::Subsystem(_) => Self::Subsystems,
            Self::Force(_) => Self::Forces,
            Self::Response(_) => Self::Responses,
            Self::Study(_) => Self::Studies,
            Self::Variable(_) | Self::Objective(_) | Self::Limit(_) => Self::Tune,
            Self::Beam
            | Self::Supports
            | Self::Subsystems
            | Self::Forces
            | Self::Responses
            | Self::Sweep
            | Self::Studies
            | Self::Tune => Self::Model,
        })
    }

    /// Its child groups, in the order of the file.
    pub fn groups(self, model: &Model) -> Vec<Self> {
        let each = |count: usize, of: fn(usize) -> Self| (0..count).map(of).collect();
        match self {
            Self::Model => {
                use Group::{Beam, Forces, Responses, Studies, Subsystems, Supports, Sweep, Tune};
                let studies = (!model.studies.is_empty()).then_some(Studies);
                let tune = model.tune.is_some().then_some(Tune);
                [Beam, Supports, Subsystems, Forces, Responses, Sweep]
                    .into_iter()
                    .chain(studies)
                    .chain(tune)
                    .collect()
            }
            Self::Beam => vec![Self::Material, Self::Section, Self::Foundation],
            Self::Supports => End::ALL.map(Self::Support).to_vec(),
            Self::Support(end) => BeamMotion::ALL
                .map(|motion| Self::Motion(end, motion))
                .to_vec(),
            Self::Subsystems => each(model.subsystems.len(), Self::Subsystem),
            Self::Forces => each(model.forces.len(), Self::Force),
            Self::Responses => each(model.responses.len(), Self::Response),
            Self::Studies => each(model.studies.len(), Self::Study),
            Self::Tune => model.tune.as_ref().map_or_else(Vec::new, |tune| {
                [
                    each(tune.variables.len(), Self::Variable),
                    each(tune.objectives.len(), Self::Objective),
                    each(tune.limits.len(), Self::Limit),
                ]
                .concat()
            }),
            _ => Vec::new(),
        }
    }

    /// The beam, end or list element that it belongs to, which the first parts of a path name.
    #[must_use]
    pub const fn owner(self) -> Self {
        match self {
            Self::Material | Self::Section | Self::Foundation => Self::Beam,
            Self::Motion(end, _) => Self::Support(end),
            other => other,
        }
    }

    /// Its index among the ends or in its list.
    pub const fn place(self) -> Option<usize> {
        match self {
            Self::Support(end) | Self::Motion(end, _) => Some(end as usize),
            Self::Subsystem(i)
            | Self::Force(i)
            | Self::Response(i)
            | Self::Study(i)
            | Self::Variable(i)
            | Self::Objective(i)
            | Self::Limit(i) => Some(i),
            _ => None,
        }
    }

    /// The same group of another end or list element.
    #[must_use]
    pub fn at(self, place: usize) -> Self {
        match self {
            Self::Support(_) => Self::Support(End::ALL[place]),
            Self::Motion(_, motion) => Self::Motion(End::ALL[place], motion),
            Self::Subsystem(_) => Self::Subsystem(place),
            Self::Force(_) => Self::Force(place),
            Self::Response(_) => Self::Response(place),
            Self::Study(_) => Self::Study(place),
            Self::Variable(_) => Self::Variable(place),
            Self::Objective(_) => Self::Objective(place),
            Self::Limit(_) => Self::Limit(place),
            other => other,
        }
    }

    /// The parameter of a row.
    pub const fn parameter(self, row: usize) -> ParameterId {
        ParameterId { group: self, row }
    }

    /// Its parameters, also those without a value now.
    pub fn parameters(self) -> impl Iterator<Item = ParameterId> {
        (0..self.keys().len()).map(move |row| self.parameter(row))
    }

    /// Its parameter of a kind, if it has one.
    pub fn parameter_of(self, kind: Kind) -> Option<ParameterId> {
        self.parameters().find(|id| id.key().kind == kind)
    }

    /// The parameters of a beam, end or element and all groups inside, in the order of the file.
    pub(super) fn owned(self) -> Vec<ParameterId> {
        match self {
            Self::Beam => [Self::Beam, Self::Material, Self::Section]
                .into_iter()
                .flat_map(Self::parameters)
                .collect(),
            Self::Support(end) => {
                let mut all: Vec<_> = self.parameter_of(Kind::Support).into_iter().collect();
                for motion in BeamMotion::ALL {
                    all.push(ParameterId::restraint(end, motion));
                    all.extend(Self::Motion(end, motion).parameters());
                }
                all
            }
            _ => self.parameters().collect(),
        }
    }
}

/// A parameter of a model: a key of one of its groups.
///
/// It is valid for one model; after elements were added, removed or renamed, [`Moves`](super::Moves) maps it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ParameterId {
    /// The group.
    pub group: Group,
    /// The number of its key in [`Group::keys`].
    pub row: usize,
}

impl ParameterId {
    /// The model's title.
    pub const TITLE: Self = Group::Model.parameter(0);

    /// The restraint of a motion of an end: the rows after the word for all motions.
    pub const fn restraint(end: End, motion: BeamMotion) -> Self {
        Group::Support(end).parameter(1 + motion as usize)
    }

    /// The motion of an end whose restraint it is.
    pub fn motion(self) -> Option<BeamMotion> {
        let is_restraint = matches!(self.group, Group::Support(_)) && self.row > 0;
        is_restraint.then(|| BeamMotion::ALL[self.row - 1])
    }

    /// Its description.
    pub const fn key(self) -> &'static Key {
        &self.group.keys()[self.row]
    }

    /// Every parameter that has a value, in the order of the file.
    pub fn all(model: &Model) -> Vec<Self> {
        let mut all: Vec<Self> = Group::Model.parameters().collect();
        for group in Group::Model.groups(model) {
            let owners = match group {
                Group::Beam | Group::Sweep => vec![group],
                list => list.groups(model),
            };
            all.extend(owners.into_iter().flat_map(Group::owned));
        }
        all.retain(|id| id.exists(model));
        all
    }

    /// Whether it has a value: a fixed motion has no spring, an energy has no position.
    pub fn exists(self, model: &Model) -> bool {
        match (self.group, self.key().kind) {
            (Group::Motion(end, motion), _) => end.support(model)[motion] != Restraint::Fixed,
            (Group::Response(index), Kind::Place | Kind::Direction) => {
                model.responses[index].quantity != Quantity::Energy
            }
            _ => true,
        }
    }

    /// The same parameter of another end or list element.
    #[must_use]
    pub fn at(self, place: usize) -> Self {
        self.group.at(place).parameter(self.row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::sample;
    use std::collections::HashSet;

    #[test]
    fn every_parameter_is_there_once_and_in_a_group_of_the_model() {
        let model = sample::model(&["S1", "S2"]);
        let mut groups = vec![Group::Model];
        let mut next = 0;
        while let Some(group) = groups.get(next) {
            let below = group.groups(&model);
            assert!(below.iter().all(|one| one.parent() == Some(*group)));
            groups.extend(below);
            next += 1;
        }
        let held = groups.into_iter().flat_map(Group::parameters);
        let held: HashSet<ParameterId> = held.filter(|id| id.exists(&model)).collect();
        let all = ParameterId::all(&model);
        assert_eq!(all.len(), held.len());
        assert_eq!(all.into_iter().collect::<HashSet<_>>(), held);
    }

    #[test]
    fn a_parameter_has_the_same_place_in_its_list() {
        let model = sample::model(&["S1", "S2"]);
        for id in ParameterId::all(&model) {
            assert_eq!(id.group.place().map_or(id, |place| id.at(place)), id);
        }
    }
}
