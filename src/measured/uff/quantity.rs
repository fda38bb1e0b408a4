//! The quantity of the numbers in data set 58: motion, load, units and sign.

use super::header::{AxisInfo, Dof, FunctionHeader};
use super::lines::UffLines;
use crate::measured::layout::Layout;
use crate::measured::{Fault, Question, number};
use crate::unit::{self, Amount, Dimension, FrequencyUnit, Kind, Load, Measure, Moves, ValueUnit};

/// Data set 164: one metre and one newton in the units of the file; angles are in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FileUnits {
    length: f64,
    force: f64,
}

/// Without data set 164, SI.
impl Default for FileUnits {
    fn default() -> Self {
        Self {
            length: 1.0,
            force: 1.0,
        }
    }
}

impl FileUnits {
    /// Reads record 2 of data set 164, `3D25.17`.
    pub(super) fn read(lines: &mut UffLines, set: usize) -> Result<Self, Fault> {
        let factors = lines
            .record()
            .and_then(|_| lines.record())
            .unwrap_or_default();
        let factor = |column: usize| {
            let field = factors
                .get(column..factors.len().min(column + 25))
                .unwrap_or_default();
            let factor =
                number::parse(field, false).filter(|factor| factor.is_normal() && *factor > 0.0);
            factor.ok_or_else(|| {
                let message = "no unit factor: a number above 0 would be accepted in 25 columns";
                lines.fault(set, 2, column + 1, message)
            })
        };
        let units = Self {
            length: factor(0)?,
            force: factor(25)?,
        };
        lines.end_set();
        Ok(units)
    }

    /// One unit of the file in SI.
    fn of_motion(self, moves: Moves) -> f64 {
        match moves {
            Moves::Length => self.length.recip(),
            Moves::Angle => 1.0,
            Moves::TwistRate => self.length,
        }
    }

    fn of_load(self, load: Load) -> f64 {
        let arm = match load {
            Load::Force => 1.0,
            Load::Moment => self.length,
            Load::Bimoment => self.length * self.length,
        };
        (self.force * arm).recip()
    }
}

/// The quantity of a function.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FunctionQuantity {
    /// Unit of the abscissa; none if its label is unknown.
    pub(super) frequency: Option<FrequencyUnit>,
    /// Unit of the values; none if it is not given or unknown.
    pub(super) unit: Option<ValueUnit>,
    /// The unknown labels.
    pub(super) unknown: Vec<(Question, String)>,
    /// -1 if exactly one of response and reference is opposite to its axis.
    pub(super) sign: f64,
    pub(super) notes: Vec<String>,
}

/// Numerator or denominator of a ratio, with its unit in SI.
#[derive(Debug, Clone, PartialEq)]
enum RatioSide {
    Motion(Moves, Measure, f64),
    Load(Load, f64),
    /// A complete ratio or an energy, by its unit label.
    Whole(Kind, f64, bool),
    NotGiven,
    /// A unit label that is unknown or does not match the data type.
    Unknown(String),
}

impl FunctionQuantity {
    /// The quantity of a function.
    ///
    /// # Errors
    /// Why the function is not a frequency response, in words.
    pub(super) fn of(header: &FunctionHeader, units: &FileUnits) -> Result<Self, String> {
        let mut notes = Vec::new();
        let mut unknown = Vec::new();
        let frequency = frequency(header, &mut notes)?;
        if frequency.is_none() {
            unknown.push((Question::Frequency, header.abscissa.unit.clone()));
        }
        let numerator = side(&header.ordinate, header.response, units)?;
        let denominator = side(&header.denominator, header.reference, units)?;
        let directed = header.response.direction != 0 || header.ordinate.length != 0;
        if matches!(numerator, RatioSide::Motion(..))
            && !directed
            && header.ordinate.unit.is_empty()
        {
            notes.push("the direction is not given: translation assumed".to_owned());
        }
        let unit = match (numerator, denominator) {
            (RatioSide::Whole(kind, scale, inverse), _) => {
                Some(ValueUnit::scaled(kind, scale, inverse))
            }
            (RatioSide::Unknown(words), _) | (_, RatioSide::Unknown(words)) => {
                unknown.push((Question::Unit, words));
                None
            }
            (numerator, denominator) => ratio(&numerator, &denominator)?,
        };
        Ok(Self {
            frequency,
            unit,
            unknown,
            sign: sign(header, &mut notes),
            notes,
        })
    }

    /// Takes unknown units from the layout.
    pub(super) fn complete(&mut self, layout: Option<&Layout>) {
        if let Some(layout) = layout {
            self.frequency.get_or_insert(layout.frequency);
            self.unit = self.unit.take().or_else(|| layout.unit.clone());
        }
        let (frequency, unit) = (self.frequency.is_none(), self.unit.is_none());
        self.unknown.retain(|(question, _)| {
            if *question == Question::Frequency {
                frequency
            } else {
                unit
            }
        });
        for (_, word) in &self.unknown {
            self.notes.push(format!(
                "{word:?} is not a known unit: numbers are as in the file"
            ));
        }
    }
}

