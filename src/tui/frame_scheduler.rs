//! Decides when to draw: at once after a visible change, but not frames that the next one replaces, and less often on a
//! slow connection.
//!
//! No clock: the caller passes the time. The loop waits for events until [`FrameScheduler::due`], draws, and reports
//! the duration by [`FrameScheduler::drew`].

use std::time::{Duration, Instant};

use super::event::Event;
use crate::worker::{Answer, Curves, Stage};

/// The longest wait for a better picture in work. After a key this is for the new curves, to avoid a frame with the old
/// ones dimmed; after the first curves at the sweep frequencies it is for the curves with all peaks, because sharp
/// peaks would vanish and come back. A response within 0.1 s feels immediate (J. Nielsen, Usability Engineering, 1993,
/// section 5.5).
const HOLD: Duration = Duration::from_millis(100);

/// The shortest time between the end of a drawing and the next one: more than 30 frames per second is not visible.
const SHORTEST: Duration = Duration::from_nanos(1_000_000_000 / 30);

/// The longest wait between drawings on a slow connection.
const LONGEST: Duration = Duration::from_secs(1);

/// After a slow drawing the pause is this many times as long as the drawing.
const REST: u32 = 2;

/// Why a drawing is needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// Something visible changed.
    Shows,
    /// The same, and a better picture is in work and may arrive soon.
    Awaits,
}

/// Whether curves have extra points between the sweep frequencies, from the peaks before the last edit.
fn has_peaks(curves: &Curves) -> bool {
    let mut members = curves.members.iter();
    members.any(|member| member.frf.frequencies.len() > member.model.sweep.points)
}

impl Reason {
    /// The reason for a drawing after an event, without requests.
    pub fn of(event: &Event) -> Self {
        match event {
            Event::Answer(Answer::Curves(answer)) => {
                // A coarse curve means that the full one takes long.
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

    /// The reason, given whether the event started a solution.
    #[must_use]
    pub fn asking(self, solves: bool) -> Self {
        if solves { Self::Awaits } else { self }
    }

    /// The longest acceptable wait.
    const fn patience(self) -> Duration {
        match self {
            Self::Shows => Duration::ZERO,
            Self::Awaits => HOLD,
        }
    }
}

/// The schedule of drawings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FrameScheduler {
    /// The deadline of the pending drawing.
    wanted: Option<Instant>,
    /// The earliest time of the next drawing.
    rest: Option<Instant>,
}

impl FrameScheduler {
    /// Without a pending drawing.
    pub const fn new() -> Self {
        Self {
            wanted: None,
            rest: None,
        }
    }

    /// Schedules a drawing from `now` on; an earlier deadline stays.
    pub fn wants(&mut self, reason: Reason, now: Instant) {
        let latest = now + reason.patience();
        self.wanted = Some(self.wanted.map_or(latest, |wanted| wanted.min(latest)));
    }

    /// When to draw: a past time means at once; none if nothing is pending.
    pub fn due(&self) -> Option<Instant> {
        let wanted = self.wanted?;
        Some(self.rest.map_or(wanted, |rest| wanted.max(rest)))
    }

    /// Records a drawing from `began` to `ended`; a slow connection makes it long.
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
        // They have arrived.
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
        // Nothing follows a failure.
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
