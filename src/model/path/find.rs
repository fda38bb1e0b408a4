//! From the text of a path to the parameters it stands for, and from a slip to the path that was meant.

use std::cell::{Cell, OnceCell};
use std::collections::HashMap;

use super::address::{Address, End, Leaf, Owner, leaves, owner_paths, owners};
use super::miss::{self, Miss};
use super::pattern::{Part, split};
use crate::model::Fault;
use crate::model::types::Model;

/// The words a path may begin with.
const ROOTS: [&str; 9] = [
    "title",
    "notes",
    "beam",
    "supports",
    "subsystems",
    "forces",
    "responses",
    "sweep",
    "studies",
];

/// Finds parameters of a model. One finder for many paths keeps the names in a hash table.
pub(super) struct Finder<'a> {
    model: &'a Model,
    /// Whether a name has been sought before: a single look-up is not worth a table.
    sought: Cell<bool>,
    subsystems: OnceCell<HashMap<&'a str, usize>>,
}

/// The parameters of a path: every leaf of every owner.
pub(super) struct Found {
    pub(super) owners: Vec<Owner>,
    pub(super) leaves: Vec<Leaf>,
    /// A star stands for a motion or a response; those without the parameter are passed over.
    lenient: bool,
}

impl Found {
    /// All of it, owner by owner, each with its path.
    pub(super) fn with_paths(&self, model: &Model) -> Vec<(Address, String)> {
        let mut all = Vec::with_capacity(self.owners.len() * self.leaves.len());
        for (owner, path) in self.owners.iter().zip(owner_paths(model, &self.owners)) {
            let addresses = self.leaves.iter().map(|leaf| Address {
                owner: *owner,
                leaf: *leaf,
            });
            all.extend(
                addresses
                    .filter(|of| self.holds(model, of))
                    .map(|of| (of, of.below(&path))),
            );
        }
        all
    }

    /// All of it, owner by owner.
    pub(super) fn addresses(&self, model: &Model) -> Vec<Address> {
        let each = |owner: &Owner| {
            let owner = *owner;
            self.leaves
                .iter()
                .map(move |leaf| Address { owner, leaf: *leaf })
        };
        self.owners
            .iter()
            .flat_map(each)
            .filter(|of| self.holds(model, of))
            .collect()
    }

    fn holds(&self, model: &Model, address: &Address) -> bool {
        !self.lenient || address.exists(model)
    }
}

impl<'a> Finder<'a> {
    pub(super) fn new(model: &'a Model) -> Self {
        Self {
            model,
            sought: Cell::new(false),
            subsystems: OnceCell::new(),
        }
    }

    /// The parameters that a path or pattern stands for, at least one.
    ///
    /// # Errors
    /// The path matches nothing; the fault has the nearest path that does, or what could stand there.
    pub(super) fn find(&self, path: &str) -> Result<Found, Fault> {
        let parts = split(path).map_err(|message| Fault::new(path, message))?;
        self.resolve(&parts)
            .map_err(|miss| Fault::new(path, miss::explain(self, parts, miss)))
    }

    /// The parameters of a path's parts.
    pub(super) fn resolve(&self, parts: &[Part]) -> Result<Found, Miss> {
        let (owners, depth) = self.owners(parts)?;
        // Every list has an element here, and the keys do not depend on which.
        let all = owners.first().map_or_else(Vec::new, |owner| leaves(*owner));
        let leaves = below(all, &parts[depth..]).map_err(|miss| Miss {
            at: depth + miss.at,
            ..miss
        })?;
        let star = |at: usize| parts.get(at) == Some(&Part::Any);
        let lenient = match owners.first() {
            Some(Owner::Support(_)) => star(2),
            Some(Owner::Response(_)) => star(1),
            _ => false,
        };
        Ok(Found {
            owners,
            leaves,
            lenient,
        })
    }

