//! Least squares against certified values: NIST Statistical Reference Datasets, nonlinear regression
//! (<https://www.itl.nist.gov/div898/strd/nls/nls_main.shtml>).

use std::sync::atomic::AtomicBool;

use beamtune::solve::Cancelled;
use beamtune::tune::search::{Certainty, Control, Estimate, Fit, Place, Residuals, Stop, fit};
use nalgebra::{DMatrix, DVector};

use super::NEVER;

/// A model of data, with its certified values.
struct Data {
    name: &'static str,
    x: &'static [f64],
    y: &'static [f64],
    /// Value and derivatives by the parameters.
    model: fn(f64, &[f64]) -> (f64, Vec<f64>),
    bounds: Vec<[f64; 2]>,
    starts: Vec<Vec<f64>>,
    certified: Vec<f64>,
    deviations: Vec<f64>,
    sum: f64,
}

impl Data {
    fn unit(&self, real: &[f64]) -> Vec<f64> {
        let both = real.iter().zip(&self.bounds);
        both.map(|(b, [min, max])| (b - min) / (max - min))
            .collect()
    }

    fn real(&self, unit: &[f64]) -> Vec<f64> {
        let both = unit.iter().zip(&self.bounds);
        both.map(|(b, [min, max])| min + b * (max - min)).collect()
    }
}

impl Fit for Data {
    fn residuals(&self, unit: &[f64]) -> Result<Residuals, Cancelled> {
        let real = self.real(unit);
        let mut values = DVector::zeros(self.x.len());
        let mut jacobian = DMatrix::zeros(self.x.len(), unit.len());
        for (row, (&x, y)) in self.x.iter().zip(self.y).enumerate() {
            let (value, gradient) = (self.model)(x, &real);
            values[row] = value - y;
            for (column, [min, max]) in self.bounds.iter().enumerate() {
                jacobian[(row, column)] = gradient[column] * (max - min);
            }
        }
        Ok(Residuals { values, jacobian })
    }
}

fn fitted(problem: &dyn Fit, start: &[f64], budget: usize) -> Estimate {
    let control = Control {
        cancel: &NEVER,
        budget,
        tell: &mut |_| (),
    };
    fit(problem, start, control)
}

/// Lower level of difficulty; two parameters.
fn misra1a() -> Data {
    Data {
        name: "Misra1a",
        x: &[
            77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1,
            689.1, 760.0,
        ],
        y: &[
            10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40,
            75.47, 81.78,
        ],
        model: |x, b| {
            let decay = (-b[1] * x).exp();
            (b[0] * (1.0 - decay), vec![1.0 - decay, b[0] * x * decay])
        },
        bounds: vec![[100.0, 600.0], [1e-5, 1e-3]],
        starts: vec![vec![500.0, 0.0001], vec![250.0, 0.0005]],
        certified: vec![2.389_421_291_8e2, 5.501_564_318_1e-4],
        deviations: vec![2.707_007_524_1, 7.266_868_843_6e-6],
        sum: 1.245_513_889_4e-1,
    }
}

