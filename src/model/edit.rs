//! All changes of a model, with a check that the result is possible.

mod family;
mod rename;
mod target;
mod value;
mod variable;

pub use family::{apply, apply_unchecked, family_keys, family_labels};
pub(super) use target::Placed;
pub use target::at_of;
pub use value::{Value, get, names, number, put};

use super::beam::Span;
use super::check::Checked;
use super::fault::Fault;
use super::id::{Group, ParameterId, SupportId};
use super::path::{self, Pattern};
use super::types::Model;
use std::cmp::Ordering;
use std::mem::discriminant;

/// The model with another value of a parameter, if that is possible.
///
/// # Errors
/// The value is of another type, or [`check()`](super::check()) finds faults in the result.
pub fn changed(model: &Model, id: ParameterId, value: Value) -> Result<Checked, Vec<Fault>> {
    let mut changed = model.clone();
    put(&mut changed, id, value)
        .map_err(|message| vec![Fault::new(path::text(model, id), message)])?;
    Checked::new(changed)
}

/// Divides a span in half, or a uniform beam in two spans; the length of the beam stays.
pub fn split(model: &mut Model, index: usize) {
    let length = model.length();
    if model.spans.is_empty() {
        model.beam.length = 0.0;
        model.spans.push(Span {
            length,
            ..Span::default()
        });
    }
    let mut half = model.spans[index];
    half.length *= 0.5;
    model.spans.splice(index..=index, [half, half]);
    restore_length(model, length);
}

/// Gives the length of a span to its neighbour; the last one left becomes the uniform beam.
fn remove_span(model: &mut Model, index: usize) {
    let length = model.length();
    let removed = model.spans.remove(index);
    match model.spans.get_mut(index.saturating_sub(1)) {
        Some(neighbour) => neighbour.length = without_rounding(neighbour.length + removed.length),
        None => model.beam = removed.beam(&model.beam),
    }
    restore_length(model, length);
}

/// A sum without the digits that its rounding adds: 1.6 + 0.8 as 2.4.
fn without_rounding(sum: f64) -> f64 {
    format!("{sum:.14e}").parse().unwrap_or(sum)
}

/// Corrects the last digit of the sum of the spans, so that what is at the right end stays on the beam.
fn restore_length(model: &mut Model, length: f64) {
    let rest = length - model.length();
    if let Some(last) = model.spans.last_mut() {
        last.length += rest;
    }
}

/// Removes an element from its list. The length of a span goes to its neighbour.
pub fn remove(model: &mut Model, element: Group) {
    match element {
        Group::Span(i) => remove_span(model, i),
        Group::Support(SupportId::Inner(i)) => drop(model.supports.inner.remove(i)),
        Group::Joint(i) => {
            model.joints.remove(i);
        }
        Group::Subsystem(i) => drop(model.subsystems.remove(i)),
        Group::Branch(spring, i) => {
            if let Some(spring) = spring.spring_mut(model) {
                spring.maxwell.remove(i);
            }
        }
        Group::Force(i) => drop(model.forces.remove(i)),
        Group::Response(i) => drop(model.responses.remove(i)),
        Group::Study(i) => drop(model.studies.remove(i)),
        _ => {}
    }
}

/// The first study or variable with a path that matches other parameters, or none, after the removal of an element.
pub fn misled(before: &Model, after: &Model, removed: Group) -> Option<Group> {
    // Elements after the removed one move up by one.
    let same_list = |group: Group| discriminant(&group.owner()) == discriminant(&removed);
    let moved = |id: ParameterId| {
        let (order, group) = match (id.group, removed) {
            (Group::Branch(spring, own), Group::Branch(other, there)) if spring == other => {
                let up = own.saturating_sub(1);
                (own.cmp(&there), Group::Branch(spring, up))
            }
            (group, _) if same_list(group) => {
                let up = group.place()?.saturating_sub(1);
                (group.place().cmp(&removed.place()), group.at(up))
            }
            _ => return Some(id),
        };
        match order {
            Ordering::Less => Some(id),
            Ordering::Equal => None,
            Ordering::Greater => Some(group.parameter(id.row)),
        }
    };
    let is_misled = |pattern: &Pattern| {
        let same = |old: Vec<ParameterId>, new: Vec<ParameterId>| {
            new.into_iter().eq(old.into_iter().filter_map(moved))
        };
        match (pattern.parameters(before), pattern.parameters(after)) {
            (Ok(old), Ok(new)) => !same(old, new),
            (Ok(_), Err(_)) => true,
            (Err(_), _) => false,
        }
    };
    let mut studies = before.studies.iter();
    let study = studies.position(|study| study.family.patterns().any(is_misled));
    study.map(Group::Study).or_else(|| {
        let mut variables = before.tune.iter().flat_map(|tune| &tune.variables);
        let variable = variables.position(|variable| variable.paths.iter().any(is_misled));
        variable.map(Group::Variable)
    })
}

