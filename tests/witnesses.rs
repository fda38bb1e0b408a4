//! The two independent methods, compared with the exact solution: finite elements, and the paper's chain of transfer
//! matrices.
//!
//! Expected values are the exact solution's, which `high_precision.rs` compares with a solution of the state equation
//! in ball arithmetic. The finite elements must converge to them with the fourth power of the elements' length, the
//! order of Hermite's cubics in bending (Strang & Fix 1973, Section 4.4: 2 (4 - 2) for frequencies).

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "common/checked.rs"]
mod checked;
#[path = "common/quantities.rs"]
mod quantities;

use checked::checked;
use std::sync::atomic::AtomicBool;

use beamtune::model::{
    self, BeamMotion, Bedding, Elastic, Foundation, InnerSupport, Joint, Link, MassMotion,
    Material, Measure, Model, Place, Point, Quantity, Reaction, Response, Restraint, Section, Span,
    Spring, Support, SupportId, Target, Theory,
};
use beamtune::solve::Cancelled;
use beamtune::solve::compare::differences;
use beamtune::solve::fem::{self, FiniteElements};
use beamtune::solve::sensitivity::Differentiator;
use beamtune::solve::transfer_matrix::{self, NotApplicable};
use beamtune::{presets, solve};
use num_complex::Complex64;

fn preset(name: &str) -> Model {
    model::read(presets::find(name).unwrap().text)
        .unwrap()
        .into_inner()
}

fn never() -> AtomicBool {
    AtomicBool::new(false)
}

/// The largest relative difference of finite elements from the exact solution.
fn difference(model: &Model, mesh: &FiniteElements, hertz: &[f64]) -> f64 {
    let exact = solve::sweep(&checked(model), hertz, &never()).unwrap();
    let frf = mesh.sweep(hertz, &never()).unwrap();
    let all = differences(&checked(model), &exact, &frf)
        .into_iter()
        .flatten();
    all.map(|difference| difference.expect("a finite exact response").relative)
        .fold(0.0, f64::max)
}

/// Compares a model with the exact solution: with `elements` within `tolerance`, with twice as many closer by the
/// fourth power.
fn hold(name: &str, model: &Model, elements: usize, hertz: &[f64], tolerance: f64) {
    assert_eq!(model::check(model), [], "{name}");
    let mesh = FiniteElements::new(model, elements);
    let coarse = difference(model, &mesh, hertz);
    let fine = difference(model, &mesh.halved(), hertz);
    let order = (coarse / fine).log2();
    assert!(coarse < tolerance, "{name}: {coarse:e}");
    assert!(order > 3.7, "{name}: {coarse:e} {fine:e}, order {order}");
}

/// Frequencies between the resonances and on their slopes.
const HERTZ: [f64; 7] = [3.0, 17.0, 41.0, 88.0, 133.0, 240.0, 390.0];

fn beam(place: Place, motion: BeamMotion) -> Target {
    Target::Beam(place, motion)
}

fn force(target: Target, amplitude: f64) -> model::Force {
    model::Force {
        enabled: true,
        target,
        amplitude,
        phase: 30.0,
        point: beamtune::model::Point::AXIS,
    }
}

fn respond(target: Target) -> Response {
    Response {
        name: format!("{target:?}"),
        enabled: true,
        quantity: Quantity::Motion(target, Measure::Displacement),
        point: beamtune::model::Point::AXIS,
        over: None,
    }
}

