//! What a response is: where it is read, along what, its words in a file and the dimension of its values.

use super::beam::{BeamMotion, Point};
use super::spring::SpringName;
use super::types::{At, MassMotion, Model, Place, Target};
use crate::unit::{Amount, Dimension, Kind, Load, Measure, Moves};
use crate::words::words;

/// A response to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// Unique.
    pub name: String,
    /// False: kept in the file, but not computed.
    pub enabled: bool,
    /// The quantity to compute.
    pub quantity: Quantity,
    /// The point of the section that moves, for a motion along w or v; on the axis for any other quantity.
    pub point: Point,
    /// The name of the response that divides it, if any does; not itself divided.
    pub over: Option<String>,
}

/// The quantity of a response.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A motion, complex.
    Motion(Target, Measure),
    /// What the beam puts on the ground: what the springs and dampers of supports, or what holds a fixed motion, carry,
    /// without the inertias of the supports; complex, N, N m or N m2.
    Reaction(Reaction),
    /// An internal force of the beam, conjugate to a motion of its axis, just right of a place (at the right end just left of
    /// it); complex, N, N m or N m2.
    InternalForce(Place, BeamMotion),
    /// What a spring with its damper of the subsystem with this name carries, or its stretch: complex, N or m.
    Spring(String, SpringName, SpringMeasure),
    /// The vibration energy `E_V` of the whole beam (Chen & Liu 2022, Section 4.2), real, kg m2.
    Energy,
}

/// The supports of which a reaction is.
#[derive(Debug, Clone, PartialEq)]
pub enum Reaction {
    /// Of one support, along a motion of the point that it holds.
    Support(Holder, BeamMotion),
    /// The sum over all supports.
    Ground(Across),
}

/// A support, by its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Holder {
    /// At x = 0.
    Left,
    /// At x = L.
    Right,
    /// The inner support with this name.
    Inner(String),
}

words! {
    /// A direction in which forces of several supports add up.
    pub enum Across {
        /// Along y.
        W = "w",
        /// Along z.
        V = "v",
    }
}

words! {
    /// What is measured of a spring.
    pub enum SpringMeasure {
        /// `k (1 + i eta) + i omega c` times the stretch, N.
        Force = "spring_force",
        /// The displacement of the beam's end less that of the mass's, m.
        Stretch = "stretch",
    }
}

impl From<Across> for BeamMotion {
    fn from(across: Across) -> Self {
        match across {
            Across::W => Self::W,
            Across::V => Self::V,
        }
    }
}

impl Model {
    /// The responses that are computed: those enabled, each with the one that divides it.
    pub(crate) fn computed(&self) -> impl Iterator<Item = &Response> {
        let enabled = self.responses.iter().filter(|of| of.enabled);
        enabled.flat_map(|of| [Some(of), of.divisor(self)].into_iter().flatten())
    }
}

impl Response {
    /// Whether it is another one at another point of the section.
    pub fn has_point(&self) -> bool {
        self.quantity.target().is_some_and(Target::has_point)
    }

    /// Sets the quantity; one that is the same at every point of the section has no point, an energy no divisor.
    pub(super) fn set_quantity(&mut self, quantity: Quantity) {
        self.quantity = quantity;
        if !self.has_point() {
            self.point = Point::AXIS;
        }
        if self.quantity.is_quadratic() {
            self.over = None;
        }
    }

    /// The response of a model that divides it.
    pub fn divisor<'a>(&self, model: &'a Model) -> Option<&'a Self> {
        let name = self.over.as_ref()?;
        model.responses.iter().find(|one| one.name == *name)
    }

    /// Whether its values are in proportion to the loads: neither a ratio of two responses nor an energy.
    pub const fn is_linear(&self) -> bool {
        self.over.is_none() && !self.quantity.is_quadratic()
    }

    /// The dimension of its values, divided by a load where they are in proportion to it.
    pub fn kind(&self, model: &Model, per: Option<Load>) -> Kind {
        let per = match self.divisor(model) {
            Some(divisor) => divisor.quantity.amount(),
            None => per.map(Amount::Load),
        };
        match self.quantity.amount() {
            Some(of) => Kind::Amplitude(Dimension { of, per }),
            None => Kind::Energy,
        }
    }
}

impl Quantity {
    /// The words of the measures that are no motions and not of a spring.
    pub const REACTION: &'static str = "reaction";
    /// See [`Self::REACTION`].
    pub const INTERNAL_FORCE: &'static str = "internal_force";
    /// See [`Self::REACTION`].
    pub const ENERGY: &'static str = "energy";

