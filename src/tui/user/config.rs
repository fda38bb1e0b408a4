//! The user's configuration file, read and checked as strictly as a model file.
//!
//! ```toml
//! [options]              # each may be left out
//! color = "auto"         # auto, always, never, 16, 256, truecolor
//! theme = "auto"         # auto, dark, light
//! ascii = false
//! marker = "braille"     # braille, octant, block, dot, ascii
//! mouse = true
//! [keys.model]           # a table for each part of the key table; `beamtune man` has the names
//! undo = ["u", "Alt-u"]  # the first is the one in hints; [] removes a command's keys
//! ```

use crossterm::event::KeyCode;

use crate::model::Fault;
use crate::model::read::document;
use crate::model::read::reader::{Reader, quoted};
use crate::model::read::table::Table;
use crate::model::read::value::{Node, wrong_type};
use crate::tui::keys::{self, Conflict, Key, KeyMap, Scope};
use crate::tui::options::{Colours, Ground, Marker, Options};

/// The accepted list of keys.
const LIST: &str = "a list of keys in quotes, such as [\"u\", \"Alt-u\"]";
/// Several kinds of keys.
const EXAMPLES: &str = "u, U, Ctrl-z, Alt-x, F5, PgDn, Space or Shift-Tab";

/// Keys that edit typed text.
const EDITING: [KeyCode; 6] = [
    KeyCode::Backspace,
    KeyCode::Delete,
    KeyCode::Left,
    KeyCode::Right,
    KeyCode::Home,
    KeyCode::End,
];

/// The user's configuration.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Config {
    /// The options; what is `None` is not in the file.
    pub options: Options,
    /// The key table with the user's keys.
    pub keys: KeyMap,
}

/// Parses a configuration file. An empty one is valid.
///
/// # Errors
/// All faults in the order of the text, each with line, column and path: invalid TOML, unknown keys, scopes and
/// commands (with the nearest known one), wrong types and words, invalid key names, keys needed for typing, and keys
/// bound to two commands.
pub fn read(text: &str) -> Result<Config, Vec<Fault>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = Reader::default();
    let Some(document) = document(text, &mut reader) else {
        return Err(reader.into_faults(text));
    };
    let mut root = Table::root(document.get_ref());
    let mut config = Config::default();
    if let Some(table) = root.table("options", &mut reader) {
        config.options = options(table, &mut reader);
    }
    if let Some(table) = root.table("keys", &mut reader) {
        config.keys = key_map(table, &mut reader);
    }
    root.finish(&mut reader);
    if reader.is_content() {
        Ok(config)
    } else {
        Err(reader.into_faults(text))
    }
}

fn options(mut table: Table<'_>, reader: &mut Reader) -> Options {
    let options = Options {
        colours: choice(&mut table, "color", Colours::WORDS, reader).and_then(Colours::of_word),
        ground: choice(&mut table, "theme", Ground::WORDS, reader).and_then(Ground::of_word),
        ascii: table.flag("ascii", reader),
        marker: choice(&mut table, "marker", Marker::WORDS, reader).and_then(Marker::of_word),
        mouse: table.flag("mouse", reader),
    };
    table.finish(reader);
    options
}

/// The word of a choice; none if missing or another word.
fn choice<'a>(
    table: &mut Table<'a>,
    key: &'a str,
    words: &[&'static str],
    reader: &mut Reader,
) -> Option<&'static str> {
    if !table.has(key) {
        table.accept(key);
        return None;
    }
    let index = table.word(key, words, None, reader)?;
    words.get(index).copied()
}

/// A key that the file binds to a command.
struct Given {
    key: Key,
    scope: Scope,
    name: &'static str,
    path: String,
    /// Its byte offset.
    offset: usize,
}

fn key_map(mut table: Table<'_>, reader: &mut Reader) -> KeyMap {
    let mut map = KeyMap::default();
    let mut given: Vec<Given> = Vec::new();
    for scope in Scope::ALL {
        let Some(mut commands) = table.table(scope.key(), reader) else {
            continue;
        };
        for name in keys::names(scope) {
            let Some((path, node)) = commands.take(name, reader) else {
                continue;
            };
            let row = Row { scope, name, path };
            if let Some(list) = row.keys(node, reader) {
                let keys: Vec<Key> = list.iter().map(|given| given.key).collect();
                map.rebind(scope, name, &keys);
                given.extend(list);
            }
        }
        commands.finish(reader);
    }
    table.finish(reader);
    given.sort_by_key(|given| given.offset);
    for conflict in map.conflicts() {
        refuse(&conflict, &given, reader);
    }
    map
}

