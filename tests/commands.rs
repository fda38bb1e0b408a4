//! The commands as used in a script: output, exit codes, files.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;

use checked::checked;
use std::path::Path;

use assert_cmd::Command;
use beamtune::{guide, presets};

#[path = "commands/measured.rs"]
mod measured;

fn beamtune(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("beamtune").unwrap();
    command.args(arguments);
    command
}

fn output(arguments: &[&str]) -> String {
    let assert = beamtune(arguments).assert().success();
    String::from_utf8(assert.get_output().stdout.clone()).unwrap()
}

/// The exit code and standard error of a call that must fail and print nothing on standard output.
fn failure(arguments: &[&str]) -> (i32, String) {
    let output = beamtune(arguments).output().unwrap();
    assert!(
        output.stdout.is_empty(),
        "{:?}",
        String::from_utf8_lossy(&output.stdout)
    );
    (
        output.status.code().unwrap(),
        String::from_utf8(output.stderr).unwrap(),
    )
}

fn rows(csv: &str) -> Vec<Vec<&str>> {
    csv.lines().map(|line| line.split(',').collect()).collect()
}

#[test]
fn presets_are_listed_and_shown() {
    let list = output(&["presets"]);
    assert_eq!(list.lines().count(), presets::ALL.len());
    for (line, preset) in list.lines().zip(presets::ALL) {
        assert!(
            line.starts_with(preset.name) && line.ends_with(&preset.title()),
            "{line}"
        );
        assert_eq!(output(&["show", preset.name]), preset.text);
        assert_eq!(output(&["check", preset.name]), "");
    }
}

#[test]
fn the_guide_lists_its_chapters_and_shows_one() {
    let list = output(&["guide"]);
    assert_eq!(list.lines().count(), guide::CHAPTERS.len());
    for (line, chapter) in list.lines().zip(guide::CHAPTERS) {
        assert!(line.starts_with(chapter.name), "{line}");
        assert!(line.ends_with(chapter.summary()), "{line}");
        let text = output(&["guide", chapter.name]);
        assert!(
            text.starts_with(&format!("# {}", &chapter.title()[..20])),
            "{text}"
        );
        assert!(!text.contains("<!--") && !text.contains("```"), "{text}");
        assert!(
            text.lines().all(|line| line.chars().count() <= 80),
            "{text}"
        );
    }
}

#[test]
fn an_unknown_chapter_is_answered_by_the_nearest_and_all() {
    let (code, message) = failure(&["guide", "tunning"]);
    assert_eq!(code, 2);
    assert!(
        message.contains("a similar value exists: 'tuning'"),
        "{message}"
    );
    for chapter in guide::CHAPTERS {
        assert!(message.contains(chapter.name), "{message}");
    }
}

