//! Writing and reading: written models read back to the same bits, and the text of a person stays.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::format_push_string)]

#[path = "round_trip/tuning.rs"]
mod tuning;

use beamtune::model::*;
use proptest::collection::vec;
use proptest::prelude::*;

const EXAMPLE: &str = include_str!("data/commented.toml");

/// Equal to the last bit: `Debug` distinguishes -0.0 from 0.0 and any two floats.
fn bits(model: &Model) -> String {
    format!("{model:#?}")
}

fn reads_as(text: &str, model: &Model) {
    match read(text) {
        Ok(found) => assert_eq!(bits(&found), bits(model), "{text}"),
        Err(faults) => panic!("{faults:#?}\n{text}"),
    }
}

/// Any size from the very small to the very large.
fn positive() -> impl Strategy<Value = f64> {
    (1.0..10.0_f64, -9..10_i32).prop_map(|(digits, power)| digits * 10.0_f64.powi(power))
}

fn not_negative() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 1 => Just(-0.0), 6 => positive(), 1 => Just(f64::MIN_POSITIVE / 8.0)]
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![not_negative(), positive().prop_map(|value| -value)]
}

/// Names that are awkward in TOML, paths and CSV; the number makes them unique.
fn names(count: impl Into<proptest::collection::SizeRange>) -> impl Strategy<Value = Vec<String>> {
    let name = prop_oneof![
        Just("S".to_owned()),
        Just(String::new()),
        Just("a.b*".to_owned()),
        Just("a \"q\" \\ 'r'".to_owned()),
        "[ -~äß€]{1,6}",
    ];
    vec(name, count).prop_map(|names| {
        names
            .into_iter()
            .enumerate()
            .map(|(index, name)| format!("{name}{index}"))
            .collect()
    })
}

fn text() -> impl Strategy<Value = String> {
    prop_oneof!["[ -~äß€]{0,12}", "[a\"'\\\\\r\n\t\u{1}#]{0,8}"]
}

fn beam() -> impl Strategy<Value = Beam> {
    (
        [
            positive(),
            positive(),
            positive(),
            positive(),
            positive(),
            positive(),
        ],
        not_negative(),
        not_negative(),
        any_number(),
        any_number(),
        any::<bool>(),
    )
        .prop_map(
            |(
                [length, young_modulus, shear_modulus, density, area, moment],
                loss_factor,
                warping,
                offset,
                axial_force,
                warps,
            )| {
                let section = Section {
                    area,
                    second_moment_y: moment,
                    second_moment_z: moment / 3.0,
                    torsion_constant: moment / 7.0,
                    warping_constant: warping,
                    polar_moment: (area * offset * offset).mul_add(1.5, moment),
                    centroid_offset: offset,
                    // A tuning may make the second moments any smaller.
                    product_moment: 0.0,
                    centroid_offset_y: 0.5 * offset,
                    shear_area_y: area / 3.0,
                    shear_area_z: if warps { area } else { 0.0 },
                };
                Beam {
                    length,
                    theory: if warps {
                        Theory::Timoshenko
                    } else {
                        Theory::EulerBernoulli
                    },
                    warping_inertia: warps,
                    axial_force,
                    foundation: if warps {
                        Foundation {
                            psi: Bedding {
                                stiffness: moment,
                                damping: 0.0,
                                loss_factor,
                            },
                            ..Foundation::default()
                        }
                    } else {
                        Foundation::default()
                    },
                    material: Material {
                        young_modulus,
                        shear_modulus,
                        density,
                        loss_factor,
                    },
                    section,
                }
            },
        )
}

/// A beam, uniform or of up to three spans with tables of their own or those of the beam.
fn beam_of_spans() -> impl Strategy<Value = (Beam, Vec<Span>)> {
    let one = |whole: Beam| {
        let has = any::<[bool; 4]>();
        let numbers = (0.1..1.0_f64, any_number(), any_number());
        (beam(), has, numbers).prop_map(move |(own, has, (length, y, z))| {
            // The theory of the beam may need the shear areas.
            let section = Section {
                shear_area_z: own.section.area,
                ..own.section
            };
            let section = has[0].then_some(section);
            let warps = section.unwrap_or(whole.section).warping_constant > 0.0;
            Span {
                length: length * whole.length,
                offset: if warps { Point { y, z } } else { Point::AXIS },
                axial_force: has[1].then_some(own.axial_force),
                material: has[2].then_some(own.material),
                section,
                foundation: has[3].then_some(own.foundation),
            }
        })
    };
    beam().prop_flat_map(move |whole| {
        let spans = prop_oneof![2 => Just(Vec::new()), 1 => vec(one(whole), 1..4)];
        spans.prop_map(move |spans| {
            let length = if spans.is_empty() { whole.length } else { 0.0 };
            (Beam { length, ..whole }, spans)
        })
    })
}

fn restraint() -> impl Strategy<Value = Restraint> {
    prop_oneof![
        Just(Restraint::Free),
        Just(Restraint::Fixed),
        [not_negative(), not_negative(), not_negative()].prop_map(
            |[stiffness, damping, inertia]| {
                Restraint::Elastic(Elastic {
                    spring: Spring {
                        stiffness,
                        damping,
                        ..Spring::default()
                    },
                    inertia,
                })
            }
        ),
    ]
}

fn support() -> impl Strategy<Value = Support> {
    let any = [
        restraint(),
        restraint(),
        restraint(),
        restraint(),
        restraint(),
        restraint(),
    ]
    .prop_map(Support::on_axis);
    prop_oneof![
        Just(Support::FREE),
        Just(Support::PINNED),
        Just(Support::CLAMPED),
        any
    ]
}

