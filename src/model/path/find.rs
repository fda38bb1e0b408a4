//! Finds the parameters that a path matches.

use std::borrow::Cow;
use std::cell::{Cell, OnceCell};
use std::collections::HashMap;

use super::pattern::{Part, Pattern};
use super::suggestion::{self, Mismatch};
use super::text::{BRANCHES, parts};
use crate::model::Fault;
use crate::model::id::{Group, ParameterId, SupportId};
use crate::model::spring::SpringId;
use crate::model::types::Model;

/// The first words of paths.
const ROOTS: [&str; 10] = [
    "title",
    "notes",
    "beam",
    "supports",
    "joints",
    "subsystems",
    "forces",
    "responses",
    "sweep",
    "studies",
];

/// Finds parameters of a model. Use one finder for many paths: it caches the names in a hash table.
pub(in crate::model) struct Finder<'a> {
    model: &'a Model,
    /// Whether a name was looked up before: for a single look-up a table is slower.
    used: Cell<bool>,
    subsystems: OnceCell<HashMap<&'a str, usize>>,
}

impl Pattern {
    /// The parameters that it matches, at least one.
    ///
    /// # Errors
    /// It matches nothing; the fault suggests the nearest path that matches, or lists the valid words.
    pub fn parameters(&self, model: &Model) -> Result<Vec<ParameterId>, Fault> {
        Finder::new(model).find(self)
    }
}

impl<'a> Finder<'a> {
    pub(in crate::model) fn new(model: &'a Model) -> Self {
        Self {
            model,
            used: Cell::new(false),
            subsystems: OnceCell::new(),
        }
    }

    /// The parameters that a path or pattern matches, at least one, owner by owner.
    ///
    /// # Errors
    /// The path matches nothing; the fault suggests the nearest path that matches, or lists the valid words.
    pub(in crate::model) fn find(&self, path: &Pattern) -> Result<Vec<ParameterId>, Fault> {
        let fault = |message| Fault::new(&**path, message);
        let parts = path.parts().map_err(|message| fault(message.to_owned()))?;
        self.resolve(parts)
            .map_err(|mismatch| fault(suggestion::explain(self, parts.to_vec(), mismatch)))
    }

    /// The parameters of a path's parts.
    pub(super) fn resolve(&self, path: &[Part]) -> Result<Vec<ParameterId>, Mismatch> {
        let (owners, depth) = self.owners(path)?;
        let list = path.get(depth + 1);
        if list.is_some_and(|part| *part != Part::Any && part.means(BRANCHES)) {
            return self.branches(&owners, path, depth);
        }
        // There is at least one owner, and all have the same keys.
        let all = owners.first().map_or_else(Vec::new, |owner| owner.owned());
        let ids = below(all, &path[depth..]).map_err(|mut mismatch| {
            if owners == [Group::Beam] && mismatch.at == 0 && !self.model.spans.is_empty() {
                mismatch.known.push(SPANS.to_owned());
            }
            if mismatch.at == 1 && !SpringId::of(owners[0]).is_empty() {
                mismatch.known.push(BRANCHES.to_owned());
            }
            mismatch.at += depth;
            mismatch
        })?;
        let each = |owner: &Group| {
            let place = owner.place();
            ids.iter()
                .map(move |id| place.map_or(*id, |place| id.at(place)))
        };
        let mut all: Vec<ParameterId> = owners.iter().flat_map(each).collect();
        let star = |at: usize| path.get(at) == Some(&Part::Any);
        // A star for a motion, a response or a span skips those without the parameter.
        let lenient = match owners.first() {
            Some(Group::Support(SupportId::Inner(_))) => star(3),
            Some(Group::Support(_) | Group::Joint(_)) => star(2),
            // If no span has it, each can say why.
            Some(Group::Span(_)) => star(2) && all.iter().any(|id| id.exists(self.model)),
            Some(Group::Response(_)) => star(1),
            _ => false,
        };
        if lenient {
            all.retain(|id| id.exists(self.model));
        }
        Ok(all)
    }

    /// The parameters of Maxwell branches that the rest of a path matches: each spring has its own number of them.
    fn branches(
        &self,
        owners: &[Group],
        path: &[Part],
        depth: usize,
    ) -> Result<Vec<ParameterId>, Mismatch> {
        let groups = owners.iter().flat_map(|owner| owner.branches(self.model));
        let all = groups.flat_map(Group::parameters);
        let is_meant =
            |id: &ParameterId| parts(*id).next().is_some_and(|key| path[depth].means(&key));
        let meant: Vec<ParameterId> = all.filter(is_meant).collect();
        if meant.is_empty() {
            return Err(Mismatch {
                at: depth + 1,
                known: Vec::new(),
            });
        }
        below(meant, &path[depth..]).map_err(|mut mismatch| {
            mismatch.at += depth;
            mismatch
        })
    }

