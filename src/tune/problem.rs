//! The problem that `[tune]` of a model defines: variables as coordinates, objectives as figures, limits as bounds.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::candidate::{Candidate, Moved};
use super::coordinates::Coordinate;
use super::limits::{self, Bound};
use super::objectives::Figure;
use crate::model::{
    Aim, Checked, Combine, Fault, Limit, Model, Objective, Point, Quantity, Response, Tune,
    check_state, edit, path,
};
use crate::solve::Cancelled;
use crate::solve::modes::{MOST_MODES, are_too_many, count};

/// A model and its `[tune]`, ready for the search.
#[derive(Debug, Clone)]
pub struct Problem {
    /// The original model.
    given: Checked,
    /// The same with only the required responses, so that candidates are cheap.
    bare: Checked,
    tune: Tune,
    pub(super) coordinates: Vec<Coordinate>,
    pub(super) aims: Vec<Aimed>,
    pub(super) bounds: Vec<Bound>,
    /// The modes are required up to this frequency, Hz.
    pub(super) modes_to: Option<f64>,
}

/// An objective with its figure.
#[derive(Debug, Clone)]
pub(super) struct Aimed {
    pub(super) objective: Objective,
    pub(super) figure: Figure,
}

/// Reads the measured curve of an objective, if it has one.
///
/// # Errors
/// The curve cannot be read, needs an answer about its columns, has another quantity than the response, or has no
/// points in the band.
pub fn check_match(model: &Checked, objective: &Objective, folder: &Path) -> Result<(), Fault> {
    let Some(name) = objective.response.as_ref() else {
        return Ok(());
    };
    let mut responses = model.responses.iter();
    match responses.position(|response| response.name == *name) {
        Some(place) => Figure::new(model, objective, place, folder).map(drop),
        None => Err(Fault::new("tune", format!("there is no response {name:?}"))),
    }
}

impl Problem {
    /// Prepares a checked model; measured curves are read from `folder`, that of the model file.
    ///
    /// # Errors
    /// All faults, with the accepted alternatives: there is no `[tune]`, a variable that changes nothing, a measured
    /// curve that cannot be read or has another quantity, a limit of the deflection at rest of a beam that can move
    /// freely.
    pub fn new(model: &Checked, folder: &Path) -> Result<Self, Vec<Fault>> {
        let Some(tune) = &model.tune else {
            let message = "is missing; must have variables and an objective";
            return Err(vec![Fault::new("tune", message)]);
        };
        let mut faults = Vec::new();
        let (bare, places) = bare(model, tune);
        let mut coordinates = Vec::new();
        for (index, variable) in tune.variables.iter().enumerate() {
            match Coordinate::new(model, variable) {
                Ok(one) => coordinates.push(one),
                Err(fault) => faults.push(within(&format!("tune.variables.{}", index + 1), &fault)),
            }
        }
        let mut aims = Vec::new();
        for (objective, place) in tune.objectives.iter().zip(places) {
            match Figure::new(&bare, objective, place, folder) {
                Ok(figure) => aims.push(Aimed {
                    objective: objective.clone(),
                    figure,
                }),
                Err(fault) => faults.push(fault),
            }
        }
        faults.extend(restless(model, tune));
        faults.extend(crowded(model, tune));
        let place = |name: &str| place_of(&bare, name);
        let sweep = [bare.sweep.from, bare.sweep.to];
        let bounds = tune.limits.iter();
        let bounds: Vec<Bound> = bounds
            .map(|limit| Bound::new(limit, sweep, place))
            .collect();
        let ends = aims.iter().filter_map(|aimed| aimed.figure.modes_to());
        let ends = ends.chain(bounds.iter().filter_map(Bound::modes_to));
        let modes_to = ends.reduce(f64::max);
        if let Some(to) = modes_to.filter(|&to| are_too_many(&bare, to)) {
            let message = format!(
                "reaches up to {to:?} Hz, below which there are more than {MOST_MODES} modes; its `to` must be lower"
            );
            faults.push(Fault::new("tune.objective", message));
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Self {
            modes_to,
            given: model.clone(),
            bounds,
            tune: tune.clone(),
            coordinates,
            aims,
            bare,
        })
    }

    /// The original model.
    pub fn model(&self) -> &Checked {
        &self.given
    }

