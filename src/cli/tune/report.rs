//! The result of a search: the table that is printed and the text for the notes.

use crate::cli::padded;
use crate::escape::escape;
use crate::model::{Aim, Checked, Limit, Unit, Variable, counted, path};
use crate::tune::words::{bounds, first_parameter, level, of_objective, range};
use crate::tune::{Achieved, LimitOutcome, Moved, Place, Tuned, WorstCase};

/// An objective, a variable or a limit before and after.
struct Row {
    what: String,
    /// Empty if unknown.
    before: String,
    after: String,
    /// Additional information; may be empty.
    more: String,
}

impl Row {
    /// With hidden characters in names escaped.
    fn shown(self) -> Self {
        let shown = |text: String| escape(&text).into_owned();
        Self {
            what: shown(self.what),
            before: shown(self.before),
            after: shown(self.after),
            more: shown(self.more),
        }
    }
}

/// The table: one block each for objectives, variables and limits, and the course of the search.
pub(super) fn table(model: &Checked, tuned: &Tuned) -> String {
    let mut blocks = vec![
        ("objective", objectives(model, tuned)),
        ("variable", variables(model, tuned)),
        ("limit", limits(model, tuned)),
    ];
    blocks.retain(|(_, rows)| !rows.is_empty());
    let heading = |what: &str| Row {
        what: what.to_owned(),
        before: "before".to_owned(),
        after: "after".to_owned(),
        more: String::new(),
    };
    let mut rows = Vec::new();
    for (what, block) in blocks {
        rows.push(heading(what));
        rows.extend(block.into_iter().map(Row::shown));
    }
    let widest = |cell: fn(&Row) -> &String| {
        let widths = rows.iter().map(|row| cell(row).chars().count());
        widths.max().unwrap_or(0)
    };
    let (what, before, after) = (
        widest(|row| &row.what),
        widest(|row| &row.before),
        widest(|row| &row.after),
    );
    let mut text = String::new();
    for (index, row) in rows.iter().enumerate() {
        let is_heading = index > 0 && row.before == "before" && row.after == "after";
        if is_heading {
            text.push('\n');
        }
        let line = format!(
            "{}  {}  {}  {}",
            padded(&row.what, what),
            padded(&row.before, before),
            padded(&row.after, after),
            row.more
        );
        text.push_str(line.trim_end());
        text.push('\n');
    }
    format!("{text}\n{}\n", how(tuned))
}

/// The text for the notes, one line per item.
pub(super) fn notes(model: &Checked, tuned: &Tuned) -> String {
    let rows = objectives(model, tuned)
        .into_iter()
        .chain(variables(model, tuned))
        .chain(limits(model, tuned));
    let mut lines = vec![format!("Tuned: {}.", how(tuned))];
    for row in rows {
        let before = if row.before.is_empty() {
            String::new()
        } else {
            format!("{} -> ", row.before)
        };
        let more = if row.more.is_empty() {
            String::new()
        } else {
            format!(" ({})", row.more)
        };
        lines.push(format!("{}: {before}{}{more}", row.what, row.after));
    }
    lines.join("\n") + "\n"
}

/// The number of models, the seed and the reason of the stop.
fn how(tuned: &Tuned) -> String {
    let models = counted(tuned.evaluations, "model", "models");
    format!("{models}, seed {}, {}", tuned.seed, tuned.stop)
}

fn objectives(model: &Checked, tuned: &Tuned) -> Vec<Row> {
    let pairs = tuned.before.iter().zip(&tuned.after);
    let rows = pairs.map(|(before, after)| objective(model, before, after));
    let worst = tuned
        .worst_case
        .as_ref()
        .map(|worst| worst_case(tuned, worst));
    rows.chain(worst).collect()
}

fn objective(model: &Checked, before: &Achieved, after: &Achieved) -> Row {
    let objective = &after.objective;
    let what = of_objective(model, objective, |wording| wording.figure);
    let more = [change(before, after), places(after)];
    let more: Vec<_> = more.into_iter().filter(|text| !text.is_empty()).collect();
    Row {
        what,
        before: figure(before),
        after: figure(after),
        more: more.join(", "),
    }
}

/// The figure for people: for a width the width itself, not the rest of the band.
fn figure(achieved: &Achieved) -> String {
    let objective = &achieved.objective;
    let value = match objective.aim {
        Aim::Width { .. } => (objective.to - objective.from - achieved.figure).max(0.0),
        _ => achieved.figure,
    };
    format!("{} {}", Unit::ONE.format(value), achieved.unit)
        .trim_end()
        .to_owned()
}

