//! Tuning: any `[tune]`, and edits of it in its text.

use beamtune::model::*;
use proptest::collection::vec;
use proptest::prelude::*;

use super::{edit_in, model, not_negative, positive, reads_as, with_comments};

/// Names of enabled responses: all, those that have a phase, those that are not 0 at rest.
fn response_names(responses: &[Response]) -> [Vec<String>; 3] {
    let fits = |quantity: &Quantity, least: usize| match least {
        0 => true,
        1 => !quantity.is_quadratic(),
        _ => quantity.is_static(),
    };
    [0, 1, 2].map(|least| {
        let found = responses
            .iter()
            .filter(|response| response.enabled && fits(&response.quantity, least));
        found.map(|response| response.name.clone()).collect()
    })
}

fn variables() -> impl Strategy<Value = Vec<Variable>> {
    let pools: Vec<Vec<&str>> = vec![
        vec!["beam.material.density"],
        vec!["beam.material.young_modulus", "beam.material.shear_modulus"],
        vec!["beam.section.second_moment_y"],
    ];
    let one = |paths: Vec<&'static str>| {
        let scales = [None, Some(Spacing::Linear), Some(Spacing::Log)];
        let tolerances = prop_oneof![Just(0.0), Just(-0.0), 0.0..99.9_f64];
        (
            prop::sample::select(Hold::ALL.to_vec()),
            positive(),
            prop::sample::select(scales.to_vec()),
            tolerances,
        )
            .prop_map(move |(hold, size, scale, tolerance)| Variable {
                paths: paths.iter().map(|path| (*path).into()).collect(),
                hold,
                min: size,
                max: size * 2.0,
                scale,
                tolerance,
            })
    };
    prop::sample::subsequence(pools, 1..=3)
        .prop_shuffle()
        .prop_flat_map(move |pools| pools.into_iter().map(one).collect::<Vec<_>>())
}

/// The objective, and its response.
fn aim(
    names: &[Vec<String>; 3],
    from: f64,
    to: f64,
) -> impl Strategy<Value = (Aim, Option<String>)> + use<> {
    let mut aims = vec![Just((Aim::Energy, None)).boxed()];
    let [any, motions, _] = names.clone();
    if !any.is_empty() {
        let peak = |response| (Aim::Peak, Some(response));
        let mean_square = |response| (Aim::MeanSquare, Some(response));
        aims.push(prop::sample::select(any.clone()).prop_map(peak).boxed());
        aims.push(prop::sample::select(any).prop_map(mean_square).boxed());
    }
    if !motions.is_empty() {
        let name = || prop::sample::select(motions.clone());
        let width =
            (name(), positive()).prop_map(|(name, below)| (Aim::Width { below }, Some(name)));
        let place = (name(), 0.0..=1.0_f64).prop_map(move |(name, share)| {
            let at = (to - from).mul_add(share, from).clamp(from, to);
            (Aim::AntiResonance { at }, Some(name))
        });
        let compare = prop::sample::select(Compare::ALL.to_vec());
        let files = "[a-z./ \"\\\\']{0,8}[.]csv";
        let curves = prop::option::of("[ -~äß€]{0,5}x");
        let matched = (name(), files, curves.clone(), curves, compare).prop_map(|found| {
            let (name, file, curve, columns, compare) = found;
            let aim = Aim::Match {
                file,
                curve,
                columns,
                compare,
            };
            (aim, Some(name))
        });
        aims.extend([width.boxed(), place.boxed(), matched.boxed()]);
    }
    proptest::strategy::Union::new(aims).boxed()
}

fn objective(names: [Vec<String>; 3]) -> impl Strategy<Value = Objective> {
    let weight = prop_oneof![Just(1.0), positive()];
    (positive(), weight).prop_flat_map(move |(from, weight)| {
        let to = from * 3.0;
        aim(&names, from, to).prop_map(move |(aim, response)| Objective {
            aim,
            response,
            from,
            to,
            weight,
        })
    })
}

fn limit(names: &[Vec<String>; 3]) -> BoxedStrategy<Limit> {
    let mass = positive().prop_map(|at_most| Limit::AddedMass { at_most });
    let band = (not_negative(), positive()).prop_map(|(from, width)| Limit::NoMode {
        from,
        to: from.mul_add(2.0, width),
    });
    let buckling = positive().prop_map(|at_least| Limit::Buckling { at_least });
    if names[2].is_empty() {
        return prop_oneof![mass, band, buckling].boxed();
    }
    let deflection = (prop::sample::select(names[2].clone()), positive())
        .prop_map(|(response, at_most)| Limit::StaticDeflection { response, at_most });
    prop_oneof![mass, band, buckling, deflection].boxed()
}

