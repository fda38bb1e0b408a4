//! A ratatui backend that writes few bytes, for slow connections.
//!
//! A frame is buffered and written at once, as a synchronised update; an unchanged frame writes nothing. Unlike
//! crossterm's backend it moves the cursor by the shortest sequence, lets blanks keep the previous text colour, and writes
//! the sixteen colours by their short codes. It never queries the terminal; the size comes from the system.

mod cursor;
mod sgr;

use std::io::{self, Write};

use ratatui::backend::{Backend, ClearType, WindowSize};
use ratatui::buffer::Cell;
use ratatui::layout::{Position, Size};

use self::cursor::move_cursor;
use self::sgr::CellStyle;

const BEGIN_UPDATE: &[u8] = b"\x1b[?2026h";
const END_UPDATE: &[u8] = b"\x1b[?2026l";

/// An ECMA-48 terminal behind a writer.
#[derive(Debug)]
pub struct CompactBackend<W: Write> {
    writer: W,
    /// The bytes of the next flush.
    frame: Vec<u8>,
    /// Whether the cursor is visible; none if unknown.
    cursor: Option<bool>,
    size: fn() -> io::Result<Size>,
}

impl<W: Write> CompactBackend<W> {
    /// A terminal behind `writer`; `size` returns its size.
    pub fn new(writer: W, size: fn() -> io::Result<Size>) -> Self {
        Self {
            writer,
            frame: Vec::new(),
            cursor: None,
            size,
        }
    }

    /// The writer.
    #[cfg(test)]
    pub fn writer_mut(&mut self) -> &mut W {
        &mut self.writer
    }

    /// Discards the known terminal state, after another program used the terminal.
    pub fn forget(&mut self) {
        self.frame.clear();
        self.cursor = None;
    }

    fn set_cursor_shown(&mut self, shown: bool) {
        if self.cursor.replace(shown) != Some(shown) {
            let mode: &[u8] = if shown { b"\x1b[?25h" } else { b"\x1b[?25l" };
            self.frame.extend_from_slice(mode);
        }
    }
}

impl<W: Write> Backend for CompactBackend<W> {
    type Error = io::Error;

    fn draw<'a, I>(&mut self, content: I) -> io::Result<()>
    where
        I: Iterator<Item = (u16, u16, &'a Cell)>,
    {
        let columns = (self.size)()?.width;
        // The style is reset at the end of a frame and the cursor position is not kept, so that other output to the
        // terminal starts from a defined state.
        let (mut style, mut at) = (CellStyle::DEFAULT, None);
        for (x, y, cell) in content {
            move_cursor(at, (x, y), &mut self.frame);
            if !style.shows(cell) {
                style.change_to(CellStyle::of(cell), &mut self.frame);
            }
            self.frame.extend_from_slice(cell.symbol().as_bytes());
            at = cursor_after((x, y), cell, columns);
        }
        style.change_to(CellStyle::DEFAULT, &mut self.frame);
        Ok(())
    }

    fn hide_cursor(&mut self) -> io::Result<()> {
        self.set_cursor_shown(false);
        Ok(())
    }

    fn show_cursor(&mut self) -> io::Result<()> {
        self.set_cursor_shown(true);
        Ok(())
    }

    /// Not supported: the answer would arrive among the keys.
    fn get_cursor_position(&mut self) -> io::Result<Position> {
        Err(io::ErrorKind::Unsupported.into())
    }

    fn set_cursor_position<P: Into<Position>>(&mut self, position: P) -> io::Result<()> {
        let Position { x, y } = position.into();
        move_cursor(None, (x, y), &mut self.frame);
        Ok(())
    }

    fn clear(&mut self) -> io::Result<()> {
        self.clear_region(ClearType::All)
    }

    fn clear_region(&mut self, region: ClearType) -> io::Result<()> {
        let code: &[u8] = match region {
            ClearType::All => b"\x1b[2J",
            ClearType::AfterCursor => b"\x1b[J",
            ClearType::BeforeCursor => b"\x1b[1J",
            ClearType::CurrentLine => b"\x1b[2K",
            ClearType::UntilNewLine => b"\x1b[K",
        };
        self.frame.extend_from_slice(code);
        Ok(())
    }

    fn size(&self) -> io::Result<Size> {
        (self.size)()
    }

    fn window_size(&mut self) -> io::Result<WindowSize> {
        Ok(WindowSize {
            columns_rows: (self.size)()?,
            pixels: Size::ZERO,
        })
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.frame.is_empty() {
            return Ok(());
        }
        let mut bytes = Vec::with_capacity(self.frame.len() + 2 * BEGIN_UPDATE.len());
        bytes.extend_from_slice(BEGIN_UPDATE);
        bytes.append(&mut self.frame);
        bytes.extend_from_slice(END_UPDATE);
        self.writer.write_all(&bytes)?;
        self.writer.flush()
    }
}

/// The cursor position after a cell: the next column; unknown where terminals differ, at the end of a row and after a
/// symbol that may be wider than one column.
fn cursor_after((x, y): (u16, u16), cell: &Cell, columns: u16) -> Option<(u16, u16)> {
    let mut letters = cell.symbol().chars();
    let single = letters.next().filter(|_| letters.next().is_none());
    let narrow = single.is_some_and(|letter| letter.is_ascii() || is_drawn(letter));
    (narrow && x + 1 < columns).then_some((x + 1, y))
}

/// Whether a letter is a chart character that is one column wide in every terminal: box drawing, blocks, braille.
fn is_drawn(letter: char) -> bool {
    matches!(letter, '\u{2500}'..='\u{259f}' | '\u{2800}'..='\u{28ff}')
}

#[cfg(test)]
mod tests;
