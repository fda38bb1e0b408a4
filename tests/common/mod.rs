//! Random damped models for the property tests.

use beamtune::model::{
    Beam, BeamMotion, Bedding, Elastic, Force, Foundation, InnerSupport, Joint, Link, MassMotion,
    Material, MaxwellBranch, Measure, Model, Place, Point, Quantity, Response, Restraint, Section,
    Spacing, Spring, SpringId, Subsystem, Support, Supports, Sweep, Target, Theory,
};
use num_complex::Complex64;
use proptest::prelude::*;
use proptest::test_runner::TestRng;
use std::ops::Range;
use std::sync::atomic::AtomicBool;

/// The length of every beam here, m.
pub const LENGTH: f64 = 3.2;

/// A beam of the paper's section, with a loss factor, with or without warping and offset.
fn beams() -> impl Strategy<Value = Beam> {
    (
        0.001..0.05,
        prop_oneof![Just(0.0), 1e-9..1e-7],
        prop_oneof![Just(0.0), -0.1..0.1],
    )
        .prop_map(|(loss_factor, warping_constant, centroid_offset)| Beam {
            length: LENGTH,
            material: Material {
                young_modulus: 2.1e11,
                shear_modulus: 8e10,
                density: 7850.0,
                loss_factor,
            },
            section: Section {
                area: 0.0116,
                second_moment_y: 1.6625e-4,
                second_moment_z: 1.3745e-4,
                torsion_constant: 4.7657e-7,
                warping_constant,
                polar_moment: 5.9992e-4,
                centroid_offset,
                ..Default::default()
            },
            ..Default::default()
        })
}

/// The same, half of them without any symmetry, with another theory of bending, under an axial force or on
/// a foundation.
fn any_beams() -> impl Strategy<Value = Beam> {
    let maybe = |range: std::ops::Range<f64>| prop_oneof![Just(0.0), range];
    let general = (
        maybe(-0.1..0.1),
        maybe(-1e-4..1e-4),
        maybe(-2e5..2e6),
        prop::sample::select(Theory::ALL.to_vec()),
        any::<bool>(),
        prop_oneof![Just([0.0; 3]), [1e4..1e8, 10.0..1e4, 0.0..0.2]],
    );
    (beams(), prop::option::of(general)).prop_map(|(beam, general)| {
        let Some((
            centroid_offset_y,
            product_moment,
            axial_force,
            theory,
            warping_inertia,
            [stiffness, damping, loss_factor],
        )) = general
        else {
            return beam;
        };
        let bedding = Bedding {
            stiffness,
            damping,
            loss_factor,
        };
        Beam {
            theory,
            warping_inertia,
            axial_force,
            foundation: Foundation {
                w: bedding,
                psi: Bedding::default(),
                v: Bedding {
                    stiffness: 0.3 * stiffness,
                    ..bedding
                },
            },
            section: Section {
                centroid_offset_y,
                product_moment,
                shear_area_y: 6e-3,
                shear_area_z: 4e-3,
                ..beam.section
            },
            ..beam
        }
    })
}

/// Free, fixed or elastic, with some loss factors.
fn restraints(loss_factors: BoxedStrategy<f64>) -> impl Strategy<Value = Restraint> {
    let inertia = prop_oneof![Just(0.0), 0.0..5.0];
    let elastic = (1e4..1e8, 0.0..1e3, loss_factors, inertia).prop_map(
        |(stiffness, damping, loss_factor, inertia)| {
            Restraint::Elastic(Elastic {
                spring: Spring {
                    stiffness,
                    damping,
                    loss_factor,
                    ..Spring::default()
                },
                inertia,
            })
        },
    );
    prop_oneof![2 => Just(Restraint::Free), 1 => Just(Restraint::Fixed), 2 => elastic]
}

/// Those of springs: 0 for half of them.
fn loss_factors() -> BoxedStrategy<f64> {
    prop_oneof![Just(0.0), 0.0..0.2].boxed()
}

fn supports_on_axis(loss_factors: BoxedStrategy<f64>) -> impl Strategy<Value = Support> {
    prop::array::uniform6(restraints(loss_factors)).prop_map(Support::on_axis)
}

fn supports_at_points() -> impl Strategy<Value = Support> {
    let arm = || prop_oneof![Just(0.0), -0.2..0.2];
    (supports_on_axis(loss_factors()), arm(), arm()).prop_map(|(support, y, z)| Support {
        point: Point { y, z },
        ..support
    })
}

