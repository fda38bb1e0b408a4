//! The division of the picture into rows.

/// Rows of the picture, from the top. A part without room has none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rows {
    pub(super) force_words: Option<i32>,
    pub(super) forces: Option<i32>,
    pub(super) beam: i32,
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
    pub(super) fn of(height: i32) -> Self {
        let mut left = height - 1;
        let mut take = || {
            let row = i32::from(left > 0);
            left -= row;
            row
        };
        let (mut springs, mut boxes, forces) = (take(), take(), take());
        let (numbers, ruler, words) = (take(), take(), take());
        springs += take();
        boxes += take() + take() + take();
        springs += take();
        let (key, gap) = (take(), take());
        // A surplus of rows makes the picture higher.
        springs += take() + take();
        let top = left.max(0) / 2;
        let beam = top + words + forces;
        let below = beam + 1 + springs + boxes + gap;
        Self {
            force_words: (words > 0).then_some(top),
            forces: (forces > 0).then_some(beam - 1),
            beam,
            springs,
            boxes,
            ruler: (ruler > 0).then_some(below),
            numbers: (numbers > 0).then_some(below + ruler),
            key: (key > 0).then_some(height - 1),
        }
    }

    /// The first row below the springs: the ground, and the boxes.
    pub(super) const fn below_springs(&self) -> i32 {
        self.beam + 1 + self.springs
    }

    /// The row after the last one of the boxes.
    pub(super) const fn below_boxes(&self) -> i32 {
        self.below_springs() + self.boxes
    }
}
