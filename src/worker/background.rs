//! A pool of threads that give way: what is solved there comes after what is drawn.

use rayon::{ThreadPool, ThreadPoolBuilder};

/// As many threads as there are cores, of lower priority than the others; none where the system gives none.
pub(super) fn pool() -> Option<ThreadPool> {
    ThreadPoolBuilder::new()
        .start_handler(|_| give_way())
        .build()
        .ok()
}

/// Lowers the priority of this thread.
#[cfg(target_os = "linux")]
pub(crate) fn give_way() {
    /// All that there is: a thread that draws shall not wait for the end of a slice of time.
    const STEPS: i32 = 19;
    // Where that is not allowed everything is still right, only later.
    let _ = rustix::process::nice(STEPS);
}

/// Elsewhere a priority is that of the whole program.
#[cfg(not(target_os = "linux"))]
pub(crate) const fn give_way() {}
