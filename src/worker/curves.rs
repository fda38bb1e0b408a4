//! Curves: a few frequencies first, then the whole sweep.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use super::curve_cache::{CurveCache, spread, timed};
use super::job_thread::guarded;
use super::members::{Labelled, members};
use super::messages::{Curves, CurvesAnswer, Member, Stage, Subject};
use super::resolve::Unresolved;
use crate::fault_injection;
use crate::model::Checked;
use crate::solve::{Cancelled, Frf, frequencies, sweep, sweep_alone};

/// The number of frequencies of the timing sample, over the whole range.
const SAMPLE: usize = 8;

/// A sweep that takes longer than this, about the time of drawing, is preceded by a coarse curve.
pub(super) const PROMPT: Duration = Duration::from_micros(500);

/// A coarse curve that would take longer than this is omitted, because it cannot be cancelled.
const LONGEST_COARSE: Duration = Duration::from_secs(1);

/// The time of a coarse curve as a share of [`PROMPT`], if [`COARSEST`] permits.
const COARSE: f64 = 0.5;

/// The least number of frequencies of a coarse curve: about one per column of dots on a terminal of 80 columns.
const COARSEST: usize = 100;

/// Sends a coarse curve if the sweep is slow, then the whole sweep. Returns the curves to resolve, or an error in one line.
pub(super) fn answer(
    subject: Subject,
    cache: &CurveCache,
    cancel: &AtomicBool,
    notify: &impl Fn(CurvesAnswer),
) -> Result<Result<Unresolved, String>, Cancelled> {
    let start = Instant::now();
    let send = |stage, result| {
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
        // If this is cancelled, the coarse curve below still is sent.
        let few = |place, model: &Arc<Checked>| cache.few(place, model, cancel).ok().flatten();
        let few = of_each(&members, few);
        if let Some(coarse) = few.or_else(|| coarse(&members, cache)) {
            send(Stage::Coarse, Ok(coarse));
        }
        let solved = solve_all(&members, cache, cancel)?;
        Ok((members, solved))
    })?;
    Ok(match solved {
        Ok((members, (curves, shown))) => {
            send(Stage::Full, Ok(shown));
            Ok(Unresolved {
                subject,
                members,
                curves,
                start,
            })
        }
        Err(message) => {
            send(Stage::Full, Err(message.clone()));
            Err(message)
        }
    })
}

/// The curves that `solve` returns for every member and its index; none if it returns none for one of them.
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

/// A few frequencies, if the sweep would take longer than [`PROMPT`]. Never cancelled: the chart must follow a repeating key.
fn coarse(members: &[Labelled], cache: &CurveCache) -> Option<Curves> {
    let (_, model) = members.first()?;
    let each = match cache.seconds_per_frequency(model) {
        Some(seconds) => seconds,
        None => sampled(model)?,
    };
    let (points, alone) = few(
        each * members.len() as f64,
        rayon::current_num_threads(),
        model.sweep.points,
    )?;
    of_each(members, |place, model| {
        let some = spread(model, &cache.peaks_between(place, model), points);
        if alone {
            Some(sweep_alone(model, &some))
        } else {
            sweep(model, &some, &AtomicBool::new(false)).ok()
        }
    })
}

/// The number of frequencies of a coarse curve of a sweep of `all` frequencies, if all threads solve one in `each`
/// seconds, and whether one thread alone is as fast. None if the whole sweep is fast, or even a coarse curve is too slow.
fn few(each: f64, threads: usize, all: usize) -> Option<(usize, bool)> {
    let too_long = each * COARSEST as f64 > LONGEST_COARSE.as_secs_f64();
    if each * all as f64 <= PROMPT.as_secs_f64() || too_long {
        return None;
    }
    let affordable = (COARSE * PROMPT.as_secs_f64() / each) as usize;
    // Waking the other threads takes as long as solving these on one.
    let by_one = affordable / threads;
    let alone = by_one >= COARSEST;
    let points = if alone {
        by_one
    } else {
        affordable.max(COARSEST)
    };
    (points < all).then_some((points, alone))
}

/// The time per frequency of a model, s, measured on a few of them.
fn sampled(model: &Checked) -> Option<f64> {
    let all = frequencies(&model.sweep);
    let every = (all.len() / SAMPLE).max(1);
    let sample: Vec<f64> = all.iter().step_by(every).copied().collect();
    let never = AtomicBool::new(false);
    // The first run may include waking the threads.
    let mut shortest = f64::INFINITY;
    for _ in 0..2 {
        let (solved, took) = timed(|| sweep(model, &sample, &never));
        solved.ok()?;
        shortest = shortest.min(took);
    }
    Some(shortest / sample.len() as f64)
}

/// Every member at the frequencies of its sweep, and the same with the frequencies of its previous peaks.
fn solve_all(
    members: &[Labelled],
    cache: &CurveCache,
    cancel: &AtomicBool,
) -> Result<(Curves, Curves), Cancelled> {
    let (mut all, mut shown) = (Vec::new(), Vec::new());
    for (place, (label, model)) in members.iter().enumerate() {
        let (base, near) = cache.sweep(place, model, cancel)?;
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

/// A member with unresolved responses.
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
        // Closed form: a share of PROMPT over the time per frequency.
        let prompt = PROMPT.as_secs_f64();
        assert_eq!(few(0.9 * prompt / 2000.0, 2, 2000), None);
        let share = |of: f64| (COARSE * of) as usize;
        assert_eq!(few(prompt / 1000.0, 2, 2000), Some((share(500.0), true)));
        assert_eq!(few(prompt / 1000.0, 8, 2000), Some((share(1000.0), false)));
        // At least COARSEST frequencies; no coarse curve if it would block too long.
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
        // Many peaks are thinned like the sweep.
        let peaks: Vec<f64> = (0..5000).map(|k| 10.0 + 0.05 * f64::from(k)).collect();
        assert!(spread(&checked(&model), &peaks, 300).len() <= 610);
    }
}
