//! The table of modes.

use crate::model::counted;
use crate::solve::modes::{Gap, MOST_MODES};
use crate::tui::app::{App, Completeness, ModeKind, ModeList, ModeRow};
use crate::tui::view::table::Kind::{Frequency, Plain};
use crate::tui::view::table::{self, Column, Content, NONE, column};
use crate::tui::view::text::{significant, width};

/// Columns with other texts in the narrowest layout are there twice.
#[rustfmt::skip]
const COLUMNS: [Column<ModeRow>; 13] = [
    column(Plain, &[("mode", 6), ("mode", 5), ("no", 5)], number),
    column(Frequency, &[("", 11), ("", 10), ("", 9)], |app, mode| app.display.frequency_digits(mode.frequency)),
    column(Plain, &[("damping %", 12), ("damping %", 11)], |_, mode| damping(mode, "overdamped")),
    column(Plain, &[NONE, NONE, ("damping%", 9)], |_, mode| damping(mode, "overd.")),
    column(Plain, &[("bending y %", 13), ("bending y %", 12)], |_, mode| tenths(mode.shares.bending_y)),
    column(Plain, &[NONE, NONE, ("y%", 4)], |_, mode| whole(mode.shares.bending_y)),
    column(Plain, &[("bending z %", 13), ("bending z %", 12)], |_, mode| tenths(mode.shares.bending_z)),
    column(Plain, &[NONE, NONE, ("z%", 4)], |_, mode| whole(mode.shares.bending_z)),
    column(Plain, &[("twist %", 9), ("twist %", 8)], |_, mode| tenths(mode.shares.twist)),
    column(Plain, &[NONE, NONE, ("twist%", 7)], |_, mode| whole(mode.shares.twist)),
    column(Plain, &[("subsystems %", 14), ("subsystems %", 13)], |_, mode| tenths(mode.shares.subsystems)),
    column(Plain, &[NONE, NONE, ("subs%", 6)], |_, mode| whole(mode.shares.subsystems)),
    column(Plain, &[("supports %", 12)], |_, mode| tenths(mode.shares.supports)),
];

/// The table in this number of columns of the screen.
pub(crate) fn content(app: &App, columns: u16) -> Content<'_, ModeRow> {
    let modes = app.modes.list.as_ref();
    Content {
        title: modes.map_or("Modes".to_owned(), |list| title(app, list, columns)),
        warns: modes.is_some_and(|list| match list.completeness {
            // The certified count follows in a moment.
            Completeness::Certain | Completeness::Uncounted => false,
            Completeness::Open(_) | Completeness::TooMany => true,
        }),
        note: match modes.map(|list| &list.completeness) {
            Some(Completeness::Open(_)) => "? in an open range".to_owned(),
            _ => "shares of kinetic energy".to_owned(),
        },
        columns: &COLUMNS,
        rows: modes.map_or(&[], |modes| &modes.rows),
        sentences: Vec::new(),
        empty: match modes {
            None => "computing the modes".into(),
            Some(list) if list.completeness == Completeness::TooMany => {
                format!("more than {MOST_MODES} modes are not listed: lower the end of the sweep")
                    .into()
            }
            Some(list) => format!("no mode below {}", app.display.frequency_text(list.to)).into(),
        },
        stale: modes.is_some_and(|list| list.generation != app.curves.generation),
    }
}

/// The number of modes, and whether the list is complete; open ranges as far as there is room for them.
fn title(app: &App, list: &ModeList, columns: u16) -> String {
    let found = list.rows.len();
    let to = app.display.frequency_text(list.to);
    match &list.completeness {
        Completeness::Certain => format!("Modes: {found} of {found} below {to}"),
        Completeness::Uncounted => format!("Modes: {found} below {to}, not counted yet"),
        Completeness::TooMany => format!("Modes: more than {MOST_MODES} below {to}"),
        Completeness::Open(gaps) => {
            let ranges: Vec<String> = gaps.iter().map(|gap| range(app, gap)).collect();
            let all = ranges.join(", ");
            let first = ranges.first().map_or("", String::as_str);
            let more = ranges.len().saturating_sub(1);
            let texts = [
                format!("Modes: {found} below {to}, open at {all}"),
                format!("Modes: {found}, open at {all}"),
                format!("Modes: {found}, open at {first}, {more} more"),
                format!(
                    "Modes: {found}, {} open",
                    counted(ranges.len(), "range", "ranges")
                ),
            ];
            let room = table::title_room(columns);
            let fitting = texts.iter().find(|text| width(text) <= room);
            fitting.unwrap_or(&texts[3]).clone()
        }
    }
}

/// A range of frequencies with its unit once, if both ends have the same.
fn range(app: &App, gap: &Gap) -> String {
    let [from, to] = [gap.from, gap.to].map(|hertz| app.display.frequency_text(hertz));
    match (from.split_once(' '), to.split_once(' ')) {
        (Some((number, unit)), Some((_, same))) if unit == same => format!("{number} to {to}"),
        _ => format!("{from} to {to}"),
    }
}

fn number(app: &App, mode: &ModeRow) -> String {
    let list = app.modes.list.as_ref();
    let is_open = list.is_some_and(|list| list.is_open_at(mode));
    format!("{}{}", if is_open { "?" } else { "" }, mode.number)
}

fn damping(mode: &ModeRow, overdamped: &str) -> String {
    match mode.kind {
        ModeKind::RigidBody => "rigid".to_owned(),
        ModeKind::Oscillating => significant(100.0 * mode.damping_ratio, 4),
        ModeKind::Overdamped => overdamped.to_owned(),
    }
}

/// A share in percent with one decimal; a rounding error below 0 is 0.
fn tenths(share: f64) -> String {
    format!("{:.1}", 100.0 * share.max(0.0))
}

/// The same without decimals.
fn whole(share: f64) -> String {
    format!("{:.0}", 100.0 * share.max(0.0))
}
