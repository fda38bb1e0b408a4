use num_complex::Complex64;
use proptest::prelude::*;

use super::blocked::Blocked;
use super::characteristic::Characteristic;
use super::with_damping_times;
use super::wittrick_williams::Counter;
use crate::model::{
    Beam, Bedding, Elastic, Foundation, InnerSupport, Joint, Link, Material, Model, Point,
    Restraint, Section, Spacing, Span, Spring, Subsystem, Support, Supports, Sweep, Theory,
};
use crate::presets;

/// Expected: the characteristic function, which comes from the waves, changes its sign at each mode of the count, which
/// comes from power series and matrix inertia.
fn assert_agree(model: &Model, frequencies: impl Iterator<Item = f64>) {
    let model = with_damping_times(model, 0.0);
    let counter = Counter::new(&model);
    let characteristic = Characteristic::new(&model);
    let mut signs = Vec::new();
    for hertz in frequencies {
        let omega = std::f64::consts::TAU * hertz;
        let count = counter.below(omega);
        let value = characteristic.at(&[Complex64::from(omega)])[0].direction;
        assert!(value.im.abs() < 1e-3, "{hertz} Hz: {value} is not real");
        let parity = if count.is_multiple_of(2) { 1.0 } else { -1.0 };
        signs.push(parity * value.re.signum());
        assert_eq!(
            signs[0],
            parity * value.re.signum(),
            "{hertz} Hz: {count} modes"
        );
    }
}

#[test]
fn the_count_and_the_characteristic_function_agree_on_every_preset() {
    for preset in presets::ALL {
        let model = crate::model::read(preset.text).unwrap().into_inner();
        println!("{}", preset.name);
        assert_agree(
            &model,
            (0..200).map(|step| 0.3 * (1.0 + 0.0513 * f64::from(step)).powi(3)),
        );
    }
}

/// Closed form: a beam that is cut into equal spans has the same characteristic function, also where a mass is blocked.
#[test]
fn the_characteristic_function_of_a_beam_in_equal_spans_is_that_of_the_beam() {
    for name in ["fig05a", "hundred_absorbers"] {
        let model = crate::model::read(presets::find(name).unwrap().text)
            .unwrap()
            .into_inner();
        let whole = with_damping_times(&model, 0.0);
        let mut cut = whole.clone();
        cut.beam.length = 0.0;
        cut.spans = [0.3, 0.3, 0.4]
            .map(|share| Span {
                length: share * whole.beam.length,
                section: Some(whole.beam.section),
                ..Span::default()
            })
            .to_vec();
        let masses = Blocked::new(&whole).roots;
        let masses = masses.iter().filter(|root| root.re > 0.0);
        let mut omegas: Vec<Complex64> = masses.map(|root| root.re.into()).collect();
        omegas.push(Complex64::from(777.0));
        let [found, expected] = [&cut, &whole].map(|model| Characteristic::new(model).at(&omegas));
        for ((found, expected), omega) in found.iter().zip(&expected).zip(&omegas) {
            let ratio = (found.log - expected.log).exp();
            let difference = (found.direction * ratio - expected.direction).norm();
            assert!(
                difference < 1e-6,
                "{name}, {omega} rad/s: {found:?} {expected:?}"
            );
        }
    }
}

fn beams() -> impl Strategy<Value = Beam> {
    let warping = prop_oneof![Just(0.0), 1e-11..1e-7];
    let offset = prop_oneof![Just(0.0), -0.15..0.15, 1e-9..1e-3];
    let general = (
        prop_oneof![Just(0.0), -0.1..0.1],
        prop_oneof![Just(0.0), -0.9..0.9],
        prop_oneof![Just(0.0), 0.0..1e7],
        prop::sample::select(Theory::ALL.to_vec()),
        any::<bool>(),
    );
    let general = prop_oneof![
        Just((0.0, 0.0, 0.0, Theory::EulerBernoulli, false)),
        general
    ];
    (0.5..8.0, warping, offset, 1e-5..3e-4, general).prop_map(
        |(length, warping, offset, second, (offset_y, product, axial_force, theory, warps))| Beam {
            length,
            axial_force,
            foundation: Foundation {
                v: Bedding {
                    stiffness: if warps { 1e7 } else { 0.0 },
                    ..Bedding::default()
                },
                ..Foundation::default()
            },
            warping_inertia: warps,
            theory,
            material: Material {
                young_modulus: 2.1e11,
                shear_modulus: 8e10,
                density: 7850.0,
                loss_factor: 0.0,
            },
            section: Section {
                area: 0.0116,
                second_moment_y: 1.6625e-4,
                second_moment_z: second,
                torsion_constant: 4.7657e-7,
                warping_constant: warping,
                polar_moment: 5.9992e-4,
                centroid_offset: offset,
                centroid_offset_y: offset_y,
                product_moment: product * (1.6625e-4 * second).sqrt(),
                shear_area_y: 6e-3,
                shear_area_z: 4e-3,
            },
        },
    )
}

/// Shares of the length and what they are made of, some like the whole beam; none on a uniform beam. Their theory is that
/// of the whole beam.
fn spans() -> impl Strategy<Value = Vec<(f64, Span)>> {
    let offset = || prop_oneof![Just(0.0), -0.2..0.2];
    let own = (beams(), offset(), offset(), 0.2..2.0);
    let own = own.prop_map(|(beam, y, z, factor)| {
        let material = Material {
            young_modulus: factor * beam.material.young_modulus,
            ..beam.material
        };
        let offset = if beam.section.warping_constant == 0.0 {
            Point::AXIS
        } else {
            Point { y, z }
        };
        Span {
            axial_force: Some(beam.axial_force),
            material: Some(material),
            section: Some(beam.section),
            foundation: Some(beam.foundation),
            offset,
            ..Span::default()
        }
    });
    let span = prop_oneof![1 => Just(Span::default()), 4 => own];
    let spans = prop::collection::vec((0.1..1.0, span), 2..4);
    prop_oneof![1 => Just(Vec::new()), 1 => spans]
}