/// The change of a level in decibels.
fn change(before: &Achieved, after: &Achieved) -> String {
    let Some(per_decade) = after.objective.aim.decibels() else {
        return String::new();
    };
    let decibels = per_decade * (after.figure / before.figure).log10();
    if decibels.is_finite() {
        format!("{decibels:+.2} dB")
    } else {
        String::new()
    }
}

/// The frequency of the figure.
fn places(achieved: &Achieved) -> String {
    let hertz = |place: f64| Unit::HERTZ.format(place);
    match (&achieved.objective.aim, &achieved.places[..]) {
        (Aim::Width { .. }, [from, to]) => range(*from, *to, Unit::HERTZ),
        (_, []) => String::new(),
        (_, places) => {
            let places: Vec<_> = places.iter().map(|place| hertz(*place)).collect();
            format!("at {}", places.join(", "))
        }
    }
}

fn worst_case(tuned: &Tuned, worst: &WorstCase) -> Row {
    // With one objective the worst case has its unit; with several it is their combination.
    let unit = match &tuned.after[..] {
        [one] => one.unit.as_str(),
        _ => "",
    };
    let text = |value: f64| {
        format!("{} {unit}", Unit::ONE.format(value))
            .trim_end()
            .to_owned()
    };
    let limits = if worst.is_possible {
        ""
    } else {
        ", limits not met"
    };
    Row {
        what: "worst over the tolerances".to_owned(),
        before: text(worst.before),
        after: text(worst.after),
        more: format!(
            "{}, {}{limits}",
            counted(worst.corners, "corner", "corners"),
            counted(worst.samples, "point", "points")
        ),
    }
}

fn variables(model: &Checked, tuned: &Tuned) -> Vec<Row> {
    let given = model.tune.iter().flat_map(|tune| &tune.variables);
    given
        .zip(&tuned.variables)
        .map(|(variable, moved)| self::variable(model, variable, moved))
        .collect()
}

fn variable(model: &Checked, variable: &Variable, moved: &Moved) -> Row {
    let first = first_parameter(model, variable);
    let unit = first.as_ref().map_or(Unit::ONE, |first| first.unit);
    let count = variable.parameters(model).map_or(1, |all| all.len());
    let what = first.map_or_else(
        || moved.paths.join(", "),
        |first| path::text(model, first.id),
    );
    let what = match count {
        0 | 1 => what,
        count => format!("{what} and {} more", count - 1),
    };
    let mut more = bounds(model, variable);
    match moved.place {
        Place::Inside => {}
        Place::AtMin => more.push_str(", at the lower bound"),
        Place::AtMax => more.push_str(", at the upper bound"),
    }
    if let Some(uncertainty) = moved.uncertainty {
        more = format!("standard uncertainty {}, {more}", unit.format(uncertainty));
    }
    Row {
        what,
        before: unit.format(moved.before),
        after: unit.format(moved.after),
        more,
    }
}

fn limits(model: &Checked, tuned: &Tuned) -> Vec<Row> {
    tuned
        .limits
        .iter()
        .map(|kept| self::limit(model, kept))
        .collect()
}

fn limit(model: &Checked, kept: &LimitOutcome) -> Row {
    let (what, after, wanted) = match &kept.limit {
        Limit::AddedMass { at_most } => {
            let mass = |value| Unit::KILOGRAM.format(value);
            let wanted = format!("at most {}", mass(*at_most));
            ("added mass".to_owned(), mass(kept.value), wanted)
        }
        Limit::NoMode { from, to } => {
            let near = if kept.value.is_finite() {
                Unit::HERTZ.format(kept.value)
            } else {
                "none near".to_owned()
            };
            let wanted = format!("none in {}", range(*from, *to, Unit::HERTZ));
            ("natural frequency".to_owned(), near, wanted)
        }
        Limit::Peak { response, at_most } => {
            let what = format!("highest peak of {response}");
            let wanted = format!("at most {}", level(model, response, *at_most));
            (what, level(model, response, kept.value), wanted)
        }
        Limit::StaticDeflection { response, at_most } => {
            let what = format!("{response} at rest");
            let wanted = format!("at most {}", level(model, response, *at_most));
            (what, level(model, response, kept.value), wanted)
        }
        Limit::Buckling { at_least } => {
            let found = if kept.value.is_finite() {
                format!("at {} times the force", Unit::ONE.format(kept.value))
            } else {
                "no compression".to_owned()
            };
            let wanted = format!("at least {} times", Unit::ONE.format(*at_least));
            ("buckling".to_owned(), found, wanted)
        }
    };
    let kept = if kept.holds { "" } else { ": NOT KEPT" };
    Row {
        what,
        before: String::new(),
        after,
        more: format!("{wanted}{kept}"),
    }
}
