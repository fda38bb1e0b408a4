//! Frequency responses over many frequencies, on all cores.

use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};

use num_complex::Complex64;
use rayon::prelude::*;

use super::Cancelled;
use super::kernel::{Instructions, MOST_LANES, Prepared, Solver};
use super::limit;
use super::plan::Plan;
use crate::model::{Checked, Model, Response, Spacing, Sweep};

/// Frequency responses of a model: one column for each enabled response, one value for each frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Frf {
    /// Hz, ascending.
    pub frequencies: Vec<f64>,
    /// In the order of the model's enabled responses.
    pub columns: Vec<Column>,
}

/// One response over all frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// The response's name.
    pub name: String,
    /// The kind of its values.
    pub kind: ColumnKind,
    /// One value per frequency; an energy has no imaginary part.
    pub values: Vec<Complex64>,
}

/// The kind of the values of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnKind {
    /// A complex amplitude, zero to peak.
    Complex,
    /// The vibration energy, real.
    Energy,
}

impl Frf {
    /// The frequencies (Hz) at which any response is not finite: an undamped model exactly at a resonance.
    pub fn singular(&self) -> Vec<f64> {
        let rows = self.singular_rows().into_iter();
        rows.map(|row| self.frequencies[row]).collect()
    }

    /// The indices of [`Self::singular`].
    pub(super) fn singular_rows(&self) -> Vec<usize> {
        let finite = |index: usize| {
            self.columns
                .iter()
                .all(|column| column.values[index].is_finite())
        };
        let rows = 0..self.frequencies.len();
        rows.filter(|&row| !finite(row)).collect()
    }

    /// Merges the rows of two responses of the same model, by ascending frequency.
    #[must_use]
    pub fn merged(&self, other: &Self) -> Self {
        let split = self.frequencies.len();
        let both = [&self.frequencies[..], &other.frequencies].concat();
        let is_known = |f: &f64| {
            let place = self
                .frequencies
                .binary_search_by(|known| known.total_cmp(f));
            place.is_ok()
        };
        let mut order: Vec<usize> = (0..both.len())
            .filter(|&row| row < split || !is_known(&both[row]))
            .collect();
        // A stable sort, and fast for two ascending runs.
        order.sort_by(|&a, &b| both[a].total_cmp(&both[b]));
        let columns = self.columns.iter().zip(&other.columns);
        let columns = columns.map(|(one, other)| Column {
            name: one.name.clone(),
            kind: one.kind,
            values: order
                .iter()
                .map(|&row| match row.checked_sub(split) {
                    None => one.values[row],
                    Some(row) => other.values[row],
                })
                .collect(),
        });
        Self {
            columns: columns.collect(),
            frequencies: order.iter().map(|&row| both[row]).collect(),
        }
    }
}

/// The frequencies of a sweep, Hz; the first and the last are exactly `from` and `to`.
pub fn frequencies(sweep: &Sweep) -> Vec<f64> {
    let last = sweep.points - 1;
    (0..sweep.points)
        .map(|index| {
            let share = index as f64 / last as f64;
            match (index, sweep.spacing) {
                (0, _) => sweep.from,
                (index, _) if index == last => sweep.to,
                (_, Spacing::Linear) => sweep.from + share * (sweep.to - sweep.from),
                (_, Spacing::Log) => sweep.from.powf(1.0 - share) * sweep.to.powf(share),
            }
        })
        .collect()
}

/// Angular frequencies, rad/s, from frequencies, Hz.
pub(super) fn angular(frequencies: &[f64]) -> Vec<Complex64> {
    let omega = |&frequency: &f64| Complex64::from(std::f64::consts::TAU * frequency);
    frequencies.iter().map(omega).collect()
}

/// Solves a model at each frequency (Hz, > 0).
///
/// All cores share the work in chunks; `cancel` is checked between chunks.
///
/// # Errors
/// `cancel` became true before the end.
pub fn sweep(model: &Checked, frequencies: &[f64], cancel: &AtomicBool) -> Result<Frf, Cancelled> {
    let prepared = Prepared::new(Plan::new(model));
    sweep_prepared(model, &prepared, frequencies, cancel)
}