/// The paper's beam with every kind of load and response.
fn loaded_everywhere() -> Model {
    let mut model = preset("fig05a");
    let inside = |x, motion| beam(Place::Position(x), motion);
    model.forces = vec![
        force(inside(0.55, BeamMotion::W), 1.0),
        force(inside(1.0, BeamMotion::WSlope), 0.4),
        force(inside(1.9, BeamMotion::VSlope), -0.7),
        force(inside(2.9, BeamMotion::Psi), 0.2),
        force(beam(Place::Right, BeamMotion::VSlope), 0.5),
        force(Target::Mass("S2".into(), MassMotion::Theta), 0.3),
        force(Target::Mass("S3".into(), MassMotion::Y), 0.3),
    ];
    let mut targets: Vec<Target> = BeamMotion::ALL
        .into_iter()
        .flat_map(|motion| {
            [
                inside(0.3, motion),
                inside(1.9, motion),
                beam(Place::Right, motion),
            ]
        })
        .collect();
    targets.extend(MassMotion::ALL.map(|motion| Target::Mass("S2".into(), motion)));
    model.responses = targets.into_iter().map(respond).collect();
    for measure in [Measure::Velocity, Measure::Acceleration] {
        model.responses.push(Response {
            name: format!("{measure:?}"),
            enabled: true,
            quantity: Quantity::Motion(Target::Mass("S1".into(), MassMotion::Z), measure),
            point: beamtune::model::Point::AXIS,
            over: None,
        });
    }
    model.responses.push(Response {
        name: "E_V".into(),
        enabled: true,
        quantity: Quantity::Energy,
        point: beamtune::model::Point::AXIS,
        over: None,
    });
    model
}

/// Springs, dampers and inertias on all six motions.
fn elastic() -> Support {
    let of = |stiffness, damping, inertia| {
        Restraint::Elastic(Elastic {
            spring: Spring {
                stiffness,
                damping,
                ..Spring::default()
            },
            inertia,
        })
    };
    Support::on_axis([
        of(4e7, 800.0, 12.0),
        of(1.5e6, 300.0, 0.4),
        of(3e7, 650.0, 7.5),
        of(2e6, 90.0, 0.9),
        of(4e3, 2.0, 1e-3),
        of(1e6, 40.0, 0.3),
    ])
}

#[test]
fn elements_agree_on_the_papers_figures() {
    for name in ["fig05a", "fig05b", "fig05c", "fig06", "fig08", "fig13"] {
        hold(name, &preset(name), 120, &HERTZ, 1e-2);
    }
}

/// Reactions of springs and of fixed motions, at and between the ends and off the axis, internal forces, springs and ratios.
#[test]
fn elements_agree_on_forces() {
    let mut model = loaded_everywhere();
    let mut support = Support::FREE;
    support[BeamMotion::W] = Restraint::Fixed;
    support[BeamMotion::Psi] = Restraint::Fixed;
    support[BeamMotion::V] = elastic()[BeamMotion::V].clone();
    support.point = Point { y: 0.05, z: -0.1 };
    model.supports.inner = vec![InnerSupport {
        name: "B".to_owned(),
        // Where a subsystem stands.
        position: model.subsystems[1].position,
        support,
    }];
    model.supports.left = elastic();
    model.supports.right[BeamMotion::V] = Restraint::Fixed;
    let places = [Place::Left, Place::Position(0.3), Place::Position(1.9)];
    let mut all = quantities::internal_forces(&places);
    all.extend(quantities::springs(&model));
    all.extend(quantities::reactions(&model));
    all.retain(|quantity| {
        // 0 along a free motion.
        let Quantity::Reaction(Reaction::Support(holder, motion)) = quantity else {
            return true;
        };
        let id = SupportId::all(&model).find(|id| id.name(&model) == holder.name());
        id.unwrap().support(&model)[*motion] != Restraint::Free
    });
    model.responses = all.into_iter().map(quantities::response).collect();
    let first = model.responses[0].name.clone();
    model.responses[20].over = Some(first);
    assert_eq!(model::check(&model), []);
    let mesh = FiniteElements::new(&model, 200);
    let found = difference(&model, &mesh, &HERTZ[..5]);
    assert!(found < 1e-3, "{found:e}");
}