/// Higher level of difficulty; seven parameters.
fn thurber() -> Data {
    Data {
        name: "Thurber",
        x: &[
            -3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481, -2.363,
            -2.322, -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714, -0.566, -0.545,
            -0.400, -0.309, -0.109, -0.103, 0.010, 0.119, 0.377, 0.790, 0.963, 1.006, 1.115, 1.572,
            1.841, 2.047, 2.200,
        ],
        y: &[
            80.574, 84.248, 87.264, 87.195, 89.076, 89.608, 89.868, 90.101, 92.405, 95.854,
            100.696, 101.060, 401.672, 390.724, 567.534, 635.316, 733.054, 759.087, 894.206,
            990.785, 1090.109, 1080.914, 1122.643, 1178.351, 1260.531, 1273.514, 1288.339,
            1327.543, 1353.863, 1414.509, 1425.208, 1421.384, 1442.962, 1464.350, 1468.705,
            1447.894, 1457.628,
        ],
        model: |x, b| {
            let above = b[0] + x * (b[1] + x * (b[2] + x * b[3]));
            let below = 1.0 + x * (b[4] + x * (b[5] + x * b[6]));
            let powers = [1.0, x, x * x, x.powi(3)];
            let numerator = powers.iter().map(|p| p / below);
            let denominator = powers[1..].iter().map(|p| -p * above / below.powi(2));
            (above / below, numerator.chain(denominator).collect())
        },
        bounds: vec![
            [500.0, 2000.0],
            [500.0, 3000.0],
            [100.0, 1500.0],
            [10.0, 300.0],
            [0.1, 3.0],
            [0.1, 1.0],
            [0.01, 0.2],
        ],
        starts: vec![
            vec![1000.0, 1000.0, 400.0, 40.0, 0.7, 0.3, 0.03],
            vec![1300.0, 1500.0, 500.0, 75.0, 1.0, 0.4, 0.05],
        ],
        certified: vec![
            1.288_139_680_0e3,
            1.491_079_253_5e3,
            5.832_383_687_7e2,
            7.541_664_429_1e1,
            9.662_950_286_4e-1,
            3.979_728_579_7e-1,
            4.972_729_734_9e-2,
        ],
        deviations: vec![
            4.664_796_334_4,
            3.957_115_608_6e1,
            2.869_869_610_2e1,
            5.567_537_027_0,
            3.133_334_068_7e-2,
            1.498_492_819_8e-2,
            6.584_234_462_3e-3,
        ],
        sum: 5.642_708_239_7e3,
    }
}

/// Higher level of difficulty; four parameters, and a first start that is far off.
fn mgh09() -> Data {
    Data {
        name: "MGH09",
        x: &[
            4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625,
        ],
        y: &[
            0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246,
        ],
        model: |x, b| {
            let (above, below) = (x * x + x * b[1], x * x + x * b[2] + b[3]);
            let value = b[0] * above / below;
            (
                value,
                vec![
                    above / below,
                    b[0] * x / below,
                    -value * x / below,
                    -value / below,
                ],
            )
        },
        bounds: vec![[-50.0, 50.0]; 4],
        starts: vec![vec![0.25, 0.39, 0.415, 0.39]],
        certified: vec![
            1.928_069_345_8e-1,
            1.912_823_287_3e-1,
            1.230_565_069_3e-1,
            1.360_623_306_8e-1,
        ],
        deviations: vec![
            1.143_531_222_7e-2,
            1.963_322_091_1e-1,
            8.084_203_123_2e-2,
            9.002_554_230_8e-2,
        ],
        sum: 3.075_056_038_5e-4,
    }
}

fn deviations(problem: &Data, estimate: &Estimate) -> Vec<f64> {
    let Certainty::Covariance(covariance) = &estimate.certainty else {
        panic!("{:?}", estimate.certainty);
    };
    let widths = problem.bounds.iter().enumerate();
    widths
        .map(|(i, [min, max])| covariance[(i, i)].sqrt() * (max - min))
        .collect()
}

#[test]
fn certified_values_and_deviations_come_out() {
    for problem in [misra1a(), thurber(), mgh09()] {
        for start in &problem.starts {
            let found = fitted(&problem, &problem.unit(start), 200);
            let name = problem.name;
            assert_eq!(found.stop, Stop::Converged, "{name}");
            assert_eq!(found.places, vec![Place::Inside; start.len()]);
            assert!(
                (found.sum_of_squares / problem.sum - 1.0).abs() < 1e-9,
                "{name}"
            );
            let close = |found: &[f64], certified: &[f64], within: f64| {
                for (found, certified) in found.iter().zip(certified) {
                    let error = (found / certified - 1.0).abs();
                    assert!(error < within, "{name}: {found} {certified} {error:e}");
                }
            };
            close(&problem.real(&found.x), &problem.certified, 1e-6);
            close(&deviations(&problem, &found), &problem.deviations, 1e-5);
        }
    }
}