/// [`sweep`] of a model that has been laid out.
pub(super) fn sweep_prepared(
    model: &Model,
    prepared: &Prepared,
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Result<Frf, Cancelled> {
    let chunk = chunk_length(&prepared.plan);
    let solve = |solver: &mut Solver, _, frequencies: &[f64], out: &mut [&mut [Complex64]]| {
        solver.solve(prepared, &angular(frequencies), out);
    };
    let mut frf = solved(model, frequencies, chunk, cancel, &solve)?;
    fill_limits(model, prepared, &mut frf);
    Ok(frf)
}

/// Finds the finite values of the rows at a resonance that no load excites.
pub(super) fn fill_limits(model: &Model, prepared: &Prepared, frf: &mut Frf) {
    limit::fill(frf, |frequencies| {
        solved_alone(Instructions::available()[0], model, prepared, frequencies)
    });
}

/// [`sweep`] on the calling thread only: faster for short sweeps, which end before other threads wake up.
pub fn sweep_alone(model: &Checked, frequencies: &[f64]) -> Frf {
    sweep_with(Instructions::available()[0], model, frequencies)
}

/// [`sweep`] on the calling thread only, with a given instruction set of the processor, for benchmarks and comparisons.
pub fn sweep_with(instructions: Instructions, model: &Checked, frequencies: &[f64]) -> Frf {
    let prepared = Prepared::new(Plan::new(model));
    let mut frf = solved_alone(instructions, model, &prepared, frequencies);
    fill_limits(model, &prepared, &mut frf);
    frf
}

fn solved_alone(
    instructions: Instructions,
    model: &Model,
    prepared: &Prepared,
    frequencies: &[f64],
) -> Frf {
    let mut columns = columns(model, frequencies.len());
    let mut out: Vec<_> = columns.iter_mut().map(|c| &mut c.values[..]).collect();
    Solver::new(instructions).solve(prepared, &angular(frequencies), &mut out);
    Frf {
        frequencies: frequencies.to_vec(),
        columns,
    }
}

/// Gives `solve` each chunk of frequencies (Hz), with the index of its first frequency and its own element of `rooms`.
///
/// Consecutive chunks on a core use the same workspace.
pub(super) fn over_chunks<W: Default + Send, R: Send>(
    frequencies: &[f64],
    chunk: usize,
    rooms: impl IndexedParallelIterator<Item = R>,
    cancel: &AtomicBool,
    solve: &(impl Fn(&mut W, usize, &[f64], R) + Sync),
) -> Result<(), Cancelled> {
    let idle: Mutex<Vec<W>> = Mutex::default();
    let lock = || idle.lock().unwrap_or_else(PoisonError::into_inner);
    frequencies
        .par_chunks(chunk)
        .zip(rooms)
        .enumerate()
        .try_for_each(|(index, (frequencies, room))| {
            Cancelled::check(cancel)?;
            let mut workspace = lock().pop().unwrap_or_default();
            solve(&mut workspace, index * chunk, frequencies, room);
            lock().push(workspace);
            Ok(())
        })
}

/// The responses of a model; `solve` writes them for a chunk of frequencies (Hz) at a time, each to its own column.
pub(super) fn solved<W: Default + Send>(
    model: &Model,
    frequencies: &[f64],
    chunk: usize,
    cancel: &AtomicBool,
    solve: &(impl Fn(&mut W, usize, &[f64], &mut [&mut [Complex64]]) + Sync),
) -> Result<Frf, Cancelled> {
    let mut columns = columns(model, frequencies.len());
    let chunks = frequencies.len().div_ceil(chunk);
    let mut rooms: Vec<Vec<&mut [Complex64]>> = Vec::new();
    rooms.resize_with(chunks, || Vec::with_capacity(columns.len()));
    for column in &mut columns {
        for (room, values) in rooms.iter_mut().zip(column.values.chunks_mut(chunk)) {
            room.push(values);
        }
    }
    let solve = |workspace: &mut W, first, frequencies: &[f64], mut room: Vec<&mut [Complex64]>| {
        solve(workspace, first, frequencies, &mut room);
    };
    if let Some(room) = (chunks == 1).then(|| rooms.pop()).flatten() {
        Cancelled::check(cancel)?;
        // This thread solves it before another one wakes up.
        solve(&mut W::default(), 0, frequencies, room);
    } else {
        over_chunks(frequencies, chunk, rooms.into_par_iter(), cancel, &solve)?;
    }
    Ok(Frf {
        frequencies: frequencies.to_vec(),
        columns,
    })
}

/// A column for each enabled response of a model, in its order, with zeros.
fn columns(model: &Model, count: usize) -> Vec<Column> {
    let responses = model.responses.iter().filter(|r| r.enabled);
    let column = |response: &Response| Column {
        name: response.name.clone(),
        kind: if response.quantity.is_quadratic() {
            ColumnKind::Energy
        } else {
            ColumnKind::Complex
        },
        values: vec![Complex64::ZERO; count],
    };
    responses.map(column).collect()
}

/// The responses of a model; `solve` writes them for one frequency (Hz) at a time: one value for each enabled response,
/// in the order of the model.
pub(super) fn one_by_one<W: Default + Send>(
    model: &Model,
    frequencies: &[f64],
    cancel: &AtomicBool,
    solve: &(impl Fn(&mut W, f64, &mut [Complex64]) + Sync),
) -> Result<Frf, Cancelled> {
    /// Few, so that a cancelled sweep ends soon.
    const CHUNK: usize = 4;
    let solve = |(workspace, row): &mut (W, Vec<Complex64>),
                 _,
                 frequencies: &[f64],
                 out: &mut [&mut [Complex64]]| {
        row.resize(out.len(), Complex64::ZERO);
        for (index, &frequency) in frequencies.iter().enumerate() {
            solve(workspace, frequency, row);
            for (column, value) in out.iter_mut().zip(&*row) {
                column[index] = *value;
            }
        }
    };
    solved(model, frequencies, CHUNK, cancel, &solve)
}

/// Frequencies per chunk: about a millisecond of work, so that a cancelled sweep ends soon.
pub(super) fn chunk_length(plan: &Plan) -> usize {
    const STATIONS_A_CHUNK: usize = 1000;
    let groups = STATIONS_A_CHUNK / (plan.stations.len() + 1) / MOST_LANES;
    MOST_LANES * groups.clamp(1, 8)
}
