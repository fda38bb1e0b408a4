//! Modes of beams of several spans.

use super::common::models;
use super::{
    NEVER, PI, assert_close, assert_modes, checked, damped, mass_on_springs, pinned_beam,
    unsymmetric,
};
use beamtune::model::{
    Beam, BeamMotion, Elastic, InnerSupport, Model, Point, Restraint, Section, Span, Spring,
    Support,
};
use beamtune::solve::modes::{
    Mode, ModeKind, buckling_factors, buckling_load, shape, shares, undamped,
};
use proptest::prelude::*;

/// The same model with spans in place of its length.
fn with_spans(mut model: Model, spans: Vec<Span>) -> Model {
    model.beam.length = 0.0;
    model.spans = spans;
    model
}

fn span(length: f64, section: Section) -> Span {
    Span {
        length,
        section: Some(section),
        ..Span::default()
    }
}

/// A section with these multiples of all that resists bending and warping or has inertia, and of the torsion constant.
fn scaled(section: &Section, all: f64, torsion: f64) -> Section {
    Section {
        area: all * section.area,
        second_moment_y: all * section.second_moment_y,
        second_moment_z: all * section.second_moment_z,
        warping_constant: all * section.warping_constant,
        polar_moment: all * section.polar_moment,
        torsion_constant: torsion * section.torsion_constant,
        ..*section
    }
}

fn all(model: &Model, to: f64) -> Vec<f64> {
    undamped(&checked(model), to, &NEVER).unwrap().unwrap()
}

fn assert_same(found: &[f64], expected: &[f64], within: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert_close(*found, *expected, within);
    }
}

/// Expected: a Ritz method, whose digits are those of Koplow, Bhattacharyya & Mann 2006 (among the cases of the literature)
/// and more. A free aluminium beam with a step; bending across and twist are made too stiff to be in the list.
#[test]
fn a_free_beam_with_a_step() {
    let section = |depth: f64| {
        let width = 25.4e-3;
        let bending = width * depth.powi(3) / 12.0;
        Section {
            area: width * depth,
            second_moment_y: bending,
            second_moment_z: 400.0 * bending,
            torsion_constant: 1e3 * bending,
            polar_moment: 10.0 * bending,
            ..Section::default()
        }
    };
    let mut model = unsymmetric(1.0, Support::FREE, Support::FREE);
    let material = &mut model.beam.material;
    (material.young_modulus, material.shear_modulus) = (71.7e9, 27e9);
    material.density = 2830.0;
    let spans = vec![span(0.254, section(19.05e-3)), span(0.14, section(5.49e-3))];
    let model = with_spans(model, spans);
    let found = all(&model, 1900.0);
    assert_eq!(found.iter().filter(|hertz| **hertz == 0.0).count(), 5);
    assert_eq!(found.len(), 8, "{found:?}");
    assert_modes(&model, &[292.443_786, 1_181.319_924, 1_804.087_158]);
}

/// Expected: a Ritz method with polynomials of order 14 and 18, whose results agree in all digits given; the second half
/// has half of all stiffnesses and masses, but an eighth of the torsion constant.
#[test]
fn a_step_of_a_section_without_symmetry() {
    for (left, right, expected) in [
        (
            Support::CLAMPED,
            Support::FREE,
            [21.682_77, 36.172_47, 79.248_96, 98.605_06],
        ),
        (
            Support::PINNED,
            Support::PINNED,
            [42.583_95, 71.977_98, 158.086_06, 176.961_23],
        ),
    ] {
        let model = unsymmetric(1.5, left, right);
        let section = model.beam.section;
        let spans = vec![
            span(0.75, section),
            span(0.75, scaled(&section, 0.5, 0.125)),
        ];
        assert_modes(&with_spans(model, spans), &expected);
    }
}

/// Expected: the same Ritz method for a linear taper. Equal spans with the section of their middle converge with the
/// square of their number, so that two numbers of them extrapolate to the taper (Richardson): to 2e-6 here.
#[test]
fn a_taper_of_many_spans() {
    let expected = [19.777_18, 32.940_56, 72.144_70, 103.793_51, 178.116_53];
    let tapered = |count: usize| {
        let model = unsymmetric(1.5, Support::CLAMPED, Support::FREE);
        let spans = (0..count).map(|index| {
            let factor = 1.0 - (index as f64 + 0.5) / (2.0 * count as f64);
            let section = scaled(&model.beam.section, factor, factor.powi(3));
            span(1.5 / count as f64, section)
        });
        let spans = spans.collect();
        all(&with_spans(model, spans), 180.0)
    };
    let (coarse, fine) = (tapered(16), tapered(32));
    let found = fine.iter().zip(&coarse);
    let found: Vec<f64> = found
        .map(|(fine, coarse)| (4.0 * fine - coarse) / 3.0)
        .collect();
    assert_same(&found, &expected, 2e-6);
}