#[test]
fn frf_writes_a_column_pair_for_each_response_and_numbers_that_read_back() {
    let csv = output(&["frf", "fig08", "--at", "5,20.5,80"]);
    let rows = rows(&csv);
    let header =
        "frequency_hz,right w.re,right w.im,right psi.re,right psi.im,right v.re,right v.im";
    assert_eq!(rows[0].join(","), header);
    let frequencies: Vec<f64> = rows[1..]
        .iter()
        .map(|row| row[0].parse().unwrap())
        .collect();
    assert_eq!(frequencies, [5.0, 20.5, 80.0]);
    let model = beamtune::model::read(presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    let solved = beamtune::solve::sweep(&checked(&model), &frequencies, &false.into()).unwrap();
    for (index, row) in rows[1..].iter().enumerate() {
        let cells: Vec<f64> = row[1..].iter().map(|cell| cell.parse().unwrap()).collect();
        let expected: Vec<f64> = solved
            .columns
            .iter()
            .flat_map(|c| [c.values[index].re, c.values[index].im])
            .collect();
        assert_eq!(cells, expected);
    }
}

#[test]
fn an_energy_is_one_column_and_a_study_one_block_a_curve() {
    let csv = output(&["frf", "fig13", "--at", "10,20"]);
    assert_eq!(csv.lines().next(), Some("frequency_hz,E_V"));
    let model = beamtune::model::read(presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    let csv = output(&[
        "frf",
        "fig08",
        "--at",
        "10,20",
        "--study",
        &model.studies[0].name,
    ]);
    let rows = rows(&csv);
    assert_eq!(rows[0][..2], ["curve", "frequency_hz"]);
    let curves: Vec<f64> = rows[1..]
        .iter()
        .map(|row| row[0].parse().unwrap())
        .collect();
    assert_eq!(curves, [0.5, 0.5, 1.0, 1.0, 2.0, 2.0, 4.0, 4.0]);
}

#[test]
fn without_at_the_sweep_of_the_model_is_solved() {
    let csv = output(&[
        "frf",
        "fig06",
        "--set",
        "sweep.points=11",
        "--set",
        "sweep.to=101",
        "--set",
        "sweep.from=1 Hz",
    ]);
    let frequencies: Vec<f64> = rows(&csv)[1..]
        .iter()
        .map(|row| row[0].parse().unwrap())
        .collect();
    assert_eq!(
        frequencies,
        [
            1.0, 11.0, 21.0, 31.0, 41.0, 51.0, 61.0, 71.0, 81.0, 91.0, 101.0
        ]
    );
}

/// The first column of a CSV, which has the frequencies.
fn frequencies(csv: &str) -> Vec<f64> {
    let rows = rows(csv);
    let cells = rows[1..].iter().map(|row| row[0].parse().unwrap());
    cells.collect()
}

#[test]
fn resolve_adds_rows_between_those_of_the_sweep() {
    let plain = output(&["frf", "fig06"]);
    let resolved = output(&["frf", "fig06", "--resolve"]);
    let (base, all) = (frequencies(&plain), frequencies(&resolved));
    assert!(all.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!((all.first(), all.last()), (base.first(), base.last()));
    assert!(all.len() > base.len() + 200 && all.len() < 2 * base.len());
    let lines: std::collections::HashSet<&str> = resolved.lines().collect();
    assert!(plain.lines().all(|line| lines.contains(line)));
}

/// A sweep longer than a block of the solver is resolved like the whole.
#[test]
fn resolve_does_not_depend_on_blocks() {
    let sets = ["--set", "sweep.points=9000", "--set", "sweep.to=200"];
    let csv = output(&[&["frf", "fig08", "--resolve"], &sets[..]].concat());
    let mut model = beamtune::model::read(presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    (model.sweep.points, model.sweep.to) = (9000, 200.0);
    let base = beamtune::solve::frequencies(&model.sweep);
    let modes = beamtune::solve::modes::modes(&checked(&model), 200.0, &false.into()).unwrap();
    let whole =
        beamtune::solve::peaks::refined(&checked(&model), &modes, &base, &false.into()).unwrap();
    assert!(whole.len() > 9020);
    assert_eq!(frequencies(&csv), whole);
}

#[test]
fn resolve_follows_each_curve_of_a_study() {
    let model = beamtune::model::read(presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    let study = &model.studies[0].name;
    let few = ["--set", "sweep.points=50"];
    let csv = output(&[&["frf", "fig08", "--resolve", "--study", study], &few[..]].concat());
    let rows = rows(&csv);
    let curves = [0.5, 1.0, 2.0, 4.0].map(|factor| {
        let of_curve = rows[1..].iter().filter(|row| row[0].parse() == Ok(factor));
        let cells = of_curve.map(|row| row[1].parse().unwrap());
        cells.collect::<Vec<f64>>()
    });
    for curve in &curves {
        assert!(curve.len() > 100 && curve.windows(2).all(|pair| pair[0] < pair[1]));
    }
    assert_ne!(curves[0], curves[3]);
}

#[test]
fn set_changes_parameters_by_path_and_wildcard() {
    let plain = output(&["frf", "fig05a", "--at", "50"]);
    let heavier = output(&[
        "frf",
        "fig05a",
        "--at",
        "50",
        "--set",
        "subsystems.*.mass=*2",
    ]);
    let one_by_one: Vec<String> = ["S1", "S2", "S3"]
        .map(|name| format!("subsystems.{name}.mass=200 kg"))
        .into();
    let mut arguments = vec!["frf", "fig05a", "--at", "50"];
    for set in &one_by_one {
        arguments.extend(["--set", set]);
    }
    assert_ne!(plain, heavier);
    assert_eq!(output(&arguments), heavier);
}

#[test]
fn frf_writes_a_file_and_leaves_it_alone_when_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("out.csv");
    let name = file.to_str().unwrap();
    assert_eq!(output(&["frf", "fig06", "--at", "10", "-o", name]), "");
    let written = std::fs::read_to_string(&file).unwrap();
    assert_eq!(written, output(&["frf", "fig06", "--at", "10"]));
    let (code, message) = failure(&[
        "frf",
        "fig06",
        "--at",
        "10",
        "-o",
        name,
        "--set",
        "beam.length=-1",
    ]);
    assert_eq!(code, 2);
    assert!(
        message.starts_with("error: ") && message.contains("beam.length"),
        "{message}"
    );
    assert_eq!(std::fs::read_to_string(&file).unwrap(), written);
    let missing = folder.path().join("no folder/out.csv");
    let (code, message) = failure(&[
        "frf",
        "fig06",
        "--at",
        "10",
        "-o",
        missing.to_str().unwrap(),
    ]);
    assert_eq!(code, 1);
    assert!(message.starts_with("error: "), "{message}");
}

#[test]
fn a_model_may_come_from_standard_input() {
    let text = presets::find("fig06").unwrap().text;
    let assert = beamtune(&["frf", "-", "--at", "10"])
        .write_stdin(text)
        .assert()
        .success();
    let from_input = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    assert_eq!(from_input, output(&["frf", "fig06", "--at", "10"]));
}

#[test]
fn check_prints_every_fault_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bad.toml");
    let text = presets::find("fig05a")
        .unwrap()
        .text
        .replace("density", "densty")
        .replace("loss_factor", "los_factor");
    std::fs::write(&file, text.replace("length = 3.2", "length = -3.2")).unwrap();
    let name = file.to_str().unwrap();
    let (code, message) = failure(&["check", name]);
    assert_eq!(code, 2);
    for line in message.lines() {
        assert!(line.starts_with(&format!("error: {name}:")), "{line}");
    }
    assert!(
        message.contains("densty") && message.contains("density"),
        "{message}"
    );
    assert!(message.contains("beam.length"), "{message}");
    assert_eq!(failure(&["frf", name]).0, 2);
    assert_eq!(failure(&[name]).0, 2);
}

#[test]
fn a_curve_that_a_study_makes_impossible_is_refused_where_it_is_wanted() {
    let study = beamtune::model::read(presets::find("fig15").unwrap().text)
        .unwrap()
        .into_inner()
        .studies
        .remove(0)
        .name;
    let near_the_end = [
        "frf",
        "fig15",
        "--at",
        "10",
        "--set",
        "subsystems.*.position=3",
    ];
    assert_eq!(output(&near_the_end).lines().count(), 2);
    let (code, message) = failure(&[&near_the_end[..], &["--study", &study]].concat());
    assert_eq!(code, 2);
    assert!(
        message.contains("position") && message.contains("3.2"),
        "{message}"
    );
}

#[test]
fn a_study_of_a_spring_does_not_forbid_to_clamp_its_end() {
    let clamped = [
        "frf",
        "fig16",
        "--at",
        "10",
        "--set",
        "supports.left.kind=clamped",
    ];
    assert_eq!(output(&clamped).lines().count(), 2);
}

#[test]
fn values_that_are_not_finite_are_reported_on_standard_error() {
    let output = beamtune(&["frf", "fig06", "--at", "10,1e308"])
        .output()
        .unwrap();
    assert!(output.status.success());
    let csv = String::from_utf8(output.stdout).unwrap();
    assert!(
        csv.lines()
            .nth(1)
            .unwrap()
            .split(',')
            .all(|cell| cell.parse::<f64>().unwrap().is_finite())
    );
    assert!(csv.lines().nth(2).unwrap().ends_with(",nan"), "{csv}");
    let warning = String::from_utf8(output.stderr).unwrap();
    assert!(
        warning.contains("no finite response at 1 frequency, first at 1e308 Hz"),
        "{warning}"
    );
}

/// Expected: a cantilever of 5 cm at 0.1 Hz moves as in statics; the amplitudes of the waves there are 1e8 times the
/// motion, and their energy cannot be computed in double precision. It must never be negative.
#[test]
fn an_energy_that_cancels_is_not_a_number() {
    let short = [
        "frf",
        "fig13",
        "--at",
        "0.001",
        "--set",
        "beam.length=0.05",
        "--set",
        "subsystems.*.position=0.02",
    ];
    let output = beamtune(&short).output().unwrap();
    let csv = String::from_utf8(output.stdout).unwrap();
    let energy: f64 = csv
        .lines()
        .nth(1)
        .unwrap()
        .split(',')
        .nth(1)
        .unwrap()
        .parse()
        .unwrap();
    assert!(energy.is_nan() || energy > 0.0, "{csv}");
    assert_eq!(energy.is_nan(), !output.stderr.is_empty());
}

/// A long log sweep stays within its bounds though their ratio overflows.
#[test]
fn a_log_sweep_never_leaves_its_bounds() {
    let sweep = beamtune::model::Sweep {
        from: 1e-200,
        to: 1e200,
        points: 5,
        spacing: beamtune::model::Spacing::Log,
    };
    let frequencies = beamtune::solve::frequencies(&sweep);
    assert_eq!((frequencies[0], frequencies[4]), (1e-200, 1e200));
    assert!((frequencies[2] - 1.0).abs() < 1e-12, "{frequencies:?}");
}

#[test]
#[cfg(unix)]
fn frf_keeps_links_and_modes() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (
        folder.path().join("file.csv"),
        folder.path().join("link.csv"),
    );
    std::fs::write(&file, "old").unwrap();
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&file, &link).unwrap();
    output(&["frf", "fig06", "--at", "10", "-o", link.to_str().unwrap()]);
    assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .starts_with("frequency_hz")
    );
    assert_eq!(
        std::fs::metadata(&file).unwrap().permissions().mode() & 0o777,
        0o640
    );
}

