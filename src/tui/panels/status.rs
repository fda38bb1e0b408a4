//! The first line: the open model and the solution; and the last one: what can be done.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::text::{Line, Span};

use crate::model::schema::Kind;
use crate::model::{Group, counted, grouped};
use crate::solve::modes::Completeness;
use crate::tui::app::{
    App, ExternalChange, FemOverlay, FemPicture, Message, Picture, Progress, Search, Shown, Stage,
};
use crate::tui::keys::{ReadingCommand, RowKind, Scope, SearchCommand, TuneCommand};
use crate::tui::panels::prompt::view::draw_input;
use crate::tui::theme::Theme;
use crate::tui::tree::Node;
use crate::tui::view::text::{cut, significant, width};

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let half = usize::from(area.width / 2);
    let (said, wrong) = solver(app);
    // The first text that fits.
    let fits = said.iter().find(|text| width(text) <= half);
    let solver = cut(fits.or(said.last()).map_or("", String::as_str), half);
    let changed = match (app.document.is_changed(), app.files.external_change) {
        (false, ExternalChange::Same) => "",
        (true, ExternalChange::Same) => " · changed",
        (false, ExternalChange::Changed) => " · changed on disk",
        (true, ExternalChange::Changed) => " · changed, also on disk",
        (_, ExternalChange::Gone) => " · missing on disk",
    };
    let room = usize::from(area.width).saturating_sub(width(&solver) + width(changed) + 3);
    let name = cut(&app.document.source().name(), room);
    let title = cut(&app.model().title, room.saturating_sub(width(&name) + 2));
    let left = Line::from(vec![
        Span::raw(" "),
        Span::styled(name, theme.accent()),
        Span::raw("  "),
        Span::raw(title),
        Span::styled(changed, theme.changed()),
    ]);
    let style = if wrong { theme.refusal() } else { theme.dim() };
    frame.render_widget(left, area);
    let right = Line::from(vec![Span::styled(solver, style), Span::raw(" ")]).right_aligned();
    frame.render_widget(right, area);
}

/// The message of the solver, from long to short, and whether it is a warning.
fn solver(app: &App) -> (Vec<String>, bool) {
    let solving = || (vec!["solving".to_owned()], false);
    match &app.curves.shown {
        Shown::Nothing => solving(),
        Shown::Failed(reason, _) => (vec![format!("not solved: {reason}")], true),
        Shown::Picture(picture) if picture.generation != app.curves.generation => solving(),
        Shown::Picture(picture) if picture.stage == Stage::Coarse => {
            (vec![format!("coarse {}, solving", extent(picture))], false)
        }
        Shown::Picture(picture) => match (picture.singular.as_slice(), &app.fem_overlay) {
            (_, FemOverlay::Failed(reason)) => {
                (vec![format!("no finite elements: {reason}")], true)
            }
            (_, FemOverlay::Waiting(_)) => (vec!["computing finite elements".to_owned()], false),
            (_, FemOverlay::Shown(witness)) => (difference(app, witness), false),
            ([], FemOverlay::Off) => (solved(app, picture), false),
            ([first], _) => (
                vec![format!(
                    "no finite answer at {}",
                    app.display.frequency_text(*first)
                )],
                true,
            ),
            ([first, ..], _) => (
                vec![format!(
                    "no finite answer at {} frequencies, first {}",
                    grouped(picture.singular.len()),
                    app.display.frequency_text(*first)
                )],
                true,
            ),
        },
    }
}

/// The size of the solution and its time; and the modes, above all whether one was lost or gained.
fn solved(app: &App, picture: &Picture) -> Vec<String> {
    let solved = format!("solved {} in {}", extent(picture), elapsed(picture));
    let list = app.modes.list.as_ref();
    let Some(list) = list.filter(|_| picture.stage >= Stage::Resolved) else {
        let short = format!("{} in {}", extent(picture), elapsed(picture));
        return [solved, short]
            .into_iter()
            .map(|text| format!("{text}, computing modes"))
            .chain(["computing modes".to_owned()])
            .collect();
    };
    let modes = counted(list.rows.len(), "mode", "modes");
    let modes = match &list.completeness {
        Completeness::Certain => modes,
        Completeness::Uncounted => format!("{modes} not counted yet"),
        Completeness::Open(gaps) => {
            let open = counted(gaps.len(), "range", "ranges");
            format!("{modes}, {open} open")
        }
        Completeness::TooMany => {
            let modes = "too many modes".to_owned();
            return vec![format!("{modes}, {solved}"), modes];
        }
    };
    // If there is room for one thing only, a doubt comes before the time.
    let short = match &list.completeness {
        Completeness::Certain => solved.clone(),
        _ => modes.clone(),
    };
    let change = match list.change {
        None | Some(0) => return vec![format!("{modes}, {solved}"), short],
        Some(1) => "one more".to_owned(),
        Some(-1) => "one fewer".to_owned(),
        Some(change @ 2..) => format!("{change} more"),
        Some(change) => format!("{} fewer", change.unsigned_abs()),
    };
    vec![
        format!("{modes}, {change} than before, {solved}"),
        format!("{modes}, {change} than before"),
        format!("{modes}, {change}"),
    ]
}

