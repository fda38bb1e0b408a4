//! Which parameters there are: owners (a beam, a subsystem, ...) and below each its keys, from the table of numbers.

use crate::model::check::element_keys;
use crate::model::field::elastic_fields;
use crate::model::field::{BEAM, FORCE, Field, MATERIAL, SECTION, SUBSYSTEM, SWEEP};
use crate::model::names;
use crate::model::types::{
    Beam, BeamMotion, Elastic, Force, Material, Model, Quantity, Restraint, Section, Subsystem,
    Support, Sweep,
};

/// What a parameter belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    Model,
    Beam,
    Support(End),
    Subsystem(usize),
    Force(usize),
    Response(usize),
    Sweep,
    Study(usize),
}

/// An end of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Left,
    Right,
}

impl End {
    pub(super) fn of(self, model: &Model) -> &Support {
        match self {
            Self::Left => &model.supports.left,
            Self::Right => &model.supports.right,
        }
    }

    pub(super) fn of_mut(self, model: &mut Model) -> &mut Support {
        match self {
            Self::Left => &mut model.supports.left,
            Self::Right => &mut model.supports.right,
        }
    }
}

/// A parameter of an owner: a row of the table of numbers, or one of the few that are no numbers.
#[derive(Debug, Clone, Copy)]
pub(super) enum Key {
    Beam(&'static Field<Beam>),
    Material(&'static Field<Material>),
    Section(&'static Field<Section>),
    Elastic(BeamMotion, &'static Field<Elastic>),
    Subsystem(&'static Field<Subsystem>),
    Force(&'static Field<Force>),
    Sweep(&'static Field<Sweep>),
    Title,
    Notes,
    Kind,
    Restraint(BeamMotion),
    Name,
    Enabled,
    Measure,
    At,
    Direction,
    Points,
    Spacing,
}

/// A key with its place below the owner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leaf {
    /// The inner table; empty for none.
    table: &'static str,
    /// Itself; a dot steps into a further table.
    name: &'static str,
    pub(super) key: Key,
}

impl Leaf {
    const fn new(name: &'static str, key: Key) -> Self {
        Self {
            table: "",
            name,
            key,
        }
    }

    /// The keys from the owner down.
    pub(super) fn parts(&self) -> impl Iterator<Item = &'static str> + use<> {
        (!self.table.is_empty())
            .then_some(self.table)
            .into_iter()
            .chain(self.name.split('.'))
    }
}

/// One parameter of a model.
#[derive(Debug, Clone, Copy)]
pub(super) struct Address {
    pub(super) owner: Owner,
    pub(super) leaf: Leaf,
}

impl Address {
    /// Whether it can be read: a fixed motion has no spring, an energy no place.
    pub(super) fn exists(&self, model: &Model) -> bool {
        match (self.owner, self.leaf.key) {
            (Owner::Support(end), Key::Elastic(motion, _)) => {
                end.of(model)[motion] != Restraint::Fixed
            }
            (Owner::Response(index), Key::At | Key::Direction) => {
                model.responses[index].quantity != Quantity::Energy
            }
            _ => true,
        }
    }

    /// Its path; `owner` is that of the owner.
    pub(super) fn below(&self, owner: &str) -> String {
        let mut path = owner.to_owned();
        for part in self.leaf.parts() {
            if !path.is_empty() {
                path.push('.');
            }
            path.push_str(part);
        }
        path
    }

    /// Its path.
    pub(super) fn path(&self, model: &Model) -> String {
        self.below(&owner_path(model, self.owner))
    }
}

/// The path of an owner.
fn owner_path(model: &Model, owner: Owner) -> String {
    match owner {
        Owner::Model => String::new(),
        Owner::Beam => "beam".to_owned(),
        Owner::Support(End::Left) => "supports.left".to_owned(),
        Owner::Support(End::Right) => "supports.right".to_owned(),
        Owner::Subsystem(index) => format!(
            "subsystems.{}",
            key(model.subsystems.iter().map(|of| &*of.name), index)
        ),
        Owner::Force(index) => format!("forces.{}", index + 1),
        Owner::Response(index) => format!(
            "responses.{}",
            key(model.responses.iter().map(|of| &*of.name), index)
        ),
        Owner::Sweep => "sweep".to_owned(),
        Owner::Study(index) => format!(
            "studies.{}",
            key(model.studies.iter().map(|of| &*of.name), index)
        ),
    }
}

/// The key of one element of a list: its name, or its number where the name is empty or taken.
fn key<'a>(mut names: impl Iterator<Item = &'a str> + Clone, index: usize) -> String {
    let name = names.clone().nth(index).unwrap_or_default();
    if !name.trim().is_empty() && names.position(|other| other == name) == Some(index) {
        names::segment(name)
    } else {
        (index + 1).to_string()
    }
}

/// The paths of owners, each name looked at once.
pub(super) fn owner_paths(model: &Model, owners: &[Owner]) -> Vec<String> {
    let keys = match owners {
        [Owner::Subsystem(_), _, ..] => element_keys(model.subsystems.iter().map(|of| &*of.name)),
        [Owner::Response(_), _, ..] => element_keys(model.responses.iter().map(|of| &*of.name)),
        [Owner::Study(_), _, ..] => element_keys(model.studies.iter().map(|of| &*of.name)),
        _ => {
            return owners
                .iter()
                .map(|owner| owner_path(model, *owner))
                .collect();
        }
    };
    let path = |owner: &Owner| match owner {
        Owner::Subsystem(index) => format!("subsystems.{}", keys[*index]),
        Owner::Response(index) => format!("responses.{}", keys[*index]),
        Owner::Study(index) => format!("studies.{}", keys[*index]),
        other => owner_path(model, *other),
    };
    owners.iter().map(path).collect()
}

/// The rows of a table as leaves.
fn rows<T>(
    table: &'static str,
    fields: &'static [Field<T>],
    key: fn(&'static Field<T>) -> Key,
) -> impl Iterator<Item = Leaf> {
    fields.iter().map(move |field| Leaf {
        table,
        name: field.key,
        key: key(field),
    })
}

/// All keys below an owner, in the order of the file.
pub(super) fn leaves(owner: Owner) -> Vec<Leaf> {
    let name = Leaf::new("name", Key::Name);
    let enabled = Leaf::new("enabled", Key::Enabled);
    let place = [
        Leaf::new("at", Key::At),
        Leaf::new("direction", Key::Direction),
    ];
    match owner {
        Owner::Model => vec![
            Leaf::new("title", Key::Title),
            Leaf::new("notes", Key::Notes),
        ],
        Owner::Beam => rows("", BEAM, Key::Beam)
            .chain(rows("material", MATERIAL, Key::Material))
            .chain(rows("section", SECTION, Key::Section))
            .collect(),
        Owner::Support(_) => support(),
        Owner::Subsystem(_) => [name, enabled]
            .into_iter()
            .chain(rows("", SUBSYSTEM, Key::Subsystem))
            .collect(),
        Owner::Force(_) => [enabled]
            .into_iter()
            .chain(place)
            .chain(rows("", FORCE, Key::Force))
            .collect(),
        Owner::Response(_) => [name, enabled, Leaf::new("measure", Key::Measure)]
            .into_iter()
            .chain(place)
            .collect(),
        Owner::Sweep => rows("", SWEEP, Key::Sweep)
            .chain([
                Leaf::new("points", Key::Points),
                Leaf::new("spacing", Key::Spacing),
            ])
            .collect(),
        Owner::Study(_) => vec![name],
    }
}

fn support() -> Vec<Leaf> {
    let mut leaves = vec![Leaf::new("kind", Key::Kind)];
    for motion in BeamMotion::ALL {
        leaves.push(Leaf::new(motion.key(), Key::Restraint(motion)));
        let fields = elastic_fields(motion).iter();
        leaves.extend(fields.map(|field| Leaf {
            table: motion.key(),
            name: field.key,
            key: Key::Elastic(motion, field),
        }));
    }
    leaves
}

/// All owners, in the order of the file; the model itself, with title and notes, first.
pub(super) fn owners(model: &Model) -> [Vec<Owner>; 8] {
    [
        vec![Owner::Model],
        vec![Owner::Beam],
        vec![Owner::Support(End::Left), Owner::Support(End::Right)],
        (0..model.subsystems.len()).map(Owner::Subsystem).collect(),
        (0..model.forces.len()).map(Owner::Force).collect(),
        (0..model.responses.len()).map(Owner::Response).collect(),
        vec![Owner::Sweep],
        (0..model.studies.len()).map(Owner::Study).collect(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::sample;

    #[test]
    fn every_row_of_the_table_has_its_leaf() {
        let count = |owner| leaves(owner).len();
        assert_eq!(
            count(Owner::Beam),
            BEAM.len() + MATERIAL.len() + SECTION.len()
        );
        assert_eq!(
            count(Owner::Support(End::Left)),
            1 + BeamMotion::ALL.len() * 4
        );
        assert_eq!(count(Owner::Subsystem(0)), 2 + SUBSYSTEM.len());
        assert_eq!(count(Owner::Force(0)), 3 + FORCE.len());
        assert_eq!(count(Owner::Sweep), 2 + SWEEP.len());
    }

    #[test]
    fn one_path_and_many_paths_agree() {
        let model = sample::model(&["S1", "S1", "", "a.b", "7"]);
        for owners in owners(&model) {
            let each: Vec<String> = owners
                .iter()
                .map(|owner| owner_path(&model, *owner))
                .collect();
            assert_eq!(owner_paths(&model, &owners), each);
        }
    }
}
