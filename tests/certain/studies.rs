//! Lists of modes of every preset and every member of every study, with a tenth to a hundred times their damping.

use beamtune::model::{self, Family, Model, Restraint, Theory, edit};
use beamtune::presets;
use rayon::prelude::*;

use super::{certain_and_right, report};

/// Factors of every damper and of the loss factor.
const DAMPING: [f64; 4] = [0.1, 1.0, 10.0, 100.0];

/// By default one of this many models is checked, with each factor in turn; `MODES_STUDIES` sets another share: 1 is
/// all, some minutes.
const SAMPLE: usize = 17;

/// Expected: the judge counts what is listed, group by group and as a whole.
#[test]
fn lists_of_presets_and_their_studies_are_right() {
    let share = std::env::var("MODES_STUDIES").map_or(SAMPLE, |share| share.parse().unwrap());
    let models = presets::ALL.iter().flat_map(members);
    let models: Vec<(String, Model)> = models.filter(|(_, model)| is_judged(model)).collect();
    assert!(models.len() > 300, "{}", models.len());
    let verdicts = models
        .into_par_iter()
        .step_by(share)
        .map(|(name, model)| (name, certain_and_right(&model, model.sweep.to)))
        .collect();
    let (wrong, open) = report(verdicts);
    assert!(wrong.is_empty(), "{wrong:?}");
    assert!(open.is_empty(), "{open:?}");
}

/// Whether the judge knows the beam: one of the paper's, with warping stiffness.
fn is_judged(model: &Model) -> bool {
    let beam = &model.beam;
    let section = &beam.section;
    model.spans.is_empty()
        && section.warping_constant > 0.0
        && section.product_moment == 0.0
        && section.centroid_offset_y == 0.0
        && beam.axial_force == 0.0
        && beam.theory == Theory::EulerBernoulli
}

/// A preset and the members of its studies, each with all factors of damping.
fn members(preset: &presets::Preset) -> Vec<(String, Model)> {
    let model = model::read(preset.text).unwrap().into_inner();
    let mut members = vec![(preset.name.to_owned(), model.clone())];
    for study in &model.studies {
        let count = match &study.family {
            Family::Vary { values, .. } => values.len(),
            Family::Cases(cases) => cases.len(),
        };
        for index in 0..count {
            let member = edit::apply(&model, &study.family, index).unwrap();
            members.push((
                format!("{}, {} {index}", preset.name, study.name),
                member.into_inner(),
            ));
        }
    }
    let times = |(name, model): (String, Model)| {
        DAMPING.map(|factor| {
            (
                format!("{name}, damping x {factor}"),
                damped(&model, factor),
            )
        })
    };
    members.into_iter().flat_map(times).collect()
}

/// A model with all of its damping times a factor.
fn damped(model: &Model, factor: f64) -> Model {
    let mut model = model.clone();
    model.beam.material.loss_factor *= factor;
    for support in [&mut model.supports.left, &mut model.supports.right] {
        for restraint in &mut support.restraints {
            if let Restraint::Elastic(elastic) = restraint {
                elastic.spring.damping *= factor;
            }
        }
    }
    for subsystem in &mut model.subsystems {
        for spring in [
            &mut subsystem.y_left,
            &mut subsystem.y_right,
            &mut subsystem.z_left,
            &mut subsystem.z_right,
        ] {
            spring.damping *= factor;
        }
    }
    model
}
