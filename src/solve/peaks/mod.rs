//! Frequency grids on which no peak and no anti-resonance is skipped, and tables of peaks.
//!
//! [`resolved`] adds the points for the half-power band of every mode (`grid`) to a solved base grid and then, pass by
//! pass, the points for every peak and dip of every response (`resolve`, by the three-point fit of `fit`). [`peaks`]
//! makes the table from such a curve (`table`).
//!
//! A mode of angular frequency omega has the centre Re omega / 2 pi and the half-width Im omega / 2 pi: alone it makes
//! |H| proportional to `1 / |f - centre - i half-width|`, which is 3 dB down at centre +- half-width (Ewins, Modal
//! Testing, 2000, Sec. 4.2). A zero of a response, its anti-resonance, has both as well.

mod fit;
mod grid;
mod missing_points;
mod resolve;
mod table;

pub use resolve::{points, refined, resolved};
pub use table::{Peak, peaks};

use super::modes::{Mode, ModeKind};

/// A damping ratio below which a mode or a zero counts as undamped: it is rounding.
const UNDAMPED: f64 = 1e-12;

/// The distance of points from an undamped mode or zero, relative to its frequency.
const NEAREST: f64 = 1e-9;

/// Centre of a mode's half-power band, Hz.
pub(super) fn centre(mode: &Mode) -> f64 {
    mode.omega.re.abs() / std::f64::consts::TAU
}

/// Half the width of a mode's half-power band, Hz; 0 for an undamped mode.
pub(super) fn half_width(mode: &Mode) -> f64 {
    if is_pole(mode) {
        0.0
    } else {
        mode.omega.im.abs() / std::f64::consts::TAU
    }
}

/// True for an oscillating mode without damping: at its frequency responses are infinite.
pub(super) fn is_pole(mode: &Mode) -> bool {
    mode.kind == ModeKind::Oscillating && mode.omega.im.abs() <= UNDAMPED * mode.omega.norm()
}
