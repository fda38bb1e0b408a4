//! Natural frequencies of the literature: one file per source under `tests/literature/`.
//!
//! A case gives a model and either printed numbers, with the tolerance that the printed digits allow, or the name of a
//! frequency equation, which is solved here by code that shares only the model with the solver. In both, the list is
//! compared as a whole, so a mode or a load of buckling too many or too few fails. A source's sentences without numbers are tested elsewhere,
//! in the tests that its file names. The table of the guide (`src/guide/validation.md`) is made here, one row per
//! source, and a test holds it equal.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;
#[path = "literature/coupled.rs"]
mod coupled;
#[path = "literature/roots.rs"]
mod roots;
#[path = "literature/source.rs"]
mod source;
#[path = "literature/sprung_mass.rs"]
mod sprung_mass;
#[path = "literature/uncoupled.rs"]
mod uncoupled;

use checked::checked;
use std::sync::atomic::AtomicBool;

use beamtune::model::Model;
use beamtune::solve::modes;
use source::{Case, ClosedForm, Equation, Published, Source, Unit};

/// A smaller difference is rounding; the table does not show its digits.
const ROUNDING: f64 = 1e-9;

/// One mode with the value of its source.
struct Comparison {
    case: String,
    /// Counted from 1 among the modes above 0 Hz.
    mode: usize,
    unit: Unit,
    published: f64,
    ours: f64,
}

impl Comparison {
    fn difference(&self) -> f64 {
        self.ours / self.published - 1.0
    }
}

fn sources() -> Vec<Source> {
    let mut paths: Vec<_> = std::fs::read_dir("tests/literature")
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "toml")
        })
        .collect();
    paths.sort();
    paths
        .iter()
        .map(|path| {
            let text = std::fs::read_to_string(path).unwrap();
            toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        })
        .collect()
}

/// The result of a case: the modes side by side, and every fault.
#[derive(Default)]
struct Outcome {
    compared: Vec<Comparison>,
    faults: Vec<String>,
}

/// Compares the whole list of a model up to `to` Hz with the expected one, in its unit; differences lie from `least` to
/// `most`.
fn side_by_side(
    place: &str,
    model: &Model,
    (expected, unit): (&[f64], Unit),
    to: f64,
    (least, most): (f64, f64),
) -> Outcome {
    let all = match unit {
        Unit::Newton => modes::buckling_factors(&checked(model), to, usize::MAX),
        Unit::Hertz | Unit::RadianPerSecond | Unit::Beta | Unit::BetaL | Unit::BetaLSquared => {
            modes::undamped(&checked(model), to, &AtomicBool::new(false))
                .unwrap()
                .unwrap()
        }
    };
    let ours: Vec<f64> = all
        .into_iter()
        .filter(|&found| found > 0.0)
        .map(|found| unit.of_hertz(found, model))
        .collect();
    let mut outcome = Outcome::default();
    if ours.len() != expected.len() || expected.is_empty() {
        let fault = format!("{place}: {ours:?} against {expected:?} {}", unit.word());
        outcome.faults.push(fault);
        return outcome;
    }
    for (index, (&ours, &published)) in ours.iter().zip(expected).enumerate() {
        let mode = index + 1;
        let comparison = Comparison {
            case: place.to_owned(),
            mode,
            unit,
            published,
            ours,
        };
        let difference = comparison.difference();
        if !(least..=most).contains(&difference) {
            let unit = unit.word();
            outcome.faults.push(format!(
                "{place}, mode {mode}: {ours} against {published} {unit}, {difference:e}"
            ));
        }
        outcome.compared.push(comparison);
    }
    outcome
}

/// Printed numbers against the program's.
fn hold_published(model: &Model, case: &Case, published: &Published) -> Outcome {
    let Published {
        unit,
        values,
        tolerance,
        ours_lie_above,
    } = published;
    let least = if *ours_lie_above { 0.0 } else { -tolerance };
    // A frequency is proportional to the square of beta L, and so is the tolerance.
    let to = values.last().map_or(0.0, |&last| {
        unit.to_hertz(last, model) * (1.0 + 2.0 * tolerance)
    });
    side_by_side(&case.name, model, (values, *unit), to, (least, *tolerance))
}

