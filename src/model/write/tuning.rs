//! The tuning as a tree of keys and values.

use super::super::schema::{AIMS, Choice, LIMITS, OBJECTIVE, VARIABLE};
use super::super::tuning::{Combine, Limit, Objective, Tune, Variable};
use super::node::{Entry, Node};
use super::tree::{entry, optional, rows, text};
use std::collections::HashSet;
use toml_edit::{Item, TableLike, Value};

/// The tree of a tuning; the original determines whether a single path or objective is a list of one.
pub(super) fn tune(tune: &Tune, original: Option<&dyn TableLike>) -> Vec<Entry> {
    let listed = paths_in_lists(original);
    let variables = tune
        .variables
        .iter()
        .map(|one| variable(one, &listed))
        .collect();
    let limits = tune.limits.iter().map(limit).collect();
    let combine = Node::Text(tune.combine.key().to_owned());
    let in_list = original
        .is_some_and(|table| table.contains_key("objectives") && !table.contains_key("objective"));
    vec![
        entry("variables", Node::List(variables)),
        match &tune.objectives[..] {
            [one] if !in_list => entry("objective", objective(one)),
            all => entry(
                "objectives",
                Node::List(all.iter().map(objective).collect()),
            ),
        },
        optional("combine", combine, tune.combine == Combine::default()),
        optional("limits", Node::List(limits), tune.limits.is_empty()),
    ]
}

/// The paths that the original gives as a list of one.
fn paths_in_lists(original: Option<&dyn TableLike>) -> HashSet<String> {
    let alone = |table: &dyn TableLike| match table.get("paths")?.as_array()? {
        list if list.len() == 1 => list.get(0)?.as_str().map(str::to_owned),
        _ => None,
    };
    match original.and_then(|table| table.get("variables")) {
        Some(Item::ArrayOfTables(tables)) => tables.iter().filter_map(|one| alone(one)).collect(),
        Some(Item::Value(Value::Array(array))) => array
            .iter()
            .filter_map(Value::as_inline_table)
            .filter_map(|one| alone(one))
            .collect(),
        _ => HashSet::new(),
    }
}

fn variable(variable: &Variable, listed: &HashSet<String>) -> Node {
    let mut entries = vec![match &variable.paths[..] {
        [path] if !listed.contains(&**path) => text("path", path),
        paths => {
            let paths = paths.iter().map(|path| Node::Text(path.to_string()));
            entry("paths", Node::List(paths.collect()))
        }
    }];
    entries.extend(rows(variable, &VARIABLE));
    // Before the tolerance.
    let scale = variable.scale.map(|scale| text("scale", scale.key()));
    entries.splice(4..4, scale);
    Node::Inline(entries)
}

fn objective(objective: &Objective) -> Node {
    let mut entries = chosen(AIMS, &objective.aim);
    let response = objective.response.as_ref();
    entries.extend(response.map(|name| text("response", name)));
    entries.extend(rows(objective, &OBJECTIVE));
    Node::Inline(entries)
}

fn limit(limit: &Limit) -> Node {
    Node::Inline(chosen(LIMITS, limit))
}

/// The key that selects the kind of a table, if it has one, and the keys of that kind.
fn chosen<T>(choices: &[Choice<T>], of: &T) -> Vec<Entry> {
    let Some(choice) = Choice::of(choices, of) else {
        return Vec::new();
    };
    let word = (!choice.word.is_empty()).then(|| text(choice.key, choice.word));
    word.into_iter().chain(rows(of, &choice.rows)).collect()
}
