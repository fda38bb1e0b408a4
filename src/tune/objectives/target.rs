//! A measured curve as the target of a response.

use std::path::Path;

use num_complex::Complex64;

use super::matching::Matching;
use crate::measured::{self, Curve, Hint, Inspection, Layout, Opened};
use crate::model::{Aim, Checked, Compare, Fault, Objective};
use crate::solve::Reference;
use crate::unit::{Dimension, Kind, Load};

/// The target values of a response at the measured frequencies in a band.
///
/// # Errors
/// The file cannot be read, has no such curve, is of another quantity, or leaves nothing to compare.
pub(super) fn matching(
    model: &Checked,
    objective: &Objective,
    response: usize,
    folder: &Path,
) -> Result<Matching, Fault> {
    let Aim::Match {
        file,
        curve,
        columns,
        compare,
    } = &objective.aim
    else {
        return Err(Fault::new("tune", "has no measured curve"));
    };
    let band = [objective.from, objective.to];
    let name = objective.response.as_deref().unwrap_or_default();
    let about = |fault: Fault| Fault::new(format!("tune: {file}"), fault.to_string());
    let all = read(&folder.join(file), file, columns.as_deref()).map_err(about)?;
    let one = choose(&all, curve.as_deref(), name)
        .map_err(|message| Fault::new(format!("tune: {file}"), message))?;
    let values = in_form_of(model, one, response)
        .map_err(|message| Fault::new(format!("tune: {file}: {}", one.name), message))?;
    if *compare == Compare::Complex && !one.phase_known {
        let message = "has no phase; compare = \"log_magnitude\" would be accepted";
        return Err(Fault::new(format!("tune: {file}: {}", one.name), message));
    }
    let points = one.frequencies.iter().copied().zip(values);
    let (frequencies, values): (Vec<f64>, Vec<Complex64>) = points
        .filter(|(frequency, value)| {
            let inside = band[0] <= *frequency && *frequency <= band[1];
            inside && value.is_finite() && value.norm() > 0.0
        })
        .unzip();
    if frequencies.is_empty() {
        let message = format!(
            "has no value other than 0 from {} to {} Hz; a band with some would be accepted",
            band[0], band[1]
        );
        return Err(Fault::new(format!("tune: {file}: {}", one.name), message));
    }
    Ok(Matching {
        response,
        compare: *compare,
        frequencies,
        values,
    })
}

fn read(path: &Path, name: &str, columns: Option<&str>) -> Result<Vec<Curve>, Fault> {
    let layout = columns.map(Layout::parse).transpose();
    let hint = Hint {
        name: name.to_owned(),
        layout: layout.map_err(|message| Fault::new("columns", message))?,
    };
    let bytes = measured::load(path)?;
    match measured::open_in_si(&bytes, &hint)? {
        Opened::Curves(curves) => Ok(curves),
        Opened::Asks(seen) => Err(Fault::new("", asked(&seen))),
    }
}

/// The answers to questions that a file leaves open.
fn asked(seen: &Inspection) -> String {
    let mut known = seen.preview();
    if known.is_empty() {
        known.clone_from(&seen.recognised);
    }
    format!(
        "{} ({}); an answer would be accepted, as columns = \"{}\", with ? for the unit of the response",
        seen.question(),
        known.join("; "),
        seen.proposal
    )
}

/// The curve with a name; without a name that of the response's name, or the only one.
fn choose<'a>(all: &'a [Curve], curve: Option<&str>, response: &str) -> Result<&'a Curve, String> {
    let named = |name: &str| all.iter().find(|one| one.name == name);
    let found = match (curve, all) {
        (Some(name), _) => named(name),
        (None, [only]) => Some(only),
        (None, _) => named(response),
    };
    let names = || {
        let names: Vec<String> = all
            .iter()
            .take(8)
            .map(|one| format!("{:?}", one.name))
            .collect();
        names.join(", ")
    };
    let wanted = curve.unwrap_or(response);
    found.ok_or_else(|| {
        format!(
            "has no curve {wanted:?}; accepted would be curve = one of {}",
            names()
        )
    })
}

/// The values of a measured curve in the form and unit of a response, for the loads of the model. Unknown properties
/// count as those of the response itself.
fn in_form_of(model: &Checked, curve: &Curve, response: usize) -> Result<Vec<Complex64>, String> {
    let Some(Kind::Amplitude(own)) = curve.kind else {
        return match curve.kind {
            None => Ok(curve.values.clone()),
            Some(_) => Err("is an energy; must be a complex response".to_owned()),
        };
    };
    let reference = Reference::of(model);
    let dimension = |per: Option<Load>| {
        let response = model.responses.get(response);
        response.and_then(|one| one.kind(model, per).dimension())
    };
    let [alone, divided] = [None, reference.map(|one| one.load)].map(dimension);
    let is_alike = |one: &Dimension| one.is_alike(own);
    let unit = Kind::Amplitude(own).unit();
    let (dimension, amplitude) = match (alone.filter(is_alike), divided.filter(is_alike), reference)
    {
        (Some(alone), ..) => (alone, Complex64::ONE),
        (None, Some(divided), Some(reference)) => (divided, reference.amplitude),
        _ if alone.is_some_and(|one| one.of_same_motion(own)) => {
            return Err(format!(
                "is in {unit}, per load; the model must have exactly that force, so that its response can be divided by it",
            ));
        }
        _ => return Err(format!("is in {unit}, which does not match the response")),
    };
    let points = curve.frequencies.iter().zip(&curve.values);
    Ok(points
        .map(|(frequency, value)| {
            amplitude * own.converted(*value, *frequency, dimension.own_form())
        })
        .collect())
}
