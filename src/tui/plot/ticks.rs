//! Round tick values, as dense as their labels allow.

use super::axis::{Axis, Direction, Notation, Ruler, Scale};

/// Free columns between two labels of a horizontal axis.
const LABEL_GAP: u16 = 2;
/// Rows from one label of a vertical axis to the next.
const LABEL_ROWS: u16 = 2;
/// Fewest cells of a decade with ticks at 2..9.
const DECADE_CELLS: f64 = 8.0;
/// Dots per letter where there are no cells.
const FINE_DOTS: u16 = 4;

/// A tick and its cell, counted from the left or from the top.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) cell: u16,
    /// Present on major ticks.
    pub(super) label: Option<String>,
}

/// A round value of an axis, independent of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisTick {
    /// Its position: 0 at the lower bound, 1 at the upper.
    pub fraction: f64,
    /// Its value as text; none for minor ticks.
    pub label: Option<String>,
}

impl Axis {
    /// Round values for an axis to the right, `letters` long.
    pub fn ticks_across(&self, letters: u16) -> Vec<AxisTick> {
        self.axis_ticks(letters, Direction::Right)
    }

    /// Round values for an axis upward, `lines` of text high.
    pub fn ticks_up(&self, lines: u16) -> Vec<AxisTick> {
        self.axis_ticks(lines, Direction::Up)
    }

    fn axis_ticks(&self, cells: u16, direction: Direction) -> Vec<AxisTick> {
        let ruler = Ruler {
            direction,
            cells,
            dots_per_cell: FINE_DOTS,
        };
        let ticks = ticks(self, ruler).into_iter();
        ticks
            .map(|tick| AxisTick {
                fraction: self.fraction(tick.value),
                label: tick.label,
            })
            .collect()
    }
}

