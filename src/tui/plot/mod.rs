//! Frequency-response charts for the terminal, drawn with ratatui's canvas and its marker grids.
//!
//! The axes are our own: those of ratatui's `Chart` are not logarithmic and space labels evenly instead of
//! at round values, and its lines draw zero and non-finite samples as spikes. [`Chart`] here keeps three
//! promises:
//!
//! - A label, a tick, the cursor and a sample of the same value are in the same column or row.
//! - Every dot column shows all rows that its samples cover, so a resonance narrower than a column keeps its peak.
//! - A sample that cannot be drawn (non-finite, or zero on a logarithmic axis) leaves a gap.
//!
//! From a value to the screen: [`Level`] turns a magnitude into an axis value, [`Axis`] an axis value into a fraction of
//! its length, `Ruler` a fraction into a dot and a cell, `StrokePainter` a line into `Dots`, and a
//! [`Canvas`](ratatui::widgets::canvas::Canvas) the dots into characters.

mod axis;
mod cell_ruler;
mod cells;
mod chart;
mod curve;
mod dots;
mod frame;
mod glyphs;
mod layout;
mod legend;
mod level;
mod nyquist;
mod render;
mod stacked;
mod stroke;
mod ticks;
mod trace;

#[cfg(test)]
pub use axis::Notation;
pub use axis::{Axis, Scale};
pub use cell_ruler::{CellRuler, dotted};
pub use chart::{AxisMark, Chart, ChartStyles, Legend, Marks, Spot};
pub use curve::{Curve, LineStyle};
pub use glyphs::Glyphs;
pub use level::Level;
pub use nyquist::{clipped, equal_spans, nyquist_axes};
pub use stacked::StackedCharts;
pub use ticks::AxisTick;

#[cfg(test)]
mod tests;
