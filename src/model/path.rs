//! Parameter paths: the text that identifies parameters in files, on the command line and in prompts.
//!
//! A path is the keys of the model file, separated by dots: `beam.material.density`,
//! `supports.left.w.stiffness`, `subsystems.S1.y_left.stiffness`, `forces.1.amplitude`. A list element is identified
//! by its name or by its number from 1; a name that contains a dot or a quote, or only digits, needs quotes:
//! `subsystems."a.b".mass`. In a pattern, `*` matches every element, both ends, or any one key:
//! `subsystems.*.y_left.stiffness`, `subsystems.*.*.damping`, `supports.*.psi.stiffness`.

mod find;
pub(super) mod pattern;
#[cfg(test)]
pub(super) mod sample;
mod suggestion;
mod text;

pub(super) use find::Finder;
#[cfg(test)]
pub(crate) use pattern::PARSED;
pub use pattern::Pattern;
pub use text::{text, texts};

use super::describe::Parameter;
use super::edit::number as value_of;
use super::fault::Fault;
use super::id::ParameterId;
use super::types::Model;

/// Every parameter's path, in the order of the model file.
///
/// Without those that have no value: the springs of a fixed motion, the position of an energy.
pub fn all(model: &Model) -> Vec<String> {
    texts(model, &ParameterId::all(model))
}

/// The parameters that a path or pattern matches, at least one.
///
/// # Errors
/// The pattern matches nothing; the fault suggests the nearest path that matches, or lists the valid words.
pub fn find(model: &Model, pattern: &str) -> Result<Vec<ParameterId>, Fault> {
    Pattern::from(pattern).parameters(model)
}

/// The paths that a pattern matches, at least one.
///
/// # Errors
/// As [`find`].
pub fn expand(model: &Model, pattern: &str) -> Result<Vec<String>, Fault> {
    Ok(texts(model, &find(model, pattern)?))
}

/// The parameter of a path.
///
/// # Errors
/// The path matches nothing, or more than one parameter, or one that has no value now: a fixed motion has no spring.
pub fn parameter(model: &Model, path: &str) -> Result<Parameter, Fault> {
    Parameter::of(model, one(model, path)?).map_err(|message| Fault::new(path, message))
}

/// The parameter of an id.
///
/// # Errors
/// It has no value now.
pub fn described(model: &Model, id: ParameterId) -> Result<Parameter, Fault> {
    Parameter::of(model, id).map_err(|message| Fault::new(text(model, id), message))
}

/// The number of a path.
///
/// # Errors
/// As [`parameter`], or the parameter is not a number.
pub fn number(model: &Model, path: &str) -> Result<f64, Fault> {
    value_of(model, one(model, path)?).map_err(|message| Fault::new(path, message))
}

/// The numbers that a pattern matches, each with its parameter.
///
/// # Errors
/// The pattern matches nothing, or a parameter that is not a number.
pub fn numbers(model: &Model, pattern: &str) -> Result<Vec<(ParameterId, f64)>, Fault> {
    numbers_of(model, &Pattern::from(pattern))
}

/// The numbers that a pattern matches, each with its parameter.
///
/// # Errors
/// As [`numbers`].
pub fn numbers_of(model: &Model, pattern: &Pattern) -> Result<Vec<(ParameterId, f64)>, Fault> {
    let number = |id| match value_of(model, id) {
        Ok(number) => Ok((id, number)),
        // Builds the path only if there is an error to report.
        Err(message) => Err(Fault::new(text(model, id), message)),
    };
    let found = pattern.parameters(model)?;
    found.into_iter().map(number).collect()
}

/// The single parameter of a path.
///
/// # Errors
/// The path matches nothing, or several parameters.
pub fn one(model: &Model, path: &str) -> Result<ParameterId, Fault> {
    match find(model, path)?[..] {
        [id] => Ok(id),
        _ => Err(Fault::new(
            path,
            "stands for several parameters; must be one without a star",
        )),
    }
}