#[test]
fn bad_usage_exits_2_with_an_error() {
    let calls: [&[&str]; 10] = [
        &["frf", "fig05a", "--resolve", "--at", "10"],
        &["show", "fig99"],
        &["check", "no such file.toml"],
        &["frf", "fig05a", "--at", "-5"],
        &["frf", "fig05a", "--at", "ten"],
        &["frf", "fig05a", "--study", "nothing"],
        &["frf", "fig05a", "--set", "beam.lenght=3"],
        &["frf", "fig05a", "--set", "beam.length"],
        &["frf", "fig05a", "--set", "beam.length=long"],
        &["frf", "fig05a", "--unknown"],
    ];
    for call in calls {
        let (code, message) = failure(call);
        assert_eq!(code, 2, "{call:?}: {message}");
        assert!(message.starts_with("error: "), "{call:?}: {message}");
    }
}

#[test]
fn the_designer_refuses_a_pipe() {
    let (code, message) = failure(&["fig05a"]);
    assert_eq!(code, 2);
    assert!(message.contains("terminal"), "{message}");
}

/// The cells of a table of `validate`, which are separated by two or more spaces.
fn cells(line: &str) -> Vec<&str> {
    line.split("  ")
        .map(str::trim)
        .filter(|cell| !cell.is_empty())
        .collect()
}

