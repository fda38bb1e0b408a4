//! A terminal with a simulated user.
//!
//! Every step waits for what should appear; the only clock is the timeout of a test that hangs.

use std::io::Read;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use portable_pty::{CommandBuilder, ExitStatus, MasterPty, PtySize, native_pty_system};
use vt100::{MouseProtocolMode, Parser};

pub use super::home::{BEAMTUNE, Home, names};
pub use super::pty::picture;
use super::pty::{find, parser, settings, signal, typist};

/// The timeout of a test.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// The interval at which a key is repeated until it has an effect.
const REPEAT: Duration = Duration::from_millis(300);

/// Columns and rows of a small terminal.
pub const SMALL: (u16, u16) = (80, 24);

/// Columns and rows of a large one.
pub const LARGE: (u16, u16) = (120, 40);

/// Escape as a key of its own, also if other keys follow at once.
pub const ESCAPE: &str = "\u{1b}[27u";

/// The sequence that begins a full repaint.
const CLEAR: &[u8] = b"\x1b[2J";

/// The sequence after every picture.
const SHOWN: &[u8] = b"\x1b[?2026l";

/// A running program and its terminal.
pub struct Program {
    master: Option<Box<dyn MasterPty + Send>>,
    keys: Option<Sender<Vec<u8>>>,
    writer: Option<JoinHandle<()>>,
    id: u32,
    ended: Receiver<ExitStatus>,
    reader: Option<JoinHandle<()>>,
    /// The reader is to stop at the next output.
    let_go: Arc<AtomicBool>,
    output: Receiver<Vec<u8>>,
    screen: Parser,
    /// The whole output of the program.
    pub raw: Vec<u8>,
    /// The terminal's settings before the program.
    settings: String,
}

impl Program {
    /// The designer in a small terminal.
    pub fn start(home: &Home, arguments: &[&str]) -> Self {
        Self::launch(home.beamtune(arguments), SMALL)
    }

    /// The designer in a terminal of this size.
    pub fn sized(home: &Home, arguments: &[&str], size: (u16, u16)) -> Self {
        Self::launch(home.beamtune(arguments), size)
    }

    /// The designer with other variables; an empty one is unset.
    pub fn with(home: &Home, arguments: &[&str], variables: &[(&str, &str)]) -> Self {
        let mut command = home.beamtune(arguments);
        for (name, value) in variables {
            match *value {
                "" => command.env_remove(name),
                value => command.env(name, value),
            }
        }
        Self::launch(command, SMALL)
    }

    /// A script of the shell, in which `"$BEAMTUNE"` is the designer.
    pub fn script(home: &Home, script: &str) -> Self {
        let mut command = home.program(Path::new("/bin/sh"));
        command.args(["-c", script]);
        Self::launch(command, SMALL)
    }

    /// An ordinary shell with a prompt.
    pub fn shell(home: &Home) -> Self {
        let mut command = home.program(Path::new("/bin/bash"));
        // Without line editing, which sets terminal modes of its own.
        command.args(["--norc", "--noprofile", "--noediting", "-i"]);
        command.env("PS1", "prompt> ");
        Self::launch(command, SMALL)
    }

    fn launch(command: CommandBuilder, (columns, rows): (u16, u16)) -> Self {
        let pair = native_pty_system()
            .openpty(PtySize {
                rows,
                cols: columns,
                ..Default::default()
            })
            .unwrap();
        let settings = settings(pair.master.tty_name().as_deref());
        let mut child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let id = child.process_id().unwrap();
        let (end, ended) = channel();
        std::thread::spawn(move || end.send(child.wait().unwrap()));
        let mut reader = pair.master.try_clone_reader().unwrap();
        let (sender, output) = channel();
        let let_go = Arc::new(AtomicBool::new(false));
        let stop = Arc::clone(&let_go);
        let reader = std::thread::spawn(move || {
            let mut bytes = vec![0; 65_536];
            while let Ok(count @ 1..) = reader.read(&mut bytes) {
                let sent = sender.send(bytes[..count].to_vec());
                if sent.is_err() || stop.load(Ordering::SeqCst) {
                    break;
                }
            }
        });
        let (keys, writer) = typist(pair.master.take_writer().unwrap());
        Self {
            keys: Some(keys),
            writer: Some(writer),
            master: Some(pair.master),
            id,
            ended,
            reader: Some(reader),
            let_go,
            output,
            screen: parser(columns, rows),
            raw: Vec::new(),
            settings,
        }
    }

