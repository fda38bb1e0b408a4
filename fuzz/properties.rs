//! Properties of every text. Shared by the fuzz targets and `tests/fuzz.rs`; a panic is a failure.

use beamtune::model::edit::{self, Value};
use beamtune::model::{self, Fault, Model, Unit, path, value_input};
use std::sync::OnceLock;

/// A model for paths and typed values: six subsystems, supports, forces, responses and studies.
const SAMPLE: &str = include_str!("../presets/fig05a.toml");

/// Integers up to this are exact floats (2^53, rounded down).
const MOST: usize = 9_000_000_000_000_000;

/// Reading a text gives a valid model that survives writing and reading, or faults with locations; returns whether it
/// was a model.
pub fn model_file(text: &str) -> bool {
    match model::read(text) {
        Ok(model) => {
            accepted(&model, text);
            true
        }
        Err(faults) => {
            assert!(!faults.is_empty(), "refused without a reason");
            for fault in &faults {
                has_a_place(fault, text);
            }
            false
        }
    }
}

fn accepted(model: &Model, text: &str) {
    let faults = model::check(model);
    assert!(faults.is_empty(), "read, but not possible: {faults:?}");
    // Nothing has changed, so no byte does.
    assert_eq!(model::write(model, text), text, "an unchanged model");
    let fresh = model::write(model, "");
    reads_back(model, &fresh);
    // After a change, the text reads as the changed model.
    let mut changed = model.clone();
    changed.title.push_str(" \"2\" \u{1}\r\n\\");
    changed.sweep.points = if model.sweep.points == 7 { 8 } else { 7 };
    if let Some(response) = changed.responses.first_mut() {
        response.enabled = !response.enabled;
    }
    changed.subsystems.reverse();
    if model::check(&changed).is_empty() {
        reads_back(&changed, &model::write(&changed, text));
    }
}

/// The text reads as the model, to the last bit, and is written unchanged.
fn reads_back(model: &Model, text: &str) {
    match model::read(text) {
        // `Debug` distinguishes 0 from -0.
        Ok(found) => {
            let found = found.into_inner();
            assert_eq!(format!("{found:?}"), format!("{model:?}"), "{text}");
        }
        Err(faults) => panic!("what was written is refused: {faults:?}\n{text}"),
    }
    assert_eq!(model::write(model, text), text, "written again");
}

/// Line and column are those of a character of the text, or of the position after its last one.
fn has_a_place(fault: &Fault, text: &str) {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let (Some(line), Some(column)) = (fault.line, fault.column) else {
        panic!("no place: {fault:?}");
    };
    let within = text
        .split('\n')
        .nth(line.wrapping_sub(1))
        .is_some_and(|found| (1..=found.chars().count() + 1).contains(&column));
    assert!(within, "outside of the text: {fault:?}");
    assert!(!fault.message.is_empty(), "says nothing: {fault:?}");
}

/// Typed text for a number, for every kind of parameter, and as a path.
pub fn value(unit: usize, old: f64, text: &str) {
    let unit = &Unit::ALL[unit % Unit::ALL.len()];
    if old.is_finite() {
        typed_number(text, old, unit);
        exact_text(old, unit);
    }
    let sample = sample();
    typed_for_parameters(text, sample);
    path_of(text, sample);
}

fn sample() -> &'static Model {
    static MODEL: OnceLock<Model> = OnceLock::new();
    MODEL.get_or_init(|| match model::read(SAMPLE) {
        Ok(model) => model.into_inner(),
        Err(faults) => panic!("the sample is refused: {faults:?}"),
    })
}

fn typed_number(text: &str, old: f64, unit: &Unit) {
    match value_input::number(text, old, unit) {
        Ok(number) => {
            assert!(number.is_finite(), "{text:?} gives {number}");
            exact_text(number, unit);
        }
        Err(refusal) => assert!(!refusal.is_empty(), "{text:?} is refused without a word"),
    }
    let count = (old.abs() as usize).min(MOST);
    if let Ok(count) = value_input::count(text, count) {
        assert!(count <= MOST, "{text:?} gives {count}");
        assert_eq!(value_input::count(&count.to_string(), 1), Ok(count));
    }
}

/// The text that a prompt shows of a number gives that number when it is accepted unchanged.
fn exact_text(number: f64, unit: &Unit) {
    let shown = unit.format_exact(number);
    let read = value_input::number(&shown, 1.0, unit).map(f64::to_bits);
    assert_eq!(
        read,
        Ok(number.to_bits()),
        "{number:e} is shown as {shown:?}"
    );
}

/// A typed value gives a valid model or leaves the one before.
fn typed_for_parameters(text: &str, sample: &Model) {
    // A number, a count, a flag, a choice, a name, a position and free text.
    let paths = [
        "supports.left.w.stiffness",
        "sweep.points",
        "subsystems.1.enabled",
        "sweep.spacing",
        "subsystems.1.name",
        "forces.1.at",
        "title",
    ];
    for at in paths {
        let parameter = match path::parameter(sample, at) {
            Ok(parameter) => parameter,
            Err(fault) => panic!("{fault}"),
        };
        let Ok(value) = parameter.read(text) else {
            continue;
        };
        if let Value::Number(number) = value {
            assert!(number.is_finite(), "{text:?} gives {number}");
        }
        let mut changed = sample.clone();
        match edit::set(&mut changed, at, value) {
            Ok(()) => assert!(model::check(&changed).is_empty(), "{at} = {text:?}"),
            Err(faults) => {
                assert!(!faults.is_empty(), "{at} = {text:?} refused without a word");
                assert_eq!(changed, *sample, "{at} = {text:?} refused, yet changed");
            }
        }
    }
}

/// A path stands for parameters, each of which stands for itself, or is refused.
fn path_of(text: &str, sample: &Model) {
    let Ok(found) = path::expand(sample, text) else {
        return;
    };
    assert!(!found.is_empty(), "{text:?} stands for nothing");
    for one in found {
        assert_eq!(
            path::expand(sample, &one),
            Ok(vec![one.clone()]),
            "{text:?}"
        );
    }
}
