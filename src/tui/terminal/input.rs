//! The threads that send what comes from outside: keys and mouse, signals, and the loss of the terminal.

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

/// How often it is looked whether the terminal is still there, where the hang-up signal is ignored.
const LOOK_EVERY: Duration = Duration::from_millis(400);

/// How long the program has to end by itself once its terminal is gone.
const GRACE: Duration = Duration::from_millis(350);

/// As many bytes as a terminal gives at once.
const READ: usize = 4096;

/// Starts the threads.
///
/// # Errors
/// Where signals cannot be caught, or the terminal cannot be read.
pub fn events(sender: &Sender<Event>) -> io::Result<()> {
    signals::start(sender.clone())?;
    let terminal = open()?;
    let to = sender.clone();
    thread::spawn(move || forward_input(terminal, &to));
    let to = sender.clone();
    thread::spawn(move || watch_terminal(&to));
    Ok(())
}

/// The terminal that keys come from: standard input, else the one that the process belongs to.
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
    let mut bytes = [0; READ];
    loop {
        let events = match read(&mut terminal, &mut bytes, parser.deadline()) {
            Ok(Some(count)) => parser.feed(&bytes[..count], Instant::now()),
            Ok(None) => parser.expire(),
            Err(error) if is_passing(&error) => continue,
            Err(_) => {
                // Without a receiver the program ends already.
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

/// Reads what the terminal sends, as a count of bytes; None where nothing has come until the deadline.
fn read(
    terminal: &mut File,
    bytes: &mut [u8],
    deadline: Option<Instant>,
) -> io::Result<Option<usize>> {
    let left = deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
    let left = left.and_then(|left| Timespec::try_from(left).ok());
    if poll(&mut [PollFd::new(&*terminal, PollFlags::IN)], left.as_ref())? == 0 {
        return Ok(None);
    }
    match terminal.read(bytes)? {
        // The end of a line that dropped; a terminal that is still there has sent an empty line.
        0 if !terminal.is_terminal() => Err(io::ErrorKind::UnexpectedEof.into()),
        count => Ok(Some(count)),
    }
}

/// Whether reading can go on after this error.
fn is_passing(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::Interrupted | io::ErrorKind::WouldBlock
    )
}

/// Ends the program once its terminal is gone, also where the hang-up signal is ignored and reading would spin.
fn watch_terminal(to: &Sender<Event>) {
    while !is_gone() {
        thread::sleep(LOOK_EVERY);
    }
    let _ = to.send(Event::Quit(SIGHUP));
    signals::insist(SIGHUP, GRACE);
}
