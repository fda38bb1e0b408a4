//! The summary of a group of the tree.

use std::f64::consts::PI;

use crate::model::{
    Group, Material, MaxwellBranch, Model, Section, Subsystem, SupportId, UniformPart, Unit,
    counted,
};
use crate::tui::keys::{CurvesCommand, KeyMap, ModelCommand, TuneCommand};
use crate::tui::tree::{self, Node};
use crate::tune::words;

fn branch(branch: &MaxwellBranch) -> String {
    let most = branch.stiffness / branch.damping / (2.0 * PI);
    if most.is_finite() {
        let most = Unit::HERTZ.format(most);
        format!("a spring and a damper in series: most loss at {most}, stiff above, soft below")
    } else {
        "a spring and a damper in series".to_owned()
    }
}

/// The details of a row that is not a parameter, one line per fact.
pub(crate) fn of(model: &Model, node: Node, keys: &KeyMap) -> String {
    let group = match node {
        Node::Group(group) => group,
        Node::StudyLine(..) => return tree::label(model, node).into_owned(),
        Node::Parameter(_) => return String::new(),
    };
    match group {
        Group::Beam => format!(
            "{}; {} adds a span",
            mass(model.beam_mass()),
            keys.key_of(ModelCommand::Add)
        ),
        Group::Material(part) => part.material(model).map_or_else(String::new, material),
        Group::Section(part) => part.section(model).map_or_else(String::new, section),
        Group::Spans => format!(
            "uniform parts of the beam, from left to right; {} divides the last one, {} gives one to its neighbour",
            keys.key_of(ModelCommand::Add),
            keys.key_of(ModelCommand::Delete)
        ),
        Group::Span(i) => span(&model.uniform_parts()[i]),
        Group::Supports => format!(
            "the ends, and what holds the beam between them; {} on a support selects the next kind, {} adds one",
            keys.key_of(ModelCommand::Cycle),
            keys.key_of(ModelCommand::Add)
        ),
        Group::Support(SupportId::Inner(i)) => {
            let inner = &model.supports.inner[i];
            let position = Unit::METRE.format(inner.position);
            format!("{} support at {position}", inner.support.kind())
        }
        Group::Subsystems => enabled_of(model.subsystems.iter().map(|one| one.enabled), keys),
        Group::Forces => enabled_of(model.forces.iter().map(|one| one.enabled), keys),
        Group::Responses => enabled_of(model.responses.iter().map(|one| one.enabled), keys),
        Group::Subsystem(i) => subsystem(&model.subsystems[i]),
        Group::Branch(spring, i) => spring
            .branches(model)
            .get(i)
            .map_or_else(String::new, branch),
        Group::Force(_) | Group::Response(_) => tree::value(model, node),
        Group::Sweep => counted(model.sweep.points, "frequency", "frequencies"),
        Group::Studies | Group::Study(_) => {
            let (edit, study) = (
                keys.key_of(ModelCommand::Edit),
                keys.key_of(CurvesCommand::Study),
            );
            format!("{edit} shows a study's curves, {study} the next study's")
        }
        Group::Tune => format!(
            "variables and objectives of a search; {} starts it",
            keys.key_of(TuneCommand::Tune)
        ),
        Group::Variable(i) => tree::variable_at(model, i)
            .map_or_else(String::new, |variable| words::variable(model, variable)),
        Group::Objective(i) => tree::objective_at(model, i)
            .map_or_else(String::new, |objective| words::objective(model, objective)),
        Group::Limit(i) => tree::limit_at(model, i).map_or_else(String::new, |limit| {
            words::of_limit(model, limit, |of| of.whole)
        }),
        _ => String::new(),
    }
}

fn mass(mass: f64) -> String {
    format!("mass {}", Unit::KILOGRAM.format(mass))
}

fn span(part: &UniformPart) -> String {
    let [start, end] = [part.start, part.end].map(|x| Unit::METRE.format(x));
    let start = tree::without_unit_of(&start, &end);
    format!("from {start} to {end}\n{}", mass(part.mass()))
}

fn material(material: &Material) -> String {
    let e = Unit::PASCAL.format(material.young_modulus);
    let g = Unit::PASCAL.format(material.shear_modulus);
    let density = Unit::DENSITY.format(material.density);
    format!("E {e}\nG {g}\nrho {density}, eta {}", material.loss_factor)
}

fn section(section: &Section) -> String {
    let area = Unit::AREA.format(section.area);
    let moments =
        [section.second_moment_y, section.second_moment_z].map(|of| Unit::METRE_4.format(of));
    let product = (section.product_moment != 0.0)
        .then(|| format!("I_yz {}", Unit::METRE_4.format(section.product_moment)));
    let along_y = (section.centroid_offset_y != 0.0)
        .then(|| format!("y_c {}", Unit::METRE.format(section.centroid_offset_y)));
    let mut lines = vec![
        format!("A {area}"),
        format!("I_y {}", moments[0]),
        format!("I_z {}", moments[1]),
    ];
    lines.extend(product);
    lines.extend(along_y);
    lines.push(format!(
        "z_c {}",
        Unit::METRE.format(section.centroid_offset)
    ));
    lines.join("\n")
}

/// A subsystem's mass, and its frequencies on springs with fixed other ends and without arms.
fn subsystem(one: &Subsystem) -> String {
    let alone = |stiffness: f64| Unit::HERTZ.format((stiffness / one.mass).sqrt() / (2.0 * PI));
    format!(
        "{} on a fixed base:\ny {}\nz {} (arms aside)",
        Unit::KILOGRAM.format(one.mass),
        alone(one.y_left.stiffness + one.y_right.stiffness),
        alone(one.z_left.stiffness + one.z_right.stiffness),
    )
}

fn enabled_of(enabled: impl ExactSizeIterator<Item = bool>, keys: &KeyMap) -> String {
    let all = enabled.len();
    let enabled = enabled.filter(|enabled| *enabled).count();
    match all {
        0 => format!("none; {} adds one", keys.key_of(ModelCommand::Add)),
        _ if enabled == all => format!("{all}, all enabled"),
        _ => format!("{all}, of which {enabled} enabled"),
    }
}
