//! The styles that distinguish curves on paper: colour, dashes and markers.

use std::fmt::Write as _;

use super::frame::PlotFrame;
use super::page::{Page, px};
use super::path::CurvePath;
use crate::tui::plot::{LineStyle, clipped};
use crate::tui::scene::{CurveKind, Scene, SceneCurve};

/// Colours with a contrast of at least 4 on white, ordered so that normal and colour-blind vision distinguish the first
/// ones best (after Okabe and Ito, Color Universal Design, 2008, darkened).
const COLOURS: [&str; 8] = [
    "#0072b2", "#b8460e", "#00795a", "#9a3b85", "#000000", "#7a5c00", "#5a4fcf", "#a61c3c",
];
/// Dashes of the model's curves, in order.
const DASHES: [&str; 6] = ["", "9 4", "9 3 2 3", "5 3", "14 4", "9 3 2 3 2 3"];
/// Marker shapes, centred at 0, about 4 px in each direction.
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
/// The marker of finite-element points.
const POINT: &str = "m-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0z";
/// Width of a terminal column, px, for marker distances given in columns.
const LETTER: f64 = 8.0;
/// Markers along a line.
const MARKERS: usize = 6;
/// A measured curve with more points than this is drawn as a line.
const SPARSE: usize = 200;
/// Legend sizes, px: line sample, row height, letter width, space between entries.
const SAMPLE: f64 = 34.0;
const ROW: f64 = 17.0;
const TEXT: f64 = 6.6;
const SPACE: f64 = 20.0;

/// The style of a curve.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CurveStyle {
    colour: &'static str,
    width: f64,
    /// The dashes of its line; none without a line.
    dashes: Option<&'static str>,
    shape: Option<&'static str>,
    /// Px between markers at its points; none for a few markers along the line.
    apart: Option<f64>,
    /// Index and count of the curves, to stagger the markers.
    turn: [usize; 2],
    /// Whether it has a legend entry.
    named: bool,
}

/// The styles of the curves of a scene. Model curves have the colours and markers of the screen. References and measured
/// curves have a combination of colour and marker that no earlier curve has, and, while available, an unused colour and
/// marker.
pub(super) fn styles(scene: &Scene) -> Vec<CurveStyle> {
    let mut markers: Vec<ColourMarker> = scene.curves.iter().map(ColourMarker::of).collect();
    let is_model = |index: &usize| scene.curves[*index].kind == CurveKind::Model;
    let mut used: Vec<ColourMarker> = (0..markers.len())
        .filter(is_model)
        .map(|index| markers[index])
        .collect();
    let mut last = None;
    for (index, curve) in scene.curves.iter().enumerate() {
        if !matches!(curve.kind, CurveKind::Reference | CurveKind::Measured) {
            continue;
        }
        // Curves of a reference without a name share the style of its named curve.
        let marker = match last.filter(|_| curve.label.is_empty()) {
            Some(marker) => marker,
            None => ColourMarker::free(&used, markers[index].shape.is_some()),
        };
        used.push(marker);
        markers[index] = marker;
        last = Some(marker);
    }
    let styles = markers.into_iter().enumerate();
    styles
        .map(|(index, marker)| CurveStyle::new(scene, index, marker))
        .collect()
}

/// Indices of the colour and of the marker shape of a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
struct ColourMarker {
    colour: usize,
    shape: Option<usize>,
}

impl ColourMarker {
    /// The indices on the screen; measured curves always have a marker.
    fn of(curve: &SceneCurve) -> Self {
        let measured = curve.kind == CurveKind::Measured;
        let marker = curve.marker.or(measured.then_some(0));
        Self {
            colour: curve.colour % COLOURS.len(),
            shape: marker.map(|number| number % SHAPES.len()),
        }
    }

    /// The least used combination of colour and, if `marked`, marker that no other curve has.
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

/// Indices below `count`, least used first.
fn least_used(count: usize, uses: impl Fn(usize) -> usize) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..count).collect();
    numbers.sort_by_key(|number| uses(*number));
    numbers
}

