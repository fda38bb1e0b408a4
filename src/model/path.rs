//! Parameter paths: the one way in which parameters are named, read and set.
//!
//! A path is the keys of the model file with dots between them: `beam.material.density`,
//! `supports.left.w.stiffness`, `subsystems.S1.y_left.stiffness`, `forces.1.amplitude`. An element of a list is named
//! by its name or by its number from 1; a name that holds a dot or a quote, or digits alone, stands in quotes:
//! `subsystems."a.b".mass`. In a pattern, `*` stands for every element, either end, or any one key:
//! `subsystems.*.y_left.stiffness`, `subsystems.*.*.damping`, `supports.*.psi.stiffness`.

mod address;
mod describe;
mod family;
mod find;
mod miss;
mod pattern;
mod rename;
#[cfg(test)]
pub(super) mod sample;
mod target;
mod value;

pub use family::{apply, apply_unchecked, family_keys, family_labels};

use super::check::check;
use super::fault::Fault;
use super::types::Model;
use super::unit::Unit;
use address::Address;
use find::Finder;

/// The value of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number, in the parameter's unit.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// True or false.
    Flag(bool),
    /// One of the parameter's choices.
    Choice(&'static str),
    /// Free text, a name, or a place: `left`, `right`, `1.6 m`, a subsystem's name.
    Text(String),
}

impl Value {
    fn number(&self) -> Result<f64, String> {
        match self {
            Self::Number(number) => Ok(*number),
            other => Err(other.misfit("a number")),
        }
    }

    fn count(&self) -> Result<usize, String> {
        match self {
            Self::Count(count) => Ok(*count),
            other => Err(other.misfit("a whole number")),
        }
    }

    fn flag(&self) -> Result<bool, String> {
        match self {
            Self::Flag(flag) => Ok(*flag),
            other => Err(other.misfit("true or false")),
        }
    }

    fn text(self) -> Result<String, String> {
        match self {
            Self::Text(text) => Ok(text),
            Self::Choice(word) => Ok(word.to_owned()),
            other => Err(other.misfit("text")),
        }
    }

    fn word(&self) -> Result<&str, String> {
        match self {
            Self::Text(text) => Ok(text),
            Self::Choice(word) => Ok(word),
            other => Err(other.misfit("a word")),
        }
    }

    fn misfit(&self, wanted: &str) -> String {
        let given = match self {
            Self::Number(number) => super::serial::format_number(*number),
            Self::Count(count) => count.to_string(),
            Self::Flag(flag) => flag.to_string(),
            Self::Choice(word) => format!("{word:?}"),
            Self::Text(text) => format!("{text:?}"),
        };
        format!("is {given}; must be {wanted}")
    }
}

/// A parameter, with all that a person needs to set it.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Its own path, without stars.
    pub path: String,
    /// The symbol of the literature; empty where there is none.
    pub symbol: &'static str,
    /// Of a number; [`Unit::ONE`] for everything else.
    pub unit: Unit,
    /// What it is.
    pub meaning: &'static str,
    /// What it may be, in words: `> 0`, `0 to 3.2 m`, `free, pinned or clamped`.
    pub range: String,
    /// The words of a [`Value::Choice`]; empty for the others.
    pub choices: Vec<&'static str>,
    /// What it is now.
    pub value: Value,
}

/// Every parameter's path, in the order of the model file.
///
/// Those that cannot be read are left out: the springs of a fixed motion, the place of an energy.
pub fn all(model: &Model) -> Vec<String> {
    find::all(model).into_iter().map(|(_, path)| path).collect()
}

/// The paths that a pattern stands for, at least one.
///
/// # Errors
/// The pattern matches nothing; the fault names the nearest path that does, or what could stand there.
pub fn expand(model: &Model, pattern: &str) -> Result<Vec<String>, Fault> {
    let found = Finder::new(model).find(pattern)?;
    Ok(found
        .with_paths(model)
        .into_iter()
        .map(|(_, path)| path)
        .collect())
}

/// The parameter of a path.
///
/// # Errors
/// The path matches nothing, or more than one parameter, or one that has no value now: a fixed motion has no spring.
pub fn parameter(model: &Model, path: &str) -> Result<Parameter, Fault> {
    let address = one(model, path)?;
    let value = value::read(model, &address).map_err(|message| Fault::new(path, message))?;
    Ok(describe::parameter(model, &address, value))
}

/// The number of a path.
///
/// # Errors
/// As [`parameter`], or the parameter is no number.
pub fn number(model: &Model, path: &str) -> Result<f64, Fault> {
    let address = one(model, path)?;
    number_at(model, &address).map_err(|message| Fault::new(path, message))
}

