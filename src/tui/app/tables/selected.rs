//! Which rows of the tables of modes and peaks are selected, and where they are in new lists.

use crate::tui::app::List;

/// Where a row is among others: its frequency and how fast it decays, both Hz.
pub(super) type Place = [f64; 2];

/// What is selected in the tables of a model's modes and peaks.
#[derive(Debug, Clone, Copy)]
pub(in crate::tui::app) struct Selected {
    /// Of the model whose modes are listed.
    pub(super) generation: Option<u64>,
    pub(super) mode: Option<Chosen>,
    pub(super) peak: Option<Chosen>,
}

/// The selected row of a table.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chosen {
    place: Place,
    /// How many rows at the same place come before it.
    equal_before: usize,
}

impl Chosen {
    pub(super) fn new(places: &[Place], row: usize) -> Option<Self> {
        let place = *places.get(row)?;
        let equal = places[..row]
            .iter()
            .filter(|one| apart(one, &place) <= same(&place));
        Some(Self {
            place,
            equal_before: equal.count(),
        })
    }

    /// The row nearest to it; of several at one place the one that has as many before it.
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

/// Rows that are no further apart, Hz, stand at one place.
fn same(place: &Place) -> f64 {
    const ROUNDING: f64 = 1e-9;
    ROUNDING * place[0]
}

/// As many rows as places. In a changed model the selected one stays if there are as many as before; otherwise it is the
/// nearest.
pub(super) fn follow(
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
