//! The division of the picture into rows.

use std::cell::Cell;

use super::beam::Profile;

/// Rows of the picture, from the top. A part without room has none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rows {
    pub(super) force_words: Option<i32>,
    /// Whether there is a row for forces above the beam.
    pub(super) forces: bool,
    /// The axis of the beam.
    pub(super) beam: i32,
    /// The first and the last row of the beam.
    pub(super) depth: [i32; 2],
    /// How many rows of springs there are below the beam.
    pub(super) springs: i32,
    /// How many rows a box has below the springs.
    pub(super) boxes: i32,
    pub(super) ruler: Option<i32>,
    pub(super) numbers: Option<i32>,
    pub(super) key: Option<i32>,
}

impl Rows {
    /// Divides this number of rows, the most important first.
    pub(super) fn of(height: i32, profile: &Profile) -> Self {
        let left = Cell::new(height - 1);
        let take_all = |rows: i32| {
            let taken = if left.get() >= rows { rows } else { 0 };
            left.set(left.get() - taken);
            taken
        };
        let take = || take_all(1);
        // Above the axis and below it.
        let deepen = || take_all(if profile.is_flat() { 0 } else { 2 });
        let (mut springs, mut boxes, forces) = (take(), take(), take());
        let mut depth = deepen();
        let (numbers, ruler, words) = (take(), take(), take());
        springs += take();
        boxes += take() + take() + take();
        depth += deepen();
        springs += take();
        let (key, gap) = (take(), take());
        // A surplus of rows makes the picture higher.
        springs += take() + take();
        depth += deepen();
        let top = left.get() / 2;
        let first = top + words + forces;
        let depth = [first, first + depth];
        let below = depth[1] + 1 + springs + boxes + gap;
        Self {
            force_words: (words > 0).then_some(top),
            forces: forces > 0,
            beam: first + profile.above_axis(depth[1] - first),
            depth,
            springs,
            boxes,
            ruler: (ruler > 0).then_some(below),
            numbers: (numbers > 0).then_some(below + ruler),
            key: (key > 0).then_some(height - 1),
        }
    }

    /// The first row below the springs: the ground, and the boxes.
    pub(super) const fn below_springs(&self) -> i32 {
        self.depth[1] + 1 + self.springs
    }

    /// The row after the last one of the boxes.
    pub(super) const fn below_boxes(&self) -> i32 {
        self.below_springs() + self.boxes
    }
}