/// A rule that generates round values.
#[derive(Debug, Clone, Copy, PartialEq)]
enum TickStep {
    /// Multiples of `mantissa * 10^exponent`.
    Linear { mantissa: i32, exponent: i32 },
    /// These multiples of each power of ten.
    Multiples(&'static [i32]),
    /// Every n-th power of ten.
    Decades(i32),
}

const ONE_TWO_FIVE: TickStep = TickStep::Multiples(&[1, 2, 5]);
const ALL_NINE: TickStep = TickStep::Multiples(&[1, 2, 3, 4, 5, 6, 7, 8, 9]);

/// The ticks of `axis` along `ruler`: major ones in ascending order of value, then minor ones.
pub(super) fn ticks(axis: &Axis, ruler: Ruler) -> Vec<Tick> {
    let (step, mut ticks) = major(axis, ruler);
    let cells: Vec<u16> = ticks.iter().map(|tick| tick.cell).collect();
    for value in minor(step, axis, ruler) {
        match ruler.cell(axis.fraction(value)) {
            Some(cell) if !cells.contains(&cell) => ticks.push(Tick {
                value,
                cell,
                label: None,
            }),
            _ => {}
        }
    }
    ticks
}

/// The densest labelled ticks that fit; if none fit, the sparsest with at least two.
fn major(axis: &Axis, ruler: Ruler) -> (TickStep, Vec<Tick>) {
    let mut last = (TickStep::Decades(1), Vec::new());
    for step in ladder(axis) {
        let Some(values) = values(step, axis, ruler.cells) else {
            continue;
        };
        if values.len() < 2 && !last.1.is_empty() {
            continue;
        }
        let ticks = labelled(&values, axis, ruler);
        if ticks.len() >= 2 && fit(&ticks, ruler.direction) {
            return (step, ticks);
        }
        last = (step, ticks);
    }
    last
}

/// Steps of angles from 15 degrees up, where decimal steps do not divide a right angle.
const ANGLES: [i32; 6] = [15, 30, 45, 90, 180, 360];

/// The smallest of 1, 2 and 5 times a power of ten that is at least `least` (positive): mantissa and exponent.
pub(super) fn round_step(least: f64) -> (i64, i32) {
    let exponent = least.log10().floor() as i32;
    let steps = [1, 2, 5].map(|mantissa| (mantissa, exponent));
    let found = steps
        .into_iter()
        .find(|(mantissa, exponent)| round(*mantissa, *exponent) >= least * (1.0 - 1e-9));
    found.unwrap_or((1, exponent.saturating_add(1)))
}

/// The steps to try, from dense to sparse.
fn ladder(axis: &Axis) -> Vec<TickStep> {
    let [low, high] = axis.bounds();
    let top = (high - low).log10().floor() as i32;
    let linear = (top - 3..=top)
        .flat_map(|exponent| [1, 2, 5].map(|mantissa| TickStep::Linear { mantissa, exponent }));
    if axis.notation == Notation::Degrees {
        return angles(linear);
    }
    if axis.scale == Scale::Linear {
        return linear.collect();
    }
    // Within a decade 1, 2 and 5 may be too few, and multiples of one step are easier to read.
    let few = values(ONE_TWO_FIVE, axis, 3).is_some();
    let mut steps: Vec<TickStep> = linear.filter(|_| few).collect();
    steps.push(ONE_TWO_FIVE);
    steps.extend([1, 2, 3, 5, 10, 20, 50, 100].map(TickStep::Decades));
    steps
}

/// Steps of angles: decimal below 15 degrees, then parts of a turn, then turns.
fn angles(linear: impl Iterator<Item = TickStep>) -> Vec<TickStep> {
    let turns = [2, 5, 10, 20, 50, 100].map(|turns| 360 * turns);
    let angles = ANGLES.into_iter().chain(turns);
    let whole = angles.map(|mantissa| TickStep::Linear {
        mantissa,
        exponent: 0,
    });
    let fine = linear.filter(|step| matches!(step, TickStep::Linear { exponent: ..=0, .. }));
    fine.chain(whole).collect()
}

/// The values of `step` on the axis; none if there are more than `limit`.
fn values(step: TickStep, axis: &Axis, limit: u16) -> Option<Vec<f64>> {
    let [low, high] = axis.bounds();
    let candidates: Vec<f64> = match step {
        TickStep::Linear { mantissa, exponent } => {
            let (mantissa, size) = (i64::from(mantissa), round(i64::from(mantissa), exponent));
            let (first, last) = ((low / size).floor(), (high / size).ceil());
            if last - first > f64::from(limit) + 2.0 {
                return None;
            }
            let multiples = first as i64..=last as i64;
            multiples
                .map(|k| round(k.saturating_mul(mantissa), exponent))
                .collect()
        }
        TickStep::Multiples(multiples) => decades(low, high, 1)
            .flat_map(|decade| multiples.iter().map(move |k| round(i64::from(*k), decade)))
            .collect(),
        TickStep::Decades(every) => decades(low, high, every)
            .map(|decade| round(1, decade))
            .collect(),
    };
    let values: Vec<f64> = candidates
        .into_iter()
        .filter(|value| axis.contains(*value))
        .collect();
    (values.len() <= usize::from(limit)).then_some(values)
}

/// The exponents of ten around the bounds that are divisible by `every`.
fn decades(low: f64, high: f64, every: i32) -> impl Iterator<Item = i32> {
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    (first..=last).filter(move |exponent| exponent % every == 0)
}

/// `mantissa * 10^exponent`, correctly rounded (a floating-point product is not).
pub(super) fn round(mantissa: i64, exponent: i32) -> f64 {
    format!("{mantissa}e{exponent}").parse().unwrap_or(f64::NAN)
}

fn labelled(values: &[f64], axis: &Axis, ruler: Ruler) -> Vec<Tick> {
    let tick = |value: &f64| {
        let cell = ruler.cell(axis.fraction(*value))?;
        let label = Some(text(*value, axis.notation));
        Some(Tick {
            value: *value,
            cell,
            label,
        })
    };
    values.iter().filter_map(tick).collect()
}

/// The label of a round value.
fn text(value: f64, notation: Notation) -> String {
    let plain = notation != Notation::Power && (1e-4..1e7).contains(&value.abs());
    if plain || value == 0.0 {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// The first column and the width of a label centred on its tick; the column may be negative.
pub(super) fn label_span(label: &str, cell: u16) -> (i32, u16) {
    let width = label.len() as u16;
    (
        i32::from(cell) - i32::from(width.saturating_sub(1) / 2),
        width,
    )
}

/// Whether the labels do not touch each other.
fn fit(ticks: &[Tick], direction: Direction) -> bool {
    ticks.windows(2).all(|pair| match direction {
        Direction::Up => pair[0].cell >= pair[1].cell.saturating_add(LABEL_ROWS),
        Direction::Right => {
            let [first, second] = [&pair[0], &pair[1]]
                .map(|tick| label_span(tick.label.as_deref().unwrap_or_default(), tick.cell));
            first.0 + i32::from(first.1 + LABEL_GAP) <= second.0
        }
    })
}

/// Values of minor ticks between those of `step`.
fn minor(step: TickStep, axis: &Axis, ruler: Ruler) -> Vec<f64> {
    let sparse = ruler.cells / 2 + 1;
    match step {
        TickStep::Linear { mantissa, exponent } => {
            let finer = match mantissa {
                1 => [(2, exponent - 1), (5, exponent - 1)],
                2 => [(5, exponent - 1), (1, exponent)],
                15 => [(5, 0), (5, 0)],
                30 | 45 => [(15, 0), (15, 0)],
                90 => [(30, 0), (45, 0)],
                180.. => [(mantissa / 4, 0), (mantissa / 2, 0)],
                _ => [(1, exponent), (1, exponent)],
            };
            finer
                .into_iter()
                .map(|(mantissa, exponent)| TickStep::Linear { mantissa, exponent })
                .find_map(|finer| values(finer, axis, sparse))
        }
        TickStep::Decades(every) if every > 1 => values(TickStep::Decades(1), axis, sparse),
        TickStep::Multiples(_) | TickStep::Decades(_) => {
            let [low, high] = axis.bounds();
            let decade = f64::from(ruler.cells) / (high / low).log10();
            (decade >= DECADE_CELLS)
                .then(|| values(ALL_NINE, axis, u16::MAX))
                .flatten()
        }
    }
    .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis, cells: u16, direction: Direction) -> Vec<String> {
        let ruler = Ruler {
            direction,
            cells,
            dots_per_cell: 2,
        };
        ticks(axis, ruler)
            .into_iter()
            .filter_map(|tick| tick.label)
            .collect()
    }

    fn across(scale: Scale, bounds: [f64; 2], cells: u16) -> String {
        labels(&Axis::new(scale, bounds, ""), cells, Direction::Right).join(" ")
    }

    fn up(bounds: [f64; 2], rows: u16) -> String {
        let axis = Axis::new(Scale::Log, bounds, "").with_notation(Notation::Power);
        labels(&axis, rows, Direction::Up).join(" ")
    }

    #[test]
    fn linear_labels_are_round() {
        assert_eq!(
            across(Scale::Linear, [0.0, 250.0], 50),
            "0 50 100 150 200 250"
        );
        assert_eq!(across(Scale::Linear, [0.0, 250.0], 20), "0 100 200");
        assert_eq!(
            across(Scale::Linear, [0.0, 0.3], 40),
            "0 0.05 0.1 0.15 0.2 0.25 0.3"
        );
        assert_eq!(across(Scale::Linear, [-3.0, 3.0], 30), "-3 -2 -1 0 1 2 3");
        assert_eq!(across(Scale::Linear, [0.0, 2e9], 40), "0 5e8 1e9 1.5e9 2e9");
    }

    #[test]
    fn log_labels_suit_the_range() {
        assert_eq!(
            across(Scale::Log, [1.0, 400.0], 60),
            "1 2 5 10 20 50 100 200"
        );
        assert_eq!(across(Scale::Log, [1.0, 400.0], 25), "1 10 100");
        assert_eq!(
            across(Scale::Log, [0.01, 1e6], 40),
            "0.01 1 100 10000 1000000"
        );
        assert_eq!(across(Scale::Log, [2.0, 900.0], 30), "10 100");
        assert_eq!(across(Scale::Log, [25.0, 90.0], 60), "30 40 50 60 70 80 90");
        assert_eq!(
            across(Scale::Log, [100.0, 110.0], 40),
            "100 102 104 106 108 110"
        );
        assert_eq!(
            across(Scale::Log, [500.0, 5000.0], 40),
            "500 1000 2000 5000"
        );
    }

    #[test]
    fn log_values_are_labelled_as_powers() {
        assert_eq!(up([1e-9, 1e-4], 15), "1e-9 1e-8 1e-7 1e-6 1e-5 1e-4");
        assert_eq!(
            up([1e-16, 1e-4], 15),
            "1e-16 1e-14 1e-12 1e-10 1e-8 1e-6 1e-4"
        );
        assert_eq!(up([1e-6, 1e-5], 12), "1e-6 2e-6 5e-6 1e-5");
        assert_eq!(up([2e-6, 4e-6], 12), "2e-6 2.5e-6 3e-6 3.5e-6 4e-6");
    }

    #[test]
    fn phases_are_labelled_by_parts_of_a_turn() {
        let up = |bounds, rows| {
            let axis = Axis::new(Scale::Linear, bounds, "deg").with_notation(Notation::Degrees);
            labels(&axis, rows, Direction::Up).join(" ")
        };
        assert_eq!(up([-180.0, 180.0], 4), "-180 0 180");
        assert_eq!(up([-180.0, 180.0], 6), "-180 0 180");
        assert_eq!(up([-180.0, 180.0], 12), "-180 -90 0 90 180");
        assert_eq!(up([-180.0, 180.0], 20), "-180 -135 -90 -45 0 45 90 135 180");
        assert_eq!(up([-90.0, 0.0], 14), "-90 -75 -60 -45 -30 -15 0");
        assert_eq!(up([-1080.0, 180.0], 8), "-1080 -720 -360 0");
        assert_eq!(up([-9000.0, 0.0], 8), "-7200 -3600 0");
        assert_eq!(up([88.0, 92.0], 10), "88 89 90 91 92");
    }

    #[test]
    fn a_round_step_is_the_next_one() {
        for (least, step) in [
            (0.9, (1, 0)),
            (1.0, (1, 0)),
            (1.1, (2, 0)),
            (2.5e-7, (5, -7)),
            (6e3, (1, 4)),
        ] {
            assert_eq!(round_step(least), step, "{least}");
        }
    }

    #[test]
    fn every_axis_with_room_has_two_labels() {
        for scale in [Scale::Linear, Scale::Log] {
            for ratio in [1.0001, 1.3, 2.0, 7.0, 15.0, 30.0, 99.0, 1e4, 1e12] {
                for low in [1e-9, 0.017, 0.3, 1.0, 4.2, 60.0, 9e5] {
                    let axis = Axis::new(scale, [low, low * ratio], "");
                    for rows in 6..60 {
                        let labels = labels(&axis, rows, Direction::Up);
                        assert!(labels.len() >= 2, "{axis:?} {rows}: {labels:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn ticks_are_at_their_values() {
        for (scale, low, high) in [
            (Scale::Linear, 0.0, 250.0),
            (Scale::Linear, -7.3, 1.9),
            (Scale::Log, 1.0, 400.0),
            (Scale::Log, 3e-7, 8e2),
            (Scale::Log, 31.0, 44.0),
        ] {
            let axis = Axis::new(scale, [low, high], "");
            for cells in 1..250 {
                let ruler = Ruler {
                    direction: Direction::Right,
                    cells,
                    dots_per_cell: 2,
                };
                for tick in ticks(&axis, ruler) {
                    let Some(label) = tick.label else {
                        continue;
                    };
                    let value: f64 = label.parse().unwrap();
                    let fraction = match scale {
                        Scale::Linear => (value - low) / (high - low),
                        Scale::Log => (value / low).ln() / (high / low).ln(),
                    };
                    let dot = fraction * f64::from(2 * cells - 1);
                    assert!((dot - 2.0 * f64::from(tick.cell) - 0.5).abs() <= 1.0 + 1e-6);
                }
            }
        }
    }

    #[test]
    fn decades_have_minor_ticks_where_there_is_room() {
        let axis = Axis::new(Scale::Log, [1.0, 100.0], "");
        let minor = |cells| {
            let ruler = Ruler {
                direction: Direction::Right,
                cells,
                dots_per_cell: 2,
            };
            ticks(&axis, ruler)
                .iter()
                .filter(|tick| tick.label.is_none())
                .count()
        };
        // 3, 4, 6, 7, 8, 9 and so on; 2 and 5 are labelled.
        assert_eq!(minor(120), 12);
        assert_eq!(minor(12), 0);
    }
}
