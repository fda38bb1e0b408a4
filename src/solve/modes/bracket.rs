//! Root finding for a real function between two points, one value at a time.

/// A root between two points at which the function has different signs.
///
/// Chandrupatla, Adv. Eng. Softw. 28 (1997) 145-149: inverse quadratic steps where they are safe, halving elsewhere.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bracket {
    /// The newest point, with its value.
    a: [f64; 2],
    /// The other side of the root.
    b: [f64; 2],
    /// The next point to evaluate.
    next: f64,
    is_narrow: bool,
}

impl Bracket {
    /// Between two points, each with its value.
    pub(super) fn new(low: [f64; 2], high: [f64; 2]) -> Self {
        Self {
            a: high,
            b: low,
            next: 0.5 * (low[0] + high[0]),
            is_narrow: false,
        }
    }

    /// The next point to evaluate; `None` if the bracket is as narrow as rounding.
    pub(super) fn next(&self) -> Option<f64> {
        (!self.is_narrow).then_some(self.next)
    }

    /// The best point so far.
    pub(super) fn root(&self) -> f64 {
        let [a, b] = [self.a, self.b];
        if a[1].abs() < b[1].abs() { a[0] } else { b[0] }
    }

    /// Takes the value of the function at the point [`Self::next`] asked for.
    pub(super) fn insert(&mut self, value: f64) {
        let differ = |x: f64, y: f64| (x < 0.0) != (y < 0.0);
        let c;
        if differ(value, self.a[1]) {
            (c, self.b) = (self.b, self.a);
        } else {
            c = self.a;
        }
        self.a = [self.next, value];
        let ([a, fa], [b, fb], [c, fc]) = (self.a, self.b, c);
        let tolerance = 2.0 * f64::EPSILON * self.root().abs();
        let least = tolerance / (b - a).abs();
        self.is_narrow = least > 0.5 || fa == 0.0;
        let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        let share = if phi * phi < xi && (1.0 - phi).powi(2) < 1.0 - xi {
            fa / (fb - fa) * (fc / (fb - fc))
                + (c - a) / (b - a) * (fa / (fc - fa)) * (fb / (fc - fb))
        } else {
            0.5
        };
        if !self.is_narrow {
            self.next = a + share.clamp(least, 1.0 - least) * (b - a);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Expected: closed form, x^3 = 2, and a root where the function is flat.
    #[test]
    fn roots_are_found_to_rounding() {
        for (f, low, high, expected) in [
            (
                (|x: f64| x * x * x - 2.0) as fn(f64) -> f64,
                0.5,
                9.0,
                2.0_f64.cbrt(),
            ),
            (|x: f64| (x - 1.0).powi(3), 0.2, 5.0, 1.0),
        ] {
            let mut bracket = Bracket::new([low, f(low)], [high, f(high)]);
            let mut steps = 0;
            while let Some(x) = bracket.next() {
                bracket.insert(f(x));
                steps += 1;
            }
            assert!(steps < 120, "{steps}");
            assert!((bracket.root() - expected).abs() < 1e-5 * expected);
            assert!(f(bracket.root()).abs() < 4e-15);
        }
    }
}
