//! The value of an objective.

/// From and to, Hz.
pub(super) type Band = [f64; 2];

/// The value of an objective for one model.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::tune) struct ObjectiveValue {
    /// In the figure's unit.
    pub(in crate::tune) figure: f64,
    /// Its frequencies, Hz: the highest peak, the ends of the widest band, the anti-resonance.
    pub(in crate::tune) places: Vec<f64>,
}
