//! Exports the chart: numbers as CSV, a drawing as SVG, both with their provenance.

mod csv;
mod svg;

pub use csv::csv;
pub use svg::svg;

use sha2::{Digest, Sha256};

use super::app::{App, ModeList};
use super::scene::{CurveKind, Scene};

/// The origin of exported curves.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    /// The program and its version, "beamtune 0.1.0".
    pub program: String,
    /// The model's title.
    pub model: String,
    /// The model's file or preset.
    pub source: String,
    /// SHA-256 of the model as TOML text, in hexadecimal digits.
    pub hash: String,
    /// How the curves were solved.
    pub method: String,
    /// Notes and warnings, one line each.
    pub notes: Vec<String>,
}

/// The provenance of the curves on the chart.
pub fn provenance(app: &App) -> Provenance {
    let document = &app.document;
    let mut notes = Vec::new();
    if document.is_changed() {
        notes.push(
            "the model has changes that are not in its file; the hash is of the changed text"
                .to_owned(),
        );
    }
    if app.curves.is_stale() {
        notes.push("the curves are older than the model".to_owned());
    }
    if !app.curves.is_resolved() {
        notes.push("peaks may lie between the frequencies: the curves are not resolved".to_owned());
    }
    let list = app.modes.list.as_ref();
    if let Some(doubt) = list.and_then(ModeList::doubt) {
        notes.push(format!("a peak may be missing: {doubt}"));
    }
    Provenance {
        program: concat!("beamtune ", env!("CARGO_PKG_VERSION")).to_owned(),
        model: document.model().title.clone(),
        source: document.source().name(),
        hash: hexadecimal(&Sha256::digest(document.text())),
        method: "exact: waves of bending, torsion and warping, joined at every station".to_owned(),
        notes,
    }
}

fn hexadecimal(bytes: &[u8]) -> String {
    let digits = bytes.iter().map(|byte| format!("{byte:02x}"));
    digits.collect::<Vec<_>>().concat()
}

/// Unique names of the curves: their labels, or their kind if they have none.
fn names(scene: &Scene) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for curve in &scene.curves {
        let kind = match curve.kind {
            CurveKind::Reference => "reference",
            CurveKind::Model if scene.title.is_empty() => "model",
            CurveKind::Model => &scene.title,
            CurveKind::Fem => "finite elements",
            CurveKind::Measured => "measured",
        };
        let name = if curve.label.is_empty() {
            kind
        } else {
            &curve.label
        };
        let numbered = (2..).map(|number| format!("{name} ({number})"));
        let mut free = std::iter::once(name.to_owned()).chain(numbered);
        names.extend(free.find(|name| !names.contains(name)));
    }
    names
}

/// A frequency in the displayed unit, with six digits and the unit.
fn frequency(scene: &Scene, hertz: f64) -> String {
    let unit = scene.frequency.unit;
    let value = hertz * unit.per_hertz();
    let digits = (5 - value.abs().log10().floor() as i32).clamp(0, 12) as usize;
    let text = format!("{value:.digits$}");
    let short = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    format!("{short} {}", unit.symbol())
}

/// The marks on the frequency axis, in words.
fn marks(scene: &Scene) -> Vec<String> {
    let marked = &scene.marks;
    let mut words = Vec::new();
    words.extend(
        marked
            .cursor
            .map(|f| format!("cursor {}", frequency(scene, f))),
    );
    let second = marked.second.map(|f| frequency(scene, f));
    words.extend(second.map(|f| format!("second cursor {f}")));
    if let Some([low, high]) = marked.band {
        words.push(format!(
            "band {} to {}",
            frequency(scene, low),
            frequency(scene, high)
        ));
    }
    let [low, high] = scene.frequency.bounds;
    let inside = |f: &f64| (low..=high).contains(f);
    let limit = marked.validity.filter(inside);
    words.extend(limit.map(|f| format!("Euler-Bernoulli limit {}", frequency(scene, f))));
    words
}

#[cfg(test)]
mod tests;
