//! Bytes and times at a terminal: run with `cargo bench --bench thrift`.
//!
//! The real program in a pseudo-terminal of 120 x 40 with fig05a: the bytes written for a nudge of each parameter, for
//! a full repaint and while idle, and the time from the key to its first and last picture. A model can be named: `cargo
//! bench --bench thrift -- tests/data/thousand.toml`, from the folder of the project.

#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use std::io::{Read, Write};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use portable_pty::{CommandBuilder, PtySize, native_pty_system};

/// After this time without a byte, a key is handled.
const QUIET: Duration = Duration::from_millis(300);

/// Parameters from the first one on.
const PARAMETERS: usize = 25;

/// Nudges of each.
const NUDGES: usize = 8;

struct Program {
    keys: Box<dyn Write + Send>,
    output: Receiver<usize>,
}

impl Program {
    fn start(home: &std::path::Path, arguments: &[String]) -> Self {
        let size = PtySize {
            rows: 40,
            cols: 120,
            ..PtySize::default()
        };
        let pair = native_pty_system().openpty(size).unwrap();
        let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_beamtune"));
        command.args(arguments);
        command.cwd(std::env::current_dir().unwrap());
        command.env("HOME", home);
        command.env("TERM", "xterm-256color");
        command.env("LC_ALL", "C.UTF-8");
        for variable in [
            "NO_COLOR",
            "COLORFGBG",
            "COLORTERM",
            "XDG_STATE_HOME",
            "XDG_CONFIG_HOME",
        ] {
            command.env_remove(variable);
        }
        let mut child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().unwrap();
        let keys = pair.master.take_writer().unwrap();
        let (sender, output) = channel();
        std::thread::spawn(move || {
            let mut bytes = [0; 8192];
            while let Ok(count @ 1..) = reader.read(&mut bytes) {
                if sender.send(count).is_err() {
                    break;
                }
            }
            let _ = child.wait();
            drop(pair.master);
        });
        Self { keys, output }
    }

    /// The output after a key.
    fn press(&mut self, key: &str) -> Written {
        let start = Instant::now();
        self.keys.write_all(key.as_bytes()).unwrap();
        self.keys.flush().unwrap();
        let mut written = Written::default();
        while let Ok(more) = self.output.recv_timeout(QUIET) {
            let now = start.elapsed().as_secs_f64() * 1e3;
            if written.bytes == 0 {
                written.first = now;
            }
            written.bytes += more;
            written.last = now;
        }
        written
    }
}

/// The bytes written after a key.
#[derive(Default)]
struct Written {
    bytes: usize,
    /// Until the first byte, ms: a picture is written in one piece.
    first: f64,
    /// Until the last one, ms.
    last: f64,
}

fn median<T: Copy + PartialOrd>(values: &mut [T]) -> T {
    values.sort_by(|a, b| a.partial_cmp(b).unwrap());
    values[values.len() / 2]
}

fn main() {
    let home = tempfile::tempdir().unwrap();
    let arguments: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| argument != "--bench")
        .collect();
    let mut program = Program::start(home.path(), &arguments);
    println!("start: {} bytes", program.press("").bytes);
    let (mut bytes, mut shares) = (Vec::new(), Vec::new());
    let (mut first, mut last) = (Vec::new(), Vec::new());
    for _ in 0..PARAMETERS {
        program.press("\t");
        let repaint = program.press("\u{c}").bytes;
        for _ in 0..NUDGES {
            let written = program.press("+");
            // A nudge does not change a parameter of 0.
            if written.bytes > 0 {
                bytes.push(written.bytes);
                first.push(written.first);
                last.push(written.last);
                shares.push(written.bytes as f64 / repaint as f64);
            }
        }
    }
    let repaint = program.press("\u{c}").bytes;
    let worst = bytes.iter().max().copied().unwrap();
    println!("full repaint: {repaint} bytes");
    println!(
        "nudge: median {} bytes, worst {worst}, of {}; of a repaint: median {:.2}",
        median(&mut bytes),
        bytes.len(),
        median(&mut shares)
    );
    for (what, times) in [("first", &mut first), ("last", &mut last)] {
        println!(
            "key to the {what} picture: median {:.1} ms, worst {:.1} ms",
            median(times),
            times.iter().copied().fold(0.0, f64::max)
        );
    }
    std::thread::sleep(Duration::from_secs(2));
    let idle: usize = program.output.try_iter().sum();
    println!("idle for 2 s: {idle} bytes");
    program.press("q");
    program.press("d");
}
