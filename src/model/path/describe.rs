//! What a person is told of a parameter.

use super::address::{Address, Key, Owner};
use super::value::ENERGY;
use super::{Parameter, Value, target};
use crate::model::check::{FEWEST_POINTS, MOST_POINTS};
use crate::model::field::Field;
use crate::model::types::{
    BeamMotion, Force, MassMotion, Measure, Model, Quantity, Section, Spacing, Subsystem, Sweep,
    Target,
};
use crate::model::unit::Unit;

/// The parameter of an address, with its value.
pub(super) fn parameter(model: &Model, address: &Address, value: Value) -> Parameter {
    let path = address.path(model);
    let blank = Parameter {
        path,
        symbol: "",
        unit: Unit::ONE,
        meaning: "",
        range: String::new(),
        choices: Vec::new(),
        value,
    };
    match address.leaf.key {
        Key::Beam(field) => row(field, blank),
        Key::Material(field) => row(field, blank),
        Key::Section(field) => Parameter {
            range: section_range(model, field),
            ..row(field, blank)
        },
        Key::Elastic(_, field) => row(field, blank),
        Key::Subsystem(field) => Parameter {
            range: subsystem_range(model, field),
            ..row(field, blank)
        },
        Key::Force(field) => Parameter {
            unit: force_unit(model, address.owner, field),
            ..row(field, blank)
        },
        Key::Sweep(field) => Parameter {
            range: sweep_range(model, field),
            ..row(field, blank)
        },
        Key::Kind | Key::Restraint(_) | Key::Measure | Key::Direction | Key::Spacing => {
            choice(model, address, blank)
        }
        Key::Points | Key::Title | Key::Notes | Key::Name | Key::Enabled | Key::At => {
            other(model, address, blank)
        }
    }
}

/// The parameters that are neither numbers of the table nor choices.
fn other(model: &Model, address: &Address, blank: Parameter) -> Parameter {
    let (meaning, range) = match address.leaf.key {
        Key::Points => (
            "number of frequencies, both ends included",
            format!("{FEWEST_POINTS} to {MOST_POINTS}"),
        ),
        Key::Title => ("one line for people", "one line of text".to_owned()),
        Key::Name => (
            name_meaning(address.owner),
            "a name that no other has".to_owned(),
        ),
        Key::Enabled => (enabled_meaning(address.owner), "true or false".to_owned()),
        Key::At => (
            "where on the beam, or which subsystem",
            target::places(model),
        ),
        _ => ("notes", "any text".to_owned()),
    };
    Parameter {
        meaning,
        range,
        ..blank
    }
}

/// What a row of the table of numbers says.
fn row<T>(field: &Field<T>, blank: Parameter) -> Parameter {
    Parameter {
        symbol: field.symbol,
        unit: field.unit,
        meaning: field.meaning,
        range: field.range.words().to_owned(),
        ..blank
    }
}

fn choice(model: &Model, address: &Address, blank: Parameter) -> Parameter {
    let (meaning, choices) = match (address.leaf.key, address.owner) {
        (Key::Restraint(motion), _) => {
            (restraint_meaning(motion), vec!["free", "fixed", "elastic"])
        }
        (Key::Measure, _) => {
            let measures = Measure::ALL.map(Measure::key).into_iter();
            ("what is computed", measures.chain([ENERGY]).collect())
        }
        (Key::Spacing, _) => (
            "how the frequencies are spread",
            Spacing::ALL.map(Spacing::key).to_vec(),
        ),
        (Key::Direction, Owner::Force(index)) => (
            "along what it acts",
            target::directions(&model.forces[index].target),
        ),
        (Key::Direction, Owner::Response(index)) => (
            "which motion",
            match &model.responses[index].quantity {
                Quantity::Motion(target, _) => target::directions(target),
                Quantity::Energy => Vec::new(),
            },
        ),
        _ => {
            // What is mixed comes from the single motions and cannot be chosen here.
            let mixed = (blank.value == Value::Choice("elastic")).then_some("elastic");
            (
                "what holds the end; elastic: see its motions",
                ["free", "pinned", "clamped"]
                    .into_iter()
                    .chain(mixed)
                    .collect(),
            )
        }
    };
    Parameter {
        meaning,
        range: choices.join(", "),
        choices,
        ..blank
    }
}

const fn restraint_meaning(motion: BeamMotion) -> &'static str {
    match motion {
        BeamMotion::W => "what holds w, the displacement along y",
        BeamMotion::Psi => "what holds psi, the twist about x",
        BeamMotion::V => "what holds v, the displacement along z",
        BeamMotion::WSlope => "what holds the slope of w",
        BeamMotion::PsiSlope => "what holds the rate of twist; fixed: warping restrained",
        BeamMotion::VSlope => "what holds the slope of v",
    }
}

const fn name_meaning(owner: Owner) -> &'static str {
    match owner {
        Owner::Subsystem(_) => "name of the subsystem",
        Owner::Response(_) => "name of the response",
        _ => "name of the study",
    }
}

