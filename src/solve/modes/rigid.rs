//! The modes at frequency 0: how the beam and the masses move without stretching a spring.

use nalgebra::{SMatrix, SymmetricEigen};

use super::station::{End, Mass};

/// The modes at frequency 0: motions of the rigid beam and the masses that stretch no spring.
pub(super) fn count(left: &End, right: &End, masses: &[Mass], length: f64) -> usize {
    // Of w, psi, v at the left end and the two slopes; a rigid beam has no rate of twist.
    let mut rigid = SMatrix::<f64, 5, 5>::zeros();
    let mut free = 0;
    let held = held_stiffness([left, right], masses);
    for (end, x) in [(left, 0.0), (right, length)] {
        for (row, motion) in rigid_motions(x).iter().enumerate() {
            let stiffness = if end.fixed[row] {
                held
            } else {
                end.elastic[row].stiffness
            };
            rigid += stiffness * motion * motion.transpose();
        }
    }
    for mass in masses {
        let (condensed, loose) = mass.condensed_static();
        let motions = rigid_motions(mass.position);
        for row in 0..3 {
            for column in 0..3 {
                rigid += condensed[(row, column)] * motions[row] * motions[column].transpose();
            }
        }
        free += loose;
    }
    free + 5 - rank(&rigid)
}

/// A stiffness as large as any of the model: what is fixed is certainly no mode at frequency 0.
fn held_stiffness(ends: [&End; 2], masses: &[Mass]) -> f64 {
    let springs = ends
        .iter()
        .flat_map(|end| end.elastic.iter().map(|elastic| elastic.stiffness));
    let masses = masses.iter().map(|mass| mass.stiffness.amax());
    springs.chain(masses).fold(1.0, f64::max)
}

/// w, psi, v and their slopes at x, as functions of (w, psi, v, w', v') of a rigid beam at its left end.
fn rigid_motions(x: f64) -> [SMatrix<f64, 5, 1>; 6] {
    [
        [1.0, 0.0, 0.0, x, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, x],
        [0.0, 0.0, 0.0, 1.0, 0.0],
        [0.0; 5],
        [0.0, 0.0, 0.0, 0.0, 1.0],
    ]
    .map(SMatrix::<f64, 5, 1>::from)
}

/// The rank of a positive semidefinite matrix, each motion in its own unit.
fn rank<const N: usize>(stiffness: &SMatrix<f64, N, N>) -> usize
where
    nalgebra::Const<N>: nalgebra::DimSub<nalgebra::U1>,
    nalgebra::DefaultAllocator: nalgebra::allocator::Allocator<nalgebra::Const<N>>
        + nalgebra::allocator::Allocator<nalgebra::DimDiff<nalgebra::Const<N>, nalgebra::U1>>,
{
    const RESOLVED: f64 = 1e-11;
    let scale = |index: usize| {
        let diagonal = stiffness[(index, index)];
        if diagonal > 0.0 {
            diagonal.sqrt().recip()
        } else {
            0.0
        }
    };
    let scaled = SMatrix::<f64, N, N>::from_fn(|i, j| stiffness[(i, j)] * scale(i) * scale(j));
    SymmetricEigen::new(scaled)
        .eigenvalues
        .iter()
        .filter(|&&x| x > RESOLVED)
        .count()
}
