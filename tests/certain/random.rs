//! Random models: 0 to 20 subsystems, half of the models with some equal ones.

use beamtune::model::{
    Beam, Elastic, InnerSupport, Joint, Link, Material, MaxwellBranch, Model, Point, Restraint,
    Section, Spacing, Span, Spring, SpringId, Subsystem, Support, Supports, Sweep,
};

use super::frequency_of::frequency_of;

/// A linear congruential generator (Knuth's MMIX).
struct Dice(u64);

impl Dice {
    /// From a mixed seed (Steele, Lea & Flood, OOPSLA 2014): adjacent seeds are independent.
    fn new(seed: u64) -> Self {
        let mut z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Self(z ^ (z >> 31))
    }

    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }

    /// Uniform in the logarithm.
    fn power(&mut self, from: f64, to: f64) -> f64 {
        (self.between(from.ln(), to.ln())).exp()
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[(self.next() * from.len() as f64) as usize]
    }
}

/// A model and the upper frequency limit (Hz) of its modes.
pub fn model(seed: u64) -> (Model, f64) {
    let mut dice = Dice::new(seed);
    let beam = beam(&mut dice);
    let mut subsystems: Vec<Subsystem> = Vec::new();
    let total = (dice.next() * 21.0) as usize;
    if dice.next() < 0.5 {
        let alike = (2 + (dice.next() * 11.0) as usize).min(total);
        let first = subsystem(&mut dice, &beam);
        for index in 0..alike {
            let mut next = first.clone();
            // Some at the same position.
            if index > 0 && dice.next() < 0.8 {
                next.position = dice.next() * beam.length;
            }
            subsystems.push(next);
        }
    }
    while subsystems.len() < total {
        subsystems.push(subsystem(&mut dice, &beam));
    }
    for (index, subsystem) in subsystems.iter_mut().enumerate() {
        subsystem.name = format!("S{index}");
    }
    let supports = Supports {
        left: support(&mut dice),
        right: support(&mut dice),
        inner: Vec::new(),
    };
    let sweep = Sweep {
        from: 1.0,
        to: 100.0,
        points: 2,
        spacing: Spacing::Linear,
    };
    let mut model = Model {
        title: format!("random {seed}"),
        beam,
        supports,
        subsystems,
        sweep,
        ..Model::default()
    };
    let wanted = 8 + (dice.next() * 22.0) as usize;
    let beyond = dice.between(1.001, 1.1);
    // Of every second model: the others have what the paper's models have.
    if dice.next() < 0.5 {
        hold_anywhere(&mut model, &mut dice);
    }
    if dice.next() < 0.4 {
        divide(&mut model, &mut dice);
    }
    let to = frequency_of(&model, wanted) * beyond;
    if dice.next() < 0.3 {
        relax(&mut model, &mut dice);
    }
    (model, to)
}

/// Adds Maxwell branches to some springs, as stiff as these and with their losses within the range of a machine.
fn relax(model: &mut Model, dice: &mut Dice) {
    let places: Vec<SpringId> = SpringId::all(model).collect();
    for place in places {
        let Some(spring) = place.spring_mut(model) else {
            continue;
        };
        while dice.next() < 0.3 {
            let stiffness = spring.stiffness.max(1e4) * dice.power(0.03, 3.0);
            spring.maxwell.push(MaxwellBranch {
                stiffness,
                damping: stiffness / dice.power(10.0, 3e3),
            });
        }
    }
}

/// Adds bearings and springs to the ground between the ends, at points of the section, and loss factors.
fn hold_anywhere(model: &mut Model, dice: &mut Dice) {
    for index in 0..=(dice.next() * 2.0) as usize {
        let elastic = |dice: &mut Dice| {
            match dice.next() {
                share if share < 0.4 => return Restraint::Free,
                share if share < 0.6 => return Restraint::Fixed,
                _ => {}
            }
            Restraint::Elastic(Elastic {
                spring: Spring {
                    stiffness: dice.power(1e4, 1e8),
                    damping: dice.pick(&[0.0, 10.0, 300.0]),
                    loss_factor: dice.pick(&[0.0, 0.02, 0.2]),
                    ..Spring::default()
                },
                inertia: dice.pick(&[0.0, 2.0]),
            })
        };
        let mut restraints = std::array::from_fn(|_| elastic(dice));
        if restraints.iter().all(|of| *of == Restraint::Free) {
            restraints[0] = Restraint::Fixed;
        }
        model.supports.inner.push(InnerSupport {
            name: format!("B{index}"),
            position: dice.between(0.05, 0.95) * model.beam.length,
            support: Support {
                restraints,
                point: Point {
                    y: dice.pick(&[0.0, 0.08]),
                    z: dice.pick(&[0.0, -0.1]),
                },
            },
        });
    }
    for subsystem in &mut model.subsystems {
        let loss_factor = dice.pick(&[0.0, 0.0, 0.1]);
        subsystem.y_left.loss_factor = loss_factor;
        subsystem.z_right.loss_factor = loss_factor;
    }
    if dice.next() < 0.6 {
        cut(model, dice);
    }
}