pub fn tune(responses: &[Response]) -> BoxedStrategy<Option<Tune>> {
    let names = response_names(responses);
    let limits = vec(limit(&names), 0..3);
    let tune = (
        variables(),
        vec(objective(names), 1..4),
        prop::sample::select(Combine::ALL.to_vec()),
        limits,
    )
        .prop_map(|(variables, objectives, combine, limits)| Tune {
            variables,
            objectives,
            combine,
            limits,
        });
    prop::option::of(tune).boxed()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn edits_keep_every_comment_of_the_tuning(old in model(), size in positive(), turn in 0..3_usize) {
        let Some(tune) = &old.tune else { return Ok(()) };
        let old = Model { title: "one line".to_owned(), notes: "one line".to_owned(), ..old.clone() };
        let (original, count) = with_comments(&write(&old, ""));
        let mut tune = tune.clone();
        let turns = turn % tune.variables.len();
        tune.variables.rotate_left(turns);
        for variable in &mut tune.variables {
            (variable.min, variable.max, variable.tolerance) = (size, size * 3.0, 5.0);
        }
        let turns = turn % tune.objectives.len();
        tune.objectives.rotate_left(turns);
        tune.objectives[0].weight = size;
        tune.combine = Combine::Worst;
        tune.limits.push(Limit::AddedMass { at_most: size });
        let edited = Model { tune: Some(tune), ..old };
        prop_assume!(check(&edited).is_empty());
        let text = write(&edited, &original);
        reads_as(&text, &edited);
        for number in 1..=count {
            prop_assert!(text.contains(&format!("# note {number};")), "note {number} is gone\n{original}\n=>\n{text}");
        }
    }
}

/// The example with a typical tuning.
fn tuned() -> String {
    let example = super::EXAMPLE.replace("\n# The end.\n", "");
    example
        + r#"
# What the absorbers are for.
[tune]
variables = [
    # the springs
    { path = "subsystems.*.y_left.stiffness", min = 1e5, max = 1e8 },   # kN/mm
    { paths = ["subsystems.S1.mass"], min = 10, max = 200.0, tolerance = 5 },
]
objective = { minimise = "peak", response = "P5 w", from = 20.0, to = 120.0 }  # as low as can be
"#
}

/// A tuning with one of everything.
const WHOLE: &str = include_str!("../data/tuned.toml");

#[test]
fn everything_is_read_as_it_stands() {
    let tune = read(WHOLE).unwrap().into_inner().tune.unwrap();
    let name = || "P5 w".to_owned();
    let aims = [
        Aim::Peak,
        Aim::MeanSquare,
        Aim::Energy,
        Aim::Width { below: 1e-7 },
        Aim::AntiResonance { at: 85.0 },
        Aim::Match {
            file: "measured.csv".to_owned(),
            curve: Some("tip".to_owned()),
            columns: Some("hz; re im; m/N".to_owned()),
            compare: Compare::Complex,
        },
        Aim::Match {
            file: "measured.unv".to_owned(),
            curve: None,
            columns: None,
            compare: Compare::LogMagnitude,
        },
    ];
    let found: Vec<_> = tune.objectives.iter().map(|one| one.aim.clone()).collect();
    assert_eq!(found, aims);
    let responses = tune.objectives.iter().map(|one| one.response.as_deref());
    let [w, v] = [Some("P5 w"), Some("P5 v")];
    assert_eq!(responses.collect::<Vec<_>>(), [w, v, None, w, w, w, v]);
    let weights = tune.objectives.iter().map(|one| one.weight);
    assert_eq!(
        weights.collect::<Vec<_>>(),
        [1.0, 0.5, 1.0, 1.0, 1.0, 1.0, 1.0]
    );
    assert!(
        tune.objectives
            .iter()
            .all(|one| (one.from, one.to) == (20.0, 120.0))
    );
    let variable = |paths: &[&str], hold, min, max| Variable {
        paths: paths.iter().map(|path| (*path).into()).collect(),
        hold,
        min,
        max,
        scale: None,
        tolerance: 0.0,
    };
    let damping = ["supports.left.w.damping", "subsystems.S1.y_left.damping"];
    let variables = [
        variable(&["subsystems.*.z_left.stiffness"], Hold::Equal, 1e5, 1e8),
        variable(&damping, Hold::Equal, 1.0, 1e4),
        Variable {
            scale: Some(Spacing::Log),
            tolerance: 5.0,
            ..variable(
                &["subsystems.*.mass", "subsystems.*.inertia"],
                Hold::Ratio,
                10.0,
                300.0,
            )
        },
    ];
    assert_eq!(tune.variables, variables);
    assert_eq!(tune.combine, Combine::Worst);
    let limits = [
        Limit::AddedMass { at_most: 300.0 },
        Limit::NoMode {
            from: 45.0,
            to: 55.0,
        },
        Limit::StaticDeflection {
            response: name(),
            at_most: 1e-3,
        },
        Limit::Buckling { at_least: 2.0 },
    ];
    assert_eq!(tune.limits, limits);
}

