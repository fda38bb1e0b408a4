//! The one key table. Dispatch, the hint line, the help screen and the README's table all come from it.

mod boxes;
mod modes;
mod table;

use std::fmt::Write as _;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

pub use table::SECTIONS;

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
    /// Move the cursor to the next peak or dip.
    NextExtremum,
    /// Move the cursor to the peak or dip before.
    PreviousExtremum,
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
    /// Choose a preset.
    Presets,
    /// Show every key.
    Help,
    /// Draw the screen anew.
    Redraw,
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

/// Where a key has its meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scope {
    /// The tree and the chart.
    Main,
    /// A table below the chart; other keys are those of the tree and the chart.
    Table,
    /// A box in which a value, a name or a path is typed.
    Prompt,
    /// The list of presets.
    Picker,
    /// Help and lists of faults.
    Reader,
    /// The question what becomes of unsaved changes.
    Unsaved,
    /// The question whether a file is replaced.
    Replace,
    /// Everywhere, after the scope's own keys.
    Any,
}

/// When a binding's hint is on the last line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hint {
    /// Never; help has it.
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

/// What kind of row is selected, for the hints.
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

/// A key with its Control state; Shift is in the character.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Key {
    /// The key.
    pub code: KeyCode,
    /// Whether Control is held.
    pub control: bool,
}

impl Key {
    fn matches(self, event: &KeyEvent) -> bool {
        let control = event.modifiers.contains(KeyModifiers::CONTROL);
        let alt = event.modifiers.contains(KeyModifiers::ALT);
        self.code == event.code && self.control == control && !alt
    }

    /// The key's name in help and hints.
    pub fn name(self) -> String {
        let name = match self.code {
            KeyCode::Char(' ') => "Space".to_owned(),
            KeyCode::Char(c) => c.to_string(),
            KeyCode::F(n) => format!("F{n}"),
            KeyCode::BackTab => "Shift-Tab".to_owned(),
            KeyCode::PageUp => "PgUp".to_owned(),
            KeyCode::PageDown => "PgDn".to_owned(),
            KeyCode::Delete => "Del".to_owned(),
            other => format!("{other:?}"),
        };
        if self.control {
            format!("Ctrl-{name}")
        } else {
            name
        }
    }
}

const fn key(c: char) -> Key {
    Key {
        code: KeyCode::Char(c),
        control: false,
    }
}

const fn control(c: char) -> Key {
    Key {
        code: KeyCode::Char(c),
        control: true,
    }
}

const fn special(code: KeyCode) -> Key {
    Key {
        code,
        control: false,
    }
}

/// A row of the table.
#[derive(Debug)]
pub struct Binding {
    /// The keys; the first is the one in hints.
    pub keys: &'static [Key],
    /// What they do.
    pub command: Command,
    /// Words on the last line.
    pub hint: Hint,
    /// A line of help.
    pub help: &'static str,
}

const fn bind(keys: &'static [Key], command: Command, hint: Hint, help: &'static str) -> Binding {
    Binding {
        keys,
        command,
        hint,
        help,
    }
}

/// Bindings that belong together.
#[derive(Debug)]
pub struct Section {
    /// Heading in help.
    pub title: &'static str,
    /// Where the keys have their meaning.
    pub scope: Scope,
    /// The bindings, in the order of help and hints.
    pub bindings: &'static [Binding],
}

/// The command of a key in a scope, if it has one there.
pub fn command(scope: Scope, event: &KeyEvent) -> Option<Command> {
    let in_scope = |wanted: Scope| {
        bindings(wanted)
            .find(|binding| binding.keys.iter().any(|key| key.matches(event)))
            .map(|binding| binding.command)
    };
    let beneath = match scope {
        Scope::Table => in_scope(Scope::Main),
        _ => None,
    };
    in_scope(scope).or(beneath).or_else(|| in_scope(Scope::Any))
}

/// The first key of a command, by name; empty where it has none.
pub fn key_of(wanted: Command) -> String {
    SECTIONS
        .iter()
        .flat_map(|section| section.bindings)
        .find(|binding| binding.command == wanted)
        .map(|binding| binding.keys[0].name())
        .unwrap_or_default()
}

/// The hints of a scope on a kind of row, as (key, words): first what the row allows, then help and the rest.
pub fn hints(scope: Scope, row: RowKind) -> Vec<(String, &'static str)> {
    let of_row = |scope| {
        let mut shown: Vec<_> = bindings(scope)
            .filter_map(|binding| Some((binding, binding.hint.text_on(row)?)))
            .collect();
        // What does not fit is cut off at the end, and help leads to it.
        shown.sort_by_key(|(binding, _)| match (binding.hint, binding.command) {
            (Hint::Always(_), Command::Help) => 1,
            (Hint::Always(_), _) => 2,
            _ => 0,
        });
        shown
    };
    let mut shown = of_row(scope);
    if scope == Scope::Table {
        let of_table = |binding: &'static Binding| match binding.hint {
            Hint::Table(text) => Some((binding, text)),
            _ => None,
        };
        shown.extend(bindings(Scope::Main).filter_map(of_table));
        shown.extend(of_row(Scope::Main));
    }
    shown
        .into_iter()
        .map(|(binding, text)| (binding.keys[0].name(), text))
        .collect()
}

/// The key table as GitHub-flavoured Markdown, for the README.
pub fn markdown_table() -> String {
    let mut table = String::from("| Keys | What they do |\n| --- | --- |\n");
    for section in SECTIONS {
        let _ = writeln!(table, "| **{}** | |", section.title);
        for binding in section.bindings {
            let keys: Vec<String> = binding.keys.iter().map(|key| markdown_key(*key)).collect();
            let _ = writeln!(table, "| {} | {} |", keys.join(" "), binding.help);
        }
    }
    table
}

fn markdown_key(key: Key) -> String {
    format!("`{}`", key.name())
}

fn bindings(scope: Scope) -> impl Iterator<Item = &'static Binding> {
    SECTIONS
        .iter()
        .filter(move |section| section.scope == scope)
        .flat_map(|section| section.bindings)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(key: Key) -> KeyEvent {
        let modifiers = if key.control {
            KeyModifiers::CONTROL
        } else {
            KeyModifiers::NONE
        };
        KeyEvent::new(key.code, modifiers)
    }

    #[test]
    fn every_key_reaches_its_command() {
        for section in SECTIONS {
            for binding in section.bindings {
                for key in binding.keys {
                    let found = command(section.scope, &press(*key));
                    assert_eq!(found, Some(binding.command), "{} {key:?}", section.title);
                }
            }
        }
    }

    #[test]
    fn shift_is_in_the_character() {
        let event = KeyEvent::new(KeyCode::Char('U'), KeyModifiers::SHIFT);
        assert_eq!(command(Scope::Main, &event), Some(Command::Redo));
    }

    #[test]
    fn typed_characters_stay_free_in_prompts() {
        for c in (' '..='~').map(key) {
            assert_eq!(command(Scope::Prompt, &press(c)), None);
        }
    }

    #[test]
    fn markdown_has_a_row_for_every_binding() {
        let rows: usize = SECTIONS
            .iter()
            .map(|section| section.bindings.len() + 1)
            .sum();
        assert_eq!(markdown_table().lines().count(), rows + 2);
    }
}
