//! The finite-element witness of the curves.

use std::sync::atomic::AtomicBool;

use super::lane::guarded;
use super::members::members;
use super::{Difference, Subject, WitnessAnswer, WitnessMember};
use crate::model::Checked;
use crate::solve::compare::differences;
use crate::solve::fem::{FiniteElements, default_elements};
use crate::solve::{Cancelled, Frf, frequencies, sweep};

/// The curves of a finite-element model of each member, held against the exact ones.
pub(super) fn answer(subject: &Subject, cancel: &AtomicBool) -> Result<WitnessAnswer, Cancelled> {
    let result = guarded(|| {
        let members = members(subject, cancel)?.into_iter();
        let solved = members.map(|(_, model)| {
            let frequencies = frequencies(&model.sweep);
            let mesh = FiniteElements::new(&model, default_elements(&model));
            let frf = mesh.sweep(&frequencies, cancel)?;
            let exact = sweep(&model, &frequencies, cancel)?;
            Ok(WitnessMember {
                elements: mesh.elements(),
                differences: largest(&model, &exact, &frf),
                frf,
            })
        });
        solved.collect()
    })?;
    Ok(WitnessAnswer {
        generation: subject.generation,
        result,
    })
}

/// The largest difference of each response, dB.
fn largest(model: &Checked, exact: &Frf, other: &Frf) -> Vec<Option<Difference>> {
    let columns = differences(model, exact, other).into_iter();
    columns
        .map(|column| {
            let places = exact.frequencies.iter().zip(column);
            let all = places.filter_map(|(&frequency, difference)| {
                Some(Difference {
                    decibels: difference?.decibels,
                    frequency,
                })
            });
            all.filter(|difference| difference.decibels.is_finite())
                .max_by(|a, b| a.decibels.total_cmp(&b.decibels))
        })
        .collect()
}