#[test]
fn elements_agree_on_other_sections_and_supports() {
    hold("cantilever", &preset("cantilever"), 60, &HERTZ, 1e-4);
    let name = "symmetric_section";
    hold(name, &preset(name), 40, &[2.0, 30.0, 70.0, 150.0], 1e-4);
    let name = "semicircular_cantilever";
    hold(name, &preset(name), 40, &[12.0, 70.0, 300.0, 900.0], 1e-3);
    let name = "hundred_absorbers";
    hold(name, &preset(name), 150, &[11.0, 120.0, 450.0, 900.0], 1e-2);
}

#[test]
fn elements_agree_whatever_holds_the_ends() {
    let supports = [Support::FREE, Support::PINNED, Support::CLAMPED, elastic()];
    for left in supports {
        for right in [Support::FREE, elastic()] {
            let mut model = loaded_everywhere();
            (model.supports.left, model.supports.right) = (left.clone(), right.clone());
            model.beam.material.loss_factor = 0.02;
            let name = format!("{} {}", left.kind(), right.kind());
            hold(&name, &model, 120, &HERTZ, 1e-3);
        }
    }
}

/// A bearing off the axis, a spring to the ground there, and ends that are held off it, also where v couples with twist by
/// that alone; loads and responses on points of the section.
#[test]
fn elements_agree_whatever_holds_the_beam_between_its_ends() {
    for (warping, clamped) in [(true, true), (true, false), (false, true), (false, false)] {
        let mut model = loaded_everywhere();
        if !warping {
            model.beam.section.warping_constant = 0.0;
            // The slope of a twist without warping stiffness converges with the third power.
            let is_rate = |response: &Response| {
                let of = &response.quantity;
                matches!(
                    of,
                    Quantity::Motion(Target::Beam(_, BeamMotion::PsiSlope), _)
                )
            };
            model.responses.retain(|response| !is_rate(response));
        }
        let inner = |name: &str, position, support: Support, [y, z]: [f64; 2]| InnerSupport {
            name: name.to_owned(),
            position,
            support: Support {
                point: Point { y, z },
                ..support
            },
        };
        let mut bearing = Support::FREE;
        bearing[BeamMotion::W] = Restraint::Fixed;
        bearing[BeamMotion::V] = Restraint::Fixed;
        if clamped {
            bearing = Support::CLAMPED;
        }
        model.supports.inner = vec![
            inner("bearing", 1.1, bearing, [0.06, -0.1]),
            inner("spring", 2.3, elastic(), [-0.04, 0.08]),
        ];
        model.supports.left = Support {
            point: Point { y: 0.05, z: 0.0 },
            ..elastic()
        };
        model.supports.right[BeamMotion::W] = Restraint::Fixed;
        model.supports.right.point.z = -0.07;
        for force in model
            .forces
            .iter_mut()
            .filter(|force| force.target.has_point())
        {
            force.point = Point { y: -0.03, z: 0.09 };
        }
        for response in &mut model.responses {
            if matches!(&response.quantity, Quantity::Motion(target, _) if target.has_point()) {
                response.point = Point { y: 0.07, z: -0.02 };
            }
        }
        model.beam.material.loss_factor = 0.02;
        hold(&format!("{warping} {clamped}"), &model, 120, &HERTZ, 1e-2);
    }
}

/// Without warping stiffness the rate of twist jumps at a torque, and at a fixed end its boundary layer has no length.
#[test]
fn elements_agree_without_warping_stiffness() {
    for left in [Support::FREE, Support::PINNED, Support::CLAMPED, elastic()] {
        for centroid_offset in [0.0, -0.05] {
            let mut model = loaded_everywhere();
            (model.supports.left, model.supports.right) = (left.clone(), elastic());
            model.beam.material.loss_factor = 0.02;
            model.beam.section.warping_constant = 0.0;
            model.beam.section.centroid_offset = centroid_offset;
            let name = format!("{} {centroid_offset}", left.kind());
            hold(&name, &model, 120, &HERTZ, 1e-2);
        }
    }
}

