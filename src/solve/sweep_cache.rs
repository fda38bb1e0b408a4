//! Sweeps of a model that is edited in one place: the parts left and right of the place are solved once and cached.
//!
//! Two models that differ in one subsystem, force, response or support have the same stations along x up to some
//! position, and again from some position on. Both sides act on the substructure between them in the same way: see
//! [`super::kernel`]. So after the first edit of a place the next ones cost as much as a beam with the edited
//! substructure only, for any number of other subsystems.

use std::ops::Range;
use std::sync::atomic::AtomicBool;

use num_complex::Complex64;
use rayon::prelude::*;

use super::Cancelled;
use super::kernel::{MOST_LANES, Prepared, SideBatch, Solver, Source, Substructure, low_limit};
use super::output::{Holds, Read, Row};
use super::plan::{Event, Plan};
use super::sweep::{Frf, angular, chunk_length, fill_limits, over_chunks, solved, sweep_prepared};
use super::waves::BeamConstants;
use crate::model::Checked;

/// With fewer stations on the sides a full solution is as fast as the cached one.
const FEWEST_STATIONS: usize = 8;

/// Frequencies per chunk of a sweep with cached sides: whole groups.
const CHUNK: usize = 8 * MOST_LANES;

/// One thread solves this many with cached sides before another one wakes up.
const ALONE: usize = 32 * MOST_LANES;

/// Of the limit below which frequencies are solved in numbers of twice the digits: up to this factor the cached sides keep
/// their own, above it they are solved again.
const MOST_RISE: f64 = 1.5;

/// The cache between the sweeps of a model that is edited.
#[derive(Debug, Default)]
pub struct SweepCache {
    /// The newest plan that was solved.
    last: Option<Plan>,
    cached: Option<CachedSides>,
}

/// The solved sides of a part of a plan.
#[derive(Debug)]
struct CachedSides {
    plan: Plan,
    part: Part,
    /// Hz.
    frequencies: Vec<f64>,
    sides: Vec<SideBatch>,
}

/// A part of a plan's stations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Part {
    /// Stations left of it.
    left: usize,
    /// Stations right of it.
    right: usize,
}

impl SweepCache {
    /// The same as [`super::sweep()`]: solves a model at each frequency (Hz, > 0).
    ///
    /// A model that differs from the last one in one place is solved from the cached sides. If they are not cached yet,
    /// they are solved first (as much work as two sweeps; with an enabled response `E_V`, to which every point of the
    /// beam contributes, four to five).
    ///
    /// # Errors
    /// `cancel` became true before the end.
    pub fn sweep(
        &mut self,
        model: &Checked,
        frequencies: &[f64],
        cancel: &AtomicBool,
    ) -> Result<Frf, Cancelled> {
        let plan = Plan::new(model);
        if !self.reaches(&plan, frequencies) {
            let before = self.last.replace(plan.clone());
            if let Some(before) = before {
                self.keep(&before, &plan, frequencies, cancel)?;
            }
        }
        self.last = Some(plan.clone());
        match self.cached_for(&plan, frequencies) {
            Some(cached) => from_sides(model, plan, cached, frequencies, cancel),
            None => sweep_prepared(model, &Prepared::new(plan), frequencies, cancel),
        }
    }

    /// The same from the cache only; `None` if the cache does not fit the model.
    ///
    /// # Errors
    /// `cancel` became true before the end.
    pub fn recalled(
        &self,
        model: &Checked,
        frequencies: &[f64],
        cancel: &AtomicBool,
    ) -> Result<Option<Frf>, Cancelled> {
        let plan = Plan::new(model);
        let Some(cached) = self.cached_for(&plan, frequencies) else {
            return Ok(None);
        };
        from_sides(model, plan, cached, frequencies, cancel).map(Some)
    }

    /// Solves the sides of the place that the next edit changes, so that the sweep after it finds them in the cache.
    ///
    /// `edited` is the model after such an edit.
    ///
    /// # Errors
    /// `cancel` became true before the end.
    pub fn expect(
        &mut self,
        model: &Checked,
        edited: &Checked,
        frequencies: &[f64],
        cancel: &AtomicBool,
    ) -> Result<(), Cancelled> {
        let (plan, edited) = (Plan::new(model), Plan::new(edited));
        if self.reaches(&edited, frequencies) {
            return Ok(());
        }
        self.keep(&plan, &edited, frequencies, cancel)
    }

    /// Whether the sides for the edit from `model` to `edited` also fit another model.
    pub fn would_serve(model: &Checked, edited: &Checked, other: &Checked) -> bool {
        let [plan, edited, other] = [model, edited, other].map(|model| Plan::new(model));
        let part = part(common(&plan, &edited), &plan, &edited);
        part.is_some_and(|part| serves(&edited, part, &other))
    }

