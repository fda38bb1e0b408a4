//! The extrema of curves between their points, refined together.
//!
//! Each extremum is refined by parabolas through 1/|H|^2 (a minimum: |H|^2), which is a parabola next to an isolated mode
//! (a zero), with golden-section steps if they do not help, following Brent, Algorithms for Minimization without
//! Derivatives, 1973, chapter 5. All extrema take each step together, so that one sweep solves it.
//!
//! Two searches are of another kind. `peaks` does not need extrema but a grid: three points near each of them, for a fit
//! of the complex response, and none on an undamped mode. `sensitivity` differentiates the response at an extremum, and
//! the series for that gives its position, too.

use super::Cancelled;

/// A point of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Point {
    /// Hz.
    pub(crate) frequency: f64,
    /// |H|, its square, or an energy.
    pub(crate) size: f64,
}

/// The kind of an extremum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Turn {
    /// A peak.
    Maximum,
    /// An anti-resonance, or another minimum.
    Minimum,
}

impl Turn {
    /// The extremum of three sizes at the middle one, if there is one.
    pub(crate) fn of([left, middle, right]: [f64; 3]) -> Option<Self> {
        if left < middle && middle >= right {
            Some(Self::Maximum)
        } else if left > middle && middle <= right {
            Some(Self::Minimum)
        } else {
            None
        }
    }
}

/// Refines extrema until each is known. `sizes` solves frequencies (Hz), each with the index of its bracket.
///
/// # Errors
/// Those of `sizes`.
pub(crate) fn refined(
    mut brackets: Vec<Bracket>,
    sizes: impl Fn(&[(usize, f64)]) -> Result<Vec<f64>, Cancelled>,
) -> Result<Vec<Point>, Cancelled> {
    const MOST_ROUNDS: usize = 60;
    for round in 0..MOST_ROUNDS {
        let wanted: Vec<(usize, f64)> = brackets
            .iter_mut()
            .enumerate()
            .filter_map(|(index, bracket)| Some((index, bracket.next(round)?)))
            .collect();
        if wanted.is_empty() {
            break;
        }
        for ((index, frequency), size) in wanted.iter().zip(sizes(&wanted)?) {
            brackets[*index].take(Point {
                frequency: *frequency,
                size,
            });
        }
    }
    Ok(brackets.into_iter().map(|bracket| bracket.middle).collect())
}

/// Three points; the middle one is the best.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bracket {
    left: Point,
    middle: Point,
    right: Point,
    turn: Turn,
    exponent: i32,
    settled: bool,
}

impl Bracket {
    /// An extremum between three points. `exponent` makes a size a square: 2 for |H|, 1 for a square or an energy.
    pub(crate) fn new([left, middle, right]: [Point; 3], turn: Turn, exponent: i32) -> Self {
        Self {
            left,
            middle,
            right,
            turn,
            exponent,
            settled: false,
        }
    }

    /// Makes every extremum a minimum, and next to a mode or a zero a parabola.
    fn depth(&self, size: f64) -> f64 {
        match self.turn {
            Turn::Maximum => size.powi(-self.exponent),
            Turn::Minimum => size.powi(self.exponent),
        }
    }

    /// The next frequency; `None` once the extremum is known.
    fn next(&mut self, round: usize) -> Option<f64> {
        /// In half-widths: 1e-14 of the height.
        const NEAR: f64 = 1e-7;
        const FINEST: f64 = 4.0 * f64::EPSILON;
        /// After this number of steps, one divides the longer side, independently of the parabola.
        const CUT: usize = 4;
        if self.settled {
            return None;
        }
        let sides = [self.left, self.right].map(|side| side.frequency - self.middle.frequency);
        let bottom = self.depth(self.middle.size);
        let slopes = [self.left, self.right].map(|side| {
            (self.depth(side.size) - bottom) / (side.frequency - self.middle.frequency)
        });
        let curvature = (slopes[1] - slopes[0]) / (sides[1] - sides[0]);
        let slope = slopes[0] - curvature * sides[0];
        let shift = -0.5 * slope / curvature;
        let half_width = (bottom / curvature).sqrt();
        let nearest = (NEAR * half_width).max(FINEST * self.middle.frequency);
        let is_inside = shift > sides[0] && shift < sides[1];
        self.settled = sides[1] - sides[0] <= 4.0 * FINEST * self.middle.frequency
            || (is_inside && shift.abs() <= nearest);
        if self.settled {
            return None;
        }
        let longer = if -sides[0] > sides[1] {
            sides[0]
        } else {
            sides[1]
        };
        let step = if is_inside && round % CUT != CUT - 1 {
            shift
        } else {
            0.381_966 * longer
        };
        Some(self.middle.frequency + step)
    }

    fn take(&mut self, point: Point) {
        let (new, old) = (self.depth(point.size), self.depth(self.middle.size));
        let is_left = point.frequency < self.middle.frequency;
        if point.frequency == self.middle.frequency || !new.is_finite() {
            self.settled = true;
        } else if new <= old {
            if is_left {
                self.right = self.middle;
            } else {
                self.left = self.middle;
            }
            self.middle = point;
        } else if is_left {
            self.left = point;
        } else {
            self.right = point;
        }
    }
}
