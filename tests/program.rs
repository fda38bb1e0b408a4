//! The real binary in a pseudo-terminal, as an engineer uses it.
//!
//! Every step waits for what should appear; the only clock is the one that ends a test that hangs.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};

/// After this long a test has failed.
const PATIENCE: Duration = Duration::from_secs(60);

const ROWS: NonZeroU16 = NonZeroU16::new(24).unwrap();
const COLUMNS: NonZeroU16 = NonZeroU16::new(80).unwrap();

struct Program {
    master: Box<dyn MasterPty + Send>,
    child: Box<dyn Child + Send + Sync>,
    keys: Box<dyn Write + Send>,
    output: Receiver<Vec<u8>>,
    screen: vt100::Parser,
    raw: Vec<u8>,
}

impl Program {
    fn start(arguments: &[&str], folder: &Path) -> Self {
        let pair = native_pty_system()
            .openpty(PtySize {
                rows: ROWS.get(),
                cols: COLUMNS.get(),
                ..Default::default()
            })
            .unwrap();
        let mut command = CommandBuilder::new(assert_cmd::cargo::cargo_bin("beamtune"));
        command.args(arguments);
        command.cwd(folder);
        command.env("TERM", "xterm-256color");
        command.env_remove("NO_COLOR");
        let child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().unwrap();
        let (sender, output) = channel();
        std::thread::spawn(move || {
            let mut bytes = [0; 4096];
            while let Ok(count @ 1..) = reader.read(&mut bytes) {
                if sender.send(bytes[..count].to_vec()).is_err() {
                    break;
                }
            }
        });
        let keys = pair.master.take_writer().unwrap();
        let screen = vt100::Parser::new(ROWS, COLUMNS, 0);
        Self {
            master: pair.master,
            child,
            keys,
            output,
            screen,
            raw: Vec::new(),
        }
    }

    fn press(&mut self, keys: &str) {
        self.keys.write_all(keys.as_bytes()).unwrap();
        self.keys.flush().unwrap();
    }

    fn text(&self) -> String {
        self.screen.screen().contents()
    }

    /// Reads until the screen is as wanted.
    fn wait(&mut self, what: &str, mut wanted: impl FnMut(&str) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !wanted(&self.text()) {
            let left = end.saturating_duration_since(Instant::now());
            match self.output.recv_timeout(left) {
                Ok(bytes) => {
                    self.screen.process(&bytes);
                    self.raw.extend(bytes);
                }
                Err(error) => panic!(
                    "{error} while waiting for {what}; the screen is\n{}",
                    self.text()
                ),
            }
        }
    }

    fn wait_for(&mut self, text: &str) {
        self.wait(text, |screen| screen.contains(text));
    }

    /// Waits for the program's end; its exit code. The terminal must be given back.
    fn end(mut self) -> u32 {
        while let Ok(bytes) = self.output.recv_timeout(PATIENCE) {
            self.screen.process(&bytes);
            self.raw.extend(bytes);
        }
        let status = self.child.wait().unwrap();
        assert!(
            !self.screen.screen().alternate_screen(),
            "still on the alternate screen"
        );
        assert!(
            !self.screen.screen().hide_cursor(),
            "the cursor stays hidden"
        );
        assert!(
            !self.screen.screen().bracketed_paste(),
            "bracketed paste stays on"
        );
        drop(self.master);
        status.exit_code()
    }
}

/// Start, find and change a parameter, see the new curve, save, quit, read the file back.
#[test]
fn a_parameter_is_tuned_and_saved() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("tuned.toml");
    let text = beamtune::presets::find("fig08").unwrap().text;
    std::fs::write(&file, text).unwrap();
    let mut program = Program::start(&["tuned.toml"], folder.path());
    program.wait_for("solved");
    select(&mut program, "S1 y_left stiffness");
    program.press("\r");
    program.wait_for("3.33333");
    // Ctrl-U empties the line.
    program.press("\u{15}5 MN/m\r");
    program.wait("the new value, solved", |screen| {
        screen.contains("5 MN/m") && screen.contains("solved")
    });
    program.press("s");
    program.wait_for("saved");
    program.press("q");
    assert_eq!(program.end(), 0);
    let saved = std::fs::read_to_string(&file).unwrap();
    let model = beamtune::model::read(&saved).unwrap();
    assert_eq!(model.subsystems[0].y_left.stiffness, 5e6);
    let mut original = beamtune::model::read(text).unwrap();
    original.subsystems[0].y_left.stiffness = 5e6;
    assert_eq!(model, original);
    let comments = |text: &str| text.matches('#').count();
    assert_eq!(comments(&saved), comments(text));
}