const fn enabled_meaning(owner: Owner) -> &'static str {
    match owner {
        Owner::Subsystem(_) => "whether it is attached",
        Owner::Force(_) => "whether it acts",
        _ => "whether it is computed",
    }
}

/// The range of a section's number, with the rules between two of them.
fn section_range(model: &Model, field: &Field<Section>) -> String {
    let section = &model.beam.section;
    match field.key {
        "polar_moment" => {
            let least = section.area * section.centroid_offset * section.centroid_offset;
            format!("> A z_c^2 = {}", Unit::METRE_4.format(least))
        }
        "torsion_constant" if section.warping_constant == 0.0 => {
            "> 0 without a warping constant".to_owned()
        }
        "warping_constant" if section.torsion_constant == 0.0 => {
            "> 0 without a torsion constant".to_owned()
        }
        _ => field.range.words().to_owned(),
    }
}

fn subsystem_range(model: &Model, field: &Field<Subsystem>) -> String {
    match field.key {
        "position" => format!("0 to {} m", short(model.beam.length)),
        _ => field.range.words().to_owned(),
    }
}

fn sweep_range(model: &Model, field: &Field<Sweep>) -> String {
    match field.key {
        "from" => format!("> 0, below {} Hz", short(model.sweep.to)),
        _ => format!("above {} Hz", short(model.sweep.from)),
    }
}

fn short(value: f64) -> String {
    Unit::ONE.format(value)
}

/// The unit of a force's number: the amplitude's goes with the direction.
fn force_unit(model: &Model, owner: Owner, field: &Field<Force>) -> Unit {
    let Owner::Force(index) = owner else {
        return field.unit;
    };
    if field.key == "amplitude" {
        load_unit(&model.forces[index].target)
    } else {
        field.unit
    }
}

/// The unit of a load along a motion.
pub(super) const fn load_unit(target: &Target) -> Unit {
    match target {
        Target::Beam(_, BeamMotion::W | BeamMotion::V)
        | Target::Mass(_, MassMotion::Y | MassMotion::Z) => Unit::FORCE,
        Target::Beam(_, BeamMotion::PsiSlope) => Unit::BIMOMENT,
        Target::Beam(..) | Target::Mass(_, MassMotion::Theta) => Unit::TORQUE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::path::{all, parameter, sample};

    #[test]
    fn everything_is_described() {
        let model = sample::model(&["S1"]);
        for path in all(&model) {
            let parameter = parameter(&model, &path).unwrap();
            assert_eq!(parameter.path, path);
            assert!(
                !parameter.meaning.is_empty() && !parameter.range.is_empty(),
                "{path}"
            );
            match parameter.value {
                Value::Number(_) => assert!(!parameter.symbol.is_empty(), "{path}"),
                Value::Choice(word) => assert!(parameter.choices.contains(&word), "{path}"),
                _ => assert!(
                    parameter.choices.is_empty() && parameter.unit == Unit::ONE,
                    "{path}"
                ),
            }
        }
    }

    #[test]
    fn a_load_has_the_unit_of_its_direction() {
        let model = sample::model(&["S1"]);
        let unit = |path: &str| parameter(&model, path).unwrap().unit;
        assert_eq!(unit("forces.1.amplitude"), Unit::FORCE);
        assert_eq!(unit("forces.2.amplitude"), Unit::TORQUE);
        assert_eq!(unit("forces.3.amplitude"), Unit::BIMOMENT);
        assert_eq!(unit("forces.4.amplitude"), Unit::TORQUE);
        assert_eq!(unit("forces.3.phase"), Unit::DEGREE);
        assert_eq!(
            unit("supports.left.psi.stiffness"),
            Unit::ROTATIONAL_STIFFNESS
        );
        assert_eq!(
            unit("supports.right.psi_slope.inertia"),
            Unit::WARPING_INERTIA
        );
    }

    #[test]
    fn a_range_says_what_this_model_allows() {
        let mut model = sample::model(&["S1", "S2"]);
        model.beam.section.warping_constant = 0.0;
        let range = |path: &str| parameter(&model, path).unwrap().range;
        assert_eq!(range("beam.length"), "> 0");
        assert_eq!(
            range("beam.section.polar_moment"),
            "> A z_c^2 = 4.4447e-5 m4"
        );
        assert_eq!(
            range("beam.section.torsion_constant"),
            "> 0 without a warping constant"
        );
        assert_eq!(range("subsystems.S1.position"), "0 to 3.2 m");
        assert_eq!(range("sweep.to"), "above 1 Hz");
        assert_eq!(
            range("forces.1.at"),
            "left, right, a position in m or S1, S2"
        );
        assert_eq!(range("supports.left.w"), "free, fixed, elastic");
        let many: Vec<String> = (1..10).map(|number| format!("S{number}")).collect();
        let many = sample::model(&many.iter().map(String::as_str).collect::<Vec<_>>());
        assert!(
            parameter(&many, "forces.1.at")
                .unwrap()
                .range
                .ends_with("a subsystem's name")
        );
    }
}
