//! What a row of the tree is.

use crate::model::{BeamMotion, Model, Support};

/// An end of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum End {
    /// x = 0.
    Left,
    /// x = L.
    Right,
}

impl End {
    /// The word of the model file.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }

    /// What the model has at this end.
    pub const fn support(self, model: &Model) -> &Support {
        match self {
            Self::Left => &model.supports.left,
            Self::Right => &model.supports.right,
        }
    }
}

/// A row of the tree. Numbers count from 0 in the model's lists and in the tables of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Node {
    /// The model's title.
    Title,
    /// The beam.
    Beam,
    /// A number of the beam itself.
    BeamNumber(usize),
    /// The beam's material.
    Material,
    /// A number of the material.
    MaterialNumber(usize),
    /// The beam's section.
    Section,
    /// A number of the section.
    SectionNumber(usize),
    /// Both supports.
    Supports,
    /// One end's support.
    Support(End),
    /// What a motion of an end meets.
    Motion(End, BeamMotion),
    /// A number of an end's spring.
    MotionNumber(End, BeamMotion, usize),
    /// All subsystems.
    Subsystems,
    /// One subsystem.
    Subsystem(usize),
    /// A number of a subsystem.
    SubsystemNumber(usize, usize),
    /// All forces.
    Forces,
    /// One force.
    Force(usize),
    /// Where a force acts.
    ForceAt(usize),
    /// Along what a force acts.
    ForceDirection(usize),
    /// A number of a force.
    ForceNumber(usize, usize),
    /// All responses.
    Responses,
    /// One response.
    Response(usize),
    /// Motion's time derivative, or energy.
    ResponseMeasure(usize),
    /// Where a response is taken.
    ResponseAt(usize),
    /// Along what a response is taken.
    ResponseDirection(usize),
    /// The frequencies.
    Sweep,
    /// A number of the sweep.
    SweepNumber(usize),
    /// How many frequencies.
    SweepPoints,
    /// How the frequencies are spread.
    SweepSpacing,
    /// All studies.
    Studies,
    /// One study.
    Study(usize),
    /// A line of a study: a path or a case.
    StudyLine(usize, usize),
    /// What an optimiser may move.
    Tune,
    /// One of its variables.
    TuneVariable(usize),
    /// One of the things it seeks.
    TuneObjective(usize),
    /// One of its limits.
    TuneLimit(usize),
}
