//! The error of cancelled work.

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

/// The cancel flag became true before the end of the work: there is no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cancelled;

impl Cancelled {
    /// Returns `Ok` while the work may continue.
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
