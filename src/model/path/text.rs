//! The paths of parameters as text.

use std::borrow::Cow;
use std::cell::OnceCell;

use crate::model::id::{Group, ParameterId, SupportId};
use crate::model::spelling::{element_key, element_keys};
use crate::model::types::Model;

/// The list of the Maxwell branches of a spring.
pub(super) const BRANCHES: &str = "maxwell";

/// The path of a parameter.
pub fn text(model: &Model, id: ParameterId) -> String {
    join(&owner(model, id.group.owner()), id)
}

/// The paths of parameters; visits each name of a list once.
pub fn texts(model: &Model, ids: &[ParameterId]) -> Vec<String> {
    let lists = [const { OnceCell::new() }; 4];
    let key = |list: usize, of: Group, place: usize| {
        let keys: &Vec<String> =
            lists[list].get_or_init(|| names(model, of, |names| element_keys(names)));
        format!("{}.{}", list_key(of), keys[place])
    };
    let path = |id: &ParameterId| match id.group.owner() {
        // A single path does not need the keys of the whole list.
        _ if ids.len() == 1 => text(model, *id),
        owner @ Group::Subsystem(i) => join(&key(0, owner, i), *id),
        owner @ Group::Response(i) => join(&key(1, owner, i), *id),
        owner @ Group::Study(i) => join(&key(2, owner, i), *id),
        owner @ Group::Support(SupportId::Inner(i)) => join(&key(3, owner, i), *id),
        _ => text(model, *id),
    };
    ids.iter().map(path).collect()
}

/// The keys of a parameter below its owner.
pub(super) fn parts(id: ParameterId) -> impl Iterator<Item = Cow<'static, str>> {
    let inner = match id.group {
        Group::Motion(_, motion) | Group::Link(_, motion) => [Some(motion.key()), None],
        Group::Branch(spring, _) => [Some(spring.key()), Some(BRANCHES)],
        group => [group.table_key(), None],
    };
    let number = match id.group {
        Group::Branch(_, index) => Some((index + 1).to_string().into()),
        _ => None,
    };
    let keys = id.key().key.split('.').map(Into::into);
    let inner = inner.into_iter().flatten().map(Into::into);
    inner.chain(number).chain(keys)
}

fn join(owner: &str, id: ParameterId) -> String {
    let mut path = owner.to_owned();
    for part in parts(id) {
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(&part);
    }
    path
}

/// The path of a beam, a support, or an element of a list.
fn owner(model: &Model, owner: Group) -> String {
    match owner {
        Group::Model => String::new(),
        Group::Support(end @ (SupportId::Left | SupportId::Right)) => {
            format!("supports.{}", end.name(model))
        }
        Group::Support(SupportId::Inner(i))
        | Group::Subsystem(i)
        | Group::Response(i)
        | Group::Study(i) => {
            let key = names(model, owner, |names| element_key(names, i));
            format!("{}.{key}", list_key(owner))
        }
        Group::Span(i) => format!("beam.spans.{}", i + 1),
        Group::Joint(i) => format!("joints.{}", i + 1),
        Group::Force(i) => format!("forces.{}", i + 1),
        other => list_key(other).to_owned(),
    }
}

/// The key of the file that contains a table.
const fn list_key(of: Group) -> &'static str {
    match of {
        Group::Beam => "beam",
        Group::Subsystem(_) => "subsystems",
        Group::Response(_) => "responses",
        Group::Study(_) => "studies",
        Group::Support(_) => "supports.inner",
        _ => "sweep",
    }
}

/// Applies a function to the names of a list.
fn names<R>(model: &Model, list: Group, of: impl FnOnce(&mut dyn Iterator<Item = &str>) -> R) -> R {
    match list {
        Group::Subsystem(_) => of(&mut model.subsystems.iter().map(|one| &*one.name)),
        Group::Support(_) => of(&mut model.supports.inner.iter().map(|one| &*one.name)),
        Group::Response(_) => of(&mut model.responses.iter().map(|one| &*one.name)),
        _ => of(&mut model.studies.iter().map(|one| &*one.name)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::sample;

    #[test]
    fn one_path_and_many_paths_agree() {
        for model in sample::models(&["S1", "S1", "", "a.b", "7"]) {
            let all = ParameterId::all(&model);
            let each: Vec<String> = all.iter().map(|id| text(&model, *id)).collect();
            assert_eq!(texts(&model, &all), each);
        }
    }
}