/// Sets every parameter that a path or pattern matches, if the result is possible.
///
/// # Errors
/// The path matches nothing, the value is of another type, or [`check()`](super::check()) finds faults in the result. The model is then
/// unchanged.
pub fn set(model: &mut Model, pattern: &str, value: Value) -> Result<(), Vec<Fault>> {
    let mut changed = model.clone();
    set_unchecked(&mut changed, pattern, value).map_err(|fault| vec![fault])?;
    *model = Checked::new(changed)?.into_inner();
    Ok(())
}

/// Sets every parameter that a path or pattern matches, without a check of the result.
///
/// # Errors
/// The path matches nothing, or the value is of another type than the parameter. The model is then unchanged.
pub fn set_unchecked(model: &mut Model, pattern: &str, value: Value) -> Result<(), Fault> {
    let found = path::find(model, pattern)?;
    if let [id] = found[..] {
        return put(model, id, value).map_err(|message| Fault::new(pattern, message));
    }
    let mut changed = model.clone();
    for id in found {
        put(&mut changed, id, value.clone())
            .map_err(|message| Fault::new(path::text(model, id), message))?;
    }
    *model = changed;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::beam::Beam;
    use super::super::types::{Case, Family, Operation, Study};
    use super::*;
    use crate::model::check;
    use crate::model::path::{all, number, numbers, parameter, sample};
    use crate::model::schema::SubsystemKey;
    use std::time::{Duration, Instant};

    /// The study or variable that [`misled`] reports after the removal of a subsystem of three.
    fn misled_by(removed: usize, pattern: &str) -> Option<Group> {
        let mut model = sample::model(&["S1", "a.b", "S3"]);
        model.tune = None;
        model.studies = vec![Study {
            name: "only".to_owned(),
            family: Family::Vary {
                paths: vec!["beam.length".into(), pattern.into()],
                operation: Operation::Multiply,
                values: vec![1.0],
            },
        }];
        let mut after = model.clone();
        remove(&mut after, Group::Subsystem(removed));
        misled(&model, &after, Group::Subsystem(removed))
    }

    /// Expected: a path is misled if it matches other parameters, or none, after the removal. A name in unnecessary or
    /// single quotes is the same name.
    #[test]
    fn paths_that_lead_elsewhere_are_found() {
        let study = Some(Group::Study(0));
        for pattern in [
            "subsystems.S1.mass",
            "subsystems.\"S1\".mass",
            "subsystems.1.mass",
            "subsystems.3.mass",
        ] {
            assert_eq!(misled_by(0, pattern), study, "{pattern}");
        }
        for pattern in [
            "subsystems.S3.mass",
            "subsystems.*.mass",
            "subsystems.'a.b'.mass",
        ] {
            assert_eq!(misled_by(0, pattern), None, "{pattern}");
        }
        assert_eq!(misled_by(1, "subsystems.'a.b'.mass"), study);
        let mut model = sample::model(&["S1"]);
        model.tune = None;
        let family = Family::Vary {
            paths: vec!["supports.inner.B1.w.stiffness".into()],
            operation: Operation::Multiply,
            values: vec![1.0],
        };
        model.studies = vec![Study {
            name: "only".to_owned(),
            family,
        }];
        let mut after = model.clone();
        let bearing = Group::Support(SupportId::Inner(0));
        remove(&mut after, bearing);
        assert_eq!(misled(&model, &after, bearing), study);
        assert_eq!(misled_by(2, "subsystems.1.mass"), None);
        // The supports and joints do not move when a subsystem is removed.
        assert_eq!(misled_by(2, "supports.right.w.stiffness"), None);
        assert_eq!(misled_by(0, "joints.2.psi.stiffness"), None);
        // A number of a joint is that of another one after the removal, as for any list.
        let mut model = sample::model(&["S1"]);
        (model.studies, model.tune) = (Vec::new(), None);
        model.studies = vec![Study {
            name: "only".to_owned(),
            family: Family::Vary {
                paths: vec!["joints.2.psi.stiffness".into()],
                operation: Operation::Multiply,
                values: vec![1.0],
            },
        }];
        let mut after = model.clone();
        remove(&mut after, Group::Joint(0));
        assert_eq!(misled(&model, &after, Group::Joint(0)), study);
        let mut model = sample::model(&["S1"]);
        model.studies.clear();
        let mut after = model.clone();
        after.subsystems.clear();
        let variable = misled(&model, &after, Group::Subsystem(0));
        assert_eq!(variable, Some(Group::Variable(0)));
    }

    /// The lengths 0.1, 0.2 and 0.3 do not add up to 0.6 in floating point; what is at the right end must stay on the beam.
    #[test]
    fn spans_are_divided_and_joined_at_the_same_length() {
        let lengths =
            |model: &Model| -> Vec<f64> { model.spans.iter().map(|span| span.length).collect() };
        let mut model = sample::model(&["S1"]);
        split(&mut model, 0);
        assert_eq!((lengths(&model), model.beam.length), (vec![1.6, 1.6], 0.0));
        split(&mut model, 1);
        assert_eq!(lengths(&model), [1.6, 0.8, 0.8]);
        remove(&mut model, Group::Span(1));
        assert_eq!(lengths(&model), [2.4, 0.8]);
        remove(&mut model, Group::Span(0));
        model.spans[0].axial_force = Some(5.0);
        remove(&mut model, Group::Span(0));
        let expected = Beam {
            axial_force: 5.0,
            ..sample::model(&["S1"]).beam
        };
        assert_eq!((lengths(&model), model.beam), (vec![], expected));
        for index in 0..3 {
            let span = |length| Span {
                length,
                ..Span::default()
            };
            model.spans = [0.1, 0.2, 0.3].map(span).to_vec();
            let length = model.length();
            assert_ne!(length, 0.6);
            let mut joined = model.clone();
            remove(&mut joined, Group::Span(index));
            split(&mut model, index);
            assert_eq!([joined.length(), model.length()], [length; 2], "{index}");
        }
    }

    #[test]
    fn a_path_into_the_spans_is_misled_by_a_removal_before_it() {
        let [_, mut model] = sample::models(&["S1"]);
        model.tune = None;
        let study = |path: &str| Study {
            name: path.to_owned(),
            family: Family::Vary {
                paths: vec![path.into()],
                operation: Operation::Multiply,
                values: vec![1.0],
            },
        };
        model.studies = ["beam.spans.1.length", "beam.spans.3.section.area"]
            .map(study)
            .to_vec();
        let misled_by = |index| {
            let mut after = model.clone();
            remove(&mut after, Group::Span(index));
            misled(&model, &after, Group::Span(index))
        };
        assert_eq!(misled_by(0), Some(Group::Study(0)));
        assert_eq!(misled_by(1), Some(Group::Study(1)));
        assert_eq!(misled_by(2), Some(Group::Study(1)));
    }

    #[test]
    fn a_number_is_set_and_checked() {
        let mut model = sample::model(&["S1", "S2"]);
        set(&mut model, "subsystems.S2.mass", Value::Number(250.0)).unwrap();
        assert_eq!(number(&model, "subsystems.2.mass"), Ok(250.0));
        assert_eq!(model.subsystems[0].mass, 100.0);
        set(&mut model, "subsystems.*.mass", Value::Number(300.0)).unwrap();
        assert!(
            model
                .subsystems
                .iter()
                .all(|subsystem| subsystem.mass == 300.0)
        );
        set(&mut model, "sweep.points", Value::Count(100)).unwrap();
        set(&mut model, "subsystems.S1.enabled", Value::Flag(true)).unwrap();
        set(&mut model, "sweep.spacing", Value::Choice("log")).unwrap();
        set(&mut model, "title", Value::Text("New".to_owned())).unwrap();
        assert_eq!((model.sweep.points, &*model.title), (100, "New"));
    }

    #[test]
    fn what_the_checks_refuse_leaves_the_model_as_it_was() {
        let model = sample::model(&["S1", "S2"]);
        let refused: &[(&str, Value)] = &[
            ("beam.length", Value::Number(0.0)),
            ("beam.length", Value::Number(f64::NAN)),
            ("beam.length", Value::Number(1.0)),
            ("beam.section.polar_moment", Value::Number(1e-9)),
            ("subsystems.*.mass", Value::Number(-1.0)),
            ("subsystems.S1.position", Value::Number(3.3)),
            ("subsystems.S1.enabled", Value::Flag(false)),
            ("supports.left.w.stiffness", Value::Number(f64::INFINITY)),
            ("sweep.to", Value::Number(0.5)),
            ("sweep.points", Value::Count(1)),
            ("no.such.path", Value::Number(1.0)),
        ];
        for (path, value) in refused {
            let mut same = model.clone();
            assert!(
                !set(&mut same, path, value.clone()).unwrap_err().is_empty(),
                "{path}"
            );
            assert_eq!(same, model, "{path}");
        }
    }

    #[test]
    fn a_pattern_is_set_as_a_whole_or_not_at_all() {
        let mut model = sample::model(&["S1"]);
        let same = model.clone();
        let fault =
            set_unchecked(&mut model, "supports.*.v.stiffness", Value::Number(5.0)).unwrap_err();
        assert_eq!(fault.path, "supports.left.v.stiffness");
        assert_eq!(model, same);
    }

    #[test]
    fn only_one_parameter_can_be_read() {
        let model = sample::model(&["S1", "S2"]);
        assert!(
            parameter(&model, "subsystems.*.mass")
                .unwrap_err()
                .message
                .contains("several")
        );
        assert!(
            number(&model, "title")
                .unwrap_err()
                .message
                .contains("not a number")
        );
        assert!(
            number(&model, "sweep.points")
                .unwrap_err()
                .message
                .contains("not a number")
        );
        let found = numbers(&model, "subsystems.*.mass").unwrap();
        let mass = |i| Group::Subsystem(i).parameter(SubsystemKey::Mass as usize);
        assert_eq!(found, [(mass(0), 100.0), (mass(1), 100.0)]);
        assert!(numbers(&model, "subsystems.*.name").is_err());
    }

    #[test]
    fn the_parameters_follow_the_model_file() {
        let model = sample::model(&["S1"]);
        let all = all(&model);
        let place = |path: &str| {
            all.iter()
                .position(|other| other == path)
                .unwrap_or_else(|| panic!("{path} is missing"))
        };
        let order = [
            "title",
            "notes",
            "beam.length",
            "beam.material.young_modulus",
            "beam.section.centroid_offset",
            "supports.left.kind",
            "supports.left.w",
            "supports.left.w.mass",
            "supports.left.psi.inertia",
            "supports.left.v",
            "supports.right.psi_slope.stiffness",
            "subsystems.S1.name",
            "subsystems.S1.y_left.stiffness",
            "subsystems.S1.mount_z",
            "forces.1.at",
            "forces.4.phase",
            "responses.P5 w.name",
            "responses.E_V.measure",
            "sweep.from",
            "sweep.spacing",
            "studies.Cases.name",
        ];
        assert!(order.map(place).is_sorted());
        assert!(
            !all.iter()
                .any(|path| path == "supports.left.v.stiffness" || path == "responses.E_V.at")
        );
    }

    /// The shortest time of a few runs.
    fn time(mut work: impl FnMut()) -> Duration {
        let runs = (0..5).map(|_| {
            let start = Instant::now();
            work();
            start.elapsed()
        });
        runs.min().unwrap_or_default()
    }

    #[test]
    fn a_thousand_subsystems_are_no_burden() {
        let names: Vec<String> = (0..1000).map(|index| format!("absorber {index}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut model = sample::model(&names);
        (model.studies, model.tune) = (Vec::new(), None);
        let path = |name: &&str| (format!("subsystems.{name}.mass").into(), 7.0);
        let set_all = names.iter().map(path).collect();
        let case = Case {
            name: "all".to_owned(),
            set: set_all,
        };
        let family = Family::Cases(vec![case]);

        let clone = time(|| drop(model.clone()));
        let check = time(|| assert_eq!(check(&model), []));
        let one = time(|| {
            set(
                &mut model,
                "subsystems.absorber 999.mass",
                Value::Number(5.0),
            )
            .unwrap();
        });
        let every = time(|| {
            set(&mut model, "subsystems.*.mass", Value::Number(5.0)).unwrap();
        });
        let listed = time(|| {
            numbers(&model, "subsystems.*.*.stiffness").unwrap();
        });
        let member = time(|| {
            apply(&model, &family, 0).unwrap();
        });
        println!("clone {clone:?}, check {check:?}, set one {one:?}, every {every:?}");
        println!("list 4000 {listed:?}, a case of 1000 {member:?}");
        // Generous, for a busy machine; quadratic time would still exceed it.
        for elapsed in [one, every, listed, member] {
            assert!(elapsed.as_millis() < 50, "{elapsed:?}");
        }
    }
}
