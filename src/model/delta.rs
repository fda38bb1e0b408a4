//! The difference of two models as one line of text, whose length depends only on what changed.
//!
//! ```toml
//! edit = {at = [[0, 0], [17, 1], [0, 0], [0, 0], [0, 0], [0, 0]], model = {.., subsystems = [{name = "S17", ..}]}}
//! ```
//!
//! `at` has the first index and the number of replaced elements of joints, subsystems, forces, responses, studies and
//! `[tune]` (a list of one or none). `model` has the new elements and all parts that are not lists.

use super::types::Model;
use super::{read, write};
use toml::de::{DeTable, DeValue};

/// First index and number of replaced elements.
type Span = [usize; 2];

/// The number of lists.
const SPANS: usize = 6;

/// The line that changes one model to another, without a line end.
pub fn delta(before: &Model, after: &Model) -> String {
    let mut spans = Vec::new();
    let part = Model {
        title: after.title.clone(),
        notes: after.notes.clone(),
        beam: after.beam,
        spans: after.spans.clone(),
        supports: after.supports.clone(),
        sweep: after.sweep,
        joints: replaced(&before.joints, &after.joints, &mut spans),
        subsystems: replaced(&before.subsystems, &after.subsystems, &mut spans),
        forces: replaced(&before.forces, &after.forces, &mut spans),
        responses: replaced(&before.responses, &after.responses, &mut spans),
        studies: replaced(&before.studies, &after.studies, &mut spans),
        tune: replaced(before.tune.as_slice(), after.tune.as_slice(), &mut spans).pop(),
    };
    let spans = spans
        .iter()
        .map(|[first, count]| format!("[{first}, {count}]"));
    let spans: Vec<String> = spans.collect();
    let part = write::one_line(&part);
    format!("edit = {{at = [{}], model = {part}}}", spans.join(", "))
}

/// The elements between the first and the last difference; sets `span` to their range.
fn replaced<T: PartialEq + Clone>(before: &[T], after: &[T], spans: &mut Vec<Span>) -> Vec<T> {
    let pairs = before.iter().zip(after);
    let start = pairs.take_while(|(one, other)| one == other).count();
    let (old, new) = (&before[start..], &after[start..]);
    let pairs = old.iter().rev().zip(new.iter().rev());
    let end = pairs.take_while(|(one, other)| one == other).count();
    spans.push([start, old.len() - end]);
    new[..new.len() - end].to_vec()
}

/// Applies a line of [`delta`] to the model that it was made from. Returns false if the line is invalid or of another
/// model; the model is then unchanged.
pub fn apply_delta(model: &mut Model, line: &str) -> bool {
    parse(model, line).is_some_and(|(spans, part)| apply(model, spans, part))
}

fn parse(model: &Model, line: &str) -> Option<([Span; SPANS], Model)> {
    let document = DeTable::parse(line).ok()?;
    let edit = document.get_ref().get("edit")?.get_ref().as_table()?;
    let spans = edit.get("at")?.get_ref().as_array()?;
    let spans: Option<Vec<Span>> = spans
        .iter()
        .map(|span| self::span(span.get_ref()))
        .collect();
    let names = model.subsystems.iter().map(|one| one.name.as_str());
    let part = edit.get("model")?.get_ref().as_table()?;
    let part = read::part(part, &names.collect::<Vec<_>>())?;
    Some((spans?.try_into().ok()?, part))
}

fn span(value: &DeValue<'_>) -> Option<Span> {
    let number = |value: &DeValue<'_>| value.as_integer()?.as_str().parse().ok();
    match &value.as_array()?.iter().collect::<Vec<_>>()[..] {
        [first, count] => Some([number(first.get_ref())?, number(count.get_ref())?]),
        _ => None,
    }
}

fn apply(model: &mut Model, spans: [Span; SPANS], part: Model) -> bool {
    let lengths = [
        model.joints.len(),
        model.subsystems.len(),
        model.forces.len(),
        model.responses.len(),
        model.studies.len(),
        model.tune.as_slice().len(),
    ];
    let fits = |(&[first, count], length): (&Span, usize)| {
        first.checked_add(count).is_some_and(|end| end <= length)
    };
    if !spans.iter().zip(lengths).all(fits) {
        return false;
    }
    let [joints, subsystems, forces, responses, studies, tune] =
        spans.map(|[first, count]| first..first + count);
    model.joints.splice(joints, part.joints);
    model.subsystems.splice(subsystems, part.subsystems);
    model.forces.splice(forces, part.forces);
    model.responses.splice(responses, part.responses);
    model.studies.splice(studies, part.studies);
    if part.tune.is_some() || !tune.is_empty() {
        model.tune = part.tune;
    }
    model.title = part.title;
    model.notes = part.notes;
    model.beam = part.beam;
    model.spans = part.spans;
    model.supports = part.supports;
    model.sweep = part.sweep;
    true
}

#[cfg(test)]
mod tests {
    use super::super::beam::BeamMotion;
    use super::super::path::sample;
    use super::super::spring::{Elastic, Spring};
    use super::super::types::{Link, Restraint, Support};
    use super::*;
    use crate::presets;

