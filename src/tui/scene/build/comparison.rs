//! The curves that are compared with the model: references, finite elements, measurements.

use super::{Builder, Source, colour, poles, traces};
use crate::tui::panels::comparison::Reference;
use crate::tui::panels::measured::Measured;
use crate::tui::plot::LineStyle;
use crate::tui::scene::{ChartView, CurveKind, SceneCurve, part};
use crate::unit::Dimension;

/// The most points drawn of a measured curve; beyond, every second, third...
const MOST_MEASURED: usize = 20_000;
/// Columns between the points of a finite-element curve.
const FEM_POINTS: u16 = 3;

impl<'a> Builder<'a> {
    /// The tolerance band (nine of ten curves) of the first visible response.
    pub(super) fn tolerances(&self) -> Vec<SceneCurve> {
        let magnitude = matches!(
            self.view(),
            ChartView::Magnitude | ChartView::MagnitudePhase
        );
        let state = self.state.curves;
        let known = self.state.tolerances.curves.as_ref();
        let Some((_, members)) = known.filter(|(generation, _)| {
            magnitude && *generation == state.generation && self.state.tolerances.shown
        }) else {
            return Vec::new();
        };
        let name = state.visible.first().map_or("", String::as_str);
        let mut curves = Vec::new();
        for (index, member) in members.iter().enumerate() {
            let Some(trace) = member.trace(name) else {
                continue;
            };
            let mut curve = self.curve(&Source {
                trace,
                frequencies: &member.frequencies,
                against: None,
            });
            // A quantile of magnitudes has no phase.
            for values in curve.values.iter_mut().skip(1) {
                values.fill(f64::NAN);
            }
            curve.kind = CurveKind::Reference;
            curve.line = if index == 1 {
                LineStyle::Dashed
            } else {
                LineStyle::Dotted
            };
            curve.dim = true;
            if curves.is_empty() {
                "5, 50, 95 %".clone_into(&mut curve.label);
            }
            curves.push(curve);
        }
        curves
    }

    /// The frozen and loaded references.
    pub(super) fn references(&self) -> Vec<SceneCurve> {
        // Differences are relative to the first one.
        if self.view() == ChartView::Difference {
            return Vec::new();
        }
        let shown: Vec<&Reference> = self.state.comparison.shown().collect();
        let mut curves = Vec::new();
        for (index, reference) in shown.iter().enumerate() {
            curves.extend(self.reference(reference, index, shown.len()));
        }
        curves
    }

    /// The number of visible curves of the model: the colours of other curves follow.
    fn model_count(&self) -> usize {
        let members = self.picture.map_or(&[][..], |picture| &picture.members);
        traces(members, self.state.curves).len()
    }

    fn reference(&self, reference: &'a Reference, index: usize, of: usize) -> Vec<SceneCurve> {
        let state = self.state.curves;
        let fine = self
            .detail
            .and_then(|detail| detail.curves.reference(reference.id));
        let picture = reference.picture.as_deref();
        let members = fine.or(picture.map(|picture| &picture.members[..]));
        let mut curves = Vec::new();
        for (place, number, member, trace) in traces(members.unwrap_or_default(), state) {
            let source = Source {
                trace,
                frequencies: &member.frequencies,
                against: None,
            };
            let mut curve = self.curve(&source);
            curve.kind = CurveKind::Reference;
            // A single reference has the colours of the curves it refers to.
            curve.colour = colour(state, place, number) + if of > 1 { index + 1 } else { 0 };
            curve.marker = (of > 1).then_some(self.model_count() + index);
            curve.line = LineStyle::Dotted;
            curve.dim = true;
            if curves.is_empty() {
                curve.label.clone_from(&reference.name);
            }
            let own =
                picture.and_then(|picture| picture.members.get(number)?.trace(&trace.response));
            curve.poles = own.map(poles).unwrap_or_default();
            curves.push(curve);
        }
        curves
    }

    /// The finite-element curves, as points.
    pub(super) fn fem_curves(&self) -> Vec<SceneCurve> {
        let state = self.state.curves;
        let Some(picture) = self.state.fem else {
            return Vec::new();
        };
        let mut curves: Vec<SceneCurve> = Vec::new();
        for (place, name) in state.visible.iter().enumerate() {
            for (number, member) in picture.members.iter().enumerate() {
                for trace in member.traces.iter().filter(|trace| trace.response == *name) {
                    let source = Source {
                        trace,
                        frequencies: &member.frequencies,
                        against: None,
                    };
                    let mut curve = self.curve(&source);
                    curve.kind = CurveKind::Fem;
                    curve.colour = colour(state, place, number);
                    curve.line = LineStyle::Points { apart: FEM_POINTS };
                    curve.dim = picture.generation != state.generation;
                    if curves.is_empty() {
                        "FEM".clone_into(&mut curve.label);
                    }
                    curves.push(curve);
                }
            }
        }
        if self.view() == ChartView::Difference {
            curves.clear();
        }
        curves
    }

    /// The measured curves that match a visible response.
    pub(super) fn measured(&self) -> Vec<SceneCurve> {
        if self.view() == ChartView::Difference {
            return Vec::new();
        }
        let shown = self
            .state
            .comparison
            .measured_shown(self.state.curves, self.state.display)
            .enumerate();
        shown
            .map(|(index, (one, response))| self.measured_curve(one, response.as_ref(), index))
            .collect()
    }

    fn measured_curve(
        &self,
        one: &Measured,
        response: Option<&Dimension>,
        index: usize,
    ) -> SceneCurve {
        let (display, view) = (self.state.display, self.view());
        let energy = one.is_energy(response);
        let places = self.visible_part(&one.curve.frequencies);
        let stride = places.len().div_ceil(MOST_MEASURED).max(1);
        let places: Vec<usize> = places.step_by(stride).collect();
        let mut values = vec![Vec::with_capacity(places.len()); view.panels()];
        // Without a phase, only the magnitude is known.
        let magnitude = matches!(view, ChartView::Magnitude | ChartView::MagnitudePhase);
        let known = match (one.curve.phase_known, magnitude) {
            (true, _) => values.len(),
            (false, true) => 1,
            (false, false) => 0,
        };
        for i in &places {
            let mut parts = part(view, one.value(display, response, *i), energy);
            parts[known..].fill(f64::NAN);
            for (all, one) in values.iter_mut().zip(parts) {
                all.push(one);
            }
        }
        SceneCurve {
            label: one.name.clone(),
            kind: CurveKind::Measured,
            colour: self.model_count() + index,
            marker: None,
            line: LineStyle::Points { apart: 1 },
            dim: false,
            frequencies: places
                .into_iter()
                .map(|i| one.curve.frequencies[i])
                .collect(),
            values: self.unwrapped(values),
            poles: Vec::new(),
            at_cursor: None,
        }
    }
}
