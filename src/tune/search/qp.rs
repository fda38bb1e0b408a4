//! The step of a local search: minimum of a convex quadratic plus a sum of largest linear pieces, within bounds.
//!
//! minimise 1/2 d^T B d + the sum over terms of max (f + g^T d) over the pieces of the term, subject to l <= d <= u; in
//! epigraph form (a variable t for each term; Madsen, J. Inst. Math. Appl. 1975, 16, 321-328), by the interior-point method
//! of Clarabel (Goulart & Chen, 2024).

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::{DMatrix, DVector};

use super::types::Function;

/// The function to minimise.
pub(super) struct QuadraticProgram<'a> {
    /// B, positive definite.
    pub(super) hessian: &'a DMatrix<f64>,
    /// f and g of every piece of every term; all finite.
    pub(super) terms: &'a [Vec<Function>],
    /// l and u of every variable, l <= 0 <= u.
    pub(super) bounds: &'a [[f64; 2]],
}

/// The minimum.
#[derive(Debug, Clone)]
pub(super) struct Step {
    /// d.
    pub(super) d: DVector<f64>,
    /// The weight of each piece of each term there: not negative, with the sum 1 in every term.
    pub(super) weights: Vec<Vec<f64>>,
    /// The decrease from d = 0; not negative.
    pub(super) decrease: f64,
}

impl QuadraticProgram<'_> {
    /// The step; `None` if the arithmetic fails.
    ///
    /// The accuracy of the interior-point method is relative to the size of the bounds. If the step is much shorter, it
    /// is computed again within narrower bounds, so that a step of any length is accurate.
    pub(super) fn solve(&self) -> Option<Step> {
        const SHORT: f64 = 0.01;
        const ROOM: f64 = 20.0;
        /// If rounding leaves no step at all.
        const LOST: f64 = 1e-3;
        const TIMES: usize = 5;
        let mut radius = self.reach();
        let mut step = self.within(radius)?;
        for _ in 0..TIMES {
            let length = step.d.amax();
            if length > SHORT * radius {
                break;
            }
            radius = if length > 0.0 {
                ROOM * length
            } else {
                LOST * radius
            };
            match self.within(radius) {
                Some(closer) if closer.decrease >= step.decrease => step = closer,
                _ => break,
            }
        }
        Some(step)
    }

    /// The longest step that the bounds allow, in its largest coordinate.
    fn reach(&self) -> f64 {
        let ends = self.bounds.iter().flatten();
        ends.fold(0.0, |reach, end| reach.max(end.abs()))
    }

    /// The step with coordinates of at most `radius`. All numbers are divided by the radius and by the steepest slope,
    /// so that the solver works with numbers near 1.
    fn within(&self, radius: f64) -> Option<Step> {
        let bounds: Vec<[f64; 2]> = self
            .bounds
            .iter()
            .map(|&[lower, upper]| [lower.max(-radius), upper.min(radius)])
            .collect();
        let pieces = self.pieces(&bounds);
        let slopes = pieces.iter().flat_map(|piece| &piece.function.gradient);
        let steepest = slopes.fold(0.0_f64, |most, slope| most.max(slope.abs()));
        if steepest == 0.0 || radius == 0.0 {
            return Some(self.still());
        }
        let scaled = Scaled {
            radius,
            steepest,
            bounds: &bounds,
            pieces: &pieces,
            terms: self.terms.len(),
            hessian: self.hessian,
        };
        let (mut d, multipliers) = scaled.solve()?;
        let mut weights: Vec<Vec<f64>> = self.terms.iter().map(|t| vec![0.0; t.len()]).collect();
        for (piece, multiplier) in pieces.iter().zip(multipliers) {
            weights[piece.term][piece.index] = multiplier.max(0.0);
        }
        for weights in &mut weights {
            let sum: f64 = weights.iter().sum();
            if sum > 0.0 {
                for weight in weights {
                    *weight /= sum;
                }
            }
        }
        let mut decrease = self.decrease(&d);
        if decrease.is_nan() || decrease < 0.0 {
            // Rounding, if no step is better than none.
            d.fill(0.0);
            decrease = 0.0;
        }
        Some(Step {
            d,
            weights,
            decrease,
        })
    }

    /// No step at all.
    fn still(&self) -> Step {
        let of = |term: &Vec<Function>| {
            let largest = largest(term);
            let mut weights = vec![0.0; term.len()];
            if let Some(index) = term.iter().position(|f| f.value == largest) {
                weights[index] = 1.0;
            }
            weights
        };
        Step {
            d: DVector::zeros(self.bounds.len()),
            weights: self.terms.iter().map(of).collect(),
            decrease: 0.0,
        }
    }

    /// The decrease of the model from 0 to d.
    fn decrease(&self, d: &DVector<f64>) -> f64 {
        let linear: f64 = self
            .terms
            .iter()
            .filter(|term| !term.is_empty())
            .map(|term| {
                let before = largest(term);
                // The difference of each piece first: it keeps its digits for a short step.
                let changes = term
                    .iter()
                    .map(|f| (f.value - before) + slope_along(f, d.as_slice()));
                -changes.fold(f64::NEG_INFINITY, f64::max)
            })
            .sum();
        linear - 0.5 * d.dot(&(self.hessian * d))
    }

    /// The pieces that can be the largest of their term anywhere within the bounds.
    fn pieces(&self, bounds: &[[f64; 2]]) -> Vec<Piece<'_>> {
        let mut pieces = Vec::new();
        for (term, functions) in self.terms.iter().enumerate() {
            let reaches: Vec<[f64; 2]> = functions.iter().map(|f| range(f, bounds)).collect();
            let floor = reaches
                .iter()
                .fold(f64::NEG_INFINITY, |floor, reach| floor.max(reach[0]));
            let before = largest(functions);
            for (index, (function, reach)) in functions.iter().zip(reaches).enumerate() {
                if reach[1] >= floor {
                    pieces.push(Piece {
                        term,
                        index,
                        function,
                        below: function.value - before,
                    });
                }
            }
        }
        pieces
    }
}

