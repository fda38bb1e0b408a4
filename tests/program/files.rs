//! Saving that fails, and saving while other programs change the file.

use std::fs;
use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, chown};
use std::os::unix::process::CommandExt as _;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use super::harness::{BEAMTUNE, Home, LARGE, Program};

/// Changes the model on the command line, so that there are changes to save.
const CHANGE: &str = "subsystems.S1.mass=200";

/// The changed mass, as in a file.
fn mass(text: &str) -> f64 {
    beamtune::model::read(text).unwrap().into_inner().subsystems[0].mass
}

/// A write fails midway, as on a full disk: the old file is intact, and no other file is left.
#[test]
fn a_full_disk_leaves_the_old_file() {
    let home = Home::new();
    let text = home.preset("fig08", "beam.toml");
    let script = format!("trap '' XFSZ; ulimit -f 0; exec \"$BEAMTUNE\" beam.toml --set {CHANGE}");
    let mut program = Program::script(&home, &script);
    program.wait_for("solved");
    program.press("s");
    program.wait("the failure", |screen| {
        screen.contains("beam.toml is not saved") && screen.contains("large")
    });
    assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
    assert_eq!(home.names(), ["beam.toml"]);
    // Still changed: quitting asks.
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
    assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
    assert_eq!(home.names(), ["beam.toml"]);
}

/// The device that is always full gives the error of a full disk.
#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_reported_and_another_file_accepted() {
    let home = Home::new();
    let text = home.preset("fig08", "beam.toml");
    let mut program = Program::start(&home, &["beam.toml", "--set", CHANGE]);
    program.wait_for("solved");
    program.press("S");
    program.wait_for("beam.toml");
    program.press("\u{15}/dev/full\r");
    program.wait_for("replace");
    program.press("y");
    program.wait_for("No space left");
    assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
    save_as(&mut program, "elsewhere.toml");
    program.wait_for("saved elsewhere.toml");
    assert_eq!(
        mass(&fs::read_to_string(home.file("elsewhere.toml")).unwrap()),
        200.0
    );
    assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
    assert_eq!(home.names(), ["beam.toml", "elsewhere.toml"]);
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// Types a path into its dialog, which may be open already.
fn save_as(program: &mut Program, path: &str) {
    program.press("\u{1b}[27uS");
    program.press(&format!("\u{15}{path}\r"));
}

/// A folder in which no file can be created, and a read-only file in it.
#[test]
fn a_read_only_folder_is_reported_and_another_file_accepted() {
    let home = Home::new();
    let folder = home.file("shelf");
    fs::create_dir(&folder).unwrap();
    let text = home.preset("fig08", "shelf/beam.toml");
    let mode = |path: &std::path::Path, mode| {
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    };
    mode(&folder.join("beam.toml"), 0o444);
    mode(&folder, 0o555);
    let mut program = Program::start(&home, &["shelf/beam.toml", "--set", CHANGE]);
    program.wait_for("solved");
    program.press("s");
    program.wait("the failure", |screen| {
        screen.contains("is not saved")
            && (screen.contains("read-only") || screen.contains("denied"))
    });
    assert_eq!(fs::read_to_string(folder.join("beam.toml")).unwrap(), text);
    // Root may write into every folder except those of the kernel.
    let shut = if fs::write(folder.join("probe"), "").is_ok() {
        fs::remove_file(folder.join("probe")).unwrap();
        "/proc/new.toml"
    } else {
        "shelf/new.toml"
    };
    save_as(&mut program, shut);
    program.wait_for("new.toml is not saved");
    save_as(&mut program, "new.toml");
    program.wait_for("saved new.toml");
    program.press("q");
    assert_eq!(program.end(), 0);
    assert_eq!(
        mass(&fs::read_to_string(home.file("new.toml")).unwrap()),
        200.0
    );
    assert_eq!(fs::read_to_string(folder.join("beam.toml")).unwrap(), text);
    assert_eq!(super::harness::names(&folder), ["beam.toml"]);
    assert_eq!(home.names(), ["new.toml", "shelf"]);
    mode(&folder, 0o755);
}

