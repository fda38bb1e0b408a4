//! The key table with the user's bindings.

use crossterm::event::KeyEvent;

use super::{Binding, Command, FileCommand, Hint, Key, RowKind, SECTIONS, Scope, Section};

/// The keys of each row of the table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyMap {
    /// By section and row, as in the table.
    keys: Vec<Vec<Vec<Key>>>,
}

/// A row of the table with its keys.
#[derive(Debug, Clone, Copy)]
pub struct Bound<'a> {
    /// Its section.
    pub section: &'static Section,
    /// The row.
    pub binding: &'static Binding,
    /// Its keys; the first one is in hints. May be empty.
    pub keys: &'a [Key],
}

impl Bound<'_> {
    /// The names of its keys, separated by spaces.
    pub fn names(&self) -> String {
        let names: Vec<String> = self.keys.iter().map(|key| key.name()).collect();
        names.join(" ")
    }
}

/// A key that is bound to two commands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Conflict {
    /// The key.
    pub key: Key,
    /// Their common scope.
    pub scope: Scope,
    /// The names of the two commands.
    pub names: [&'static str; 2],
}

/// The default table.
impl Default for KeyMap {
    fn default() -> Self {
        let section = |section: &Section| {
            let rows = section.rows();
            rows.map(|binding| binding.keys.to_vec()).collect()
        };
        Self {
            keys: SECTIONS.iter().map(section).collect(),
        }
    }
}

impl KeyMap {
    /// The rows of the table, in its order.
    pub fn rows(&self) -> impl Iterator<Item = Bound<'_>> {
        SECTIONS.iter().zip(&self.keys).flat_map(|(section, keys)| {
            let rows = section.rows().zip(keys);
            rows.map(move |(binding, keys)| Bound {
                section,
                binding,
                keys,
            })
        })
    }

    /// The rows of a scope.
    pub fn of(&self, scope: Scope) -> impl Iterator<Item = Bound<'_>> {
        self.rows().filter(move |row| row.section.scope == scope)
    }

    /// Sets the keys of a command in a scope; false if there is no such command.
    pub fn rebind(&mut self, scope: Scope, name: &str, keys: &[Key]) -> bool {
        let mut found = false;
        for (section, rows) in SECTIONS.iter().zip(&mut self.keys) {
            for (binding, own) in section.rows().zip(rows) {
                if section.scope == scope && binding.name == name {
                    *own = keys.to_vec();
                    found = true;
                }
            }
        }
        found
    }

    /// Keys bound to two commands: in the same scope, or in a scope and everywhere.
    pub fn conflicts(&self) -> Vec<Conflict> {
        let mut conflicts = Vec::new();
        for scope in Scope::ALL {
            let keys = |scope| {
                let rows = self.of(scope);
                rows.flat_map(|row| row.keys.iter().map(move |key| (*key, row.binding.name)))
            };
            let mut heard: Vec<(Key, &'static str)> = Vec::new();
            for (key, name) in keys(scope) {
                heard.push((key, name));
                let before = &heard[..heard.len() - 1];
                let first = before.iter().find(|(other, _)| *other == key);
                conflicts.extend(first.map(|(_, first)| Conflict {
                    key,
                    scope,
                    names: [first, name],
                }));
            }
            for (key, name) in keys(Scope::Any).filter(|_| scope != Scope::Any) {
                let own = heard.iter().find(|(other, _)| *other == key);
                conflicts.extend(own.map(|(_, own)| Conflict {
                    key,
                    scope,
                    names: [own, name],
                }));
            }
        }
        conflicts
    }

    /// The command of a key in a scope or everywhere, if it is bound.
    pub fn command(&self, scope: Scope, event: &KeyEvent) -> Option<Command> {
        let in_scope = |wanted| self.command_in(wanted, event);
        let beneath = match scope {
            Scope::Table => in_scope(Scope::Main),
            _ => None,
        };
        in_scope(scope).or(beneath).or_else(|| in_scope(Scope::Any))
    }

    /// The command of a key in this scope only.
    pub fn command_in(&self, scope: Scope, event: &KeyEvent) -> Option<Command> {
        let key = Key::of(event);
        let mut rows = self.of(scope);
        rows.find(|row| row.keys.contains(&key))
            .map(|row| row.binding.command)
    }

    /// The first key of a command; without a key, how to find it in the palette.
    pub fn key_of(&self, wanted: impl Into<Command>) -> String {
        let Some(row) = self.row(wanted.into()) else {
            return String::new();
        };
        let first = |row: Bound<'_>| row.keys.first().map(|key| key.name());
        let palette = || self.row(FileCommand::Palette.into()).and_then(first);
        let name = row.binding.name;
        first(row).unwrap_or_else(|| match palette() {
            Some(palette) => format!("{palette} {name}"),
            None => format!("`{name}`"),
        })
    }

    /// The first row of a command.
    fn row(&self, wanted: Command) -> Option<Bound<'_>> {
        self.rows().find(|row| row.binding.command == wanted)
    }

    /// The name of a command in the palette: `next view`.
    pub fn name_of(&self, wanted: Command) -> String {
        let row = self.row(wanted);
        row.map_or_else(String::new, |row| row.binding.name.replace('-', " "))
    }

    /// The hints of a scope for a kind of row, as (key, text): first those of the row, then help and the rest.
    pub fn hints(&self, scope: Scope, row: RowKind) -> Vec<(String, &'static str)> {
        let mut shown = self.hints_of_row(scope, row);
        if scope == Scope::Table {
            let of_table = |bound: Bound<'_>| match bound.binding.hint {
                Hint::Table(text) => Some((bound.keys.first()?.name(), text)),
                _ => None,
            };
            shown.extend(self.of(Scope::Main).filter_map(of_table));
            shown.extend(self.hints_of_row(Scope::Main, row));
        }
        shown
    }

    fn hints_of_row(&self, scope: Scope, row: RowKind) -> Vec<(String, &'static str)> {
        let mut shown: Vec<_> = self
            .of(scope)
            .filter_map(|bound| {
                let text = bound.binding.hint.text_on(row)?;
                Some((bound.binding, bound.keys.first()?.name(), text))
            })
            .collect();
        // Hints at the end may be cut off; help and the palette lead to them.
        shown.sort_by_key(|(binding, ..)| match (binding.hint, binding.command) {
            (Hint::Always(_), Command::File(FileCommand::Help | FileCommand::Palette)) => 1,
            (Hint::Always(_), _) => 2,
            _ => 0,
        });
        shown
            .into_iter()
            .map(|(_, key, text)| (key, text))
            .collect()
    }

    /// The key table as GitHub-flavoured Markdown.
    #[cfg(test)]
    pub fn markdown_table(&self) -> String {
        use std::fmt::Write as _;
        let mut table = String::from("| Keys | What they do | Name |\n| --- | --- | --- |\n");
        let mut heading = "";
        for row in self.rows() {
            if row.section.title != heading {
                heading = row.section.title;
                let _ = writeln!(table, "| **{heading}** | | `{}` |", row.section.scope.key());
            }
            let code = |key: &Key| match key.name().as_str() {
                "`" => "`` ` ``".to_owned(),
                name => format!("`{}`", name.replace('|', "\\|")),
            };
            let keys: Vec<String> = row.keys.iter().map(code).collect();
            let (help, name) = (row.binding.help, row.binding.name);
            let _ = writeln!(table, "| {} | {help} | `{name}` |", keys.join(" "));
        }
        table
    }
}

