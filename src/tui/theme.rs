//! Colours and characters: of the sixteen colours of every terminal over whatever ground it has, of a palette where
//! the ground is known, or none.
//!
//! Nothing is said by colour alone: curves have markers or line styles beside it, a change its mark or its words, a
//! refusal its sentence, and what is selected is reversed or underlined.

mod palette;

use ratatui::style::{Color, Modifier, Style};

use self::palette::Palette;
use super::options::{Colours, Environment, Ground, Marker, Options};
use super::plot::{ChartStyles, Glyphs};

/// Markers of curves, in their order: no colour is needed to tell curves apart.
const MARKERS: [char; 12] = ['o', 'x', '+', '*', '#', '@', '%', '&', 'a', 'b', 'c', 'd'];

/// How finely the terminal mixes colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Depth {
    Sixteen,
    TwoFiftySix,
    Truecolor,
}

/// Which colours are used of those that the terminal has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Scheme {
    /// None: bold, dim, underlined and reversed instead.
    Plain,
    /// Its own sixteen, over whatever ground.
    Terminal,
    /// Fixed ones that can be read on a dark and on a light ground.
    Between,
    /// Those for a dark ground.
    Dark,
    /// Those for a light ground.
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

impl Theme {
    /// The theme that is asked for, on the terminal that the environment tells of.
    ///
    /// The fixed palettes need a ground: that of the options, else that of `COLORFGBG`. Where it is not known, a depth
    /// that was asked for gets colours that can be read on both.
    pub fn resolve(options: &Options, environment: &Environment) -> Self {
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
        let scheme = match (colours, ground(options.ground, environment)) {
            (Colours::Never, _) => Scheme::Plain,
            (Colours::Auto, _) if environment.no_color => Scheme::Plain,
            (_, Some(Ground::Dark)) => Scheme::Dark,
            (_, Some(Ground::Light)) => Scheme::Light,
            _ if asked => Scheme::Between,
            _ => Scheme::Terminal,
        };
        Self {
            depth,
            scheme,
            glyphs,
            ascii,
        }
    }

    /// The terminal's own colours or none, in Unicode.
    pub const fn new(colour: bool) -> Self {
        Self {
            depth: Depth::Sixteen,
            scheme: if colour {
                Scheme::Terminal
            } else {
                Scheme::Plain
            },
            glyphs: Glyphs::Braille,
            ascii: false,
        }
    }

