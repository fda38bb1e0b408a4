//! Answers to prompts that set no parameter of the model: a frequency, the 0 dB reference, factors, names, files.

use std::sync::Arc;

use super::{Prompt, Purpose, Question};
use crate::escape::path_of_text;
use crate::model::edit::{self, Value};
use crate::model::path;
use crate::model::{
    Checked, Family, Model, Operation, Parameter, ParameterId, Study, Unit, value_input,
};
use crate::tui::app::{App, Effect, List, Overlay};
use crate::tui::scene::ChartView;
use crate::tui::tree;
use crate::unit::{FrequencyUnit, ValueUnit};

/// The most curves that can be distinguished on the chart.
const MOST_CURVES: usize = 12;

impl App {
    pub(crate) fn ask_question(&mut self, question: Question, text: String) {
        self.overlay = Some(Overlay::Prompt(Prompt::new(Purpose::Ask(question), text)));
    }

    /// Handles the typed answer; returns the effects.
    pub(crate) fn answer_question(&mut self, question: &Question, text: &str) -> Vec<Effect> {
        let taken = match question {
            Question::Frequency(unit) => self.go_to_frequency(text, *unit),
            Question::DecibelReference(unit) => self.take_decibel_reference(unit, text),
            Question::Factors { id, unit, .. } => self.take_factors(*id, *unit, text),
            Question::Bounds {
                paths, unit, index, ..
            } => self.take_bounds(paths, *unit, *index, text),
            Question::Objective { response, band, .. } => {
                match self.check_objective(response, *band, text) {
                    Some(check) => return vec![check],
                    None => self.take_objective(response, *band, text),
                }
            }
            Question::Curves(curves) => self.take_chosen(curves, text),
            Question::Name(old) => self.comparison.rename(old, text),
            _ if text.is_empty() && question.is_path() => Err("type a file's path".to_owned()),
            Question::ReferenceFile => return vec![Effect::OpenReference(path_of_text(text))],
            Question::MeasuredFile => {
                return vec![Effect::OpenMeasured(path_of_text(text), None)];
            }
            Question::Columns { path, .. } => {
                return vec![Effect::OpenMeasured(path.clone(), Some(text.to_owned()))];
            }
            Question::Export => return self.export_to(path_of_text(text)),
        };
        match taken {
            Ok(()) => {
                self.overlay = match question {
                    Question::Name(_) => {
                        let row = self.comparison.row_of(text).unwrap_or(0);
                        Some(Overlay::Comparison(List::new(self.comparison.len(), row)))
                    }
                    _ => None,
                };
            }
            Err(refusal) => self.refuse_prompt(refusal),
        }
        Vec::new()
    }

    fn go_to_frequency(&mut self, text: &str, unit: FrequencyUnit) -> Result<(), String> {
        let frequency = read_frequency(text, unit)?;
        let sweep = self.model().sweep;
        // A conversion between units may miss an end by a rounding error.
        let near = frequency.clamp(sweep.from, sweep.to);
        if (frequency - near).abs() > 1e-12 * near || frequency.is_nan() {
            return Err(format!(
                "the sweep goes from {} to {}",
                self.display.frequency_text(sweep.from),
                self.display.frequency_text(sweep.to)
            ));
        }
        self.put_cursor(near);
        Ok(())
    }

    pub(crate) fn ask_decibel_reference(&mut self) {
        if self.display.view == ChartView::Difference {
            return self.refuse("a difference in dB has no reference value");
        }
        let units = self.display.shown_units(&self.curves);
        let [unit] = units.as_slice() else {
            return self.refuse(if units.is_empty() {
                "no response is visible"
            } else {
                "the visible curves have several units: 0 dB is 1 of each"
            });
        };
        let text = format!("{:e}", self.display.decibel_reference(unit));
        self.ask_question(Question::DecibelReference(unit.clone()), text);
    }

    fn take_decibel_reference(&mut self, unit: &str, text: &str) -> Result<(), String> {
        let value = read_decibel_reference(text, unit)?;
        self.display
            .decibel_references
            .insert(unit.to_owned(), value);
        self.display.levels = None;
        self.curves.decibels = true;
        self.done(format!("0 dB is {value:e} {unit}"));
        Ok(())
    }

    pub(crate) fn ask_factors(&mut self) {
        let node = self.selection.node();
        let parameter = node
            .parameter()
            .and_then(|id| Parameter::of(self.model(), id).ok());
        match parameter {
            Some(parameter) if matches!(parameter.value, Value::Number(_)) => {
                let question = Question::Factors {
                    subject: tree::subject(self.model(), node),
                    id: parameter.id,
                    unit: parameter.unit,
                };
                self.ask_question(question, "0.5 1 2".to_owned());
            }
            _ => self.refuse("select a number of the model to sweep it"),
        }
    }

