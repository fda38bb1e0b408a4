//! How the beam and its masses move at the cursor's frequency.

use ratatui::Frame;
use ratatui::layout::Rect;

use crate::model::BeamMotion;
use crate::tui::app::App;
use crate::tui::panels::beam_view::animated::{self, Reach, Seen, Words};
use crate::tui::plot::{Axis, Curve, LineStyle, Scale};
use crate::tui::theme::Theme;
use crate::tui::view::text::significant;

/// The beam's motions in drawing order; the masses' motions on the same scales have these letters.
const MOTIONS: [(BeamMotion, &str, char); 3] = [
    (BeamMotion::W, "w", 'y'),
    (BeamMotion::V, "v", 'z'),
    (BeamMotion::Psi, "psi", 't'),
];

/// Smaller motions than this are not drawn.
const UNSEEN: f64 = 1e-4;

/// The value axis: a little more than from -1 to 1.
const REACH: f64 = 1.1;

pub(crate) fn draw(frame: &mut Frame<'_>, app: &App, theme: Theme, area: Rect) {
    animated::draw(frame, app, (theme, area), "Deflection", deflection);
}

/// The deflection at a moment: the beam as lines, its masses as letters joined by springs.
fn deflection(frame: &mut Frame<'_>, seen: Seen<'_>, area: Rect) {
    let reach = Reach::of(seen.operating);
    let words = Words {
        title: format!("Deflection at {}", seen.moment()),
        note: scale(reach),
    };
    let inside = animated::panel(frame, &words, seen.theme, area);
    let motions = [0, 1, 2].map(|row| Motion::new(seen, reach, row));
    let mut curves = Vec::new();
    for motion in motions.iter().filter(|motion| motion.masses_seen) {
        curves.extend(motion.springs(seen.theme));
    }
    for motion in motions.iter().filter(|motion| motion.beam_seen) {
        curves.push(motion.line(seen));
    }
    // Points are drawn over lines, and listed after them in the legend.
    let mut points: Vec<Curve<'_>> = motions
        .iter()
        .filter(|motion| motion.masses_seen)
        .map(|motion| motion.points(seen.theme))
        .collect();
    animated::name_masses(&mut points);
    curves.extend(points);
    // The scale is always shown: above the axis if the rule has no room for it.
    let unit = if animated::has_room(&words, area.width) {
        ""
    } else {
        &words.note
    };
    let value = Axis::new(Scale::Linear, [-REACH, REACH], unit);
    animated::chart(frame, seen, curves, value, inside);
}

/// The scale as text: what is drawn as 1.
fn scale(reach: Reach) -> String {
    let [translation, rotation] = reach.units().map(|unit| significant(unit, 3));
    match reach {
        Reach {
            translation: 0.0,
            rotation: 0.0,
        } => "nothing moves".to_owned(),
        Reach { rotation: 0.0, .. } => format!("1 is {translation} m"),
        Reach {
            translation: 0.0, ..
        } => format!("1 is {rotation} rad"),
        _ => format!("1 is {translation} m, of psi {rotation} rad"),
    }
}

/// One motion of the beam with that of the masses, at the shown moment.
struct Motion {
    /// Index into [`MOTIONS`].
    number: usize,
    places: Vec<f64>,
    beam_seen: bool,
    masses_seen: bool,
    beam: Vec<f64>,
    masses: Vec<f64>,
    /// For each mass its position twice, with the motion of the beam there and of the mass.
    joints: Vec<([f64; 2], [f64; 2])>,
}

impl Motion {
    fn new(seen: Seen<'_>, reach: Reach, number: usize) -> Self {
        let (motion, ..) = MOTIONS[number];
        let unit = reach.units()[usize::from(motion == BeamMotion::Psi)];
        let scaled = |value: Vec<f64>| -> Vec<f64> { value.iter().map(|u| u / unit).collect() };
        let column = &seen.operating.motion[motion as usize];
        // Of a mass (y, z, theta), of the beam at it (w, psi, v).
        let (of_mass, of_beam) = (number, [0, 2, 1][number]);
        let states = &seen.operating.masses;
        let moved: Vec<_> = states.iter().map(|state| state.motion[of_mass]).collect();
        let mounts: Vec<_> = states.iter().map(|state| state.mount[of_beam]).collect();
        let places: Vec<f64> = states.iter().map(|state| state.position).collect();
        let (masses, mounts) = (scaled(seen.now(&moved)), scaled(seen.now(&mounts)));
        let ends = mounts
            .iter()
            .zip(&masses)
            .map(|(beam, mass)| [*beam, *mass]);
        Self {
            number,
            beam_seen: animated::largest(column) > UNSEEN * unit,
            masses_seen: animated::largest(&moved) > UNSEEN * unit,
            beam: scaled(seen.now(column)),
            joints: places.iter().map(|x| [*x; 2]).zip(ends).collect(),
            masses,
            places,
        }
    }

    fn line<'a>(&'a self, seen: Seen<'a>) -> Curve<'a> {
        Curve {
            label: MOTIONS[self.number].1.to_owned(),
            line: [LineStyle::Solid, LineStyle::Dashed, LineStyle::Dotted][self.number],
            style: seen.theme.curve(self.number),
            ..Curve::new(&seen.operating.positions, &self.beam)
        }
    }

    fn points(&self, theme: Theme) -> Curve<'_> {
        Curve {
            marker: Some(MOTIONS[self.number].2),
            line: LineStyle::Points { apart: 0 },
            style: theme.curve(self.number),
            ..Curve::new(&self.places, &self.masses)
        }
    }

    /// The springs from the beam to each mass.
    fn springs(&self, theme: Theme) -> impl Iterator<Item = Curve<'_>> {
        self.joints.iter().map(move |(x, ends)| Curve {
            line: LineStyle::Dotted,
            style: theme.curve(self.number),
            ..Curve::new(x, ends)
        })
    }
}

#[cfg(test)]
mod tests;
