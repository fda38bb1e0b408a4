//! Two stacked charts that share the horizontal axis.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::Widget;

use super::chart::{Below, Chart, Legend};
use super::layout::ChartLayout;
use super::level::Level;

/// Fewest rows in which both charts are drawn.
const BOTH: u16 = 12;
/// Fewest rows of the lower plot.
const LOWEST: u16 = 3;
/// The upper plot's share of the rows, in percent: above a phase, and above an equal chart.
const OVER_PHASE: u16 = 60;
const HALF: u16 = 50;

/// Two charts, one above the other: a column has the same value in both; labels and marks of the horizontal axis are
/// below the lower chart only.
///
/// An area too low for both shows the upper chart only.
#[derive(Debug, Clone)]
pub struct StackedCharts<'a> {
    pub(super) upper: Chart<'a>,
    pub(super) lower: Chart<'a>,
}

impl<'a> StackedCharts<'a> {
    /// Stacks two charts. The lower one takes the horizontal axis of the upper one with cursors, harmonics, band and
    /// marks; only the upper one has a legend.
    pub fn new(upper: Chart<'a>, lower: Chart<'a>) -> Self {
        let lower = Chart {
            x: upper.x.clone(),
            cursor: upper.cursor,
            second: upper.second,
            harmonics: upper.harmonics.clone(),
            band: upper.band,
            axis_mark: upper.axis_mark,
            marks: upper.marks.clone(),
            glyphs: upper.glyphs,
            styles: upper.styles,
            legend: Legend::Hidden,
            ..lower
        };
        Self { upper, lower }
    }

    /// The plot areas when the charts are drawn into `area`; the lower one is empty where there is no room.
    pub fn plot_areas(&self, area: Rect) -> [Rect; 2] {
        let [upper, lower] = self.charts(area);
        [upper, lower]
            .map(|part| part.map_or(Rect::default(), |(chart, area)| chart.plot_area(area)))
    }

    /// The value of the horizontal axis in the middle of a column of the plots.
    pub fn value_in(&self, plot: Rect, cell: u16) -> f64 {
        self.upper.value_in(plot, cell)
    }

    /// The charts as they are drawn, and where.
    fn charts(&self, area: Rect) -> [Option<(Chart<'a>, Rect)>; 2] {
        if area.height < BOTH {
            return [Some((self.upper.clone(), area)), None];
        }
        let heading = |chart: &Chart<'_>| u16::from(chart.has_heading());
        let below = 2 + u16::from(!self.lower.marks.values.is_empty());
        let around = heading(&self.upper) + 1 + heading(&self.lower) + below;
        let share = if self.lower.level == Level::Degrees {
            OVER_PHASE
        } else {
            HALF
        };
        let plots = area.height - around;
        let upper = (plots * share).div_ceil(100).min(plots - LOWEST);
        let height = heading(&self.upper) + upper + 1;
        let areas = [
            Rect { height, ..area },
            Rect {
                y: area.y + height,
                height: area.height - height,
                ..area
            },
        ];
        let mut upper = self.upper.clone();
        let mut lower = self.lower.clone();
        upper.below = Below::Axis;
        let columns = [(&upper, areas[0]), (&lower, areas[1])]
            .map(|(chart, area)| ChartLayout::new(chart, area).label_columns);
        let widest = columns[0].max(columns[1]);
        (upper.label_columns, lower.label_columns) = (widest, widest);
        [Some((upper, areas[0])), Some((lower, areas[1]))]
    }
}

impl Widget for &StackedCharts<'_> {
    fn render(self, area: Rect, buffer: &mut Buffer) {
        let area = area.intersection(buffer.area);
        for (chart, area) in self.charts(area).into_iter().flatten() {
            chart.render(area, buffer);
        }
    }
}