/// Without warping stiffness a rate of twist that jumps, at a torque or at subsystems, is the mean of both sides, and
/// at an end its limit from inside, before everything there.
///
/// Expected: at the torque at 50 Hz -2.7763e-5 rad/m, from the state equation in ball arithmetic; a warping constant
/// with layers shorter than 1e-6 m; finite elements; the other recursion.
#[test]
fn a_rate_of_twist_that_jumps_is_the_mean_of_both_sides() {
    let mut model = model::read(include_str!("data/torque_without_warping.toml"))
        .unwrap()
        .into_inner();
    let value = |model: &Model, response: usize| {
        solve::sweep(&checked(model), &[50.0], &never())
            .unwrap()
            .columns[response]
            .values[0]
    };
    let at_torque = value(&model, 4);
    assert!((at_torque.re + 2.7763e-5).abs() < 1e-9, "{at_torque}");
    let subsystem = &preset("fig05b").subsystems[0];
    for (index, position) in [0.0, 1.0, 2.2, 2.2, 3.2].into_iter().enumerate() {
        model.subsystems.push(model::Subsystem {
            name: format!("S{index}"),
            position,
            ..subsystem.clone()
        });
    }
    let mut warping = model.clone();
    warping.beam.section.warping_constant = 1e-20;
    let mesh = FiniteElements::new(&model, 240);
    let elements = mesh.sweep(&[50.0], &never()).unwrap();
    let gradients = Differentiator::new(&checked(&model)).at(50.0.into());
    for (response, gradient) in gradients.iter().enumerate() {
        let exact = value(&model, response);
        let near = |other: Complex64, tolerance: f64| {
            assert!(
                (other - exact).norm() < tolerance * exact.norm(),
                "{response}: {exact} {other}"
            );
        };
        near(value(&warping, response), 1e-5);
        near(elements.columns[response].values[0], 1e-4);
        near(gradient.value, 1e-10);
    }
}

/// Subsystems at the ends, two at the same position, one without inertia, missing springs.
#[test]
fn elements_agree_on_subsystems_of_any_kind() {
    let mut model = loaded_everywhere();
    model.beam.material.loss_factor = 0.01;
    model.subsystems[0].position = 0.0;
    model.subsystems[1].position = 3.2;
    model.subsystems[2].position = 1.9;
    let mut twin = model.subsystems[2].clone();
    twin.name = "S4".into();
    twin.inertia = 0.0;
    twin.y_right.stiffness = 0.0;
    model.subsystems.push(twin);
    let mut hung = model.subsystems[2].clone();
    hung.name = "S5".into();
    (hung.z_left, hung.z_right) = Default::default();
    hung.inertia = 0.0;
    model.subsystems.push(hung);
    hold("subsystems", &model, 120, &HERTZ, 2e-3);
}

/// With the default mesh the difference is far below `validate`'s tolerance, on the sweep's own frequencies.
#[test]
fn the_default_mesh_is_fine_enough_for_every_preset() {
    for preset in presets::ALL {
        let mut model = model::read(preset.text).unwrap().into_inner();
        model.sweep.points = 40;
        let hertz = solve::frequencies(&model.sweep);
        let mesh = FiniteElements::new(&model, fem::default_elements(&checked(&model)));
        let found = difference(&model, &mesh, &hertz);
        assert!(found < 2e-3, "{}: {found:e}", preset.name);
    }
}

#[test]
fn elements_that_are_cancelled_give_nothing() {
    let model = preset("fig05a");
    assert_eq!(
        fem::sweep(&checked(&model), 20, &HERTZ, &AtomicBool::new(true)),
        Err(Cancelled)
    );
    let cancelled = transfer_matrix::sweep(&checked(&model), &HERTZ, &AtomicBool::new(true));
    assert_eq!(cancelled, Ok(Err(Cancelled)));
}

