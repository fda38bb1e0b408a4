//! Threads that send external events: keys and mouse, signals, and the loss of the terminal.

use std::fs::File;
use std::io::{self, IsTerminal as _, Read as _};
use std::os::fd::AsFd as _;
use std::sync::mpsc::Sender;
use std::thread;
use std::time::{Duration, Instant};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use signal_hook::consts::SIGHUP;

use super::parser::Parser;
use super::{is_gone, signals};
use crate::tui::event::Event;

/// Interval of the check for a lost terminal, needed if the hang-up signal is ignored.
const CHECK_INTERVAL: Duration = Duration::from_millis(400);

/// Time for a normal exit after the terminal is lost.
const EXIT_TIMEOUT: Duration = Duration::from_millis(350);

/// Most bytes of one read from a terminal.
const BUFFER_SIZE: usize = 4096;

/// Starts the threads.
///
/// # Errors
/// Signals cannot be caught, or the terminal cannot be read.
pub fn events(sender: &Sender<Event>) -> io::Result<()> {
    signals::start(sender.clone())?;
    let terminal = open()?;
    let to = sender.clone();
    thread::spawn(move || forward_input(terminal, &to));
    let to = sender.clone();
    thread::spawn(move || watch_terminal(&to));
    Ok(())
}

/// The terminal for keys: standard input, else the controlling terminal.
fn open() -> io::Result<File> {
    let input = io::stdin();
    if input.is_terminal() {
        Ok(File::from(input.as_fd().try_clone_to_owned()?))
    } else {
        File::open("/dev/tty")
    }
}

fn forward_input(mut terminal: File, to: &Sender<Event>) {
    let mut parser = Parser::new(Instant::now());
    let mut bytes = [0; BUFFER_SIZE];
    loop {
        let events = match read(&mut terminal, &mut bytes, parser.deadline()) {
            Ok(Some(count)) => parser.feed(&bytes[..count], Instant::now()),
            Ok(None) => parser.expire(),
            Err(error) if is_transient(&error) => continue,
            Err(_) => {
                // Without a receiver the program is already exiting.
                let _ = to.send(Event::Quit(SIGHUP));
                return;
            }
        };
        for event in events {
            if to.send(event).is_err() {
                return;
            }
        }
    }
}

/// Reads from the terminal and returns the number of bytes; none if the deadline passes first.
fn read(
    terminal: &mut File,
    bytes: &mut [u8],
    deadline: Option<Instant>,
) -> io::Result<Option<usize>> {
    let timeout = deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
    let timeout = timeout.and_then(|timeout| Timespec::try_from(timeout).ok());
    if poll(
        &mut [PollFd::new(&*terminal, PollFlags::IN)],
        timeout.as_ref(),
    )? == 0
    {
        return Ok(None);
    }
    match terminal.read(bytes)? {
        // End of file of a lost terminal; an existing terminal has sent an empty line.
        0 if !terminal.is_terminal() => Err(io::ErrorKind::UnexpectedEof.into()),
        count => Ok(Some(count)),
    }
}

/// Whether reading can continue after this error.
fn is_transient(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::Interrupted | io::ErrorKind::WouldBlock
    )
}

/// Ends the program when its terminal is lost, also if the hang-up signal is ignored and reading would spin.
fn watch_terminal(to: &Sender<Event>) {
    while !is_gone() {
        thread::sleep(CHECK_INTERVAL);
    }
    let _ = to.send(Event::Quit(SIGHUP));
    signals::force_exit(SIGHUP, EXIT_TIMEOUT);
}
