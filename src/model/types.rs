//! The model as plain data in SI units, which the engineer edits and the solver reads.
//!
//! A number that the file omits has its default here (no stiffness, no damping, amplitude 1), so every value of these
//! types is a complete model. [`check`](super::check()) finds out whether it is also a *possible* one.

use super::beam::{Beam, BeamMotion, Point, Span, UniformPart};
use super::path::Pattern;
use super::quantity::Response;
use super::spring::{Elastic, NONE, Spring};
use super::tuning::Tune;
use crate::unit::Load;
use crate::words::words;

/// A beam with its supports, subsystems, loads, responses and studies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Model {
    /// Title, one line.
    pub title: String,
    /// Free text; empty if the file has none.
    pub notes: String,
    /// The beam itself.
    pub beam: Beam,
    /// Its spans, from left to right; empty if it is uniform.
    pub spans: Vec<Span>,
    /// What holds it.
    pub supports: Supports,
    /// Where it is cut and joined again, in the order of the file.
    pub joints: Vec<Joint>,
    /// The subsystems, in the order of the file.
    pub subsystems: Vec<Subsystem>,
    /// The loads, which act simultaneously.
    pub forces: Vec<Force>,
    /// The responses, in the order of the output columns.
    pub responses: Vec<Response>,
    /// The frequencies.
    pub sweep: Sweep,
    /// The studies: families of curves.
    pub studies: Vec<Study>,
    /// Variables, objectives and limits of an optimisation.
    pub tune: Option<Tune>,
}

impl Model {
    /// The subsystems that are attached: those enabled, in the order of the file.
    pub fn attached(&self) -> impl Iterator<Item = &Subsystem> {
        self.subsystems.iter().filter(|subsystem| subsystem.enabled)
    }

    /// Length of the whole beam, m.
    pub fn length(&self) -> f64 {
        if self.spans.is_empty() {
            self.beam.length
        } else {
            self.spans.iter().map(|span| span.length).sum()
        }
    }

    /// Mass of the beam alone, kg.
    pub fn beam_mass(&self) -> f64 {
        self.uniform_parts().iter().map(UniformPart::mass).sum()
    }

    /// The uniform parts of the beam, from left to right: its spans, or all of it.
    pub(crate) fn uniform_parts(&self) -> Vec<UniformPart> {
        let mut end = 0.0;
        let parts = self.spans.iter().map(|span| {
            let start = end;
            end += span.length;
            UniformPart {
                start,
                end,
                beam: span.beam(&self.beam),
                offset: span.offset,
            }
        });
        let mut parts: Vec<UniformPart> = parts.collect();
        if parts.is_empty() {
            parts.push(UniformPart::whole(self.beam));
        }
        parts
    }
}

words! {
    /// The three motions of a subsystem's mass.
    pub enum MassMotion {
        /// Along y, m.
        Y = "y",
        /// Along z, m.
        Z = "z",
        /// Rotation about x, rad.
        Theta = "theta",
    }
}

/// What holds the beam.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Supports {
    /// At x = 0.
    pub left: Support,
    /// At x = L.
    pub right: Support,
    /// Between the ends, in the order of the file.
    pub inner: Vec<InnerSupport>,
}

/// A support between the ends: a bearing, a spring to the ground or, with masses alone, a lumped mass.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct InnerSupport {
    /// Unique, also among the subsystems; not "left" or "right".
    pub name: String,
    /// Distance from the left end, m.
    pub position: f64,
    /// What it holds.
    pub support: Support,
}

/// The restraints of the six motions of the beam at one position.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Support {
    /// In the order of [`BeamMotion::ALL`].
    pub restraints: [Restraint; 6],
    /// The point of the section that the restraints of w and v hold.
    pub point: Point,
}

