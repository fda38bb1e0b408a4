//! The table of the levels in the marked band, and how well the model fits the measurements there.

use crate::measured::Fit;
use crate::model::counted;
use crate::solve::band::Level;
use crate::tui::app::{App, Fitted, MemberLevels, ResponseLevel};
use crate::tui::view::table::Kind::Plain;
use crate::tui::view::table::{Column, Content, column};
use crate::tui::view::text::significant;
use crate::unit::Kind;

/// The columns. A reduction is positive where the level is lower than the reference's.
#[rustfmt::skip]
const COLUMNS: [Column<Row>; 6] = [
    column(Plain, &[("curve", 20), ("curve", 8)], |_, row| row.label.clone()),
    column(Plain, &[("maximum", 12), ("max", 10)], |_, row| number(row.level.maximum)),
    column(Plain, &[("at", 11)], |app, row| app.display.frequency_digits(row.level.at)),
    column(Plain, &[("root mean square", 18), ("rms", 10)], |_, row| number(row.size(&row.level))),
    column(Plain, &[("max reduced dB", 16), ("max -dB", 8)], |_, row| row.reduced(|level| level.maximum)),
    column(Plain, &[("rms reduced dB", 16), ("rms -dB", 8)], |_, row| row.reduced(|level| row.size(level))),
];

/// The least number of points: fewer have no shape to compare.
const FEWEST: usize = 3;

/// The level of a curve, and the level of the reference to compare it with.
pub(crate) struct Row {
    label: String,
    level: Level,
    energy: bool,
    against: Option<Level>,
}

/// A row for each visible curve and for the references.
pub(crate) fn rows(app: &App) -> Vec<Row> {
    let Some(levels) = &app.band.levels else {
        return Vec::new();
    };
    let first = levels.references.first().map(|(_, members)| &members[..]);
    let mut rows = levels_of(app, &levels.members, "", first);
    for (id, members) in &levels.references {
        let mut references = app.comparison.shown();
        let name = references.find(|one| one.id == *id).map(|one| &*one.name);
        rows.extend(levels_of(app, members, name.unwrap_or_default(), None));
    }
    rows
}

/// How well responses fit the measured curves: a sentence for each.
fn fits(app: &App) -> Vec<String> {
    let sentence = |fitted: &Fitted| {
        let mut measured = app.comparison.measured.iter();
        let name = measured
            .find(|one| one.id == fitted.measured)
            .map_or("", |one| &one.name);
        format!("{}: {name}", fit_words(&fitted.fit))
    };
    app.comparison.fits.iter().map(sentence).collect()
}

/// How well a response matches a measured curve, as text.
pub(crate) fn fit_words(fit: &Fit) -> String {
    if fit.points < FEWEST {
        return format!(
            "{} too few to compare",
            counted(fit.points, "point is", "points are")
        );
    }
    let of = if fit.of_magnitudes {
        " of magnitudes"
    } else {
        ""
    };
    format!(
        "FRAC{of} {:.4}, {:+.2} dB, rms {:.2}",
        fit.frac, fit.mean_decibels, fit.rms_decibels
    )
}

fn levels_of(
    app: &App,
    members: &[MemberLevels],
    name: &str,
    against: Option<&[MemberLevels]>,
) -> Vec<Row> {
    let mut rows = Vec::new();
    for response in &app.curves.visible {
        for (number, member) in members.iter().enumerate() {
            let found = level_of(member, response);
            rows.extend(found.map(|one| {
                let words = [Some(name), member.label.as_deref()];
                let mut words: Vec<&str> = words.into_iter().flatten().collect();
                words.retain(|word| !word.is_empty());
                if words.is_empty() || app.curves.visible.len() > 1 {
                    words.push(response);
                }
                let other = against
                    .and_then(|members| members.get(number).or(members.first()))
                    .and_then(|member| level_of(member, response));
                Row {
                    label: words.join(" "),
                    level: one.level,
                    energy: one.kind == Kind::Energy,
                    against: other.map(|other| other.level),
                }
            }));
        }
    }
    rows
}

fn level_of<'a>(member: &'a MemberLevels, response: &str) -> Option<&'a ResponseLevel> {
    member.levels.iter().find(|one| one.response == response)
}

pub(crate) fn content<'a>(app: &'a App, rows: &'a [Row]) -> Content<'a, Row> {
    let levels = app.band.levels.as_ref();
    Content {
        title: match app.curves.band {
            Some([low, high]) => format!(
                "Band {} to {}",
                app.display.frequency_text(low),
                app.display.frequency_text(high)
            ),
            None => "Band".to_owned(),
        },
        warns: false,
        note: unit(app),
        columns: &COLUMNS,
        rows,
        sentences: fits(app),
        empty: match (&app.band.failure, app.curves.band) {
            (Some(reason), _) => reason,
            (None, None) => "no band is marked",
            (None, Some(_)) => "computing the levels",
        }
        .into(),
        stale: levels.is_some_and(|levels| levels.generation != app.curves.generation),
    }
}

/// The units of the visible levels.
fn unit(app: &App) -> String {
    let mut units: Vec<String> = Vec::new();
    let members = app.band.levels.iter().flat_map(|levels| &levels.members);
    for level in members.flat_map(|member| &member.levels) {
        let unit = level.kind.unit();
        if app.curves.shows(&level.response) && !units.contains(&unit) {
            units.push(unit);
        }
    }
    match units.as_slice() {
        [] => String::new(),
        [unit] if *unit == Kind::Energy.unit() => format!("{unit}; rms is the mean"),
        units => format!("{}, zero to peak", units.join(", ")),
    }
}

impl Row {
    /// The root mean square of a level; an energy is a square already.
    fn size(&self, level: &Level) -> f64 {
        if self.energy {
            level.mean_square
        } else {
            level.mean_square.sqrt()
        }
    }

    /// By how many decibels a figure of the level is lower than that of the reference.
    fn reduced(&self, of: impl Fn(&Level) -> f64) -> String {
        let factor = if self.energy { 10.0 } else { 20.0 };
        let decibels = |other: &Level| factor * (of(other) / of(&self.level)).log10();
        match self.against.as_ref().map(decibels) {
            Some(0.0) => "0".to_owned(),
            Some(decibels) if decibels.is_finite() => significant(decibels, 4),
            _ => "-".to_owned(),
        }
    }
}

fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:.3e}")
    } else if value == f64::INFINITY {
        "infinite".to_owned()
    } else {
        "-".to_owned()
    }
}
