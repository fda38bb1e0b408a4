//! The finite-element witness of the curves.

use std::sync::atomic::AtomicBool;

use super::lane::guarded;
use super::members::members;
use super::{Difference, Subject, WitnessAnswer, WitnessMember};
use crate::solve::fem::{FiniteElements, default_elements};
use crate::solve::{Column, ColumnKind, Frf, frequencies, sweep};

/// The curves of a finite-element model of each member, held against the exact ones; none where cancelled.
pub(super) fn answer(subject: &Subject, cancel: &AtomicBool) -> Option<WitnessAnswer> {
    let result = guarded(|| {
        let Some(members) = members(subject, cancel)? else {
            return Ok(None);
        };
        let solved = members.into_iter().map(|(_, model)| {
            let frequencies = frequencies(&model.sweep);
            let mesh = FiniteElements::new(&model, default_elements(&model));
            let frf = mesh.sweep(&frequencies, cancel)?;
            let exact = sweep(&model, &frequencies, cancel)?;
            Some(WitnessMember {
                elements: mesh.elements(),
                differences: differences(&frf, &exact),
                frf,
            })
        });
        Ok(solved.collect::<Option<Vec<_>>>())
    })?;
    Some(WitnessAnswer {
        generation: subject.generation,
        result,
    })
}

/// The largest difference of each response.
fn differences(frf: &Frf, exact: &Frf) -> Vec<Option<Difference>> {
    let columns = frf.columns.iter().zip(&exact.columns);
    columns
        .map(|(column, exact)| largest(&frf.frequencies, column, exact))
        .collect()
}

fn largest(frequencies: &[f64], column: &Column, exact: &Column) -> Option<Difference> {
    // Ten decibels are a decade of an energy, twenty one of an amplitude.
    let factor = match column.kind {
        ColumnKind::Energy => 10.0,
        ColumnKind::Complex => 20.0,
    };
    let values = column.values.iter().zip(&exact.values);
    let all = frequencies.iter().zip(values).map(|(&frequency, (a, b))| {
        let decibels = factor * (a.norm() / b.norm()).log10().abs();
        Difference {
            decibels,
            frequency,
        }
    });
    all.filter(|difference| difference.decibels.is_finite())
        .max_by(|a, b| a.decibels.total_cmp(&b.decibels))
}