    /// Whether the cache fits a model.
    pub fn knows(&self, model: &Checked, frequencies: &[f64]) -> bool {
        self.reaches(&Plan::new(model), frequencies)
    }

    /// Bytes in the cache.
    pub fn bytes(&self) -> usize {
        let sides = self.cached.iter().flat_map(|cached| &cached.sides);
        sides.map(SideBatch::bytes).sum()
    }

    /// Whether the cache fits a plan.
    fn reaches(&self, plan: &Plan, frequencies: &[f64]) -> bool {
        self.cached_for(plan, frequencies).is_some()
    }

    /// The cached sides for a plan, and the part of the plan between them.
    fn cached_for(&self, plan: &Plan, frequencies: &[f64]) -> Option<(&CachedSides, Part)> {
        let cached = self.cached.as_ref()?;
        let serves = cached.frequencies == frequencies && serves(&cached.plan, cached.part, plan);
        serves.then_some((cached, cached.part))
    }

    /// Caches the common sides of two plans around the part in which they differ, if they are long enough.
    fn keep(
        &mut self,
        one: &Plan,
        other: &Plan,
        frequencies: &[f64],
        cancel: &AtomicBool,
    ) -> Result<(), Cancelled> {
        let Some(part) = part(common(one, other), one, other) else {
            return Ok(());
        };
        // The sides of another place would only use memory.
        self.cached = None;
        let substructure = substructure(other.clone(), part, other);
        let sides = keep(&substructure, frequencies, cancel)?;
        self.cached = Some(CachedSides {
            plan: substructure.prepared.plan,
            part,
            frequencies: frequencies.to_vec(),
            sides,
        });
        Ok(())
    }
}