/// Up to two supports between the ends, at different positions.
fn inner_supports() -> impl Strategy<Value = Vec<InnerSupport>> {
    let places = [0.02..0.48 * LENGTH, 0.52 * LENGTH..0.98 * LENGTH];
    let one = |place: Range<f64>, name: &'static str| {
        let holds = |support: &Support| support.kind() != "free";
        let support = supports_at_points().prop_filter("holds nothing", holds);
        let inner = (place, support).prop_map(|(position, support)| InnerSupport {
            name: name.to_owned(),
            position,
            support,
        });
        prop::option::of(inner)
    };
    let [first, second] = places;
    (one(first, "B1"), one(second, "B2"))
        .prop_map(|(first, second)| first.into_iter().chain(second).collect())
}

/// Up to two joints with one or two motions that are not rigid.
fn joints() -> impl Strategy<Value = Vec<Joint>> {
    let elastic =
        (1e4..1e8, 0.0..1e3, loss_factors()).prop_map(|(stiffness, damping, loss_factor)| {
            Link::Elastic(Spring {
                stiffness,
                damping,
                loss_factor,
                ..Spring::default()
            })
        });
    let link = prop_oneof![1 => Just(Link::Free), 3 => elastic];
    let motion = || prop::sample::select(BeamMotion::ALL.to_vec());
    let one = |place: Range<f64>| {
        let joint = (place, motion(), motion(), link.clone(), link.clone());
        let joint = joint.prop_map(|(position, first, second, one, other)| {
            let mut joint = Joint {
                position,
                ..Joint::default()
            };
            joint[first] = one;
            joint[second] = other;
            joint
        });
        prop::option::weighted(0.4, joint)
    };
    (
        one(0.3 * LENGTH..0.45 * LENGTH),
        one(0.45 * LENGTH..0.95 * LENGTH),
    )
        .prop_map(|(first, second)| first.into_iter().chain(second).collect())
}

fn springs(loss_factors: BoxedStrategy<f64>) -> impl Strategy<Value = Spring> {
    prop_oneof![
        1 => Just(Spring::default()),
        5 => (1e5..3e7, 1.0..200.0, loss_factors)
            .prop_map(|(stiffness, damping, loss_factor)| Spring { stiffness, damping, loss_factor, ..Spring::default() }),
    ]
}

/// A subsystem anywhere on the beam, ends included.
pub fn subsystems() -> impl Strategy<Value = Subsystem> {
    subsystems_with(&loss_factors())
}

fn subsystems_with(loss_factors: &BoxedStrategy<f64>) -> impl Strategy<Value = Subsystem> + use<> {
    let springs = || springs(loss_factors.clone());
    let place = prop_oneof![1 => Just(0.0), 1 => Just(LENGTH), 8 => 0.0..LENGTH];
    let springs = (springs(), springs(), springs(), springs());
    (
        place,
        1.0..300.0,
        1.0..100.0,
        springs,
        (0.05..0.4, 0.05..0.4),
        (0.05..0.2, -0.1..0.1),
    )
        .prop_map(
            |(position, mass, inertia, springs, (arm_left, arm_right), (mount_y, mount_z))| {
                Subsystem {
                    name: String::new(),
                    enabled: true,
                    position,
                    mass,
                    inertia,
                    y_left: springs.0,
                    y_right: springs.1,
                    z_left: springs.2,
                    z_right: springs.3,
                    arm_left,
                    arm_right,
                    mount_y,
                    mount_z,
                }
            },
        )
}

/// Models of any beams.
#[allow(dead_code, reason = "not every test program uses it")]
pub fn models() -> impl Strategy<Value = Model> {
    let supports = (supports_at_points(), supports_at_points(), inner_supports());
    models_with(
        any_beams(),
        supports.boxed(),
        joints().boxed(),
        subsystems(),
    )
}

/// The same with Maxwell branches in a third of the springs.
#[allow(dead_code, reason = "not every test program uses it")]
pub fn models_with_branches() -> impl Strategy<Value = Model> {
    models().prop_perturb(|mut model, mut random| {
        let places: Vec<SpringId> = SpringId::all(&model).collect();
        for place in places {
            if let Some(spring) = place.spring_mut(&mut model)
                && spring.stiffness > 0.0
                && random.random_range(0..3) == 0
            {
                let branch = |random: &mut TestRng| MaxwellBranch {
                    stiffness: spring.stiffness * random.random_range(0.1..2.0),
                    damping: 10.0_f64.powf(random.random_range(1.0..5.0)),
                };
                let count = random.random_range(1..3);
                spring.maxwell = (0..count).map(|_| branch(&mut random)).collect();
            }
        }
        model
    })
}