/// The unit of numerator over denominator; none if it is not given.
fn ratio(numerator: &RatioSide, denominator: &RatioSide) -> Result<Option<ValueUnit>, String> {
    let amount = |side: &RatioSide| match *side {
        RatioSide::Motion(moves, measure, one) => Some((Amount::Motion(moves, measure), one)),
        RatioSide::Load(load, one) => Some((Amount::Load(load), one)),
        RatioSide::Whole(..) | RatioSide::NotGiven | RatioSide::Unknown(_) => None,
    };
    Ok(
        match (
            numerator,
            denominator,
            amount(numerator),
            amount(denominator),
        ) {
            // A load over a motion is the inverse of a motion over a load.
            (&RatioSide::Load(load, load_one), &RatioSide::Motion(moves, measure, one), ..) => {
                let dimension = Dimension::of_motion(moves, measure, Some(load));
                Some(ValueUnit::scaled(
                    Kind::Amplitude(dimension),
                    load_one / one,
                    true,
                ))
            }
            (_, RatioSide::NotGiven, Some((of, one)), _) => {
                let dimension = Dimension { of, per: None };
                Some(ValueUnit::scaled(Kind::Amplitude(dimension), one, false))
            }
            (_, _, Some((of, one)), Some((per, per_one))) => {
                let per = Some(per);
                let dimension = Dimension { of, per };
                Some(ValueUnit::scaled(
                    Kind::Amplitude(dimension),
                    one / per_one,
                    false,
                ))
            }
            (_, _, Some(_), None) => {
                return Err("of a motion or force over something else".to_owned());
            }
            (_, _, None, _) => None,
        },
    )
}

/// The unit of the abscissa; none if its label is unknown.
///
/// # Errors
/// Why the function is not a function of frequency.
fn frequency(
    header: &FunctionHeader,
    notes: &mut Vec<String>,
) -> Result<Option<FrequencyUnit>, String> {
    let response = matches!(header.function, 0 | 1 | 4 | 12);
    match header.abscissa.kind {
        18 if response => {}
        0 | 1 if matches!(header.function, 4 | 12) => {
            notes.push("the abscissa type is not given: frequency assumed".to_owned());
        }
        _ if response => return Err("over something other than frequency".to_owned()),
        _ => {
            return Err(format!(
                "of type {} ({})",
                header.function,
                function(header.function)
            ));
        }
    }
    let word = &header.abscissa.unit;
    let unit = FrequencyUnit::from_word(if word.is_empty() { "hz" } else { word });
    if let Some(unit) = unit.filter(|unit| *unit != FrequencyUnit::Hertz) {
        notes.push(format!("frequencies are in {}", unit.key()));
    }
    Ok(unit)
}

/// The name of a function type.
fn function(code: i64) -> &'static str {
    const NAMES: [&str; 10] = [
        "general",
        "time response",
        "auto spectrum",
        "cross spectrum",
        "frequency response",
        "transmissibility",
        "coherence",
        "auto correlation",
        "cross correlation",
        "power spectral density",
    ];
    let index = usize::try_from(code).unwrap_or(usize::MAX);
    NAMES.get(index).copied().unwrap_or("another function")
}

/// The quantity of an axis, from its data type, its direction and its unit label, which must match the type.
fn side(axis: &AxisInfo, end: Dof, units: &FileUnits) -> Result<RatioSide, String> {
    let rotation = end.direction.abs() > 3;
    let words = ValueUnit::parse(&axis.unit).ok();
    let words = words.map(|unit| (unit.kind(), unit.ratio()));
    let load = unit::load(&axis.unit);
    let measure = match axis.kind {
        0 | 1 | 9 | 13 => None,
        8 => Some(Measure::Displacement),
        11 => Some(Measure::Velocity),
        12 => Some(Measure::Acceleration),
        other => return Err(format!("of data type {other}")),
    };
    let of_type = |actual: Measure| measure.is_none_or(|measure| measure == actual);
    let is_load = matches!(axis.kind, 9 | 13);
    Ok(match (words, load, measure) {
        (_, Some((load, one)), None) => RatioSide::Load(load, one),
        (Some((Kind::Amplitude(Dimension { of, per }), (scale, inverse))), _, _)
            if matches!(of, Amount::Motion(_, actual) if of_type(actual))
                && (per.is_some() || !is_load) =>
        {
            match (of, per) {
                (Amount::Motion(moves, measure), None) => RatioSide::Motion(moves, measure, scale),
                _ => RatioSide::Whole(Kind::Amplitude(Dimension { of, per }), scale, inverse),
            }
        }
        (Some((Kind::Energy, (scale, inverse))), _, None) if !is_load => {
            RatioSide::Whole(Kind::Energy, scale, inverse)
        }
        _ if !axis.unit.contains(char::is_alphanumeric) && !axis.unit.contains(['°', '%']) => {
            by_type(axis, measure, rotation, units)
        }
        _ => RatioSide::Unknown(axis.unit.clone()),
    })
}

/// The quantity of an axis without a unit label, from its data type and its direction.
fn by_type(
    axis: &AxisInfo,
    measure: Option<Measure>,
    rotation: bool,
    units: &FileUnits,
) -> RatioSide {
    match measure {
        Some(measure) => {
            let moves = if rotation {
                Moves::Angle
            } else {
                Moves::Length
            };
            RatioSide::Motion(moves, measure, units.of_motion(moves))
        }
        None if matches!(axis.kind, 9 | 13) => {
            let load = if rotation { Load::Moment } else { Load::Force };
            RatioSide::Load(load, units.of_load(load))
        }
        None => RatioSide::NotGiven,
    }
}

/// The sign that converts a ratio to the positive directions of both axes.
fn sign(header: &FunctionHeader, notes: &mut Vec<String>) -> f64 {
    let ends = [header.response, header.reference];
    let against = ends.iter().filter(|end| end.direction < 0).count();
    if against == 1 {
        notes.push(format!(
            "the sign is inverted: {} is opposite to its axis",
            header.dof_names()
        ));
        return -1.0;
    }
    1.0
}
