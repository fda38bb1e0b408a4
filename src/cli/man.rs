//! `beamtune man`: the manual page, from the arguments and the key table.

use clap::builder::Str;
use clap::{Arg, Command};
use clap_mangen::Man;
use clap_mangen::roff::{Inline, Roff, bold, italic, line_break, roman};

use super::Failure;
use crate::tui::keys::KeyMap;

/// Terms and their descriptions.
type Terms = &'static [(&'static str, &'static str)];

const FILES: Terms = &[
    (
        "$XDG_CONFIG_HOME/beamtune/config.toml",
        "Options and keys, which only you write. ~/.config if XDG_CONFIG_HOME is not set. It is checked like a \
         model file: every fault is printed with its line and column, and the designer does not start.",
    ),
    (
        "$XDG_STATE_HOME/beamtune/memory.toml",
        "Options that were changed in the designer and the last view of each model. ~/.local/state if \
         XDG_STATE_HOME is not set. It may be removed.",
    ),
    (
        "$XDG_STATE_HOME/beamtune/recovery/",
        "Models with unsaved changes, written at every change. Each is a model file. After the program was \
         killed or lost its terminal, the next start offers to recover them.",
    ),
    (
        "$XDG_STATE_HOME/beamtune/beamtune.log",
        "Errors, with the time in UTC. It may be removed.",
    ),
];

/// An example of a configuration file.
const CONFIGURATION: &str = r#"[options]
color = "auto"      # auto, always, never, 16, 256, truecolor
theme = "auto"      # auto, dark, light
ascii = false
marker = "braille"  # braille, octant, block, dot, ascii
mouse = true
[keys.model]
undo = ["u"]        # the first is the one in hints; [] removes a command's keys"#;

const ENVIRONMENT: Terms = &[
    (
        "NO_COLOR",
        "If it is set and not empty, no colours are used, unless --color or the configuration asks for some.",
    ),
    (
        "COLORTERM, TERM",
        "The number of colours of the terminal: truecolor or 24bit in COLORTERM, 256color in TERM. Terminals whose TERM \
         is linux or starts with vt get ASCII characters only; if TERM is dumb or not set, the designer does not \
         start.",
    ),
    (
        "COLORFGBG",
        "The numbers of the text and background colours, such as 15;0, which distinguish a dark background from a \
         light one.",
    ),
    (
        "LC_ALL, LC_CTYPE, LANG",
        "The locale; the first that is set counts. If it is not a UTF-8 locale, the designer draws in ASCII.",
    ),
    (
        "XDG_CONFIG_HOME, XDG_STATE_HOME, HOME",
        "The folders of the user's files. Paths that are not absolute are ignored.",
    ),
];

const EXIT_STATUS: Terms = &[
    ("0", "Done."),
    (
        "1",
        "Another failure, or differences above the tolerance of validate.",
    ),
    (
        "2",
        "Bad input or usage; standard error says what is wrong, and no file is written.",
    ),
    (
        "101",
        "Internal error of the designer. Unsaved changes are kept for recovery.",
    ),
    (
        "128 + n",
        "Signal n ended the designer, whose unsaved changes are kept for recovery, or tune, whose best so far is written.",
    ),
];

const EXAMPLES: Terms = &[
    ("beamtune fig08", "The designer on a preset."),
    (
        "beamtune guide tuning | less",
        "A chapter of the guide; without a name, the list of chapters.",
    ),
    (
        "beamtune show fig05a > mine.toml",
        "A commented start for your own model.",
    ),
    (
        "beamtune check mine.toml",
        "Every fault of it with its line.",
    ),
    (
        "beamtune frf mine.toml --set 'subsystems.*.mass=*1.2' -o heavier.csv",
        "Its frequency responses with every subsystem a fifth heavier.",
    ),
    (
        "beamtune modes mine.toml --to 200",
        "Its natural frequencies up to 200 Hz.",
    ),
    (
        "beamtune measured run.csv --columns 'hz 1; re 8; im 9; m/N' -o si.csv",
        "A summary of a measured file, whose columns are chosen by number, and its curves in SI.",
    ),
    (
        "beamtune tune cantilever -o tuned.toml",
        "The model with the best parameters for its [tune] table of variables and objectives; Ctrl-C ends the search with \
         the best so far.",
    ),
];

/// Prints the page.
pub(super) fn run(command: Command) -> Result<(), Failure> {
    super::print(&page(command)?)
}

/// The page as roff with the macros of man(7).
fn page(mut command: Command) -> Result<String, Failure> {
    // So that usages contain the program's name.
    command.build();
    let man = Man::new(command.clone()).manual("User Commands");
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    man.render_description_section(&mut page)?;
    man.render_options_section(&mut page)?;
    let mut roff = Roff::new();
    commands(&mut roff, &command);
    keys(&mut roff);
    terms(&mut roff, "FILES", FILES);
    configuration(&mut roff);
    terms(&mut roff, "ENVIRONMENT", ENVIRONMENT);
    terms(&mut roff, "EXIT STATUS", EXIT_STATUS);
    terms(&mut roff, "EXAMPLES", EXAMPLES);
    roff.to_writer(&mut page)?;
    Ok(String::from_utf8_lossy(&page).into_owned())
}