impl Support {
    /// All six free.
    pub const FREE: Self = Self::on_axis([const { Restraint::Free }; 6]);
    /// Displacements and twist fixed, slopes free.
    pub const PINNED: Self = Self::on_axis([
        Restraint::Fixed,
        Restraint::Fixed,
        Restraint::Fixed,
        Restraint::Free,
        Restraint::Free,
        Restraint::Free,
    ]);
    /// All six fixed.
    pub const CLAMPED: Self = Self::on_axis([const { Restraint::Fixed }; 6]);

    /// Restraints that act on the axis of the beam, in the order of [`BeamMotion::ALL`].
    pub const fn on_axis(restraints: [Restraint; 6]) -> Self {
        Self {
            restraints,
            point: Point::AXIS,
        }
    }

    /// The supports with one word for all six motions.
    pub const KINDS: [Self; 3] = [Self::FREE, Self::PINNED, Self::CLAMPED];
    /// Their words.
    pub const WORDS: [&'static str; 3] = ["free", "pinned", "clamped"];

    /// The word for all six motions, if there is one.
    pub fn word(&self) -> Option<&'static str> {
        let is_it = |kind: &Self| kind.restraints == self.restraints;
        let known = Self::KINDS.iter().position(is_it)?;
        Some(Self::WORDS[known])
    }

    /// The word for all six motions: `free`, `pinned`, `clamped`, or `elastic` for any other support.
    pub fn kind(&self) -> &'static str {
        self.word().unwrap_or("elastic")
    }

    /// The support of a word.
    pub fn of_word(word: &str) -> Option<Self> {
        let known = Self::WORDS.iter().position(|known| *known == word)?;
        Some(Self::KINDS[known].clone())
    }
}

impl std::ops::Index<BeamMotion> for Support {
    type Output = Restraint;
    fn index(&self, motion: BeamMotion) -> &Restraint {
        &self.restraints[motion as usize]
    }
}

impl std::ops::IndexMut<BeamMotion> for Support {
    fn index_mut(&mut self, motion: BeamMotion) -> &mut Restraint {
        &mut self.restraints[motion as usize]
    }
}

/// The restraint of one motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Restraint {
    /// No restraint.
    #[default]
    Free,
    /// No motion.
    Fixed,
    /// A spring, a damper and an inertia to the ground.
    Elastic(Elastic),
}

impl Restraint {
    /// The spring, damper and inertia; none if it is free or fixed.
    pub fn elastic(&self) -> &Elastic {
        match self {
            Self::Elastic(elastic) => elastic,
            Self::Free | Self::Fixed => &NONE,
        }
    }

    /// Whether it resists its motion: a spring, damper or inertia of 0 does not.
    pub fn acts(&self) -> bool {
        match self {
            Self::Free => false,
            Self::Fixed => true,
            Self::Elastic(elastic) => elastic.spring.acts() || elastic.inertia != 0.0,
        }
    }

    /// The words of all kinds.
    pub const WORDS: [&'static str; 3] = ["free", "fixed", "elastic"];

    /// The restraint of a word; an elastic one has 0 for every number.
    pub fn of_word(word: &str) -> Option<Self> {
        let all = [Self::Free, Self::Fixed, Self::Elastic(Elastic::default())];
        all.into_iter().find(|one| one.kind() == word)
    }

    /// Its word.
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Free => Self::WORDS[0],
            Self::Fixed => Self::WORDS[1],
            Self::Elastic(_) => Self::WORDS[2],
        }
    }
}

/// A place between the ends where the beam is cut and joined again: a hinge, a sliding joint, a coupling.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Joint {
    /// Distance from the left end, m.
    pub position: f64,
    /// What joins the motions of both sides, in the order of [`BeamMotion::ALL`]. Next to a section without warping
    /// stiffness, which transmits no bimoment, that of the rate of twist has no effect.
    pub links: [Link; 6],
}

impl std::ops::Index<BeamMotion> for Joint {
    type Output = Link;
    fn index(&self, motion: BeamMotion) -> &Link {
        &self.links[motion as usize]
    }
}

impl std::ops::IndexMut<BeamMotion> for Joint {
    fn index_mut(&mut self, motion: BeamMotion) -> &mut Link {
        &mut self.links[motion as usize]
    }
}

