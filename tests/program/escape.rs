//! Files with terminal control sequences in names, in values and in their own names.

use std::ffi::OsString;
use std::fs;
use std::os::unix::ffi::OsStringExt as _;

use super::harness::{Home, LARGE, Program};
use super::hidden::{HIDDEN, assert_safe, controls, in_toml};

/// A file name that is not text and would set a window's title.
const NAME: &[u8] = b"m\x1b]0;x\x07\xff\xe2\x80\xae.toml";

fn name(bytes: &[u8]) -> OsString {
    OsString::from_vec(bytes.to_vec())
}

/// Letters with every hidden character between them.
fn hidden(letters: impl IntoIterator<Item = char>) -> String {
    letters
        .into_iter()
        .flat_map(|letter| ['x', letter])
        .collect()
}

/// The cantilever with hidden characters in names and notes, and every control in its title.
fn model() -> String {
    let text = beamtune::presets::find("cantilever").unwrap().text;
    let names = hidden(HIDDEN[..18].iter().copied());
    let title = hidden(controls()) + &hidden(HIDDEN.iter().copied());
    text.replace("Damper", &in_toml(&format!("D{names}")))
        .replace("\"tip ", &format!("\"{}", in_toml(&format!("t{names}"))))
        .replace("title = \"", &format!("title = \"{}", in_toml(&title)))
        .replace("points = 2000", "points = 20")
}

/// In all that was sent, only the program's own sequences act on the terminal.
fn assert_sent_safe(what: &str, raw: &[u8]) {
    let text = std::str::from_utf8(raw).unwrap_or_else(|error| panic!("{what}: {error}"));
    assert!(
        !text.contains("\u{1b}]"),
        "{what}: an operating system command"
    );
    let found = text.chars().find(|letter| {
        HIDDEN.contains(letter)
            || ('\u{7f}'..='\u{9f}').contains(letter)
            || matches!(letter, '\0'..='\u{7}' | '\t' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1a}')
            // Hidden characters that a widget let through.
            || *letter == char::REPLACEMENT_CHARACTER
    });
    assert_eq!(found, None, "{what}");
}

#[test]
fn a_hostile_file_is_edited_without_its_names_reaching_the_terminal() {
    let home = Home::new();
    fs::write(home.file("model"), model()).unwrap();
    fs::rename(home.file("model"), home.work().join(name(NAME))).unwrap();
    let script = "exec \"$BEAMTUNE\" m* --set 'subsystems.1.mass=5'";
    let mut program = Program::script(&home, script);
    program.resize(LARGE);
    program.wait_for("modes,");
    program.wait_for(r"m\u{1b}]0;x\u{7}\xff\u{202e}.toml");
    for keys in [
        "E", "G", "B", "O", "P", "m", "Q", "Qr", ":D", "/D", "r", "?", "f",
    ] {
        program.press(keys);
        program.settle();
        program.press("\u{1b}[27u\u{1b}[27u");
        program.settle();
    }
    // The same name is proposed, and means the same file.
    program.press("S");
    program.wait_for("Save as");
    program.press("\r");
    program.wait_for("saved m");
    let text = fs::read_to_string(home.work().join(name(NAME))).unwrap();
    assert_safe("the file", text.replace('\r', "").as_bytes());
    let saved = beamtune::model::read(&text).unwrap().into_inner();
    let before = beamtune::model::read(&model()).unwrap().into_inner();
    assert_eq!(saved.subsystems[0].mass, 5.0);
    assert_eq!(
        (&saved.title, &saved.responses),
        (&before.title, &before.responses)
    );
    for ending in ["svg", "csv", "txt"] {
        program.press("\u{5}");
        program.wait_for("Export");
        program.press(&format!("\u{7f}\u{7f}\u{7f}{ending}\r"));
        program.wait_for(&format!("\\u{{202e}}.{ending}"));
        program.wait_for("written to m");
        let stem = NAME.strip_suffix(b"toml").unwrap();
        let file = home.work().join(name(&[stem, ending.as_bytes()].concat()));
        assert_safe(ending, &fs::read(file).unwrap());
        program.press("g");
        program.settle();
    }
    program.press("q");
    let code = program.exit();
    assert_eq!(code, 0);
    assert_sent_safe("the designer", &program.raw);
}

#[test]
fn a_hostile_file_that_cannot_be_opened_says_so_safely() {
    let home = Home::new();
    let evil = hidden(controls()) + &hidden(HIDDEN.iter().copied());
    let text = model() + &format!("\n[\"{}\"]\na = 1\n", in_toml(&evil));
    fs::write(home.file("bad.toml"), text).unwrap();
    let table = format!("Frequency,{evil}\nonce,{evil}\n");
    fs::write(home.file("bad.csv"), table).unwrap();
    // A remembered file with the same defect.
    let state = home.state("memory.toml");
    fs::create_dir_all(state.parent().unwrap()).unwrap();
    fs::write(&state, format!("[\"{}\"\n{evil}", in_toml(&evil))).unwrap();
    let mut program = Program::start(&home, &["fig08"]);
    program.wait_for("modes,");
    program.press("obad.toml\r");
    program.wait_for("not opened");
    program.press("\u{1b}[27u\u{f}");
    program.settle();
    program.press("bad.csv\r");
    program.settle();
    // Ctrl-C also works inside of a paste.
    let pasted = evil.replace('\u{3}', "");
    program.press(&format!("\u{1b}[200~{pasted}\u{1b}[201~"));
    program.settle();
    program.press("\u{3}");
    let _ = program.exit();
    assert_sent_safe("the designer", &program.raw);
    let log = fs::read(home.state("beamtune.log")).unwrap_or_default();
    assert_safe("the log", &log);
}

#[test]
fn a_hostile_configuration_is_refused_safely() {
    let home = Home::new();
    let evil = in_toml(&(hidden(controls()) + &hidden(HIDDEN.iter().copied())));
    home.configure(&format!(
        "[options]\n\"{evil}\" = 1\ncolor = \"{evil}\"\n[keys.model]\nundo = [\"{evil}\"]\n\"{evil}\" = []\n[\"{evil}\"]\n"
    ));
    let mut program = Program::start(&home, &["fig08"]);
    assert_eq!(program.exit(), 2);
    let raw = String::from_utf8(program.raw.clone()).unwrap();
    // The terminal's line ends.
    assert_safe("the faults", raw.replace("\r\n", "\n").as_bytes());
    assert!(
        raw.contains("\\u{1b}") && raw.contains("\\u{202e}"),
        "{raw}"
    );
}
