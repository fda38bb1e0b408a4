//! The two ends (Chen & Liu 2022, Appendix C), and the constants that satisfy both.

use nalgebra::{SMatrix, SVector};
use num_complex::Complex64;

use super::shapes::Matrix;
use super::springs::complex;
use super::{Chain, Link, Solution, Vector, conjugate, moved_row};
use crate::model::{BeamMotion, Restraint};

/// The six equations of an end over the constants of its segment: `of_constants C = load`.
struct End {
    of_constants: SMatrix<Complex64, 6, 12>,
    load: SVector<Complex64, 6>,
}

/// `B_L` or `B_R` of Eqs. (A37) and (A38) for any support: -p + K q = F at the left end, p + K q = F at the right, or
/// q = 0, for each of the six motions. `state` holds the derivatives there, `outward` is -1 at the left end and 1 at the
/// right.
fn end(chain: &Chain, solution: &Solution, place: usize, state: &Matrix, outward: f64) -> End {
    let mut end = End {
        of_constants: SMatrix::zeros(),
        load: SVector::zeros(),
    };
    let Some(support) = chain.layout.end(place) else {
        return end;
    };
    let omega = solution.omega;
    for (equation, motion) in BeamMotion::ALL.into_iter().enumerate() {
        let moved = state.row(moved_row(motion));
        let (row, unit) = conjugate(&solution.shapes, motion);
        let acted = state.row(row) * (unit * outward);
        let load = chain.layout.loads[place][motion as usize];
        let (of_constants, load) = match &support[motion] {
            Restraint::Fixed => (moved.into_owned(), Complex64::ZERO),
            Restraint::Free => (acted, load),
            Restraint::Elastic(elastic) => {
                // K_e of Eqs. (A26) to (A36).
                let inertia = omega * omega * elastic.inertia;
                let k = complex(&elastic.spring, Complex64::I * omega) - inertia;
                (acted + moved * k, load)
            }
        };
        end.of_constants.set_row(equation, &of_constants);
        end.load[equation] = load;
    }
    end
}

/// `C_1`: Eqs. (48), (50), (58), (62), (65) and (75) in one, for loads at the ends, inside and on the subsystems.
pub(super) fn first_constants(chain: &Chain, solution: &Solution, links: &[Link]) -> Vector {
    let shapes = &solution.shapes;
    let last = chain.lengths.len() - 1;
    let right_place = chain.layout.positions.len() - 1;
    let left = end(chain, solution, 0, &shapes.derivatives(0.0), -1.0);
    let at_end = shapes.derivatives(chain.lengths[last]);
    let right = end(chain, solution, right_place, &at_end, 1.0);
    let mut matrix = Matrix::zeros();
    let mut load = Vector::zeros();
    matrix.fixed_rows_mut::<6>(0).copy_from(&left.of_constants);
    let through = right.of_constants * links[last].of_first;
    matrix.fixed_rows_mut::<6>(6).copy_from(&through);
    load.fixed_rows_mut::<6>(0).copy_from(&left.load);
    let rest = right.load - right.of_constants * links[last].forced;
    load.fixed_rows_mut::<6>(6).copy_from(&rest);
    super::solve(&matrix.lu(), load)
}
