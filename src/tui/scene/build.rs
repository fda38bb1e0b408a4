//! Builds the scene from what the chart shows.

mod comparison;

use super::{
    ChartView, CurveKind, FrequencyAxis, Marked, Panel, Scale, Scene, SceneCurve, difference, part,
};
use crate::model::Model;
use crate::solve::euler_bernoulli_up_to;
use crate::tui::panels::chart::{
    Curves, Detail, DetailPicture, Display, MOTION, Member, Picture, Trace,
};
use crate::tui::panels::comparison::Comparison;
use crate::tui::panels::fem_overlay::FemPicture;
use crate::tui::panels::modes::ModeList;
use crate::tui::panels::readings::Reading;
use crate::tui::panels::tuning::Tolerances;
use crate::tui::plot::{Level, LineStyle};
use crate::unit::Dimension;

/// The state of the designer that the chart shows.
#[derive(Debug, Clone, Copy)]
pub struct ChartState<'a> {
    /// The model.
    pub model: &'a Model,
    /// Its curves.
    pub curves: &'a Curves,
    /// The visible band, solved with a fine grid.
    pub detail: &'a Detail,
    /// How values are shown.
    pub display: &'a Display,
    /// The values at the cursors.
    pub reading: &'a Reading,
    /// References and measured curves.
    pub comparison: &'a Comparison,
    /// The finite-element curves, if any.
    pub fem: Option<&'a FemPicture>,
    /// The effect of tolerances on the curves.
    pub tolerances: &'a Tolerances,
    /// The modes, if they are solved.
    pub modes: Option<&'a ModeList>,
    /// The index of the selected mode, if it is marked.
    pub mode: Option<usize>,
}

/// Builds the content of the chart.
pub fn of(state: ChartState<'_>) -> Scene {
    let builder = Builder::new(state);
    let panels = builder.panels();
    let mut curves = builder.tolerances();
    curves.extend(builder.references());
    curves.extend(builder.model());
    curves.extend(builder.fem_curves());
    curves.extend(builder.measured());
    // The title names a single curve.
    if let [only] = curves.as_mut_slice()
        && only.kind == CurveKind::Model
    {
        only.label.clear();
    }
    Scene {
        view: state.display.view,
        title: builder.title(),
        frequency: FrequencyAxis {
            unit: state.display.unit,
            log: state.curves.log_frequency,
            bounds: builder.shown_frequencies(),
        },
        panels,
        curves,
        spanning: builder.spanning(),
        marks: builder.marks(),
    }
}

struct Builder<'a> {
    state: ChartState<'a>,
    /// The curves of the model, if there are any.
    picture: Option<&'a Picture>,
    /// The visible band, solved with a fine grid, if it belongs to the picture.
    detail: Option<&'a DetailPicture>,
}

/// A curve of a member before it is drawn.
struct Source<'a> {
    trace: &'a Trace,
    /// Hz.
    frequencies: &'a [f64],
    /// The reference of the same response and member, for differences.
    against: Option<&'a Trace>,
}

impl<'a> Builder<'a> {
    fn new(state: ChartState<'a>) -> Self {
        let picture = state.curves.picture().map(|picture| &**picture);
        let window = state.curves.shown_frequencies(&state.model.sweep);
        let detail = picture.and_then(|picture| state.detail.of(picture.generation, window));
        Self {
            state,
            picture,
            detail,
        }
    }

    fn shown_frequencies(&self) -> [f64; 2] {
        self.state.curves.shown_frequencies(&self.state.model.sweep)
    }

    fn view(&self) -> ChartView {
        self.state.display.view
    }

    fn title(&self) -> String {
        let ChartState {
            curves, display, ..
        } = self.state;
        let what = match curves.visible.as_slice() {
            [] => String::new(),
            [one] => one.clone(),
            more => format!("{} responses", more.len()),
        };
        let form = display.form.and_then(|form| {
            let mut dimensions = curves.shown_traces().filter_map(|trace| trace.dimension);
            dimensions.find_map(|dimension| dimension.name(form))
        });
        let what = match form {
            Some(form) => format!("{what}, {form}"),
            None if curves.shown_traces().any(|trace| trace.force.is_some()) && display.motion => {
                format!("{what}, {MOTION}")
            }
            None => what,
        };
        let what = match self.state.comparison.first_shown() {
            Some(reference) if self.view() == ChartView::Difference => {
                format!("{what} against {}", reference.name)
            }
            _ => what,
        };
        let study = curves.study;
        match study.and_then(|study| self.state.model.studies.get(study)) {
            Some(study) => format!("{what}: {}", study.name),
            None => what,
        }
    }

