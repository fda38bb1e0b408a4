//! The parts of a model file: beam, supports, subsystems, sweep.

use super::super::beam::{Beam, BeamMotion, Span};
use super::super::id::SupportId;
use super::super::schema::{
    self, Access, FEWEST_POINTS, FOUNDATION, JOINT, MATERIAL, Rows, SECTION, SPAN, SUBSYSTEM,
};
use super::super::spring::{Elastic, MaxwellBranch, Spring, SpringName};
use super::super::types::{
    InnerSupport, Joint, Link, Model, Restraint, Spacing, Subsystem, Support, Supports, Sweep,
};
use super::list::{elements, named, names};
use super::loads;
use super::reader::{Reader, quoted};
use super::rows::no_own;
use super::studies;
use super::table::Table;
use super::tuning;
use super::value::{Node, wrong_type};
use toml::de::DeValue;

/// The only supported format.
const FORMAT: &str = "beamtune/1";

/// The whole file, with placeholders for unreadable parts, which the reader knows. `others` are names of subsystems
/// outside the file.
pub(super) fn model(mut root: Table<'_>, others: &[&str], reader: &mut Reader) -> Model {
    root.word("format", &[FORMAT], None, reader);
    let mut model = Model::default();
    root.rows(&mut model, &schema::MODEL, reader, no_own);
    (model.beam, model.spans) = beam(&mut root, reader);
    model.supports = supports(&mut root, reader);
    model.joints = joints(&mut root, reader);
    let (subsystems, names) = subsystems(&mut root, reader);
    model.subsystems = subsystems;
    let names: Vec<&str> = names.into_iter().chain(others.iter().copied()).collect();
    model.forces = loads::forces(&mut root, &names, reader);
    model.responses = loads::responses(&mut root, &names, reader);
    model.sweep = sweep(&mut root, reader);
    model.studies = studies::studies(&mut root, reader);
    model.tune = tuning::tune(&mut root, reader);
    root.finish(reader);
    model
}

/// NaN for every number of an unreadable table.
fn blank<T: Default>(rows: &Rows<T>) -> T {
    let mut blank = T::default();
    for access in rows.access {
        if let Access::Number(_, set) = access {
            set(&mut blank, f64::NAN);
        }
    }
    blank
}

fn beam(root: &mut Table<'_>, reader: &mut Reader) -> (Beam, Vec<Span>) {
    let mut beam = Beam {
        material: blank(&MATERIAL),
        section: blank(&SECTION),
        ..blank(&schema::BEAM)
    };
    let Some(mut table) = root.need_table("beam", reader) else {
        return (beam, Vec::new());
    };
    let spans = spans(&mut table, reader);
    table.rows(&mut beam, &schema::BEAM, reader, no_own);
    table.replaceable("length", "spans", reader);
    if !spans.is_empty() {
        beam.length = 0.0;
    }
    let all_own = |own: fn(&Span) -> bool| !spans.is_empty() && spans.iter().all(own);
    if all_own(|span| span.material.is_some()) {
        beam.material = own(&mut table, "material", &MATERIAL, reader).unwrap_or_default();
    } else {
        beam.material = filled(table.need_table("material", reader), &MATERIAL, reader);
    }
    if all_own(|span| span.section.is_some()) {
        beam.section = own(&mut table, "section", &SECTION, reader).unwrap_or_default();
    } else {
        beam.section = filled(table.need_table("section", reader), &SECTION, reader);
    }
    beam.foundation = own(&mut table, "foundation", &FOUNDATION, reader).unwrap_or_default();
    table.finish(reader);
    (beam, spans)
}

