//! The undamped natural frequencies: complete by the count, each refined on the characteristic function.
//!
//! The count gives the number of roots between two frequencies. If the characteristic function, at samples between
//! them, changes its sign as often, each change contains exactly one root. Otherwise the halves are counted, and the
//! samples that hide a root are refined.

use std::ops::Range;
use std::sync::atomic::AtomicBool;

use num_complex::Complex64;
use rayon::prelude::*;

use super::blocked::Blocked;
use super::bracket::Bracket;
use super::characteristic::Characteristic;
use super::eigenspace::{Circle, roots_inside};
use super::neighbours::neighbours;
use super::wittrick_williams::Counter;
use super::{MOST_MODES, with_damping_times};
use crate::model::Model;
use crate::solve::Cancelled;
use crate::solve::linear::Magnified;

/// Relative width to which the count alone locates a root.
const NARROW: f64 = 4e-14;

/// Roots closer than this (relative) are separated by their motions: between them the characteristic function is
/// smaller than its rounding.
const CLOSE: f64 = 1e-5;

/// The search for the undamped roots of a model.
pub(super) struct Search<'a> {
    pub(super) counter: Counter,
    /// Without damping.
    model: Model,
    characteristic: Characteristic,
    cancel: &'a AtomicBool,
}

/// A frequency with its count.
#[derive(Debug, Clone, Copy)]
struct Counted {
    omega: f64,
    below: usize,
}

/// A frequency with the characteristic function there.
#[derive(Debug, Clone, Copy)]
struct Sample {
    omega: f64,
    value: Magnified,
}

/// The location of roots.
#[derive(Debug, Clone, Copy)]
enum Piece {
    /// One between two samples.
    Single([Sample; 2]),
    /// One by the count, if the function shows none.
    Counted(f64),
    /// Some closer together than [`CLOSE`].
    Group([Counted; 2]),
}

impl<'a> Search<'a> {
    /// For a checked model, without its dampers and loss factor.
    pub(super) fn new(model: &Model, cancel: &'a AtomicBool) -> Self {
        let model = with_damping_times(model, 0.0);
        Self {
            counter: Counter::new(&model),
            characteristic: Characteristic::new(&model),
            model,
            cancel,
        }
    }

    /// All roots from 0 to `to` (rad/s), ascending, with their multiplicity; rigid-body modes are 0; `None` if there
    /// are more than [`MOST_MODES`].
    pub(super) fn up_to(&self, to: f64) -> Result<Option<Vec<f64>>, Cancelled> {
        let rigid = self.counter.rigid();
        let high = self.counted(to);
        if high.below > MOST_MODES {
            return Ok(None);
        }
        let low = self.floor(high, rigid);
        let samples = self.samples(&self.places(low, high));
        let pieces = self.pieces([low, high], &samples)?;
        let mut roots = vec![0.0; low.below];
        roots.extend(self.separated([low, high], &pieces)?);
        Ok(Some(roots))
    }

    fn counted(&self, omega: f64) -> Counted {
        Counted {
            omega,
            below: self.counter.below(omega),
        }
    }

    /// A frequency with no mode below it except those at 0. Anything slower than any beam counts as 0.
    fn floor(&self, high: Counted, rigid: usize) -> Counted {
        const SLOWEST: f64 = 1e-10;
        let mut low = high;
        while low.below > rigid && low.omega > SLOWEST * high.omega {
            low = self.counted(low.omega / 8.0);
        }
        low
    }

    /// The first samples: some for each root, uniform in the count of bending modes and in its logarithm, and next to the
    /// roots of the blocked masses, each of which has a root near it.
    fn places(&self, low: Counted, high: Counted) -> Vec<f64> {
        // At the root itself the mass is so stiff that rounding hides everything else from the count.
        const ASIDE: f64 = 1.0 + 1e-6;
        let count = 8 + 2 * high.below.saturating_sub(low.below);
        let by = |share: f64, forth: fn(f64) -> f64, back: fn(f64) -> f64| {
            back(forth(low.omega) + share * (forth(high.omega) - forth(low.omega)))
        };
        let mut places = vec![low.omega, high.omega];
        for index in 1..count {
            let share = index as f64 / count as f64;
            places.push(by(share, f64::sqrt, |root| root * root));
            places.push(by(share - 0.5 / count as f64, f64::ln, f64::exp));
        }
        let masses = Blocked::new(&self.model).roots;
        places.extend(masses.iter().map(|root| ASIDE * root.re));
        places.retain(|place| (low.omega..=high.omega).contains(place));
        places.sort_by(f64::total_cmp);
        places.dedup_by(|b, a| *b - *a < CLOSE * *a);
        places
    }

