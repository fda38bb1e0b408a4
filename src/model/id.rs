//! Identifiers of the groups and parameters of a model: small values without text.

use super::beam::BeamMotion;
use super::part::{BeamNumber, Part};
use super::schema::{self, Key, Kind};
use super::spring::SpringId;
use super::types::{Link, Model, Restraint, Support, Target};

/// A support of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SupportId {
    /// At x = 0.
    Left,
    /// At x = L.
    Right,
    /// Between the ends, by its index in the list.
    Inner(usize),
}

impl SupportId {
    /// Those of the ends, from the left.
    pub const ENDS: [Self; 2] = [Self::Left, Self::Right];

    /// Their words in the model file.
    pub const WORDS: [&'static str; 2] = ["left", "right"];

    /// All supports of a model: those of the ends, then the inner ones.
    pub fn all(model: &Model) -> impl Iterator<Item = Self> + use<> {
        (0..Self::ENDS.len() + model.supports.inner.len()).map(Self::at)
    }

    /// The word of an end in the model file, or the name of an inner support.
    pub fn name(self, model: &Model) -> &str {
        match self {
            Self::Left => Self::WORDS[0],
            Self::Right => Self::WORDS[1],
            Self::Inner(index) => &model.supports.inner[index].name,
        }
    }

    /// The support.
    pub fn support(self, model: &Model) -> &Support {
        match self {
            Self::Left => &model.supports.left,
            Self::Right => &model.supports.right,
            Self::Inner(index) => &model.supports.inner[index].support,
        }
    }

    /// The support, mutable.
    pub fn support_mut(self, model: &mut Model) -> &mut Support {
        match self {
            Self::Left => &mut model.supports.left,
            Self::Right => &mut model.supports.right,
            Self::Inner(index) => &mut model.supports.inner[index].support,
        }
    }

    /// Its distance from the left end, m.
    pub fn position(self, model: &Model) -> f64 {
        match self {
            Self::Left => 0.0,
            Self::Right => model.length(),
            Self::Inner(index) => model.supports.inner[index].position,
        }
    }

    /// The number of keys before those that every support has.
    pub(super) const fn own_keys(self) -> usize {
        match self {
            Self::Left | Self::Right => 0,
            Self::Inner(_) => schema::INNER_SUPPORT.keys.len(),
        }
    }

    /// Its index among all supports.
    const fn place(self) -> usize {
        match self {
            Self::Left => 0,
            Self::Right => 1,
            Self::Inner(index) => Self::ENDS.len() + index,
        }
    }

    const fn at(place: usize) -> Self {
        match place {
            0 => Self::Left,
            1 => Self::Right,
            inner => Self::Inner(inner - Self::ENDS.len()),
        }
    }
}

impl Part {
    /// The group of its numbers.
    pub const fn group(self) -> Group {
        match self {
            Self::Whole => Group::Beam,
            Self::Span(index) => Group::Span(index),
        }
    }