#[test]
fn a_new_name_goes_to_objectives_limits_and_variables() {
    let mut model = read(WHOLE).unwrap().into_inner();
    let text = |word: &str| edit::Value::Text(word.to_owned());
    edit::set(&mut model, "responses.P5 w.name", text("tip")).unwrap();
    edit::set(&mut model, "subsystems.S1.name", text("a.b")).unwrap();
    let tune = model.tune.clone().unwrap();
    let named: Vec<_> = tune
        .objectives
        .iter()
        .filter_map(|one| one.response.as_deref())
        .collect();
    assert_eq!(named, ["tip", "P5 v", "tip", "tip", "tip", "P5 v"]);
    let deflection = Limit::StaticDeflection {
        response: "tip".to_owned(),
        at_most: 1e-3,
    };
    assert_eq!(tune.limits[2], deflection);
    assert_eq!(
        tune.variables[1].paths[1],
        "subsystems.\"a.b\".y_left.damping"
    );
    reads_as(&write(&model, WHOLE), &model);
}

fn edited(change: impl Fn(&mut Tune)) -> String {
    edit_in(&tuned(), |model| change(model.tune.as_mut().unwrap()))
}

fn width() -> Objective {
    Objective {
        aim: Aim::Width { below: 1e-7 },
        response: Some("P5 w".to_owned()),
        from: 20.0,
        to: 120.0,
        weight: 1.0,
    }
}

#[test]
fn the_old_form_and_lists_of_one_stay() {
    let text = tuned();
    assert_eq!(write(&read(&text).unwrap().into_inner(), &text), text);
    let listed = text
        .replace("objective = {", "objectives = [ {")
        .replace("120.0 }", "120.0 } ]\ncombine = \"sum\"\nlimits = []");
    let model = read(&listed).unwrap().into_inner();
    assert_eq!(model, read(&text).unwrap().into_inner());
    assert_eq!(write(&model, &listed), listed);
}

#[test]
fn bounds_change_alone() {
    insta::assert_snapshot!(edited(|tune| {
        tune.variables[0].max = 2e8;
        tune.variables[1].scale = Some(Spacing::Log);
        tune.objectives[0].to = 130.0;
    }), @r#"
     # the springs
-    { path = "subsystems.*.y_left.stiffness", min = 1e5, max = 1e8 },   # kN/mm
-    { paths = ["subsystems.S1.mass"], min = 10, max = 200.0, tolerance = 5 },
+    { path = "subsystems.*.y_left.stiffness", min = 1e5, max = 2e8 },   # kN/mm
+    { paths = ["subsystems.S1.mass"], min = 10, max = 200.0, tolerance = 5, scale = "log" },
 ]
-objective = { minimise = "peak", response = "P5 w", from = 20.0, to = 120.0 }  # as low as can be
+objective = { minimise = "peak", response = "P5 w", from = 20.0, to = 130.0 }  # as low as can be
"#);
}

