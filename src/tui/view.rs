//! What is on the screen. The views read the state and know nothing of the solver beyond its curves.

mod boxes;
mod chart;
mod details;
mod help;
mod status;
mod summary;
mod text;
mod tree;

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Modifier;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Borders, Paragraph, Wrap};

use super::app::App;
use super::theme::Theme;

/// The smallest screen that is drawn, columns and rows.
pub const SMALLEST: (u16, u16) = (60, 18);
/// From this width on the chart stands beside the tree.
const BESIDE: u16 = 76;
/// From this height on the details stand below the tree.
const DETAILED: u16 = 20;
/// Rows of the details below the tree, their rule included.
const DETAILS: u16 = 6;

/// Where the panels are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Panels {
    pub(crate) status: Rect,
    pub(crate) tree: Rect,
    pub(crate) details: Rect,
    pub(crate) chart: Rect,
    pub(crate) hints: Rect,
}

/// The panels of a screen, if it is large enough.
pub(crate) fn panels(area: Rect) -> Option<Panels> {
    if area.width < SMALLEST.0 || area.height < SMALLEST.1 {
        return None;
    }
    let [status, middle, hints] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Fill(1),
        Constraint::Length(1),
    ])
    .areas(area);
    let (tree, details, chart) = if area.width >= BESIDE {
        beside(middle)
    } else {
        stacked(middle)
    };
    Some(Panels {
        status,
        tree,
        details,
        chart,
        hints,
    })
}

/// Tree and details at the left, the chart at the right.
fn beside(area: Rect) -> (Rect, Rect, Rect) {
    let width = (area.width / 3).clamp(36, 42);
    let [left, chart] =
        Layout::horizontal([Constraint::Length(width), Constraint::Fill(1)]).areas(area);
    let details = if area.height + 2 >= DETAILED {
        DETAILS
    } else {
        0
    };
    let [tree, details] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(details)]).areas(left);
    (tree, details, chart)
}

/// The chart above, tree and details below.
fn stacked(area: Rect) -> (Rect, Rect, Rect) {
    let [chart, below] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(area.height / 2)]).areas(area);
    let [tree, details] =
        Layout::horizontal([Constraint::Length(36), Constraint::Fill(1)]).areas(below);
    (tree, details, chart)
}

/// Draws everything; tells the state how many rows there is room for.
pub fn draw(frame: &mut Frame<'_>, app: &mut App, theme: Theme) {
    let Some(panels) = panels(frame.area()) else {
        app.unseen = true;
        return too_small(frame);
    };
    app.unseen = false;
    let tree = block_inside(panels.tree);
    app.selection.set_height(usize::from(tree.height));
    status::draw(frame, app, theme, panels.status);
    tree::draw(frame, app, theme, panels.tree);
    details::draw(frame, app, theme, panels.details);
    chart::draw(frame, app, theme, panels.chart);
    status::draw_hints(frame, app, theme, panels.hints);
    boxes::draw(frame, app, theme, &panels);
}

fn too_small(frame: &mut Frame<'_>) {
    let area = frame.area();
    let (width, height) = SMALLEST;
    let text = format!(
        "The designer needs {width} columns and {height} rows; here are {} and {}. Keys wait until it has them.",
        area.width, area.height
    );
    frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: true }), area);
}

/// A title as it stands in a rule.
fn rule(title: &str, theme: Theme) -> Line<'static> {
    // The rule beneath is dim.
    let style = theme.accent().remove_modifier(Modifier::DIM);
    Line::from(vec![
        Span::styled("─", theme.dim()),
        Span::styled(format!(" {title} "), style),
    ])
}

/// A panel with its title in a rule at the top and a rule at its right.
fn block(title: &str, theme: Theme) -> Block<'static> {
    Block::new()
        .borders(Borders::TOP | Borders::RIGHT)
        .border_style(theme.dim())
        .title(rule(title, theme))
}

/// What is inside of such a panel.
fn block_inside(area: Rect) -> Rect {
    Block::new()
        .borders(Borders::TOP | Borders::RIGHT)
        .inner(area)
}