    /// The owners at the start of a path, and the number of parts that name them.
    fn owners(&self, parts: &[Part]) -> Result<(Vec<Group>, usize), Mismatch> {
        let model = self.model;
        match parts[0].word() {
            "title" | "notes" => Ok((vec![Group::Model], 0)),
            "beam" if in_list_below(parts) => numbered(parts, 2, Group::Span, model.spans.len()),
            "beam" => Ok((vec![Group::Beam], 1)),
            "sweep" => Ok((vec![Group::Sweep], 1)),
            "supports" if in_list_below(parts) => {
                let names = model.supports.inner.iter().map(|of| &*of.name);
                let owner = |index| Group::Support(SupportId::Inner(index));
                element(parts, 2, owner, names.clone(), |name| {
                    names.clone().position(|of| of == name)
                })
            }
            "supports" => support(parts.get(1)),
            "subsystems" => element(
                parts,
                1,
                Group::Subsystem,
                model.subsystems.iter().map(|of| &*of.name),
                |name| self.subsystem(name),
            ),
            "joints" => numbered(parts, 1, Group::Joint, model.joints.len()),
            "forces" => numbered(parts, 1, Group::Force, model.forces.len()),
            "responses" => {
                let names = model.responses.iter().map(|of| &*of.name);
                element(parts, 1, Group::Response, names.clone(), |name| {
                    names.clone().position(|of| of == name)
                })
            }
            "studies" => {
                let names = model.studies.iter().map(|of| &*of.name);
                element(parts, 1, Group::Study, names.clone(), |name| {
                    names.clone().position(|of| of == name)
                })
            }
            _ => Err(Mismatch {
                at: 0,
                known: ROOTS.map(str::to_owned).to_vec(),
            }),
        }
    }

    /// The subsystem with a name; from the second look-up on by a hash table.
    fn subsystem(&self, name: &str) -> Option<usize> {
        let list = &self.model.subsystems;
        if !self.used.replace(true) {
            return list.iter().position(|subsystem| subsystem.name == name);
        }
        let table = self.subsystems.get_or_init(|| {
            // In reverse, so that the first of equal names wins.
            list.iter()
                .enumerate()
                .rev()
                .map(|(index, subsystem)| (&*subsystem.name, index))
                .collect()
        });
        table.get(name).copied()
    }
}

/// Whether a path leads into a list below the first word: that of the spans or of the inner supports.
pub(super) fn in_list_below(parts: &[Part]) -> bool {
    let list = match parts[0].word() {
        "beam" => SPANS,
        "supports" => INNER,
        _ => return false,
    };
    parts
        .get(1)
        .is_some_and(|part| *part != Part::Any && part.means(list))
}

/// The list of inner supports among the supports.
const INNER: &str = "inner";

/// The list of spans of the beam.
const SPANS: &str = "spans";

/// The ends that the second part of a path matches.
fn support(part: Option<&Part>) -> Result<(Vec<Group>, usize), Mismatch> {
    let ends = SupportId::ENDS.into_iter().zip(SupportId::WORDS);
    let meant = ends.filter(|(_, word)| part.is_some_and(|part| part.means(word)));
    let found: Vec<Group> = meant.map(|(end, _)| Group::Support(end)).collect();
    if found.is_empty() {
        let known = SupportId::WORDS.into_iter().chain([INNER]);
        return Err(Mismatch {
            at: 1,
            known: known.map(str::to_owned).collect(),
        });
    }
    Ok((found, 2))
}

/// The elements of a list without names that the part at the index `at` of a path matches.
fn numbered(
    parts: &[Part],
    at: usize,
    owner: impl Fn(usize) -> Group,
    count: usize,
) -> Result<(Vec<Group>, usize), Mismatch> {
    let numbers: Vec<String> = (1..=count).map(|number| number.to_string()).collect();
    let numbers = numbers.iter().map(|number| &**number);
    element(parts, at, owner, numbers, |_| None)
}

/// The elements of a list that the part at the index `at` of a path matches.
fn element<'n>(
    parts: &[Part],
    at: usize,
    owner: impl Fn(usize) -> Group,
    names: impl Iterator<Item = &'n str> + Clone,
    named: impl Fn(&str) -> Option<usize>,
) -> Result<(Vec<Group>, usize), Mismatch> {
    let length = || names.clone().count();
    let found: Vec<usize> = match parts.get(at) {
        Some(Part::Any) => (0..length()).collect(),
        Some(Part::Quoted(name)) => named(name).into_iter().collect(),
        // Digits alone are a number; a name of digits needs quotes.
        Some(Part::Word(word)) if word.chars().all(|letter| letter.is_ascii_digit()) => {
            let number = word.parse::<usize>().ok();
            let index = number.and_then(|number| number.checked_sub(1));
            index
                .filter(|index| *index < length())
                .into_iter()
                .collect()
        }
        Some(Part::Word(word)) => named(word).into_iter().collect(),
        None => Vec::new(),
    };
    if found.is_empty() {
        return Err(Mismatch {
            at,
            known: names.map(str::to_owned).collect(),
        });
    }
    Ok((found.into_iter().map(owner).collect(), at + 1))
}