    /// The value axes.
    fn panels(&self) -> Vec<Panel> {
        let ChartState {
            curves, display, ..
        } = self.state;
        let unit = display.shown_units(curves).join(", ");
        let panel = |name, unit: String, level| Panel {
            name,
            unit,
            level,
            bounds: None,
        };
        let Scale {
            level,
            unit: magnitude,
        } = display.scale(curves);
        let size = || panel(self.magnitude_name(), magnitude.clone(), level);
        let mut panels = match self.view() {
            ChartView::Magnitude => vec![size()],
            ChartView::MagnitudePhase => {
                vec![size(), panel("phase", "deg".to_owned(), Level::Degrees)]
            }
            ChartView::RealImaginary | ChartView::Nyquist => vec![
                panel("Re, 0-peak", unit.clone(), Level::Signed),
                panel("Im, 0-peak", unit, Level::Signed),
            ],
            ChartView::Difference => vec![panel(
                "level against the reference",
                "dB".to_owned(),
                Level::Signed,
            )],
        };
        if let (Some(first), Some(levels)) = (panels.first_mut(), display.levels) {
            first.bounds = Some(levels);
        }
        panels
    }

    /// The name of a magnitude: a ratio only if there is one force to divide by.
    fn magnitude_name(&self) -> &'static str {
        let ChartState {
            curves, display, ..
        } = self.state;
        let mut dimensions = curves
            .shown_traces()
            .map(|trace| display.dimension_of(trace));
        match dimensions.next() {
            Some(None) => "vibration energy",
            Some(Some(Dimension { per: None, .. })) => "amplitude, 0-peak",
            _ => "|H|, 0-peak",
        }
    }

    /// The curves of the model and of its study's members.
    fn model(&self) -> Vec<SceneCurve> {
        let state = self.state.curves;
        let Some(picture) = self.picture else {
            return Vec::new();
        };
        let shown = traces(&picture.members, state);
        let several = shown.len() > 1;
        let mut curves = Vec::new();
        for (index, (place, number, member, trace)) in shown.into_iter().enumerate() {
            let fine = self.detail.and_then(|detail| {
                let member = detail.curves.members.get(number)?;
                Some((member, member.trace(&trace.response)?))
            });
            let (from, values) = fine.unwrap_or((member, trace));
            let source = Source {
                trace: values,
                frequencies: &from.frequencies,
                against: self.against(number, &trace.response),
            };
            let mut curve = self.curve(&source);
            curve.label = label(state, trace, member);
            curve.colour = colour(state, place, number);
            curve.marker = several.then_some(index);
            curve.dim = state.is_stale();
            curve.poles = poles(trace);
            let generation = picture.generation;
            let cursor = state
                .cursor
                .filter(|_| self.view() != ChartView::Difference);
            curve.at_cursor = cursor.and_then(|cursor| {
                let reading = self.state.reading;
                let read = reading.model(generation, number, &trace.response, cursor)?;
                Some(self.parts(trace, read.value(), cursor))
            });
            curves.push(curve);
        }
        curves
    }

    /// The response of the reference for a member's difference: of the corresponding member, or the only one.
    fn against(&self, member: usize, response: &str) -> Option<&'a Trace> {
        let reference = self.state.comparison.first_shown()?;
        let members = self.detail?.curves.reference(reference.id)?;
        let member = members.get(member).or(members.first())?;
        member.trace(response)
    }

    /// Curves that extend the value axis: the previous resolved curves predict the range of the next ones, so that the
    /// axis does not move while a parameter changes.
    fn spanning(&self) -> Vec<SceneCurve> {
        let state = self.state.curves;
        let (false, Some(resolved)) = (state.is_resolved(), &state.resolved) else {
            return Vec::new();
        };
        if self.view() == ChartView::Difference {
            return Vec::new();
        }
        let shown = traces(&resolved.members, state).into_iter();
        shown
            .map(|(.., member, trace)| SceneCurve {
                poles: poles(trace),
                ..self.curve(&Source {
                    trace,
                    frequencies: &member.frequencies,
                    against: None,
                })
            })
            .collect()
    }

    fn marks(&self) -> Marked {
        let state = self.state;
        let cursor = state.curves.cursor;
        let list = state.modes;
        Marked {
            cursor,
            second: state.reading.second,
            harmonics: state.reading.harmonics(cursor, state.model.sweep.to),
            band: state.curves.band,
            validity: euler_bernoulli_up_to(state.model),
            modes: list.map_or_else(Vec::new, |list| {
                list.rows.iter().map(|mode| mode.frequency).collect()
            }),
            mode: state.mode,
            modes_dim: list.is_some_and(|list| list.generation != state.curves.generation),
        }
    }

    /// A curve in the view: the visible frequencies and one more on each side.
    fn curve(&self, source: &Source<'_>) -> SceneCurve {
        let places = self.visible_part(source.frequencies);
        let view = self.view();
        let mut values = vec![Vec::with_capacity(places.len()); view.panels()];
        for i in places.clone() {
            let (value, frequency) = (source.trace.values[i], source.frequencies[i]);
            let display = self.state.display;
            let parts = match source.against {
                _ if view != ChartView::Difference => self.parts(source.trace, value, frequency),
                Some(against) => {
                    let value = display.per_force(source.trace, value);
                    let other = display.per_force(against, against.values[i]);
                    vec![difference(source.trace.dimension.is_none(), value, other)]
                }
                None => vec![f64::NAN],
            };
            for (all, one) in values.iter_mut().zip(parts) {
                all.push(one);
            }
        }
        SceneCurve {
            label: String::new(),
            kind: CurveKind::Model,
            colour: 0,
            marker: None,
            line: LineStyle::Solid,
            dim: false,
            frequencies: source.frequencies[places].to_vec(),
            values: self.unwrapped(values),
            poles: Vec::new(),
            at_cursor: None,
        }
    }

    /// The value in each panel.
    fn parts(&self, trace: &Trace, value: num_complex::Complex64, frequency: f64) -> Vec<f64> {
        let shown = self.state.display.value(trace, value, frequency);
        part(self.view(), shown, trace.dimension.is_none())
    }

    /// Unwraps the phase, if the display asks for it.
    fn unwrapped(&self, mut values: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        if self.state.display.unwrapped
            && self.view() == ChartView::MagnitudePhase
            && let Some(phase) = values.get_mut(1)
        {
            super::unwrap(phase);
        }
        values
    }

    /// The indices of the visible frequencies, and one more on each side.
    fn visible_part(&self, frequencies: &[f64]) -> std::ops::Range<usize> {
        let [low, high] = self.shown_frequencies();
        let from = frequencies.partition_point(|f| *f < low);
        let to = frequencies.partition_point(|f| *f <= high);
        from.saturating_sub(1)..(to + 1).min(frequencies.len()).max(from.saturating_sub(1))
    }
}

