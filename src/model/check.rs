//! The rules that make a model physically possible.

mod joints;
mod studies;
mod supports;
mod target;
mod tuning;

use super::beam::{Beam, BeamMotion, Section, Span, Theory};
use super::fault::Fault;
use super::id::SupportId;
use super::part::Part;
use super::schema::{
    BEAM, FEWEST_POINTS, FOUNDATION, MATERIAL, MOST_POINTS, Range, Rows, SECTION, SPAN, SUBSYSTEM,
    SUPPORT, SWEEP, branch, elastic,
};
use super::spelling::{LONGEST_NAME, element_keys, is_too_long};
use super::spring::{Spring, SpringName};
use super::toml_literal::format_number;
use super::types::{Model, Restraint, Subsystem, Support, Sweep};
use std::cell::LazyCell;
use std::collections::HashMap;
use std::fmt;
use std::ops::{Deref, RangeInclusive};

/// Accepted magnitudes, in SI units, of numbers > 0: powers and products of a few of them neither overflow nor
/// underflow.
const SIZES: RangeInclusive<f64> = 1e-60..=1e60;

/// A model that passed [`check()`], or at least [`check_state()`]: the input of the solvers.
///
/// It does not change. An edit takes the [`Model`] out and checks it again.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked(pub(super) Model);

impl Checked {
    /// A possible model.
    ///
    /// # Errors
    /// What [`check()`] refuses.
    pub fn new(model: Model) -> Result<Self, Vec<Fault>> {
        Self::if_none(check(&model), model)
    }

    /// A model with a valid structure; its studies and its tuning are not checked.
    ///
    /// # Errors
    /// What [`check_state()`] refuses.
    pub fn of_state(model: Model) -> Result<Self, Vec<Fault>> {
        Self::if_none(check_state(&model), model)
    }

    fn if_none(faults: Vec<Fault>, model: Model) -> Result<Self, Vec<Fault>> {
        if faults.is_empty() {
            Ok(Self(model))
        } else {
            Err(faults)
        }
    }

    /// The same structure with other requests, or with parts removed: `change` may set responses, forces, studies, the
    /// tuning and texts, remove damping, and move parts to positions that were checked before; nothing else.
    pub(crate) fn derived(&self, change: impl FnOnce(&mut Model)) -> Self {
        let mut model = self.0.clone();
        change(&mut model);
        Self(model)
    }

    /// The model, to be changed.
    pub fn into_inner(self) -> Model {
        self.0
    }
}

/// A model of a test with a valid structure.
///
/// # Panics
/// If the structure is invalid.
#[cfg(test)]
pub fn checked(model: &Model) -> Checked {
    Checked::of_state(model.clone()).unwrap()
}

impl Deref for Checked {
    type Target = Model;

    fn deref(&self) -> &Model {
        &self.0
    }
}

/// All faults of a model; empty for a physically possible one.
///
/// The faults come in the order of the model file, without line and column.
pub fn check(model: &Model) -> Vec<Fault> {
    let mut faults = check_state(model);
    studies::check(model, &mut faults);
    faults
}

/// The faults of the structure alone, without studies and tuning: for programs that check many variants of a model.
pub fn check_state(model: &Model) -> Vec<Fault> {
    let mut faults = Vec::new();
    state(model, &mut faults);
    faults
}

/// The rules of the structure itself, without those of the studies and the tuning.
fn state(model: &Model, faults: &mut Vec<Fault>) {
    beam(model, faults);
    for (end, of) in SupportId::WORDS
        .into_iter()
        .zip([&model.supports.left, &model.supports.right])
    {
        support(&format!("supports.{end}"), of, faults);
    }
    supports::inner(model, faults);
    joints::check(model, faults);
    subsystems(model, faults);
    target::forces(model, faults);
    target::responses(model, faults);
    sweep(&model.sweep, faults);
}

