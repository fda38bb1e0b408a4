//! The key table. Dispatch, the hint line, help, the palette, the table in the guide and the man page all use it.
//!
//! The rows are in [`SECTIONS`]; [`KeyMap`] is the table with the user's key bindings.

mod command;
mod key;
mod map;
mod table;

pub use command::Movement;
pub use key::Key;
pub use map::{Conflict, KeyMap, names};
pub use table::{
    AnywhereCommand, BeamViewCommand, Command, CompareCommand, ComparisonCommand, CurvesCommand,
    FileCommand, ModelCommand, ModesCommand, PaletteCommand, PickerCommand, PromptCommand,
    ReaderCommand, ReadingCommand, RecoveryCommand, ReplaceCommand, SECTIONS, SearchCommand,
    TableCommand, TreeCommand, TuneCommand, UnsavedCommand,
};

use key::{control, key, shifted, special};

/// Where a binding applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scope {
    /// The tree and the chart.
    Main,
    /// A table below the chart; other keys are those of the tree and the chart.
    Table,
    /// A prompt for a value, a name or a path.
    Prompt,
    /// The palette.
    Palette,
    /// The search of the tree.
    Search,
    /// The list of presets.
    Picker,
    /// The list of references and measured curves.
    Comparison,
    /// Help and lists of faults.
    Reader,
    /// The confirmation about unsaved changes.
    Unsaved,
    /// The confirmation before a file is replaced.
    Replace,
    /// The list of recovered changes.
    Recovery,
    /// Everywhere, after the scope's own keys.
    Any,
}

impl Scope {
    /// Every scope.
    pub const ALL: [Self; 12] = [
        Self::Main,
        Self::Table,
        Self::Prompt,
        Self::Palette,
        Self::Search,
        Self::Picker,
        Self::Comparison,
        Self::Reader,
        Self::Unsaved,
        Self::Replace,
        Self::Recovery,
        Self::Any,
    ];

    /// Its table in the configuration file, below `keys`.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Main => "model",
            Self::Table => "table",
            Self::Prompt => "typing",
            Self::Palette => "palette",
            Self::Search => "search",
            Self::Picker => "presets",
            Self::Comparison => "beside",
            Self::Reader => "reader",
            Self::Unsaved => "unsaved",
            Self::Replace => "replace",
            Self::Recovery => "recovery",
            Self::Any => "everywhere",
        }
    }

    /// Whether characters are typed there.
    pub const fn is_typing(self) -> bool {
        matches!(self, Self::Prompt | Self::Palette | Self::Search)
    }
}

/// When the hint of a binding is on the last line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hint {
    /// Never; only in help.
    Never,
    /// On every row.
    Always(&'static str),
    /// On a number or a text.
    Value(&'static str),
    /// On a number.
    Number(&'static str),
    /// On a choice.
    Choice(&'static str),
    /// On a subsystem, force or response.
    Item(&'static str),
    /// On a list to which something can be added.
    List(&'static str),
    /// On a list or another group.
    Group(&'static str),
    /// While a table is open.
    Table(&'static str),
}

/// The kind of the selected row, for the hints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowKind {
    /// A number.
    Number,
    /// A name or a place.
    Text,
    /// One of several words.
    Choice,
    /// A subsystem, force or response.
    Item,
    /// All subsystems, forces or responses.
    List,
    /// Anything else that opens and closes.
    Group,
}

impl Hint {
    fn text_on(self, kind: RowKind) -> Option<&'static str> {
        match (self, kind) {
            (Self::Always(text), _)
            | (Self::Value(text), RowKind::Number | RowKind::Text)
            | (Self::Number(text), RowKind::Number)
            | (Self::Choice(text), RowKind::Choice)
            | (Self::Item(text), RowKind::Item)
            | (Self::List(text), RowKind::List)
            | (Self::Group(text), RowKind::Group | RowKind::List) => Some(text),
            _ => None,
        }
    }
}

/// A row of the table.
#[derive(Debug)]
pub struct Binding {
    /// The command's name in the configuration file and the palette; unique in its scope.
    pub name: &'static str,
    /// The default keys; the first one is in hints.
    pub keys: &'static [Key],
    /// The command.
    pub command: Command,
    /// The hint on the last line.
    pub hint: Hint,
    /// The help line.
    pub help: &'static str,
}

/// A group of bindings.
#[derive(Debug)]
pub struct Section {
    /// Heading in help.
    pub title: &'static str,
    /// Where the keys apply.
    pub scope: Scope,
    /// The rows of movement, which come first.
    moves: &'static [Binding],
    /// The other rows.
    bindings: &'static [Binding],
}

impl Section {
    /// The rows, in the order of help and hints.
    pub fn rows(&self) -> impl Iterator<Item = &'static Binding> + use<> {
        self.moves.iter().chain(self.bindings)
    }
}
