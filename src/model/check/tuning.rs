//! The rules of the tuning: variables, objectives and limits.

use super::super::edit::{Value, put};
use super::super::fault::Fault;
use super::super::id::{Group, ParameterId};
use super::super::path;
use super::super::schema::{AIMS, Access, Asked, Choice, Kind, LIMITS, OBJECTIVE, Rows};
use super::super::spelling;
use super::super::toml_literal::format_number;
use super::super::tuning::{Aim, Hold, Limit, Objective, Tune, Variable};
use super::super::types::{Model, Spacing};
use super::studies::{BareModel, not_empty};
use super::{band, not_finite, state};
use std::collections::HashMap;

/// Adds the faults of a model's tuning.
pub(super) fn check(model: &Model, bare: &BareModel, tune: &Tune, faults: &mut Vec<Fault>) {
    not_empty("tune.variables", tune.variables.len(), "variable", faults);
    let rules = Rules { model, bare };
    let mut moved = HashMap::new();
    for (index, variable) in tune.variables.iter().enumerate() {
        let at = format!("tune.variables.{}", index + 1);
        let before = faults.len();
        rules.paths(&at, index, variable, &mut moved, faults);
        range(&at, variable, faults);
        if faults.len() == before {
            rules.bounds(&at, variable, faults);
        }
    }
    let objectives = &tune.objectives;
    not_empty("tune.objectives", objectives.len(), "objective", faults);
    for (index, objective) in objectives.iter().enumerate() {
        let at = match objectives.len() {
            1 => "tune.objective".to_owned(),
            _ => format!("tune.objectives.{}", index + 1),
        };
        self::objective(&at, model, objective, faults);
    }
    for (index, limit) in tune.limits.iter().enumerate() {
        self::limit(&format!("tune.limits.{}", index + 1), model, limit, faults);
    }
}

/// The context in which variables are checked.
struct Rules<'a> {
    model: &'a Model,
    bare: &'a BareModel,
}

impl Rules<'_> {
    /// The paths of a variable: each matches numbers that responses depend on and that no other variable changes.
    fn paths(
        &self,
        at: &str,
        index: usize,
        variable: &Variable,
        moved: &mut HashMap<ParameterId, usize>,
        faults: &mut Vec<Fault>,
    ) {
        not_empty(&format!("{at}.paths"), variable.paths.len(), "path", faults);
        for (number, pattern) in variable.paths.iter().enumerate() {
            let at = match variable.paths.len() {
                1 => format!("{at}.path"),
                _ => format!("{at}.paths.{}", number + 1),
            };
            match path::numbers_of(&self.bare.model, pattern) {
                Ok(found) => {
                    let message = found
                        .into_iter()
                        .find_map(|(id, _)| self.unfit(index, id, moved));
                    faults.extend(message.map(|message| Fault::new(at, message)));
                }
                Err(fault) => {
                    let message = format!("{}: {}", fault.path, fault.message);
                    faults.push(Fault::new(at, message));
                }
            }
        }
    }

    /// Why a variable must not change a parameter.
    fn unfit(
        &self,
        index: usize,
        id: ParameterId,
        moved: &mut HashMap<ParameterId, usize>,
    ) -> Option<String> {
        let path = || path::text(&self.bare.model, id);
        if id.group == Group::Sweep {
            return Some(format!(
                "{}: no response depends on it; must be a number of the beam, a support, a subsystem or a force",
                path()
            ));
        }
        match *moved.entry(id).or_insert(index) {
            other if other != index => Some(format!(
                "{}: is already changed by variable {}; must be changed by one only",
                path(),
                other + 1
            )),
            _ => None,
        }
    }

    /// The model must be possible with the first parameter at either bound, or beyond it by the tolerance.
    fn bounds(&self, at: &str, variable: &Variable, faults: &mut Vec<Fault>) {
        let bare = &self.bare.model;
        let share = variable.tolerance / 100.0;
        let extremes = [
            ("min", variable.min - variable.min.abs() * share),
            ("max", variable.max + variable.max.abs() * share),
        ];
        for (key, value) in extremes {
            let set = match variable.applied(self.model, value) {
                Ok(set) => set,
                Err(fault) if variable.parameters(self.model).is_ok() => {
                    faults.push(no_ratio(at, &fault));
                    return;
                }
                // The spring of a motion that is fixed now has no value, so no ratio to keep.
                Err(_) if variable.hold == Hold::Ratio => return,
                Err(_) => match variable.applied(bare, value) {
                    Ok(set) => set,
                    Err(_) => return,
                },
            };
            let mut extreme = bare.clone();
            let mut set = set.into_iter();
            if set.any(|(id, value)| put(&mut extreme, id, Value::Number(value)).is_err()) {
                continue;
            }
            let mut found = Vec::new();
            state(&extreme, &mut found);
            let new = |fault: &Fault| !self.bare.known.contains(&fault.path);
            if let Some(fault) = found.into_iter().find(new) {
                let message = impossible(variable.tolerance, &fault);
                faults.push(Fault::new(format!("{at}.{key}"), message));
            }
        }
    }
}

fn no_ratio(at: &str, fault: &Fault) -> Fault {
    let message = format!(
        "is \"ratio\", but {} is 0; must be \"equal\", or the first parameter another number than 0",
        fault.path
    );
    Fault::new(format!("{at}.hold"), message)
}

fn impossible(tolerance: f64, fault: &Fault) -> String {
    let beyond = if tolerance > 0.0 {
        format!(" with its tolerance of {} %", format_number(tolerance))
    } else {
        String::new()
    };
    format!(
        "makes the model impossible{beyond}: {}: {}",
        fault.path, fault.message
    )
}