/// The numbers that a pattern stands for, each with its path: [`expand`] and [`number`] in one pass.
///
/// # Errors
/// The pattern matches nothing, or something that is no number.
pub fn numbers(model: &Model, pattern: &str) -> Result<Vec<(String, f64)>, Fault> {
    let found = Finder::new(model).find(pattern)?.with_paths(model);
    let read = |(address, path): (Address, String)| match number_at(model, &address) {
        Ok(number) => Ok((path, number)),
        Err(message) => Err(Fault::new(path, message)),
    };
    found.into_iter().map(read).collect()
}

/// Makes sure that a pattern stands for numbers alone: [`numbers`] without them.
///
/// # Errors
/// As [`numbers`].
pub(super) fn must_be_numbers(model: &Model, pattern: &str) -> Result<(), Fault> {
    let found = Finder::new(model).find(pattern)?;
    for address in found.addresses(model) {
        // A path is made where it is told alone.
        number_at(model, &address).map_err(|message| Fault::new(address.path(model), message))?;
    }
    Ok(())
}

fn number_at(model: &Model, address: &Address) -> Result<f64, String> {
    value::read(model, address)?
        .number()
        .map_err(|message| format!("is no number: {message}"))
}

/// The one parameter of a path.
fn one(model: &Model, path: &str) -> Result<Address, Fault> {
    let found = Finder::new(model).find(path)?;
    match found.addresses(model)[..] {
        [address] => Ok(address),
        _ => Err(Fault::new(
            path,
            "stands for several parameters; must be one without a star",
        )),
    }
}

/// Sets every parameter of a path or pattern, if the model stays a possible one.
///
/// # Errors
/// The path matches nothing, the value does not fit, or [`check()`] refuses the outcome. The model is then unchanged.
pub fn set(model: &mut Model, path: &str, value: Value) -> Result<(), Vec<Fault>> {
    *model = changed(model, path, value)?;
    Ok(())
}

/// A model in which every parameter of a path or pattern has another value, if that is a possible one.
///
/// # Errors
/// As [`set`].
pub fn changed(model: &Model, path: &str, value: Value) -> Result<Model, Vec<Fault>> {
    let mut changed = model.clone();
    set_unchecked(&mut changed, path, value).map_err(|fault| vec![fault])?;
    let faults = check(&changed);
    if faults.is_empty() {
        Ok(changed)
    } else {
        Err(faults)
    }
}

