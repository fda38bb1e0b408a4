//! The springs of a model: those of supports, joints and subsystems are one kind, and one identifier finds each of them.

use super::beam::BeamMotion;
use super::id::{Group, SupportId};
use super::types::{Link, Model, Restraint, Subsystem};
use crate::words::words;

/// A spring, a damper and Maxwell branches in parallel, all 0 if there is none: the dynamic stiffness
/// `k (1 + i eta) + i omega c + sum k_b i omega c_b / (k_b + i omega c_b)`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Spring {
    /// k: N/m; N m/rad about an axis; N m3/rad on the rate of twist.
    pub stiffness: f64,
    /// c: N s/m; N m s/rad; N m3 s/rad.
    pub damping: f64,
    /// Loss factor eta of the stiffness.
    pub loss_factor: f64,
    /// In the order of the file.
    pub maxwell: Vec<MaxwellBranch>,
}

/// A spring and a damper in series: soft at low frequencies, at high ones a spring. Several of them describe a rubber.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MaxwellBranch {
    /// `k_b`, in the unit of the spring parallel to it.
    pub stiffness: f64,
    /// `c_b`, in the unit of the damper parallel to it.
    pub damping: f64,
}

impl MaxwellBranch {
    /// Whether it transmits a force.
    pub fn acts(&self) -> bool {
        self.stiffness != 0.0 && self.damping != 0.0
    }
}

impl Spring {
    /// Whether it transmits a force at any frequency.
    pub fn acts(&self) -> bool {
        self.has_spring() || self.has_damper()
    }

    /// Whether there is a spring in it, that of a Maxwell branch included.
    pub fn has_spring(&self) -> bool {
        self.stiffness != 0.0 || self.maxwell.iter().any(MaxwellBranch::acts)
    }

    /// Whether there is a damper in it, that of a Maxwell branch included.
    pub fn has_damper(&self) -> bool {
        self.damping != 0.0 || self.maxwell.iter().any(MaxwellBranch::acts)
    }
}

/// Spring, damper and inertia along one motion: the dynamic stiffness of the spring, and `-omega^2 m`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Elastic {
    /// To the ground.
    pub spring: Spring,
    /// Mass in kg along w and v; inertia in kg m2 about an axis; kg m4 on the rate of twist.
    pub inertia: f64,
}

/// That of a motion without a spring.
pub(super) static NONE: Elastic = Elastic {
    spring: Spring {
        stiffness: 0.0,
        damping: 0.0,
        loss_factor: 0.0,
        maxwell: Vec::new(),
    },
    inertia: 0.0,
};

words! {
    /// A spring of a subsystem with its damper.
    pub enum SpringName {
        /// The left one along y.
        YLeft = "y_left",
        /// The right one along y.
        YRight = "y_right",
        /// The left one along z.
        ZLeft = "z_left",
        /// The right one along z.
        ZRight = "z_right",
    }
}

impl SpringName {
    /// The spring of a subsystem.
    pub const fn of(self, subsystem: &Subsystem) -> &Spring {
        subsystem.springs()[self as usize]
    }
}

impl Subsystem {
    /// Its springs, in the order of [`SpringName::ALL`].
    pub const fn springs(&self) -> [&Spring; 4] {
        [&self.y_left, &self.y_right, &self.z_left, &self.z_right]
    }

    /// Its springs, mutable.
    pub const fn springs_mut(&mut self) -> [&mut Spring; 4] {
        [
            &mut self.y_left,
            &mut self.y_right,
            &mut self.z_left,
            &mut self.z_right,
        ]
    }
}

/// A place for a spring. Elements of lists count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SpringId {
    /// That of a motion of a support to the ground.
    Support(SupportId, BeamMotion),
    /// That between both sides of a motion of a joint.
    Joint(usize, BeamMotion),
    /// One of a subsystem.
    Subsystem(usize, SpringName),
}

impl SpringId {
    /// The places of a support, joint or subsystem, in the order of its rows; none of another group.
    pub fn of(owner: Group) -> Vec<Self> {
        match owner {
            Group::Support(id) => BeamMotion::ALL
                .map(|motion| Self::Support(id, motion))
                .into(),
            Group::Joint(index) => BeamMotion::ALL
                .map(|motion| Self::Joint(index, motion))
                .into(),
            Group::Subsystem(index) => SpringName::ALL
                .map(|spring| Self::Subsystem(index, spring))
                .into(),
            _ => Vec::new(),
        }
    }