/// `validate`'s report, without the times, which differ from run to run.
fn report(arguments: &[&str]) -> (i32, String) {
    let output = beamtune(arguments).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let timeless: Vec<&str> = text.lines().filter(|line| !line.ends_with(" s")).collect();
    (output.status.code().unwrap(), timeless.join("\n"))
}

#[test]
fn validate_compares_two_methods_with_the_exact_solution() {
    let call = [
        "validate",
        "fig05a",
        "--at",
        "30,100,350",
        "--elements",
        "80",
    ];
    let (code, text) = report(&call);
    assert_eq!(code, 0, "{text}");
    assert_eq!(report(&call).1, text);
    let row = |start: &str| {
        let line = text.lines().find(|line| line.starts_with(start));
        cells(line.unwrap_or_else(|| panic!("no {start}: {text}")))
    };
    let difference: f64 = row("P5 psi")[1].parse().unwrap();
    assert!(difference > 0.0 && difference < 1e-2, "{text}");
    // Hermite's cubics converge with the fourth power of the elements' length.
    let order: f64 = row("320 ")[2].parse().unwrap();
    assert!((order - 4.0).abs() < 0.3, "{text}");
    // The chain loses digits with the frequency.
    let digits = |start: &str| row(start)[1].parse::<f64>().unwrap();
    assert!(digits("100 ") > 8.0 && digits("350 ") < 4.0, "{text}");
    assert!(text.contains("is within the tolerance of 0.01."), "{text}");
}

