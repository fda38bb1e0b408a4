//! The first line, what is open and what is solved; and the last, what can be done.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use super::text::{cut, width};
use crate::model::Unit;
use crate::tui::app::{App, Message, Picture, Shown};
use crate::tui::keys::{self, RowKind};
use crate::tui::theme::Theme;
use crate::tui::tree::{self, Node};
use crate::worker::Stage;

pub(super) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let (solver, wrong) = solver(app);
    let solver = cut(&solver, usize::from(area.width / 2));
    let changed = if app.document.is_changed() {
        " · changed"
    } else {
        ""
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

/// What the solver has to say, and whether it is bad news.
fn solver(app: &App) -> (String, bool) {
    match &app.curves.shown {
        Shown::Nothing => ("solving".to_owned(), false),
        Shown::Failed(reason, _) => (format!("not solved: {reason}"), true),
        Shown::Picture(picture) if picture.generation != app.curves.generation => {
            ("solving".to_owned(), false)
        }
        Shown::Picture(picture) if picture.stage == Stage::Coarse => {
            (format!("coarse {}, solving", extent(picture)), false)
        }
        Shown::Picture(picture) => match picture.singular.as_slice() {
            [] => (
                format!("solved {} in {}", extent(picture), elapsed(picture)),
                false,
            ),
            [first] => (
                format!("no finite answer at {}", Unit::HERTZ.format(*first)),
                true,
            ),
            [first, ..] => (
                format!(
                    "no finite answer at {} frequencies, first {}",
                    tree::grouped(picture.singular.len()),
                    Unit::HERTZ.format(*first)
                ),
                true,
            ),
        },
    }
}

/// Points x responses, and x curves of a study.
fn extent(picture: &Picture) -> String {
    let (points, responses, members) = picture.extent();
    let points = tree::grouped(points);
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
        9.95..9999.5 => format!("{} ms", tree::grouped(ms.round() as usize)),
        _ => format!("{:.0} s", ms / 1e3),
    }
}

pub(super) fn draw_hints(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let columns = usize::from(area.width.saturating_sub(1));
    let line = match &app.message {
        Some(Message::Done(text)) => Line::raw(cut(text, columns)),
        Some(Message::Refused(text)) => Line::styled(cut(text, columns), theme.refusal()),
        None => hints(app, theme, columns),
    };
    let mut line = line;
    line.spans.insert(0, Span::raw(" "));
    frame.render_widget(line, area);
}

/// As many hints as there is room for, whole ones.
fn hints(app: &App, theme: Theme, columns: usize) -> Line<'static> {
    let mut spans = Vec::new();
    let mut taken = 0;
    for (key, words) in keys::hints(app.scope(), row_kind(app)) {
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

/// What kind of row is selected.
fn row_kind(app: &App) -> RowKind {
    match app.selection.node() {
        Node::Support(_)
        | Node::Motion(..)
        | Node::ForceDirection(_)
        | Node::ResponseDirection(_)
        | Node::ResponseMeasure(_)
        | Node::ForceAt(_)
        | Node::ResponseAt(_)
        | Node::SweepSpacing => RowKind::Choice,
        Node::Title => RowKind::Text,
        Node::Subsystems | Node::Forces | Node::Responses => RowKind::List,
        Node::Subsystem(_) | Node::Force(_) | Node::Response(_) => RowKind::Item,
        node if tree::parameter_path(app.model(), node).is_some() => RowKind::Number,
        _ => RowKind::Group,
    }
}
