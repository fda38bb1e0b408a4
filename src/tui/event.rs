//! What reaches the designer: one enum on one channel.

use crossterm::event::{KeyEvent, MouseEvent};

use crate::worker::Answer;

/// Something that happened.
#[derive(Debug)]
pub enum Event {
    /// A key was pressed.
    Key(KeyEvent),
    /// Text was pasted in one piece.
    Paste(String),
    /// A button of the mouse was pressed or its wheel turned.
    Mouse(MouseEvent),
    /// The terminal has another size, or its contents are lost: everything is drawn again.
    Resize,
    /// The worker has found something, or says why not.
    Answer(Answer),
    /// It is time for the next frame of what moves.
    Tick,
    /// The file of the model may have changed on disk.
    Touched,
    /// Something that goes on beside does not work, and why.
    Trouble(String),
    /// A signal asks the program to stop for a while.
    Suspend,
    /// The program goes on after it was stopped.
    Resume,
    /// A signal with this number asks the program to end.
    Quit(i32),
}
