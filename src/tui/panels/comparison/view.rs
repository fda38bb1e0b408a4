//! The dialog with the list of references and measured curves.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout};
use ratatui::text::{Line, Span};

use crate::model::counted;
use crate::tui::app::{App, List, MOTION, Measured, Reference, Rows};
use crate::tui::keys::{RowKind, Scope};
use crate::tui::panels::band::view::fit_words;
use crate::tui::theme::Theme;
use crate::tui::view::dialog_box::{middle, open_dialog};
use crate::tui::view::text::{cut, width};
use crate::unit::Kind;

/// An entry: whether it is visible, its name, and its kind.
type Entry = (bool, String, String);

/// Draws the list; returns its number of entries and of visible rows, and its area.
pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, mut list: List, theme: Theme) -> (List, Rows) {
    let entries = entries(app);
    let place = middle(frame.area(), entries.len().max(3) + 1);
    let inside = open_dialog(frame, place, " References and measured curves ", theme);
    let [above, below] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(1)]).areas(inside);
    list.set_rows(entries.len());
    list.height = usize::from(above.height).max(1);
    let columns = usize::from(above.width);
    if entries.is_empty() {
        let text = "no reference and no measured curve yet";
        frame.render_widget(Line::styled(text, theme.dim()), above);
    }
    let first = (list.row + 1).saturating_sub(list.height);
    let names = entries.iter().map(|(_, name, _)| width(name)).max();
    let names = names.unwrap_or(0).min(columns / 2);
    for (line, (index, (shown, name, what))) in
        above.rows().zip(entries.iter().enumerate().skip(first))
    {
        let mark = if *shown { "x" } else { " " };
        let name = cut(name, names);
        let blank = " ".repeat(names.saturating_sub(width(&name)));
        let what = cut(what, columns.saturating_sub(names + 6));
        let text = Line::from(vec![
            Span::raw(format!("[{mark}] ")),
            Span::styled(name, theme.key()),
            Span::raw(format!("{blank}  {what}")),
        ]);
        frame.render_widget(text, line);
        if index == list.row {
            frame.buffer_mut().set_style(line, theme.selection());
        }
    }
    let answers = app.keys.hints(Scope::Comparison, RowKind::Group);
    frame.render_widget(hints(answers, theme, columns), below);
    (list, Rows { area: above, first })
}

fn hints(answers: Vec<(String, &'static str)>, theme: Theme, columns: usize) -> Line<'static> {
    let mut spans = Vec::new();
    let mut taken = 0;
    for (key, words) in answers {
        let needed = width(&key) + 1 + width(words) + 2;
        if taken + needed > columns + 2 {
            break;
        }
        taken += needed;
        spans.push(Span::styled(key, theme.key()));
        spans.push(Span::styled(format!(" {words}  "), theme.dim()));
    }
    Line::from(spans)
}

fn entries(app: &App) -> Vec<Entry> {
    let references = app.comparison.references.iter().map(reference);
    let measured = app.comparison.measured.iter();
    references
        .chain(measured.map(|one| measurement(app, one)))
        .collect()
}

fn reference(one: &Reference) -> Entry {
    let what = match (&one.failure, &one.picture) {
        (Some(reason), _) => format!("not solved: {reason}"),
        (None, None) => "reference, solving".to_owned(),
        (None, Some(_)) => {
            let study = one.study.and_then(|study| one.model.studies.get(study));
            match study {
                Some(study) => format!("reference, {}", study.name),
                None => format!("reference, {}", one.model.title),
            }
        }
    };
    (one.shown, one.name.clone(), what)
}

fn measurement(app: &App, one: &Measured) -> Entry {
    let points = one.curve.frequencies.len();
    let mut fits = app.comparison.fits.iter();
    let fit = fits.find(|fitted| fitted.measured == one.id);
    let stands = app.measured_shown().any(|(other, _)| other.id == one.id);
    let what = match fit {
        Some(fitted) => format!("{}: {}", fitted.response, fit_words(&fitted.fit)),
        None if one.shown && !stands => {
            let unit = one.curve.kind.map(Kind::unit).unwrap_or_default();
            let units = app.display.shown_units(&app.curves).join(", ");
            let is_motion = one.dimension().is_some_and(|own| own.per.is_none());
            let hint = if is_motion && !app.display.motion {
                format!("; the form `{MOTION}` may fit")
            } else {
                String::new()
            };
            format!("measured in {unit}: does not match the visible curves, in {units}{hint}")
        }
        None => format!("measured, {}", counted(points, "point", "points")),
    };
    (one.shown, one.name.clone(), what)
}
