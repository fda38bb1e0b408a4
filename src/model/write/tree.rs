//! A model as a tree of keys and values.

use super::super::beam::{BeamMotion, Foundation, Span};
use super::super::id::{Group, SupportId};
use super::super::part::Part;
use super::super::quantity::Response;
use super::super::schema::{
    self, Access, FORCE, FOUNDATION, JOINT, Key, Kind, MATERIAL, RESPONSE, Rows, SECTION, SPAN,
    SUBSYSTEM, SWEEP,
};
use super::super::spring::{Spring, SpringName};
use super::super::types::{
    At, Case, Family, Force, InnerSupport, Joint, Link, Model, Place, Restraint, Study, Subsystem,
    Support, Supports,
};
use super::node::{Entry, Node, Presence};
use super::tuning;
use crate::unit::Measure;
use std::borrow::Cow;
use toml_edit::{Item, Table, TableLike};

use Presence::{Always, InNewTables, OnlyIfThere};

/// Keys that a new table shows also at their default.
const SHOWN_DEFAULTS: [&str; 4] = ["stiffness", "damping", "amplitude", "spacing"];

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

/// An entry that may be at its default.
pub(super) fn optional(key: &'static str, node: Node, at_default: bool) -> Entry {
    Entry {
        key: key.into(),
        node,
        presence: if at_default { OnlyIfThere } else { Always },
    }
}

