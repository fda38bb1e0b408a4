//! The rows of the key table, and their commands: each row defines a command.

use crossterm::event::KeyCode::{
    BackTab, Backspace, Delete, Down, End, Enter, Esc, F, Home, Insert, Left, PageDown, PageUp,
    Right, Tab, Up,
};

use super::Hint::{Always, Choice, Group, Item, List, Never, Number, Table, Value};
use super::{Binding, Key, Movement, Scope, Section, control, key, shifted, special};

/// The whole table. A section is an enum of commands, a scope, a title and rows of movement; each other row has a
/// command, a name, keys, a hint, and a help line, which documents the command.
macro_rules! key_table {
    ($(
        $(#[$doc:meta])*
        $group:ident($commands:ident) in $scope:ident, $title:literal, $moves:expr => {
            $($command:ident $name:literal $keys:expr, $hint:expr, $help:literal;)*
        }
    )*) => {
        /// The command of a key.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Command {
            /// Move in the rows of the active dialog, table or tree.
            Move(Movement),
            $($(#[$doc])* $group($commands),)*
        }

        $(
            $(#[$doc])*
            #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
            pub enum $commands {
                $(#[doc = $help] $command,)*
            }

            impl From<$commands> for Command {
                fn from(command: $commands) -> Self {
                    Self::$group(command)
                }
            }
        )*

        /// Every binding, in the order of help.
        pub const SECTIONS: &[Section] = &[$(Section {
            title: $title,
            scope: Scope::$scope,
            moves: $moves,
            bindings: &[$(Binding {
                name: $name,
                keys: &$keys,
                command: Command::$group($commands::$command),
                hint: $hint,
                help: $help,
            },)*],
        },)*];
    };
}

/// Rows of movement: a movement, its keys, a hint and a help line.
macro_rules! moves {
    ($($movement:ident $keys:expr, $hint:expr, $help:expr;)*) => {
        &[$(Binding {
            name: Movement::$movement.name(),
            keys: &$keys,
            command: Command::Move(Movement::$movement),
            hint: $hint,
            help: $help,
        },)*]
    };
}

/// The rows of movement in a list: the name of its rows, and optionally hint and help of the key down.
macro_rules! list {
    ($row:literal) => {
        list!($row, Never, concat!($row, " below"))
    };
    ($row:literal, $hint:expr, $below:expr) => {
        moves! {
            Up UP, Never, concat!($row, " above");
            Down DOWN, $hint, $below;
            PageUp PAGE_UP, Never, "one screen up";
            PageDown PAGE_DOWN, Never, "one screen down";
            First FIRST, Never, concat!("first ", $row);
            Last LAST, Never, concat!("last ", $row);
        }
    };
}

const UP: [Key; 2] = [special(Up), key('k')];
const DOWN: [Key; 2] = [special(Down), key('j')];
const PAGE_UP: [Key; 2] = [special(PageUp), control('u')];
const PAGE_DOWN: [Key; 2] = [special(PageDown), control('d')];
const FIRST: [Key; 2] = [special(Home), key('g')];
const LAST: [Key; 2] = [special(End), key('G')];
/// Up and down while typing.
const LINE_UP: [Key; 3] = [special(Up), control('p'), special(BackTab)];
const LINE_DOWN: [Key; 3] = [special(Down), control('n'), special(Tab)];

key_table! {
    /// Move in the tree, and open and close its groups.
    Tree(TreeCommand) in Main, "Move in the model", list!("row") => {
        Expand "expand" [special(Right), key('l')], Group("open"), "open the group, or go into it";
        Collapse "collapse" [special(Left), key('h')], Never, "close the group, or go to its parent";
        ExpandAll "expand-all" [key('E')], Never, "open every group, except the springs of free motions";
        CollapseAll "collapse-all" [key('C')], Never, "close every group";
        NextParameter "next-parameter" [special(Tab)], Group("next value"), "next parameter, opening the group that holds it";
        PreviousParameter "previous-parameter" [special(BackTab)], Never, "previous parameter";
        NextAlike "next-alike" [key('n')], Never, "same parameter of the next subsystem, support, force or response; after a search the next match";
        PreviousAlike "previous-alike" [key('N')], Never, "same parameter of the previous one; after a search the previous match";
        Search "search" [key('/')], Group("search"), "search the tree";
    }

    /// Change the model.
    Model(ModelCommand) in Main, "Change the model", &[] => {
        Edit "edit" [special(Enter)], Value("edit"), "type a value (4e7, 40M, 40 MN/m, *1.1, /2, +5%), next choice, or open and close";
        NudgeUp "nudge-up" [key('+'), key('=')], Number("1 % more"), "1 % more";
        NudgeDown "nudge-down" [key('-')], Number("less"), "1 % less";
        NudgeUpCoarse "nudge-up-coarse" [key('>')], Number("10 % more"), "10 % more";
        NudgeDownCoarse "nudge-down-coarse" [key('<')], Number("less"), "10 % less";
        NudgeUpFine "nudge-up-fine" [key('.')], Never, "0.1 % more";
        NudgeDownFine "nudge-down-fine" [key(',')], Never, "0.1 % less";
        Cycle "cycle" [key(' ')], Choice("next choice"), "next choice (support, spacing, measure, direction, place), or open and close";
        Repeat "repeat" [key(';')], Never, "repeat the last change (also a typed one) on the selected row";
        Revert "revert" [special(Backspace)], Never, "restore the file's value";
        Add "add" [key('a')], List("add"), "add a span, support, joint, subsystem, force or response";
        AddBranch "add-branch" [special(Insert)], Never, "add a Maxwell branch, a spring and a damper in series, to the spring of the row";
        Duplicate "duplicate" [key('D')], Item("duplicate"), "duplicate the inner support, joint, subsystem, force or response, or divide the span";
        Rename "rename" [key('r')], Item("rename"), "rename the inner support, subsystem, response or study";
        Enable "enable" [key('e')], Item("on/off"), "enable or disable the subsystem, force or response";
        Delete "delete" [key('x'), special(Delete)], Item("delete"), "delete the span, inner support, joint, subsystem, force, response or study";
        Undo "undo" [key('u')], Always("undo"), "undo";
        Redo "redo" [key('U'), control('r')], Never, "redo";
    }

    /// Choose what the chart shows: curves, frequencies and levels.
    Curves(CurvesCommand) in Main, "Curves", &[] => {
        Show "show" [key('v')], Item("show"), "show or hide the response's curve";
        Solo "solo" [key('V')], Never, "show only this response; again: all of its unit";
        Freeze "freeze" [key('f')], Always("freeze"), "freeze the curves as a reference, dotted";
        Unfreeze "unfreeze" [key('F')], Never, "remove the newest reference";
        Study "study" [key('t')], Always("study"), "next study, or none";
        ZoomIn "zoom-in" [key('z')], Never, "halve the frequency range, about the cursor";
        ZoomOut "zoom-out" [key('Z')], Never, "double the frequency range";
        ZoomWhole "zoom-whole" [key('W')], Never, "the whole sweep, automatic levels";
        PanUp "pan-up" [key('K'), shifted(Right)], Never, "higher frequencies, by a quarter of the range";
        PanDown "pan-down" [key('J'), shifted(Left)], Never, "lower frequencies";
        LogFrequency "log-frequency" [key('L')], Never, "frequency axis logarithmic or linear";
        LevelIn "level-in" [key('*')], Never, "halve the range of levels, about the middle, and fix it";
        LevelOut "level-out" [key('&')], Never, "double the range of levels";
        LevelUp "level-up" [shifted(Up)], Never, "higher levels, by a quarter of the range";
        LevelDown "level-down" [shifted(Down)], Never, "lower levels";
        LevelFix "level-fix" [key('!')], Never, "fix the levels, or let them follow the curves";
    }

    /// Read values off the chart: views, units and cursors.
    Reading(ReadingCommand) in Main, "Read the curves", &[] => {
        NextView "next-view" [key('b')], Never, "next view: magnitude, with phase, real and imaginary, Nyquist, difference to the reference";
        NextForm "next-form" [key('i')], Never, "next form: the model's, receptance, mobility, accelerance, their inverses, motion under the actual forces";
        PreviousForm "previous-form" [key('I')], Never, "previous form";
        Decibels "decibels" [key('d')], Never, "magnitude in powers of ten or in decibels";
        DecibelReference "decibel-reference" [key('%')], Never, "type the value of 0 dB";
        FrequencyUnit "frequency-unit" [key('#')], Never, "frequencies in Hz, rad/s or rpm";
        Unwrap "unwrap" [key('\'')], Never, "unwrap the phase, or wrap it to half a turn";
        CursorRight "cursor-right" [key(']')], Never, "cursor a column to the right";
        CursorLeft "cursor-left" [key('[')], Never, "cursor a column to the left";
        CursorOff "cursor-off" [special(Esc)], Never, "cancel a typed count, end a search, or remove the cursor";
        NextPeak "next-peak" [key('}')], Never, "cursor to the next peak of the first curve";
        PreviousPeak "previous-peak" [key('{')], Never, "cursor to the previous peak";
        NextDip "next-dip" [key('\\')], Never, "cursor to the next anti-resonance of the first curve";
        PreviousDip "previous-dip" [key('|')], Never, "cursor to the previous anti-resonance";
        GoTo "go-to" [key('@')], Never, "cursor to a typed frequency";
        Readings "readings" [key('"')], Never, "table of the values at the cursors, or close it";
        SecondCursor "second-cursor" [key('c')], Never, "second cursor here, the reference of differences; again: remove it";
        Harmonics "harmonics" [key('H')], Never, "mark the harmonics of the cursor; again: remove the marks";
        Band "band" [key('_')], Never, "mark the band between the cursors, or the visible one, and list its levels; again: remove it";
    }

    /// Compare with references and measured curves, and export.
    Compare(CompareCommand) in Main, "Compare", &[] => {
        List "beside" [key('Q')], Never, "references and measured curves: show, rename, remove, load";
        AddMeasured "add-measured" [control('o')], Never, "open a measured curve: CSV or universal file (UFF 58)";
        MakeStudy "make-study" [control('t')], Never, "sweep the selected parameter: a study of it with typed factors or values";
        Export "export" [control('e')], Never, "export the screen: .csv, .svg or .txt";
    }

    /// Views of the beam: its motion and its drawing.
    BeamView(BeamViewCommand) in Main, "Look at the beam", &[] => {
        Operating "operating" [key('O')], Never, "operating deflection at the cursor, then internal forces, then power; again: close";
        PhaseStep "phase-step" [key('`')], Never, "step the animation through its period";
        Structure "structure" [key('B')], Never, "drawing of the beam, then of its cross-section; again: close";
    }

    /// Modes, peaks and finite elements.
    Modes(ModesCommand) in Main, "Modes, peaks and finite elements", &[] => {
        ModeTable "mode-table" [key('m')], Always("modes"), "table of modes, or close it";
        PeakTable "peak-table" [key('P')], Table("peaks"), "table of the first curve's peaks, or close it";
        NextMode "next-mode" [key(')')], Never, "select the next mode; the cursor goes to it";
        PreviousMode "previous-mode" [key('(')], Never, "select the previous mode";
        Shape "shape" [key('M')], Table("shape"), "shape of the selected mode, or hide it";
        Animate "animate" [key('A')], Table("animate"), "start or stop the animation";
        FiniteElements "finite-elements" [key('w')], Never, "finite-element curves as points over the exact ones, or hide them";
    }

    /// Sensitivities and the search for better parameters.
    Tune(TuneCommand) in Main, "Tune", &[] => {
        Sensitivities "sensitivities" [key('~')], Table("sensitivities"), "sensitivities: bars and a table for the cursor, then the peak, the mode, the band; again: close";
        TuneVariable "tune-variable" [key('$')], Never, "let a search change the selected parameter, within typed bounds; again: fix it";
        TuneObjective "tune-objective" [key('^')], Never, "set the objective of the first curve in the marked band, or in the visible one";
        Tune "tune" [control('g')], Never, "search; again: pause, continue; a count before it limits the evaluations";
        TuneAccept "tune-accept" [control('y')], Never, "apply the best so far to the model, as one step";
        TuneDiscard "tune-discard" [control('x')], Never, "discard the search and its result";
        Tolerances "tolerances" [control('k')], Never, "band of nine of ten curves when the variables vary within their tolerances, or hide it";
    }

    /// Files and the program.
    File(FileCommand) in Main, "Files and program", &[] => {
        Save "save" [key('s'), control('s')], Always("save"), "save";
        SaveAs "save-as" [key('S')], Never, "save to another file";
        Reload "reload" [key('R')], Never, "reload the file; asks if there are unsaved changes";
        Open "open" [key('o')], Never, "open a file";
        Presets "presets" [key('p')], Always("presets"), "choose a preset";
        Palette "palette" [key(':')], Always("commands"), "search every command and every parameter";
        CopyValue "copy-value" [key('y')], Never, "copy the value to the terminal's clipboard (OSC 52)";
        CopyModel "copy-model" [key('Y')], Never, "copy the model's text to the terminal's clipboard";
        Theme "theme" [key('T')], Never, "next theme: the terminal's colours, for a dark background, for a light one, none";
        Mouse "mouse" [key('X')], Never, "capture the mouse, or leave it to the terminal (to select text)";
        Help "help" [key('?'), special(F(1))], Always("help"), "this help";
        Guide "guide" [], Never, "read a chapter of the guide";
        Quit "quit" [key('q')], Always("quit"), "quit; asks if there are unsaved changes";
    }

    /// In every scope.
    Anywhere(AnywhereCommand) in Any, "Everywhere", &[] => {
        Redraw "redraw" [control('l')], Never, "redraw the screen";
        Suspend "suspend" [control('z')], Never, "suspend; `fg` in the shell continues";
        End "end" [control('c')], Never, "quit; asks if there are unsaved changes";
    }

    /// In a table below the chart.
    Table(TableCommand) in Table, "In a table below the chart (all other keys as usual)", list!("row", Always("next row"), "row below; the cursor goes to it") => {
        Close "close" [special(Esc)], Always("close"), "close the table";
    }

    /// In a prompt.
    Prompt(PromptCommand) in Prompt, "While typing", &[] => {
        Accept "accept" [special(Enter)], Always("accept"), "accept the typed text";
        Cancel "cancel" [special(Esc)], Always("cancel"), "close the dialog without changes";
        Complete "complete" [special(Tab)], Never, "complete a file's path";
    }

    /// In the palette.
    Palette(PaletteCommand) in Palette, "In the palette", moves! {
        Up LINE_UP, Never, "entry above";
        Down LINE_DOWN, Always("next"), "entry below";
        PageUp [special(PageUp)], Never, "one screen up";
        PageDown [special(PageDown)], Never, "one screen down";
    } => {
        Accept "accept" [special(Enter)], Always("run or edit it"), "run the command, or go to the parameter and edit it";
        Cancel "cancel" [special(Esc)], Always("close"), "close the palette";
    }

    /// While the tree is searched.
    Search(SearchCommand) in Search, "While searching the tree", moves! {
        Up LINE_UP, Never, "match above";
        Down LINE_DOWN, Always("next"), "match below";
    } => {
        Accept "accept" [special(Enter)], Always("stay there"), "stay on the row";
        Cancel "cancel" [special(Esc)], Always("go back"), "go back to the row where the search began";
    }

    /// In the list of presets.
    Picker(PickerCommand) in Picker, "List of presets", list!("preset") => {
        Accept "accept" [special(Enter)], Always("open"), "open the preset";
        Cancel "cancel" [special(Esc), key('q'), key('p')], Always("close"), "close the list";
    }

    /// In the list of references and measured curves.
    Comparison(ComparisonCommand) in Comparison, "References and measured curves", list!("entry") => {
        Accept "accept" [special(Enter)], Always("show or hide"), "show it, or hide it";
        AddReference "add-reference" [key('a')], Always("load a model"), "load a model as a reference";
        AddMeasured "add-measured" [key('m')], Always("load a measured curve"), "load a measured curve";
        Rename "rename" [key('r')], Always("rename"), "rename it";
        Delete "delete" [key('x'), special(Delete)], Always("remove"), "remove it";
        Cancel "cancel" [special(Esc), key('q'), key('Q')], Always("close"), "close the list";
    }

    /// In help and lists of faults.
    Reader(ReaderCommand) in Reader, "Help and lists of faults", moves! {
        Up UP, Never, "one line up";
        Down DOWN, Always("scroll"), "one line down";
        PageUp PAGE_UP, Never, "one screen up";
        PageDown [special(PageDown), control('d'), key(' ')], Always("page"), "one screen down";
        First FIRST, Never, "the top";
        Last LAST, Never, "the end";
    } => {
        Cancel "cancel" [special(Esc), key('q'), key('?'), special(Enter)], Always("close"), "close";
    }

    /// In the confirmation about unsaved changes.
    Unsaved(UnsavedCommand) in Unsaved, "Confirm: unsaved changes", &[] => {
        Save "save" [key('s'), key('y')], Always("save first"), "save, then continue";
        Discard "discard" [key('d'), key('n')], Always("discard the changes"), "continue without saving";
        Cancel "cancel" [special(Esc)], Always("cancel"), "cancel; nothing changes";
    }

    /// In the confirmation before a file is replaced.
    Replace(ReplaceCommand) in Replace, "Confirm: replace a file", &[] => {
        Replace "replace" [key('y')], Always("replace it"), "replace the file";
        Cancel "cancel" [special(Esc), key('n')], Always("keep it"), "keep the file; nothing is saved";
    }

    /// In the list of recovered changes.
    Recovery(RecoveryCommand) in Recovery, "Recover unsaved changes", moves! {
        Up UP, Never, "changes above";
        Down DOWN, Never, "changes below";
    } => {
        Accept "accept" [special(Enter)], Always("recover"), "recover the changes";
        Discard "discard" [key('x'), key('d'), special(Delete)], Always("discard"), "delete the changes";
        Cancel "cancel" [special(Esc), key('q')], Always("later"), "leave them for the next start";
    }
}
