//! An example `[tune]` for a model that has none.

use crate::model::schema::MaterialKey;
use crate::model::{
    self, Aim, Checked, Combine, Group, Hold, Model, Objective, Part, Tune, Variable, path,
};

/// The message for a model without `[tune]`, with an example.
pub(super) fn wanted(label: &str, model: &Checked) -> String {
    format!(
        "{label}: has no [tune], which defines variables and objectives; for example\n\n{}",
        text(model)
    )
}

/// The text of the example.
fn text(model: &Checked) -> String {
    let with = Model {
        tune: Some(tune(model)),
        ..model.clone().into_inner()
    };
    let whole = model::write(&with, "");
    // The last match: notes may contain the text too.
    let start = whole.rfind("[tune]\n").unwrap_or(0);
    whole[start..].trim_end().to_owned()
}

/// One parameter of the model, a decade up and down, and the peak of its first response.
fn tune(model: &Checked) -> Tune {
    let of_first = |key: &str| {
        let all = path::numbers(model, &format!("subsystems.*.{key}")).unwrap_or_default();
        all.into_iter().find(|(_, value)| *value > 0.0)
    };
    let (id, now) = of_first("y_left.stiffness")
        .or_else(|| of_first("mass"))
        .unwrap_or_else(|| {
            let row = MaterialKey::YoungModulus as usize;
            let of = |part: Part| {
                let modulus = part.material(model)?.young_modulus;
                Some((Group::Material(part).parameter(row), modulus))
            };
            // Either the beam or each of its spans has a material.
            let first = Part::all(model).find_map(of);
            first.unwrap_or((Group::Material(Part::Whole).parameter(row), 0.0))
        });
    let response = model.responses.iter().find(|response| response.enabled);
    let aim = response.map_or(Aim::Energy, |_| Aim::Peak);
    Tune {
        variables: vec![Variable {
            paths: vec![path::text(model, id).into()],
            hold: Hold::Equal,
            min: now / 10.0,
            max: now * 10.0,
            scale: None,
            tolerance: 0.0,
        }],
        objectives: vec![Objective {
            aim,
            response: response.map(|response| response.name.clone()),
            from: model.sweep.from,
            to: model.sweep.to,
            weight: 1.0,
        }],
        combine: Combine::Sum,
        limits: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::checked;

    /// The example can be appended to any model that has no `[tune]`.
    #[test]
    fn the_example_does_for_every_preset() {
        for preset in crate::presets::ALL {
            let model = model::read(preset.text).unwrap().into_inner();
            if model.tune.is_none() {
                let with = format!("{}\n{}\n", preset.text, text(&checked(&model)));
                let found =
                    model::read(&with).unwrap_or_else(|faults| panic!("{faults:?}\n{with}"));
                assert!(found.tune.is_some(), "{}", preset.name);
            }
        }
    }
}
