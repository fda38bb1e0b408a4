//! The events of the designer: one enum on one channel.

use crossterm::event::{KeyEvent, MouseEvent};

use crate::worker::Answer;

/// An event.
#[derive(Debug)]
pub enum Event {
    /// A key was pressed.
    Key(KeyEvent),
    /// Text was pasted in one piece.
    Paste(String),
    /// A button of the mouse was pressed or its wheel turned.
    Mouse(MouseEvent),
    /// The terminal has another size, or lost its contents: redraw everything.
    Resize,
    /// An answer of the worker, or its failure.
    Answer(Answer),
    /// The next frame of an animation is due.
    Tick,
    /// The file of the model may have changed on disk.
    Touched,
    /// A background task failed, and why.
    Trouble(String),
    /// A signal requests a suspension.
    Suspend,
    /// The program continues after a suspension.
    Resume,
    /// A signal with this number requests the end.
    Quit(i32),
}