/// The ids that the rest of a path matches.
fn below(mut ids: Vec<ParameterId>, path: &[Part]) -> Result<Vec<ParameterId>, Mismatch> {
    for at in 0..=path.len() {
        // No part may follow the last key.
        let meant = |id: &&ParameterId| match (path.get(at), parts(**id).nth(at)) {
            (Some(part), Some(key)) => part.means(&key),
            (part, key) => part.is_none() && key.is_none(),
        };
        let kept: Vec<ParameterId> = ids.iter().filter(meant).copied().collect();
        if kept.is_empty() {
            let known = next_words(&ids, at);
            return Err(Mismatch { at, known });
        }
        ids = kept;
    }
    Ok(ids)
}

/// The different keys of ids at a depth; equal ones are neighbours.
fn next_words(ids: &[ParameterId], depth: usize) -> Vec<String> {
    let mut words: Vec<String> = ids
        .iter()
        .filter_map(|id| parts(*id).nth(depth))
        .map(Cow::into_owned)
        .collect();
    words.dedup();
    words
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

    /// Of the three spans, the second has all tables itself and the third a section.
    #[test]
    fn spans_go_by_number_and_a_star_is_those_that_have_it() {
        let [uniform, model] = sample::models(&["S1"]);
        let count = |pattern| {
            expand(&model, pattern)
                .unwrap_or_else(|fault| panic!("{fault}"))
                .len()
        };
        assert_eq!(count("beam.spans.*.length"), 3);
        assert_eq!(count("beam.spans.*.section"), 3, "the words");
        assert_eq!(count("beam.spans.*.section.area"), 2);
        assert_eq!(count("beam.spans.2.*.density"), 1);
        assert_eq!(
            expand(&model, "beam.spans.3.section.area").unwrap(),
            ["beam.spans.3.section.area"]
        );
        let refused = |model, path: &str| expand(model, path).unwrap_err().message;
        assert!(refused(&uniform, "beam.spans.1.length").ends_with("the model has no spans"));
        assert!(refused(&model, "beam.spans.4.length").ends_with("must be 1, 2, 3"));
        assert!(refused(&model, "beam.span.1.length").ends_with("`beam.spans.1.length`?"));
        assert!(refused(&model, "beam.spans.1.lenght").ends_with("`beam.spans.1.length`?"));
    }

    /// Of two subsystems with two Maxwell branches each.
    #[test]
    fn branches_go_by_number_and_each_spring_has_its_own() {
        let mut model = sample::model(&["S1", "S2"]);
        let count = |model: &_, pattern| expand(model, pattern).map(|found| found.len());
        assert_eq!(
            count(&model, "subsystems.*.y_left.maxwell.*.stiffness"),
            Ok(4)
        );
        assert_eq!(count(&model, "subsystems.*.*.maxwell.2.damping"), Ok(2));
        assert_eq!(
            expand(&model, "subsystems.2.y_left.maxwell.1.damping").unwrap(),
            ["subsystems.S2.y_left.maxwell.1.damping"]
        );
        model.subsystems[1].y_left.maxwell.pop();
        assert_eq!(
            count(&model, "subsystems.*.y_left.maxwell.2.damping"),
            Ok(1)
        );
        let refused = |path: &str| expand(&model, path).unwrap_err().message;
        for (path, expected) in [
            ("subsystems.S1.y_left.maxwell.3.damping", "must be 1, 2"),
            (
                "subsystems.S1.y_left.maxwell.1.loss_factor",
                "must be stiffness, damping",
            ),
            ("subsystems.S1.y_left.maxwell", "must continue with 1, 2"),
            (
                "subsystems.S1.z_left.maxwell.1.damping",
                "no spring there has Maxwell branches",
            ),
            (
                "supports.left.w.maxwell.1.damping",
                "no spring there has Maxwell branches",
            ),
            (
                "subsystems.S1.y_left.maxwel.1.damping",
                "`subsystems.S1.y_left.maxwell.1.damping`?",
            ),
            (
                "subsystems.S1.y_lft.maxwell.1.damping",
                "no spring there has Maxwell branches",
            ),
        ] {
            assert!(
                refused(path).ends_with(expected),
                "{path}: {}",
                refused(path)
            );
        }
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
