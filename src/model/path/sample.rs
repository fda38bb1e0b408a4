//! Models for tests.

use crate::model::beam::{Beam, BeamMotion, Bedding, Foundation, Material, Point, Section, Span};
use crate::model::quantity::{Quantity, Response};
use crate::model::spring::{Elastic, MaxwellBranch, Spring};
use crate::model::tuning::{Aim, Combine, Hold, Objective, Tune, Variable};
use crate::model::types::{
    Case, Family, Force, InnerSupport, Joint, Link, MassMotion, Model, Operation, Place, Restraint,
    Spacing, Study, Subsystem, Support, Supports, Sweep, Target,
};
use crate::unit::Measure;

/// The beam of the paper with one subsystem per name, and a few elements of every other list.
pub(in crate::model) fn model(names: &[&str]) -> Model {
    let count = names.len() as f64;
    let at = |index: usize| 3.2 * (index as f64 + 1.0) / (count + 1.0);
    Model {
        title: "Sample".to_owned(),
        notes: String::new(),
        beam: beam(),
        supports: supports(),
        spans: Vec::new(),
        joints: joints(),
        subsystems: names
            .iter()
            .enumerate()
            .map(|(index, name)| subsystem(name, at(index)))
            .collect(),
        forces: forces(names),
        responses: responses(names),
        sweep: Sweep {
            from: 1.0,
            to: 500.0,
            points: 2000,
            spacing: Spacing::Linear,
        },
        studies: vec![
            study(
                "Stiffness",
                "subsystems.*.y_left.stiffness",
                Operation::Multiply,
                &[0.5, 1.0, 2.0],
            ),
            study(
                "Ends",
                "supports.*.w.stiffness",
                Operation::Add,
                &[0.0, 1e6, -1e6],
            ),
            Study {
                name: "Cases".to_owned(),
                family: Family::Cases(cases(names)),
            },
        ],
        tune: Some(Tune {
            variables: vec![Variable {
                paths: vec!["subsystems.*.mass".into()],
                hold: Hold::Equal,
                min: 1.0,
                max: 1000.0,
                scale: None,
                tolerance: 0.0,
            }],
            objectives: vec![Objective {
                aim: Aim::Peak,
                response: Some("P5 w".to_owned()),
                from: 20.0,
                to: 120.0,
                weight: 1.0,
            }],
            combine: Combine::Sum,
            limits: Vec::new(),
        }),
    }
}

/// That model, and the same with a beam of spans.
pub(in crate::model) fn models(names: &[&str]) -> [Model; 2] {
    let mut spanned = model(names);
    spanned.spans = spans();
    spanned.beam.length = 0.0;
    [model(names), spanned]
}

/// Three spans, 3.2 m together: as the beam, with all of its own, with a section of its own.
fn spans() -> Vec<Span> {
    let Beam {
        material, section, ..
    } = beam();
    let bedding = Bedding {
        stiffness: 2.0e5,
        ..Bedding::default()
    };
    vec![
        Span {
            length: 1.2,
            ..Span::default()
        },
        Span {
            length: 1.5,
            offset: Point { y: 0.01, z: -0.02 },
            axial_force: Some(500.0),
            material: Some(Material {
                density: 2700.0,
                ..material
            }),
            section: Some(section),
            foundation: Some(Foundation {
                w: bedding,
                ..Foundation::default()
            }),
        },
        Span {
            length: 0.5,
            section: Some(Section {
                area: 0.01,
                ..section
            }),
            ..Span::default()
        },
    ]
}

fn beam() -> Beam {
    Beam {
        length: 3.2,
        material: Material {
            young_modulus: 2.1e11,
            shear_modulus: 8.0e10,
            density: 7850.0,
            loss_factor: 0.01,
        },
        section: Section {
            area: 0.0116,
            second_moment_y: 1.6625e-4,
            second_moment_z: 1.3745e-4,
            torsion_constant: 4.7657e-7,
            warping_constant: 2.2783e-8,
            polar_moment: 5.9992e-4,
            centroid_offset: 0.0619,
            ..Default::default()
        },
        ..Default::default()
    }
}

