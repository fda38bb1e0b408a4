//! The parts of a model file: beam, supports, subsystems, sweep.

use super::super::check::{FEWEST_POINTS, MOST_POINTS, element_keys};
use super::super::field::elastic_fields;
use super::super::field::{BEAM, Field, MATERIAL, SECTION, SUBSYSTEM, SWEEP};
use super::super::types::{
    Beam, BeamMotion, Elastic, Model, Restraint, Spacing, Spring, Subsystem, Support, Supports,
    Sweep,
};
use super::loads;
use super::plans;
use super::reader::{Reader, quoted};
use super::table::Table;
use super::tuning;
use super::value::{Node, whole, wrong_type};
use std::collections::HashMap;
use toml::de::DeValue;

/// The only format there is.
const FORMAT: &str = "beamtune/1";

/// The whole file; what cannot be read has a placeholder, of which the reader knows. `others` are names of subsystems
/// that are not in it.
pub(super) fn model(mut root: Table<'_>, others: &[&str], reader: &mut Reader) -> Model {
    root.word("format", &[FORMAT], None, reader);
    let title = root.text("title", None, reader).unwrap_or_default();
    let notes = root.text("notes", Some(""), reader).unwrap_or_default();
    let beam = beam(&mut root, reader);
    let supports = supports(&mut root, reader);
    let (subsystems, names) = subsystems(&mut root, reader);
    let names: Vec<&str> = names.into_iter().chain(others.iter().copied()).collect();
    let forces = loads::forces(&mut root, &names, reader);
    let responses = loads::responses(&mut root, &names, reader);
    let sweep = sweep(&mut root, reader);
    let studies = plans::studies(&mut root, reader);
    let tune = tuning::tune(&mut root, reader);
    root.finish(reader);
    Model {
        title,
        notes,
        beam,
        supports,
        subsystems,
        forces,
        responses,
        sweep,
        studies,
        tune,
    }
}

/// NaN for every number, where their table cannot be read.
fn blank<T>(of: &mut T, fields: &[Field<T>]) {
    for field in fields {
        (field.set)(of, f64::NAN);
    }
}

fn beam(root: &mut Table<'_>, reader: &mut Reader) -> Beam {
    let mut beam = Beam::default();
    blank(&mut beam, BEAM);
    blank(&mut beam.material, MATERIAL);
    blank(&mut beam.section, SECTION);
    let Some(mut table) = root.need_table("beam", reader) else {
        return beam;
    };
    table.numbers(&mut beam, BEAM, reader);
    if let Some(mut material) = table.need_table("material", reader) {
        material.numbers(&mut beam.material, MATERIAL, reader);
        material.finish(reader);
    }
    if let Some(mut section) = table.need_table("section", reader) {
        section.numbers(&mut beam.section, SECTION, reader);
        section.finish(reader);
    }
    table.finish(reader);
    beam
}

fn supports(root: &mut Table<'_>, reader: &mut Reader) -> Supports {
    let mut supports = Supports::default();
    if let Some(mut table) = root.table("supports", reader) {
        supports.left = support(table.table("left", reader), reader);
        supports.right = support(table.table("right", reader), reader);
        table.finish(reader);
    }
    supports
}

fn support(table: Option<Table<'_>>, reader: &mut Reader) -> Support {
    let mut support = Support::FREE;
    let Some(mut table) = table else {
        return support;
    };
    let kind = table.has("kind");
    if let Some(index) = table.word("kind", &["free", "pinned", "clamped"], Some(0), reader) {
        support = [Support::FREE, Support::PINNED, Support::CLAMPED][index];
    }
    let beside: Vec<_> = BeamMotion::ALL
        .map(BeamMotion::key)
        .into_iter()
        .filter(|key| table.has(key))
        .collect();
    for motion in BeamMotion::ALL {
        if let Some((path, node)) = table.take(motion.key(), reader) {
            let restraint = restraint(&path, node, motion, reader);
            if !kind {
                support[motion] = restraint;
            }
        }
    }
    if kind
        && !beside.is_empty()
        && let Some((path, node)) = table.take("kind", reader)
    {
        let message = format!(
            "stands beside {}; must be either kind or the six motions",
            beside.join(", ")
        );
        reader.fault(node.span().start, &path, message);
    }
    table.finish(reader);
    support
}