/// A parameter held at its bound has no deviation, and the other has that of a fit in one variable, s / |J|.
#[test]
fn a_variable_at_its_bound_is_reported() {
    let mut problem = misra1a();
    problem.bounds[0] = [100.0, 200.0];
    let found = fitted(&problem, &[0.5, 0.5], 200);
    assert_eq!(found.places, [Place::AtMax, Place::Inside]);
    assert_eq!(found.stop, Stop::Converged);
    let residuals = problem.residuals(&found.x).unwrap();
    let slope = residuals.jacobian.column(1).dot(&residuals.values);
    assert!(
        slope.abs() < 1e-6 * residuals.jacobian.column(1).norm(),
        "{slope:e}"
    );
    let Certainty::Covariance(covariance) = &found.certainty else {
        panic!("{:?}", found.certainty);
    };
    let expected = found.sum_of_squares / 13.0 / residuals.jacobian.column(1).norm_squared();
    assert!((covariance[(1, 1)] / expected - 1.0).abs() < 1e-9);
    assert_eq!(covariance.row(0).amax(), 0.0);
}

/// y = (a + 2 b) x: only the sum is determined, a and b are not.
struct Twins;

impl Fit for Twins {
    fn residuals(&self, b: &[f64]) -> Result<Residuals, Cancelled> {
        let x = DVector::from_vec(vec![1.0, 2.0, 3.0, 4.0]);
        let y = DVector::from_vec(vec![1.1, 1.9, 3.2, 3.9]);
        Ok(Residuals {
            values: &x * (b[0] + 2.0 * b[1]) - y,
            jacobian: DMatrix::from_fn(4, 2, |row, column| x[row] * [1.0, 2.0][column]),
        })
    }
}

#[test]
fn what_the_residuals_do_not_tell_apart_is_said() {
    let found = fitted(&Twins, &[0.1, 0.1], 100);
    let Certainty::Singular { direction } = &found.certainty else {
        panic!("{:?}", found.certainty);
    };
    // Along (2, -1) the sum is constant.
    assert!(
        (direction[0] + 2.0 * direction[1]).abs() < 1e-12,
        "{direction:?}"
    );
    assert!((direction[0].hypot(direction[1]) - 1.0).abs() < 1e-12);
    // Least squares in closed form: sum x y / sum x^2 = 30.1 / 30.
    let sum = found.x[0] + 2.0 * found.x[1];
    assert!((sum - 30.1 / 30.0).abs() < 1e-9, "{sum}");
}

/// The residuals of a few of its rows.
struct First<F>(F, usize);

impl<F: Fit> Fit for First<F> {
    fn residuals(&self, x: &[f64]) -> Result<Residuals, Cancelled> {
        let all = self.0.residuals(x)?;
        Ok(Residuals {
            values: all.values.rows(0, self.1).into_owned(),
            jacobian: all.jacobian.rows(0, self.1).into_owned(),
        })
    }
}

#[test]
fn too_few_residuals_are_reported() {
    let found = fitted(&First(misra1a(), 2), &[0.5, 0.5], 200);
    assert_eq!(found.certainty, Certainty::TooFewResiduals);
    assert!(found.sum_of_squares < 1e-20, "{found:?}");
}

/// NaN where the first variable is large.
struct Hole(Data);

impl Fit for Hole {
    fn residuals(&self, x: &[f64]) -> Result<Residuals, Cancelled> {
        let mut residuals = self.0.residuals(x)?;
        if x[0] > 0.5 {
            residuals.values[0] = f64::NAN;
        }
        Ok(residuals)
    }
}

#[test]
fn values_that_are_not_finite_do_not_break_a_fit() {
    let problem = misra1a();
    let start = problem.unit(&[120.0, 0.0009]);
    let found = fitted(&Hole(misra1a()), &start, 300);
    assert!(
        (found.sum_of_squares / problem.sum - 1.0).abs() < 1e-6,
        "{found:?}"
    );
    let lost = fitted(&Hole(misra1a()), &[0.9, 0.5], 300);
    assert_eq!(
        (lost.stop, lost.certainty),
        (Stop::NotFinite, Certainty::Unknown)
    );
}

#[test]
fn budget_and_cancel_end_a_fit() {
    let problem = thurber();
    let start = problem.unit(&problem.starts[0]);
    for budget in [0, 1, 5] {
        let found = fitted(&problem, &start, budget);
        assert_eq!((found.stop, found.evaluations), (Stop::Budget, budget));
    }
    let cancel = AtomicBool::new(true);
    let control = Control {
        cancel: &cancel,
        budget: 100,
        tell: &mut |_| (),
    };
    let found = fit(&problem, &start, control);
    assert_eq!((found.stop, found.x), (Stop::Cancelled, start));
}
