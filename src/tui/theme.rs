//! Colours and characters: the sixteen terminal colours on any background, a palette for a known background, or no
//! colours.
//!
//! Colour is never the only sign: curves also have markers or line styles, changes a mark or words, refusals a sentence,
//! and the selection is reversed or underlined.

mod palette;

use ratatui::style::{Color, Modifier, Style};

use self::palette::ColourPalette;
use super::options::{Colours, Environment, Ground, Marker, Options};
use super::plot::{ChartStyles, Glyphs};

/// Markers of curves, in order: they distinguish curves without colour.
const MARKERS: [char; 12] = ['o', 'x', '+', '*', '#', '@', '%', '&', 'a', 'b', 'c', 'd'];

/// The colour depth of the terminal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Depth {
    Sixteen,
    TwoFiftySix,
    Truecolor,
}

/// The colour scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Scheme {
    /// No colours: bold, dim, underlined and reversed instead.
    Monochrome,
    /// The sixteen colours of the terminal, on any background.
    Terminal,
    /// Fixed colours that are readable on dark and light backgrounds.
    Neutral,
    /// Colours for a dark background.
    Dark,
    /// Colours for a light background.
    Light,
}

/// The styles and characters of the designer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Theme {
    depth: Depth,
    scheme: Scheme,
    glyphs: Glyphs,
    ascii: bool,
}

// Each role is a method of the theme, even if all themes draw it alike.
#[allow(clippy::unused_self)]
impl Theme {
    /// The theme for the options and the terminal of the environment.
    ///
    /// Palettes for a dark or light background need to know it: from the options, else from `COLORFGBG`. If it is
    /// unknown, a requested depth gets colours that are readable on both.
    pub fn resolve(options: Options, environment: &Environment) -> Self {
        let colours = options.colours.unwrap_or(Colours::Auto);
        let ascii = options.ascii.unwrap_or(!environment.is_unicode());
        let glyphs = match options.marker {
            _ if ascii => Glyphs::Ascii,
            None | Some(Marker::Braille) => Glyphs::Braille,
            Some(Marker::Octant) => Glyphs::Octant,
            Some(Marker::Block) => Glyphs::Block,
            Some(Marker::Dot) => Glyphs::Dot,
            Some(Marker::Ascii) => Glyphs::Ascii,
        };
        let depth = match colours {
            Colours::Sixteen => Depth::Sixteen,
            Colours::TwoFiftySix => Depth::TwoFiftySix,
            Colours::Truecolor => Depth::Truecolor,
            Colours::Auto | Colours::Always | Colours::Never => depth_of(environment),
        };
        let asked = matches!(colours, Colours::TwoFiftySix | Colours::Truecolor);
        let scheme = match (colours, background(options.ground, environment)) {
            (Colours::Never, _) => Scheme::Monochrome,
            (Colours::Auto, _) if environment.no_color => Scheme::Monochrome,
            (_, Some(Ground::Dark)) => Scheme::Dark,
            (_, Some(Ground::Light)) => Scheme::Light,
            _ if asked => Scheme::Neutral,
            _ => Scheme::Terminal,
        };
        Self {
            depth,
            scheme,
            glyphs,
            ascii,
        }
    }

    /// The terminal's colours or none, in Unicode.
    pub const fn new(colour: bool) -> Self {
        Self {
            depth: Depth::Sixteen,
            scheme: if colour {
                Scheme::Terminal
            } else {
                Scheme::Monochrome
            },
            glyphs: Glyphs::Braille,
            ascii: false,
        }
    }

