//! The progress of a search, on a line of standard error if that is a terminal.

use std::fmt::Write as _;
use std::io::{IsTerminal, Write as _};
use std::time::{Duration, Instant};

use crate::model::grouped;
use crate::tune::Status;

/// The shortest time between two updates of the line.
const EVERY: Duration = Duration::from_millis(100);

/// The progress line.
pub(super) struct Progress {
    watched: bool,
    start: Instant,
    drawn: Option<Instant>,
}

impl Progress {
    /// Starts the clock.
    pub(super) fn start() -> Self {
        Self {
            watched: std::io::stderr().is_terminal(),
            start: Instant::now(),
            drawn: None,
        }
    }

    /// Draws the line, if it is due.
    pub(super) fn show(&mut self, status: &Status) {
        let now = Instant::now();
        if !self.watched || self.drawn.is_some_and(|drawn| now - drawn < EVERY) {
            return;
        }
        self.drawn = Some(now);
        draw(&line(status, now - self.start));
    }

    /// Clears the line.
    pub(super) fn clear(&self) {
        if self.watched {
            draw("");
        }
    }
}

/// Truncated to the width of the terminal, because a longer line cannot be cleared.
fn draw(line: &str) {
    let columns = crossterm::terminal::size().map_or(80, |(columns, _)| usize::from(columns));
    let line: String = line.chars().take(columns.saturating_sub(1)).collect();
    let mut out = std::io::stderr().lock();
    // Ignore errors of the progress display.
    let _ = write!(out, "\r\x1b[K{line}").and_then(|()| out.flush());
}

fn line(status: &Status, elapsed: Duration) -> String {
    let (done, of) = (status.evaluations, status.budget);
    let mut line = format!(
        "{}: {} of {} models",
        status.phase,
        grouped(done),
        grouped(of)
    );
    let share = 100.0 * status.best / status.start;
    if !status.is_possible {
        line.push_str(", limits not met yet");
    } else if share.is_finite() {
        let _ = write!(line, ", best {share:.4} % of the start");
    }
    if done > 0 {
        let left = elapsed.as_secs_f64() * of.saturating_sub(done) as f64 / done as f64;
        let _ = write!(line, ", at most {} left", time(left));
    }
    line
}

/// A time in words, s.
fn time(seconds: f64) -> String {
    if seconds < 99.5 {
        format!("{seconds:.0} s")
    } else if seconds < 99.5 * 60.0 {
        format!("{:.0} min", seconds / 60.0)
    } else {
        format!("{:.1} h", seconds / 3600.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::checked;
    use crate::tune::Phase;

    #[test]
    fn the_line_says_how_far_it_is() {
        let text = crate::presets::find("fig06").unwrap().text;
        let mut status = Status {
            evaluations: 500,
            budget: 2500,
            phase: Phase::Global,
            start: 5e-3,
            best: 1e-3,
            is_possible: true,
            model: checked(&crate::model::read(text).unwrap().into_inner()),
        };
        let elapsed = Duration::from_secs(10);
        assert_eq!(
            line(&status, elapsed),
            "global search: 500 of 2,500 models, best 20.0000 % of the start, at most 40 s left"
        );
        (status.start, status.evaluations) = (f64::INFINITY, 0);
        status.is_possible = false;
        assert_eq!(
            line(&status, elapsed),
            "global search: 0 of 2,500 models, limits not met yet"
        );
        assert_eq!(time(600.0), "10 min");
        assert_eq!(time(9000.0), "2.5 h");
    }
}
