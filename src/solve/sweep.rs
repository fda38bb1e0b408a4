//! Frequency responses over many frequencies, on all cores.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use num_complex::Complex64;
use rayon::prelude::*;

use super::lanes::{Prepared, Solver, WIDTH};
use super::plan::Plan;
use crate::model::{BeamMotion, MassMotion, Measure, Model, Quantity, Spacing, Sweep, Target};

/// Frequency responses of a model: one column for each enabled response, one value for each frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Frf {
    /// Hz, rising.
    pub frequencies: Vec<f64>,
    /// In the order of the model's enabled responses.
    pub columns: Vec<Column>,
}

/// One response over all frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// The response's name.
    pub name: String,
    /// What its values are.
    pub kind: ColumnKind,
    /// Unit of the values, for the loads as they are given.
    pub unit: &'static str,
    /// As many as frequencies; an energy has no imaginary part.
    pub values: Vec<Complex64>,
}

/// What the values of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnKind {
    /// A complex amplitude, zero to peak.
    Complex,
    /// The vibration energy, real.
    Energy,
}

impl Frf {
    /// The frequencies (Hz) at which some response is not finite: an undamped model exactly at a resonance.
    pub fn singular(&self) -> Vec<f64> {
        let finite = |index: usize| {
            self.columns
                .iter()
                .all(|column| column.values[index].is_finite())
        };
        self.frequencies
            .iter()
            .enumerate()
            .filter(|(index, _)| !finite(*index))
            .map(|(_, &f)| f)
            .collect()
    }
}

impl Frf {
    /// The rows of two responses of the same model, by rising frequency.
    #[must_use]
    pub fn merged(&self, other: &Self) -> Self {
        let split = self.frequencies.len();
        let both = [&self.frequencies[..], &other.frequencies].concat();
        let mut order: Vec<usize> = (0..both.len()).collect();
        // Stable, and fast on two rising runs.
        order.sort_by(|&a, &b| both[a].total_cmp(&both[b]));
        let columns = self.columns.iter().zip(&other.columns);
        let columns = columns.map(|(one, other)| Column {
            name: one.name.clone(),
            kind: one.kind,
            unit: one.unit,
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

/// Solves a checked model at each frequency (Hz, > 0). `None` where `cancel` became true before the end.
///
/// The work is shared among all cores in chunks; `cancel` is looked at between chunks.
pub fn sweep(model: &Model, frequencies: &[f64], cancel: &AtomicBool) -> Option<Frf> {
    let prepared = Prepared::new(Plan::new(model));
    sweep_prepared(model, &prepared, frequencies, cancel)
}

/// [`sweep`] of a model that has been laid out.
pub(super) fn sweep_prepared(
    model: &Model,
    prepared: &Prepared,
    frequencies: &[f64],
    cancel: &AtomicBool,
) -> Option<Frf> {
    let chunk = chunk_length(&prepared.plan);
    let solve = |solver: &mut Solver, _, frequencies: &[f64]| solver.solve(prepared, frequencies);
    let rows = over_chunks(frequencies, chunk, cancel, &solve)?;
    Some(collected(model, frequencies, &rows))
}

/// What `solve` makes of each chunk of frequencies (Hz); none where `cancel` became true before the
/// end.
///
/// It is told the chunk and the place of its first frequency. Chunks that follow each other on a core use the same
/// workspace.
pub(super) fn over_chunks<W: Default + Send, T: Send>(
    frequencies: &[f64],
    chunk: usize,
    cancel: &AtomicBool,
    solve: &(impl Fn(&mut W, usize, &[f64]) -> Vec<T> + Sync),
) -> Option<Vec<Vec<T>>> {
    let idle: Mutex<Vec<W>> = Mutex::default();
    let lock = || idle.lock().unwrap_or_else(PoisonError::into_inner);
    frequencies
        .par_chunks(chunk)
        .enumerate()
        .map(|(index, frequencies)| {
            if cancel.load(Ordering::Relaxed) {
                return None;
            }
            let mut workspace = lock().pop().unwrap_or_default();
            let solved = solve(&mut workspace, index * chunk, frequencies);
            lock().push(workspace);
            Some(solved)
        })
        .collect()
}

/// The responses of a model from chunks of rows of one value for each enabled response, in the order of the model.
pub(super) fn collected(model: &Model, frequencies: &[f64], chunks: &[Vec<Complex64>]) -> Frf {
    let responses = || model.responses.iter().filter(|r| r.enabled);
    let width = responses().count();
    let columns = responses().enumerate().map(|(index, response)| Column {
        name: response.name.clone(),
        kind: if response.quantity == Quantity::Energy {
            ColumnKind::Energy
        } else {
            ColumnKind::Complex
        },
        unit: unit(&response.quantity),
        values: values(chunks, index, width, frequencies.len()),
    });
    Frf {
        frequencies: frequencies.to_vec(),
        columns: columns.collect(),
    }
}

/// One response out of chunks of rows.
fn values(chunks: &[Vec<Complex64>], index: usize, width: usize, count: usize) -> Vec<Complex64> {
    let mut values = Vec::with_capacity(count);
    for rows in chunks {
        values.extend(rows.chunks_exact(width).map(|row| row[index]));
    }
    values
}

/// The responses of a model, which `solve` writes for a frequency (Hz) at a time: one value for each enabled response, in
/// the order of the model.
pub(super) fn one_by_one<W: Default + Send>(
    model: &Model,
    frequencies: &[f64],
    cancel: &AtomicBool,
    solve: &(impl Fn(&mut W, f64, &mut [Complex64]) + Sync),
) -> Option<Frf> {
    let width = model.responses.iter().filter(|r| r.enabled).count();
    let solve = |workspace: &mut W, _, frequencies: &[f64]| {
        let mut row = vec![Complex64::ZERO; width];
        for &frequency in frequencies {
            solve(workspace, frequency, &mut row);
        }
        row
    };
    let rows = over_chunks(frequencies, 1, cancel, &solve)?;
    Some(collected(model, frequencies, &rows))
}

/// Frequencies a chunk: about a millisecond of work, so that a cancelled sweep ends soon.
pub(super) fn chunk_length(plan: &Plan) -> usize {
    const STATIONS_A_CHUNK: usize = 1000;
    let groups = STATIONS_A_CHUNK / (plan.stations.len() + 1) / WIDTH;
    WIDTH * groups.clamp(1, 16)
}

/// The unit of a response's values.
fn unit(quantity: &Quantity) -> &'static str {
    let Quantity::Motion(target, measure) = quantity else {
        return "kg m2";
    };
    let units = match target {
        Target::Beam(_, BeamMotion::W | BeamMotion::V)
        | Target::Mass(_, MassMotion::Y | MassMotion::Z) => ["m", "m/s", "m/s2"],
        Target::Beam(_, BeamMotion::PsiSlope) => ["rad/m", "rad/(m s)", "rad/(m s2)"],
        Target::Beam(..) | Target::Mass(_, MassMotion::Theta) => ["rad", "rad/s", "rad/s2"],
    };
    match measure {
        Measure::Displacement => units[0],
        Measure::Velocity => units[1],
        Measure::Acceleration => units[2],
    }
}
