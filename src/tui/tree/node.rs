//! What a row of the tree is.

use crate::model::schema::Kind;
use crate::model::{Group, Moves, ParameterId};

/// A row of the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Node {
    /// A table or list of the model. That of an end or of one of its motions is also the parameter of its word.
    Group(Group),
    /// A parameter that has a row of its own.
    Parameter(ParameterId),
    /// A line of a study: a path or a case.
    StudyLine(usize, usize),
}

impl Node {
    /// The model's title, the first row.
    pub const TITLE: Self = Self::Parameter(ParameterId::TITLE);

    /// The row of a parameter.
    pub fn of(id: ParameterId) -> Self {
        match (id.group, id.motion()) {
            (Group::Support(end), Some(motion)) => Self::Group(Group::Motion(end, motion)),
            (Group::Support(_), None) => Self::Group(id.group),
            _ => Self::Parameter(id),
        }
    }

    /// The table that it is or belongs to.
    pub const fn group(self) -> Group {
        match self {
            Self::Group(group) => group,
            Self::Parameter(id) => id.group,
            Self::StudyLine(study, _) => Group::Study(study),
        }
    }

    /// The row that holds it.
    pub fn parent(self) -> Option<Self> {
        let holder = match self {
            Self::Group(group) => group.parent()?,
            Self::Parameter(_) | Self::StudyLine(..) => self.group(),
        };
        (holder != Group::Model).then_some(Self::Group(holder))
    }

    /// The parameter that it shows, if it shows one.
    pub fn parameter(self) -> Option<ParameterId> {
        match self {
            Self::Parameter(id) => Some(id),
            Self::Group(Group::Motion(end, motion)) => Some(ParameterId::restraint(end, motion)),
            Self::Group(group) => group.parameter_of(Kind::Support),
            Self::StudyLine(..) => None,
        }
    }

    /// The name of a subsystem, response or study, or the title.
    pub fn name(self) -> Option<ParameterId> {
        match self {
            Self::Group(group) => group.parameter_of(Kind::Name),
            other => (other == Self::TITLE).then_some(ParameterId::TITLE),
        }
    }

    /// The subsystem, force, response or study that it belongs to.
    pub fn item(self) -> Option<Group> {
        Some(self.group()).filter(|group| {
            matches!(
                group,
                Group::Subsystem(_) | Group::Force(_) | Group::Response(_) | Group::Study(_)
            )
        })
    }

    /// Where the row is in a changed model; none where it was removed.
    pub fn moved(self, moves: &Moves) -> Option<Self> {
        Some(self.of_group(moves.of(self.group())?))
    }

    /// The same row of another table of the same kind.
    #[must_use]
    pub const fn of_group(self, group: Group) -> Self {
        match (self, group) {
            (Self::Parameter(id), _) => Self::Parameter(group.parameter(id.row)),
            (Self::StudyLine(_, line), Group::Study(study)) => Self::StudyLine(study, line),
            _ => Self::Group(group),
        }
    }
}
