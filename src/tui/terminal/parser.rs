//! Parses the bytes of a terminal into keys, mouse events and pasted text.
//!
//! The parser has no clock: the caller passes the time of the bytes, and calls [`Parser::expire`] when
//! [`Parser::deadline`] passes without more bytes. So an incomplete sequence never blocks the following keys.

use std::time::{Duration, Instant};

use crossterm::event::KeyModifiers;

use super::sequence;
use crate::tui::event::Event;

/// After this pause an incomplete sequence becomes keys. The bytes of a sequence follow each other faster, also on a slow
/// line; a person types slower.
const SEQUENCE_TIMEOUT: Duration = Duration::from_millis(80);

/// After this time it becomes keys even without a pause: a repeating key could extend it forever.
const SEQUENCE_LIMIT: Duration = Duration::from_secs(1);

/// After this pause a paste ends without its end mark: the mark was lost, or there was no paste.
const PASTE_TIMEOUT: Duration = Duration::from_millis(800);

/// The same for a long paste: it is certainly a paste, and a slow line may stall longer.
const LONG_PASTE_TIMEOUT: Duration = Duration::from_secs(2);

/// Bytes above which a paste is long.
const LONG_PASTE: usize = 4096;

/// Bytes in smaller pieces than this, after longer pauses than [`TYPING_PAUSE`], are typed: they do not extend a paste.
const TYPED_PIECE: usize = 8;

/// See [`TYPED_PIECE`].
const TYPING_PAUSE: Duration = Duration::from_millis(50);

const CONTROL_C: u8 = 3;
const BELL: u8 = 7;
const ESCAPE: u8 = 0x1b;
const PASTE_END: &[u8] = b"\x1b[201~";

/// The kind of the incomplete input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ParserState {
    /// None: the next byte starts a new input.
    Ground,
    /// `ESC`.
    Escape,
    /// A UTF-8 character, possibly after `ESC`.
    Letter,
    /// `ESC [`, up to a final letter.
    Csi,
    /// `ESC O`, up to a final letter.
    Ss3,
    /// `ESC [ M` and three bytes: the mouse protocol of old terminals.
    PlainMouse,
    /// `ESC ]`, `ESC P` or `ESC _`: a string, up to `BEL` or `ESC \`.
    Report,
    /// Text after `ESC [ 200 ~`.
    Paste,
}

/// Turns bytes into events.
#[derive(Debug)]
pub struct Parser {
    state: ParserState,
    /// The bytes of the incomplete input, or the text of the paste.
    pending: Vec<u8>,
    /// Start time of the incomplete input.
    started: Instant,
    /// Time of the last bytes.
    last: Instant,
    /// Time of the last bytes that were not typed.
    last_untyped: Instant,
    events: Vec<Event>,
}

impl Parser {
    /// A parser without input.
    pub fn new(now: Instant) -> Self {
        Self {
            state: ParserState::Ground,
            pending: Vec::new(),
            started: now,
            last: now,
            last_untyped: now,
            events: Vec::new(),
        }
    }

    /// Parses the bytes of one read; returns the events they complete.
    pub fn feed(&mut self, bytes: &[u8], now: Instant) -> Vec<Event> {
        let pause = now.saturating_duration_since(self.last);
        if bytes.len() >= TYPED_PIECE || pause < TYPING_PAUSE {
            self.last_untyped = now;
        }
        self.last = now;
        for (index, byte) in bytes.iter().enumerate() {
            if *byte == CONTROL_C {
                self.interrupt(index + 1 == bytes.len());
            } else {
                self.accept(*byte);
            }
        }
        std::mem::take(&mut self.events)
    }

    /// When to call [`Parser::expire`] if no byte arrives before; none without incomplete input.
    pub fn deadline(&self) -> Option<Instant> {
        match self.state {
            ParserState::Ground => None,
            ParserState::Paste if self.pending.len() > LONG_PASTE => {
                Some(self.last_untyped + LONG_PASTE_TIMEOUT)
            }
            ParserState::Paste => Some(self.last_untyped + PASTE_TIMEOUT),
            _ => Some((self.last + SEQUENCE_TIMEOUT).min(self.started + SEQUENCE_LIMIT)),
        }
    }

    /// Ends the incomplete input: a paste becomes its text so far, a sequence becomes the keys of its bytes.
    pub fn expire(&mut self) -> Vec<Event> {
        self.release();
        std::mem::take(&mut self.events)
    }

    fn accept(&mut self, byte: u8) {
        match self.state {
            ParserState::Ground => self.begin(byte),
            ParserState::Escape => self.escaped(byte),
            ParserState::Letter => self.letter(byte),
            ParserState::Csi | ParserState::Ss3 => self.sequence(byte),
            ParserState::PlainMouse => self.plain_mouse(byte),
            ParserState::Report => self.report(byte),
            ParserState::Paste => self.paste(byte),
        }
    }

    fn begin(&mut self, byte: u8) {
        self.started = self.last;
        match byte {
            ESCAPE => self.advance(ParserState::Escape, byte),
            0xc2..=0xf4 => self.advance(ParserState::Letter, byte),
            // No UTF-8 character starts with these.
            0x80.. => {}
            _ => self.press(char::from(byte), KeyModifiers::NONE),
        }
    }

