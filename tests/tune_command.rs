//! `beamtune tune`: its files, output and refusals, and the effect of signals.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;
use checked::checked;
use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::Output;

use assert_cmd::Command;
use beamtune::model::{self, Model};
use beamtune::{presets, solve};
use portable_pty::{CommandBuilder, PtySize, native_pty_system};

fn tune(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("beamtune").unwrap();
    command.arg("tune").args(arguments);
    command
}

fn run(arguments: &[&str]) -> Output {
    tune(arguments).output().unwrap()
}

/// Exit code, standard output and standard error.
fn said(output: &Output) -> (i32, String, String) {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (
        output.status.code().unwrap(),
        text(&output.stdout),
        text(&output.stderr),
    )
}

fn cantilever() -> &'static str {
    presets::find("cantilever").unwrap().text
}

/// The cantilever's file with another `[tune]`, in a folder.
fn with_tune(folder: &Path, tune: &str) -> String {
    let text = cantilever();
    let own = text.rfind("[tune]").unwrap();
    let file = folder.join("model.toml");
    fs::write(&file, format!("{}{tune}", &text[..own])).unwrap();
    file.to_str().unwrap().to_owned()
}

fn read(file: &Path) -> Model {
    let text = fs::read_to_string(file).unwrap();
    model::read(&text)
        .unwrap_or_else(|faults| panic!("{faults:?}\n{text}"))
        .into_inner()
}

/// The highest magnitude of a response over many frequencies of a band, by the sweep without refinement.
fn highest(model: &Model, response: &str, band: [f64; 2]) -> f64 {
    let points = 4000;
    let step = (band[1] - band[0]) / f64::from(points);
    let frequencies: Vec<f64> = (0..=points)
        .map(|point| f64::from(point).mul_add(step, band[0]))
        .collect();
    let frf = solve::sweep(&checked(model), &frequencies, &false.into()).unwrap();
    let column = frf.columns.iter().find(|one| one.name == response).unwrap();
    column
        .values
        .iter()
        .map(|value| value.norm())
        .fold(0.0, f64::max)
}

#[test]
fn the_tuned_file_keeps_the_comments_and_says_what_it_achieved() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("tuned.toml");
    let (code, table, errors) = said(&run(&["cantilever", "-o", file.to_str().unwrap()]));
    assert_eq!((code, errors.as_str()), (0, ""), "{table}");

    let (before, after) = (model::read(cantilever()).unwrap().into_inner(), read(&file));
    let spring = after.subsystems[0].y_left.clone();
    assert!((2e4..=1e6).contains(&spring.stiffness), "{spring:?}");
    assert!((10.0..=2000.0).contains(&spring.damping), "{spring:?}");
    // Nothing else has changed.
    let mut same = after.clone();
    same.subsystems[0].y_left = before.subsystems[0].y_left.clone();
    same.notes.clone_from(&before.notes);
    assert_eq!(same, before);

    let text = fs::read_to_string(&file).unwrap();
    for line in cantilever().lines().filter(|line| line.contains('#')) {
        let comment = &line[line.find('#').unwrap()..];
        assert!(text.contains(comment), "{comment} is gone");
    }
    let own = after.notes.strip_prefix(before.notes.trim_end()).unwrap();
    assert!(own.starts_with("\n\nTuned: "), "{own}");
    for part in [
        ", seed 1, ",
        "\nhighest peak of tip w, 15..60 Hz: ",
        "\nsubsystems.Damper.y_left.stiffness: 140 kN/m -> ",
        "\nsubsystems.Damper.y_left.damping: 150 N s/m -> ",
    ] {
        assert!(own.contains(part), "{part:?} in {own}");
    }

    // The reported peak is right, by the sweep without refinement; between its points a peak is higher by less than
    // 1e-3.
    let row = table
        .lines()
        .find(|line| line.starts_with("highest"))
        .unwrap();
    let cells: Vec<&str> = row
        .split("  ")
        .map(str::trim)
        .filter(|cell| !cell.is_empty())
        .collect();
    for (cell, model) in [(cells[1], &before), (cells[2], &after)] {
        let said: f64 = cell.strip_suffix(" m").unwrap().parse().unwrap();
        let found = highest(model, "tip w", [15.0, 60.0]);
        assert!((found / said - 1.0).abs() < 1e-3, "{said} m, {found} m");
    }
    let ratio = highest(&after, "tip w", [15.0, 60.0]) / highest(&before, "tip w", [15.0, 60.0]);
    assert!(ratio < 0.5, "the peak is {ratio} of what it was");
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let tuned = |name: &str, threads: &str| {
        let file = folder.path().join(name);
        let call = ["cantilever", "--seed", "7", "--budget", "150", "-o"];
        let output = tune(&call)
            .arg(&file)
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap();
        assert!(output.status.success());
        (fs::read(&file).unwrap(), output.stdout)
    };
    let first = tuned("one.toml", "1");
    assert_eq!(tuned("two.toml", "2"), first);
    assert_eq!(tuned("three.toml", "3"), first);
}