#[test]
fn without_loads_nothing_moves() {
    let mut model = preset("fig05a");
    model.forces.clear();
    let frf = fem::sweep(&checked(&model), 20, &HERTZ, &never()).unwrap();
    let all = || frf.columns.iter().flat_map(|column| &column.values);
    assert!(all().all(|value| value.norm() == 0.0));
}

/// Expected: closed form of a pinned beam's bending and of free torsion, `(n pi / L)^2 sqrt(E I / rho A)`; the discrete
/// ones are higher (Rayleigh) by a share of (k h)^4 / 1440.
#[test]
fn natural_frequencies_come_down_to_the_closed_form() {
    let mut model = preset("symmetric_section");
    model.subsystems.clear();
    model.forces.clear();
    model.responses.clear();
    let (section, material) = (model.beam.section, model.beam.material);
    let wave = std::f64::consts::PI / model.beam.length;
    let stiffness = material.young_modulus * section.second_moment_z.min(section.second_moment_y);
    let rate = (stiffness / (material.density * section.area)).sqrt();
    let exact = wave * wave * rate / std::f64::consts::TAU;
    let nearest = |elements| {
        let all = fem::natural_frequencies(&checked(&model), elements, 6);
        assert!(all.windows(2).all(|pair| pair[0] <= pair[1]), "{all:?}");
        let above = all.into_iter().map(|hertz| hertz / exact - 1.0);
        above.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap()
    };
    let (coarse, fine) = (nearest(4), nearest(8));
    let kh = wave * model.beam.length / 4.0;
    // The mesh has a node at every response, so it may be finer than requested.
    assert!(
        coarse > 0.0 && coarse < 1.1 * kh.powi(4) / 1440.0,
        "{coarse:e}"
    );
    assert!(
        fine > 0.0 && (coarse / fine).log2() > 3.7,
        "{coarse:e} {fine:e}"
    );
}

/// Expected: a free beam has two translations, two rotations and the twist; every mass adds to the count.
#[test]
fn rigid_body_motions_are_near_zero() {
    let mut model = preset("fig06");
    model.supports = model::Supports::default();
    let all = fem::natural_frequencies(&checked(&model), 20, 7);
    assert!(all[4] < 1e-2 && all[5] > 1.0, "{all:?}");
}

/// Expected: the modes of the high-precision solution of the preset's notes, 63.79, 137.69, 278.36, 484.78 and 663.84 Hz of w
/// and psi together, given to 0.01 Hz.
#[test]
fn natural_frequencies_are_those_of_the_literature_case() {
    let found = fem::natural_frequencies(&checked(&preset("semicircular_cantilever")), 40, 9);
    for expected in [63.79, 137.69, 278.36, 484.78, 663.84] {
        assert!(
            found.iter().any(|hertz| (hertz - expected).abs() < 0.006),
            "{expected}: {found:?}"
        );
    }
}

