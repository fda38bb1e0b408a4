//! A pool of threads of low priority, so that solving does not delay drawing.

use rayon::{ThreadPool, ThreadPoolBuilder};

/// As many threads as cores, of lower priority than the others; none if the system cannot start them.
pub(super) fn pool() -> Option<ThreadPool> {
    ThreadPoolBuilder::new()
        .start_handler(|_| lower_priority())
        .build()
        .ok()
}

/// Lowers the priority of this thread.
#[cfg(target_os = "linux")]
pub(crate) fn lower_priority() {
    /// The maximum, so that a thread that draws never waits for a time slice to end.
    const STEPS: i32 = 19;
    // If that is not permitted, results are the same, only later.
    let _ = rustix::process::nice(STEPS);
}

/// On other systems the priority applies to the whole program.
#[cfg(not(target_os = "linux"))]
pub(crate) const fn lower_priority() {}