/// Every number of a table against its range.
fn numbers<T>(path: &str, of: &T, rows: &Rows<T>, faults: &mut Vec<Fault>) {
    for (key, value) in rows.numbers(of) {
        if let Some(message) = out_of_range(value, key.range) {
            faults.push(Fault::new(format!("{path}.{}", key.key), message));
        }
    }
}

/// Why a number is outside its range.
fn out_of_range(value: f64, range: Range) -> Option<String> {
    let wanted = if !value.is_finite() {
        return Some(not_finite(value));
    } else if !range.holds(value) {
        range.words().to_owned()
    } else if range == Range::Positive && !SIZES.contains(&value) {
        let (least, most) = (SIZES.start(), SIZES.end());
        format!("{least:e} to {most:e}: beyond, products of such numbers have no digits")
    } else {
        return None;
    };
    Some(format!("is {}; must be {wanted}", format_number(value)))
}

/// The message for NaN and the infinities.
pub(super) fn not_finite(value: f64) -> String {
    format!("is {}; must be a finite number", format_number(value))
}

fn beam(model: &Model, faults: &mut Vec<Fault>) {
    numbers("beam", &model.beam, &BEAM, faults);
    if !model.spans.is_empty() {
        // Each span has a length.
        faults.retain(|fault| fault.path != "beam.length");
    }
    for part in Part::all(model) {
        let path = match part {
            Part::Whole => "beam".to_owned(),
            Part::Span(index) => {
                let path = format!("beam.spans.{}", index + 1);
                span(&path, &model.spans[index], &model.beam, faults);
                path
            }
        };
        if let Some(material) = part.material(model) {
            numbers(&format!("{path}.material"), material, &MATERIAL, faults);
        }
        if let Some(one) = part.section(model) {
            section(&format!("{path}.section"), one, model.beam.theory, faults);
        }
        if let Some(foundation) = part.foundation(model) {
            let path = format!("{path}.foundation");
            numbers(&path, foundation, &FOUNDATION, faults);
        }
    }
}

fn span(path: &str, span: &Span, beam: &Beam, faults: &mut Vec<Fault>) {
    numbers(path, span, &SPAN, faults);
    if span.section.unwrap_or(beam.section).warping_constant != 0.0 {
        return;
    }
    for (key, offset) in [("offset_y", span.offset.y), ("offset_z", span.offset.z)] {
        if offset != 0.0 && offset.is_finite() {
            let message = format!(
                "is {}; must be 0, or the warping_constant > 0: without warping stiffness a span lies on the axis of the beam",
                format_number(offset)
            );
            faults.push(Fault::new(format!("{path}.{key}"), message));
        }
    }
}

fn section(path: &str, section: &Section, theory: Theory, faults: &mut Vec<Fault>) {
    numbers(path, section, &SECTION, faults);
    let mut fault =
        |key: &str, message: String| faults.push(Fault::new(format!("{path}.{key}"), message));
    let (least, formula) = section.least_polar_moment();
    if section.polar_moment > 0.0 && section.polar_moment <= least {
        fault(
            "polar_moment",
            format!(
                "is {} m4; must be > {formula} = {least:.5e} m4 (it is taken about the shear centre)",
                format_number(section.polar_moment)
            ),
        );
    }
    let most = section.most_product_moment();
    if section.product_moment.abs() >= most {
        fault(
            "product_moment",
            format!(
                "is {} m4; must be within +-sqrt(I_y I_z) = {most:.5e} m4",
                format_number(section.product_moment)
            ),
        );
    }
    let areas = [
        ("shear_area_y", section.shear_area_y),
        ("shear_area_z", section.shear_area_z),
    ];
    for (key, area) in areas {
        if theory.has_shear() && area == 0.0 {
            fault(
                key,
                format!(
                    "is missing or 0; must be > 0 m2 for the theory \"{}\"",
                    theory.key()
                ),
            );
        }
    }
    if section.torsion_constant == 0.0 && section.warping_constant == 0.0 {
        let message = "is 0 with a warping_constant of 0, so nothing resists twist; one of the two must be > 0";
        fault("torsion_constant", message.to_owned());
    }
}

