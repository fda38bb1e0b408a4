//! `beamtune completions`: completion scripts for shells.
//!
//! Clap generates the scripts; this adds the names of the presets to the files that complete a MODEL.

use clap::builder::PossibleValuesParser;
use clap::{Args, Command, ValueEnum};

use super::Failure;
use crate::guide;
use crate::presets;

/// The arguments of `beamtune completions`.
#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// The shell.
    shell: Shell,
}

/// The supported shells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Shell {
    /// For ~/.local/share/bash-completion/completions/beamtune
    Bash,
    /// For a file _beamtune in a folder of $fpath
    Zsh,
    /// For ~/.config/fish/completions/beamtune.fish
    Fish,
}

/// The program's commands, with and without a MODEL.
pub(super) struct Commands {
    pub(super) whole: Command,
    /// For zsh, which completes a command only if no other argument may be in its position.
    pub(super) without_model: Command,
}

/// Prints the script.
pub(super) fn run(arguments: &Arguments, commands: Commands) -> Result<(), Failure> {
    let script = match arguments.shell {
        Shell::Bash => bash(commands.whole),
        Shell::Zsh => zsh(commands.without_model),
        Shell::Fish => fish(commands.whole),
    };
    super::print(&script)
}

/// bash continues with files if no word matches.
fn bash(command: Command) -> String {
    generate(
        clap_complete::Shell::Bash,
        words(command, &["model", "preset"]),
    )
}

fn zsh(command: Command) -> String {
    let names = names().join(" ");
    let model = format!("_alternative \"presets:preset:({names})\" \"files:model file:_files\"");
    let lines = generate(clap_complete::Shell::Zsh, words(command, &["preset"]));
    let lines = lines.lines().map(|line| {
        // A space before an action prevents zsh from adding its own arguments.
        if line.starts_with("':model -- ") {
            line.replace(":_default'", &format!(": {model}'"))
        } else if line
            .trim_start()
            .starts_with("_describe -t commands 'beamtune commands'")
        {
            format!("{line}\n    {model}")
        } else {
            line.to_owned()
        }
    });
    lines.map(|line| line + "\n").collect()
}

/// fish completes files unless `-f` forbids it; clap omits other words for arguments.
fn fish(command: Command) -> String {
    let with = |argument| using(&subcommands_with(&command, argument));
    let presets: Vec<(&str, String)> = presets::ALL
        .iter()
        .map(|preset| (preset.name, preset.title()))
        .collect();
    let shells: Vec<(&str, String)> = ["bash", "zsh", "fish"]
        .map(|shell| (shell, String::new()))
        .to_vec();
    let chapters: Vec<(&str, String)> = guide::CHAPTERS
        .iter()
        .map(|chapter| (chapter.name, chapter.summary().to_owned()))
        .collect();
    let added = [
        fish_words("__fish_beamtune_needs_command", "", &presets),
        fish_words(&with("model"), "", &presets),
        fish_words(&with("preset"), " -f", &presets),
        fish_words(&with("shell"), " -f", &shells),
        fish_words(&with("chapter"), " -f", &chapters),
    ];
    generate(clap_complete::Shell::Fish, command) + &added.concat()
}

fn using(subcommands: &[String]) -> String {
    format!("__fish_beamtune_using_subcommand {}", subcommands.join(" "))
}

/// Words with their meanings, for the arguments of some commands; `files` is `-f` if no file is accepted.
fn fish_words(condition: &str, files: &str, words: &[(&str, String)]) -> String {
    let line = |(word, meaning): &(&str, String)| {
        let meaning = meaning.replace('\\', "\\\\").replace('\'', "\\'");
        format!("complete -c beamtune -n \"{condition}\"{files} -a {word} -d '{meaning}'\n")
    };
    words.iter().map(line).collect()
}

fn generate(shell: clap_complete::Shell, mut command: Command) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, "beamtune", &mut script);
    String::from_utf8_lossy(&script).into_owned()
}

/// The same commands, with the names of the presets as the only values of these arguments.
fn words(command: Command, arguments: &[&str]) -> Command {
    let own = |argument: clap::Arg| {
        if arguments.contains(&argument.get_id().as_str()) {
            argument.value_parser(PossibleValuesParser::new(names()))
        } else {
            argument
        }
    };
    command
        .mut_args(own)
        .mut_subcommands(|subcommand| subcommand.mut_args(own))
}

/// The names of the commands that have an argument.
fn subcommands_with(command: &Command, argument: &str) -> Vec<String> {
    let has = |one: &&Command| one.get_arguments().any(|own| own.get_id() == argument);
    let found = command.get_subcommands().filter(has);
    found.map(|one| one.get_name().to_owned()).collect()
}

fn names() -> Vec<&'static str> {
    presets::ALL.iter().map(|preset| preset.name).collect()
}

#[cfg(test)]
mod tests {
    use super::super::completion_commands;
    use super::*;

    #[test]
    fn bash_offers_presets_and_goes_on_to_files() {
        let script = bash(completion_commands().whole);
        let names = names().join(" ");
        // The program itself, `show` and the commands with a MODEL.
        assert!(script.matches(&names).count() >= 8, "{script}");
        assert!(script.contains("-o default beamtune"));
    }

    #[test]
    fn zsh_offers_commands_presets_and_files_in_one_place() {
        let script = zsh(completion_commands().without_model);
        let expected = "commands 'beamtune commands' commands \"$@\"\n    _alternative \"presets:preset:(fig05a ";
        assert!(script.contains(expected), "{script}");
        let models = script
            .lines()
            .filter(|line| line.starts_with("':model -- "));
        let models: Vec<&str> = models.collect();
        assert_eq!(models.len(), 7, "{models:#?}");
        for model in models {
            assert!(
                model.ends_with(")\" \"files:model file:_files\"' \\"),
                "{model}"
            );
        }
        assert!(script.contains("name:(fig05a fig05b"), "{script}");
    }

    #[test]
    fn fish_offers_presets_with_their_titles() {
        let script = fish(completion_commands().whole);
        let at_once =
            "complete -c beamtune -n \"__fish_beamtune_needs_command\" -a fig06 -d 'Fig. 6: ";
        assert!(script.contains(at_once), "{script}");
        for line in [
            "using_subcommand check frf modes sensitivities spread tune validate\" -a cantilever -d 'Cantilever with",
            "using_subcommand show\" -f -a fig08 -d 'Fig. 8: ",
            "using_subcommand completions\" -f -a zsh -d ''",
            "using_subcommand guide\" -f -a tuning -d 'which",
        ] {
            assert!(script.contains(line), "{line}");
        }
    }
}