    /// All places of a model.
    pub fn all(model: &Model) -> impl Iterator<Item = Self> + use<> {
        let lists = [Group::Supports, Group::Joints, Group::Subsystems];
        let owners: Vec<Group> = lists.iter().flat_map(|list| list.groups(model)).collect();
        owners.into_iter().flat_map(Self::of)
    }

    /// All springs of a model that responses depend on: not those of disabled subsystems.
    pub(crate) fn acting(model: &Model) -> impl Iterator<Item = &Spring> {
        let acts = |id: &Self| match *id {
            Self::Support(..) | Self::Joint(..) => true,
            Self::Subsystem(index, _) => model.subsystems[index].enabled,
        };
        Self::all(model)
            .filter(acts)
            .filter_map(|id| id.spring(model))
    }

    /// The spring; none where the motion is free, fixed or rigid.
    pub fn spring(self, model: &Model) -> Option<&Spring> {
        match self {
            Self::Support(id, motion) => match &id.support(model)[motion] {
                Restraint::Elastic(elastic) => Some(&elastic.spring),
                Restraint::Free | Restraint::Fixed => None,
            },
            Self::Joint(index, motion) => match &model.joints[index][motion] {
                Link::Elastic(spring) => Some(spring),
                Link::Rigid | Link::Free => None,
            },
            Self::Subsystem(index, spring) => Some(spring.of(&model.subsystems[index])),
        }
    }

    /// The spring, mutable; none where the motion is free, fixed or rigid.
    pub fn spring_mut(self, model: &mut Model) -> Option<&mut Spring> {
        match self {
            Self::Support(id, motion) => match &mut id.support_mut(model)[motion] {
                Restraint::Elastic(elastic) => Some(&mut elastic.spring),
                Restraint::Free | Restraint::Fixed => None,
            },
            Self::Joint(index, motion) => match &mut model.joints[index][motion] {
                Link::Elastic(spring) => Some(spring),
                Link::Rigid | Link::Free => None,
            },
            Self::Subsystem(index, spring) => {
                let springs = model.subsystems[index].springs_mut();
                springs.into_iter().nth(spring as usize)
            }
        }
    }

    /// Its Maxwell branches.
    pub fn branches(self, model: &Model) -> &[MaxwellBranch] {
        self.spring(model).map_or(&[], |spring| &spring.maxwell)
    }

    /// The groups of its Maxwell branches.
    pub(super) fn groups(self, model: &Model) -> Vec<Group> {
        let indices = 0..self.branches(model).len();
        indices.map(|index| Group::Branch(self, index)).collect()
    }

    /// The support, joint or subsystem.
    pub const fn owner(self) -> Group {
        match self {
            Self::Support(id, _) => Group::Support(id),
            Self::Joint(index, _) => Group::Joint(index),
            Self::Subsystem(index, _) => Group::Subsystem(index),
        }
    }

    /// The group of its numbers: a motion of the support or joint, or the whole subsystem.
    pub const fn group(self) -> Group {
        match self {
            Self::Support(id, motion) => Group::Motion(id, motion),
            Self::Joint(index, motion) => Group::Link(index, motion),
            Self::Subsystem(index, _) => Group::Subsystem(index),
        }
    }

    /// The same place of another support, joint or subsystem.
    #[must_use]
    pub(super) const fn at(self, owner: Group) -> Self {
        match (self, owner) {
            (Self::Support(_, motion), Group::Support(id)) => Self::Support(id, motion),
            (Self::Joint(_, motion), Group::Joint(index)) => Self::Joint(index, motion),
            (Self::Subsystem(_, spring), Group::Subsystem(index)) => Self::Subsystem(index, spring),
            (other, _) => other,
        }
    }

    /// Its key in the table of its owner.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Support(_, motion) | Self::Joint(_, motion) => motion.key(),
            Self::Subsystem(_, spring) => spring.key(),
        }
    }

    /// The motion of the beam with the units of this spring.
    pub(super) const fn like(self) -> BeamMotion {
        match self {
            Self::Support(_, motion) | Self::Joint(_, motion) => motion,
            Self::Subsystem(..) => BeamMotion::W,
        }
    }
}