fn restraint(path: &str, node: Node<'_>, motion: BeamMotion, reader: &mut Reader) -> Restraint {
    match node.get_ref() {
        DeValue::String(word) if word == "free" => return Restraint::Free,
        DeValue::String(word) if word == "fixed" => return Restraint::Fixed,
        DeValue::Table(_) => {}
        other => {
            let inertia = if motion.is_translation() {
                "mass"
            } else {
                "inertia"
            };
            let accepted =
                format!("\"free\", \"fixed\" or a table of stiffness, damping and {inertia}");
            let message = match other {
                DeValue::String(word) => format!("is {}; must be {accepted}", quoted(word)),
                _ => wrong_type(node, &accepted),
            };
            reader.fault(node.span().start, path, message);
            return Restraint::Free;
        }
    }
    let mut elastic = Elastic::default();
    if let Some(mut table) = Table::open(path.to_owned(), node, reader) {
        table.numbers(&mut elastic, elastic_fields(motion), reader);
        table.finish(reader);
    }
    Restraint::Elastic(elastic)
}

/// The names in a list of tables; empty where there is none.
pub(super) fn names<'a>(list: &[Node<'a>]) -> Vec<&'a str> {
    list.iter()
        .map(|node| {
            node.get_ref()
                .get("name")
                .and_then(|name| name.get_ref().as_str())
                .unwrap_or("")
        })
        .collect()
}

/// The elements of a list of named tables, opened; none where an element is no table.
pub(super) fn named<'a>(
    list: &[Node<'a>],
    path: &str,
    reader: &mut Reader,
) -> Vec<Option<Table<'a>>> {
    let keys = element_keys(names(list).into_iter());
    let mut first = HashMap::new();
    for (node, key) in list.iter().zip(&keys) {
        if let Some(name) = node.get_ref().get("name")
            && let Some(word) = name
                .get_ref()
                .as_str()
                .filter(|word| !word.trim().is_empty())
        {
            let here = name.span().start;
            let there = *first.entry(word).or_insert(here);
            if here != there {
                reader.used_twice(here, &format!("{path}.{key}.name"), word, there);
            }
        }
    }
    list.iter()
        .zip(keys)
        .map(|(node, key)| Table::open(format!("{path}.{key}"), node, reader))
        .collect()
}

fn subsystems<'a>(root: &mut Table<'a>, reader: &mut Reader) -> (Vec<Subsystem>, Vec<&'a str>) {
    let list = root.list("subsystems", "tables", reader);
    let names = names(&list);
    reader.subsystem_lost = names.contains(&"") || (list.is_empty() && root.has("subsystems"));
    let subsystems = named(&list, "subsystems", reader)
        .into_iter()
        .map(|table| subsystem(table, reader))
        .collect();
    (subsystems, names)
}

fn subsystem(table: Option<Table<'_>>, reader: &mut Reader) -> Subsystem {
    let mut subsystem = Subsystem {
        name: String::new(),
        enabled: true,
        position: f64::NAN,
        mass: f64::NAN,
        inertia: f64::NAN,
        y_left: Spring::default(),
        y_right: Spring::default(),
        z_left: Spring::default(),
        z_right: Spring::default(),
        arm_left: f64::NAN,
        arm_right: f64::NAN,
        mount_y: f64::NAN,
        mount_z: f64::NAN,
    };
    if let Some(mut table) = table {
        subsystem.name = table.text("name", None, reader).unwrap_or_default();
        subsystem.enabled = table.enabled(reader);
        // Whether these matter is known when the springs are.
        let absent: Vec<&Field<Subsystem>> = SUBSYSTEM
            .iter()
            .filter(|field| Subsystem::OF_SPRINGS.contains(&field.key) && !table.has(field.key))
            .collect();
        let keys: Vec<&str> = absent.iter().map(|field| field.key).collect();
        table.numbers_or(&mut subsystem, SUBSYSTEM, &keys, reader);
        for field in absent {
            if subsystem.needs(field.key) {
                table.miss_number(field.key, field.range);
            }
        }
        table.finish(reader);
    }
    subsystem
}

fn sweep(root: &mut Table<'_>, reader: &mut Reader) -> Sweep {
    let mut sweep = Sweep {
        from: f64::NAN,
        to: f64::NAN,
        points: FEWEST_POINTS,
        spacing: Spacing::default(),
    };
    let Some(mut table) = root.need_table("sweep", reader) else {
        return sweep;
    };
    table.numbers(&mut sweep, SWEEP, reader);
    let expected = format!("a whole number, {FEWEST_POINTS} to {MOST_POINTS}");
    if let Some((path, node)) = table.need("points", &expected, reader) {
        match (
            whole(node).map(usize::try_from),
            node.get_ref().as_integer(),
        ) {
            (Some(Ok(points)), _) => sweep.points = points,
            (_, Some(integer)) => reader.fault(
                node.span().start,
                &path,
                format!("is {integer}; must be {expected}"),
            ),
            _ => reader.fault(node.span().start, &path, wrong_type(node, &expected)),
        }
    }
    let spacings = Spacing::ALL;
    if let Some(index) = table.word("spacing", &spacings.map(Spacing::key), Some(0), reader) {
        sweep.spacing = spacings[index];
    }
    table.finish(reader);
    sweep
}
