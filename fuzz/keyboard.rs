//! Properties of any terminal input. Shared by the fuzz target and `tests/designer/keyboard.rs`; a panic is a failure.

use std::time::{Duration, Instant};

use beamtune::tui::event::Event;
use beamtune::tui::keys::Key;
use beamtune::tui::terminal::Parser;

/// After inputs up to this length, every key is answered within [`DEAF`].
pub const MOST: usize = 4096;

/// See [`MOST`].
const DEAF: Duration = Duration::from_secs(1);

/// The parser and its clock, which the test advances.
struct Line {
    parser: Parser,
    now: Instant,
    events: Vec<Event>,
}

impl Line {
    fn new() -> Self {
        let now = Instant::now();
        Self {
            parser: Parser::new(now),
            now,
            events: Vec::new(),
        }
    }

    /// A terminal on which these bytes arrived, in pieces of a length and with a pause after each.
    fn after(bytes: &[u8], length: usize, pause: Duration) -> Self {
        let mut line = Self::new();
        for piece in bytes.chunks(length.max(1)) {
            line.send(piece);
            line.wait(pause);
        }
        line
    }

    fn send(&mut self, bytes: &[u8]) {
        self.events.extend(self.parser.feed(bytes, self.now));
    }

    fn wait(&mut self, pause: Duration) {
        self.now += pause;
        while self
            .parser
            .deadline()
            .is_some_and(|deadline| deadline <= self.now)
        {
            self.events.extend(self.parser.expire());
        }
    }

    /// Whether these bytes give exactly this key.
    fn hears(&mut self, bytes: &[u8], key: &str) {
        self.events.clear();
        self.send(bytes);
        self.ends_with(key);
        assert_eq!(self.events.len(), 1, "more than {key}: {:?}", self.events);
    }

    /// Whether this key is the last event.
    fn ends_with(&self, key: &str) {
        let last = match self.events.last() {
            Some(Event::Key(key)) => Key::of(key).name(),
            other => format!("{other:?}"),
        };
        assert_eq!(last, key);
    }
}

/// After any bytes Ctrl-C is recognised at once, and after a second of silence every key. The division of the bytes
/// into reads makes no difference.
pub fn input(bytes: &[u8], length: usize, pause: Duration) {
    let bytes = &bytes[..bytes.len().min(MOST)];
    let mut line = Line::after(bytes, length, pause);
    line.wait(DEAF);
    line.hears(b"q", "q");
    line.hears(b"\x03", "Ctrl-c");
    let mut line = Line::after(bytes, length, pause);
    line.send(b"\x03");
    line.ends_with("Ctrl-c");
    line.hears(b"q", "q");
    // For Ctrl-C in a paste it matters whether more bytes follow in the same read.
    let bytes: Vec<u8> = bytes.iter().copied().filter(|byte| *byte != 3).collect();
    let whole = Line::after(&bytes, MOST, DEAF);
    let cut = {
        let mut line = Line::after(&bytes, length, Duration::ZERO);
        line.wait(DEAF);
        line
    };
    assert_eq!(format!("{:?}", cut.events), format!("{:?}", whole.events));
}
