//! The views: they draw the state, and use only the curves of the solver.

pub(crate) mod dialog_box;
pub(crate) mod frame;
pub(crate) mod layout;
pub(crate) mod table;
pub(crate) mod text;

use ratatui::backend::TestBackend;
use ratatui::layout::Rect;
use ratatui::widgets::{Paragraph, Wrap};
use ratatui::{Frame, Terminal};

use super::app::{App, BeamView, List, Rows, Screen, Table};
use super::ascii;
use super::keys::AnywhereCommand;
use super::panels::beam_view::{deflection, forces, mode_shape, power, section, structure};
use super::panels::chart::figure::Drawn;
use super::panels::{
    band, chart, dialogs, modes, peaks, readings, sensitivity, status, tree, tuning,
};
use super::theme::Theme;
use crate::fault_injection;
pub use layout::SMALLEST;
use layout::{OptionalPanels, panels};

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
        readings: readings::view::rows(app),
        band: band::view::rows(app),
        tuning: tuning::view::rows(app),
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
    let tree = frame::block_inside(panels.tree);
    status::draw(frame, app, theme, panels.status);
    tree::view::draw(frame, app, theme, panels.tree);
    tree::details::draw(frame, app, theme, panels.details);
    let chart = if panels.chart.height > 0 {
        chart::view::draw(frame, app, theme, panels.chart)
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
    let (dialog, list) = dialogs::view::draw(frame, app, theme, &panels);
    Some(Screen {
        unseen: false,
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
    readings: Vec<readings::view::Row>,
    band: Vec<band::view::Row>,
    tuning: Vec<tuning::view::Row>,
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
        Table::Modes => table::draw(
            frame,
            app,
            &modes::view::content(app, area.width),
            list,
            area,
        ),
        Table::Peaks => table::draw(frame, app, &peaks::content(app), list, area),
        Table::Readings => {
            let content = readings::view::content(app, &rows.readings);
            table::draw(frame, app, &content, list, area)
        }
        Table::Band => table::draw(
            frame,
            app,
            &band::view::content(app, &rows.band),
            list,
            area,
        ),
        Table::Sensitivities => {
            table::draw(frame, app, &sensitivity::view::content(app), list, area)
        }
        Table::Tuning => {
            let content = tuning::view::content(app, &rows.tuning);
            table::draw(frame, app, &content, list, area)
        }
    }
}

/// Draws the beam view below the chart.
fn draw_beam_view(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    match app.beam_view.shown {
        Some(BeamView::Mode) => mode_shape::draw(frame, app, theme, area),
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
