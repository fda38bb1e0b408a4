//! Decodes characters and escape sequences: keys, and buttons and wheel of the mouse.
//!
//! Supported encodings: xterm (ctlseqs), CSI u (fixterms, kitty), rxvt and the Linux console. Other sequences are None:
//! reports, focus, mouse movements, key releases.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

use crate::tui::event::Event;

/// Keypad keys from kitty's code 57399 on.
const KEYPAD: [KeyCode; 28] = [
    KeyCode::Char('0'),
    KeyCode::Char('1'),
    KeyCode::Char('2'),
    KeyCode::Char('3'),
    KeyCode::Char('4'),
    KeyCode::Char('5'),
    KeyCode::Char('6'),
    KeyCode::Char('7'),
    KeyCode::Char('8'),
    KeyCode::Char('9'),
    KeyCode::Char('.'),
    KeyCode::Char('/'),
    KeyCode::Char('*'),
    KeyCode::Char('-'),
    KeyCode::Char('+'),
    KeyCode::Enter,
    KeyCode::Char('='),
    KeyCode::Char(','),
    KeyCode::Left,
    KeyCode::Right,
    KeyCode::Up,
    KeyCode::Down,
    KeyCode::PageUp,
    KeyCode::PageDown,
    KeyCode::Home,
    KeyCode::End,
    KeyCode::Insert,
    KeyCode::Delete,
];

/// The key of a character with modifiers; none for Latin-1 control characters.
pub(super) fn key(c: char, held: KeyModifiers) -> Option<KeyEvent> {
    let (code, own) = match c {
        '\r' => (KeyCode::Enter, KeyModifiers::NONE),
        '\t' => (KeyCode::Tab, KeyModifiers::NONE),
        '\x1b' => (KeyCode::Esc, KeyModifiers::NONE),
        '\x7f' => (KeyCode::Backspace, KeyModifiers::NONE),
        '\0' => (KeyCode::Char(' '), KeyModifiers::CONTROL),
        '\x01'..='\x1f' => {
            // The control character of a letter is its ASCII code without the two high bits.
            let letter = char::from(c as u8 | 0x40).to_ascii_lowercase();
            (KeyCode::Char(letter), KeyModifiers::CONTROL)
        }
        c if c.is_control() => return None,
        c if c.is_uppercase() => (KeyCode::Char(c), KeyModifiers::SHIFT),
        c => (KeyCode::Char(c), KeyModifiers::NONE),
    };
    Some(KeyEvent::new(code, held | own))
}

/// The event of a sequence, from its bytes after `ESC [`.
pub(super) fn csi(body: &[u8]) -> Option<Event> {
    let (last, parameters) = body.split_last()?;
    let parameters = str::from_utf8(parameters).ok()?;
    let key = match last {
        b'M' | b'm' => return mouse(parameters.strip_prefix('<')?, *last == b'M'),
        // Reports start with these.
        _ if parameters.starts_with(['<', '=', '>', '?']) => None,
        b'~' => numbered(parameters, KeyModifiers::NONE),
        b'$' => numbered(parameters, KeyModifiers::SHIFT),
        b'^' => numbered(parameters, KeyModifiers::CONTROL),
        b'@' => numbered(parameters, KeyModifiers::CONTROL | KeyModifiers::SHIFT),
        b'u' => {
            let (code, rest) = parameters.split_once(';').unwrap_or((parameters, ""));
            coded(code, rest.split(';').next()?)
        }
        b'A'..=b'E' if parameters == "[" => Some(KeyEvent::from(KeyCode::F(last - b'A' + 1))),
        // A cursor position report, not F3.
        b'R' => None,
        b'a'..=b'd' if parameters.is_empty() => {
            lettered("", last.to_ascii_uppercase(), KeyModifiers::SHIFT)
        }
        letter => lettered(parameters, *letter, KeyModifiers::NONE),
    };
    key.map(Event::Key)
}

/// The event of a sequence, from its bytes after `ESC O`.
pub(super) fn ss3(body: &[u8]) -> Option<Event> {
    let (last, parameters) = body.split_last()?;
    let parameters = str::from_utf8(parameters).ok()?;
    let key = match last {
        b'a'..=b'd' if parameters.is_empty() => {
            lettered("", last.to_ascii_uppercase(), KeyModifiers::CONTROL)
        }
        letter => lettered(parameters, *letter, KeyModifiers::NONE),
    };
    key.map(Event::Key)
}

/// A mouse event without decimal coordinates: button, column and row as bytes from 32 on.
pub(super) fn plain_mouse(bytes: &[u8]) -> Option<Event> {
    let [button, column, row] = *bytes else {
        return None;
    };
    let coordinate = |byte: u8| byte.checked_sub(33).map(u16::from);
    clicked(
        u16::from(button.checked_sub(32)?),
        coordinate(column)?,
        coordinate(row)?,
    )
}

/// A mouse event with decimal coordinates: button, column and row from 1 on.
fn mouse(parameters: &str, pressed: bool) -> Option<Event> {
    let mut numbers = parameters.split(';').map(|text| text.parse::<u16>().ok());
    let mut next = || numbers.next().flatten();
    let (button, column, row) = (next()?, next()?, next()?);
    let event = clicked(button, column.checked_sub(1)?, row.checked_sub(1)?);
    event.filter(|_| pressed)
}