/// Closed form: a clamped column with a free end, tan(k1 l1) tan(k2 l2) = k2 / k1 with k = sqrt(P / (E I)) (Timoshenko &
/// Gere, Theory of Elastic Stability (1961), Section 2.14); and a force of its own in each span is scaled by one factor.
#[test]
fn a_stepped_column_buckles() {
    let mut model = pinned_beam(4e-6);
    (model.supports.left, model.supports.right) = (Support::CLAMPED, Support::FREE);
    // Twist does not buckle.
    model.beam.section.torsion_constant = 1.0;
    let modulus = model.beam.material.young_modulus;
    let [first, second] = [1.0, 0.6].map(|share| model.beam.length * share);
    let section = |second_moment_y: f64| Section {
        second_moment_y,
        ..model.beam.section
    };
    let spans = vec![span(first, section(3e-6)), span(second, section(1e-6))];
    let rest = |load: f64| {
        let [k1, k2] = [3e-6, 1e-6].map(|moment| (load / (modulus * moment)).sqrt());
        let [of_first, of_second] = [k1 * first, k2 * second];
        of_first.sin() * of_second.sin() * k1 - of_first.cos() * of_second.cos() * k2
    };
    // The least root is below the load of the stiffer section all along.
    let most = modulus * 3e-6 * (0.5 * PI / (first + second)).powi(2);
    let mut range = [0.0, most];
    for _ in 0..100 {
        let middle = 0.5 * (range[0] + range[1]);
        range[usize::from(rest(middle) > 0.0)] = middle;
    }
    let mut model = with_spans(model, spans);
    let critical = buckling_load(&checked(&model)).unwrap();
    assert_close(critical, range[0], 1e-9);
    model.beam.axial_force = -1e3;
    let factors = buckling_factors(&checked(&model), critical / 900.0, 3);
    assert_close(factors[0], critical / 1e3, 1e-9);
    for span in &mut model.spans {
        span.axial_force = Some(-2e3);
    }
    let factors = buckling_factors(&checked(&model), critical / 900.0, 3);
    assert_close(factors[0], critical / 2e3, 1e-9);
    // Tension in the upper span lifts the load of the lower one, but not to infinity.
    model.spans[1].axial_force = Some(2e3);
    let pulled = buckling_factors(&checked(&model), 20.0 * critical / 2e3, 3);
    assert!(pulled[0] > factors[0], "{pulled:?}");
}

/// Of a beam of unlike spans off its axis, with loss factors of their own and a mass: its damped list is certain, and each
/// mode has a shape. By construction: the shape of a mode that is not orthogonal to the others with the mass of all spans
/// is zero.
#[test]
fn every_mode_of_unlike_spans_has_a_shape() {
    let mut model = unsymmetric(1.5, Support::FREE, Support::FREE);
    let spring = Spring {
        stiffness: 2e4,
        damping: 3.0,
        ..Spring::default()
    };
    model.subsystems = vec![mass_on_springs(0.6, spring)];
    let section = model.beam.section;
    let mut spans = vec![
        span(0.6, section),
        span(0.5, scaled(&section, 2.0, 3.0)),
        span(0.4, scaled(&section, 0.7, 0.5)),
    ];
    spans[0].offset = Point { y: 0.03, z: -0.02 };
    spans[2].offset = Point { y: -0.01, z: 0.05 };
    for loss_factor in [0.0, 0.03] {
        let mut material = model.beam.material;
        material.loss_factor = loss_factor;
        spans[1].material = Some(material);
        let model = with_spans(model.clone(), spans.clone());
        let found = damped(&model, 300.0);
        let rigid = |mode: &&Mode| mode.kind == ModeKind::RigidBody;
        assert!(found.modes.iter().filter(rigid).count() >= 5);
        for index in 0..found.modes.len() {
            let shape = shape(&checked(&model), &found, index, 9);
            let moved = shape.w.iter().chain(&shape.psi).chain(&shape.v);
            let moved = moved.chain(shape.masses.iter().flatten());
            assert!(moved.map(|z| z.norm()).fold(0.0, f64::max) > 0.0, "{index}");
        }
        for of in shares(&checked(&model), &found, &NEVER).unwrap() {
            let sum = of.bending_y + of.bending_z + of.twist + of.subsystems + of.supports;
            assert_close(sum, 1.0, 1e-12);
        }
    }
}

