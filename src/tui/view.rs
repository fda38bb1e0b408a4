//! The views: they draw the state, and use only the curves of the solver.

mod animated;
mod band;
mod chart;
mod comparison;
mod confirm;
mod deflection;
mod details;
mod dialog_box;
mod dialogs;
mod figure;
mod forces;
mod help;
mod modes;
mod palette;
mod peaks;
mod power;
mod prompt;
mod readings;
mod readout;
mod section;
mod sensitivity;
mod shape;
mod status;
mod structure;
mod summary;
mod table;
mod text;
mod tree;
mod tuning;

use ratatui::backend::TestBackend;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Modifier;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Borders, Paragraph, Wrap};
use ratatui::{Frame, Terminal};

use super::app::{App, BeamView, List, Rows, Screen, Table};
use super::ascii;
use super::keys::AnywhereCommand;
use super::theme::Theme;
use crate::fault_injection;
use figure::Drawn;

/// The smallest supported screen, columns and rows.
pub const SMALLEST: (u16, u16) = (60, 18);
/// From this width on, the chart is to the right of the tree.
const BESIDE: u16 = 76;
/// From this height on, the details are below the tree.
const DETAILED: u16 = 20;
/// Rows of the details below the tree, including their rule.
const DETAILS: u16 = 6;

/// From this height of the right side on, the beam view is below the chart; else it replaces the chart.
const SHAPED: u16 = 20;
/// A table takes at most this share of the right side's height, in percent.
const TABLED: u16 = 45;

/// The areas of the panels. A hidden panel has no height.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Panels {
    pub(crate) status: Rect,
    pub(crate) tree: Rect,
    pub(crate) details: Rect,
    pub(crate) chart: Rect,
    pub(crate) shape: Rect,
    pub(crate) table: Rect,
    pub(crate) hints: Rect,
}

/// The optional panels next to tree and chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct OptionalPanels {
    /// The rows of the open table, if any.
    table: Option<u16>,
    shape: bool,
}

/// The panels of a screen; none if it is too small.
fn panels(area: Rect, wanted: OptionalPanels) -> Option<Panels> {
    if area.width < SMALLEST.0 || area.height < SMALLEST.1 {
        return None;
    }
    let [status, middle, hints] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Fill(1),
        Constraint::Length(1),
    ])
    .areas(area);
    let mut panels = if area.width >= BESIDE {
        side_by_side(middle, wanted)
    } else {
        stacked(middle, wanted)
    };
    (panels.status, panels.hints) = (status, hints);
    if wanted.shape {
        let rows = if panels.chart.height >= SHAPED {
            panels.chart.height / 2
        } else {
            panels.chart.height
        };
        [panels.chart, panels.shape] =
            Layout::vertical([Constraint::Fill(1), Constraint::Length(rows)]).areas(panels.chart);
    }
    Some(panels)
}

/// Tree and details on the left, the chart with a table below it on the right.
fn side_by_side(area: Rect, wanted: OptionalPanels) -> Panels {
    let width = (area.width / 3).clamp(36, 42);
    let [left, right] =
        Layout::horizontal([Constraint::Length(width), Constraint::Fill(1)]).areas(area);
    let details = if area.height + 2 >= DETAILED {
        DETAILS
    } else {
        0
    };
    let [tree, details] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(details)]).areas(left);
    let rows = wanted
        .table
        .map_or(0, |rows| rows.min(right.height * TABLED / 100));
    let [chart, table] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(rows)]).areas(right);
    Panels {
        tree,
        details,
        chart,
        table,
        ..Panels::default()
    }
}

/// The chart at the top; below it tree and details, or instead a table.
fn stacked(area: Rect, wanted: OptionalPanels) -> Panels {
    let below = (area.height / 2).saturating_sub(1);
    let [chart, below] =
        Layout::vertical([Constraint::Fill(1), Constraint::Length(below)]).areas(area);
    let panels = Panels {
        chart,
        ..Panels::default()
    };
    if wanted.table.is_some() {
        return Panels {
            table: below,
            ..panels
        };
    }
    let [tree, details] =
        Layout::horizontal([Constraint::Length(36), Constraint::Fill(1)]).areas(below);
    Panels {
        tree,
        details,
        ..panels
    }
}

/// Draws everything; returns the positions, or none if the screen is too small. [`App::drawn`] stores them.
pub fn draw(frame: &mut Frame<'_>, app: &App) -> Option<Screen> {
    fault_injection::inject("drawing", &app.model().title);
    let theme = app.theme;
    let screen = draw_panels(frame, app, theme);
    text::show_hidden(frame.buffer_mut());
    if theme.is_ascii() {
        ascii::flatten(frame.buffer_mut());
    }
    screen
}