/// A pressed or dragged button, or the wheel, from xterm's bits.
fn clicked(button: u16, column: u16, row: u16) -> Option<Event> {
    let dragged = button & 32 != 0;
    let of = |button| {
        if dragged {
            MouseEventKind::Drag(button)
        } else {
            MouseEventKind::Down(button)
        }
    };
    let kind = match (button & !0b1_1100 & !32, dragged) {
        (0, _) => of(MouseButton::Left),
        (1, _) => of(MouseButton::Middle),
        (2, _) => of(MouseButton::Right),
        (64, false) => MouseEventKind::ScrollUp,
        (65, false) => MouseEventKind::ScrollDown,
        (66, false) => MouseEventKind::ScrollLeft,
        (67, false) => MouseEventKind::ScrollRight,
        _ => return None,
    };
    let mut modifiers = KeyModifiers::NONE;
    modifiers.set(KeyModifiers::SHIFT, button & 4 != 0);
    modifiers.set(KeyModifiers::ALT, button & 8 != 0);
    modifiers.set(KeyModifiers::CONTROL, button & 16 != 0);
    Some(Event::Mouse(MouseEvent {
        kind,
        column,
        row,
        modifiers,
    }))
}

/// The modifiers of a key from `MASK` or `MASK:KIND`; the mask is its bits plus 1. None for a key release, and for Super,
/// Hyper and Meta, which no command uses.
fn held(parameter: &str) -> Option<KeyModifiers> {
    let (mask, kind) = parameter.split_once(':').unwrap_or((parameter, "1"));
    let mask = if mask.is_empty() {
        1
    } else {
        mask.parse::<u8>().ok()?
    };
    let bits = mask.saturating_sub(1);
    if kind == "3" || bits & 0b11_1000 != 0 {
        return None;
    }
    let mut modifiers = KeyModifiers::NONE;
    modifiers.set(KeyModifiers::SHIFT, bits & 1 != 0);
    modifiers.set(KeyModifiers::ALT, bits & 2 != 0);
    modifiers.set(KeyModifiers::CONTROL, bits & 4 != 0);
    Some(modifiers)
}

/// A key identified by its final letter: `ESC [ A`, `ESC [ 1 ; 5 A`, `ESC O A`.
fn lettered(parameters: &str, letter: u8, more: KeyModifiers) -> Option<KeyEvent> {
    let (code, own) = match letter {
        b'A' => (KeyCode::Up, KeyModifiers::NONE),
        b'B' => (KeyCode::Down, KeyModifiers::NONE),
        b'C' => (KeyCode::Right, KeyModifiers::NONE),
        b'D' => (KeyCode::Left, KeyModifiers::NONE),
        b'F' => (KeyCode::End, KeyModifiers::NONE),
        b'H' => (KeyCode::Home, KeyModifiers::NONE),
        b'P'..=b'S' => (KeyCode::F(letter - b'P' + 1), KeyModifiers::NONE),
        b'Z' => (KeyCode::BackTab, KeyModifiers::SHIFT),
        _ => return None,
    };
    let held = held(parameters.rsplit(';').next()?)?;
    Some(KeyEvent::new(code, held | own | more))
}

/// A key identified by its first number: `ESC [ 3 ~`, `ESC [ 3 ; 5 ~`.
fn numbered(parameters: &str, more: KeyModifiers) -> Option<KeyEvent> {
    let mut parameters = parameters.split(';');
    let number: u8 = parameters.next()?.parse().ok()?;
    let modifiers = parameters.next().unwrap_or_default();
    let code = match number {
        1 | 7 => KeyCode::Home,
        2 => KeyCode::Insert,
        3 => KeyCode::Delete,
        4 | 8 => KeyCode::End,
        5 => KeyCode::PageUp,
        6 => KeyCode::PageDown,
        11..=15 => KeyCode::F(number - 10),
        17..=21 => KeyCode::F(number - 11),
        23..=26 => KeyCode::F(number - 12),
        28..=29 => KeyCode::F(number - 15),
        31..=34 => KeyCode::F(number - 17),
        // Another encoding of CSI u: xterm's modifyOtherKeys.
        27 => return coded(parameters.next()?, modifiers),
        _ => return None,
    };
    Some(KeyEvent::new(code, held(modifiers)? | more))
}

/// A key by its character code, `CODE` or `CODE:SHIFTED`, or by its kitty code.
fn coded(code: &str, modifiers: &str) -> Option<KeyEvent> {
    let mut codes = code.split(':').map(|code| code.parse::<u32>().ok());
    let number = codes.next()??;
    let held = held(modifiers)?;
    let code = match number {
        57_376..=57_387 => KeyCode::F((number - 57_376) as u8 + 13),
        57_399..=57_426 => KEYPAD[(number - 57_399) as usize],
        // Other kitty keys are in this private Unicode range.
        57_344..=63_743 => return None,
        _ => {
            let plain = char::from_u32(number)?;
            let shifted = codes.next().flatten().and_then(char::from_u32);
            return key(
                match shifted {
                    Some(shifted) if held.contains(KeyModifiers::SHIFT) => shifted,
                    None if held.contains(KeyModifiers::SHIFT) => plain.to_ascii_uppercase(),
                    _ => plain,
                },
                held,
            );
        }
    };
    Some(KeyEvent::new(code, held))
}

#[cfg(test)]
mod tests;
