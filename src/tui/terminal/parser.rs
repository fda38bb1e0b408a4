//! Keys, mouse and pasted text from the bytes of a terminal.
//!
//! The parser has no clock: the caller gives the time of the bytes, and calls [`Parser::expire`] when
//! [`Parser::deadline`] passes without any. So what stays unfinished never holds up the keys that follow.

use std::time::{Duration, Instant};

use crossterm::event::KeyModifiers;

use super::sequence;
use crate::tui::event::Event;

/// After this much silence an unfinished sequence is taken as keys. The parts of a sequence follow each other faster,
/// also on a slow line; a person types slower.
const SILENCE: Duration = Duration::from_millis(80);

/// After this time it is taken as keys without silence too: a key that repeats could keep it going.
const LONGEST: Duration = Duration::from_secs(1);

/// After this much silence a paste ends without its end mark: the mark was lost, or there never was a paste.
const PASTE_SILENCE: Duration = Duration::from_millis(800);

/// The same for a long paste: it is no slip of the fingers, and a slow line holds it up for longer.
const LONG_PASTE_SILENCE: Duration = Duration::from_secs(2);

/// A longer paste is a long one, bytes.
const LONG_PASTE: usize = 4096;

/// Bytes that come in smaller pieces than this, after longer pauses than [`TYPING_PAUSE`], are typed: they keep no paste
/// open.
const TYPED_PIECE: usize = 8;

/// See [`TYPED_PIECE`].
const TYPING_PAUSE: Duration = Duration::from_millis(50);

const CONTROL_C: u8 = 3;
const BELL: u8 = 7;
const ESCAPE: u8 = 0x1b;
const PASTE_END: &[u8] = b"\x1b[201~";

/// What the bytes so far are the beginning of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// Nothing: the next byte begins something.
    Ground,
    /// `ESC`.
    Escape,
    /// A letter in UTF-8, perhaps behind `ESC`.
    Letter,
    /// `ESC [`, up to a last letter.
    Csi,
    /// `ESC O`, up to a last letter.
    Ss3,
    /// `ESC [ M` and three bytes: the mouse of old terminals.
    PlainMouse,
    /// `ESC ]`, `ESC P` or `ESC _`: a report in words, up to `BEL` or `ESC \`.
    Report,
    /// Text behind `ESC [ 200 ~`.
    Paste,
}

/// Turns bytes into events.
#[derive(Debug)]
pub struct Parser {
    state: State,
    /// The bytes of what is unfinished, or the text of the paste.
    pending: Vec<u8>,
    /// When what is unfinished began.
    began: Instant,
    /// When the last bytes came.
    last: Instant,
    /// When the last bytes came that were not typed.
    last_untyped: Instant,
    events: Vec<Event>,
}

impl Parser {
    /// A parser without bytes so far.
    pub fn new(now: Instant) -> Self {
        Self {
            state: State::Ground,
            pending: Vec::new(),
            began: now,
            last: now,
            last_untyped: now,
            events: Vec::new(),
        }
    }