    /// Adds a study from the typed text to the model, and shows it.
    fn take_factors(&mut self, id: ParameterId, unit: Unit, text: &str) -> Result<(), String> {
        let (operation, values) = read_factors(text, unit)?;
        let now = edit::get(self.model(), id);
        if operation == Operation::Multiply && matches!(now, Ok(Value::Number(0.0))) {
            return Err("factors do not change a 0: = and values, as = 50 150".to_owned());
        }
        let mut changed = Model::clone(self.model());
        let path = path::text(&changed, id);
        let study = Study {
            name: free_study_name(&changed, &path),
            family: Family::Vary {
                paths: vec![path.into()],
                operation,
                values,
            },
        };
        changed.studies.push(study);
        let last = changed.studies.len() - 1;
        let changed = Checked::new(changed).map_err(|faults| faults[0].message.clone())?;
        let family = &changed.studies[last].family;
        for (index, label) in edit::family_labels(family).into_iter().enumerate() {
            if let Err(faults) = edit::apply(&changed, family, index) {
                let why = faults.first().map(|fault| fault.message.clone());
                return Err(format!("{label}: {}", why.unwrap_or_default()));
            }
        }
        let name = changed.studies[last].name.clone();
        let before = Arc::clone(self.model());
        self.document.replace(format!("add study {name}"), changed);
        self.follow(&before);
        let model = Arc::clone(self.document.model());
        self.show_study(Some(last), &model);
        Ok(())
    }
}

/// An unused name for a study of a path.
fn free_study_name(model: &Model, path: &str) -> String {
    let base = path.replace(['.', '_'], " ");
    let taken = |name: &str| model.studies.iter().any(|study| study.name == name);
    let mut names = (1..).map(|number| match number {
        1 => base.clone(),
        number => format!("{base} {number}"),
    });
    // The number of used names is finite.
    names.find(|name| !taken(name)).unwrap_or_default()
}

/// A 0 dB reference in a unit: a number, or one with another unit of the same quantity.
fn read_decibel_reference(text: &str, unit: &str) -> Result<f64, String> {
    let refusal = || {
        value_input::decimal_comma(text)
            .unwrap_or_else(|| format!("type a number above 0, in {unit} or a unit of its kind"))
    };
    let value = plain(text, Unit::ONE).ok().or_else(|| {
        let [typed, own] = [text, unit].map(ValueUnit::parse);
        typed.ok()?.in_units_of(&own.ok()?)
    });
    let possible = |value: &f64| value.is_normal() && *value > 0.0;
    value.filter(possible).ok_or_else(refusal)
}

/// Factors, or values after `=`, or summands after `+`.
fn read_factors(text: &str, unit: Unit) -> Result<(Operation, Vec<f64>), String> {
    let text = text.trim();
    let (operation, rest) = match text.chars().next() {
        Some('=') => (Operation::Set, &text[1..]),
        Some('+') => (Operation::Add, &text[1..]),
        Some('*') => (Operation::Multiply, &text[1..]),
        _ => (Operation::Multiply, text),
    };
    let unit = if operation == Operation::Multiply {
        Unit::ONE
    } else {
        unit
    };
    // Between commas, a value may have a unit after a space.
    let commas = rest.contains([',', ';']);
    let parts = |c: char| c == ',' || c == ';' || (!commas && c.is_whitespace());
    let words = rest.split(parts).map(str::trim);
    let values: Result<Vec<f64>, String> = words
        .filter(|word| !word.is_empty())
        .map(|word| number_of(word, operation, unit))
        .collect();
    match values? {
        values if values.is_empty() => Err("type at least one factor or value".to_owned()),
        values if values.len() > MOST_CURVES => Err(format!(
            "{} curves; {MOST_CURVES} are the most that can be distinguished",
            values.len()
        )),
        values => Ok((operation, values)),
    }
}

/// A factor, also as 50% or *0.5; else a value with or without unit.
fn number_of(word: &str, operation: Operation, unit: Unit) -> Result<f64, String> {
    let refusal = |_| {
        format!("{word} is not a number: factors, as 0.5 50% 2; = and values; + and increments")
    };
    if operation == Operation::Multiply {
        let word = word.trim_start_matches('*');
        return match word.strip_suffix('%') {
            Some(percent) => plain(percent, unit).map(|percent| percent / 100.0),
            None => plain(word, unit),
        }
        .map_err(refusal);
    }
    plain(word, unit).map_err(refusal)
}

/// A number with or without unit, but not a relative change.
fn plain(text: &str, unit: Unit) -> Result<f64, String> {
    // A relative change alone is not a number.
    value_input::number(text, f64::NAN, &unit)
}

/// A typed frequency, Hz: a number in `unit`, or with its own unit.
fn read_frequency(text: &str, unit: FrequencyUnit) -> Result<f64, String> {
    let text = text.trim();
    let own = FrequencyUnit::SHOWN
        .into_iter()
        .skip(1)
        .find_map(|unit| Some((text.strip_suffix(unit.symbol())?, unit)));
    let (number, unit) = own.unwrap_or((text, unit));
    let hertz = plain(number, Unit::ONE).map(|value| value / unit.per_hertz());
    hertz.or_else(|_| plain(text, Unit::HERTZ)).map_err(|_| {
        let form = "type a frequency, as 120, 120 Hz, 754 rad/s or 7200 rpm";
        value_input::decimal_comma(text).unwrap_or_else(|| form.to_owned())
    })
}