    pub fn press(&mut self, keys: &str) {
        self.send(keys.as_bytes());
    }

    /// Sends one byte after another with this pause after each; without a pause, all in one piece.
    pub fn press_slowly(&mut self, bytes: &[u8], pause: Duration) {
        if pause.is_zero() {
            return self.send(bytes);
        }
        for byte in bytes.chunks(1) {
            self.send(byte);
            self.read_for(pause);
        }
    }

    /// Presses a key again and again until a text shows.
    pub fn press_until(&mut self, key: &str, text: &str) {
        let end = Instant::now() + PATIENCE;
        while !self.text().contains(text) {
            assert!(
                Instant::now() < end,
                "no {text} by {key}; the screen is\n{}",
                self.text()
            );
            self.press(key);
            self.read_for(REPEAT);
        }
    }

    pub fn send(&mut self, bytes: &[u8]) {
        // The functions that wait notice if the program has ended.
        let _ = self.keys.as_ref().unwrap().send(bytes.to_vec());
    }

    /// Resizes the terminal.
    pub fn resize(&mut self, (columns, rows): (u16, u16)) {
        let size = PtySize {
            rows,
            cols: columns,
            ..Default::default()
        };
        self.master.as_ref().unwrap().resize(size).unwrap();
        let (rows, columns) = (rows.try_into().unwrap(), columns.try_into().unwrap());
        self.screen.screen_mut().set_size(rows, columns);
    }

    /// Sends a signal to the process that was started.
    pub fn signal(&self, name: &str) {
        signal(self.id, name);
    }

    /// The screen as it is now.
    pub fn screen(&self) -> &vt100::Screen {
        self.screen.screen()
    }

    /// Its text.
    pub fn text(&self) -> String {
        self.screen().contents()
    }

    /// Its text as seen: written blanks and empty cells are the same.
    pub fn picture(&self) -> Vec<String> {
        picture(&self.text())
    }

    /// The settings of the terminal now, as printed by `stty -g`.
    pub fn settings(&self) -> String {
        settings(self.master.as_ref().unwrap().tty_name().as_deref())
    }

    /// Whether the terminal's settings are unchanged.
    pub fn is_plain(&self) -> bool {
        self.settings() == self.settings
    }

    /// Reads until the screen meets a condition.
    pub fn wait(&mut self, what: &str, mut wanted: impl FnMut(&str) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !wanted(&self.text()) {
            self.read_on(what, end);
        }
    }

    pub fn wait_for(&mut self, text: &str) {
        self.wait(text, |screen| screen.contains(text));
    }

    /// Reads the next output.
    fn read_on(&mut self, what: &str, end: Instant) {
        let left = end.saturating_duration_since(Instant::now());
        match self.output.recv_timeout(left) {
            Ok(bytes) => self.take(&bytes),
            Err(error) => panic!(
                "{error} while waiting for {what}; the screen is\n{}",
                self.text()
            ),
        }
    }

    /// Reads the output of this time.
    fn read_for(&mut self, time: Duration) {
        let end = Instant::now() + time;
        let left = || end.saturating_duration_since(Instant::now());
        while let Ok(bytes) = self.output.recv_timeout(left()) {
            self.take(&bytes);
        }
    }

    fn take(&mut self, bytes: &[u8]) {
        self.screen.process(bytes);
        self.raw.extend(bytes);
    }

    /// Waits until all pressed keys are handled and shown: requests a repaint and reads to its end. Returns the output.
    pub fn settle(&mut self) -> Vec<u8> {
        let from = self.pending();
        self.press("\u{c}");
        self.read_past(from, &[CLEAR, SHOWN], "a new painting")
    }

    /// Waits for a picture of the last action.
    pub fn painted(&mut self) {
        let from = self.raw.len();
        self.read_past(from, &[SHOWN], "a picture");
    }

    /// Waits for an unrequested full repaint.
    pub fn repainted(&mut self) {
        let from = self.raw.len();
        self.read_past(from, &[CLEAR, SHOWN], "a new painting");
    }

    /// Reads the pending output; returns the number of bytes written up to now.
    pub fn pending(&mut self) -> usize {
        while let Ok(bytes) = self.output.try_recv() {
            self.take(&bytes);
        }
        self.raw.len()
    }

