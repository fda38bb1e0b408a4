//! Draws a chart: lays out its parts, then draws them over each other.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::Widget;

use super::cells;
use super::chart::Chart;
use super::curve::Curve;
use super::dots::Dots;
use super::frame;
use super::glyphs::{put, rulers, width};
use super::layout::ChartLayout;
use super::legend;
use super::level::Level;
use super::nyquist;
use super::trace;

impl Chart<'_> {
    /// The plot area when the chart is drawn into `area`.
    pub fn plot_area(&self, area: Rect) -> Rect {
        ChartLayout::new(self, area).plot
    }

    /// The screen column of a value of the horizontal axis when the chart is drawn into `area`.
    pub fn column(&self, area: Rect, value: f64) -> Option<u16> {
        let plot = self.plot_area(area);
        self.cell(plot, value).map(|cell| plot.x + cell)
    }

    /// Writes in the middle of an empty plot why it is empty.
    fn explain(&self, plot: Rect, buffer: &mut Buffer) {
        let finite = |(abscissa, magnitude): (f64, f64)| {
            self.x.fraction(abscissa).is_finite()
                && self.y.fraction(self.level.value(magnitude)).is_finite()
        };
        let mut samples = self.curves.iter().flat_map(Curve::samples).peekable();
        let hidden = !self.y.fraction(self.level.value(0.0)).is_finite();
        let zero = hidden && samples.peek().is_some() && samples.all(|sample| sample.1 == 0.0);
        let message = if zero {
            "zero at every frequency"
        } else if self.curves.iter().flat_map(Curve::samples).any(finite) {
            "no value within the axes"
        } else if self.level == Level::Degrees {
            // For example an energy, or a measurement of magnitudes only.
            "no phase to draw"
        } else {
            "no finite value to draw"
        };
        let margin = plot.width.saturating_sub(width(message)) / 2;
        let row = Rect {
            x: plot.x + margin,
            y: plot.y + plot.height / 2,
            width: plot.width - margin,
            height: plot.height.min(1),
        };
        put(buffer, row, message, (self.glyphs, self.styles.message));
    }

    /// Draws the chart as laid out by `layout`.
    pub(super) fn render_in(&self, layout: &ChartLayout, buffer: &mut Buffer) {
        let plot = layout.plot;
        let mut dots = Dots::new(rulers(plot.width, plot.height, self.glyphs));
        if self.nyquist {
            nyquist::trace(self, &mut dots);
        } else {
            trace::trace(self, &mut dots);
        }
        cells::curves(self, layout, &dots, buffer);
        frame::draw(self, layout, buffer);
        legend::draw(self, layout.legend, buffer);
        cells::paint(self, layout, &dots, buffer);
        if dots.is_blank() {
            self.explain(plot, buffer);
        }
    }
}

impl Widget for &Chart<'_> {
    fn render(self, area: Rect, buffer: &mut Buffer) {
        let area = area.intersection(buffer.area);
        if !area.is_empty() {
            self.render_in(&ChartLayout::new(self, area), buffer);
        }
    }
}