    /// The owners a path begins with, and how many parts name them.
    fn owners(&self, parts: &[Part]) -> Result<(Vec<Owner>, usize), Miss> {
        let model = self.model;
        match parts[0].word() {
            "title" | "notes" => Ok((vec![Owner::Model], 0)),
            "beam" => Ok((vec![Owner::Beam], 1)),
            "sweep" => Ok((vec![Owner::Sweep], 1)),
            "supports" => support(parts.get(1)),
            "subsystems" => element(
                parts,
                Owner::Subsystem,
                model.subsystems.iter().map(|of| &*of.name),
                |name| self.subsystem(name),
            ),
            "forces" => {
                let numbers: Vec<String> = (1..=model.forces.len())
                    .map(|number| number.to_string())
                    .collect();
                element(
                    parts,
                    Owner::Force,
                    numbers.iter().map(|number| &**number),
                    |_| None,
                )
            }
            "responses" => {
                let names = model.responses.iter().map(|of| &*of.name);
                element(parts, Owner::Response, names.clone(), |name| {
                    names.clone().position(|of| of == name)
                })
            }
            "studies" => {
                let names = model.studies.iter().map(|of| &*of.name);
                element(parts, Owner::Study, names.clone(), |name| {
                    names.clone().position(|of| of == name)
                })
            }
            _ => Err(Miss {
                at: 0,
                known: ROOTS.map(str::to_owned).to_vec(),
            }),
        }
    }

    /// The subsystem of a name; from the second name on by a hash table.
    fn subsystem(&self, name: &str) -> Option<usize> {
        let list = &self.model.subsystems;
        if !self.sought.replace(true) {
            return list.iter().position(|subsystem| subsystem.name == name);
        }
        let table = self.subsystems.get_or_init(|| {
            // Backwards, so that of equal names the first one stays.
            list.iter()
                .enumerate()
                .rev()
                .map(|(index, subsystem)| (&*subsystem.name, index))
                .collect()
        });
        table.get(name).copied()
    }
}

/// The ends that the second part of a path stands for.
fn support(part: Option<&Part>) -> Result<(Vec<Owner>, usize), Miss> {
    let ends = [("left", End::Left), ("right", End::Right)];
    let meant = |part: &Part| {
        let ends = ends.iter().filter(|(key, _)| part.means(key));
        ends.map(|(_, end)| Owner::Support(*end)).collect()
    };
    let found: Vec<Owner> = part.map_or_else(Vec::new, meant);
    if found.is_empty() {
        return Err(Miss {
            at: 1,
            known: ends.map(|(key, _)| key.to_owned()).to_vec(),
        });
    }
    Ok((found, 2))
}

/// The elements of a list that the second part of a path stands for.
fn element<'n>(
    parts: &[Part],
    owner: fn(usize) -> Owner,
    names: impl Iterator<Item = &'n str> + Clone,
    named: impl Fn(&str) -> Option<usize>,
) -> Result<(Vec<Owner>, usize), Miss> {
    let length = || names.clone().count();
    let found: Vec<Owner> = match parts.get(1) {
        Some(Part::Any) => (0..length()).map(owner).collect(),
        Some(Part::Quoted(name)) => named(name).map(owner).into_iter().collect(),
        // Digits alone are a number; a name of digits is written in quotes.
        Some(Part::Word(word)) if word.chars().all(|letter| letter.is_ascii_digit()) => {
            let index = word
                .parse::<usize>()
                .ok()
                .and_then(|number| number.checked_sub(1));
            index
                .filter(|index| *index < length())
                .map(owner)
                .into_iter()
                .collect()
        }
        Some(Part::Word(word)) => named(word).map(owner).into_iter().collect(),
        None => Vec::new(),
    };
    if found.is_empty() {
        return Err(Miss {
            at: 1,
            known: names.map(str::to_owned).collect(),
        });
    }
    Ok((found, 2))
}

/// The leaves that the rest of a path stands for.
fn below(mut leaves: Vec<Leaf>, parts: &[Part]) -> Result<Vec<Leaf>, Miss> {
    for (at, part) in parts.iter().enumerate() {
        let meant = |leaf: &Leaf| leaf.parts().nth(at).is_some_and(|key| part.means(key));
        if !leaves.iter().any(meant) {
            return Err(Miss {
                at,
                known: next_words(&leaves, at),
            });
        }
        leaves.retain(meant);
    }
    let at = parts.len();
    let ends = |leaf: &Leaf| leaf.parts().nth(at).is_none();
    if !leaves.iter().any(ends) {
        return Err(Miss {
            at,
            known: next_words(&leaves, at),
        });
    }
    leaves.retain(ends);
    Ok(leaves)
}

