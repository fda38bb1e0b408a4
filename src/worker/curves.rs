//! Curves: first few frequencies, then all of the sweep.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use super::lane::guarded;
use super::members::{Labelled, members};
use super::memory::Memory;
use super::resolve::Unresolved;
use super::{Curves, CurvesAnswer, Member, PROMPT, Stage, Subject};
use crate::fault_injection;
use crate::model::Checked;
use crate::solve::{Cancelled, Frf, frequencies, sweep, sweep_alone};

/// Frequencies of the timing sample, spread over the whole range.
const SAMPLE: usize = 8;

/// A coarse curve that would take longer than this is left out: it cannot be cancelled.
const LONGEST_COARSE: Duration = Duration::from_secs(1);

/// What a coarse curve takes, as a share of [`PROMPT`], where that allows for [`COARSEST`].
const COARSE: f64 = 0.5;

/// The fewest frequencies of a coarse curve: about one for each column of dots on a terminal of 80 columns.
const COARSEST: usize = 100;

/// Answers coarsely where that helps, then in full; what is left to resolve, or one line that says what went wrong.
pub(super) fn answer(
    subject: Subject,
    memory: &Memory,
    cancel: &AtomicBool,
    notify: &impl Fn(CurvesAnswer),
) -> Result<Result<Unresolved, String>, Cancelled> {
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
        fault_injection::inject("worker", &subject.model.title);
        let members = members(&subject, cancel)?;
        // Where that is cancelled a coarse curve comes all the same.
        let few = |place, model: &Arc<Checked>| memory.few(place, model, cancel).ok().flatten();
        let few = of_each(&members, few);
        if let Some(coarse) = few.or_else(|| coarse(&members, memory)) {
            tell(Stage::Coarse, Ok(coarse));
        }
        let solved = solve_all(&members, memory, cancel)?;
        Ok((members, solved))
    })?;
    Ok(match solved {
        Ok((members, (curves, shown))) => {
            tell(Stage::Full, Ok(shown));
            Ok(Unresolved {
                subject,
                members,
                curves,
                start,
            })
        }
        Err(message) => {
            tell(Stage::Full, Err(message.clone()));
            Err(message)
        }
    })
}

/// What `solve` makes of every member, which it is given with its place; none where it makes nothing of one.
fn of_each(
    members: &[Labelled],
    solve: impl Fn(usize, &Arc<Checked>) -> Option<Frf>,
) -> Option<Curves> {
    let solved = members.iter().enumerate().map(|(place, (label, model))| {
        let frf = solve(place, model)?;
        Some(member(label.as_deref(), model, frf))
    });
    Some(Curves {
        members: solved.collect::<Option<_>>()?,
        modes: None,
    })
}

/// Few frequencies, where all would take longer than [`PROMPT`]. Never cancelled: it is what keeps a held key alive.
fn coarse(members: &[Labelled], memory: &Memory) -> Option<Curves> {
    let (_, model) = members.first()?;
    let pace = match memory.pace(model) {
        Some(pace) => pace,
        None => sampled(model)?,
    };
    let (points, alone) = few(
        pace * members.len() as f64,
        rayon::current_num_threads(),
        model.sweep.points,
    )?;
    of_each(members, |place, model| {
        let some = spread(model, &memory.between(place, model), points);
        if alone {
            Some(sweep_alone(model, &some))
        } else {
            sweep(model, &some, &AtomicBool::new(false)).ok()
        }
    })
}

/// How many frequencies of a sweep of so many are a coarse curve, where all threads solve one in `each` seconds, and
/// whether one thread alone solves them as soon; none where all are solved soon, or even few take too long.
fn few(each: f64, threads: usize, all: usize) -> Option<(usize, bool)> {
    let too_long = each * COARSEST as f64 > LONGEST_COARSE.as_secs_f64();
    if each * all as f64 <= PROMPT.as_secs_f64() || too_long {
        return None;
    }
    let affordable = (COARSE * PROMPT.as_secs_f64() / each) as usize;
    // Other threads would be awake only when one has done it.
    let by_one = affordable / threads;
    let alone = by_one >= COARSEST;
    let points = if alone {
        by_one
    } else {
        affordable.max(COARSEST)
    };
    (points < all).then_some((points, alone))
}

