//! The kernel against closed forms and finite elements, and its instructions against one another.
//!
//! All lose the digits that the conditioning of a model costs: of a response near an anti-resonance, and at low
//! frequencies by cancellation between the waves. So differences are relative to the response and to its largest value.

use std::sync::atomic::AtomicBool;

use num_complex::Complex64;

use super::complex::Complex;
use super::linear::solve;
use super::number::{Arithmetic, MOST_LANES, Real};
use super::portable::Portable;
use super::recursion::Prepared;
#[cfg(target_arch = "x86_64")]
use super::vectors::{Avx2, Avx512};
use super::waves::{Constants, Waves};
use super::{Instructions, Solver};
use crate::model::{
    BeamMotion, Elastic, Force, InnerSupport, Joint, Link, MassMotion, MaxwellBranch, Measure,
    Model, Place, Point, Quantity, Response, Restraint, Spring, Support, Target, Theory,
    UniformPart, check, read,
};
use crate::presets;
use crate::solve::fem::FiniteElements;
use crate::solve::linear::Magnified;
use crate::solve::plan::Plan;
use crate::solve::sweep::{angular, frequencies};
use crate::solve::waves::BeamConstants;

mod low;
mod spans;

/// All responses at some frequencies, a row a frequency.
fn lanes(instructions: Instructions, plan: &Plan, frequencies: &[f64]) -> Vec<Complex64> {
    let (width, count) = (plan.outputs.len(), frequencies.len());
    let mut columns = vec![vec![Complex64::ZERO; count]; width];
    let mut out: Vec<&mut [Complex64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    Solver::new(instructions).solve(
        &Prepared::new(plan.clone()),
        &angular(frequencies),
        &mut out,
    );
    (0..width * count)
        .map(|index| columns[index % width][index / width])
        .collect()
}

/// Compares two sets of rows: within a fraction of each value, of the largest of its response and, for a response that
/// symmetry makes 0, of the others.
fn assert_near(
    found: &[Complex64],
    expected: &[Complex64],
    width: usize,
    [own, top, rounding]: [f64; 3],
) {
    let finite = expected.iter().filter(|value| value.is_finite());
    let of_all = finite.map(|value| value.norm()).fold(0.0, f64::max);
    for response in 0..width {
        let of = |rows: &[Complex64]| -> Vec<Complex64> {
            rows.iter().skip(response).step_by(width).copied().collect()
        };
        let (found, expected) = (of(found), of(expected));
        let finite = expected.iter().filter(|value| value.is_finite());
        let largest = finite.map(|value| value.norm()).fold(0.0, f64::max);
        for (index, (a, b)) in found.iter().zip(&expected).enumerate() {
            let allowed = own * b.norm() + top * largest + rounding * of_all;
            let both = a.is_finite() == b.is_finite();
            let near = !b.is_finite() || (a - b).norm() <= allowed;
            assert!(
                both && near,
                "response {response}, row {index}: {a} {b} of {of_all:e}"
            );
        }
    }
}

#[test]
fn each_frequency_is_solved_as_if_it_were_alone() {
    // Golden: bit for bit, for any neighbours in a group and any division of a sweep.
    let plan = Plan::new(
        &read(presets::find("fig05a").unwrap().text)
            .unwrap()
            .into_inner(),
    );
    let all: Vec<f64> = (1..=11).map(|k| 37.0 * f64::from(k)).collect();
    for instructions in Instructions::available() {
        let together = lanes(instructions, &plan, &all);
        for (frequency, row) in all.iter().zip(together.chunks(plan.outputs.len())) {
            assert_eq!(lanes(instructions, &plan, &[*frequency]), row);
        }
    }
}

/// Expected: finite elements, which converge at order 4, fine enough for what decays fastest.
#[test]
fn random_models_are_solved_as_by_finite_elements() {
    let mut random = fastrand::Rng::with_seed(7);
    let all: Vec<f64> = (0..6).map(|k| 20.0 * 1.4_f64.powi(k)).collect();
    let mut compared = 0;
    for index in 0..400 {
        let mut model = random_model(&mut random);
        // A section without warping stiffness carries no bimoment.
        if !check(&model).is_empty() {
            continue;
        }
        compared += 1;
        if index % 2 == 0 {
            spans::divide(&mut model, &mut random);
        }
        let never = AtomicBool::new(false);
        let elements = FiniteElements::new(&model, 160);
        let elements = elements.sweep(&all, &never).unwrap();
        let columns = &elements.columns;
        let row = |row: usize| columns.iter().map(move |column| column.values[row]);
        let expected: Vec<Complex64> = (0..all.len()).flat_map(row).collect();
        let plan = Plan::new(&model);
        for instructions in Instructions::available() {
            let found = lanes(instructions, &plan, &all);
            assert_near(&found, &expected, plan.outputs.len(), [1e-3, 1e-3, 1e-14]);
        }
    }
    assert!(compared > 200, "{compared}");
}

/// A number of a range.
fn some(random: &mut fastrand::Rng, from: f64, to: f64) -> f64 {
    from + (to - from) * random.f64()
}

/// A beam with all features: any supports, loads of all motions, subsystems without springs or inertia.
fn random_model(random: &mut fastrand::Rng) -> Model {
    let mut model = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    model.beam.material.loss_factor = [0.0, 0.01, 0.2][random.usize(0..3)];
    let section = &mut model.beam.section;
    section.warping_constant *= [0.0, 0.1, 1.0, 10.0][random.usize(0..4)];
    section.centroid_offset *= [0.0, 1.0, -2.0][random.usize(0..3)];
    (section.shear_area_y, section.shear_area_z) = (6e-3, 4e-3);
    if random.bool() {
        section.centroid_offset_y = [0.0, 0.05, -0.1][random.usize(0..3)];
        section.product_moment = [0.0, 3e-5, -1e-4][random.usize(0..3)];
        model.beam.axial_force = [0.0, 2e6, -1e5][random.usize(0..3)];
        model.beam.warping_inertia = random.bool();
        model.beam.theory = Theory::ALL[random.usize(0..4)];
        model.beam.foundation.w.stiffness = [0.0, 1e5, 1e8][random.usize(0..3)];
        model.beam.foundation.psi.damping = [0.0, 50.0][random.usize(0..2)];
        model.beam.foundation.v.loss_factor = 0.3;
        model.beam.foundation.v.stiffness = [0.0, 3e6][random.usize(0..2)];
    }
    for support in [&mut model.supports.left, &mut model.supports.right] {
        *support = random_support(random);
    }
    for index in 0..random.usize(0..3) {
        model.supports.inner.push(InnerSupport {
            name: format!("B{index}"),
            position: model.beam.length * some(random, 0.05, 0.95),
            support: random_support(random),
        });
    }
    let pattern = model.subsystems[0].clone();
    model.subsystems.clear();
    model.forces.clear();
    model.responses.clear();
    for index in 0..random.usize(0..6) {
        let mut subsystem = pattern.clone();
        subsystem.name = format!("S{index}");
        subsystem.position = model.beam.length * [0.3, 0.7, random.f64()][random.usize(0..3)];
        subsystem.inertia *= [0.0, 1e-2, 1.0][random.usize(0..3)];
        subsystem.mount_y *= [0.0, 1.0][random.usize(0..2)];
        subsystem.arm_left *= [0.0, 1.0, 3.0][random.usize(0..3)];
        for spring in [
            &mut subsystem.y_left,
            &mut subsystem.z_left,
            &mut subsystem.z_right,
        ] {
            spring.stiffness *= [0.0, 1e-2, 1.0, 10.0][random.usize(0..4)];
            spring.damping *= [0.0, 1.0, 100.0][random.usize(0..3)];
            spring.loss_factor = [0.0, 0.1][random.usize(0..2)];
            spring.maxwell = random_branches(random);
        }
        for motion in MassMotion::ALL {
            let target = Target::Mass(subsystem.name.clone(), motion);
            add_response(&mut model, target.clone(), random);
            if random.u8(0..4) == 0 {
                add_force(&mut model, target, random);
            }
        }
        model.subsystems.push(subsystem);
    }
    for motion in BeamMotion::ALL {
        let place = Place::Position(some(random, 0.1, 0.9) * model.beam.length);
        let place = [Place::Left, Place::Right, place][random.usize(0..3)];
        add_response(&mut model, Target::Beam(place, motion), random);
        add_force(&mut model, Target::Beam(place, motion), random);
    }
    if random.bool() {
        model.responses.push(Response {
            name: "E_V".to_owned(),
            enabled: true,
            quantity: Quantity::Energy,
            point: crate::model::Point::AXIS,
            over: None,
        });
    }
    for _ in 0..random.usize(0..3) {
        model.joints.push(random_joint(random, model.beam.length));
    }
    model
}

fn add_response(model: &mut Model, target: Target, random: &mut fastrand::Rng) {
    model.responses.push(Response {
        name: format!("R{}", model.responses.len()),
        enabled: true,
        point: random_point(&target, random),
        quantity: Quantity::Motion(target, Measure::ALL[random.usize(0..3)]),
        over: None,
    });
}

fn add_force(model: &mut Model, target: Target, random: &mut fastrand::Rng) {
    model.forces.push(Force {
        enabled: true,
        point: random_point(&target, random),
        target,
        amplitude: random.f64(),
        phase: 360.0 * random.f64(),
    });
}

/// A point of the section for a displacement of the beam, on the axis half of the time.
fn random_point(target: &Target, random: &mut fastrand::Rng) -> Point {
    if !target.has_point() || random.bool() {
        return Point::AXIS;
    }
    Point {
        y: some(random, -0.2, 0.2),
        z: some(random, -0.2, 0.2),
    }
}

/// None for half of the springs; some transmit no force. Does not advance the generator.
fn random_branches(random: &fastrand::Rng) -> Vec<MaxwellBranch> {
    let mut random = random.clone();
    let count = [0, 0, 1, 2][random.usize(0..4)];
    let branch = |_| MaxwellBranch {
        stiffness: [0.0, 1e5, 3e6][random.usize(0..3)],
        damping: [0.0, 300.0, 2e4][random.usize(0..3)],
    };
    (0..count).map(branch).collect()
}

fn random_support(random: &mut fastrand::Rng) -> Support {
    let elastic = Elastic {
        spring: Spring {
            stiffness: 1e6,
            damping: 100.0,
            loss_factor: [0.0, 0.2][random.usize(0..2)],
            maxwell: random_branches(random),
        },
        inertia: [0.0, 10.0][random.usize(0..2)],
    };
    let mut support = Support::FREE;
    for motion in BeamMotion::ALL {
        support[motion] = match random.u8(0..3) {
            0 => Restraint::Free,
            1 => Restraint::Fixed,
            _ => Restraint::Elastic(elastic.clone()),
        };
    }
    support.point.z = [0.0, 0.1][random.usize(0..2)];
    support.point.y = [0.0, 0.0, -0.07][random.usize(0..3)];
    support
}

fn random_joint(random: &mut fastrand::Rng, length: f64) -> Joint {
    let spring = Spring {
        stiffness: [1e4, 1e6, 1e9][random.usize(0..3)],
        damping: 100.0,
        loss_factor: [0.0, 0.2][random.usize(0..2)],
        maxwell: random_branches(random),
    };
    let mut joint = Joint {
        position: length * some(random, 0.05, 0.95),
        ..Joint::default()
    };
    for motion in BeamMotion::ALL {
        joint[motion] = match random.u8(0..4) {
            0 => Link::Free,
            1 => Link::Elastic(spring.clone()),
            _ => Link::Rigid,
        };
    }
    joint[BeamMotion::ALL[random.usize(0..6)]] = Link::Elastic(spring);
    joint
}

#[test]
fn what_nothing_drives_stays_at_zero_and_what_is_driven_has_no_finite_answer() {
    // Closed form: 2 x = 4 and 0 y = 0, whose limit is 0 as the zero is approached; x + y = 1 and x + y = -1.
    let number = |re: f64| Complex::<Portable>::from_real(Real::splat(re));
    let solved = |a: [[f64; 2]; 2], b: [f64; 2]| {
        let (mut a, mut b) = (a.map(|row| row.map(number)), b.map(|row| [number(row)]));
        solve(&mut a, &mut b);
        b.map(|[x]| x.lane(0))
    };
    let undriven = solved([[2.0, 0.0], [0.0, 0.0]], [4.0, 0.0]);
    assert_eq!(undriven, [2.0, 0.0].map(Complex64::from));
    let singular = solved([[1.0, 1.0], [1.0, 1.0]], [1.0, -1.0]);
    assert!(singular.iter().any(|x| !x.is_finite()));
}

#[test]
fn an_undamped_resonance_has_no_finite_answer() {
    // Closed form: a pinned beam without coupling, n = 1, f = pi / (2 L^2) sqrt(E Iz / rho A).
    let mut model = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    model.subsystems.clear();
    model.supports.left = Support::PINNED;
    model.supports.right = Support::PINNED;
    model.beam.section.centroid_offset = 0.0;
    model.forces[0].target = Target::Beam(Place::Position(1.0), BeamMotion::V);
    let section = &model.beam.section;
    let stiffness = model.beam.material.young_modulus * section.second_moment_z;
    let mass = model.beam.material.density * section.area;
    let length = model.beam.length;
    let at = std::f64::consts::FRAC_PI_2 / (length * length) * (stiffness / mass).sqrt();
    let plan = Plan::new(&model);
    for instructions in Instructions::available() {
        let rows = lanes(instructions, &plan, &[0.9 * at, at, 1.1 * at]);
        let is_finite: Vec<bool> = rows
            .chunks(plan.outputs.len())
            .map(|row| row.iter().all(|value| value.is_finite()))
            .collect();
        assert_eq!(is_finite, [true, false, true]);
    }
}

#[test]
fn all_instructions_give_the_same_responses() {
    for preset in presets::ALL {
        let plan = Plan::new(&read(preset.text).unwrap().into_inner());
        let all = frequencies(&read(preset.text).unwrap().into_inner().sweep);
        let expected = lanes(Instructions::Portable, &plan, &all);
        for instructions in Instructions::available() {
            let found = lanes(instructions, &plan, &all);
            assert_near(&found, &expected, plan.outputs.len(), [1e-12, 1e-12, 1e-14]);
        }
    }
}

#[test]
fn the_coupled_waves_are_all_four_roots_whatever_the_section() {
    let mut random = fastrand::Rng::with_seed(11);
    let mut beam = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner()
        .beam;
    let first = beam.section;
    for _ in 0..20_000 {
        let mut times = |tens: f64| 10.0_f64.powf(tens * (2.0 * random.f64() - 1.0));
        let section = &mut beam.section;
        section.second_moment_y = first.second_moment_y * times(2.0);
        section.torsion_constant = first.torsion_constant * times(3.0);
        section.warping_constant = first.warping_constant * times(3.0);
        section.centroid_offset = first.centroid_offset * times(2.0);
        // From nearly uncoupled to as coupled as a section can be.
        let least = section.area * section.centroid_offset.powi(2);
        section.polar_moment = least * (1.0 + times(3.0));
        let omega = 1e3 * times(4.0);
        beam.material.loss_factor = [0.0, 0.01, 0.5][random.usize(0..3)];
        assert_all_roots(&BeamConstants::new(&UniformPart::whole(beam), false), omega);
    }
}

/// Closed form: what the roots h of `(E Iy h^2 - a)(E G0 h^2 - G J h - b) = d^2` add up to, alone and in products.
fn assert_all_roots(beam: &BeamConstants, omega: f64) {
    let mut waves = Waves::<Portable>::NONE;
    waves.set(
        &Constants::new(beam),
        Complex::from_real(Real::splat(omega)),
    );
    let square = omega * omega;
    let [a, b, d] = [beam.mass, beam.polar, beam.coupling].map(|inertia| square * inertia);
    let leading = beam.bending_w * beam.warping;
    let expected = [
        beam.torsion / beam.warping,
        -(beam.bending_w * b + beam.warping * a) / leading,
        -beam.torsion * a / leading,
        (a * b - d * d) / leading,
    ];
    // Symmetric functions of the roots found, and of their sizes.
    let (mut found, mut sizes) = ([Complex64::ZERO; 5], [0.0; 5]);
    (found[0], sizes[0]) = (Complex64::ONE, 1.0);
    for wave in 0..4 {
        let kappa = waves.kappa[wave].lane(0);
        for k in (1..5).rev() {
            found[k] += found[k - 1] * kappa * kappa;
            sizes[k] += sizes[k - 1] * kappa.norm_sqr();
        }
    }
    for k in 1..5 {
        let error = (found[k] - expected[k - 1]).norm();
        assert!(
            error < 1e-12 * sizes[k],
            "{k}: {error:.1e} of {:.1e}, {omega} {beam:?}",
            sizes[k]
        );
    }
}

#[test]
fn elementary_functions_are_those_of_the_library() {
    elementary_functions_are_right_by::<Portable>();
    #[cfg(target_arch = "x86_64")]
    for instructions in Instructions::available() {
        match instructions {
            Instructions::Avx512 => elementary_functions_are_right_by::<Avx512>(),
            Instructions::Avx2 => elementary_functions_are_right_by::<Avx2>(),
            Instructions::Portable => {}
        }
    }
}

fn elementary_functions_are_right_by<A: Arithmetic>() {
    // High-precision solution: the platform's, within 1 unit of the last place.
    let mut random = fastrand::Rng::with_seed(3);
    for scale in [1e-9, 1e-3, 1.0, 30.0, 690.0, 1e5, 1e8] {
        for _ in 0..500 {
            let all: [f64; MOST_LANES] =
                std::array::from_fn(|_| scale * (2.0 * random.f64() - 1.0));
            let (sin, cos) = Real::<A>::new(&all).sin_cos();
            let exp = Real::<A>::new(&all.map(|x| x.min(700.0))).exp();
            let (sin, cos, exp) = (sin.lanes(), cos.lanes(), exp.lanes());
            for (lane, x) in all.into_iter().enumerate().take(A::LANES) {
                assert!((sin[lane] - x.sin()).abs() < 4e-16, "sin {x}");
                assert!((cos[lane] - x.cos()).abs() < 4e-16, "cos {x}");
                let x = x.min(700.0);
                let expected = if x < -700.0 { 0.0 } else { x.exp() };
                assert!((exp[lane] - expected).abs() <= 5e-16 * expected, "exp {x}");
            }
        }
    }
}

/// F at some complex angular frequencies, rad/s.
fn characteristic(
    instructions: Instructions,
    model: &Model,
    omegas: &[Complex64],
) -> Vec<Magnified> {
    let prepared = Prepared::new(Plan::new(model));
    let mut out = vec![Magnified::ONE; omegas.len()];
    Solver::new(instructions).characteristic(&prepared, omegas, &mut out);
    out
}

/// Complex angular frequencies, rad/s, on either side of the real and the imaginary axis.
fn complex_frequencies() -> Vec<Complex64> {
    let omega = |k: i32| {
        Complex64::from_polar(
            60.0 * 1.12_f64.powi(k),
            -0.4 + 2.2 * (0.37 * f64::from(k)).fract(),
        )
    };
    (0..43).map(omega).collect()
}

/// Expected: closed form of a pinned beam without coupling, the product of `sin(k L) sinh(k L) / k^2` over both bendings
/// and `sin(a L) sinh(b L) / (a b)` of twist with warping.
#[test]
fn the_characteristic_function_of_a_pinned_beam_is_its_closed_form() {
    let mut model = read(presets::find("fig05a").unwrap().text)
        .unwrap()
        .into_inner();
    model.subsystems.clear();
    model.forces.clear();
    model.responses.clear();
    (model.supports.left, model.supports.right) = (Support::PINNED, Support::PINNED);
    model.beam.section.centroid_offset = 0.0;
    for loss_factor in [0.0, 0.3] {
        model.beam.material.loss_factor = loss_factor;
        let beam = BeamConstants::new(&UniformPart::whole(model.beam), false);
        let length = model.beam.length;
        let waves = |evanescent: Complex64, travelling: Complex64| {
            // Even in either root.
            let (b, a) = (evanescent.sqrt(), travelling.sqrt());
            (b * length).sinh() / b * ((a * length).sin() / a)
        };
        let exact = |omega: Complex64| {
            let bending = [beam.bending_w, beam.bending_v].map(|stiffness| {
                let h = omega * (beam.mass / stiffness).sqrt();
                waves(h, h)
            });
            let inertia = 4.0 * beam.warping * beam.polar * omega * omega;
            let root = (beam.torsion * beam.torsion + inertia).sqrt();
            let twist =
                [root + beam.torsion, root - beam.torsion].map(|h| h / (2.0 * beam.warping));
            bending[0] * bending[1] * waves(twist[0], twist[1])
        };
        let omegas = complex_frequencies();
        for instructions in Instructions::available() {
            let found = characteristic(instructions, &model, &omegas);
            for (omega, found_here) in omegas.iter().zip(&found) {
                let expected = exact(*omega) / exact(omegas[0]);
                let error = (found_here.ratio(&found[0]) / expected - 1.0).norm();
                assert!(error < 1e-11, "{omega}: {error:e}");
            }
        }
    }
}

/// Expected: the portable arithmetic, which shares the equations but no instructions.
#[test]
fn all_instructions_give_the_same_characteristic_function() {
    let mut random = fastrand::Rng::with_seed(5);
    let omegas = complex_frequencies();
    for _ in 0..100 {
        let mut model = random_model(&mut random);
        model.forces.clear();
        model.responses.clear();
        let expected = characteristic(Instructions::Portable, &model, &omegas);
        for instructions in Instructions::available() {
            let found = characteristic(instructions, &model, &omegas);
            for (found_here, expected_here) in found.iter().zip(&expected) {
                let relative = found_here.over(&found[0]);
                let error = (relative.ratio(&expected_here.over(&expected[0])) - 1.0).norm();
                assert!(error < 1e-10, "{error:e}");
            }
        }
    }
}
