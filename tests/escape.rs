//! Text from files reaches a terminal, a log and a table escaped, in every command; and a write error of standard
//! output is reported.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::{OsStrExt as _, OsStringExt as _};
use std::path::Path;
use std::process::{Command, Output, Stdio};

use beamtune::{model, presets};

#[path = "fuzz/dice.rs"]
#[allow(dead_code)]
mod dice;
#[path = "common/hidden.rs"]
mod hidden;
#[path = "common/hostile.rs"]
mod hostile;

use dice::Dice;
use hidden::{assert_safe, controls, in_toml};
use hostile::{hostile, hostile_model};

const BEAMTUNE: &str = env!("CARGO_BIN_EXE_beamtune");

fn run<A: AsRef<OsStr>>(folder: &Path, arguments: &[A]) -> Output {
    let mut command = Command::new(BEAMTUNE);
    command.args(arguments).current_dir(folder);
    command.stdin(Stdio::null()).output().unwrap()
}

/// Standard output and standard error contain no control characters.
fn assert_output_safe(what: &str, output: &Output) {
    assert_safe(&format!("{what}, output"), &output.stdout);
    assert_safe(&format!("{what}, errors"), &output.stderr);
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("no signal")
}

fn errors(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn a_hostile_model_is_escaped_by_every_command_and_stays_what_it_is() {
    let mut dice = Dice(7);
    for round in 0..3 {
        let folder = tempfile::tempdir().unwrap();
        let (name, title) = (hostile(&mut dice, &[]), hostile(&mut dice, &controls()));
        let text = hostile_model(&name, &title);
        let model = model::read(&text).unwrap().into_inner();
        let file = OsString::from_vec([b"m\x1b[2J\xff", name.as_bytes(), b".toml"].concat());
        fs::write(folder.path().join(&file), &text).unwrap();
        let out = OsString::from_vec([b"o\x1b]0;\xfe", name.as_bytes()].concat());
        let study = format!("{name} stiffness");
        let response = &model.responses[0].name;
        assert!(response.starts_with('='));
        let calls: [&[&str]; 9] = [
            &["check"],
            &["frf", "--at", "20"],
            &["frf", "--at", "20", "--study", &study],
            &["frf", "--at", "20", "--format", "uff"],
            &["modes", "--to", "60", "--shapes", "OUT"],
            &["sensitivities", "--at", "20", "--response", response],
            &["spread", "--at", "20", "--samples", "3"],
            &["tune", "--budget", "3", "-o", "OUT"],
            &[
                "validate",
                "--at",
                "20",
                "--elements",
                "8",
                "--tolerance",
                "1e9",
            ],
        ];
        for call in calls {
            let mut arguments: Vec<OsString> = call.iter().map(OsString::from).collect();
            arguments.insert(1, file.clone());
            for argument in &mut arguments {
                if argument == "OUT" {
                    argument.clone_from(&out);
                }
            }
            let output = run(folder.path(), &arguments);
            let what = format!("round {round}, {call:?}");
            assert_eq!(code(&output), 0, "{what}: {}", errors(&output));
            assert_output_safe(&what, &output);
            if call.contains(&"OUT") {
                assert_safe(&what, &fs::read(folder.path().join(&out)).unwrap());
            }
            if call[0] == "frf" && call.contains(&"uff") {
                let lines = String::from_utf8(output.stdout).unwrap();
                let named = |line: &str| line.starts_with("=tipx\\u{");
                assert!(lines.lines().any(named), "{lines}");
            } else if call[0] == "frf" && !call.contains(&"--study") {
                let lines = String::from_utf8(output.stdout).unwrap();
                assert!(lines.starts_with("frequency_hz,'=tipx\\u{"), "{lines}");
            }
        }
        // The last tuned names are complete, to the last character.
        let tuned = fs::read_to_string(folder.path().join(&out)).unwrap();
        let tuned = model::read(&tuned).unwrap().into_inner();
        assert_eq!(tuned.title, model.title);
        assert_eq!(tuned.responses, model.responses);
        assert_eq!(tuned.subsystems[0].name, name);
        assert!(tuned.notes.contains(&name));
    }
}

/// Every view of the designer measures and draws escaped names: the final check of the cells, which inserts a
/// replacement character, finds nothing.
#[test]
fn hostile_arguments_are_refused_escaped() {
    let mut dice = Dice(11);
    let folder = tempfile::tempdir().unwrap();
    let controls: Vec<char> = controls().into_iter().filter(|c| *c != '\0').collect();
    for round in 0..2 {
        let e = hostile(&mut dice, &controls);
        let joined = |before: &str, after: &str| format!("{before}{e}{after}");
        let (inside, option) = (joined("", "/o.csv"), joined("--", ""));
        let [set, length, mass] = [
            joined("", ""),
            joined("beam.length=", ""),
            joined("subsystems.", ".mass=1"),
        ];
        let named = joined("subsystems.S1.name=", "");
        let calls: Vec<Vec<&str>> = vec![
            vec![&e],
            vec![&e, &e],
            vec![&option],
            vec!["check", &e],
            vec!["show", &e],
            vec!["frf", &e],
            vec!["frf", "fig08", "--study", &e],
            vec!["frf", "fig08", "--at", &e],
            vec!["frf", "fig08", "--format", &e],
            vec!["frf", "fig08", &e],
            vec!["frf", "fig08", &option],
            vec!["frf", "fig08", "--at", "5", "-o", &inside],
            vec!["frf", "fig08", "--set", &set],
            vec!["frf", "fig08", "--set", &length],
            vec!["frf", "fig08", "--set", &mass],
            vec!["frf", "fig08", "--set", &named],
            vec!["modes", "fig08", "--to", &e],
            vec!["modes", "fig08", "--to", "9", "--shapes", &inside],
            vec!["sensitivities", "fig08", "--at", "5", "--response", &e],
            vec!["sensitivities", "fig08", "--band", &e],
            vec!["spread", "cantilever", "--samples", &e],
            vec!["tune", "cantilever", "--budget", &e],
            vec!["tune", "cantilever", "--budget", "3", "-o", &inside],
            vec!["validate", "fig08", "--elements", &e],
            vec!["validate", &e],
            vec!["completions", &e],
            vec!["fig08", "--color", &e],
        ];
        for call in &calls {
            let output = run(folder.path(), call);
            let what = format!("round {round}, {call:?}");
            assert_ne!(code(&output), 0, "{what}");
            assert!(!output.stderr.is_empty(), "{what}");
            assert_output_safe(&what, &output);
            // `x` and the first hidden character.
            let shown = errors(&output);
            let silent = call
                .iter()
                .any(|word| matches!(*word, "--at" | "--to" | "--band"));
            assert!(silent || shown.contains("x\\"), "{what}: {shown}");
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        let mut paths = Command::new(BEAMTUNE);
        let home = OsString::from_vec([b"/\xff", e.as_bytes()].concat());
        paths
            .arg("paths")
            .env("XDG_CONFIG_HOME", &home)
            .env("XDG_STATE_HOME", home);
        let output = paths.output().unwrap();
        assert_eq!(code(&output), 0, "{}", errors(&output));
        assert_output_safe("paths", &output);
        assert!(
            String::from_utf8(output.stdout)
                .unwrap()
                .contains("/\\xffx")
        );
    }
}

/// Places in a file with free text, and the text; `@` is the hostile text, `%` the same without escapes.
const PLACES: [(&str, &str); 21] = [
    ("[beam]\n", "\"@\" = 1\n[beam]\n"),
    ("[beam]\n", "[beam]\n\"@\" = 1\n"),
    ("[beam]\n", "[\"@\"]\n[beam]\n"),
    ("[beam]\n", "[[\"@\".a]]\n[beam]\n"),
    ("[beam]\n", "%\n[beam]\n"),
    ("[beam]\n", "a = \"\\%\"\n[beam]\n"),
    ("[beam]\n", "a = %\n[beam]\n"),
    ("beamtune/1", "@"),
    ("length = 3.2", "length = \"@\""),
    ("kind = \"clamped\"", "kind = \"@\""),
    ("kind = \"clamped\"", "kind = { \"@\" = 1 }"),
    ("name = \"Damper\"", "name = \"@\""),
    ("at = \"right\"", "at = \"@\""),
    ("direction = \"psi\"", "direction = \"@\""),
    ("measure = \"acceleration\"", "measure = \"@\""),
    ("spacing = \"log\"", "spacing = \"@\""),
    (
        "vary = [\"subsystems.Damper.y_left.stiffness\"]",
        "vary = [\"@\"]",
    ),
    (
        "vary = [\"subsystems.Damper.y_left.stiffness\"]",
        "vary = [\"subsystems.@.mass\"]",
    ),
    (
        "path = \"subsystems.Damper.y_left.stiffness\"",
        "path = \"@\"",
    ),
    ("minimise = \"peak\"", "minimise = \"@\""),
    ("response = \"tip w\"", "response = \"@\""),
];

#[test]
fn faults_of_a_hostile_file_are_escaped() {
    let mut dice = Dice(23);
    let folder = tempfile::tempdir().unwrap();
    let text = presets::find("cantilever").unwrap().text;
    for (from, to) in PLACES {
        assert!(text.contains(from), "{from}");
        let hostile = format!("{}\u{1b}]0;x\u{7}", hostile(&mut dice, &controls()));
        let to = to.replace('@', &in_toml(&hostile)).replace('%', &hostile);
        fs::write(folder.path().join("m.toml"), text.replacen(from, &to, 1)).unwrap();
        for command in ["check", "tune"] {
            let output = run(folder.path(), &[command, "m.toml"]);
            assert_eq!(code(&output), 2, "{to:?}: {}", errors(&output));
            assert_output_safe(&format!("{to:?}"), &output);
            // A line feed in the file does not begin a new line here.
            for line in errors(&output).lines() {
                assert!(line.starts_with("error: m.toml:"), "{to:?}: {line}");
            }
        }
    }
}

#[test]
fn measured_headers_are_escaped() {
    let mut dice = Dice(31);
    let folder = tempfile::tempdir().unwrap();
    let text = presets::find("cantilever").unwrap().text;
    let evil = "m\u{200b}\u{202e}.csv";
    for (file, objective, expected) in [
        ("m.csv", "match = \"m.csv\", curve = \"none\"", 2),
        (evil, "match = \"FILE\", curve = \"CURVE\"", 0),
        (evil, "match = \"FILE\", curve = \"none\"", 2),
        ("m.csv", "match = \"FILE\"", 2),
    ] {
        let folder = folder.path();
        let curve = hostile(&mut dice, &['\u{1b}', '\u{7f}', '\u{9b}']);
        let objective = objective.replace("CURVE", &in_toml(&curve));
        let objective = objective.replace("FILE", &in_toml(evil));
        let model = text.replace("minimise = \"peak\"", &objective);
        fs::write(folder.join("b.toml"), model).unwrap();
        let rows = "20,1e-5,0\n30,2e-5,0\n40,1e-5,0\n50,5e-6,0\n";
        let head = format!("Frequency [Hz],{curve}.re [m/N],{curve}.im [m/N]");
        fs::write(folder.join(file), format!("{head}\n{rows}")).unwrap();
        let output = run(folder, &["tune", "b.toml", "--budget", "3"]);
        assert_eq!(code(&output), expected, "{}", errors(&output));
        assert_output_safe(&objective, &output);
        let said = [&output.stdout[..], &output.stderr].concat();
        assert!(
            String::from_utf8(said).unwrap().contains("\\u{"),
            "{objective}"
        );
        fs::remove_file(folder.join(file)).unwrap();
    }
}

#[test]
fn fifty_faults_are_printed_and_how_many_more() {
    let folder = tempfile::tempdir().unwrap();
    let text = presets::find("fig06").unwrap().text;
    let keys: Vec<String> = (0..80)
        .map(|number| format!("unknown_{number} = 1\n"))
        .collect();
    fs::write(folder.path().join("m.toml"), keys.concat() + text).unwrap();
    let output = run(folder.path(), &["check", "m.toml"]);
    assert_eq!(code(&output), 2);
    let errors = errors(&output);
    assert_eq!(errors.lines().count(), 51, "{errors}");
    assert_eq!(errors.lines().last(), Some("error: m.toml: and 30 more"));
}

/// The standard library's formats accept no width above 65,535.
#[test]
fn a_name_of_65536_letters_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let text = presets::find("cantilever").unwrap().text;
    for name in ["tip w", "Damper", "Damper stiffness"] {
        let long = format!("\"{}\"", "n".repeat(65_536));
        fs::write(
            folder.path().join("m.toml"),
            text.replace(&format!("\"{name}\""), &long),
        )
        .unwrap();
        for command in ["check", "validate", "tune", "frf"] {
            let output = run(folder.path(), &[command, "m.toml"]);
            assert_eq!(code(&output), 2, "{command}: {}", errors(&output).len());
            let wanted = "name: is 65536 characters long; must be at most 200";
            assert!(errors(&output).contains(wanted), "{command}");
        }
    }
}

#[test]
fn a_file_whose_name_is_no_text_is_opened_and_written() {
    let folder = tempfile::tempdir().unwrap();
    let text = presets::find("cantilever").unwrap().text;
    let name = |bytes: &[u8]| OsString::from_vec(bytes.to_vec());
    let [file, table] = [name(b"m\xff.toml"), name(b"t\xfe.csv")];
    fs::write(folder.path().join(&file), text).unwrap();
    let words = |words: &[&str]| words.iter().map(OsString::from).collect::<Vec<_>>();
    for command in ["check", "frf", "modes", "validate"] {
        let mut arguments = words(&[command]);
        arguments.push(file.clone());
        let output = run(folder.path(), &arguments);
        assert_eq!(code(&output), 0, "{command}: {}", errors(&output));
    }
    let mut arguments = words(&["frf", "cantilever", "--at", "5", "-o"]);
    arguments.push(table.clone());
    assert_eq!(code(&run(folder.path(), &arguments)), 0);
    assert!(folder.path().join(&table).exists());
    fs::write(folder.path().join(&file), "a = ").unwrap();
    let output = run(
        folder.path(),
        &[OsStr::new("check"), OsStr::from_bytes(b"m\xff.toml")],
    );
    assert!(
        errors(&output).starts_with("error: m\\xff.toml:1:"),
        "{}",
        errors(&output)
    );
}

/// Calls that write to standard output.
const WRITERS: [&str; 14] = [
    "presets",
    "show fig06",
    "frf fig06 --at 5",
    "frf fig06 --at 5 --format uff",
    "modes fig06 --to 9",
    "sensitivities fig06 --at 5",
    "spread m.toml --at 5 --samples 2",
    "validate fig06 --at 5 --elements 4",
    "tune cantilever --budget 3",
    "paths",
    "completions bash",
    "man",
    "--help",
    "--version",
];

#[test]
fn an_output_that_goes_nowhere_is_a_failure() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("m.toml"), hostile_model("Damper", "t")).unwrap();
    let script = |script: String| {
        let mut shell = Command::new("/bin/sh");
        shell
            .current_dir(folder.path())
            .args(["-c", &script])
            .env("BEAMTUNE", BEAMTUNE)
            .env("HOME", "/nowhere");
        shell.output().unwrap()
    };
    for call in WRITERS {
        let closed = script(format!("\"$BEAMTUNE\" {call} >&-"));
        assert_eq!(code(&closed), 1, "{call}: {}", errors(&closed));
        let wanted = "error: standard output: cannot be written: it is closed\n";
        assert!(
            errors(&closed).ends_with(wanted),
            "{call}: {}",
            errors(&closed)
        );
        let open = script(format!("\"$BEAMTUNE\" {call} 1<>/dev/null"));
        assert_eq!(code(&open), 0, "{call}: {}", errors(&open));
        // A reader that closes early.
        let head = script(format!("{{ \"$BEAMTUNE\" {call}; echo $? >&2; }} | true"));
        assert!(errors(&head).ends_with("0\n"), "{call}: {}", errors(&head));
        assert!(
            !errors(&head).contains("error"),
            "{call}: {}",
            errors(&head)
        );
        if cfg!(target_os = "linux") {
            let full = script(format!("\"$BEAMTUNE\" {call} >/dev/full"));
            assert_eq!(code(&full), 1, "{call}");
            let wanted = "error: standard output: cannot be written: No space left";
            assert!(errors(&full).contains(wanted), "{call}: {}", errors(&full));
        }
    }
}

