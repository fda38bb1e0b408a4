//! Draws the line of a curve into dots, column by column.

use super::curve::LineStyle;
use super::dots::Dots;

/// The first and last dot row of a curve in one dot column, from the top, inside the plot.
pub(super) type RowSpan = (u16, u16);

/// A dot column and the height range covered in it, in dots from the top.
#[derive(Debug, Clone, Copy)]
struct ColumnSpan {
    column: i32,
    top: f64,
    bottom: f64,
}

/// The finished column on the left: its rows, and the row in which the curve left it.
#[derive(Debug, Clone, Copy)]
struct PreviousColumn {
    column: i32,
    top: i32,
    bottom: i32,
    crossing: i32,
}

/// Draws one curve from left to right.
///
/// Each dot column gets all rows from its highest to its lowest sample or interpolated point.
/// Where the rows of neighbouring columns do not touch, each is extended to the row in which the curve crosses the
/// border between them, so that a steep line is connected and one dot thin.
pub(super) struct StrokePainter<'d> {
    dots: &'d mut Dots,
    curve: usize,
    line: LineStyle,
    /// Dots along the line so far, drawn or not.
    distance: usize,
    last: Option<(f64, f64)>,
    span: Option<ColumnSpan>,
    previous: Option<PreviousColumn>,
    covered: Vec<Option<RowSpan>>,
}

impl<'d> StrokePainter<'d> {
    pub(super) fn new(dots: &'d mut Dots, curve: usize, line: LineStyle) -> Self {
        let covered = vec![None; usize::from(dots.across.dots())];
        Self {
            dots,
            curve,
            line,
            distance: 0,
            last: None,
            span: None,
            previous: None,
            covered,
        }
    }

    /// Continues the line to a point in dots from the top left; a point that is not finite ends the line.
    pub(super) fn line_to(&mut self, x: f64, y: f64) {
        if !(x.is_finite() && y.is_finite()) {
            self.end_line();
            return;
        }
        match self.last {
            Some(last) if last.0 <= x => self.segment(last, (x, y)),
            _ => {
                self.end_line();
                self.cover(self.column(x), y);
            }
        }
        self.last = Some((x, y));
    }

    /// Ends the curve; returns the rows it covers in each dot column.
    pub(super) fn finish(mut self) -> Vec<Option<RowSpan>> {
        self.end_line();
        self.covered
    }

    /// Ends the line: the next point starts a new one.
    pub(super) fn end_line(&mut self) {
        self.flush(0.0);
        self.last = None;
        self.previous = None;
    }

    fn segment(&mut self, (x0, y0): (f64, f64), (x1, y1): (f64, f64)) {
        // Fast path: most samples stay in their column and need no rounding.
        if let Some(span) = &mut self.span
            && x1 < f64::from(span.column) + 0.5
        {
            span.top = span.top.min(y1);
            span.bottom = span.bottom.max(y1);
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

    /// The dot column of `x`; columns outside the plot become the first one outside.
    fn column(&self, x: f64) -> i32 {
        x.round().clamp(-1.0, f64::from(self.dots.across.dots())) as i32
    }

    /// The dot row of `y`, likewise.
    fn row(&self, y: f64) -> i32 {
        y.round().clamp(-1.0, f64::from(self.dots.down.dots())) as i32
    }

    fn cover(&mut self, column: i32, y: f64) {
        let (top, bottom) = self
            .span
            .map_or((y, y), |span| (span.top.min(y), span.bottom.max(y)));
        self.span = Some(ColumnSpan {
            column,
            top,
            bottom,
        });
    }

    /// Draws the span and connects it to the one on its left; the curve leaves it at height `crossing`.
    fn flush(&mut self, crossing: f64) {
        let Some(span) = self.span.take() else {
            return;
        };
        let (mut top, mut bottom) = (self.row(span.top), self.row(span.bottom));
        let crossing = self.row(crossing);
        let next = PreviousColumn {
            column: span.column,
            top,
            bottom,
            crossing,
        };
        if let Some(previous) = self.previous.replace(next) {
            if top > previous.bottom {
                let border = previous.crossing.clamp(previous.bottom, top - 1);
                self.fill(previous.column, previous.bottom + 1, border);
                top = border + 1;
            } else if bottom < previous.top {
                let border = previous.crossing.clamp(bottom + 1, previous.top);
                self.fill(previous.column, border, previous.top - 1);
                bottom = border - 1;
            }
        }
        self.fill(span.column, top, bottom);
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
            if self.line.draws(self.distance) {
                self.dots.draw(column as u16, row, self.curve);
            }
            self.distance += 1;
        }
    }
}