fn supports() -> Supports {
    let spring = Restraint::Elastic(Elastic {
        spring: Spring {
            stiffness: 4.0e7,
            damping: 800.0,
            ..Spring::default()
        },
        inertia: 0.5,
    });
    let mut left = Support::FREE;
    left[BeamMotion::W] = spring.clone();
    left[BeamMotion::Psi] = spring.clone();
    left[BeamMotion::V] = Restraint::Fixed;
    let mut right = Support::FREE;
    right[BeamMotion::W] = spring.clone();
    right[BeamMotion::PsiSlope] = spring.clone();
    let mut bearing = Support::FREE;
    bearing[BeamMotion::W] = spring;
    bearing[BeamMotion::V] = Restraint::Fixed;
    bearing.point.z = -0.05;
    let inner = vec![InnerSupport {
        name: "B1".to_owned(),
        position: 1.1,
        support: bearing,
    }];
    Supports { left, right, inner }
}

fn joints() -> Vec<Joint> {
    let mut hinge = Joint {
        position: 2.1,
        ..Joint::default()
    };
    hinge[BeamMotion::WSlope] = Link::Free;
    let mut coupling = Joint {
        position: 0.7,
        ..Joint::default()
    };
    coupling[BeamMotion::Psi] = Link::Elastic(Spring {
        stiffness: 3.0e5,
        damping: 12.0,
        loss_factor: 0.02,
        ..Spring::default()
    });
    vec![hinge, coupling]
}

fn subsystem(name: &str, position: f64) -> Subsystem {
    let spring = Spring {
        stiffness: 1.666_667e7,
        damping: 33.33,
        ..Spring::default()
    };
    let branch = MaxwellBranch {
        stiffness: 2.0e6,
        damping: 300.0,
    };
    Subsystem {
        name: name.to_owned(),
        enabled: true,
        position,
        mass: 100.0,
        inertia: 53.33,
        y_left: Spring {
            maxwell: vec![branch, branch],
            ..spring.clone()
        },
        y_right: spring.clone(),
        z_left: spring.clone(),
        z_right: spring,
        arm_left: 0.08,
        arm_right: 0.36,
        mount_y: 0.13,
        mount_z: -0.055,
    }
}

fn forces(names: &[&str]) -> Vec<Force> {
    let beam = |place, motion| Target::Beam(place, motion);
    let mut targets = vec![
        beam(Place::Left, BeamMotion::W),
        beam(Place::Right, BeamMotion::Psi),
        beam(Place::Position(1.6), BeamMotion::PsiSlope),
    ];
    targets.extend(
        names
            .first()
            .map(|name| Target::Mass((*name).to_owned(), MassMotion::Theta)),
    );
    let force = |target| Force {
        enabled: true,
        target,
        amplitude: 1.0,
        phase: 30.0,
        point: Point::AXIS,
    };
    targets.into_iter().map(force).collect()
}

fn responses(names: &[&str]) -> Vec<Response> {
    let response = |name: &str, quantity| Response {
        name: name.to_owned(),
        enabled: true,
        quantity,
        point: Point::AXIS,
        over: None,
    };
    let w = Target::Beam(Place::Right, BeamMotion::W);
    let mut all = vec![
        response("P5 w", Quantity::Motion(w, Measure::Displacement)),
        response("E_V", Quantity::Energy),
    ];
    all.extend(names.first().map(|name| {
        response(
            "mass",
            Quantity::Motion(
                Target::Mass((*name).to_owned(), MassMotion::Y),
                Measure::Velocity,
            ),
        )
    }));
    all
}

fn study(name: &str, path: &str, operation: Operation, values: &[f64]) -> Study {
    let family = Family::Vary {
        paths: vec![path.into()],
        operation,
        values: values.to_vec(),
    };
    Study {
        name: name.to_owned(),
        family,
    }
}

fn cases(names: &[&str]) -> Vec<Case> {
    let named = names.first().map(|name| {
        let path = format!(
            "subsystems.{}.arm_left",
            crate::model::spelling::segment(name)
        );
        (path.into(), 0.22)
    });
    vec![
        Case {
            name: "as it is".to_owned(),
            set: Vec::new(),
        },
        Case {
            name: "symmetric".to_owned(),
            set: named.into_iter().collect(),
        },
    ]
}