/// Makes the beam of two or three spans; some end where something stands.
fn divide(model: &mut Model, dice: &mut Dice) {
    let length = model.beam.length;
    let mut ends = vec![dice.between(0.1, 0.9) * length];
    let inside = 0.05 * length..0.95 * length;
    let places = (model.supports.inner.iter().map(|of| of.position))
        .chain(model.joints.iter().map(|of| of.position))
        .chain(model.subsystems.iter().map(|of| of.position));
    let places: Vec<f64> = places.filter(|place| inside.contains(place)).collect();
    if !places.is_empty() && dice.next() < 0.7 {
        ends.push(dice.pick(&places));
    }
    ends.push(length);
    ends.sort_by(f64::total_cmp);
    let mut from = 0.0;
    for end in ends {
        let mut section = model.beam.section;
        let size = dice.power(0.4, 2.5);
        for number in [
            &mut section.area,
            &mut section.second_moment_y,
            &mut section.second_moment_z,
            &mut section.polar_moment,
        ] {
            *number *= size;
        }
        section.torsion_constant *= dice.power(0.3, 3.0);
        section.warping_constant *= dice.power(0.3, 3.0);
        section.centroid_offset *= dice.pick(&[1.0, 0.0, -0.5]);
        let material = Material {
            loss_factor: dice.pick(&[0.0, model.beam.material.loss_factor]),
            ..model.beam.material
        };
        model.spans.push(Span {
            length: end - from,
            section: dice.pick(&[None, Some(section)]),
            material: dice.pick(&[None, Some(material)]),
            offset: Point {
                y: dice.pick(&[0.0, 0.1, -0.05]),
                z: dice.pick(&[0.0, -0.08, 0.03]),
            },
            ..Span::default()
        });
        from = end;
    }
    model.beam.length = 0.0;
    // The last place is the end of the beam, whatever its rounding.
    let end = model.length();
    for subsystem in &mut model.subsystems {
        subsystem.position = subsystem.position.min(end);
    }
}

/// Adds a joint, in some models where a support is.
fn cut(model: &mut Model, dice: &mut Dice) {
    let link = |dice: &mut Dice| match dice.next() {
        share if share < 0.5 => Link::Rigid,
        share if share < 0.7 => Link::Free,
        _ => Link::Elastic(Spring {
            stiffness: dice.power(1e4, 1e8),
            damping: dice.pick(&[0.0, 10.0, 300.0]),
            loss_factor: dice.pick(&[0.0, 0.02, 0.2]),
            ..Spring::default()
        }),
    };
    let position = dice.between(0.05, 0.95) * model.beam.length;
    let mut links = std::array::from_fn(|_| link(dice));
    if links.iter().all(|link| *link == Link::Rigid) {
        links[3] = Link::Free;
    }
    model.joints.push(Joint {
        position: dice.pick(&[position, position, model.supports.inner[0].position]),
        links,
    });
}

fn beam(dice: &mut Dice) -> Beam {
    Beam {
        length: dice.power(1.0, 6.0),
        material: Material {
            young_modulus: 2.1e11,
            shear_modulus: 8e10,
            density: 7850.0,
            loss_factor: dice.pick(&[0.0, 0.001, 0.02, 0.3]),
        },
        section: Section {
            area: 0.0116,
            second_moment_y: dice.power(1e-5, 2e-4),
            second_moment_z: dice.power(1e-5, 2e-4),
            torsion_constant: dice.power(1e-7, 1e-5),
            warping_constant: dice.power(1e-9, 3e-8),
            polar_moment: 5.9992e-4,
            centroid_offset: dice.pick(&[0.0, 0.0619, -0.12]),
            ..Default::default()
        },
        ..Default::default()
    }
}

fn subsystem(dice: &mut Dice, beam: &Beam) -> Subsystem {
    let mass = dice.power(1.0, 200.0);
    let own = dice.power(3.0, 300.0) * std::f64::consts::TAU;
    let ratio = match dice.next() {
        share if share < 0.2 => 0.0,
        share if share < 0.7 => dice.power(0.002, 0.3),
        _ => dice.power(0.3, 10.0),
    };
    let mut spring = || {
        let stiffness = 0.5 * mass * own * own * dice.between(0.3, 1.5);
        Spring {
            stiffness,
            damping: 2.0 * ratio * (0.5 * mass * stiffness).sqrt(),
            ..Spring::default()
        }
    };
    let [y_left, y_right, z_left, z_right] = [spring(), spring(), spring(), spring()];
    Subsystem {
        name: String::new(),
        enabled: true,
        position: dice.pick(&[0.0, 1.0, 0.5, dice.0 as f64 / u64::MAX as f64]) * beam.length,
        mass,
        inertia: mass * dice.between(0.03, 0.3).powi(2),
        y_left,
        y_right,
        z_left,
        z_right,
        arm_left: dice.between(0.03, 0.3),
        arm_right: dice.between(0.03, 0.3),
        mount_y: dice.pick(&[0.0, 0.1, 0.2]),
        mount_z: dice.pick(&[0.0, -0.1, 0.15]),
    }
}

fn support(dice: &mut Dice) -> Support {
    match dice.next() {
        share if share < 0.2 => Support::CLAMPED,
        share if share < 0.4 => Support::PINNED,
        share if share < 0.6 => Support::FREE,
        _ => Support::on_axis(std::array::from_fn(|_| match dice.next() {
            share if share < 0.3 => Restraint::Free,
            share if share < 0.5 => Restraint::Fixed,
            _ => Restraint::Elastic(Elastic {
                spring: Spring {
                    stiffness: dice.power(1e4, 1e8),
                    damping: dice.pick(&[0.0, 10.0, 300.0]),
                    ..Spring::default()
                },
                inertia: dice.pick(&[0.0, 0.5]),
            }),
        })),
    }
}
