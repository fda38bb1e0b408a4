//! The sources and sinks of power at the cursor's frequency, and the power flow along the beam.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;
use ratatui::text::{Line, Span};

use crate::model::{Force, Place, Target};
use crate::tui::app::App;
use crate::tui::panels::beam_view::animated::{self, Seen, Words};
use crate::tui::plot::{Axis, Curve, Level, Scale};
use crate::tui::theme::Theme;
use crate::tui::view::text::{cut, significant, width};
use crate::unit::Unit;

/// Columns of the numbers: power in W, and its percentage.
const NUMBERS: [usize; 2] = [10, 7];

/// Columns of the longest label that is not cut, and of the table with its bars next to the flow.
const LABEL: usize = 16;
const TABLE: u16 = 46;

/// The flow is shown if there are this number of columns next to the table.
const FLOW: u16 = 30;

/// More forces than these share one row.
const MOST_FORCES: usize = 3;

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
struct Row {
    label: String,
    /// W.
    power: f64,
    /// Whether the power is a loss, and has a bar.
    loss: bool,
}

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    animated::draw(frame, app, (theme, area), "Power", power);
}

fn power(frame: &mut Frame<'_>, seen: Seen<'_>, area: Rect) {
    let found = &seen.operating.power;
    let words = Words {
        title: format!("Power at {}", seen.at),
        note: format!(
            "in {} W, out {} W",
            watts(found.input()),
            watts(found.loss())
        ),
    };
    let inside = animated::panel(frame, &words, seen.theme, area);
    let mut table = inside;
    if inside.width >= TABLE + FLOW {
        let [left, right] =
            Layout::horizontal([Constraint::Length(TABLE), Constraint::Fill(1)]).areas(inside);
        table = left;
        flow(frame, seen, right);
    }
    let rows = fitted(rows(seen), usize::from(table.height).saturating_sub(1));
    let Some((heading, body)) = split(table) else {
        return;
    };
    let names = format!(
        "{:>1$}{2:>3$}",
        "W",
        label_columns(table) + NUMBERS[0],
        "%",
        NUMBERS[1]
    );
    frame.render_widget(Line::styled(names, seen.theme.dim()), heading);
    for (row, line) in rows.iter().zip(body.rows()) {
        frame.render_widget(
            row.line(seen, usize::from(table.width), label_columns(table)),
            line,
        );
    }
}

/// A power without its unit; a dash if only a rounding error is left.
fn watts(power: f64) -> String {
    if power.is_finite() {
        significant(power, 3)
    } else {
        "-".to_owned()
    }
}

fn split(table: Rect) -> Option<(Rect, Rect)> {
    let heading = table.rows().next()?;
    let body = Rect {
        y: table.y + 1,
        height: table.height - 1,
        ..table
    };
    Some((heading, body))
}

/// Columns of the labels: half of a narrow table.
fn label_columns(table: Rect) -> usize {
    (usize::from(table.width) / 2).min(LABEL)
}

/// The input of each force, then the largest losses, and the material with its loss factor.
fn rows(seen: Seen<'_>) -> Vec<Row> {
    let power = &seen.operating.power;
    let mut rows = Vec::new();
    if power.inputs.len() > MOST_FORCES {
        rows.push(Row {
            label: format!("in {} forces", power.inputs.len()),
            power: power.input(),
            loss: false,
        });
    } else {
        rows.extend(power.inputs.iter().map(|input| Row {
            label: label(input.force, seen.model.forces.get(input.force)),
            power: input.power,
            loss: false,
        }));
    }
    let mut losses: Vec<Row> = power
        .dampers
        .iter()
        .map(|damper| (damper.label.clone(), damper.power))
        .chain((power.material != 0.0).then(|| ("material".to_owned(), power.material)))
        .map(|(label, power)| Row {
            label,
            power,
            loss: true,
        })
        .collect();
    losses.sort_by(|a, b| b.power.total_cmp(&a.power));
    rows.extend(losses);
    rows
}

/// "in left w"; with its number if the model no longer has that force.
fn label(index: usize, force: Option<&Force>) -> String {
    match force.map(|force| &force.target) {
        None => format!("in force {}", index + 1),
        Some(Target::Mass(name, motion)) => format!("in {name} {}", motion.key()),
        Some(Target::Beam(Place::Left, motion)) => format!("in left {}", motion.key()),
        Some(Target::Beam(Place::Right, motion)) => format!("in right {}", motion.key()),
        Some(Target::Beam(Place::Position(x), motion)) => format!("in {x} m {}", motion.key()),
    }
}

/// Limits the number of rows: the last one sums up those that do not fit.
fn fitted(mut rows: Vec<Row>, most: usize) -> Vec<Row> {
    if rows.len() > most && most > 0 {
        let rest = rows.split_off(most - 1);
        rows.push(Row {
            label: format!("{} more", rest.len()),
            power: rest.iter().map(|row| row.power).sum(),
            loss: rest.iter().all(|row| row.loss),
        });
    }
    rows
}

impl Row {
    fn line(&self, seen: Seen<'_>, columns: usize, labels: usize) -> Line<'static> {
        let found = &seen.operating.power;
        let all = [found.loss(), found.input()];
        let all = all.into_iter().find(|power| power.is_finite());
        let share = self.power / all.unwrap_or(f64::NAN);
        let percent = if share.is_finite() {
            format!("{:.1}", 100.0 * share)
        } else {
            "-".to_owned()
        };
        let label = cut(&self.label, labels);
        let blank = " ".repeat(labels.saturating_sub(width(&label)));
        let [powers, percents] = NUMBERS;
        let power = watts(self.power);
        let text = format!("{label}{blank}{power:>powers$}{percent:>percents$} ");
        let room = columns.saturating_sub(width(&text)) as f64;
        let cells = if self.loss && share.is_finite() {
            (share.clamp(0.0, 1.0) * room).round() as usize
        } else {
            0
        };
        let [style, bar] = if seen.stale {
            [seen.theme.dim(); 2]
        } else {
            [Style::new(), seen.theme.curve(0)]
        };
        Line::from(vec![
            Span::styled(text, style),
            Span::styled("█".repeat(cells), bar),
        ])
    }
}

/// The power flow in +x.
fn flow(frame: &mut Frame<'_>, seen: Seen<'_>, area: Rect) {
    let x = &seen.operating.positions;
    let curve = Curve {
        label: "flow to the right".to_owned(),
        style: seen.theme.curve(0),
        ..Curve::new(x, &seen.operating.power.flow)
    };
    let ends = [0.0, x.last().copied().unwrap_or(1.0)];
    let across = Axis::new(Scale::Linear, ends, Unit::METRE.symbol);
    let value = Level::Signed.axis(std::slice::from_ref(&curve), &across, "W");
    animated::chart(frame, seen, vec![curve], value, area);
}

#[cfg(test)]
mod tests;
