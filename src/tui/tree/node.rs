//! The nodes of the tree.

use crate::model::schema::Kind;
use crate::model::{Group, Moves, ParameterId, SpringId, SpringName, SupportId};

/// A row of the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Node {
    /// A table or list of the model. For an end, one of its motions or a table of a span, also the parameter of its word.
    Group(Group),
    /// A parameter with its own row.
    Parameter(ParameterId),
    /// A line of a study: a path or a case.
    StudyLine(usize, usize),
}

impl Node {
    /// The model's title, the first row.
    pub const TITLE: Self = Self::Parameter(ParameterId::TITLE);

    /// The row of a parameter.
    pub fn of(id: ParameterId) -> Self {
        if let Some(table) = id.table() {
            return Self::Group(table);
        }
        match (id.group, id.motion(), id.key().kind) {
            (Group::Support(id), Some(motion), _) => Self::Group(Group::Motion(id, motion)),
            (Group::Joint(joint), Some(motion), _) => Self::Group(Group::Link(joint, motion)),
            (Group::Support(_), None, Kind::Support) => Self::Group(id.group),
            _ => Self::Parameter(id),
        }
    }

    /// Its table.
    pub const fn group(self) -> Group {
        match self {
            Self::Group(group) => group,
            Self::Parameter(id) => id.group,
            Self::StudyLine(study, _) => Group::Study(study),
        }
    }

    /// The parent row.
    pub fn parent(self) -> Option<Self> {
        let holder = match self {
            Self::Group(group) => group.parent()?,
            Self::Parameter(_) | Self::StudyLine(..) => self.group(),
        };
        (holder != Group::Model).then_some(Self::Group(holder))
    }

    /// Its parameter, if it has one.
    pub fn parameter(self) -> Option<ParameterId> {
        match self {
            Self::Parameter(id) => Some(id),
            Self::Group(Group::Motion(end, motion)) => Some(ParameterId::restraint(end, motion)),
            Self::Group(Group::Link(joint, motion)) => Some(ParameterId::link(joint, motion)),
            Self::Group(group) => {
                ParameterId::owner_of(group).or_else(|| group.parameter_of(Kind::Support))
            }
            Self::StudyLine(..) => None,
        }
    }

    /// The name of an inner support, a subsystem, response or study, or the title.
    pub fn name(self) -> Option<ParameterId> {
        match self {
            Self::Group(group) => group.parameter_of(Kind::Name),
            other => (other == Self::TITLE).then_some(ParameterId::TITLE),
        }
    }

    /// What can be deleted or duplicated there: [`Self::item`], or a Maxwell branch.
    pub fn element(self) -> Option<Group> {
        match self.group() {
            branch @ Group::Branch(..) => Some(branch),
            _ => self.item(),
        }
    }

    /// The spring of its row, if it has one.
    pub fn spring(self) -> Option<SpringId> {
        match self.group() {
            Group::Branch(spring, _) => Some(spring),
            Group::Motion(id, motion) => Some(SpringId::Support(id, motion)),
            Group::Link(joint, motion) => Some(SpringId::Joint(joint, motion)),
            Group::Subsystem(index) => {
                let (word, _) = self.parameter()?.key().key.split_once('.')?;
                Some(SpringId::Subsystem(index, SpringName::of_word(word)?))
            }
            _ => None,
        }
    }

    /// Its span, inner support, joint, subsystem, force, response or study.
    pub fn item(self) -> Option<Group> {
        Some(self.group().owner()).filter(|group| {
            matches!(
                group,
                Group::Span(_)
                    | Group::Support(SupportId::Inner(_))
                    | Group::Joint(_)
                    | Group::Subsystem(_)
                    | Group::Force(_)
                    | Group::Response(_)
                    | Group::Study(_)
            )
        })
    }

    /// Its row in a changed model; none if it was removed.
    pub fn moved(self, moves: &Moves) -> Option<Self> {
        self.of_group(moves.of(self.group())?)
    }

    /// The corresponding row of another table of the same kind, if it has one.
    pub fn of_group(self, group: Group) -> Option<Self> {
        Some(match (self, group) {
            (Self::Parameter(id), _) => Self::Parameter(id.of_group(group)?),
            (Self::StudyLine(_, line), Group::Study(study)) => Self::StudyLine(study, line),
            _ => Self::Group(group),
        })
    }
}
