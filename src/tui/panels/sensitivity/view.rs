//! Which parameter matters: the table, and the bars of the tree.

use ratatui::Frame;
use ratatui::layout::Rect;

use crate::tui::app::{App, Effects, List, Rows, Sensed};
use crate::tui::theme::Theme;
use crate::tui::tree::Node;
use crate::tui::view::table::{self, Column, Content};
use crate::tui::view::text::{cut, significant, width};

/// Cells of a bar at either side of its axis.
const HALF: usize = 3;

/// Columns for a level, in what there is room for.
const LEVEL: [&[Column]; 2] = [
    &[
        ("parameter", 32),
        ("", 10),
        ("dB for p x e", 14),
        ("for +1 %", 12),
    ],
    &[("parameter", 24), ("", 9), ("dB", 8)],
];

/// Columns for a peak.
const PEAK: [&[Column]; 2] = [
    &[
        ("parameter", 30),
        ("", 10),
        ("dB for p x e", 14),
        ("shift", 12),
    ],
    &[("parameter", 18), ("", 8), ("dB", 8), ("shift", 8)],
];

/// Columns for a mode.
const MODE: [&[Column]; 2] = [
    &[
        ("parameter", 30),
        ("", 10),
        ("shift for p x e", 16),
        ("damping %", 12),
    ],
    &[("parameter", 17), ("", 8), ("shift", 9), ("damp %", 8)],
];

pub(crate) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    list: &mut List,
    theme: Theme,
    area: Rect,
) -> Rows {
    let effects = app.sensitivities.effects.as_ref();
    let sensed = effects
        .map(|effects| effects.sensed)
        .or(app.sensitivities.sensed);
    let columns = table::fitting(
        match sensed {
            Some(Sensed::Mode) => &MODE,
            Some(Sensed::Peak) => &PEAK,
            Some(Sensed::Cursor | Sensed::Band) | None => &LEVEL,
        },
        area.width,
    );
    let rows = effects.map_or(&[][..], |effects| &effects.rows);
    let longest = rows.iter().map(|row| width(&row.name)).max().unwrap_or(0);
    let columns = &*table::widened(columns, longest, area.width);
    let empty = match (&app.sensitivities.failure, sensed) {
        (Some(failure), _) => failure.as_str(),
        (None, None) => "what they are of is chosen by the key that opened this table",
        (None, Some(_)) if effects.is_some() => "no parameter matters",
        (None, Some(_)) if app.lacks_figure() => "there is none now that they could be of",
        (None, Some(_)) => "solving",
    };
    let lack = effects.and_then(|effects| effects.lack.as_deref());
    let content = Content {
        title: title(app, effects),
        warns: app.sensitivities.failure.is_some() || lack.is_some(),
        frequency_unit: app.display.unit,
        note: match (lack, sensed) {
            (Some(reason), _) => reason.to_owned(),
            (None, Some(Sensed::Peak | Sensed::Mode)) => {
                format!("shift in {}", app.display.unit.symbol())
            }
            (None, _) => String::new(),
        },
        columns,
        row: &|row| cells(app, theme, row, columns),
        empty,
        stale: effects.is_some_and(|effects| effects.generation != app.curves.generation),
    };
    table::draw(frame, &content, list, theme, area)
}

/// What the sensitivities are of.
fn title(app: &App, effects: Option<&Effects>) -> String {
    let Some(effects) = effects else {
        return "Sensitivities".to_owned();
    };
    let at = |f: f64| app.display.frequency_text(f);
    let [low, high] = effects.at;
    let name = &effects.response;
    match effects.sensed {
        Sensed::Cursor => format!("Sensitivities of {name} at {}", at(low)),
        Sensed::Peak => format!("Sensitivities of {name}, peak at {}", at(low)),
        Sensed::Mode => format!("Sensitivities of the mode at {}", at(low)),
        Sensed::Band => format!(
            "Sensitivities of {name}, mean square {} to {}",
            at(low),
            at(high)
        ),
    }
}