fn support(path: &str, support: &Support, faults: &mut Vec<Fault>) {
    numbers(path, support, &SUPPORT, faults);
    for motion in BeamMotion::ALL {
        if let Restraint::Elastic(restraint) = &support[motion] {
            let path = format!("{path}.{}", motion.key());
            numbers(&path, restraint, elastic(motion), faults);
            branches(&path, &restraint.spring, motion, faults);
        }
    }
}

/// The numbers of the Maxwell branches of a spring.
fn branches(path: &str, spring: &Spring, motion: BeamMotion, faults: &mut Vec<Fault>) {
    for (index, of) in spring.maxwell.iter().enumerate() {
        let path = format!("{path}.maxwell.{}", index + 1);
        numbers(&path, of, branch(motion), faults);
    }
}

/// Names that are empty, contain control characters, are too long or are not unique.
fn element_names<'a>(
    path: &str,
    names: &(impl Iterator<Item = &'a str> + Clone),
    faults: &mut Vec<Fault>,
) {
    let keys = LazyCell::new(|| element_keys(names.clone()));
    let mut seen = HashMap::new();
    for (index, name) in names.clone().enumerate() {
        let first = *seen.entry(name).or_insert(index);
        let message = if name.trim().is_empty() {
            "is empty; must be a name".to_owned()
        } else if name.contains(char::is_control) {
            format!("{name:?} contains a control character; must be one line of text")
        } else if is_too_long(name) {
            let length = name.chars().count();
            format!("is {length} characters long; must be at most {LONGEST_NAME}")
        } else if first != index {
            format!(
                "{name:?} is used twice, first by number {}; must be unique",
                first + 1
            )
        } else {
            continue;
        };
        faults.push(Fault::new(format!("{path}.{}.name", keys[index]), message));
    }
}

fn subsystems(model: &Model, faults: &mut Vec<Fault>) {
    let names = model
        .subsystems
        .iter()
        .map(|subsystem| subsystem.name.as_str());
    element_names("subsystems", &names, faults);
    let is_sound = |one| {
        let mut found = Vec::new();
        subsystem("", one, model, &mut found);
        found.is_empty()
    };
    // Building a path takes longer than checking a rule.
    if model.subsystems.iter().all(is_sound) {
        return;
    }
    for (one, key) in model.subsystems.iter().zip(element_keys(names)) {
        subsystem(&format!("subsystems.{key}"), one, model, faults);
    }
}

fn subsystem(path: &str, one: &Subsystem, model: &Model, faults: &mut Vec<Fault>) {
    if matches!(one.name.as_str(), "left" | "right") {
        faults.push(Fault::new(
            format!("{path}.name"),
            format!("{:?} is an end of the beam; must be another name", one.name),
        ));
    }
    numbers(path, one, &SUBSYSTEM, faults);
    for (key, spring) in SpringName::WORDS.iter().zip(one.springs()) {
        branches(&format!("{path}.{key}"), spring, BeamMotion::W, faults);
    }
    let path = format_args!("{path}.position");
    beyond_the_end(path, one.position, model, faults);
}

/// A position beyond the right end; the range of the key rejects those before the left end.
fn beyond_the_end(path: fmt::Arguments<'_>, position: f64, model: &Model, faults: &mut Vec<Fault>) {
    let length = model.length();
    if position.is_finite() && length > 0.0 && position > length {
        faults.push(Fault::new(
            path.to_string(),
            format!(
                "is {}; must be 0 to {} m, on the beam",
                format_number(position),
                format_number(length)
            ),
        ));
    }
}

fn sweep(sweep: &Sweep, faults: &mut Vec<Fault>) {
    numbers("sweep", sweep, &SWEEP, faults);
    band("sweep", sweep.from, sweep.to, faults);
    if !(FEWEST_POINTS..=MOST_POINTS).contains(&sweep.points) {
        faults.push(Fault::new(
            "sweep.points",
            format!(
                "is {}; must be {FEWEST_POINTS} to {MOST_POINTS}",
                sweep.points
            ),
        ));
    }
}

