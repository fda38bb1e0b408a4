//! The terminal: taken at the start, given back as it was found on every way out and on every pause.

mod input;
mod jobs;
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

use super::backend::Wire;

pub use self::input::events;
pub use self::jobs::can_suspend;
pub use self::panic::set_panic_sink;
#[cfg(any(test, fuzzing))]
pub use self::parser::Parser;

/// Presses and the wheel, dragging, and places in decimals: modes 1000, 1002 and 1006 of xterm. Moves without a button
/// (1003) would be sent for nothing.
const TAKE_MOUSE: &str = "\x1b[?1000h\x1b[?1002h\x1b[?1006h";
/// The same in reverse.
const LEAVE_MOUSE: &str = "\x1b[?1006l\x1b[?1002l\x1b[?1000l";

/// Clears the screen, in no colours: where there is no alternate screen, the shell's old text is still there.
const CLEAR: &str = "\x1b[m\x1b[2J";
/// Below the picture, for what comes after it on such a screen. The alternate screen forgets the cursor's place.
const BELOW: &str = "\x1b[999;1H\n";

/// True while the terminal is ours.
static TAKEN: AtomicBool = AtomicBool::new(false);
/// True while its mouse is, too.
static MOUSE: AtomicBool = AtomicBool::new(false);

/// The terminal in raw mode on its alternate screen. Dropping it gives the terminal back.
#[derive(Debug)]
pub struct Session {
    terminal: Terminal<Wire<File>>,
    /// The mouse is wanted.
    mouse: bool,
    /// The terminal was taken again after a pause of which the signal thread is still to tell.
    resumed: bool,
    /// The program goes on behind another one, to which the terminal listens.
    behind: bool,
}

impl Session {
    /// Takes the terminal, and its mouse where that is wanted.
    ///
    /// # Errors
    /// Where it cannot be put into raw mode or written to; it is then given back.
    pub fn start(mouse: bool) -> io::Result<Self> {
        panic::install_hook();
        // Standard output itself would split a frame into lines.
        let writer = File::from(io::stdout().as_fd().try_clone_to_owned()?);
        let started = take(mouse).and_then(|()| Terminal::new(Wire::new(writer, size)));
        match started {
            Ok(terminal) => Ok(Self {
                terminal,
                mouse,
                resumed: false,
                behind: false,
            }),
            Err(error) => {
                give_back();
                Err(error)
            }
        }
    }

    /// Draws a frame in one synchronised update; nothing while another program has the terminal.
    ///
    /// # Errors
    /// Where the terminal cannot be written to.
    pub fn draw(&mut self, render: impl FnOnce(&mut Frame)) -> io::Result<()> {
        if !self.behind {
            self.terminal.draw(render)?;
        }
        Ok(())
    }

    /// Paints everything anew at the next draw, without asking the terminal for anything.
    ///
    /// # Errors
    /// Where the terminal cannot be written to.
    pub fn repaint(&mut self) -> io::Result<()> {
        let size = self.terminal.size()?;
        self.terminal.resize(size.into())
    }

    /// Takes the mouse, or leaves it to the terminal.
    ///
    /// # Errors
    /// Where the terminal cannot be written to.
    pub fn set_mouse(&mut self, mouse: bool) -> io::Result<()> {
        self.mouse = mouse;
        if MOUSE.swap(mouse, Ordering::SeqCst) == mouse {
            return Ok(());
        }
        let modes = if mouse { TAKE_MOUSE } else { LEAVE_MOUSE };
        execute!(io::stdout(), Print(modes))
    }

    /// Sends a text to the clipboard of the terminal (OSC 52). Whether it takes it there is no way to know.
    ///
    /// # Errors
    /// Where the terminal cannot be written to.
    pub fn copy(&mut self, text: &str) -> io::Result<()> {
        execute!(io::stdout(), CopyToClipboard::to_clipboard_from(text))
    }

    /// Gives the terminal back and stops until the shell goes on with the program; takes it again then. There must be
    /// a shell that can, see [`can_suspend`].
    ///
    /// # Errors
    /// Where the terminal cannot be taken again.
    pub fn suspend(&mut self) -> io::Result<()> {
        give_back();
        jobs::stop()?;
        self.resumed = true;
        self.take_again()
    }

    /// Takes the terminal again after the program was stopped from outside and goes on.
    ///
    /// # Errors
    /// Where the terminal cannot be taken again.
    pub fn resume(&mut self) -> io::Result<()> {
        if std::mem::take(&mut self.resumed) && !self.behind {
            return Ok(());
        }
        // The shell has changed the modes since; those from before are put back, so that they are kept for the end.
        give_back();
        self.take_again()
    }

    fn take_again(&mut self) -> io::Result<()> {
        // Whoever changes the modes from behind is stopped.
        self.behind = !jobs::is_in_front();
        if self.behind {
            return Ok(());
        }
        take(self.mouse)?;
        self.terminal.backend_mut().forget();
        self.repaint()
    }
}

/// Whether the terminal has gone: a line that dropped, a window that was closed.
pub fn is_gone() -> bool {
    !io::stdout().is_terminal()
}

fn size() -> io::Result<Size> {
    let (width, height) = terminal::size()?;
    Ok(Size { width, height })
}

impl Drop for Session {
    fn drop(&mut self) {
        give_back();
    }
}

/// Puts the terminal into raw mode, onto its alternate screen, without a cursor.
fn take(mouse: bool) -> io::Result<()> {
    enable_raw_mode()?;
    TAKEN.store(true, Ordering::SeqCst);
    let mut out = io::stdout();
    execute!(
        out,
        EnterAlternateScreen,
        Print(CLEAR),
        EnableBracketedPaste,
        cursor::Hide
    )?;
    MOUSE.store(mouse, Ordering::SeqCst);
    if mouse {
        execute!(out, Print(TAKE_MOUSE))?;
    }
    Ok(())
}

/// Undoes what [`take`] did, once, in reverse order. Failures leave nothing more to try.
fn give_back() {
    if TAKEN.swap(false, Ordering::SeqCst) {
        let mouse = MOUSE.swap(false, Ordering::SeqCst);
        let _ = execute!(
            io::stdout(),
            EndSynchronizedUpdate,
            Print(if mouse { LEAVE_MOUSE } else { "" }),
            cursor::Show,
            DisableBracketedPaste,
            Print(BELOW),
            LeaveAlternateScreen
        );
        let _ = disable_raw_mode();
    }
}
