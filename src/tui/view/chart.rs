//! The chart of the responses that show.

use ratatui::Frame;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Modifier;
use ratatui::text::Line;
use ratatui::widgets::{Block, Borders, Paragraph, Wrap};

use crate::model::Unit;
use crate::tui::app::{Anchor, App, Curves, Member, Picture, Plot, Shaping, Shown, Table, Trace};
use crate::tui::keys::Command;
use crate::tui::plot::{Axis, Chart, Curve, Level, LineStyle, Marks, Scale};
use crate::tui::theme::Theme;

/// Columns from one point of a finite-element curve to the next.
const POINTS: u16 = 3;

/// Draws the chart; where its curves are, if there are any.
pub(super) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) -> Option<Plot> {
    let block = Block::new()
        .borders(Borders::TOP)
        .border_style(theme.dim())
        .title(super::rule(&heading(app), theme))
        .title(
            Line::styled(readout(app), theme.key().remove_modifier(Modifier::DIM)).right_aligned(),
        );
    let inside = block.inner(area);
    frame.render_widget(block, area);
    let curves = curves(app, theme);
    if curves.is_empty() {
        let text = Paragraph::new(why_empty(app)).wrap(Wrap { trim: false });
        frame.render_widget(
            text.style(theme.dim()),
            inside.centered_vertically(Constraint::Length(2)),
        );
        return None;
    }
    let x = frequency_axis(app);
    let (level, unit) = level(app);
    let y = level.axis(&spanning(app, &curves), &x, unit);
    let mut chart = Chart::new(x, y, level, &curves);
    chart.cursor = app.curves.cursor;
    chart.marks = marks(app);
    chart.styles = theme.chart();
    chart.glyphs = theme.glyphs();
    let modes = app.modal.list.as_ref();
    if modes.is_some_and(|list| list.generation != app.curves.generation) {
        chart.styles.mark = theme.dim();
    }
    frame.render_widget(&chart, inside);
    let area = chart.plot_area(inside);
    let frequencies = (0..area.width).map(|cell| chart.value_in(area, cell));
    Some(Plot {
        area,
        frequencies: frequencies.collect(),
    })
}

/// The axis of the frequencies that show.
fn frequency_axis(app: &App) -> Axis {
    let scale = if app.curves.log_frequency {
        Scale::Log
    } else {
        Scale::Linear
    };
    Axis::new(scale, app.shown_frequencies(), "Hz")
}

/// The modes, ticked beneath the axis.
fn marks(app: &App) -> Marks {
    let Some(list) = &app.modal.list else {
        return Marks::default();
    };
    let chosen = app.anchor == Anchor::Mode
        || app.tables.open == Some(Table::Modes)
        || app.modal.shaping != Shaping::Hidden;
    Marks {
        name: "modes",
        values: list.rows.iter().map(|mode| mode.frequency).collect(),
        selected: chosen.then_some(app.tables.modes.row),
    }
}

/// What the value axis spans: the curves, and what they will be once they are resolved, which is about what the
/// resolved ones before are; so that it stands still while a parameter is turned.
fn spanning<'a>(app: &'a App, drawn: &[Curve<'a>]) -> Vec<Curve<'a>> {
    let mut curves = drawn.to_vec();
    let is_resolved = app.curves.is_resolved();
    if let (false, Some(resolved)) = (is_resolved, &app.curves.resolved) {
        let resolved = traces(resolved, &app.curves).into_iter();
        curves.extend(resolved.map(|(.., member, trace)| curve(member, trace)));
    }
    curves
}

/// A curve with its poles.
fn curve<'a>(member: &'a Member, trace: &'a Trace) -> Curve<'a> {
    let poles = trace.peaks.iter().filter(|peak| peak.pole);
    Curve {
        poles: poles.map(|peak| peak.frequency).collect(),
        ..Curve::new(&member.frequencies, &trace.magnitudes)
    }
}

/// The frequency nearest to the cursor, and the first curve's value there.
fn readout(app: &App) -> String {
    let Some((cursor, (member, trace))) = app.curves.cursor.zip(app.curves.first_trace()) else {
        return String::new();
    };
    let after = member
        .frequencies
        .partition_point(|frequency| *frequency < cursor);
    let around = [after.saturating_sub(1), after]
        .into_iter()
        .filter(|i| *i < member.frequencies.len());
    let distance = |i: &usize| (member.frequencies[*i] - cursor).abs();
    let Some(i) = around.min_by(|a, b| distance(a).total_cmp(&distance(b))) else {
        return String::new();
    };
    let (level, unit) = level(app);
    let value = match level {
        _ if trace.magnitudes[i] == 0.0 => "zero".to_owned(),
        Level::Magnitude => format!("{:.3e} {}", trace.magnitudes[i], trace.unit),
        Level::Decibel { .. } => format!("{:.1} {unit}", level.value(trace.magnitudes[i])),
    };
    let of = match &member.label {
        None if app.curves.visible.len() == 1 => String::new(),
        _ => format!("{}: ", label(&app.curves, trace, member)),
    };
    format!(
        " {of}{}  {value} ",
        Unit::HERTZ.format(member.frequencies[i])
    )
}

/// Which place a response that shows has among those that show.
pub(super) fn place(app: &App, response: &str) -> Option<usize> {
    app.curves.visible.iter().position(|name| name == response)
}

fn heading(app: &App) -> String {
    let what = match app.curves.visible.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        more => format!("{} responses", more.len()),
    };
    match app
        .curves
        .study
        .and_then(|study| app.model().studies.get(study))
    {
        Some(study) => format!("{what}: {}", study.name),
        None => what,
    }
}

