//! A root of a real function between two points.

/// The root of f between two points where its signs differ, to rounding; `None` where they do not differ.
///
/// Chandrupatla, Adv. Eng. Softw. 28 (1997) 145-149: inverse quadratic steps where they are safe, halving elsewhere.
pub(super) fn bracketed(low: f64, high: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    const MOST_STEPS: usize = 100;
    // The newest point a, the other side of the bracket b, the point before c.
    let (mut a, mut b) = (high, low);
    let (mut fa, mut fb) = (f(a), f(b));
    let differ = |x: f64, y: f64| (x < 0.0) != (y < 0.0);
    if !fa.is_finite() || !fb.is_finite() || !differ(fa, fb) {
        return None;
    }
    let mut share = 0.5;
    for _ in 0..MOST_STEPS {
        let x = a + share * (b - a);
        let fx = f(x);
        let (c, fc);
        if differ(fx, fa) {
            (c, fc) = (b, fb);
            (b, fb) = (a, fa);
        } else {
            (c, fc) = (a, fa);
        }
        (a, fa) = (x, fx);
        let best = if fa.abs() < fb.abs() { a } else { b };
        let tolerance = 2.0 * f64::EPSILON * best.abs();
        let least = tolerance / (b - a).abs();
        if least > 0.5 || fa == 0.0 {
            return Some(best);
        }
        let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        share = if phi * phi < xi && (1.0 - phi).powi(2) < 1.0 - xi {
            fa / (fb - fa) * (fc / (fb - fc))
                + (c - a) / (b - a) * (fa / (fc - fa)) * (fb / (fc - fb))
        } else {
            0.5
        };
        share = share.clamp(least, 1.0 - least);
    }
    Some(if fa.abs() < fb.abs() { a } else { b })
}
