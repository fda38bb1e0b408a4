//! How curves are told apart on paper: by colour, by dashes and by markers.

use std::fmt::Write as _;

use super::frame::Field;
use super::line::Run;
use super::page::{Page, px};
use crate::tui::plot::{LineStyle, clipped};
use crate::tui::scene::{CurveKind, Scene, SceneCurve};

/// Colours with a contrast of 4 and more on white, those first that the common eye and those without one kind of cones
/// tell apart best (after Okabe and Ito, Color Universal Design, 2008, darkened).
const COLOURS: [&str; 8] = [
    "#0072b2", "#b8460e", "#00795a", "#9a3b85", "#000000", "#7a5c00", "#5a4fcf", "#a61c3c",
];
/// Dashes of the curves of the model, in their order.
const DASHES: [&str; 6] = ["", "9 4", "9 3 2 3", "5 3", "14 4", "9 3 2 3 2 3"];
/// Markers, drawn about 0 with a reach of 4 px.
const SHAPES: [&str; 8] = [
    "m-3.5 -3.5h7v7h-7z",
    "m0 -4.5l4 7h-8z",
    "m0 -4.5l4.5 4.5l-4.5 4.5l-4.5 -4.5z",
    "m-3.5 -3.5l7 7m0 -7l-7 7",
    "m0 -4.5v9m-4.5 -4.5h9",
    "m0 4.5l4 -7h-8z",
    "m-4 0h8m-6 -3.5l4 7m0 -7l-4 7",
    "m-3.5 -3.5h7l-7 7h7z",
];
/// What finite elements are marked with.
const POINT: &str = "m-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0z";
/// A letter of the terminal, px: markers are as many letters apart.
const LETTER: f64 = 8.0;
/// Markers along a line.
const MARKERS: usize = 6;
/// A measured curve with more points than this is a line.
const SPARSE: usize = 200;
/// Px of a legend's sample, of a row, of a letter of its text and between its entries.
const SAMPLE: f64 = 34.0;
const ROW: f64 = 17.0;
const TEXT: f64 = 6.6;
const SPACE: f64 = 20.0;

/// How a curve looks.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Look {
    colour: &'static str,
    width: f64,
    /// The dashes of its line; none where it has no line.
    dashes: Option<&'static str>,
    shape: Option<&'static str>,
    /// Px between markers at its points; none where a few stand on a line.
    apart: Option<f64>,
    /// Which of the curves it is, and of how many: markers are staggered.
    turn: [usize; 2],
    /// Whether it is named.
    named: bool,
}

/// How the curves of a scene look. Those of the model have the colours and markers of the screen; every reference and
/// every measured curve has a colour and a marker that no curve before it has together, and, as long as there are any,
/// that none has.
pub(super) fn looks(scene: &Scene) -> Vec<Look> {
    let mut signs: Vec<Sign> = scene.curves.iter().map(Sign::of).collect();
    let is_model = |index: &usize| scene.curves[*index].kind == CurveKind::Model;
    let mut used: Vec<Sign> = (0..signs.len())
        .filter(is_model)
        .map(|index| signs[index])
        .collect();
    let mut last = None;
    for (index, curve) in scene.curves.iter().enumerate() {
        if !matches!(curve.kind, CurveKind::Reference | CurveKind::Measured) {
            continue;
        }
        // The members of a reference without a name of their own look as the one that has it.
        let sign = match last.filter(|_| curve.label.is_empty()) {
            Some(sign) => sign,
            None => Sign::free(&used, signs[index].shape.is_some()),
        };
        used.push(sign);
        signs[index] = sign;
        last = Some(sign);
    }
    let looks = signs.into_iter().enumerate();
    looks
        .map(|(index, sign)| Look::new(scene, index, sign))
        .collect()
}

/// The colour and the marker of a curve, by their numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sign {
    colour: usize,
    shape: Option<usize>,
}

impl Sign {
    /// As the screen has them; measured curves have markers.
    fn of(curve: &SceneCurve) -> Self {
        let measured = curve.kind == CurveKind::Measured;
        let marker = curve.marker.or(measured.then_some(0));
        Self {
            colour: curve.colour % COLOURS.len(),
            shape: marker.map(|number| number % SHAPES.len()),
        }
    }

    /// The least used colour and, where it is wanted, the least used marker that no other curve has together.
    fn free(used: &[Self], marked: bool) -> Self {
        let colours = least_used(COLOURS.len(), |colour| {
            used.iter().filter(|one| one.colour == colour).count()
        });
        let shapes = least_used(SHAPES.len(), |shape| {
            used.iter().filter(|one| one.shape == Some(shape)).count()
        });
        let pairs = colours.iter().flat_map(|colour| {
            shapes.iter().map(|shape| Self {
                colour: *colour,
                shape: marked.then_some(*shape),
            })
        });
        let mut free = pairs.filter(|pair| !used.contains(pair));
        free.next().unwrap_or(Self {
            colour: colours[0],
            shape: Some(shapes[0]),
        })
    }
}

/// Numbers below `count`, those used least first.
fn least_used(count: usize, uses: impl Fn(usize) -> usize) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..count).collect();
    numbers.sort_by_key(|number| uses(*number));
    numbers
}

