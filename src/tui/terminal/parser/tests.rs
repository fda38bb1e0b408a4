use super::*;
use crate::tui::keys::Key;

/// A parser at a connection with simulated time.
struct Connection {
    parser: Parser,
    now: Instant,
    received: Vec<String>,
}

impl Connection {
    fn new() -> Self {
        let now = Instant::now();
        Self {
            parser: Parser::new(now),
            now,
            received: Vec::new(),
        }
    }

    fn wait(&mut self, milliseconds: u64) {
        let end = self.now + Duration::from_millis(milliseconds);
        while self
            .parser
            .deadline()
            .is_some_and(|deadline| deadline <= end)
        {
            let events = self.parser.expire();
            self.record(events);
        }
        self.now = end;
    }

    fn send(&mut self, bytes: &[u8]) {
        let events = self.parser.feed(bytes, self.now);
        self.record(events);
    }

    fn record(&mut self, events: Vec<Event>) {
        let words = events.into_iter().map(|event| match event {
            Event::Key(key) => Key::of(&key).name(),
            Event::Paste(text) => format!("paste {text}"),
            Event::Mouse(mouse) => format!("{:?} {} {}", mouse.kind, mouse.column, mouse.row),
            other => panic!("{other:?}"),
        });
        self.received.extend(words);
    }

    /// The events since the last call, joined by blanks.
    fn received(&mut self) -> String {
        std::mem::take(&mut self.received).join(" ")
    }
}

/// The events of pieces with this pause (ms) after each, and a final second of silence.
fn received(pieces: &[&[u8]], pause: u64) -> String {
    let mut connection = Connection::new();
    for piece in pieces {
        connection.send(piece);
        connection.wait(pause);
    }
    connection.wait(1000);
    connection.received()
}

/// One byte at a time.
fn bytewise(bytes: &[u8]) -> Vec<&[u8]> {
    bytes.chunks(1).collect()
}

#[test]
fn an_incomplete_sequence_becomes_the_keys_of_its_bytes() {
    let expected: [(&[u8], &str); 17] = [
        (b"\x1b", "Esc"),
        (b"\x1b\x1b", "Esc Esc"),
        (b"\x1b[", "Esc ["),
        (b"\x1b[<", "Esc [ <"),
        (b"\x1b[<0;5", "Esc [ < 0 ; 5"),
        (b"\x1b[?", "Esc [ ?"),
        (b"\x1b[[", "Esc [ ["),
        (b"\x1b[1;", "Esc [ 1 ;"),
        (b"\x1b[M", "Esc [ M"),
        (b"\x1b[M !", "Esc [ M Space !"),
        (b"\x1bO", "Esc O"),
        (b"\x1bO1", "Esc O 1"),
        (b"\x1b]", "Alt-]"),
        (b"\x1bP+q", "Alt-P + q"),
        (b"\x1b]11;\xc3\xa4\r", "Alt-] 1 1 ; \u{e4} Enter"),
        (b"\xc3", ""),
        (b"\x1b\xe2\x82", "Esc"),
    ];
    for (bytes, expected) in expected {
        assert_eq!(received(&[bytes], 0), expected, "{}", bytes.escape_ascii());
        let mut connection = Connection::new();
        connection.send(bytes);
        connection.wait(79);
        assert!(connection.parser.deadline().is_some(), "waits for more");
        connection.wait(1);
        assert_eq!(
            connection.parser.deadline(),
            None,
            "{}",
            bytes.escape_ascii()
        );
        connection.received();
        connection.send(b"q");
        assert_eq!(connection.received(), "q", "{}", bytes.escape_ascii());
    }
}

/// A person presses a key every 0.1 to 0.3 s; the bytes of one key follow each other faster on any line.
#[test]
fn typed_bytes_are_keys_and_a_split_sequence_is_one_key() {
    let sequences: [(&[u8], &str, &str); 6] = [
        (b"\x1b[<", "Esc [ <", "Esc [ <"),
        (b"\x1b[A", "Up", "Esc [ A"),
        (b"\x1b[1;5C", "Ctrl-Right", "Esc [ 1 ; 5 C"),
        (b"\x1bOP", "F1", "Esc O P"),
        (b"\x1b[<0;12;7M", "Down(Left) 11 6", "Esc [ < 0 ; 1 2 ; 7 M"),
        (b"\x1bx", "Alt-x", "Esc x"),
    ];
    for (bytes, split, typed) in sequences {
        for pause in [0, 1, 20, 70] {
            assert_eq!(received(&bytewise(bytes), pause), split, "{pause} ms");
        }
        for pause in [100, 200, 300] {
            assert_eq!(received(&bytewise(bytes), pause), typed, "{pause} ms");
        }
    }
    assert_eq!(received(&bytewise("\u{20ac}".as_bytes()), 70), "\u{20ac}");
    assert_eq!(
        received(&[b"\x1b[20", b"0~ab", b"c\x1b[2", b"01~q"], 70),
        "paste abc q"
    );
}

/// A key that repeats 30 times a second after `ESC [` does not extend the sequence forever.
#[test]
fn a_sequence_of_more_than_a_second_becomes_keys() {
    let mut connection = Connection::new();
    connection.send(b"\x1b[");
    for _ in 0..40 {
        connection.wait(33);
        connection.send(b"1");
    }
    assert_eq!(connection.received().split(' ').count(), 2 + 40);
}

