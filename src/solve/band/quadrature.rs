//! Adaptive Gauss-Kronrod quadrature of all responses at once.

use std::sync::atomic::AtomicBool;

use super::{Sample, samples};
use crate::model::Checked;
use crate::solve::Cancelled;

/// Relative tolerance of every mean.
const TOLERANCE: f64 = 1e-8;

/// Most frequencies.
const MOST_FREQUENCIES: usize = 30_000;

/// Frequencies per piece.
const NODES: usize = 15;

/// The non-negative nodes of the rule on [-1, 1], with the weights of the 15-point rule and of the 7-point rule (`None`
/// if it has no such node). Source: QUADPACK (Piessens et al. 1983), routine QK15.
const RULE: [(f64, f64, f64); 8] = [
    (0.0, 0.209_482_141_084_727_83, 0.417_959_183_673_469_4),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9, 0.0),
    (
        0.405_845_151_377_397_2,
        0.190_350_578_064_785_4,
        0.381_830_050_505_118_9,
    ),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (
        0.741_531_185_599_394_4,
        0.140_653_259_715_525_92,
        0.279_705_391_489_276_67,
    ),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_18, 0.0),
    (
        0.949_107_912_342_758_5,
        0.063_092_092_629_978_55,
        0.129_484_966_168_869_7,
    ),
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224, 0.0),
];

/// The integral over a band.
#[derive(Debug)]
pub(super) struct Integral {
    /// The mean of each response's power.
    pub(super) means: Vec<f64>,
    /// All solved samples, by ascending frequency.
    pub(super) samples: Vec<Sample>,
    /// The frequencies (Hz) of the means with their weights, whose sum is 1.
    pub(super) rule: Vec<[f64; 2]>,
}

/// A piece of the band with the integrals of all responses over it.
#[derive(Debug)]
struct Piece {
    from: f64,
    to: f64,
    estimates: Vec<Estimate>,
}

/// A piece to be integrated.
#[derive(Debug)]
struct Wanted {
    from: f64,
    to: f64,
    /// The result for the piece of which it is a half, if any.
    whole: Option<Vec<Estimate>>,
}

/// The integral of a response over a piece.
#[derive(Debug, Clone, Copy)]
struct Estimate {
    value: f64,
    /// The difference of the two rules.
    difference: f64,
    /// The estimated error of the value; 0 if only rounding is left.
    error: f64,
}

/// The means over the pieces between `cuts` (Hz, ascending). A response with a pole has no finite mean and does not
/// delay convergence.
pub(super) fn integrate(
    model: &Checked,
    cuts: &[f64],
    poles: &[Option<f64>],
    cancel: &AtomicBool,
) -> Result<Integral, Cancelled> {
    let mut solved: Vec<Sample> = Vec::new();
    let mut pieces: Vec<Piece> = Vec::new();
    let mut wanted: Vec<Wanted> = cuts.windows(2).map(Wanted::first).collect();
    loop {
        let nodes: Vec<f64> = wanted.iter().flat_map(Wanted::nodes).collect();
        let values = samples(model, &nodes, cancel)?;
        let new = wanted.iter().zip(values.chunks(NODES));
        pieces.extend(new.map(|(wanted, values)| wanted.integrated(values)));
        solved.extend(values);
        let (coarse, fine): (Vec<Piece>, Vec<Piece>) = split(pieces, poles);
        if coarse.is_empty() || solved.len() + 2 * NODES * coarse.len() > MOST_FREQUENCIES {
            pieces = coarse.into_iter().chain(fine).collect();
            break;
        }
        pieces = fine;
        wanted = coarse.iter().flat_map(Wanted::halves).collect();
    }
    solved.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
    let width: f64 = pieces.iter().map(|piece| piece.to - piece.from).sum();
    let mean = |response: usize| total(&pieces, response, |estimate| estimate.value) / width;
    Ok(Integral {
        rule: pieces.iter().flat_map(|piece| piece.rule(width)).collect(),
        means: (0..poles.len()).map(mean).collect(),
        samples: solved,
    })
}

impl Piece {
    /// The frequencies of the 15-point rule with their weights, of a band of a width, Hz.
    fn rule(&self, width: f64) -> [[f64; 2]; NODES] {
        let ends = Wanted::first(&[self.from, self.to]);
        let nodes = ends.nodes();
        let weight = |index: usize| RULE[index.div_ceil(2)].1 * ends.half_width() / width;
        std::array::from_fn(|index| [nodes[index], weight(index)])
    }
}