fn spans(beam: &mut Table<'_>, reader: &mut Reader) -> Vec<Span> {
    let list = beam.list("spans", "tables", reader);
    let numbered = list.into_iter().enumerate();
    numbered
        .map(|(index, node)| {
            let mut span = blank(&SPAN);
            let path = format!("beam.spans.{}", index + 1);
            if let Some(mut table) = Table::open(path, node, reader) {
                table.rows(&mut span, &SPAN, reader, no_own);
                span.material = own(&mut table, "material", &MATERIAL, reader);
                span.section = own(&mut table, "section", &SECTION, reader);
                span.foundation = own(&mut table, "foundation", &FOUNDATION, reader);
                table.finish(reader);
            }
            span
        })
        .collect()
}

/// An optional table without keys of their own rules.
fn own<'a, T: Default>(
    table: &mut Table<'a>,
    key: &'a str,
    rows: &Rows<T>,
    reader: &mut Reader,
) -> Option<T> {
    table.accept(key);
    let is_there = table.has(key);
    is_there.then(|| filled(table.table(key, reader), rows, reader))
}

/// The keys of a table; placeholders if it is missing or unreadable.
fn filled<T: Default>(table: Option<Table<'_>>, rows: &Rows<T>, reader: &mut Reader) -> T {
    let mut filled = blank(rows);
    if let Some(mut table) = table {
        table.rows(&mut filled, rows, reader, no_own);
        table.finish(reader);
    }
    filled
}

fn supports(root: &mut Table<'_>, reader: &mut Reader) -> Supports {
    let mut supports = Supports::default();
    if let Some(mut table) = root.table("supports", reader) {
        let [left, right] = SupportId::WORDS;
        supports.left = end(table.table(left, reader), reader);
        supports.right = end(table.table(right, reader), reader);
        let list = table.list("inner", "tables", reader);
        supports.inner = named(&list, "supports.inner", reader)
            .into_iter()
            .map(|table| inner_support(table, reader))
            .collect();
        table.finish(reader);
    }
    supports
}

/// An end; free without a table.
fn end(table: Option<Table<'_>>, reader: &mut Reader) -> Support {
    table.map_or(Support::FREE, |mut table| {
        let support = support(&mut table, reader);
        table.finish(reader);
        support
    })
}

fn inner_support(table: Option<Table<'_>>, reader: &mut Reader) -> InnerSupport {
    let mut inner = blank(&schema::INNER_SUPPORT);
    if let Some(mut table) = table {
        table.rows(&mut inner, &schema::INNER_SUPPORT, reader, no_own);
        inner.support = support(&mut table, reader);
        table.finish(reader);
    }
    inner
}

/// The keys that every support has.
fn support(table: &mut Table<'_>, reader: &mut Reader) -> Support {
    let mut support = Support::FREE;
    let kind = table.has("kind");
    if let Some(index) = table.word("kind", &Support::WORDS, Some(0), reader) {
        support
            .restraints
            .clone_from(&Support::KINDS[index].restraints);
    }
    let motions = BeamMotion::WORDS.iter().copied();
    let conflicting: Vec<_> = motions.filter(|key| table.has(key)).collect();
    for motion in BeamMotion::ALL {
        if let Some((path, node)) = table.take(motion.key(), reader) {
            let restraint = restraint(&path, node, motion, reader);
            if !kind {
                support[motion] = restraint;
            }
        }
    }
    if kind
        && !conflicting.is_empty()
        && let Some((path, node)) = table.take("kind", reader)
    {
        let message = format!(
            "cannot be combined with {}; must be either kind or the six motions",
            conflicting.join(", ")
        );
        reader.fault(node.span().start, &path, message);
    }
    table.rows(&mut support, &schema::SUPPORT, reader, no_own);
    support
}