    /// `Debug` distinguishes any two floats, also 0.0 and -0.0.
    fn bits(model: &Model) -> String {
        format!("{model:#?}")
    }

    /// Each model from the one before, and back.
    fn returns(models: &[Model]) {
        let back = models.iter().rev();
        let path: Vec<&Model> = models.iter().chain(back).collect();
        let mut model = path[0].clone();
        for pair in path.windows(2) {
            let line = delta(pair[0], pair[1]);
            assert!(!line.contains('\n'), "{line}");
            assert!(apply_delta(&mut model, &line), "{line}");
            assert_eq!(bits(&model), bits(pair[1]), "{line}");
        }
    }

    fn changed(model: &Model, change: impl FnOnce(&mut Model)) -> Model {
        let mut model = model.clone();
        change(&mut model);
        model
    }

    #[test]
    fn every_preset_becomes_every_other() {
        let models = presets::ALL.iter();
        let models: Vec<Model> = models
            .map(|one| read::read(one.text).unwrap().into_inner())
            .collect();
        returns(&models);
    }

    #[test]
    fn every_kind_of_edit_comes_back() {
        let model = sample::model(&["S1", "left \"2\"", "a.b", "S4"]);
        assert!(model.tune.is_some() && !model.studies.is_empty());
        let held = Restraint::Elastic(Elastic::default());
        let models = vec![
            model.clone(),
            changed(&model, |model| model.subsystems[2].mass = 0.1 + 0.2),
            changed(&model, |model| {
                model
                    .subsystems
                    .iter_mut()
                    .for_each(|one| one.mass = 1e-300);
            }),
            changed(&model, |model| drop(model.subsystems.remove(1))),
            changed(&model, |model| {
                model.subsystems.insert(0, model.subsystems[3].clone());
            }),
            changed(&model, |model| model.subsystems.swap(0, 3)),
            changed(&model, |model| model.subsystems.clear()),
            changed(&model, |model| {
                model.joints.pop();
            }),
            changed(&model, |model| {
                model.joints[0][BeamMotion::V] = Link::Elastic(Spring::default());
            }),
            changed(&model, |model| super::super::edit::split(model, 0)),
            sample::models(&["S1"])[1].clone(),
            changed(&model, |model| drop(model.forces.pop())),
            changed(&model, |model| model.responses.rotate_left(1)),
            changed(&model, |model| model.studies.clear()),
            changed(&model, |model| model.tune = None),
            changed(&model, |model| {
                model.tune.as_mut().unwrap().variables[0].min = 7.5;
            }),
            changed(&model, |model| {
                model.title = "\r\n\t\0 \"\\ é\u{2028}".to_owned();
            }),
            changed(&model, |model| {
                model.notes = "one\n# edit = {}\n'''".to_owned();
            }),
            changed(&model, |model| model.supports.left[BeamMotion::W] = held),
            changed(&model, |model| model.supports.right = Support::CLAMPED),
            changed(&model, |model| model.sweep.points += 1),
        ];
        returns(&models);
    }

    #[test]
    fn a_load_on_a_mass_that_did_not_change_is_on_that_mass() {
        let model = read::read(presets::find("fig08").unwrap().text)
            .unwrap()
            .into_inner();
        let name = model.subsystems[0].name.clone();
        let loaded = changed(&model, |model| {
            let motion = super::super::types::MassMotion::Theta;
            model.forces[0].target = super::super::types::Target::Mass(name, motion);
        });
        returns(&[model, loaded]);
    }

    #[test]
    fn one_of_a_thousand_is_one_line_of_its_size() {
        let names: Vec<String> = (0..1000).map(|index| format!("S{index}")).collect();
        let mut model = sample::model(&names.iter().map(String::as_str).collect::<Vec<_>>());
        (model.studies, model.tune) = (Vec::new(), None);
        let other = changed(&model, |model| model.subsystems[500].mass *= 1.01);
        assert!(delta(&model, &other).len() < 3000);
    }

    #[test]
    fn what_is_no_edit_of_this_model_changes_nothing() {
        let model = sample::model(&["S1", "S2", "S3"]);
        let fewer = changed(&model, |model| model.subsystems.truncate(1));
        let line = delta(
            &model,
            &changed(&model, |model| model.subsystems[2].mass = 3.0),
        );
        let mut same = fewer.clone();
        assert!(!apply_delta(&mut same, &line));
        for end in (0..line.len()).filter(|end| line.is_char_boundary(*end)) {
            assert!(!apply_delta(&mut same, &line[..end]), "cut after {end}");
        }
        for bad in [
            "",
            "edit = 3",
            "edit = {at = [], model = {}}",
            &line.replace("[2, 1]", "[18446744073709551615, 1]"),
            &line.replace("[2, 1]", "[2]"),
            &line.replace("mass", "mess"),
            &line.replace("edit", "# edit"),
        ] {
            assert!(!apply_delta(&mut same, bad), "{bad}");
        }
        assert_eq!(same, fewer);
    }
}