impl CurveStyle {
    fn new(scene: &Scene, index: usize, marker: ColourMarker) -> Self {
        let curve = &scene.curves[index];
        let shape = marker.shape.map(|number| SHAPES[number]);
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
        let style = Self {
            colour: COLOURS[marker.colour],
            width: 1.6,
            dashes,
            shape,
            apart,
            turn: [index, scene.curves.len()],
            named: !curve.label.is_empty(),
        };
        match curve.kind {
            CurveKind::Model => style,
            CurveKind::Reference => Self {
                width: 1.2,
                ..style
            },
            CurveKind::Fem => Self {
                shape: Some(POINT),
                ..style
            },
            CurveKind::Measured => Self {
                dashes: (curve.frequencies.len() > SPARSE).then_some("6 2"),
                apart: (curve.frequencies.len() <= SPARSE).then_some(0.0),
                width: 1.2,
                ..style
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

    /// The attributes of markers: filled with white.
    fn hollow(&self) -> String {
        format!(
            "fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.2\"",
            self.colour
        )
    }

    /// Draws the line of a curve, and arrows at its poles.
    pub(super) fn draw_line(&self, page: &mut Page, frame: &PlotFrame, path: &CurvePath) {
        let data = data(frame, path);
        if self.dashes.is_some() && !data.is_empty() {
            page.path(&data, &self.attributes());
        }
        for [x, y] in &path.poles {
            page.line([*x, *y], [*x, frame.top], &self.attributes());
            let arrow = format!("M{} {}l-4 8h8z", px(*x), px(frame.top));
            page.path(&arrow, &format!("fill=\"{}\"", self.colour));
        }
    }

    /// Draws the markers of a curve.
    pub(super) fn draw_markers(&self, page: &mut Page, frame: &PlotFrame, path: &CurvePath) {
        let Some(shape) = self.shape else { return };
        let mut markers = String::new();
        for [x, y] in self.markers(frame, path) {
            let _ = write!(markers, "M{} {}{shape}", px(x), px(y));
        }
        if !markers.is_empty() {
            page.path(&markers, &self.hollow());
        }
    }

    /// The positions of its markers.
    fn markers(&self, frame: &PlotFrame, path: &CurvePath) -> Vec<[f64; 2]> {
        if let Some(apart) = self.apart {
            let mut marked: Vec<[f64; 2]> = Vec::new();
            for [x, y] in &path.samples {
                let last = marked.last();
                if last.is_none_or(|last| (last[0] - x).hypot(last[1] - y) >= apart) {
                    marked.push([*x, *y]);
                }
            }
            return marked;
        }
        let [turn, turns] = self.turn;
        let share = (turn as f64 + 0.5) / turns as f64;
        let aims =
            (0..MARKERS).map(|k| frame.left + frame.width * (k as f64 + share) / MARKERS as f64);
        let nearest = |aim: f64| {
            let distance = |point: &&[f64; 2]| (point[0] - aim).abs();
            let points = path.samples.iter();
            points
                .min_by(|a, b| distance(a).total_cmp(&distance(b)))
                .copied()
        };
        aims.filter_map(nearest).collect()
    }
}

/// The path data of a curve, clipped to its plot plus a small margin.
fn data(frame: &PlotFrame, path: &CurvePath) -> String {
    let beyond = 4.0;
    let within = [
        [frame.left - beyond, frame.left + frame.width + beyond],
        [frame.top - beyond, frame.top + frame.height + beyond],
    ];
    let mut data = String::new();
    for part in &path.parts {
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

/// Draws the legend in rows from `left` to `right`; returns the position of the last row.
pub(super) fn legend(
    page: &mut Page,
    styles: &[CurveStyle],
    names: &[String],
    [left, top, right]: [f64; 3],
) -> f64 {
    let named = styles.iter().zip(names).filter(|(style, _)| style.named);
    let (mut x, mut y) = (left, top);
    let mut rows = 0;
    for (style, name) in named {
        let width = SAMPLE + 6.0 + TEXT * name.chars().count() as f64;
        if x > left && x + width > right {
            (x, y) = (left, y + ROW);
        }
        if style.dashes.is_some() {
            page.line([x, y - 4.0], [x + SAMPLE, y - 4.0], &style.attributes());
        }
        if let Some(shape) = style.shape {
            let marker = format!("M{} {}{shape}", px(x + SAMPLE / 2.0), px(y - 4.0));
            page.path(&marker, &style.hollow());
        }
        page.text([x + SAMPLE + 6.0, y], name, "class=\"name\"");
        x += width + SPACE;
        rows = 1;
    }
    if rows == 0 { top - ROW } else { y }
}