/// A beam of three spans: unlike sections and materials off the axis, and one without warping stiffness on it or
/// another one with it; with a bearing, a joint and a subsystem where they meet.
fn stepped(without_warping: bool) -> Model {
    let mut model = loaded_everywhere();
    model.beam.material.loss_factor = 0.02;
    let (section, material) = (model.beam.section, model.beam.material);
    let stiff = Section {
        second_moment_y: 2.0 * section.second_moment_y,
        product_moment: 4e-5,
        centroid_offset_y: 0.04,
        ..section
    };
    let slender = Section {
        area: 0.7 * section.area,
        second_moment_z: 0.5 * section.second_moment_z,
        torsion_constant: 0.4 * section.torsion_constant,
        warping_constant: if without_warping {
            0.0
        } else {
            0.6 * section.warping_constant
        },
        ..section
    };
    let span = |length, section, y, z| Span {
        length,
        offset: Point { y, z },
        section: Some(section),
        ..Span::default()
    };
    let z = if without_warping { 0.0 } else { 0.08 };
    model.spans = vec![
        span(1.0, stiff, -0.05, 0.03),
        span(1.2, slender, 0.0, z),
        span(1.0, section, 0.02, 0.0),
    ];
    model.spans[0].axial_force = Some(-2e5);
    model.spans[1].material = Some(Material {
        young_modulus: 0.4 * material.young_modulus,
        density: 0.5 * material.density,
        loss_factor: 0.1,
        ..material
    });
    model.spans[2].foundation = Some(Foundation {
        w: Bedding {
            stiffness: 2e6,
            damping: 300.0,
            loss_factor: 0.1,
        },
        ..Foundation::default()
    });
    // Where parts meet, by the sums of their lengths.
    let [first, second] = [1.0, 1.0 + 1.2];
    let mut bearing = Support::FREE;
    bearing[BeamMotion::V] = Restraint::Fixed;
    bearing.point = Point { y: 0.03, z: 0.0 };
    model.supports.inner = vec![InnerSupport {
        name: "bearing".to_owned(),
        position: first,
        support: bearing,
    }];
    let mut joint = Joint {
        position: second,
        ..Joint::default()
    };
    joint[BeamMotion::WSlope] = Link::Elastic(Spring {
        stiffness: 1e6,
        ..Spring::default()
    });
    model.joints = vec![joint];
    model.subsystems[1].position = second;
    for place in [first, second].map(Place::Position) {
        let targets = BeamMotion::ALL.map(|motion| beam(place, motion));
        model.responses.extend(targets.map(respond));
    }
    model
        .forces
        .push(force(beam(Place::Position(second), BeamMotion::Psi), 0.1));
    model.responses.retain(|response| {
        let of = &response.quantity;
        // The slope of a twist without warping stiffness converges with the third power.
        !without_warping
            || !matches!(
                of,
                Quantity::Motion(Target::Beam(_, BeamMotion::PsiSlope), _)
            )
    });
    for (index, response) in model.responses.iter_mut().enumerate() {
        response.name = index.to_string();
    }
    model
}

/// Expected: the elements of a stepped beam converge to the exact solution as those of a uniform one.
#[test]
fn elements_agree_on_beams_of_several_spans() {
    for without_warping in [false, true] {
        let mut model = stepped(without_warping);
        for theory in [Theory::EulerBernoulli, Theory::Rayleigh] {
            model.beam.theory = theory;
            let name = format!("{without_warping} {theory:?}");
            hold(&name, &model, 160, &HERTZ, 2e-3);
        }
    }
}

/// The section of Tanaka & Bercin 1997 without symmetry, times a factor, and its torsion constant times another one.
fn unsymmetric(factor: f64, of_torsion: f64) -> Section {
    Section {
        area: factor * 1.947 / 7800.0,
        second_moment_y: factor * 16680.0 / 200e9,
        second_moment_z: factor * 73480.0 / 200e9,
        torsion_constant: of_torsion * 10.81 / 80e9,
        warping_constant: factor * 26.34 / 200e9,
        polar_moment: factor * 5.90e-3 / 7800.0,
        centroid_offset: 0.02316,
        centroid_offset_y: 0.02625,
        ..Section::default()
    }
}

/// A bare beam of spans of a material, each a length, m, and a section.
fn bare(material: [f64; 3], spans: &[(f64, Section)]) -> Model {
    let mut model = preset("symmetric_section");
    model.subsystems.clear();
    model.forces.clear();
    model.responses.clear();
    let [young_modulus, shear_modulus, density] = material;
    model.beam.material = Material {
        young_modulus,
        shear_modulus,
        density,
        loss_factor: 0.0,
    };
    let spans = spans.iter().map(|&(length, section)| Span {
        length,
        section: Some(section),
        ..Span::default()
    });
    model.spans = spans.collect();
    model.supports = model::Supports::default();
    model
}

fn assert_frequencies(found: &[f64], expected: &[f64], within: f64) {
    for hertz in expected {
        let nearest = found.iter().map(|found| (found / hertz - 1.0).abs());
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        assert!(nearest < within, "{hertz}: {nearest:e} of {found:?}");
    }
}