    /// The `[tune]` of the model.
    pub fn tune(&self) -> &Tune {
        &self.tune
    }

    /// The number of variables, each a coordinate from 0 to 1.
    pub fn variables(&self) -> usize {
        self.coordinates.len()
    }

    /// The model at a point of the unit box that was a candidate, so that it is possible; at its own point exactly the
    /// original model.
    pub(super) fn tuned(&self, x: &[f64]) -> Checked {
        self.given.derived(|model| {
            for (one, value) in self.coordinates.iter().zip(self.values(x)) {
                one.set(model, value);
            }
        })
    }

    /// The first parameter of each variable at a point; at the point of the original model its exact values.
    pub(super) fn values(&self, x: &[f64]) -> Vec<f64> {
        let all = self.coordinates.iter().zip(x);
        all.map(|(one, x)| {
            let start = one.start();
            let is_inside = one.variable.min <= start && start <= one.variable.max;
            if is_inside && *x == one.coordinate(start) {
                start
            } else {
                one.value(*x)
            }
        })
        .collect()
    }

    /// The point of a model of the same structure; a value outside its bounds counts as at the bound.
    pub fn point_of(&self, model: &Checked) -> Vec<f64> {
        let value = |one: &Coordinate| {
            let first = one.parameters.first();
            let number = first.and_then(|(id, _)| edit::number(model, *id).ok());
            number.map_or(0.0, |number| one.coordinate(number))
        };
        self.coordinates.iter().map(value).collect()
    }

    /// Paths of the variables whose original value is outside their bounds: the search starts at the bound.
    pub fn outside(&self) -> Vec<String> {
        let beyond = self
            .coordinates
            .iter()
            .filter(|one| one.start() < one.variable.min || one.start() > one.variable.max);
        beyond
            .filter_map(|one| one.parameters.first())
            .map(|(id, _)| path::text(&self.bare, *id))
            .collect()
    }

    /// The combination of figures: a sum, or the largest.
    pub(super) fn combined(&self, figures: &[f64]) -> f64 {
        if let [one] = figures {
            return *one;
        }
        let weighted = figures.iter().zip(&self.aims);
        let weighted = weighted.map(|(figure, aimed)| figure * aimed.objective.weight);
        match self.tune.combine {
            Combine::Sum => weighted.sum(),
            Combine::Worst => weighted.fold(f64::NEG_INFINITY, f64::max),
        }
    }

    /// The candidate at a point; `deviation` is the deviation of each variable from its value, in tolerances: from -1
    /// to 1, empty for none. `None` if the model is invalid, which is possible for a combination of variables within
    /// their bounds, or if it has too many modes to list.
    pub(super) fn candidate<'a>(
        &self,
        x: &[f64],
        deviation: &[f64],
        cancel: &'a AtomicBool,
    ) -> Result<Option<Candidate<'a>>, Cancelled> {
        let mut whole = self.given.clone().into_inner();
        self.set(&mut whole, x, deviation);
        if !check_state(&whole).is_empty() {
            return Ok(None);
        }
        let model = self.bare.derived(|model| self.set(model, x, deviation));
        Candidate::new(model, self.modes_to, cancel)
    }

    /// A valid model of the same structure as a candidate; `None` if it has too many modes to list.
    pub(super) fn trial_of<'a>(
        &self,
        model: &Checked,
        cancel: &'a AtomicBool,
    ) -> Result<Option<Candidate<'a>>, Cancelled> {
        let bare = model.derived(|model| {
            model.responses.clone_from(&self.bare.responses);
            (model.studies, model.tune) = (Vec::new(), None);
        });
        Candidate::new(bare, self.modes_to, cancel)
    }

    /// The original model as a candidate; `None` if it has too many modes to list.
    pub(super) fn trial_as_given<'a>(
        &self,
        cancel: &'a AtomicBool,
    ) -> Result<Option<Candidate<'a>>, Cancelled> {
        Candidate::new(self.bare.clone(), self.modes_to, cancel)
    }

    /// The parameters that each coordinate changes at a point, and their rates.
    pub(super) fn moved(&self, x: &[f64], deviation: &[f64]) -> Vec<Moved> {
        let all = self.coordinates.iter().zip(x).enumerate();
        all.map(|(index, (one, x))| {
            let slope = one.slope(*x) * self.factor(index, deviation);
            one.rates().map(|(id, rate)| (id, rate * slope)).collect()
        })
        .collect()
    }

    /// The factor of a variable for a deviation.
    pub(super) fn factor(&self, index: usize, deviation: &[f64]) -> f64 {
        let share = deviation.get(index).copied().unwrap_or(0.0);
        1.0 + 0.01 * self.coordinates[index].variable.tolerance * share
    }

    fn set(&self, model: &mut Model, x: &[f64], deviation: &[f64]) {
        for (index, (one, x)) in self.coordinates.iter().zip(x).enumerate() {
            one.set(model, one.value(*x) * self.factor(index, deviation));
        }
    }
}

