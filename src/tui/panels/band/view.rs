//! The table of the levels in the marked band, and how well the model fits the measurements there.

use ratatui::Frame;
use ratatui::layout::Rect;

use crate::measured::Fit;
use crate::model::counted;
use crate::solve::band::Level;
use crate::tui::app::{App, List, MemberLevels, ResponseLevel, Rows};
use crate::tui::theme::Theme;
use crate::tui::view::table::{self, Column, Content};
use crate::tui::view::text::significant;
use crate::unit::Kind;

/// The columns, in what there is room for. A reduction is positive where the level is lower than the reference's.
const LAYOUTS: [&[Column]; 2] = [
    &[
        ("curve", 20),
        ("maximum", 12),
        ("at", 11),
        ("root mean square", 18),
        ("max reduced dB", 16),
        ("rms reduced dB", 16),
    ],
    &[
        ("curve", 8),
        ("max", 10),
        ("rms", 10),
        ("max -dB", 8),
        ("rms -dB", 8),
    ],
];

/// A curve of fewer points has the shape of any other.
const FEWEST: usize = 3;

/// A row of the table.
pub(crate) enum Row {
    /// The level of a curve, and that of the reference it is held against.
    Level {
        label: String,
        level: Level,
        energy: bool,
        against: Option<Level>,
    },
    /// How well a response fits a measured curve, in words.
    Fit(String),
}

/// A row for each curve that shows, the references, and the measured curves.
pub(crate) fn rows(app: &App) -> Vec<Row> {
    let mut rows = Vec::new();
    if let Some(levels) = &app.band.levels {
        let first = levels.references.first().map(|(_, members)| &members[..]);
        rows.extend(levels_of(app, &levels.members, "", first));
        for (id, members) in &levels.references {
            let mut references = app.comparison.shown();
            let name = references.find(|one| one.id == *id).map(|one| &*one.name);
            rows.extend(levels_of(app, members, name.unwrap_or_default(), None));
        }
    }
    rows.extend(app.comparison.fits.iter().map(|fitted| {
        let mut measured = app.comparison.measured.iter();
        let name = measured
            .find(|one| one.id == fitted.measured)
            .map_or("", |one| &one.name);
        Row::Fit(format!("{}: {name}", fit_words(&fitted.fit)))
    }));
    rows
}

/// How well a response fits a measured curve.
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
                Row::Level {
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

pub(crate) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    list: &mut List,
    theme: Theme,
    area: Rect,
) -> Rows {
    let rows = rows(app);
    let title = match app.curves.band {
        Some([low, high]) => format!(
            "Band {} to {}",
            app.display.frequency_text(low),
            app.display.frequency_text(high)
        ),
        None => "Band".to_owned(),
    };
    let columns = table::fitting(&LAYOUTS, area.width);
    let levels = app.band.levels.as_ref();
    let content = Content {
        title,
        warns: false,
        frequency_unit: app.display.unit,
        note: unit(app),
        columns,
        row: &|index| {
            rows.get(index)
                .map_or(Vec::new(), |row| cells(app, row, columns))
        },
        empty: match (&app.band.failure, app.curves.band) {
            (Some(reason), _) => reason,
            (None, None) => "no band is marked",
            (None, Some(_)) => "solving the levels",
        },
        stale: levels.is_some_and(|levels| levels.generation != app.curves.generation),
    };
    table::draw(frame, &content, list, theme, area)
}

/// The units of the levels that show.
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

fn cells(app: &App, row: &Row, columns: &[Column]) -> Vec<String> {
    let (label, level, energy, against) = match row {
        Row::Fit(words) => return vec![words.clone()],
        Row::Level {
            label,
            level,
            energy,
            against,
        } => (label, level, *energy, against),
    };
    let number = |value: f64| {
        if value.is_finite() {
            format!("{value:.3e}")
        } else if value == f64::INFINITY {
            "infinite".to_owned()
        } else {
            "-".to_owned()
        }
    };
    // An energy is a square already.
    let size = |level: &Level| {
        if energy {
            level.mean_square
        } else {
            level.mean_square.sqrt()
        }
    };
    let factor = if energy { 10.0 } else { 20.0 };
    let reduced = |of: &dyn Fn(&Level) -> f64| {
        let decibels = against.map(|other| factor * (of(&other) / of(level)).log10());
        let finite = decibels.filter(|decibels| decibels.is_finite());
        finite.map_or_else(|| "-".to_owned(), significant_decibels)
    };
    let cell = |name: &str| match name {
        "curve" => label.clone(),
        "maximum" | "max" => number(level.maximum),
        "at" => app.display.frequency_digits(level.at),
        "root mean square" | "rms" => number(size(level)),
        "max reduced dB" | "max -dB" => reduced(&|level| level.maximum),
        _ => reduced(&size),
    };
    columns.iter().map(|(name, _)| cell(name)).collect()
}

fn significant_decibels(decibels: f64) -> String {
    if decibels == 0.0 {
        "0".to_owned()
    } else {
        significant(decibels, 4)
    }
}