/// Expected: a Ritz solution of high order (14 and 18 polynomials a span agree in all digits) of the section of Tanaka &
/// Bercin (Applied Mathematical Modelling 21, 1997) with a step at mid-span to a half of all and an eighth of G J.
#[test]
fn natural_frequencies_of_a_stepped_beam_without_symmetry() {
    let spans = [unsymmetric(1.0, 1.0), unsymmetric(0.5, 0.125)].map(|section| (0.75, section));
    let mut model = bare([200e9, 80e9, 7800.0], &spans);
    for (left, right, expected) in [
        (
            Support::CLAMPED,
            Support::FREE,
            [21.68277, 36.17247, 79.24896, 98.60506],
        ),
        (
            Support::PINNED,
            Support::PINNED,
            [42.58395, 71.97798, 158.08606, 176.96123],
        ),
    ] {
        (model.supports.left, model.supports.right) = (left, right);
        let found = fem::natural_frequencies(&checked(&model), 48, 4);
        assert_frequencies(&found, &expected, 1e-5);
    }
}

/// Expected: the same Ritz solution of a linear taper, `1 - x / 2L` on all and its cube on G J, which spans of the values at
/// their middles approximate with the second power of their length.
#[test]
fn natural_frequencies_of_a_tapered_beam_without_symmetry() {
    let expected = [19.77718, 32.94056, 72.14470, 103.79351, 178.11653];
    let errors = [8, 16].map(|count| {
        let spans: Vec<(f64, Section)> = (0..count)
            .map(|index| {
                let factor = 1.0 - (f64::from(index) + 0.5) / f64::from(2 * count);
                let section = unsymmetric(factor, factor.powi(3));
                (1.5 / f64::from(count), section)
            })
            .collect();
        let mut model = bare([200e9, 80e9, 7800.0], &spans);
        model.supports.left = Support::CLAMPED;
        let found = fem::natural_frequencies(&checked(&model), 64, 5);
        let errors = found
            .iter()
            .zip(expected)
            .map(|(found, of)| (found / of - 1.0).abs());
        errors.fold(0.0, f64::max)
    });
    assert!(errors[1] < 1e-3, "{errors:?}");
    assert!((errors[0] / errors[1]).log2() > 1.8, "{errors:?}");
}

/// Published: Koplow, Bhattacharyya & Mann, Journal of Sound and Vibration 295 (2006), 214-225: a free aluminium beam of two
/// thicknesses, 292.44, 1181.3 and 1804.1 Hz; the digits beyond from a Ritz solution of high order.
#[test]
fn natural_frequencies_of_koplows_stepped_beam() {
    let (width, material) = (0.0254_f64, [71.7e9, 26.9e9, 2830.0]);
    let spans = [(0.254, 0.01905_f64), (0.14, 0.00549)].map(|(length, thickness)| {
        let area = width * thickness;
        let (thin, wide) = (
            width * thickness.powi(3) / 12.0,
            thickness * width.powi(3) / 12.0,
        );
        let section = Section {
            area,
            second_moment_y: thin,
            second_moment_z: wide,
            torsion_constant: 4.0 * thin,
            polar_moment: thin + wide,
            ..Section::default()
        };
        (length, section)
    });
    let model = bare(material, &spans);
    let found = fem::natural_frequencies(&checked(&model), 40, 14);
    assert_frequencies(&found, &[292.443_786, 1_181.319_924, 1_804.087_158], 1e-5);
}

/// The least number of correct digits of the chain, over all responses, at each frequency.
fn digits(model: &Model, hertz: &[f64]) -> Vec<f64> {
    let exact = solve::sweep(&checked(model), hertz, &never()).unwrap();
    let frf = transfer_matrix::sweep(&checked(model), hertz, &never())
        .unwrap()
        .unwrap();
    let found = differences(&checked(model), &exact, &frf);
    (0..hertz.len())
        .map(|row| {
            let worst = found.iter().map(|column| column[row].unwrap().relative);
            -worst.fold(f64::MIN_POSITIVE, f64::max).log10()
        })
        .collect()
}

