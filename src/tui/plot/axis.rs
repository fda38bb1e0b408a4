//! Axes: from a value to a fraction of the axis, and from there to dots and cells.

/// The scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences take equal lengths.
    Linear,
    /// Equal ratios take equal lengths; positive values only.
    Log,
}

/// How labels are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// `0.5`, `50`, `2000`; very large and very small values as powers.
    Plain,
    /// `1e-6`, `2e3`.
    Power,
    /// `-90`, `360`: like plain, at multiples of 15, 30, 45, 90, 180 and 360.
    Degrees,
}

/// An axis: scale, bounds, label notation and unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(super) scale: Scale,
    bounds: [f64; 2],
    /// The bounds as values (linear) or decimal logarithms (log).
    span: [f64; 2],
    pub(super) notation: Notation,
    pub(super) unit: String,
}

impl Axis {
    /// An axis from `bounds[0]` to `bounds[1]`, both in `unit`, with plain labels.
    ///
    /// Empty or invalid bounds are widened or replaced, so that every axis can be drawn.
    pub fn new(scale: Scale, bounds: [f64; 2], unit: impl Into<String>) -> Self {
        let bounds = drawable(scale, bounds);
        Self {
            scale,
            bounds,
            span: bounds.map(|bound| coordinate(scale, bound)),
            notation: Notation::Plain,
            unit: unit.into(),
        }
    }

    /// The same axis with its labels written in `notation`.
    #[must_use]
    pub fn with_notation(mut self, notation: Notation) -> Self {
        self.notation = notation;
        self
    }

    /// The lower and the upper bound, in the axis's unit.
    pub fn bounds(&self) -> [f64; 2] {
        self.bounds
    }

    /// The unit, with the quantity name before it if there is one.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// The position of `value`: 0 at the lower bound, 1 at the upper; not finite where the axis cannot show it.
    pub fn fraction(&self, value: f64) -> f64 {
        let [low, high] = self.span;
        (coordinate(self.scale, value) - low) / (high - low)
    }

    /// The value at a fraction of the axis, clamped to the bounds; the inverse of [`Axis::fraction`].
    pub fn value(&self, fraction: f64) -> f64 {
        let [low, high] = self.span;
        let coordinate = low + fraction * (high - low);
        let value = match self.scale {
            Scale::Linear => coordinate,
            Scale::Log => 10_f64.powf(coordinate),
        };
        value.clamp(self.bounds[0], self.bounds[1])
    }

    /// Whether `value` lies within the bounds.
    pub(super) fn contains(&self, value: f64) -> bool {
        on_axis(self.fraction(value))
    }
}

fn coordinate(scale: Scale, value: f64) -> f64 {
    match scale {
        Scale::Linear => value,
        Scale::Log => value.log10(),
    }
}

/// Whether `fraction` is on the axis; the logarithm of a bound may miss 0 or 1 by a rounding error.
fn on_axis(fraction: f64) -> bool {
    (-1e-9..=1.0 + 1e-9).contains(&fraction)
}

/// Bounds in ascending order with a positive span.
fn drawable(scale: Scale, [first, second]: [f64; 2]) -> [f64; 2] {
    let (low, high) = (first.min(second), first.max(second));
    let spans = coordinate(scale, high) - coordinate(scale, low);
    if spans.is_finite() && spans > 0.0 {
        return [low, high];
    }
    match scale {
        Scale::Log if high.is_normal() && high > 0.0 => [high / 10.0, high * 10.0],
        Scale::Linear if high.is_finite() && high == low => {
            let margin = high.abs().max(1.0) / 2.0;
            [high - margin, high + margin]
        }
        _ => [1.0, 10.0],
    }
}

/// The direction of an axis on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    /// The lower bound is at the left.
    Right,
    /// The lower bound is at the bottom.
    Up,
}

/// The cells along an axis and the dots in each of them, counted from the left or from the top.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ruler {
    pub(super) direction: Direction,
    pub(super) cells: u16,
    pub(super) dots_per_cell: u16,
}

impl Ruler {
    /// The number of dots along the axis.
    pub(super) fn dots(self) -> u16 {
        self.cells.saturating_mul(self.dots_per_cell)
    }

    /// The position of `fraction` in dots: the bounds are at the centres of the first and the last dot.
    pub(super) fn dot(self, fraction: f64) -> f64 {
        let last = f64::from(self.dots().saturating_sub(1));
        match self.direction {
            Direction::Right => fraction * last,
            Direction::Up => (1.0 - fraction) * last,
        }
    }

    /// The fraction in the middle of a cell, for an axis to the right.
    pub(super) fn middle(self, cell: u16) -> f64 {
        let last = f64::from(self.dots().saturating_sub(1).max(1));
        let per_cell = f64::from(self.dots_per_cell);
        (f64::from(cell) * per_cell + (per_cell - 1.0) / 2.0) / last
    }

    /// The cell that contains `fraction`, if it is on the axis.
    pub(super) fn cell(self, fraction: f64) -> Option<u16> {
        (on_axis(fraction) && self.cells > 0)
            .then(|| self.dot(fraction).round() as u16 / self.dots_per_cell)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degenerate_bounds_are_widened() {
        let bounds = |scale, bounds| Axis::new(scale, bounds, "").bounds();
        assert_eq!(bounds(Scale::Linear, [5.0, 5.0]), [2.5, 7.5]);
        assert_eq!(bounds(Scale::Linear, [9.0, 1.0]), [1.0, 9.0]);
        assert_eq!(
            bounds(Scale::Linear, [f64::NAN, f64::INFINITY]),
            [1.0, 10.0]
        );
        assert_eq!(bounds(Scale::Log, [10.0, 10.0]), [1.0, 100.0]);
        assert_eq!(bounds(Scale::Log, [0.0, 10.0]), [1.0, 100.0]);
        assert_eq!(bounds(Scale::Log, [-3.0, -1.0]), [1.0, 10.0]);
    }

    #[test]
    fn the_middle_of_a_cell_is_in_it() {
        for dots_per_cell in [1, 2] {
            let ruler = Ruler {
                direction: Direction::Right,
                cells: 37,
                dots_per_cell,
            };
            for scale in [Scale::Linear, Scale::Log] {
                let axis = Axis::new(scale, [2.0, 700.0], "Hz");
                for cell in 0..37 {
                    let value = axis.value(ruler.middle(cell));
                    assert_eq!(ruler.cell(axis.fraction(value)), Some(cell));
                }
            }
        }
    }

    #[test]
    fn a_value_outside_has_no_cell() {
        let ruler = Ruler {
            direction: Direction::Up,
            cells: 10,
            dots_per_cell: 4,
        };
        assert_eq!(ruler.cell(0.0), Some(9));
        assert_eq!(ruler.cell(1.0), Some(0));
        assert_eq!(ruler.cell(1.1), None);
        assert_eq!(ruler.cell(f64::NAN), None);
    }
}