/// Models of beams whose v is on its own, as the paper's, held at its ends by springs without a loss factor.
#[allow(dead_code, reason = "not every test program uses it")]
pub fn models_of_one_offset() -> impl Strategy<Value = Model> {
    let on_axis = || supports_on_axis(Just(0.0).boxed());
    let supports = (on_axis(), on_axis(), Just(Vec::new()));
    let subsystems = subsystems_with(&Just(0.0).boxed());
    let joints = Just(Vec::new()).boxed();
    models_with(beams(), supports.boxed(), joints, subsystems)
}

/// A damped model with up to four subsystems named S1, S2, ..., without forces and responses.
fn models_with(
    beams: impl Strategy<Value = Beam>,
    supports: BoxedStrategy<(Support, Support, Vec<InnerSupport>)>,
    joints: BoxedStrategy<Vec<Joint>>,
    subsystems: impl Strategy<Value = Subsystem>,
) -> impl Strategy<Value = Model> {
    let subsystems = prop::collection::vec(subsystems, 0..=4);
    let all = (beams, supports, joints, subsystems);
    all.prop_map(|(beam, (left, right, inner), joints, mut subsystems)| {
        for (index, subsystem) in subsystems.iter_mut().enumerate() {
            subsystem.name = format!("S{}", index + 1);
        }
        Model {
            beam,
            supports: Supports { left, right, inner },
            joints,
            subsystems,
            sweep: Sweep {
                from: 1.0,
                to: 100.0,
                points: 2,
                spacing: Spacing::Linear,
            },
            ..Model::default()
        }
    })
}

/// A motion of the beam between its ends, or of a mass.
pub fn targets() -> impl Strategy<Value = Target> {
    let motion = prop_oneof![
        Just(BeamMotion::W),
        Just(BeamMotion::Psi),
        Just(BeamMotion::V),
        Just(BeamMotion::WSlope),
        Just(BeamMotion::VSlope),
    ];
    let mass = prop_oneof![
        Just(MassMotion::Y),
        Just(MassMotion::Z),
        Just(MassMotion::Theta)
    ];
    prop_oneof![
        3 => (0.01..LENGTH - 0.01, motion).prop_map(|(x, motion)| Target::Beam(Place::Position(x), motion)),
        1 => mass.prop_map(|motion| Target::Mass("S1".into(), motion)),
    ]
}

/// Whether a model contains the place of a target.
pub fn exists(model: &Model, target: &Target) -> bool {
    matches!(target, Target::Beam(..)) || !model.subsystems.is_empty()
}

/// A load of amplitude 1.
pub fn unit_force(target: Target) -> Force {
    Force {
        enabled: true,
        target,
        amplitude: 1.0,
        phase: 0.0,
        point: Point::AXIS,
    }
}

/// The displacement at each target under forces, at one frequency in Hz.
pub fn respond(model: &Model, forces: Vec<Force>, at: &[Target], hertz: f64) -> Vec<Complex64> {
    let on_axis = |target: &Target| (target.clone(), Point::AXIS);
    let at: Vec<_> = at.iter().map(on_axis).collect();
    respond_at_points(model, forces, &at, hertz)
}

/// The same at points of the section.
pub fn respond_at_points(
    model: &Model,
    forces: Vec<Force>,
    at: &[(Target, Point)],
    hertz: f64,
) -> Vec<Complex64> {
    let responses = at
        .iter()
        .enumerate()
        .map(|(index, (target, point))| Response {
            name: format!("R{index}"),
            enabled: true,
            quantity: Quantity::Motion(target.clone(), Measure::Displacement),
            point: *point,
            over: None,
        });
    let model = Model {
        forces,
        responses: responses.collect(),
        ..model.clone()
    };
    let model = beamtune::model::Checked::new(model).unwrap();
    let frf = beamtune::solve::sweep(&model, &[hertz], &AtomicBool::new(false)).unwrap();
    frf.columns.iter().map(|column| column.values[0]).collect()
}

/// Frequencies in Hz, spread evenly over the decades.
pub fn frequencies() -> impl Strategy<Value = f64> {
    (0.0..3.5_f64).prop_map(|decades| 10f64.powf(decades))
}
