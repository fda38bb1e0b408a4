//! Drawing a curve's line into dots, column by column.

use super::curve::LineStyle;
use super::dots::Dots;

/// Rows of dots a curve covers in one dot column, from the top downward, inside the plot.
pub(super) type Rows = (u16, u16);

/// A dot column and the heights covered in it, in dots from the top downward.
#[derive(Debug, Clone, Copy)]
struct Stroke {
    column: i32,
    top: f64,
    bottom: f64,
}

#[derive(Debug, Clone, Copy)]
struct Left {
    column: i32,
    top: i32,
    bottom: i32,
    crossing: i32,
}

/// Draws one curve from left to right.
///
/// Each dot column gets all rows from the highest to the lowest sample or interpolated point in it.
/// Where the rows of neighbours do not touch, each is extended to the row in which the curve crosses
/// the border between them, so that a steep line is connected and yet one dot thin.
pub(super) struct Pen<'d> {
    dots: &'d mut Dots,
    curve: usize,
    line: LineStyle,
    /// Dots passed along the line, drawn or not.
    passed: usize,
    last: Option<(f64, f64)>,
    stroke: Option<Stroke>,
    /// The finished stroke to the left: its column, its rows and the row in which the curve left it.
    left: Option<Left>,
    covered: Vec<Option<Rows>>,
}

impl<'d> Pen<'d> {
    pub(super) fn new(dots: &'d mut Dots, curve: usize, line: LineStyle) -> Self {
        let covered = vec![None; usize::from(dots.across.dots())];
        Self {
            dots,
            curve,
            line,
            passed: 0,
            last: None,
            stroke: None,
            left: None,
            covered,
        }
    }

    /// Continues the line to a point in dots from the top left; a point that is not finite ends the line.
    pub(super) fn draw_to(&mut self, x: f64, y: f64) {
        if !(x.is_finite() && y.is_finite()) {
            self.lift();
            return;
        }
        match self.last {
            Some(last) if last.0 <= x => self.segment(last, (x, y)),
            _ => {
                self.lift();
                self.cover(self.column(x), y);
            }
        }
        self.last = Some((x, y));
    }

    /// Ends the curve and tells which rows it covers in each dot column.
    pub(super) fn finish(mut self) -> Vec<Option<Rows>> {
        self.lift();
        self.covered
    }

    /// Ends the line: the next point starts another.
    pub(super) fn lift(&mut self) {
        self.flush(0.0);
        self.last = None;
        self.left = None;
    }

    fn segment(&mut self, (x0, y0): (f64, f64), (x1, y1): (f64, f64)) {
        // Most samples stay in their column; they are recognised without rounding.
        if let Some(stroke) = &mut self.stroke
            && x1 < f64::from(stroke.column) + 0.5
        {
            stroke.top = stroke.top.min(y1);
            stroke.bottom = stroke.bottom.max(y1);
            return;
        }
        let (first, last) = (self.column(x0), self.column(x1));
        if first == last {
            self.cover(last, y1);
            return;
        }
        let at = |x: f64| y0 + (x - x0) * ((y1 - y0) / (x1 - x0));
        for column in first + 1..=last {
            let centre = f64::from(column);
            self.flush(at(centre - 0.5));
            self.cover(column, if column == last { y1 } else { at(centre) });
        }
    }

    /// The dot column of `x`; all columns outside the plot are as good as the first one outside.
    fn column(&self, x: f64) -> i32 {
        x.round().clamp(-1.0, f64::from(self.dots.across.dots())) as i32
    }

    /// The dot row of `y`, likewise.
    fn row(&self, y: f64) -> i32 {
        y.round().clamp(-1.0, f64::from(self.dots.down.dots())) as i32
    }

    fn cover(&mut self, column: i32, y: f64) {
        let (top, bottom) = self
            .stroke
            .map_or((y, y), |stroke| (stroke.top.min(y), stroke.bottom.max(y)));
        self.stroke = Some(Stroke {
            column,
            top,
            bottom,
        });
    }

    /// Draws the stroke and its connection to the one on its left; the curve goes on at height `crossing`.
    fn flush(&mut self, crossing: f64) {
        let Some(stroke) = self.stroke.take() else {
            return;
        };
        let (mut top, mut bottom) = (self.row(stroke.top), self.row(stroke.bottom));
        let crossing = self.row(crossing);
        let next = Left {
            column: stroke.column,
            top,
            bottom,
            crossing,
        };
        if let Some(left) = self.left.replace(next) {
            if top > left.bottom {
                let border = left.crossing.clamp(left.bottom, top - 1);
                self.fill(left.column, left.bottom + 1, border);
                top = border + 1;
            } else if bottom < left.top {
                let border = left.crossing.clamp(bottom + 1, left.top);
                self.fill(left.column, border, left.top - 1);
                bottom = border - 1;
            }
        }
        self.fill(stroke.column, top, bottom);
    }

    /// Draws the rows from `top` to `bottom` that are inside the plot.
    fn fill(&mut self, column: i32, top: i32, bottom: i32) {
        let rows = top.max(0)..=bottom.min(i32::from(self.dots.down.dots()) - 1);
        if rows.is_empty() || !(0..i32::from(self.dots.across.dots())).contains(&column) {
            return;
        }
        let covered = &mut self.covered[column as usize];
        let (start, end) = (*rows.start() as u16, *rows.end() as u16);
        *covered = Some(covered.map_or((start, end), |(top, bottom)| {
            (top.min(start), bottom.max(end))
        }));
        for row in start..=end {
            if self.line.draws(self.passed) {
                self.dots.draw(column as u16, row, self.curve);
            }
            self.passed += 1;
        }
    }
}