#[test]
fn a_file_that_cannot_be_written_has_the_name_that_was_given() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("m.toml"), hostile_model("Damper", "t")).unwrap();
    for call in [
        "frf fig06 --at 5 -o missing/o",
        "frf fig06 --at 5 --format uff -o missing/o",
        "modes fig06 --to 9 -o missing/o",
        "modes fig06 --to 9 --shapes missing/o",
        "sensitivities fig06 --at 5 -o missing/o",
        "spread m.toml --at 5 --samples 2 -o missing/o",
        "tune cantilever --budget 3 -o missing/o",
    ] {
        let arguments: Vec<&str> = call.split(' ').collect();
        let output = run(folder.path(), &arguments);
        assert_eq!(code(&output), 1, "{call}");
        let said = errors(&output);
        let wanted =
            "error: missing/o: cannot be written: No such file or directory (os error 2)\n";
        assert!(said.ends_with(wanted), "{call}: {said}");
        if cfg!(target_os = "linux") {
            let call = call.replace("missing/o", "/dev/full");
            let output = run(folder.path(), &call.split(' ').collect::<Vec<_>>());
            assert_eq!(code(&output), 1, "{call}");
            let wanted =
                "error: /dev/full: cannot be written: No space left on device (os error 28)\n";
            assert!(
                errors(&output).ends_with(wanted),
                "{call}: {}",
                errors(&output)
            );
        }
    }
}

#[test]
fn a_misspelt_command_is_answered_by_the_one_that_was_meant() {
    let folder = tempfile::tempdir().unwrap();
    for (call, meant) in [
        ("frm x.toml", "frf"),
        ("frm", "frf"),
        ("frm fig06 --at 5", "frf"),
        ("chek fig06", "check"),
        ("sensitivty fig06", "sensitivities"),
    ] {
        let arguments: Vec<&str> = call.split(' ').collect();
        let output = run(folder.path(), &arguments);
        assert_eq!(code(&output), 2, "{call}");
        let wanted = format!(
            "error: no command, file or preset is named `{}`; did you mean `beamtune {meant}`?\n",
            arguments[0]
        );
        assert_eq!(errors(&output), wanted);
    }
    // A file of this name is one.
    fs::write(
        folder.path().join("frm"),
        presets::find("fig06").unwrap().text,
    )
    .unwrap();
    let output = run(folder.path(), &["frm", "fig06"]);
    assert!(
        !errors(&output).contains("no command"),
        "{}",
        errors(&output)
    );
}
