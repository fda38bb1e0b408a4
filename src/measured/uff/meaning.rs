//! What the numbers of data set 58 are: motion, load, units and sense.

use super::head::{Axis, End, Head};
use super::lines::Lines;
use crate::measured::layout::Layout;
use crate::measured::{Fault, Question, number};
use crate::unit::{self, Dimension, FrequencyUnit, Kind, Load, Measure, Moves, ValueUnit};

/// Data set 164: one metre and one newton in the units of the file; angles are in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Units {
    length: f64,
    force: f64,
}

/// Without data set 164, SI.
impl Default for Units {
    fn default() -> Self {
        Self {
            length: 1.0,
            force: 1.0,
        }
    }
}

impl Units {
    /// Reads record 2 of data set 164, `3D25.17`.
    pub(super) fn read(lines: &mut Lines, set: usize) -> Result<Self, Fault> {
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
                let message =
                    "no factor of a unit: a number above 0 would be accepted in 25 columns";
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

/// What the numbers of a function are.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Meaning {
    /// Unit of the abscissa; none where its word is not known.
    pub(super) frequency: Option<FrequencyUnit>,
    /// None where it is not said, or its words are not known.
    pub(super) unit: Option<ValueUnit>,
    /// The words that are not known.
    pub(super) unknown: Vec<(Question, String)>,
    /// -1 where one end looks against its axis, and not both.
    pub(super) sign: f64,
    pub(super) notes: Vec<String>,
}

/// What one side of a ratio is, and one of it in SI.
#[derive(Debug, Clone, PartialEq)]
enum Side {
    Motion(Moves, Measure, f64),
    Load(Load, f64),
    /// A whole ratio or an energy, by its unit in words.
    Whole(Kind, f64, bool),
    Unsaid,
    /// Its unit in words that are not known, or that are not of what its data type says.
    Unknown(String),
}

impl Meaning {
    /// What a function is; in words why it is no frequency response.
    pub(super) fn of(head: &Head, units: &Units) -> Result<Self, String> {
        let mut notes = Vec::new();
        let mut unknown = Vec::new();
        let frequency = frequency(head, &mut notes)?;
        if frequency.is_none() {
            unknown.push((Question::Frequency, head.abscissa.unit.clone()));
        }
        let above = side(&head.ordinate, head.response, units)?;
        let below = side(&head.denominator, head.reference, units)?;
        let directed = head.response.direction != 0 || head.ordinate.length != 0;
        if matches!(above, Side::Motion(..)) && !directed && head.ordinate.unit.is_empty() {
            notes.push("the direction is not said: a translation is taken".to_owned());
        }
        let unit = match (above, below) {
            (Side::Whole(kind, scale, inverse), _) => Some(ValueUnit::scaled(kind, scale, inverse)),
            (Side::Unknown(words), _) | (_, Side::Unknown(words)) => {
                unknown.push((Question::Unit, words));
                None
            }
            (above, below) => ratio(&above, &below)?,
        };
        Ok(Self {
            frequency,
            unit,
            unknown,
            sign: sign(head, &mut notes),
            notes,
        })
    }

    /// Takes for what is not said, or not understood, what a person says of it.
    pub(super) fn answer(&mut self, layout: Option<&Layout>) {
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
                "{word:?} is no unit that is known: numbers stand as in the file"
            ));
        }
    }
}