fn spring() -> impl Strategy<Value = Spring> {
    let branch = (not_negative(), not_negative())
        .prop_map(|(stiffness, damping)| MaxwellBranch { stiffness, damping });
    let maxwell = prop_oneof![2 => Just(Vec::new()), 1 => prop::collection::vec(branch, 1..3)];
    (not_negative(), not_negative(), maxwell).prop_map(|(stiffness, damping, maxwell)| Spring {
        stiffness,
        damping,
        maxwell,
        ..Spring::default()
    })
}

/// Joints at different positions inside a beam of a length, m, none of them rigid in every motion.
fn joints(length: f64) -> impl Strategy<Value = Vec<Joint>> {
    let link = || {
        let elastic = spring().prop_map(Link::Elastic);
        prop_oneof![Just(Link::Rigid), Just(Link::Free), elastic]
    };
    let links = prop::array::uniform6(link());
    let one = (0.01..0.99_f64, links).prop_map(move |(place, links)| Joint {
        position: place * length,
        links,
    });
    let is_cut = |joint: &Joint| joint.links.iter().any(|link| *link != Link::Rigid);
    prop::collection::vec(one.prop_filter("is rigid", is_cut), 0..3).prop_map(|mut joints| {
        joints.dedup_by(|one, other| one.position == other.position);
        joints
    })
}

fn subsystems(length: f64) -> impl Strategy<Value = Vec<Subsystem>> {
    names(0..4).prop_flat_map(move |names| {
        let one = move |name: String| {
            let springs = prop::array::uniform4(spring());
            let numbers = [any_number(), any_number(), any_number(), any_number()];
            (
                any::<bool>(),
                0.0..=1.0_f64,
                positive(),
                positive(),
                springs,
                numbers,
            )
                .prop_map(move |(enabled, place, mass, inertia, springs, numbers)| {
                    let [y_left, y_right, z_left, z_right] = springs;
                    Subsystem {
                        name: name.clone(),
                        enabled,
                        position: (place * length).min(length),
                        mass,
                        inertia,
                        y_left,
                        y_right,
                        z_left,
                        z_right,
                        arm_left: numbers[0],
                        arm_right: numbers[1],
                        mount_y: numbers[2],
                        mount_z: numbers[3],
                    }
                })
        };
        names.into_iter().map(one).collect::<Vec<_>>()
    })
}

fn target(length: f64, masses: Vec<String>) -> impl Strategy<Value = Target> {
    let place = prop_oneof![
        Just(Place::Left),
        Just(Place::Right),
        (0.0..=1.0_f64).prop_map(move |place| Place::Position((place * length).min(length))),
    ];
    let motion = prop::sample::select(vec![
        BeamMotion::W,
        BeamMotion::V,
        BeamMotion::Psi,
        BeamMotion::VSlope,
    ]);
    let beam = (place, motion)
        .prop_map(|(place, motion)| Target::Beam(place, motion))
        .boxed();
    if masses.is_empty() {
        return beam;
    }
    let mass = (
        prop::sample::select(masses),
        prop::sample::select(MassMotion::ALL.to_vec()),
    )
        .prop_map(|(name, motion)| Target::Mass(name, motion));
    prop_oneof![beam, mass].boxed()
}

fn forces(length: f64, masses: Vec<String>) -> impl Strategy<Value = Vec<Force>> {
    vec(
        (
            any::<bool>(),
            target(length, masses),
            any_number(),
            not_negative(),
        ),
        0..4,
    )
    .prop_map(|forces| {
        let one = |(enabled, target, amplitude, phase)| Force {
            enabled,
            target,
            amplitude,
            phase,
            point: beamtune::model::Point::AXIS,
        };
        forces.into_iter().map(one).collect()
    })
}

fn responses(length: f64, masses: Vec<String>) -> impl Strategy<Value = Vec<Response>> {
    let mut others = vec![
        Quantity::Energy,
        Quantity::Reaction(Reaction::Support(Holder::Left, BeamMotion::WSlope)),
        Quantity::Reaction(Reaction::Support(Holder::Right, BeamMotion::PsiSlope)),
        Quantity::Reaction(Reaction::Ground(Across::V)),
        Quantity::InternalForce(Place::Right, BeamMotion::VSlope),
        Quantity::InternalForce(Place::Position(0.5 * length), BeamMotion::W),
    ];
    others.extend(masses.iter().take(2).flat_map(|name| {
        let of = |spring, measure| Quantity::Spring(name.clone(), spring, measure);
        [
            of(SpringName::YRight, SpringMeasure::Force),
            of(SpringName::ZLeft, SpringMeasure::Stretch),
        ]
    }));
    let quantity = prop_oneof![
        1 => prop::sample::select(others),
        3 => (target(length, masses), prop::sample::select(Measure::ALL.to_vec()))
            .prop_map(|(target, measure)| Quantity::Motion(target, measure)),
    ];
    let all = vec((any::<bool>(), quantity, any::<bool>()), 4);
    (names(0..4), all).prop_map(|(names, rest)| {
        let mut all: Vec<Response> = Vec::new();
        for (name, (enabled, quantity, divided)) in names.into_iter().zip(rest) {
            let divisors = all.iter().find(|of| of.is_linear());
            let over = divisors.filter(|_| divided && !quantity.is_quadratic());
            all.push(Response {
                over: over.map(|of| of.name.clone()),
                name,
                enabled,
                quantity,
                point: beamtune::model::Point::AXIS,
            });
        }
        all
    })
}