#[test]
fn without_a_file_there_is_only_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let output = tune(&["-", "--budget", "1"])
        .current_dir(folder.path())
        .write_stdin(cantilever())
        .output()
        .unwrap();
    let (code, table, errors) = said(&output);
    assert_eq!((code, errors.as_str()), (0, ""));
    let starts: Vec<&str> = table
        .lines()
        .map(|line| line.split("  ").next().unwrap())
        .collect();
    assert_eq!(
        starts,
        [
            "objective",
            "highest peak of tip w, 15..60 Hz",
            "",
            "variable",
            "subsystems.Damper.y_left.stiffness",
            "subsystems.Damper.y_left.damping",
            "",
            "1 model, seed 1, all evaluations were used",
        ]
    );
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_model_without_tune_is_refused_with_one_that_would_do() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("tuned.toml");
    let (code, table, errors) = said(&run(&["fig05a", "-o", file.to_str().unwrap()]));
    assert_eq!((code, table.as_str()), (2, ""));
    assert!(
        errors.starts_with("error: fig05a: has no [tune]"),
        "{errors}"
    );
    let example = &errors[errors.find("\n[tune]\n").unwrap()..];
    let whole = format!("{}{example}", presets::find("fig05a").unwrap().text);
    assert!(model::read(&whole).unwrap().into_inner().tune.is_some());
    assert!(!file.exists());
}

#[test]
fn bad_calls_are_refused_before_the_search() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("no folder/tuned.toml");
    for place in [missing.as_path(), folder.path()] {
        let (code, table, errors) = said(&run(&["cantilever", "-o", place.to_str().unwrap()]));
        assert_eq!((code, table.as_str()), (1, ""));
        assert!(errors.contains("cannot be written"), "{errors}");
    }
    for call in [
        ["cantilever", "--budget", "0"],
        ["cantilever", "--seed", "-1"],
        ["cantilever", "--set", "tune.variables=1"],
    ] {
        let (code, table, errors) = said(&run(&call));
        assert_eq!((code, table.as_str()), (2, ""), "{errors}");
        assert!(errors.starts_with("error: "), "{errors}");
    }
    let measured = with_tune(
        folder.path(),
        r#"[tune]
variables = [ { path = "subsystems.Damper.mass", min = 1.0, max = 9.0 } ]
objective = { match = "nowhere.csv", response = "tip w", from = 15.0, to = 60.0 }
"#,
    );
    let (code, table, errors) = said(&run(&[&measured]));
    assert_eq!((code, table.as_str()), (2, ""));
    assert!(errors.contains("nowhere.csv"), "{errors}");
}

/// Expected: the curve is that of the cantilever with 140 kN/m, in "G" of 9.80665 m/s2 (NIST SP 811).
#[test]
fn a_match_takes_the_unit_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let curve = "tests/data/measured/universal/match_capital_g.uff";
    fs::copy(curve, folder.path().join("curve.uff")).unwrap();
    let file = with_tune(
        folder.path(),
        r#"[tune]
variables = [
    { path = "subsystems.Damper.y_left.stiffness", min = 2.0e4, max = 1.0e6 },
    { path = "subsystems.Damper.y_left.damping", min = 10.0, max = 2000.0 },
]
objective = { match = "curve.uff", compare = "complex", response = "tip w", from = 16.0, to = 59.0 }
"#,
    );
    let text = fs::read_to_string(&file).unwrap();
    fs::write(
        &file,
        text.replace("stiffness = 1.4e5", "stiffness = 1.3e5"),
    )
    .unwrap();
    let tuned = folder.path().join("tuned.toml");
    let arguments = [&file, "--budget", "400", "-o", tuned.to_str().unwrap()];
    let (code, _, errors) = said(&run(&arguments));
    assert_eq!(code, 0, "{errors}");
    let stiffness = read(&tuned).subsystems[0].y_left.stiffness;
    assert!((stiffness / 1.4e5 - 1.0).abs() < 1e-3, "{stiffness}");

    // An unknown unit cannot be a unit of the response.
    let text = fs::read_to_string(curve).unwrap();
    let text = text.replace("Acceleration         G ", "Acceleration         Q ");
    fs::write(folder.path().join("curve.uff"), text).unwrap();
    let (code, _, errors) = said(&run(&[&file]));
    assert_eq!(code, 2, "{errors}");
    assert!(errors.contains("\"Q\" is not a known unit"), "{errors}");
}

