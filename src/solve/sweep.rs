//! Frequency responses over many frequencies, on all cores.

use std::sync::atomic::{AtomicBool, Ordering};

use num_complex::Complex64;
use rayon::prelude::*;

use super::plan::Plan;
use super::recursion::Workspace;
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
    let plan = Plan::new(model);
    over_frequencies(
        model,
        frequencies,
        chunk_length(&plan),
        cancel,
        &|workspace: &mut Workspace, frequency, row| {
            let omega = std::f64::consts::TAU * frequency;
            workspace.solve(&plan, omega.into(), row);
        },
    )
}

/// Collects what `solve` writes for each frequency (Hz): one value for each enabled response, in the order of the model.
///
/// Each core has a workspace of its own and takes `chunk` frequencies at a time; `cancel` is looked at between chunks.
pub(super) fn over_frequencies<W: Default>(
    model: &Model,
    frequencies: &[f64],
    chunk: usize,
    cancel: &AtomicBool,
    solve: &(impl Fn(&mut W, f64, &mut [Complex64]) + Sync),
) -> Option<Frf> {
    let responses = || model.responses.iter().filter(|r| r.enabled);
    let width = responses().count();
    let chunks: Option<Vec<Vec<Complex64>>> = frequencies
        .par_chunks(chunk)
        .map_init(W::default, |workspace, frequencies| {
            (!cancel.load(Ordering::Relaxed))
                .then(|| solve_chunk(workspace, frequencies, width, solve))
        })
        .collect();
    let rows = chunks?.concat();
    let columns = responses().enumerate().map(|(index, response)| Column {
        name: response.name.clone(),
        kind: if response.quantity == Quantity::Energy {
            ColumnKind::Energy
        } else {
            ColumnKind::Complex
        },
        unit: unit(&response.quantity),
        values: rows.iter().skip(index).step_by(width).copied().collect(),
    });
    Some(Frf {
        frequencies: frequencies.to_vec(),
        columns: columns.collect(),
    })
}

/// All responses at some frequencies, a row a frequency.
fn solve_chunk<W>(
    workspace: &mut W,
    frequencies: &[f64],
    width: usize,
    solve: &impl Fn(&mut W, f64, &mut [Complex64]),
) -> Vec<Complex64> {
    let mut rows = vec![Complex64::ZERO; width * frequencies.len()];
    if width > 0 {
        for (&frequency, row) in frequencies.iter().zip(rows.chunks_mut(width)) {
            solve(workspace, frequency, row);
        }
    }
    rows
}

/// Frequencies a chunk: about a millisecond of work, so that a cancelled sweep ends soon.
fn chunk_length(plan: &Plan) -> usize {
    const STATIONS_A_CHUNK: usize = 1000;
    (STATIONS_A_CHUNK / (plan.stations.len() + 1)).clamp(1, 64)
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