fn within(place: &str, fault: &Fault) -> Fault {
    Fault::new(place, format!("{}: {}", fault.path, fault.message))
}

/// The index of a response by its name.
fn place_of(model: &Checked, name: &str) -> usize {
    let place = model.responses.iter().position(|one| one.name == name);
    place.unwrap_or_default()
}

/// The model with only the required responses, and for each objective the index of its own. The energy of the beam is
/// added if no response gives it.
fn bare(model: &Checked, tune: &Tune) -> (Checked, Vec<usize>) {
    let mut names: Vec<&str> = tune
        .objectives
        .iter()
        .filter_map(|objective| objective.response.as_deref())
        .collect();
    let limits = tune.limits.iter().filter_map(Limit::response);
    names.extend(limits.map(String::as_str));
    let wanted = model
        .responses
        .iter()
        .filter(|one| names.contains(&&*one.name));
    let mut responses: Vec<Response> = wanted.cloned().collect();
    if tune.objectives.iter().any(|one| one.aim == Aim::Energy) {
        responses.push(Response {
            name: String::new(),
            enabled: true,
            quantity: Quantity::Energy,
            point: Point::AXIS,
            over: None,
        });
    }
    let divides = |one: &&Response| {
        let is_used = responses
            .iter()
            .any(|of| of.over.as_ref() == Some(&one.name));
        is_used && !names.contains(&&*one.name)
    };
    let divisors: Vec<Response> = model.responses.iter().filter(divides).cloned().collect();
    for response in &mut responses {
        response.enabled = true;
    }
    let energy = responses.len() - 1;
    responses.extend(divisors.into_iter().map(|of| Response {
        enabled: false,
        ..of
    }));
    let bare = model.derived(|model| {
        (model.title, model.notes) = Default::default();
        (model.responses, model.studies, model.tune) = (responses, Vec::new(), None);
    });
    let place = |objective: &Objective| match &objective.response {
        Some(name) => place_of(&bare, name),
        None => energy,
    };
    let places = tune.objectives.iter().map(place).collect();
    (bare, places)
}

/// Faults of limits on modes that are too many to list.
fn crowded(model: &Checked, tune: &Tune) -> Vec<Fault> {
    let limits = tune.limits.iter().enumerate();
    let crowded = limits.filter_map(|(index, limit)| {
        let to = limits::looks_to(limit).filter(|&to| are_too_many(model, to))?;
        Some(Fault::new(
            format!("tune.limits.{}", index + 1),
            format!("needs the modes up to {to:?} Hz, of which there are more than {MOST_MODES}; its `to` must be lower"),
        ))
    });
    crowded.collect()
}

/// Faults of limits of a deflection at rest of a beam that has none.
fn restless(model: &Checked, tune: &Tune) -> Vec<Fault> {
    /// Hz; a slower motion is that of a rigid body.
    const SLOWEST: f64 = 1e-4;
    let mut faults = Vec::new();
    for (index, limit) in tune.limits.iter().enumerate() {
        let Limit::StaticDeflection { response, .. } = limit else {
            continue;
        };
        let place = format!("tune.limits.{}", index + 1);
        let of = model.responses.iter().find(|one| one.name == *response);
        if !of.is_some_and(|one| one.quantity.is_static()) {
            let message = format!("{response:?} is not a displacement or a force; must be one");
            faults.push(Fault::new(&place, message));
        }
        if count(model, SLOWEST) > 0 {
            let message =
                "needs a beam that rests on its supports; this one can move freely as a rigid body";
            faults.push(Fault::new(&place, message));
        }
    }
    faults
}