fn why_empty(app: &App) -> String {
    match &app.curves.shown {
        _ if app
            .model()
            .responses
            .iter()
            .all(|response| !response.enabled) =>
        {
            format!(
                " no response is asked for: {} on Responses adds one",
                app.keys.key_of(Command::Add)
            )
        }
        _ if app.curves.visible.is_empty() => format!(
            " no response shows: select one, then {}",
            app.keys.key_of(Command::Show)
        ),
        Shown::Failed(reason, _) => format!(" no curves: {reason}"),
        Shown::Nothing => " solving".to_owned(),
        Shown::Picture(_) => " the responses that show have no curves yet".to_owned(),
    }
}

/// The traces that show, of one picture, with their place and their member's.
fn traces<'a>(
    picture: &'a Picture,
    curves: &'a Curves,
) -> Vec<(usize, usize, &'a Member, &'a Trace)> {
    let mut found = Vec::new();
    for (place, name) in curves.visible.iter().enumerate() {
        for (number, member) in picture.members.iter().enumerate() {
            let trace = member.traces.iter().find(|trace| trace.response == *name);
            found.extend(trace.map(|trace| (place, number, member, trace)));
        }
    }
    found
}

fn curves(app: &App, theme: Theme) -> Vec<Curve<'_>> {
    let state = &app.curves;
    let mut curves = Vec::new();
    if let Some(reference) = &state.reference {
        for (place, number, member, trace) in traces(reference, state) {
            let mut curve = curve(member, trace);
            curve.style = theme.curve(colour(state, place, number));
            curve.line = LineStyle::Dotted;
            curve.dim = true;
            if curves.is_empty() {
                "before".clone_into(&mut curve.label);
            }
            curves.push(curve);
        }
    }
    let Some(picture) = state.picture() else {
        return curves;
    };
    let shown = traces(picture, state);
    let several = shown.len() > 1;
    for (index, (place, number, member, trace)) in shown.into_iter().enumerate() {
        let mut curve = curve(member, trace);
        curve.label = label(state, trace, member);
        curve.style = theme.curve(colour(state, place, number));
        curve.marker = several.then(|| theme.marker(index));
        curve.dim = state.is_stale();
        curves.push(curve);
    }
    // One curve alone is named in the heading.
    if let [only] = curves.as_mut_slice() {
        only.label.clear();
    }
    curves.extend(witnesses(app, theme));
    curves
}

/// The finite-element curves of the responses that show, as points.
fn witnesses(app: &App, theme: Theme) -> Vec<Curve<'_>> {
    let state = &app.curves;
    let Some(picture) = app.witness.picture() else {
        return Vec::new();
    };
    let mut curves: Vec<Curve<'_>> = Vec::new();
    for (place, name) in state.visible.iter().enumerate() {
        for (number, member) in picture.members.iter().enumerate() {
            let traces = member.traces.iter();
            for trace in traces.filter(|trace| trace.response == *name) {
                let mut curve = Curve::new(&member.frequencies, &trace.magnitudes);
                curve.style = theme.witness(colour(state, place, number));
                curve.marker = Some(theme.point());
                curve.line = LineStyle::Points { apart: POINTS };
                curve.dim = picture.generation != state.generation;
                if curves.is_empty() {
                    "FEM".clone_into(&mut curve.label);
                }
                curves.push(curve);
            }
        }
    }
    curves
}

/// Responses have a colour each; where only one shows, the members of the study have.
fn colour(state: &Curves, place: usize, member: usize) -> usize {
    if state.visible.len() > 1 {
        place
    } else {
        member
    }
}

fn label(state: &Curves, trace: &Trace, member: &Member) -> String {
    let name = match &member.label {
        None => trace.response.clone(),
        Some(label) if state.visible.len() == 1 => label.clone(),
        Some(label) => format!("{} {label}", trace.response),
    };
    // A logarithmic axis has no place for it.
    if trace.magnitudes.iter().all(|magnitude| *magnitude == 0.0) {
        format!("{name} (zero)")
    } else {
        name
    }
}

/// What the value axis shows, and its unit.
pub(super) fn level(app: &App) -> (Level, String) {
    let state = &app.curves;
    let mut units: Vec<&str> = Vec::new();
    let (mut energy, mut motion) = (false, false);
    let pictures = state.picture().into_iter().chain(&state.reference);
    for (.., trace) in pictures.flat_map(|picture| traces(picture, state)) {
        energy |= trace.energy;
        motion |= !trace.energy;
        if !units.contains(&trace.unit) {
            units.push(trace.unit);
        }
    }
    let unit = units.join(", ");
    // Ten and twenty decibels a decade do not go on one axis.
    if !state.decibels || (energy && motion) {
        return (Level::Magnitude, unit);
    }
    let factor = if energy { 10.0 } else { 20.0 };
    (
        Level::Decibel {
            factor,
            reference: 1.0,
        },
        format!("dB re 1 {unit}"),
    )
}