/// What joins a motion of both sides of a joint.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Link {
    /// Both sides move together.
    #[default]
    Rigid,
    /// Each side moves on its own.
    Free,
    /// A spring and a damper between both sides.
    Elastic(Spring),
}

impl Link {
    /// The spring and damper; none if it is rigid or free.
    pub fn spring(&self) -> &Spring {
        match self {
            Self::Elastic(spring) => spring,
            Self::Rigid | Self::Free => &NONE.spring,
        }
    }

    /// The words of all kinds.
    pub const WORDS: [&'static str; 3] = ["rigid", "free", "elastic"];

    /// The link of a word; an elastic one has 0 for every number.
    pub fn of_word(word: &str) -> Option<Self> {
        let all = [Self::Rigid, Self::Free, Self::Elastic(Spring::default())];
        all.into_iter().find(|one| one.kind() == word)
    }

    /// Its word.
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Rigid => Self::WORDS[0],
            Self::Free => Self::WORDS[1],
            Self::Elastic(_) => Self::WORDS[2],
        }
    }
}

/// A mass with three degrees of freedom (y, z, theta) on four springs with dampers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Subsystem {
    /// Unique; not "left" or "right".
    pub name: String,
    /// Whether it is attached.
    pub enabled: bool,
    /// Distance from the left end, m.
    pub position: f64,
    /// m, kg.
    pub mass: f64,
    /// J about its own centre, kg m2.
    pub inertia: f64,
    /// Left spring along y.
    pub y_left: Spring,
    /// Right spring along y.
    pub y_right: Spring,
    /// Left spring along z.
    pub z_left: Spring,
    /// Right spring along z.
    pub z_right: Spring,
    /// Arm `l_L` of the left z spring at the mass, m.
    pub arm_left: f64,
    /// Arm `l_R` of the right z spring at the mass, m.
    pub arm_right: f64,
    /// Half-spacing `y_u` of the z springs at the beam, m.
    pub mount_y: f64,
    /// Height `z_b` of the y springs at the beam, from the shear centre, m.
    pub mount_z: f64,
}

impl Subsystem {
    /// The keys of the numbers that matter only with some spring or damper.
    pub const OF_SPRINGS: [&str; 5] = ["inertia", "arm_left", "arm_right", "mount_y", "mount_z"];

    /// Whether something resists theta: an inertia, or a z spring or damper on an arm. Otherwise theta has no equation.
    pub fn can_turn(&self) -> bool {
        let on_arm = |spring: &Spring, arm: f64| arm != 0.0 && spring.acts();
        self.inertia != 0.0
            || on_arm(&self.z_left, self.arm_left)
            || on_arm(&self.z_right, self.arm_right)
    }

    /// Whether the number of a key matters: without a spring or damper that uses it, it is optional and 0 by default.
    pub fn needs(&self, key: &str) -> bool {
        match key {
            "arm_left" => self.z_left.acts(),
            "arm_right" => self.z_right.acts(),
            "inertia" | "mount_y" => self.z_left.acts() || self.z_right.acts(),
            "mount_z" => self.y_left.acts() || self.y_right.acts(),
            _ => true,
        }
    }
}

/// A position on the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// x = 0.
    Left,
    /// x = L.
    Right,
    /// Distance from the left end, m.
    Position(f64),
}

impl Place {
    /// Its distance from the left end of a beam of a length, both m.
    pub const fn position(self, length: f64) -> f64 {
        match self {
            Self::Left => 0.0,
            Self::Right => length,
            Self::Position(x) => x,
        }
    }
}

/// Where a force acts or a response is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum At<'a> {
    /// On the beam.
    Beam(Place),
    /// At the subsystem with this name.
    Subsystem(&'a str),
    /// At the inner support with this name.
    Support(&'a str),
    /// At all supports.
    Ground,
}

/// A motion of the beam at a position, or of a subsystem's mass.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// A motion of the beam.
    Beam(Place, BeamMotion),
    /// A motion of the mass of the subsystem with this name.
    Mass(String, MassMotion),
}