/// Closed form: the same beam about another axis. The supports hold the same points, and twist with the slopes.
#[test]
fn an_axis_off_the_shear_centre_changes_no_mode() {
    let offset = Point { y: -0.04, z: 0.07 };
    let held = |restraint: Restraint, point: Point| {
        let mut support = Support::FREE;
        for motion in [BeamMotion::W, BeamMotion::Psi, BeamMotion::V] {
            support[motion] = restraint.clone();
        }
        support.point = point;
        support
    };
    let elastic = Restraint::Elastic(Elastic {
        spring: Spring {
            stiffness: 3e4,
            damping: 20.0,
            ..Spring::default()
        },
        inertia: 0.2,
    });
    let about = |axis: Point| {
        let point = |y: f64, z: f64| Point {
            y: y + axis.y,
            z: z + axis.z,
        };
        let mut model = unsymmetric(
            1.5,
            Support::CLAMPED,
            held(elastic.clone(), point(0.02, 0.01)),
        );
        model.beam.axial_force = 3e3;
        model.supports.inner.push(InnerSupport {
            name: "bearing".into(),
            position: 0.9,
            support: held(Restraint::Fixed, point(-0.05, 0.03)),
        });
        let spring = Spring {
            stiffness: 1e4,
            ..Spring::default()
        };
        let mut mass = mass_on_springs(0.5, spring);
        // Only along y: springs along z are in pairs about the axis.
        (mass.z_left, mass.z_right) = (Spring::default(), Spring::default());
        mass.mount_z = 0.06 + axis.z;
        model.subsystems.push(mass);
        model
    };
    let expected = all(&about(Point::AXIS), 500.0);
    assert!(expected.len() > 8, "{expected:?}");
    for lengths in [vec![1.5], vec![0.5, 0.4, 0.6]] {
        let spans = lengths.into_iter().map(|length| Span {
            length,
            offset,
            ..Span::default()
        });
        let found = all(&with_spans(about(offset), spans.collect()), 500.0);
        assert_same(&found, &expected, 1e-9);
    }
}

/// Closed form: a mirror changes no mode; also where one of two halves has no warping stiffness.
#[test]
fn mirrored_halves_have_the_same_modes() {
    for warping in [1.0, 0.0] {
        let model = unsymmetric(1.5, Support::CLAMPED, Support::PINNED);
        let section = model.beam.section;
        let mut stiff = scaled(&section, 2.0, 70.0);
        stiff.warping_constant *= warping;
        let mut spans = vec![span(0.6, section), span(0.9, stiff)];
        spans[0].offset = Point { y: 0.02, z: 0.03 };
        let mut mirrored = model.clone();
        mirrored.supports.left = model.supports.right.clone();
        mirrored.supports.right = model.supports.left.clone();
        let expected = all(&with_spans(model, spans.clone()), 500.0);
        assert!(expected.len() > 5, "{expected:?}");
        spans.reverse();
        assert_same(&all(&with_spans(mirrored, spans), 500.0), &expected, 1e-9);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, rng_seed: prop::test_runner::RngSeed::Fixed(8), failure_persistence: None, ..ProptestConfig::default() })]

    /// Closed form: a beam that is cut into equal spans is the same beam.
    #[test]
    fn a_beam_in_equal_spans_has_the_same_modes(model in models(), share in 0.05..0.95, other in 0.05..0.95) {
        let Beam { length, section, .. } = model.beam;
        let [first, last] = if share < other { [share, other] } else { [other, share] };
        let cut = [first, last - first, 1.0 - last].map(|share| span(share * length, section));
        prop_assume!(cut.iter().all(|span| span.length > 1e-3));
        let spans = with_spans(model.clone(), cut.to_vec());
        // Otherwise what stands at the right end is beyond it by rounding.
        prop_assume!(spans.length() >= length);
        let (expected, found) = (all(&model, 300.0), all(&spans, 300.0));
        prop_assert_eq!(expected.len(), found.len());
        for (found, expected) in found.iter().zip(&expected) {
            prop_assert!((found - expected).abs() <= 1e-8 * expected, "{} {}", found, expected);
        }
    }
}
