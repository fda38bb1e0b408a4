//! The curves as CSV.

use std::fmt::Write as _;

use super::{Provenance, frequency, marks, names};
use crate::escape::escape;
use crate::table::{cell, number};
use crate::tui::plot::Level;
use crate::tui::scene::axes::heading;
use crate::tui::scene::{ChartView, Scene};

/// The curves on the chart as CSV (RFC 4180, lines end with a line feed), after comment lines that start with `#`.
///
/// Long format: one row per point within the frequency bounds, with the curve's name, the frequency in the displayed
/// unit, and the value on each panel, in decibels if the panel shows them. Numbers parse back exactly; `nan` is a gap.
pub fn csv(scene: &Scene, provenance: &Provenance) -> String {
    let names = names(scene);
    let mut text = head(scene, provenance, &names);
    let columns: Vec<&str> = (0..scene.panels.len()).map(|i| column(scene, i)).collect();
    let abscissa = scene.frequency.unit.column();
    let mut titles = vec!["curve", &abscissa];
    titles.extend(columns);
    // Writing to a string has no errors.
    let _ = writeln!(text, "{}", titles.join(","));
    let per_hertz = scene.frequency.unit.per_hertz();
    let [low, high] = scene.frequency.bounds;
    for (curve, name) in scene.curves.iter().zip(&names) {
        let name = cell(name);
        for (index, hertz) in curve.frequencies.iter().enumerate() {
            if !(low..=high).contains(hertz) {
                continue;
            }
            let _ = write!(text, "{name},{}", number(hertz * per_hertz));
            for (panel, shown) in scene.panels.iter().enumerate() {
                let values = curve.values.get(panel);
                let value = values.and_then(|values| values.get(index));
                let value = value.map_or(f64::NAN, |value| shown.level.value(*value));
                let _ = write!(text, ",{}", number(value));
            }
            text.push('\n');
        }
    }
    text
}

/// The comment lines: quantities, units and provenance.
fn head(scene: &Scene, provenance: &Provenance, names: &[String]) -> String {
    let mut lines = vec![
        provenance.program.clone(),
        format!("model: {}", provenance.model),
        format!("source: {}", provenance.source),
        format!("sha256 of the model as TOML: {}", provenance.hash),
        format!("method: {}", provenance.method),
    ];
    lines.extend(provenance.notes.iter().cloned());
    lines.push(format!("chart: {}, {}", scene.title, scene.view.name()));
    lines.push("amplitudes are zero to peak; nan is a gap".to_owned());
    lines.push(format!(
        "{}: {}",
        scene.frequency.unit.column(),
        scene.frequency.unit.symbol()
    ));
    for (index, panel) in scene.panels.iter().enumerate() {
        lines.push(format!("{}: {}", column(scene, index), heading(panel)));
    }
    lines.extend(marks(scene));
    for (curve, name) in scene.curves.iter().zip(names) {
        if !curve.poles.is_empty() {
            let poles = curve.poles.iter().map(|pole| frequency(scene, *pole));
            let poles: Vec<String> = poles.collect();
            lines.push(format!("{name} is infinite at {}", poles.join(", ")));
        }
    }
    let comment = |line: &String| format!("# {}\n", escape(&line.replace(['\n', '\r'], " ")));
    lines.iter().map(comment).collect()
}

/// The title of a panel's column.
fn column(scene: &Scene, panel: usize) -> &'static str {
    match (scene.view, scene.panels[panel].level, panel) {
        (ChartView::Difference, ..) => "difference_db",
        (_, Level::Magnitude, _) => "magnitude",
        (_, Level::Decibel { .. }, _) => "level_db",
        (_, Level::Degrees, _) => "phase_deg",
        (_, Level::Signed, 0) => "real",
        (_, Level::Signed, _) => "imaginary",
    }
}
