//! The terminal: set up at the start, restored on every exit and suspension.

mod input;
mod job_control;
mod panic;
mod parser;
mod sequence;
mod signals;

use std::fs::File;
use std::io::{self, IsTerminal as _};
use std::os::fd::AsFd as _;
use std::sync::atomic::{AtomicBool, Ordering};

use crossterm::clipboard::CopyToClipboard;
use crossterm::event::{DisableBracketedPaste, EnableBracketedPaste};
use crossterm::style::Print;
use crossterm::terminal::{
    self, EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode,
    enable_raw_mode,
};
use crossterm::{cursor, execute};
use ratatui::layout::Size;
use ratatui::{Frame, Terminal};

use super::backend::CompactBackend;

pub use self::input::events;
pub use self::job_control::can_suspend;
pub use self::panic::set_panic_sink;
#[cfg(any(test, fuzzing))]
pub use self::parser::Parser;

/// Buttons and wheel, dragging, and decimal coordinates: xterm modes 1000, 1002 and 1006. Movements without a button
/// (1003) are not needed.
const ENABLE_MOUSE: &str = "\x1b[?1000h\x1b[?1002h\x1b[?1006h";
/// Disables these modes in reverse order.
const DISABLE_MOUSE: &str = "\x1b[?1006l\x1b[?1002l\x1b[?1000l";

/// Resets colours and clears the screen: without an alternate screen the shell's text would remain.
const CLEAR: &str = "\x1b[m\x1b[2J";
/// Moves the cursor below the content, for later output without an alternate screen. Leaving the alternate screen
/// discards this position.
const BELOW_CONTENT: &str = "\x1b[999;1H\n";

/// Whether the terminal is set up.
static ACTIVE: AtomicBool = AtomicBool::new(false);
/// Whether mouse reporting is on.
static MOUSE_ACTIVE: AtomicBool = AtomicBool::new(false);

/// The terminal in raw mode on its alternate screen. Dropping it restores the terminal.
#[derive(Debug)]
pub struct Session {
    terminal: Terminal<CompactBackend<File>>,
    /// Whether the user wants mouse reporting.
    mouse: bool,
    /// The terminal is set up again, but the signal thread has not reported the resume yet.
    resume_pending: bool,
    /// The program runs in the background: another job controls the terminal.
    in_background: bool,
}

impl Session {
    /// Sets up the terminal, with mouse reporting if `mouse`.
    ///
    /// # Errors
    /// The terminal cannot be set to raw mode or written to; it is then restored.
    pub fn start(mouse: bool) -> io::Result<Self> {
        panic::install_hook();
        // Line-buffered standard output would split a frame.
        let writer = File::from(io::stdout().as_fd().try_clone_to_owned()?);
        let started = set_up(mouse).and_then(|()| Terminal::new(CompactBackend::new(writer, size)));
        match started {
            Ok(terminal) => Ok(Self {
                terminal,
                mouse,
                resume_pending: false,
                in_background: false,
            }),
            Err(error) => {
                restore();
                Err(error)
            }
        }
    }

    /// Draws a frame as one synchronised update; does nothing in the background.
    ///
    /// # Errors
    /// The terminal cannot be written to.
    pub fn draw(&mut self, render: impl FnOnce(&mut Frame)) -> io::Result<()> {
        if !self.in_background {
            self.terminal.draw(render)?;
        }
        Ok(())
    }

    /// Makes the next draw repaint the whole screen, without querying the terminal.
    ///
    /// # Errors
    /// The terminal cannot be written to.
    pub fn repaint(&mut self) -> io::Result<()> {
        let size = self.terminal.size()?;
        self.terminal.resize(size.into())
    }

    /// Switches mouse reporting on or off.
    ///
    /// # Errors
    /// The terminal cannot be written to.
    pub fn set_mouse(&mut self, mouse: bool) -> io::Result<()> {
        self.mouse = mouse;
        if MOUSE_ACTIVE.swap(mouse, Ordering::SeqCst) == mouse {
            return Ok(());
        }
        let modes = if mouse { ENABLE_MOUSE } else { DISABLE_MOUSE };
        execute!(io::stdout(), Print(modes))
    }

    /// Sends a text to the clipboard of the terminal (OSC 52). The terminal does not report success.
    ///
    /// # Errors
    /// The terminal cannot be written to.
    pub fn copy(text: &str) -> io::Result<()> {
        execute!(io::stdout(), CopyToClipboard::to_clipboard_from(text))
    }

    /// Restores the terminal, stops until the shell continues the program, then sets it up again. Requires a shell with
    /// job control, see [`can_suspend`].
    ///
    /// # Errors
    /// The terminal cannot be set up again.
    pub fn suspend(&mut self) -> io::Result<()> {
        restore();
        job_control::stop()?;
        self.resume_pending = true;
        self.set_up_again()
    }

    /// Sets up the terminal again after another process stopped and continued the program.
    ///
    /// # Errors
    /// The terminal cannot be set up again.
    pub fn resume(&mut self) -> io::Result<()> {
        if std::mem::take(&mut self.resume_pending) && !self.in_background {
            return Ok(());
        }
        // The shell has changed the modes: restore first, so that the original modes remain for the exit.
        restore();
        self.set_up_again()
    }

    fn set_up_again(&mut self) -> io::Result<()> {
        // The system stops a background job that changes the modes.
        self.in_background = !job_control::is_in_foreground();
        if self.in_background {
            return Ok(());
        }
        set_up(self.mouse)?;
        self.terminal.backend_mut().forget();
        self.repaint()
    }
}

/// Whether the terminal is lost: a dropped connection, a closed window.
pub fn is_gone() -> bool {
    !io::stdout().is_terminal()
}

fn size() -> io::Result<Size> {
    let (width, height) = terminal::size()?;
    Ok(Size { width, height })
}

impl Drop for Session {
    fn drop(&mut self) {
        restore();
    }
}

/// Sets raw mode, the alternate screen and a hidden cursor.
fn set_up(mouse: bool) -> io::Result<()> {
    enable_raw_mode()?;
    ACTIVE.store(true, Ordering::SeqCst);
    let mut out = io::stdout();
    execute!(
        out,
        EnterAlternateScreen,
        Print(CLEAR),
        EnableBracketedPaste,
        cursor::Hide
    )?;
    MOUSE_ACTIVE.store(mouse, Ordering::SeqCst);
    if mouse {
        execute!(out, Print(ENABLE_MOUSE))?;
    }
    Ok(())
}

/// Reverts [`set_up`] once, in reverse order. Errors are ignored: there is no further recovery.
fn restore() {
    if ACTIVE.swap(false, Ordering::SeqCst) {
        let mouse = MOUSE_ACTIVE.swap(false, Ordering::SeqCst);
        let _ = execute!(
            io::stdout(),
            EndSynchronizedUpdate,
            Print(if mouse { DISABLE_MOUSE } else { "" }),
            cursor::Show,
            DisableBracketedPaste,
            Print(BELOW_CONTENT),
            LeaveAlternateScreen
        );
        let _ = disable_raw_mode();
    }
}