/// The roots of a frequency equation against the program's.
fn hold_closed_form(model: &Model, case: &Case, form: &ClosedForm) -> Outcome {
    let ClosedForm {
        equation,
        to,
        tolerance,
    } = *form;
    let mut expected = match equation {
        Equation::Uncoupled => uncoupled::frequencies(model, to),
        Equation::Sinusoidal => coupled::sinusoidal(model, to),
        Equation::Determinant => coupled::determinant(model, to),
        Equation::SprungMass => sprung_mass::frequencies(model, to),
    };
    expected.sort_by(f64::total_cmp);
    let range = (-tolerance, tolerance);
    side_by_side(&case.name, model, (&expected, Unit::Hertz), to, range)
}

/// Every comparison of a source, for the table; if there are printed numbers, only those.
fn compare(source: &Source) -> Outcome {
    let (mut published, mut closed) = (Outcome::default(), Outcome::default());
    for case in &source.cases {
        let model = source.model(case);
        let mut held = 0;
        if let Some(print) = &case.published {
            published.extend(hold_published(&model, case, print));
            held += 1;
        }
        if let Some(form) = &case.closed_form {
            closed.extend(hold_closed_form(&model, case, form));
            held += 1;
        }
        assert!(held > 0, "{}: nothing is expected", case.name);
    }
    if published.compared.is_empty() && published.faults.is_empty() {
        return closed;
    }
    published.faults.extend(closed.faults);
    published
}

impl Outcome {
    fn extend(&mut self, other: Self) {
        self.compared.extend(other.compared);
        self.faults.extend(other.faults);
    }
}

/// The comparison for the table: the worst, or the first if all differ by rounding only.
fn worst(compared: &[Comparison]) -> &Comparison {
    let size = |comparison: &Comparison| comparison.difference().abs();
    compared.iter().fold(&compared[0], |worst, next| {
        // The first of equal ones, whatever their rounding.
        let beyond = size(worst).max(ROUNDING) * 1.001;
        if size(next) > beyond { next } else { worst }
    })
}

/// A number with at most nine significant digits.
fn rounded(value: f64) -> String {
    let digits: f64 = format!("{value:.8e}").parse().unwrap();
    digits.to_string()
}

/// A source's row of the guide's table; its faults are added to the list.
fn row(source: &Source, faults: &mut Vec<String>) -> String {
    let name = format!("{} {}", source.authors, source.year);
    if source.cases.is_empty() {
        let all = source.statements.len();
        let departing = source
            .statements
            .iter()
            .filter(|held| !held.departs.is_empty())
            .count();
        return format!(
            "| {} | {name} | {all} sentences | {} hold, {departing} in part | `tests/presets.rs` |\n",
            source.subject,
            all - departing
        );
    }
    let Outcome {
        compared,
        faults: found,
    } = compare(source);
    faults.extend(found.into_iter().map(|fault| format!("{name}: {fault}")));
    if compared.is_empty() {
        return String::new();
    }
    let shown = worst(&compared);
    let difference = shown.difference();
    let difference = if difference.abs() < ROUNDING {
        "< 1e-9".to_owned()
    } else {
        format!("{difference:+.1e}")
    };
    format!(
        "| {}: {}, mode {} ({} compared) | {name} | {} {unit} | {} {unit} | {difference} |\n",
        source.subject,
        shown.case,
        shown.mode,
        compared.len(),
        rounded(shown.published),
        rounded(shown.ours),
        unit = shown.unit.word(),
    )
}

#[test]
fn every_source_is_met_and_the_guide_says_so() {
    let mut table = String::from("| case | source | published | ours | relative difference |\n");
    table.push_str("| --- | --- | --- | --- | --- |\n");
    let mut faults = Vec::new();
    for source in sources() {
        assert!(!source.title.is_empty() && !source.doubtful.is_empty());
        table.push_str(&row(&source, &mut faults));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let chapter = std::fs::read_to_string("src/guide/validation.md").unwrap();
    let (_, rest) = chapter.split_once("<!-- literature: ").unwrap();
    let (_, rest) = rest.split_once("-->\n").unwrap();
    let (shown, _) = rest.split_once("<!-- end of literature -->").unwrap();
    assert_eq!(
        shown.trim(),
        table.trim(),
        "copy the table on the right into src/guide/validation.md"
    );
}

#[test]
fn every_sentence_names_the_test_that_holds_it() {
    let tests = std::fs::read_to_string("tests/presets.rs").unwrap();
    let sources = sources();
    let statements: Vec<_> = sources
        .iter()
        .flat_map(|source| &source.statements)
        .collect();
    assert!(!statements.is_empty());
    for statement in statements {
        assert!(
            tests.contains(&format!("#[test]\nfn {}()", statement.test)),
            "{}: {:?} is held by no test {}",
            statement.figure,
            statement.sentence,
            statement.test
        );
    }
}