#[test]
fn validate_exits_1_beyond_the_tolerance_and_2_on_bad_input() {
    let coarse = ["validate", "fig05a", "--at", "350", "--elements", "4"];
    let (code, text) = report(&coarse);
    assert_eq!(code, 1);
    assert!(text.contains("is beyond the tolerance of 0.01."), "{text}");
    let (code, text) = report(&[&coarse[..], &["--tolerance", "1e9"]].concat());
    assert_eq!(code, 0, "{text}");
    for bad in [
        &["validate", "fig99"][..],
        &["validate", "fig05a", "--elements", "0"],
        &["validate", "fig05a", "--tolerance", "0"],
        &["validate", "fig05a", "--at", "-1"],
        &["validate", "fig05a", "--set", "beam.length=-1"],
    ] {
        assert_eq!(failure(bad).0, 2, "{bad:?}");
    }
}

#[test]
fn validate_says_where_a_method_has_no_answer() {
    let (code, text) = report(&["validate", "symmetric_section", "--at", "20,60"]);
    assert_eq!(code, 0, "{text}");
    assert!(
        text.contains("does not apply: its ratios t divide by the centroid offset"),
        "{text}"
    );
    let (code, text) = report(&["validate", "fig06", "--at", "10,1e308", "--elements", "40"]);
    assert_eq!(code, 0, "{text}");
    assert!(
        text.contains("not finite at 1 of them, first at 1e308 Hz; these are left out"),
        "{text}"
    );
    let nowhere = beamtune(&["validate", "fig06", "--at", "1e308", "--elements", "4"])
        .output()
        .unwrap();
    assert_eq!(nowhere.status.code(), Some(1));
}

#[test]
fn modes_are_a_table_and_a_statement_that_it_is_complete() {
    let output = beamtune(&["modes", "fig05a", "--to", "250"])
        .output()
        .unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let rows = rows(&text);
    assert_eq!(rows[0], ["mode", "frequency_hz", "damping_ratio"]);
    assert_eq!(rows.len(), 22);
    assert_eq!(rows[1], ["1", "0.0", "0.0"]);
    for (index, row) in rows[1..].iter().enumerate() {
        assert_eq!(row[0], (index + 1).to_string());
    }
    let stated = String::from_utf8(output.stderr).unwrap();
    assert_eq!(stated.trim(), "21 of 21 modes below 250 Hz");
}

#[test]
fn mode_shapes_go_to_a_file_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shapes.csv");
    output(&[
        "modes",
        "fig05a",
        "--to",
        "20",
        "--shapes",
        file.to_str().unwrap(),
    ]);
    let text = std::fs::read_to_string(&file).unwrap();
    let rows = rows(&text);
    assert_eq!(
        rows[0],
        ["mode", "at", "position_m", "direction", "re", "im"]
    );
    // Three modes: 101 positions with three motions, three masses with three.
    assert_eq!(rows.len(), 1 + 3 * (101 * 3 + 3 * 3));
    assert!(
        rows[1..]
            .iter()
            .all(|row| row[4].parse::<f64>().unwrap().is_finite())
    );
    assert_eq!(rows[1][..4], ["1", "beam", "0.0", "w"]);
}

#[test]
fn a_model_without_modes_in_range_has_an_empty_table() {
    let output = beamtune(&["modes", "semicircular_cantilever", "--to", "5"])
        .output()
        .unwrap();
    assert!(output.status.success());
    assert_eq!(
        String::from_utf8(output.stdout).unwrap(),
        "mode,frequency_hz,damping_ratio\n"
    );
    assert!(
        String::from_utf8(output.stderr)
            .unwrap()
            .starts_with("0 of 0 modes")
    );
}

