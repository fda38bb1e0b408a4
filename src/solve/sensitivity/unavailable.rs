//! Why a table of sensitivities has empty cells.

use super::{Figure, Sensitivity};
use crate::model::Checked;
use crate::solve::sweep_alone;

/// Explains why some of the sensitivities of a figure are unknown; `None` if all are known.
pub fn unavailable(model: &Checked, figure: &Figure, found: &[Sensitivity]) -> Option<String> {
    let empty = found.iter().filter(|one| has_empty_cell(figure, one));
    let (empty, all) = (empty.count(), found.len());
    if empty == 0 {
        return None;
    }
    Some(if empty == all {
        reason(model, figure)
    } else {
        format!("no effect of {empty} of {all} parameters: derivatives not finite")
    })
}

/// Whether a value of a figure is missing for a parameter.
fn has_empty_cell(figure: &Figure, one: &Sensitivity) -> bool {
    match figure {
        Figure::Level { .. } | Figure::Band { .. } => one.level.is_none(),
        Figure::Peak { .. } => one.level.is_none() || one.frequency.is_none(),
        Figure::Mode { .. } => one.frequency.is_none() || one.damping_ratio.is_none(),
    }
}

/// Why all sensitivities of a figure are unknown.
fn reason(model: &Checked, figure: &Figure) -> String {
    match figure {
        Figure::Level {
            response,
            frequency,
        } => {
            let solved = sweep_alone(model, &[*frequency]);
            let value = solved.columns.get(*response).map(|column| column.values[0]);
            let value = value.unwrap_or_default();
            if value.norm() == 0.0 {
                format!("the response is 0 at {frequency:?} Hz, which is no level in dB")
            } else if value.is_finite() {
                format!("its derivatives are not finite at {frequency:?} Hz")
            } else {
                format!(
                    "the response is not finite at {frequency:?} Hz: the model is undamped and at a resonance, or the \
                     numbers are beyond the range of the arithmetic"
                )
            }
        }
        Figure::Peak { frequency, .. } => format!(
            "the peak at {frequency:?} Hz has no series about it: too little damping, or another peak or dip too near"
        ),
        Figure::Mode { .. } => "the derivatives of the mode are not finite".to_owned(),
        Figure::Band { band, .. } => format!(
            "the mean square from {:?} to {:?} Hz is 0 or not finite",
            band[0], band[1]
        ),
    }
}

#[cfg(test)]
mod tests {
    use crate::model::checked;
    use std::sync::atomic::AtomicBool;

    use super::*;
    use crate::solve::sensitivity::effects;

    fn words(figure: &Figure) -> Option<String> {
        let text = crate::presets::find("cantilever").unwrap().text;
        let model = crate::model::read(text).unwrap().into_inner();
        let found = effects(&checked(&model), figure, &AtomicBool::new(false)).unwrap();
        unavailable(&checked(&model), figure, &found)
    }

    #[test]
    fn empty_cells_have_a_reason_and_full_ones_none() {
        let level = |frequency| Figure::Level {
            response: 0,
            frequency,
        };
        assert_eq!(words(&level(20.0)), None);
        let beyond = words(&level(1e308)).unwrap();
        assert!(beyond.contains("not finite at 1e308 Hz"), "{beyond}");
        // Far below the first resonance the response only increases.
        let no_peak = words(&Figure::Peak {
            response: 0,
            frequency: 0.5,
        });
        assert!(
            no_peak
                .unwrap()
                .contains("the peak at 0.5 Hz has no series")
        );
    }

    #[test]
    fn some_empty_cells_are_counted() {
        let row = |level| Sensitivity {
            id: crate::model::ParameterId::TITLE,
            level,
            frequency: None,
            damping_ratio: None,
        };
        let text = crate::presets::find("cantilever").unwrap().text;
        let model = crate::model::read(text).unwrap().into_inner();
        let figure = Figure::Level {
            response: 0,
            frequency: 20.0,
        };
        let told = unavailable(&checked(&model), &figure, &[row(Some(1.0)), row(None)]).unwrap();
        assert!(told.starts_with("no effect of 1 of 2 parameters"), "{told}");
    }
}
