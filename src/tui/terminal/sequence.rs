//! What the characters and sequences of a terminal stand for: keys, and buttons and wheel of the mouse.
//!
//! The forms are those of xterm (ctlseqs), of CSI u (fixterms, kitty), of rxvt and of the Linux console. A sequence that
//! stands for nothing the designer knows is None: reports, focus, moves of the mouse, keys that are let go.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

use crate::tui::event::Event;

/// Keys of the keypad from kitty's code 57399 on.
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

/// The key of a character, with what is held with it; none for the controls of Latin-1.
pub(super) fn key(c: char, held: KeyModifiers) -> Option<KeyEvent> {
    let (code, own) = match c {
        '\r' => (KeyCode::Enter, KeyModifiers::NONE),
        '\t' => (KeyCode::Tab, KeyModifiers::NONE),
        '\x1b' => (KeyCode::Esc, KeyModifiers::NONE),
        '\x7f' => (KeyCode::Backspace, KeyModifiers::NONE),
        '\0' => (KeyCode::Char(' '), KeyModifiers::CONTROL),
        '\x01'..='\x1f' => {
            // The code of the letter without the bits of its column in the table of ASCII.
            let letter = char::from(c as u8 | 0x40).to_ascii_lowercase();
            (KeyCode::Char(letter), KeyModifiers::CONTROL)
        }
        c if c.is_control() => return None,
        c if c.is_uppercase() => (KeyCode::Char(c), KeyModifiers::SHIFT),
        c => (KeyCode::Char(c), KeyModifiers::NONE),
    };
    Some(KeyEvent::new(code, held | own))
}

/// What a sequence stands for whose bytes behind `ESC [` are these.
pub(super) fn csi(body: &[u8]) -> Option<Event> {
    let (last, parameters) = body.split_last()?;
    let parameters = str::from_utf8(parameters).ok()?;
    let key = match last {
        b'M' | b'm' => return mouse(parameters.strip_prefix('<')?, *last == b'M'),
        // Reports begin so.
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
        // The place of the cursor, not F3.
        b'R' => None,
        b'a'..=b'd' if parameters.is_empty() => {
            lettered("", last.to_ascii_uppercase(), KeyModifiers::SHIFT)
        }
        letter => lettered(parameters, *letter, KeyModifiers::NONE),
    };
    key.map(Event::Key)
}

/// The same behind `ESC O`.
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

/// The mouse of terminals that do not know decimals: button, column and row as bytes from 32 on.
pub(super) fn plain_mouse(bytes: &[u8]) -> Option<Event> {
    let [button, column, row] = *bytes else {
        return None;
    };
    let place = |byte: u8| byte.checked_sub(33).map(u16::from);
    clicked(
        u16::from(button.checked_sub(32)?),
        place(column)?,
        place(row)?,
    )
}

/// The mouse with decimals: button, column and row from 1 on.
fn mouse(parameters: &str, pressed: bool) -> Option<Event> {
    let mut numbers = parameters.split(';').map(|text| text.parse::<u16>().ok());
    let mut next = || numbers.next().flatten();
    let (button, column, row) = (next()?, next()?, next()?);
    let event = clicked(button, column.checked_sub(1)?, row.checked_sub(1)?);
    event.filter(|_| pressed)
}

/// A button that is pressed or dragged, or the wheel; the bits are xterm's.
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

/// What is held with a key, of `MASK` or `MASK:KIND`, where the mask is 1 more than its bits. None where the key is let
/// go, or where Super, Hyper or Meta is held: no command has them.
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

/// A key that its last letter names: `ESC [ A`, `ESC [ 1 ; 5 A`, `ESC O A`.
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

/// A key that its first number names: `ESC [ 3 ~`, `ESC [ 3 ; 5 ~`.
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
        // Another form of CSI u: xterm's modifyOtherKeys.
        27 => return coded(parameters.next()?, modifiers),
        _ => return None,
    };
    Some(KeyEvent::new(code, held(modifiers)? | more))
}

/// A key by the number of its character, of `CODE` or `CODE:SHIFTED`, or by kitty's number for it.
fn coded(code: &str, modifiers: &str) -> Option<KeyEvent> {
    let mut codes = code.split(':').map(|code| code.parse::<u32>().ok());
    let number = codes.next()??;
    let held = held(modifiers)?;
    let code = match number {
        57_376..=57_387 => KeyCode::F((number - 57_376) as u8 + 13),
        57_399..=57_426 => KEYPAD[(number - 57_399) as usize],
        // Its other keys are in this private range of Unicode.
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
