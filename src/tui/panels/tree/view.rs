//! The tree's rows. Only visible ones are made into text.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

use crate::model::Group;
use crate::tui::app::{App, Search};
use crate::tui::theme::Theme;
use crate::tui::tree::{self, Node, Row};
use crate::tui::view::frame;
use crate::tui::view::text::{cut, width};

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    let rows = app.selection.rows();
    let inside = frame::block_inside(area);
    let offset = app.selection.first_shown(inside.height.into());
    let below = rows
        .len()
        .saturating_sub(offset + usize::from(inside.height));
    let mut block = frame::block("Model", theme);
    if offset > 0 || below > 0 {
        let place = format!(" {} of {} ", app.selection.cursor() + 1, rows.len());
        block = block.title(Line::styled(place, theme.dim()).right_aligned());
    }
    frame.render_widget(block, area);
    for (line, row) in inside.rows().zip(rows.iter().enumerate().skip(offset)) {
        let (number, row) = row;
        frame.render_widget(row_line(app, theme, *row, line.width), line);
        if number == app.selection.cursor() {
            let style = match app.tables.open {
                None => theme.selection(),
                Some(_) => theme.selection_aside(),
            };
            frame.buffer_mut().set_style(line, style);
        }
    }
}

fn row_line(app: &App, theme: Theme, row: Row, columns: u16) -> Line<'static> {
    let model = app.model();
    let columns = usize::from(columns);
    let changed = tree::differs(model, app.document.saved(), row.node);
    let mark = if changed { "•" } else { " " };
    let arrow = match row.open {
        Some(true) => "▾ ",
        Some(false) => "▸ ",
        None if app.tuning.moving.has(row.node) => "↕ ",
        None => "  ",
    };
    let indent = " ".repeat(usize::from(row.depth));
    let swatch = swatch(app, theme, row.node);
    let label = tree::label(model, row.node);
    let effect = crate::tui::panels::sensitivity::view::in_tree(app, theme, row.node);
    let value = effect.unwrap_or_else(|| tree::value(model, row.node));
    let before = 3 + indent.len() + usize::from(swatch.is_some()) * 2;
    let room = columns.saturating_sub(before + 1);
    // The value is more important; the label gives way, but keeps a few letters.
    let value = cut(&value, room.saturating_sub(width(&label).min(8) + 1));
    let label = cut(
        &label,
        room.saturating_sub(width(&value) + usize::from(!value.is_empty())),
    );
    let gap = " ".repeat(room.saturating_sub(width(&label) + width(&value)));
    let style = row_style(app, theme, row);
    let found = |search: &Search| search.found.contains(&row.node);
    let name_style = match &app.search {
        Some(search) if found(search) => style.patch(theme.found()),
        _ => style,
    };
    let mut spans = vec![
        Span::styled(mark, theme.changed()),
        Span::raw(indent),
        Span::styled(arrow, theme.dim()),
    ];
    spans.extend(swatch);
    spans.extend([
        Span::styled(label, name_style),
        Span::raw(gap),
        Span::styled(value, style),
        Span::raw(" "),
    ]);
    Line::from(spans)
}

/// The marker of a visible response, in the colour of its curve.
fn swatch(app: &App, theme: Theme, node: Node) -> Option<Span<'static>> {
    let Node::Group(Group::Response(i)) = node else {
        return None;
    };
    let response = &app.model().responses[i];
    Some(
        match crate::tui::panels::chart::view::place(app, &response.name)
            .filter(|_| response.enabled)
        {
            Some(place) if app.curves.visible.len() > 1 => {
                Span::styled(format!("{} ", theme.marker(place)), theme.curve(place))
            }
            Some(_) => Span::styled("─ ", theme.curve(0)),
            None => Span::raw("  "),
        },
    )
}

fn row_style(app: &App, theme: Theme, row: Row) -> Style {
    let model = app.model();
    let off = match row.node.item() {
        Some(Group::Subsystem(i)) => !model.subsystems[i].enabled,
        Some(Group::Force(i)) => !model.forces[i].enabled,
        Some(Group::Response(i)) => !model.responses[i].enabled,
        Some(Group::Study(i)) => app.curves.study != Some(i),
        _ => matches!(
            row.node,
            Node::Group(Group::Variable(_) | Group::Objective(_) | Group::Limit(_))
        ),
    };
    if off {
        theme.dim()
    } else if row.depth == 0 {
        theme.key()
    } else {
        Style::new()
    }
}
