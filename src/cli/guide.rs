//! `beamtune guide`: the list of chapters, or one chapter.

use std::io::IsTerminal as _;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use super::Failure;
use crate::guide::{self, CHAPTERS, Chapter};

/// Columns of the text if standard output is not a terminal.
const COLUMNS: usize = 80;
/// Longer lines are hard to read.
const WIDEST: usize = 100;

/// The arguments of `beamtune guide`.
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The chapter; without it, the list of chapters is printed.
    #[arg(value_parser = chapters())]
    chapter: Option<&'static Chapter>,
}

fn chapters() -> impl TypedValueParser<Value = &'static Chapter> {
    let value = |chapter: &Chapter| PossibleValue::new(chapter.name).help(chapter.summary());
    let names = PossibleValuesParser::new(CHAPTERS.iter().map(value));
    names.try_map(|name| guide::find(&name).ok_or("there is no such chapter"))
}

/// Prints the list of chapters, or a chapter.
pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(chapter) = arguments.chapter else {
        return super::print(&guide::contents());
    };
    let lines = guide::lines(chapter.markdown, columns());
    let text: String = lines.into_iter().map(|line| line.text + "\n").collect();
    super::print(&text)
}

/// The width of the terminal, within bounds.
fn columns() -> usize {
    if !std::io::stdout().is_terminal() {
        return COLUMNS;
    }
    let size = crossterm::terminal::size();
    size.map_or(COLUMNS, |(columns, _)| {
        usize::from(columns).clamp(40, WIDEST)
    })
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    #[test]
    fn the_chapter_of_commands_names_every_command() {
        let chapter = crate::guide::find("commands").unwrap();
        for command in super::super::Arguments::command().get_subcommands() {
            let call = format!("| `beamtune {}", command.get_name());
            assert!(chapter.markdown.contains(&call), "{call}");
        }
    }
}
