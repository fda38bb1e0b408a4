//! The program in a pseudo-terminal, and the times of its pictures.

use std::io::{Read, Write};
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use portable_pty::{Child, CommandBuilder, PtySize, native_pty_system};

/// Lines and columns.
pub const SIZE: (u16, u16) = (40, 120);

/// The end of a picture: the end of a synchronised update.
const END: &[u8] = b"\x1b[?2026l";

/// The output, as it arrives.
pub struct Terminal {
    keys: Box<dyn Write + Send>,
    output: Receiver<(Instant, Vec<u8>)>,
    child: Box<dyn Child + Send + Sync>,
    /// The contents of the screen.
    pub screen: vt100::Parser,
    /// The last bytes, which may contain the beginning of an end.
    tail: Vec<u8>,
}

impl Terminal {
    /// Starts a program with its own home folder.
    pub fn start(program: &str, arguments: &[String], home: &Path) -> Self {
        let size = PtySize {
            rows: SIZE.0,
            cols: SIZE.1,
            ..PtySize::default()
        };
        let pair = native_pty_system().openpty(size).unwrap();
        let mut command = CommandBuilder::new(program);
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
        let child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().unwrap();
        let keys = pair.master.take_writer().unwrap();
        let (sender, output) = channel();
        std::thread::spawn(move || {
            let mut bytes = vec![0; 65536];
            while let Ok(count @ 1..) = reader.read(&mut bytes) {
                if sender
                    .send((Instant::now(), bytes[..count].to_vec()))
                    .is_err()
                {
                    break;
                }
            }
            drop(pair.master);
        });
        Self {
            keys,
            output,
            child,
            screen: parser(),
            tail: Vec::new(),
        }
    }

    /// Sends keys.
    pub fn send(&mut self, keys: &str) {
        self.keys.write_all(keys.as_bytes()).unwrap();
        self.keys.flush().unwrap();
    }

    /// The time at which the next picture is complete; none if no byte arrives within the limit.
    pub fn picture(&mut self, patience: Duration) -> Option<Instant> {
        loop {
            let (at, bytes) = self.output.recv_timeout(patience).ok()?;
            self.screen.process(&bytes);
            self.tail.extend(bytes);
            let complete = self.tail.windows(END.len()).any(|window| window == END);
            let keep = self.tail.len().min(END.len() - 1);
            self.tail.drain(..self.tail.len() - keep);
            if complete {
                self.tail.clear();
                return Some(at);
            }
        }
    }

    /// The times of all pictures, until no byte arrives within the limit.
    pub fn pictures(&mut self, quiet: Duration) -> Vec<Instant> {
        std::iter::from_fn(|| self.picture(quiet)).collect()
    }

    /// Ends the program.
    pub fn end(mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    /// Waits for the end of a program that ends by itself.
    pub fn ended(mut self) -> Instant {
        self.child.wait().unwrap();
        Instant::now()
    }
}

fn parser() -> vt100::Parser {
    let [rows, columns] = [SIZE.0, SIZE.1].map(|size| size.try_into().unwrap());
    vt100::Parser::new(rows, columns, 0)
}

/// The median of some times, ms.
pub fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The time between two instants, ms.
pub fn ms(from: Instant, to: Instant) -> f64 {
    to.duration_since(from).as_secs_f64() * 1e3
}
