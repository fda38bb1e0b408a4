//! The frames of panels: a rule with a title.

use ratatui::layout::Rect;
use ratatui::style::Modifier;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Borders};

use crate::tui::theme::Theme;

/// A title in a rule.
pub(crate) fn rule(title: &str, theme: Theme) -> Line<'static> {
    // The rule itself is dim.
    let style = theme.accent().remove_modifier(Modifier::DIM);
    Line::from(vec![
        Span::styled("─", theme.dim()),
        Span::styled(format!(" {title} "), style),
    ])
}

/// A panel with a rule at the top: the title on the left, a note on the right if there is room for both.
pub(crate) fn panel(title: Line<'static>, note: Line<'static>, columns: u16) -> Block<'static> {
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
pub(crate) fn block(title: &str, theme: Theme) -> Block<'static> {
    Block::new()
        .borders(Borders::TOP | Borders::RIGHT)
        .border_style(theme.dim())
        .title(rule(title, theme))
}

/// The area inside such a panel.
pub(crate) fn block_inside(area: Rect) -> Rect {
    Block::new()
        .borders(Borders::TOP | Borders::RIGHT)
        .inner(area)
}