#[test]
fn control_c_works_in_any_state() {
    let expected: [(&[u8], &str); 9] = [
        (b"\x1b\x03", "Esc Ctrl-c"),
        (b"\x1b[\x03", "Esc [ Ctrl-c"),
        (b"\x1b[<0;5\x03", "Esc [ < 0 ; 5 Ctrl-c"),
        (b"\x1b[M  \x03", "Esc [ M Space Space Ctrl-c"),
        (b"\x1bO\x03", "Esc O Ctrl-c"),
        (b"\x1b]11\x03", "Alt-] 1 1 Ctrl-c"),
        (b"\xe2\x82\x03", "Ctrl-c"),
        (b"\x1b[200~abc\x03", "paste abc Ctrl-c"),
        (b"\x1b[200~\x03", "Ctrl-c"),
    ];
    for (bytes, expected) in expected {
        let mut connection = Connection::new();
        connection.send(bytes);
        // Without a pause; the next key is a key again.
        assert_eq!(connection.received(), expected, "{}", bytes.escape_ascii());
        connection.send(b"d");
        assert_eq!(connection.received(), "d", "{}", bytes.escape_ascii());
    }
    // In the middle of a paste, the rest is still text.
    let pasted = b"\x1b[200~a\x03D\x1b[201~q";
    assert_eq!(received(&[pasted], 0), "paste a Ctrl-c paste D q");
}

#[test]
fn a_paste_without_its_end_ends_by_itself() {
    let mut connection = Connection::new();
    connection.send(b"\x1b[200~abc");
    connection.wait(799);
    assert_eq!(connection.received(), "");
    connection.wait(1);
    assert_eq!(connection.received(), "paste abc");
    connection.send(b"q\x1b[201~");
    assert_eq!(connection.received(), "q");
    // Typed keys do not extend it.
    for pause in [60, 100, 300] {
        let mut connection = Connection::new();
        connection.send(b"\x1b[200~abc");
        for _ in 0..=800 / pause {
            connection.wait(pause);
            connection.send(b"q");
        }
        assert!(connection.received().ends_with("q q"), "{pause} ms");
    }
}

/// A megabyte at 10 kB/s in pieces, with stalls of lost packets.
#[test]
fn a_long_paste_on_a_slow_line_is_one() {
    let mut connection = Connection::new();
    connection.send(b"\x1b[200~");
    for piece in 0..1000 {
        connection.wait(if piece % 100 == 99 { 1900 } else { 100 });
        connection.send(&[b'x'; 1000]);
    }
    // A line of 300 baud brings 30 letters a second.
    for _ in 0..100 {
        connection.wait(33);
        connection.send(b"y");
    }
    connection.send(b"\x1b[201~");
    let text = "x".repeat(1_000_000) + &"y".repeat(100);
    assert_eq!(connection.received(), format!("paste {text}"));
    connection.send(b"\x1b[200~\x1b[201~q");
    assert_eq!(connection.received(), "q");
}

#[test]
fn an_interrupted_sequence_becomes_keys_and_the_next_input_is_parsed() {
    let expected: [(&[u8], &str); 12] = [
        (b"\x1b\x1b[A", "Esc Up"),
        (b"\x1b[\x1b[A", "Esc [ Up"),
        (b"\x1b[1\r", "Esc [ 1 Enter"),
        (b"\x1bO\x1bOA", "Esc O Up"),
        (b"\x1b[M\x01q", "Esc [ M Ctrl-a q"),
        (b"\x1b]x\x1b[A", "Alt-] x Up"),
        (b"\xc3q", "q"),
        (b"\xc3\xc3\xa4", "\u{e4}"),
        (b"\x1b\xc3q", "Esc q"),
        (b"\x80\xff\xc0\xf5q", "q"),
        // An overlong encoding and a surrogate.
        (b"\xe0\x80\x80q\xed\xa0\x80w", "q w"),
        (b"\x1b[\xc3\xa4", "Esc [ \u{e4}"),
    ];
    for (bytes, expected) in expected {
        assert_eq!(received(&[bytes], 0), expected, "{}", bytes.escape_ascii());
        assert_eq!(
            received(&bytewise(bytes), 10),
            expected,
            "{}",
            bytes.escape_ascii()
        );
    }
}

/// Unknown sequences (focus, attributes, colours, names, keys) are ignored as a whole.
#[test]
fn unknown_sequences_are_ignored() {
    let ignored: [&[u8]; 12] = [
        b"\x1b[I",
        b"\x1b[O",
        b"\x1b[99~",
        b"\x1b[12;40R",
        b"\x1b[?62;4c",
        b"\x1b[?2026;2$y",
        b"\x1b[<35;1;1M",
        b"\x1b[M#!!",
        b"\x1bOM",
        b"\x1b]11;rgb:0000/0000/0000\x07",
        b"\x1b]11;rgb:ffff/ffff/ffff\x1b\\",
        b"\x1bP>|term 1.0 Dxq\x1b\\",
    ];
    for bytes in ignored {
        let bytes = [bytes, b"q"].concat();
        assert_eq!(received(&[&bytes], 0), "q", "{}", bytes.escape_ascii());
        assert_eq!(
            received(&bytewise(&bytes), 10),
            "q",
            "{}",
            bytes.escape_ascii()
        );
    }
}

#[test]
fn alt_works_with_any_character() {
    let bytes = "\u{1b}h\u{1b}\r\u{1b}\u{7f}\u{1b}H\u{1b}\u{e4}\u{1b}[1;3A".as_bytes();
    let expected = "Alt-h Alt-Enter Alt-Backspace Alt-H Alt-\u{e4} Alt-Up";
    assert_eq!(received(&[bytes], 0), expected);
    assert_eq!(received(&bytewise(bytes), 10), expected);
}

#[test]
fn rxvt_ends_shifted_keys_by_a_dollar() {
    assert_eq!(received(&[b"\x1b[3$q"], 0), "Shift-Del q");
}