/// The title of the panel that tells of the selected row.
fn details(screen: &str) -> Option<&str> {
    let titles = screen.lines().filter_map(|line| line.strip_prefix("─ "));
    titles
        .filter_map(|title| title.split_once(" ─"))
        .map(|(title, _)| title)
        .find(|title| *title != "Model")
}

/// Goes from parameter to parameter until the details are those of `name`.
fn select(program: &mut Program, name: &str) {
    for _ in 0..60 {
        let before = program.text();
        if before.contains(&format!("{name} ─")) {
            return;
        }
        program.press("\t");
        // Not any change will do: new curves may arrive at any time.
        program.wait("the next parameter", |screen| {
            details(screen).is_some() && details(screen) != details(&before)
        });
    }
    panic!("{name} not found; the screen is\n{}", program.text());
}

/// A changed model is not thrown away without a question.
#[test]
fn quitting_asks_when_something_is_unsaved() {
    let folder = tempfile::tempdir().unwrap();
    let mut program = Program::start(&["fig08", "--set", "subsystems.S1.mass=200"], folder.path());
    program.wait_for("solved");
    program.press("q");
    program.wait_for("discard");
    program.press("\u{1b}");
    program.wait("the question to go", |screen| !screen.contains("discard"));
    program.press("q");
    program.wait_for("discard");
    program.press("d");
    assert_eq!(program.end(), 0);
}

/// What is not saved when a signal ends the program goes into a file of its own, over no other.
#[cfg(unix)]
#[test]
fn a_signal_rescues_unsaved_changes() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("fig08.rescue.toml");
    std::fs::write(&taken, "precious").unwrap();
    let mut program = Program::start(&["fig08", "--set", "subsystems.S1.mass=200"], folder.path());
    program.wait_for("solved");
    let id = program.child.process_id().unwrap().to_string();
    assert!(
        std::process::Command::new("kill")
            .args(["-HUP", &id])
            .status()
            .unwrap()
            .success()
    );
    assert_eq!(program.end(), 129);
    assert_eq!(std::fs::read_to_string(&taken).unwrap(), "precious");
    let rescued = std::fs::read_to_string(folder.path().join("fig08.rescue.2.toml")).unwrap();
    assert_eq!(
        beamtune::model::read(&rescued).unwrap().subsystems[0].mass,
        200.0
    );
}

/// The terminal is given back after a signal, and the exit code says which.
#[cfg(unix)]
#[test]
fn signals_give_the_terminal_back() {
    for (signal, number) in [("TERM", 15), ("HUP", 1), ("INT", 2)] {
        let folder = tempfile::tempdir().unwrap();
        let mut program = Program::start(&["fig06"], folder.path());
        program.wait_for("solved");
        let id = program.child.process_id().unwrap();
        let sent = std::process::Command::new("kill")
            .args([&format!("-{signal}"), &id.to_string()])
            .status()
            .unwrap();
        assert!(sent.success());
        assert_eq!(program.end(), 128 + number, "SIG{signal}");
    }
}

/// A shape moves by itself, and stands still again by the same key.
#[test]
fn a_shape_moves_while_it_shall() {
    let folder = tempfile::tempdir().unwrap();
    let mut program = Program::start(&["fig06"], folder.path());
    program.press("m");
    program.wait_for("Modes: ");
    program.press("jM");
    // The axis is drawn last.
    program.wait("a shape", |screen| {
        screen.contains("psi  ") && screen.contains("2.5    3 m")
    });
    // A blank that was written is no other picture than one that was not.
    let picture = |screen: &str| -> Vec<String> {
        let lines = screen.lines();
        lines.map(|line| line.trim_end().to_owned()).collect()
    };
    let still = picture(&program.text());
    program.press("A");
    program.wait("a frame", |screen| picture(screen) != still);
    let frame = picture(&program.text());
    program.wait("the next frame", |screen| picture(screen) != frame);
    program.press("A");
    program.wait("the shape at its widest", |screen| picture(screen) == still);
    program.press("q");
    assert_eq!(program.end(), 0);
}
