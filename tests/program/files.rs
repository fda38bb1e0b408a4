//! Saving where it cannot be done, and beside other programs.

use std::fs;
use std::os::unix::fs::PermissionsExt as _;

use super::harness::{Home, Program};

/// Changes a model on its way in, so that there is something to save.
const CHANGE: &str = "subsystems.S1.mass=200";

/// The mass that the change gives, in a file.
fn mass(text: &str) -> f64 {
    beamtune::model::read(text).unwrap().subsystems[0].mass
}

/// A write fails midway, as on a full disk: the old file is whole, and nothing else is left.
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
    // Still changed: leaving asks.
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
    assert_eq!(fs::read_to_string(home.file("beam.toml")).unwrap(), text);
    assert_eq!(home.names(), ["beam.toml"]);
}

/// The device that is always full says what a full disk says.
#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_told_and_another_file_taken() {
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

/// Types a path into the box for it, which may be open already.
fn save_as(program: &mut Program, path: &str) {
    program.press("\u{1b}[27uS");
    program.press(&format!("\u{15}{path}\r"));
}

/// A folder in which nothing can be made, and a file in it that nobody may write.
#[test]
fn a_read_only_folder_is_told_and_another_file_taken() {
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
    // Root may write into every folder but those of the kernel.
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

/// What another program has saved in the meantime is not replaced without a question.
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

/// Two programs on one file notice each other's saves, without a key being pressed.
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
    looking.wait_for("read the file again");
    // What was read is the file's: nothing is there to be saved.
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
