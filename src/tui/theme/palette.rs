//! Colour palettes for the kinds of terminals.
//!
//! In each order, a colour is as different as possible from all before it, for normal vision and for vision without one
//! kind of cones (Machado, Oliveira and Fernandes, A physiologically-based model for simulation of color vision
//! deficiency, 2009), among the colours with enough contrast to the background. The first colours are the sky blue and the
//! blue of Okabe and Ito (Color Universal Design, 2008).

use ratatui::style::Color;
use ratatui::style::Color::{Indexed, Rgb};

/// Colours for one kind of background.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct ColourPalette {
    /// Curves, in order.
    pub(super) curves: &'static [Color],
    /// Headings and open dialogs.
    pub(super) accent: Color,
    /// Values that differ from the file.
    pub(super) changed: Color,
    /// Refusals.
    pub(super) refusal: Color,
    /// Secondary text; without it the default colour is dimmed.
    pub(super) muted: Option<Color>,
}

/// The sixteen terminal colours on any background, without those that are invisible on white or black.
pub(super) const SIXTEEN: ColourPalette = ColourPalette {
    curves: &[
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
    ],
    accent: Color::Cyan,
    changed: Color::Yellow,
    refusal: Color::Red,
    muted: None,
};

/// The brighter of the sixteen terminal colours.
pub(super) const SIXTEEN_DARK: ColourPalette = ColourPalette {
    curves: &[
        Color::LightCyan,
        Color::LightYellow,
        Color::LightMagenta,
        Color::LightGreen,
        Color::LightRed,
        Color::Cyan,
        Color::Yellow,
        Color::Magenta,
    ],
    accent: Color::LightCyan,
    changed: Color::LightYellow,
    refusal: Color::LightRed,
    muted: None,
};

/// The darker of the sixteen terminal colours.
pub(super) const SIXTEEN_LIGHT: ColourPalette = ColourPalette {
    curves: &[
        Color::Blue,
        Color::Red,
        Color::Black,
        Color::Magenta,
        Color::Green,
        Color::Cyan,
    ],
    accent: Color::Blue,
    changed: Color::Magenta,
    refusal: Color::Red,
    muted: None,
};

/// Of the 256 indexed colours, those between dark and light.
pub(super) const INDEXED: ColourPalette = ColourPalette {
    curves: &[
        Indexed(32),
        Indexed(196),
        Indexed(93),
        Indexed(131),
        Indexed(126),
        Indexed(139),
        Indexed(99),
        Indexed(64),
    ],
    accent: Indexed(63),
    changed: Indexed(163),
    refusal: Indexed(131),
    muted: Some(Indexed(243)),
};

/// Of the 256 indexed colours, those for a dark background.
pub(super) const INDEXED_DARK: ColourPalette = ColourPalette {
    curves: &[
        Indexed(74),
        Indexed(202),
        Indexed(229),
        Indexed(174),
        Indexed(154),
        Indexed(50),
        Indexed(141),
        Indexed(179),
    ],
    accent: Indexed(74),
    changed: Indexed(220),
    refusal: Indexed(210),
    muted: Some(Indexed(248)),
};

/// Of the 256 indexed colours, those for a light background.
pub(super) const INDEXED_LIGHT: ColourPalette = ColourPalette {
    curves: &[
        Indexed(25),
        Indexed(160),
        Indexed(16),
        Indexed(93),
        Indexed(125),
        Indexed(18),
        Indexed(53),
        Indexed(52),
    ],
    accent: Indexed(25),
    changed: Indexed(94),
    refusal: Indexed(160),
    muted: Some(Indexed(241)),
};

/// RGB colours between dark and light.
pub(super) const RGB: ColourPalette = ColourPalette {
    curves: &[
        Rgb(0x00, 0x84, 0xc8),
        Rgb(0xf0, 0x00, 0x00),
        Rgb(0xa8, 0x48, 0x60),
        Rgb(0x90, 0x00, 0xf0),
        Rgb(0x90, 0x90, 0x48),
        Rgb(0xc0, 0x00, 0x90),
        Rgb(0x90, 0x60, 0xf0),
        Rgb(0x78, 0x90, 0x90),
    ],
    accent: Rgb(0x18, 0x78, 0xcc),
    changed: Rgb(0xa8, 0x66, 0x00),
    refusal: Rgb(0xe4, 0x24, 0x00),
    muted: Some(Rgb(0x76, 0x76, 0x76)),
};

/// RGB colours for a dark background.
pub(super) const RGB_DARK: ColourPalette = ColourPalette {
    curves: &[
        Rgb(0x56, 0xb4, 0xe9),
        Rgb(0xf0, 0xc0, 0x00),
        Rgb(0xd8, 0xf0, 0xc0),
        Rgb(0xf0, 0x90, 0x48),
        Rgb(0xc0, 0xa8, 0xa8),
        Rgb(0x00, 0xf0, 0xf0),
        Rgb(0x90, 0xd8, 0x78),
        Rgb(0xf0, 0xf0, 0x78),
    ],
    accent: Rgb(0x56, 0xb4, 0xe9),
    changed: Rgb(0xf0, 0xc0, 0x00),
    refusal: Rgb(0xff, 0x80, 0x80),
    muted: Some(Rgb(0xa0, 0xa0, 0xa0)),
};

/// RGB colours for a light background.
pub(super) const RGB_LIGHT: ColourPalette = ColourPalette {
    curves: &[
        Rgb(0x00, 0x63, 0xa8),
        Rgb(0xc0, 0x00, 0x00),
        Rgb(0x30, 0x00, 0x00),
        Rgb(0x90, 0x00, 0xf0),
        Rgb(0x00, 0x00, 0x78),
        Rgb(0xc0, 0x30, 0x60),
        Rgb(0x60, 0x18, 0x60),
        Rgb(0x30, 0x48, 0x30),
    ],
    accent: Rgb(0x00, 0x63, 0xa8),
    changed: Rgb(0x8a, 0x5a, 0x00),
    refusal: Rgb(0xc0, 0x00, 0x00),
    muted: Some(Rgb(0x60, 0x60, 0x60)),
};