/// A band's end that is not above its start.
fn band(path: &str, from: f64, to: f64, faults: &mut Vec<Fault>) {
    if to > 0.0 && to <= from {
        faults.push(Fault::new(
            format!("{path}.to"),
            format!(
                "is {}; must be above from = {} Hz",
                format_number(to),
                format_number(from)
            ),
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::super::types::{Case, Family, Operation, Study};
    use super::*;

    const SMALLEST: &str = r#"
        format = "beamtune/1"
        title = "a bare beam"
        beam.length = 1.0
        beam.material = { young_modulus = 2e11, shear_modulus = 8e10, density = 7850.0 }
        sweep = { from = 1.0, to = 2.0, points = 2 }
        [beam.section]
        area = 1e-2
        second_moment_y = 1e-5
        second_moment_z = 1e-5
        torsion_constant = 1e-7
        warping_constant = 0.0
        polar_moment = 2e-5
        centroid_offset = 0.0
    "#;

    fn smallest() -> Model {
        super::super::read(SMALLEST).unwrap().into_inner()
    }

    fn faults(model: &Model) -> Vec<String> {
        check(model).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn numbers_must_be_finite() {
        let mut model = smallest();
        assert_eq!(faults(&model), [""; 0]);
        model.beam.material.density = f64::NAN;
        model.sweep.to = f64::INFINITY;
        model.supports.left[BeamMotion::PsiSlope] =
            Restraint::Elastic(super::super::spring::Elastic {
                spring: Spring {
                    damping: f64::NEG_INFINITY,
                    ..Spring::default()
                },
                ..Default::default()
            });
        assert_eq!(
            faults(&model),
            [
                "beam.material.density: is nan; must be a finite number",
                "supports.left.psi_slope.damping: is -inf; must be a finite number",
                "sweep.to: is inf; must be a finite number",
            ]
        );
    }

    #[test]
    fn a_study_with_an_impossible_curve_does_not_stand_in_the_way() {
        let mut model = smallest();
        let family = Family::Vary {
            paths: vec!["beam.section.area".into()],
            operation: Operation::Multiply,
            values: vec![1.0, -1.0],
        };
        model.studies.push(Study {
            name: "area".to_owned(),
            family,
        });
        assert_eq!(faults(&model), [""; 0]);
        model.beam.section.area = 0.0;
        assert_eq!(faults(&model), ["beam.section.area: is 0.0; must be > 0"]);
    }

    #[test]
    fn ambiguous_names_are_numbers_in_paths() {
        let long = "n".repeat(LONGEST_NAME + 1);
        let names = ["a", "", "a", "b.c", "7", "two\nlines", &long];
        let keys = element_keys(names.into_iter());
        assert_eq!(keys, ["a", "2", "3", "\"b.c\"", "\"7\"", "6", "7"]);
    }

    #[test]
    fn a_name_has_at_most_200_characters() {
        let mut model = crate::model::read(crate::presets::find("fig08").unwrap().text)
            .unwrap()
            .into_inner();
        let study = |name: &str| Study {
            name: "é".repeat(200),
            family: Family::Cases(vec![Case {
                name: name.to_owned(),
                set: vec![("beam.length".into(), 1.0)],
            }]),
        };
        (model.studies, model.tune) = (vec![study(&"é".repeat(200))], None);
        model.responses[0].name = "é".repeat(200);
        assert_eq!(faults(&model), [""; 0]);
        let long = "é".repeat(65_536);
        model.responses[0].name.clone_from(&long);
        model.studies[0] = study(&long);
        model.studies[0].name.clone_from(&long);
        let words = "name: is 65536 characters long; must be at most 200";
        assert_eq!(
            faults(&model),
            [
                format!("responses.1.{words}"),
                format!("studies.1.{words}"),
                format!("studies.1.cases.1.{words}")
            ]
        );
    }
}