/// Frequencies (Hz) at which a curve is infinite.
fn poles(trace: &Trace) -> Vec<f64> {
    let poles = trace.peaks.iter().filter(|peak| peak.pole);
    poles.map(|peak| peak.frequency).collect()
}

/// The visible traces, with their index and that of their member.
fn traces<'a>(
    members: &'a [Member],
    curves: &Curves,
) -> Vec<(usize, usize, &'a Member, &'a Trace)> {
    let mut found = Vec::new();
    for (place, name) in curves.visible.iter().enumerate() {
        for (number, member) in members.iter().enumerate() {
            found.extend(
                member
                    .trace(name)
                    .map(|trace| (place, number, member, trace)),
            );
        }
    }
    found
}

/// Each response has a colour; if only one is visible, each member of the study has.
fn colour(state: &Curves, place: usize, member: usize) -> usize {
    if state.visible.len() > 1 {
        place
    } else {
        member
    }
}

/// A curve's name in the legend.
pub fn label(state: &Curves, trace: &Trace, member: &Member) -> String {
    let name = match &member.label {
        None => trace.response.clone(),
        Some(label) if state.visible.len() == 1 => label.clone(),
        Some(label) => format!("{} {label}", trace.response),
    };
    // A logarithmic axis cannot show it.
    if trace.values.iter().all(|value| value.norm_sqr() == 0.0) {
        format!("{name} (zero)")
    } else {
        name
    }
}
