//! Curves: first few frequencies, then all of the sweep.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use super::lane::guarded;
use super::members::{Labelled, members};
use super::memory::Memory;
use super::resolve::Unresolved;
use super::{Curves, CurvesAnswer, Member, PROMPT, Stage, Subject};
use crate::model::Model;
use crate::rehearsal;
use crate::solve::{Frf, frequencies, sweep};

/// Frequencies of the timing sample, spread over the whole range.
const SAMPLE: usize = 8;

/// A coarse curve that would take longer than this is left out: it cannot be cancelled.
const LONGEST_COARSE: Duration = Duration::from_secs(1);

/// Subsystems times frequencies that no processor needs [`PROMPT`] for.
const LIGHT: usize = 20_000;

/// The fewest frequencies of a coarse curve.
const COARSEST: usize = 50;

/// Answers coarsely where that helps, then in full; what is left to resolve. `None` where cancelled or not possible.
pub(super) fn answer(
    subject: Subject,
    memory: &Memory,
    cancel: &AtomicBool,
    notify: &impl Fn(CurvesAnswer),
) -> Option<Unresolved> {
    let start = Instant::now();
    let tell = |stage, result| {
        notify(CurvesAnswer {
            generation: subject.generation,
            stage,
            result,
            elapsed: start.elapsed(),
        });
    };
    let solved = guarded(|| {
        rehearsal::fault("worker", &subject.model.title);
        let Some(members) = members(&subject, cancel)? else {
            return Ok(None);
        };
        let mut places = members.iter().enumerate();
        let knows = places.all(|(place, (_, model))| memory.knows(place, model));
        if !knows && let Some(coarse) = coarse(&members) {
            tell(Stage::Coarse, Ok(coarse));
        }
        Ok(solve_all(&members, memory, cancel).map(|solved| (members, solved)))
    });
    match solved? {
        Ok((members, (curves, shown))) => {
            tell(Stage::Full, Ok(shown));
            Some(Unresolved {
                subject,
                members,
                curves,
                start,
            })
        }
        Err(message) => {
            tell(Stage::Full, Err(message));
            None
        }
    }
}

/// Few frequencies, where all would take longer than [`PROMPT`]. Never cancelled: it is what keeps a held key alive.
fn coarse(members: &[Labelled]) -> Option<Curves> {
    let (_, model) = members.first()?;
    let all = frequencies(&model.sweep);
    if (model.attached().count() + 1) * all.len() * members.len() < LIGHT {
        return None;
    }
    let every = (all.len() / SAMPLE).max(1);
    let sample: Vec<f64> = all.iter().step_by(every).copied().collect();
    let never = AtomicBool::new(false);
    // The first time may be that of waking the threads.
    let mut shortest = f64::INFINITY;
    for _ in 0..2 {
        let start = Instant::now();
        sweep(model, &sample, &never)?;
        shortest = shortest.min(start.elapsed().as_secs_f64());
    }
    let each = shortest / sample.len() as f64 * members.len() as f64;
    let affordable = 0.5 * PROMPT.as_secs_f64() / each;
    let too_long = each * COARSEST as f64 > LONGEST_COARSE.as_secs_f64();
    if 2.0 * affordable >= all.len() as f64 || too_long {
        return None;
    }
    let points = (affordable as usize).max(COARSEST);
    let stride = all.len().div_ceil(points);
    (stride > 1).then(|| solve_some(members, stride)).flatten()
}

/// Every member at every `stride`-th frequency of its sweep and the last.
fn solve_some(members: &[Labelled], stride: usize) -> Option<Curves> {
    let solved = members.iter().map(|(label, model)| {
        let all = frequencies(&model.sweep);
        let last = all.len() - 1;
        let some: Vec<f64> = all
            .iter()
            .enumerate()
            .filter(|(index, _)| index % stride == 0 || *index == last)
            .map(|(_, &f)| f)
            .collect();
        let frf = sweep(model, &some, &AtomicBool::new(false))?;
        Some(member(label.as_deref(), model, frf))
    });
    Some(Curves {
        members: solved.collect::<Option<_>>()?,
        modes: None,
    })
}

/// Every member at the frequencies of its sweep, and the same with those where its peaks were before; none where
/// cancelled.
fn solve_all(
    members: &[Labelled],
    memory: &Memory,
    cancel: &AtomicBool,
) -> Option<(Curves, Curves)> {
    let (mut all, mut shown) = (Vec::new(), Vec::new());
    for (place, (label, model)) in members.iter().enumerate() {
        let (base, near) = memory.sweep(place, model, cancel)?;
        let base = member(label.as_deref(), model, base);
        shown.push(match near {
            Some(frf) => member(label.as_deref(), model, frf),
            None => base.clone(),
        });
        all.push(base);
    }
    let curves = |members| Curves {
        members,
        modes: None,
    };
    Some((curves(all), curves(shown)))
}

/// A member's responses, not resolved.
fn member(label: Option<&str>, model: &Arc<Model>, frf: Frf) -> Member {
    Member {
        label: label.map(str::to_owned),
        model: Arc::clone(model),
        frf,
        peaks: Vec::new(),
        damping_ratios: Vec::new(),
    }
}