fn cells(app: &App, theme: Theme, row: usize, columns: &[Column]) -> Vec<String> {
    let Some(effects) = &app.sensitivities.effects else {
        return Vec::new();
    };
    let Some(row) = effects.rows.get(row) else {
        return Vec::new();
    };
    let one = &row.effect;
    let room = columns.first().map_or(0, |column| column.1 - 1);
    let name = cut(&row.name, room);
    let name = format!("{name}{}", " ".repeat(room - width(&name)));
    let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), signed);
    let shift = one.frequency.map(|f| f * app.display.unit.per_hertz());
    let bar = bar(effects.share(row), theme);
    match effects.sensed {
        Sensed::Cursor | Sensed::Band => {
            let percent = one.level.map(|level| level * 1.01_f64.ln());
            vec![name, bar, number(one.level), number(percent)]
        }
        Sensed::Peak => vec![name, bar, number(one.level), number(shift)],
        Sensed::Mode => {
            let damping = one.damping_ratio.map(|ratio| 100.0 * ratio);
            vec![name, bar, number(shift), number(damping)]
        }
    }
}

/// A number with its sign.
fn signed(value: f64) -> String {
    let text = significant(value.abs(), 3);
    match value {
        0.0 => text,
        value if value < 0.0 => format!("-{text}"),
        _ => format!("+{text}"),
    }
}

/// A bar from its axis to the left for what is below 0, to the right for what is above; `share` from -1 to 1.
fn bar(share: f64, theme: Theme) -> String {
    // What there is at all shows.
    let halves = (share.abs() * (2 * HALF) as f64).round() as usize;
    let (full, half) = (halves / 2, halves % 2);
    let (left_half, right_half) = if theme.is_ascii() {
        ("#", "#")
    } else {
        ("▐", "▌")
    };
    let blank = " ".repeat(HALF - full - half);
    let solid = "█".repeat(full);
    let none = " ".repeat(HALF);
    if share < 0.0 {
        format!("{blank}{}{solid}│{none}", left_half.repeat(half))
    } else {
        format!("{none}│{solid}{}{blank}", right_half.repeat(half))
    }
}

/// What stands in place of a row's value in the tree: its bar and its effect; none where sensitivities do not show.
pub(crate) fn in_tree(app: &App, theme: Theme, node: Node) -> Option<String> {
    app.sensitivities.sensed?;
    let effects = app.sensitivities.effects.as_ref()?;
    let (effect, share) = effects.of(node)?;
    let scale = match effects.sensed {
        Sensed::Mode => app.display.unit.per_hertz(),
        Sensed::Cursor | Sensed::Peak | Sensed::Band => 1.0,
    };
    Some(format!(
        "{} {:>6}",
        bar(share, theme),
        short(scale * effect)
    ))
}

/// A number with its sign in six cells, unless it is very large.
fn short(value: f64) -> String {
    match value.abs() {
        size if size < 1e-3 => "0".to_owned(),
        size if size < 10.0 => format!("{value:+.3}"),
        size if size < 100.0 => format!("{value:+.2}"),
        size if size < 1e5 => format!("{value:+.0}"),
        _ => format!("{value:+.0e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_as_long_as_their_share() {
        // Closed form: three cells are the whole, half a cell a sixth.
        let theme = Theme::new(true);
        assert_eq!(bar(1.0, theme), "   │███");
        assert_eq!(bar(-1.0, theme), "███│   ");
        assert_eq!(bar(-5.0 / 6.0, theme), "▐██│   ");
        assert_eq!(bar(1.0 / 6.0, theme), "   │▌  ");
        assert_eq!(bar(0.0, theme), "   │   ");
    }

    #[test]
    fn numbers_have_signs() {
        assert_eq!(signed(-3.21), "-3.21");
        assert_eq!(signed(0.5), "+0.500");
        assert_eq!(signed(0.0), "0");
        for (value, text) in [
            (-3.21, "-3.210"),
            (130.4, "+130"),
            (0.0631, "+0.063"),
            (1e-9, "0"),
        ] {
            assert_eq!(short(value), text);
        }
    }
}