fn draw_panels(frame: &mut Frame<'_>, app: &App, theme: Theme) -> Option<Screen> {
    let mut tables = app.tables;
    let rows = TableRows {
        readings: readings::rows(app),
        band: band::rows(app),
        tuning: tuning::rows(app),
    };
    tables.readings.set_rows(rows.readings.len());
    tables
        .band
        .set_rows(rows.band.len() + app.comparison.fits.len());
    tables.tuning.set_rows(rows.tuning.len());
    let list = tables.open.map(|table| *tables.list_mut(table));
    let wanted = OptionalPanels {
        table: list.map(|list| (list.rows.max(1) as u16).saturating_add(table::FRAME_ROWS)),
        shape: app.beam_view.shown.is_some(),
    };
    let Some(panels) = panels(frame.area(), wanted) else {
        too_small(frame, &app.keys.key_of(AnywhereCommand::End));
        return None;
    };
    let tree = block_inside(panels.tree);
    status::draw(frame, app, theme, panels.status);
    tree::draw(frame, app, theme, panels.tree);
    details::draw(frame, app, theme, panels.details);
    let chart = if panels.chart.height > 0 {
        chart::draw(frame, app, theme, panels.chart)
    } else {
        Drawn::default()
    };
    if panels.shape.height > 0 {
        draw_beam_view(frame, app, theme, panels.shape);
    }
    let table = tables.open.map(|open| {
        let list = tables.list_mut(open);
        draw_table(frame, app, (open, &rows), list, panels.table)
    });
    status::draw_hints(frame, app, theme, panels.hints);
    let (dialog, list) = dialogs::draw(frame, app, theme, &panels);
    Some(Screen {
        area: frame.area(),
        tree: Rows {
            area: tree,
            first: app.selection.first_shown(tree.height.into()),
        },
        details: panels.details,
        plot: chart.plot,
        levels: chart.levels,
        table,
        tables,
        list,
        dialog,
    })
}

/// The rows that the views make, once for a drawing: their number sets the height of the table.
struct TableRows {
    readings: Vec<readings::Row>,
    band: Vec<band::Row>,
    tuning: Vec<tuning::Row>,
}

/// Draws the open table; returns the area of its rows.
fn draw_table(
    frame: &mut Frame<'_>,
    app: &App,
    (open, rows): (Table, &TableRows),
    list: &mut List,
    area: Rect,
) -> Rows {
    match open {
        Table::Modes => table::draw(frame, app, &modes::content(app, area.width), list, area),
        Table::Peaks => table::draw(frame, app, &peaks::content(app), list, area),
        Table::Readings => {
            let content = readings::content(app, &rows.readings);
            table::draw(frame, app, &content, list, area)
        }
        Table::Band => table::draw(frame, app, &band::content(app, &rows.band), list, area),
        Table::Sensitivities => table::draw(frame, app, &sensitivity::content(app), list, area),
        Table::Tuning => {
            let content = tuning::content(app, &rows.tuning);
            table::draw(frame, app, &content, list, area)
        }
    }
}

/// Draws the beam view below the chart.
fn draw_beam_view(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    match app.beam_view.shown {
        Some(BeamView::Mode) => shape::draw(frame, app, theme, area),
        Some(BeamView::Structure) => structure::draw(frame, app, theme, area),
        Some(BeamView::Section) => section::draw(frame, app, theme, area),
        Some(BeamView::Deflection) => deflection::draw(frame, app, theme, area),
        Some(BeamView::Moments | BeamView::Shear | BeamView::Torque | BeamView::Bimoment) => {
            forces::draw(frame, app, theme, area);
        }
        Some(BeamView::Power) => power::draw(frame, app, theme, area),
        None => {}
    }
}

/// The screen as text, as drawn last: one line per row, without trailing blanks.
pub fn text(app: &App) -> String {
    let size = app.screen.area;
    let backend = TestBackend::new(size.width, size.height);
    // This backend cannot fail.
    let Ok(mut terminal) = Terminal::new(backend);
    let _ = terminal.draw(|frame| drop(draw(frame, app)));
    let buffer = terminal.backend().buffer();
    let row = |y| (0..size.width).map(move |x| buffer[(x, y)].symbol());
    let lines = (0..size.height).map(|y| row(y).collect::<String>().trim_end().to_owned() + "\n");
    lines.collect()
}

fn too_small(frame: &mut Frame<'_>, leave: &str) {
    let area = frame.area();
    let (width, height) = SMALLEST;
    let text = format!(
        "The designer needs {width} columns and {height} rows; here are {} and {}. {leave} quits and keeps unsaved changes for recovery.",
        area.width, area.height
    );
    frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: true }), area);
}

/// A title in a rule.
fn rule(title: &str, theme: Theme) -> Line<'static> {
    // The rule itself is dim.
    let style = theme.accent().remove_modifier(Modifier::DIM);
    Line::from(vec![
        Span::styled("─", theme.dim()),
        Span::styled(format!(" {title} "), style),
    ])
}

/// A panel with a rule at the top: the title on the left, a note on the right if there is room for both.
fn panel(title: Line<'static>, note: Line<'static>, columns: u16) -> Block<'static> {
    let block = Block::new().borders(Borders::TOP);
    let room = usize::from(columns).saturating_sub(title.width() + 1);
    let block = block.title(title);
    if note.width() <= room {
        block.title(note.right_aligned())
    } else {
        block
    }
}

/// A panel with its title in a rule at the top and a rule on its right.
fn block(title: &str, theme: Theme) -> Block<'static> {
    Block::new()
        .borders(Borders::TOP | Borders::RIGHT)
        .border_style(theme.dim())
        .title(rule(title, theme))
}

/// The area inside such a panel.
fn block_inside(area: Rect) -> Rect {
    Block::new()
        .borders(Borders::TOP | Borders::RIGHT)
        .inner(area)
}
