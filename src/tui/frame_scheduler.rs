//! When the screen is drawn: at once where something shows, but not for pictures that the next one replaces, and the
//! slower the slower the line is.
//!
//! There is no clock in here: the time is told. The loop waits until [`FrameScheduler::due`] for more events, draws, and
//! tells by [`FrameScheduler::drew`] how long that took.

use std::time::{Duration, Instant};

use super::event::Event;
use crate::worker::{Answer, Curves, Stage};

/// How long a drawing waits for a better picture that is in work. After a key these are the curves it asked for, old
/// ones, dimmed, being drawn for nothing; after the first curves at the frequencies of the sweep the ones with all peaks,
/// the sharp ones of which would vanish and come back. What takes 0.1 s still seems to come at once (J. Nielsen, Usability
/// Engineering, 1993, section 5.5).
const HOLD: Duration = Duration::from_millis(100);

/// From the end of a drawing to the next one at least: no eye sees more.
const SHORTEST: Duration = Duration::from_nanos(1_000_000_000 / 30);

/// The longest wait between drawings on a slow line.
const LONGEST: Duration = Duration::from_secs(1);

/// A drawing that was held up by a slow line is followed by a rest so many times as long.
const REST: u32 = 2;

/// Why there is something to be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// Something shows now that did not.
    Shows,
    /// So does this, and something better is in work and may be there in a moment.
    Awaits,
}

/// Whether curves have points between those of the sweep, where the peaks were before the last edit.
fn has_peaks(curves: &Curves) -> bool {
    let mut members = curves.members.iter();
    members.any(|member| member.frf.frequencies.len() > member.model.sweep.points)
}

impl Reason {
    /// Why an event is followed by a drawing, as long as it asked for nothing.
    pub fn of(event: &Event) -> Self {
        match event {
            Event::Answer(Answer::Curves(answer)) => {
                // A coarse curve comes where the full one takes long.
                let awaits = answer.stage == Stage::Full
                    && answer
                        .result
                        .as_ref()
                        .is_ok_and(|curves| !has_peaks(curves));
                if awaits { Self::Awaits } else { Self::Shows }
            }
            _ => Self::Shows,
        }
    }

    /// The reason where the event had the model solved.
    #[must_use]
    pub fn asking(self, solves: bool) -> Self {
        if solves { Self::Awaits } else { self }
    }

    /// How long it can wait.
    const fn patience(self) -> Duration {
        match self {
            Self::Shows => Duration::ZERO,
            Self::Awaits => HOLD,
        }
    }
}

/// The pace of drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FrameScheduler {
    /// When what is to be drawn must be drawn.
    wanted: Option<Instant>,
    /// Before this nothing is drawn.
    rest: Option<Instant>,
}

impl FrameScheduler {
    /// Nothing is to be drawn yet.
    pub const fn new() -> Self {
        Self {
            wanted: None,
            rest: None,
        }
    }

    /// Something is to be drawn since `now`; what has waited before does not wait any longer for it.
    pub fn wants(&mut self, reason: Reason, now: Instant) {
        let latest = now + reason.patience();
        self.wanted = Some(self.wanted.map_or(latest, |wanted| wanted.min(latest)));
    }

    /// When to draw; a time that has passed means at once, none that nothing is to be drawn.
    pub fn due(&self) -> Option<Instant> {
        let wanted = self.wanted?;
        Some(self.rest.map_or(wanted, |rest| wanted.max(rest)))
    }

    /// Everything was drawn, from `began` to `ended`; a drawing takes long where the line takes no more.
    pub fn drew(&mut self, began: Instant, ended: Instant) {
        let took = ended.saturating_duration_since(began);
        self.wanted = None;
        self.rest = Some(ended + (REST * took).clamp(SHORTEST, LONGEST));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worker::CurvesAnswer;

    const MS: fn(u64) -> Duration = Duration::from_millis;

    #[test]
    fn what_shows_is_drawn_at_once() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new();
        assert_eq!(pace.due(), None);
        pace.wants(Reason::Shows, start);
        assert_eq!(pace.due(), Some(start));
        pace.drew(start, start);
        assert_eq!(pace.due(), None);
    }

    #[test]
    fn curves_that_come_soon_are_waited_for() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new();
        pace.wants(Reason::Awaits, start);
        assert_eq!(pace.due(), Some(start + HOLD));
        // They are there.
        pace.wants(Reason::Shows, start + MS(5));
        assert_eq!(pace.due(), Some(start + MS(5)));
    }

    #[test]
    fn a_held_key_does_not_hold_the_drawing() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new();
        for key in 0..10 {
            pace.wants(Reason::Awaits, start + MS(key));
        }
        assert_eq!(pace.due(), Some(start + HOLD));
    }

    #[test]
    fn drawings_are_a_thirtieth_of_a_second_apart_at_least() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new();
        pace.drew(start, start + MS(2));
        pace.wants(Reason::Shows, start + MS(3));
        assert_eq!(pace.due(), Some(start + MS(2) + SHORTEST));
        pace.wants(Reason::Shows, start + MS(500));
        assert_eq!(pace.due(), Some(start + MS(2) + SHORTEST));
    }

    #[test]
    fn a_slow_line_is_given_rest_but_not_for_ever() {
        let start = Instant::now();
        let rest = |took: Duration| {
            let mut pace = FrameScheduler::new();
            pace.drew(start, start + took);
            pace.wants(Reason::Shows, start + took);
            pace.due().unwrap() - (start + took)
        };
        assert_eq!(rest(MS(200)), MS(400));
        assert_eq!(rest(MS(30_000)), LONGEST);
        assert_eq!(rest(MS(1)), SHORTEST);
    }

    #[test]
    fn curves_without_their_peaks_wait_for_those_with() {
        let answer = |stage, result| {
            Event::Answer(Answer::Curves(CurvesAnswer {
                generation: 1,
                stage,
                result,
                elapsed: Duration::ZERO,
            }))
        };
        let curves = || {
            Ok(Curves {
                members: Vec::new(),
                modes: None,
            })
        };
        assert_eq!(Reason::of(&answer(Stage::Coarse, curves())), Reason::Shows);
        assert_eq!(Reason::of(&answer(Stage::Full, curves())), Reason::Awaits);
        assert_eq!(
            Reason::of(&answer(Stage::Resolved, curves())),
            Reason::Shows
        );
        // Nothing comes after a failure.
        let failed = answer(Stage::Full, Err("why".to_owned()));
        assert_eq!(Reason::of(&failed), Reason::Shows);
    }

    #[test]
    fn a_key_waits_for_what_it_asked() {
        let key = Event::Key(crossterm::event::KeyCode::Char('+').into());
        assert_eq!(Reason::of(&key).asking(true), Reason::Awaits);
        assert_eq!(Reason::of(&key).asking(false), Reason::Shows);
    }
}
