//! Tables of colours for what is known of the terminal.
//!
//! The orders are such that each colour is as far as may be from all before it, to the common eye and to those
//! without one kind of cones (Machado, Oliveira and Fernandes, A physiologically-based model for simulation of color
//! vision deficiency, 2009), among the colours with contrast enough against the ground; they start at the sky blue and
//! the blue of Okabe and Ito (Color Universal Design, 2008).

use ratatui::style::Color;
use ratatui::style::Color::{Indexed, Rgb};

/// Colours for one kind of ground.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Palette {
    /// Of curves, in their order.
    pub(super) curves: &'static [Color],
    /// Of headings and open boxes.
    pub(super) accent: Color,
    /// Of what differs from the file.
    pub(super) changed: Color,
    /// Of a refusal.
    pub(super) refusal: Color,
    /// Of what is secondary; without one the terminal's own letters are dimmed.
    pub(super) muted: Option<Color>,
}

/// The terminal's sixteen over whatever ground it has: those that vanish on a white or black one are left out.
pub(super) const SIXTEEN: Palette = Palette {
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

/// The brighter ones of the terminal's sixteen.
pub(super) const SIXTEEN_DARK: Palette = Palette {
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

/// The darker ones of the terminal's sixteen.
pub(super) const SIXTEEN_LIGHT: Palette = Palette {
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

/// Of the fixed 256 those between dark and light.
pub(super) const FIXED: Palette = Palette {
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

/// Of the fixed 256 those for a dark ground.
pub(super) const FIXED_DARK: Palette = Palette {
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

/// Of the fixed 256 those for a light ground.
pub(super) const FIXED_LIGHT: Palette = Palette {
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

/// Red, green and blue between dark and light.
pub(super) const FREE: Palette = Palette {
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

/// Red, green and blue for a dark ground.
pub(super) const FREE_DARK: Palette = Palette {
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

/// Red, green and blue for a light ground.
pub(super) const FREE_LIGHT: Palette = Palette {
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
