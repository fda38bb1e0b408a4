//! The terminal: taken at the start, given back as it was found on every way out.

use std::io::{self, BufWriter, IsTerminal, Stdout, Write};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::thread::{self, ThreadId};
use std::time::Duration;

use crossterm::event::{DisableBracketedPaste, EnableBracketedPaste, KeyEventKind};
use crossterm::terminal::{
    BeginSynchronizedUpdate, EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen,
    disable_raw_mode, enable_raw_mode,
};
use crossterm::{cursor, event, execute, queue};
use ratatui::backend::CrosstermBackend;
use ratatui::{Frame, Terminal};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::iterator::Signals;

use super::event::Event;

/// Room for a whole frame, so that it goes out in one write.
const FRAME_BYTES: usize = 65_536;

/// How often it is looked whether the terminal is still there, where the hang-up signal is ignored.
const LOOK_EVERY: Duration = Duration::from_millis(500);

/// How long the program has to end by itself once its terminal is gone.
const GRACE: Duration = Duration::from_millis(400);

/// True while the terminal is ours.
static TAKEN: AtomicBool = AtomicBool::new(false);

/// The thread whose panic ends the program.
static OWNER: OnceLock<ThreadId> = OnceLock::new();

/// The terminal in raw mode on its alternate screen. Dropping it gives the terminal back.
pub struct Session {
    terminal: Terminal<CrosstermBackend<BufWriter<Stdout>>>,
}

impl Session {
    /// Takes the terminal.
    ///
    /// # Errors
    /// Where it cannot be put into raw mode or written to; it is then given back.
    pub fn start() -> io::Result<Self> {
        install_panic_hook();
        enable_raw_mode()?;
        TAKEN.store(true, Ordering::SeqCst);
        let started = execute!(
            io::stdout(),
            EnterAlternateScreen,
            EnableBracketedPaste,
            cursor::Hide
        )
        .and_then(|()| {
            Terminal::new(CrosstermBackend::new(BufWriter::with_capacity(
                FRAME_BYTES,
                io::stdout(),
            )))
        });
        match started {
            Ok(terminal) => Ok(Self { terminal }),
            Err(error) => {
                give_back();
                Err(error)
            }
        }
    }

    /// Draws a frame in one synchronised update.
    ///
    /// # Errors
    /// Where the terminal cannot be written to.
    pub fn draw(&mut self, render: impl FnOnce(&mut Frame)) -> io::Result<()> {
        queue!(self.terminal.backend_mut(), BeginSynchronizedUpdate)?;
        self.terminal.draw(render)?;
        queue!(self.terminal.backend_mut(), EndSynchronizedUpdate)?;
        self.terminal.backend_mut().flush()
    }

    /// Paints everything anew at the next draw, without asking the terminal for anything.
    ///
    /// # Errors
    /// Where the terminal cannot be written to.
    pub fn repaint(&mut self) -> io::Result<()> {
        let size = self.terminal.size()?;
        self.terminal.resize(size.into())
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        give_back();
    }
}

/// Undoes what [`Session::start`] did, once, in reverse order. Failures leave nothing more to try.
fn give_back() {
    if TAKEN.swap(false, Ordering::SeqCst) {
        let _ = execute!(
            io::stdout(),
            EndSynchronizedUpdate,
            cursor::Show,
            DisableBracketedPaste,
            LeaveAlternateScreen
        );
        let _ = disable_raw_mode();
    }
}

/// A panic of the thread that draws gives the terminal back before it is reported. One of another thread comes as
/// an answer's error and must not write over the screen.
fn install_panic_hook() {
    if OWNER.set(thread::current().id()).is_err() {
        return;
    }
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if OWNER.get() == Some(&thread::current().id()) {
            give_back();
        }
        if !TAKEN.load(Ordering::SeqCst) {
            report(panic);
        }
    }));
}

/// Starts the threads that send keys, signals and the loss of the terminal.
///
/// # Errors
/// Where signals cannot be caught.
pub fn events(sender: &Sender<Event>) -> io::Result<()> {
    let signals = Signals::new([SIGTERM, SIGINT, SIGHUP])?;
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
        if to.send(Event::Quit(signal)).is_err() {
            return;
        }
    }
}

fn forward_input(to: &Sender<Event>) {
    loop {
        let event = match event::read() {
            Ok(event::Event::Key(key)) if key.kind == KeyEventKind::Press => Event::Key(key),
            Ok(event::Event::Paste(text)) => Event::Paste(text),
            Ok(event::Event::Resize(..)) => Event::Resize,
            Ok(_) => continue,
            Err(_) => Event::Quit(SIGHUP),
        };
        let last = matches!(event, Event::Quit(_));
        if to.send(event).is_err() || last {
            return;
        }
    }
}

/// Ends the program once its terminal is gone, also where the hang-up signal is ignored and reading would spin.
fn watch_terminal(to: &Sender<Event>) {
    while io::stdout().is_terminal() {
        thread::sleep(LOOK_EVERY);
    }
    let _ = to.send(Event::Quit(SIGHUP));
    thread::sleep(GRACE);
    // Still here: the drawing thread hangs on a terminal that is no more.
    std::process::exit(128 + SIGHUP);
}
