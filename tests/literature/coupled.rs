//! Bending coupled with torsion: closed forms, and the determinant of the boundary conditions.

use std::f64::consts::{PI, TAU};

use beamtune::model::{BeamMotion, Model, Restraint, Support};
use nalgebra::DMatrix;

use super::roots::{bisect, roots};
use super::uncoupled::bending_v;

/// Stiffnesses and inertias per length of the coupled motions w and psi.
#[derive(Clone, Copy)]
struct Products {
    /// E `I_y`, N m2.
    bending: f64,
    /// G J, N m2.
    torsion: f64,
    /// E `Gamma_0`, N m4.
    warping: f64,
    /// rho A, kg/m.
    mass: f64,
    /// rho `I_0`, kg m.
    inertia: f64,
    /// rho A `z_c`, kg.
    coupling: f64,
}

impl Products {
    fn of(model: &Model) -> Self {
        let (material, section) = (&model.beam.material, &model.beam.section);
        let mass = material.density * section.area;
        Self {
            bending: material.young_modulus * section.second_moment_y,
            torsion: material.shear_modulus * section.torsion_constant,
            warping: material.young_modulus * section.warping_constant,
            mass,
            inertia: material.density * section.polar_moment,
            coupling: mass * section.centroid_offset,
        }
    }
}

/// Gere & Lin, Coupled Vibrations of Thin-Walled Beams of Open Cross Section, 1958: both ends pinned, so that w and psi
/// are sin(n pi x / L), and omega^2 is a root of a quadratic. A guided end (slopes fixed) has a cosine in the same way.
/// All natural frequencies above zero, Hz, up to `to`, not sorted.
pub fn sinusoidal(model: &Model, to: f64) -> Vec<f64> {
    let guided = |support: &Support| match &support.restraints {
        displacements_and_slopes if *displacements_and_slopes == Support::PINNED.restraints => 0,
        [
            Restraint::Free,
            Restraint::Free,
            _,
            Restraint::Fixed,
            Restraint::Fixed,
            _,
        ] => 1,
        other => panic!("no closed form for {other:?}"),
    };
    let shift = match guided(&model.supports.left) + guided(&model.supports.right) {
        1 => 0.5,
        _ => 0.0,
    };
    let products = Products::of(model);
    let pairs = (1..200).flat_map(|n| {
        let wave = (f64::from(n) - shift) * PI / model.beam.length;
        quadratic(&products, wave)
    });
    let mut all: Vec<f64> = pairs.filter(|&hertz| hertz <= to).collect();
    all.extend(bending_v(model, to));
    all
}

/// Both frequencies in Hz for a wave number.
fn quadratic(products: &Products, wave: f64) -> [f64; 2] {
    let bending = products.bending * wave.powi(4);
    let twist = products.warping * wave.powi(4) + products.torsion * wave.powi(2);
    let a = products.mass * products.inertia - products.coupling.powi(2);
    let b = bending * products.inertia + twist * products.mass;
    let c = bending * twist;
    // b^2 - 4 a c as a sum, so that nearly equal roots keep their digits.
    let difference = bending * products.inertia - twist * products.mass;
    let root = (difference.powi(2) + 4.0 * c * products.coupling.powi(2)).sqrt();
    let larger = (b + root) / (2.0 * a);
    [c / (a * larger), larger].map(|squared| squared.sqrt() / TAU)
}

/// The general solution of the coupled equations and the determinant of its boundary conditions: Dokumaci, Journal of
/// Sound and Vibration 119, 1987 (without warping: 6x6), Bercin & Tanaka, 207, 1997 (with warping: 8x8), with the ends'
/// springs and inertias on the diagonal. All natural frequencies above zero, Hz, up to `to`, not sorted.
pub fn determinant(model: &Model, to: f64) -> Vec<f64> {
    let products = Products::of(model);
    assert_ne!(products.coupling, 0.0, "the motions are not coupled");
    let mut all = roots(to, |hertz| boundary(model, &products, TAU * hertz));
    all.extend(bending_v(model, to));
    all
}

