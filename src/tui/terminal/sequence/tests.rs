use super::*;
use crate::tui::keys::Key;

/// The name of the key, if it is one.
fn name(event: Option<Event>) -> Option<String> {
    match event? {
        Event::Key(key) => Some(Key::of(&key).name()),
        other => panic!("{other:?} is no key"),
    }
}

/// Bytes after `ESC [` and the key that sends them: xterm's ctlseqs ("PC-Style Function Keys"), rxvt's and the Linux
/// console's tables of keys, CSI u of fixterms and kitty.
const CSI: &[(&str, &str)] = &[
    ("A", "Up"),
    ("B", "Down"),
    ("C", "Right"),
    ("D", "Left"),
    ("H", "Home"),
    ("F", "End"),
    ("Z", "Shift-Tab"),
    ("P", "F1"),
    ("1;2A", "Shift-Up"),
    ("1;3B", "Alt-Down"),
    ("1;5C", "Ctrl-Right"),
    ("1;8D", "Ctrl-Alt-Shift-Left"),
    ("1;2H", "Shift-Home"),
    ("1;5F", "Ctrl-End"),
    ("5C", "Ctrl-Right"),
    ("1;5P", "Ctrl-F1"),
    ("1;2Q", "Shift-F2"),
    ("1;2S", "Shift-F4"),
    ("1;5:1A", "Ctrl-Up"),
    ("1;5:2A", "Ctrl-Up"),
    ("1~", "Home"),
    ("2~", "Ins"),
    ("3~", "Del"),
    ("4~", "End"),
    ("5~", "PgUp"),
    ("6~", "PgDn"),
    ("7~", "Home"),
    ("8~", "End"),
    ("3;5~", "Ctrl-Del"),
    ("6;2~", "Shift-PgDn"),
    ("11~", "F1"),
    ("15~", "F5"),
    ("17~", "F6"),
    ("21~", "F10"),
    ("23~", "F11"),
    ("24;2~", "Shift-F12"),
    ("34~", "F17"),
    ("[A", "F1"),
    ("[E", "F5"),
    ("3$", "Shift-Del"),
    ("7^", "Ctrl-Home"),
    ("8@", "Ctrl-Shift-End"),
    ("a", "Shift-Up"),
    ("27u", "Esc"),
    ("13u", "Enter"),
    ("9;2u", "Shift-Tab"),
    ("127;5u", "Ctrl-Backspace"),
    ("99;5u", "Ctrl-c"),
    ("99;69u", "Ctrl-c"),
    ("97;2u", "A"),
    ("49:33;2u", "!"),
    ("228u", "ä"),
    ("57404u", "5"),
    ("57414u", "Enter"),
    ("57426u", "Del"),
    ("57376u", "F13"),
    ("27;5;99~", "Ctrl-c"),
];

/// Sequences that are not keys, key releases, and keys with Super.
const NOTHING: &[&str] = &[
    "I",
    "O",
    "E",
    "99~",
    "200",
    "256~",
    "12;40R",
    "1;2R",
    "?62;4c",
    ">0;276;0c",
    "?1u",
    "?1A",
    "?62;4A",
    "<5;5A",
    "0n",
    "8;24;80t",
    "1;x5A",
    "1;5:3A",
    "97;1:3u",
    "1;9A",
    "97;9u",
    "57358u",
    "1114112u",
    "u",
    ";u",
    "~",
    "[",
    "[F",
    "1;",
    "M",
    "m",
    "<M",
    "<0;5M",
    "<0;0;1M",
    "<0;1;0M",
    "<99999;1;1M",
    "<0;65536;1M",
    "<-1;1;1M",
    " q",
    "",
];

#[test]
fn keys_of_terminals_are_decoded() {
    for (body, expected) in CSI {
        let found = name(csi(body.as_bytes()));
        assert_eq!(found.as_deref(), Some(*expected), "ESC [ {body}");
    }
    let behind_o = [
        ("A", "Up"),
        ("D", "Left"),
        ("H", "Home"),
        ("F", "End"),
        ("P", "F1"),
        ("R", "F3"),
        ("S", "F4"),
        ("1;2P", "Shift-F1"),
        ("5A", "Ctrl-Up"),
        ("c", "Ctrl-Right"),
    ];
    for (body, expected) in behind_o {
        let found = name(ss3(body.as_bytes()));
        assert_eq!(found.as_deref(), Some(expected), "ESC O {body}");
    }
}