    /// What its colours are, in words.
    pub const fn name(self) -> &'static str {
        match self.scheme {
            Scheme::Plain => "no colours",
            Scheme::Terminal => "the terminal's colours",
            Scheme::Between => "colours for any ground",
            Scheme::Dark => "colours for a dark ground",
            Scheme::Light => "colours for a light ground",
        }
    }

    /// The word by which its colours are remembered.
    pub const fn word(self) -> &'static str {
        match self.scheme {
            Scheme::Plain => "none",
            Scheme::Terminal | Scheme::Between => "terminal",
            Scheme::Dark => "dark",
            Scheme::Light => "light",
        }
    }

    /// The theme with the colours that are remembered by this word; as it is where there is none.
    #[must_use]
    pub fn recalled(self, word: Option<&str>) -> Self {
        let schemes = [Scheme::Plain, Scheme::Terminal, Scheme::Dark, Scheme::Light];
        let mut themes = schemes.into_iter().map(|scheme| Self { scheme, ..self });
        let found = themes.find(|theme| Some(theme.word()) == word);
        found.unwrap_or(self)
    }

    /// The theme with the next colours: the terminal's, for a dark ground, for a light ground, none.
    #[must_use]
    pub const fn next(self) -> Self {
        let scheme = match self.scheme {
            Scheme::Plain => Scheme::Terminal,
            Scheme::Terminal | Scheme::Between => Scheme::Dark,
            Scheme::Dark => Scheme::Light,
            Scheme::Light => Scheme::Plain,
        };
        Self { scheme, ..self }
    }

    /// Nothing but ASCII is to be drawn.
    pub const fn is_ascii(self) -> bool {
        self.ascii
    }

    /// The characters of which charts are made.
    pub const fn glyphs(self) -> Glyphs {
        self.glyphs
    }

    const fn palette(self) -> Option<&'static Palette> {
        use {Depth as D, Scheme as S};
        Some(match (self.scheme, self.depth) {
            (S::Plain, _) => return None,
            (S::Terminal, _) | (S::Between, D::Sixteen) => &palette::SIXTEEN,
            (S::Between, D::TwoFiftySix) => &palette::FIXED,
            (S::Between, D::Truecolor) => &palette::FREE,
            (S::Dark, D::Sixteen) => &palette::SIXTEEN_DARK,
            (S::Dark, D::TwoFiftySix) => &palette::FIXED_DARK,
            (S::Dark, D::Truecolor) => &palette::FREE_DARK,
            (S::Light, D::Sixteen) => &palette::SIXTEEN_LIGHT,
            (S::Light, D::TwoFiftySix) => &palette::FIXED_LIGHT,
            (S::Light, D::Truecolor) => &palette::FREE_LIGHT,
        })
    }

    fn bold(self, colour: impl FnOnce(&Palette) -> Color) -> Style {
        // Over something dim it is to stand out all the same.
        let style = Style::new()
            .add_modifier(Modifier::BOLD)
            .remove_modifier(Modifier::DIM);
        match self.palette() {
            Some(palette) => style.fg(colour(palette)),
            None => style,
        }
    }

    /// Headings and open boxes.
    pub fn accent(self) -> Style {
        self.bold(|palette| palette.accent)
    }

    /// The selected row.
    pub fn selection(self) -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }

    /// The selected row while the arrows are another panel's.
    pub fn selection_aside(self) -> Style {
        Style::new().add_modifier(Modifier::BOLD | Modifier::UNDERLINED)
    }

    /// What a search has found.
    pub fn found(self) -> Style {
        Style::new().add_modifier(Modifier::UNDERLINED)
    }

    /// What is secondary.
    pub fn dim(self) -> Style {
        match self.palette().and_then(|palette| palette.muted) {
            Some(muted) => Style::new().fg(muted),
            None => Style::new().add_modifier(Modifier::DIM),
        }
    }

    /// What differs from the file.
    pub fn changed(self) -> Style {
        self.bold(|palette| palette.changed)
    }

    /// A refusal.
    pub fn refusal(self) -> Style {
        self.bold(|palette| palette.refusal)
    }

    /// A key in hints and help.
    pub fn key(self) -> Style {
        // Over something muted it takes the terminal's own colour.
        match self.palette().and_then(|palette| palette.muted) {
            Some(_) => self.bold(|_| Color::Reset),
            None => Style::new().add_modifier(Modifier::BOLD),
        }
    }

    /// The curve with this number.
    pub fn curve(self, number: usize) -> Style {
        match self.palette() {
            Some(Palette { curves, .. }) => Style::new().fg(curves[number % curves.len()]),
            None => Style::new(),
        }
    }

    /// The points of a finite-element curve beside the curve with this number.
    pub fn witness(self, number: usize) -> Style {
        match self.palette() {
            Some(Palette { curves, .. }) => self.curve(number + curves.len() / 2),
            None => self.key(),
        }
    }

    /// The marker of the curve with this number.
    pub const fn marker(self, number: usize) -> char {
        MARKERS[number % MARKERS.len()]
    }

    /// The marker of finite-element points: none of the curves', nor of what lines are made.
    pub const fn point(self) -> char {
        match self.glyphs {
            Glyphs::Braille | Glyphs::Octant | Glyphs::Block => '•',
            Glyphs::Dot => '○',
            Glyphs::Ascii => '$',
        }
    }

    /// The marker of the measured curve with this number: none of the curves', nor that of finite elements.
    pub const fn sample(self, number: usize) -> char {
        let samples = match self.glyphs {
            Glyphs::Braille | Glyphs::Octant | Glyphs::Block | Glyphs::Dot => ['◇', '□', '▽', '☆'],
            Glyphs::Ascii => ['M', 'N', 'P', 'Q'],
        };
        samples[number % samples.len()]
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

/// How finely the terminal says that it mixes colours.
fn depth_of(environment: &Environment) -> Depth {
    let term = environment.term.as_deref().unwrap_or_default();
    match environment.colorterm.as_deref() {
        Some("truecolor" | "24bit") => Depth::Truecolor,
        _ if term.contains("direct") => Depth::Truecolor,
        _ if term.contains("256color") => Depth::TwoFiftySix,
        _ => Depth::Sixteen,
    }
}

/// The ground, dark or light, if it is known.
fn ground(asked: Option<Ground>, environment: &Environment) -> Option<Ground> {
    match asked {
        Some(ground @ (Ground::Dark | Ground::Light)) => Some(ground),
        Some(Ground::Auto) | None => {
            // The last number is the ground's, by rxvt's convention: 7 and those from 9 on are light.
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
