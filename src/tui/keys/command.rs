//! Properties of commands.

use super::{
    BeamViewCommand, Command, CurvesCommand, ModelCommand, ModesCommand, ReadingCommand,
    TreeCommand,
};

/// A movement in rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Movement {
    /// One row up.
    Up,
    /// One row down.
    Down,
    /// One screen up.
    PageUp,
    /// One screen down.
    PageDown,
    /// The first row.
    First,
    /// The last row.
    Last,
}

impl Movement {
    /// Its name in the key table.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Up => "up",
            Self::Down => "down",
            Self::PageUp => "page-up",
            Self::PageDown => "page-down",
            Self::First => "first",
            Self::Last => "last",
        }
    }

    /// The message if it changes nothing.
    pub const fn at_end(self) -> &'static str {
        if self.is_forward() {
            "this is the last row"
        } else {
            "this is the first row"
        }
    }

    /// Whether it goes towards the last row.
    pub const fn is_forward(self) -> bool {
        matches!(self, Self::Down | Self::PageDown | Self::Last)
    }
}

impl Command {
    /// Whether a count repeats it.
    pub const fn counts(self) -> bool {
        match self {
            Self::Move(movement) => !matches!(movement, Movement::First | Movement::Last),
            Self::Tree(command) => matches!(
                command,
                TreeCommand::NextParameter
                    | TreeCommand::PreviousParameter
                    | TreeCommand::NextAlike
                    | TreeCommand::PreviousAlike
            ),
            Self::Model(command) => {
                command.is_nudge()
                    || matches!(
                        command,
                        ModelCommand::Cycle
                            | ModelCommand::Repeat
                            | ModelCommand::Undo
                            | ModelCommand::Redo
                            | ModelCommand::Add
                            | ModelCommand::Duplicate
                            | ModelCommand::Delete
                    )
            }
            Self::Curves(command) => matches!(
                command,
                CurvesCommand::Unfreeze
                    | CurvesCommand::Study
                    | CurvesCommand::ZoomIn
                    | CurvesCommand::ZoomOut
                    | CurvesCommand::PanUp
                    | CurvesCommand::PanDown
                    | CurvesCommand::LevelIn
                    | CurvesCommand::LevelOut
                    | CurvesCommand::LevelUp
                    | CurvesCommand::LevelDown
            ),
            Self::Reading(command) => matches!(
                command,
                ReadingCommand::NextView
                    | ReadingCommand::NextForm
                    | ReadingCommand::PreviousForm
                    | ReadingCommand::CursorRight
                    | ReadingCommand::CursorLeft
                    | ReadingCommand::NextPeak
                    | ReadingCommand::PreviousPeak
                    | ReadingCommand::NextDip
                    | ReadingCommand::PreviousDip
            ),
            Self::BeamView(command) => matches!(command, BeamViewCommand::PhaseStep),
            Self::Modes(command) => {
                matches!(command, ModesCommand::NextMode | ModesCommand::PreviousMode)
            }
            _ => false,
        }
    }

    /// Whether it takes a count as one step instead of repeating.
    pub const fn takes_count(self) -> bool {
        match self {
            Self::Tree(command) => matches!(
                command,
                TreeCommand::NextParameter | TreeCommand::PreviousParameter
            ),
            Self::Model(command) => command.is_nudge(),
            _ => false,
        }
    }

    /// Whether it changes the model and can be repeated on another row.
    pub const fn repeats(self) -> bool {
        match self {
            Self::Model(command) => {
                command.is_nudge()
                    || matches!(
                        command,
                        ModelCommand::Cycle
                            | ModelCommand::Revert
                            | ModelCommand::Add
                            | ModelCommand::AddBranch
                            | ModelCommand::Duplicate
                            | ModelCommand::Delete
                            | ModelCommand::Enable
                    )
            }
            _ => false,
        }
    }
}

impl ModelCommand {
    const fn is_nudge(self) -> bool {
        matches!(
            self,
            Self::NudgeUp
                | Self::NudgeDown
                | Self::NudgeUpCoarse
                | Self::NudgeDownCoarse
                | Self::NudgeUpFine
                | Self::NudgeDownFine
        )
    }
}