    /// The words of all measures.
    pub fn words() -> Vec<&'static str> {
        let forces = [Self::REACTION, Self::INTERNAL_FORCE];
        [
            Measure::WORDS,
            &forces,
            SpringMeasure::WORDS,
            &[Self::ENERGY],
        ]
        .concat()
    }

    /// The word of its measure.
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Motion(_, measure) => measure.key(),
            Self::Reaction(_) => Self::REACTION,
            Self::InternalForce(..) => Self::INTERNAL_FORCE,
            Self::Spring(_, _, measure) => measure.key(),
            Self::Energy => Self::ENERGY,
        }
    }

    /// The same with another measure, where and along what it can be; without a position of its own at a default one.
    ///
    /// # Errors
    /// The word is no measure, or the model has nothing of which it could be.
    pub fn of_word(&self, word: &str, model: &Model) -> Result<Self, String> {
        let motion = self.motion().unwrap_or(BeamMotion::W);
        let plain = if let Some(measure) = Measure::of_word(word) {
            Self::Motion(Target::Beam(Place::Right, motion), measure)
        } else if let Some(measure) = SpringMeasure::of_word(word) {
            let first = model.subsystems.first();
            let first = first.ok_or("needs a subsystem; the model has none")?;
            Self::Spring(first.name.clone(), SpringName::along(motion), measure)
        } else {
            match word {
                Self::REACTION => Self::Reaction(Reaction::Support(Holder::Left, motion)),
                Self::INTERNAL_FORCE => Self::InternalForce(Place::Left, motion),
                Self::ENERGY => Self::Energy,
                _ => {
                    let words = Self::words().join(", ");
                    return Err(format!("is {word:?}; must be one of {words}"));
                }
            }
        };
        Ok(self.at().and_then(|at| plain.moved(at)).unwrap_or(plain))
    }

    /// What moves; none for what is no motion of the beam or of a mass.
    pub const fn target(&self) -> Option<&Target> {
        match self {
            Self::Motion(target, _) => Some(target),
            Self::Reaction(_) | Self::InternalForce(..) | Self::Spring(..) | Self::Energy => None,
        }
    }

    /// Where it is read; none for what is of the whole beam.
    pub fn at(&self) -> Option<At<'_>> {
        Some(match self {
            Self::Motion(target, _) => target.at(),
            Self::Reaction(Reaction::Support(holder, _)) => holder.at(),
            Self::Reaction(Reaction::Ground(_)) => At::Ground,
            Self::InternalForce(place, _) => At::Beam(*place),
            Self::Spring(name, ..) => At::Subsystem(name),
            Self::Energy => return None,
        })
    }

    /// The same elsewhere, along the direction that corresponds; none where it is not defined.
    pub fn moved(&self, at: At<'_>) -> Option<Self> {
        Some(match (self, at) {
            (Self::Motion(target, measure), _) => Self::Motion(target.moved(at)?, *measure),
            (Self::Reaction(_), At::Ground) => Self::Reaction(Reaction::Ground(self.across())),
            (Self::Reaction(_), _) => {
                Self::Reaction(Reaction::Support(Holder::of(at)?, self.motion()?))
            }
            (Self::InternalForce(_, motion), At::Beam(place)) => {
                Self::InternalForce(place, *motion)
            }
            (Self::Spring(_, spring, measure), At::Subsystem(name)) => {
                Self::Spring(name.to_owned(), *spring, *measure)
            }
            (Self::InternalForce(..) | Self::Spring(..) | Self::Energy, _) => return None,
        })
    }

    /// The words of the directions that its measure and its position permit; none for an energy.
    pub const fn directions(&self) -> &'static [&'static str] {
        match self {
            Self::Motion(target, _) => target.directions(),
            Self::Reaction(Reaction::Support(..)) | Self::InternalForce(..) => BeamMotion::WORDS,
            Self::Reaction(Reaction::Ground(_)) => Across::WORDS,
            Self::Spring(..) => SpringName::WORDS,
            Self::Energy => &[],
        }
    }

    /// The word of its direction; none for an energy.
    pub const fn direction(&self) -> Option<&'static str> {
        Some(match self {
            Self::Motion(target, _) => target.direction(),
            Self::Reaction(Reaction::Support(_, motion)) | Self::InternalForce(_, motion) => {
                motion.key()
            }
            Self::Reaction(Reaction::Ground(across)) => across.key(),
            Self::Spring(_, spring, _) => spring.key(),
            Self::Energy => return None,
        })
    }

    /// The same along another direction; none for a word that is not one of [`Self::directions`].
    pub fn turned(&self, word: &str) -> Option<Self> {
        Some(match self {
            Self::Motion(target, measure) => Self::Motion(target.turned(word)?, *measure),
            Self::Reaction(Reaction::Support(holder, _)) => {
                let motion = BeamMotion::of_word(word)?;
                Self::Reaction(Reaction::Support(holder.clone(), motion))
            }
            Self::Reaction(Reaction::Ground(_)) => {
                Self::Reaction(Reaction::Ground(Across::of_word(word)?))
            }
            Self::InternalForce(place, _) => {
                Self::InternalForce(*place, BeamMotion::of_word(word)?)
            }
            Self::Spring(name, _, measure) => {
                Self::Spring(name.clone(), SpringName::of_word(word)?, *measure)
            }
            Self::Energy => return None,
        })
    }

    /// Whether it is real and goes with the square of the loads.
    pub const fn is_quadratic(&self) -> bool {
        matches!(self, Self::Energy)
    }

    /// Whether it has a value under loads at rest: a displacement, a stretch or a force.
    pub const fn is_static(&self) -> bool {
        match self {
            Self::Motion(_, measure) => matches!(measure, Measure::Displacement),
            Self::Reaction(_) | Self::InternalForce(..) | Self::Spring(..) => true,
            Self::Energy => false,
        }
    }

    /// What its complex amplitude is of; none for an energy.
    const fn amount(&self) -> Option<Amount> {
        Some(match self {
            Self::Motion(target, measure) => Amount::Motion(Moves::along(target.load()), *measure),
            Self::Reaction(Reaction::Support(_, motion)) | Self::InternalForce(_, motion) => {
                Amount::Load(motion.load())
            }
            Self::Reaction(Reaction::Ground(_)) | Self::Spring(_, _, SpringMeasure::Force) => {
                Amount::Load(Load::Force)
            }
            Self::Spring(_, _, SpringMeasure::Stretch) => {
                Amount::Motion(Moves::Length, Measure::Displacement)
            }
            Self::Energy => return None,
        })
    }

    /// The motion of the beam to which its direction corresponds.
    fn motion(&self) -> Option<BeamMotion> {
        Some(match self {
            Self::Motion(target, _) => target.beam_motion(),
            Self::Reaction(Reaction::Support(_, motion)) | Self::InternalForce(_, motion) => {
                *motion
            }
            Self::Reaction(Reaction::Ground(across)) => (*across).into(),
            Self::Spring(_, SpringName::YLeft | SpringName::YRight, _) => BeamMotion::W,
            Self::Spring(_, SpringName::ZLeft | SpringName::ZRight, _) => BeamMotion::V,
            Self::Energy => return None,
        })
    }

    fn across(&self) -> Across {
        match self.motion() {
            Some(BeamMotion::V | BeamMotion::VSlope) => Across::V,
            _ => Across::W,
        }
    }
}

