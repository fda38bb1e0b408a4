//! Where the groups and parameters of a model are in a changed one.
//!
//! A [`Group`] has meaning with one model alone. What keeps one while the model changes takes it through here.

use std::collections::HashMap;

use super::id::{Group, ParameterId};
use super::types::Model;

/// How the lists of a model changed.
#[derive(Debug)]
pub struct Moves {
    subsystems: Move,
    forces: Move,
    responses: Move,
    studies: Move,
}

/// Where the places of a list are now.
#[derive(Debug)]
enum Move {
    /// Where they were.
    Stay,
    /// From `from` on, moved by the difference in length.
    Shift { from: usize, by: isize },
    /// By the place before; none where it was removed.
    Places(Vec<Option<usize>>),
}

impl Move {
    /// Of a list without names: what the two lists begin with is the same.
    fn of_unnamed<T: PartialEq>(before: &[T], after: &[T]) -> Self {
        if before.len() == after.len() {
            return Self::Stay;
        }
        let from = before.iter().zip(after).take_while(|(a, b)| a == b).count();
        let by = after.len().cast_signed() - before.len().cast_signed();
        Self::Shift { from, by }
    }

    /// Of a list whose names differ from each other.
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
            // The row that takes the place of a removed one is another row.
            Self::Shift { from, by } => place.checked_add_signed(*by).filter(|new| new >= from),
            Self::Places(places) => places.get(place).copied().flatten(),
        }
    }
}

impl Moves {
    /// From one model to another, in which elements were added, removed or renamed.
    pub fn new(before: &Model, after: &Model) -> Self {
        Self {
            subsystems: Move::of_named(&before.subsystems, &after.subsystems, |one| &one.name),
            forces: Move::of_unnamed(&before.forces, &after.forces),
            responses: Move::of_named(&before.responses, &after.responses, |one| &one.name),
            studies: Move::of_named(&before.studies, &after.studies, |one| &one.name),
        }
    }

    /// Where a group is in the model after; none where it was removed.
    pub fn of(&self, group: Group) -> Option<Group> {
        let list = match group {
            Group::Subsystem(_) => &self.subsystems,
            Group::Force(_) => &self.forces,
            Group::Response(_) => &self.responses,
            Group::Study(_) => &self.studies,
            other => return Some(other),
        };
        Some(group.at(list.of(group.place()?)?))
    }
}

impl Group {
    /// The group of another model, such as that of a file, which has the same name; a force has the same number.
    pub fn counterpart(self, model: &Model, other: &Model) -> Option<Self> {
        let place = match self {
            Self::Subsystem(i) => named(&model.subsystems[i].name, i, &other.subsystems, |one| {
                &one.name
            })?,
            Self::Response(i) => named(&model.responses[i].name, i, &other.responses, |one| {
                &one.name
            })?,
            Self::Study(i) => named(&model.studies[i].name, i, &other.studies, |one| &one.name)?,
            Self::Force(i) => (i < other.forces.len()).then_some(i)?,
            fixed => return Some(fixed),
        };
        Some(self.at(place))
    }
}

/// Where in a list a name is: nearly always at the same place, and a search through thousands is not needed.
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
        // One removed and another one added is no new name.
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
