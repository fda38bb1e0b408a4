//! The threads that send what comes from outside: keys and mouse, signals, and the loss of the terminal.

use std::io;
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;

use crossterm::event::{self, KeyEventKind, MouseEventKind};
use crossterm::terminal::disable_raw_mode;
use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP};
use signal_hook::iterator::Signals;

use super::{give_back, is_gone};
use crate::tui::event::Event;

/// How often it is looked whether the terminal is still there, where the hang-up signal is ignored.
const LOOK_EVERY: Duration = Duration::from_millis(400);

/// How long the program has to end by itself once its terminal is gone.
const GRACE: Duration = Duration::from_millis(350);

/// How long it has after a signal; its terminal may be one that takes no more and is waited for.
const PATIENCE: Duration = Duration::from_secs(3);

/// How long the terminal has to take its last bytes.
const LAST: Duration = Duration::from_millis(100);

/// Starts the threads.
///
/// # Errors
/// Where signals cannot be caught.
pub fn events(sender: &Sender<Event>) -> io::Result<()> {
    let signals = Signals::new([SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT])?;
    let to = sender.clone();
    thread::spawn(move || forward_signals(signals, &to));
    let to = sender.clone();
    thread::spawn(move || forward_input(&to));
    let to = sender.clone();
    thread::spawn(move || watch_terminal(&to));
    Ok(())
}

fn forward_signals(mut signals: Signals, to: &Sender<Event>) {
    for signal in signals.forever() {
        let event = match signal {
            SIGTSTP => Event::Suspend,
            SIGCONT => Event::Resume,
            other => {
                thread::spawn(move || insist(other, PATIENCE));
                Event::Quit(other)
            }
        };
        if to.send(event).is_err() {
            return;
        }
    }
}

fn forward_input(to: &Sender<Event>) {
    loop {
        let event = match event::read() {
            Ok(event) => match of_terminal(event) {
                Some(event) => event,
                None => continue,
            },
            Err(_) => Event::Quit(SIGHUP),
        };
        let last = matches!(event, Event::Quit(_));
        if to.send(event).is_err() || last {
            return;
        }
    }
}

/// What an event of the terminal is to the designer, if it is anything.
fn of_terminal(event: event::Event) -> Option<Event> {
    match event {
        event::Event::Key(key) if key.kind == KeyEventKind::Press => Some(Event::Key(key)),
        event::Event::Mouse(mouse) => match mouse.kind {
            MouseEventKind::Moved | MouseEventKind::Up(_) => None,
            _ => Some(Event::Mouse(mouse)),
        },
        event::Event::Paste(text) => Some(Event::Paste(text)),
        event::Event::Resize(..) => Some(Event::Resize),
        _ => None,
    }
}

/// Ends the program once its terminal is gone, also where the hang-up signal is ignored and reading would spin.
fn watch_terminal(to: &Sender<Event>) {
    while !is_gone() {
        thread::sleep(LOOK_EVERY);
    }
    let _ = to.send(Event::Quit(SIGHUP));
    insist(SIGHUP, GRACE);
}

/// Ends the program as by a signal if it is still there after some time: the drawing thread hangs on its terminal.
fn insist(signal: i32, after: Duration) {
    thread::sleep(after);
    // A terminal that takes no more would hold up this thread too; the modes are the system's.
    thread::spawn(give_back);
    thread::sleep(LAST);
    let _ = disable_raw_mode();
    crate::model::remove_temporaries();
    std::process::exit(128 + signal);
}

#[cfg(test)]
mod tests {
    use crossterm::event::{KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent};

    use super::*;

    #[test]
    fn moves_and_releases_are_nothing_to_the_designer() {
        let passes = |kind| {
            let mouse = MouseEvent {
                kind,
                column: 3,
                row: 4,
                modifiers: KeyModifiers::NONE,
            };
            of_terminal(event::Event::Mouse(mouse)).is_some()
        };
        assert!(passes(MouseEventKind::Down(MouseButton::Left)));
        assert!(passes(MouseEventKind::Drag(MouseButton::Left)));
        assert!(passes(MouseEventKind::ScrollDown));
        assert!(!passes(MouseEventKind::Moved));
        assert!(!passes(MouseEventKind::Up(MouseButton::Left)));
        let mut key = KeyEvent::new(KeyCode::Char('a'), KeyModifiers::NONE);
        assert!(of_terminal(event::Event::Key(key)).is_some());
        key.kind = KeyEventKind::Release;
        assert!(of_terminal(event::Event::Key(key)).is_none());
    }
}