impl Holder {
    /// Its name in a file.
    pub fn name(&self) -> &str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Inner(name) => name,
        }
    }

    fn at(&self) -> At<'_> {
        match self {
            Self::Left => At::Beam(Place::Left),
            Self::Right => At::Beam(Place::Right),
            Self::Inner(name) => At::Support(name),
        }
    }

    fn of(at: At<'_>) -> Option<Self> {
        match at {
            At::Beam(Place::Left) => Some(Self::Left),
            At::Beam(Place::Right) => Some(Self::Right),
            At::Support(name) => Some(Self::Inner(name.to_owned())),
            At::Beam(Place::Position(_)) | At::Subsystem(_) | At::Ground => None,
        }
    }
}

impl SpringName {
    /// The left spring along a motion of the beam.
    const fn along(motion: BeamMotion) -> Self {
        match motion {
            BeamMotion::V | BeamMotion::VSlope => Self::ZLeft,
            BeamMotion::W | BeamMotion::WSlope | BeamMotion::Psi | BeamMotion::PsiSlope => {
                Self::YLeft
            }
        }
    }
}

impl Target {
    /// The same elsewhere, with the motion that corresponds; none where neither the beam nor a mass moves.
    pub fn moved(&self, at: At<'_>) -> Option<Self> {
        match at {
            At::Beam(place) => Some(Self::Beam(place, self.beam_motion())),
            At::Subsystem(name) => Some(Self::Mass(name.to_owned(), self.mass_motion())),
            At::Support(_) | At::Ground => None,
        }
    }

    /// The same along another direction; none for a word that is not one of [`Self::directions`].
    pub fn turned(&self, word: &str) -> Option<Self> {
        match self {
            Self::Beam(place, _) => Some(Self::Beam(*place, BeamMotion::of_word(word)?)),
            Self::Mass(name, _) => Some(Self::Mass(name.clone(), MassMotion::of_word(word)?)),
        }
    }

    /// The beam motion, or the one that corresponds to its mass motion.
    const fn beam_motion(&self) -> BeamMotion {
        match self {
            Self::Beam(_, motion) => *motion,
            Self::Mass(_, MassMotion::Y) => BeamMotion::W,
            Self::Mass(_, MassMotion::Z) => BeamMotion::V,
            Self::Mass(_, MassMotion::Theta) => BeamMotion::Psi,
        }
    }

    /// The mass motion, or the one that corresponds to its beam motion.
    const fn mass_motion(&self) -> MassMotion {
        match self {
            Self::Mass(_, motion) => *motion,
            Self::Beam(_, BeamMotion::W | BeamMotion::WSlope) => MassMotion::Y,
            Self::Beam(_, BeamMotion::V | BeamMotion::VSlope) => MassMotion::Z,
            Self::Beam(_, BeamMotion::Psi | BeamMotion::PsiSlope) => MassMotion::Theta,
        }
    }
}