/// The unit of one side over the other; none where it is not said.
fn ratio(above: &Side, below: &Side) -> Result<Option<ValueUnit>, String> {
    let motion = |moves, measure, per| {
        Kind::Motion(Dimension {
            moves,
            measure,
            per,
        })
    };
    Ok(match (above, below) {
        (&Side::Motion(moves, measure, one), &Side::Load(load, load_one)) => {
            let kind = motion(moves, measure, Some(load));
            Some(ValueUnit::scaled(kind, one / load_one, false))
        }
        (&Side::Motion(moves, measure, one), Side::Unsaid) => {
            Some(ValueUnit::scaled(motion(moves, measure, None), one, false))
        }
        (&Side::Load(load, load_one), &Side::Motion(moves, measure, one)) => {
            let kind = motion(moves, measure, Some(load));
            Some(ValueUnit::scaled(kind, load_one / one, true))
        }
        (Side::Motion(..), _) => return Err("of a motion over a motion".to_owned()),
        (Side::Load(..), _) => return Err("of a load over no motion".to_owned()),
        (Side::Whole(..) | Side::Unsaid | Side::Unknown(_), _) => None,
    })
}

/// The unit of the abscissa, where the function is one of frequency; none where its word is not known.
fn frequency(head: &Head, notes: &mut Vec<String>) -> Result<Option<FrequencyUnit>, String> {
    let response = matches!(head.function, 0 | 1 | 4 | 12);
    match head.abscissa.kind {
        18 if response => {}
        0 | 1 if matches!(head.function, 4 | 12) => {
            notes
                .push("the abscissa is not said to be a frequency: it is taken for one".to_owned());
        }
        _ if response => return Err("over something else than frequency".to_owned()),
        _ => {
            return Err(format!(
                "of type {} ({})",
                head.function,
                function(head.function)
            ));
        }
    }
    let word = &head.abscissa.unit;
    let unit = FrequencyUnit::from_word(if word.is_empty() { "hz" } else { word });
    if let Some(unit) = unit.filter(|unit| *unit != FrequencyUnit::Hertz) {
        notes.push(format!("frequencies are in {}", unit.key()));
    }
    Ok(unit)
}

/// What a function type is called.
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

/// What an axis is of: by its specific data type, its direction and its unit in words, which must be of that type.
fn side(axis: &Axis, end: End, units: &Units) -> Result<Side, String> {
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
    let of_type = |said: Measure| measure.is_none_or(|measure| measure == said);
    let is_load = matches!(axis.kind, 9 | 13);
    Ok(match (words, load, measure) {
        (_, Some((load, one)), None) => Side::Load(load, one),
        (Some((Kind::Motion(said), (scale, false))), _, _)
            if said.per.is_none() && !is_load && of_type(said.measure) =>
        {
            Side::Motion(said.moves, said.measure, scale)
        }
        (Some((Kind::Motion(said), (scale, inverse))), _, _)
            if said.per.is_some() && of_type(said.measure) =>
        {
            Side::Whole(Kind::Motion(said), scale, inverse)
        }
        (Some((Kind::Energy, (scale, inverse))), _, None) if !is_load => {
            Side::Whole(Kind::Energy, scale, inverse)
        }
        _ if !axis.unit.contains(char::is_alphanumeric) && !axis.unit.contains(['°', '%']) => {
            by_type(axis, measure, rotation, units)
        }
        _ => Side::Unknown(axis.unit.clone()),
    })
}

/// What an axis without a unit in words is of: by its specific data type and its direction.
fn by_type(axis: &Axis, measure: Option<Measure>, rotation: bool, units: &Units) -> Side {
    match measure {
        Some(measure) => {
            let moves = if rotation {
                Moves::Angle
            } else {
                Moves::Length
            };
            Side::Motion(moves, measure, units.of_motion(moves))
        }
        None if matches!(axis.kind, 9 | 13) => {
            let load = if rotation { Load::Moment } else { Load::Force };
            Side::Load(load, units.of_load(load))
        }
        None => Side::Unsaid,
    }
}

/// The sense of a ratio: that along both axes.
fn sign(head: &Head, notes: &mut Vec<String>) -> f64 {
    let ends = [head.response, head.reference];
    let against = ends.iter().filter(|end| end.direction < 0).count();
    if against == 1 {
        notes.push(format!(
            "the sign is turned: {} looks against its axis",
            head.places()
        ));
        return -1.0;
    }
    1.0
}
