//! Renaming elements that other parts of the model refer to.

use crate::model::id::{Group, SupportId};
use crate::model::path::Pattern;
use crate::model::path::pattern::{Part, join};
use crate::model::quantity::{Holder, Quantity, Reaction};
use crate::model::tuning::Limit;
use crate::model::types::{Family, Model, Target};

/// Renames an element of a list and all references to it.
pub(super) fn element(model: &mut Model, group: Group, new: &str) {
    match group {
        Group::Subsystem(index) => subsystem(model, index, new),
        Group::Response(index) => response(model, index, new),
        Group::Support(SupportId::Inner(index)) => inner_support(model, index, new),
        Group::Study(index) => new.clone_into(&mut model.studies[index].name),
        _ => {}
    }
}

/// Renames a subsystem and all references to it.
fn subsystem(model: &mut Model, index: usize, new: &str) {
    let old = std::mem::replace(&mut model.subsystems[index].name, new.to_owned());
    for force in &mut model.forces {
        if let Target::Mass(name, _) = &mut force.target {
            follow(name, &old, new);
        }
    }
    for response in &mut model.responses {
        match &mut response.quantity {
            Quantity::Motion(Target::Mass(name, _), _) | Quantity::Spring(name, ..) => {
                follow(name, &old, new);
            }
            Quantity::Motion(Target::Beam(..), _)
            | Quantity::Reaction(_)
            | Quantity::InternalForce(..)
            | Quantity::Energy => {}
        }
    }
    paths(model, &["subsystems"], &old, new);
}

/// Renames an inner support and all references to it.
fn inner_support(model: &mut Model, index: usize, new: &str) {
    let name = &mut model.supports.inner[index].name;
    let old = std::mem::replace(name, new.to_owned());
    for response in &mut model.responses {
        if let Quantity::Reaction(Reaction::Support(Holder::Inner(name), _)) =
            &mut response.quantity
        {
            follow(name, &old, new);
        }
    }
    paths(model, &["supports", "inner"], &old, new);
}

/// Renames a reference, if it is one to the old name.
fn follow(name: &mut String, old: &str, new: &str) {
    if name == old {
        new.clone_into(name);
    }
}

/// Renames a response and all references to it.
fn response(model: &mut Model, index: usize, new: &str) {
    let old = std::mem::replace(&mut model.responses[index].name, new.to_owned());
    for response in &mut model.responses {
        if let Some(over) = &mut response.over {
            follow(over, &old, new);
        }
    }
    if let Some(tune) = &mut model.tune {
        let objectives = tune.objectives.iter_mut();
        let responses = objectives.filter_map(|objective| objective.response.as_mut());
        let limits = tune.limits.iter_mut().filter_map(|limit| match limit {
            Limit::Peak { response, .. } | Limit::StaticDeflection { response, .. } => {
                Some(response)
            }
            Limit::AddedMass { .. } | Limit::NoMode { .. } | Limit::Buckling { .. } => None,
        });
        for response in responses.chain(limits).filter(|name| **name == old) {
            new.clone_into(response);
        }
    }
    paths(model, &["responses"], &old, new);
}

/// Rewrites the paths of studies and tuning that name an element of a list.
fn paths(model: &mut Model, list: &[&str], old: &str, new: &str) {
    for study in &mut model.studies {
        match &mut study.family {
            Family::Vary { paths, .. } => paths
                .iter_mut()
                .for_each(|path| rewrite(path, list, old, new)),
            Family::Cases(cases) => {
                let paths = cases
                    .iter_mut()
                    .flat_map(|case| &mut case.set)
                    .map(|(path, _)| path);
                paths.for_each(|path| rewrite(path, list, old, new));
            }
        }
    }
    for variable in model.tune.iter_mut().flat_map(|tune| &mut tune.variables) {
        for path in &mut variable.paths {
            rewrite(path, list, old, new);
        }
    }
}

fn rewrite(path: &mut Pattern, list: &[&str], old: &str, new: &str) {
    let Ok(parts) = path.parts() else { return };
    let is_in_list = parts.len() > list.len()
        && list
            .iter()
            .zip(parts)
            .all(|(key, part)| *part != Part::Any && part.means(key));
    // Digits without quotes are a number, which does not change.
    let is_it = match parts.get(list.len()) {
        Some(Part::Word(name)) => {
            name == old && !name.chars().all(|letter| letter.is_ascii_digit())
        }
        Some(Part::Quoted(name)) => name == old,
        Some(Part::Any) | None => false,
    };
    if is_in_list && is_it {
        let mut parts = parts.to_vec();
        parts[list.len()] = Part::Quoted(new.to_owned());
        *path = join(&parts).into();
    }
}

#[cfg(test)]
mod tests {
    use crate::model::edit::{Value, set};
    use crate::model::path::{number, parameter, sample};
    use crate::model::types::Family;

    fn text(word: &str) -> Value {
        Value::Text(word.to_owned())
    }

    #[test]
    fn a_subsystem_takes_its_references_along() {
        let mut model = sample::model(&["S1", "S2"]);
        if let Family::Vary { paths, .. } = &mut model.studies[0].family {
            *paths = [
                "subsystems.S1.mass",
                "subsystems.1.mass",
                "subsystems.S2.mass",
            ]
            .map(crate::model::path::Pattern::from)
            .to_vec();
        }
        set(&mut model, "subsystems.S1.name", text("a.b")).unwrap();
        assert_eq!(number(&model, r#"subsystems."a.b".mass"#), Ok(100.0));
        assert_eq!(parameter(&model, "forces.4.at").unwrap().value, text("a.b"));
        assert_eq!(
            parameter(&model, "responses.mass.at").unwrap().value,
            text("a.b")
        );
        let Family::Vary { paths, .. } = &model.studies[0].family else {
            panic!()
        };
        assert_eq!(
            paths[..],
            [
                r#"subsystems."a.b".mass"#,
                "subsystems.1.mass",
                "subsystems.S2.mass"
            ]
        );
        let Family::Cases(cases) = &model.studies[2].family else {
            panic!()
        };
        assert_eq!(cases[1].set[0].0, r#"subsystems."a.b".arm_left"#);
        set(&mut model, "subsystems.1.name", text("S1")).unwrap();
        assert_eq!(parameter(&model, "forces.4.at").unwrap().value, text("S1"));
    }

    #[test]
    fn a_response_takes_the_objective_along() {
        let mut model = sample::model(&["S1"]);
        set(&mut model, "responses.P5 w.name", text("tip")).unwrap();
        assert_eq!(
            model.tune.as_ref().unwrap().objectives[0]
                .response
                .as_deref(),
            Some("tip")
        );
    }

    #[test]
    fn a_name_that_cannot_be_is_refused() {
        let mut model = sample::model(&["S1", "S2"]);
        let same = model.clone();
        for name in ["S2", "left", "right", "", "a\nb"] {
            assert!(
                set(&mut model, "subsystems.S1.name", text(name)).is_err(),
                "{name:?} was taken"
            );
            assert_eq!(model, same);
        }
        assert!(set(&mut model, "responses.1.name", text("E_V")).is_err());
        assert!(set(&mut model, "studies.1.name", text("Ends")).is_err());
        assert!(set(&mut model, "subsystems.*.name", text("S")).is_err());
        assert_eq!(model, same);
    }
}