fn total(pieces: &[Piece], response: usize, of: impl Fn(&Estimate) -> f64) -> f64 {
    pieces
        .iter()
        .map(|piece| of(&piece.estimates[response]))
        .sum()
}

/// The pieces to halve, and the others.
fn split(pieces: Vec<Piece>, poles: &[Option<f64>]) -> (Vec<Piece>, Vec<Piece>) {
    let share = |response: usize| {
        let allowed = TOLERANCE * total(&pieces, response, |estimate| estimate.value);
        let left = total(&pieces, response, |estimate| estimate.error);
        let waits = poles[response].is_none() && left > allowed;
        // While the total error is too large, some piece exceeds its share.
        waits.then(|| allowed / pieces.len() as f64)
    };
    let shares: Vec<Option<f64>> = (0..poles.len()).map(share).collect();
    pieces.into_iter().partition(|piece| {
        let mut both = piece.estimates.iter().zip(&shares);
        both.any(|(estimate, share)| share.is_some_and(|share| estimate.error > share))
    })
}

impl Wanted {
    fn first(ends: &[f64]) -> Self {
        Self {
            from: ends[0],
            to: ends[1],
            whole: None,
        }
    }

    fn halves(whole: &Piece) -> [Self; 2] {
        let middle = 0.5 * (whole.from + whole.to);
        [(whole.from, middle), (middle, whole.to)].map(|(from, to)| Self {
            from,
            to,
            whole: Some(whole.estimates.clone()),
        })
    }

    fn half_width(&self) -> f64 {
        0.5 * (self.to - self.from)
    }

    /// The frequencies of the rule: the middle, then those at both sides of it.
    fn nodes(&self) -> [f64; NODES] {
        let middle = 0.5 * (self.from + self.to);
        std::array::from_fn(|index| {
            let side = if index % 2 == 0 { 1.0 } else { -1.0 };
            middle + side * RULE[index.div_ceil(2)].0 * self.half_width()
        })
    }

    /// The integrals of all responses, from their powers at the nodes.
    fn integrated(&self, values: &[Sample]) -> Piece {
        let count = values.first().map_or(0, |sample| sample.powers.len());
        let estimate = |response: usize| {
            let powers: [f64; NODES] = std::array::from_fn(|node| values[node].powers[response]);
            let found = Estimate::new(&powers, self.half_width());
            let whole = self.whole.as_ref().map(|whole| whole[response]);
            found.settled_beside(whole)
        };
        Piece {
            from: self.from,
            to: self.to,
            estimates: (0..count).map(estimate).collect(),
        }
    }
}

impl Estimate {
    /// The integral by 15 points, with the error of QUADPACK's QK15.
    fn new(powers: &[f64; NODES], half_width: f64) -> Self {
        let sum = |weight: fn(&(f64, f64, f64)) -> f64, of: &dyn Fn(f64) -> f64| -> f64 {
            let terms = powers.iter().enumerate();
            let terms = terms.map(|(index, power)| weight(&RULE[index.div_ceil(2)]) * of(*power));
            half_width * terms.sum::<f64>()
        };
        let value = sum(|rule| rule.1, &|power| power);
        let difference = (value - sum(|rule| rule.2, &|power| power)).abs();
        let mean = value / (2.0 * half_width);
        let variation = sum(|rule| rule.1, &|power| (power - mean).abs());
        let error = if variation > 0.0 {
            variation * (200.0 * difference / variation).powf(1.5).min(1.0)
        } else {
            difference
        };
        Self {
            value,
            difference,
            error,
        }
    }

    /// Halving reduces a smooth response's difference many times; if not, the rest is rounding.
    fn settled_beside(self, whole: Option<Self>) -> Self {
        let stays = whole.is_some_and(|whole| self.difference > 0.125 * whole.difference);
        Self {
            error: if stays { 0.0 } else { self.error },
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_are_exact_for_polynomials_of_their_degree() {
        // Closed form: int x^n over [-1, 1] is 2 / (n + 1) for even n; degrees 13 (Gauss) and 22 (Kronrod).
        let piece = Wanted::first(&[-1.0, 1.0]);
        for degree in (0..=22).step_by(2) {
            let powers = piece.nodes().map(|x| x.powi(degree));
            let found = Estimate::new(&powers, 1.0);
            let exact = 2.0 / f64::from(degree + 1);
            assert!((found.value - exact).abs() < 1e-15, "{degree}: {found:?}");
            assert_eq!(
                found.difference < 1e-15,
                degree <= 13,
                "{degree}: {found:?}"
            );
        }
    }
}