#[test]
fn modes_refuses_a_range_that_is_none() {
    for bad in ["0", "-3", "nan", "inf", "x"] {
        let output = beamtune(&["modes", "fig06", &format!("--to={bad}")])
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2), "{bad}");
    }
}

/// The program with its own home folder and no other folder in the environment.
fn at_home(home: &Path, arguments: &[&str]) -> Command {
    let mut command = beamtune(arguments);
    command.env_clear().env("HOME", home).env("TERM", "xterm");
    command
}

#[test]
fn paths_are_those_of_the_environment_and_nothing_is_made() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    let text = |command: &mut Command| {
        let output = command.output().unwrap();
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let paths = text(&mut at_home(folder, &["paths"]));
    let shown = folder.display();
    assert_eq!(
        paths,
        format!(
            "configuration  {shown}/.config/beamtune/config.toml\n\
             memory         {shown}/.local/state/beamtune/memory.toml\n\
             recovery       {shown}/.local/state/beamtune/recovery\n\
             log            {shown}/.local/state/beamtune/beamtune.log\n"
        )
    );
    let mut elsewhere = at_home(folder, &["paths"]);
    elsewhere
        .env("XDG_CONFIG_HOME", "/c")
        .env("XDG_STATE_HOME", "not/absolute");
    let paths = text(&mut elsewhere);
    assert!(
        paths.starts_with("configuration  /c/beamtune/config.toml\n"),
        "{paths}"
    );
    assert!(
        paths.contains(&format!("memory         {shown}/.local/state/")),
        "{paths}"
    );
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 0);
}

#[test]
fn without_a_home_paths_says_what_to_set() {
    let output = at_home(Path::new("relative"), &["paths"]).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(
        said.starts_with("error: ") && said.contains("set HOME"),
        "{said}"
    );
    let mut command = at_home(Path::new("relative"), &["paths"]);
    command
        .env("XDG_CONFIG_HOME", "/c")
        .env("XDG_STATE_HOME", "/s");
    assert!(command.output().unwrap().status.success());
}

#[test]
fn completions_and_the_manual_page_name_every_command() {
    let help = output(&["--help"]);
    let commands = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let commands: Vec<&str> = commands
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(commands.len() > 8, "{help}");
    let page = output(&["man"]);
    for command in &commands {
        assert!(page.contains(&format!(".SS {command}\n")), "{command}");
    }
    for shell in ["bash", "zsh", "fish"] {
        let script = output(&["completions", shell]);
        for word in commands
            .iter()
            .chain(&["semicircular_cantilever", "marker", "study"])
        {
            assert!(script.contains(word), "{shell} {word}");
        }
    }
    let (code, said) = failure(&["completions", "csh"]);
    assert_eq!(code, 2);
    assert!(said.contains("bash, zsh, fish"), "{said}");
}

