//! Division of a band for its integral: near a resonance in steps that grow with the distance from it.

use crate::solve::modes::{ModeKind, Modes};
use crate::solve::peaks::{centre, half_width, is_pole};

/// Relative distance within which a pole next to a band counts as inside.
const AT_END: f64 = 1e-9;

/// The steps away from a resonance grow by this factor: a piece is then three times as long as its distance from the
/// resonance, and fifteen points give eleven digits.
const GROWTH: f64 = 4.0;

/// A resonance and the width over which responses vary near it, both Hz.
#[derive(Debug, Clone, Copy)]
struct Resonance {
    centre: f64,
    width: f64,
}

/// The undamped modes in a band, Hz.
pub(super) fn poles(modes: &Modes, band: [f64; 2]) -> impl Iterator<Item = f64> {
    let all = modes.modes.iter().chain(&modes.beyond);
    let inside = move |f: &f64| band[0] * (1.0 - AT_END) <= *f && *f <= band[1] * (1.0 + AT_END);
    all.filter(|mode| is_pole(mode)).map(centre).filter(inside)
}

/// The ends of a band and the division points between them, Hz, ascending.
pub(super) fn cuts(modes: &Modes, band: [f64; 2]) -> Vec<f64> {
    let resonances = resonances(modes, band);
    let mut cuts: Vec<f64> = poles(modes, band).collect();
    for (index, one) in resonances.iter().enumerate() {
        // Beyond the middle the neighbour's steps are finer.
        let middle = |other: &Resonance| 0.5 * (one.centre + other.centre);
        let left = index
            .checked_sub(1)
            .map_or(0.0, |left| middle(&resonances[left]));
        let right = resonances.get(index + 1).map_or(f64::INFINITY, middle);
        let (low, high) = (left.max(band[0]), right.min(band[1]));
        // Each piece holds at most one resonance.
        cuts.push(high);
        let mut step = one.width;
        while one.centre - step > low || one.centre + step < high {
            cuts.extend(
                [one.centre - step, one.centre + step]
                    .iter()
                    .filter(|f| low < **f && **f < high),
            );
            step *= GROWTH;
        }
    }
    cuts.retain(|f| band[0] < *f && *f < band[1]);
    cuts.extend(band);
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    cuts
}

/// All modes by ascending centre; coinciding ones are merged, with the smallest width.
fn resonances(modes: &Modes, band: [f64; 2]) -> Vec<Resonance> {
    /// The smallest relative width of a mode: rounding.
    const LEAST: f64 = 1e-9;
    /// The relative width of an undamped mode, for responses that do not move in it.
    const UNDAMPED: f64 = 0.01;
    let all = modes.modes.iter().chain(&modes.beyond).map(|mode| {
        let (centre, half_width) = match mode.kind {
            ModeKind::RigidBody => (0.0, 0.0),
            ModeKind::Oscillating | ModeKind::Overdamped => (centre(mode), half_width(mode)),
        };
        // For a mode outside of the band the nearest point of the band counts.
        let outside = (band[0] - centre).max(centre - band[1]).max(0.0);
        let least = if half_width == 0.0 { UNDAMPED } else { LEAST };
        Resonance {
            centre,
            width: half_width.max(outside).max(least * centre),
        }
    });
    let mut all: Vec<Resonance> = all.filter(|one| one.width > 0.0).collect();
    all.sort_by(|a, b| a.centre.total_cmp(&b.centre));
    all.dedup_by(|next, kept| {
        let together = next.centre - kept.centre <= 0.5 * next.width.min(kept.width);
        if together {
            kept.width = kept.width.min(next.width);
        }
        together
    });
    all
}