    /// The groups of its tables, in the order of the file.
    pub const fn tables(self) -> [Group; 3] {
        [
            Group::Material(self),
            Group::Section(self),
            Group::Foundation(self),
        ]
    }
}

/// A group of a model: a table or a list of tables. Elements of lists count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Group {
    /// The whole model, with the keys above all tables.
    Model,
    /// The beam.
    Beam,
    /// The material of a part of the beam.
    Material(Part),
    /// The section of a part of the beam.
    Section(Part),
    /// The foundation of a part of the beam.
    Foundation(Part),
    /// All spans of the beam.
    Spans,
    /// One span.
    Span(usize),
    /// All supports.
    Supports,
    /// One support.
    Support(SupportId),
    /// The spring of one motion of a support.
    Motion(SupportId, BeamMotion),
    /// All joints.
    Joints,
    /// One joint.
    Joint(usize),
    /// The spring of one motion of a joint.
    Link(usize, BeamMotion),
    /// All subsystems.
    Subsystems,
    /// One subsystem.
    Subsystem(usize),
    /// One Maxwell branch of a spring.
    Branch(SpringId, usize),
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
            Self::Material(_) => schema::MATERIAL.keys,
            Self::Section(_) => schema::SECTION.keys,
            Self::Foundation(_) => schema::FOUNDATION.keys,
            Self::Span(_) => schema::SPAN.keys,
            Self::Support(SupportId::Left | SupportId::Right) => schema::SUPPORT.keys,
            Self::Support(SupportId::Inner(_)) => schema::INNER_SUPPORT_KEYS,
            Self::Motion(_, motion) => schema::elastic(motion).keys,
            Self::Joint(_) => schema::JOINT.keys,
            Self::Link(_, motion) => schema::link(motion).keys,
            Self::Subsystem(_) => schema::SUBSYSTEM.keys,
            Self::Branch(spring, _) => schema::branch(spring.like()).keys,
            Self::Force(_) => schema::FORCE.keys,
            Self::Response(_) => schema::RESPONSE.keys,
            Self::Sweep => schema::SWEEP.keys,
            Self::Study(_) => schema::STUDY.keys,
            Self::Spans
            | Self::Supports
            | Self::Joints
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
            Self::Material(part) | Self::Section(part) | Self::Foundation(part) => part.group(),
            Self::Spans => Self::Beam,
            Self::Span(_) => Self::Spans,
            Self::Support(_) => Self::Supports,
            Self::Motion(support, _) => Self::Support(support),
            Self::Joint(_) => Self::Joints,
            Self::Link(joint, _) => Self::Joint(joint),
            Self::Subsystem(_) => Self::Subsystems,
            Self::Branch(spring, _) => spring.group(),
            Self::Force(_) => Self::Forces,
            Self::Response(_) => Self::Responses,
            Self::Study(_) => Self::Studies,
            Self::Variable(_) | Self::Objective(_) | Self::Limit(_) => Self::Tune,
            Self::Beam
            | Self::Supports
            | Self::Joints
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
                use Group::{
                    Beam, Forces, Joints, Responses, Studies, Subsystems, Supports, Sweep, Tune,
                };
                let studies = (!model.studies.is_empty()).then_some(Studies);
                let tune = model.tune.is_some().then_some(Tune);
                [Beam, Supports, Joints, Subsystems, Forces, Responses, Sweep]
                    .into_iter()
                    .chain(studies)
                    .chain(tune)
                    .collect()
            }
            Self::Beam => {
                let tables = Part::Whole.tables().into_iter();
                let tables = tables.filter(|table| table.is_there(model));
                let spans = (!model.spans.is_empty()).then_some(Self::Spans);
                tables.chain(spans).collect()
            }
            Self::Spans => each(model.spans.len(), Self::Span),
            Self::Span(index) => Part::Span(index).tables().to_vec(),
            Self::Supports => SupportId::all(model).map(Self::Support).collect(),
            Self::Support(support) => BeamMotion::ALL
                .map(|motion| Self::Motion(support, motion))
                .to_vec(),
            Self::Joints => each(model.joints.len(), Self::Joint),
            Self::Joint(joint) => BeamMotion::ALL
                .map(|motion| Self::Link(joint, motion))
                .to_vec(),
            Self::Motion(support, motion) => SpringId::Support(support, motion).groups(model),
            Self::Link(joint, motion) => SpringId::Joint(joint, motion).groups(model),
            Self::Subsystems => each(model.subsystems.len(), Self::Subsystem),
            Self::Subsystem(_) => self.branches(model),
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

    /// The key of a table of a part of the beam.
    pub(super) const fn table_key(self) -> Option<&'static str> {
        match self {
            Self::Material(_) => Some("material"),
            Self::Section(_) => Some("section"),
            Self::Foundation(_) => Some("foundation"),
            _ => None,
        }
    }

    /// Whether a material, section or foundation belongs to its part itself; true of all other groups.
    pub fn is_there(self, model: &Model) -> bool {
        match self {
            Self::Material(part) => part.material(model).is_some(),
            Self::Section(part) => part.section(model).is_some(),
            Self::Foundation(part) => part.foundation(model).is_some(),
            _ => true,
        }
    }

    /// The beam, span, support or list element that it belongs to, which the first parts of a path name.
    #[must_use]
    pub const fn owner(self) -> Self {
        match self {
            Self::Material(part) | Self::Section(part) | Self::Foundation(part) => part.group(),
            Self::Motion(support, _) => Self::Support(support),
            Self::Link(joint, _) => Self::Joint(joint),
            Self::Branch(spring, _) => spring.owner(),
            other => other,
        }
    }

    /// The Maxwell branches of all springs of a support, joint or subsystem, in the order of the file.
    pub(super) fn branches(self, model: &Model) -> Vec<Self> {
        let springs = SpringId::of(self).into_iter();
        springs.flat_map(|spring| spring.groups(model)).collect()
    }

    /// Its index among the supports or in its list.
    pub const fn place(self) -> Option<usize> {
        match self {
            Self::Branch(spring, _) => spring.owner().place(),
            Self::Support(support) | Self::Motion(support, _) => Some(support.place()),
            Self::Span(i)
            | Self::Material(Part::Span(i))
            | Self::Section(Part::Span(i))
            | Self::Foundation(Part::Span(i))
            | Self::Joint(i)
            | Self::Link(i, _)
            | Self::Subsystem(i)
            | Self::Force(i)
            | Self::Response(i)
            | Self::Study(i)
            | Self::Variable(i)
            | Self::Objective(i)
            | Self::Limit(i) => Some(i),
            _ => None,
        }
    }

    /// The same group of another support or list element.
    #[must_use]
    pub fn at(self, place: usize) -> Self {
        match self {
            Self::Material(part) => Self::Material(part.at(place)),
            Self::Section(part) => Self::Section(part.at(place)),
            Self::Foundation(part) => Self::Foundation(part.at(place)),
            Self::Span(_) => Self::Span(place),
            Self::Support(_) | Self::Motion(..) => self.of_support(SupportId::at(place)),
            Self::Joint(_) => Self::Joint(place),
            Self::Link(_, motion) => Self::Link(place, motion),
            Self::Subsystem(_) => Self::Subsystem(place),
            Self::Branch(spring, index) => Self::Branch(spring.at(spring.owner().at(place)), index),
            Self::Force(_) => Self::Force(place),
            Self::Response(_) => Self::Response(place),
            Self::Study(_) => Self::Study(place),
            Self::Variable(_) => Self::Variable(place),
            Self::Objective(_) => Self::Objective(place),
            Self::Limit(_) => Self::Limit(place),
            other => other,
        }
    }

    /// The same group of another support; a group of none stays.
    #[must_use]
    pub const fn of_support(self, support: SupportId) -> Self {
        match self {
            Self::Support(_) => Self::Support(support),
            Self::Motion(_, motion) => Self::Motion(support, motion),
            Self::Branch(spring, index) => Self::Branch(spring.at(Self::Support(support)), index),
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

    /// The parameters of a beam, span, support or element and all groups inside but the Maxwell branches, in the order of the
    /// file.
    pub(super) fn owned(self) -> Vec<ParameterId> {
        let with_tables = |part: Part| {
            let groups = std::iter::once(self).chain(part.tables());
            groups.flat_map(Self::parameters).collect()
        };
        match self {
            Self::Beam => with_tables(Part::Whole),
            Self::Span(index) => with_tables(Part::Span(index)),
            Self::Support(support) => self.with_springs(|motion| Self::Motion(support, motion)),
            Self::Joint(joint) => self.with_springs(|motion| Self::Link(joint, motion)),
            _ => self.parameters().collect(),
        }
    }

    /// The parameters of a support or joint, each motion's followed by those of its spring.
    fn with_springs(self, spring: impl Fn(BeamMotion) -> Self) -> Vec<ParameterId> {
        let mut all = Vec::new();
        for id in self.parameters() {
            all.push(id);
            let springs = id.motion().into_iter().map(&spring);
            all.extend(springs.flat_map(Self::parameters));
        }
        all
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
    /// The number of the beam that it is, if it is one.
    pub(crate) fn of_beam(self) -> Option<BeamNumber> {
        use schema::{BeamKey, FoundationKey, MaterialKey, SectionKey, SpanKey};
        Some(match self.group {
            Group::Beam => BeamNumber::Beam(BeamKey::ALL[self.row]),
            Group::Span(index) => BeamNumber::Span(index, SpanKey::ALL[self.row]),
            Group::Material(of) => BeamNumber::Material(of, MaterialKey::ALL[self.row]),
            Group::Section(of) => BeamNumber::Section(of, SectionKey::ALL[self.row]),
            Group::Foundation(of) => BeamNumber::Foundation(of, FoundationKey::ALL[self.row]),
            Group::Model
            | Group::Spans
            | Group::Supports
            | Group::Support(_)
            | Group::Motion(..)
            | Group::Joints
            | Group::Joint(_)
            | Group::Link(..)
            | Group::Subsystems
            | Group::Subsystem(_)
            | Group::Branch(..)
            | Group::Forces
            | Group::Force(_)
            | Group::Responses
            | Group::Response(_)
            | Group::Sweep
            | Group::Studies
            | Group::Study(_)
            | Group::Tune
            | Group::Variable(_)
            | Group::Objective(_)
            | Group::Limit(_) => return None,
        })
    }

    /// The model's title.
    pub const TITLE: Self = Group::Model.parameter(0);

    /// The restraint of a motion of a support: the rows after the word for all motions.
    pub const fn restraint(support: SupportId, motion: BeamMotion) -> Self {
        Group::Support(support).parameter(support.own_keys() + 1 + motion as usize)
    }

    /// The link of a motion of a joint: the rows after its position.
    pub const fn link(joint: usize, motion: BeamMotion) -> Self {
        Group::Joint(joint).parameter(1 + motion as usize)
    }

    /// The word for whose table a span has, its own or the beam's; none for another group.
    pub const fn owner_of(table: Group) -> Option<Self> {
        use schema::SpanKey;
        let (index, key) = match table {
            Group::Material(Part::Span(index)) => (index, SpanKey::Material),
            Group::Section(Part::Span(index)) => (index, SpanKey::Section),
            Group::Foundation(Part::Span(index)) => (index, SpanKey::Foundation),
            _ => return None,
        };
        Some(Group::Span(index).parameter(key as usize))
    }

    /// The table of a span whose word it is: [`Self::owner_of`] in reverse.
    pub fn table(self) -> Option<Group> {
        let Group::Span(index) = self.group else {
            return None;
        };
        let mut tables = Part::Span(index).tables().into_iter();
        tables.find(|table| Self::owner_of(*table) == Some(self))
    }

    /// The motion of a support whose restraint it is, or that of a joint whose link it is.
    pub fn motion(self) -> Option<BeamMotion> {
        let key = self.key();
        matches!(key.kind, Kind::Restraint | Kind::Link)
            .then(|| BeamMotion::of_word(key.key))
            .flatten()
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
                Group::Sweep => vec![group],
                Group::Beam => {
                    let spans = Group::Spans.groups(model);
                    std::iter::once(group).chain(spans).collect()
                }
                list => list.groups(model),
            };
            for owner in owners {
                all.extend(owner.owned());
                let branches = owner.branches(model).into_iter();
                all.extend(branches.flat_map(Group::parameters));
            }
        }
        all.retain(|id| id.exists(model));
        all
    }

    /// Whether it has a value: a fixed or rigid motion has no spring, an energy no position, a twist no point of the section,
    /// a beam of spans no length, a span with a table of the beam none of its own.
    pub fn exists(self, model: &Model) -> bool {
        match (self.group, self.key().kind) {
            (Group::Beam, _) => {
                model.spans.is_empty() || self.row != schema::BeamKey::Length as usize
            }
            (group @ (Group::Material(_) | Group::Section(_) | Group::Foundation(_)), _) => {
                group.is_there(model)
            }
            (Group::Motion(support, motion), _) => {
                support.support(model)[motion] != Restraint::Fixed
            }
            (Group::Link(joint, motion), _) => model.joints[joint][motion] != Link::Rigid,
            (Group::Branch(spring, index), _) => index < spring.branches(model).len(),
            (Group::Response(index), Kind::Place | Kind::Direction | Kind::Over) => {
                !model.responses[index].quantity.is_quadratic()
            }
            (group, _) => self.moved_by_twist().is_none_or(|motion| {
                let target =
                    super::edit::Placed::of(model, group).and_then(super::edit::Placed::target);
                matches!(target, Some(Target::Beam(_, own)) if *own == motion)
            }),
        }
    }

    /// For a coordinate of the point of a force or response: the motion that it matters for.
    fn moved_by_twist(self) -> Option<BeamMotion> {
        use schema::{ForceKey, ResponseKey};
        let is_row = |y: usize, z: usize| match self.row {
            row if row == y => Some(BeamMotion::V),
            row if row == z => Some(BeamMotion::W),
            _ => None,
        };
        match self.group {
            Group::Force(_) => is_row(ForceKey::Y as usize, ForceKey::Z as usize),
            Group::Response(_) => is_row(ResponseKey::Y as usize, ResponseKey::Z as usize),
            _ => None,
        }
    }

    /// The parameter with the same key in another group of its kind; none if that has no such key: an end has no position.
    pub fn of_group(self, group: Group) -> Option<Self> {
        let row = match (self.group, group) {
            (Group::Support(own), Group::Support(other)) => {
                (self.row + other.own_keys()).checked_sub(own.own_keys())?
            }
            _ => self.row,
        };
        Some(group.parameter(row))
    }

    /// The same parameter of another support or list element.
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
        for model in sample::models(&["S1", "S2"]) {
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
    }

    #[test]
    fn a_parameter_has_the_same_place_in_its_list() {
        for model in sample::models(&["S1", "S2"]) {
            for id in ParameterId::all(&model) {
                assert_eq!(id.group.place().map_or(id, |place| id.at(place)), id);
                assert_eq!(
                    id.table().and_then(ParameterId::owner_of),
                    id.table().map(|_| id)
                );
            }
        }
    }
}