/// A heading with a paragraph for each term.
fn terms(roff: &mut Roff, heading: &str, terms: Terms) {
    roff.control("SH", [heading]);
    for (term, text) in terms {
        paragraph(roff, vec![bold(*term)], text);
    }
}

fn paragraph(roff: &mut Roff, term: Vec<Inline>, text: &str) {
    roff.control("TP", []);
    roff.text(term);
    roff.text([roman(text)]);
}

/// Each command with its usage and its arguments.
fn commands(roff: &mut Roff, command: &Command) {
    roff.control("SH", ["COMMANDS"]);
    for subcommand in command.get_subcommands().filter(|one| !one.is_hide_set()) {
        let usage = subcommand.clone().render_usage().to_string();
        roff.control("SS", [subcommand.get_name()]);
        roff.text([bold(usage.trim_start_matches("Usage: "))]);
        roff.control("PP", []);
        roff.text([roman(sentence(subcommand.get_about()))]);
        let arguments = subcommand.get_arguments();
        for argument in arguments.filter(|one| !one.is_hide_set() && one.get_id() != "help") {
            paragraph(roff, name(argument), &sentence(argument.get_help()));
        }
    }
}

/// A help text with the full stop that clap removes.
fn sentence(help: Option<&clap::builder::StyledStr>) -> String {
    let text = help.map(ToString::to_string).unwrap_or_default();
    format!("{}.", text.trim_end_matches('.'))
}

/// An argument as typed: `-o, --output FILE`.
fn name(argument: &Arg) -> Vec<Inline> {
    let short = argument.get_short().map(|short| format!("-{short}"));
    let long = argument.get_long().map(|long| format!("--{long}"));
    let flags: Vec<String> = short.into_iter().chain(long).collect();
    let mut name = vec![bold(flags.join(", "))];
    if argument.is_positional() || argument.get_action().takes_values() {
        let space = if flags.is_empty() { "" } else { " " };
        let values = argument.get_value_names().unwrap_or_default();
        let values: Vec<&str> = values.iter().map(Str::as_str).collect();
        name.push(roman(space));
        name.push(italic(values.join(" ")));
    }
    name
}

/// The key table.
fn keys(roff: &mut Roff) {
    roff.control("SH", ["KEYS"]);
    roff.text([roman(
        "In brackets are the table of the configuration file and, for each command, its name there.",
    )]);
    let map = KeyMap::default();
    let mut heading = "";
    for row in map.rows() {
        if row.section.title != heading {
            heading = row.section.title;
            let title = format!("{heading} [keys.{}]", row.section.scope.key());
            roff.control("SS", [title.as_str()]);
        }
        let text = format!("{} [{}]", row.binding.help, row.binding.name);
        paragraph(roff, vec![bold(row.names())], &text);
    }
}

/// The configuration file by example.
fn configuration(roff: &mut Roff) {
    roff.control("SH", ["CONFIGURATION"]);
    roff.text([roman("An example, with every option and one command:")]);
    roff.control("PP", []);
    roff.control("nf", []);
    let lines = CONFIGURATION.lines();
    let lines: Vec<Inline> = lines.flat_map(|line| [roman(line), line_break()]).collect();
    roff.text(lines);
    roff.control("fi", []);
    roff.control("PP", []);
    roff.text([roman(
        "There is a table of keys for each part of the key table. A key is written as in KEYS: u, U, Ctrl-z, Alt-x, \
         F5, PgDn, Space, Shift-Tab. A key of two commands is refused, with the names of both. Options of the command \
         line take precedence over those of the file, and these over options changed in the designer.",
    )]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::options::Marker;
    use crate::tui::user::config;
    use clap::CommandFactory as _;

    fn text() -> String {
        page(super::super::Arguments::command()).unwrap()
    }

    /// A text as roff writes it.
    fn escaped(text: &str) -> String {
        Roff::new()
            .text([roman(text)])
            .render()
            .lines()
            .skip(2)
            .collect()
    }

    #[test]
    fn every_section_command_and_key_is_there() {
        let page = text();
        for heading in [
            "NAME",
            "SYNOPSIS",
            "DESCRIPTION",
            "OPTIONS",
            "COMMANDS",
            "KEYS",
            "FILES",
            "CONFIGURATION",
            "ENVIRONMENT",
            "\"EXIT STATUS\"",
            "EXAMPLES",
        ] {
            assert!(page.contains(&format!(".SH {heading}\n")), "{heading}");
        }
        for command in super::super::Arguments::command().get_subcommands() {
            assert!(page.contains(&format!(".SS {}\n", command.get_name())));
        }
        for row in KeyMap::default().rows() {
            let line = escaped(&format!("{} [{}]", row.binding.help, row.binding.name));
            assert!(page.contains(&line), "{line}");
        }
    }

    #[test]
    fn the_example_is_a_sound_file() {
        let config = config::read(CONFIGURATION).unwrap();
        assert_eq!(config.keys, KeyMap::default());
        assert_eq!(config.options.ascii, Some(false));
        assert_eq!(config.options.marker, Some(Marker::Braille));
    }
}