/// The different keys of leaves at a depth; equal ones are neighbours.
fn next_words(leaves: &[Leaf], depth: usize) -> Vec<String> {
    let mut words: Vec<String> = leaves
        .iter()
        .filter_map(|leaf| leaf.parts().nth(depth))
        .map(str::to_owned)
        .collect();
    words.dedup();
    words
}

/// Every parameter of a model with its path, in the order of the file.
pub(super) fn all(model: &Model) -> Vec<(Address, String)> {
    let mut all = Vec::new();
    for owners in owners(model) {
        let leaves = owners.first().map_or_else(Vec::new, |owner| leaves(*owner));
        all.extend(
            Found {
                owners,
                leaves,
                lenient: true,
            }
            .with_paths(model),
        );
    }
    all
}

#[cfg(test)]
mod tests {
    use crate::model::path::{expand, sample};

    #[test]
    fn elements_go_by_name_or_number() {
        let model = sample::model(&["S1", "a.b", "7", "5\" arm"]);
        let cases = [
            ("beam.length", "beam.length"),
            ("beam.material.density", "beam.material.density"),
            ("subsystems.1.mass", "subsystems.S1.mass"),
            ("subsystems.2.mass", r#"subsystems."a.b".mass"#),
            ("subsystems.'a.b'.mass", r#"subsystems."a.b".mass"#),
            (r#"subsystems."7".mass"#, r#"subsystems."7".mass"#),
            ("subsystems.4.mass", r#"subsystems."5\" arm".mass"#),
            (
                "subsystems.S1.y_left.stiffness",
                "subsystems.S1.y_left.stiffness",
            ),
            ("forces.2.amplitude", "forces.2.amplitude"),
            ("responses.P5 w.enabled", "responses.P5 w.enabled"),
            ("responses.2.name", "responses.E_V.name"),
            ("studies.Ends.name", "studies.Ends.name"),
            (
                "supports.left.psi_slope.stiffness",
                "supports.left.psi_slope.stiffness",
            ),
        ];
        for (path, expected) in cases {
            assert_eq!(
                expand(&model, path).unwrap_or_else(|fault| panic!("{fault}")),
                [expected]
            );
        }
    }

    #[test]
    fn a_star_is_every_element_and_every_key() {
        let model = sample::model(&["S1", "S2"]);
        let count = |pattern| {
            expand(&model, pattern)
                .unwrap_or_else(|fault| panic!("{fault}"))
                .len()
        };
        assert_eq!(count("subsystems.*.y_left.stiffness"), 2);
        assert_eq!(count("subsystems.*.*.stiffness"), 8);
        assert_eq!(count("subsystems.S1.*.damping"), 4);
        assert_eq!(count("supports.*.w.stiffness"), 2);
        assert_eq!(
            count("supports.left.*.stiffness"),
            5,
            "not that of the fixed motion"
        );
        assert_eq!(count("forces.*.amplitude"), 4);
        assert_eq!(count("responses.*.at"), 2, "not that of the energy");
        assert_eq!(count("responses.*.enabled"), 3);
        assert_eq!(count("beam.material.*"), 4);
        let paths = expand(&model, "supports.*.psi").unwrap();
        assert_eq!(paths, ["supports.left.psi", "supports.right.psi"]);
    }

    #[test]
    fn unnamed_and_double_elements_go_by_their_numbers() {
        let model = sample::model(&["S1", "S1", ""]);
        let paths = expand(&model, "subsystems.*.mass").unwrap();
        assert_eq!(
            paths,
            [
                "subsystems.S1.mass",
                "subsystems.2.mass",
                "subsystems.3.mass"
            ]
        );
        assert_eq!(
            expand(&model, "subsystems.2.mass").unwrap(),
            ["subsystems.2.mass"]
        );
        assert_eq!(
            expand(&model, "subsystems.S1.mass").unwrap(),
            ["subsystems.S1.mass"]
        );
    }
}
