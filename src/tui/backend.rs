//! The bytes that go to the terminal, as few as they can be: ratatui's backend for a slow line.
//!
//! A frame is gathered and goes out in one write, between the marks of a synchronised update; a frame in which nothing
//! changed writes nothing. Against crossterm's backend it goes from cell to cell by the shortest way, lets blanks be of
//! whatever colour comes before them, and writes the sixteen colours by their own codes. Nothing is asked of the
//! terminal; its size is the system's to tell.

mod sgr;
mod travel;

use std::io::{self, Write};

use ratatui::backend::{Backend, ClearType, WindowSize};
use ratatui::buffer::Cell;
use ratatui::layout::{Position, Size};

use self::sgr::Look;
use self::travel::travel;

const BEGIN_UPDATE: &[u8] = b"\x1b[?2026h";
const END_UPDATE: &[u8] = b"\x1b[?2026l";

/// A terminal of the ECMA-48 kind behind a writer.
#[derive(Debug)]
pub struct Wire<W: Write> {
    writer: W,
    /// What the next flush writes.
    frame: Vec<u8>,
    /// Whether the terminal's cursor shows, where that is known.
    cursor: Option<bool>,
    size: fn() -> io::Result<Size>,
}

impl<W: Write> Wire<W> {
    /// A terminal behind `writer`, of the size that `size` tells.
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

    /// Forgets what is known of the terminal, which has been somebody else's.
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

impl<W: Write> Backend for Wire<W> {
    type Error = io::Error;

    fn draw<'a, I>(&mut self, content: I) -> io::Result<()>
    where
        I: Iterator<Item = (u16, u16, &'a Cell)>,
    {
        let columns = (self.size)()?.width;
        // Styles are put back at the end of a frame, and the place of the cursor is forgotten: whatever else is written
        // to the terminal finds it in order.
        let (mut look, mut at) = (Look::PLAIN, None);
        for (x, y, cell) in content {
            travel(at, (x, y), &mut self.frame);
            if !look.suits(cell) {
                look.turn(Look::of(cell), &mut self.frame);
            }
            self.frame.extend_from_slice(cell.symbol().as_bytes());
            at = behind((x, y), cell, columns);
        }
        look.turn(Look::PLAIN, &mut self.frame);
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

    /// Never asked for: the answer would have to be fished out of the keys.
    fn get_cursor_position(&mut self) -> io::Result<Position> {
        Err(io::ErrorKind::Unsupported.into())
    }

    fn set_cursor_position<P: Into<Position>>(&mut self, position: P) -> io::Result<()> {
        let Position { x, y } = position.into();
        travel(None, (x, y), &mut self.frame);
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

/// Where the cursor is once a cell has been written: in the next column, or not known where terminals do not agree, at
/// the end of a row and behind what may be wider than one column.
fn behind((x, y): (u16, u16), cell: &Cell, columns: u16) -> Option<(u16, u16)> {
    let mut letters = cell.symbol().chars();
    let alone = letters.next().filter(|_| letters.next().is_none());
    let narrow = alone.is_some_and(|letter| letter.is_ascii() || is_drawn(letter));
    (narrow && x + 1 < columns).then_some((x + 1, y))
}

/// Whether a letter is one of those that charts are drawn with, one column wide everywhere: box drawing, blocks and
/// braille.
fn is_drawn(letter: char) -> bool {
    matches!(letter, '\u{2500}'..='\u{259f}' | '\u{2800}'..='\u{28ff}')
}

#[cfg(test)]
mod tests;
