//! The table of modes.

use ratatui::Frame;
use ratatui::layout::Rect;

use crate::model::counted;
use crate::solve::modes::{Gap, MOST_MODES};
use crate::tui::app::{App, Completeness, List, ModeKind, ModeList, ModeRow, Rows};
use crate::tui::theme::Theme;
use crate::tui::view::table::{self, Column, Content, FREQUENCY};
use crate::tui::view::text::{significant, width};

/// The columns, in what there is room for.
const LAYOUTS: [&[Column]; 3] = [
    &[
        ("mode", 6),
        (FREQUENCY, 11),
        ("damping %", 12),
        ("bending y %", 13),
        ("bending z %", 13),
        ("twist %", 9),
        ("subsystems %", 14),
        ("supports %", 12),
    ],
    &[
        ("mode", 5),
        (FREQUENCY, 10),
        ("damping %", 11),
        ("bending y %", 12),
        ("bending z %", 12),
        ("twist %", 8),
        ("subsystems %", 13),
    ],
    &[
        ("no", 5),
        (FREQUENCY, 9),
        ("damping%", 9),
        ("y%", 4),
        ("z%", 4),
        ("twist%", 7),
        ("subs%", 6),
    ],
];

pub(crate) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    list: &mut List,
    theme: Theme,
    area: Rect,
) -> Rows {
    let columns = table::fitting(&LAYOUTS, area.width);
    let modes = app.modes.list.as_ref();
    let rows = modes.map_or(&[][..], |modes| &modes.rows);
    let empty = match modes {
        None => "solving the modes".to_owned(),
        Some(list) if list.completeness == Completeness::TooMany => {
            format!("none is listed: at most {MOST_MODES} are; a lower end of the sweep has fewer")
        }
        Some(list) => format!("no mode below {}", app.display.frequency_text(list.to)),
    };
    let content = Content {
        title: modes.map_or("Modes".to_owned(), |list| title(app, list, area.width)),
        warns: modes.is_some_and(|list| match list.completeness {
            // The count comes in a moment.
            Completeness::Certain | Completeness::Uncounted => false,
            Completeness::Open(_) | Completeness::TooMany => true,
        }),
        frequency_unit: app.display.unit,
        note: match modes.map(|list| &list.completeness) {
            Some(Completeness::Open(_)) => "? in an open range".to_owned(),
            _ => "shares of kinetic energy".to_owned(),
        },
        columns,
        row: &|row| {
            rows.get(row).map_or(Vec::new(), |mode| {
                let frequency = app.display.frequency_digits(mode.frequency);
                let is_open = modes.is_some_and(|list| list.is_open_at(mode));
                let number = format!("{}{}", if is_open { "?" } else { "" }, row + 1);
                cells(
                    number,
                    mode,
                    frequency,
                    columns == LAYOUTS[LAYOUTS.len() - 1],
                )
            })
        },
        empty: &empty,
        stale: modes.is_some_and(|list| list.generation != app.curves.generation),
    };
    table::draw(frame, &content, list, theme, area)
}

/// How many there are, and whether these are all; open ranges as far as there is room for.
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

fn cells(number: String, mode: &ModeRow, frequency: String, narrow: bool) -> Vec<String> {
    let damping = match mode.kind {
        ModeKind::RigidBody => "rigid".to_owned(),
        ModeKind::Oscillating => significant(100.0 * mode.damping_ratio, 4),
        ModeKind::Overdamped if narrow => "overd.".to_owned(),
        ModeKind::Overdamped => "overdamped".to_owned(),
    };
    let shares = mode.shares;
    let decimals = usize::from(!narrow);
    // A rounding error below 0 is 0.
    let share = |share: f64| format!("{:.decimals$}", 100.0 * share.max(0.0));
    vec![
        number,
        frequency,
        damping,
        share(shares.bending_y),
        share(shares.bending_z),
        share(shares.twist),
        share(shares.subsystems),
        share(shares.supports),
    ]
}
