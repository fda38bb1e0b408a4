//! The internal forces along the beam at the cursor's frequency.

use ratatui::Frame;
use ratatui::layout::Rect;

use crate::tui::app::{App, BeamView};
use crate::tui::panels::beam_view::animated::{self, Seen, Words};
use crate::tui::plot::{Axis, Curve, Level, LineStyle, Scale};
use crate::tui::theme::Theme;
use crate::tui::view::text::significant;
use crate::unit::{Load, Unit};

/// A force smaller than this share of the group's largest is not drawn: it may be a rounding error.
const UNSEEN: f64 = 1e-9;

/// Forces that share a panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Group {
    name: &'static str,
    /// SI.
    unit: &'static str,
    /// Their names, and their indices among the forces conjugate to the six motions.
    members: &'static [(&'static str, usize)],
}

/// The groups of forces of a view; those along the six motions are `S_w`, T, `S_v`, `M_w`, B, `M_v`.
fn group(look: BeamView) -> Option<Group> {
    let group = |name, load: Load, members| {
        Some(Group {
            name,
            unit: load.unit().symbol,
            members,
        })
    };
    match look {
        BeamView::Moments => group("Bending moments", Load::Moment, &[("M_w", 3), ("M_v", 5)]),
        BeamView::Shear => group("Shear forces", Load::Force, &[("S_w", 0), ("S_v", 2)]),
        BeamView::Torque => group("Torque", Load::Moment, &[("T", 1)]),
        BeamView::Bimoment => group("Bimoment", Load::Bimoment, &[("B", 4)]),
        _ => None,
    }
}

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let Some(group) = app.beam_view.shown.and_then(group) else {
        return;
    };
    let forces = |frame: &mut Frame<'_>, seen: Seen<'_>, area: Rect| {
        forces(frame, seen, group, area);
    };
    animated::draw(frame, app, (theme, area), group.name, forces);
}

/// A group of forces at a moment, between their amplitudes.
fn forces(frame: &mut Frame<'_>, seen: Seen<'_>, group: Group, area: Rect) {
    let words = Words {
        title: format!("{} at {}", group.name, seen.moment()),
        note: largest(seen, group),
    };
    let inside = animated::panel(frame, &words, seen.theme, area);
    let amplitude = |row: usize| animated::largest(&seen.operating.forces[row]);
    let all = group.members.iter().map(|(_, row)| amplitude(*row));
    let least = UNSEEN * all.fold(0.0, f64::max);
    let members: Vec<Member> = group
        .members
        .iter()
        .filter(|(_, row)| amplitude(*row) > least)
        .map(|(name, row)| Member::new(seen, name, *row))
        .collect();
    let x = &seen.operating.positions;
    let mut curves = Vec::new();
    for (number, member) in members.iter().enumerate() {
        let first = number == 0;
        curves.extend(member.bounds.iter().enumerate().map(|(side, bound)| Curve {
            label: if first && side == 0 { "amplitude" } else { "" }.to_owned(),
            line: LineStyle::Dotted,
            style: seen.theme.curve(number),
            dim: true,
            ..Curve::new(x, bound)
        }));
    }
    for (number, member) in members.iter().enumerate() {
        curves.push(Curve {
            label: member.name.to_owned(),
            line: [LineStyle::Solid, LineStyle::Dashed][number % 2],
            style: seen.theme.curve(number),
            ..Curve::new(x, &member.now)
        });
    }
    let ends = [0.0, x.last().copied().unwrap_or(1.0)];
    let across = Axis::new(Scale::Linear, ends, Unit::METRE.symbol);
    let value = Level::Signed.axis(&curves, &across, group.unit);
    animated::chart(frame, seen, curves, value, inside);
}

/// The largest amplitude of the group, and its position.
fn largest(seen: Seen<'_>, group: Group) -> String {
    let positions = &seen.operating.positions;
    let all = group.members.iter().flat_map(|(name, row)| {
        let forces = seen.operating.forces[*row].iter().zip(positions);
        forces.map(move |(force, x)| (*name, force.norm(), *x))
    });
    match all.max_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((name, amplitude, x)) if amplitude > 0.0 => format!(
            "|{name}| to {} {} at {} m",
            significant(amplitude, 3),
            group.unit,
            significant(x, 3)
        ),
        _ => "none".to_owned(),
    }
}

/// One force along the beam.
struct Member {
    name: &'static str,
    /// At the shown moment.
    now: Vec<f64>,
    /// Its amplitude, positive and negative.
    bounds: [Vec<f64>; 2],
}

impl Member {
    fn new(seen: Seen<'_>, name: &'static str, row: usize) -> Self {
        let force = &seen.operating.forces[row];
        let bound = |side: f64| force.iter().map(|p| side * p.norm()).collect();
        Self {
            name,
            now: seen.now(force),
            bounds: [bound(1.0), bound(-1.0)],
        }
    }
}

#[cfg(test)]
mod tests;
