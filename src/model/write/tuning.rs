//! The tuning as a tree of keys and values.

use super::super::tuning::{Aim, Combine, Compare, Hold, Limit, Objective, Tune, Variable};
use super::node::{Entry, Node};
use super::tree::{entry, optional, text};
use std::collections::HashSet;
use toml_edit::{Item, TableLike, Value};

/// The tree of a tuning; it takes from the original whether a single path or objective is given as a list of one.
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

/// The paths that stand alone in a list in the original.
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

/// A number that is left out at its default.
fn number(key: &'static str, value: f64, default: f64) -> Entry {
    let at_default = value.to_bits() == default.to_bits();
    optional(key, Node::Number(value), at_default)
}

fn variable(variable: &Variable, listed: &HashSet<String>) -> Node {
    let mut entries = vec![match &variable.paths[..] {
        [path] if !listed.contains(path) => text("path", path),
        paths => {
            let paths = paths.iter().cloned().map(Node::Text);
            entry("paths", Node::List(paths.collect()))
        }
    }];
    let hold = Node::Text(variable.hold.key().to_owned());
    entries.push(optional("hold", hold, variable.hold == Hold::default()));
    entries.push(entry("min", Node::Number(variable.min)));
    entries.push(entry("max", Node::Number(variable.max)));
    entries.extend(variable.scale.map(|scale| text("scale", scale.key())));
    entries.push(number("tolerance", variable.tolerance, 0.0));
    Node::Inline(entries)
}

fn objective(objective: &Objective) -> Node {
    let mut entries = match &objective.aim {
        Aim::Peak { .. } => vec![text("minimise", "peak")],
        Aim::MeanSquare { .. } => vec![text("minimise", "mean_square")],
        Aim::Energy => vec![text("minimise", "energy")],
        Aim::Width { below, .. } => vec![
            text("maximise", "width"),
            entry("below", Node::Number(*below)),
        ],
        Aim::AntiResonance { at, .. } => vec![
            text("place", "anti_resonance"),
            entry("at", Node::Number(*at)),
        ],
        Aim::Match {
            file,
            curve,
            columns,
            compare,
            ..
        } => matched(file, curve.as_deref(), columns.as_deref(), *compare),
    };
    entries.extend(objective.aim.response().map(|name| text("response", name)));
    entries.extend(band(objective.from, objective.to));
    entries.push(number("weight", objective.weight, 1.0));
    Node::Inline(entries)
}

fn matched(file: &str, curve: Option<&str>, columns: Option<&str>, compare: Compare) -> Vec<Entry> {
    let mut entries = vec![text("match", file)];
    entries.extend(curve.map(|curve| text("curve", curve)));
    entries.extend(columns.map(|columns| text("columns", columns)));
    let word = Node::Text(compare.key().to_owned());
    entries.push(optional("compare", word, compare == Compare::default()));
    entries
}

fn band(from: f64, to: f64) -> [Entry; 2] {
    [
        entry("from", Node::Number(from)),
        entry("to", Node::Number(to)),
    ]
}

fn limit(limit: &Limit) -> Node {
    Node::Inline(match limit {
        Limit::AddedMass { at_most } => vec![
            text("limit", "added_mass"),
            entry("at_most", Node::Number(*at_most)),
        ],
        Limit::NoMode { from, to } => {
            let mut entries = vec![text("limit", "no_mode")];
            entries.extend(band(*from, *to));
            entries
        }
        Limit::StaticDeflection { response, at_most } => vec![
            text("limit", "static_deflection"),
            text("response", response),
            entry("at_most", Node::Number(*at_most)),
        ],
    })
}