/// The bounds, scale and tolerance of a variable.
fn range(at: &str, variable: &Variable, faults: &mut Vec<Fault>) {
    let Variable { min, max, .. } = *variable;
    for (key, value) in [("min", min), ("max", max)] {
        if !value.is_finite() {
            faults.push(Fault::new(format!("{at}.{key}"), not_finite(value)));
        }
    }
    if min >= max {
        let (min, max) = (format_number(min), format_number(max));
        let message = format!("is {min}; must be below max = {max}");
        faults.push(Fault::new(format!("{at}.min"), message));
    } else if variable.scale == Some(Spacing::Log) && min <= 0.0 {
        let message = format!("is {}; must be > 0 if scale is \"log\"", format_number(min));
        faults.push(Fault::new(format!("{at}.min"), message));
    }
    let tolerance = variable.tolerance;
    if !(0.0..100.0).contains(&tolerance) {
        let at = format!("{at}.tolerance");
        let message = if tolerance.is_finite() {
            let tolerance = format_number(tolerance);
            format!("is {tolerance}; must be 0 or more and below 100, percent")
        } else {
            not_finite(tolerance)
        };
        faults.push(Fault::new(at, message));
    }
}

fn objective(at: &str, model: &Model, objective: &Objective, faults: &mut Vec<Fault>) {
    let aim = &objective.aim;
    response(
        at,
        model,
        objective.response.as_ref(),
        asked(AIMS, aim),
        faults,
    );
    let (from, to) = (objective.from, objective.to);
    ranges(at, objective, &OBJECTIVE, faults);
    band(at, from, to, faults);
    chosen(at, aim, AIMS, faults);
    if let Aim::AntiResonance { at: place, .. } = aim
        && *place > 0.0
        && (*place < from || *place > to)
    {
        let [place, from, to] = [*place, from, to].map(format_number);
        let message = format!("is {place}; must be in the band, {from} to {to} Hz");
        faults.push(Fault::new(format!("{at}.at"), message));
    }
}

fn limit(at: &str, model: &Model, limit: &Limit, faults: &mut Vec<Fault>) {
    response(at, model, limit.response(), asked(LIMITS, limit), faults);
    chosen(at, limit, LIMITS, faults);
    if let Limit::NoMode { from, to } = limit {
        band(at, *from, *to, faults);
    }
}

/// The response of an aim or a limit.
fn asked<T>(choices: &[Choice<T>], of: &T) -> Asked {
    Choice::of(choices, of).map_or(Asked::Nothing, |choice| choice.response)
}

/// The numbers and texts of the chosen kind of a table.
fn chosen<T>(at: &str, of: &T, choices: &[Choice<T>], faults: &mut Vec<Fault>) {
    let Some(choice) = Choice::of(choices, of) else {
        return;
    };
    ranges(at, of, &choice.rows, faults);
    for (key, access) in choice.rows.iter() {
        if let Access::Optional(get, _) = access
            && key.kind != Kind::Response
            && let Some(text) = get(of)
        {
            not_blank(&format!("{at}.{}", key.key), text, key.meaning, faults);
        }
    }
}

/// Every number against its range, without a limit of magnitude.
fn ranges<T>(at: &str, of: &T, rows: &Rows<T>, faults: &mut Vec<Fault>) {
    for (key, value) in rows.numbers(of) {
        let message = if !value.is_finite() {
            not_finite(value)
        } else if !key.range.holds(value) {
            format!("is {}; must be {}", format_number(value), key.range.words())
        } else {
            continue;
        };
        faults.push(Fault::new(format!("{at}.{}", key.key), message));
    }
}

/// A response must exist, be enabled and be of the requested kind.
fn response(at: &str, model: &Model, name: Option<&String>, asked: Asked, faults: &mut Vec<Fault>) {
    let Some(name) = name else { return };
    let found = model.responses.iter().find(|one| one.name == *name);
    let message = match found {
        None => {
            let known = model
                .responses
                .iter()
                .map(|response| response.name.as_str());
            let near = spelling::nearest(name, known);
            let near = near.map_or_else(String::new, |near| format!(" (did you mean {near:?}?)"));
            format!("{name:?} is not a response{near}; must be the name of one")
        }
        Some(found) if !found.enabled => {
            format!("{name:?} is disabled; must be an enabled response")
        }
        Some(found) => match asked {
            Asked::Motion if found.quantity.is_quadratic() => {
                format!("{name:?} is an energy, which has no phase; must be a motion or a force")
            }
            Asked::Displacement if found.quantity.is_quadratic() => {
                format!("{name:?} is an energy; must be a displacement or a force")
            }
            Asked::Displacement if !found.quantity.is_static() => {
                let measure = found.quantity.word();
                format!(
                    "{name:?} is of measure {measure}, which is 0 at rest; must be a displacement or a force"
                )
            }
            Asked::Nothing | Asked::Any | Asked::Motion | Asked::Displacement => return,
        },
    };
    faults.push(Fault::new(format!("{at}.response"), message));
}

/// A text that names something.
fn not_blank(path: &str, text: &str, what: &str, faults: &mut Vec<Fault>) {
    let message = if text.trim().is_empty() {
        format!("is empty; must be the name of {what}")
    } else if text.contains(char::is_control) {
        format!("{text:?} contains a control character; must be the name of {what}")
    } else {
        return;
    };
    faults.push(Fault::new(path, message));
}