/// A command that the file binds to keys.
struct Row {
    scope: Scope,
    name: &'static str,
    path: String,
}

impl Row {
    /// The valid keys; none if the value is not a list.
    fn keys(&self, node: Node<'_>, reader: &mut Reader) -> Option<Vec<Given>> {
        let Some(list) = node.get_ref().as_array() else {
            reader.fault(node.span().start, &self.path, wrong_type(node, LIST));
            return None;
        };
        if list.is_empty() && self.is_needed() {
            let message =
                "is empty; must have a key, without which the dialog cannot be answered or closed";
            reader.fault(node.span().start, &self.path, message);
        }
        let mut keys: Vec<Given> = Vec::new();
        for node in list {
            let offset = node.span().start;
            match self.key(node) {
                Ok(key) if keys.iter().any(|known| known.key == key) => {
                    let message = format!("has `{}` twice; once is enough", key.name());
                    reader.fault(offset, &self.path, message);
                }
                Ok(key) => keys.push(Given {
                    key,
                    scope: self.scope,
                    name: self.name,
                    path: self.path.clone(),
                    offset,
                }),
                Err(message) => reader.fault(offset, &self.path, message),
            }
        }
        Some(keys)
    }

    /// One key of the list, or its fault.
    fn key(&self, node: Node<'_>) -> Result<Key, String> {
        let text = node.get_ref().as_str();
        let text = text.ok_or_else(|| wrong_type(node, "a key in quotes"))?;
        let key = Key::parse(text).ok_or_else(|| {
            format!(
                "is {}, which is not a key; must be one such as {EXAMPLES}",
                quoted(text)
            )
        })?;
        if self.takes_counts(key) {
            return Err(format!(
                "is {}, which is part of a count before a command; must be another key, such as Q, Ctrl-y or F5",
                quoted(text)
            ));
        }
        if self.takes_typing(key) {
            return Err(format!(
                "is {}, which is needed for typing; must be another key, such as Ctrl-z, Alt-x or F5",
                quoted(text)
            ));
        }
        Ok(key)
    }

    /// Whether the binding would make a count with this digit impossible.
    fn takes_counts(&self, key: Key) -> bool {
        let counted = matches!(self.scope, Scope::Main | Scope::Table | Scope::Any);
        let digit = matches!(key.code, KeyCode::Char(c) if c.is_ascii_digit());
        counted && digit && key.is_typed()
    }

    /// Whether the binding would take a key needed for typing.
    fn takes_typing(&self, key: Key) -> bool {
        let heard = self.scope.is_typing() || self.scope == Scope::Any;
        let own = KeyMap::default();
        let own = own
            .of(self.scope)
            .any(|row| row.binding.name == self.name && row.keys.contains(&key));
        heard
            && !own
            && (key.is_typed() || (EDITING.contains(&key.code) && key.modifiers.is_empty()))
    }

    /// Whether a dialog, or the program, could not be closed without a key.
    fn is_needed(&self) -> bool {
        match self.scope {
            Scope::Main | Scope::Table => false,
            Scope::Any => self.name == "end",
            _ => matches!(self.name, "cancel" | "accept" | "discard" | "replace"),
        }
    }
}