    fn escaped(&mut self, byte: u8) {
        match byte {
            b'[' => self.advance(ParserState::Csi, byte),
            b'O' => self.advance(ParserState::Ss3, byte),
            b']' | b'P' | b'_' => self.advance(ParserState::Report, byte),
            0xc2..=0xf4 => self.advance(ParserState::Letter, byte),
            ESCAPE | 0x80.. => self.restart_with(byte),
            _ => {
                self.reset();
                self.press(char::from(byte), KeyModifiers::ALT);
            }
        }
    }

    fn letter(&mut self, byte: u8) {
        if !matches!(byte, 0x80..=0xbf) {
            return self.restart_with(byte);
        }
        self.pending.push(byte);
        let (held, letter) = match self.pending.strip_prefix(&[ESCAPE]) {
            Some(letter) => (KeyModifiers::ALT, letter),
            None => (KeyModifiers::NONE, &self.pending[..]),
        };
        let length = match letter[0] {
            0xc2..=0xdf => 2,
            0xe0..=0xef => 3,
            _ => 4,
        };
        if letter.len() == length {
            // Overlong encodings and surrogates are invalid.
            let letter = str::from_utf8(letter)
                .ok()
                .and_then(|text| text.chars().next());
            self.reset();
            if let Some(letter) = letter {
                self.press(letter, held);
            }
        }
    }

    fn sequence(&mut self, byte: u8) {
        let body = &self.pending[2..];
        let is_first = body.is_empty() && self.state == ParserState::Csi;
        // With Shift, rxvt ends a key number by `$`, which is not a final byte elsewhere.
        let is_shifted = byte == b'$' && !body.is_empty() && body.iter().all(u8::is_ascii_digit);
        match byte {
            b'M' if is_first => self.advance(ParserState::PlainMouse, byte),
            // Function keys of the Linux console have a second bracket.
            b'[' if is_first => self.pending.push(byte),
            0x20..=0x3f if !is_shifted => self.pending.push(byte),
            0x20..=0x7e => {
                self.pending.push(byte);
                self.complete();
            }
            _ => self.restart_with(byte),
        }
    }

    fn complete(&mut self) {
        let body = &self.pending[2..];
        let event = match self.state {
            ParserState::Csi if body == b"200~" => {
                self.reset();
                self.state = ParserState::Paste;
                self.last_untyped = self.last;
                return;
            }
            ParserState::Csi => sequence::csi(body),
            _ => sequence::ss3(body),
        };
        self.reset();
        self.events.extend(event);
    }

    fn plain_mouse(&mut self, byte: u8) {
        if byte < 0x20 {
            return self.restart_with(byte);
        }
        self.pending.push(byte);
        if let Some(bytes @ [_, _, _]) = self.pending.get(3..) {
            self.events.extend(sequence::plain_mouse(bytes));
            self.reset();
        }
    }

    fn report(&mut self, byte: u8) {
        let is_escaped = self.pending.last() == Some(&ESCAPE);
        match byte {
            BELL => self.reset(),
            b'\\' if is_escaped => self.reset(),
            _ if is_escaped => {
                self.pending.pop();
                self.restart_with(ESCAPE);
                self.accept(byte);
            }
            _ => self.pending.push(byte),
        }
    }

    fn paste(&mut self, byte: u8) {
        self.pending.push(byte);
        if self.pending.ends_with(PASTE_END) {
            self.pending.truncate(self.pending.len() - PASTE_END.len());
            self.release();
        }
    }

    /// Handles Ctrl-C in any state. Within a paste, the following bytes of the same read are still text: if a person
    /// presses it, it is the last byte.
    fn interrupt(&mut self, is_last: bool) {
        let state = self.state;
        self.release();
        if state == ParserState::Paste && !is_last {
            self.state = ParserState::Paste;
        }
        self.press(char::from(CONTROL_C), KeyModifiers::NONE);
    }

    fn advance(&mut self, state: ParserState, byte: u8) {
        self.state = state;
        self.pending.push(byte);
    }

    fn reset(&mut self) {
        self.state = ParserState::Ground;
        self.pending.clear();
    }

    /// Ends the incomplete input at a byte that does not continue it; the byte starts a new input.
    fn restart_with(&mut self, byte: u8) {
        self.release();
        self.begin(byte);
    }

    /// Emits the text of a paste, or the bytes of the incomplete input as keys, without incomplete characters.
    fn release(&mut self) {
        let bytes = std::mem::take(&mut self.pending);
        let state = std::mem::replace(&mut self.state, ParserState::Ground);
        if state == ParserState::Paste {
            if !bytes.is_empty() {
                let text = String::from_utf8_lossy(&bytes).into_owned();
                self.events.push(Event::Paste(text));
            }
            return;
        }
        let mut keys = &bytes[..];
        // A string starts like a complete Alt key. No terminal sends `ESC [` or `ESC O` as keys: these are Esc and a
        // typed character.
        if let (ParserState::Report, [_, letter, rest @ ..]) = (state, keys) {
            self.press(char::from(*letter), KeyModifiers::ALT);
            keys = rest;
        }
        for c in String::from_utf8_lossy(keys).chars() {
            if c != char::REPLACEMENT_CHARACTER {
                self.press(c, KeyModifiers::NONE);
            }
        }
    }

    fn press(&mut self, c: char, held: KeyModifiers) {
        self.events.extend(sequence::key(c, held).map(Event::Key));
    }
}

#[cfg(test)]
mod tests;
