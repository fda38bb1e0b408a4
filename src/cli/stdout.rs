//! Standard output: a command whose output goes nowhere fails, except where its reader has seen enough.

use std::io::{self, BufWriter, Write};

use super::Failure;

/// Writes to standard output.
pub(super) fn write(content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    must_be_open()?;
    let mut out = BufWriter::new(io::stdout().lock());
    accept(content(&mut out).and_then(|()| out.flush()))
}

/// Prints a text of our own to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    write(|out| out.write_all(text.as_bytes()))
}

/// What a command that computes for long asks first.
pub(super) fn must_be_open() -> Result<(), Failure> {
    if startup::was_closed() {
        return Err(failure("it is closed"));
    }
    Ok(())
}

/// A reader that has gone away, as `head` does, is no failure.
pub(super) fn accept(written: io::Result<()>) -> Result<(), Failure> {
    match written {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(|error| failure(&error.to_string())),
    }
}

fn failure(reason: &str) -> Failure {
    Failure::Other(format!("standard output: cannot be written: {reason}"))
}

/// Whether standard output was open when the program was started.
///
/// The standard library opens /dev/null in the place of a closed one before `main`, after which nothing tells the two
/// apart. So this looks before, in a function that the loader calls.
mod startup {
    use std::sync::atomic::{AtomicBool, Ordering};

    static CLOSED: AtomicBool = AtomicBool::new(false);

    ctor::declarative::ctor! {
        // It uses nothing of what the standard library sets up later.
        #[ctor(unsafe)]
        fn look() {
            let closed = rustix::io::fcntl_getfd(rustix::stdio::stdout()).is_err();
            CLOSED.store(closed, Ordering::Relaxed);
        }
    }

    pub(super) fn was_closed() -> bool {
        CLOSED.load(Ordering::Relaxed)
    }
}