/// Sets every parameter of a path or pattern, without asking whether the model stays a possible one.
///
/// # Errors
/// The path matches nothing, or the value is of another type than the parameter. The model is then unchanged.
pub fn set_unchecked(model: &mut Model, path: &str, value: Value) -> Result<(), Fault> {
    let addresses = Finder::new(model).find(path)?.addresses(model);
    if let [address] = &addresses[..] {
        return value::write(model, address, value).map_err(|message| Fault::new(path, message));
    }
    let mut changed = model.clone();
    for address in &addresses {
        value::write(&mut changed, address, value.clone())
            .map_err(|message| Fault::new(address.path(model), message))?;
    }
    *model = changed;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::types::{Case, Family};
    use super::*;
    use std::time::{Duration, Instant};

    #[test]
    fn a_number_is_set_and_checked() {
        let mut model = sample::model(&["S1", "S2"]);
        set(&mut model, "subsystems.S2.mass", Value::Number(250.0)).unwrap();
        assert_eq!(number(&model, "subsystems.2.mass"), Ok(250.0));
        assert_eq!(model.subsystems[0].mass, 100.0);
        set(&mut model, "subsystems.*.mass", Value::Number(300.0)).unwrap();
        assert!(
            model
                .subsystems
                .iter()
                .all(|subsystem| subsystem.mass == 300.0)
        );
        set(&mut model, "sweep.points", Value::Count(100)).unwrap();
        set(&mut model, "subsystems.S1.enabled", Value::Flag(true)).unwrap();
        set(&mut model, "sweep.spacing", Value::Choice("log")).unwrap();
        set(&mut model, "title", Value::Text("New".to_owned())).unwrap();
        assert_eq!((model.sweep.points, &*model.title), (100, "New"));
    }

    #[test]
    fn what_the_checks_refuse_leaves_the_model_as_it_was() {
        let model = sample::model(&["S1", "S2"]);
        let refused: &[(&str, Value)] = &[
            ("beam.length", Value::Number(0.0)),
            ("beam.length", Value::Number(f64::NAN)),
            ("beam.length", Value::Number(1.0)),
            ("beam.section.polar_moment", Value::Number(1e-9)),
            ("subsystems.*.mass", Value::Number(-1.0)),
            ("subsystems.S1.position", Value::Number(3.3)),
            ("subsystems.S1.enabled", Value::Flag(false)),
            ("supports.left.w.stiffness", Value::Number(f64::INFINITY)),
            ("sweep.to", Value::Number(0.5)),
            ("sweep.points", Value::Count(1)),
            ("no.such.path", Value::Number(1.0)),
        ];
        for (path, value) in refused {
            let mut same = model.clone();
            assert!(
                !set(&mut same, path, value.clone()).unwrap_err().is_empty(),
                "{path}"
            );
            assert_eq!(same, model, "{path}");
        }
    }

    #[test]
    fn a_pattern_is_set_as_a_whole_or_not_at_all() {
        let mut model = sample::model(&["S1"]);
        let same = model.clone();
        let fault =
            set_unchecked(&mut model, "supports.*.v.stiffness", Value::Number(5.0)).unwrap_err();
        assert_eq!(fault.path, "supports.left.v.stiffness");
        assert_eq!(model, same);
    }

    #[test]
    fn only_one_parameter_can_be_read() {
        let model = sample::model(&["S1", "S2"]);
        assert!(
            parameter(&model, "subsystems.*.mass")
                .unwrap_err()
                .message
                .contains("several")
        );
        assert!(
            number(&model, "title")
                .unwrap_err()
                .message
                .contains("no number")
        );
        assert!(
            number(&model, "sweep.points")
                .unwrap_err()
                .message
                .contains("no number")
        );
        let numbers = numbers(&model, "subsystems.*.mass").unwrap();
        assert_eq!(
            numbers,
            [
                ("subsystems.S1.mass".to_owned(), 100.0),
                ("subsystems.S2.mass".to_owned(), 100.0)
            ]
        );
        assert!(super::numbers(&model, "subsystems.*.name").is_err());
    }

    #[test]
    fn the_parameters_follow_the_model_file() {
        let model = sample::model(&["S1"]);
        let all = all(&model);
        let place = |path: &str| {
            all.iter()
                .position(|other| other == path)
                .unwrap_or_else(|| panic!("{path} is missing"))
        };
        let order = [
            "title",
            "notes",
            "beam.length",
            "beam.material.young_modulus",
            "beam.section.centroid_offset",
            "supports.left.kind",
            "supports.left.w",
            "supports.left.w.mass",
            "supports.left.psi.inertia",
            "supports.left.v",
            "supports.right.psi_slope.stiffness",
            "subsystems.S1.name",
            "subsystems.S1.y_left.stiffness",
            "subsystems.S1.mount_z",
            "forces.1.at",
            "forces.4.phase",
            "responses.P5 w.name",
            "responses.E_V.measure",
            "sweep.from",
            "sweep.spacing",
            "studies.Cases.name",
        ];
        assert!(order.map(place).is_sorted());
        assert!(
            !all.iter()
                .any(|path| path == "supports.left.v.stiffness" || path == "responses.E_V.at")
        );
    }

    /// The shortest of a few runs.
    fn time(mut work: impl FnMut()) -> Duration {
        let runs = (0..5).map(|_| {
            let start = Instant::now();
            work();
            start.elapsed()
        });
        runs.min().unwrap_or_default()
    }

    #[test]
    fn a_thousand_subsystems_are_no_burden() {
        let names: Vec<String> = (0..1000).map(|index| format!("absorber {index}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut model = sample::model(&names);
        (model.studies, model.tune) = (Vec::new(), None);
        let path = |name: &&str| (format!("subsystems.{name}.mass"), 7.0);
        let set_all = names.iter().map(path).collect();
        let case = Case {
            name: "all".to_owned(),
            set: set_all,
        };
        let family = Family::Cases(vec![case]);

        let clone = time(|| drop(model.clone()));
        let check = time(|| assert_eq!(check(&model), []));
        let one = time(|| {
            set(
                &mut model,
                "subsystems.absorber 999.mass",
                Value::Number(5.0),
            )
            .unwrap();
        });
        let every = time(|| {
            set(&mut model, "subsystems.*.mass", Value::Number(5.0)).unwrap();
        });
        let listed = time(|| {
            numbers(&model, "subsystems.*.*.stiffness").unwrap();
        });
        let member = time(|| {
            apply(&model, &family, 0).unwrap();
        });
        println!("clone {clone:?}, check {check:?}, set one {one:?}, every {every:?}");
        println!("list 4000 {listed:?}, a case of 1000 {member:?}");
        // Generous, for a busy machine; what is quadratic takes longer still.
        for elapsed in [one, every, listed, member] {
            assert!(elapsed.as_millis() < 50, "{elapsed:?}");
        }
    }
}
