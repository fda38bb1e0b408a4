//! The variables of a search, and their bounds.

use std::sync::Arc;

use crate::model::edit;
use crate::model::path::{self, Pattern};
use crate::model::schema::SubsystemKey;
use crate::model::{
    Aim, Checked, Combine, Group, Hold, Model, Objective, Parameter, ParameterId, Spacing, Tune,
    Unit, Variable, value_input,
};
use crate::tui::app::{App, Question};
use crate::tui::tree::{self, Node};
use crate::tune::words::first_parameter;

impl App {
    /// Makes the selected parameter a variable with typed bounds, or fixes it.
    pub(crate) fn turn_variable(&mut self) {
        let node = self.selection.node();
        if let Node::Group(Group::Variable(index)) = node {
            return self.ask_bounds_of(index);
        }
        let number = node.parameter().and_then(|id| {
            let unit = Parameter::of(self.model(), id).ok()?.unit;
            Some((id, unit, edit::number(self.model(), id).ok()?))
        });
        let Some((id, unit, value)) = number else {
            return self.refuse("select a number of the model to make it a variable");
        };
        if let Some(index) = variable_of(self.model(), id) {
            return self.drop_variable(index);
        }
        let question = Question::Bounds {
            subject: tree::subject(self.model(), node),
            paths: vec![path::text(self.model(), id).into()],
            unit,
            index: None,
        };
        let bounds = usual_bounds(self.model(), id, value);
        let text = bounds.map_or_else(String::new, |[low, high]| bounds_text(unit, low, high));
        self.ask_question(question, text);
    }

    /// Prompts for other bounds of a variable.
    pub(crate) fn ask_bounds_of(&mut self, index: usize) {
        let model = Arc::clone(self.document.model());
        let mut variables = model.tune.iter().flat_map(|tune| &tune.variables);
        let Some(variable) = variables.nth(index) else {
            return;
        };
        let unit = first_parameter(&model, variable).map_or(Unit::ONE, |first| first.unit);
        let mut text = bounds_text(unit, variable.min, variable.max);
        if variable.tolerance > 0.0 {
            let tolerance = variable.tolerance;
            text = format!("{text} +-{tolerance} %");
        }
        match variable.scale {
            Some(Spacing::Log) => text += " log",
            Some(Spacing::Linear) => text += " linear",
            None => {}
        }
        let question = Question::Bounds {
            subject: variable.paths.join(", "),
            paths: variable.paths.clone(),
            unit,
            index: Some(index),
        };
        self.ask_question(question, text);
    }

    /// Applies typed bounds to a new variable, or to the one with this index.
    ///
    /// # Errors
    /// Why they are refused, in one line.
    pub(crate) fn take_bounds(
        &mut self,
        paths: &[Pattern],
        unit: Unit,
        index: Option<usize>,
        text: &str,
    ) -> Result<(), String> {
        let typed = read_bounds(text, unit)?;
        let mut changed = Model::clone(self.model());
        let tune = match &mut changed.tune {
            Some(tune) => tune,
            none => none.insert(Tune {
                variables: Vec::new(),
                objectives: vec![self.usual_objective()?],
                combine: Combine::Sum,
                limits: Vec::new(),
            }),
        };
        let variable = Variable {
            paths: paths.to_vec(),
            hold: Hold::Equal,
            min: typed.low,
            max: typed.high,
            scale: typed.scale,
            tolerance: typed.tolerance,
        };
        let known = index.and_then(|index| tune.variables.get_mut(index));
        let words = if let Some(known) = known {
            let hold = known.hold;
            *known = Variable { hold, ..variable };
            format!("bounds of {}", paths.join(", "))
        } else {
            tune.variables.push(variable);
            format!("make {} a variable", paths.join(", "))
        };
        self.take_tune(words, changed)
    }

    /// Applies a model with another `[tune]`, as one step.
    ///
    /// # Errors
    /// Why it is invalid, in one line.
    pub(crate) fn take_tune(&mut self, words: String, changed: Model) -> Result<(), String> {
        let changed = Checked::new(changed).map_err(|faults| {
            let first = &faults[0];
            format!("{} {}", first.path, first.message)
        })?;
        let before = Arc::clone(self.model());
        self.document.replace(words.clone(), changed);
        self.follow(&before);
        self.done(words);
        Ok(())
    }

    /// Removes a variable; without variables, `[tune]` is removed.
    pub(crate) fn drop_variable(&mut self, index: usize) {
        let mut changed = Model::clone(self.model());
        let Some(tune) = &mut changed.tune else {
            return;
        };
        let dropped = tune.variables.remove(index);
        let name = dropped.paths.join(", ");
        let words = if tune.variables.is_empty() {
            changed.tune = None;
            format!("{name} is fixed; there are no variables left")
        } else {
            format!("{name} is fixed")
        };
        if let Err(reason) = self.take_tune(words, changed) {
            self.refuse(reason);
        }
    }