    /// The name of the colour scheme for people.
    pub const fn name(self) -> &'static str {
        match self.scheme {
            Scheme::Monochrome => "no colours",
            Scheme::Terminal => "the terminal's colours",
            Scheme::Neutral => "colours for any background",
            Scheme::Dark => "colours for a dark background",
            Scheme::Light => "colours for a light background",
        }
    }

    /// The key under which the colour scheme is stored.
    pub const fn word(self) -> &'static str {
        match self.scheme {
            Scheme::Monochrome => "none",
            Scheme::Terminal | Scheme::Neutral => "terminal",
            Scheme::Dark => "dark",
            Scheme::Light => "light",
        }
    }

    /// The theme with the stored colour scheme; unchanged without one.
    #[must_use]
    pub fn recalled(self, word: Option<&str>) -> Self {
        let schemes = [
            Scheme::Monochrome,
            Scheme::Terminal,
            Scheme::Dark,
            Scheme::Light,
        ];
        let mut themes = schemes.into_iter().map(|scheme| Self { scheme, ..self });
        let found = themes.find(|theme| Some(theme.word()) == word);
        found.unwrap_or(self)
    }

    /// The theme with the next colours: the terminal's, for a dark background, for a light background, none.
    #[must_use]
    pub const fn next(self) -> Self {
        let scheme = match self.scheme {
            Scheme::Monochrome => Scheme::Terminal,
            Scheme::Terminal | Scheme::Neutral => Scheme::Dark,
            Scheme::Dark => Scheme::Light,
            Scheme::Light => Scheme::Monochrome,
        };
        Self { scheme, ..self }
    }

    /// Whether only ASCII is drawn.
    pub const fn is_ascii(self) -> bool {
        self.ascii
    }

    /// The character set of charts.
    pub const fn glyphs(self) -> Glyphs {
        self.glyphs
    }

    const fn palette(self) -> Option<&'static ColourPalette> {
        use {Depth as D, Scheme as S};
        Some(match (self.scheme, self.depth) {
            (S::Monochrome, _) => return None,
            (S::Terminal, _) | (S::Neutral, D::Sixteen) => &palette::SIXTEEN,
            (S::Neutral, D::TwoFiftySix) => &palette::INDEXED,
            (S::Neutral, D::Truecolor) => &palette::RGB,
            (S::Dark, D::Sixteen) => &palette::SIXTEEN_DARK,
            (S::Dark, D::TwoFiftySix) => &palette::INDEXED_DARK,
            (S::Dark, D::Truecolor) => &palette::RGB_DARK,
            (S::Light, D::Sixteen) => &palette::SIXTEEN_LIGHT,
            (S::Light, D::TwoFiftySix) => &palette::INDEXED_LIGHT,
            (S::Light, D::Truecolor) => &palette::RGB_LIGHT,
        })
    }

    fn bold(self, colour: impl FnOnce(&ColourPalette) -> Color) -> Style {
        // It must stand out on dim text, too.
        let style = Style::new()
            .add_modifier(Modifier::BOLD)
            .remove_modifier(Modifier::DIM);
        match self.palette() {
            Some(palette) => style.fg(colour(palette)),
            None => style,
        }
    }

    /// Headings and open dialogs.
    pub fn accent(self) -> Style {
        self.bold(|palette| palette.accent)
    }

    /// The selected row.
    pub fn selection(self) -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }

    /// The selected row of a panel without focus.
    pub fn selection_aside(self) -> Style {
        Style::new().add_modifier(Modifier::BOLD | Modifier::UNDERLINED)
    }

    /// Search matches.
    pub fn found(self) -> Style {
        Style::new().add_modifier(Modifier::UNDERLINED)
    }

    /// Secondary text.
    pub fn dim(self) -> Style {
        match self.palette().and_then(|palette| palette.muted) {
            Some(muted) => Style::new().fg(muted),
            None => Style::new().add_modifier(Modifier::DIM),
        }
    }

    /// Values that differ from the file.
    pub fn changed(self) -> Style {
        self.bold(|palette| palette.changed)
    }

    /// Refusals.
    pub fn refusal(self) -> Style {
        self.bold(|palette| palette.refusal)
    }

    /// Keys in hints and help.
    pub fn key(self) -> Style {
        // On muted text it takes the terminal's default colour.
        match self.palette().and_then(|palette| palette.muted) {
            Some(_) => self.bold(|_| Color::Reset),
            None => Style::new().add_modifier(Modifier::BOLD),
        }
    }

    /// The style of a curve by its number.
    pub fn curve(self, number: usize) -> Style {
        match self.palette() {
            Some(ColourPalette { curves, .. }) => Style::new().fg(curves[number % curves.len()]),
            None => Style::new(),
        }
    }

    /// The style of the finite-element points that belong to the curve with this number.
    pub fn witness(self, number: usize) -> Style {
        match self.palette() {
            Some(ColourPalette { curves, .. }) => self.curve(number + curves.len() / 2),
            None => self.key(),
        }
    }

    /// The marker of a curve by its number.
    pub const fn marker(self, number: usize) -> char {
        MARKERS[number % MARKERS.len()]
    }

    /// The marker of finite-element points: different from curve markers and line characters.
    pub const fn point(self) -> char {
        match self.glyphs {
            Glyphs::Braille | Glyphs::Octant | Glyphs::Block => '•',
            Glyphs::Dot => '○',
            Glyphs::Ascii => '$',
        }
    }

    /// The marker of a measured curve by its number: different from curve and finite-element markers.
    pub const fn sample(self, number: usize) -> char {
        let samples = match self.glyphs {
            Glyphs::Braille | Glyphs::Octant | Glyphs::Block | Glyphs::Dot => ['◇', '□', '▽', '☆'],
            Glyphs::Ascii => ['M', 'N', 'P', 'Q'],
        };
        samples[number % samples.len()]
    }

    /// The styles of the chart's parts.
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

/// The colour depth that the environment reports.
fn depth_of(environment: &Environment) -> Depth {
    let term = environment.term.as_deref().unwrap_or_default();
    match environment.colorterm.as_deref() {
        Some("truecolor" | "24bit") => Depth::Truecolor,
        _ if term.contains("direct") => Depth::Truecolor,
        _ if term.contains("256color") => Depth::TwoFiftySix,
        _ => Depth::Sixteen,
    }
}

/// The background, dark or light, if it is known.
fn background(asked: Option<Ground>, environment: &Environment) -> Option<Ground> {
    match asked {
        Some(ground @ (Ground::Dark | Ground::Light)) => Some(ground),
        Some(Ground::Auto) | None => {
            // By rxvt's convention the last number is the background: 7 and those from 9 on are light.
            let last = environment.colorfgbg.as_deref()?.rsplit(';').next()?;
            match last.parse::<u8>().ok()? {
                0..=6 | 8 => Some(Ground::Dark),
                7 | 9..=15 => Some(Ground::Light),
                _ => None,
            }
        }
    }
}

#[cfg(test)]
mod tests;