    /// Reads until some pieces have arrived in order; returns the output from the start of the search to the end of the
    /// last piece.
    fn read_past(&mut self, from: usize, pieces: &[&[u8]], what: &str) -> Vec<u8> {
        let end = Instant::now() + PATIENCE;
        loop {
            let new = &self.raw[from..];
            let past = pieces.iter().try_fold(0, |at, piece| {
                find(&new[at..], piece).map(|found| at + found + piece.len())
            });
            if let Some(to) = past {
                return new[..to].to_vec();
            }
            self.read_on(what, end);
        }
    }

    /// Requests repaints until a condition outside of the terminal is met.
    pub fn until(&mut self, what: &str, mut come: impl FnMut() -> bool) {
        let end = Instant::now() + PATIENCE;
        while !come() {
            assert!(
                Instant::now() < end,
                "no {what}; the screen is\n{}",
                self.text()
            );
            self.settle();
        }
    }

    /// Closes the terminal, like a dropped connection. The caller waits for the program's end.
    pub fn hang_up(mut self) -> Orphan {
        self.let_go.store(true, Ordering::SeqCst);
        // The reader holds the terminal until it has read something.
        self.press("\u{c}");
        self.reader.take().unwrap().join().unwrap();
        drop(self.keys.take());
        self.writer.take().unwrap().join().unwrap();
        drop(self.master.take());
        let (_, never) = channel();
        Orphan {
            since: Instant::now(),
            ended: std::mem::replace(&mut self.ended, never),
        }
    }

    /// Waits for the program's end; returns its exit code. The terminal's settings must be restored.
    pub fn end(mut self) -> u32 {
        let code = self.exit();
        let screen = self.screen();
        assert!(!screen.alternate_screen(), "still on the alternate screen");
        assert!(!screen.hide_cursor(), "the cursor stays hidden");
        assert!(!screen.bracketed_paste(), "bracketed paste stays on");
        assert_eq!(screen.mouse_protocol_mode(), MouseProtocolMode::None);
        assert!(
            self.is_plain(),
            "{} is not {}",
            self.settings(),
            self.settings
        );
        code
    }

    /// [`Program::end`], which also returns the final screen.
    pub fn last_words(mut self) -> (u32, String) {
        self.read_out();
        let text = self.text();
        (self.end(), text)
    }

    /// Waits for the end, whatever the state of the terminal; returns the exit code.
    pub fn exit(&mut self) -> u32 {
        self.read_out();
        let status = self.ended.recv_timeout(PATIENCE).unwrap();
        self.id = 0;
        status.exit_code()
    }

    /// Reads until all writers are closed.
    fn read_out(&mut self) {
        loop {
            match self.output.recv_timeout(PATIENCE) {
                Ok(bytes) => self.take(&bytes),
                Err(std::sync::mpsc::RecvTimeoutError::Disconnected) => return,
                Err(error) => panic!("{error} while waiting for the end:\n{}", self.text()),
            }
        }
    }
}

/// A failed test leaves no program running.
impl Drop for Program {
    fn drop(&mut self) {
        if std::thread::panicking() && self.id != 0 {
            // It may have ended by itself in the meantime.
            let _ = Command::new("kill")
                .args(["-KILL", &self.id.to_string()])
                .status();
        }
    }
}

/// A program whose terminal is closed.
pub struct Orphan {
    since: Instant,
    ended: Receiver<ExitStatus>,
}

impl Orphan {
    /// Waits for its end; returns the exit code and the time that it took.
    pub fn end(self) -> (u32, Duration) {
        let status = self.ended.recv_timeout(PATIENCE).unwrap();
        (status.exit_code(), self.since.elapsed())
    }
}

/// Tests of the harness itself: it sees what a program leaves behind.
#[test]
fn a_terminal_that_is_not_given_back_is_noticed() {
    let home = Home::new();
    let mut program = Program::script(&home, "stty raw -echo; printf '\\033[?1049h\\033[?25l'");
    assert_eq!(program.exit(), 0);
    assert!(program.screen().alternate_screen() && program.screen().hide_cursor());
    assert!(!program.is_plain());
    let mut program = Program::script(&home, "stty raw; stty sane; exit 3");
    assert_eq!(program.exit(), 3);
    assert!(program.screen().contents().is_empty());
}