/// The tree of a model; supports and tuning take their form from the original.
pub(super) fn model(model: &Model, original: &Table) -> Vec<Entry> {
    let mut root = vec![text("format", "beamtune/1")];
    root.extend(rows(model, &schema::MODEL));
    root.extend([
        entry("beam", Node::Table(beam(model))),
        supports(&model.supports, original),
        tables("joints", model.joints.iter().map(joint).collect()),
        tables(
            "subsystems",
            model.subsystems.iter().map(subsystem).collect(),
        ),
        tables("forces", model.forces.iter().map(force).collect()),
        tables("responses", model.responses.iter().map(response).collect()),
        entry("sweep", Node::Table(rows(&model.sweep, &SWEEP))),
        tables("studies", model.studies.iter().map(study).collect()),
    ]);
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

/// The keys of a table of the schema that have no rules of their own; keys with a dot form inline tables.
pub(super) fn rows<T>(of: &T, rows: &Rows<T>) -> Vec<Entry> {
    let mut entries = Vec::new();
    for (key, access) in rows.iter() {
        let (node, at_default) = match access {
            Access::Number(get, _) => {
                let value = get(of);
                let default = key.default.map(f64::to_bits);
                (Node::Number(value), default == Some(value.to_bits()))
            }
            Access::OptionalNumber(get, _) => {
                entries.extend(get(of).map(|number| entry(key.key, Node::Number(number))));
                continue;
            }
            Access::Count(get, _) => (Node::Count(get(of)), false),
            Access::Flag(get, _) => (Node::Flag(get(of)), get(of) == key.is_on_by_default()),
            Access::Word(get, _) => (Node::Text(key.words[get(of)].to_owned()), get(of) == 0),
            Access::Text(get, _) => {
                let at_default = key.kind == Kind::Text && get(of).is_empty();
                (Node::Text(get(of).clone()), at_default)
            }
            Access::Optional(get, _) => {
                entries.extend(get(of).map(|words| text(key.key, words)));
                continue;
            }
            // Its own rules write it.
            Access::Own => continue,
        };
        push(&mut entries, key, node, at_default);
    }
    entries
}

/// Adds an entry, in its inner table if the key has a dot.
fn push(entries: &mut Vec<Entry>, key: &Key, node: Node, at_default: bool) {
    let (head, key) = match key.key.split_once('.') {
        Some((head, key)) => (Some(head), key),
        None => (None, key.key),
    };
    let shown = SHOWN_DEFAULTS.contains(&key);
    let mut new = optional(key, node, at_default);
    if at_default && shown {
        new.presence = InNewTables;
    }
    let Some(head) = head else {
        return entries.push(new);
    };
    match entries.last_mut() {
        Some(Entry {
            key,
            node: Node::Inline(inner),
            presence,
        }) if *key == head => {
            inner.push(new);
            if !at_default {
                *presence = Always;
            }
        }
        _ => entries.push(optional(head, Node::Inline(vec![new]), at_default)),
    }
}

fn beam(model: &Model) -> Vec<Entry> {
    let beam = &model.beam;
    let mut entries = rows(beam, &schema::BEAM);
    if !model.spans.is_empty() {
        entries.retain(|entry| entry.key != "length");
    }
    let (material, section) = (
        rows(&beam.material, &MATERIAL),
        rows(&beam.section, &SECTION),
    );
    let is_left_out = |table: Group| !table.is_there(model);
    entries.extend([
        optional(
            "material",
            Node::Table(material),
            is_left_out(Group::Material(Part::Whole)),
        ),
        optional(
            "section",
            Node::Table(section),
            is_left_out(Group::Section(Part::Whole)),
        ),
        optional(
            "foundation",
            Node::Table(rows(&beam.foundation, &FOUNDATION)),
            beam.foundation == Foundation::default(),
        ),
        tables("spans", model.spans.iter().map(span).collect()),
    ]);
    entries
}

fn span(span: &Span) -> Vec<Entry> {
    let mut entries = rows(span, &SPAN);
    let mut own = |key, table: Option<Vec<Entry>>| {
        entries.extend(table.map(|rows| entry(key, Node::Table(rows))));
    };
    own("material", span.material.map(|of| rows(&of, &MATERIAL)));
    own("section", span.section.map(|of| rows(&of, &SECTION)));
    own(
        "foundation",
        span.foundation.map(|of| rows(&of, &FOUNDATION)),
    );
    entries
}

fn supports(supports: &Supports, original: &Table) -> Entry {
    let original = original.get("supports").and_then(Item::as_table_like);
    let end = |key: &'static str, support: &Support| {
        let original = original
            .and_then(|table| table.get(key))
            .and_then(Item::as_table_like);
        let node = Node::Table(self::support(support, original));
        in_new_tables(key, node, *support == Support::FREE)
    };
    let [left, right] = SupportId::WORDS;
    let inner = original.and_then(|table| table.get("inner"));
    let inner = |support: &InnerSupport| {
        let is_it = |table: &&Table| {
            table.get("name").and_then(Item::as_str) == Some(support.name.as_str())
        };
        let mut tables = inner
            .and_then(Item::as_array_of_tables)
            .into_iter()
            .flatten();
        let original = tables.find(is_it).map(|table| table as &dyn TableLike);
        let mut entries = rows(support, &schema::INNER_SUPPORT);
        entries.extend(self::support(&support.support, original));
        entries
    };
    let all = vec![
        end(left, &supports.left),
        end(right, &supports.right),
        tables("inner", supports.inner.iter().map(inner).collect()),
    ];
    let is_free = *supports == Supports::default();
    in_new_tables("supports", Node::Table(all), is_free)
}

/// An entry that a new table shows also at its default.
fn in_new_tables(key: &'static str, node: Node, at_default: bool) -> Entry {
    Entry {
        key: key.into(),
        node,
        presence: if at_default { InNewTables } else { Always },
    }
}

/// A support: one word if it has one and the original does not list the six motions; then its point.
fn support(support: &Support, original: Option<&dyn TableLike>) -> Vec<Entry> {
    let by_kind = original.is_none_or(|table| table.contains_key("kind"));
    let mut entries = match support.word().filter(|_| by_kind) {
        Some(kind) => vec![text("kind", kind)],
        None => restraints(support),
    };
    entries.extend(rows(support, &schema::SUPPORT));
    entries
}

/// The order of the motions in a file.
const ORDER: [BeamMotion; 6] = [
    BeamMotion::W,
    BeamMotion::V,
    BeamMotion::Psi,
    BeamMotion::WSlope,
    BeamMotion::VSlope,
    BeamMotion::PsiSlope,
];