    fn samples(&self, places: &[f64]) -> Vec<Sample> {
        let omegas: Vec<Complex64> = places.iter().map(|&omega| omega.into()).collect();
        let values = self.characteristic.at(&omegas);
        let sample = |(&omega, value)| Sample { omega, value };
        places.iter().zip(values).map(sample).collect()
    }

    /// The locations of the roots between two counted frequencies, which are the first and the last of some samples.
    fn pieces(&self, ends: [Counted; 2], samples: &[Sample]) -> Result<Vec<Piece>, Cancelled> {
        /// Number of additional samples between two.
        const DENSER: usize = 8;
        Cancelled::check(self.cancel)?;
        let [low, high] = ends;
        let roots = high.below.saturating_sub(low.below);
        if roots == 0 {
            return Ok(Vec::new());
        }
        let changes = samples.windows(2).filter(|pair| pair[0].differs(&pair[1]));
        if changes.clone().count() == roots {
            let single = |pair: &[Sample]| Piece::Single([pair[0], pair[1]]);
            return Ok(changes.map(single).collect());
        }
        if samples.len() > 2 {
            let middle = samples.len() / 2;
            let counted = self.counted(samples[middle].omega);
            let (left, right) = rayon::join(
                || self.pieces([low, counted], &samples[..=middle]),
                || self.pieces([counted, high], &samples[middle..]),
            );
            return Ok([left?, right?].concat());
        }
        if high.omega / low.omega - 1.0 < CLOSE {
            if roots > 1 {
                return Ok(vec![Piece::Group(ends)]);
            }
            return Ok(self
                .by_count(ends)?
                .into_iter()
                .map(Piece::Counted)
                .collect());
        }
        let ratio = (high.omega / low.omega).powf(1.0 / DENSER as f64);
        let places = (1..DENSER).map(|index| low.omega * ratio.powi(index as i32));
        let mut denser = samples.to_vec();
        denser.splice(1..1, self.samples(&places.collect::<Vec<_>>()));
        self.pieces(ends, &denser)
    }

    /// The roots between two counted frequencies to the last digits, ascending, from their locations.
    fn separated(&self, ends: [Counted; 2], pieces: &[Piece]) -> Result<Vec<f64>, Cancelled> {
        let places = self.polished(pieces);
        let all: Vec<Complex64> = places.iter().map(|&omega| omega.into()).collect();
        let groups: Vec<&[f64]> = places.chunk_by(|a, b| b - a < CLOSE * a).collect();
        let apart = groups.into_par_iter().map(|group| {
            if group.len() == 1 {
                return Ok(Some(group.to_vec()));
            }
            let first = places.partition_point(|place| *place < group[0]);
            let members = first..first + group.len();
            let around = self.around(ends, &places, &members);
            if around[1].below.saturating_sub(around[0].below) != group.len() {
                // Samples this close together are rounding.
                return Ok(None);
            }
            match self.by_motions(&all, &members) {
                Some(roots) => Ok(Some(roots)),
                None => self.by_count(around).map(Some),
            }
        });
        let apart: Result<Vec<Option<Vec<f64>>>, Cancelled> = apart.collect();
        match apart?.into_iter().collect::<Option<Vec<_>>>() {
            Some(roots) => Ok(roots.concat()),
            None => self.by_count(ends),
        }
    }