/// The largest value of a term.
fn largest(term: &[Function]) -> f64 {
    term.iter()
        .fold(f64::NEG_INFINITY, |most, f| most.max(f.value))
}

/// The change of a linear function along a step.
pub(super) fn slope_along(function: &Function, d: &[f64]) -> f64 {
    function.gradient.iter().zip(d).map(|(g, d)| g * d).sum()
}

/// The smallest and the largest value of a linear piece within bounds.
fn range(function: &Function, bounds: &[[f64; 2]]) -> [f64; 2] {
    let mut range = [function.value; 2];
    for (slope, &[lower, upper]) in function.gradient.iter().zip(bounds) {
        range[0] += (slope * lower).min(slope * upper);
        range[1] += (slope * lower).max(slope * upper);
    }
    range
}

/// An active linear piece.
struct Piece<'a> {
    term: usize,
    index: usize,
    function: &'a Function,
    /// Its value minus the largest of its term; not positive.
    below: f64,
}

/// The same problem in numbers near 1: d = radius e, functions in units of radius * steepest.
struct Scaled<'a> {
    radius: f64,
    steepest: f64,
    bounds: &'a [[f64; 2]],
    pieces: &'a [Piece<'a>],
    terms: usize,
    hessian: &'a DMatrix<f64>,
}

impl Scaled<'_> {
    /// d within its bounds, and the multiplier of every piece.
    fn solve(&self) -> Option<(DVector<f64>, Vec<f64>)> {
        let variables = self.bounds.len();
        let columns = variables + self.terms;
        let rows = self.pieces.len() + 2 * variables;
        let mut matrix = DMatrix::zeros(rows, columns);
        let mut right = vec![0.0; rows];
        for (row, piece) in self.pieces.iter().enumerate() {
            for (column, slope) in piece.function.gradient.iter().enumerate() {
                matrix[(row, column)] = slope / self.steepest;
            }
            matrix[(row, variables + piece.term)] = -1.0;
            right[row] = -piece.below / self.steepest / self.radius;
        }
        for (variable, [lower, upper]) in self.bounds.iter().enumerate() {
            let row = self.pieces.len() + 2 * variable;
            matrix[(row, variable)] = -1.0;
            right[row] = -lower / self.radius;
            matrix[(row + 1, variable)] = 1.0;
            right[row + 1] = upper / self.radius;
        }
        let mut quadratic = DMatrix::zeros(columns, columns);
        for column in 0..variables {
            for row in 0..=column {
                quadratic[(row, column)] =
                    self.hessian[(row, column)] * (self.radius / self.steepest);
            }
        }
        let mut linear = vec![0.0; columns];
        for piece in self.pieces {
            linear[variables + piece.term] = 1.0;
        }
        let (solution, multipliers) = interior_point(&quadratic, &linear, &matrix, &right)?;
        let inside = self.bounds.iter().zip(&solution);
        let d = inside.map(|(&[lower, upper], e)| (e * self.radius).clamp(lower, upper));
        let d = DVector::from_iterator(variables, d);
        Some((d, multipliers[..self.pieces.len()].to_vec()))
    }
}

/// Minimises 1/2 x^T P x + q^T x (P by its upper triangle) subject to A x <= b: x, and the multipliers of the rows.
fn interior_point(
    quadratic: &DMatrix<f64>,
    linear: &[f64],
    matrix: &DMatrix<f64>,
    right: &[f64],
) -> Option<(Vec<f64>, Vec<f64>)> {
    const TOLERANCE: f64 = 1e-12;
    let settings = DefaultSettings {
        verbose: false,
        tol_gap_abs: TOLERANCE,
        tol_gap_rel: TOLERANCE,
        tol_feas: TOLERANCE,
        // Rows are of the same size already, and every column is bounded.
        presolve_enable: false,
        max_threads: 1,
        ..DefaultSettings::default()
    };
    let cones = [SupportedConeT::NonnegativeConeT(right.len())];
    let mut solver = DefaultSolver::new(
        &sparse(quadratic),
        linear,
        &sparse(matrix),
        right,
        &cones,
        settings,
    )
    .ok()?;
    solver.solve();
    let solution = solver.solution;
    // It often cannot reach the last digits of its tolerances; its result is still good.
    let usable = matches!(
        solution.status,
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress
    );
    let finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
    (usable && finite(&solution.x) && finite(&solution.z)).then_some((solution.x, solution.z))
}

/// Columns of the non-zero entries.
fn sparse(matrix: &DMatrix<f64>) -> CscMatrix<f64> {
    let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for column in matrix.column_iter() {
        for (row, &value) in column.iter().enumerate() {
            if value != 0.0 {
                rows.push(row);
                values.push(value);
            }
        }
        starts.push(values.len());
    }
    CscMatrix::new(matrix.nrows(), matrix.ncols(), starts, rows, values)
}
