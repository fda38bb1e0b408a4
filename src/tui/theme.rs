//! Colours: the sixteen of every terminal, over whatever background it has; or none.

use ratatui::style::{Color, Modifier, Style};

use super::plot::ChartStyles;

/// Colours of curves, in their order. Those that vanish on a white or black ground are left out.
const CURVES: [Color; 10] = [
    Color::Cyan,
    Color::Magenta,
    Color::Green,
    Color::Red,
    Color::Blue,
    Color::Yellow,
    Color::LightCyan,
    Color::LightMagenta,
    Color::LightGreen,
    Color::LightRed,
];

/// Markers of curves, in their order: no colour is needed to tell curves apart.
const MARKERS: [char; 12] = ['o', 'x', '+', '*', '#', '@', '%', '&', 'a', 'b', 'c', 'd'];

/// The styles of the designer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Theme {
    colour: bool,
}

impl Theme {
    /// With colours, or with bold, dim and reversed only.
    pub const fn new(colour: bool) -> Self {
        Self { colour }
    }

    /// Without colours where `NO_COLOR` is set to something (no-color.org).
    pub fn from_environment() -> Self {
        Self::new(std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty()))
    }

    fn with(self, colour: Color, modifier: Modifier) -> Style {
        let style = Style::new().add_modifier(modifier);
        if self.colour { style.fg(colour) } else { style }
    }

    /// Headings and open boxes.
    pub fn accent(self) -> Style {
        self.with(Color::Cyan, Modifier::BOLD)
    }

    /// The selected row.
    pub fn selection(self) -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }

    /// The selected row while the arrows are another panel's.
    pub fn selection_aside(self) -> Style {
        Style::new().add_modifier(Modifier::BOLD | Modifier::UNDERLINED)
    }

    /// What is secondary.
    pub fn dim(self) -> Style {
        Style::new().add_modifier(Modifier::DIM)
    }

    /// What differs from the file.
    pub fn changed(self) -> Style {
        self.with(Color::Yellow, Modifier::BOLD)
    }

    /// A refusal.
    pub fn refusal(self) -> Style {
        self.with(Color::Red, Modifier::BOLD)
    }

    /// A key in hints and help.
    pub fn key(self) -> Style {
        Style::new().add_modifier(Modifier::BOLD)
    }

    /// The curve with this number.
    pub fn curve(self, number: usize) -> Style {
        if self.colour {
            Style::new().fg(CURVES[number % CURVES.len()])
        } else {
            Style::new()
        }
    }

    /// The points of a finite-element curve beside the curve with this number.
    pub fn witness(self, number: usize) -> Style {
        if self.colour {
            self.curve(number + CURVES.len() / 2)
        } else {
            self.key()
        }
    }

    /// The marker of the curve with this number.
    pub const fn marker(self, number: usize) -> char {
        MARKERS[number % MARKERS.len()]
    }

    /// The chart's own parts.
    pub fn chart(self) -> ChartStyles {
        ChartStyles {
            axis: self.dim(),
            title: self.accent(),
            grid: self.dim(),
            message: self.dim(),
            selected_mark: self.accent().add_modifier(Modifier::REVERSED),
            ..ChartStyles::default()
        }
    }
}
