//! What reaches the designer: one enum on one channel.

use crossterm::event::KeyEvent;

use crate::worker::Answer;

/// Something that happened.
#[derive(Debug)]
pub enum Event {
    /// A key was pressed.
    Key(KeyEvent),
    /// Text was pasted in one piece.
    Paste(String),
    /// The terminal has another size, or its contents are lost: everything is drawn again.
    Resize,
    /// The worker has found something, or says why not.
    Answer(Answer),
    /// It is time for the next frame of what moves.
    Tick,
    /// A signal with this number asks the program to end.
    Quit(i32),
}
