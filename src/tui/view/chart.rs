//! The chart of the responses that show.

use ratatui::Frame;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Modifier;
use ratatui::text::Line;
use ratatui::widgets::{Block, Borders, Paragraph, Wrap};

use crate::model::Unit;
use crate::tui::app::{App, Curves, Member, Picture, Shown, Trace};
use crate::tui::plot::{Axis, Chart, Curve, Level, LineStyle, Scale};
use crate::tui::theme::Theme;

pub(super) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
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
        return;
    }
    let sweep = &app.model().sweep;
    let scale = if app.curves.log_frequency {
        Scale::Log
    } else {
        Scale::Linear
    };
    let x = Axis::new(scale, [sweep.from, sweep.to], "Hz");
    let (level, unit) = level(app);
    let y = level.axis(&curves, &x, unit);
    let mut chart = Chart::new(x, y, level, &curves);
    chart.cursor = app.curves.cursor;
    chart.styles = theme.chart();
    frame.render_widget(&chart, inside);
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
            " no response is asked for: a on Responses adds one".to_owned()
        }
        _ if app.curves.visible.is_empty() => " no response shows: select one, then v".to_owned(),
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
            let mut curve = Curve::new(&member.frequencies, &trace.magnitudes);
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
        let mut curve = Curve::new(&member.frequencies, &trace.magnitudes);
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
fn level(app: &App) -> (Level, String) {
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
