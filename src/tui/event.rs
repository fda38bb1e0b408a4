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
    /// The worker has curves, or says why there are none.
    Answer(Answer),
    /// A signal with this number asks the program to end.
    Quit(i32),
}
