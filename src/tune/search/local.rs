//! Several walks downhill side by side.

use super::budget::Budget;
use super::sqp::Sqp;
use super::types::{Merit, Phase, Stop};

/// Walks downhill from every start until all have stopped, and tells why the best of them did; none where none began.
///
/// A walk that comes to where a better one is ends there.
pub(super) fn descend(budget: &mut Budget<'_>, starts: Vec<Vec<f64>>) -> Option<Stop> {
    let mut walks: Vec<Sqp> = starts.into_iter().map(Sqp::new).collect();
    while budget.ended().is_none() {
        let points: Vec<Vec<f64>> = walks
            .iter()
            .filter_map(Sqp::ask)
            .map(<[f64]>::to_vec)
            .collect();
        if points.is_empty() {
            break;
        }
        let evaluations = budget.evaluations(&points, Phase::Local);
        let walking = walks.iter_mut().filter(|walk| walk.ask().is_some());
        for (walk, evaluation) in walking.zip(evaluations) {
            walk.tell(evaluation);
        }
        drop_followers(&mut walks);
    }
    let merit = |walk: &Sqp| walk.merit().unwrap_or(Merit::WORST);
    let best = walks.iter().min_by(|a, b| merit(a).compare(&merit(b)))?;
    best.stopped()
}

/// Ends every walk that is where another, better one is.
fn drop_followers(walks: &mut Vec<Sqp>) {
    const TOGETHER: f64 = 1e-3;
    let mut index = 0;
    while index < walks.len() {
        let walk = &walks[index];
        let follows = walk.ask().is_some()
            && walks.iter().enumerate().any(|(i, other)| {
                let (Some(own), Some(others)) = (walk.merit(), other.merit()) else {
                    return false;
                };
                let apart = walk.x().iter().zip(other.x()).map(|(a, b)| (a - b).abs());
                // Of two that are equal the first goes on.
                let order = others.compare(&own).then(i.cmp(&index));
                order.is_lt() && apart.fold(0.0, f64::max) < TOGETHER
            });
        if follows {
            walks.remove(index);
        } else {
            index += 1;
        }
    }
}