fn studies() -> impl Strategy<Value = Vec<Study>> {
    let paths = [
        "beam.material.density",
        "beam.material.young_modulus",
        "beam.section.second_moment_*",
    ];
    let paths = prop::sample::subsequence(paths[..2].to_vec(), 1..=2).prop_shuffle();
    let paths = paths.prop_map(|paths| {
        paths
            .into_iter()
            .map(path::Pattern::from)
            .collect::<Vec<_>>()
    });
    let vary = (
        paths.clone(),
        prop::sample::select(Operation::ALL.to_vec()),
        vec(positive(), 1..5),
    )
        .prop_map(|(paths, operation, values)| Family::Vary {
            paths,
            operation,
            values,
        });
    let set = (paths, vec(positive(), 2))
        .prop_map(|(paths, values)| paths.into_iter().zip(values).collect::<Vec<_>>());
    let cases = (
        names(1..4),
        vec(prop_oneof![Just(Vec::new()), set.boxed()], 4),
    )
        .prop_map(|(names, sets)| {
            Family::Cases(
                names
                    .into_iter()
                    .zip(sets)
                    .map(|(name, set)| Case { name, set })
                    .collect(),
            )
        });
    (names(0..3), vec(prop_oneof![vary, cases], 3)).prop_map(|(names, families)| {
        names
            .into_iter()
            .zip(families)
            .map(|(name, family)| Study { name, family })
            .collect()
    })
}

/// Any valid model. Its parts are boxed: together they exceed the stack of a test.
fn model() -> impl Strategy<Value = Model> {
    let start = (
        text(),
        text(),
        beam_of_spans().boxed(),
        support().boxed(),
        support().boxed(),
        positive(),
        2..=1_000_000_usize,
        any::<bool>(),
    );
    start.prop_flat_map(|(title, notes, all, left, right, from, points, log)| {
        let (beam, spans) = all;
        let supports = Supports {
            left,
            right,
            inner: Vec::new(),
        };
        let length = beam.length + spans.iter().map(|span| span.length).sum::<f64>();
        let spacing = if log { Spacing::Log } else { Spacing::Linear };
        let sweep = Sweep {
            from,
            to: from * 1.5,
            points,
            spacing,
        };
        subsystems(length)
            .boxed()
            .prop_flat_map(move |subsystems| {
                let enabled = subsystems
                    .iter()
                    .filter(|one| one.enabled)
                    .map(|one| one.name.clone())
                    .collect::<Vec<_>>();
                let (title, notes, spans) = (title.clone(), notes.clone(), spans.clone());
                let supports = supports.clone();
                let parts = (
                    forces(length, enabled.clone()).boxed(),
                    responses(length, enabled).boxed(),
                    studies().boxed(),
                    joints(length).boxed(),
                );
                parts
                    .prop_flat_map(move |(forces, responses, studies, joints)| {
                        let subsystems = subsystems.clone();
                        let (title, notes, spans) = (title.clone(), notes.clone(), spans.clone());
                        let supports = supports.clone();
                        tuning::tune(&responses).prop_map(move |tune| Model {
                            title: title.clone(),
                            notes: notes.clone(),
                            beam,
                            spans: spans.clone(),
                            supports: supports.clone(),
                            joints: joints.clone(),
                            subsystems: subsystems.clone(),
                            forces: forces.clone(),
                            responses: responses.clone(),
                            sweep,
                            studies: studies.clone(),
                            tune,
                        })
                    })
                    .boxed()
            })
            .boxed()
    })
}

/// A comment at the end of every line that can have one, numbered.
fn with_comments(text: &str) -> (String, usize) {
    let mut count = 0;
    let mut commented = String::new();
    for line in text.lines() {
        commented.push_str(line);
        if !line.is_empty() {
            count += 1;
            commented.push_str(&format!("  # note {count};"));
        }
        commented.push('\n');
    }
    (commented, count)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn a_rewritten_model_reads_back_to_the_same_bits(model in model()) {
        prop_assert_eq!(check(&model), Vec::new());
        let text = write(&model, "");
        reads_as(&text, &model);
        prop_assert_eq!(write(&model, &text), text);
    }

    #[test]
    fn any_model_can_be_merged_into_any_other(old in model(), new in model(), dos: bool) {
        let mut original = write(&old, "");
        if dos {
            original = original.replace('\n', "\r\n");
        }
        reads_as(&write(&new, &original), &new);
    }

    #[test]
    fn edits_keep_every_comment(old in model(), new in model(), turn in 0..4_usize) {
        let old = Model { title: "one line".to_owned(), notes: "one line".to_owned(), ..old };
        let (original, count) = with_comments(&write(&old, ""));
        // The same parts with other numbers, in another order, renamed.
        let mut edited = Model { studies: old.studies.clone(), tune: None, ..old.clone() };
        edited.beam.material = new.beam.material;
        edited.sweep = new.sweep;
        for (subsystem, other) in edited.subsystems.iter_mut().zip(&new.subsystems) {
            (subsystem.mass, subsystem.y_left) = (other.mass, other.y_left.clone());
        }
        for (force, other) in edited.forces.iter_mut().zip(&new.forces) {
            force.amplitude = other.amplitude;
        }
        if !edited.subsystems.is_empty() {
            let turn = turn % edited.subsystems.len();
            edited.subsystems.rotate_left(turn);
        }
        if !edited.responses.is_empty() {
            let turn = turn % edited.responses.len();
            edited.responses.rotate_left(turn);
            edited.responses[0].name += " renamed";
        }
        for study in &mut edited.studies {
            if let Family::Cases(cases) = &mut study.family {
                let turn = turn % cases.len();
                cases.rotate_left(turn);
            }
        }
        prop_assume!(check(&edited).is_empty());
        let original_tune = original.find("\n[tune]").unwrap_or(original.len());
        let original = &original[..original_tune];
        let count = count.min(original.matches("# note ").count());
        let text = write(&edited, original);
        reads_as(&text, &edited);
        for number in 1..=count {
            prop_assert!(text.contains(&format!("# note {number};")), "note {number} is gone\n{original}\n=>\n{text}");
        }
    }
}

