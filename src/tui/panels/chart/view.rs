//! The chart of the visible responses.

use ratatui::Frame;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Modifier;
use ratatui::text::Line;
use ratatui::widgets::{Block, Borders, Paragraph, Wrap};

use crate::tui::app::{App, Shown};
use crate::tui::keys::{CurvesCommand, ModelCommand};
use crate::tui::panels::chart::figure::{self, Drawn};
use crate::tui::panels::chart::readout;
use crate::tui::theme::Theme;
use crate::tui::view::frame;
use crate::tui::view::text::{cut, width};

/// Draws the chart; returns the area of its curves and the range of its value axis, if there are any.
pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) -> Drawn {
    let scene = app.scene();
    // At least a part of a long title stays; the readout is never cut off.
    let columns = usize::from(area.width);
    let title = width(&scene.title).min(columns / 4);
    let read = readout::line(app, columns.saturating_sub(title + 5));
    let title = cut(&scene.title, columns.saturating_sub(width(&read) + 5));
    let block = Block::new()
        .borders(Borders::TOP)
        .border_style(theme.dim())
        .title(frame::rule(&title, theme))
        .title(Line::styled(read, theme.key().remove_modifier(Modifier::DIM)).right_aligned());
    let inside = block.inner(area);
    frame.render_widget(block, area);
    if scene.curves.is_empty() {
        let text = Paragraph::new(why_empty(app)).wrap(Wrap { trim: false });
        frame.render_widget(
            text.style(theme.dim()),
            inside.centered_vertically(Constraint::Length(2)),
        );
        return Drawn::default();
    }
    figure::draw(&scene, theme, inside, frame.buffer_mut())
}

/// The index of a response among the visible ones.
pub(crate) fn place(app: &App, response: &str) -> Option<usize> {
    app.curves.visible.iter().position(|name| name == response)
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
                " the model has no responses: {} on Responses adds one",
                app.keys.key_of(ModelCommand::Add)
            )
        }
        _ if app.curves.visible.is_empty() => format!(
            " no response is visible: select one, then {}",
            app.keys.key_of(CurvesCommand::Show)
        ),
        Shown::Failed(reason, _) => format!(" no curves: {reason}"),
        Shown::Nothing => " solving".to_owned(),
        Shown::Picture(_) => " the visible responses have no curves yet".to_owned(),
    }
}
