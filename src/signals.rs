//! Signals that the parent process set to be ignored, as `nohup` does: they stay ignored.

use std::fs;

/// Filters out the ignored signals.
pub(crate) fn not_ignored(signals: impl IntoIterator<Item = i32>) -> Vec<i32> {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    // If the system does not report it, none is ignored.
    let ignored = ignored(&status).unwrap_or(0);
    let is_handled = |signal: &i32| (ignored >> (signal - 1)) & 1 == 0;
    signals.into_iter().filter(is_handled).collect()
}

/// The mask of ignored signals; the lowest bit is signal 1 (Linux, proc(5), /proc/PID/status).
fn ignored(status: &str) -> Option<u64> {
    let mask = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))?;
    u64::from_str_radix(mask.trim(), 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `nohup cat /proc/self/status` says `SigIgn: 0000000000000001`; SIGHUP is signal 1, SIGPIPE 13.
    #[test]
    fn ignored_signals_are_bits_of_the_status() {
        let status = "Name:\tcat\nSigBlk:\t0000000000000000\nSigIgn:\t0000000000001001\n";
        assert_eq!(ignored(status), Some(0x1001));
        assert_eq!(ignored("Name:\tcat\n"), None);
    }
}