fn restraint(path: &str, node: Node<'_>, motion: BeamMotion, reader: &mut Reader) -> Restraint {
    let word = node.get_ref().as_str().and_then(Restraint::of_word);
    match (word, node.get_ref()) {
        (Some(held @ (Restraint::Free | Restraint::Fixed)), _) => return held,
        (_, DeValue::Table(_)) => {}
        (_, other) => {
            let inertia = if motion.is_translation() {
                "mass"
            } else {
                "inertia"
            };
            let accepted = format!(
                "\"free\", \"fixed\" or a table of stiffness, damping, loss_factor, maxwell and {inertia}"
            );
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
        table.rows(&mut elastic, schema::elastic(motion), reader, no_own);
        elastic.spring.maxwell = maxwell(&mut table, motion, reader);
        table.finish(reader);
    }
    Restraint::Elastic(elastic)
}

fn joints(root: &mut Table<'_>, reader: &mut Reader) -> Vec<Joint> {
    let list = root.list("joints", "tables", reader);
    let mut joints = Vec::new();
    for (index, node) in list.into_iter().enumerate() {
        let mut joint = blank(&JOINT);
        if let Some(mut table) = Table::open(format!("joints.{}", index + 1), node, reader) {
            table.rows(&mut joint, &JOINT, reader, no_own);
            for motion in BeamMotion::ALL {
                if let Some((path, node)) = table.take(motion.key(), reader) {
                    joint[motion] = link(&path, node, motion, reader);
                }
            }
            table.finish(reader);
        } else {
            // An unreadable joint is not one that joins everything.
            joint.links = [const { Link::Free }; 6];
        }
        joints.push(joint);
    }
    joints
}

fn link(path: &str, node: Node<'_>, motion: BeamMotion, reader: &mut Reader) -> Link {
    const ACCEPTED: &str =
        "\"rigid\", \"free\" or a table of stiffness, damping, loss_factor and maxwell";
    let word = node.get_ref().as_str().and_then(Link::of_word);
    match (word, node.get_ref()) {
        (Some(joined @ (Link::Rigid | Link::Free)), _) => return joined,
        (_, DeValue::Table(_)) => {}
        (_, other) => {
            let message = match other {
                DeValue::String(word) => format!("is {}; must be {ACCEPTED}", quoted(word)),
                _ => wrong_type(node, ACCEPTED),
            };
            reader.fault(node.span().start, path, message);
            return Link::Free;
        }
    }
    let mut spring = Spring::default();
    if let Some(mut table) = Table::open(path.to_owned(), node, reader) {
        table.rows(&mut spring, schema::link(motion), reader, no_own);
        spring.maxwell = maxwell(&mut table, motion, reader);
        table.finish(reader);
    }
    Link::Elastic(spring)
}

/// The Maxwell branches of a spring of a motion.
fn maxwell(spring: &mut Table<'_>, motion: BeamMotion, reader: &mut Reader) -> Vec<MaxwellBranch> {
    let rows = schema::branch(motion);
    let list = elements("maxwell", "tables { stiffness, damping }", spring, reader);
    let branch = |(path, node)| {
        let mut branch = blank(rows);
        if let Some(mut table) = Table::open(path, node, reader) {
            table.rows(&mut branch, rows, reader, no_own);
            table.finish(reader);
        }
        branch
    };
    list.into_iter().map(branch).collect()
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
    let mut subsystem = blank(&SUBSYSTEM);
    if let Some(mut table) = table {
        let inner = table.open_rows(&mut subsystem, &SUBSYSTEM, reader, no_own);
        for (key, mut spring) in inner {
            if let Some(name) = SpringName::of_word(key) {
                let maxwell = maxwell(&mut spring, BeamMotion::W, reader);
                subsystem.springs_mut()[name as usize].maxwell = maxwell;
            }
            spring.finish(reader);
        }
        // Whether these are required depends on the springs.
        for key in SUBSYSTEM.keys {
            if Subsystem::OF_SPRINGS.contains(&key.key)
                && !table.has(key.key)
                && subsystem.needs(key.key)
            {
                table.miss_number(key.key, key.range);
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
    if let Some(mut table) = root.need_table("sweep", reader) {
        table.rows(&mut sweep, &schema::SWEEP, reader, no_own);
        table.finish(reader);
    }
    sweep
}