impl Target {
    /// Whether it is a displacement of the beam, which is another one at another point of the section.
    pub const fn has_point(&self) -> bool {
        matches!(self, Self::Beam(_, BeamMotion::W | BeamMotion::V))
    }

    /// Where it is.
    pub fn at(&self) -> At<'_> {
        match self {
            Self::Beam(place, _) => At::Beam(*place),
            Self::Mass(name, _) => At::Subsystem(name),
        }
    }

    /// The word of its direction.
    pub const fn direction(&self) -> &'static str {
        match self {
            Self::Beam(_, motion) => motion.key(),
            Self::Mass(_, motion) => motion.key(),
        }
    }

    /// The words of the directions that its position permits.
    pub const fn directions(&self) -> &'static [&'static str] {
        match self {
            Self::Beam(..) => BeamMotion::WORDS,
            Self::Mass(..) => MassMotion::WORDS,
        }
    }

    /// The load that acts along it.
    pub const fn load(&self) -> Load {
        match self {
            Self::Beam(_, motion) => motion.load(),
            Self::Mass(_, MassMotion::Y | MassMotion::Z) => Load::Force,
            Self::Mass(_, MassMotion::Theta) => Load::Moment,
        }
    }
}

/// A harmonic load.
#[derive(Debug, Clone, PartialEq)]
pub struct Force {
    /// False: kept in the file, but does not act.
    pub enabled: bool,
    /// Position and direction.
    pub target: Target,
    /// The point of the section on which a force along w or v acts; on the axis for any other load.
    pub point: Point,
    /// Zero to peak, N (a torque or moment: N m; along `psi_slope`, a bimoment: N m2).
    pub amplitude: f64,
    /// Phase, degrees.
    pub phase: f64,
}

/// The frequencies of the curves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sweep {
    /// First frequency, Hz.
    pub from: f64,
    /// Last frequency, Hz.
    pub to: f64,
    /// The number of frequencies, both ends included.
    pub points: usize,
    /// Their spacing.
    pub spacing: Spacing,
}

words! {
    /// The spacing of frequencies.
    #[derive(Default)]
    pub enum Spacing {
        /// Equal steps.
        #[default]
        Linear = "linear",
        /// Equal ratios.
        Log = "log",
    }
}

/// A family of curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Unique.
    pub name: String,
    /// The differences of its members.
    pub family: Family,
}

/// The members of a study.
#[derive(Debug, Clone, PartialEq)]
pub enum Family {
    /// Each value in turn changes the same paths.
    Vary {
        /// Parameter paths; `*` is every subsystem.
        paths: Vec<Pattern>,
        /// How a value changes a parameter.
        operation: Operation,
        /// One value per member.
        values: Vec<f64>,
    },
    /// Named cases.
    Cases(Vec<Case>),
}

impl Family {
    /// The paths that its members change.
    pub fn patterns(&self) -> Box<dyn Iterator<Item = &Pattern> + '_> {
        match self {
            Self::Vary { paths, .. } => Box::new(paths.iter()),
            Self::Cases(cases) => {
                let set = cases.iter().flat_map(|case| &case.set);
                Box::new(set.map(|(path, _)| path))
            }
        }
    }
}

words! {
    /// How a study's value changes a parameter.
    pub enum Operation {
        /// Times the value.
        Multiply = "multiply",
        /// The value itself.
        Set = "set",
        /// Plus the value.
        Add = "add",
    }
}

impl Operation {
    /// The parameter's new value.
    pub fn apply(self, old: f64, value: f64) -> f64 {
        match self {
            Self::Multiply => old * value,
            Self::Set => value,
            Self::Add => old + value,
        }
    }
}

/// A named member of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Unique in its study.
    pub name: String,
    /// Paths and their values.
    pub set: Vec<(Pattern, f64)>,
}
