//! Shared parts of the panels that show the beam's motion at the cursor.

use num_complex::Complex64;
use ratatui::Frame;
use ratatui::layout::{Constraint, Rect};
use ratatui::text::Line;
use ratatui::widgets::Paragraph;

use crate::model::{BeamMotion, Model};
use crate::solve::operating::{MassState, Operating};
use crate::tui::app::App;
use crate::tui::plot::{Axis, Chart, Curve, Legend, Level, LineStyle, Scale};
use crate::tui::theme::Theme;
use crate::tui::view::frame;
use crate::tui::view::text::{cut, width};
use crate::unit::Unit;

/// Below this share of the rest (1 m to 1 rad), a motion is not scaled up.
const NEGLIGIBLE: f64 = 1e-6;

/// Above this share of the largest deflection, a deflection counts as equally large.
const ABOUT: f64 = 0.9;

/// The motion of the beam at a moment of its period.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Seen<'a> {
    /// The model of the beam.
    pub(crate) model: &'a Model,
    pub(crate) operating: &'a Operating,
    /// The frequency as text.
    pub(crate) at: &'a str,
    /// The angle of the period from the moment of the largest deflection, rad.
    pub(crate) angle: f64,
    /// Whether it belongs to an older model or another frequency.
    pub(crate) stale: bool,
    pub(crate) theme: Theme,
}

/// The title of a panel, and a note at the right of its rule.
#[derive(Debug, Clone, Default)]
pub(crate) struct Words {
    pub(crate) title: String,
    pub(crate) note: String,
}

/// The largest deflections, zero to peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reach {
    /// The largest w, v, y or z, m.
    pub(crate) translation: f64,
    /// The largest psi or theta, rad.
    pub(crate) rotation: f64,
}

/// Draws the motion at the cursor with `draw`, or says why there is none.
pub(crate) fn draw(
    frame: &mut Frame<'_>,
    app: &App,
    (theme, area): (Theme, Rect),
    name: &str,
    draw: impl Fn(&mut Frame<'_>, Seen<'_>, Rect),
) {
    let reason = match (app.curves.cursor, &app.beam_view.operating) {
        (None, _) => " there is no cursor on the chart",
        (_, None) => app
            .beam_view
            .failure
            .as_deref()
            .unwrap_or(" computing the beam's motion"),
        (_, Some((_, operating))) if !is_finite(operating) => {
            " no finite answer: a resonance without damping"
        }
        (_, Some((model, operating))) => {
            let seen = Seen {
                model,
                operating,
                at: &app.display.frequency_text(operating.frequency),
                angle: app.beam_view.moment.angle(),
                stale: app.operating_is_stale(),
                theme,
            };
            return draw(frame, seen, area);
        }
    };
    let words = Words {
        title: name.to_owned(),
        ..Words::default()
    };
    let inside = panel(frame, &words, theme, area);
    let text = Paragraph::new(reason).style(theme.dim());
    frame.render_widget(text, inside.centered_vertically(Constraint::Length(1)));
}

fn is_finite(operating: &Operating) -> bool {
    let mut along = operating.motion.iter().chain(&operating.forces).flatten();
    along.all(|value| value.is_finite())
}

/// Whether a panel of this width in columns has room for its note.
pub(crate) fn has_room(words: &Words, columns: u16) -> bool {
    // The rule has a sign and a blank on both sides of either.
    width(&words.title) + width(&words.note) + 6 <= usize::from(columns)
}

/// A panel with its title in a rule at the top; returns the area inside.
pub(crate) fn panel(frame: &mut Frame<'_>, words: &Words, theme: Theme, area: Rect) -> Rect {
    let title = cut(&words.title, usize::from(area.width).saturating_sub(4));
    let note = Line::styled(format!(" {} ", words.note), theme.dim());
    let note = Some(note).filter(|_| !words.note.is_empty());
    let rule = frame::rule(&title, theme);
    let block = frame::panel(rule, note.unwrap_or_default(), area.width);
    let block = block.border_style(theme.dim());
    let inside = block.inner(area);
    frame.render_widget(block, area);
    inside
}

