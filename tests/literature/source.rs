//! The case files: the statements of a source, the model, and the accuracy of the comparison.

use std::collections::BTreeMap;

use beamtune::model::edit::{self, Value};
use beamtune::model::{self, Model};
use serde::Deserialize;

/// One file: one source of the literature.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// The subject of the comparison, a few words for the guide's table.
    pub subject: String,
    pub authors: String,
    pub year: u16,
    pub title: String,
    /// What a reader must know before trusting the numbers.
    pub doubtful: String,
    /// A model file of the format `beamtune/1`, the basis of the cases.
    #[serde(default)]
    pub model: String,
    #[serde(default)]
    pub cases: Vec<Case>,
    /// Sentences without numbers, each checked by a test elsewhere.
    #[serde(default)]
    pub statements: Vec<Statement>,
}

/// One model, with its expected natural frequencies.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    pub name: String,
    /// A model file of its own, in place of the source's.
    pub model: Option<String>,
    /// Parameter paths and their values.
    #[serde(default)]
    pub set: BTreeMap<String, toml::Value>,
    pub published: Option<Published>,
    pub closed_form: Option<ClosedForm>,
}

/// Printed numbers: every natural frequency above zero, up to the last one listed.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    pub unit: Unit,
    pub values: Vec<f64>,
    /// Largest relative difference that the printed digits allow.
    pub tolerance: f64,
    /// True if the source has shear deformation and rotary inertia, so that our frequencies are higher.
    #[serde(default)]
    pub ours_lie_above: bool,
}

/// A frequency equation that the test solves by itself, for all frequencies up to `to` in Hz.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClosedForm {
    pub equation: Equation,
    pub to: f64,
    pub tolerance: f64,
}

/// The frequency equations by name.
#[derive(Deserialize, Clone, Copy)]
#[serde(rename_all = "snake_case")]
pub enum Equation {
    /// Bending in both planes and torsion, each by itself.
    Uncoupled,
    /// Sines and cosines along the beam: pinned and guided ends, coupled.
    Sinusoidal,
    /// The determinant of the boundary conditions, coupled, any ends.
    Determinant,
    /// A mass on a spring on a beam.
    SprungMass,
}

/// The unit of printed numbers.
#[derive(Deserialize, Clone, Copy)]
pub enum Unit {
    #[serde(rename = "Hz")]
    Hertz,
    #[serde(rename = "rad/s")]
    RadianPerSecond,
    /// 1/m: beta times a span of 1 m.
    #[serde(rename = "beta")]
    Beta,
    #[serde(rename = "beta L")]
    BetaL,
    #[serde(rename = "(beta L)^2")]
    BetaLSquared,
    /// Loads of buckling, of a model under 1 N of compression.
    #[serde(rename = "N")]
    Newton,
}

/// A sentence of the source, and the test that checks it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Statement {
    pub figure: String,
    pub sentence: String,
    pub test: String,
    /// Empty if the sentence holds as printed.
    #[serde(default)]
    pub departs: String,
}

impl Source {
    /// The model of a case.
    pub fn model(&self, case: &Case) -> Model {
        let text = case.model.as_ref().unwrap_or(&self.model);
        let mut model = model::read(text)
            .unwrap_or_else(|faults| panic!("{}: {faults:?}", self.subject))
            .into_inner();
        for (path, value) in &case.set {
            let value = match value {
                toml::Value::Float(number) => Value::Number(*number),
                toml::Value::String(word) => Value::Text(word.clone()),
                other => panic!("{}: {path} cannot be {other}", case.name),
            };
            edit::set_unchecked(&mut model, path, value)
                .unwrap_or_else(|fault| panic!("{}: {fault}", case.name));
        }
        let faults = model::check(&model);
        assert!(faults.is_empty(), "{}: {faults:?}", case.name);
        model
    }
}

impl Unit {
    /// The word of the case files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Hertz => "Hz",
            Self::RadianPerSecond => "rad/s",
            Self::Beta => "1/m",
            Self::BetaL => "beta L",
            Self::BetaLSquared => "(beta L)^2",
            Self::Newton => "N",
        }
    }

    /// A frequency in Hz in this unit, a load as it is; beta is the wave number of bending along y.
    pub fn of_hertz(self, hertz: f64, model: &Model) -> f64 {
        let omega = std::f64::consts::TAU * hertz;
        let (beam, section) = (&model.beam, &model.beam.section);
        let speed = (beam.material.young_modulus * section.second_moment_y
            / (beam.material.density * section.area))
            .sqrt();
        match self {
            Self::Hertz | Self::Newton => hertz,
            Self::RadianPerSecond => omega,
            Self::Beta => (omega / speed).sqrt(),
            Self::BetaL => (omega / speed).sqrt() * beam.length,
            Self::BetaLSquared => omega / speed * beam.length.powi(2),
        }
    }

    /// The frequency in Hz of a number in this unit.
    pub fn to_hertz(self, value: f64, model: &Model) -> f64 {
        match self {
            Self::Beta => (value / self.of_hertz(1.0, model)).powi(2),
            Self::BetaL => value.powi(2) / Self::BetaLSquared.of_hertz(1.0, model),
            other => value / other.of_hertz(1.0, model),
        }
    }
}
