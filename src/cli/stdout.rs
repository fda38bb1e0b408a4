//! Standard output: a command fails if it cannot write, except if the reader has closed the pipe.

use std::io::{self, BufWriter, Write};

use super::failure::Failure;

/// Writes to standard output.
pub(super) fn write(content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    must_be_open()?;
    let mut out = BufWriter::new(io::stdout().lock());
    accept(content(&mut out).and_then(|()| out.flush()))
}

/// Prints trusted text to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    write(|out| out.write_all(text.as_bytes()))
}

/// Fails early, before a long computation, if standard output is closed.
pub(super) fn must_be_open() -> Result<(), Failure> {
    if startup::was_closed() {
        return Err(failure("it is closed"));
    }
    Ok(())
}

/// A closed pipe, as by `head`, is not a failure.
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
/// The standard library replaces a closed one with /dev/null before `main`, after which the two cannot be
/// distinguished. Therefore a function that the loader calls checks this earlier.
mod startup {
    use std::sync::atomic::{AtomicBool, Ordering};

    static CLOSED: AtomicBool = AtomicBool::new(false);

    ctor::declarative::ctor! {
        // It uses nothing that the standard library initialises later.
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
