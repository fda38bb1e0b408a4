//! The error log, one line per error.

use std::fs::{self, OpenOptions};
use std::io::{self, Read as _, Write as _};
use std::path::Path;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use crate::escape::escape_lines;
use crate::files;

/// The size, bytes, from which on the older half is removed.
const LARGEST: u64 = 1_000_000;

/// Adds one entry, `2026-11-23T17:05:09Z beamtune 0.1.0: WHAT`, to the log file; creates file and folder if missing.
/// The time is UTC. Further lines of `what` are indented, so that an unindented line starts an entry; hidden characters
/// are escaped.
///
/// Errors are ignored: the log is written after another error, and must neither hide it nor stop the program.
pub fn append(path: &Path, what: &str) {
    let since = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .unwrap_or_default();
    let _ = write(path, &entry(since, what));
}

fn entry(since_1970: Duration, what: &str) -> String {
    let what = escape_lines(what.trim_end());
    let lines: Vec<&str> = what.lines().collect();
    format!(
        "{} beamtune {}: {}\n",
        utc(since_1970),
        env!("CARGO_PKG_VERSION"),
        lines.join("\n    ")
    )
}

fn write(path: &Path, entry: &str) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        files::make_private(folder)?;
    }
    if fs::metadata(path).is_ok_and(|found| found.len() + entry.len() as u64 > LARGEST) {
        drop_older_half(path)?;
    }
    let mut file = files::open_with(path, OpenOptions::new().create(true).append(true))?;
    // One write, so that the entries of two programs do not mix.
    file.write_all(entry.as_bytes())
}

/// Keeps the lines of the newer half.
fn drop_older_half(path: &Path) -> io::Result<()> {
    let mut bytes = Vec::new();
    files::open(path)?.read_to_end(&mut bytes)?;
    let newer = &bytes[bytes.len() / 2..];
    let start = newer.iter().position(|byte| *byte == b'\n');
    let kept = start.map_or(&[][..], |newline| &newer[newline + 1..]);
    files::save_with(path, |file| file.write_all(kept))
}

/// Date and time of day in UTC, `2026-11-23T17:05:09Z`, from the time since the start of 1970 without leap seconds.
///
/// Days to a date of the Gregorian calendar: `civil_from_days` of H. Hinnant, *chrono-Compatible Low-Level Date
/// Algorithms* (2013), in years that start in March, so that a leap day is the last one.
fn utc(since_1970: Duration) -> String {
    let seconds = since_1970.as_secs();
    // Days since 1 March of the year 0.
    let days = seconds / 86_400 + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = if month_from_march < 10 {
        month_from_march + 3
    } else {
        month_from_march - 9
    };
    let year = 400 * era + year_of_era + u64::from(month <= 2);
    let (hour, minute, second) = (seconds / 3_600 % 24, seconds / 60 % 60, seconds % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_those_of_the_calendar() {
        // `date -u -d @SECONDS +%FT%TZ` of GNU coreutils.
        for (seconds, expected) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (951_868_800, "2000-03-01T00:00:00Z"),
            (1_709_164_800, "2024-02-29T00:00:00Z"),
            (1_795_453_509, "2026-11-23T17:05:09Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
            (4_107_542_399, "2100-02-28T23:59:59Z"),
            (253_402_300_799, "9999-12-31T23:59:59Z"),
        ] {
            assert_eq!(utc(Duration::from_secs(seconds)), expected);
        }
    }

    #[test]
    fn entries_follow_each_other_in_a_folder_that_was_not_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a/b/beamtune.log");
        append(&path, "one");
        append(&path, "two\nlines\n");
        let text = fs::read_to_string(&path).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let version = env!("CARGO_PKG_VERSION");
        assert!(
            lines[0].ends_with(&format!("Z beamtune {version}: one")),
            "{text}"
        );
        assert!(
            lines[1].ends_with(&format!("Z beamtune {version}: two")),
            "{text}"
        );
        assert_eq!(lines[2..], ["    lines"]);
    }

    #[test]
    fn a_large_log_loses_its_older_half_at_a_line() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("beamtune.log");
        let lines: Vec<String> = (0..100_000).map(|n| format!("{n:09}\n")).collect();
        fs::write(&path, lines.concat()).unwrap();
        append(&path, "new");
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.starts_with("000050001\n"), "{}", &text[..40]);
        assert!(text.contains("\n000099999\n") && text.ends_with(": new\n"));
        assert!(text.len() < 600_000);
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_borne() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "kept").unwrap();
        append(&file.join("beamtune.log"), "lost");
        assert_eq!(fs::read_to_string(&file).unwrap(), "kept");
    }
}
