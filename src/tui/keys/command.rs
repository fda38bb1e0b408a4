//! What a key can ask for.

/// What a key asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Command {
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
    /// Close the group, or go to the group that holds the row.
    Collapse,
    /// Open the group, or go to its first row.
    Expand,
    /// Open every group.
    ExpandAll,
    /// Close every group.
    CollapseAll,
    /// The next parameter of the model, opening what holds it.
    NextParameter,
    /// The parameter before.
    PreviousParameter,
    /// The same parameter of the next subsystem, force, response or support.
    NextAlike,
    /// The same parameter of the one before.
    PreviousAlike,
    /// Edit the value, cycle the choice, or open and close the group.
    Edit,
    /// Cycle the choice, or open and close the group.
    Cycle,
    /// Change a number by this many thousandths of itself.
    Nudge(i32),
    /// Do the last change again, on the selected row.
    Repeat,
    /// Put the file's value back.
    Revert,
    /// Take the last step back.
    Undo,
    /// Take an undone step again.
    Redo,
    /// Add a subsystem, force or response.
    Add,
    /// Add a copy of the selected one.
    Duplicate,
    /// Give the selected one another name.
    Rename,
    /// Delete the selected one.
    Delete,
    /// Enable or disable the selected one.
    Enable,
    /// Search the tree.
    Search,
    /// Search every command and every parameter.
    Palette,
    /// Show or hide the response's curve.
    Show,
    /// Show this response's curve alone.
    Solo,
    /// The next study, or none.
    Study,
    /// Decibels or powers of ten.
    Decibels,
    /// Logarithmic or linear frequency axis.
    LogFrequency,
    /// Keep the curves as a dotted reference.
    Freeze,
    /// Drop the reference.
    Unfreeze,
    /// Move the cursor on the chart by steps of a two-hundredth of the axis.
    Cursor(i32),
    /// Halve the frequencies that show, about the cursor.
    ZoomIn,
    /// Double the frequencies that show.
    ZoomOut,
    /// Show the whole sweep.
    ZoomWhole,
    /// Show lower (below 0) or higher frequencies, by quarters of those that show.
    Pan(i32),
    /// Move the cursor to the next peak.
    NextPeak,
    /// Move the cursor to the peak before.
    PreviousPeak,
    /// Move the cursor to the next anti-resonance.
    NextDip,
    /// Move the cursor to the anti-resonance before.
    PreviousDip,
    /// Move the cursor to a frequency that is typed.
    GoTo,
    /// Put the second cursor where the cursor is, or take it away.
    SecondCursor,
    /// Mark the harmonics of the cursor.
    Harmonics,
    /// Open or close the table of what is read at the cursors.
    Readings,
    /// Mark the band between the cursors, or take it away.
    Band,
    /// Show which parameter matters for the next figure: cursor, peak, mode, band; or not.
    Sensitivities,
    /// Let a search move the selected parameter, or keep it.
    TuneVariable,
    /// Say what is sought.
    TuneObjective,
    /// Start a search, hold it up, or let it go on.
    Tune,
    /// Put what a search has found into the model.
    TuneAccept,
    /// Drop a search and what it has found.
    TuneDiscard,
    /// Show what tolerances make of the curves, or not.
    Tolerances,
    /// The next of the six forms.
    NextForm,
    /// The form before.
    PreviousForm,
    /// The next view: magnitude, with phase, real and imaginary, Nyquist, difference.
    NextView,
    /// Let the phase run on, or keep it within half a turn.
    Unwrap,
    /// Hz, rad/s or rpm.
    FrequencyUnit,
    /// Type the value of 0 dB.
    DecibelReference,
    /// Halve the levels that show.
    LevelIn,
    /// Double the levels that show.
    LevelOut,
    /// Show lower (below 0) or higher levels, by quarters of those that show.
    LevelPan(i32),
    /// Keep the levels that show, or let them follow the curves.
    LevelFix,
    /// List what stands beside the model: references and measured curves.
    Beside,
    /// Open a model to compare with.
    AddReference,
    /// Open a measured curve.
    AddMeasured,
    /// Make a study of the selected parameter.
    MakeStudy,
    /// Write what is on the screen to a file.
    Export,
    /// Show how the beam moves and what acts in it at the cursor: the next of these, or nothing.
    Operating,
    /// Show the drawing of the structure, then of the cross-section, then nothing.
    Structure,
    /// A step further in the period.
    PhaseStep,
    /// Open or close the table of modes.
    ModeTable,
    /// Open or close the table of peaks.
    PeakTable,
    /// Select the next mode and move the cursor to it.
    NextMode,
    /// Select the mode before and move the cursor to it.
    PreviousMode,
    /// Show or hide the shape of the selected mode.
    Shape,
    /// Let the shape move, or stand still.
    Animate,
    /// Show or hide the finite-element curves.
    Witness,
    /// Save to the file.
    Save,
    /// Save to another file.
    SaveAs,
    /// Open a file.
    Open,
    /// Read the file again.
    Reload,
    /// Choose a preset.
    Presets,
    /// Send the value to the terminal's clipboard.
    CopyValue,
    /// Send the model's text to the terminal's clipboard.
    CopyModel,
    /// The next theme.
    Theme,
    /// Take or leave the mouse.
    Mouse,
    /// Show every key.
    Help,
    /// Choose a chapter of the guide.
    Guide,
    /// Draw the screen anew.
    Redraw,
    /// Stop, until the shell goes on with it.
    Suspend,
    /// End the program.
    Quit,
    /// Take what was typed or chosen.
    Accept,
    /// Close the box, changing nothing.
    Cancel,
    /// Complete the path.
    Complete,
    /// Yes: replace the file.
    Replace,
    /// Drop what is not saved.
    Discard,
}

impl Command {
    /// Whether a count before it does it so many times.
    pub const fn counts(self) -> bool {
        matches!(
            self,
            Self::Up
                | Self::Down
                | Self::PageUp
                | Self::PageDown
                | Self::NextParameter
                | Self::PreviousParameter
                | Self::NextAlike
                | Self::PreviousAlike
                | Self::Nudge(_)
                | Self::Cycle
                | Self::Repeat
                | Self::Undo
                | Self::Redo
                | Self::Add
                | Self::Duplicate
                | Self::Delete
                | Self::Unfreeze
                | Self::NextForm
                | Self::PreviousForm
                | Self::NextView
                | Self::Study
                | Self::ZoomIn
                | Self::ZoomOut
                | Self::Pan(_)
                | Self::NextPeak
                | Self::PreviousPeak
                | Self::NextDip
                | Self::PreviousDip
                | Self::LevelIn
                | Self::LevelOut
                | Self::LevelPan(_)
                | Self::PhaseStep
                | Self::Cursor(_)
                | Self::NextMode
                | Self::PreviousMode
        )
    }

    /// Whether it is a change of the model that can be done again on another row.
    pub const fn repeats(self) -> bool {
        matches!(
            self,
            Self::Nudge(_)
                | Self::Cycle
                | Self::Revert
                | Self::Add
                | Self::Duplicate
                | Self::Delete
                | Self::Enable
        )
    }
}
