//! Parts of the harness for terminals and processes.

use std::fs;
use std::io::Write;
use std::num::NonZeroU16;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::{Sender, channel};
use std::thread::JoinHandle;

use vt100::Parser;

/// The lines of a screen as seen.
pub fn picture(screen: &str) -> Vec<String> {
    let lines = screen.lines();
    lines.map(|line| line.trim_end().to_owned()).collect()
}

/// Sends a signal to a process.
pub fn signal(id: u32, name: &str) {
    let sent = Command::new("kill")
        .args([&format!("-{name}"), &id.to_string()])
        .status();
    assert!(sent.unwrap().success(), "SIG{name} is not sent");
}

/// The input, on its own thread: a program that does not read must not block the test.
pub fn typist(mut terminal: Box<dyn Write + Send>) -> (Sender<Vec<u8>>, JoinHandle<()>) {
    let (keys, typed) = channel::<Vec<u8>>();
    let writer = std::thread::spawn(move || {
        for bytes in typed {
            // A closed terminal accepts no input; the function that waits for an answer then reports it.
            if terminal
                .write_all(&bytes)
                .and_then(|()| terminal.flush())
                .is_err()
            {
                return;
            }
        }
    });
    (keys, writer)
}

pub fn parser(columns: u16, rows: u16) -> Parser {
    let (rows, columns) = (
        NonZeroU16::new(rows).unwrap(),
        NonZeroU16::new(columns).unwrap(),
    );
    Parser::new(rows, columns, 0)
}

/// The settings of a terminal, as printed by `stty -g`.
pub fn settings(terminal: Option<&Path>) -> String {
    let terminal = fs::File::open(terminal.unwrap()).unwrap();
    let output = Command::new("stty")
        .arg("-g")
        .stdin(Stdio::from(terminal))
        .output()
        .unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}

/// The position at which a piece begins.
pub fn find(bytes: &[u8], piece: &[u8]) -> Option<usize> {
    bytes
        .windows(piece.len())
        .position(|window| window == piece)
}