#[test]
fn limits_tolerances_and_values_beyond_the_bounds_are_spoken_of() {
    let folder = tempfile::tempdir().unwrap();
    let file = with_tune(
        folder.path(),
        r#"[tune]
variables = [
    { path = "subsystems.Damper.mass", min = 5.0, max = 9.0 },
    { path = "subsystems.Damper.y_left.damping", min = 10.0, max = 2000.0, tolerance = 10.0 },
]
objectives = [
    { minimise = "peak", response = "tip w", from = 15.0, to = 60.0 },
    { minimise = "mean_square", response = "tip w", from = 15.0, to = 60.0, weight = 2.0 },
    { minimise = "energy", from = 15.0, to = 60.0 },
]
limits = [ { limit = "added_mass", at_most = 1.0 } ]
"#,
    );
    let (code, table, errors) = said(&run(&[&file, "--budget", "30"]));
    assert_eq!(code, 0, "{errors}");
    assert_eq!(
        errors,
        "warning: subsystems.Damper.mass is outside its bounds; the search starts at the nearer one\n\
         warning: no model within all limits was found\n"
    );
    for part in [
        "worst over the tolerances",
        "2 corners, 200 points",
        "at most 1 kg: NOT KEPT",
        "mean square of tip w, 15..60 Hz",
        " m2 ",
        "mean vibration energy, 15..60 Hz",
    ] {
        assert!(table.contains(part), "{part:?} in\n{table}");
    }
    // The least allowed mass is nearest to the limit.
    let mass = table
        .lines()
        .find(|line| line.starts_with("subsystems.Damper.mass"))
        .unwrap();
    assert!(
        mass.contains("4 kg ") && mass.contains("5 kg ") && mass.contains("at the lower bound"),
        "{mass}"
    );
}

/// A search that takes far longer than a test: twelve variables on the three absorbers.
const LONG: &str = r#"
[tune]
variables = [
    { path = "subsystems.S1.y_left.stiffness", min = 1.0e5, max = 1.0e9 },
    { path = "subsystems.S1.y_left.damping", min = 1.0, max = 1.0e5 },
    { path = "subsystems.S1.z_left.stiffness", min = 1.0e5, max = 1.0e9 },
    { path = "subsystems.S1.z_left.damping", min = 1.0, max = 1.0e5 },
    { path = "subsystems.S2.y_left.stiffness", min = 1.0e5, max = 1.0e9 },
    { path = "subsystems.S2.y_left.damping", min = 1.0, max = 1.0e5 },
    { path = "subsystems.S2.z_left.stiffness", min = 1.0e5, max = 1.0e9 },
    { path = "subsystems.S2.z_left.damping", min = 1.0, max = 1.0e5 },
    { path = "subsystems.S3.y_left.stiffness", min = 1.0e5, max = 1.0e9 },
    { path = "subsystems.S3.y_left.damping", min = 1.0, max = 1.0e5 },
    { path = "subsystems.S3.z_left.stiffness", min = 1.0e5, max = 1.0e9 },
    { path = "subsystems.S3.z_left.damping", min = 1.0, max = 1.0e5 },
]
objective = { minimise = "peak", response = "P5 w", from = 1.0, to = 400.0 }
"#;