#[test]
fn variables_come_and_go_with_their_comments() {
    insta::assert_snapshot!(edited(|tune| {
        tune.variables.push(Variable {
            paths: vec!["subsystems.*.arm_left".into(), "subsystems.*.arm_right".into()],
            hold: Hold::Ratio,
            min: 0.05,
            max: 0.4,
            scale: None,
            tolerance: 0.0,
        });
    }), @r#"
     { paths = ["subsystems.S1.mass"], min = 10, max = 200.0, tolerance = 5 },
+    { paths = ["subsystems.*.arm_left", "subsystems.*.arm_right"], hold = "ratio", min = 0.05, max = 0.4 },
"#);
    insta::assert_snapshot!(edited(|tune| {
        drop(tune.variables.remove(0));
        tune.variables[0].max = 300.0;
    }), @r#"
 variables = [
-    # the springs
-    { path = "subsystems.*.y_left.stiffness", min = 1e5, max = 1e8 },   # kN/mm
-    { paths = ["subsystems.S1.mass"], min = 10, max = 200.0, tolerance = 5 },
+    { paths = ["subsystems.S1.mass"], min = 10, max = 300.0, tolerance = 5 },
"#);
    insta::assert_snapshot!(edited(|tune| {
        tune.variables.swap(0, 1);
        tune.variables[0].min = 20.0;
        tune.variables[1].min = 2e5;
    }), @r#"
 variables = [
+    { paths = ["subsystems.S1.mass"], min = 20.0, max = 200.0, tolerance = 5 },
     # the springs
-    { path = "subsystems.*.y_left.stiffness", min = 1e5, max = 1e8 },   # kN/mm
-    { paths = ["subsystems.S1.mass"], min = 10, max = 200.0, tolerance = 5 },
+    { path = "subsystems.*.y_left.stiffness", min = 2e5, max = 1e8 },   # kN/mm
"#);
}

#[test]
fn an_objective_is_replaced() {
    insta::assert_snapshot!(edited(|tune| tune.objectives[0] = width()), @r#"
 ]
-objective = { minimise = "peak", response = "P5 w", from = 20.0, to = 120.0 }  # as low as can be
+objective = { maximise = "width", response = "P5 w", from = 20.0, to = 120.0, below = 1e-7 }  # as low as can be
"#);
    insta::assert_snapshot!(edited(|tune| {
        tune.objectives[0].aim = Aim::Energy;
        tune.objectives[0].response = None;
    }), @r#"
 ]
-objective = { minimise = "peak", response = "P5 w", from = 20.0, to = 120.0 }  # as low as can be
+objective = { minimise = "energy", from = 20.0, to = 120.0 }  # as low as can be
"#);
}

#[test]
fn objectives_and_limits_are_added() {
    insta::assert_snapshot!(edited(|tune| {
        tune.objectives.push(width());
        tune.combine = Combine::Worst;
        tune.limits = vec![
            Limit::AddedMass { at_most: 300.0 },
            Limit::NoMode { from: 45.0, to: 55.0 },
            Limit::StaticDeflection { response: "P5 w".to_owned(), at_most: 1e-3 },
            Limit::Buckling { at_least: 1.5 },
        ];
    }), @r#"
 ]
-objective = { minimise = "peak", response = "P5 w", from = 20.0, to = 120.0 }  # as low as can be
+# as low as can be
+objectives = [
+    { minimise = "peak", response = "P5 w", from = 20.0, to = 120.0 },
+    { maximise = "width", below = 1e-7, response = "P5 w", from = 20.0, to = 120.0 },
+]
+combine = "worst"
+limits = [
+    { limit = "added_mass", at_most = 300.0 },
+    { limit = "no_mode", from = 45.0, to = 55.0 },
+    { limit = "static_deflection", response = "P5 w", at_most = 0.001 },
+    { limit = "buckling", at_least = 1.5 },
+]
"#);
}

#[test]
fn tables_below_headers_are_kept() {
    let text = super::EXAMPLE.to_owned()
        + r#"
[[tune.variables]]      # the first
path = "subsystems.*.y_left.stiffness"
min = 1e5
max = 1e8

[[tune.objectives]]     # low
minimise = "peak"
response = "P5 w"
from = 20.0
to = 120.0

[[tune.objectives]]     # quiet
minimise = "energy"
from = 20.0
to = 120.0
"#;
    let change = |model: &mut Model| {
        let tune = model.tune.as_mut().unwrap();
        tune.variables[0].min = 2e5;
        tune.objectives[1] = width();
        tune.objectives.swap(0, 1);
        tune.limits.push(Limit::NoMode {
            from: 0.0,
            to: 10.0,
        });
    };
    insta::assert_snapshot!(edit_in(&text, change), @r#"
 ]
+[tune]
+limits = [{ limit = "no_mode", from = 0.0, to = 10.0 }]
+
 path = "subsystems.*.y_left.stiffness"
-min = 1e5
+min = 2e5
 max = 1e8
-[[tune.objectives]]     # low
-minimise = "peak"
-response = "P5 w"
+[[tune.objectives]]     # quiet
 to = 120.0
+maximise = "width"
+below = 1e-7
+response = "P5 w"
-[[tune.objectives]]     # quiet
-minimise = "energy"
+[[tune.objectives]]     # low
+minimise = "peak"
+response = "P5 w"
"#);
}
