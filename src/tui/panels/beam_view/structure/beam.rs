//! The beam from the side: a line where its depth is the same all along, otherwise the outlines of its spans, to scale.

use ratatui::style::Style;

use super::{Focus, Picture};
use crate::model::UniformPart;
use crate::tui::sketch::{Board, POINTER, POINTER_BACK};

/// The lower and the upper surface of each part of the beam, y in m from the axis.
pub(super) struct Profile {
    surfaces: Vec<[f64; 2]>,
}

impl Profile {
    pub(super) fn of(parts: &[UniformPart]) -> Self {
        Self {
            surfaces: parts.iter().map(surfaces).collect(),
        }
    }

    /// Whether a line shows all of it.
    pub(super) fn is_flat(&self) -> bool {
        self.surfaces.windows(2).all(|pair| pair[0] == pair[1])
    }

    /// The range of all surfaces and the axis.
    fn range(&self) -> [f64; 2] {
        let all = self.surfaces.iter();
        all.fold([0.0, 0.0], |[low, high], part| {
            [low.min(part[0]), high.max(part[1])]
        })
    }

    /// Rows of its upper end above the axis, if its depth takes this number of rows after the first one.
    pub(super) fn above_axis(&self, depth: i32) -> i32 {
        row_of(self.range(), depth, self.range()[1])
    }

    /// The rows above the axis of the surfaces of each part, the upper one first.
    fn rows(&self, depth: i32) -> impl Iterator<Item = [i32; 2]> {
        let range = self.range();
        let [lowest, highest] = [self.above_axis(depth) - depth, self.above_axis(depth)];
        self.surfaces.iter().map(move |[low, high]| {
            [*high, *low].map(|y| row_of(range, depth, y).clamp(lowest, highest))
        })
    }
}

/// The row above the axis of a height y, m, if a range of heights takes this number of rows after the first one. A half
/// is rounded to the axis, so that three rows tell half of the depth from all of it.
fn row_of([low, high]: [f64; 2], depth: i32, y: f64) -> i32 {
    let rows = y / (high - low) * f64::from(depth);
    (rows.abs() - 0.5 - 1e-9).ceil().copysign(rows) as i32
}

/// The surfaces of a rectangle with a part's area and second moment, about its centroid: the model has no outline.
fn surfaces(part: &UniformPart) -> [f64; 2] {
    let section = &part.beam.section;
    let centroid = part.offset.y + section.centroid_offset_y;
    let half = (12.0 * section.second_moment_y / section.area).sqrt() / 2.0;
    [centroid - half, centroid + half]
}

/// A part of the beam in the picture: its first and last column, and its first and last row.
pub(super) struct Body {
    pub(super) columns: [i32; 2],
    pub(super) rows: [i32; 2],
}

pub(super) fn bodies(picture: &Picture<'_>, parts: &[UniformPart], profile: &Profile) -> Vec<Body> {
    let [first, last] = picture.rows.depth;
    let rows = profile.rows(last - first);
    let bodies = parts.iter().zip(rows).map(|(part, rows)| Body {
        columns: [part.start, part.end].map(|x| picture.column(x)),
        rows: rows.map(|row| picture.rows.beam - row),
    });
    bodies.collect()
}

pub(super) fn draw(picture: &Picture<'_>, board: &mut Board<'_>) {
    let is_selected = |column: i32| match picture.focus {
        Focus::Beam => true,
        Focus::Span(i) => {
            let [first, last] = picture.bodies[i].columns;
            (first..=last).contains(&column)
        }
        Focus::Support(_)
        | Focus::Joint(_)
        | Focus::Subsystem(_)
        | Focus::Force(_)
        | Focus::Response(_)
        | Focus::Nothing => false,
    };
    for column in picture.ends[0]..=picture.ends[1] {
        let style = if is_selected(column) {
            picture.theme.accent()
        } else {
            Style::new()
        };
        draw_column(picture, board, column, style);
    }
    if picture.focus == Focus::Beam {
        // Signs from both ends inwards; a support has its pointer at its own end.
        let (row, style) = (picture.rows.beam, picture.style(true, true));
        board.sign([(picture.ends[0] - 1).max(0), row], POINTER, style);
        board.sign([picture.ends[1] + 1, row], POINTER_BACK, style);
    }
}

/// A column of the beam and its axis: the surfaces of a part, or where a part ends a line across it.
fn draw_column(picture: &Picture<'_>, board: &mut Board<'_>, column: i32, style: Style) {
    let signs = picture.signs;
    let bodies = || picture.bodies.iter();
    let left = bodies().position(|body| body.columns[0] < column && column <= body.columns[1]);
    let right = bodies().position(|body| body.columns[0] <= column && column < body.columns[1]);
    let has_edge = |body: Option<usize>, row: i32| {
        body.is_some_and(|body| picture.bodies[body].rows.contains(&row))
    };
    let [top, bottom] = picture.beam_at(column);
    // On one line, a sign across it shows where two parts meet.
    let crosses = top == bottom && left.is_some() && right.is_some();
    for row in top..=bottom {
        let at = [column, row];
        let along = [left, right].map(|body| has_edge(body, row));
        if left != right {
            let across = [crosses || row > top, crosses || row < bottom];
            let sign = if across == [false; 2] {
                signs.beam
            } else {
                signs.junction([across[0], across[1], along[0], along[1]])
            };
            board.sign(at, sign, style);
        } else if along[0] && left.is_some_and(|body| is_line(&picture.bodies[body])) {
            board.sign(at, signs.beam, style);
        } else if along[0] {
            board.sign(at, signs.frame.along, style);
        } else if row == picture.rows.beam {
            board.sign(at, signs.dashed.along, picture.theme.dim());
        } else {
            board.sign(at, ' ', style);
        }
    }
}

fn is_line(body: &Body) -> bool {
    body.rows[0] == body.rows[1]
}

/// The sign of the axis, if the beam is not drawn as a line there.
pub(super) fn keys(picture: &Picture<'_>) -> Vec<String> {
    let is_seen = picture.bodies.iter().any(|body| !is_line(body));
    let key = is_seen.then(|| format!("{} axis", picture.signs.dashed.along));
    key.into_iter().collect()
}
