//! Sensitivities: the table, and the bars of the tree.

use crate::tui::app::{App, Effects, Sensed, Weighed};
use crate::tui::theme::Theme;
use crate::tui::tree::Node;
use crate::tui::view::table::Kind::{Name, Plain};
use crate::tui::view::table::{Column, Content, column};
use crate::tui::view::text::significant;

/// Cells of a bar on either side of its axis.
const HALF: usize = 3;

/// Columns for a level.
#[rustfmt::skip]
const LEVEL: [Column<Weighed>; 4] = [
    column(Name, &[("parameter", 32), ("parameter", 24)], name),
    column(Plain, &[("", 10), ("", 9)], bar_of),
    column(Plain, &[("dB for p x e", 14), ("dB", 8)], level),
    column(Plain, &[("for +1 %", 12)], |_, row| number(row.effect.level.map(|one| one * 1.01_f64.ln()))),
];

/// Columns for a peak.
#[rustfmt::skip]
const PEAK: [Column<Weighed>; 4] = [
    column(Name, &[("parameter", 30), ("parameter", 18)], name),
    column(Plain, &[("", 10), ("", 8)], bar_of),
    column(Plain, &[("dB for p x e", 14), ("dB", 8)], level),
    column(Plain, &[("shift", 12), ("shift", 8)], shift),
];

/// Columns for a mode.
#[rustfmt::skip]
const MODE: [Column<Weighed>; 4] = [
    column(Name, &[("parameter", 30), ("parameter", 17)], name),
    column(Plain, &[("", 10), ("", 8)], bar_of),
    column(Plain, &[("shift for p x e", 16), ("shift", 9)], shift),
    column(Plain, &[("damping %", 12), ("damp %", 8)], damping),
];

pub(crate) fn content(app: &App) -> Content<'_, Weighed> {
    let effects = app.sensitivities.effects.as_ref();
    let sensed = effects
        .map(|effects| effects.sensed)
        .or(app.sensitivities.sensed);
    let lack = effects.and_then(|effects| effects.lack.as_deref());
    Content {
        title: title(app, effects),
        warns: app.sensitivities.failure.is_some() || lack.is_some(),
        note: match (lack, sensed) {
            (Some(reason), _) => reason.to_owned(),
            (None, Some(Sensed::Peak | Sensed::Mode)) => {
                format!("shift in {}", app.display.unit.symbol())
            }
            (None, _) => String::new(),
        },
        columns: match sensed {
            Some(Sensed::Mode) => &MODE,
            Some(Sensed::Peak) => &PEAK,
            Some(Sensed::Cursor | Sensed::Band) | None => &LEVEL,
        },
        rows: effects.map_or(&[], |effects| &effects.rows),
        sentences: Vec::new(),
        empty: match (&app.sensitivities.failure, sensed) {
            (Some(failure), _) => failure.as_str(),
            (None, None) => "select level, peak, mode or band with the key that opened this table",
            (None, Some(_)) if effects.is_some() => "no parameter has an effect",
            (None, Some(_)) if app.lacks_figure() => {
                "there is no such level, peak, mode or band now"
            }
            (None, Some(_)) => "solving",
        }
        .into(),
        stale: effects.is_some_and(|effects| effects.generation != app.curves.generation),
    }
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

fn name(_: &App, row: &Weighed) -> String {
    row.name.clone()
}

fn bar_of(app: &App, row: &Weighed) -> String {
    let effects = app.sensitivities.effects.as_ref();
    bar(effects.map_or(0.0, |effects| effects.share(row)), app.theme)
}

fn level(_: &App, row: &Weighed) -> String {
    number(row.effect.level)
}

fn shift(app: &App, row: &Weighed) -> String {
    let shift = row.effect.frequency;
    number(shift.map(|shift| shift * app.display.unit.per_hertz()))
}

fn damping(_: &App, row: &Weighed) -> String {
    number(row.effect.damping_ratio.map(|ratio| 100.0 * ratio))
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), signed)
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

/// A bar from its axis to the left for negative values, to the right for positive ones; `share` from -1 to 1.
fn bar(share: f64, theme: Theme) -> String {
    // Any value other than 0 is visible.
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

/// The content of a row in place of its value: its bar and its effect; none if sensitivities are hidden.
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
        // Closed form: three cells are the full length, half a cell is a sixth.
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