/// Expected: the sixteen digits less those lost to e^(2 beta l); the bounds are the result of double precision here,
/// with a margin.
#[test]
fn the_chain_is_right_at_low_frequencies_and_loses_all_digits_at_high_ones() {
    let mut model = preset("fig05a");
    model.responses.retain(|response| response.name == "P1 w");
    let left = digits(&model, &[10.0, 100.0, 350.0, 1000.0]);
    assert!(left[0] > 12.0, "{left:?}");
    assert!(left[1] > 10.0, "{left:?}");
    assert!(left[2] < 6.0, "{left:?}");
    assert!(left[3] < 1.0, "{left:?}");
}

#[test]
fn the_chain_takes_loads_at_ends_inside_and_on_subsystems() {
    for left in [Support::FREE, Support::PINNED, Support::CLAMPED, elastic()] {
        let mut model = loaded_everywhere();
        (model.supports.left, model.supports.right) = (left, elastic());
        model.beam.material.loss_factor = 0.02;
        let bimoment = beam(Place::Position(0.7), BeamMotion::PsiSlope);
        model.forces.push(force(bimoment, 0.1));
        let found = digits(&model, &[3.0, 40.0, 90.0]);
        assert!(found.iter().all(|digits| *digits > 7.0), "{found:?}");
    }
}

#[test]
fn the_chain_agrees_on_presets_at_low_frequencies() {
    for name in ["fig05b", "fig05c", "fig06", "fig08", "fig13", "cantilever"] {
        let found = digits(&preset(name), &[3.0, 10.0, 60.0]);
        assert!(
            found.iter().all(|digits| *digits > 7.5),
            "{name}: {found:?}"
        );
    }
}

#[test]
fn the_chain_says_where_the_papers_formulas_divide_by_zero() {
    let solve =
        |model: &Model| transfer_matrix::sweep(&checked(model), &[10.0], &never()).map(|_| ());
    assert_eq!(
        solve(&preset("symmetric_section")),
        Err(NotApplicable::NoOffset)
    );
    let mut model = preset("fig05a");
    model.beam.section.warping_constant = 0.0;
    assert_eq!(solve(&model), Err(NotApplicable::NoWarping));
    assert_eq!(solve(&stepped(false)), Err(NotApplicable::Spans));
}

/// Expected: the natural frequencies of the finite elements decrease to the exact ones (Rayleigh), with the fourth
/// power of the elements' length.
#[test]
fn natural_frequencies_come_down_to_the_exact_ones() {
    for name in [
        "fig05a",
        "fig06",
        "fig08",
        "cantilever",
        "semicircular_cantilever",
    ] {
        let model = preset(name);
        let exact = solve::modes::undamped(&checked(&model), 250.0, &never())
            .unwrap()
            .unwrap();
        assert!(exact.len() > 3, "{name}: {exact:?}");
        let errors = |elements| -> Vec<f64> {
            let found = fem::natural_frequencies(&checked(&model), elements, exact.len());
            let pairs = found.iter().zip(&exact);
            // Rigid-body modes are 0; the others' rounding is far below their discretisation here.
            pairs
                .filter(|(_, exact)| **exact > 0.1)
                .map(|(found, exact)| found / exact - 1.0)
                .collect()
        };
        let (coarse, fine) = (errors(16), errors(32));
        assert!(fine.iter().all(|error| *error > -1e-7), "{name}: {fine:?}");
        let worst = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
        let order = (worst(&coarse) / worst(&fine)).log2();
        assert!(
            worst(&fine) < 1e-3 && order > 3.5,
            "{name}: {coarse:?} {fine:?}"
        );
    }
}
