//! Converts a curve into the points of its path on the page.

use super::frame::PlotFrame;
use crate::tui::plot::{Curve, Level};

/// Approximate most points of a curve on the page.
const MOST_POINTS: usize = 4000;
/// Half a turn, in degrees; a larger phase jump is a wrap.
const HALF_TURN: f64 = 180.0;

/// A curve on the page, px.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct CurvePath {
    /// The points between two gaps.
    pub(super) parts: Vec<Vec<[f64; 2]>>,
    /// Poles: each is a line from this point up to the top.
    pub(super) poles: Vec<[f64; 2]>,
    /// All points inside the plot, for markers.
    pub(super) samples: Vec<[f64; 2]>,
}

/// The path of a curve over frequency.
pub(super) fn over_frequency(frame: &PlotFrame, curve: &Curve<'_>, level: Level) -> CurvePath {
    let mut path = CurvePath::default();
    let mut part: Vec<[f64; 2]> = Vec::new();
    let mut previous = f64::NAN;
    for (x, y) in curve.x.iter().zip(curve.y) {
        let value = level.value(*y);
        let position = frame.position(*x, value);
        let wraps = level == Level::Degrees && (value - previous).abs() > HALF_TURN;
        previous = value;
        let drawable = position.iter().all(|coordinate| coordinate.is_finite());
        if wraps || !drawable {
            path.parts.push(std::mem::take(&mut part));
        }
        if drawable {
            part.push(position);
            path.samples.extend(frame.inside(*x, value));
        }
    }
    path.parts.push(part);
    path.parts.retain(|part| !part.is_empty());
    if matches!(level, Level::Magnitude | Level::Decibel { .. }) {
        path.poles = poles(frame, curve, level);
    }
    let points: usize = path.parts.iter().map(Vec::len).sum();
    if points > MOST_POINTS {
        // A column keeps four points.
        let column = frame.width / (MOST_POINTS as f64 / 4.0);
        path.parts = path
            .parts
            .iter()
            .map(|part| by_columns(part, column))
            .collect();
    }
    path
}

/// The poles of a curve, each at the height of its lower neighbour sample.
fn poles(frame: &PlotFrame, curve: &Curve<'_>, level: Level) -> Vec<[f64; 2]> {
    let on_axis = |pole: &&f64| (0.0..=1.0).contains(&frame.x.fraction(**pole));
    let neighbour_height = |pole: &f64| {
        let after = curve.x.partition_point(|x| x < pole);
        let around = [after.wrapping_sub(1), after].into_iter();
        let heights =
            around.filter_map(|i| Some(frame.position(*pole, level.value(*curve.y.get(i)?))));
        let finite = heights.filter(|position| position[1].is_finite());
        finite.max_by(|a, b| a[1].total_cmp(&b[1]))
    };
    curve
        .poles
        .iter()
        .filter(on_axis)
        .filter_map(neighbour_height)
        .collect()
}

/// The first, the highest, the lowest and the last point of each column, in their order.
fn by_columns(part: &[[f64; 2]], width: f64) -> Vec<[f64; 2]> {
    let number = |point: &[f64; 2]| (point[0] / width).floor();
    let columns = part.chunk_by(|a, b| number(a) == number(b));
    let mut selected = Vec::new();
    for column in columns {
        let heights = || column.iter().map(|point| point[1]).enumerate();
        let high = heights().min_by(|a, b| a.1.total_cmp(&b.1));
        let low = heights().max_by(|a, b| a.1.total_cmp(&b.1));
        let mut indices = vec![0, column.len() - 1];
        indices.extend(high.into_iter().chain(low).map(|(position, _)| position));
        indices.sort_unstable();
        indices.dedup();
        selected.extend(indices.into_iter().map(|position| column[position]));
    }
    selected
}

/// The path of a Nyquist curve.
pub(super) fn nyquist(frame: &PlotFrame, [x, y]: &[Vec<f64>; 2]) -> CurvePath {
    let mut path = CurvePath::default();
    let mut part: Vec<[f64; 2]> = Vec::new();
    for (x, y) in x.iter().zip(y) {
        let position = frame.position(*x, *y);
        if position.iter().all(|coordinate| coordinate.is_finite()) {
            part.push(position);
            path.samples.extend(frame.inside(*x, *y));
        } else {
            path.parts.push(std::mem::take(&mut part));
        }
    }
    path.parts.push(part);
    path.parts.retain(|part| !part.is_empty());
    let mut apart = 0.25;
    while path.parts.iter().map(Vec::len).sum::<usize>() > MOST_POINTS && apart < frame.width {
        path.parts = path.parts.iter().map(|part| thinned(part, apart)).collect();
        apart *= 2.0;
    }
    path
}

