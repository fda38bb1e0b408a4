//! The selected rows of the tables of modes and peaks, and their places in new lists.

use crate::tui::app::list::List;

/// The place of a row: its frequency and its decay rate, both Hz.
pub(crate) type Place = [f64; 2];

/// The selected mode and peak of a model.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Selected {
    /// The model of the listed modes.
    pub(crate) generation: Option<u64>,
    pub(crate) mode: Option<Chosen>,
    pub(crate) peak: Option<Chosen>,
}

/// The selected row of a table.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chosen {
    place: Place,
    /// How many rows at the same place precede it.
    equal_before: usize,
}

impl Chosen {
    pub(crate) fn new(places: &[Place], row: usize) -> Option<Self> {
        let place = *places.get(row)?;
        let equal = places[..row]
            .iter()
            .filter(|one| apart(one, &place) <= same(&place));
        Some(Self {
            place,
            equal_before: equal.count(),
        })
    }

    /// The nearest row; of several at one place, the one with the same number of predecessors.
    fn nearest(&self, places: &[Place]) -> Option<usize> {
        let distance = |row: usize| apart(&places[row], &self.place);
        let shortest = (0..places.len())
            .map(distance)
            .fold(f64::INFINITY, f64::min);
        let nearest: Vec<usize> = (0..places.len())
            .filter(|row| distance(*row) <= shortest + same(&self.place))
            .collect();
        let last = nearest.len().checked_sub(1)?;
        Some(nearest[self.equal_before.min(last)])
    }
}

fn apart(one: &Place, other: &Place) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
}

/// Rows this close, Hz, count as one place.
fn same(place: &Place) -> f64 {
    const ROUNDING: f64 = 1e-9;
    ROUNDING * place[0]
}

/// The new selection in `places`. In a changed model the index stays if the number of rows is the same; otherwise the
/// nearest row is selected.
pub(crate) fn follow(
    list: &mut List,
    places: &[Place],
    before: Option<Chosen>,
    is_same_model: bool,
) {
    let as_many = list.rows == places.len();
    list.set_rows(places.len());
    if as_many && !is_same_model {
        return;
    }
    if let Some(before) = before {
        list.row = before.nearest(places).unwrap_or(0);
    }
}