/// A version that another program has saved is not replaced without a confirmation.
#[test]
fn another_programs_save_is_not_replaced_unasked() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let mut program = Program::start(&home, &["beam.toml", "--set", CHANGE]);
    program.wait_for("solved");
    let mut other = Program::start(&home, &["beam.toml", "--set", "subsystems.S1.mass=300"]);
    other.wait_for("solved");
    other.press("s");
    other.wait_for("saved beam.toml");
    other.press("q");
    assert_eq!(other.end(), 0);
    program.press("s");
    program.wait_for("replace");
    program.press("n");
    program.wait_for("not saved");
    assert_eq!(
        mass(&fs::read_to_string(home.file("beam.toml")).unwrap()),
        300.0
    );
    program.press("s");
    program.wait_for("replace");
    program.press("y");
    program.wait_for("saved");
    assert_eq!(
        mass(&fs::read_to_string(home.file("beam.toml")).unwrap()),
        200.0
    );
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// Two programs with one file notice each other's saves, without a key press.
#[test]
fn another_programs_save_is_noticed_and_read() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let mut saving = Program::start(&home, &["beam.toml", "--set", CHANGE]);
    let mut looking = Program::start(&home, &["beam.toml"]);
    let mut editing = Program::start(&home, &["beam.toml", "--set", "subsystems.S1.mass=300"]);
    for program in [&mut saving, &mut looking, &mut editing] {
        program.wait_for("solved");
    }
    saving.press("s");
    saving.wait_for("saved beam.toml");
    saving.press("q");
    assert_eq!(saving.end(), 0);
    for program in [&mut looking, &mut editing] {
        program.wait_for("changed on disk");
    }
    looking.press("R");
    looking.wait_for("file reloaded");
    // The reloaded model matches the file: there is nothing to save.
    assert!(!looking.text().contains("· changed"), "{}", looking.text());
    looking.press("q");
    assert_eq!(looking.end(), 0);
    editing.press("s");
    editing.wait_for("replace");
    assert_eq!(
        mass(&fs::read_to_string(home.file("beam.toml")).unwrap()),
        200.0
    );
    editing.press("y");
    editing.wait_for("saved beam.toml");
    assert_eq!(
        mass(&fs::read_to_string(home.file("beam.toml")).unwrap()),
        300.0
    );
    editing.press("q");
    assert_eq!(editing.end(), 0);
}

/// Replaces a file by a pipe.
fn pipe(path: &Path) {
    let _ = fs::remove_file(path);
    let made = Command::new("mkfifo").arg(path).status();
    assert!(made.unwrap().success());
}

/// The model's file becomes a pipe: reload and save report it, and do not block.
#[test]
fn a_file_that_became_a_pipe_is_not_waited_for() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    let mut program = Program::start(&home, &["beam.toml", "--set", CHANGE]);
    program.wait_for("solved");
    pipe(&home.file("beam.toml"));
    program.wait_for("changed on disk");
    program.press("R");
    program.wait_for("discard");
    program.press("d");
    program.wait_for("it is a pipe");
    program.press("s");
    program.wait_for("replace");
    program.press("y");
    program.wait_for("is not saved: it is a pipe");
    save_as(&mut program, "other.toml");
    program.wait_for("saved other.toml");
    program.press("q");
    assert_eq!(program.end(), 0);
}

/// The program's own files for its user, as pipes.
#[test]
fn pipes_among_the_users_own_files_are_not_waited_for() {
    let home = Home::new();
    home.preset("fig08", "beam.toml");
    fs::create_dir_all(home.state("recovery")).unwrap();
    for name in [
        "memory.toml",
        "memory.toml.lock",
        "beamtune.log",
        "recovery/a.toml",
        "recovery/b.lock",
    ] {
        pipe(&home.state(name));
    }
    let mut program = Program::sized(&home, &["beam.toml"], LARGE);
    program.wait_for("cannot be read: it is a pipe");
    program.press("q");
    assert_eq!(program.end(), 0);
    home.configure("");
    let configuration = home.state("../../config/beamtune/config.toml");
    pipe(&configuration);
    let mut program = Program::sized(&home, &["beam.toml"], LARGE);
    program.wait_for("cannot be read: it is a pipe");
    assert_eq!(program.end(), 2);
}

