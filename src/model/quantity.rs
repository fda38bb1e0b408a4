//! What a response is: where it is read, along what, its words in a file and the dimension of its values.

use super::beam::{BeamMotion, Point};
use super::types::{At, Place, Target};
use crate::unit::{Dimension, Kind, Load, Measure, Moves};

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
}

impl Response {
    /// Whether it is another one at another point of the section.
    pub fn has_point(&self) -> bool {
        self.quantity.target().is_some_and(Target::has_point)
    }
}

/// The quantity of a response.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A motion, complex.
    Motion(Target, Measure),
    /// The vibration energy `E_V` of the whole beam (Chen & Liu 2022, Section 4.2), real, kg m2.
    Energy,
}

impl Quantity {
    /// The word for an energy among the measures.
    pub const ENERGY: &'static str = "energy";

    /// What becomes a motion without having a position.
    const DEFAULT: Target = Target::Beam(Place::Right, BeamMotion::W);

    /// The words of all measures.
    pub fn words() -> Vec<&'static str> {
        [Measure::WORDS, &[Self::ENERGY]].concat()
    }

    /// The word of its measure.
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Motion(_, measure) => measure.key(),
            Self::Energy => Self::ENERGY,
        }
    }

    /// The same with another measure; none for a word that is no measure. An energy that becomes a motion is w at the right
    /// end.
    pub fn of_word(&self, word: &str) -> Option<Self> {
        if word == Self::ENERGY {
            return Some(Self::Energy);
        }
        let target = self.target().cloned().unwrap_or(Self::DEFAULT);
        Some(Self::Motion(target, Measure::of_word(word)?))
    }

    /// What moves; none for what is no motion.
    pub const fn target(&self) -> Option<&Target> {
        match self {
            Self::Motion(target, _) => Some(target),
            Self::Energy => None,
        }
    }

    /// What moves; none for what is no motion.
    pub const fn target_mut(&mut self) -> Option<&mut Target> {
        match self {
            Self::Motion(target, _) => Some(target),
            Self::Energy => None,
        }
    }

    /// Where it is read; none for what is of the whole beam.
    pub fn at(&self) -> Option<At<'_>> {
        self.target().map(Target::at)
    }

    /// Whether it is real and goes with the square of the loads.
    pub const fn is_quadratic(&self) -> bool {
        matches!(self, Self::Energy)
    }

    /// The dimension of its values divided by a load, or undivided.
    pub const fn kind(&self, per: Option<Load>) -> Kind {
        match self {
            Self::Motion(target, measure) => Kind::Motion(Dimension {
                moves: Moves::along(target.load()),
                measure: *measure,
                per,
            }),
            Self::Energy => Kind::Energy,
        }
    }
}