impl Look {
    fn new(scene: &Scene, index: usize, sign: Sign) -> Self {
        let curve = &scene.curves[index];
        let shape = sign.shape.map(|number| SHAPES[number]);
        let model = DASHES[curve.marker.unwrap_or(0) % DASHES.len()];
        let dashes = match curve.line {
            LineStyle::Solid => Some(model),
            LineStyle::Dashed => Some(DASHES[1]),
            LineStyle::Dotted => Some("1.5 3.5"),
            LineStyle::Points { .. } => None,
        };
        let apart = match curve.line {
            LineStyle::Points { apart } => Some(f64::from(apart) * LETTER),
            _ => None,
        };
        let look = Self {
            colour: COLOURS[sign.colour],
            width: 1.6,
            dashes,
            shape,
            apart,
            turn: [index, scene.curves.len()],
            named: !curve.label.is_empty(),
        };
        match curve.kind {
            CurveKind::Model => look,
            CurveKind::Reference => Self { width: 1.2, ..look },
            CurveKind::Witness => Self {
                shape: Some(POINT),
                ..look
            },
            CurveKind::Measured => Self {
                dashes: (curve.frequencies.len() > SPARSE).then_some("6 2"),
                apart: (curve.frequencies.len() <= SPARSE).then_some(0.0),
                width: 1.2,
                ..look
            },
        }
    }

    fn attributes(&self) -> String {
        let dashes = match self.dashes {
            None | Some("") => String::new(),
            Some(dashes) => format!(" stroke-dasharray=\"{dashes}\""),
        };
        format!(
            "fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dashes}",
            self.colour,
            px(self.width)
        )
    }

    /// The style of markers: a white ground within.
    fn hollow(&self) -> String {
        format!(
            "fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.2\"",
            self.colour
        )
    }

    /// Draws the line of a curve, and where it goes at its poles.
    pub(super) fn draw_line(&self, page: &mut Page, field: &Field, run: &Run) {
        let data = data(field, run);
        if self.dashes.is_some() && !data.is_empty() {
            page.path(&data, &self.attributes());
        }
        for [x, y] in &run.poles {
            page.line([*x, *y], [*x, field.top], &self.attributes());
            let arrow = format!("M{} {}l-4 8h8z", px(*x), px(field.top));
            page.path(&arrow, &format!("fill=\"{}\"", self.colour));
        }
    }

    /// Draws the markers of a curve.
    pub(super) fn draw_markers(&self, page: &mut Page, field: &Field, run: &Run) {
        let Some(shape) = self.shape else { return };
        let mut signs = String::new();
        for [x, y] in self.markers(field, run) {
            let _ = write!(signs, "M{} {}{shape}", px(x), px(y));
        }
        if !signs.is_empty() {
            page.path(&signs, &self.hollow());
        }
    }

    /// Where its markers are.
    fn markers(&self, field: &Field, run: &Run) -> Vec<[f64; 2]> {
        if let Some(apart) = self.apart {
            let mut kept: Vec<[f64; 2]> = Vec::new();
            for [x, y] in &run.samples {
                let last = kept.last();
                if last.is_none_or(|last| (last[0] - x).hypot(last[1] - y) >= apart) {
                    kept.push([*x, *y]);
                }
            }
            return kept;
        }
        let [turn, turns] = self.turn;
        let share = (turn as f64 + 0.5) / turns as f64;
        let aims =
            (0..MARKERS).map(|k| field.left + field.width * (k as f64 + share) / MARKERS as f64);
        let nearest = |aim: f64| {
            let distance = |point: &&[f64; 2]| (point[0] - aim).abs();
            let points = run.samples.iter();
            points
                .min_by(|a, b| distance(a).total_cmp(&distance(b)))
                .copied()
        };
        aims.filter_map(nearest).collect()
    }
}

/// The path of a curve, within its plot and a little beyond.
fn data(field: &Field, run: &Run) -> String {
    let beyond = 4.0;
    let within = [
        [field.left - beyond, field.left + field.width + beyond],
        [field.top - beyond, field.top + field.height + beyond],
    ];
    let mut data = String::new();
    for part in &run.parts {
        let mut last = None;
        for ends in part.windows(2) {
            let Some([from, to]) = clipped(ends[0], ends[1], within) else {
                continue;
            };
            if last != Some(from) {
                let _ = write!(data, "M{} {}", px(from[0]), px(from[1]));
            }
            let _ = write!(data, "L{} {}", px(to[0]), px(to[1]));
            last = Some(to);
        }
        if let [[x, y]] = part.as_slice() {
            let _ = write!(data, "M{} {}h0.01", px(*x), px(*y));
        }
    }
    data
}

/// Names the curves in rows from `left` to `right`; where the rows end.
pub(super) fn legend(
    page: &mut Page,
    looks: &[Look],
    names: &[String],
    [left, top, right]: [f64; 3],
) -> f64 {
    let named = looks.iter().zip(names).filter(|(look, _)| look.named);
    let (mut x, mut y) = (left, top);
    let mut rows = 0;
    for (look, name) in named {
        let width = SAMPLE + 6.0 + TEXT * name.chars().count() as f64;
        if x > left && x + width > right {
            (x, y) = (left, y + ROW);
        }
        if look.dashes.is_some() {
            page.line([x, y - 4.0], [x + SAMPLE, y - 4.0], &look.attributes());
        }
        if let Some(shape) = look.shape {
            let sign = format!("M{} {}{shape}", px(x + SAMPLE / 2.0), px(y - 4.0));
            page.path(&sign, &look.hollow());
        }
        page.text([x + SAMPLE + 6.0, y], name, "class=\"name\"");
        x += width + SPACE;
        rows = 1;
    }
    if rows == 0 { top - ROW } else { y }
}
