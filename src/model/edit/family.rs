//! The members of a study.

use super::value::{Value, number, put};
use crate::model::check::Checked;
use crate::model::fault::Fault;
use crate::model::path::{self, Finder, Pattern};
use crate::model::types::{Family, Model, Operation};
use crate::unit::Unit;

/// A member of a study: the model with its changes, checked, without studies and tuning.
///
/// Every change starts from the model's own value, so that a parameter that two paths match is changed once.
///
/// # Errors
/// The member does not exist, a path matches nothing or no number, or [`check()`](crate::model::check()) finds faults
/// in the result.
pub fn apply(model: &Model, family: &Family, index: usize) -> Result<Checked, Vec<Fault>> {
    let member = apply_unchecked(model, family, index).map_err(|fault| vec![fault])?;
    Checked::new(member)
}

/// As [`apply`], without a check of the result.
///
/// # Errors
/// The member does not exist, or a path matches nothing or no number.
pub fn apply_unchecked(model: &Model, family: &Family, index: usize) -> Result<Model, Fault> {
    let mut member = Model {
        studies: Vec::new(),
        tune: None,
        ..model.clone()
    };
    change(model, &mut member, family, index)?;
    Ok(member)
}

fn change(model: &Model, member: &mut Model, family: &Family, index: usize) -> Result<(), Fault> {
    let missing = || Fault::new("", format!("the study has no member {}", index + 1));
    let finder = Finder::new(model);
    let mut write = |path: &Pattern, operation: Operation, by: f64| {
        for id in finder.find(path)? {
            let fault = |message| Fault::new(path::text(model, id), message);
            let old = number(model, id).map_err(fault)?;
            put(member, id, Value::Number(operation.apply(old, by))).map_err(fault)?;
        }
        Ok(())
    };
    match family {
        Family::Vary {
            paths,
            operation,
            values,
        } => {
            let by = *values.get(index).ok_or_else(missing)?;
            paths
                .iter()
                .try_for_each(|path| write(path, *operation, by))
        }
        Family::Cases(cases) => {
            let case = cases.get(index).ok_or_else(missing)?;
            case.set
                .iter()
                .try_for_each(|(path, value)| write(path, Operation::Set, *value))
        }
    }
}

/// Labels of the members of a study for a chart: `x 0.5`, `1e6`, `+0.3`, a case's name.
pub fn family_labels(family: &Family) -> Vec<String> {
    match family {
        Family::Vary {
            operation: Operation::Multiply,
            values,
            ..
        } => values
            .iter()
            .map(|value| format!("x {}", short(*value)))
            .collect(),
        Family::Vary {
            operation: Operation::Add,
            values,
            ..
        } => values
            .iter()
            .map(|value| {
                if value.is_sign_negative() {
                    short(*value)
                } else {
                    format!("+{}", short(*value))
                }
            })
            .collect(),
        _ => family_keys(family),
    }
}

/// Labels of the members of a study for a table: the factor or value alone, or a case's name.
pub fn family_keys(family: &Family) -> Vec<String> {
    match family {
        Family::Vary { values, .. } => values.iter().map(|value| short(*value)).collect(),
        Family::Cases(cases) => cases.iter().map(|case| case.name.clone()).collect(),
    }
}

fn short(value: f64) -> String {
    Unit::ONE.format_exact(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::{number, sample};
    use crate::model::types::{Case, Study};

    fn vary(paths: &[&str], operation: Operation, values: &[f64]) -> Family {
        let paths = paths.iter().map(|path| (*path).into()).collect();
        Family::Vary {
            paths,
            operation,
            values: values.to_vec(),
        }
    }

    #[test]
    fn a_member_has_its_changes_and_nothing_else() {
        let model = sample::model(&["S1", "S2"]);
        let bare = Model {
            studies: Vec::new(),
            tune: None,
            ..model.clone()
        };
        let family = vary(&["subsystems.*.mass"], Operation::Multiply, &[1.0, 0.5]);
        assert_eq!(apply(&model, &family, 0), Checked::new(bare.clone()));
        let member = apply(&model, &family, 1).unwrap();
        assert!(
            member
                .subsystems
                .iter()
                .all(|subsystem| subsystem.mass == 50.0)
        );
        let family = vary(
            &["beam.length", "subsystems.S1.position"],
            Operation::Add,
            &[0.3],
        );
        assert_eq!(
            number(&apply(&model, &family, 0).unwrap(), "beam.length"),
            Ok(3.5)
        );
        let family = vary(&["supports.*.w.stiffness"], Operation::Set, &[5.0]);
        assert_eq!(
            number(
                &apply(&model, &family, 0).unwrap(),
                "supports.right.w.stiffness"
            ),
            Ok(5.0)
        );
        for Study { family, .. } in &model.studies {
            for index in 0..family_labels(family).len() {
                apply(&model, family, index).unwrap();
            }
        }
    }

    #[test]
    fn a_parameter_that_two_paths_mean_is_changed_once() {
        let model = sample::model(&["S1", "S2"]);
        let family = vary(
            &["subsystems.*.mass", "subsystems.S1.mass"],
            Operation::Add,
            &[7.0],
        );
        let member = apply(&model, &family, 0).unwrap();
        assert_eq!(
            (member.subsystems[0].mass, member.subsystems[1].mass),
            (107.0, 107.0)
        );
    }

    #[test]
    fn an_impossible_member_is_refused() {
        let model = sample::model(&["S1"]);
        let refused = [
            vary(&["subsystems.*.mass"], Operation::Multiply, &[-1.0]),
            vary(&["subsystems.*.mass"], Operation::Multiply, &[1e308]),
            vary(&["subsystems.S1.position"], Operation::Add, &[3.0]),
            vary(&["subsystems.S9.position"], Operation::Add, &[0.0]),
            vary(&["subsystems.S1.name"], Operation::Set, &[1.0]),
            vary(&["sweep.points"], Operation::Multiply, &[2.0]),
            vary(&["supports.left.v.stiffness"], Operation::Set, &[2.0]),
            vary(&["subsystems.S1.mass"], Operation::Set, &[]),
            Family::Cases(vec![Case {
                name: "a".to_owned(),
                set: vec![("beam.length".into(), 0.0)],
            }]),
        ];
        for family in refused {
            assert!(apply(&model, &family, 0).is_err(), "{family:?}");
        }
        assert!(apply(&model, &model.studies[0].family, 3).is_err());
    }

    #[test]
    fn members_are_distinguished() {
        let values = [0.5, -0.3, 1e6, 0.0];
        let family = |operation| vary(&["beam.length"], operation, &values);
        assert_eq!(
            family_labels(&family(Operation::Multiply)),
            ["x 0.5", "x -0.3", "x 1e6", "x 0"]
        );
        assert_eq!(
            family_labels(&family(Operation::Set)),
            ["0.5", "-0.3", "1e6", "0"]
        );
        assert_eq!(
            family_labels(&family(Operation::Add)),
            ["+0.5", "-0.3", "+1e6", "+0"]
        );
        assert_eq!(
            family_keys(&family(Operation::Add)),
            ["0.5", "-0.3", "1e6", "0"]
        );
        let cases = sample::model(&["S1"]).studies[2].family.clone();
        assert_eq!(family_labels(&cases), ["as it is", "symmetric"]);
        assert_eq!(family_keys(&cases), ["as it is", "symmetric"]);
    }
}