/// Adds one legend entry that names the motions of the masses, each marker in its colour.
pub(crate) fn name_masses(points: &mut [Curve<'_>]) {
    if let Some((first, others)) = points.split_first_mut() {
        "masses".clone_into(&mut first.label);
        for other in others {
            other.shares_entry = true;
        }
    }
}

/// Curves over the length of the beam, above its line at rest.
pub(crate) fn chart(
    frame: &mut Frame<'_>,
    seen: Seen<'_>,
    curves: Vec<Curve<'_>>,
    value: Axis,
    area: Rect,
) {
    let length = seen.operating.positions.last().copied().unwrap_or(1.0);
    let (ends, rest) = ([0.0, length], [0.0; 2]);
    let mut all = vec![Curve {
        line: LineStyle::Dotted,
        dim: true,
        ..Curve::new(&ends, &rest)
    }];
    all.extend(curves);
    for curve in &mut all {
        curve.dim |= seen.stale;
    }
    let x = Axis::new(Scale::Linear, ends, Unit::METRE.symbol);
    let mut chart = Chart::new(x, value, Level::Signed, &all);
    chart.legend = Legend::Line;
    chart.styles = seen.theme.chart();
    chart.glyphs = seen.theme.glyphs();
    frame.render_widget(&chart, area);
}

/// The size of a curve, zero to peak.
pub(crate) fn largest<'a>(curve: impl IntoIterator<Item = &'a Complex64>) -> f64 {
    curve.into_iter().map(|u| u.norm()).fold(0.0, f64::max)
}

impl Reach {
    pub(crate) fn of(operating: &Operating) -> Self {
        let beam = |motion: BeamMotion| largest(&operating.motion[motion as usize]);
        let mass = |of: fn(&MassState) -> f64| operating.masses.iter().map(of).fold(0.0, f64::max);
        let masses = mass(|state| state.motion[0].norm().max(state.motion[1].norm()));
        Self {
            translation: beam(BeamMotion::W).max(beam(BeamMotion::V)).max(masses),
            rotation: beam(BeamMotion::Psi).max(mass(|state| state.motion[2].norm())),
        }
    }

    /// The scale: what is drawn as 1, of translations (m) and of rotations (rad). It does not magnify rounding errors.
    pub(crate) fn units(self) -> [f64; 2] {
        let least = f64::MIN_POSITIVE;
        [
            self.translation.max(NEGLIGIBLE * self.rotation).max(least),
            self.rotation.max(NEGLIGIBLE * self.translation).max(least),
        ]
    }
}

impl Seen<'_> {
    /// A curve at the shown moment.
    pub(crate) fn now(self, curve: &[Complex64]) -> Vec<f64> {
        let turn = Complex64::from_polar(1.0, self.phase());
        curve.iter().map(|u| (u * turn).re).collect()
    }

    /// omega t of the shown moment, rad: 0 where a force of phase 0 is largest.
    pub(crate) fn phase(self) -> f64 {
        self.angle + widest(self.operating)
    }

    /// The frequency and the phase as text.
    pub(crate) fn moment(self) -> String {
        // Zero has no sign here.
        let degrees = self.phase().to_degrees().round().rem_euclid(360.0) + 0.0;
        format!("{}, phase {degrees} deg", self.at)
    }
}

/// omega t (rad) at which most of the deflection is largest, with the first place of largest deflection on the positive
/// side.
fn widest(operating: &Operating) -> f64 {
    let units = Reach::of(operating).units();
    let scaled = || {
        let motions = [(BeamMotion::W, 0), (BeamMotion::V, 0), (BeamMotion::Psi, 1)];
        motions.into_iter().flat_map(move |(motion, unit)| {
            let curve = operating.motion[motion as usize].iter();
            curve.map(move |u| u / units[unit])
        })
    };
    // A rotation of all values by an angle rotates the sum of their squares by twice that angle.
    let square: Complex64 = scaled().map(|u| u * u).sum();
    let turn = -0.5 * square.arg();
    let most = scaled().map(Complex64::norm).fold(0.0, f64::max);
    let first = scaled().find(|u| u.norm() > ABOUT * most);
    match first {
        Some(first) if (first * Complex64::from_polar(1.0, turn)).re < 0.0 => {
            turn + std::f64::consts::PI
        }
        _ => turn,
    }
}

#[cfg(test)]
pub(crate) mod stage;