/// The fault of a conflict, at its place in the file.
fn refuse(conflict: &Conflict, given: &[Given], reader: &mut Reader) {
    let [first, second] = conflict.names;
    let own = |name| keys::names(conflict.scope).any(|own| own == name);
    // The first one is always of the scope itself.
    let place = if second != first && own(second) {
        conflict.scope
    } else {
        Scope::Any
    };
    let message = format!(
        "`{}` is given to both `{first}` of {} and `{second}` of {}; a key must have one command only",
        conflict.key.name(),
        conflict.scope.key(),
        place.key(),
    );
    let cause = given.iter().rfind(|given| {
        given.key == conflict.key
            && conflict.names.contains(&given.name)
            && (given.scope == conflict.scope || given.scope == Scope::Any)
    });
    let (offset, path) = cause.map_or((0, "keys"), |given| (given.offset, &*given.path));
    reader.fault(offset, path, message);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::keys::{Command, FileCommand, ModelCommand, PickerCommand};
    use std::fmt::Write as _;

    fn faults(text: &str) -> Vec<String> {
        let faults = read(text).expect_err(text);
        faults.iter().map(ToString::to_string).collect()
    }

    /// The only fault of a text.
    fn fault(text: &str) -> String {
        let faults = faults(text);
        assert_eq!(faults.len(), 1, "{text}: {faults:#?}");
        faults.concat()
    }

    fn command(config: &Config, scope: Scope, key: &str) -> Option<Command> {
        config
            .keys
            .command(scope, &Key::parse(key).unwrap().event())
    }

    #[test]
    fn an_empty_file_configures_nothing() {
        for text in [
            "",
            "\u{feff}",
            "# nothing\n",
            "[options]\n[keys]\n[keys.model]\n",
        ] {
            assert_eq!(read(text), Ok(Config::default()), "{text:?}");
        }
    }

    #[test]
    fn options_and_keys_are_read() {
        let config = read(
            "[options]\ncolor = \"256\"\ntheme = \"light\"\nascii = false\nmarker = \"dot\"\nmouse = true\n\
             [keys.model]\nundo = [\"Alt-u\", \"u\"]\nredo = []\n[keys.presets]\ncancel = [\"Esc\", \"x\"]\n",
        )
        .unwrap();
        let expected = Options {
            colours: Some(Colours::TwoFiftySix),
            ground: Some(Ground::Light),
            ascii: Some(false),
            marker: Some(Marker::Dot),
            mouse: Some(true),
        };
        assert_eq!(config.options, expected);
        assert_eq!(
            command(&config, Scope::Main, "Alt-u"),
            Some(ModelCommand::Undo.into())
        );
        assert_eq!(command(&config, Scope::Main, "U"), None);
        assert_eq!(
            command(&config, Scope::Picker, "x"),
            Some(PickerCommand::Cancel.into())
        );
        assert_eq!(command(&config, Scope::Picker, "q"), None);
        assert_eq!(
            command(&config, Scope::Main, "s"),
            Some(FileCommand::Save.into())
        );
    }

    #[test]
    fn the_table_itself_can_be_written_down() {
        let mut text = String::new();
        for scope in Scope::ALL {
            writeln!(text, "[keys.{}]", scope.key()).unwrap();
            for row in KeyMap::default().of(scope) {
                let keys: Vec<String> = row.keys.iter().map(|key| key.name()).collect();
                writeln!(text, "{} = {keys:?}", row.binding.name).unwrap();
            }
        }
        assert_eq!(read(&text), Ok(Config::default()), "{text}");
    }

    #[test]
    fn broken_toml_has_its_place() {
        assert!(fault("[options]\ncolor = \n").starts_with("2:"));
    }

    #[test]
    fn slips_name_the_nearest() {
        assert_eq!(
            fault("[option]\n"),
            "1:2: option: is unknown; did you mean options?"
        );
        assert_eq!(
            fault("[options]\nmous = true\n"),
            "2:1: options.mous: is unknown; did you mean mouse?"
        );
        assert_eq!(
            fault("[keys.modle]\n"),
            "1:7: keys.modle: is unknown; did you mean model?"
        );
        assert_eq!(
            fault("[keys.model]\nunod = [\"Q\"]\n"),
            "2:1: keys.model.unod: is unknown; did you mean undo?"
        );
        let far = fault("[options]\nsound = 3\n");
        assert!(
            far.ends_with("must be one of color, theme, ascii, marker, mouse"),
            "{far}"
        );
    }

    #[test]
    fn wrong_types_and_words_say_what_is_accepted() {
        assert_eq!(
            fault("[options]\ncolor = \"lots\"\n"),
            "2:9: options.color: is \"lots\"; must be \"auto\", \"always\", \"never\", \"16\", \"256\" or \"truecolor\""
        );
        assert_eq!(
            fault("[options]\nmouse = 1\n"),
            "2:9: options.mouse: is 1; must be true or false"
        );
        assert_eq!(
            fault("options = 1\n"),
            "1:11: options: is 1; must be a table"
        );
        assert_eq!(
            fault("[keys.model]\nundo = \"u\"\n"),
            "2:8: keys.model.undo: is the text \"u\"; must be a list of keys in quotes, such as [\"u\", \"Alt-u\"]"
        );
        assert_eq!(
            fault("[keys.model]\nundo = [3]\n"),
            "2:9: keys.model.undo: is 3; must be a key in quotes"
        );
    }

    #[test]
    fn what_names_no_key_is_refused() {
        for nonsense in ["", "Ctrl-", "Strg-z", "uu", "F99"] {
            let fault = fault(&format!("[keys.model]\nundo = [\"{nonsense}\"]\n"));
            let start = format!(
                "2:9: keys.model.undo: is \"{nonsense}\", which is not a key; must be one such as u,"
            );
            assert!(fault.starts_with(&start), "{fault}");
        }
        assert_eq!(
            fault("[keys.model]\nundo = [\"u\", \"u\"]\n"),
            "2:14: keys.model.undo: has `u` twice; once is enough"
        );
    }

    #[test]
    fn a_key_for_two_commands_is_refused_where_it_is_given() {
        assert_eq!(
            fault("[keys.model]\nundo = [\"u\", \"s\"]\n"),
            "2:14: keys.model.undo: `s` is given to both `undo` of model and `save` of model; a key must have one command only"
        );
        assert_eq!(
            fault("[keys.model]\nsave = [\"F9\"]\nundo = [\"F9\"]\n"),
            "3:9: keys.model.undo: `F9` is given to both `undo` of model and `save` of model; a key must have one command only"
        );
        let everywhere = faults("[keys.everywhere]\nredraw = [\"F1\"]\n");
        assert_eq!(
            everywhere[0],
            "2:11: keys.everywhere.redraw: `F1` is given to both `help` of model and `redraw` of everywhere; a key must have one command only"
        );
    }

    #[test]
    fn a_swap_of_two_keys_is_no_conflict() {
        let config = read("[keys.model]\nundo = [\"s\"]\nsave = [\"u\"]\n").unwrap();
        assert_eq!(
            command(&config, Scope::Main, "s"),
            Some(ModelCommand::Undo.into())
        );
        assert_eq!(
            command(&config, Scope::Main, "u"),
            Some(FileCommand::Save.into())
        );
    }

    #[test]
    fn what_is_typed_stays_free_where_something_is_typed() {
        for (part, name) in [
            ("typing", "accept"),
            ("palette", "up"),
            ("search", "down"),
            ("everywhere", "redraw"),
        ] {
            for key in ["x", "Space", "ä", "Backspace", "Left", "Home"] {
                let faults = faults(&format!("[keys.{part}]\n{name} = [\"{key}\"]\n"));
                let first = format!(
                    "2:{}: keys.{part}.{name}: is \"{key}\", which is needed for typing",
                    name.len() + 5
                );
                assert!(faults[0].starts_with(&first), "{faults:#?}");
            }
        }
    }

    #[test]
    fn nothing_stays_open_for_want_of_a_key() {
        for (part, name) in [
            ("typing", "cancel"),
            ("unsaved", "cancel"),
            ("everywhere", "end"),
        ] {
            let fault = fault(&format!("[keys.{part}]\n{name} = []\n"));
            assert!(fault.contains("is empty; must have a key"), "{fault}");
        }
        assert!(read("[keys.model]\nquit = []\n").is_ok());
    }

    #[test]
    fn a_torn_file_is_read_or_its_faults_have_places() {
        let text = "[options]\ncolor = \"256\"\nmouse = true\n[keys.model]\nundo = [\"Alt-ü\", 'u']\n[keys]\ntable = { down = [\"é\"] }\n";
        for (end, _) in text.char_indices() {
            for torn in [&text[..end], &text[end..]] {
                for fault in read(torn).err().unwrap_or_default() {
                    assert!(
                        fault.line.is_some() && fault.column.is_some(),
                        "{torn:?}: {fault:?}"
                    );
                    assert!(!fault.message.is_empty(), "{torn:?}");
                }
            }
        }
        assert!(read(text).is_ok());
    }

    #[test]
    fn all_faults_are_reported_in_the_order_of_the_text() {
        let faults = faults(
            "[keys.model]\nundo = [\"s\", \"nonsense\"]\nfly = []\n[options]\ncolor = 16\nfont = 1\n[colours]\n",
        );
        let places: Vec<&str> = faults.iter().map(|fault| &fault[..4]).collect();
        assert_eq!(
            places,
            ["2:9:", "2:14", "3:1:", "5:9:", "6:1:", "7:2:"],
            "{faults:#?}"
        );
    }
}