#[test]
fn reports_and_invalid_sequences_are_ignored() {
    for body in NOTHING {
        assert!(csi(body.as_bytes()).is_none(), "ESC [ {body}");
    }
    for body in ["", "M", "E", "x1A", "\u{e4}A"] {
        assert!(ss3(body.as_bytes()).is_none(), "ESC O {body}");
    }
    assert!(csi(b"\xff~").is_none());
}

#[test]
fn characters_are_keys() {
    let expected = [
        ('\r', "Enter"),
        ('\t', "Tab"),
        ('\u{1b}', "Esc"),
        ('\u{7f}', "Backspace"),
        ('\0', "Ctrl-Space"),
        ('\u{1}', "Ctrl-a"),
        ('\u{8}', "Ctrl-h"),
        ('\n', "Ctrl-j"),
        ('\u{1a}', "Ctrl-z"),
        ('\u{1c}', "Ctrl-\\"),
        ('\u{1d}', "Ctrl-]"),
        ('\u{1e}', "Ctrl-^"),
        ('\u{1f}', "Ctrl-_"),
        ('U', "U"),
        ('ä', "ä"),
    ];
    for (c, expected) in expected {
        let found = key(c, KeyModifiers::NONE).map(|key| Key::of(&key).name());
        assert_eq!(found.as_deref(), Some(expected), "{c:?}");
        // The key names of the configuration file match decoded keys.
        assert!(Key::parse(expected).is_some() || c == '\n' || c == '\u{8}' || c == '\0');
    }
    assert_eq!(key('\u{9b}', KeyModifiers::NONE), None);
}

/// xterm's ctlseqs, "Mouse Tracking": the button in the low bits, 4 Shift, 8 Alt, 16 Control, 32 dragging, 64 the wheel;
/// columns and rows from 1.
#[test]
fn buttons_and_the_wheel_are_decoded_in_both_encodings() {
    let mouse = |kind, modifiers| {
        let (column, row) = (4, 6);
        format!(
            "{:?}",
            Some(Event::Mouse(MouseEvent {
                kind,
                column,
                row,
                modifiers
            }))
        )
    };
    let none = KeyModifiers::NONE;
    let expected = [
        (0, mouse(MouseEventKind::Down(MouseButton::Left), none)),
        (1, mouse(MouseEventKind::Down(MouseButton::Middle), none)),
        (2, mouse(MouseEventKind::Down(MouseButton::Right), none)),
        (32, mouse(MouseEventKind::Drag(MouseButton::Left), none)),
        (64, mouse(MouseEventKind::ScrollUp, none)),
        (65, mouse(MouseEventKind::ScrollDown, none)),
        (
            4 + 16,
            mouse(
                MouseEventKind::Down(MouseButton::Left),
                KeyModifiers::SHIFT | KeyModifiers::CONTROL,
            ),
        ),
        (64 + 8, mouse(MouseEventKind::ScrollUp, KeyModifiers::ALT)),
        // Releases, movements without a button, unknown buttons.
        (3, "None".to_owned()),
        (35, "None".to_owned()),
        (128, "None".to_owned()),
        (96, "None".to_owned()),
    ];
    for (button, expected) in expected {
        let decimals = csi(format!("<{button};5;7M").as_bytes());
        assert_eq!(format!("{decimals:?}"), expected, "{button}");
        let bytes = plain_mouse(&[32 + button, 32 + 5, 32 + 7]);
        assert_eq!(format!("{bytes:?}"), expected, "{button}");
        assert!(csi(format!("<{button};5;7m").as_bytes()).is_none());
    }
    assert!(plain_mouse(&[31, 40, 40]).is_none() && plain_mouse(&[32, 32, 40]).is_none());
}