/// The responses of a plan from the cached sides of a part of it.
fn from_sides(
    model: &Checked,
    plan: Plan,
    (cached, part): (&CachedSides, Part),
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Frf, Cancelled> {
    let substructure = substructure(plan, part, &cached.plan);
    let solve = |solver: &mut Solver, first, frequencies: &[f64], out: &mut [&mut [Complex64]]| {
        solver.solve_substructure(
            &substructure,
            (&cached.sides, first),
            &angular(frequencies),
            out,
        );
    };
    let chunk = if frequencies.len() <= ALONE {
        ALONE
    } else {
        CHUNK
    };
    let mut frf = solved(model, frequencies, chunk, cancel, &solve)?;
    fill_limits(model, &substructure.prepared, &mut frf);
    Ok(frf)
}

/// Whether the cached sides of a part of a plan are also sides of another plan.
fn serves(known: &Plan, part: Part, plan: &Plan) -> bool {
    let Part { left, right } = part;
    let has_energy = known.wants_energy || !plan.wants_energy;
    let has_digits = low_limit(plan) <= MOST_RISE * low_limit(known);
    let common = common(known, plan);
    has_energy
        && has_digits
        && common.left >= left
        && common.right >= right
        && left + right <= plan.stations.len()
}

/// The stations that two plans have in common, from the left and from the right. No stations on a side whose end differs.
fn common(one: &Plan, other: &Plan) -> Part {
    let (most, reads) = (
        one.stations.len().min(other.stations.len()),
        [one, other].map(|plan| {
            let mut reads = plan.reads.clone();
            reads.sort_by_key(|read| read.station);
            reads
        }),
    );
    let known = |beam: &BeamConstants| one.beams.iter().position(|known| known == beam);
    let known: Vec<Option<usize>> = other.beams.iter().map(known).collect();
    let same_beam = |a: usize, b: usize| {
        let beam = |plan: &Plan, span: usize| plan.kinds[plan.spans[span]].beam;
        known[beam(other, b)] == Some(beam(one, a))
    };
    let same = |a: usize, b: usize| {
        let [of, with] = [&one.stations[a], &other.stations[b]];
        let is_same = match (&of.event, &with.event) {
            // It has the beam right of it, whose index may differ.
            (Event::Junction(_), Event::Junction(_)) => of.position == with.position,
            _ => of == with,
        };
        is_same && same_beam(a, b) && same_beam(a + 1, b + 1)
    };
    let from_left = (0..most).take_while(|&k| same(k, k)).count();
    let counts = [one.stations.len(), other.stations.len()];
    let from_right = (1..=most)
        .take_while(|&k| same(counts[0] - k, counts[1] - k))
        .count();
    let differ_left = first_difference(&reads[0], &reads[1], |station, _| station, counts);
    let reversed = reads.map(|reads| reads.into_iter().rev().collect::<Vec<_>>());
    let differ_right = first_difference(
        &reversed[0],
        &reversed[1],
        |station, count| count - 1 - station,
        counts,
    );
    let last = |plan: &Plan| plan.kinds[plan.last_span()].length;
    let ends_there = last(one) == last(other);
    // The reaction of an end that differs is read in the part, too.
    let beside = |holds: Holds, plan: &Plan, place: fn(usize, usize) -> usize| {
        let reads = plan.reads.iter();
        let own = reads.filter(move |read| matches!(read.row, Row::Reaction(of, _) if of == holds));
        let places = own.map(|read| place(read.station, plan.stations.len()));
        places.min().unwrap_or(usize::MAX)
    };
    let both = |holds, place| beside(holds, one, place).min(beside(holds, other, place));
    let mut common = Part {
        left: from_left.min(differ_left),
        right: from_right.min(differ_right),
    };
    if one.left != other.left {
        let from_there = both(Holds::Left, |station, count| count - 1 - station);
        common.left = 0;
        common.right = common.right.min(from_there);
    }
    if one.right != other.right || !ends_there {
        common.left = common.left.min(both(Holds::Right, |station, _| station));
        common.right = 0;
    }
    common
}

/// The first station, counted by `place` from one of the ends, at which two lists of reads differ.
fn first_difference(
    one: &[Read],
    other: &[Read],
    place: impl Fn(usize, usize) -> usize,
    counts: [usize; 2],
) -> usize {
    let at = |list: &[Read], index: usize, count| {
        list.get(index)
            .map(|read| (place(read.station, count), read.row))
    };
    (0..one.len().max(other.len()))
        .find_map(|index| {
            let (a, b) = (at(one, index, counts[0]), at(other, index, counts[1]));
            let differ = a != b;
            let stations = [a, b].into_iter().flatten().map(|(station, _)| station);
            differ.then(|| stations.min().unwrap_or(0))
        })
        .unwrap_or(usize::MAX)
}

/// The part in which two plans differ; `None` if its sides are too short to cache.
fn part(common: Part, one: &Plan, other: &Plan) -> Option<Part> {
    let most = one.stations.len().min(other.stations.len());
    let is_same = |count| common.left >= count && common.right >= count;
    if is_same(one.stations.len().max(other.stations.len())) {
        return None;
    }
    let left = common.left.min(most);
    // If nothing differs, or if a station was added next to an equal one, both sides may claim the same stations.
    let right = common.right.min(most - left);
    (left + right >= FEWEST_STATIONS).then_some(Part { left, right })
}

/// A plan whose part lies between the sides of `known`.
fn substructure(plan: Plan, part: Part, known: &Plan) -> Substructure {
    let count = plan.stations.len();
    let range = part.left..count - part.right;
    let sources = sources(&plan, &range, known, part);
    let reads = plan.reads.iter().enumerate();
    let mut by_station: Vec<(usize, usize)> =
        reads.map(|(number, read)| (read.station, number)).collect();
    by_station.sort_unstable();
    Substructure {
        prepared: Prepared::new(plan).with_limit_of(known),
        part: range,
        sources,
        by_station,
    }
}

/// The source of each read: its index among those of its side, in the order of the known plan.
fn sources(plan: &Plan, range: &Range<usize>, known: &Plan, part: Part) -> Vec<Source> {
    let from_right = known.stations.len() - part.right;
    let shifted = |read: &Read, by: usize| Read {
        station: read.station - by,
        ..*read
    };
    let on_side = |is_there: &dyn Fn(usize) -> bool, by: usize| -> Vec<Read> {
        let there = known.reads.iter().filter(|read| is_there(read.station));
        there.map(|read| shifted(read, by)).collect()
    };
    let left = on_side(&|station| station < part.left, 0);
    let right = on_side(&|station| station >= from_right, from_right);
    let find = |list: &[Read], read: Read| list.iter().position(|known| *known == read);
    let source = |read: &Read| {
        let found = if read.station < range.start {
            find(&left, *read).map(Source::Left)
        } else if read.station >= range.end {
            find(&right, shifted(read, range.end)).map(Source::Right)
        } else {
            None
        };
        found.unwrap_or(Source::Substructure)
    };
    plan.reads.iter().map(source).collect()
}

/// The sides for each group of frequencies.
fn keep(
    substructure: &Substructure,
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Vec<SideBatch>, Cancelled> {
    let chunk = chunk_length(&substructure.prepared.plan);
    let mut kept = vec![Vec::new(); frequencies.len().div_ceil(chunk)];
    let keep = |solver: &mut Solver, _, frequencies: &[f64], kept: &mut Vec<_>| {
        *kept = solver.keep(substructure, &angular(frequencies));
    };
    over_chunks(frequencies, chunk, kept.par_iter_mut(), cancel, &keep)?;
    Ok(kept.into_iter().flatten().collect())
}