/// The names of the commands of a scope.
pub fn names(scope: Scope) -> impl Iterator<Item = &'static str> {
    SECTIONS
        .iter()
        .filter(move |section| section.scope == scope)
        .flat_map(Section::rows)
        .map(|binding| binding.name)
}

#[cfg(test)]
mod tests {
    use super::super::ModelCommand;
    use super::*;

    #[test]
    fn every_key_reaches_its_command() {
        let map = KeyMap::default();
        for row in map.rows() {
            for key in row.keys {
                let found = map.command(row.section.scope, &key.event());
                assert_eq!(
                    found,
                    Some(row.binding.command),
                    "{} {key:?}",
                    row.section.title
                );
            }
        }
    }

    #[test]
    fn the_table_has_no_conflicts_and_a_name_once_in_a_scope() {
        assert_eq!(KeyMap::default().conflicts(), []);
        for scope in Scope::ALL {
            let mut all: Vec<_> = names(scope).collect();
            all.sort_unstable();
            let count = all.len();
            all.dedup();
            assert_eq!(all.len(), count, "{scope:?}");
        }
    }

    #[test]
    fn typed_characters_stay_free_where_something_is_typed() {
        let map = KeyMap::default();
        let typing = Scope::ALL.into_iter().filter(|scope| scope.is_typing());
        for scope in typing {
            for c in ' '..='~' {
                let key = super::super::key::key(c);
                assert_eq!(map.command(scope, &key.event()), None, "{scope:?} {c}");
            }
        }
    }

    #[test]
    fn a_command_takes_other_keys_or_none() {
        let mut map = KeyMap::default();
        let key = |name| Key::parse(name).unwrap();
        assert!(map.rebind(Scope::Main, "undo", &[key("Ctrl-y"), key("Q")]));
        assert!(map.rebind(Scope::Main, "redo", &[]));
        assert!(!map.rebind(Scope::Table, "undo", &[]));
        let command = |name| map.command(Scope::Main, &key(name).event());
        assert_eq!(command("Q"), Some(ModelCommand::Undo.into()));
        assert_eq!(command("u"), None);
        assert_eq!(map.key_of(ModelCommand::Undo), "Ctrl-y");
        assert_eq!(map.key_of(ModelCommand::Redo), ": redo");
    }

    #[test]
    fn conflicts_name_both_commands() {
        let mut map = KeyMap::default();
        let key = Key::parse("s").unwrap();
        assert!(map.rebind(Scope::Main, "undo", &[key]));
        let conflict = Conflict {
            key,
            scope: Scope::Main,
            names: ["undo", "save"],
        };
        assert_eq!(map.conflicts(), [conflict]);
        let everywhere = Key::parse("Ctrl-l").unwrap();
        assert!(map.rebind(Scope::Main, "undo", &[everywhere]));
        assert_eq!(map.conflicts()[0].names, ["undo", "redraw"]);
        let mut map = KeyMap::default();
        let end = Key::parse("Ctrl-c").unwrap();
        assert!(map.rebind(Scope::Any, "redraw", &[end]));
        let conflicts = map.conflicts();
        assert_eq!(conflicts.len(), 1, "{conflicts:?}");
        assert_eq!(
            (conflicts[0].scope, conflicts[0].names),
            (Scope::Any, ["redraw", "end"])
        );
    }

    #[test]
    fn markdown_has_a_row_for_every_binding() {
        let rows: usize = SECTIONS
            .iter()
            .map(|section| section.rows().count() + 1)
            .sum();
        let table = KeyMap::default().markdown_table();
        assert_eq!(table.lines().count(), rows + 2);
    }
}