    /// The roots: single ones to the last digits, the others approximately.
    fn polished(&self, pieces: &[Piece]) -> Vec<f64> {
        const MOST_STEPS: usize = 100;
        let single = |piece: &Piece| match piece {
            Piece::Single([low, high]) => {
                let value = |at: &Sample| [at.omega, at.relative_to(&low.value)];
                Some((low.value, Bracket::new(value(low), value(high))))
            }
            Piece::Counted(_) | Piece::Group(_) => None,
        };
        let mut brackets: Vec<(Magnified, Bracket)> = pieces.iter().filter_map(single).collect();
        for _ in 0..MOST_STEPS {
            let wide = brackets.iter().filter_map(|(_, bracket)| bracket.next());
            let places: Vec<f64> = wide.collect();
            if places.is_empty() {
                break;
            }
            let mut samples = self.samples(&places).into_iter();
            for (scale, bracket) in &mut brackets {
                if bracket.next().is_some()
                    && let Some(sample) = samples.next()
                {
                    bracket.insert(sample.relative_to(scale));
                }
            }
        }
        let mut singles = brackets.iter().map(|(_, bracket)| bracket.root());
        let places = pieces.iter().flat_map(|piece| -> Vec<f64> {
            match piece {
                Piece::Single(_) => singles.next().into_iter().collect(),
                Piece::Counted(omega) => vec![*omega],
                Piece::Group([low, high]) => {
                    // The largest possible distance.
                    let count = high.below.saturating_sub(low.below);
                    let share = |index: usize| index as f64 / (count - 1) as f64;
                    let place = |index| low.omega + share(index) * (high.omega - low.omega);
                    (0..count).map(place).collect()
                }
            }
        });
        places.collect()
    }

    /// Counts at the ends of a group of roots: halfway to its neighbours.
    fn around(&self, ends: [Counted; 2], places: &[f64], members: &Range<usize>) -> [Counted; 2] {
        const MARGIN: f64 = 1e-3;
        let (first, last) = (places[members.start], places[members.end - 1]);
        let low = match members.start.checked_sub(1) {
            Some(before) => 0.5 * (places[before] + first),
            None => ends[0].omega,
        };
        let high = match places.get(members.end) {
            Some(next) => 0.5 * (last + next),
            None => ends[1].omega,
        };
        [
            self.counted(low.max(first * (1.0 - MARGIN))),
            self.counted(high.min(last * (1.0 + MARGIN))),
        ]
    }

    /// The roots of a group from the space of their motions; `None` if that does not separate them.
    fn by_motions(&self, all: &[Complex64], group: &Range<usize>) -> Option<Vec<f64>> {
        let mut close = neighbours(all, group.start, CLOSE);
        // The group may have others next to it.
        let offset = close
            .members
            .iter()
            .position(|&member| member == group.start)?;
        let mut roots: Vec<Complex64> = close.members.iter().map(|&member| all[member]).collect();
        // Within a circle as wide as their uncertainty, and within one as wide as the group.
        for _ in 0..2 {
            let before = roots.iter().sum::<Complex64>() / roots.len() as f64;
            roots = roots_inside(&self.model, Circle::around(&roots, close.gap), roots.len())?;
            close.gap -= (roots.iter().sum::<Complex64>() / roots.len() as f64 - before).norm();
        }
        let own = roots.get(offset..offset + group.len())?;
        let near = |(found, about): (&Complex64, &Complex64)| {
            (found.re - about.re).abs() < 2.0 * CLOSE * about.re
        };
        own.iter()
            .zip(&all[group.clone()])
            .all(near)
            .then(|| own.iter().map(|root| root.re).collect())
    }

    /// The roots between two counted frequencies by the count alone.
    fn by_count(&self, [low, high]: [Counted; 2]) -> Result<Vec<f64>, Cancelled> {
        Cancelled::check(self.cancel)?;
        let roots = high.below.saturating_sub(low.below);
        if roots == 0 {
            return Ok(Vec::new());
        }
        if high.omega / low.omega - 1.0 < NARROW {
            return Ok(vec![0.5 * (low.omega + high.omega); roots]);
        }
        let middle = self.counted((low.omega * high.omega).sqrt());
        let (left, right) = rayon::join(
            || self.by_count([low, middle]),
            || self.by_count([middle, high]),
        );
        Ok([left?, right?].concat())
    }
}

impl Sample {
    /// Whether the function has the other sign at another sample.
    fn differs(&self, other: &Self) -> bool {
        (self.value.direction.re < 0.0) != (other.value.direction.re < 0.0)
    }

    /// The value relative to the magnitude of another; 0 if it vanishes.
    fn relative_to(&self, scale: &Magnified) -> f64 {
        if self.value.log == f64::NEG_INFINITY {
            return 0.0;
        }
        (self.value.log - scale.log).exp().min(f64::MAX) * self.value.direction.re.signum()
    }
}