/// Runs the program on its own terminal and sends a signal each time it shows one of some texts; returns its exit code
/// and output.
fn signalled(command: CommandBuilder, signals: &[(&str, &str)]) -> (u32, String) {
    let pair = native_pty_system()
        .openpty(PtySize {
            rows: 24,
            cols: 100,
            pixel_width: 0,
            pixel_height: 0,
        })
        .unwrap();
    let mut child = pair.slave.spawn_command(command).unwrap();
    drop(pair.slave);
    let mut reader = pair.master.try_clone_reader().unwrap();
    let mut written = Vec::new();
    let mut left = signals.iter();
    let mut next = left.next();
    let mut piece = [0; 4096];
    // The terminal ends with the program; once it is closed, reading fails.
    while let Ok(count @ 1..) = reader.read(&mut piece) {
        written.extend_from_slice(&piece[..count]);
        let text = String::from_utf8_lossy(&written);
        if let Some((words, signal)) = next
            && text.contains(words)
        {
            next = left.next();
            let id = child.process_id().unwrap().to_string();
            let kill = std::process::Command::new("kill")
                .args([&format!("-{signal}"), &id])
                .status();
            assert!(kill.unwrap().success());
        }
    }
    let text = String::from_utf8_lossy(&written).into_owned();
    assert!(next.is_none(), "{next:?} was not there: {text}");
    (child.wait().unwrap().exit_code(), text)
}

/// The search of a model without end, into a file.
fn endless(model: &Path, output: &Path) -> CommandBuilder {
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_beamtune"));
    command.arg("tune");
    command.arg(model);
    command.args(["--budget", "1000000000", "-o"]);
    command.arg(output);
    command.cwd(env!("CARGO_MANIFEST_DIR"));
    command
}

/// The signals that end a search, and the exit codes: 128 and the number of the signal (signal(7)).
const ENDS: [(&str, u32); 4] = [("INT", 130), ("TERM", 143), ("HUP", 129), ("QUIT", 131)];

#[test]
fn a_signal_ends_the_search_and_the_best_so_far_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("long.toml");
    let text = presets::find("fig05a").unwrap().text;
    fs::write(&file, format!("{text}{LONG}")).unwrap();
    for (signal, expected) in ENDS {
        let tuned = folder.path().join(format!("{signal}.toml"));
        let (code, text) = signalled(endless(&file, &tuned), &[(" models", signal)]);
        assert_eq!(code, expected, "SIG{signal}: {text}");
        assert!(text.contains("stopped: the best so far"), "{text}");
        let found = read(&tuned);
        assert!(found.notes.contains("cancelled"), "{}", found.notes);
        assert!(text.contains("highest peak of P5 w"), "{text}");
        // The progress line is removed before other output.
        let after = &text[text.rfind("\r\u{1b}[K").unwrap()..];
        assert!(
            after.contains("stopped") && !after.contains(" left"),
            "{after:?}"
        );
    }
}

/// The second signal comes while the result is evaluated, or just after that; the best result is available either way.
#[test]
fn a_second_signal_loses_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let (file, tuned) = (
        folder.path().join("long.toml"),
        folder.path().join("tuned.toml"),
    );
    let text = presets::find("fig05a").unwrap().text;
    fs::write(&file, format!("{text}{LONG}")).unwrap();
    let signals = [(" models", "TERM"), ("stopping", "INT")];
    let (code, text) = signalled(endless(&file, &tuned), &signals);
    assert!(text.contains("stopped: the best so far"), "{text}");
    let notes = read(&tuned).notes;
    // 128 and the number of the signal that ended the program.
    match code {
        130 => assert!(notes.contains("cancelled before"), "{notes}"),
        143 => assert!(notes.contains("highest peak of P5 w"), "{notes}"),
        _ => panic!("{code}: {text}"),
    }
    let names: Vec<_> = fs::read_dir(folder.path()).unwrap().collect();
    assert_eq!(names.len(), 2, "{names:?}");
}

/// As with `nohup`: the search continues, and another signal ends it.
#[test]
fn a_signal_that_is_ignored_from_the_start_ends_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let (file, tuned) = (
        folder.path().join("long.toml"),
        folder.path().join("tuned.toml"),
    );
    let text = presets::find("fig05a").unwrap().text;
    fs::write(&file, format!("{text}{LONG}")).unwrap();
    let mut command = CommandBuilder::new("/bin/sh");
    command.args(["-c", "trap '' HUP; exec \"$@\"", "sh"]);
    command.args(endless(&file, &tuned).get_argv());
    let signals = [(" models", "HUP"), ("best", "TERM")];
    let (code, text) = signalled(command, &signals);
    assert_eq!(code, 143, "{text}");
    assert!(read(&tuned).notes.contains("cancelled"));
}