/// About so many frequencies of a model's sweep, and as many at the most of others that matter (Hz, rising); each once.
pub(super) fn spread(model: &Checked, others: &[f64], points: usize) -> Vec<f64> {
    let all = frequencies(&model.sweep);
    let evenly = |list: &[f64]| -> Vec<f64> {
        let stride = list.len().div_ceil(points).max(1);
        list.iter().step_by(stride).copied().collect()
    };
    let mut some = [evenly(&all), evenly(others), vec![model.sweep.to]].concat();
    some.sort_by(f64::total_cmp);
    some.dedup();
    some
}

/// How long a frequency of a model takes, s, by a few of them.
fn sampled(model: &Checked) -> Option<f64> {
    let all = frequencies(&model.sweep);
    let every = (all.len() / SAMPLE).max(1);
    let sample: Vec<f64> = all.iter().step_by(every).copied().collect();
    let never = AtomicBool::new(false);
    // The first time may be that of waking the threads.
    let mut shortest = f64::INFINITY;
    for _ in 0..2 {
        let (solved, took) = timed(|| sweep(model, &sample, &never));
        solved.ok()?;
        shortest = shortest.min(took);
    }
    Some(shortest / sample.len() as f64)
}

/// What a solve gives, and how long it took, s.
pub(super) fn timed<T>(solve: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let solved = solve();
    (solved, start.elapsed().as_secs_f64())
}

/// Every member at the frequencies of its sweep, and the same with those where its peaks were before.
fn solve_all(
    members: &[Labelled],
    memory: &Memory,
    cancel: &AtomicBool,
) -> Result<(Curves, Curves), Cancelled> {
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
    Ok((curves(all), curves(shown)))
}

/// A member's responses, not resolved.
fn member(label: Option<&str>, model: &Arc<Checked>, frf: Frf) -> Member {
    Member {
        label: label.map(str::to_owned),
        model: Arc::clone(model),
        frf,
        peaks: Vec::new(),
        damping_ratios: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::checked;
    use crate::presets;

    #[test]
    fn a_coarse_curve_takes_no_longer_than_it_may() {
        // Closed form: a share of the prompt answer over the time a frequency takes.
        let prompt = PROMPT.as_secs_f64();
        assert_eq!(few(0.9 * prompt / 2000.0, 2, 2000), None);
        let share = |of: f64| (COARSE * of) as usize;
        assert_eq!(few(prompt / 1000.0, 2, 2000), Some((share(500.0), true)));
        assert_eq!(few(prompt / 1000.0, 8, 2000), Some((share(1000.0), false)));
        // Never so few that it would show nothing, and none that would hang.
        assert_eq!(few(prompt, 2, 2000), Some((COARSEST, false)));
        assert_eq!(few(LONGEST_COARSE.as_secs_f64(), 2, 2000), None);
        assert_eq!(few(prompt, 2, COARSEST), None);
    }

    #[test]
    fn a_coarse_curve_reaches_from_end_to_end_and_has_the_peaks() {
        let model = crate::model::read(presets::find("fig08").unwrap().text)
            .unwrap()
            .into_inner();
        let peaks = [7.413, 31.06, 120.5];
        let some = spread(&checked(&model), &peaks, 300);
        let sweep = model.sweep;
        assert!(some.is_sorted_by(|a, b| a < b));
        assert_eq!((some[0], some[some.len() - 1]), (sweep.from, sweep.to));
        assert!(peaks.iter().all(|peak| some.contains(peak)));
        assert!((280..=310).contains(&some.len()), "{}", some.len());
        // Many peaks are thinned, as the sweep is.
        let peaks: Vec<f64> = (0..5000).map(|k| 10.0 + 0.05 * f64::from(k)).collect();
        assert!(spread(&checked(&model), &peaks, 300).len() <= 610);
    }
}