/// The lines that differ, the old with a minus and the new with a plus, below the last equal line that has text.
fn difference(old: &str, new: &str) -> String {
    let (old, new): (Vec<_>, Vec<_>) = (old.lines().collect(), new.lines().collect());
    // Longest common subsequence, from the end.
    let mut length = vec![vec![0_usize; new.len() + 1]; old.len() + 1];
    for i in (0..old.len()).rev() {
        for j in (0..new.len()).rev() {
            length[i][j] = if old[i] == new[j] {
                length[i + 1][j + 1] + 1
            } else {
                length[i + 1][j].max(length[i][j + 1])
            };
        }
    }
    let (mut i, mut j, mut text, mut above) = (0, 0, String::new(), "");
    while i < old.len() || j < new.len() {
        if i < old.len() && j < new.len() && old[i] == new[j] {
            above = if old[i].is_empty() { above } else { old[i] };
            (i, j) = (i + 1, j + 1);
            continue;
        }
        if !std::mem::take(&mut above).is_empty() {
            text += &format!(
                " {}\n",
                old[..i].iter().rfind(|line| !line.is_empty()).unwrap()
            );
        }
        if j == new.len() || (i < old.len() && length[i + 1][j] >= length[i][j + 1]) {
            text += &format!("-{}\n", old[i]);
            i += 1;
        } else {
            text += &format!("+{}\n", new[j]);
            j += 1;
        }
    }
    text
}

/// Edits the example and returns the differences in its text.
fn edit(change: impl Fn(&mut Model)) -> String {
    edit_in(EXAMPLE, change)
}

fn edit_in(original: &str, change: impl Fn(&mut Model)) -> String {
    let mut model = read(original).unwrap().into_inner();
    change(&mut model);
    let text = write(&model, original);
    reads_as(&text, &model);
    difference(original, &text)
}

#[test]
fn an_unchanged_model_leaves_the_text_as_it_is() {
    for text in [
        EXAMPLE.to_owned(),
        EXAMPLE.replace('\n', "\r\n"),
        format!("\u{feff}{EXAMPLE}"),
    ] {
        assert_eq!(write(&read(&text).unwrap().into_inner(), &text), text);
    }
}

