//! The full form of a model as a tree of keys and values.

use super::super::field::elastic_fields;
use super::super::field::{BEAM, FORCE, Field, MATERIAL, SECTION, SUBSYSTEM, SWEEP};
use super::super::types::{
    BeamMotion, Case, Family, Force, Measure, Model, Place, Quantity, Response, Restraint, Spacing,
    Study, Subsystem, Support, Supports, Target,
};
use super::node::{Entry, Node, Presence};
use super::tuning;
use std::borrow::Cow;
use toml_edit::{Item, Table, TableLike};

use Presence::{Always, InNewTables, OnlyIfThere};

/// Defaults that a new table shows all the same.
const SHOWN_DEFAULTS: [&str; 3] = ["stiffness", "damping", "amplitude"];

pub(super) fn entry(key: impl Into<Cow<'static, str>>, node: Node) -> Entry {
    Entry {
        key: key.into(),
        node,
        presence: Always,
    }
}

pub(super) fn text(key: &'static str, text: &str) -> Entry {
    entry(key, Node::Text(text.to_owned()))
}

/// An entry that is at its default, or not.
pub(super) fn optional(key: &'static str, node: Node, at_default: bool) -> Entry {
    Entry {
        key: key.into(),
        node,
        presence: if at_default { OnlyIfThere } else { Always },
    }
}

fn enabled(enabled: bool) -> Entry {
    optional("enabled", Node::Flag(enabled), enabled)
}

/// The tree of a model; it takes from the original in which of its forms a support and the tuning are given.
pub(super) fn model(model: &Model, original: &Table) -> Vec<Entry> {
    let mut root = vec![
        text("format", "beamtune/1"),
        text("title", &model.title),
        optional(
            "notes",
            Node::Text(model.notes.clone()),
            model.notes.is_empty(),
        ),
        entry("beam", Node::Table(beam(model))),
        supports(&model.supports, original),
        tables(
            "subsystems",
            model.subsystems.iter().map(subsystem).collect(),
        ),
        tables("forces", model.forces.iter().map(force).collect()),
        tables("responses", model.responses.iter().map(response).collect()),
        entry("sweep", Node::Table(sweep(model))),
        tables("studies", model.studies.iter().map(study).collect()),
    ];
    if let Some(tune) = &model.tune {
        let original = original.get("tune").and_then(Item::as_table_like);
        root.push(entry("tune", Node::Table(tuning::tune(tune, original))));
    }
    root
}

fn tables(key: &'static str, list: Vec<Vec<Entry>>) -> Entry {
    let presence = if list.is_empty() { OnlyIfThere } else { Always };
    Entry {
        key: key.into(),
        node: Node::Tables(list.into_iter().map(Node::Table).collect()),
        presence,
    }
}

/// All numbers of a table of fields; those with a dotted key are gathered in inline tables.
fn numbers<T>(of: &T, fields: &[Field<T>]) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for field in fields {
        let value = (field.get)(of);
        let at_default = field
            .default
            .is_some_and(|default| default.to_bits() == value.to_bits());
        let (head, key) = field
            .key
            .split_once('.')
            .map_or((None, field.key), |(head, key)| (Some(head), key));
        let presence = match at_default {
            false => Always,
            true if SHOWN_DEFAULTS.contains(&key) => InNewTables,
            true => OnlyIfThere,
        };
        let number = Entry {
            key: key.into(),
            node: Node::Number(value),
            presence,
        };
        let Some(head) = head else {
            entries.push(number);
            continue;
        };
        match entries.last_mut() {
            Some(Entry {
                key,
                node: Node::Inline(inner),
                presence,
            }) if *key == head => {
                inner.push(number);
                if !at_default {
                    *presence = Always;
                }
            }
            _ => entries.push(optional(head, Node::Inline(vec![number]), at_default)),
        }
    }
    entries
}

fn beam(model: &Model) -> Vec<Entry> {
    let mut beam = numbers(&model.beam, BEAM);
    beam.push(entry(
        "material",
        Node::Table(numbers(&model.beam.material, MATERIAL)),
    ));
    beam.push(entry(
        "section",
        Node::Table(numbers(&model.beam.section, SECTION)),
    ));
    beam
}

