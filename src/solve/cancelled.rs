//! The end of work that its flag cancels.

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

/// The flag of the work became true before its end: there is no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cancelled;

impl Cancelled {
    /// Lets the work go on.
    ///
    /// # Errors
    /// The flag is true.
    pub fn check(cancel: &AtomicBool) -> Result<(), Self> {
        if cancel.load(Ordering::Relaxed) {
            return Err(Self);
        }
        Ok(())
    }
}

impl fmt::Display for Cancelled {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("cancelled")
    }
}

impl std::error::Error for Cancelled {}