    /// The default objective: the smallest peak of the first curve in the band.
    fn usual_objective(&self) -> Result<Objective, String> {
        let Some(response) = self.curves.visible.first() else {
            return Err("no visible response can be tuned".to_owned());
        };
        let [from, to] = self.tuned_band();
        Ok(Objective {
            aim: Aim::Peak,
            response: Some(response.clone()),
            from,
            to,
            weight: 1.0,
        })
    }

    /// The marked band, or the visible one, Hz.
    pub(crate) fn tuned_band(&self) -> [f64; 2] {
        self.curves.band.unwrap_or_else(|| self.shown_frequencies())
    }
}

/// Default bounds of a parameter with this value: a tenth and ten times it; for a place, the whole beam.
fn usual_bounds(model: &Model, id: ParameterId, value: f64) -> Option<[f64; 2]> {
    let is_position = id.row == SubsystemKey::Position as usize;
    if is_position && matches!(id.group, Group::Subsystem(_)) {
        return Some([0.0, model.length()]);
    }
    let mut bounds = [0.1 * value, 10.0 * value];
    bounds.sort_by(f64::total_cmp);
    (value != 0.0).then_some(bounds)
}

fn bounds_text(unit: Unit, low: f64, high: f64) -> String {
    let symbol = if unit.symbol.is_empty() {
        String::new()
    } else {
        format!(" {}", unit.symbol)
    };
    format!("{} .. {}{symbol}", short(low), short(high))
}

/// The shortest text that reads back as the same number.
fn short(value: f64) -> String {
    let (plain, power) = (format!("{value}"), format!("{value:e}"));
    if power.len() < plain.len() {
        power
    } else {
        plain
    }
}

/// The variable that changes a parameter, alone or with others.
fn variable_of(model: &Model, id: ParameterId) -> Option<usize> {
    let tune = model.tune.as_ref()?;
    let moves = |pattern: &Pattern| {
        let found = pattern.parameters(model);
        found.is_ok_and(|found| found.contains(&id))
    };
    tune.variables
        .iter()
        .position(|variable| variable.paths.iter().any(moves))
}

/// Parsed bounds.
#[derive(Debug, PartialEq)]
struct Bounds {
    low: f64,
    high: f64,
    tolerance: f64,
    scale: Option<Spacing>,
}

/// `LOW .. HIGH`, then optionally a tolerance `+-5 %` and `log` or `linear`.
fn read_bounds(text: &str, unit: Unit) -> Result<Bounds, String> {
    let form = "type bounds, as 1e5 .. 1e8, then optionally +-5 % and log or linear";
    let text = text.replace('±', "+-");
    let (rest, scale) = match text.trim() {
        text if text.ends_with("linear") => (&text[..text.len() - 6], Some(Spacing::Linear)),
        text if text.ends_with("log") => (&text[..text.len() - 3], Some(Spacing::Log)),
        text => (text, None),
    };
    let (bounds, tolerance) = match rest.split_once("+-") {
        Some((bounds, tolerance)) => {
            let tolerance = tolerance.trim().trim_end_matches('%').trim();
            let tolerance: f64 = tolerance
                .parse()
                .map_err(|_| format!("{tolerance} is not a tolerance in percent"))?;
            (bounds, tolerance)
        }
        None => (rest, 0.0),
    };
    let (low, high) = bounds.split_once("..").ok_or(form)?;
    // A unit after the upper bound applies to both.
    let high = high.trim();
    let number = |text: &str| {
        value_input::number(text.trim(), f64::NAN, &unit)
            .map_err(|_| value_input::decimal_comma(text).unwrap_or_else(|| form.to_owned()))
    };
    let shared = high
        .split_once(' ')
        .map(|(_, symbol)| format!("{} {symbol}", low.trim()));
    let low = match shared {
        Some(shared) => number(&shared).or_else(|_| number(low))?,
        None => number(low)?,
    };
    Ok(Bounds {
        low,
        high: number(high)?,
        tolerance,
        scale,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_read_with_units_tolerance_and_scale() {
        let bounds = |low, high, tolerance, scale| Bounds {
            low,
            high,
            tolerance,
            scale,
        };
        let read = |text| read_bounds(text, Unit::METRE).unwrap();
        assert_eq!(read("1 .. 2"), bounds(1.0, 2.0, 0.0, None));
        assert_eq!(read("1..2 m +-5 %"), bounds(1.0, 2.0, 5.0, None));
        assert_eq!(
            read("1 mm .. 2 m ±2% log"),
            bounds(1e-3, 2.0, 2.0, Some(Spacing::Log))
        );
        assert_eq!(
            read("-1e-2 .. 2 linear"),
            bounds(-0.01, 2.0, 0.0, Some(Spacing::Linear))
        );
        for wrong in ["", "1", "1 2", "a .. b", "1 .. 2 +-x", "1 .. 2 kg"] {
            assert!(read_bounds(wrong, Unit::METRE).is_err(), "{wrong}");
        }
    }

    #[test]
    fn numbers_are_as_short_as_they_read_back() {
        for (value, text) in [(0.1, "0.1"), (20_000_000.0, "2e7"), (-25.0, "-25")] {
            assert_eq!(short(value), text);
            assert_eq!(text.parse(), Ok(value));
        }
    }
}