/// The largest difference between the visible finite-element curves and the exact ones.
fn difference(app: &App, witness: &FemPicture) -> Vec<String> {
    let largest = witness
        .members
        .iter()
        .flat_map(|member| member.traces.iter().zip(&member.differences))
        .filter(|(trace, _)| app.curves.shows(&trace.response))
        .filter_map(|(_, difference)| *difference)
        .max_by(|a, b| a.decibels.total_cmp(&b.decibels));
    let Some(largest) = largest else {
        return vec!["finite elements: nothing to compare".to_owned()];
    };
    let decibels = significant(largest.decibels, 3);
    let at = app.display.frequency_text(largest.frequency);
    let elements = witness
        .members
        .iter()
        .map(|member| member.elements)
        .max()
        .unwrap_or(0);
    vec![
        format!("{elements} finite elements: at most {decibels} dB off, at {at}"),
        format!("FEM at most {decibels} dB off, at {at}"),
        format!("FEM: {decibels} dB at {at}"),
    ]
}

/// Points x responses, and x curves of a study.
fn extent(picture: &Picture) -> String {
    let (points, responses, members) = picture.extent();
    let points = grouped(points);
    if members > 1 {
        format!("{points} x {responses} x {members}")
    } else {
        format!("{points} x {responses}")
    }
}

fn elapsed(picture: &Picture) -> String {
    let ms = picture.elapsed.as_secs_f64() * 1e3;
    match ms {
        0.0..9.95 => format!("{ms:.1} ms"),
        9.95..9999.5 => format!("{} ms", grouped(ms.round() as usize)),
        _ => format!("{:.0} s", ms / 1e3),
    }
}

pub(crate) fn draw_hints(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let columns = usize::from(area.width.saturating_sub(1));
    if let Some(search) = app.search.as_ref().filter(|search| search.typing) {
        return draw_search(frame, app, search, theme, area);
    }
    let line = match &app.message {
        _ if app.repeat.count.is_some() => count_line(app, theme, columns),
        Some(Message::Done(text)) => Line::raw(cut(text, columns)),
        Some(Message::Refused(text)) => Line::styled(cut(text, columns), theme.refusal()),
        None => hints(app, theme, columns),
    };
    let mut line = line;
    line.spans.insert(0, Span::raw(" "));
    frame.render_widget(line, area);
}

/// The typed count, and its purpose.
fn count_line(app: &App, theme: Theme, columns: usize) -> Line<'static> {
    let count = app.repeat.count.unwrap_or(1).to_string();
    let escape = app.keys.key_of(ReadingCommand::CursorOff);
    let words = format!(" times the next key; {escape} cancels the count");
    let words = cut(&words, columns.saturating_sub(width(&count)));
    Line::from(vec![
        Span::styled(count, theme.key()),
        Span::styled(words, theme.dim()),
    ])
}

/// The line of the search, and the number of matches.
fn draw_search(frame: &mut Frame<'_>, app: &App, search: &Search, theme: Theme, area: Rect) {
    let place = search.place(app.selection.node());
    let found = match (search.input.value().trim(), place) {
        ("", _) => format!(
            "parts of a name; {} stays there, {} goes back",
            app.keys.key_of(SearchCommand::Accept),
            app.keys.key_of(SearchCommand::Cancel)
        ),
        (_, None) if search.found.is_empty() => "none found".to_owned(),
        (_, place) => format!(
            "{} of {}",
            place.map_or_else(|| "-".to_owned(), |place| place.to_string()),
            grouped(search.found.len())
        ),
    };
    let found = format!(" {found} ");
    let [mark, typed, found_area] = Layout::horizontal([
        Constraint::Length(2),
        Constraint::Fill(1),
        Constraint::Length(width(&found) as u16),
    ])
    .areas(area);
    frame.render_widget(Line::styled(" /", theme.key()), mark);
    draw_input(frame, &search.input, typed);
    frame.render_widget(Line::styled(found, theme.dim()), found_area);
}

/// The hints that fit, none of them cut.
fn hints(app: &App, theme: Theme, columns: usize) -> Line<'static> {
    let mut spans = Vec::new();
    let mut taken = 0;
    let usual = app.keys.hints(app.scope(), row_kind(app));
    for (key, words) in search_hints(app).into_iter().chain(usual) {
        let needed = width(&key) + 1 + width(words);
        if taken + needed > columns {
            break;
        }
        taken += needed + 2;
        spans.extend([
            Span::styled(key, theme.key()),
            Span::styled(format!(" {words}  "), theme.dim()),
        ]);
    }
    Line::from(spans)
}

/// What the tuning waits for.
fn search_hints(app: &App) -> Vec<(String, &'static str)> {
    let at_the_model = matches!(app.scope(), Scope::Main | Scope::Table);
    let Some(run) = app.tuning.run.as_ref().filter(|_| at_the_model) else {
        return Vec::new();
    };
    let hold = match run.progress {
        Progress::Searching => Some("pause"),
        Progress::Paused => Some("continue"),
        Progress::Found(_) | Progress::Failed(_) => None,
    };
    let hold = hold.map(|words| (TuneCommand::Tune, words));
    let hints = [
        (TuneCommand::TuneAccept, "apply the best"),
        (TuneCommand::TuneDiscard, "discard it"),
    ];
    let hints = hold.into_iter().chain(hints);
    hints
        .map(|(command, words)| (app.keys.key_of(command), words))
        .collect()
}

/// The kind of the selected row.
fn row_kind(app: &App) -> RowKind {
    let node = app.selection.node();
    match (node.parameter().map(|id| id.key().kind), node) {
        (Some(Kind::Number | Kind::Count), _) => RowKind::Number,
        (Some(Kind::Line | Kind::Text | Kind::Name), _) => RowKind::Text,
        (Some(_), _) => RowKind::Choice,
        (None, Node::Group(Group::Subsystems | Group::Forces | Group::Responses)) => RowKind::List,
        (None, Node::Group(Group::Subsystem(_) | Group::Force(_) | Group::Response(_))) => {
            RowKind::Item
        }
        _ => RowKind::Group,
    }
}