fn joint(joint: &Joint) -> Vec<Entry> {
    let mut entries = rows(joint, &JOINT);
    entries.extend(ORDER.map(|motion| match &joint[motion] {
        joined @ (Link::Rigid | Link::Free) => {
            let word = Node::Text(joined.kind().to_owned());
            optional(motion.key(), word, *joined == Link::Rigid)
        }
        Link::Elastic(spring) => {
            let mut entries = rows(spring, schema::link(motion));
            entries.push(maxwell(spring));
            entry(motion.key(), Node::Inline(entries))
        }
    }));
    entries
}

fn restraints(support: &Support) -> Vec<Entry> {
    let restraint = |motion: BeamMotion| match &support[motion] {
        held @ (Restraint::Free | Restraint::Fixed) => {
            let word = Node::Text(held.kind().to_owned());
            optional(motion.key(), word, *held == Restraint::Free)
        }
        Restraint::Elastic(elastic) => {
            let mut entries = rows(elastic, schema::elastic(motion));
            entries.push(maxwell(&elastic.spring));
            entry(motion.key(), Node::Inline(entries))
        }
    };
    ORDER.map(restraint).into()
}

/// The Maxwell branches of a spring.
fn maxwell(spring: &Spring) -> Entry {
    // The units differ with the motion, the keys do not.
    let branch = |of| Node::Inline(rows(of, &schema::BRANCH_TRANSLATION));
    let list = spring.maxwell.iter().map(branch).collect();
    optional("maxwell", Node::List(list), spring.maxwell.is_empty())
}

fn subsystem(subsystem: &Subsystem) -> Vec<Entry> {
    let mut entries = rows(subsystem, &SUBSYSTEM);
    for entry in &mut entries {
        if let Some(spring) = SpringName::of_word(&entry.key)
            && let Node::Inline(inner) = &mut entry.node
        {
            let spring = subsystem.springs()[spring as usize];
            inner.push(maxwell(spring));
            if !spring.maxwell.is_empty() {
                entry.presence = Always;
            }
        }
        // A 0 that a spring or damper uses is written.
        if Subsystem::OF_SPRINGS.contains(&&*entry.key) && entry.presence != Always {
            let needed = subsystem.needs(&entry.key);
            entry.presence = if needed { Always } else { InNewTables };
        }
    }
    entries
}

/// Position and direction.
fn position(at: At<'_>, direction: &str) -> [Entry; 2] {
    let at = match at {
        At::Beam(Place::Left) => text("at", "left"),
        At::Beam(Place::Right) => text("at", "right"),
        At::Beam(Place::Position(position)) => entry("at", Node::Number(position)),
        At::Subsystem(name) | At::Support(name) => text("at", name),
        At::Ground => text("at", "ground"),
    };
    [at, text("direction", direction)]
}

fn force(force: &Force) -> Vec<Entry> {
    let mut entries = rows(force, &FORCE);
    let target = &force.target;
    insert_before(&mut entries, "y", position(target.at(), target.direction()));
    entries
}

/// Inserts entries before one with a key, or at the end.
fn insert_before(entries: &mut Vec<Entry>, key: &str, new: impl IntoIterator<Item = Entry>) {
    let found = entries.iter().position(|entry| entry.key == key);
    let at = found.unwrap_or(entries.len());
    entries.splice(at..at, new);
}

fn response(response: &Response) -> Vec<Entry> {
    let mut entries = rows(response, &RESPONSE);
    let quantity = &response.quantity;
    if let (Some(at), Some(direction)) = (quantity.at(), quantity.direction()) {
        insert_before(&mut entries, "y", position(at, direction));
    }
    let word = quantity.word();
    let measure = optional(
        "measure",
        Node::Text(word.to_owned()),
        word == Measure::default().key(),
    );
    insert_before(&mut entries, "over", [measure]);
    entries
}

fn study(study: &Study) -> Vec<Entry> {
    let mut entries = rows(study, &schema::STUDY);
    match &study.family {
        Family::Vary {
            paths,
            operation,
            values,
        } => {
            entries.push(entry(
                "vary",
                Node::List(
                    paths
                        .iter()
                        .map(|path| Node::Text(path.to_string()))
                        .collect(),
                ),
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
        .map(|(path, value)| entry(path.to_string(), Node::Number(*value)))
        .collect();
    Node::Inline(vec![
        text("name", &case.name),
        optional("set", Node::Ordered(set), case.set.is_empty()),
    ])
}