/// A pipe that is named on the command line is used on purpose.
#[test]
fn a_model_comes_through_a_pipe() {
    let home = Home::new();
    let text = home.preset("fig08", "beam.toml");
    pipe(&home.file("pipe"));
    let script = "cat beam.toml > pipe & exec \"$BEAMTUNE\" frf pipe --at 100";
    let piped = shell(&home, script);
    assert!(piped.status.success(), "{piped:?}");
    let other = shell(&home, "\"$BEAMTUNE\" frf beam.toml --at 100");
    assert_eq!(piped.stdout, other.stdout);
    assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
}

/// A script of the shell, in which `"$BEAMTUNE"` is the program.
fn shell(home: &Home, script: &str) -> Output {
    let mut command = Command::new("/bin/sh");
    command.args(["-c", script]).current_dir(home.work());
    command.env_clear().envs(home.environment());
    command.output().unwrap()
}

/// A signal of any kind leaves no temporary file, and no partial table; the next write removes the files of a killed
/// program.
#[test]
fn a_signal_leaves_no_temporary_file() {
    let home = Home::new();
    let long = [
        "frf",
        "fig05a",
        "--set",
        "sweep.points=1000000",
        "-o",
        "out.csv",
    ];
    for signal in [
        "TERM", "HUP", "INT", "QUIT", "USR1", "USR2", "ALRM", "XCPU", "KILL",
    ] {
        let mut command = Command::new(BEAMTUNE);
        command.args(long).current_dir(home.work());
        let mut child = command.stderr(Stdio::null()).spawn().unwrap();
        while home.names().is_empty() {
            assert!(child.try_wait().unwrap().is_none(), "it has ended");
            std::thread::yield_now();
        }
        let id = child.id().to_string();
        let sent = Command::new("kill").args(["-s", signal, &id]).status();
        assert!(sent.unwrap().success());
        assert!(!child.wait().unwrap().success());
        let left = home.names();
        let most = usize::from(signal == "KILL");
        assert!(left.len() <= most, "SIG{signal}: {left:?}");
    }
    let ended = shell(&home, "\"$BEAMTUNE\" frf fig08 --at 100 -o short.csv");
    assert!(ended.status.success(), "{ended:?}");
    assert_eq!(home.names(), ["short.csv"]);
}

/// Another user's file in a world-writable folder. Only root can create one.
#[test]
fn a_file_of_another_owner_keeps_it_or_the_loss_is_said() {
    const OTHER: u32 = 12_345;
    let home = Home::new();
    let file = home.file("out.csv");
    fs::write(&file, "old").unwrap();
    if chown(&file, Some(OTHER), Some(OTHER)).is_err() {
        return;
    }
    let mode =
        |path: &Path, mode| fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    mode(&home.work(), 0o777);
    mode(home.work().parent().unwrap(), 0o755);
    let program = home.work().parent().unwrap().join("beamtune");
    fs::copy(BEAMTUNE, &program).unwrap();
    let run = || {
        let mut command = Command::new(&program);
        command.args(["frf", "fig08", "--at", "100", "-o", "out.csv"]);
        command
            .current_dir(home.work())
            .uid(OTHER + 1)
            .gid(OTHER + 1);
        let output = command.output().unwrap();
        assert!(output.status.success(), "{output:?}");
        assert!(
            fs::read_to_string(&file)
                .unwrap()
                .starts_with("frequency_hz")
        );
        assert_eq!(home.names(), ["out.csv"]);
        String::from_utf8(output.stderr).unwrap()
    };
    // The file is world-writable: it is written in place.
    mode(&file, 0o666);
    assert_eq!(run(), "");
    assert_eq!(fs::metadata(&file).unwrap().uid(), OTHER);
    // Only its owner may write: it can be replaced, but the owner cannot be preserved.
    fs::write(&file, "old").unwrap();
    mode(&file, 0o644);
    assert_eq!(
        run(),
        "warning: out.csv loses its owner and group, which the user may not set\n"
    );
    assert_eq!(fs::metadata(&file).unwrap().uid(), OTHER + 1);
}
