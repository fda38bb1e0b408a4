//! Maps the groups and parameters of a model to those of a changed model.
//!
//! A [`Group`] is valid for one model only. Code that keeps one while the model changes maps it here.

use std::collections::HashMap;

use super::id::{Group, ParameterId, SupportId};
use super::types::Model;

/// How the lists of a model changed.
#[derive(Debug)]
pub struct Moves {
    inner_supports: Move,
    spans: Move,
    joints: Move,
    subsystems: Move,
    forces: Move,
    responses: Move,
    studies: Move,
}

/// The new indices of a list.
#[derive(Debug)]
enum Move {
    /// Unchanged.
    Stay,
    /// Shifted by the difference in length, from `from` on.
    Shift { from: usize, by: isize },
    /// By old index; none if removed.
    Places(Vec<Option<usize>>),
}

impl Move {
    /// For a list without names: the common start of both lists is unchanged.
    fn of_unnamed<T: PartialEq>(before: &[T], after: &[T]) -> Self {
        if before.len() == after.len() {
            return Self::Stay;
        }
        let from = before.iter().zip(after).take_while(|(a, b)| a == b).count();
        let by = after.len().cast_signed() - before.len().cast_signed();
        Self::Shift { from, by }
    }

    /// For a list of unique names.
    fn of_named<T>(before: &[T], after: &[T], name: fn(&T) -> &str) -> Self {
        if before.iter().map(name).eq(after.iter().map(name)) {
            return Self::Stay;
        }
        let places = |list: &'_ [T]| -> HashMap<String, usize> {
            let names = list.iter().enumerate();
            names.map(|(i, one)| (name(one).to_owned(), i)).collect()
        };
        let (old, new) = (places(before), places(after));
        let moved = before.iter().enumerate().map(|(place, one)| {
            let renamed = || {
                let there = after.get(place).map(name)?;
                (before.len() == after.len() && !old.contains_key(there)).then_some(place)
            };
            new.get(name(one)).copied().or_else(renamed)
        });
        Self::Places(moved.collect())
    }

    fn of(&self, place: usize) -> Option<usize> {
        match self {
            Self::Stay => Some(place),
            Self::Shift { from, .. } if place < *from => Some(place),
            // The row at the index of a removed one is another row.
            Self::Shift { from, by } => place.checked_add_signed(*by).filter(|new| new >= from),
            Self::Places(places) => places.get(place).copied().flatten(),
        }
    }
}

impl Moves {
    /// Compares a model with one in which elements were added, removed or renamed.
    pub fn new(before: &Model, after: &Model) -> Self {
        let [old, new] = [before, after].map(|model| &model.supports.inner[..]);
        Self {
            inner_supports: Move::of_named(old, new, |one| &one.name),
            spans: Move::of_unnamed(&before.spans, &after.spans),
            joints: Move::of_unnamed(&before.joints, &after.joints),
            subsystems: Move::of_named(&before.subsystems, &after.subsystems, |one| &one.name),
            forces: Move::of_unnamed(&before.forces, &after.forces),
            responses: Move::of_named(&before.responses, &after.responses, |one| &one.name),
            studies: Move::of_named(&before.studies, &after.studies, |one| &one.name),
        }
    }

    /// The group in the changed model; none if it was removed.
    pub fn of(&self, group: Group) -> Option<Group> {
        let list = match group.owner() {
            Group::Support(SupportId::Inner(i)) => {
                let support = SupportId::Inner(self.inner_supports.of(i)?);
                return Some(group.of_support(support));
            }
            Group::Span(_) => &self.spans,
            Group::Joint(_) => &self.joints,
            Group::Subsystem(_) => &self.subsystems,
            Group::Force(_) => &self.forces,
            Group::Response(_) => &self.responses,
            Group::Study(_) => &self.studies,
            _ => return Some(group),
        };
        Some(group.at(list.of(group.place()?)?))
    }
}

impl Group {
    /// The group with the same name in another model, such as that of a file; for a span, joint or force, the same number.
    pub fn counterpart(self, model: &Model, other: &Model) -> Option<Self> {
        let place = match self.owner() {
            Self::Subsystem(i) => named(&model.subsystems[i].name, i, &other.subsystems, |one| {
                &one.name
            })?,
            Self::Support(SupportId::Inner(i)) => {
                let [own, list] = [model, other].map(|model| &model.supports.inner);
                let found = named(&own[i].name, i, list, |one| &one.name)?;
                return Some(self.of_support(SupportId::Inner(found)));
            }
            Self::Response(i) => named(&model.responses[i].name, i, &other.responses, |one| {
                &one.name
            })?,
            Self::Study(i) => named(&model.studies[i].name, i, &other.studies, |one| &one.name)?,
            Self::Span(i) => (i < other.spans.len()).then_some(i)?,
            Self::Joint(i) => (i < other.joints.len()).then_some(i)?,
            Self::Force(i) => (i < other.forces.len()).then_some(i)?,
            _ => return Some(self),
        };
        Some(self.at(place))
    }
}

/// The index of a name in a list; tries the same index first, to avoid a search through thousands.
fn named<T>(own: &str, place: usize, list: &[T], name: fn(&T) -> &String) -> Option<usize> {
    let is_it = |one: &T| name(one) == own;
    let same = list.get(place).is_some_and(is_it);
    same.then_some(place)
        .or_else(|| list.iter().position(is_it))
}

impl ParameterId {
    /// The same parameter of another model, by [`Group::counterpart`].
    pub fn counterpart(self, model: &Model, other: &Model) -> Option<Self> {
        Some(self.group.counterpart(model, other)?.parameter(self.row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(before: &[&str], after: &[&str]) -> Vec<Option<usize>> {
        let moved = Move::of_named(before, after, |one| one);
        (0..before.len()).map(|place| moved.of(place)).collect()
    }

    #[test]
    fn places_follow_their_names() {
        let before = ["a", "b", "c"];
        assert_eq!(named(&before, &before), [Some(0), Some(1), Some(2)]);
        assert_eq!(
            named(&before, &["a", "new", "b", "c"]),
            [Some(0), Some(2), Some(3)]
        );
        assert_eq!(named(&before, &["a", "c"]), [Some(0), None, Some(1)]);
        assert_eq!(
            named(&before, &["a", "x", "c"]),
            [Some(0), Some(1), Some(2)]
        );
        // One element removed and another added is not a rename.
        assert_eq!(named(&["a", "c"], &["a", "b", "c"]), [Some(0), Some(2)]);
        assert_eq!(named(&["a", "c"], &["c", "d"]), [None, Some(0)]);
    }

    #[test]
    fn places_without_names_follow_an_insertion_and_a_removal() {
        let inserted = Move::of_unnamed(&["a", "b", "c"], &["a", "new", "b", "c"]);
        assert_eq!(
            [0, 1, 2].map(|i| inserted.of(i)),
            [Some(0), Some(2), Some(3)]
        );
        let removed = Move::of_unnamed(&["a", "b", "c"], &["a", "c"]);
        assert_eq!([0, 1, 2].map(|i| removed.of(i)), [Some(0), None, Some(1)]);
    }
}