    /// Takes the bytes of one read; what they complete.
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
                self.take(*byte);
            }
        }
        std::mem::take(&mut self.events)
    }

    /// When to call [`Parser::expire`] if no byte comes before; none where nothing is unfinished.
    pub fn deadline(&self) -> Option<Instant> {
        match self.state {
            State::Ground => None,
            State::Paste if self.pending.len() > LONG_PASTE => {
                Some(self.last_untyped + LONG_PASTE_SILENCE)
            }
            State::Paste => Some(self.last_untyped + PASTE_SILENCE),
            _ => Some((self.last + SILENCE).min(self.began + LONGEST)),
        }
    }

    /// Ends what is unfinished: a paste is its text so far, a sequence is the keys that it is made of.
    pub fn expire(&mut self) -> Vec<Event> {
        self.release();
        std::mem::take(&mut self.events)
    }

    fn take(&mut self, byte: u8) {
        match self.state {
            State::Ground => self.begin(byte),
            State::Escape => self.escaped(byte),
            State::Letter => self.letter(byte),
            State::Csi | State::Ss3 => self.sequence(byte),
            State::PlainMouse => self.plain_mouse(byte),
            State::Report => self.report(byte),
            State::Paste => self.paste(byte),
        }
    }

    fn begin(&mut self, byte: u8) {
        self.began = self.last;
        match byte {
            ESCAPE => self.go_on(State::Escape, byte),
            0xc2..=0xf4 => self.go_on(State::Letter, byte),
            // No letter begins with these.
            0x80.. => {}
            _ => self.press(char::from(byte), KeyModifiers::NONE),
        }
    }

    fn escaped(&mut self, byte: u8) {
        match byte {
            b'[' => self.go_on(State::Csi, byte),
            b'O' => self.go_on(State::Ss3, byte),
            b']' | b'P' | b'_' => self.go_on(State::Report, byte),
            0xc2..=0xf4 => self.go_on(State::Letter, byte),
            ESCAPE | 0x80.. => self.break_off(byte),
            _ => {
                self.close();
                self.press(char::from(byte), KeyModifiers::ALT);
            }
        }
    }

    fn letter(&mut self, byte: u8) {
        if !matches!(byte, 0x80..=0xbf) {
            return self.break_off(byte);
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
            // Longer forms than a letter needs, and halves of surrogates, are no letters.
            let letter = str::from_utf8(letter)
                .ok()
                .and_then(|text| text.chars().next());
            self.close();
            if let Some(letter) = letter {
                self.press(letter, held);
            }
        }
    }

    fn sequence(&mut self, byte: u8) {
        let body = &self.pending[2..];
        let is_first = body.is_empty() && self.state == State::Csi;
        // With Shift, rxvt ends the number of a key by a byte that ends nothing elsewhere.
        let is_shifted = byte == b'$' && !body.is_empty() && body.iter().all(u8::is_ascii_digit);
        match byte {
            b'M' if is_first => self.go_on(State::PlainMouse, byte),
            // The function keys of the Linux console have a second bracket.
            b'[' if is_first => self.pending.push(byte),
            0x20..=0x3f if !is_shifted => self.pending.push(byte),
            0x20..=0x7e => {
                self.pending.push(byte);
                self.complete();
            }
            _ => self.break_off(byte),
        }
    }

    fn complete(&mut self) {
        let body = &self.pending[2..];
        let event = match self.state {
            State::Csi if body == b"200~" => {
                self.close();
                self.state = State::Paste;
                self.last_untyped = self.last;
                return;
            }
            State::Csi => sequence::csi(body),
            _ => sequence::ss3(body),
        };
        self.close();
        self.events.extend(event);
    }

    fn plain_mouse(&mut self, byte: u8) {
        if byte < 0x20 {
            return self.break_off(byte);
        }
        self.pending.push(byte);
        if let Some(bytes @ [_, _, _]) = self.pending.get(3..) {
            self.events.extend(sequence::plain_mouse(bytes));
            self.close();
        }
    }

    fn report(&mut self, byte: u8) {
        let is_escaped = self.pending.last() == Some(&ESCAPE);
        match byte {
            BELL => self.close(),
            b'\\' if is_escaped => self.close(),
            _ if is_escaped => {
                self.pending.pop();
                self.break_off(ESCAPE);
                self.take(byte);
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

    /// Ctrl-C counts inside of anything. Inside of a paste, the bytes of the same read that follow it are still text: it
    /// is the last one where a person presses it.
    fn interrupt(&mut self, is_last: bool) {
        let state = self.state;
        self.release();
        if state == State::Paste && !is_last {
            self.state = State::Paste;
        }
        self.press(char::from(CONTROL_C), KeyModifiers::NONE);
    }

    fn go_on(&mut self, state: State, byte: u8) {
        self.state = state;
        self.pending.push(byte);
    }

    fn close(&mut self) {
        self.state = State::Ground;
        self.pending.clear();
    }

    /// The byte does not continue what is unfinished: it begins something new.
    fn break_off(&mut self, byte: u8) {
        self.release();
        self.begin(byte);
    }

    /// Sends the text of a paste, or what is unfinished as the keys that it is made of; half a letter is none.
    fn release(&mut self) {
        let bytes = std::mem::take(&mut self.pending);
        let state = std::mem::replace(&mut self.state, State::Ground);
        if state == State::Paste {
            if !bytes.is_empty() {
                let text = String::from_utf8_lossy(&bytes).into_owned();
                self.events.push(Event::Paste(text));
            }
            return;
        }
        let mut keys = &bytes[..];
        // A report begins like a letter with Alt, which otherwise is complete. `ESC [` and `ESC O` are no keys of any
        // terminal: somebody typed Esc and a character.
        if let (State::Report, [_, letter, rest @ ..]) = (state, keys) {
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