fn supports(supports: &Supports, original: &Table) -> Entry {
    let original = original.get("supports").and_then(Item::as_table_like);
    let end = |key: &'static str, support: &Support| {
        let original = original
            .and_then(|table| table.get(key))
            .and_then(Item::as_table_like);
        let presence = if *support == Support::FREE {
            InNewTables
        } else {
            Always
        };
        Entry {
            key: key.into(),
            node: Node::Table(self::support(support, original)),
            presence,
        }
    };
    let ends = vec![end("left", &supports.left), end("right", &supports.right)];
    let presence = if *supports == Supports::default() {
        InNewTables
    } else {
        Always
    };
    Entry {
        key: "supports".into(),
        node: Node::Table(ends),
        presence,
    }
}

/// One end, by its kind if it is one and the file does not speak of the six motions.
fn support(support: &Support, original: Option<&dyn TableLike>) -> Vec<Entry> {
    let kinds = [
        ("free", Support::FREE),
        ("pinned", Support::PINNED),
        ("clamped", Support::CLAMPED),
    ];
    let by_kind = original.is_none_or(|table| table.contains_key("kind"));
    if let Some((kind, _)) = kinds.iter().find(|(_, kind)| by_kind && kind == support) {
        return vec![text("kind", kind)];
    }
    let order = [
        BeamMotion::W,
        BeamMotion::V,
        BeamMotion::Psi,
        BeamMotion::WSlope,
        BeamMotion::VSlope,
        BeamMotion::PsiSlope,
    ];
    let restraint = |motion: BeamMotion| match &support[motion] {
        Restraint::Free => optional(motion.key(), Node::Text("free".to_owned()), true),
        Restraint::Fixed => text(motion.key(), "fixed"),
        Restraint::Elastic(elastic) => entry(
            motion.key(),
            Node::Inline(numbers(elastic, elastic_fields(motion))),
        ),
    };
    order.map(restraint).into()
}

fn subsystem(subsystem: &Subsystem) -> Vec<Entry> {
    let mut entries = vec![text("name", &subsystem.name), enabled(subsystem.enabled)];
    entries.extend(numbers(subsystem, SUBSYSTEM));
    for entry in &mut entries {
        let is_zero = matches!(entry.node, Node::Number(value) if value.to_bits() == 0);
        if is_zero && !subsystem.needs(&entry.key) {
            entry.presence = InNewTables;
        }
    }
    entries
}

/// Where and along what.
fn target(target: &Target) -> [Entry; 2] {
    match target {
        Target::Beam(place, motion) => {
            let at = match place {
                Place::Left => text("at", "left"),
                Place::Right => text("at", "right"),
                Place::Position(position) => entry("at", Node::Number(*position)),
            };
            [at, text("direction", motion.key())]
        }
        Target::Mass(name, motion) => [text("at", name), text("direction", motion.key())],
    }
}

fn force(force: &Force) -> Vec<Entry> {
    let mut entries = vec![enabled(force.enabled)];
    entries.extend(target(&force.target));
    entries.extend(numbers(force, FORCE));
    entries
}

fn response(response: &Response) -> Vec<Entry> {
    let mut entries = vec![text("name", &response.name), enabled(response.enabled)];
    match &response.quantity {
        Quantity::Motion(at, measure) => {
            entries.extend(target(at));
            let word = Node::Text(measure.key().to_owned());
            entries.push(optional("measure", word, *measure == Measure::default()));
        }
        Quantity::Energy => entries.push(text("measure", "energy")),
    }
    entries
}

fn sweep(model: &Model) -> Vec<Entry> {
    let sweep = &model.sweep;
    let mut entries = numbers(sweep, SWEEP);
    entries.push(entry("points", Node::Count(sweep.points)));
    let spacing = Node::Text(sweep.spacing.key().to_owned());
    let presence = if sweep.spacing == Spacing::default() {
        InNewTables
    } else {
        Always
    };
    entries.push(Entry {
        key: "spacing".into(),
        node: spacing,
        presence,
    });
    entries
}

fn study(study: &Study) -> Vec<Entry> {
    let mut entries = vec![text("name", &study.name)];
    match &study.family {
        Family::Vary {
            paths,
            operation,
            values,
        } => {
            entries.push(entry(
                "vary",
                Node::List(paths.iter().cloned().map(Node::Text).collect()),
            ));
            entries.push(entry(
                operation.key(),
                Node::List(values.iter().copied().map(Node::Number).collect()),
            ));
        }
        Family::Cases(cases) => {
            entries.push(entry("cases", Node::List(cases.iter().map(case).collect())));
        }
    }
    entries
}

fn case(case: &Case) -> Node {
    let set = case
        .set
        .iter()
        .map(|(path, value)| entry(path.clone(), Node::Number(*value)))
        .collect();
    Node::Inline(vec![
        text("name", &case.name),
        optional("set", Node::Ordered(set), case.set.is_empty()),
    ])
}
