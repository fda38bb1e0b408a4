//! The details of the selected row: symbol, unit, meaning, range, and its value before and after.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;

use crate::model::edit::Value;
use crate::model::{Parameter, path};
use crate::solve;
use crate::tui::app::App;
use crate::tui::panels::tree::summary;
use crate::tui::theme::Theme;
use crate::tui::tree::{self, Node};
use crate::tui::view::frame;
use crate::tui::view::text::{cut, width, wrapped};

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    if area.height < 2 {
        return;
    }
    let node = app.selection.node();
    let inside = frame::block_inside(area);
    let title = cut(
        &tree::subject(app.model(), node),
        usize::from(area.width.saturating_sub(5)),
    );
    let block = frame::block(&title, theme);
    frame.render_widget(block, area);
    let columns = usize::from(inside.width.saturating_sub(2));
    let lines: Vec<Line<'_>> = lines(app, theme, node, columns)
        .into_iter()
        .map(indented)
        .collect();
    frame.render_widget(Paragraph::new(lines), inside);
}

fn indented(mut line: Line<'static>) -> Line<'static> {
    line.spans.insert(0, Span::raw(" "));
    line
}

fn lines(app: &App, theme: Theme, node: Node, columns: usize) -> Vec<Line<'static>> {
    let model = app.model();
    let Some(id) = node.parameter() else {
        return plain(&summary::of(model, node, &app.keys), columns);
    };
    let parameter = match path::described(model, id) {
        Ok(parameter) => parameter,
        Err(fault) => return plain(&format!("{} {}", fault.path, fault.message), columns),
    };
    let mut lines = Vec::new();
    match &parameter.value {
        Value::Text(text) if width(text) > columns => lines.extend(plain(text, columns)),
        _ => lines.push(value_line(app, theme, &parameter, columns)),
    }
    lines.extend(meaning(theme, &parameter, columns));
    lines.extend(dimmed(&allowed(&parameter), columns, theme));
    for note in solve::notes(model).iter().filter(|note| note.id == id) {
        lines.extend(plain(&note.message, columns));
    }
    lines
}

/// The symbol and its meaning.
fn meaning(theme: Theme, parameter: &Parameter, columns: usize) -> Vec<Line<'static>> {
    let indent = if parameter.symbol.is_empty() {
        0
    } else {
        width(parameter.symbol) + 2
    };
    let lines = wrapped(parameter.meaning, columns.saturating_sub(indent))
        .into_iter()
        .enumerate();
    lines
        .map(|(number, text)| {
            let symbol = if number == 0 { parameter.symbol } else { "" };
            Line::from(vec![
                Span::styled(format!("{symbol:indent$}"), theme.key()),
                Span::raw(text),
            ])
        })
        .collect()
}

fn plain(text: &str, columns: usize) -> Vec<Line<'static>> {
    text.lines()
        .flat_map(|line| wrapped(line, columns))
        .map(Line::from)
        .collect()
}

fn dimmed(text: &str, columns: usize, theme: Theme) -> Vec<Line<'static>> {
    wrapped(text, columns)
        .into_iter()
        .map(|line| Line::styled(line, theme.dim()))
        .collect()
}

/// The unit and the allowed range.
fn allowed(parameter: &Parameter) -> String {
    if !parameter.choices.is_empty() {
        return parameter.choices.join(", ");
    }
    match (&parameter.value, parameter.unit.symbol) {
        (Value::Number(_), "") => format!("no unit, {}", parameter.range),
        (Value::Number(_), unit) => format!("{unit}, {}", parameter.range),
        _ => parameter.range.clone(),
    }
}

/// The value; if it differs from the file's, also the old value and the difference.
fn value_line(app: &App, theme: Theme, parameter: &Parameter, columns: usize) -> Line<'static> {
    let now = tree::of_parameter(parameter, &parameter.value);
    let before = app.saved_value(parameter.id);
    let Some(before) = before.filter(|before| *before != parameter.value) else {
        return Line::styled(cut(&now, columns), theme.key());
    };
    let percent = match (&before, &parameter.value) {
        (Value::Number(before), Value::Number(now)) if *before != 0.0 => {
            format!("  ({})", percent(now / before - 1.0))
        }
        _ => String::new(),
    };
    let before = tree::of_parameter(parameter, &before);
    let before = tree::without_unit_of(&before, &now);
    Line::styled(
        cut(&format!("{before} -> {now}{percent}"), columns),
        theme.changed(),
    )
}

/// A relative difference in percent, with as many digits as are useful.
fn percent(difference: f64) -> String {
    let percent = difference * 100.0;
    match percent.abs() {
        99.0..100.0 if percent < 0.0 => format!("x {:.1e}", difference + 1.0),
        0.0..0.95 => format!("{percent:+.2} %"),
        0.95..99.5 => format!("{percent:+.1} %"),
        99.5..9999.5 => format!("{percent:+.0} %"),
        _ => format!("x {:.3e}", difference + 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentages_are_as_fine_as_they_matter() {
        assert_eq!(percent(0.041), "+4.1 %");
        assert_eq!(percent(-0.001), "-0.10 %");
        assert_eq!(percent(1.4), "+140 %");
        assert_eq!(percent(1e6), "x 1.000e6");
    }
}