#[test]
fn a_number_changes_alone() {
    insta::assert_snapshot!(edit(|model| {
        model.beam.length = 3.25;
        model.beam.material.shear_modulus = 7.9e10;
        model.beam.material.loss_factor = 0.01;
        model.supports.left[BeamMotion::V] = Restraint::Elastic(Elastic { spring: Spring { stiffness: 4e7, damping: 900.0, ..Spring::default() }, inertia: 2.0 });
        model.subsystems[0].z_left.damping = 5.0;
        model.subsystems[1].y_left.damping = 7.0;
        model.subsystems[1].z_right.stiffness = -0.0;
        model.sweep.points = 2001;
        model.sweep.spacing = Spacing::Log;
    }), @r#"
 [beam]
-length = 3.2            # m
+length = 3.25            # m
     young_modulus = 2.1e11
-    shear_modulus = 80_000_000_000   # a whole number with underscores
+    shear_modulus = 7.9e10   # a whole number with underscores
     density = 7850
+    loss_factor = 0.01
 v.stiffness = 4.0e7     # dotted
-v.damping = 800.0
+v.damping = 900.0
+v.mass = 2.0
 y_left  = { stiffness = 1.666667e7, damping = 33.33 }
-z_left  = {stiffness=1.666667e7}
+z_left  = {stiffness=1.666667e7, damping = 5.0}
 mount_z = 0.0
+z_right = { stiffness = -0.0, damping = 0.0 }
 stiffness = 2.0e6
+damping = 7.0
 to = 500.0
-points = 2_000
+points = 2001
+spacing = "log"
"#);
}

#[test]
fn a_beam_becomes_spans_and_uniform_again() {
    insta::assert_snapshot!(edit(|model| {
        edit::split(model, 0);
        model.spans[1].section = Some(model.beam.section);
        model.spans[1].axial_force = Some(1e3);
    }), @"
 [beam]
-length = 3.2            # m
 centroid_offset = +0.0619
+# m
+[[beam.spans]]
+length = 1.6
+
+[[beam.spans]]
+length = 1.6
+axial_force = 1000.0
+
+[beam.spans.section]
+area = 0.0116
+second_moment_y = 1.6625e-4
+second_moment_z = 1.3745e-4
+torsion_constant = 4.7657e-7
+warping_constant = 2.2783e-8
+polar_moment = 5.9992e-4
+centroid_offset = 0.0619
+
");
    let spanned = EXAMPLE.replace(
        "length = 3.2            # m",
        "spans = [{ length = 1.2 }, { length = 2.0, axial_force = 5.0 }]  # m",
    );
    insta::assert_snapshot!(edit_in(&spanned, |model| model.spans[1].offset.z = 0.1), @"
 [beam]
-spans = [{ length = 1.2 }, { length = 2.0, axial_force = 5.0 }]  # m
+spans = [{ length = 1.2 }, { length = 2.0, axial_force = 5.0, offset_z = 0.1 }]  # m
");
    insta::assert_snapshot!(edit_in(&spanned, |model| {
        edit::remove(model, Group::Span(0));
        edit::remove(model, Group::Span(0));
    }), @"
 [beam]
-spans = [{ length = 1.2 }, { length = 2.0, axial_force = 5.0 }]  # m
+spans = []  # m
+length = 3.2
+axial_force = 5.0
");
}

#[test]
fn spans_are_edited_with_their_comments() {
    let below = "\n# left is on springs\n";
    let spans = "\n# the thick end\n[[beam.spans]]\nlength = 1.2 # m\n[beam.spans.material] # its own\nyoung_modulus = 7e10\n\
        shear_modulus = 2.6e10\ndensity = 2700 # light\n\n# the thin end\n[[beam.spans]]\nlength = 2.0\n";
    let spanned = EXAMPLE
        .replace("length = 3.2            # m\n", "")
        .replace(below, &format!("{spans}{below}"));
    insta::assert_snapshot!(edit_in(&spanned, |model| {
        model.spans[0].material.as_mut().unwrap().density = 2710.0;
        model.spans[1].material = model.spans[0].material;
        model.spans[1].length = 2.1;
    }), @"
 shear_modulus = 2.6e10
-density = 2700 # light
+density = 2710.0 # light
 [[beam.spans]]
-length = 2.0
+length = 2.1
+[beam.spans.material]
+young_modulus = 7e10
+shear_modulus = 2.6e10
+density = 2710.0
+
");
    insta::assert_snapshot!(edit_in(&spanned, |model| model.spans[0].material = None), @"
 length = 1.2 # m
-[beam.spans.material] # its own
-young_modulus = 7e10
-shear_modulus = 2.6e10
-density = 2700 # light
");
    insta::assert_snapshot!(edit_in(&spanned, |model| edit::remove(model, Group::Span(0))), @"
 [[beam.spans]]
-length = 1.2 # m
-[beam.spans.material] # its own
-young_modulus = 7e10
-shear_modulus = 2.6e10
-density = 2700 # light
-
-# the thin end
-[[beam.spans]]
-length = 2.0
+length = 3.2 # m
");
}

/// A table that every span has itself may be missing, is not asked for and is not written.
#[test]
fn what_every_span_has_is_not_needed_of_the_beam() {
    let mut model = read(EXAMPLE).unwrap().into_inner();
    edit::split(&mut model, 0);
    for span in &mut model.spans {
        (span.section, span.foundation) = (Some(model.beam.section), Some(Foundation::default()));
    }
    let text = write(&model, EXAMPLE);
    reads_as(&text, &model);
    assert!(text.contains("[beam.section]"), "numbers are not dropped");
    model.beam.section = Section::default();
    assert_eq!(check(&model), []);
    let text = write(&model, &text);
    reads_as(&text, &model);
    reads_as(&write(&model, ""), &model);
    assert!(!write(&model, "").contains("[beam.section]") && text.contains("[beam.material]"));
    // One that needs it: all of its numbers are missing.
    model.spans[0].section = None;
    assert_eq!(check(&model)[0].path, "beam.section.area");
}

#[test]
fn a_support_changes_its_kind() {
    insta::assert_snapshot!(edit(|model| model.supports.right = Support::PINNED), @r#"
 # welded on
-kind = "clamped"        # until spring
+kind = "pinned"        # until spring
"#);
    insta::assert_snapshot!(edit(|model| model.supports.right[BeamMotion::W] = Restraint::Free), @r#"
 # welded on
-kind = "clamped"        # until spring
+# until spring
+v = "fixed"
+psi = "fixed"
+w_slope = "fixed"
+v_slope = "fixed"
+psi_slope = "fixed"
"#);
    insta::assert_snapshot!(edit(|model| {
        model.supports.left[BeamMotion::W] = Restraint::Free;
        model.supports.left[BeamMotion::V] = Restraint::Fixed;
        model.supports.left[BeamMotion::PsiSlope] = Restraint::Elastic(Elastic::default());
    }), @r#"
 [supports.left]
-w = { stiffness = 4.0e7, damping = 800.0, mass = 0.0 } # wall
-v.stiffness = 4.0e7     # dotted
-v.damping = 800.0
+w = "free" # wall
+# dotted
+v = "fixed"
+psi_slope = { stiffness = 0.0, damping = 0.0 }
"#);
}

#[test]
fn subsystems_are_added_after_the_last() {
    insta::assert_snapshot!(edit(|model| {
        let copy = Subsystem { name: "S3".to_owned(), enabled: false, ..model.subsystems[0].clone() };
        model.subsystems.push(copy);
    }), @r#"
 stiffness = 2.0e6
+[[subsystems]]
+name = "S3"
+enabled = false
+position = 0.8
+mass = 100.0
+inertia = 53.33
+y_left = { stiffness = 1.666667e7, damping = 33.33 }
+z_left = { stiffness = 1.666667e7, damping = 0.0 }
+arm_left = 0.08
+arm_right = 0.36
+mount_y = 0.13
+mount_z = -0.055
+
"#);
}

#[test]
fn subsystems_are_removed_with_their_comments_but_not_their_heading() {
    insta::assert_snapshot!(edit(|model| {
        model.subsystems.remove(0);
        model.forces.truncate(1);
        model.studies.clear();
    }), @r#"
 # ==== Subsystems ====
-# the left machine
-[[subsystems]]
-name = "S1"
-position = 0.8
-mass = 1e2              # kg
-inertia = 53.33
-y_left  = { stiffness = 1.666667e7, damping = 33.33 }
-z_left  = {stiffness=1.666667e7}
-arm_left = 0.08
-arm_right = 0.36
-mount_y = 0.13
-mount_z = -0.055
-
 direction = "w"
-# on the machine
-[[forces]]
-at = "S1"
-direction = "y"
-amplitude = 2.5
-
 points = 2_000
-[[studies]]
-name = "Stiffness"
-vary = [
-    "subsystems.*.y_left.stiffness",   # all left ones
-    "subsystems.S1.z_left.stiffness",
-]
-multiply = [0.5, 1.0, 2.0, 4]
-
-[[studies]]
-name = "Arms"
-cases = [
-  { name = "long" },    # as built
-  { name = "short", set = { "subsystems.*.arm_left" = 0.22, "subsystems.S1.arm_right" = 0.2 } },
-]
-
"#);
}

#[test]
fn subsystems_change_places() {
    insta::assert_snapshot!(edit(|model| model.subsystems.swap(0, 1)), @r#"
 # ==== Subsystems ====
-# the left machine
-[[subsystems]]
-name = "S1"
-position = 0.8
-mass = 1e2              # kg
-inertia = 53.33
-y_left  = { stiffness = 1.666667e7, damping = 33.33 }
-z_left  = {stiffness=1.666667e7}
-arm_left = 0.08
-arm_right = 0.36
-mount_y = 0.13
-mount_z = -0.055
-
 stiffness = 2.0e6
+# the left machine
+[[subsystems]]
+name = "S1"
+position = 0.8
+mass = 1e2              # kg
+inertia = 53.33
+y_left  = { stiffness = 1.666667e7, damping = 33.33 }
+z_left  = {stiffness=1.666667e7}
+arm_left = 0.08
+arm_right = 0.36
+mount_y = 0.13
+mount_z = -0.055
+
"#);
}

#[test]
fn a_renamed_subsystem_keeps_its_place() {
    insta::assert_snapshot!(edit(|model| {
        edit::set(model, "subsystems.S1.name", edit::Value::Text("motor".to_owned())).unwrap();
    }), @r#"
 [[subsystems]]
-name = "S1"
+name = "motor"
 [[forces]]
-at = "S1"
+at = "motor"
     "subsystems.*.y_left.stiffness",   # all left ones
-    "subsystems.S1.z_left.stiffness",
+    "subsystems.motor.z_left.stiffness",
   { name = "long" },    # as built
-  { name = "short", set = { "subsystems.*.arm_left" = 0.22, "subsystems.S1.arm_right" = 0.2 } },
+  { name = "short", set = { "subsystems.*.arm_left" = 0.22, "subsystems.motor.arm_right" = 0.2 } },
"#);
}

#[test]
fn forces_and_responses_change() {
    insta::assert_snapshot!(edit(|model| {
        model.forces.insert(0, model.forces[0].clone());
        model.forces[0].target = Target::Beam(Place::Position(1.0), BeamMotion::Psi);
        model.responses[0].quantity = Quantity::Energy;
        model.responses[1].quantity =
            Quantity::Motion(Target::Mass("S2".to_owned(), MassMotion::Theta), Measure::Velocity);
    }), @r#"
 [[forces]]
+at = 1.0
+direction = "psi"
+amplitude = 1.0
+
+[[forces]]
 name = "P5 w"
-at = "right"
-direction = "w"
+measure = "energy"
 name = "E_V"
-measure = "energy"      # the whole beam
+measure = "velocity"      # the whole beam
+at = "S2"
+direction = "theta"
"#);
}

#[test]
fn studies_change() {
    insta::assert_snapshot!(edit(|model| {
        let Family::Vary { paths, operation, values } = &mut model.studies[0].family else { panic!() };
        paths[0] = "subsystems.*.mass".into();
        paths.push("beam.material.density".into());
        *operation = Operation::Set;
        values.remove(0);
        values.push(8.0);
        let Family::Cases(cases) = &mut model.studies[1].family else { panic!() };
        cases[1].set.reverse();
        cases.push(Case { name: "new".to_owned(), set: Vec::new() });
        model.tune = Some(Tune {
            variables: vec![Variable { paths: vec!["beam.length".into()], hold: Hold::Equal, min: 3.0, max: 4.0, scale: None, tolerance: 0.0 }],
            objectives: vec![Objective { aim: Aim::Peak, response: Some("E_V".to_owned()), from: 2.0, to: 3.0, weight: 1.0 }],
            combine: Combine::Sum,
            limits: Vec::new(),
        });
    }), @r#"
 vary = [
-    "subsystems.*.y_left.stiffness",   # all left ones
+    "subsystems.*.mass",   # all left ones
     "subsystems.S1.z_left.stiffness",
+    "beam.material.density",
 ]
-multiply = [0.5, 1.0, 2.0, 4]
+set = [1.0, 2.0, 4.0, 8.0]
   { name = "long" },    # as built
-  { name = "short", set = { "subsystems.*.arm_left" = 0.22, "subsystems.S1.arm_right" = 0.2 } },
+  { name = "short", set = { "subsystems.S1.arm_right" = 0.2, "subsystems.*.arm_left" = 0.22 } },
+  { name = "new" },
 ]
+[tune]
+variables = [{ path = "beam.length", min = 3.0, max = 4.0 }]
+objective = { minimise = "peak", response = "E_V", from = 2.0, to = 3.0 }
+
"#);
}

/// The same beam in the other forms of tables.
const OTHER_STYLES: &str = r#"format = "beamtune/1"
title = "Other styles"
beam = { length = 3.2, material = { young_modulus = 2.1e11, shear_modulus = 8.0e10, density = 7850.0 }, section.area = 0.0116, section.second_moment_y = 1.6625e-4, section.second_moment_z = 1.3745e-4, section.torsion_constant = 4.7657e-7, section.warping_constant = 2.2783e-8, section.polar_moment = 5.9992e-4, section.centroid_offset = 0.0619 }
supports.left.w.stiffness = 4e7 # the spring
# the damper
supports.left.w.damping = 10.0
subsystems = [ { name = "A", position = 1.0, mass = 1.0, inertia = 1.0, arm_left = 0.0, arm_right = 0.0, mount_y = 0.0, mount_z = 0.0 } ]
forces = [{ at = "A", direction = "y" }]
sweep.from = 1.0
sweep.to = 10.0
sweep.points = 10
tune.variables = [ { path = "beam.length", min = 1.0, max = 4.0 } ]
tune.objective = { minimise = "peak", response = "r", from = 1.0, to = 2.0 }
responses = [
  # first
  { name = "r", measure = "energy" } # last
]
"#;

#[test]
fn other_styles_of_tables_are_kept() {
    assert_eq!(edit_in(OTHER_STYLES, |_| {}), "");
    insta::assert_snapshot!(edit_in(OTHER_STYLES, |model| {
        model.beam.length = 3.5;
        model.beam.material.loss_factor = 0.5;
        model.beam.section.area = 0.02;
        model.supports.left[BeamMotion::W] = Restraint::Fixed;
        model.supports.left[BeamMotion::Psi] = Restraint::Elastic(Elastic { spring: Spring { stiffness: 5.0, ..Spring::default() }, ..Elastic::default() });
        model.supports.right = Support::CLAMPED;
        model.subsystems[0].y_left.stiffness = 9.0;
        let copy = Subsystem { name: "B".to_owned(), ..model.subsystems[0].clone() };
        model.subsystems.insert(0, copy);
        model.forces[0].phase = 90.0;
        model.responses.push(Response { name: "s".to_owned(), enabled: true, quantity: Quantity::Energy, point: beamtune::model::Point::AXIS, over: None, });
        model.studies.push(Study {
            name: "new".to_owned(),
            family: Family::Vary { paths: vec!["beam.length".into()], operation: Operation::Multiply, values: vec![1.0] },
        });
    }), @r#"
 title = "Other styles"
-beam = { length = 3.2, material = { young_modulus = 2.1e11, shear_modulus = 8.0e10, density = 7850.0 }, section.area = 0.0116, section.second_moment_y = 1.6625e-4, section.second_moment_z = 1.3745e-4, section.torsion_constant = 4.7657e-7, section.warping_constant = 2.2783e-8, section.polar_moment = 5.9992e-4, section.centroid_offset = 0.0619 }
-supports.left.w.stiffness = 4e7 # the spring
+beam = { length = 3.5, material = { young_modulus = 2.1e11, shear_modulus = 8.0e10, density = 7850.0, loss_factor = 0.5 }, section.area = 0.02, section.second_moment_y = 1.6625e-4, section.second_moment_z = 1.3745e-4, section.torsion_constant = 4.7657e-7, section.warping_constant = 2.2783e-8, section.polar_moment = 5.9992e-4, section.centroid_offset = 0.0619 }
+# the spring
 # the damper
-supports.left.w.damping = 10.0
-subsystems = [ { name = "A", position = 1.0, mass = 1.0, inertia = 1.0, arm_left = 0.0, arm_right = 0.0, mount_y = 0.0, mount_z = 0.0 } ]
-forces = [{ at = "A", direction = "y" }]
+supports.left.w = "fixed"
+supports.left.psi = { stiffness = 5.0, damping = 0.0 }
+supports.right.kind = "clamped"
+subsystems = [ { name = "B", position = 1.0, mass = 1.0, inertia = 1.0, y_left = { stiffness = 9.0, damping = 0.0 }, arm_left = 0.0, arm_right = 0.0, mount_y = 0.0, mount_z = 0.0 }, { name = "A", position = 1.0, mass = 1.0, inertia = 1.0, arm_left = 0.0, arm_right = 0.0, mount_y = 0.0, mount_z = 0.0, y_left = { stiffness = 9.0, damping = 0.0 } } ]
+forces = [{ at = "A", direction = "y", phase = 90.0 }]
   # first
-  { name = "r", measure = "energy" } # last
+  { name = "r", measure = "energy" }, # last
+  { name = "s", measure = "energy" }
 ]
+
+[[studies]]
+name = "new"
+vary = ["beam.length"]
+multiply = [1.0]
"#);
}

#[test]
fn comments_in_arrays_stay_with_their_values() {
    for (array, end) in [
        (
            "[ # open\n  # above 1\n  1.0, # one\n  # above 2\n  2.0, # two\n  3.0 # three\n]",
            "\n]",
        ),
        (
            "[ # open\n  # above 1\n  1.0, # one\n  # above 2\n  2.0, # two\n  3.0, # three\n  # below\n]",
            "# below\n]",
        ),
        (
            "[ # open\n # above 1\n1.0 # one\n,\n # above 2\n 2.0 # two\n, 3.0 # three\n]",
            "\n]",
        ),
    ] {
        let original = EXAMPLE.replace("[0.5, 1.0, 2.0, 4]", array);
        for values in [
            &[1.0, 2.0, 3.0, 4.0][..],
            &[1.0, 2.0],
            &[1.0, 3.0],
            &[2.0, 3.0],
            &[3.0, 2.0, 1.0],
            &[0.5, 1.0, 2.0, 3.0],
            &[2.0],
        ] {
            let mut model = read(&original).unwrap().into_inner();
            let Family::Vary { values: old, .. } = &mut model.studies[0].family else {
                panic!()
            };
            *old = values.to_vec();
            let text = write(&model, &original);
            reads_as(&text, &model);
            let start = text.find("multiply = ").unwrap();
            let new = &text[start..start + text[start..].find("\n\n").unwrap()];
            assert!(new.contains("# open") && new.ends_with(end), "{new}");
            for (value, comment) in [
                (1.0, "# one"),
                (2.0, "# two"),
                (3.0, "# three"),
                (1.0, "# above 1"),
                (2.0, "# above 2"),
            ] {
                assert_eq!(
                    new.contains(comment),
                    values.contains(&value),
                    "{comment} {values:?}\n{array}\n{new}"
                );
            }
        }
    }
}

#[test]
fn line_ends_and_byte_order_mark_stay() {
    let dos = format!("\u{feff}{}", EXAMPLE.replace('\n', "\r\n"));
    let mut model = read(&dos).unwrap().into_inner();
    assert_eq!(model.notes, "Two lines\r\nof notes.");
    model.beam.length = 4.0;
    let text = write(&model, &dos);
    assert_eq!(text, dos.replace("length = 3.2 ", "length = 4.0 "));
    reads_as(&text, &model);
    model.notes = "a\nb\r\nc\t\u{7}".to_owned();
    reads_as(&write(&model, &dos), &model);
}

#[test]
fn texts_keep_their_line_ends_in_a_file_that_mixes_them() {
    let mixed = EXAMPLE.replace("Two lines\n", "Two lines\r\n");
    let mut model = read(&mixed).unwrap().into_inner();
    assert_eq!(write(&model, &mixed), mixed);
    model.beam.length = 4.0;
    reads_as(&write(&model, &mixed), &model);
}

/// A small generator, so that every run sees the same texts (Numerical Recipes' constants).
struct Dice(u64);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % count.max(1)
    }
}

/// Changes a text at random places: bytes, lines, tokens of TOML.
fn mutated(text: &str, dice: &mut Dice) -> String {
    const TOKENS: [&str; 18] = [
        "[",
        "]",
        "{",
        "}",
        "\"",
        "'''",
        "=",
        ".",
        ",",
        "\n",
        "\r",
        "#",
        "[[beam]]\n",
        "nan",
        "1e999",
        "-0",
        "\u{0}",
        "é",
    ];
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=dice.below(3) {
        let at = dice.below(bytes.len());
        match dice.below(5) {
            0 => bytes.truncate(at),
            1 => bytes[at] = (32 + dice.below(95)) as u8,
            2 => {
                let end = (at + dice.below(40)).min(bytes.len());
                bytes.drain(at..end);
            }
            3 => drop(bytes.splice(at..at, TOKENS[dice.below(TOKENS.len())].bytes())),
            _ => {
                let mut lines: Vec<&[u8]> = bytes.split(|byte| *byte == b'\n').collect();
                let (from, to) = (dice.below(lines.len()), dice.below(lines.len()));
                let line = lines.remove(from);
                lines.insert(to.min(lines.len()), line);
                bytes = lines.join(&b'\n');
            }
        }
        if bytes.is_empty() {
            break;
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[test]
fn no_text_makes_it_panic_and_any_original_takes_a_model() {
    let models = [EXAMPLE, OTHER_STYLES].map(|text| read(text).unwrap().into_inner());
    let mut dice = Dice(1);
    for round in 0..3000 {
        let text = mutated([EXAMPLE, OTHER_STYLES][round % 2], &mut dice);
        match read(&text) {
            Ok(model) => {
                assert_eq!(write(&model, &text), text);
                reads_as(&write(&model, ""), &model);
            }
            Err(faults) => {
                assert!(!faults.is_empty());
                let places: Vec<_> = faults
                    .iter()
                    .map(|fault| (fault.line.unwrap(), fault.column.unwrap()))
                    .collect();
                assert!(places.is_sorted(), "{faults:?}");
            }
        }
        for model in &models {
            let merged = write(model, &text);
            assert_eq!(
                read(&merged).map(|found| bits(&found)),
                Ok(bits(model)),
                "{text}\n=>\n{merged}"
            );
        }
    }
}

#[test]
fn a_cut_text_is_refused_or_read() {
    for end in (0..EXAMPLE.len()).filter(|end| EXAMPLE.is_char_boundary(*end)) {
        let _ = read(&EXAMPLE[..end]);
    }
}

#[test]
fn deep_and_large_texts_are_refused() {
    let deep = 100_000;
    for text in [
        format!("a = {}", "[".repeat(deep)),
        format!("a = {}1{}", "[".repeat(deep), "]".repeat(deep)),
        format!("a = {}", "{ a = ".repeat(deep)),
        format!("{}a = 1", "a.".repeat(deep)),
        format!("[{}a]", "a.".repeat(deep)),
        "[[subsystems]]\n".repeat(2_000),
        "\"".repeat(deep),
        "\u{0}".repeat(1_000),
    ] {
        assert!(!read(&text).unwrap_err().is_empty());
        let model = read(EXAMPLE).unwrap().into_inner();
        reads_as(&write(&model, &text), &model);
    }
}

#[test]
fn numbers_that_no_spring_works_on_may_be_left_out_and_stay_out() {
    let with = |springs: &str| {
        let subsystem =
            format!("[[subsystems]]\nname = \"M\"\nposition = 0.5\nmass = 2.0\n{springs}\n[sweep]");
        let text = include_str!("data/own_resonance.toml");
        let (head, _) = text.split_once("[[subsystems]]").unwrap();
        format!("{head}{subsystem}\nfrom = 1.0\nto = 2.0\npoints = 2\n")
    };
    let missing = |springs: &str| match read(&with(springs)) {
        Ok(_) => Vec::new(),
        Err(faults) => faults
            .iter()
            .filter_map(|fault| fault.path.strip_prefix("subsystems.M.").map(str::to_owned))
            .collect(),
    };
    // A spring along y acts at its height alone; one along z turns the mass by its arm, and the beam by its mount.
    assert_eq!(missing(""), [""; 0]);
    assert_eq!(missing("y_left = { stiffness = 0.0 }"), [""; 0]);
    assert_eq!(missing("y_left = { stiffness = 1.0 }"), ["mount_z"]);
    assert_eq!(
        missing("z_left = { damping = 1.0 }"),
        ["inertia", "arm_left", "mount_y"]
    );
    assert_eq!(
        missing("z_right = { stiffness = 1.0 }"),
        ["inertia", "arm_right", "mount_y"]
    );
    let text = with("y_right = { stiffness = 1e3 }\nmount_z = 0.1");
    let mut model = read(&text).unwrap().into_inner();
    assert_eq!(model.subsystems[0].arm_left, 0.0);
    assert_eq!(write(&model, &text), text);
    // Once they have an effect, they are written.
    model.subsystems[0].z_left.stiffness = 1e3;
    let turned = write(&model, &text);
    assert!(
        turned.contains("arm_left = 0.0") && !turned.contains("arm_right"),
        "{turned}"
    );
    reads_as(&turned, &model);
}