/// The points at least `apart` px from the previous one, and the last point.
fn thinned(part: &[[f64; 2]], apart: f64) -> Vec<[f64; 2]> {
    let mut selected: Vec<[f64; 2]> = Vec::new();
    for (index, point) in part.iter().enumerate() {
        let far = selected
            .last()
            .is_none_or(|last| (last[0] - point[0]).hypot(last[1] - point[1]) >= apart);
        if far || index + 1 == part.len() {
            selected.push(*point);
        }
    }
    selected
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::plot::{Axis, Scale};

    fn frame() -> PlotFrame {
        PlotFrame {
            x: Axis::new(Scale::Linear, [0.0, 1.0], ""),
            y: Axis::new(Scale::Linear, [0.0, 100.0], ""),
            left: 0.0,
            top: 0.0,
            width: 700.0,
            height: 400.0,
        }
    }

    #[test]
    fn narrow_peaks_and_dips_of_many_points_remain() {
        let count = 100_000;
        let x: Vec<f64> = (0..count)
            .map(|k| f64::from(k) / f64::from(count))
            .collect();
        let mut y = vec![50.0; x.len()];
        (y[31_234], y[31_235], y[77_777]) = (99.0, 1.0, 90.0);
        let path = over_frequency(&frame(), &Curve::new(&x, &y), Level::Signed);
        let points: Vec<[f64; 2]> = path.parts.concat();
        assert!(points.len() <= MOST_POINTS, "{}", points.len());
        // 4 px a unit, from the top.
        for height in [4.0, 396.0, 40.0] {
            assert!(points.iter().any(|point| (point[1] - height).abs() < 1e-9));
        }
        assert!(points.is_sorted_by(|a, b| a[0] <= b[0]));
        assert_eq!(
            (points[0], points[points.len() - 1][0]),
            ([0.0, 200.0], 700.0 * x[99_999])
        );
    }

    #[test]
    fn many_points_of_a_locus_are_thinned_by_distance() {
        let angle = |k: u32| f64::from(k) * 1e-5;
        let x: Vec<f64> = (0..600_000).map(|k| 0.5 + 0.4 * angle(k).cos()).collect();
        let y: Vec<f64> = (0..600_000).map(|k| 50.0 + 40.0 * angle(k).sin()).collect();
        let points = nyquist(&frame(), &[x, y]).parts.concat();
        assert!(
            (1000..=MOST_POINTS).contains(&points.len()),
            "{}",
            points.len()
        );
        let steps = points
            .windows(2)
            .map(|p| (p[0][0] - p[1][0]).hypot(p[0][1] - p[1][1]));
        assert!(steps.fold(0.0, f64::max) < 1.0);
    }

    #[test]
    fn gaps_and_wraps_split_a_curve() {
        let x = [0.0, 0.2, 0.4, 0.6, 0.8];
        let parts = |y: &[f64], level| {
            let path = over_frequency(&frame(), &Curve::new(&x, y), level);
            path.parts.iter().map(Vec::len).collect::<Vec<_>>()
        };
        assert_eq!(
            parts(&[1.0, 2.0, f64::NAN, 3.0, 4.0], Level::Signed),
            [2, 2]
        );
        assert_eq!(
            parts(&[10.0, 175.0, -175.0, 0.0, 1.0], Level::Degrees),
            [2, 3]
        );
        assert_eq!(parts(&[10.0, 175.0, -175.0, 0.0, 1.0], Level::Signed), [5]);
        let gap = nyquist(&frame(), &[x.to_vec(), vec![1.0, f64::NAN, 2.0, 3.0, 4.0]]);
        assert_eq!(gap.parts.iter().map(Vec::len).collect::<Vec<_>>(), [1, 3]);
    }

    #[test]
    fn a_pole_reaches_from_the_lower_neighbour_to_the_top() {
        let curve = Curve {
            poles: vec![0.5, 7.0],
            ..Curve::new(&[0.4, 0.6], &[60.0, 20.0])
        };
        let path = over_frequency(&frame(), &curve, Level::Magnitude);
        assert_eq!(path.poles, [[350.0, 320.0]]);
        assert!(
            over_frequency(&frame(), &curve, Level::Signed)
                .poles
                .is_empty()
        );
    }
}