/// The squares kappa^2 of the waves, real: between and beyond those of bending and of torsion alone.
fn squares(products: &Products, omega: f64) -> Vec<f64> {
    let squared = omega.powi(2);
    let (mass, inertia) = (squared * products.mass, squared * products.inertia);
    let characteristic = |h: f64| {
        (products.bending * h * h - mass)
            * (products.warping * h * h - products.torsion * h - inertia)
            - (squared * products.coupling).powi(2)
    };
    let bending = (mass / products.bending).sqrt();
    let root = (products.torsion.powi(2) + 4.0 * products.warping * inertia).sqrt();
    let travelling = -2.0 * inertia / (products.torsion + root);
    let far = |start: f64| {
        let mut end = 2.0 * start;
        while characteristic(end) < 0.0 {
            end *= 2.0;
        }
        bisect(start, end, &characteristic)
    };
    let mut found = vec![
        far(travelling.min(-bending)),
        bisect(travelling.max(-bending), 0.0, &characteristic),
    ];
    if products.warping == 0.0 {
        found.push(bisect(0.0, bending, &characteristic));
    } else {
        let evanescent = (products.torsion + root) / (2.0 * products.warping);
        found.push(bisect(0.0, bending.min(evanescent), &characteristic));
        found.push(far(bending.max(evanescent)));
    }
    found
}

/// A wave's value and first three derivatives at x; e^{-kappa x} and e^{-kappa (L - x)}, or cosine and sine.
fn wave(square: f64, second: bool, x: f64, length: f64) -> [f64; 4] {
    let kappa = square.abs().sqrt();
    if square > 0.0 {
        let (value, rate) = if second {
            ((-kappa * (length - x)).exp(), kappa)
        } else {
            ((-kappa * x).exp(), -kappa)
        };
        return [0, 1, 2, 3].map(|order| value * rate.powi(order));
    }
    let (sin, cos) = (kappa * x).sin_cos();
    let circle = if second {
        [sin, cos, -sin, -cos]
    } else {
        [cos, -sin, -cos, sin]
    };
    let powers = [1.0, kappa, kappa.powi(2), kappa.powi(3)];
    [0, 1, 2, 3].map(|order| circle[order] * powers[order])
}

/// The determinant, with rows and columns scaled by positive factors.
fn boundary(model: &Model, products: &Products, omega: f64) -> f64 {
    let length = model.beam.length;
    let mut columns: Vec<Vec<f64>> = Vec::new();
    for square in squares(products, omega) {
        // The row of w: (E I_y h^2 - omega^2 rho A) W = omega^2 rho A z_c Psi.
        let w = omega.powi(2) * products.coupling;
        let psi = products.bending * square.powi(2) - omega.powi(2) * products.mass;
        for second in [false, true] {
            let mut column = Vec::new();
            for (support, x, side) in [
                (&model.supports.left, 0.0, -1.0),
                (&model.supports.right, length, 1.0),
            ] {
                let shape = wave(square, second, x, length);
                column.extend(end_rows(products, support, shape, (w, psi), (side, omega)));
            }
            columns.push(column);
        }
    }
    let size = columns.len();
    let mut matrix = DMatrix::from_fn(size, size, |row, column| columns[column][row]);
    for index in 0..size {
        let largest = matrix.column(index).amax();
        matrix.column_mut(index).unscale_mut(largest);
    }
    for index in 0..size {
        let largest = matrix.row(index).amax();
        matrix.row_mut(index).unscale_mut(largest);
    }

    matrix.determinant()
}

/// The conditions of one end: the motion, or the internal force with the reaction of the support.
fn end_rows(
    products: &Products,
    support: &Support,
    shape: [f64; 4],
    (w, psi): (f64, f64),
    (side, omega): (f64, f64),
) -> Vec<f64> {
    let [value, slope, curvature, third] = shape;
    let torque = products.torsion * slope - products.warping * third;
    let mut rows = vec![
        (BeamMotion::W, w * value, -products.bending * third * w),
        (
            BeamMotion::WSlope,
            w * slope,
            products.bending * curvature * w,
        ),
        (BeamMotion::Psi, psi * value, torque * psi),
    ];
    if products.warping > 0.0 {
        let bimoment = products.warping * curvature * psi;
        rows.push((BeamMotion::PsiSlope, psi * slope, bimoment));
    }
    rows.into_iter()
        .map(|(motion, displacement, force)| match &support[motion] {
            Restraint::Fixed => displacement,
            Restraint::Free => force,
            Restraint::Elastic(spring) => {
                let dynamic = spring.spring.stiffness - omega.powi(2) * spring.inertia;
                side * force + dynamic * displacement
            }
        })
        .collect()
}