fn restraints() -> impl Strategy<Value = Restraint> {
    let inertia = prop_oneof![Just(0.0), 0.0..50.0];
    let elastic = (1.0..10.0, inertia).prop_map(|(power, inertia)| {
        Restraint::Elastic(Elastic {
            spring: Spring {
                stiffness: 10.0_f64.powf(power),
                ..Spring::default()
            },
            inertia,
        })
    });
    prop_oneof![2 => Just(Restraint::Free), 1 => Just(Restraint::Fixed), 2 => elastic]
}

fn subsystems() -> impl Strategy<Value = Subsystem> {
    let spring = prop_oneof![
        1 => Just(0.0),
        4 => (2.0..8.0_f64).prop_map(|power| 10.0_f64.powf(power)),
    ]
    .prop_map(|stiffness| Spring {
        stiffness,
        ..Spring::default()
    });
    let place = prop_oneof![
        Just(0.0),
        Just(1.0),
        Just(0.3),
        Just(0.300_000_1),
        Just(OF_AN_END),
        0.0..1.0
    ];
    let inertia = prop_oneof![Just(0.0), 0.01..50.0];
    let lengths = prop::array::uniform4(-0.4..0.4);
    (
        place,
        0.1..500.0,
        inertia,
        prop::array::uniform4(spring),
        lengths,
    )
        .prop_map(
            |(position, mass, inertia, [y_left, y_right, z_left, z_right], lengths)| Subsystem {
                name: String::new(),
                enabled: true,
                position,
                mass,
                inertia,
                y_left,
                y_right,
                z_left,
                z_right,
                arm_left: lengths[0],
                arm_right: lengths[1],
                mount_y: lengths[2],
                mount_z: lengths[3],
            },
        )
}

/// The place, from 0 to 1, that stands for the end of the first span.
const OF_AN_END: f64 = 0.7;

/// Some at the places of supports and subsystems, all at different ones, from 0 to 1.
fn joints() -> impl Strategy<Value = Vec<Joint>> {
    let elastic = (1.0..10.0).prop_map(|power| {
        Link::Elastic(Spring {
            stiffness: 10.0_f64.powf(power),
            ..Spring::default()
        })
    });
    let link = prop_oneof![6 => Just(Link::Rigid), 1 => Just(Link::Free), 2 => elastic];
    let place = prop_oneof![Just(0.3), Just(OF_AN_END), 0.01..0.99];
    let joint = (place, prop::array::uniform6(link))
        .prop_map(|(position, links)| Joint { position, links });
    prop::collection::vec(joint, 0..4).prop_map(|mut joints| {
        joints.sort_by(|a, b| a.position.total_cmp(&b.position));
        joints.dedup_by(|one, other| one.position == other.position);
        joints
    })
}

fn models() -> impl Strategy<Value = Model> {
    let arm = || prop_oneof![Just(0.0), -0.2..0.2];
    let support = move || {
        (prop::array::uniform6(restraints()), arm(), arm()).prop_map(|(restraints, y, z)| Support {
            restraints,
            point: Point { y, z },
        })
    };
    let place = prop_oneof![Just(0.3), Just(OF_AN_END), 0.01..0.99];
    let inner = (place, support());
    // Different places: two supports cannot fix the same motion.
    let inner = prop::collection::vec(inner, 0..3).prop_map(|mut inner| {
        inner.dedup_by(|one, other| one.0 == other.0);
        inner
    });
    let masses = prop::collection::vec(subsystems(), 0..6);
    let ends = (support(), support());
    let all = (beams(), spans(), ends, inner, joints(), masses);
    all.prop_map(
        |(mut beam, spans, (left, right), inner, mut joints, mut subsystems)| {
            let sum: f64 = spans.iter().map(|(share, _)| share).sum();
            let spans = spans.into_iter().map(|(share, span)| Span {
                length: share / sum * beam.length,
                ..span
            });
            let spans: Vec<Span> = spans.collect();
            let length = beam.length;
            let position = |place: f64| match spans.first() {
                Some(first) if place == OF_AN_END => first.length,
                Some(_) | None => place * length,
            };
            for joint in &mut joints {
                joint.position = position(joint.position);
            }
            let inner = inner.into_iter().map(|(place, support)| InnerSupport {
                name: String::new(),
                position: position(place),
                support,
            });
            let inner = inner.collect();
            for subsystem in &mut subsystems {
                subsystem.position = position(subsystem.position);
            }
            if !spans.is_empty() {
                beam.length = 0.0;
            }
            Model {
                beam,
                supports: Supports { left, right, inner },
                spans,
                joints,
                subsystems,
                sweep: Sweep {
                    from: 1.0,
                    to: 300.0,
                    points: 2,
                    spacing: Spacing::Linear,
                },
                ..Model::default()
            }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, rng_seed: prop::test_runner::RngSeed::Fixed(11), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_count_and_the_characteristic_function_agree(model in models(), start in 0.9..1.1) {
        assert_agree(&model, (0..40).map(|step| 2.0 * start * (1.0 + 0.1 * f64::from(step)).powi(3)));
    }

    /// Expected: the count below a low frequency equals the number of rigid motions.
    #[test]
    fn the_modes_at_zero_are_the_rigid_motions(model in models()) {
        let counter = Counter::new(&model);
        prop_assert_eq!(counter.below(1e-3), counter.rigid());
    }
}