/// The curves that `frf --format uff` prints, and the text on standard error.
fn universal(arguments: &[&str]) -> (Vec<beamtune::measured::Curve>, String) {
    let call = [&["frf", "--format", "uff"], arguments].concat();
    let output = beamtune(&call).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let curves = beamtune::measured::read(&output.stdout, &beamtune::measured::Hint::default());
    (curves.unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// Expected: the exact responses over the force, to the 13 digits of the format.
#[test]
fn a_universal_file_has_ratios_to_the_one_force() {
    let mut model = beamtune::model::read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    for force in &mut model.forces[1..] {
        force.enabled = false;
    }
    (model.forces[0].amplitude, model.forces[0].phase) = (4.0, 30.0);
    model.responses[1].quantity = beamtune::model::Quantity::Energy;
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("model.toml");
    std::fs::write(&file, beamtune::model::write(&model, "")).unwrap();
    let (curves, warning) = universal(&[file.to_str().unwrap(), "--at", "10,10.5,11"]);
    assert_eq!(warning, "");
    let frf = beamtune::solve::sweep(&checked(&model), &[10.0, 10.5, 11.0], &false.into()).unwrap();
    let force = num_complex::Complex64::from_polar(4.0, 30_f64.to_radians());
    for (index, (curve, column)) in curves.iter().zip(&frf.columns).enumerate() {
        assert_eq!(
            (&curve.name, &curve.frequencies),
            (&column.name, &frf.frequencies)
        );
        assert_eq!(curve.phase_known, index != 1);
        let unit = curve.kind.unwrap().unit();
        assert_eq!(unit, ["m/N", "kg m2", "m/N", "m/N", "rad/N"][index.min(4)]);
        let by = if index == 1 { 1.0.into() } else { force };
        for (found, value) in curve.values.iter().zip(&column.values) {
            assert!(
                (found * by - value).norm() < 1e-12 * value.norm(),
                "{found} {value}"
            );
        }
        if index == 4 {
            break;
        }
    }
    assert_eq!(curves.len(), frf.columns.len());
}

#[test]
fn a_universal_file_names_several_forces_studies_and_lost_digits() {
    let (curves, warning) = universal(&["fig05a", "--at", "10,20.123456,400"]);
    assert_eq!(curves[0].kind.unwrap().unit(), "m");
    assert_eq!(curves[0].frequencies, [10.0, 20.1235, 400.0]);
    assert!(
        warning.contains("six digits of each frequency") && warning.contains("up to 4.4e-5 Hz off"),
        "{warning}"
    );
    let model = beamtune::model::read(presets::find("fig08").unwrap().text)
        .unwrap()
        .into_inner();
    let study = &model.studies[0].name;
    let (curves, _) = universal(&["fig08", "--study", study, "--at", "10,20"]);
    let names: Vec<&str> = curves.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(
        names[..4],
        [
            "right w, 0.5",
            "right psi, 0.5",
            "right v, 0.5",
            "right w, 1"
        ]
    );
    assert_eq!(curves.len(), 12);
    // A resonance of an undamped model has no value.
    let text = output(&["frf", "fig06", "--format", "uff", "--at", "10,1e308"]);
    assert!(!text.to_lowercase().contains("nan"), "{text}");
    let (curves, warning) = universal(&["fig06", "--at", "10,1e308"]);
    assert_eq!(curves[0].frequencies, [10.0]);
    assert!(curves[0].notes.is_empty(), "{:?}", curves[0].notes);
    assert!(
        warning.contains("no finite response at 1 frequency") && warning.contains("(left out)"),
        "{warning}"
    );
    let (code, message) = failure(&["frf", "fig06", "--format", "hdf5"]);
    assert!(code == 2 && message.contains("csv, uff"), "{message}");
}

/// Abscissae rise: frequencies that are equal in six digits are written once. A reader that finds one twice reports it
/// in a note.
#[test]
fn abscissae_of_a_universal_file_rise() {
    // 3.186094 and 3.186091 Hz are 3.18609E+00, and 50 Hz was to come first.
    let (curves, warning) = universal(&["fig05a", "--at", "50,3.186094,3.186091,3.2"]);
    assert_eq!(curves[0].frequencies, [3.18609, 3.2, 50.0]);
    assert!(curves[0].notes.is_empty(), "{:?}", curves[0].notes);
    let left_out = format!("{} values are left out", curves.len());
    assert!(warning.contains(&left_out), "{warning}");
    let model = beamtune::model::read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    let frf = beamtune::solve::sweep(&checked(&model), &[3.186_091], &false.into()).unwrap();
    let value = frf.columns[0].values[0];
    assert!((curves[0].values[0] - value).norm() < 1e-12 * value.norm());
}

/// Positions are numbered from left to right, masses after them; w and y are along 2, v and z along 3, twists about 4.
#[test]
fn a_universal_file_numbers_its_places() {
    let text = output(&["frf", "fig05a", "--format", "uff", "--at", "10"]);
    let places: Vec<(&str, u32, i32)> = text
        .lines()
        .filter(|line| line.starts_with("    4         0    0         0 "))
        .map(|line| {
            (
                line[31..41].trim(),
                line[41..51].trim().parse().unwrap(),
                line[51..55].trim().parse().unwrap(),
            )
        })
        .collect();
    assert_eq!(
        places[..4],
        [
            ("left", 1, 2),
            ("left", 1, 4),
            ("left", 1, 3),
            ("x=1.2", 2, 2)
        ]
    );
    assert_eq!(places[11], ("right", 4, 3));
}
